/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The findings of the thesis's chapter 6, each checked on these surfaces by the thesis's models. A further one is a row
 * of `checks`, which says what is held against what, and its line in templates/words.txt. */
#include "report/view.h"

#include <math.h>
#include <stddef.h>

/** Cases for a finding, against it, and ties. */
struct tally {
    size_t good, bad, ties;
};

/** A check at work on a model, and what it found: of the model, `own`, and the range of a number of the model's; of
 * all models. */
struct finding {
    const struct view_source *source;
    const struct check *row;
    double law_m;    /* wavelength that power laws are held against each other at */
    size_t m, other; /* the model, and the one that it is held against; model_count: there is none */
    size_t step;     /* to the surface that one is held against */
    struct tally own, first /* the smoothest surface's part of it */, all;
    double least, most; /* least > most: none */
};

/** Models of the thesis that have to run for a check, bits; of one kind alone: those that it looks at. */
enum { SCALES = 1, ASPERITIES = 2, FAMILIES = SCALES | ASPERITIES };

/** What a curve is held against: that of the next rougher surface, of the elastic model or of the multiscale one of the
 * same law. */
enum with { NEIGHBOUR, ELASTIC, COUNTERPART };

/** A number of a surface or of a model's curve. */
enum number {
    FIELD, /* of the curve's summary */
    ELBOW, /* its load over that of full contact; none at the first load or below */
    FROM_LAW,
    LAW_GAMMA,
    LAW_AMPLITUDE, /* log10 */
    TIMES,         /* the other curve over this one, in the mean over the loads */
    TIMES_APART,   /* the same, never below 1 */
    STEP,          /* log10 of the resistance of the other curve over this one's, in the mean over the loads */
    SHOULDER,      /* where the other curve's resistance bends over where contact of this one is full */
    SPREAD,        /* most over least of all surfaces, at the load where it is largest */
    MEAN_SPREAD    /* log10, in the mean over the loads at which both models have one */
};

/** What a check is: bits. */
enum {
    ONCE = 1,       /* about the surfaces, no model */
    WHOLE = 2,      /* about all surfaces together, not about each or each pair */
    FALLS = 4,      /* the other's number is the smaller */
    HIGH = 8,       /* in the last decade of load before one contact is full */
    NO_ORDER = 16,  /* the finding is that cases go both ways */
    BUT_FIRST = 32, /* that the smoothest surface's alone go the other way; shown: how many of those, in % */
    EVEN = 64,      /* that the largest of two numbers or more is at most twice the least */
    TOGETHER = NO_ORDER | BUT_FIRST | EVEN /* a model's cases are one */
};

struct check {
    const char *part;                             /* of the thesis */
    const char *name;                             /* its words are finding.NAME */
    unsigned effects;                             /* EFFECT_BITs it needs */
    unsigned models;                              /* that it needs: the bits above */
    size_t surfaces;                              /* that it takes at least */
    void (*check)(struct finding *out, size_t k); /* the kind: called for the k-th smoothest surface */
    enum with with;
    unsigned is;
    enum quantity quantity, than; /* than: it should be closer in `quantity` than in that one */
    enum number number;
    size_t field;
    double scale;     /* a number is shown times that; 0: it is not */
    double low, high; /* the finding is that it, so scaled, lies between */
};

static const struct surface_record *record_of(const struct finding *f, size_t k)
{
    return &f->source->results->surfaces[f->source->results->by_roughness[k]];
}

static void add(struct tally *out, bool good)
{
    out->good += good;
    out->bad += !good;
}

/** One case: x should be less than y by more than `slack`; or more, where it `falls`. */
static void add_case(struct tally *out, double x, double y, double slack, bool falls)
{
    if (!isfinite(x) || !isfinite(y))
        return;
    if (fabs(x - y) <= slack)
        out->ties++;
    else
        add(out, (x < y) != falls);
}

/** Numbers this close are equal within the run's tolerance. */
static double slack_of(const struct finding *f, double x, double y)
{
    return f->source->results->scene->tolerance * fmax(fabs(x), fabs(y));
}

