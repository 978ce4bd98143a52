#include "report/claim.h"

#include "report/words.h"
#include <math.h>

static const struct surface_summary *usable(const struct results *results, size_t k)
{
    return &results->spool->summaries[results->by_roughness[k]];
}

/** Range of a number over all surfaces in one model; false when no surface has it. */
static bool range_of(double (*value)(const struct surface_summary *, enum model_id), const struct results *results,
                     enum model_id model, double *least, double *most)
{
    *least = INFINITY;
    *most = -INFINITY;
    for (size_t k = 0; k < results->usable_count; k++) {
        const struct surface_summary *summary = usable(results, k);
        double number = summary->models[model].exists ? value(summary, model) : NAN;
        if (isfinite(number)) {
            *least = fmin(*least, number);
            *most = fmax(*most, number);
        }
    }
    return *least <= *most;
}

static enum claim_verdict verdict_of(double share)
{
    return share >= 0.999 ? CLAIM_HOLDS : share >= 0.5 ? CLAIM_PARTLY : CLAIM_FAILS;
}

/** Evidence of one range a model, "label least to most" joined by semicolons. */
static void add_ranges(struct text *out, double (*value)(const struct surface_summary *, enum model_id),
                       const struct results *results, double scale, const char *unit)
{
    bool first = true;
    for (int m = 0; m < MODEL_COUNT; m++) {
        double least, most;
        if (!range_of(value, results, (enum model_id)m, &least, &most))
            continue;
        text_add(out, "%s%s ", first ? "" : "; ", model_rows[m].label);
        words_range(out, least * scale, most * scale, 3);
        text_add(out, "%s", unit);
        first = false;
    }
}

static double area_slope(const struct surface_summary *summary, enum model_id model)
{
    return summary->models[model].area_slope;
}

static enum claim_verdict check_linear(struct text *out, const struct results *results, const struct study *study)
{
    (void)study;
    size_t all = 0, linear = 0;
    text_add(out, "d ln A/d ln P below A/Aₙ = 0.1: ");
    add_ranges(out, area_slope, results, 1, "");
    for (int m = 0; m < MODEL_COUNT; m++)
        for (size_t k = 0; k < results->usable_count; k++) {
            double slope = usable(results, k)->models[m].exists ? usable(results, k)->models[m].area_slope : NAN;
            all += isfinite(slope);
            linear += fabs(slope - 1) <= 0.1;
        }
    text_add(out, ". %zu of %zu curves lie within 0.1 of 1", linear, all);
    return all == 0 ? CLAIM_NOT_TESTED : verdict_of((double)linear / (double)all);
}

static enum claim_verdict check_plastic_above(struct text *out, const struct results *results,
                                              const struct study *study)
{
    static const char *const names[2] = {"multiscale", "statistical"};
    size_t points = 0, above = 0;
    for (int f = 0; f < 2; f++) {
        const struct study_plastic *plastic = &study->plastic[f];
        if (plastic->points == 0)
            continue;
        text_add(out, "%s%s: plastic/elastic area ", points > 0 ? "; " : "", names[f]);
        words_range(out, plastic->least, plastic->most, 3);
        text_add(out, ", not below at %zu of %zu loads", plastic->above, plastic->points);
        points += plastic->points;
        above += plastic->above;
    }
    (void)results;
    return points == 0 ? CLAIM_NOT_TESTED : verdict_of((double)above / (double)points);
}

static enum claim_verdict check_sooner(struct text *out, const struct results *results, const struct study *study)
{
    size_t surfaces = study->plastic[0].surfaces + study->plastic[1].surfaces;
    size_t sooner = study->plastic[0].sooner + study->plastic[1].sooner;
    (void)results;
    text_add(out, "in %zu of %zu pairs of models the plastic one reaches A = Aₙ at the lower load", sooner, surfaces);
    return surfaces == 0 ? CLAIM_NOT_TESTED : verdict_of((double)sooner / (double)surfaces);
}

