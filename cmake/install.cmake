# SPDX-License-Identifier: GPL-3.0-or-later
# What an installation holds. Components are the packages of package.cmake.
set(install_folders ${CMAKE_INSTALL_BINDIR} ${CMAKE_INSTALL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_INCLUDEDIR}
    ${CMAKE_INSTALL_MANDIR}/man1 share/bash-completion/completions share/roughcontact share/doc/roughcontact)
# First of all, which of these folders the installation makes: `uninstall` removes those again once they are empty.
install(CODE "set(folders ${install_folders})
set(record \"${CMAKE_BINARY_DIR}/install_folders.txt\")
include(\"${CMAKE_SOURCE_DIR}/cmake/record_folders.cmake\")")

install(TARGETS roughcontact RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
install(DIRECTORY templates DESTINATION share/roughcontact COMPONENT program)
install(FILES src/selftest/selftest.csv DESTINATION share/roughcontact COMPONENT program)
install(DIRECTORY surfaces DESTINATION share/roughcontact COMPONENT program PATTERN make.sh EXCLUDE)

add_custom_command(OUTPUT ${CMAKE_BINARY_DIR}/roughcontact.1.gz DEPENDS docs/roughcontact.1 VERBATIM
                   COMMAND gzip -9nc ${CMAKE_SOURCE_DIR}/docs/roughcontact.1 > ${CMAKE_BINARY_DIR}/roughcontact.1.gz)
add_custom_target(manual DEPENDS ${CMAKE_BINARY_DIR}/roughcontact.1.gz)
add_dependencies(roughcontact manual)
install(FILES ${CMAKE_BINARY_DIR}/roughcontact.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
install(FILES docs/roughcontact.bash DESTINATION share/bash-completion/completions RENAME roughcontact COMPONENT program)

install(TARGETS libroughcontact LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library
        NAMELINK_COMPONENT development)
install(FILES src/library/roughcontact.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
install(FILES ${CMAKE_BINARY_DIR}/roughcontact.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
install(DIRECTORY examples DESTINATION share/roughcontact COMPONENT development)

add_custom_target(uninstall COMMAND ${CMAKE_COMMAND} -D MANIFEST=${CMAKE_BINARY_DIR}/install_manifest.txt
                  -D RECORD=${CMAKE_BINARY_DIR}/install_folders.txt -P ${CMAKE_SOURCE_DIR}/cmake/uninstall.cmake
                  VERBATIM)
