/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The findings of the thesis's chapter 6, each checked on these surfaces. A further check is one function and one row.
 */
#include "report/section.h"

#include <math.h>

enum verdict { VERDICT_HOLDS, VERDICT_PARTLY, VERDICT_FAILS, VERDICT_NOT_TESTED };

/** Of `good` of `all` cases; ties are in neither. */
static enum verdict verdict_of(size_t good, size_t all)
{
    return all == 0          ? VERDICT_NOT_TESTED
           : good == all     ? VERDICT_HOLDS
           : 2 * good >= all ? VERDICT_PARTLY
                             : VERDICT_FAILS;
}

static enum verdict verdict_of_tally(const struct comparison_tally *tally)
{
    return verdict_of(tally->agreeing, tally->agreeing + tally->opposed);
}

/** The findings are the thesis's, and speak of its models. */
static bool speaks(const struct section_context *context, size_t m)
{
    return model_rows[m]->in_findings && plan_runs_model(context->results->plan, m);
}

/** What is known of model `m` on the k-th smoothest surface; NULL: nothing, or it has no part in them. */
static const struct curve_summary *curve_of(const struct section_context *context, size_t k, size_t m)
{
    const struct curve_summary *curve = surface_model(section_smoothest(context, k), m);
    return speaks(context, m) && curve->exists ? curve : NULL;
}

/** Before the next of several pieces of evidence. */
static const char *joint(bool first)
{
    return first ? "" : "; ";
}

static void add_tally(struct comparison_tally *sum, const struct comparison_tally *more)
{
    sum->agreeing += more->agreeing;
    sum->opposed += more->opposed;
    sum->ties += more->ties;
}

/** "at 100 of 120 loads, alike at 3". */
static void tell_tally(struct text *out, const struct comparison_tally *tally, const char *cases)
{
    text_add(out, "%zu of %zu %s", tally->agreeing, tally->agreeing + tally->opposed, cases);
    if (tally->ties > 0)
        text_add(out, ", alike in %zu more", tally->ties);
}

/** Evidence of one range a model, "label least to most" joined by semicolons. */
static void add_ranges(struct text *out, const struct section_context *context,
                       double (*number)(const struct curve_summary *), double scale)
{
    bool first = true;
    for (size_t m = 0; m < model_count; m++) {
        double least, most;
        if (!speaks(context, m) || !section_range(&least, &most, context, m, number))
            continue;
        text_add(out, "%s%s ", joint(first), model_rows[m]->label);
        number_format_range(out, least * scale, most * scale, 3);
        first = false;
    }
}

static double area_slope(const struct curve_summary *summary)
{
    return summary->area_slope;
}

static double gap_at_full(const struct curve_summary *summary)
{
    return summary->gap_at_full;
}

static double sd_least(const struct curve_summary *summary)
{
    return summary->sd_least;
}

static double sd_most(const struct curve_summary *summary)
{
    return summary->sd_most;
}

static double beta_of(const struct curve_summary *summary)
{
    return summary->beta;
}

static enum verdict check_linear(struct text *out, const struct section_context *context)
{
    size_t all = 0, linear = 0;
    text_add(out, "d ln A/d ln P below A/Aₙ = 0.1: ");
    add_ranges(out, context, area_slope, 1);
    for (size_t m = 0; m < model_count; m++)
        for (size_t k = 0; k < context->results->usable_count; k++) {
            const struct curve_summary *curve = curve_of(context, k, m);
            all += curve && isfinite(curve->area_slope);
            linear += curve && fabs(curve->area_slope - 1) <= 0.1;
        }
    if (all > 0)
        text_add(out, ". %zu of %zu curves lie within 0.1 of 1", linear, all);
    else
        text_add(out, "no curve has 5 loads there");
    return verdict_of(linear, all);
}

/** What yielding does to a quantity, a pair of models each. */
static enum verdict check_yield(struct text *out, const struct section_context *context, enum quantity quantity)
{
    struct comparison_tally sum = {0};
    bool first = true;
    for (size_t m = 0; m < model_count; m++) {
        const struct comparison_plastic *plastic = &context->comparison->models[m].plastic;
        const struct comparison_tally *tally = &plastic->changes[quantity];
        if (!speaks(context, m) || tally->agreeing + tally->opposed + tally->ties == 0)
            continue;
        text_add(out, "%s%s: ", joint(first), model_rows[m]->family);
        if (quantity == QUANTITY_AREA) {
            text_add(out, "plastic/elastic area ");
            number_format_range(out, plastic->least, plastic->most, 3);
            text_add(out, ", ");
        }
        tell_tally(out, tally, "loads");
        add_tally(&sum, tally);
        first = false;
    }
    if (first)
        text_add(out, "no load of partial contact in both models of a pair");
    return verdict_of_tally(&sum);
}

