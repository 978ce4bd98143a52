/* SPDX-License-Identifier: GPL-3.0-or-later */
/* libFuzzer's side of a driver; FUZZ_TARGET is one of the functions of fuzz.h. */
#include "fuzz/fuzz.h"

int LLVMFuzzerInitialize(int *argc, char ***argv);
int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length);
size_t LLVMFuzzerMutate(uint8_t *bytes, size_t length, size_t most);
size_t LLVMFuzzerCustomMutator(uint8_t *bytes, size_t length, size_t most, unsigned seed);

int LLVMFuzzerInitialize(int *argc, char ***argv)
{
    (void)argc, (void)argv;
    return atexit(fuzz_print_counts);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length)
{
    FUZZ_TARGET(bytes, length);
    return 0;
}

/* Three of four mutations keep the beginning, which tells the format: else most runs would be of unknown files. */
size_t LLVMFuzzerCustomMutator(uint8_t *bytes, size_t length, size_t most, unsigned seed)
{
    uint8_t kept[26];
    size_t count = length < sizeof kept ? length : sizeof kept;
    memcpy(kept, bytes, count);
    size_t size = LLVMFuzzerMutate(bytes, length, most);
    if (seed % 4 != 0)
        memcpy(bytes, kept, size < count ? size : count);
    return size;
}
