/* Chapter 6 of the thesis, claim by claim, checked on the user's surfaces. One row a claim. */
#ifndef REPORT_CLAIM_H
#define REPORT_CLAIM_H

#include "results/comparison.h"

enum claim_verdict { CLAIM_HOLDS, CLAIM_PARTLY, CLAIM_FAILS, CLAIM_NOT_TESTED };

struct claim_row {
    const char *section; /* of the thesis */
    const char *statement;
    unsigned effects;  /* EFFECT_BITs it needs */
    unsigned families; /* enum scene_model bits it needs */
    bool several;      /* needs at least two surfaces */
    /** Adds the evidence, with its figures, and says how the claim fares. */
    enum claim_verdict (*check)(struct text *evidence, const struct results *results, const struct comparison *study);
};

extern const struct claim_row claim_rows[];
extern const size_t claim_count;

/** The table of all claims that can be checked with what ran. */
void claim_table(struct text *out, const struct results *results, const struct comparison *study);

#endif
