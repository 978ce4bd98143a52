#include "base/version.h"
#include "cli/command.h"
#include "scene/scene_words.h"

#include <argp.h>
#include <gsl/gsl_errno.h>
#include <stdio.h>
#include <string.h>

static const struct command_row commands[] = {
    {"report", "DIR [-o OUT]", "read the scans in DIR, run the models, write the report", command_report},
    {"direct", "DIR [-o OUT]", "the report, with a direct solution beside the models", command_direct},
    {"plan", "DIR", "what would be simulated and why; runs nothing", command_plan},
    {"inspect", "FILE|DIR...", "what is in a scan: format, spacing, roughness, power law", command_inspect},
    {"synth", "[-o FILE]", "write a scan that obeys a given power law", command_synth},
    {"models", "", "the models, their sources and where they are valid", command_models},
    {"materials", "", "the built-in materials and where their numbers are from", command_materials},
};
enum { COMMANDS = sizeof commands / sizeof commands[0] };

static void print_help(FILE *stream)
{
    fputs("Usage: roughcontact COMMAND [OPTION...]\n"
          "Contact of measured rough surfaces: area, separation, electrical and thermal resistance against load.\n\n",
          stream);
    for (int i = 0; i < COMMANDS; i++)
        fprintf(stream, "  roughcontact %-9s %-13s %s\n", commands[i].name, commands[i].arguments, commands[i].summary);
    fputs("\nEvery command has --help. Exit status: 0 done; 1 report written but some scan was refused; 2 usage;\n"
          "3 scene invalid; 4 nothing could be reported, or not on standard output; 5 report --check: a limit is "
          "missed;\n"
          "128 + its number: ended by a signal.\n",
          stream);
}

static int unknown_command(const char *name)
{
    const char *names[COMMANDS];
    struct status status = {0};
    for (int i = 0; i < COMMANDS; i++)
        names[i] = commands[i].name;
    (void)status_fail(&status, STATUS_USAGE, "unknown command '%s'; %s", scene_words_show(name, strlen(name)).text,
                      scene_words_hint(name, names, COMMANDS, COMMANDS).text);
    return command_fail(&status);
}

int command_main(int argc, char **argv)
{
    gsl_set_error_handler_off();
    argp_err_exit_status = COMMAND_USAGE;
    const char *name = argc > 1 ? argv[1] : "";
    if (strcmp(name, "--help") == 0 || strcmp(name, "-h") == 0 || strcmp(name, "help") == 0) {
        print_help(stdout);
        return command_finish(COMMAND_DONE, NULL);
    }
    if (strcmp(name, "--version") == 0 || strcmp(name, "-V") == 0) {
        printf("roughcontact %s\n", version_string());
        return command_finish(COMMAND_DONE, NULL);
    }
    for (int i = 0; i < COMMANDS; i++)
        if (strcmp(name, commands[i].name) == 0) {
            char invoked[64];
            snprintf(invoked, sizeof invoked, "roughcontact %s", name);
            argv[1] = invoked;
            return commands[i].run(argc - 1, argv + 1);
        }
    if (argc > 1)
        return unknown_command(name);
    print_help(stderr);
    return COMMAND_USAGE;
}
