# SPDX-License-Identifier: GPL-3.0-or-later
# What an installation holds.
set(install_folders ${CMAKE_INSTALL_BINDIR} ${CMAKE_INSTALL_MANDIR}/man1 share/bash-completion/completions
    share/roughcontact share/doc/roughcontact)
# First of all, which of these folders the installation makes: `uninstall` removes those again once they are empty.
install(CODE "set(folders ${install_folders})
set(record \"${CMAKE_BINARY_DIR}/install_folders.txt\")
include(\"${CMAKE_SOURCE_DIR}/cmake/record_folders.cmake\")")

install(TARGETS roughcontact RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY templates DESTINATION share/roughcontact)
install(DIRECTORY surfaces DESTINATION share/roughcontact PATTERN make.sh EXCLUDE)

add_custom_command(OUTPUT ${CMAKE_BINARY_DIR}/roughcontact.1.gz DEPENDS docs/roughcontact.1 VERBATIM
                   COMMAND gzip -9nc ${CMAKE_SOURCE_DIR}/docs/roughcontact.1 > ${CMAKE_BINARY_DIR}/roughcontact.1.gz)
add_custom_target(manual DEPENDS ${CMAKE_BINARY_DIR}/roughcontact.1.gz)
add_dependencies(roughcontact manual)
install(FILES ${CMAKE_BINARY_DIR}/roughcontact.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES docs/roughcontact.bash DESTINATION share/bash-completion/completions RENAME roughcontact)

add_custom_target(uninstall COMMAND ${CMAKE_COMMAND} -D MANIFEST=${CMAKE_BINARY_DIR}/install_manifest.txt
                  -D RECORD=${CMAKE_BINARY_DIR}/install_folders.txt -P ${CMAKE_SOURCE_DIR}/cmake/uninstall.cmake
                  VERBATIM)
