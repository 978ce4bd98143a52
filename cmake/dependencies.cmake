# SPDX-License-Identifier: GPL-3.0-or-later
# Everything the program stands on, all of it from Debian's packages (listed in packages.txt).
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
pkg_check_modules(fftw REQUIRED IMPORTED_TARGET fftw3)
pkg_check_modules(gsl REQUIRED IMPORTED_TARGET gsl)
pkg_check_modules(yaml REQUIRED IMPORTED_TARGET yaml-0.1)
pkg_check_modules(jansson REQUIRED IMPORTED_TARGET jansson)
pkg_check_modules(md REQUIRED IMPORTED_TARGET libmd)
pkg_check_modules(md4c REQUIRED IMPORTED_TARGET md4c)
pkg_check_modules(expat REQUIRED IMPORTED_TARGET expat)
pkg_check_modules(zlib REQUIRED IMPORTED_TARGET zlib)

find_library(fftw_threads fftw3_threads REQUIRED) # Debian has no .pc file for it

add_library(roughcontact_dependencies INTERFACE)
target_link_libraries(roughcontact_dependencies INTERFACE ${fftw_threads} PkgConfig::fftw PkgConfig::gsl PkgConfig::yaml
                      PkgConfig::jansson PkgConfig::md PkgConfig::md4c PkgConfig::expat PkgConfig::zlib
                      Threads::Threads m)
