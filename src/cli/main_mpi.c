/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The program over MPI's ranks: the first one is the program, the others solve with it. */
#include "cli/command.h"
#include "cli/signals.h"
#include "ranks/ranks.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char option[] = "--ranks-per-grid";

static void print_help(void)
{
    fputs("Usage: mpirun -n RANKS roughcontact-mpi [--ranks-per-grid N] COMMAND [OPTION...]\n"
          "The commands of roughcontact, with the surfaces of a report dealt out to the ranks, and direct solutions\n"
          "shared by them: seeds by groups of N of them (default: as many as there are for a seed), a map and the\n"
          "finer grid by all.\n\n",
          stdout);
}

/** Takes the option out of the arguments. */
static bool parse(struct ranks_options *out, int *argc, char **argv)
{
    char *end;
    *out = (struct ranks_options){0};
    if (*argc < 2 || strcmp(argv[1], option) != 0)
        return true;
    out->ranks_per_grid = *argc > 2 ? strtoul(argv[2], &end, 10) : 0;
    if (out->ranks_per_grid < 1 || out->ranks_per_grid > 65536 || *end != '\0')
        return false;
    *argc -= 2;
    memmove(argv + 1, argv + 3, (size_t)*argc * sizeof *argv); /* the NULL at the end too */
    return true;
}

/** The others wait for the first to end, and go when it does. */
enum { OTHERS_MS = 5000 };

static int run(int argc, char **argv)
{
    struct ranks_options options;
    ranks_begin(&argc, &argv);
    if (!ranks_is_first()) {
        (void)signals_first_word();
        ranks_serve(signals_stop(OTHERS_MS));
        exit(COMMAND_DONE);
    }
    if (atexit(ranks_end) != 0) {
        ranks_end();
        return COMMAND_NOTHING;
    }
    if (!parse(&options, &argc, argv)) {
        command_complain("", "--ranks-per-grid must be 1 to 65536");
        return COMMAND_USAGE;
    }
    if (argc > 1 && (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0 || strcmp(argv[1], "help") == 0))
        print_help();
    command_use_crew(ranks_crew(&options));
    exit(signals_status(command_main(argc, argv))); /* which lets the others go first */
}

int main(int argc, char **argv)
{
    return signals_run(run, argc, argv);
}
