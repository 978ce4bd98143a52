#include "report/claim_check.h"

#include "base/number_format.h"
#include <math.h>

/** Range of a number over all surfaces in one model; false when no surface has it. */
static bool range_of(double (*value)(const struct surface_summary *, enum model_id), const struct results *results,
                     enum model_id model, double *least, double *most)
{
    *least = INFINITY;
    *most = -INFINITY;
    for (size_t k = 0; k < results->usable_count; k++) {
        const struct surface_summary *summary = claim_surface(results, k);
        double number = summary->models[model].exists ? value(summary, model) : NAN;
        if (isfinite(number)) {
            *least = fmin(*least, number);
            *most = fmax(*most, number);
        }
    }
    return *least <= *most;
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
        number_format_range(out, least * scale, most * scale, 3);
        text_add(out, "%s", unit);
        first = false;
    }
}

static double area_slope(const struct surface_summary *summary, enum model_id model)
{
    return summary->models[model].area_slope;
}

enum claim_verdict claim_linear(struct text *out, const struct results *results, const struct comparison *study)
{
    (void)study;
    size_t all = 0, linear = 0;
    text_add(out, "d ln A/d ln P below A/Aₙ = 0.1: ");
    add_ranges(out, area_slope, results, 1, "");
    for (int m = 0; m < MODEL_COUNT; m++)
        for (size_t k = 0; k < results->usable_count; k++) {
            double slope =
                claim_surface(results, k)->models[m].exists ? claim_surface(results, k)->models[m].area_slope : NAN;
            all += isfinite(slope);
            linear += fabs(slope - 1) <= 0.1;
        }
    if (all > 0)
        text_add(out, ". %zu of %zu curves lie within 0.1 of 1", linear, all);
    else
        text_add(out, "fewer than 5 loads");
    return all == 0 ? CLAIM_NOT_TESTED : claim_verdict_of(linear, all);
}

enum claim_verdict claim_plastic_above(struct text *out, const struct results *results, const struct comparison *study)
{
    static const char *const names[2] = {"multiscale", "statistical"};
    size_t points = 0, above = 0;
    for (int f = 0; f < 2; f++) {
        const struct comparison_plastic *plastic = &study->plastic[f];
        if (plastic->points == 0)
            continue;
        text_add(out, "%s%s: plastic/elastic area ", points > 0 ? "; " : "", names[f]);
        number_format_range(out, plastic->least, plastic->most, 3);
        text_add(out, ", not below at %zu of %zu loads", plastic->above, plastic->points);
        points += plastic->points;
        above += plastic->above;
    }
    (void)results;
    return points == 0 ? CLAIM_NOT_TESTED : claim_verdict_of(above, points);
}

enum claim_verdict claim_sooner(struct text *out, const struct results *results, const struct comparison *study)
{
    size_t surfaces = study->plastic[0].surfaces + study->plastic[1].surfaces;
    size_t sooner = study->plastic[0].sooner + study->plastic[1].sooner;
    (void)results;
    text_add(out, "in %zu of %zu pairs of models the plastic one reaches A = Aₙ at the lower load", sooner, surfaces);
    return surfaces == 0 ? CLAIM_NOT_TESTED : claim_verdict_of(sooner, surfaces);
}

static double gap_at_full(const struct surface_summary *summary, enum model_id model)
{
    return summary->models[model].gap_at_full;
}

