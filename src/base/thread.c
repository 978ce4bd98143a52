/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/thread.h"

bool thread_start(pthread_t *out, void *(*work)(void *context), void *context)
{
    pthread_attr_t attributes;
    if (pthread_attr_init(&attributes) != 0)
        return false;
    bool started = pthread_attr_setstacksize(&attributes, THREAD_STACK_BYTES) == 0 &&
                   pthread_create(out, &attributes, work, context) == 0;
    pthread_attr_destroy(&attributes);
    return started;
}
