/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/command.h"

#include <stdio.h>

static error_t parse(int key, char *value, struct argp_state *state)
{
    const char **command = state->input;
    if (key != ARGP_KEY_ARG)
        return ARGP_ERR_UNKNOWN;
    if (*command)
        argp_error(state, "one command at a time: '%s' is too many", value);
    *command = value;
    return 0;
}

const struct argp command_help_argp = {
    .parser = parse,
    .args_doc = "[COMMAND]",
    .doc = "Lists the commands; of COMMAND, says what it does and takes, as COMMAND --help does."};

int command_help(int argc, char **argv)
{
    const char *command = NULL;
    struct status status = {0};
    command_parse(&command_help_argp, argc, argv, &command);
    if (command) {
        const struct command_row *row = command_find(command, &status);
        return row ? command_run_help(row) : command_fail(&status);
    }
    command_list(stdout);
    return command_finish(COMMAND_DONE, NULL);
}
