/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The contact of a map at one load: what its picture shows, and its spots. Of the square that is solved first. */
#ifndef MEMBERS_MAP_CONTACT_H
#define MEMBERS_MAP_CONTACT_H

#include "members/tiles.h"

enum { MAP_CONTACT_CELLS = 256, MAP_CONTACT_SPOTS = 100000 };

/** A patch of points in contact that have a face in common; over the edge of a map that closes it goes on. */
struct map_spot {
    double x_m, y_m, area_m2; /* the middle of its points, from the map's first; its points times dx dy */
    double force_m2;          /* over E' */
};

/** Owned: map_contact_free(). */
struct map_contact {
    size_t cells;                                   /* a side of the picture */
    double cell_m, from_m[2];                       /* a cell's side; where the square begins in its map */
    double *height_m;                               /* cells * cells, row after row: the mean over each */
    enum { MAP_OPEN, MAP_TOUCHES, MAP_FLOWS } * is; /* the same: the most of its points */
    size_t points;                                  /* of the section, the row that carries most: */
    double spacing_m, section_m, *pressure;         /* its place across; p/E' of the points along it */
    double area_ratio, flowed;                      /* in contact; of that at the hardness */
    size_t spot_count;
    struct map_spot *spots; /* NULL: more than MAP_CONTACT_SPOTS */
};

/** Solves the contact of a solved map at load p/E' below the hardness H/E' (INFINITY: elastic); what has no answer has
 * no cells. Errors: STATUS_INTERRUPTED, STATUS_MEMORY. */
MUST_CHECK enum status_code map_contact_find(struct map_contact *out, const struct tiles *tiles, double load,
                                             double hardness, const atomic_bool *stop, struct status *status);
void map_contact_free(struct map_contact *contact);

#endif
