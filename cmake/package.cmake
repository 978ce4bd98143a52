# SPDX-License-Identifier: GPL-3.0-or-later
# cd build && cpack -G DEB: three Debian packages, the program, the library, and what it takes to
# build with the library. Dependencies on libraries are found by dpkg-shlibdeps (of the package dpkg-dev).
set(package_doc ${CMAKE_BINARY_DIR}/package)
set(CPACK_PACKAGE_NAME roughcontact)
set(CPACK_PACKAGE_VENDOR "The roughcontact authors")
set(CPACK_PACKAGE_CONTACT "The roughcontact authors <authors@roughcontact.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # each package has its own in the first line of its description
set(CPACK_RESOURCE_FILE_LICENSE ${CMAKE_SOURCE_DIR}/LICENSE)
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_SOURCE_DIR}/cmake/package_check.cmake)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
    WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL program library development)
set(CPACK_COMPONENTS_GROUPING IGNORE)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME roughcontact)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
# besides what the program is linked to: gnuplot draws the charts
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "gnuplot-nox | gnuplot")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "contact of measured rough surfaces
Reads a directory of surface-profilometer scans and tells what those
surfaces do when pressed together: real contact area, separation,
electrical and thermal contact resistance against load, by several models
side by side, in a report with charts.")

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libroughcontact1)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${package_doc}/triggers)
file(WRITE ${package_doc}/triggers "activate-noawait ldconfig\n")
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION "contact of measured rough surfaces, as a library
Reads a scan of a rough surface, makes it ready, finds its roughness,
spectrum and power law, and runs models of its contact: area, separation,
electrical and thermal resistance against load.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libroughcontact-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libroughcontact1 (= ${PROJECT_VERSION})")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "contact of measured rough surfaces, development files
The header, the pkg-config file and examples in C and Python for programs
that use libroughcontact.")

# What Debian's policy asks of every package; no part of an installation by cmake --install.
file(TIMESTAMP docs/CHANGELOG.md package_date "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file(cmake/copyright.in ${package_doc}/copyright @ONLY)
configure_file(cmake/changelog.in ${package_doc}/changelog @ONLY)
foreach(component program library development)
    string(TOUPPER ${component} upper)
    install(FILES ${package_doc}/copyright DESTINATION share/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME}
            COMPONENT ${component} EXCLUDE_FROM_ALL)
    install(CODE "execute_process(COMMAND gzip -9nc ${package_doc}/changelog
            OUTPUT_FILE \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/share/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME}/changelog.gz\"
            COMMAND_ERROR_IS_FATAL ANY)" COMPONENT ${component} EXCLUDE_FROM_ALL)
endforeach()
include(CPack)
