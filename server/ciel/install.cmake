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

# The way from ciel.pc to the headers depends on how deep the folder of libraries lies: lib, or Debian's
# lib/x86_64-linux-gnu.
cmake_path(RELATIVE_PATH CMAKE_INSTALL_PREFIX BASE_DIRECTORY ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig
  OUTPUT_VARIABLE CIEL_PC_PREFIX)
# A shared library is linked with these already; a static one leaves that to each program.
get_target_property(type ciel_kernel TYPE)
if(type STREQUAL "SHARED_LIBRARY")
  set(private _PRIVATE)
endif()
if(CIEL_PARALLEL STREQUAL "tbb")
  set(CIEL_PC_REQUIRES${private} tbb)
endif()
if(NOT CIEL_PARALLEL STREQUAL "serial")
  set(CIEL_PC_LIBS${private} " -pthread")
endif()
configure_file(ciel.pc.in ciel.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/ciel.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT kernel)