/** Is the surface that the k-th smoothest is held against another one that is rougher, or itself? */
static bool is_ordered(const struct finding *f, size_t k)
{
    const size_t next = k + f->step;
    if (next >= f->source->results->usable_count)
        return false;
    const double rq_m = record_of(f, k)->summary.roughness.rq_m, rougher_m = record_of(f, next)->summary.roughness.rq_m;
    return f->step == 0 || rougher_m - rq_m > slack_of(f, rq_m, rougher_m);
}

static void widen(struct finding *f, double value)
{
    if (f->row->scale == 0 || !isfinite(value))
        return;
    f->least = fmin(f->least, value);
    f->most = fmax(f->most, value);
}

/** What a model says of the k-th smoothest surface at place `i` of its loads; NULL: nothing, as where a statistical
 * curve closes with a load of its own. */
static const struct contact_point *point_at(const struct finding *f, size_t m, size_t k, size_t i)
{
    const struct results *results = f->source->results;
    if (m >= model_count || k >= results->usable_count || !record_of(f, k)->curves)
        return NULL;
    const struct model_curve *curve = &record_of(f, k)->curves[m];
    const double load = results_loads(results, results->by_roughness[k])[i];
    return i < curve->count && curve->points[i].value[QUANTITY_LOAD] == load ? &curve->points[i] : NULL;
}

enum mean { DECADES, DECADES_APART, APART };

/** Mean over the loads of the other curve's quantity over the model's, in decades, where both are above 0 (of areas:
 * and conduct); or of how far they lie apart. The multiscale models know one separation, however it is adjusted. NaN:
 * none. */
static double mean_of(const struct finding *f, size_t k, enum quantity quantity, enum mean mean)
{
    const enum quantity other = quantity == QUANTITY_ADJUSTED ? QUANTITY_SEPARATION : quantity;
    double sum = 0, count = 0;
    for (size_t i = 0; i < f->source->results->load_count; i++) {
        const struct contact_point *a = point_at(f, f->m, k, i), *b = point_at(f, f->other, k + f->step, i);
        double x = a ? a->value[quantity] : NAN, y = b ? b->value[other] : NAN;
        bool full = quantity == QUANTITY_AREA && a && b && !(a->value[QUANTITY_ECR] > 0 && b->value[QUANTITY_ECR] > 0);
        double step = mean == APART ? y - x : full || !(x > 0 && y > 0) ? NAN : log10(y / x);
        sum += isnan(step) ? 0 : mean == DECADES ? step : fabs(step);
        count += !isnan(step);
    }
    return sum / count;
}

/** Most over least of an area or a resistance at load `i`; NaN where not all surfaces are in partial contact there. */
static double spread_at(const struct finding *f, size_t m, size_t i)
{
    const struct results *results = f->source->results;
    const enum quantity quantity = f->row->quantity == QUANTITY_AREA ? QUANTITY_AREA : results_criterion(results);
    double least = INFINITY, most = 0;
    for (size_t k = 0; k < results->usable_count; k++) {
        const struct contact_point *point = point_at(f, m, k, i);
        if (!point || !(point->value[QUANTITY_AREA] < 1) || !(point->value[quantity] > 0))
            return NAN;
        least = fmin(least, point->value[quantity]);
        most = fmax(most, point->value[quantity]);
    }
    return most / least;
}

