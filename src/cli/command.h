/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The program's commands: one row each. A command parses its own arguments, prints, and returns the exit status. */
#ifndef CLI_COMMAND_H
#define CLI_COMMAND_H

#include "base/text.h"
#include "output/json.h"
#include "run/all_surfaces.h"

#include <argp.h>

/** Exit statuses of every command (docs/commands.md). */
enum command_exit {
    COMMAND_DONE = 0,
    COMMAND_REFUSED = 1, /* a report was written, but a scan was refused */
    COMMAND_USAGE = 2,
    COMMAND_SCENE = 3,
    COMMAND_NOTHING = 4,   /* nothing could be reported, or not on standard output */
    COMMAND_MISSED = 5,    /* report --check: a surface misses a limit */
    COMMAND_UNDECIDED = 6, /* report --check: none is missed, but one is undecided or has no value */
    COMMAND_STATUSES,
};

/** Their meanings. */
extern const char *const command_statuses[COMMAND_STATUSES];

/** A command, argv[0] being "roughcontact NAME", or the program. Returns the exit status. */
typedef int command_run(int argc, char **argv);

struct command_row {
    const char *name;
    const char *arguments;
    const char *summary;
    command_run *run;
    const struct argp *argp; /* its options */
};
enum { COMMANDS = 9 };
extern const struct command_row command_rows[COMMANDS];

/** All of the program but main(): picks the command. */
command_run command_main;

command_run command_report, command_direct, command_plan, command_compare, command_inspect, command_init, command_synth,
    command_models, command_materials;

extern const struct argp command_report_argp, command_direct_argp, command_plan_argp, command_inspect_argp,
    command_init_argp, command_compare_argp, command_synth_argp, command_models_argp, command_materials_argp;

/** Reads the command line; ends the program where it is wrong (COMMAND_USAGE) or asks for help. */
void command_parse(const struct argp *argp, int argc, char **argv, void *input);
/** A parser, or the end of one: takes the directory of a command, a const char * at the beginning of the input. */
error_t command_directory(int key, char *value, struct argp_state *state);

/** Prints "roughcontact: `what``message`" as one line on stderr, characters that may not be shown written out. */
void command_complain(const char *what, const char *message);

/** Prints the message in the same way and returns the exit status of its code. */
int command_fail(const struct status *status);

/** The folder of the templates, share/roughcontact/templates beside the program's bin. Error: STATUS_IO. */
MUST_CHECK enum status_code command_templates(const char **out, struct status *status);

/** Writes a file whole or not at all: in a hidden directory beside it, then moved to its place; `fresh`: it never
 * replaces another. A pipe or a device is written to. Error: STATUS_IO. */
MUST_CHECK enum status_code command_write(const char *path, const struct text *content, bool fresh,
                                          struct status *status);

/** The length [m], above 0, of option `name`: 0.8mm, 8 um, or a number in m. Ends the program where it is none. */
double command_length(const char *name, const char *value, struct argp_state *state);

/** Columns and rows of the terminal on stdout, else of $COLUMNS and $LINES, else 100 x 30. */
void command_terminal_size(int *columns, int *rows);

/** Flushes stdout. Returns `exit_status`; or says that not all was printed, and where the report was `written`. */
int command_finish(int exit_status, const char *written);

/** Prints a value (docs/commands.md) to stdout, numbers with 17 digits; frees it. command_finish() reports failures. */
void command_json_print(json_t *json);

/* How a signal ends the program: in order if that is quick, else at once, and nothing temporary is left. */

/** Runs the program, `body`, on a thread of its own and returns its exit status. The calling thread takes SIGINT,
 * SIGTERM and SIGHUP unless they are ignored. On the first one it stops the other programs that run. When the body
 * returns, or its time (signals_stop()) is over, or on a second signal, it removes everything of base/temporary.h, says
 * so in one line, and ends the program by that signal. Before that, closed standard streams are opened as unusable
 * ones, so that no file gets their numbers, and too large files become errors. */
int signals_run(command_run *body, int argc, char **argv);

/** Becomes true when a signal has come. Who asks must look at it, and then has `milliseconds` to end in order. */
const atomic_bool *signals_stop(int milliseconds);

/** True once: the caller is the one to say that a signal has come. */
bool signals_first_word(void);

#endif