/** The statistical separations are 0 there by the choice of β and prove nothing. */
enum claim_verdict claim_closed(struct text *out, const struct results *results, const struct comparison *study)
{
    (void)study;
    size_t curves = 0, closed = 0;
    bool first = true;
    text_add(out, "separation/σ left where A = Aₙ: ");
    for (int m = MODEL_MULTISCALE_ELASTIC; m <= MODEL_MULTISCALE_PLASTIC; m++) {
        double least, most;
        if (!range_of(gap_at_full, results, (enum model_id)m, &least, &most))
            continue;
        text_add(out, "%s%s ", first ? "" : "; ", model_rows[m].label);
        number_format_range(out, least, most, 2);
        first = false;
        for (size_t k = 0; k < results->usable_count; k++) {
            const struct curve_summary *model = &claim_surface(results, k)->models[m];
            curves += model->exists && isfinite(model->gap_at_full);
            closed += model->exists && model->gap_at_full < 0.01;
        }
    }
    if (curves == 0) {
        text_add(out, "no multiscale curve reaches it within the loads");
        return CLAIM_NOT_TESTED;
    }
    text_add(out, "; below 0.01 in %zu of %zu curves%s", closed, curves,
             closed < curves ? " (the published elastic-plastic area is full before the last gap closes)" : "");
    if (results->plan->families & SCENE_MODEL_STATISTICAL)
        text_add(out, "; the adjusted statistical ones are 0 by the choice of β");
    return claim_verdict_of(closed, curves);
}

static double elbow(const struct surface_summary *summary, enum model_id model)
{
    return summary->models[model].elbow_load / summary->models[model].full_load;
}

/** Curves that reach full contact within the loads, or have an elbow before. */
enum claim_verdict claim_elbow(struct text *out, const struct results *results, const struct comparison *study)
{
    (void)study;
    size_t curves = 0, late = 0;
    text_add(out, "ECR begins to fall faster than P⁻² at this percentage of the load to full contact: ");
    add_ranges(out, elbow, results, 100, "");
    for (int m = 0; m < MODEL_COUNT; m++)
        for (size_t k = 0; k < results->usable_count; k++) {
            const struct surface_summary *summary = claim_surface(results, k);
            const struct curve_summary *model = &summary->models[m];
            if (!model->exists)
                continue;
            double share = elbow(summary, (enum model_id)m);
            curves += isfinite(share) || model->full_load <= results->loads[results->load_count - 1];
            late += share > 0.1;
        }
    if (curves == 0) {
        text_add(out, "none does within the loads");
        return CLAIM_NOT_TESTED;
    }
    text_add(out, "; in the last decade before it in %zu of %zu curves", late, curves);
    return claim_verdict_of(late, curves);
}

enum claim_verdict claim_families(struct text *out, const struct results *results, const struct comparison *study)
{
    static const char *const laws[2] = {"elastic", "plastic"};
    size_t tested = 0, better = 0;
    for (int law = 0; law < 2; law++) {
        const struct comparison_gap *gap = &study->gap[law];
        if (isnan(gap->area))
            continue;
        if (tested == 0) {
            section_named(out, "surface ", results, results->baseline);
            text_add(out, ", mean distance of the multiscale and the statistical curve: ");
        }
        text_add(out, "%s%s: ", tested > 0 ? "; " : "", laws[law]);
        number_format_add(out, "ECR ", gap->ecr, 2, ", area ");
        number_format_add(out, "", gap->area, 2, " decades");
        better += gap->ecr <= gap->area;
        tested++;
    }
    return claim_verdict_of(better, tested);
}

enum claim_verdict claim_proportional(struct text *out, const struct results *results, const struct comparison *study)
{
    (void)results;
    if (isnan(study->proportional_error))
        return CLAIM_NOT_TESTED;
    text_add(out, "TCR/ECR is 1/(ρ k) at every load, to a relative ");
    number_format_number(out, study->proportional_error, 2);
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

enum claim_verdict claim_scale_dependence(struct text *out, const struct results *results,
                                          const struct comparison *study)
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
        number_format_range(out, 100 * least, 100 * most, 2);
        text_add(out, " %%");
        largest = fmax(largest, most);
        first = false;
    }
    return first ? CLAIM_NOT_TESTED : largest < 0.05 ? CLAIM_HOLDS : CLAIM_FAILS;
}

/** Largest share of the area that scales below the sampling limit would still take. */
static double largest_fall(const struct results *results)
{
    double fall = 0;
    for (size_t k = 0; k < results->usable_count; k++)
        for (int m = 0; m < MODEL_COUNT; m++) {
            const struct convergence_extension *extension = &claim_surface(results, k)->models[m].extension;
            if (extension->area_measured > 0)
                fall = fmax(fall, 1 - extension->area_extended / extension->area_measured);
        }
    return fall;
}

