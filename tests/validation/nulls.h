/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VALIDATION_NULLS_H
#define VALIDATION_NULLS_H

#include "directory.h"
#include "members/surface.h"
#include "validation/truths.h"

/** The surfaces of a scene in a directory, as the analysis leaves them. Owned: analysis_free(). */
struct analysis {
    struct scene scene;
    struct plan plan;
    struct surface_record *record; /* scene.surface_count of them */
};
void analysis_make(struct analysis *out, const struct directory *place);
void analysis_free(struct analysis *analysis);

/** How often the same surface is told apart from itself, and others from it. */
void nulls_add(struct page *page);

#endif
