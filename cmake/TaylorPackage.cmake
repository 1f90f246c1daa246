# What `cmake --install` and CPack deliver: the libraries, tlgen, and a CMake package libtaylor with targets taylor::*.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/libtaylor)
set(package_targets taylor eom)
set(package_modules)
install(DIRECTORY libtaylor/include/taylor runtime/include/eom DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
if(TAYLOR_TLGEN)
  list(APPEND package_targets tlgen)
  list(APPEND package_modules cmake/TaylorAddModel.cmake)
endif()
install(TARGETS ${package_targets} EXPORT libtaylorTargets)
install(EXPORT libtaylorTargets NAMESPACE taylor:: DESTINATION ${package_dir})
configure_package_config_file(cmake/libtaylorConfig.cmake.in ${PROJECT_BINARY_DIR}/libtaylorConfig.cmake
  INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/libtaylorConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/libtaylorConfig.cmake ${PROJECT_BINARY_DIR}/libtaylorConfigVersion.cmake ${package_modules}
  DESTINATION ${package_dir})
install(FILES LICENSE README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})

set(CPACK_GENERATOR TGZ DEB)
set(CPACK_PACKAGE_CONTACT "the libtaylor authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Exact dynamics from plain C: Taylor algebra, code generator and motion library")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
if(TAYLOR_HOST)
  set(CPACK_DEBIAN_PACKAGE_DEPENDS "liblapacke-dev, libopenblas-dev, pkg-config") # what a program with taylor::eom links
endif()
include(CPack)