static enum verdict check_plastic_above(struct text *out, const struct section_context *context)
{
    return check_yield(out, context, QUANTITY_AREA);
}

static enum verdict check_plastic_gap(struct text *out, const struct section_context *context)
{
    return check_yield(out, context, QUANTITY_SEPARATION);
}

static enum verdict check_plastic_ecr(struct text *out, const struct section_context *context)
{
    return check_yield(out, context, QUANTITY_ECR);
}

static enum verdict check_sooner(struct text *out, const struct section_context *context)
{
    struct comparison_tally sum = {0};
    for (size_t m = 0; m < model_count; m++)
        if (speaks(context, m))
            add_tally(&sum, &context->comparison->models[m].plastic.sooner);
    text_add(out, "the plastic model reaches A = Aₙ at the lower load in ");
    tell_tally(out, &sum, "pairs");
    return verdict_of_tally(&sum);
}

/** The statistical separations are 0 there by the choice of β and prove nothing. */
static enum verdict check_closed(struct text *out, const struct section_context *context)
{
    size_t curves = 0, closed = 0;
    bool first = true;
    text_add(out, "separation/σ left where A = Aₙ: ");
    for (size_t m = 0; m < model_count; m++) {
        double least, most;
        if (!speaks(context, m) || !model_rows[m]->stacks_scales ||
            !section_range(&least, &most, context, m, gap_at_full))
            continue;
        text_add(out, "%s%s ", joint(first), model_rows[m]->label);
        number_format_range(out, least, most, 2);
        first = false;
        for (size_t k = 0; k < context->results->usable_count; k++) {
            const struct curve_summary *curve = curve_of(context, k, m);
            curves += curve && isfinite(curve->gap_at_full);
            closed += curve && curve->gap_at_full < 0.01;
        }
    }
    if (curves == 0) {
        text_add(out, "no multiscale curve reaches it within the loads");
        return VERDICT_NOT_TESTED;
    }
    text_add(out, "; below 0.01 in %zu of %zu curves%s", closed, curves,
             closed < curves ? " (the published elastic-plastic area is full before the last gap closes)" : "");
    if (section_computes(context, QUANTITY_ADJUSTED))
        text_add(out, "; the adjusted statistical ones are 0 by the choice of β");
    return verdict_of(closed, curves);
}

/** Curves that have an elbow within the loads, or go through partial to full contact without one. */
static enum verdict check_elbow(struct text *out, const struct section_context *context)
{
    const struct results *results = context->results;
    size_t curves = 0, late = 0;
    text_add(out, "ECR begins to fall faster than P⁻² at this percentage of the load to full contact: ");
    add_ranges(out, context, curve_summary_elbow_share, 100);
    for (size_t m = 0; m < model_count; m++)
        for (size_t k = 0; k < results->usable_count; k++) {
            const struct curve_summary *curve = curve_of(context, k, m);
            const double *loads = results_loads(results, results->by_roughness[k]);
            if (!curve || curve->elbow_load <= curve->first_load) /* it may lie anywhere below */
                continue;
            curves += isfinite(curve_summary_elbow_share(curve)) ||
                      (curve->full_load > loads[0] && curve->full_load <= loads[results->load_count - 1]);
            late += curve_summary_elbow_share(curve) > 0.1;
        }
    if (curves == 0) {
        text_add(out, "none begins to within the loads");
        return VERDICT_NOT_TESTED;
    }
    text_add(out, "; in the last decade before it in %zu of %zu curves", late, curves);
    return verdict_of(late, curves);
}

/** A distance between multiscale and statistical curves: of a material law, on a surface. */
typedef double family_distance(const struct comparison_gap *gap);

static double distance_in_area(const struct comparison_gap *gap)
{
    return gap->area;
}

static double distance_in_ecr(const struct comparison_gap *gap)
{
    return gap->ecr;
}

static double distance_plain(const struct comparison_gap *gap)
{
    return gap->plain;
}

static double distance_adjusted(const struct comparison_gap *gap)
{
    return gap->adjusted;
}

/** "elastic: ECR 0.12 to 0.30, area 0.4 to 0.5 decades; plastic: …" over all surfaces; on how many of them is `x` the
 * smaller? */