static double number_of(const struct finding *f, size_t m, size_t k)
{
    const struct surface_summary *summary = &record_of(f, k)->summary;
    const struct curve_summary *curve = surface_model(summary, m);
    const struct power_law *law = &summary->power_law;
    const struct model_curve *curves = record_of(f, k)->curves;
    double most = NAN, sum = 0, count = 0;
    switch (f->row->number) {
    case FIELD:
        return curve->exists ? *(const double *)(const void *)((const char *)curve + f->row->field) : NAN;
    case ELBOW:
        return curve->elbow_load > curve->first_load ? curve->elbow_load / curve->full_load : NAN;
    case FROM_LAW:
        return fmax(curve->law_factor, 1 / curve->law_factor);
    case LAW_GAMMA:
        return power_law_holds(law) ? law->gamma : NAN;
    case LAW_AMPLITUDE:
        return power_law_holds(law) ? log10(power_law_amplitude(law, f->law_m)) : NAN;
    case TIMES:
    case TIMES_APART:
        return pow(10, mean_of(f, k, f->row->quantity, f->row->number == TIMES ? DECADES : DECADES_APART));
    case STEP:
        return mean_of(f, k, results_criterion(f->source->results), DECADES);
    case SHOULDER:
        most = curves && f->other < model_count ? curves[f->other].kink.load : 0;
        return most > 0 ? most / curve->full_load : NAN;
    case SPREAD:
    case MEAN_SPREAD:
        for (size_t i = 0; i < f->source->results->load_count; i++) {
            const double spread = spread_at(f, m, i);
            most = fmax(most, spread); /* of a number and NaN, the number */
            if (isfinite(spread_at(f, f->m, i)) && isfinite(spread_at(f, f->other, i))) {
                sum += log10(spread);
                count++;
            }
        }
    }
    return f->row->number == SPREAD ? most : sum / count;
}

/** Does a number lie within its bounds? */
static void check_number(struct finding *f, size_t k)
{
    double value = (f->row->scale == 0 ? 1 : f->row->scale) * number_of(f, f->m, k);
    widen(f, value);
    if (isfinite(value))
        add(&f->own, value > f->row->low && value < f->row->high);
}

/** Standard error of a power law's number. */
static double error_of(const struct finding *f, size_t k)
{
    const struct power_law *law = &record_of(f, k)->summary.power_law;
    return f->row->number == LAW_GAMMA ? law->gamma_error : power_law_error_decades(law, f->law_m);
}

/** Is a number less than the other's, beyond the tolerance, or the errors of both laws? */
static void check_order(struct finding *f, size_t k)
{
    const size_t next = k + f->step;
    if (f->other == model_count || !is_ordered(f, k) || (f->row->with != NEIGHBOUR && !record_of(f, k)->curves))
        return;
    double x = number_of(f, f->m, k), y = number_of(f, f->other, next);
    double slack = f->row->is & ONCE    ? hypot(error_of(f, k), error_of(f, next))
                   : f->row->is & WHOLE ? slack_of(f, 1, 0) /* of decades */
                                        : slack_of(f, x, y);
    add_case(&f->own, x, y, slack, f->row->is & FALLS);
}

/** Is it in the last decade of load before contact is full? */
static bool is_high(const struct finding *f, size_t k, const struct contact_point *point)
{
    return point->value[QUANTITY_LOAD] >= 0.1 * surface_model(&record_of(f, k)->summary, f->m)->full_load;
}

/** Load by load, has the curve the larger area, the smaller gap or resistance than the other? Loads at which both
 * contacts are full are no cases. */
static void check_loads(struct finding *f, size_t k)
{
    const enum quantity quantity = f->row->quantity;
    const struct quantity_row *row = &quantity_rows[quantity];
    const double least = row->sigma_column ? 1 : 0; /* what a difference of gaps is small against */
    const size_t next = k + f->step;
    for (size_t i = 0; is_ordered(f, k) && i < f->source->results->load_count; i++) {
        const struct contact_point *a = point_at(f, f->m, k, i), *b = point_at(f, f->other, next, i);
        if (!a || !b || (a->value[QUANTITY_AREA] == 1 && b->value[QUANTITY_AREA] == 1) ||
            ((f->row->is & HIGH) && !is_high(f, k, a) && !is_high(f, next, b)))
            continue;
        double x = comparison_value(a, quantity, f->m, record_of(f, k)->summary.asperities.sigma_m);
        double y = comparison_value(b, quantity, f->m, record_of(f, next)->summary.asperities.sigma_m);
        add_case(&f->own, x, y, fmax(slack_of(f, x, y), slack_of(f, least, 0)), row->is & QUANTITY_RISES);
        widen(f, x / y);
    }
}

