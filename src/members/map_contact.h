/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The contact of a map at one load, on the square that is solved first: its picture and its spots. */
#ifndef MEMBERS_MAP_CONTACT_H
#define MEMBERS_MAP_CONTACT_H

#include "members/tiles.h"

enum { MAP_CONTACT_CELLS = 256, MAP_CONTACT_SPOTS = 100000 };

/** Points in contact that are joined edge to edge; on a periodic map also across its border. */
struct map_spot {
    double x_m, y_m, area_m2; /* centre, from the map's first point; points times dx dy */
    double force_m2;          /* force over E' */
};

/** Owned: map_contact_free(). */
struct map_contact {
    size_t squares;                                 /* of the map that are solved, this one the first */
    size_t cells;                                   /* a side of the picture */
    double cell_m, from_m[2];                       /* side of a cell; where the square begins in its map */
    double *height_m;                               /* cells * cells, row after row: mean height of each */
    enum { MAP_OPEN, MAP_TOUCHES, MAP_FLOWS } * is; /* the same: the highest of its points */
    size_t points;                                  /* along the section, the row that carries most: */
    double spacing_m, section_m, *pressure;         /* where it lies; p/E' along it */
    double touched, flowed;                         /* share of the points in contact; share of these at the hardness */
    size_t spot_count;
    struct map_spot *spots; /* NULL: none, or more than MAP_CONTACT_SPOTS */
};

/** Solves the contact of a map at load p/E' below the hardness H/E' (INFINITY: elastic). Without a solution there are 0
 * cells. Errors: STATUS_INTERRUPTED, STATUS_MEMORY. */
MUST_CHECK enum status_code map_contact_find(struct map_contact *out, const struct tiles *tiles, double load,
                                             double hardness, const atomic_bool *stop, struct status *status);
void map_contact_free(struct map_contact *contact);

#endif