/** Shares of ranked comparisons, a model each; `offset` picks the counter of struct study_rank. */
static enum claim_verdict check_rank(struct text *out, const struct study *study, size_t offset)
{
    size_t pairs = 0, ranked = 0;
    text_add(out, "neighbours in roughness, load by load, in this order: ");
    for (int m = 0; m < MODEL_COUNT; m++) {
        const struct study_rank *rank = &study->rank[m];
        if (rank->pairs == 0)
            continue;
        size_t count = *(const size_t *)((const char *)rank + offset);
        text_add(out, "%s%s %.0f %%", pairs > 0 ? "; " : "", model_rows[m].label,
                 100 * (double)count / (double)rank->pairs);
        pairs += rank->pairs;
        ranked += count;
    }
    return pairs == 0 ? CLAIM_NOT_TESTED : verdict_of((double)ranked / (double)pairs);
}

static enum claim_verdict check_area_rank(struct text *out, const struct results *results, const struct study *study)
{
    (void)results;
    return check_rank(out, study, offsetof(struct study_rank, area));
}

static enum claim_verdict check_ecr_rank(struct text *out, const struct results *results, const struct study *study)
{
    (void)results;
    return check_rank(out, study, offsetof(struct study_rank, ecr));
}

/** The thesis finds no order here, so the claim holds when the ranks are mixed. */
static enum claim_verdict check_separation_rank(struct text *out, const struct results *results,
                                                const struct study *study)
{
    (void)results;
    enum claim_verdict ordered = check_rank(out, study, offsetof(struct study_rank, separation));
    return ordered == CLAIM_NOT_TESTED ? ordered : ordered == CLAIM_HOLDS ? CLAIM_FAILS : CLAIM_HOLDS;
}

static enum claim_verdict check_spread(struct text *out, const struct results *results, const struct study *study)
{
    size_t tested = 0, narrower = 0;
    (void)results;
    text_add(out, "largest/smallest area of the surfaces at P/(Aₙ E′) = ");
    words_number(out, study->middle_load, 2);
    for (int f = 0; f < 2; f++) {
        double elastic = study->area_spread[f == 0 ? MODEL_MULTISCALE_ELASTIC : MODEL_GW];
        double plastic = study->area_spread[f == 0 ? MODEL_MULTISCALE_PLASTIC : MODEL_JG];
        if (isnan(elastic) || isnan(plastic))
            continue;
        text_add(out, "%s%s elastic ", tested == 0 ? ": " : "; ", f == 0 ? "multiscale" : "statistical");
        words_number(out, elastic, 3);
        text_add(out, ", plastic ");
        words_number(out, plastic, 3);
        tested++;
        narrower += plastic < elastic;
    }
    return tested == 0 ? CLAIM_NOT_TESTED : verdict_of((double)narrower / (double)tested);
}

static double gap_at_full(const struct surface_summary *summary, enum model_id model)
{
    return summary->models[model].gap_at_full;
}

static enum claim_verdict check_closed(struct text *out, const struct results *results, const struct study *study)
{
    (void)study;
    size_t curves = 0, closed = 0;
    text_add(out, "separation/σ left where A = Aₙ: ");
    add_ranges(out, gap_at_full, results, 1, "");
    for (int m = 0; m < MODEL_COUNT; m++)
        for (size_t k = 0; k < results->usable_count; k++) {
            double gap = usable(results, k)->models[m].exists ? usable(results, k)->models[m].gap_at_full : NAN;
            curves += isfinite(gap);
            closed += gap < 0.01;
        }
    if (curves == 0) {
        text_add(out, "no curve reaches it within the loads");
        return CLAIM_NOT_TESTED;
    }
    return verdict_of((double)closed / (double)curves);
}

static double elbow(const struct surface_summary *summary, enum model_id model)
{
    return summary->models[model].elbow_load / summary->models[model].full_load;
}

