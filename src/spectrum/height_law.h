/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Are the heights of a scan Gaussian, as models take them to be that know only its spectrum or moments? The one
 * criterion of the program. */
#ifndef SPECTRUM_HEIGHT_LAW_H
#define SPECTRUM_HEIGHT_LAW_H

#include "profile/level.h"
#include "spectrum/roughness.h"

enum height_verdict {
    HEIGHTS_GAUSSIAN,     /* within the limits, in which such models may be trusted */
    HEIGHTS_CANNOT_TELL,  /* beyond, but no farther than a scan of a Gaussian surface may be by chance */
    HEIGHTS_NOT_GAUSSIAN, /* beyond, and farther than chance takes them; or chance is not known */
    HEIGHT_VERDICTS
};

struct height_verdict_row {
    const char *name; /* as in results.json */
    const char *mark; /* beside what such a model says of the surface */
};
extern const struct height_verdict_row height_verdicts[HEIGHT_VERDICTS];

struct height_law {
    enum height_verdict verdict;
    double chance[2]; /* share of simulated scans whose Rsk, Rku is as far from their median; NaN: not simulated */
};

/** `spectrum`: best that of multitaper.h, with which 1 to 8 % of Gaussian scans are taken for others; up to 15 % with a
 * periodogram, as the one scan's own waves scatter in it.
 * The limits: |Rsk| < 0.5 and 2.5 <= Rku <= 4. Beyond them, 256 Gaussian scans with the surface's spectrum are
 * simulated (simulated_record.h), levelled like its own and averaged over as many (`scans`, not always whole, at least
 * 1): a scan of few long waves has few independent heights, so its Rsk and Rku scatter. What lies beyond its limit and
 * is met in fewer than 2.5 % of them, two-sided, is no chance. Where there are fewer than 7 harmonics, or no power in
 * them, the limits alone decide. Within the limits nothing is computed. Error: STATUS_MEMORY. */
MUST_CHECK enum status_code height_law_find(struct height_law *out, const struct roughness *roughness,
                                            const struct spectrum *spectrum, double scans, enum level level,
                                            struct status *status);

#endif