static enum verdict check_distances(struct text *out, const struct section_context *context, family_distance *x,
                                    const char *x_name, family_distance *y, const char *y_name, const char *unit)
{
    const struct results *results = context->results;
    struct comparison_tally tally = {0};
    bool first = true;
    text_add(out, "mean distance of the multiscale and the statistical curve: ");
    for (size_t m = 0; m < model_count; m++) {
        double least[2] = {INFINITY, INFINITY}, most[2] = {-INFINITY, -INFINITY};
        for (size_t k = 0; speaks(context, m) && k < results->usable_count; k++) {
            const struct comparison_gap *gap = &context->comparison->models[m].gaps[results->by_roughness[k]];
            double distances[2] = {x(gap), y(gap)};
            if (isnan(distances[0]) || isnan(distances[1]))
                continue;
            bool tie =
                fabs(distances[0] - distances[1]) <= results->scene->tolerance * fmax(distances[0], distances[1]);
            tally.ties += tie;
            tally.agreeing += !tie && distances[0] < distances[1];
            tally.opposed += !tie && distances[0] > distances[1];
            for (int d = 0; d < 2; d++) {
                least[d] = fmin(least[d], distances[d]);
                most[d] = fmax(most[d], distances[d]);
            }
        }
        if (!(least[0] <= most[0]))
            continue;
        text_add(out, "%s%s: %s ", joint(first), section_law(m, "plastic"), x_name);
        number_format_range(out, least[0], most[0], 2);
        text_add(out, ", %s ", y_name);
        number_format_range(out, least[1], most[1], 2);
        text_add(out, " %s", unit);
        first = false;
    }
    text_add(out, "%s", first ? "none has both" : "; so on ");
    if (!first)
        tell_tally(out, &tally, results->usable_count > 1 ? "surfaces and laws" : "laws");
    return verdict_of_tally(&tally);
}

static enum verdict check_families(struct text *out, const struct section_context *context)
{
    return check_distances(out, context, distance_in_ecr, "ECR", distance_in_area, "area", "decades");
}

static enum verdict check_adjustment(struct text *out, const struct section_context *context)
{
    return check_distances(out, context, distance_adjusted, "adjusted", distance_plain, "as it is", "σ");
}

/** "Very similar" is taken as: within half a decade, so that both round to the same order of magnitude. */
static enum verdict check_family_ecr(struct text *out, const struct section_context *context)
{
    static const double alike_decades = 0.5;
    const struct results *results = context->results;
    size_t all = 0, alike = 0;
    double farthest = 0;
    size_t farthest_at = 0;
    for (size_t m = 0; m < model_count; m++)
        for (size_t k = 0; speaks(context, m) && k < results->usable_count; k++) {
            size_t index = results->by_roughness[k];
            double decades = context->comparison->models[m].gaps[index].ecr;
            all += isfinite(decades);
            alike += decades < alike_decades;
            if (decades >= farthest) {
                farthest = decades;
                farthest_at = index;
            }
        }
    if (all == 0) {
        text_add(out, "no surface has both");
        return VERDICT_NOT_TESTED;
    }
    text_add(out,
             "the ECR curves of the two families are on average less than half a decade apart on %zu of %zu "
             "surfaces and laws; at most ",
             alike, all);
    number_format_between(out, "", farthest, 2, " decades, on ");
    section_named(out, "surface ", results, farthest_at);
    return verdict_of(alike, all);
}

static enum verdict check_proportional(struct text *out, const struct section_context *context)
{
    if (isnan(context->comparison->proportional_error)) {
        text_add(out, "no load at which both are above 0");
        return VERDICT_NOT_TESTED;
    }
    text_add(out, "TCR/ECR is 1/(ρ k) at every load, to a relative ");
    number_format(out, context->comparison->proportional_error, 2);
    return context->comparison->proportional_error < 1e-6 ? VERDICT_HOLDS : VERDICT_FAILS;
}

static enum verdict check_scale_dependence(struct text *out, const struct section_context *context)
{
    double largest = 0;
    bool first = true;
    text_add(out, "TCR rises by: ");
    for (size_t m = 0; m < model_count; m++) {
        double least, most, unused;
        if (!speaks(context, m) || !section_range(&least, &unused, context, m, sd_least) ||
            !section_range(&unused, &most, context, m, sd_most))
            continue;
        text_add(out, "%s%s ", joint(first), model_rows[m]->label);
        number_format_range(out, 100 * least, 100 * most, 2);
        text_add(out, " %%");
        largest = fmax(largest, most);
        first = false;
    }
    if (first)
        text_add(out, "no load of partial contact");
    return first ? VERDICT_NOT_TESTED : largest < 0.05 ? VERDICT_HOLDS : VERDICT_FAILS;
}

