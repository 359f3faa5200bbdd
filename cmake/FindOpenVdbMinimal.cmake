# Debian's module for OpenVDB wants compiled parts of Boost and more that the benchmarks do not
# use: target OpenVdbMinimal::openvdb from its headers and library alone.
find_package(Imath QUIET CONFIG)
find_path(OpenVdbMinimal_INCLUDE_DIR openvdb/openvdb.h)
find_path(OpenVdbMinimal_BOOST_DIR boost/uuid/uuid.hpp)
find_library(OpenVdbMinimal_LIBRARY openvdb)
if(OpenVdbMinimal_INCLUDE_DIR)
  file(STRINGS ${OpenVdbMinimal_INCLUDE_DIR}/openvdb/version.h OpenVdbMinimal_LINES
    REGEX "#define OPENVDB_LIBRARY_(MAJOR|MINOR|PATCH)_VERSION_NUMBER")
  string(REGEX REPLACE "[^0-9]+([0-9]+)[^0-9]+([0-9]+)[^0-9]+([0-9]+).*" "\\1.\\2.\\3"
    OpenVdbMinimal_VERSION "${OpenVdbMinimal_LINES}")
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenVdbMinimal
  REQUIRED_VARS OpenVdbMinimal_LIBRARY OpenVdbMinimal_INCLUDE_DIR OpenVdbMinimal_BOOST_DIR Imath_FOUND
  VERSION_VAR OpenVdbMinimal_VERSION)
if(OpenVdbMinimal_FOUND AND NOT TARGET OpenVdbMinimal::openvdb)
  add_library(OpenVdbMinimal::openvdb UNKNOWN IMPORTED)
  set_target_properties(OpenVdbMinimal::openvdb PROPERTIES
    IMPORTED_LOCATION ${OpenVdbMinimal_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${OpenVdbMinimal_INCLUDE_DIR}
    INTERFACE_LINK_LIBRARIES "Imath::Imath;TBB::tbb")
endif()
