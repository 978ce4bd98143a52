# SPDX-License-Identifier: GPL-3.0-or-later
# Language and warnings, the same for the program and the tests.
set(CMAKE_C_STANDARD 17)
set(CMAKE_C_STANDARD_REQUIRED ON)
set(CMAKE_C_EXTENSIONS OFF)
if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "build type" FORCE)
endif()

option(ROUGHCONTACT_WERROR "treat warnings as errors" OFF)
option(ROUGHCONTACT_SANITIZE "build with AddressSanitizer and UndefinedBehaviorSanitizer" OFF)
option(ROUGHCONTACT_FUZZ "build the drivers of libFuzzer (clang)" OFF)
option(ROUGHCONTACT_THREAD_SANITIZE "build with ThreadSanitizer" OFF)

add_library(roughcontact_warnings INTERFACE)
# -ffp-contract=off: a fused multiply-add rounds once where the formula rounds twice, so results would depend on the
# processor; output has to be the same to the byte everywhere.
target_compile_options(roughcontact_warnings INTERFACE -Wall -Wextra -Wconversion -Wshadow -Wstrict-prototypes
                       -Wformat=2 -Wvla -ffp-contract=off $<$<BOOL:${ROUGHCONTACT_WERROR}>:-Werror>
                       # clang alone complains of rows that name some of their fields, of nothing that is printed in one
                       # of two cases, and of a row of strings of which one takes two lines
                       $<$<C_COMPILER_ID:Clang>:-Wno-missing-field-initializers;-Wno-format-zero-length;-Wno-string-concatenation>)
target_compile_definitions(roughcontact_warnings INTERFACE _GNU_SOURCE)
# Of the program: small frames, as nothing of a thread is to need more than a fraction of its stack (base/threads.h).
# Sanitizers make them larger.
if(NOT ROUGHCONTACT_SANITIZE AND NOT ROUGHCONTACT_THREAD_SANITIZE)
    set(roughcontact_frames -Wframe-larger-than=49152)
endif()
if(ROUGHCONTACT_SANITIZE)
    target_compile_options(roughcontact_warnings INTERFACE -fsanitize=address,undefined,float-cast-overflow
                           -fno-sanitize-recover=all -fno-omit-frame-pointer
                           -Wno-format-truncation -Wno-maybe-uninitialized
                           -Wno-stringop-overread) # false of instrumented code
    target_link_options(roughcontact_warnings INTERFACE -fsanitize=address,undefined)
endif()
if(ROUGHCONTACT_FUZZ)
    # no -g, which takes a fifth of the building: what is found is run again by fuzz/test_fuzz_corpus
    target_compile_options(roughcontact_warnings INTERFACE -fsanitize=fuzzer-no-link
                           -fsanitize-coverage-ignorelist=${CMAKE_SOURCE_DIR}/tests/fuzz/not-traced.txt)
endif()
if(ROUGHCONTACT_THREAD_SANITIZE)
    target_compile_options(roughcontact_warnings INTERFACE -fsanitize=thread -fno-omit-frame-pointer)
    target_link_options(roughcontact_warnings INTERFACE -fsanitize=thread)
endif()
