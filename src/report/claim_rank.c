#include "report/claim_check.h"

#include "base/number_format.h"
#include <math.h>

/** The shares of comparisons in this order, a model each; `offset` picks the counter of struct comparison_rank. */
static enum claim_verdict check_rank(struct text *out, const struct comparison *study, size_t offset)
{
    size_t pairs = 0, ranked = 0;
    text_add(out, "of neighbours in roughness, load by load, so ordered: ");
    for (int m = 0; m < MODEL_COUNT; m++) {
        const struct comparison_rank *rank = &study->rank[m];
        if (rank->pairs == 0)
            continue;
        size_t count = *(const size_t *)((const char *)rank + offset);
        text_add(out, "%s%s %.0f %%", pairs > 0 ? "; " : "", model_rows[m].label,
                 floor(100 * (double)count / (double)rank->pairs));
        pairs += rank->pairs;
        ranked += count;
    }
    return claim_verdict_of(ranked, pairs);
}

enum claim_verdict claim_area_rank(struct text *out, const struct results *results, const struct comparison *study)
{
    (void)results;
    return check_rank(out, study, offsetof(struct comparison_rank, area));
}

enum claim_verdict claim_ecr_rank(struct text *out, const struct results *results, const struct comparison *study)
{
    (void)results;
    return check_rank(out, study, offsetof(struct comparison_rank, ecr));
}

enum claim_verdict claim_tcr_rank(struct text *out, const struct results *results, const struct comparison *study)
{
    (void)results;
    return check_rank(out, study, offsetof(struct comparison_rank, tcr));
}

/** The thesis finds no order here: a model agrees when the smoother neighbour comes out on either side. */
enum claim_verdict claim_separation_rank(struct text *out, const struct results *results,
                                         const struct comparison *study)
{
    size_t models = 0, mixed = 0;
    (void)results;
    (void)check_rank(out, study, offsetof(struct comparison_rank, separation));
    for (int m = 0; m < MODEL_COUNT; m++) {
        const struct comparison_rank *rank = &study->rank[m];
        models += rank->pairs > 0;
        mixed += rank->separation > 0 && rank->separation < rank->pairs;
    }
    text_add(out, " (0 and 100 %% would be an order)");
    return claim_verdict_of(mixed, models);
}

enum claim_verdict claim_spread(struct text *out, const struct results *results, const struct comparison *study)
{
    size_t tested = 0, narrower = 0;
    (void)results;
    text_add(out, "largest/smallest area of the surfaces at P/(Aₙ E′) = ");
    number_format_power(out, study->middle_load, 3);
    for (int f = 0; f < 2; f++) {
        const struct comparison_extremes *elastic =
            &study->extremes[f == 0 ? MODEL_MULTISCALE_ELASTIC : MODEL_GW][COMPARISON_AREA];
        const struct comparison_extremes *plastic =
            &study->extremes[f == 0 ? MODEL_MULTISCALE_PLASTIC : MODEL_JG][COMPARISON_AREA];
        if (elastic->count < 2 || plastic->count < elastic->count)
            continue;
        number_format_add(out,
                          f == 0        ? ": multiscale elastic "
                          : tested == 0 ? ": statistical elastic "
                                        : "; statistical elastic ",
                          elastic->most / elastic->least, 3, ", plastic ");
        number_format_number(out, plastic->most / plastic->least, 3);
        tested++;
        narrower += plastic->most * elastic->least < elastic->most * plastic->least;
    }
    if (tested == 0)
        text_add(out, ": not all surfaces are in partial contact there");
    return claim_verdict_of(narrower, tested);
}

/** Is gamma lower for the rougher of two neighbours? */
enum claim_verdict claim_gamma_rank(struct text *out, const struct results *results, const struct comparison *study)
{
    (void)study;
    size_t pairs = 0, falling = 0;
    for (size_t k = 1; k < results->usable_count; k++) {
        double smooth = claim_surface(results, k - 1)->power_law.gamma,
               rough = claim_surface(results, k)->power_law.gamma;
        pairs += isfinite(smooth) && isfinite(rough);
        falling += smooth > rough;
    }
    text_add(out, "γ falls from the smoother to the rougher neighbour in %zu of %zu pairs", falling, pairs);
    return pairs == 0 ? CLAIM_NOT_TESTED : claim_verdict_of(falling, pairs);
}
