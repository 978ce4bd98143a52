/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/version.h"
#include "cli/command.h"
#include "scene/scene_words.h"

#include <fftw3.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_version.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const struct command_row command_rows[COMMANDS] = {
    {"report", "DIR [-o OUT]", "read the scans in DIR, run the models, write the report", command_report,
     &command_report_argp},
    {"direct", "DIR [-o OUT]", "the report, with a direct solution beside the models", command_direct,
     &command_direct_argp},
    {"plan", "DIR", "what would be simulated and why; runs nothing", command_plan, &command_plan_argp},
    {"init", "DIR", "write a scene for the scans in DIR, to be filled in", command_init, &command_init_argp},
    {"inspect", "FILE|DIR...", "what is in a scan: format, spacing, roughness, power law", command_inspect,
     &command_inspect_argp},
    {"compare", "OUT OUT...", "finished reports side by side: what differs, is it significant", command_compare,
     &command_compare_argp},
    {"synth", "[-o FILE]", "write a scan that obeys a given power law", command_synth, &command_synth_argp},
    {"models", "", "the models, their sources and where they are valid", command_models, &command_models_argp},
    {"materials", "", "the materials, platings, fillers and fluids, and their sources", command_materials,
     &command_materials_argp},
};

const char *const command_statuses[COMMAND_STATUSES] = {
    [COMMAND_DONE] = "done",
    [COMMAND_REFUSED] = "report written but some scan was refused",
    [COMMAND_USAGE] = "usage",
    [COMMAND_SCENE] = "scene invalid",
    [COMMAND_NOTHING] = "nothing could be reported, or not on standard output",
    [COMMAND_MISSED] = "report --check: a limit is missed",
    [COMMAND_UNDECIDED] = "report --check: no limit is missed, but one is undecided",
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
    fputs("\nEvery command has --help (-h), and there is --version. Exit status:", stream);
    for (int i = 0; i < COMMAND_STATUSES; i++)
        fprintf(stream, "%s%d %s%s", i % 3 == 0 ? "\n" : " ", i, command_statuses[i],
                i + 1 < COMMAND_STATUSES ? ";" : ".\n");
    fputs("128 + its number: ended by a signal.\n", stream);
}

/** Runs the command of that name, argv[0]. */
static int run(int argc, char **argv)
{
    char invoked[64];
    const char *names[COMMANDS];
    struct status status = {0};
    for (int i = 0; i < COMMANDS; i++)
        names[i] = command_rows[i].name;
    size_t which = scene_words_find(string_view_of(argv[0]), names, COMMANDS);
    if (which == COMMANDS) {
        (void)status_fail(&status, STATUS_USAGE, "unknown command '%s'; %s", scene_words_show(argv[0]).text,
                          scene_words_hint(argv[0], names, COMMANDS, COMMANDS).text);
        return command_fail(&status);
    }
    snprintf(invoked, sizeof invoked, "roughcontact %s", names[which]);
    argv[0] = invoked;
    return command_rows[which].run(argc, argv);
}

/** For jansson, since not every allocation in a JSON tree is checked. */
static void *allocate(size_t size)
{
    void *made = malloc(size);
    status_lost |= !made;
    return made;
}

int command_main(int argc, char **argv)
{
    gsl_set_error_handler_off();
    json_set_alloc_funcs(allocate, free);
    argp_err_exit_status = COMMAND_USAGE;
    if (argc <= 1) {
        list_commands(stderr);
        return COMMAND_USAGE;
    }
    bool help = strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0;
    if (!help && strcmp(argv[1], "--version") != 0)
        return run(argc - 1, argv + 1);
    if (help)
        list_commands(stdout);
    else
        printf("roughcontact %s\nbuilt by %s\n%s, GSL %s\n", version_string(), version_build(), fftw_version,
               gsl_version);
    return command_finish(COMMAND_DONE, NULL);
}