static enum claim_verdict check_elbow(struct text *out, const struct results *results, const struct study *study)
{
    (void)study;
    size_t curves = 0, late = 0;
    text_add(out, "ECR first falls faster than P⁻² at this share of the load to full contact: ");
    add_ranges(out, elbow, results, 1, "");
    for (int m = 0; m < MODEL_COUNT; m++)
        for (size_t k = 0; k < results->usable_count; k++) {
            double share = usable(results, k)->models[m].exists ? elbow(usable(results, k), (enum model_id)m) : NAN;
            curves += isfinite(share);
            late += share > 0.1;
        }
    if (curves == 0) {
        text_add(out, "nowhere within the loads");
        return CLAIM_NOT_TESTED;
    }
    return verdict_of((double)late / (double)curves);
}

static enum claim_verdict check_families(struct text *out, const struct results *results, const struct study *study)
{
    if (isnan(study->area_gap))
        return CLAIM_NOT_TESTED;
    text_add(out, "surface ");
    words_surface(out, results, results->baseline);
    text_add(out, ", multiscale against statistical, mean distance: area ");
    words_number(out, study->area_gap, 2);
    text_add(out, " decades, ECR ");
    words_number(out, study->ecr_gap, 2);
    text_add(out, " decades");
    return study->ecr_gap <= study->area_gap ? CLAIM_HOLDS : CLAIM_FAILS;
}

static enum claim_verdict check_proportional(struct text *out, const struct results *results, const struct study *study)
{
    (void)results;
    if (isnan(study->proportional_error))
        return CLAIM_NOT_TESTED;
    text_add(out, "TCR/ECR is 1/(ρ k) at every load; largest relative deviation ");
    words_number(out, study->proportional_error, 2);
    return study->proportional_error < 1e-6 ? CLAIM_HOLDS : CLAIM_FAILS;
}

static double sd_least(const struct surface_summary *summary, enum model_id model)
{
    return summary->models[model].sd_least;
}

static double sd_most(const struct surface_summary *summary, enum model_id model)
{
    return summary->models[model].sd_most;
}

static enum claim_verdict check_scale_dependence(struct text *out, const struct results *results,
                                                 const struct study *study)
{
    (void)study;
    double largest = 0;
    bool first = true;
    text_add(out, "TCR rises by: ");
    for (int m = 0; m < MODEL_COUNT; m++) {
        double least, most, unused;
        if (!range_of(sd_least, results, (enum model_id)m, &least, &unused) ||
            !range_of(sd_most, results, (enum model_id)m, &unused, &most))
            continue;
        text_add(out, "%s%s ", first ? "" : "; ", model_rows[m].label);
        words_range(out, 100 * least, 100 * most, 2);
        text_add(out, " %%");
        largest = fmax(largest, most);
        first = false;
    }
    return first ? CLAIM_NOT_TESTED : largest < 0.05 ? CLAIM_HOLDS : CLAIM_FAILS;
}

static enum claim_verdict check_gamma(struct text *out, const struct results *results, const struct study *study)
{
    (void)study;
    size_t fitted = 0, converging = 0;
    double most_fall = 0;
    for (size_t k = 0; k < results->usable_count; k++) {
        const struct surface_summary *summary = usable(results, k);
        if (isnan(summary->law.gamma))
            continue;
        fitted++;
        converging += summary->law.gamma >= 1;
        for (int m = 0; m < MODEL_COUNT; m++) {
            const struct convergence_extension *extension = &summary->models[m].extension;
            if (extension->area_measured > 0)
                most_fall = fmax(most_fall, 1 - extension->area_extended / extension->area_measured);
        }
    }
    text_add(out, "γ ≥ 1 for %zu of %zu surfaces", converging, fitted);
    if (plan_runs(results->plan, EFFECT_CONVERGENCE)) {
        text_add(out, "; carried on to %.1f nm the area would fall by at most ", convergence_atom_m * 1e9);
        words_number(out, 100 * most_fall, 2);
        text_add(out, " %% (at P/(Aₙ E′) = ");
        words_number(out, results->scene->convergence.load, 2);
        text_add(out, ")");
    }
    return fitted == 0 ? CLAIM_NOT_TESTED : verdict_of((double)converging / (double)fitted);
}

static double beta_of(const struct surface_summary *summary, enum model_id model)
{
    return summary->models[model].beta;
}

