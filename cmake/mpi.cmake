# SPDX-License-Identifier: GPL-3.0-or-later
# What roughcontact-mpi stands on besides: Debian's libopenmpi-dev (or another MPI) and libfftw3-mpi-dev.
find_package(MPI REQUIRED COMPONENTS C)
find_library(fftw_mpi fftw3_mpi REQUIRED) # Debian has no .pc file for it

add_library(roughcontact_mpi_dependencies INTERFACE)
target_link_libraries(roughcontact_mpi_dependencies INTERFACE ${fftw_mpi} MPI::MPI_C)
