/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "library/library.h"

#include "base/version.h"
#include <stdint.h>
#include <stdio.h>
#include <string.h>

static int public_code(enum status_code code)
{
    static const int codes[STATUS_INTERRUPTED + 1] = {
        [STATUS_MEMORY] = ROUGHCONTACT_MEMORY, [STATUS_IO] = ROUGHCONTACT_IO,
        [STATUS_USAGE] = ROUGHCONTACT_USAGE,   [STATUS_SCAN] = ROUGHCONTACT_SCAN,
        [STATUS_MODEL] = ROUGHCONTACT_MODEL,   [STATUS_NUMBER] = ROUGHCONTACT_NUMBER};
    return codes[code];
}

int library_end(const struct host *host, const struct status *problem, struct roughcontact_status *status)
{
    host_give_back(host);
    int code = public_code(problem->code);
    if (status) {
        status->code = code;
        snprintf(status->message, sizeof status->message, "%s", problem->message);
    }
    return code;
}

void library_init(void *options, size_t size, const void *defaults, size_t own_size)
{
    if (!options || size < sizeof size)
        return;
    memset(options, 0, size);
    memcpy(options, defaults, size < own_size ? size : own_size);
    memcpy(options, &size, sizeof size);
}

enum status_code library_take(void *own, size_t own_size, const void *given, const char *name, struct status *status)
{
    size_t size;
    if (!given)
        return STATUS_OK;
    memcpy(&size, given, sizeof size);
    if (size < sizeof size || size > SIZE_MAX / 2)
        return status_fail(status, STATUS_USAGE, "the options have no size; set them up by %s()", name);
    const unsigned char *bytes = given;
    for (size_t i = own_size; i < size; i++)
        if (bytes[i] != 0)
            return status_fail(status, STATUS_USAGE,
                               "an option is set that version %s of the library does not know; use a later one",
                               version_string());
    memcpy(own, given, size < own_size ? size : own_size);
    return STATUS_OK;
}

const char *roughcontact_version(void)
{
    return version_string();
}
