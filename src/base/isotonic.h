/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Isotonic regression: what is known to rise, or to fall, made to do so. */
#ifndef BASE_ISOTONIC_H
#define BASE_ISOTONIC_H

#include <stdbool.h>
#include <stddef.h>

/** Replaces `count` values, `step` apart, by the sequence next to them in the mean square that never falls (`falls`:
 * never rises): neighbours that violate it are pooled (Ayer et al., Ann. Math. Stat. 26 (1955) 641). */
void isotonic(double *value, size_t count, size_t step, bool falls);

#endif
