# Debian packages and archives of the server, of the importer, and of the kernel for C++ and for Python:
# cpack -G "DEB;TGZ". The importer is separate, because it needs VTK. The web client and the kernel's own build must be
# built before; deploy/package does all.
include(GNUInstallDirs)
install(TARGETS ciel_app RUNTIME COMPONENT server)
install(DIRECTORY webclient/dist/ DESTINATION ${CMAKE_INSTALL_DATADIR}/ciel/webclient COMPONENT server)
install(FILES deploy/ciel.service DESTINATION lib/systemd/system COMPONENT server)
install(FILES LICENSE README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT server)
# The kernel's own build is position-independent, as an extension of Python needs it, and configured for /usr.
function(package_of_kernel component part name)
  install(CODE "execute_process(COMMAND ${CMAKE_COMMAND} --install ${CMAKE_BINARY_DIR}/kernel --component ${part}
    --prefix \${CMAKE_INSTALL_PREFIX} COMMAND_ERROR_IS_FATAL ANY)" COMPONENT ${component} EXCLUDE_FROM_ALL)
  install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} COMPONENT ${component} EXCLUDE_FROM_ALL)
endfunction()
package_of_kernel(dev kernel libciel-dev)
package_of_kernel(module python python3-ciel-mesh)
set(packages server dev module)
if(CIEL_IMPORT)
  install(TARGETS ciel_import RUNTIME COMPONENT import)
  list(APPEND packages import)
endif()

set(CPACK_PACKAGE_NAME ciel)
set(CPACK_PACKAGE_VENDOR "The CIEL authors")
set(CPACK_PACKAGE_CONTACT "The CIEL authors <ciel@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL ${packages})
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_ARCHIVE_COMPONENT_INSTALL ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON) # dependencies are those of the Debian release on which the package is built
set(CPACK_DEBIAN_SERVER_PACKAGE_NAME ciel)
set(CPACK_DEBIAN_SERVER_DESCRIPTION "Explore large simulation results in a browser")
# Libraries and fonts that are opened at run time.
set(CPACK_DEBIAN_SERVER_PACKAGE_DEPENDS "libegl1, libgl1-mesa-dri, libopengl0, libosmesa6, fonts-dejavu-core")
set(CPACK_DEBIAN_SERVER_PACKAGE_RECOMMENDS "ciel-import, fonts-wqy-microhei")
set(CPACK_DEBIAN_IMPORT_PACKAGE_NAME ciel-import)
set(CPACK_DEBIAN_IMPORT_DESCRIPTION "Import simulation results for ciel")
set(CPACK_DEBIAN_IMPORT_PACKAGE_DEPENDS "ciel (= ${PROJECT_VERSION})")

set(CPACK_DEBIAN_DEV_PACKAGE_NAME libciel-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "libtbb-dev")
set(CPACK_DEBIAN_DEV_DESCRIPTION "Iso-surfaces and slices of polyhedral meshes, C++ library
A static library with its headers, for find_package(ciel) and pkg-config. Its surfaces are incremental from one value
to the next. The server of the package ciel is built on it.")

# An extension fits one minor version of Python.
execute_process(OUTPUT_VARIABLE python OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND /usr/bin/python3 -c
  "import sys; a, b = sys.version_info[:2]; print(f'python3 (>= {a}.{b}), python3 (<< {a}.{b + 1})')")
set(CPACK_DEBIAN_MODULE_PACKAGE_NAME python3-ciel-mesh)
set(CPACK_DEBIAN_MODULE_PACKAGE_SECTION python)
set(CPACK_DEBIAN_MODULE_PACKAGE_DEPENDS "${python}, python3-numpy")
set(CPACK_DEBIAN_MODULE_PACKAGE_SUGGESTS "python3-vtk9, python3-meshio")
set(CPACK_DEBIAN_MODULE_DESCRIPTION "Iso-surfaces and slices of polyhedral meshes, Python module ciel_mesh
Surfaces of the cells of NumPy arrays, VTK grids and meshio meshes, incremental from one value to the next.")
set(CPACK_DEBIAN_MODULE_PACKAGE_CONTROL_EXTRA
  "${CMAKE_SOURCE_DIR}/deploy/python/postinst;${CMAKE_SOURCE_DIR}/deploy/python/prerm")
set(CPACK_DEBIAN_MODULE_PACKAGE_CONTROL_STRICT_PERMISSION ON)
include(CPack)
