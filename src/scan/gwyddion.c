/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/clock.h"
#include "base/program.h"
#include "base/temporary.h"
#include "scan/format.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const double most_seconds = 30;

bool gwyddion_exists(void)
{
    char program[PATH_MAX];
    return program_find(program, sizeof program, "gwyddion");
}

/* Runs the program on the file in `directory`, which is its HOME too. */
static enum status_code run(const char *program, char *path, const char *directory, struct status *status)
{
    char name[] = "gwyddion", option[PATH_MAX + 64], home[PATH_MAX + 16];
    pid_t process;
    int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
    if (nothing < 0)
        return status_fail(status, STATUS_IO, "cannot open '/dev/null': %s", strerror(errno));
    snprintf(option, sizeof option, "--convert-to-gwy=%s/scan.gwy", directory);
    snprintf(home, sizeof home, "HOME=%s", directory);
    char *const arguments[] = {name, option, path, NULL};
    int error = program_start(&process, &(struct program_task){arguments, program, directory, home, nothing, nothing});
    close(nothing);
    if (error == ECANCELED)
        return status_fail(status, STATUS_INTERRUPTED, "Gwyddion was stopped by a signal");
    if (error)
        return status_fail(status, STATUS_SCAN, "Gwyddion cannot be started: %s", strerror(error));
    enum program_state state = program_wait(process, clock_seconds() + most_seconds);
    int how = program_end(process);
    return state == PROGRAM_STOPPED ? status_fail(status, STATUS_INTERRUPTED, "Gwyddion was stopped by a signal")
           : state == PROGRAM_LATE
               ? status_fail(status, STATUS_SCAN, "Gwyddion took more than %g s to convert it", most_seconds)
           : how != 0 ? status_fail(status, STATUS_SCAN, "Gwyddion cannot convert it")
                      : STATUS_OK;
}

enum status_code gwyddion_convert(struct text *out, const char *path, struct status *status)
{
    char program[PATH_MAX], whole[PATH_MAX];
    struct temporary temporary;
    if (!program_find(program, sizeof program, "gwyddion"))
        return status_fail(status, STATUS_SCAN, "no gwyddion in PATH");
    if (!realpath(path, whole)) /* absolute: it can be no option */
        return status_fail(status, STATUS_IO, "cannot find '%s': %s", path, strerror(errno));
    if (temporary_make(&temporary, NULL, NULL, status) != STATUS_OK)
        return status->code;
    if (run(program, whole, temporary.path, status) == STATUS_OK) {
        char converted[PATH_MAX + 16];
        snprintf(converted, sizeof converted, "%s/scan.gwy", temporary.path);
        if (text_read_file(out, converted, status) == STATUS_IO)
            status->code = STATUS_SCAN;
    }
    temporary_remove(&temporary);
    return status->code;
}
