# libyaml ships no CMake package on Debian 12: target libyaml::yaml from its header and library.
find_path(libyaml_INCLUDE_DIR yaml.h)
find_library(libyaml_LIBRARY yaml)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(libyaml REQUIRED_VARS libyaml_LIBRARY libyaml_INCLUDE_DIR)
if(libyaml_FOUND AND NOT TARGET libyaml::yaml)
  add_library(libyaml::yaml UNKNOWN IMPORTED)
  set_target_properties(libyaml::yaml PROPERTIES
    IMPORTED_LOCATION ${libyaml_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${libyaml_INCLUDE_DIR})
endif()
