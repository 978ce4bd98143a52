/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The direct solution of a surface whose data is a map: squares of it, and how far off they may be (transfer.h). */
#ifndef MEMBERS_TILES_H
#define MEMBERS_TILES_H

#include "base/threads.h"
#include "contact/transfer.h"
#include "direct/direct_map.h"
#include "scan/scan.h"

enum { TILES_SIDE = 512, TILES_MOST = 4 };

/** Owned: tiles_free(). */
struct tiles {
    double *height_m;           /* conditioned, row after row; NULL: no map */
    struct direct_map_def def;  /* of all of it */
    size_t side, columns, rows; /* squares of the map that are solved */
    size_t all;                 /* squares that it holds */
    struct transfer *transfer;  /* NULL: not solved */
    double low_pass[3];         /* ln of area, gap and constriction length that the low-pass has changed, about, at a
                                   middle load; 0: none */
    struct status problem;      /* why it is not */
    uint64_t transforms;        /* pairs of transforms times points that solving took */
};
void tiles_free(struct tiles *tiles);

/** Takes over the heights of a conditioned map whose spacings are the same, 1 % apart at most, of 32 points a side or
 * more; leaves others. */
void tiles_take(struct tiles *out, struct scan *scan, const struct direct_map_def *def);

/** Two rough bodies: adds the heights of another map of the same spacing, from a place on that is drawn by hash; beyond
 * its ends it goes on as its mirror image, or around if it is periodic. Else the tiles are none. */
void tiles_pair(struct tiles *tiles, const struct tiles *other);

/** Pairs of transforms times points that the squares take, about; 0: there is no map. */
double tiles_cost(const struct tiles *tiles, bool capped);
/** The count that a whole report spends at most on them, unless its scene names its models: about ten minutes of one
 * core. */
extern const double tiles_budget;
/** Solves fewer of the squares, at least one, until they take no more than `most`; false: one takes more. */
bool tiles_fit(struct tiles *tiles, bool capped, double most);

/** Solves the squares, elastic and below the hardness h = H/E' (INFINITY: elastic alone), and what tells their error. A
 * map that has no answer has none. The same from any number of threads. Errors: STATUS_INTERRUPTED, STATUS_MEMORY. */
MUST_CHECK enum status_code tiles_solve(struct tiles *tiles, double hardness, const struct threads *threads,
                                        struct status *status);

#endif
