/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scan/gwyddion.h"
#include "base/program.h"
#include "base/temporary.h"

#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double most_seconds = 30;

bool gwyddion_exists(void)
{
    char program[PATH_MAX];
    return program_find(program, sizeof program, "gwyddion");
}

static enum status_code convert(struct text *out, const char *program, const char *path, const char *directory,
                                struct status *status)
{
    struct status problem = {0};
    char *option = NULL;
    if (asprintf(&option, "--convert-to-gwy=%s/scan.gwy", directory) < 0)
        return status_memory(status);
    char *const arguments[] = {(char *)program, option, (char *)path, NULL};
    enum status_code code = program_run(arguments, directory, most_seconds, &problem);
    if (code == STATUS_OK)
        code = text_read_file(out, strchr(option, '=') + 1, &problem);
    free(option);
    return code == STATUS_IO   ? status_fail(status, STATUS_SCAN, "Gwyddion cannot convert it: %s", problem.message)
           : code != STATUS_OK ? status_fail(status, code, "%s", problem.message)
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
    sigset_t before;
    program_hold_signals(&before); /* until the directory is gone */
    if (temporary_make(&temporary, status) == STATUS_OK) {
        (void)convert(out, program, whole, temporary.path, status);
        temporary_remove(&temporary);
    }
    program_let_signals(&before);
    return status->code;
}