/** Is the other curve closer in a quantity than in another, or than so many decades, in the mean over the loads? */
static void check_closer(struct finding *f, size_t k)
{
    const enum mean mean = quantity_rows[f->row->quantity].sigma_column ? APART : DECADES_APART;
    double x = mean_of(f, k, f->row->quantity, mean);
    double y = f->row->than ? mean_of(f, k, f->row->than, mean) : f->row->high;
    add_case(&f->own, x, y, slack_of(f, x, y), false);
}

/** Do the resistances of the two smoothest surfaces lie less than half as far apart as other neighbours' do? */
static void check_together(struct finding *f, size_t k)
{
    double first = number_of(f, f->m, 0);
    widen(f, first);
    if (k > 0)
        add_case(&f->own, 2 * fabs(first), fabs(number_of(f, f->m, k)), 0, false);
}

enum {
    PLASTIC = EFFECT_BIT(EFFECT_PLASTICITY),
    SEPARATION = EFFECT_BIT(EFFECT_SEPARATION),
    ELECTRICAL = EFFECT_BIT(EFFECT_ELECTRICAL),
    THERMAL = EFFECT_BIT(EFFECT_THERMAL),
    SCALE_DEPENDENT = EFFECT_BIT(EFFECT_SCALE_DEPENDENT),
    STIFFNESS = EFFECT_BIT(EFFECT_STIFFNESS),
};

#define OF(name) .field = offsetof(struct curve_summary, name)

