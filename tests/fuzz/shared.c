/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fuzz/fuzz.h"

#include "directory.h"

enum { KINDS = 48 };

static struct {
    const char *kind;
    size_t runs, good;
} counts[KINDS];

static size_t find(const char *kind)
{
    size_t i = 0;
    while (i < KINDS - 1 && counts[i].kind && strcmp(counts[i].kind, kind) != 0)
        i++;
    return i;
}

void fuzz_count(const char *kind, bool good)
{
    size_t i = find(kind);
    counts[i].kind = kind;
    counts[i].runs++;
    counts[i].good += good;
}

size_t fuzz_good(const char *kind)
{
    return counts[find(kind)].good;
}

void fuzz_print_counts(void)
{
    for (size_t i = 0; i < KINDS && counts[i].kind; i++)
        fprintf(stderr, "runs of %-9s %9zu, good ones %9zu\n", counts[i].kind, counts[i].runs, counts[i].good);
}

static struct directory place;

static void remove_place(void)
{
    directory_remove(&place);
}

const char *fuzz_place(void)
{
    if (!place.path[0]) {
        if (!getenv("TMPDIR") && access("/dev/shm", W_OK) == 0)
            setenv("TMPDIR", "/dev/shm", 1);
        place = directory_make();
        atexit(remove_place);
    }
    return place.path;
}
