# Install rules: the library, its headers, a CMake package (find_package(ciel) -> ciel::kernel) and ciel.pc.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(CIEL_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/ciel)
install(TARGETS ciel_kernel EXPORT ciel COMPONENT kernel)
install(DIRECTORY include/ciel DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT kernel
  PATTERN process_threads.hpp EXCLUDE) # a limit of the whole process is not for libraries
install(EXPORT ciel NAMESPACE ciel:: FILE ciel-targets.cmake DESTINATION ${CIEL_PACKAGE_DIR} COMPONENT kernel)
configure_package_config_file(ciel-config.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/ciel-config.cmake
  INSTALL_DESTINATION ${CIEL_PACKAGE_DIR})
# SameMinorVersion: while the version is 0.x, each minor version may change the interface.
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/ciel-config-version.cmake VERSION ${PROJECT_VERSION}
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/ciel-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/ciel-config-version.cmake
  DESTINATION ${CIEL_PACKAGE_DIR} COMPONENT kernel)

set(CIEL_PC_PRIVATE "-lstdc++")
if(CIEL_PARALLEL STREQUAL "tbb")
  set(CIEL_PC_REQUIRES tbb)
endif()
configure_file(ciel.pc.in ciel.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/ciel.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT kernel)