static const struct check checks[] = {
    {"6.3.1", "linear", 0, 0, 1, check_number, OF(area_slope), .scale = 1, .low = 0.9, .high = 1.1},
    {"6.3.1", "plastic_area", PLASTIC, 0, 1, check_loads, ELASTIC, .quantity = QUANTITY_AREA, .scale = 1},
    {"6.3.2", "closed", SEPARATION, SCALES, 1, check_number, OF(gap_at_full), .scale = 1, .low = -INFINITY,
     .high = 0.01},
    {"6.3.2", "plastic_gap", PLASTIC | SEPARATION, 0, 1, check_loads, ELASTIC, .quantity = QUANTITY_SEPARATION},
    {"6.3.2", "adjustment", SEPARATION, FAMILIES, 1, check_closer, COUNTERPART, .quantity = QUANTITY_ADJUSTED,
     .than = QUANTITY_SEPARATION},
    {"6.3.2", "statistical_gap", SEPARATION, ASPERITIES, 1, check_number, OF(beta), .scale = -0.5, .low = 0,
     .high = INFINITY}, /* δ_full/σ, by the definition of β (4.54) */
    {"6.3.2", "same_order", SEPARATION, FAMILIES, 1, check_number, COUNTERPART, .quantity = QUANTITY_ADJUSTED,
     .number = TIMES_APART, .scale = 1, .high = 10},
    {"6.3.2", "stiffer", STIFFNESS, FAMILIES, 1, check_number, COUNTERPART, .quantity = QUANTITY_STIFFNESS,
     .number = TIMES, .scale = 1, .low = 1, .high = INFINITY},
    {"6.3.3", "elbow", ELECTRICAL, 0, 1, check_number, .number = ELBOW, .scale = 100, .low = 10, .high = INFINITY},
    {"6.3.3", "plastic_ecr", PLASTIC | ELECTRICAL, 0, 1, check_loads, ELASTIC, .quantity = QUANTITY_ECR},
    {"6.3.3", "families", ELECTRICAL, FAMILIES, 1, check_closer, COUNTERPART, .quantity = QUANTITY_ECR,
     .than = QUANTITY_AREA},
    {"6.3.4", "scale_dependence", SCALE_DEPENDENT, 0, 1, check_number, OF(sd_most), .scale = 100, .low = -INFINITY,
     .high = 5},
    {"6.4", "gamma_rank", 0, 0, 2, check_order, .is = ONCE | FALLS, .number = LAW_GAMMA},
    {"6.4", "amplitude_rank", 0, 0, 3, check_order, .is = ONCE | NO_ORDER, .number = LAW_AMPLITUDE},
    {"6.4", "law", 0, SCALES, 1, check_number, .number = FROM_LAW, .scale = 1, .low = 2, .high = INFINITY},
    {"6.4.1", "area_rank", 0, 0, 2, check_loads, .quantity = QUANTITY_AREA},
    {"6.4.1", "magnitude", 0, 0, 2, check_number, .is = WHOLE, .quantity = QUANTITY_AREA, .number = SPREAD, .scale = 1,
     .high = 10},
    {"6.4.1", "spread", PLASTIC, 0, 2, check_order, ELASTIC, WHOLE, .quantity = QUANTITY_AREA, .number = MEAN_SPREAD},
    {"6.4.1", "sooner", PLASTIC, 0, 1, check_order, ELASTIC, OF(full_load)},
    {"6.4.2", "separation_rank", SEPARATION, 0, 2, check_loads, .is = NO_ORDER, .quantity = QUANTITY_SEPARATION},
    {"6.4.2", "high_rank", SEPARATION, 0, 2, check_loads, .is = HIGH, .quantity = QUANTITY_SEPARATION},
    {"6.4.2", "smoothest", SEPARATION, ASPERITIES, 3, check_loads, .is = BUT_FIRST, .quantity = QUANTITY_SEPARATION},
    {"6.4.2", "beta", SEPARATION, ASPERITIES, 1, check_number, OF(beta), .scale = 1, .low = 4, .high = 12},
    {"6.4.2", "beta_rank", SEPARATION, ASPERITIES, 3, check_order, .is = NO_ORDER, OF(beta)},
    {"6.4.3", "ecr_rank", ELECTRICAL, 0, 2, check_loads, .quantity = QUANTITY_ECR},
    {"6.4.3", "equal_steps", ELECTRICAL, SCALES, 3, check_number, .is = EVEN, .number = STEP, .scale = 1,
     .low = -INFINITY, .high = INFINITY},
    {"6.4.3", "shoulder", ELECTRICAL | PLASTIC, SCALES, 1, check_number, ELASTIC, .number = SHOULDER, .scale = 1,
     .low = 0.316227766, .high = 3.16227766}, /* half a decade */
    {"6.4.4", "tcr_rank", THERMAL, 0, 2, check_loads, .quantity = QUANTITY_TCR},
    {"6.4.4", "sensitive", THERMAL, FAMILIES, 2, check_order, COUNTERPART, WHOLE | FALLS, .quantity = QUANTITY_TCR,
     .number = MEAN_SPREAD},
    {"6.4.4", "together", THERMAL, ASPERITIES, 3, check_together, .number = STEP, .scale = 1},
    {"6.4.4", "family_ecr", ELECTRICAL, FAMILIES, 2, check_closer, COUNTERPART, .quantity = QUANTITY_ECR, .high = 0.5},
};

/** Of which kind is a model that runs and speaks here? 0: it does not. */
static unsigned speaks(const struct plan *plan, size_t m)
{
    const bool does = model_rows[m]->in_findings && plan_runs_model(plan, m);
    return !does ? 0 : model_rows[m]->stacks_scales ? SCALES : ASPERITIES;
}

/** Adds the cases of a model to those of all: each of them, or one, which is what they say together. */
static void conclude(struct finding *f)
{
    const struct tally own = f->own, first = f->first;
    size_t cases = first.good + first.bad, others = own.good + own.bad - cases;
    bool asked = true, good;
    if (f->row->is & NO_ORDER) {
        asked = own.good + own.bad > 1;
        good = own.good > 0 && own.bad > 0;
    } else if (f->row->is & BUT_FIRST) {
        asked = cases > 0 && others > 0;
        good = first.bad > first.good && 2 * (own.good - first.good) > others;
        f->least = f->most = 100 * (double)first.bad / (double)cases;
    } else if (f->row->is & EVEN) {
        asked = own.good > 1 && (f->least != 0 || f->most != 0); /* surfaces that are the same have no distance */
        good = f->least > 0 && f->most <= 2 * f->least;
    } else {
        f->all = (struct tally){f->all.good + own.good, f->all.bad + own.bad, f->all.ties + own.ties};
        return;
    }
    if (asked)
        add(&f->all, good);
    else
        f->least = INFINITY;
}

