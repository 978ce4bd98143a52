/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The program's commands: one row each. A command parses its own arguments, prints, and returns the exit status. */
#ifndef CLI_COMMAND_H
#define CLI_COMMAND_H

#include "base/status.h"
#include "base/text.h"
#include "direct/direct_team.h"

#include <argp.h>
#include <jansson.h>
#include <stdbool.h>

/** Exit statuses of every command (documented in the README; command_statuses says them). */
enum command_exit {
    COMMAND_DONE = 0,
    COMMAND_REFUSED = 1, /* a report was written, but some scan was refused; self-test: a number is off */
    COMMAND_USAGE = 2,
    COMMAND_SCENE = 3,
    COMMAND_NOTHING = 4, /* nothing could be reported, or not on standard output */
    COMMAND_MISSED = 5,  /* report --check: a report was written, but a surface misses a limit */
    COMMAND_STATUSES,
};

/** What each of them means. */
extern const char *const command_statuses[COMMAND_STATUSES];

struct command_row {
    const char *name;
    const char *arguments;
    const char *summary;
    int (*run)(int argc, char **argv); /* argv[0] is "roughcontact NAME" */
    const struct argp *argp;           /* its options */
};
enum { COMMANDS = 10 };
extern const struct command_row command_rows[COMMANDS];

/** All of the program but main(): picks the command and returns the exit status. */
int command_main(int argc, char **argv);

int command_report(int argc, char **argv);
int command_direct(int argc, char **argv);
int command_plan(int argc, char **argv);
int command_view(int argc, char **argv);
int command_inspect(int argc, char **argv);
int command_synth(int argc, char **argv);
int command_models(int argc, char **argv);
int command_materials(int argc, char **argv);
int command_self_test(int argc, char **argv);
int command_help(int argc, char **argv);

extern const struct argp command_report_argp, command_direct_argp, command_plan_argp, command_inspect_argp,
    command_synth_argp, command_view_argp, command_models_argp, command_materials_argp, command_self_test_argp,
    command_help_argp;

/** What every command takes besides: -h and --help, which are the same, and --usage. */
extern const struct argp command_common_argp;

/** Reads the command line, to the end of the program where it is wrong (COMMAND_USAGE) or asks for help. */
void command_parse(const struct argp *argp, int argc, char **argv, void *input);
/** For ARGP_KEY_ARG of a command that takes none: fails. */
error_t command_no_argument(const char *value, struct argp_state *state);

/** Version and what the program is made of, a line each. */
void command_version(struct text *out);

/** From now on the contacts that `report` and `direct` solve directly are shared by these processes; NULL: not. */
void command_use_team(const struct direct_team *team);

/** Prints "roughcontact: `what``message`" as one line on stderr; what a terminal might act upon comes out as '?'. */
void command_complain(const char *what, const char *message);

/** Prints the message in the same way and returns the exit status that goes with the code. */
int command_fail(const struct status *status);

/** What is installed as share/roughcontact/`name` beside the program's bin. Error: STATUS_IO. */
MUST_CHECK enum status_code command_share(struct text *out, const char *name, struct status *status);

/** The length [m] that option `name` gives: 0.8mm, 8 um, or a plain number in m; ends the program where it is none. */
double command_length(const char *name, const char *value, struct argp_state *state);

/** Columns and rows of the terminal on stdout, else of $COLUMNS and $LINES, else 100 x 30. */
void command_terminal_size(int *columns, int *rows);

/** Flushes stdout. Returns `exit_status`, or says that not all could be printed and, where it was `written`, in which
 * file the report is. */
int command_finish(int exit_status, const char *written);

/* What the commands print as JSON (docs/commands.md). */

/** `hostile` as it may be shown: JSON is UTF-8, a file name need not be. */
json_t *command_json_text(const char *hostile);
/** A text that there may not be; NULL: null. */
json_t *command_json_optional(const char *text);
/** A number; null for NaN, and for what is without end. */
json_t *command_json_number(double value);
/** The lines of a text. */
json_t *command_json_lines(const char *lines);
/** Prints it to stdout, numbers with 17 digits; takes it over. False: out of memory. */
bool command_json_print(json_t *json);

#endif
