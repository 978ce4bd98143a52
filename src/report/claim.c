#include "report/claim_check.h"

enum {
    PLASTIC = EFFECT_BIT(EFFECT_PLASTICITY),
    SEPARATION = EFFECT_BIT(EFFECT_SEPARATION),
    ELECTRICAL = EFFECT_BIT(EFFECT_ELECTRICAL),
    THERMAL = EFFECT_BIT(EFFECT_THERMAL),
    BOTH_FAMILIES = SCENE_MODEL_MULTISCALE | SCENE_MODEL_STATISTICAL,
};

const struct claim_row claim_rows[] = {
    {"6.2", "Whether the area converges depends on γ ≥ 1, not on α", EFFECT_BIT(EFFECT_CONVERGENCE), 0, false,
     claim_convergence},
    {"6.2", "γ ≥ 1, so the area converges", 0, SCENE_MODEL_MULTISCALE, false, claim_gamma},
    {"6.3.1", "The area is linear in the load", 0, 0, false, claim_linear},
    {"6.3.1", "Plastic area is above elastic area", PLASTIC, 0, false, claim_plastic_above},
    {"6.3.2", "No separation is left at full contact", SEPARATION, SCENE_MODEL_MULTISCALE, false, claim_closed},
    {"6.3.3", "ECR falls steeply only as contact completes (the elbow)", ELECTRICAL, 0, false, claim_elbow},
    {"6.3.3", "The two families agree better in ECR than in area", ELECTRICAL, BOTH_FAMILIES, false, claim_families},
    {"6.3.4", "TCR is ECR in other units", ELECTRICAL | THERMAL, 0, false, claim_proportional},
    {"6.3.4", "Scale dependence is negligible (below 5 %)", EFFECT_BIT(EFFECT_SCALE_DEPENDENT), 0, false,
     claim_scale_dependence},
    {"6.4", "γ falls as roughness rises", 0, 0, true, claim_gamma_rank},
    {"6.4.1", "Smoother surfaces have the larger area", 0, 0, true, claim_area_rank},
    {"6.4.1", "Plasticity narrows the spread between surfaces", PLASTIC, 0, true, claim_spread},
    {"6.4.1", "Plastic models reach full contact at lower loads", PLASTIC, 0, false, claim_sooner},
    {"6.4.2", "Separation/σ is not ranked by roughness", SEPARATION, 0, true, claim_separation_rank},
    {"6.4.2", "β lies between 4 and 12", SEPARATION, SCENE_MODEL_STATISTICAL, false, claim_beta},
    {"6.4.3", "Smoother surfaces have the smaller ECR", ELECTRICAL, 0, true, claim_ecr_rank},
    {"6.4.4", "Smoother surfaces have the smaller TCR", THERMAL, 0, true, claim_tcr_rank},
};
const size_t claim_count = sizeof claim_rows / sizeof claim_rows[0];

const struct surface_summary *claim_surface(const struct results *results, size_t k)
{
    return &results->store->summaries[results->by_roughness[k]];
}

enum claim_verdict claim_verdict_of(size_t good, size_t all)
{
    return all == 0 ? CLAIM_NOT_TESTED : good == all ? CLAIM_HOLDS : 2 * good >= all ? CLAIM_PARTLY : CLAIM_FAILS;
}

void claim_table(struct text *out, const struct results *results, const struct comparison *study)
{
    static const char *const verdicts[] = {[CLAIM_HOLDS] = "holds",
                                           [CLAIM_PARTLY] = "in part",
                                           [CLAIM_FAILS] = "fails",
                                           [CLAIM_NOT_TESTED] = "not tested"};
    text_add(out, "| thesis | claim | here | evidence |\n|---|---|---|---|\n");
    for (size_t i = 0; i < claim_count; i++) {
        const struct claim_row *row = &claim_rows[i];
        if ((row->effects & ~results->plan->running) || (row->families & ~results->plan->families) ||
            (row->several && results->usable_count < 2))
            continue;
        struct text evidence = {0};
        enum claim_verdict verdict = row->check(&evidence, results, study);
        text_add(out, "| %s | %s | **%s** | ", row->section, row->statement, verdicts[verdict]);
        text_add_bytes(out, text_string(&evidence), evidence.length);
        text_add(out, " |\n");
        text_free(&evidence);
    }
    text_add(out, "\n*Holds*: in every case compared; *in part*: in at least half of them; *fails*: in fewer.\n");
}
