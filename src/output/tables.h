/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The files of OUT/data (docs/report.md): CSV, every number SI with 17 digits. Columns and rows of effects that did
 * not run are absent; what a model does not compute is an empty cell. */
#ifndef OUTPUT_TABLES_H
#define OUTPUT_TABLES_H

#include "base/threads.h"
#include "output/record.h"

/** spectrum.csv, contact.csv and, where a curve has an interval, bands.csv below `directory`, surface by surface. */
struct curve_tables;

/** Makes them, with the columns of the plan; `directory`, which has a data/, is not copied. Owned:
 * curve_tables_close(), whatever comes back. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code curve_tables_open(struct curve_tables **out, const struct results *results,
                                              const char *directory, struct status *status);
/** Writes one surface's rows, from any thread, in the order of turns. Errors: STATUS_IO, STATUS_MEMORY.
 */
MUST_CHECK enum status_code curve_tables_put(struct curve_tables *tables, const struct surface_record *record,
                                             struct threads_turn *turn, struct status *status);
/** Ends them; NULL: there are none. Returns the first problem, also one there already is in `status`. */
MUST_CHECK enum status_code curve_tables_close(struct curve_tables *tables, struct status *status);

/** Writes all other files below `directory`, and those of the curves too where these are all in memory; one without
 * rows is not there. Errors: STATUS_IO, STATUS_MEMORY.
 */
MUST_CHECK enum status_code tables_write(const struct results *results, const char *directory, struct status *status);

/** The answers to the scene's targets, or how every surface stands to every limit, as objects. */
enum tables_objects { TABLES_ANSWERS, TABLES_LIMITS };
json_t *tables_json(const struct results *results, enum tables_objects what);

/** What is said of a surface, of its repeated scans and of an answer, in data/ and in results.json. */
extern const struct record_field surface_fields[], repeats_fields[], answer_fields[], limit_fields[];
/** The conditions that columns of surfaces are there under: bits of `when`. */
unsigned tables_surface_when(const struct results *results);
/** Number `which` of a curve that may be known by an interval (curve_summary_estimate()); NULL: it never is. */
const char *tables_estimate_key(int which);

#endif
