/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A directory below TMPDIR for what another program reads and writes: `roughcontact-XXXXXX`, in which the file `lock`
 * is locked for as long as the process that made it lives. What a killed process has left behind goes with the next. */
#ifndef BASE_TEMPORARY_H
#define BASE_TEMPORARY_H

#include "base/status.h"
#include <limits.h>
#include <stddef.h>

struct temporary {
    char path[PATH_MAX];
    size_t number; /* of leftover_add() */
    int lock;      /* its descriptor */
};

/** Makes one, with mode 0700, after it has removed those of this user whose process is no more. Error: STATUS_IO. To be
 * removed by temporary_remove(); goes by itself when the program is made to end. */
MUST_CHECK enum status_code temporary_make(struct temporary *out, struct status *status);

/** Removes it with all in it. */
void temporary_remove(struct temporary *temporary);

#endif
