# lz4 ships no CMake package on Debian 12: target lz4::liblz4 from its headers and library.
find_path(lz4_INCLUDE_DIR lz4frame.h)
find_library(lz4_LIBRARY lz4)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(lz4 REQUIRED_VARS lz4_LIBRARY lz4_INCLUDE_DIR)
if(lz4_FOUND AND NOT TARGET lz4::liblz4)
  add_library(lz4::liblz4 UNKNOWN IMPORTED)
  set_target_properties(lz4::liblz4 PROPERTIES
    IMPORTED_LOCATION ${lz4_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${lz4_INCLUDE_DIR})
endif()
