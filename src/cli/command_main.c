/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/command.h"
#include "scene/scene_words.h"

#include <argp.h>
#include <gsl/gsl_errno.h>
#include <stdio.h>
#include <string.h>

const struct command_row command_rows[COMMANDS] = {
    {"report", "DIR [-o OUT]", "read the scans in DIR, run the models, write the report", command_report,
     &command_report_argp},
    {"direct", "DIR [-o OUT]", "the report, with a direct solution beside the models", command_direct,
     &command_direct_argp},
    {"plan", "DIR", "what would be simulated and why; runs nothing", command_plan, &command_plan_argp},
    {"init", "DIR [-o FILE]", "write a scene for the scans in DIR, to be filled in", command_init, &command_init_argp},
    {"inspect", "FILE|DIR...", "what is in a scan: format, spacing, roughness, power law", command_inspect,
     &command_inspect_argp},
    {"view", "DIR|OUT", "the worded values that a report's templates are filled from", command_view,
     &command_view_argp},
    {"synth", "[-o FILE]", "write a scan that obeys a given power law", command_synth, &command_synth_argp},
    {"models", "", "the models, their sources and where they are valid", command_models, &command_models_argp},
    {"materials", "", "the built-in materials and where their numbers are from", command_materials,
     &command_materials_argp},
    {"self-test", "", "does this build compute correctly here?", command_self_test, &command_self_test_argp},
    {"help", "[COMMAND]", "this list, or what COMMAND takes", command_help, &command_help_argp},
};

const char *const command_statuses[COMMAND_STATUSES] = {
    [COMMAND_DONE] = "done",
    [COMMAND_REFUSED] = "report written but some scan was refused",
    [COMMAND_USAGE] = "usage",
    [COMMAND_SCENE] = "scene invalid",
    [COMMAND_NOTHING] = "nothing could be reported, or not on standard output",
    [COMMAND_MISSED] = "report --check: a limit is missed",
};

/** The list of commands, as --help prints it. */
static void list_commands(FILE *stream)
{
    fputs("Usage: roughcontact COMMAND [OPTION...]\n"
          "Contact of measured rough surfaces: area, separation, electrical and thermal resistance against load.\n\n",
          stream);
    for (int i = 0; i < COMMANDS; i++)
        fprintf(stream, "  roughcontact %-9s %-13s %s\n", command_rows[i].name, command_rows[i].arguments,
                command_rows[i].summary);
    fputs("\nEvery command has --help (-h); --version names the libraries. Exit status:", stream);
    for (int i = 0; i < COMMAND_STATUSES; i++)
        fprintf(stream, "%s%d %s%s", i % 3 == 0 ? "\n" : " ", i, command_statuses[i],
                i + 1 < COMMAND_STATUSES ? ";" : ".\n");
    fputs("self-test ends with 1 where a number is off; 128 + its number: ended by a signal.\n", stream);
}

/** The row of that name; NULL: none, and `status` says which there are. */
static const struct command_row *find(const char *name, struct status *status)
{
    const char *names[COMMANDS];
    for (int i = 0; i < COMMANDS; i++)
        names[i] = command_rows[i].name;
    for (int i = 0; i < COMMANDS; i++)
        if (strcmp(name, names[i]) == 0)
            return &command_rows[i];
    (void)status_fail(status, STATUS_USAGE, "unknown command '%s'; %s", scene_words_show(name).text,
                      scene_words_hint(name, names, COMMANDS, COMMANDS).text);
    return NULL;
}

static int run(const struct command_row *row, int argc, char **argv)
{
    char invoked[64];
    snprintf(invoked, sizeof invoked, "roughcontact %s", row->name);
    argv[0] = invoked;
    return row->run(argc, argv);
}

static error_t parse_help(int key, char *value, struct argp_state *state)
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
    .parser = parse_help,
    .args_doc = "[COMMAND]",
    .doc = "Lists the commands; of COMMAND, says what it does and takes, as COMMAND --help does."};

int command_help(int argc, char **argv)
{
    const char *command = NULL;
    char option[] = "--help";
    struct status status = {0};
    command_parse(&command_help_argp, argc, argv, &command);
    if (command) {
        const struct command_row *row = find(command, &status);
        return row ? run(row, 2, (char *[]){NULL, option, NULL}) : command_fail(&status);
    }
    list_commands(stdout);
    return command_finish(COMMAND_DONE, NULL);
}

int command_main(int argc, char **argv)
{
    gsl_set_error_handler_off();
    argp_err_exit_status = COMMAND_USAGE;
    const char *name = argc > 1 ? argv[1] : "";
    struct status status = {0};
    if (argc <= 1) {
        list_commands(stderr);
        return COMMAND_USAGE;
    }
    if (strcmp(name, "--help") == 0 || strcmp(name, "-h") == 0) {
        list_commands(stdout);
        return command_finish(COMMAND_DONE, NULL);
    }
    if (strcmp(name, "--version") == 0 || strcmp(name, "-V") == 0) {
        struct text version = {0};
        command_version(&version);
        fputs(text_string(&version), stdout);
        text_free(&version);
        return command_finish(COMMAND_DONE, NULL);
    }
    const struct command_row *row = find(name, &status);
    return row ? run(row, argc - 1, argv + 1) : command_fail(&status);
}
