/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs the built program (or another) without a shell, in a directory of its own that is removed at the end. */
#ifndef TEST_CLI_PROCESS_H
#define TEST_CLI_PROCESS_H

#include "directory.h"

#include <jansson.h>
#include <sys/types.h>

/** A finished process, the test's: what it wrote and how it ended. */
struct process {
    int status;      /* its exit status, or 128 + the signal that ended it */
    char *out, *err; /* NUL-terminated */
    size_t out_length;
};

/** A process that runs, its output still to be collected. */
struct process_running {
    pid_t pid;
    int out, err;
};

/** A cmocka test with a workspace, `place`: a directory in which the program runs, removed at the end. */
#define TEST_IN_WORKSPACE(name)                                                                                        \
    static void name##_in(const char *place);                                                                          \
    TEST_WITH(name, directory_setup, directory_teardown)                                                               \
    {                                                                                                                  \
        name##_in(*state);                                                                                             \
    }                                                                                                                  \
    static void name##_in(__attribute__((unused)) const char *place)

/** Starts the program in the workspace. */
#define process_start(place, ...) process_start_list((place), (const char *const[]){PROGRAM, __VA_ARGS__, NULL}, NULL)
/** Runs the program to its end. */
#define process_run(place, ...) process_end(process_start(place, __VA_ARGS__))
/** The same for any program, found in PATH; stdout goes to the file `output` (NULL: it is collected). */
struct process_running process_start_list(const char *place, const char *const *arguments, const char *output);
struct process process_end(struct process_running running);
#define run_program(place, ...) process_end(process_start_list((place), (const char *const[]){__VA_ARGS__, NULL}, NULL))
/** Joins lines of stdout that were broken to fit a terminal. */
void process_unwrap(struct process *process);

/** Runs the program and fails the test unless it exits with `status`. */
#define expect_exit(place, status, ...) process_expect(process_run(place, __VA_ARGS__), status, __FILE__, __LINE__)
#define expect_status(process, status)  process_expect((process), (status), __FILE__, __LINE__)
struct process process_expect(struct process process, int status, const char *file, int line);
/** Reports d, with this d/scene.yaml (NULL: as it is), into `out` without times; it must exit with 0. */
#define report_scene(place, out, scene) process_report((place), (out), (scene), __FILE__, __LINE__)
struct process process_report(const char *place, const char *out, const char *scene, const char *file, int line);
/** The same where its output does not matter. */
#define run_to_exit(place, status, ...) ((void)expect_exit(place, status, __VA_ARGS__))
/** Fails the test unless stdout, or stderr, of a process that ended holds every one of these parts. */
#define expect_output(process, ...)                                                                                    \
    process_expect_parts((process), true, (const char *const[]){__VA_ARGS__, NULL}, __FILE__, __LINE__)
#define expect_errors(process, ...)                                                                                    \
    process_expect_parts((process), false, (const char *const[]){__VA_ARGS__, NULL}, __FILE__, __LINE__)
void process_expect_parts(struct process process, bool out, const char *const *parts, const char *file, int line);
/** Fails the test unless a document has each key of a JSON value in backquotes, but for names of models and effects
 * and, unless `properties`, of materials' properties. Returns how many keys there are. */
size_t expect_keys_described(const char *document, json_t *json, bool properties);
/** What a process wrote to stdout: a JSON value and nothing else; or fails the test. */
#define process_json(process) support_json((process).out)
/** Runs any program, which must end with 0. */
#define run_list(place, arguments) (void)expect_status(process_end(process_start_list((place), (arguments), NULL)), 0)
/** Runs the program and fails the test unless it exits with `status`, with nothing on stdout and `lines` lines on
 * stderr that hold `message`. */
#define expect_failure(place, status, lines, message, ...)                                                             \
    expect_failed(process_run(place, __VA_ARGS__), status, lines, message)
#define expect_failed(process, status, lines, message)                                                                 \
    process_expect_failure((process), (status), (lines), (message), __FILE__, __LINE__)
void process_expect_failure(struct process process, int status, size_t lines, const char *message, const char *file,
                            int line);

/** Fails the test where a line does not fit a terminal of 80 columns. */
void expect_narrow(const char *text);
#define expect_part(text, part)    expect_parts((text), (part))
#define expect_no_part(text, part) expect_no_parts((text), (part))
/** Fails the test unless `text`, read from `where`, is valid UTF-8 that shows what it holds: no control characters,
 * none that turn the direction or take no room; `tabs`: but tabs. */
void process_expect_clean(const char *text, size_t length, const char *where, bool tabs);
/** Fails the test when `text`, read from `where`, holds nan or inf as a word of its own, with a sign or without. */
void process_expect_numbers(const char *text, const char *where);
/** The same of every file below `path`, but gnuplot's templates. Returns their number. */
size_t workspace_expect_numbers(const char *place, const char *path);

/** Files below the workspace. Parents are made; what is read is the test's, which fails when there is none. */
#define workspace_write  directory_write
#define workspace_folder directory_folder
#define workspace_has    directory_has
#define workspace_table  directory_table
#define workspace_read   directory_read
#define workspace_json   directory_json
void workspace_write_bytes(const char *place, const char *path, const char *bytes, size_t length);
/** Writes a rough scan of `points` points with units in its header; another `seed`, another surface. */
void workspace_scan(const char *place, const char *path, size_t points, unsigned seed);
/** The same of a.csv, b.csv, ... in `folder`, `count` of them, from that seed on. */
void workspace_scans(const char *place, const char *folder, unsigned count, size_t points, unsigned seed);
/** SHA-256 over the names and contents of everything below `path`: the same for the same bytes. */
char *workspace_digest(const char *place, const char *path);
/** Fails the test unless that is `digest`. */
#define expect_digest(place, path, digest) workspace_expect_digest((place), (path), (digest), __FILE__, __LINE__)
void workspace_expect_digest(const char *place, const char *path, const char *digest, const char *file, int line);
/** How many entries, at any depth, have a name that begins with `prefix`. */
size_t workspace_count(const char *place, const char *prefix);
/** Puts the lines of a shell first in PATH as the program `name`. Returns PATH as it was, for workspace_take_back(). */
char *workspace_program(const char *place, const char *name, const char *lines);
void workspace_take_back(char *path);
/** Does a shell's command line succeed in the workspace? */
bool workspace_can_run(const char *place, const char *line);
/** Runs a shell's command line, which must succeed; its stdout. */
char *workspace_shell(const char *place, const char *line);

#endif
