/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Large arrays. */
#ifndef BASE_LARGE_H
#define BASE_LARGE_H

#include <stddef.h>

/** Tells the system that an array, NULL or not touched yet, is about to be used from end to end, so that it may give
 * pages of 2 MB at once where it would be interrupted for each of 4 kB. Arrays of less than some MB are let be. */
void large_pages(void *array, size_t bytes);

/** malloc() of such an array. */
void *large_alloc(size_t count, size_t size);

#endif
