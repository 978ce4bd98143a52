/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tables of conductance over pressure for other programs: OUT/export/. Every file NAME.ENDING of templates/export
 * is a program NAME, filled for each surface from its item of the view's `exports`. */
#ifndef REPORT_EXPORT_H
#define REPORT_EXPORT_H

#include "scene/scene.h"
#include <jansson.h>

/** Is there a template for every program that the scene names, and a material on every surface? Nothing is asked of a
 * scene that names none. Errors: STATUS_SCENE: a program that is not there (those there are), none named, a surface
 * without material; STATUS_IO: templates/export cannot be read. */
MUST_CHECK enum status_code export_check(const struct scene *scene, const char *templates, struct status *status);

/** Writes export/SURFACE.NAME.ENDING below `directory`, which has an export/, and names them in the view. Errors: of a
 * template, STATUS_IO, STATUS_MEMORY. */
MUST_CHECK enum status_code export_write(json_t *view, const struct scene *scene, const char *templates,
                                         const char *directory, struct status *status);

#endif