/** Largest share of the area that scales below the shortest wavelength known would still take. */
static double largest_fall(const struct section_context *context)
{
    double fall = 0;
    for (size_t k = 0; k < context->results->usable_count; k++)
        for (size_t m = 0; m < model_count; m++) {
            const struct convergence_extension *extension = &surface_model(section_smoothest(context, k), m)->extension;
            if (extension->area_measured > 0)
                fall = fmax(fall, 1 - extension->area_extended / extension->area_measured);
        }
    return fall;
}

/** Surfaces whose fitted law converges, by the one criterion of surface_diverges(). */
static enum verdict check_gamma(struct text *out, const struct section_context *context)
{
    size_t fitted = 0, diverging = 0, knees = 0;
    for (size_t k = 0; k < context->results->usable_count; k++) {
        const struct surface_summary *summary = section_smoothest(context, k);
        if (!surface_tells_gamma(summary))
            continue;
        fitted++;
        knees += isfinite(summary->power_law.knee_m);
        diverging += surface_diverges(summary);
    }
    if (fitted > 0)
        text_add(out, "γ ≥ 1, within its standard error, for %zu of %zu surface%s", fitted - diverging, fitted,
                 fitted == 1 ? "" : "s");
    else
        text_add(out, "no power law tells the slope at short wavelengths");
    if (knees > 0)
        text_add(out,
                 " (judged on %zu of them by the slope at short wavelengths, since two slopes fit better than one law)",
                 knees);
    if (section_extended(context)) {
        number_format_between(out, "; the spectra's own short ends, carried on from the shortest wavelength known to ",
                              convergence_atom_m * 1e9, 1, " nm, would take ");
        double fall = 100 * largest_fall(context);
        if (fall > 0)
            number_format_between(out, "at most ", fall, 2, " % of the area");
        else
            text_add(out, "nothing of the area");
        text_add(out, " at P/(Aₙ E′) = ");
        number_format_power(out, context->results->scene->convergence.load, 3);
    }
    return fitted == 0 ? VERDICT_NOT_TESTED : verdict_of(fitted - diverging, fitted);
}

static enum verdict check_convergence(struct text *out, const struct section_context *context)
{
    size_t all = 0, expected = 0;
    for (size_t m = 0; m < model_count; m++) {
        size_t converged[CONVERGENCE_SWEEP_COUNT] = {0}, below = 0, converged_below = 0;
        if (!speaks(context, m) || !model_rows[m]->stacks_scales)
            continue;
        for (int s = 0; s < CONVERGENCE_SWEEP_COUNT; s++)
            for (size_t v = 0; v < convergence_sweeps[s].count; v++) {
                bool converges = comparison_converges(context->results, (enum convergence_sweep)s, m, v);
                bool should = s == CONVERGENCE_ALPHA || convergence_sweeps[s].values[v] >= 1;
                expected += converges == should;
                converged[s] += converges && should;
                below += !should;
                converged_below += converges && !should;
                all++;
            }
        text_add(out, "%s%s: settled for %zu of %zu α, %zu of %zu γ ≥ 1 and %zu of %zu γ < 1",
                 all > convergence_sweeps[CONVERGENCE_ALPHA].count + convergence_sweeps[CONVERGENCE_GAMMA].count ? "; "
                                                                                                                 : "",
                 section_law(m, "elastic-plastic"), converged[CONVERGENCE_ALPHA],
                 convergence_sweeps[CONVERGENCE_ALPHA].count, converged[CONVERGENCE_GAMMA],
                 convergence_sweeps[CONVERGENCE_GAMMA].count - below, converged_below, below);
    }
    return verdict_of(expected, all);
}

static enum verdict check_beta(struct text *out, const struct section_context *context)
{
    size_t values = 0, inside = 0, negative = 0;
    text_add(out, "β ");
    add_ranges(out, context, beta_of, 1);
    for (size_t m = 0; m < model_count; m++)
        for (size_t k = 0; k < context->results->usable_count; k++) {
            double beta = curve_of(context, k, m) ? curve_of(context, k, m)->beta : NAN;
            values += isfinite(beta);
            inside += beta >= 4 && beta <= 12;
            negative += beta < 0;
        }
    text_add(out, "; %zu of %zu lie in 4…12", inside, values);
    if (negative > 0)
        text_add(out,
                 ", %zu below 0: there the asperities fill the nominal area before the flat reaches the mean plane",
                 negative);
    return verdict_of(inside, values);
}