static enum claim_verdict check_beta(struct text *out, const struct results *results, const struct study *study)
{
    (void)study;
    size_t values = 0, inside = 0, negative = 0;
    text_add(out, "β ");
    add_ranges(out, beta_of, results, 1, "");
    for (int m = 0; m < MODEL_COUNT; m++)
        for (size_t k = 0; k < results->usable_count; k++) {
            double beta = usable(results, k)->models[m].exists ? usable(results, k)->models[m].beta : NAN;
            values += isfinite(beta);
            inside += beta >= 4 && beta <= 12;
            negative += beta < 0;
        }
    text_add(out, "; %zu of %zu lie in 4…12", inside, values);
    if (negative > 0)
        text_add(out,
                 ", %zu below 0: there the asperities fill the nominal area before the flat reaches the mean plane",
                 negative);
    return values == 0 ? CLAIM_NOT_TESTED : verdict_of((double)inside / (double)values);
}

/** Is gamma lower for the rougher of two neighbours? */
static enum claim_verdict check_gamma_rank(struct text *out, const struct results *results, const struct study *study)
{
    (void)study;
    size_t pairs = 0, falling = 0;
    for (size_t k = 1; k < results->usable_count; k++) {
        double smooth = usable(results, k - 1)->law.gamma, rough = usable(results, k)->law.gamma;
        pairs += isfinite(smooth) && isfinite(rough);
        falling += smooth > rough;
    }
    text_add(out, "γ falls from the smoother to the rougher neighbour in %zu of %zu pairs", falling, pairs);
    return pairs == 0 ? CLAIM_NOT_TESTED : verdict_of((double)falling / (double)pairs);
}

enum {
    PLASTIC = EFFECT_BIT(EFFECT_PLASTICITY),
    SEPARATION = EFFECT_BIT(EFFECT_SEPARATION),
    ELECTRICAL = EFFECT_BIT(EFFECT_ELECTRICAL),
    THERMAL = EFFECT_BIT(EFFECT_THERMAL),
    BOTH_FAMILIES = SCENE_MODEL_MULTISCALE | SCENE_MODEL_STATISTICAL,
};

const struct claim_row claim_rows[] = {
    {"6.2", "The area converges because γ ≥ 1", 0, SCENE_MODEL_MULTISCALE, false, check_gamma},
    {"6.3.1", "The area is linear in the load", 0, 0, false, check_linear},
    {"6.3.1", "Plastic area is above elastic area", PLASTIC, 0, false, check_plastic_above},
    {"6.3.2", "No separation is left at full contact", SEPARATION, 0, false, check_closed},
    {"6.3.3", "ECR falls steeply only as contact completes: the elbow", ELECTRICAL, 0, false, check_elbow},
    {"6.3.3", "The two families agree better in ECR than in area", ELECTRICAL, BOTH_FAMILIES, false, check_families},
    {"6.3.4", "TCR is ECR in other units", ELECTRICAL | THERMAL, 0, false, check_proportional},
    {"6.3.4", "Scale dependence is negligible (below 5 %)", EFFECT_BIT(EFFECT_SCALE_DEPENDENT), 0, false,
     check_scale_dependence},
    {"6.4", "γ falls as roughness rises", 0, 0, true, check_gamma_rank},
    {"6.4.1", "Smoother surfaces have the larger area", 0, 0, true, check_area_rank},
    {"6.4.1", "Plasticity narrows the spread between surfaces", PLASTIC, 0, true, check_spread},
    {"6.4.1", "Plastic models reach full contact at lower loads", PLASTIC, 0, false, check_sooner},
    {"6.4.2", "Separation/σ is not ranked by roughness", SEPARATION, 0, true, check_separation_rank},
    {"6.4.2", "β lies between 4 and 12", SEPARATION, SCENE_MODEL_STATISTICAL, false, check_beta},
    {"6.4.3", "Smoother surfaces have the smaller ECR", ELECTRICAL, 0, true, check_ecr_rank},
};
const size_t claim_count = sizeof claim_rows / sizeof claim_rows[0];

void claim_table(struct text *out, const struct results *results, const struct study *study)
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
}
