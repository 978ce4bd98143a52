/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/large.h"

#include <stdint.h>
#include <stdlib.h>
#include <sys/mman.h>

enum { LARGE_PAGE = 1 << 21, LEAST_BYTES = 4 * LARGE_PAGE };

void large_pages(void *array, size_t bytes)
{
    if (!array || bytes < LEAST_BYTES)
        return;
    uintptr_t first = ((uintptr_t)array + LARGE_PAGE - 1) / LARGE_PAGE * LARGE_PAGE;
    uintptr_t end = ((uintptr_t)array + bytes) / LARGE_PAGE * LARGE_PAGE;
    (void)madvise((void *)first, end - first, MADV_HUGEPAGE); /* refused: it is only slower */
}

void *large_alloc(size_t count, size_t size)
{
    void *array = reallocarray(NULL, count, size);
    large_pages(array, count * size);
    return array;
}
