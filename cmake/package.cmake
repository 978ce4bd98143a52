# SPDX-License-Identifier: GPL-3.0-or-later
# cd build && cpack -G DEB: the Debian package. Dependencies on libraries are found by dpkg-shlibdeps (of dpkg-dev).
set(package_doc ${CMAKE_BINARY_DIR}/package)
set(CPACK_PACKAGE_NAME roughcontact)
set(CPACK_PACKAGE_VENDOR "The roughcontact authors")
set(CPACK_PACKAGE_CONTACT "The roughcontact authors <authors@roughcontact.invalid>")
set(CPACK_RESOURCE_FILE_LICENSE ${CMAKE_SOURCE_DIR}/LICENSE)
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_SOURCE_DIR}/cmake/package_check.cmake)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
    WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL Unspecified policy) # what an installation holds, and what Debian asks of a package besides
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
# besides what the program is linked to: gnuplot draws the charts
set(CPACK_DEBIAN_PACKAGE_DEPENDS "gnuplot-nox | gnuplot")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "contact of measured rough surfaces")
set(CPACK_PACKAGE_DESCRIPTION "Reads a directory of surface-profilometer scans and tells what those
surfaces do when pressed together: real contact area, separation,
electrical and thermal contact resistance against load, by several models
side by side, in a report with charts.")

# What Debian's policy asks of every package; no part of an installation by cmake --install.
file(TIMESTAMP docs/CHANGELOG.md package_date "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file(cmake/copyright.in ${package_doc}/copyright @ONLY)
configure_file(cmake/changelog.in ${package_doc}/changelog @ONLY)
install(FILES ${package_doc}/copyright DESTINATION share/doc/roughcontact COMPONENT policy EXCLUDE_FROM_ALL)
install(CODE "execute_process(COMMAND gzip -9nc ${package_doc}/changelog
        OUTPUT_FILE \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/share/doc/roughcontact/changelog.gz\"
        COMMAND_ERROR_IS_FATAL ANY)" COMPONENT policy EXCLUDE_FROM_ALL)
include(CPack)
