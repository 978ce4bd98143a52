/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Threads whose stack does not hang on `ulimit -s`. */
#ifndef BASE_THREAD_H
#define BASE_THREAD_H

#include <pthread.h>
#include <stdbool.h>

/** Bytes of stack of each: what Debian gives by default. Pages that are not used take no memory. */
enum { THREAD_STACK_BYTES = 8 << 20 };

/** Starts work(context) on a thread of its own, to be joined by pthread_join(). False: there can be no other thread. */
bool thread_start(pthread_t *out, void *(*work)(void *context), void *context);

#endif
