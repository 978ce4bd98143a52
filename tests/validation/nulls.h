/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef VALIDATION_NULLS_H
#define VALIDATION_NULLS_H

#include "validation/truths.h"

/** How often the same surface is told apart from itself, and others from it. */
void nulls_add(struct page *page);

#endif