/** The shares of comparisons in this order, a model each. */
static enum verdict check_rank(struct text *out, const struct section_context *context, enum quantity quantity)
{
    struct comparison_tally sum = {0};
    bool first = true;
    text_add(out, "of neighbours in roughness, load by load, so ordered: ");
    for (size_t m = 0; m < model_count; m++) {
        const struct comparison_tally *tally = &context->comparison->models[m].rank[quantity];
        size_t pairs = tally->agreeing + tally->opposed;
        if (!speaks(context, m) || pairs + tally->ties == 0)
            continue;
        if (pairs > 0)
            text_add(out, "%s%s %.0f %%", joint(first), model_rows[m]->label,
                     floor(100 * (double)tally->agreeing / (double)pairs));
        else
            text_add(out, "%s%s alike", joint(first), model_rows[m]->label);
        add_tally(&sum, tally);
        first = false;
    }
    if (first)
        text_add(out, "none is in partial contact");
    else if (sum.ties > 0)
        text_add(out, "; %zu are alike and speak for neither", sum.ties);
    return verdict_of_tally(&sum);
}

static enum verdict check_area_rank(struct text *out, const struct section_context *context)
{
    return check_rank(out, context, QUANTITY_AREA);
}

static enum verdict check_ecr_rank(struct text *out, const struct section_context *context)
{
    return check_rank(out, context, QUANTITY_ECR);
}

static enum verdict check_tcr_rank(struct text *out, const struct section_context *context)
{
    return check_rank(out, context, QUANTITY_TCR);
}

/** The thesis finds no order here: a model agrees when the smoother neighbour comes out on either side. */
static enum verdict check_separation_rank(struct text *out, const struct section_context *context)
{
    size_t models = 0, mixed = 0;
    (void)check_rank(out, context, QUANTITY_SEPARATION);
    for (size_t m = 0; m < model_count; m++) {
        const struct comparison_tally *tally = &context->comparison->models[m].rank[QUANTITY_SEPARATION];
        if (!speaks(context, m))
            continue;
        models += tally->agreeing + tally->opposed > 1;
        mixed += tally->agreeing > 0 && tally->opposed > 0;
    }
    text_add(out, " (0 and 100 %% would be an order)");
    return verdict_of(mixed, models);
}

/** Each model's spread between the surfaces, over the loads at which all are in partial contact in it and its partner.
 */
static enum verdict check_spread(struct text *out, const struct section_context *context)
{
    const struct results *results = context->results;
    struct comparison_tally tally = {0};
    bool first = true;
    text_add(out, "largest/smallest area of the surfaces, mean over the loads of partial contact in both models: ");
    for (size_t m = 0; m < model_count; m++) {
        size_t partner = model_index(model_rows[m]->elastic);
        if (!speaks(context, m) || partner == model_count)
            continue;
        const struct comparison_model *plastic = &context->comparison->models[m];
        const struct comparison_model *elastic = &context->comparison->models[partner];
        double wide = comparison_mean_spread(results, elastic, plastic, COMPARISON_AREAS);
        double narrow = comparison_mean_spread(results, plastic, elastic, COMPARISON_AREAS);
        if (isnan(wide) || isnan(narrow))
            continue;
        text_add(out, "%s%s elastic ", joint(first), model_rows[m]->family);
        number_format_between(out, "", pow(10, wide), 3, ", plastic ");
        number_format(out, pow(10, narrow), 3);
        bool tie = fabs(wide - narrow) <= results->scene->tolerance;
        tally.ties += tie;
        tally.agreeing += !tie && narrow < wide;
        tally.opposed += !tie && narrow > wide;
        first = false;
    }
    if (first)
        text_add(out, "there is no such load");
    return verdict_of_tally(&tally);
}

/** The same order of magnitude: within a factor of 10, load by load. */
static enum verdict check_magnitude(struct text *out, const struct section_context *context)
{
    size_t models = 0, within = 0;
    text_add(out, "largest/smallest area of the surfaces, at the load where it is largest: ");
    for (size_t m = 0; m < model_count; m++) {
        double largest =
            speaks(context, m)
                ? comparison_largest_spread(context->results, &context->comparison->models[m], COMPARISON_AREAS)
                : NAN;
        if (isnan(largest))
            continue;
        text_add(out, "%s%s ", joint(models == 0), model_rows[m]->label);
        number_format(out, largest, 3);
        models++;
        within += largest < 10;
    }
    if (models == 0)
        text_add(out, "there is no load at which all are in partial contact");
    return verdict_of(within, models);
}

