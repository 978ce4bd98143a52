#include "base/status.h"

#include <stdarg.h>
#include <stdio.h>

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
    char prefix[512], rest[sizeof status->message];
    va_list args;
    va_start(args, format);
    vsnprintf(prefix, sizeof prefix, format, args);
    va_end(args);
    snprintf(rest, sizeof rest, "%s", status->message);
    snprintf(status->message, sizeof status->message, "%s: %.*s", prefix, (int)(sizeof rest - sizeof prefix), rest);
    return status->code;
}

enum status_code status_memory(struct status *status)
{
    return status_fail(status, STATUS_MEMORY, "out of memory");
}
