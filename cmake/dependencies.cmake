# Everything the program stands on, all of it from Debian's packages (listed in packages.txt).
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
pkg_check_modules(fftw REQUIRED IMPORTED_TARGET fftw3)
pkg_check_modules(gsl REQUIRED IMPORTED_TARGET gsl)
pkg_check_modules(yaml REQUIRED IMPORTED_TARGET yaml-0.1)
pkg_check_modules(jansson REQUIRED IMPORTED_TARGET jansson)
pkg_check_modules(md REQUIRED IMPORTED_TARGET libmd)
pkg_check_modules(md4c REQUIRED IMPORTED_TARGET md4c)
pkg_check_modules(zip REQUIRED IMPORTED_TARGET libzip)
pkg_check_modules(expat REQUIRED IMPORTED_TARGET expat)
pkg_check_modules(zlib REQUIRED IMPORTED_TARGET zlib)

add_library(roughcontact_dependencies INTERFACE)
target_link_libraries(roughcontact_dependencies INTERFACE PkgConfig::fftw PkgConfig::gsl PkgConfig::yaml
                      PkgConfig::jansson PkgConfig::md PkgConfig::md4c PkgConfig::zip PkgConfig::expat
                      PkgConfig::zlib Threads::Threads m)