/** Neighbouring resistance curves keep nearly the same distance when the widest is at most twice the narrowest. */
static enum verdict check_equal_steps(struct text *out, const struct section_context *context)
{
    static const double nearly = 2;
    size_t models = 0, equal = 0;
    text_add(out, "mean distance of neighbouring surfaces' curves (decades): ");
    for (size_t m = 0; m < model_count; m++) {
        const double *steps = context->comparison->models[m].steps;
        double least = INFINITY, most = -INFINITY;
        size_t count = 0;
        if (!speaks(context, m) || !model_rows[m]->stacks_scales)
            continue;
        for (size_t k = 0; k + 1 < context->results->usable_count; k++)
            if (isfinite(steps[k])) {
                least = fmin(least, steps[k]);
                most = fmax(most, steps[k]);
                count++;
            }
        if (count < 2)
            continue;
        text_add(out, "%s%s ", joint(models == 0), model_rows[m]->label);
        number_format_range(out, least, most, 2);
        models++;
        equal += least > 0 && most <= nearly * least;
    }
    if (models == 0)
        text_add(out, "it takes two such distances");
    return verdict_of(equal, models);
}

/** The resistances' spread between the surfaces: statistical against multiscale, of one material law. */
static enum verdict check_sensitive(struct text *out, const struct section_context *context)
{
    const struct results *results = context->results;
    struct comparison_tally tally = {0};
    bool first = true;
    text_add(out, "largest/smallest resistance of the surfaces, mean over the loads of partial contact in both: ");
    for (size_t m = 0; m < model_count; m++) {
        size_t counterpart = model_index(model_rows[m]->counterpart);
        if (!speaks(context, m) || counterpart == model_count)
            continue;
        const struct comparison_model *statistical = &context->comparison->models[m];
        const struct comparison_model *multiscale = &context->comparison->models[counterpart];
        double own = comparison_mean_spread(results, statistical, multiscale, COMPARISON_RESISTANCES);
        double other = comparison_mean_spread(results, multiscale, statistical, COMPARISON_RESISTANCES);
        if (isnan(own) || isnan(other))
            continue;
        text_add(out, "%s%s ", joint(first), model_rows[m]->label);
        number_format_between(out, "", pow(10, own), 3, ", ");
        text_add(out, "%s ", model_rows[counterpart]->label);
        number_format(out, pow(10, other), 3);
        bool tie = fabs(own - other) <= results->scene->tolerance;
        tally.ties += tie;
        tally.agreeing += !tie && own > other;
        tally.opposed += !tie && own < other;
        first = false;
    }
    if (first)
        text_add(out, "there is no such load");
    return verdict_of_tally(&tally);
}

/** Does a number that is known to +- `error` fall from the smoother to the rougher of two neighbours? What lies within
 * the two errors together is a tie. */
static void count_fall(struct comparison_tally *tally, double smooth, double smooth_error, double rough,
                       double rough_error, double tolerance)
{
    if (!isfinite(smooth) || !isfinite(rough))
        return;
    double error = hypot(isfinite(smooth_error) ? smooth_error : 0, isfinite(rough_error) ? rough_error : 0);
    bool tie = fabs(smooth - rough) <= error + tolerance * fmax(fabs(smooth), fabs(rough));
    tally->ties += tie;
    tally->agreeing += !tie && smooth > rough;
    tally->opposed += !tie && smooth < rough;
}

/** "falls … in 2 of 3 pairs, 1 differ by less than their errors". */
static void tell_falls(struct text *out, const char *symbol, const struct comparison_tally *tally)
{
    text_add(out, "%s falls from the smoother to the rougher neighbour in %zu of %zu pairs", symbol, tally->agreeing,
             tally->agreeing + tally->opposed);
    if (tally->ties > 0)
        text_add(out, ", %zu more differ by less than their standard errors", tally->ties);
}

static enum verdict check_gamma_rank(struct text *out, const struct section_context *context)
{
    struct comparison_tally tally = {0};
    for (size_t k = 1; k < context->results->usable_count; k++) {
        const struct power_law *smooth = &section_smoothest(context, k - 1)->power_law,
                               *rough = &section_smoothest(context, k)->power_law;
        if (power_law_holds(smooth) && power_law_holds(rough))
            count_fall(&tally, smooth->gamma, smooth->gamma_error, rough->gamma, rough->gamma_error, 0);
    }
    tell_falls(out, "γ", &tally);
    return verdict_of_tally(&tally);
}

