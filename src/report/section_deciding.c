/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The first page's charts: the answer of all surfaces against load, and how far a direct solution is from it. */
#include "report/section.h"

static section_caption *const captions[SECTION_FIRST_PLACES] = {section_all_surfaces_caption, section_direct_caption};

static bool called_for(const struct section_context *context)
{
    bool any = false;
    for (int place = 0; place < SECTION_FIRST_PLACES; place++)
        any = any || section_has_figures(context, section_first_page[place]);
    return any;
}

static void write(struct text *out, const struct section_context *context)
{
    for (int place = 0; place < SECTION_FIRST_PLACES; place++)
        section_figures(out, context, section_first_page[place], captions[place]);
}

const struct section section_deciding = {"deciding", called_for, write};
