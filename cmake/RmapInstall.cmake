# Install rules and the package that find_package(rmap) finds.
include(CMakePackageConfigHelpers)

install(TARGETS rmap EXPORT rmapTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT rmapTargets NAMESPACE rmap:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/rmap)
if(TARGET rmap_command)
  install(TARGETS rmap_command DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/rmapConfig.cmake.in
  ${CMAKE_CURRENT_BINARY_DIR}/rmapConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/rmap)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/rmapConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${CMAKE_CURRENT_BINARY_DIR}/rmapConfig.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/rmapConfigVersion.cmake
  ${CMAKE_CURRENT_LIST_DIR}/Findlibyaml.cmake
  ${CMAKE_CURRENT_LIST_DIR}/Findlz4.cmake
  ${CMAKE_CURRENT_LIST_DIR}/Findzstd.cmake
  ${CMAKE_CURRENT_LIST_DIR}/FindxxHash.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/rmap)
