/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The surfaces' arrays on disk between evaluation and report, so that memory does not grow with their number.
 * Summaries stay in memory; spectra, curves and previews go to an unnamed temporary file. */
#ifndef RESULTS_SURFACE_STORE_H
#define RESULTS_SURFACE_STORE_H

#include "analysis/work.h"
#include "results/surface_bytes.h"
#include <pthread.h>
#include <stdio.h>

/** Where a surface's bytes begin. */
struct surface_place {
    off_t arrays, curves;
};

struct surface_store {
    struct surface_summary *summaries; /* one a surface of the scene, in its order */
    struct surface_place *places;      /* the same, in `file` */
    size_t count;
    FILE *file;              /* stands at its end */
    struct work models_done; /* by the models, of all surfaces stored */
    pthread_mutex_t lock;    /* guards these while they are added to */
    size_t lost;             /* numbers that came out infinite; their cells are empty */
    char first_lost[256];    /* what is said of the first */
};

/** `directory` is where the temporary file goes (it is unlinked at once), "" the system's place for such; NULL: only
 * summaries are kept. Owned: surface_store_close(). Errors: STATUS_IO, STATUS_MEMORY. */
MUST_CHECK enum status_code surface_store_open(struct surface_store *out, const char *directory, size_t count,
                                               struct status *status);
void surface_store_close(struct surface_store *store);

/** Stores surface `index`, in place of what was stored for it before, and takes its summary's texts over; may be called
 * from several threads. What its models took is counted: once they have run, a surface is stored once. Error:
 * STATUS_IO; then the texts are still the caller's. */
MUST_CHECK enum status_code surface_store_put(struct surface_store *store, size_t index,
                                              const struct surface_record *record, struct status *status);
/** The arrays alone, while the rest of the record is still being made; surface_store_update() follows. Error:
 * STATUS_IO.
 */
MUST_CHECK enum status_code surface_store_put_arrays(struct surface_store *store, size_t index,
                                                     const struct surface_record *record, struct status *status);
/** Stores the record of which the arrays have been stored, and are as they were or have been dropped: models change
 * none. Else as surface_store_put(). */
MUST_CHECK enum status_code surface_store_update(struct surface_store *store, size_t index,
                                                 const struct surface_record *record, struct status *status);
/** Reads a part back, from any thread; else as surface_store_get(). */
MUST_CHECK enum status_code surface_store_get_part(struct surface_record *out, struct surface_store *store,
                                                   size_t index, enum surface_bytes_part part, struct status *status);
/** Reads it back, from any thread; end it with surface_record_free(record, false). Errors: STATUS_IO, STATUS_MEMORY. */
MUST_CHECK enum status_code surface_store_get(struct surface_record *out, struct surface_store *store, size_t index,
                                              struct status *status);

#endif
