/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What `report`, `direct` and `plan` print with --json (docs/commands.md). */
#ifndef CLI_SCENE_JSON_H
#define CLI_SCENE_JSON_H

#include "run/prepare.h"
#include "run/run.h"

/** What came out of a report on `directory`: `outcome` NULL where it did not begin, `error` NULL where there is one. */
void scene_json_print_report(const struct run_outcome *outcome, const char *directory, int exit_status,
                             const char *error);

/** The plan of a whole report, or of its first page (`brief`), and roughly how long that takes: `results` NULL where
 * there is none, and `error` says why. */
void scene_json_print_plan(const struct results *results, double rough_seconds, const char *directory, bool brief,
                           const char *messages, int exit_status, const char *error);

#endif