/** gamma counts as 1 within its standard error: the thesis's roughest surface lies just there. Where two slopes fit
 * better than one law, it is the one at short wavelengths that decides. */
enum claim_verdict claim_gamma(struct text *out, const struct results *results, const struct comparison *study)
{
    (void)study;
    size_t fitted = 0, converging = 0, knees = 0;
    for (size_t k = 0; k < results->usable_count; k++) {
        const struct power_law *law = &claim_surface(results, k)->power_law;
        bool knee = isfinite(law->knee_m);
        fitted += isfinite(law->gamma);
        knees += knee;
        converging += (knee ? law->gamma_below : law->gamma) + law->gamma_error >= 1;
    }
    text_add(out, "γ ≥ 1, within its standard error, for %zu of %zu surface%s", converging, fitted,
             fitted == 1 ? "" : "s");
    if (knees > 0)
        text_add(out,
                 " (judged on %zu of them by the slope at short wavelengths, since two slopes fit better than one law)",
                 knees);
    if (plan_runs(results->plan, EFFECT_CONVERGENCE)) {
        number_format_add(out, "; scales of the one law from the sampling limit down to ", convergence_atom_m * 1e9, 1,
                          " nm would take ");
        double fall = 100 * largest_fall(results);
        if (fall > 0)
            number_format_add(out, "at most ", fall, 2, " % of the area");
        else
            text_add(out, "nothing of the area");
        text_add(out, " at P/(Aₙ E′) = ");
        number_format_power(out, results->scene->convergence.load, 3);
    }
    return claim_verdict_of(converging, fitted);
}

enum claim_verdict claim_convergence(struct text *out, const struct results *results, const struct comparison *study)
{
    (void)study;
    size_t all = 0, expected = 0;
    for (int plastic = 0; plastic <= (int)plan_runs(results->plan, EFFECT_PLASTICITY); plastic++) {
        size_t settled[CONVERGENCE_SWEEP_COUNT] = {0}, below = 0, settled_below = 0;
        for (int s = 0; s < CONVERGENCE_SWEEP_COUNT; s++)
            for (size_t v = 0; v < convergence_sweeps[s].count; v++) {
                bool settles = comparison_converges(results, (enum convergence_sweep)s, plastic, v);
                bool should = s == CONVERGENCE_ALPHA || convergence_sweeps[s].values[v] >= 1;
                all++;
                expected += settles == should;
                settled[s] += settles && should;
                below += !should;
                settled_below += settles && !should;
            }
        text_add(out, "%s%s: settled for %zu of %zu α, %zu of %zu γ ≥ 1 and %zu of %zu γ < 1", plastic ? "; " : "",
                 plastic ? "elastic-plastic" : "elastic", settled[CONVERGENCE_ALPHA],
                 convergence_sweeps[CONVERGENCE_ALPHA].count, settled[CONVERGENCE_GAMMA],
                 convergence_sweeps[CONVERGENCE_GAMMA].count - below, settled_below, below);
    }
    return claim_verdict_of(expected, all);
}

static double beta_of(const struct surface_summary *summary, enum model_id model)
{
    return summary->models[model].beta;
}

enum claim_verdict claim_beta(struct text *out, const struct results *results, const struct comparison *study)
{
    (void)study;
    size_t values = 0, inside = 0, negative = 0;
    text_add(out, "β ");
    add_ranges(out, beta_of, results, 1, "");
    for (int m = 0; m < MODEL_COUNT; m++)
        for (size_t k = 0; k < results->usable_count; k++) {
            double beta = claim_surface(results, k)->models[m].exists ? claim_surface(results, k)->models[m].beta : NAN;
            values += isfinite(beta);
            inside += beta >= 4 && beta <= 12;
            negative += beta < 0;
        }
    text_add(out, "; %zu of %zu lie in 4…12", inside, values);
    if (negative > 0)
        text_add(out,
                 ", %zu below 0: there the asperities fill the nominal area before the flat reaches the mean plane",
                 negative);
    return values == 0 ? CLAIM_NOT_TESTED : claim_verdict_of(inside, values);
}
