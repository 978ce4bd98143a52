/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `help`: what a command takes, and the two files that an installation makes of the same tables. */
#include "cli/command.h"

#include <stdio.h>

struct arguments {
    const char *command;
    bool manual, completion;
};

enum { KEY_MANUAL = 0x100, KEY_COMPLETION };

static const struct argp_option options[] = {
    {"man", KEY_MANUAL, 0, 0, "print the manual page, for man(1)", 0},
    {"completion", KEY_COMPLETION, 0, 0, "print the completion, for bash(1)", 0},
    {0},
};

static error_t parse(int key, char *value, struct argp_state *state)
{
    struct arguments *arguments = state->input;
    switch (key) {
    case KEY_MANUAL:
        arguments->manual = true;
        return 0;
    case KEY_COMPLETION:
        arguments->completion = true;
        return 0;
    case ARGP_KEY_ARG:
        if (arguments->command)
            argp_error(state, "one command at a time: '%s' is too many", value);
        arguments->command = value;
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

const struct argp command_help_argp = {
    .options = options,
    .parser = parse,
    .args_doc = "[COMMAND]",
    .doc = "Lists the commands; of COMMAND, says what it does and takes, as COMMAND --help does."};

int command_help(int argc, char **argv)
{
    struct arguments arguments = {0};
    struct status status = {0};
    struct text page = {0};
    command_parse(&command_help_argp, argc, argv, &arguments);
    if (arguments.command) {
        const struct command_row *row = command_find(arguments.command, &status);
        return row ? command_run_help(row) : command_fail(&status);
    }
    if (arguments.completion)
        command_completion(&page);
    else if (arguments.manual)
        command_manual(&page);
    if (page.failed) {
        text_free(&page);
        (void)status_memory(&status);
        return command_fail(&status);
    }
    if (!arguments.manual && !arguments.completion)
        command_list(stdout);
    fputs(text_string(&page), stdout);
    text_free(&page);
    return command_finish(COMMAND_DONE, NULL);
}
