/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The findings of the thesis's chapter 6, each checked on these surfaces by the thesis's models. A further one is a
 * function, a row of `checks`, and its words in templates/findings.md. */
#include "report/view.h"

#include <math.h>

/** A check at work on a model, and what it found of all: cases that bear the finding out, all cases, those that are
 * alike and speak for neither; and the range of a number of the model's. */
struct finding {
    const struct view_source *source;
    const struct check *row;
    size_t m;
    const char *label;  /* of the number: whose it is */
    double least, most; /* least > most: none */
    size_t good, all, ties;
};

/** What a check needs besides surfaces: models of the thesis that run. */
enum need { NEEDS_ANY, NEEDS_SCALES, NEEDS_ADJUSTED, NEEDS_FAMILIES };

/** A number of a curve's summary, or of a surface's power law. */
enum number {
    AREA_SLOPE,
    GAP_AT_FULL,
    STATISTICAL_GAP,
    ELBOW_SHARE, /* of the load to full contact; none at the first load or below */
    SCALE_DEPENDENCE,
    LAW_FACTOR,
    BETA,
    LAW_GAMMA,
    LAW_AMPLITUDE
};

struct check {
    const char *part; /* of the thesis */
    const char *name; /* a flag, for the template's words */
    unsigned effects; /* EFFECT_BITs it needs */
    enum need needs;
    size_t surfaces;                    /* that it takes at least */
    void (*check)(struct finding *out); /* called for every model that speaks; or: */
    bool once;                          /* it is about the surfaces alone */
    enum quantity quantity;             /* that check_yield(), check_rank(), check_distances() look at */
    enum number number;                 /* that check_numbers() and check_laws() look at; of the former: */
    double scale, low, high;            /* shown times the scale (0: 1); the finding is that it lies from low to high */
};

static bool speaks(const struct view_source *source, size_t m)
{
    return model_rows[m]->in_findings && plan_runs_model(source->results->plan, m);
}

static const struct surface_summary *smoothest(const struct finding *f, size_t k)
{
    return view_summary(f->source, f->source->results->by_roughness[k]);
}

/** What is known of the model on the k-th smoothest surface; NULL: nothing. */
static const struct curve_summary *curve_of(const struct finding *f, size_t k)
{
    const struct curve_summary *curve = surface_model(smoothest(f, k), f->m);
    return curve->exists ? curve : NULL;
}

static const struct comparison_model *compared(const struct finding *f)
{
    return &f->source->comparison->models[f->m];
}

static void add_tally(struct finding *out, const struct comparison_tally *tally)
{
    out->good += tally->agreeing;
    out->all += tally->agreeing + tally->opposed;
    out->ties += tally->ties;
}

/** One case: x should be less than y by more than `slack`. */
static void add_case(struct finding *out, double x, double y, double slack)
{
    if (!isfinite(x) || !isfinite(y))
        return;
    bool tie = fabs(x - y) <= slack;
    out->ties += tie;
    out->all += !tie;
    out->good += !tie && x < y;
}

static void widen(struct finding *out, double value)
{
    out->least = fmin(out->least, value);
    out->most = fmax(out->most, value);
}

static double number_of(const struct curve_summary *curve, enum number number)
{
    switch (number) {
    case AREA_SLOPE:
        return curve->area_slope;
    case GAP_AT_FULL:
        return isnan(curve->beta) ? curve->gap_at_full : NAN; /* β makes it 0, which proves nothing */
    case STATISTICAL_GAP:
        return -curve->beta / 2; /* delta_full/sigma, by the definition of beta (4.54) */
    case LAW_FACTOR:
        return fmax(curve->law_factor, 1 / curve->law_factor);
    case ELBOW_SHARE:
        return curve->elbow_load > curve->first_load ? curve->elbow_load / curve->full_load : NAN;
    case SCALE_DEPENDENCE:
        return curve->sd_most;
    default:
        return curve->beta;
    }
}