/** No order is found where neighbours go both ways, an order where two or more go one way only. */
static enum verdict verdict_of_no_order(const struct comparison_tally *tally)
{
    return tally->agreeing + tally->opposed < 2        ? VERDICT_NOT_TESTED
           : tally->agreeing > 0 && tally->opposed > 0 ? VERDICT_HOLDS
                                                       : VERDICT_FAILS;
}

/** Held against each other within the scans; at 1 m, where alpha stands, the slope's error decides. */
static enum verdict check_alpha_rank(struct text *out, const struct section_context *context)
{
    const double wavelength_m = results_law_wavelength_m(context->results);
    struct comparison_tally tally = {0};
    for (size_t k = 1; k < context->results->usable_count; k++) {
        const struct power_law *smooth = &section_smoothest(context, k - 1)->power_law,
                               *rough = &section_smoothest(context, k)->power_law;
        if (power_law_holds(smooth) && power_law_holds(rough))
            count_fall(&tally, log10(power_law_amplitude(smooth, wavelength_m)),
                       power_law_error_decades(smooth, wavelength_m), log10(power_law_amplitude(rough, wavelength_m)),
                       power_law_error_decades(rough, wavelength_m), 0);
    }
    if (isfinite(wavelength_m)) {
        number_format_between(out, "at λ = ", wavelength_m * 1e6, 3, " µm ");
        tell_falls(out, "Δ", &tally);
    } else {
        text_add(out, "no power law holds");
    }
    return verdict_of_no_order(&tally);
}

static enum verdict check_beta_rank(struct text *out, const struct section_context *context)
{
    size_t models = 0, mixed = 0;
    for (size_t m = 0; m < model_count; m++) {
        struct comparison_tally tally = {0};
        for (size_t k = 1; k < context->results->usable_count; k++) {
            const struct curve_summary *smooth = curve_of(context, k - 1, m), *rough = curve_of(context, k, m);
            if (smooth && rough)
                count_fall(&tally, smooth->beta, 0, rough->beta, 0, context->results->scene->tolerance);
        }
        enum verdict verdict = verdict_of_no_order(&tally);
        if (verdict == VERDICT_NOT_TESTED)
            continue;
        text_add(out, "%s%s: ", joint(models == 0), model_rows[m]->label);
        tell_falls(out, "β", &tally);
        models++;
        mixed += verdict == VERDICT_HOLDS;
    }
    if (models == 0)
        text_add(out, "it takes two pairs of neighbours");
    return verdict_of(mixed, models);
}

/** What a check needs besides surfaces: models of the thesis that run. */
enum need { NEEDS_ANY, NEEDS_SCALES, NEEDS_ADJUSTED, NEEDS_FAMILIES };

static bool has(const struct section_context *context, enum need need)
{
    bool any = false, scales = false, asperities = false;
    for (size_t m = 0; m < model_count; m++) {
        any = any || speaks(context, m);
        scales = scales || (speaks(context, m) && model_rows[m]->stacks_scales);
        asperities = asperities || (speaks(context, m) && model_rows[m]->asperity_model);
    }
    return need == NEEDS_ANY        ? any
           : need == NEEDS_SCALES   ? scales
           : need == NEEDS_ADJUSTED ? asperities
                                    : scales && asperities;
}

enum {
    PLASTIC = EFFECT_BIT(EFFECT_PLASTICITY),
    SEPARATION = EFFECT_BIT(EFFECT_SEPARATION),
    ELECTRICAL = EFFECT_BIT(EFFECT_ELECTRICAL),
    THERMAL = EFFECT_BIT(EFFECT_THERMAL),
    SCALE_DEPENDENT = EFFECT_BIT(EFFECT_SCALE_DEPENDENT),
    CONVERGENCE = EFFECT_BIT(EFFECT_CONVERGENCE),
};

