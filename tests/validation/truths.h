/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VALIDATION_TRUTHS_H
#define VALIDATION_TRUTHS_H

#include "base/text.h"
#include "spectrum/roughness.h"

/** docs/validation.md in the making: page.md, with rows in place of its lines @name. */
struct page {
    struct text text;
    const char *rest; /* of page.md */
    size_t outside;   /* numbers beyond their bound, which are named as well */
};

/** Goes on to the place of the rows @name. */
void page_rows(struct page *page, const char *name);
/** A cell "0.013 (≤ 0.02) |"; bound 0: none. */
void page_number(struct page *page, double value, double bound);

/** Numbers known from elsewhere: up to the thesis's tables. */
void truths_add(struct page *page);
/** Asperities of one of surfaces/chapter6, 1 to 4. */
struct asperities truths_asperities(int surface);
/** The integrals of the statistical models by the thesis's rule and by the program's. */
void quadrature_add(struct page *page);
/** Bulged rough surfaces: the cells of the joint's shape against direct solutions. */
void shapes_add(struct page *page);
/** Simulated coverage of the fit's and the scans' intervals. */
void truths_add_coverage(struct page *page);

#endif