/** Adds a model's numbers, and the surfaces, or pairs, on which it speaks against the finding. */
static void check_model(struct finding *f, json_t *numbers, json_t *opposed, size_t m)
{
    const struct model_row *model = model_rows[m];
    const bool pairs = f->row->with == NEIGHBOUR && f->row->check != check_number;
    const size_t before = f->all.bad, places = f->row->is & WHOLE ? 1 : f->source->results->usable_count;
    json_auto_t *against = json_object();
    json_t *on = view_list(against, "on");
    size_t tested = 0;
    f->m = m;
    f->step = f->row->with == NEIGHBOUR;
    f->other = f->step ? m : model_index(f->row->with == ELASTIC ? model->elastic : model->counterpart);
    f->own = f->first = (struct tally){0};
    f->least = INFINITY;
    f->most = -INFINITY;
    for (size_t k = 0; k < places; k++) {
        const struct tally was = f->own;
        f->row->check(f, k);
        f->first = k == 0 ? f->own : f->first;
        tested += f->own.good + f->own.bad > was.good + was.bad;
        if (f->own.bad == was.bad || places == 1 || (f->row->is & TOGETHER) || json_array_size(on) >= VIEW_ROWS)
            continue;
        json_t *item = view_item(on);
        view_text(item, "surface", record_of(f, k)->summary.scene->name);
        if (pairs)
            view_text(item, "beside", record_of(f, k + 1)->summary.scene->name);
    }
    conclude(f);
    if (!(f->row->is & ONCE)) {
        view_text(against, "label", model->label);
        if (json_array_size(on) == tested) /* on all */
            json_array_clear(on);
    }
    if (f->all.bad > before && (!(f->row->is & ONCE) || json_array_size(on) > 0))
        json_array_append(opposed, against);
    if (!(f->least <= f->most))
        return;
    json_t *item = view_item(numbers);
    view_text(item, "label", model_rows[f->row->number == SHOULDER ? f->other : m]->label);
    view_range(item, "range", f->least, f->most);
}

void view_findings(json_t *out, const struct view_source *source)
{
    const struct plan *plan = source->results->plan;
    const double law_m = results_law_wavelength_m(source->results);
    unsigned kinds = 0;
    for (size_t m = 0; m < model_count; m++)
        kinds |= speaks(plan, m);
    if (!source->results->convergence || !kinds || !scene_has_one_pair(source->results->scene, false))
        return;
    json_t *list = view_list(out, "findings");
    for (size_t i = 0; i < sizeof checks / sizeof *checks; i++) {
        const struct check *row = &checks[i];
        struct finding finding = {.source = source, .row = row, .law_m = law_m};
        if ((row->effects & ~plan->running) || (row->models & ~kinds) || source->results->usable_count < row->surfaces)
            continue;
        json_auto_t *item = json_object();
        json_t *numbers = view_list(item, "numbers"), *opposed = view_list(item, "opposed");
        for (size_t m = 0, called = 0; m < model_count && !((row->is & ONCE) && called > 0); m++)
            if (((row->models ? row->models : FAMILIES) & speaks(plan, m)) && ++called)
                check_model(&finding, numbers, opposed, m);
        const size_t good = finding.all.good, all = good + finding.all.bad;
        view_text(item, "part", row->part);
        view_text(item, "name", row->name);
        view_text(item, "finding", words_say(source->words, "finding.%s", row->name));
        json_set_count(item, "good", good);
        json_set_count(item, "all", all);
        view_some(item, "ties", finding.all.ties);
        view_flag(item, "holds", good == all);
        view_flag(item, "in_part", good < all && 2 * good >= all);
        view_flag(item, "fails", 2 * good < all);
        if (all > 0)
            json_array_append(list, item);
    }
    view_flag(out, "has_findings", json_array_size(list) > 0);
}