static const struct check {
    const char *part; /* of the thesis */
    const char *statement;
    unsigned effects; /* EFFECT_BITs it needs */
    enum need needs;
    size_t surfaces; /* that it takes at least */
    /** Adds the evidence, with its figures, and says how the finding fares. */
    enum verdict (*check)(struct text *evidence, const struct section_context *context);
} checks[] = {
    {"6.2", "Whether the area converges depends on γ ≥ 1, not on α", CONVERGENCE, NEEDS_SCALES, 1, check_convergence},
    {"6.2", "γ ≥ 1, so the area converges", 0, NEEDS_SCALES, 1, check_gamma},
    {"6.3.1", "The area is linear in the load", 0, NEEDS_ANY, 1, check_linear},
    {"6.3.1", "Plastic area is above elastic area", PLASTIC, NEEDS_ANY, 1, check_plastic_above},
    {"6.3.2", "No separation is left at full contact", SEPARATION, NEEDS_SCALES, 1, check_closed},
    {"6.3.2", "Plasticity lowers the gap", PLASTIC | SEPARATION, NEEDS_ANY, 1, check_plastic_gap},
    {"6.3.2", "The adjustment (4.54) brings the two families closer", SEPARATION, NEEDS_FAMILIES, 1, check_adjustment},
    {"6.3.3", "ECR falls steeply only as contact completes (the elbow)", ELECTRICAL, NEEDS_ANY, 1, check_elbow},
    {"6.3.3", "Plastic ECR is below elastic ECR", PLASTIC | ELECTRICAL, NEEDS_ANY, 1, check_plastic_ecr},
    {"6.3.3", "The two families agree better in ECR than in area", ELECTRICAL, NEEDS_FAMILIES, 1, check_families},
    {"6.3.4", "TCR is ECR in other units", ELECTRICAL | THERMAL, NEEDS_ANY, 1, check_proportional},
    {"6.3.4", "Scale dependence is negligible (below 5 %)", SCALE_DEPENDENT, NEEDS_ANY, 1, check_scale_dependence},
    {"6.4", "γ falls as roughness rises", 0, NEEDS_ANY, 2, check_gamma_rank},
    {"6.4", "The law's Δ (the thesis: α) varies independently of roughness", 0, NEEDS_ANY, 3, check_alpha_rank},
    {"6.4.1", "Smoother surfaces have the larger area", 0, NEEDS_ANY, 2, check_area_rank},
    {"6.4.1", "Areas are of the same order of magnitude", 0, NEEDS_ANY, 2, check_magnitude},
    {"6.4.1", "Plasticity narrows the spread between surfaces", PLASTIC, NEEDS_ANY, 2, check_spread},
    {"6.4.1", "Plastic models reach full contact at lower loads", PLASTIC, NEEDS_ANY, 1, check_sooner},
    {"6.4.2", "Separation/σ is not ranked by roughness", SEPARATION, NEEDS_ANY, 2, check_separation_rank},
    {"6.4.2", "β lies between 4 and 12", SEPARATION, NEEDS_ADJUSTED, 1, check_beta},
    {"6.4.2", "β does not follow roughness", SEPARATION, NEEDS_ADJUSTED, 3, check_beta_rank},
    {"6.4.3", "Smoother surfaces have the smaller ECR", ELECTRICAL, NEEDS_ANY, 2, check_ecr_rank},
    {"6.4.3", "Multiscale ECR curves lie at nearly equal distances", ELECTRICAL, NEEDS_SCALES, 3, check_equal_steps},
    {"6.4.4", "Smoother surfaces have the smaller TCR", THERMAL, NEEDS_ANY, 2, check_tcr_rank},
    {"6.4.4", "Statistical models are more sensitive to roughness", THERMAL, NEEDS_FAMILIES, 2, check_sensitive},
    {"6.4.4", "The families' resistances are similar on every surface", ELECTRICAL, NEEDS_FAMILIES, 2,
     check_family_ecr},
};

static void write(struct text *out, const struct section_context *context)
{
    static const char *const verdicts[] = {[VERDICT_HOLDS] = "holds",
                                           [VERDICT_PARTLY] = "in part",
                                           [VERDICT_FAILS] = "fails",
                                           [VERDICT_NOT_TESTED] = "not tested"};
    text_add(out, "## The findings of chapter 6, checked on these surfaces\n\n"
                  "| thesis | claim | here | evidence |\n|---|---|---|---|\n");
    for (size_t i = 0; i < sizeof checks / sizeof *checks; i++) {
        const struct check *row = &checks[i];
        if ((row->effects & ~context->results->plan->running) || !has(context, row->needs) ||
            context->results->usable_count < row->surfaces)
            continue;
        struct text evidence = {0};
        enum verdict verdict = row->check(&evidence, context);
        text_add(out, "| %s | %s | **%s** | ", row->part, row->statement, verdicts[verdict]);
        text_add_bytes(out, text_string(&evidence), evidence.length);
        text_add(out, " |\n");
        text_free(&evidence);
    }
    text_add(out, "\nOf the thesis's models. *Holds*: in every case compared; *in part*: in at least half of them; "
                  "*fails*: in fewer; *not tested*: nothing to compare. Where two numbers differ by less than the "
                  "tolerance, or than their standard errors, they speak for neither.\n");
}

static bool called_for(const struct section_context *context)
{
    return has(context, NEEDS_ANY);
}

const struct section section_checks = {"checks", called_for, write};
