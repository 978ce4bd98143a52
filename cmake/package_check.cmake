# SPDX-License-Identifier: GPL-3.0-or-later
# Read by cpack before it packs: without dpkg-shlibdeps a package would come out that depends on nothing.
find_program(dpkg_shlibdeps dpkg-shlibdeps)
if(CPACK_GENERATOR STREQUAL "DEB" AND NOT dpkg_shlibdeps)
    message(FATAL_ERROR "there is no dpkg-shlibdeps, which finds the package's dependencies; apt-get install dpkg-dev")
endif()