/** A number of the model over the surfaces. */
static void check_numbers(struct finding *f)
{
    for (size_t k = 0; k < f->source->results->usable_count; k++) {
        const struct curve_summary *curve = curve_of(f, k);
        double value = curve ? number_of(curve, f->row->number) : NAN;
        if (!isfinite(value))
            continue;
        widen(f, value);
        f->all++;
        f->good += value >= f->row->low && value <= f->row->high;
    }
}

/** What yielding does to a quantity; of the load: is contact full sooner? */
static void check_yield(struct finding *f)
{
    const struct comparison_plastic *plastic = &compared(f)->plastic;
    const enum quantity quantity = f->row->quantity;
    add_tally(f, quantity == QUANTITY_LOAD ? &plastic->sooner : &plastic->changes[quantity]);
    if (quantity == QUANTITY_AREA && plastic->most > 0) {
        f->least = plastic->least;
        f->most = plastic->most;
    }
}

/** Of the multiscale and the statistical model of one law on every surface: does the adjustment bring the gaps closer,
 * is ECR closer than the area, is it within half a decade, so that both round to the same order of magnitude? */
static void check_distances(struct finding *f)
{
    const enum quantity quantity = f->row->quantity;
    for (size_t k = 0; k < f->source->results->usable_count; k++) {
        const struct comparison_gap *gap = &compared(f)->gaps[f->source->results->by_roughness[k]];
        double x = quantity == QUANTITY_SEPARATION ? gap->adjusted : gap->ecr;
        double y = quantity == QUANTITY_SEPARATION ? gap->plain : quantity == QUANTITY_AREA ? gap->area : 0.5;
        add_case(f, x, y, f->source->results->scene->tolerance * fmax(x, y));
    }
}

/** The multiscale model over the statistical one of its law on every surface: is it stiffer, are their gaps of one
 * order of magnitude, in the mean over the loads? */
static void check_factors(struct finding *f)
{
    const bool stiffness = f->row->quantity == QUANTITY_STIFFNESS;
    for (size_t k = 0; k < f->source->results->usable_count; k++) {
        const struct comparison_gap *gap = &compared(f)->gaps[f->source->results->by_roughness[k]];
        double decades = stiffness ? gap->stiffness : gap->separation;
        if (!isfinite(decades))
            continue;
        f->all++;
        f->good += stiffness ? decades > 0 : decades < 1;
        widen(f, pow(10, decades));
    }
}

/** Does the resistance of an elastic stack bend where contact of the plastic one is full, within half a decade? */
static void check_shoulder(struct finding *f)
{
    const struct results *results = f->source->results;
    size_t elastic = model_index(model_rows[f->m]->elastic);
    for (size_t k = 0; elastic < model_count && k < results->usable_count; k++) {
        const struct model_curve *curves = results->surfaces[results->by_roughness[k]].curves;
        const struct curve_summary *plastic = curve_of(f, k);
        if (!curves || !plastic || !(curves[elastic].kink.load > 0))
            continue;
        double ratio = curves[elastic].kink.load / plastic->full_load;
        f->label = model_rows[elastic]->label;
        widen(f, ratio);
        add_case(f, fabs(log10(ratio)), 0.5, 0);
    }
}

static void check_gamma(struct finding *f)
{
    for (size_t k = 0; k < f->source->results->usable_count; k++) {
        f->all += surface_tells_gamma(smoothest(f, k));
        f->good += surface_tells_gamma(smoothest(f, k)) && !surface_diverges(smoothest(f, k));
    }
}

static void check_convergence(struct finding *f)
{
    for (int s = 0; s < CONVERGENCE_SWEEP_COUNT && model_rows[f->m]->stacks_scales; s++)
        for (size_t v = 0; v < convergence_sweeps[s].count; v++) {
            bool should = s == CONVERGENCE_ALPHA || convergence_sweeps[s].values[v] >= 1;
            f->good += comparison_converges(f->source->results, (enum convergence_sweep)s, f->m, v) == should;
            f->all++;
        }
}

/** No order is found where neighbours go both ways. */
static void add_no_order(struct finding *out, size_t one_way, size_t other_way)
{
    out->all += one_way + other_way > 1;
    out->good += one_way > 0 && other_way > 0;
}

