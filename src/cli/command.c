/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/command.h"
#include "base/temporary.h"
#include "output/exchange.h"
#include "output/record.h"
#include "scene/scene_words.h"

#include <errno.h>
#include <libgen.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

void command_complain(const char *what, const char *message)
{
    OWNED(text_free) struct text line = {0};
    text_add_shown(&line, message);
    fflush(stdout); /* else it stands in the middle of a line where both go to one file */
    fprintf(stderr, "roughcontact: %s%s\n", what, line.failed ? "out of memory" : text_string(&line));
}

int command_fail(const struct status *status)
{
    if (status->code != STATUS_INTERRUPTED || signals_first_word())
        command_complain("", status->message);
    return status->code == STATUS_USAGE   ? COMMAND_USAGE
           : status->code == STATUS_SCENE ? COMMAND_SCENE
                                          : COMMAND_NOTHING;
}

enum status_code command_templates(const char **out, struct status *status)
{
    static char path[PATH_MAX + 40];
    char program[PATH_MAX];
    ssize_t length = readlink("/proc/self/exe", program, sizeof program - 1);
    if (length < 0)
        return status_fail(status, STATUS_IO, "cannot find the program's own place: %s", strerror(errno));
    program[length] = '\0';
    snprintf(path, sizeof path, "%s/share/roughcontact/templates", dirname(dirname(program))); /* beside bin */
    *out = path;
    return access(path, R_OK) == 0
               ? STATUS_OK
               : status_fail(status, STATUS_IO, "no templates in '%s'; install the program with cmake --install", path);
}

enum status_code command_write(const char *path, const struct text *content, bool fresh, struct status *status)
{
    struct temporary hidden;
    struct stat info;
    OWNED(memory_free) char *real = realpath(path, NULL);
    char whole[PATH_MAX + 16];
    const char *target = real ? real : path, *slash = strrchr(target, '/');
    bool there = stat(path, &info) == 0;
    if (there && !S_ISREG(info.st_mode)) { /* a pipe, a device */
        return text_write_file(path, content->data, content->length, status);
    }
    OWNED(memory_free) char *parent = slash ? strndup(target, (size_t)(slash - target) + 1) : strdup(".");
    bool made = parent && temporary_make(&hidden, parent, exchange_clear, status) == STATUS_OK;
    snprintf(whole, sizeof whole, "%s/report", made ? hidden.path : "");
    if (!made || text_write_file(whole, content->data, content->length, status) != STATUS_OK ||
        (there && chmod(whole, info.st_mode & 07777) != 0) ||
        (fresh ? link(whole, target) : rename(whole, target)) != 0) {
        *status = (struct status){0};
        (void)status_fail(status, STATUS_IO, "cannot write '%s': %s", path, status_reason(errno));
    }
    if (made)
        temporary_remove(&hidden);
    return status->code;
}

void command_parse(const struct argp *argp, int argc, char **argv, void *input)
{
    char help[] = "--help";
    if (argc > 1 && strcmp(argv[1], "-h") == 0) /* argp only knows --help */
        argv[1] = help;
    for (int i = 1; i < argc && strcmp(argv[i], "--") != 0; i++) {
        struct text shown = {0}; /* getopt prints unknown options as they are */
        text_add_shown(&shown, argv[i]);
        bool plain = strcmp(text_string(&shown), argv[i]) == 0;
        if (*argv[i] == '-' && !plain) {
            command_complain("an option of characters that cannot be shown, write its value apart: ", argv[i]);
            exit(COMMAND_USAGE);
        }
        text_free(&shown);
    }
    if (argp_parse(argp, argc, argv, 0, NULL, input) == ENOMEM)
        exit(command_fail(&(struct status){STATUS_MEMORY, "out of memory"}));
}

error_t command_directory(int key, char *value, struct argp_state *state)
{
    const char **directory = state->input;
    if (key == ARGP_KEY_NO_ARGS)
        argp_error(state, "which directory of scans?");
    if (key != ARGP_KEY_ARG || *directory)
        return ARGP_ERR_UNKNOWN; /* and argp says that there are too many */
    *directory = value;
    return 0;
}

static int from_environment(const char *name, int otherwise)
{
    const char *value = getenv(name);
    long number = value ? strtol(value, NULL, 10) : 0;
    return number >= 20 && number <= 1000 ? (int)number : otherwise;
}

double command_length(const char *name, const char *value, struct argp_state *state)
{
    struct scene_quantity length;
    if (!scene_quantity_read(&length, string_view_of(value), UNIT_DISTANCE) ||
        !(length.value > 0 && isfinite(length.value)))
        argp_error(state, "--%s must be a length such as 0.31mm, not '%s'", name, value);
    return length.value;
}

void command_terminal_size(int *columns, int *rows)
{
    struct winsize size;
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col >= 40 && size.ws_row >= 12) {
        *columns = size.ws_col;
        *rows = size.ws_row;
        return;
    }
    *columns = from_environment("COLUMNS", 100);
    *rows = from_environment("LINES", 30);
}

int command_finish(int exit_status, const char *written)
{
    bool lost = status_lost && exit_status != COMMAND_NOTHING;
    if (fflush(stdout) == 0 && !ferror(stdout) && !lost)
        return exit_status;
    OWNED(text_free) struct text message = {0};
    text_add(&message, "cannot write to standard output: %s", lost ? "out of memory" : status_reason(errno));
    if (written)
        text_add(&message, "; the report is written, in '%s'", written);
    command_complain("", text_string(&message));
    return COMMAND_NOTHING;
}

void command_json_print(json_t *json)
{
    OWNED(text_free) struct text text = {0};
    status_lost |= !json_text(&text, json);
    printf("%s\n", text_string(&text)); /* what cannot be written command_finish() sees */
    json_decref(json);
}
