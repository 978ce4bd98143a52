/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The program over MPI's ranks: the first one is the program, the others solve with it. */
#include "cli/command.h"
#include "ranks/ranks.h"

#include <stdlib.h>

/** The others wait for the first to end, and go when it does. */
enum { OTHERS_MS = 5000 };

static int run(int argc, char **argv)
{
    const struct direct_team *team = ranks_begin(&argc, &argv);
    bool alike = ranks_agree(argc, argv);
    if (team && team->rank > 0) {
        (void)signals_first_word();
        ranks_serve(signals_stop(OTHERS_MS));
        exit(COMMAND_DONE);
    }
    if (atexit(ranks_end) != 0) {
        ranks_end();
        return COMMAND_NOTHING;
    }
    if (!alike) {
        command_complain("", "the processes were started with different arguments; give all of them the same");
        exit(COMMAND_USAGE);
    }
    command_use_team(team);
    exit(signals_status(command_main(argc, argv))); /* which lets the others go first */
}

int main(int argc, char **argv)
{
    return signals_run(run, argc, argv);
}