/** Neighbours in roughness, load by load: of the separation the finding is that they go both ways. */
static void check_rank(struct finding *f)
{
    const struct comparison_tally *tally = &compared(f)->rank[f->row->quantity];
    if (f->row->quantity == QUANTITY_SEPARATION)
        add_no_order(f, tally->agreeing, tally->opposed);
    else
        add_tally(f, tally);
}

/** The gaps of neighbours in the last decade of load before one of them is full. */
static void check_high_rank(struct finding *f)
{
    add_tally(f, &compared(f)->high_rank[f->row->quantity]);
}

/** Do statistical gaps follow roughness but for that of the smoothest surface? The number: at how many of its loads
 * not, in %. */
static void check_smoothest(struct finding *f)
{
    const struct comparison_tally *all = &compared(f)->rank[f->row->quantity],
                                  *first = &compared(f)->smoothest[f->row->quantity];
    size_t agreeing = all->agreeing - first->agreeing, opposed = all->opposed - first->opposed,
           cases = first->agreeing + first->opposed;
    if (!model_rows[f->m]->asperity_model || cases == 0 || agreeing + opposed == 0)
        return;
    f->all++;
    f->good += first->opposed > first->agreeing && agreeing > opposed;
    widen(f, 100 * (double)first->opposed / (double)cases);
}

/** Statistical resistances of the two smoothest surfaces lie less than half as far apart as other neighbours' do. */
static void check_together(struct finding *f)
{
    const double *steps = compared(f)->steps;
    if (!model_rows[f->m]->asperity_model || !isfinite(steps[0]))
        return;
    for (size_t k = 1; k + 1 < f->source->results->usable_count; k++)
        add_case(f, 2 * fabs(steps[0]), fabs(steps[k]), 0);
    widen(f, steps[0]);
}

static void check_beta_rank(struct finding *f)
{
    struct finding own = {0};
    for (size_t k = 1; k < f->source->results->usable_count; k++) {
        const struct curve_summary *smooth = curve_of(f, k - 1), *rough = curve_of(f, k);
        if (smooth && rough)
            add_case(&own, rough->beta, smooth->beta, f->source->results->scene->tolerance * fabs(smooth->beta));
    }
    add_no_order(f, own.good, own.all - own.good);
}

/** From the smoother to the rougher neighbour, beyond the errors of both: falls γ; has Δ no order? */
static void check_laws(struct finding *f)
{
    const double at_m = results_law_wavelength_m(f->source->results);
    struct finding own = {0};
    for (size_t k = 1; k < f->source->results->usable_count; k++) {
        const struct power_law *smooth = &smoothest(f, k - 1)->power_law, *rough = &smoothest(f, k)->power_law;
        if (!power_law_holds(smooth) || !power_law_holds(rough))
            continue;
        if (f->row->number == LAW_AMPLITUDE)
            add_case(&own, log10(power_law_amplitude(rough, at_m)), log10(power_law_amplitude(smooth, at_m)),
                     hypot(power_law_error_decades(rough, at_m), power_law_error_decades(smooth, at_m)));
        else
            add_case(f, rough->gamma, smooth->gamma, hypot(rough->gamma_error, smooth->gamma_error));
    }
    add_no_order(f, own.good, own.all - own.good);
}

/** The spread between the surfaces: of areas, each plastic model's against its elastic partner's; of resistances, each
 * statistical model's against the multiscale one's of its law. */
static void check_spread(struct finding *f)
{
    const struct results *results = f->source->results;
    bool areas = f->row->quantity == QUANTITY_AREA;
    enum comparison_spread of = areas ? COMPARISON_AREAS : COMPARISON_RESISTANCES;
    size_t partner = model_index(areas ? model_rows[f->m]->elastic : model_rows[f->m]->counterpart);
    if (partner == model_count)
        return;
    const struct comparison_model *own = compared(f), *other = &f->source->comparison->models[partner];
    double x = comparison_mean_spread(results, own, other, of), y = comparison_mean_spread(results, other, own, of);
    add_case(f, areas ? x : y, areas ? y : x, results->scene->tolerance);
}

