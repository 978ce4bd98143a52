/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A map's heights with its contact, and the pressure along a section: templates/charts/map.gp. */
#ifndef CHART_MAP_PICTURE_H
#define CHART_MAP_PICTURE_H

#include "base/mustache.h"
#include "material/material.h"
#include "members/map_contact.h"

/** "map-" and of a surface's name, which may be anything, what stands in any file's name: ASCII letters and digits, -
 * for others; cut to the size. */
void map_picture_name(char *out, size_t size, const char *surface);
/** Writes NAME.csv and NAME.gp into `directory`, with a title that may be anything. Errors: of templates, STATUS_IO,
 * STATUS_MEMORY. */
MUST_CHECK enum status_code map_picture_write(const struct map_contact *contact, const struct material_pair *pair,
                                              const char *name, const char *title, struct mustache_folder *templates,
                                              const char *directory);

#endif
