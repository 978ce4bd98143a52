/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/status.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

atomic_bool status_lost;

enum status_code status_fail(struct status *status, enum status_code code, const char *format, ...)
{
    if (status->code != STATUS_OK)
        return status->code;
    va_list args;
    va_start(args, format);
    status->code = code;
    vsnprintf(status->message, sizeof status->message, format, args);
    va_end(args);
    return code;
}

enum status_code status_prefix(struct status *status, const char *format, ...)
{
    char old[sizeof status->message];
    memcpy(old, status->message, sizeof old);
    va_list args;
    va_start(args, format);
    int length = vsnprintf(status->message, sizeof status->message, format, args);
    va_end(args);
    size_t size = sizeof status->message, used = length < 0 ? 0 : (size_t)length;
    if (used < size && snprintf(status->message + used, size - used, ": %s", old) < 0)
        status->message[used] = '\0';
    return status->code;
}

const char *status_reason(int error)
{
    return error == EFBIG ? "the file is larger than 'ulimit -f' allows" : strerror(error);
}

enum status_code status_memory(struct status *status)
{
    return status_fail(status, STATUS_MEMORY, "out of memory");
}

void memory_free(void *pointer)
{
    void *memory;
    memcpy(&memory, pointer, sizeof memory);
    free(memory);
}