/** The same order of magnitude: within a factor of 10, at the load where it is largest. */
static void check_magnitude(struct finding *f)
{
    double most = comparison_largest_spread(f->source->results, compared(f), COMPARISON_AREAS);
    f->all += isnan(most) ? 0 : 1;
    f->good += most < 10;
    widen(f, most);
}

/** Neighbouring resistance curves keep nearly the same distance when the widest is at most twice the narrowest. */
static void check_equal_steps(struct finding *f)
{
    const double *steps = compared(f)->steps;
    struct finding own = {.least = INFINITY, .most = -INFINITY};
    for (size_t k = 0; model_rows[f->m]->stacks_scales && k + 1 < f->source->results->usable_count; k++)
        if (isfinite(steps[k])) {
            widen(&own, steps[k]);
            own.all++;
        }
    if (own.all < 2)
        return;
    f->least = own.least;
    f->most = own.most;
    f->all++;
    f->good += own.least > 0 && own.most <= 2 * own.least;
}

static bool has(const struct view_source *source, enum need need)
{
    bool any = false, scales = false, asperities = false;
    for (size_t m = 0; m < model_count; m++) {
        any = any || speaks(source, m);
        scales = scales || (speaks(source, m) && model_rows[m]->stacks_scales);
        asperities = asperities || (speaks(source, m) && model_rows[m]->asperity_model);
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
    STIFFNESS = EFFECT_BIT(EFFECT_STIFFNESS),
};

static const struct check checks[] = {
    {"6.2", "convergence_by_gamma", CONVERGENCE, NEEDS_SCALES, 1, .check = check_convergence},
    {"6.2", "gamma", 0, NEEDS_SCALES, 1, .check = check_gamma, .once = true},
    {"6.3.1", "linear", 0, NEEDS_ANY, 1, check_numbers, .number = AREA_SLOPE, .low = 0.9, .high = 1.1},
    {"6.3.1", "plastic_area", PLASTIC, NEEDS_ANY, 1, check_yield, .quantity = QUANTITY_AREA},
    {"6.3.2", "closed", SEPARATION, NEEDS_SCALES, 1, check_numbers, .number = GAP_AT_FULL, .low = -INFINITY,
     .high = 0.01},
    {"6.3.2", "plastic_gap", PLASTIC | SEPARATION, NEEDS_ANY, 1, check_yield, .quantity = QUANTITY_SEPARATION},
    {"6.3.2", "adjustment", SEPARATION, NEEDS_FAMILIES, 1, check_distances, .quantity = QUANTITY_SEPARATION},
    {"6.3.2", "statistical_gap", SEPARATION, NEEDS_ADJUSTED, 1, check_numbers, .number = STATISTICAL_GAP, .low = 0,
     .high = INFINITY},
    {"6.3.2", "same_order", SEPARATION, NEEDS_FAMILIES, 1, check_factors, .quantity = QUANTITY_SEPARATION},
    {"6.3.2", "stiffer", STIFFNESS, NEEDS_FAMILIES, 1, check_factors, .quantity = QUANTITY_STIFFNESS},
    {"6.3.3", "elbow", ELECTRICAL, NEEDS_ANY, 1, check_numbers, .number = ELBOW_SHARE, .scale = 100, .low = 0.1,
     .high = INFINITY},
    {"6.3.3", "plastic_ecr", PLASTIC | ELECTRICAL, NEEDS_ANY, 1, check_yield, .quantity = QUANTITY_ECR},
    {"6.3.3", "families", ELECTRICAL, NEEDS_FAMILIES, 1, check_distances, .quantity = QUANTITY_AREA},
    {"6.3.4", "scale_dependence", SCALE_DEPENDENT, NEEDS_ANY, 1, check_numbers, .number = SCALE_DEPENDENCE,
     .scale = 100, .low = -INFINITY, .high = 0.05},
    {"6.4", "gamma_rank", 0, NEEDS_ANY, 2, check_laws, true, .number = LAW_GAMMA},
    {"6.4", "amplitude_rank", 0, NEEDS_ANY, 3, check_laws, true, .number = LAW_AMPLITUDE},
    {"6.4", "law", 0, NEEDS_SCALES, 1, check_numbers, .number = LAW_FACTOR, .low = 2, .high = INFINITY},
    {"6.4.1", "area_rank", 0, NEEDS_ANY, 2, check_rank, .quantity = QUANTITY_AREA},
    {"6.4.1", "magnitude", 0, NEEDS_ANY, 2, .check = check_magnitude},
    {"6.4.1", "spread", PLASTIC, NEEDS_ANY, 2, check_spread, .quantity = QUANTITY_AREA},
    {"6.4.1", "sooner", PLASTIC, NEEDS_ANY, 1, check_yield, .quantity = QUANTITY_LOAD},
    {"6.4.2", "separation_rank", SEPARATION, NEEDS_ANY, 2, check_rank, .quantity = QUANTITY_SEPARATION},
    {"6.4.2", "high_rank", SEPARATION, NEEDS_ANY, 2, check_high_rank, .quantity = QUANTITY_SEPARATION},
    {"6.4.2", "smoothest", SEPARATION, NEEDS_ADJUSTED, 3, check_smoothest, .quantity = QUANTITY_SEPARATION},
    {"6.4.2", "beta", SEPARATION, NEEDS_ADJUSTED, 1, check_numbers, .number = BETA, .low = 4, .high = 12},
    {"6.4.2", "beta_rank", SEPARATION, NEEDS_ADJUSTED, 3, .check = check_beta_rank},
    {"6.4.3", "ecr_rank", ELECTRICAL, NEEDS_ANY, 2, check_rank, .quantity = QUANTITY_ECR},
    {"6.4.3", "equal_steps", ELECTRICAL, NEEDS_SCALES, 3, .check = check_equal_steps},
    {"6.4.3", "shoulder", ELECTRICAL | PLASTIC, NEEDS_SCALES, 1, .check = check_shoulder},
    {"6.4.4", "tcr_rank", THERMAL, NEEDS_ANY, 2, check_rank, .quantity = QUANTITY_TCR},
    {"6.4.4", "sensitive", THERMAL, NEEDS_FAMILIES, 2, check_spread, .quantity = QUANTITY_TCR},
    {"6.4.4", "together", THERMAL, NEEDS_ADJUSTED, 3, .check = check_together},
    {"6.4.4", "family_ecr", ELECTRICAL, NEEDS_FAMILIES, 2, check_distances, .quantity = QUANTITY_ECR},
};

static void check_model(struct finding *out, json_t *numbers, size_t m)
{
    double scale = out->row->scale > 0 ? out->row->scale : 1;
    out->m = m;
    out->label = model_rows[m]->label;
    out->least = INFINITY;
    out->most = -INFINITY;
    out->row->check(out);
    if (!(out->least <= out->most))
        return;
    json_t *item = view_item(numbers);
    view_text(item, "label", out->label);
    view_range(item, "range", out->least * scale, out->most * scale, 2, "");
}

void view_findings(json_t *out, const struct view_source *source)
{
    if (!source->results->convergence || !has(source, NEEDS_ANY))
        return;
    json_t *list = view_list(out, "findings");
    view_flag(out, "has_findings", true);
    for (size_t i = 0; i < sizeof checks / sizeof *checks; i++) {
        const struct check *row = &checks[i];
        struct finding finding = {.source = source, .row = row};
        if ((row->effects & ~source->results->plan->running) || !has(source, row->needs) ||
            source->results->usable_count < row->surfaces)
            continue;
        json_t *item = view_item(list), *numbers = view_list(item, "numbers");
        for (size_t m = 0, called = 0; m < model_count && !(row->once && called > 0); m++)
            if (speaks(source, m) && ++called)
                check_model(&finding, numbers, m);
        view_separate(numbers);
        view_text(item, "part", row->part);
        view_flag(item, row->name, true);
        view_count(item, "good", finding.good);
        view_count(item, "all", finding.all);
        if (finding.ties > 0)
            view_count(item, "ties", finding.ties);
        view_flag(item, "holds", finding.all > 0 && finding.good == finding.all);
        view_flag(item, "in_part", finding.good < finding.all && 2 * finding.good >= finding.all);
        view_flag(item, "fails", 2 * finding.good < finding.all);
        view_flag(item, "not_tested", finding.all == 0);
    }
}
