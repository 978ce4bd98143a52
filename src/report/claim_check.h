/* The checks behind the rows of claim.c: each adds its evidence and says how the claim fares. */
#ifndef REPORT_CLAIM_CHECK_H
#define REPORT_CLAIM_CHECK_H

#include "report/claim.h"

/** Summary of the k-th smoothest surface. */
const struct surface_summary *claim_surface(const struct results *results, size_t k);
/** Holds when the share is 1, in part from a half up. */
enum claim_verdict claim_verdict_of(size_t good, size_t all);

/* One surface at a time (claim_check.c). */
enum claim_verdict claim_gamma(struct text *out, const struct results *results, const struct comparison *study);
enum claim_verdict claim_convergence(struct text *out, const struct results *results, const struct comparison *study);
enum claim_verdict claim_linear(struct text *out, const struct results *results, const struct comparison *study);
enum claim_verdict claim_plastic_above(struct text *out, const struct results *results, const struct comparison *study);
enum claim_verdict claim_closed(struct text *out, const struct results *results, const struct comparison *study);
enum claim_verdict claim_elbow(struct text *out, const struct results *results, const struct comparison *study);
enum claim_verdict claim_families(struct text *out, const struct results *results, const struct comparison *study);
enum claim_verdict claim_proportional(struct text *out, const struct results *results, const struct comparison *study);
enum claim_verdict claim_scale_dependence(struct text *out, const struct results *results,
                                          const struct comparison *study);
enum claim_verdict claim_sooner(struct text *out, const struct results *results, const struct comparison *study);
enum claim_verdict claim_beta(struct text *out, const struct results *results, const struct comparison *study);

/* Surfaces against each other (claim_rank.c). */
enum claim_verdict claim_gamma_rank(struct text *out, const struct results *results, const struct comparison *study);
enum claim_verdict claim_area_rank(struct text *out, const struct results *results, const struct comparison *study);
enum claim_verdict claim_spread(struct text *out, const struct results *results, const struct comparison *study);
enum claim_verdict claim_separation_rank(struct text *out, const struct results *results,
                                         const struct comparison *study);
enum claim_verdict claim_ecr_rank(struct text *out, const struct results *results, const struct comparison *study);
enum claim_verdict claim_tcr_rank(struct text *out, const struct results *results, const struct comparison *study);

#endif
