/* The program's commands: one row each. A command parses its own arguments, prints, and returns the exit status. */
#ifndef CLI_COMMAND_H
#define CLI_COMMAND_H

#include "base/status.h"
#include "base/text.h"
#include "direct/direct_crew.h"

/** Exit statuses of every command (documented in the README). */
enum command_exit {
    COMMAND_DONE = 0,
    COMMAND_REFUSED = 1, /* a report was written, but some scan was refused */
    COMMAND_USAGE = 2,
    COMMAND_SCENE = 3,
    COMMAND_NOTHING = 4, /* nothing could be reported, or not on standard output */
    COMMAND_MISSED = 5,  /* report --check: a report was written, but a surface misses a limit */
};

struct command_row {
    const char *name;
    const char *arguments;
    const char *summary;
    int (*run)(int argc, char **argv); /* argv[0] is "roughcontact NAME" */
};

/** All of the program but main(): picks the command and returns the exit status. */
int command_main(int argc, char **argv);

int command_report(int argc, char **argv);
int command_direct(int argc, char **argv);
int command_plan(int argc, char **argv);
int command_inspect(int argc, char **argv);
int command_synth(int argc, char **argv);
int command_models(int argc, char **argv);
int command_materials(int argc, char **argv);

/** From now on other processes solve the contacts of `report` and `direct`; NULL: none. */
void command_use_crew(const struct direct_crew *crew);

/** Prints "roughcontact: `what``message`" as one line on stderr; what a terminal might act upon comes out as '?'. */
void command_complain(const char *what, const char *message);

/** Prints the message in the same way and returns the exit status that goes with the code. */
int command_fail(const struct status *status);

/** Directory of the templates: share/roughcontact/templates beside the program's bin. Error: STATUS_IO. */
MUST_CHECK enum status_code command_templates(struct text *out, struct status *status);

/** Columns and rows of the terminal on stdout, else of $COLUMNS and $LINES, else 100 x 30. */
void command_terminal_size(int *columns, int *rows);

/** Flushes stdout. Returns `exit_status`, or says that not all could be printed and, where it was `written`, in which
 * file the report is. */
int command_finish(int exit_status, const char *written);

#endif
