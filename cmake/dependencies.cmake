# SPDX-License-Identifier: GPL-3.0-or-later
# Everything the program stands on, all of it from Debian's packages (listed in .ci/packages).
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
pkg_check_modules(fftw REQUIRED IMPORTED_TARGET fftw3 fftw3f)
pkg_check_modules(gsl REQUIRED IMPORTED_TARGET gsl)
pkg_check_modules(yaml REQUIRED IMPORTED_TARGET yaml-0.1)
pkg_check_modules(jansson REQUIRED IMPORTED_TARGET jansson)
pkg_check_modules(nettle REQUIRED IMPORTED_TARGET nettle)
pkg_check_modules(md4c REQUIRED IMPORTED_TARGET md4c-html)
pkg_check_modules(expat REQUIRED IMPORTED_TARGET expat)
pkg_check_modules(zlib REQUIRED IMPORTED_TARGET zlib)

set(numerical PkgConfig::fftw PkgConfig::gsl PkgConfig::jansson PkgConfig::nettle)

# Their archives, one that needs another before it, for targets of the property TAKES_ARCHIVES: the program, which starts
# in half the time. Not those of expat, libyaml and zlib, which Debian wants shared (lintian's embedded-library).
option(ROUGHCONTACT_ARCHIVES "link the program with the archives of FFTW, GSL, jansson and Nettle, where there are any" ON)
foreach(name IN ITEMS fftw3 fftw3f gsl gslcblas jansson nettle)
    find_library(archive_${name} lib${name}.a)
    mark_as_advanced(archive_${name})
    list(APPEND archives ${archive_${name}})
endforeach()
if(NOT ROUGHCONTACT_ARCHIVES OR archives MATCHES "NOTFOUND")
    set(archives ${numerical})
endif()
set(takes_archives $<BOOL:$<TARGET_PROPERTY:TAKES_ARCHIVES>>)

add_library(roughcontact_dependencies INTERFACE)
target_link_libraries(roughcontact_dependencies INTERFACE "$<${takes_archives}:${archives}>"
                      "$<$<NOT:${takes_archives}>:${numerical}>" PkgConfig::yaml PkgConfig::md4c
                      PkgConfig::expat PkgConfig::zlib Threads::Threads m)
