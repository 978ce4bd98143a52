/* The findings of the thesis's chapter 6, each checked on these surfaces. A further check is one function and one row.
 */
#include "report/section.h"

#include <math.h>

enum verdict { VERDICT_HOLDS, VERDICT_PARTLY, VERDICT_FAILS, VERDICT_NOT_TESTED };

static enum verdict verdict_of(size_t good, size_t all)
{
    return all == 0          ? VERDICT_NOT_TESTED
           : good == all     ? VERDICT_HOLDS
           : 2 * good >= all ? VERDICT_PARTLY
                             : VERDICT_FAILS;
}

/** Evidence of one range a model, "label least to most" joined by semicolons. */
static void add_ranges(struct text *out, const struct section_context *context,
                       double (*number)(const struct curve_summary *), double scale)
{
    bool first = true;
    for (size_t m = 0; m < model_count; m++) {
        double least, most;
        if (!section_range(&least, &most, context, m, number))
            continue;
        text_add(out, "%s%s ", first ? "" : "; ", model_rows[m]->label);
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

static double elbow(const struct curve_summary *summary)
{
    return summary->elbow_load / summary->full_load;
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
            double slope = section_smoothest(context, k)->models[m].exists
                               ? section_smoothest(context, k)->models[m].area_slope
                               : NAN;
            all += isfinite(slope);
            linear += fabs(slope - 1) <= 0.1;
        }
    if (all > 0)
        text_add(out, ". %zu of %zu curves lie within 0.1 of 1", linear, all);
    else
        text_add(out, "fewer than 5 loads");
    return all == 0 ? VERDICT_NOT_TESTED : verdict_of(linear, all);
}

/** A plastic model against its elastic partner, a pair each. */
static enum verdict check_plastic_above(struct text *out, const struct section_context *context)
{
    size_t points = 0, above = 0;
    for (size_t m = 0; m < model_count; m++) {
        const struct comparison_plastic *plastic = &context->comparison->models[m].plastic;
        if (plastic->points == 0)
            continue;
        text_add(out, "%s%s: plastic/elastic area ", points > 0 ? "; " : "", model_rows[m]->family);
        number_format_range(out, plastic->least, plastic->most, 3);
        text_add(out, ", not below at %zu of %zu loads", plastic->above, plastic->points);
        points += plastic->points;
        above += plastic->above;
    }
    return points == 0 ? VERDICT_NOT_TESTED : verdict_of(above, points);
}

static enum verdict check_sooner(struct text *out, const struct section_context *context)
{
    size_t surfaces = 0, sooner = 0;
    for (size_t m = 0; m < model_count; m++) {
        surfaces += context->comparison->models[m].plastic.surfaces;
        sooner += context->comparison->models[m].plastic.sooner;
    }
    text_add(out, "in %zu of %zu pairs of models the plastic one reaches A = Aₙ at the lower load", sooner, surfaces);
    return surfaces == 0 ? VERDICT_NOT_TESTED : verdict_of(sooner, surfaces);
}

/** The statistical separations are 0 there by the choice of β and prove nothing. */
static enum verdict check_closed(struct text *out, const struct section_context *context)
{
    size_t curves = 0, closed = 0;
    bool first = true;
    text_add(out, "separation/σ left where A = Aₙ: ");
    for (size_t m = 0; m < model_count; m++) {
        double least, most;
        if (!model_rows[m]->stacks_scales || !section_range(&least, &most, context, m, gap_at_full))
            continue;
        text_add(out, "%s%s ", first ? "" : "; ", model_rows[m]->label);
        number_format_range(out, least, most, 2);
        first = false;
        for (size_t k = 0; k < context->results->usable_count; k++) {
            const struct curve_summary *model = &section_smoothest(context, k)->models[m];
            curves += model->exists && isfinite(model->gap_at_full);
            closed += model->exists && model->gap_at_full < 0.01;
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

/** Curves that reach full contact within the loads, or have an elbow before. */
static enum verdict check_elbow(struct text *out, const struct section_context *context)
{
    size_t curves = 0, late = 0;
    text_add(out, "ECR begins to fall faster than P⁻² at this percentage of the load to full contact: ");
    add_ranges(out, context, elbow, 100);
    for (size_t m = 0; m < model_count; m++)
        for (size_t k = 0; k < context->results->usable_count; k++) {
            const struct curve_summary *model = &section_smoothest(context, k)->models[m];
            if (!model->exists)
                continue;
            double share = elbow(model);
            curves += isfinite(share) || model->full_load <= context->results->loads[context->results->load_count - 1];
            late += share > 0.1;
        }
    if (curves == 0) {
        text_add(out, "none does within the loads");
        return VERDICT_NOT_TESTED;
    }
    text_add(out, "; in the last decade before it in %zu of %zu curves", late, curves);
    return verdict_of(late, curves);
}

/** Multiscale and statistical curves of one material law, on the baseline surface. */
static enum verdict check_families(struct text *out, const struct section_context *context)
{
    size_t tested = 0, better = 0;
    for (size_t m = 0; m < model_count; m++) {
        const struct comparison_gap *gap = &context->comparison->models[m].gap;
        if (isnan(gap->area))
            continue;
        if (tested == 0) {
            section_named(out, "surface ", context->results, context->results->baseline);
            text_add(out, ", mean distance of the multiscale and the statistical curve: ");
        }
        text_add(out, "%s%s: ", tested > 0 ? "; " : "", section_law(m, "plastic"));
        number_format_between(out, "ECR ", gap->ecr, 2, ", area ");
        number_format_between(out, "", gap->area, 2, " decades");
        better += gap->ecr <= gap->area;
        tested++;
    }
    return verdict_of(better, tested);
}

static enum verdict check_proportional(struct text *out, const struct section_context *context)
{
    if (isnan(context->comparison->proportional_error))
        return VERDICT_NOT_TESTED;
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
        if (!section_range(&least, &unused, context, m, sd_least) ||
            !section_range(&unused, &most, context, m, sd_most))
            continue;
        text_add(out, "%s%s ", first ? "" : "; ", model_rows[m]->label);
        number_format_range(out, 100 * least, 100 * most, 2);
        text_add(out, " %%");
        largest = fmax(largest, most);
        first = false;
    }
    return first ? VERDICT_NOT_TESTED : largest < 0.05 ? VERDICT_HOLDS : VERDICT_FAILS;
}

/** Largest share of the area that scales below the sampling limit would still take. */
static double largest_fall(const struct section_context *context)
{
    double fall = 0;
    for (size_t k = 0; k < context->results->usable_count; k++)
        for (size_t m = 0; m < model_count; m++) {
            const struct convergence_extension *extension = &section_smoothest(context, k)->models[m].extension;
            if (extension->area_measured > 0)
                fall = fmax(fall, 1 - extension->area_extended / extension->area_measured);
        }
    return fall;
}

/** gamma counts as 1 within its standard error: the thesis's roughest surface lies just there. Where two slopes fit
 * better than one law, it is the one at short wavelengths that decides. */
static enum verdict check_gamma(struct text *out, const struct section_context *context)
{
    size_t fitted = 0, converging = 0, knees = 0;
    for (size_t k = 0; k < context->results->usable_count; k++) {
        const struct power_law *law = &section_smoothest(context, k)->power_law;
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
    if (plan_runs(context->results->plan, EFFECT_CONVERGENCE)) {
        number_format_between(out, "; scales of the one law from the sampling limit down to ", convergence_atom_m * 1e9,
                              1, " nm would take ");
        double fall = 100 * largest_fall(context);
        if (fall > 0)
            number_format_between(out, "at most ", fall, 2, " % of the area");
        else
            text_add(out, "nothing of the area");
        text_add(out, " at P/(Aₙ E′) = ");
        number_format_power(out, context->results->scene->convergence.load, 3);
    }
    return verdict_of(converging, fitted);
}

static enum verdict check_convergence(struct text *out, const struct section_context *context)
{
    size_t all = 0, expected = 0;
    for (size_t m = 0; m < model_count; m++) {
        size_t converged[CONVERGENCE_SWEEP_COUNT] = {0}, below = 0, converged_below = 0;
        if (!plan_runs_model(context->results->plan, m) || !model_rows[m]->stacks_scales)
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
            double beta =
                section_smoothest(context, k)->models[m].exists ? section_smoothest(context, k)->models[m].beta : NAN;
            values += isfinite(beta);
            inside += beta >= 4 && beta <= 12;
            negative += beta < 0;
        }
    text_add(out, "; %zu of %zu lie in 4…12", inside, values);
    if (negative > 0)
        text_add(out,
                 ", %zu below 0: there the asperities fill the nominal area before the flat reaches the mean plane",
                 negative);
    return values == 0 ? VERDICT_NOT_TESTED : verdict_of(inside, values);
}

/** The shares of comparisons in this order, a model each. */
static enum verdict check_rank(struct text *out, const struct section_context *context, enum quantity quantity)
{
    size_t pairs = 0, ranked = 0;
    text_add(out, "of neighbours in roughness, load by load, so ordered: ");
    for (size_t m = 0; m < model_count; m++) {
        const struct comparison_rank *rank = &context->comparison->models[m].rank;
        if (rank->pairs == 0 || !(model_rows[m]->quantities & QUANTITY_BIT(quantity)))
            continue;
        size_t count = rank->ranked[quantity];
        text_add(out, "%s%s %.0f %%", pairs > 0 ? "; " : "", model_rows[m]->label,
                 floor(100 * (double)count / (double)rank->pairs));
        pairs += rank->pairs;
        ranked += count;
    }
    return verdict_of(ranked, pairs);
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
        const struct comparison_rank *rank = &context->comparison->models[m].rank;
        if (!(model_rows[m]->quantities & QUANTITY_BIT(QUANTITY_SEPARATION)))
            continue;
        models += rank->pairs > 0;
        mixed += rank->ranked[QUANTITY_SEPARATION] > 0 && rank->ranked[QUANTITY_SEPARATION] < rank->pairs;
    }
    text_add(out, " (0 and 100 %% would be an order)");
    return verdict_of(mixed, models);
}

static enum verdict check_spread(struct text *out, const struct section_context *context)
{
    size_t tested = 0, narrower = 0;
    text_add(out, "largest/smallest area of the surfaces at P/(Aₙ E′) = ");
    number_format_power(out, context->comparison->middle_load, 3);
    for (size_t m = 0; m < model_count; m++) {
        size_t partner = model_index(model_rows[m]->elastic);
        if (partner == model_count)
            continue;
        const struct comparison_extremes *plastic = &context->comparison->models[m].extremes[QUANTITY_AREA];
        const struct comparison_extremes *elastic = &context->comparison->models[partner].extremes[QUANTITY_AREA];
        if (elastic->count < 2 || plastic->count < elastic->count)
            continue;
        text_add(out, "%s %s elastic ", tested == 0 ? ":" : ";", model_rows[m]->family);
        number_format_between(out, "", elastic->most / elastic->least, 3, ", plastic ");
        number_format(out, plastic->most / plastic->least, 3);
        tested++;
        narrower += plastic->most * elastic->least < elastic->most * plastic->least;
    }
    if (tested == 0)
        text_add(out, ": not all surfaces are in partial contact there");
    return verdict_of(narrower, tested);
}

/** Is gamma lower for the rougher of two neighbours? */
static enum verdict check_gamma_rank(struct text *out, const struct section_context *context)
{
    size_t pairs = 0, falling = 0;
    for (size_t k = 1; k < context->results->usable_count; k++) {
        double smooth = section_smoothest(context, k - 1)->power_law.gamma,
               rough = section_smoothest(context, k)->power_law.gamma;
        pairs += isfinite(smooth) && isfinite(rough);
        falling += smooth > rough;
    }
    text_add(out, "γ falls from the smoother to the rougher neighbour in %zu of %zu pairs", falling, pairs);
    return pairs == 0 ? VERDICT_NOT_TESTED : verdict_of(falling, pairs);
}

/** What a check needs besides surfaces. */
enum need { NEEDS_NOTHING, NEEDS_SCALES, NEEDS_ADJUSTED, NEEDS_FAMILIES };

static bool has(const struct section_context *context, enum need need)
{
    bool scales = plan_stacks_scales(context->results->plan), adjusted = section_computes(context, QUANTITY_ADJUSTED);
    return need == NEEDS_NOTHING    ? true
           : need == NEEDS_SCALES   ? scales
           : need == NEEDS_ADJUSTED ? adjusted
                                    : scales && plan_uses_asperities(context->results->plan);
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
    bool several; /* needs at least two surfaces */
    /** Adds the evidence, with its figures, and says how the finding fares. */
    enum verdict (*check)(struct text *evidence, const struct section_context *context);
} checks[] = {
    {"6.2", "Whether the area converges depends on γ ≥ 1, not on α", CONVERGENCE, NEEDS_NOTHING, false,
     check_convergence},
    {"6.2", "γ ≥ 1, so the area converges", 0, NEEDS_SCALES, false, check_gamma},
    {"6.3.1", "The area is linear in the load", 0, NEEDS_NOTHING, false, check_linear},
    {"6.3.1", "Plastic area is above elastic area", PLASTIC, NEEDS_NOTHING, false, check_plastic_above},
    {"6.3.2", "No separation is left at full contact", SEPARATION, NEEDS_SCALES, false, check_closed},
    {"6.3.3", "ECR falls steeply only as contact completes (the elbow)", ELECTRICAL, NEEDS_NOTHING, false, check_elbow},
    {"6.3.3", "The two families agree better in ECR than in area", ELECTRICAL, NEEDS_FAMILIES, false, check_families},
    {"6.3.4", "TCR is ECR in other units", ELECTRICAL | THERMAL, NEEDS_NOTHING, false, check_proportional},
    {"6.3.4", "Scale dependence is negligible (below 5 %)", SCALE_DEPENDENT, NEEDS_NOTHING, false,
     check_scale_dependence},
    {"6.4", "γ falls as roughness rises", 0, NEEDS_NOTHING, true, check_gamma_rank},
    {"6.4.1", "Smoother surfaces have the larger area", 0, NEEDS_NOTHING, true, check_area_rank},
    {"6.4.1", "Plasticity narrows the spread between surfaces", PLASTIC, NEEDS_NOTHING, true, check_spread},
    {"6.4.1", "Plastic models reach full contact at lower loads", PLASTIC, NEEDS_NOTHING, false, check_sooner},
    {"6.4.2", "Separation/σ is not ranked by roughness", SEPARATION, NEEDS_NOTHING, true, check_separation_rank},
    {"6.4.2", "β lies between 4 and 12", SEPARATION, NEEDS_ADJUSTED, false, check_beta},
    {"6.4.3", "Smoother surfaces have the smaller ECR", ELECTRICAL, NEEDS_NOTHING, true, check_ecr_rank},
    {"6.4.4", "Smoother surfaces have the smaller TCR", THERMAL, NEEDS_NOTHING, true, check_tcr_rank},
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
            (row->several && context->results->usable_count < 2))
            continue;
        struct text evidence = {0};
        enum verdict verdict = row->check(&evidence, context);
        text_add(out, "| %s | %s | **%s** | ", row->part, row->statement, verdicts[verdict]);
        text_add_bytes(out, text_string(&evidence), evidence.length);
        text_add(out, " |\n");
        text_free(&evidence);
    }
    text_add(out, "\n*Holds*: in every case compared; *in part*: in at least half of them; *fails*: in fewer.\n");
}

const struct section section_checks = {"checks", NULL, write};
