# SPDX-License-Identifier: GPL-3.0-or-later
# libroughcontact: of the core only what src/library needs goes in, and only the functions of its header come out. The
# program does not use it: it links the core itself, which starts faster and needs no search path.
file(GLOB library_sources CONFIGURE_DEPENDS src/library/*.c)
set(library_exports ${CMAKE_SOURCE_DIR}/src/library/roughcontact.map)
add_library(libroughcontact SHARED ${library_sources})
set_target_properties(libroughcontact PROPERTIES
                      OUTPUT_NAME roughcontact VERSION 1.${PROJECT_VERSION_MINOR}.${PROJECT_VERSION_PATCH} SOVERSION 1 C_VISIBILITY_PRESET hidden
                      LINK_DEPENDS ${library_exports} LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib)
# FFTW is its own, so that a lack of memory within FFTW does not end the host (base/fft.h): before the shared one, of which
# nothing is needed then.
set(own_fftw $<$<AND:$<BOOL:${ROUGHCONTACT_ARCHIVES}>,$<BOOL:${archive_fftw3}>>:${archive_fftw3}>)
target_link_libraries(libroughcontact PRIVATE roughcontact_core ${own_fftw})
target_compile_options(libroughcontact PRIVATE ${roughcontact_frames})
target_link_options(libroughcontact PRIVATE LINKER:--version-script=${library_exports} LINKER:--exclude-libs,ALL
                    LINKER:--as-needed)

# The prefix is found from the place of the file: an installed tree may be moved. There is no static library, so what it
# would need besides is nobody's business (Requires.private would ask users for the -dev packages of it all).
file(RELATIVE_PATH prefix_from_pkgconfig /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
string(REGEX REPLACE "/$" "" prefix_from_pkgconfig ${prefix_from_pkgconfig})
configure_file(cmake/roughcontact.pc.in ${CMAKE_BINARY_DIR}/roughcontact.pc @ONLY)
