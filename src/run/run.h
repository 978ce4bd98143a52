/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The main job: from a directory of scans to a report. run.c shows the order of all stages. */
#ifndef RUN_RUN_H
#define RUN_RUN_H

#include "base/text.h"
#include "scene/scene.h"
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>

struct run_options {
    const char *output;        /* OUT, NULL: out/<name of DIR> */
    const char *templates;     /* directory of the templates */
    const char *template;      /* the user's own in place of report.md; NULL: none */
    const char *terminal_size; /* "columns,rows": draw the main charts as text; NULL: no */
    bool no_cost;              /* leave out the cost of accuracy */
    bool brief;                /* only the report's first page, with its figures */
    bool outline;              /* fill run_outcome.outline */
    unsigned jobs;             /* threads; 0: one a processor */
    const atomic_bool *stop;   /* becomes true when the run must end early; NULL: never */
    /** Progress: work done of a stage (0 as it begins), and on what. Called from several threads, one at a time; NULL:
     * not wanted. */
    void (*progress)(const char *stage, const char *name, double done, double all);
};

/** Wall time by stage [s]; stages on several threads are summed. */
struct run_times {
    double read, prepare, spectrum, strips, tiles, convergence, uncertainty, direct, cost, tables, figures, gnuplot,
        report, total;
    double models[64]; /* as many as there are MODEL_BITs */
};

struct run_outcome {
    size_t refused;           /* surfaces of the scene */
    size_t left_out;          /* scans refused of surfaces that have others, and direct solutions lost */
    struct text messages;     /* messages_add(): one line a refused surface and a warning */
    struct text table;        /* the first page's table and sentence for a terminal */
    struct text limits;       /* a line for each surface and limit: missed ones, then undecided or without a value */
    size_t missed, undecided; /* of those */
    struct text charts;       /* when terminal_size was given */
    char *path;               /* of report.html */
    struct text work;         /* work done, by effect */
    struct json_t *outline;   /* json_outline(), when asked for; else NULL */
    uint64_t evaluations;     /* done */
    struct run_times times;
};

/** Runs `scene` and writes the report. Owned in any case: run_outcome_free(). Errors: STATUS_SCAN if no surface could
 * be read (out->messages says why), STATUS_CHART, STATUS_IO, STATUS_MEMORY, STATUS_INTERRUPTED; then OUT is as it was,
 * but for the exception in exchange_commit(). */
MUST_CHECK enum status_code run_report(struct run_outcome *out, const struct scene *scene,
                                       const struct run_options *options, struct status *status);
void run_outcome_free(struct run_outcome *outcome);

#endif
