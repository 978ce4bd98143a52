/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "claims/claims.h"

#include "answers/direct_study.h"
#include "answers/shaped.h"
#include "base/number_format.h"
#include "joint/heating.h"
#include "output/record.h"
#include "results/accuracy.h"
#include <float.h>
#include <math.h>
#include <string.h>

enum { NAMED = 2 /* surfaces that one claim names */, SCANS_MOST = 50 /* that are worth advising */ };

/** A claim that is being made, and the list it goes to. */
struct claims {
    const struct results *results;
    const struct comparison *comparison;
    struct words *words;
    struct asked asked;
    size_t leading;
    const struct claim_row *row;
    const char *key;                  /* the row's, or one of its variants */
    size_t i;                         /* the surface, target or limit that the row is asked about; else the baseline */
    double weight;                    /* a factor: within a level the largest comes first */
    size_t others;                    /* for which the same holds, beside the one told */
    json_t *numbers, *told, *surface; /* its words are filled with its numbers, SI, and the texts told beside them */
    struct text text, markdown;
};

/** Surfaces of which something is so: the first two, and how many there are. */
struct named {
    size_t surface[NAMED], count;
};

/** The range of a number over surfaces. */
struct extent {
    double least, most; /* infinite: no surface has a value */
    size_t at_most;
    struct named on;
};

/** What claims.i counts for a row. Of surfaces, the first usable one that the claim holds for is told. */
enum claim_about { ABOUT_BASELINE, ABOUT_SURFACES, ABOUT_TARGETS, ABOUT_LIMITS };

/** A claim. `when` says whether it is made, fills in its numbers and may choose another key. */
struct claim_row {
    const char *key;
    const char *level;
    bool (*when)(struct claims *c);
    enum claim_about about;
    bool melts;         /* heated() */
    enum effect effect; /* share() */
};

/* ---- What the results say ---- */

static const char *name_of(const struct claims *c, size_t surface)
{
    return c->results->surfaces[surface].summary.scene->name;
}

static const struct surface_summary *summary_of(const struct claims *c, size_t surface)
{
    return &c->results->surfaces[surface].summary;
}

/** Usable surface number k, the smoothest first. */
static size_t usable(const struct claims *c, size_t k)
{
    return c->results->by_roughness[k];
}

static bool runs(const struct claims *c, enum effect effect)
{
    return plan_runs(c->results->plan, effect);
}

/** A quantity of the leading model where the summary stands. */
static double answer(const struct claims *c, size_t surface, enum quantity quantity)
{
    return comparison_middle(c->results, c->leading, surface).value[quantity];
}

/** What a model answers to the first target. */
static const struct answer *answer_of(const struct claims *c, size_t surface, size_t model)
{
    return &summary_of(c, surface)
                ->answers[(size_t)(c->asked.target - c->results->scene->targets) * model_count + model];
}

/** Does a filler's bond line keep the metals apart where the summary stands? */
static bool nothing_touches(const struct claims *c, size_t surface)
{
    return answer(c, surface, QUANTITY_AREA) == 0;
}

static void add_name(struct named *named, size_t surface)
{
    if (named->count++ < NAMED)
        named->surface[named->count - 1] = surface;
}

/** The range of a number over the usable surfaces that have one below a limit. */
static struct extent extent_of(const struct claims *c, double (*of)(const struct claims *c, size_t surface),
                               double below)
{
    struct extent extent = {.least = INFINITY, .most = -INFINITY};
    for (size_t k = 0; k < c->results->usable_count; k++) {
        const double value = of(c, usable(c, k));
        if (!(value < below && value > -INFINITY))
            continue;
        extent.at_most = value > extent.most ? usable(c, k) : extent.at_most;
        extent.least = fmin(extent.least, value);
        extent.most = fmax(extent.most, value);
        add_name(&extent.on, usable(c, k));
    }
    return extent;
}

/* ---- What fills a sentence ---- */

static void put_text(struct claims *c, const char *name, const char *string)
{
    json_object_set_new(c->told, name, json_shown(string));
}

/** Adds a text to a list. */
static void put_more(struct claims *c, const char *name, const char *string)
{
    if (!json_object_get(c->told, name))
        json_object_set_new(c->told, name, json_array());
    json_array_append_new(json_object_get(c->told, name), json_shown(string));
}

/** SI; words.txt says how it is shown. */
static void put(struct claims *c, const char *name, double value)
{
    json_set(c->numbers, name, value);
}

/** Numbers in a unit or with digits of the run's: "low to high", or one where both look the same; results.json gets
 * `numbers`. */
static void put_shown(struct claims *c, const char *name, json_t *numbers, const double shown[2], int digits,
                      const char *unit)
{
    OWNED(text_free) struct text text = {0};
    json_object_set_new(c->numbers, name, numbers);
    number_format_range(&text, shown[0], shown[1], digits, " to ");
    text_add(&text, "%s%s", unit[0] ? "\u00a0" : "", unit);
    put_text(c, name, text_string(&text));
}

static void put_number(struct claims *c, const char *name, double value, double shown, int digits, const char *unit)
{
    put_shown(c, name, json_finite(value), (const double[]){shown, shown}, digits, unit);
}

static void put_count(struct claims *c, const char *name, size_t count)
{
    json_set_count(c->numbers, name, count);
}

static void put_load(struct claims *c, const char *name, size_t surface, double load, int digits)
{
    const struct asked_load as = asked_load_of(c->results, surface);
    put_number(c, name, load, load * as.scale, digits, as.unit[0] ? as.unit : "E′Aₙ");
}

/** The name of what is asked for, or (not `own`) of a quantity that it is made from. */
static void put_quantity(struct claims *c, bool own, enum quantity quantity)
{
    put_text(c, "quantity",
             words_say(c->words, own ? "%s" : "asked.%s", own ? c->asked.name : quantity_rows[quantity].name));
}

/** A target or a limit, with its symbol and sign. */
static void put_asked(struct claims *c, const struct scene_asked *asked)
{
    char text[UNIT_LENGTH + 20];
    asked_text(text, sizeof text, asked->text);
    put_text(c, "asked", text);
    put_text(c, "symbol", asked->symbol);
    put_text(c, "sign", asked->is_most ? "≤" : "≥");
}

static void put_surface(struct claims *c, size_t surface)
{
    if (!c->surface)
        c->surface = json_shown(name_of(c, surface));
    put_text(c, "name", name_of(c, surface));
}

/** "a", "a and b", "a, b and 3 more"; false: none. */
static bool put_names(struct claims *c, const struct named *named)
{
    OWNED(text_free) struct text text = {0};
    for (size_t i = 0; i < named->count && i < NAMED; i++)
        text_add(&text, "%s%s", i == 0 ? "" : named->count == NAMED ? " and " : ", ", name_of(c, named->surface[i]));
    if (named->count > NAMED)
        text_add(&text, " and %zu more", named->count - NAMED);
    if (named->count == 1 && !c->surface)
        c->surface = json_shown(name_of(c, named->surface[0]));
    put_text(c, "names", text_string(&text));
    return named->count > 0;
}

/** What surfaces are ordered by: the load that a target needs, without one the answer; less is better. */
static double cost_of(const struct claims *c, const struct scene_asked *target, size_t surface)
{
    const struct known known = known_shown(c->results, &c->asked, target, surface);
    const bool more = !target && c->asked.more_is_better;
    if (known.kind == KNOWN_NOTHING || known.kind == (more ? KNOWN_AT_MOST : KNOWN_MORE_THAN))
        return INFINITY;
    return more ? -known.value : known.value;
}

/** The surface that costs least, of several such the first; or most, the last. */
static size_t best_or_worst(const struct claims *c, const struct scene_asked *target, bool worst)
{
    size_t out = usable(c, 0);
    for (size_t k = 1; k < c->results->usable_count; k++) {
        const double own = cost_of(c, target, usable(c, k)), found = cost_of(c, target, out);
        out = (worst ? own >= found : own < found) ? usable(c, k) : out;
    }
    return out;
}

/** The load that a target needs, without one the answer, in words; false: nothing is known. */
static bool put_known(struct claims *c, const struct scene_asked *target, size_t surface)
{
    const struct known known = known_shown(c->results, &c->asked, target, surface);
    const struct asked_load load = asked_load_of(c->results, surface);
    OWNED(text_free) struct text value = {0}, interval = {0};
    const bool is = known.kind == KNOWN_VALUE,
               has = number_format_range(&interval, known.low, known.high, known_digits(&known), "–");
    const char *const kind = known.kind == KNOWN_AT_MOST       ? "most"
                             : known.kind == KNOWN_MORE_THAN   ? "more"
                             : known.measured && !known.beyond ? "measured"
                             : has && !known.beyond            ? "interval"
                                                               : "is";
    number_format(&value, known.value, is ? known_digits(&known) : 3);
    put_surface(c, surface);
    put_text(c, "known",
             words_say(c->words, "known.%s\nvalue %s\ninterval %s\nunit\t%s", kind, text_string(&value),
                       text_string(&interval),
                       !target        ? c->asked.unit
                       : load.unit[0] ? load.unit
                                      : "E′Aₙ"));
    return known.kind != KNOWN_NOTHING;
}

/* ---- What stops a reader ---- */

static bool refused(struct claims *c)
{
    size_t files = 0, all = 0;
    struct named on = {0};
    for (size_t i = 0; i < c->results->surface_count; i++) {
        const struct surface_summary *s = summary_of(c, i);
        const size_t named = s->scene->files.count + s->scene->along.count, out = s->usable ? s->refused_scans : named;
        all += s->usable ? s->all_scans : named;
        files += out;
        if (out > 0)
            add_name(&on, i);
    }
    put_count(c, "count", files);
    put_count(c, "all", all);
    return put_names(c, &on);
}

/** Has the leading model no number where the summary stands, as the softer body yields altogether, or as the model ends
 * before full contact? */
static bool beyond_hardness(struct claims *c)
{
    const struct material_pair *pair = results_pair(c->results, c->i);
    const double pressure_Pa = material_pair_pressure(pair, results_operating_load(c->results, c->i));
    const struct model_row *model = model_rows[c->leading];
    const bool yields = pressure_Pa >= pair->hardness_Pa;
    put(c, "hardness", pair->hardness_Pa);
    put(c, "pressure", pressure_Pa);
    put_text(c, "label", model->label);
    put(c, "area", model->largest_area);
    c->key = yields ? "beyond-hardness" : "beyond-model";
    return isnan(answer(c, c->i, QUANTITY_AREA)) && surface_model(summary_of(c, c->i), c->leading)->exists &&
           (yields || (model->ends && (!model->uses_strip || summary_of(c, c->i)->has_strips)));
}

/** Is heat asked for that also goes through gaps? */
static bool gaps_conduct(const struct claims *c)
{
    return runs(c, EFFECT_GAP) && (c->asked.quantity == QUANTITY_JOINT || c->asked.quantity == QUANTITY_SHAPE_JOINT);
}

/** How many spots carry the answer's load, in proportion to the load: those counted on a map that leads, else the
 * model's count or that of equal spots of the same area and resistance, the fewer. NaN: unknown, or gaps carry most. */
static double spots_on(const struct claims *c, size_t surface)
{
    const struct contact_point at = comparison_middle(c->results, c->leading, surface);
    const struct material_pair *pair = results_pair(c->results, surface);
    const bool electrical = isfinite(at.value[QUANTITY_ECR]);
    const struct contact_spots alike =
        joint_equal_spots(at.value[QUANTITY_AREA], at.value[electrical ? QUANTITY_ECR : QUANTITY_TCR],
                          electrical ? pair->resistivity_ohm_m : 1 / pair->conductivity_W_per_mK);
    const struct map_contact *map = &c->results->surfaces[surface].contact;
    const bool counted = model_rows[c->leading]->uses_map && map->cells > 0;
    double per_m2 = counted ? (double)map->spot_count / pow((double)map->cells * map->cell_m, 2)
                            : fmin(at.value[QUANTITY_SPOT_DENSITY], alike.density_per_m2);
    if (gaps_conduct(c) && at.value[QUANTITY_GAP] > 0.5 * at.value[QUANTITY_JOINT])
        return NAN;
    if (c->asked.target) {
        const struct known load = known_load(c->results, c->asked.target, surface);
        if (load.kind != KNOWN_VALUE && load.kind != KNOWN_AT_MOST)
            return NAN;
        per_m2 *= load.value / results_operating_load(c->results, surface);
        per_m2 = counted ? per_m2 : fmin(per_m2, answer_of(c, surface, c->leading)->spots_per_m2);
    }
    return per_m2 * c->results->scene->nominal_area_m2;
}

static bool few_spots(struct claims *c)
{
    const struct extent spots = extent_of(c, spots_on, answers_least_spots);
    put(c, "spots", fmax(spots.most, 1)); /* fewer carry nothing */
    return put_names(c, &spots.on);
}

/** The least voltage over a spot of surface `surface` that softens a metal there, or (`melts`) melts it: the softer
 * body, or the plating; without a name the voltage that melts any metal. INFINITY: none is known. */
static double heat_limit(const char **metal, const struct claims *c, size_t surface, bool melts)
{
    const struct joint *joint = &c->results->scene->joint;
    const char *plating = joint_plating_names[joint->plating], *word = strrchr(plating, ' '); /* of "hard gold" */
    const char *const metals[] = {scene_softer(&summary_of(c, surface)->scene->bodies)->name,
                                  word ? word + 1 : plating};
    double limit_V = melts ? heating_voltage(HEATING_SOLID_MOST_K, joint->temperature_K) : INFINITY;
    *metal = "";
    for (size_t k = 0; k < sizeof metals / sizeof *metals; k++) {
        const struct heating_metal *known = heating_metal_find(metals[k]);
        const double own_V = !known  ? INFINITY
                             : melts ? heating_voltage(known->melting_K, joint->temperature_K)
                                     : known->softening_voltage_V;
        if (own_V < limit_V) {
            limit_V = own_V;
            *metal = metals[k];
        }
    }
    return limit_V;
}

/** Does a metal melt there? */
static bool molten(const struct claims *c, size_t surface)
{
    const char *metal;
    return known_value(c->results, QUANTITY_VOLTAGE, surface).value >= heat_limit(&metal, c, surface, true);
}

/** Does the voltage over a spot soften a metal there, or melt it? */
static bool heated(struct claims *c)
{
    const char *metal;
    const double voltage_V = known_value(c->results, QUANTITY_VOLTAGE, c->i).value,
                 limit_V = heat_limit(&metal, c, c->i, c->row->melts);
    put(c, "voltage", voltage_V);
    put(c, "limit", limit_V);
    put(c, "current", c->results->scene->joint.current_A);
    put_text(c, "metal", metal);
    return voltage_V >= limit_V && (c->row->melts || !molten(c, c->i));
}

/** Does a filler of a thickness of its own keep the metals apart, or have none that is known? */
static bool bond_line(struct claims *c)
{
    static const double usual_m = 50e-6;
    const struct joint *joint = &c->results->scene->joint;
    const bool missing = !(joint->bond_line_m > 0);
    c->key = missing ? "bond-line-missing" : "bond-line";
    put(c, "line", missing ? usual_m : joint->bond_line_m);
    put(c, "most", joint->conductivity_W_per_mK / (missing ? usual_m : joint->bond_line_m));
    put(c, "gap", answer(c, c->i, QUANTITY_SEPARATION));
    return runs(c, EFFECT_GAP) && joint->fill == JOINT_MEDIUM && !joint->gas && (missing || nothing_touches(c, c->i));
}

static bool loads_short(struct claims *c)
{
    return c->asked.target && known_load(c->results, c->asked.target, c->i).short_loads;
}

/* ---- Verdicts ---- */

/** A surface's measurement, and how far the model is from it. */
static bool measured(struct claims *c)
{
    if (!results_measured(c->results, c->i))
        return false;
    const struct estimate *fit = &c->results->answers[c->i].fit;
    const double ends[] = {estimate_end(fit, 0), estimate_end(fit, 1)};
    const struct known factor = {.kind = KNOWN_VALUE, .value = estimate_value(fit), .low = ends[0], .high = ends[1]};
    put_number(c, "factor", factor.value, factor.value, known_digits(&factor), "");
    if (isfinite(ends[0]) && isfinite(ends[1])) /* a single point has none */
        put_shown(c, "interval", json_numbers(ends, 2), ends, known_digits(&factor), "");
    put_quantity(c, false, results_measured_quantity(c->results));
    c->key = known_value(c->results, c->asked.quantity, c->i).measured ? "measured" : "measured-beside";
    c->key = fit->count > 0 ? c->key : "measured-elsewhere";
    return true;
}

static bool not_flat(struct claims *c)
{
    if (!results_measured(c->results, c->i))
        return false;
    const struct measured_exponent *exponent = &c->results->answers[c->i].exponent;
    put(c, "exponent", exponent->measured);
    put(c, "model", exponent->model);
    return exponent->not_flat;
}

/** Does the ranking agree with the table? Not where it is by another quantity, gaps carry heat too, a number there is
 * measured or a bound, or a surface that is not ranked, as its scatter is unknown, is better than the first. */
static bool ranking_holds(const struct claims *c)
{
    const struct comparison *ranking = c->comparison;
    const bool rises = quantity_rows[ranking->criterion].is & QUANTITY_RISES;
    const unsigned made_of = quantity_rows[c->asked.quantity].from | QUANTITY_BIT(c->asked.quantity);
    bool holds = ranking->count > 1 && !gaps_conduct(c) && (made_of & QUANTITY_BIT(ranking->criterion));
    for (size_t k = 0; holds && k < c->results->usable_count; k++) {
        const double value = answer(c, usable(c, k), ranking->criterion),
                     best = answer(c, ranking->surface[0], ranking->criterion);
        const struct known known = known_value(c->results, c->asked.quantity, usable(c, k));
        holds = !known.measured && known.kind <= KNOWN_VALUE && !(rises ? value > best : value < best);
    }
    return holds;
}

/** Do the surfaces differ significantly? */
static bool rank(struct claims *c)
{
    const struct comparison *ranking = c->comparison;
    struct named like = {0};
    double p = 1; /* the least of those alike */
    if (!ranking_holds(c))
        return false;
    for (size_t j = 1; j < ranking->count; j++) {
        const struct comparison_pair *pair = comparison_pair_of(ranking, 0, j);
        if (comparison_told_apart(pair))
            continue;
        p = fmin(p, pair->p);
        add_name(&like, ranking->surface[j]);
    }
    p = like.count > 0 ? p : comparison_pair_of(ranking, 0, 1)->p;
    put_quantity(c, quantity_of_joint(ranking->criterion), ranking->criterion);
    put_surface(c, ranking->surface[0]);
    put_text(c, "next", name_of(c, ranking->surface[1]));
    (void)put_names(c, &like);
    json_set(c->numbers, "p", p);
    OWNED(text_free) struct text shown = {0};
    text_add(&shown, p < 0.01 ? "<\u00a0" : like.count > 1 ? "≥\u00a0" : "=\u00a0");
    number_format(&shown, fmin(fmax(p, 0.01), like.count > 1 ? 0.99 : 1), 2);
    put_text(c, "p", text_string(&shown));
    c->key = like.count == 0 ? "best" : like.count > 1 && like.count + 1 == ranking->count ? "same" : "same-some";
    return true;
}

/** A target beside the first: its load on the surface that needs the least. */
static bool further_target(struct claims *c)
{
    const struct scene_asked *target = &c->results->scene->targets[c->i];
    const size_t on = best_or_worst(c, target, false);
    const struct known load = known_load(c->results, target, on);
    put_asked(c, target);
    if (isinf(cost_of(c, target, on)))
        c->key = "target-never";
    else if (put_known(c, target, on)) {
        put(c, "load", load.value);
        if (isfinite(load.low) || isfinite(load.high))
            json_set_all(c->numbers, "interval", (const double[]){load.low, load.high}, 2);
    }
    return target != c->asked.target;
}

/** A limit that the table has no column for, with the surfaces of each verdict. */
static bool further_limit(struct claims *c)
{
    static const struct {
        const char *words;
        enum limit_verdict verdict;
    } parts[] = {
        {"missed", LIMIT_MISSED}, {"undecided", LIMIT_UNDECIDED}, {"no-value", LIMIT_NO_VALUE}, {"met", LIMIT_MET}};
    put_asked(c, &c->results->scene->limits[c->i]);
    for (size_t v = 0; v < sizeof parts / sizeof *parts; v++) {
        struct named on = {0};
        for (size_t k = 0; k < c->results->usable_count; k++)
            if (summary_of(c, usable(c, k))->limits[c->i].verdict == parts[v].verdict)
                add_name(&on, usable(c, k));
        if (!put_names(c, &on))
            continue;
        put_more(c, "parts",
                 words_say(c->words, "verdict.%s\nnames\t%s", parts[v].words,
                           json_string_value(json_object_get(c->told, "names"))));
        c->weight = parts[v].verdict == LIMIT_MISSED ? 2 : c->weight; /* first of the verdicts */
    }
    return c->i >= ASKED_LIMIT_COLUMNS;
}

/** How many more scans make an interval in ln narrower than `distance` to either side, from the standard deviation of
 * one scan and the model's own; 0: more than SCANS_MOST in all. */
static size_t more_scans(double sd, double own, double distance, size_t scans)
{
    for (size_t n = scans + 1; n <= SCANS_MOST; n++) {
        const double s = sd / sqrt((double)n), both = hypot(s, own);
        if (interval_quantile(estimate_level, (double)(n - 1) * pow(both / s, 4)) * both < distance)
            return n - scans;
    }
    return 0;
}

/** The first undecided limit that more scans of the surface would decide. */
static bool scans_to_decide(struct claims *c)
{
    const struct surface_summary *s = summary_of(c, c->i);
    const double around_K = c->results->scene->joint.temperature_K;
    size_t more = 0;
    for (size_t l = 0; l < c->results->scene->limit_count && more == 0; l++) {
        const struct scene_asked *limit = &c->results->scene->limits[l];
        const double value = s->limits[l].value;
        const bool heats = limit->quantity == QUANTITY_TEMPERATURE; /* whose scatter is that of its voltage */
        const struct estimate *known = results_estimate(c->results, c->i, heats ? QUANTITY_VOLTAGE : limit->quantity);
        const double sd = known->count > 1 ? known->sd : known->s,
                     ratio = heats ? heating_voltage(value, around_K) / heating_voltage(limit->value, around_K)
                                   : value / limit->value;
        if (s->limits[l].verdict == LIMIT_UNDECIDED && sd > 0 && !s->has_map &&
            !known_value(c->results, limit->quantity, c->i).measured)
            more = more_scans(sd, known->model_sd, fabs(log(ratio)), s->scans);
    }
    put_count(c, "scans", more);
    return more > 0;
}

/* ---- How far the answer may be off ---- */

/** The factor to the farther end of a modelled answer's interval, as a bound may cut the other; NaN: it has none. */
static double factor_on(const struct claims *c, size_t surface)
{
    const struct known known = known_value(c->results, c->asked.quantity, surface);
    const bool has = !known.measured && isfinite(known.low * known.high);
    return has ? fmax(known.high / known.value, known.value / known.low) : NAN;
}

/** The standard deviation of ln the answer from too few of the longest waves in a surface's scans: its part of the
 * model's. */
static double waves_sd(const struct claims *c, size_t surface)
{
    const double few = accuracy_few_waves_sd(c->results, surface),
                 own = model_sd(model_rows[c->leading], c->asked.quantity, surface_knows_both(summary_of(c, surface)));
    const struct known known = known_value(c->results, c->asked.quantity, surface);
    const double of_answer = results_estimate(c->results, surface, c->asked.quantity)->model_sd;
    if (!(few > 0) || model_rows[c->leading]->uses_map || nothing_touches(c, surface) || known.measured ||
        known.kind == KNOWN_NOTHING)
        return 0;
    return of_answer > 0 ? of_answer * few / hypot(few, own) : quantity_of_joint(c->asked.quantity) ? 0 : few;
}

/** The widest interval of a modelled answer, and what part of its variance each cause has. */
static bool uncertainty(struct claims *c)
{
    static const char *const names[] = {"model", "scans", "waves"};
    const struct extent factor = extent_of(c, factor_on, INFINITY);
    if (!(factor.most >= 1.05)) /* of which two digits would be 1.0 */
        return false;
    const size_t surface = factor.at_most;
    const char *const scans = !summary_of(c, surface)->has_map   ? names[1]
                              : model_rows[c->leading]->uses_map ? "map"
                                                                 : "row";
    const struct estimate *known = results_estimate(c->results, surface, c->asked.quantity);
    const bool low_pass = c->results->surfaces[surface].tiles.def.cutoff > 0;
    const double waves = pow(waves_sd(c, surface), 2);
    const double variance[] = {known->model_sd * known->model_sd - waves, known->s * known->s, waves},
                 all = variance[0] + variance[1] + waves;
    for (int n = 0; n < 3; n++) {
        put(c, names[n], variance[n] / all);
        if (variance[n] >= 0.03 * all)
            put_more(c, "parts",
                     words_say(c->words, "cause.%s\npercent %.0f\n%s", n == 1 ? scans : names[n],
                               100 * variance[n] / all, low_pass ? "low_pass" : "none"));
    }
    put(c, "factor", c->weight = factor.most);
    put_surface(c, surface);
    return true;
}

static bool not_flat_assumed(struct claims *c)
{
    const struct results *results = c->results;
    const struct surface_record *record = &results->surfaces[c->i];
    const enum quantity asked = c->asked.quantity;
    const int way = asked == QUANTITY_ECR || asked == QUANTITY_JOINT_ECR ? JOINT_CURRENT : JOINT_HEAT;
    const struct joint_task joint = {&results->scene->joint, &record->summary.pair,
                                     .nominal_area_m2 = results->scene->nominal_area_m2,
                                     .effects = results->plan->running};
    if ((way == JOINT_HEAT && /* gaps that conduct need loads far below those of the report */
         ((runs(c, EFFECT_GAP) && !(answer(c, c->i, QUANTITY_GAP) < 0.01 * answer(c, c->i, QUANTITY_JOINT))) ||
          (asked != QUANTITY_TCR && asked != QUANTITY_JOINT))) ||
        known_value(results, asked, c->i).measured || runs(c, EFFECT_SHAPE) || !(joint.nominal_area_m2 > 0) ||
        record->summary.pair.unknown || !record->curves || !record->curves[c->leading].exists)
        return false;
    c->weight = shaped_usual_factor(&record->curves[c->leading], model_rows[c->leading], &joint,
                                    results_operating_load(results, c->i), way);
    if (results->usable_count > 1) /* each has its own */
        put_surface(c, c->i);
    put(c, "factor", c->weight);
    put(c, "bulge", shaped_usual_flatness * sqrt(joint.nominal_area_m2));
    put(c, "side", sqrt(joint.nominal_area_m2));
    return c->weight >= 1.05;
}

/** What the model's error would be with scans in a second direction, where a surface lacks them. */
static bool one_direction(struct claims *c)
{
    const struct model_row *leading = model_rows[c->leading];
    const double one = model_factor(model_sd(leading, c->asked.quantity, false)),
                 two = model_factor(model_sd(leading, c->asked.quantity, true));
    bool some = false;
    for (size_t k = 0; k < c->results->usable_count; k++)
        some = some || (!summary_of(c, usable(c, k))->has_lay && isfinite(factor_on(c, usable(c, k))));
    c->weight = one / two;
    put(c, "one", one);
    put(c, "two", two);
    return some && one >= 1.1 * two && !gaps_conduct(c) && !runs(c, EFFECT_SHAPE); /* with a hardness it is little */
}

/** The same of a map that is solved itself, whose interval is of maps of its size. */
static double map_waves_sd(const struct claims *c, size_t surface)
{
    const struct known known = known_value(c->results, c->asked.quantity, surface);
    return nothing_touches(c, surface) || known.measured || known.kind == KNOWN_NOTHING
               ? 0
               : fmax(0, accuracy_few_waves_sd(c->results, surface));
}

static bool short_scans(struct claims *c)
{
    const bool map = model_rows[c->leading]->uses_map;
    const struct extent sd = extent_of(c, map ? map_waves_sd : waves_sd, INFINITY);
    c->weight = model_factor(sd.most);
    put(c, "waves", summary_of(c, sd.at_most)->longest_waves);
    if (!map)
        put(c, "factor", c->weight);
    put_surface(c, sd.at_most);
    return c->weight >= 1.1;
}

/* ---- What stands beside the answer ---- */

static bool direct(struct claims *c)
{
    const enum quantity asked = c->asked.quantity,
                        quantity = quantity_rows[asked].from ? results_criterion(c->results) : asked;
    const struct asked_solved solved = asked_direct(c->results, quantity, results_operating_load(c->results, c->i));
    if (!(solved.value > 0) || !(solved.ratio > 0) || nothing_touches(c, c->i))
        return false;
    const bool own = quantity == asked || (quantity == QUANTITY_ECR && asked == QUANTITY_JOINT_ECR);
    const struct quantity_unit unit = quantity_unit(quantity);
    const double value[] = {solved.value, solved.value * solved.ratio};
    static const char *const names[] = {"direct", "model"};
    put_surface(c, c->i);
    put_quantity(c, own, quantity);
    for (int k = 0; k < 2; k++)
        put_number(c, names[k], value[k], own ? asked_shown(&c->asked, value[k]) : value[k] * unit.scale, 2,
                   own ? c->asked.unit : unit.unit);
    put_load(c, "load", c->i, solved.load, 3);
    return true;
}

static bool textbook(struct claims *c)
{
    const size_t book = asked_textbook(c->results);
    if (book == model_count || book == c->leading || nothing_touches(c, c->i))
        return false;
    put_text(c, "label", model_rows[book]->label);
    put_surface(c, c->i);
    if (c->asked.target) {
        const struct answer *load = answer_of(c, c->i, book);
        put_load(c, "value", c->i, load->load, 3);
        return load->kind == ANSWER_LOAD && !load->most && !load->invalid;
    }
    const double value = comparison_middle(c->results, book, c->i).value[c->asked.quantity];
    put_number(c, "value", value, asked_shown(&c->asked, value), 3, c->asked.unit);
    return isfinite(value) && known_value(c->results, c->asked.quantity, c->i).kind <= KNOWN_VALUE &&
           curve_summary_is_valid(surface_model(summary_of(c, c->i), book), results_operating_load(c->results, c->i));
}

/** Is the roughest surface rougher than the smoothest by two standard deviations? The mean square of w longest waves
 * has the relative standard deviation 1/sqrt(w), ln Rq half of it. */
static bool differ_in_roughness(const struct results *results)
{
    const size_t ends[] = {results->by_roughness[0], results->by_roughness[results->usable_count - 1]};
    double ln_rq[2], variance = 0;
    for (int k = 0; k < 2; k++) {
        const struct surface_summary *summary = &results->surfaces[ends[k]].summary;
        ln_rq[k] = log(summary->roughness.rq_m);
        variance += 0.25 / (fmax(summary->longest_waves, 1) * fmax(summary->independent, 1));
    }
    return ln_rq[1] - ln_rq[0] > 2 * sqrt(variance);
}

/** A model's answer on usable surface k; NaN also where the answer shown is but a bound. */
static double modelled(const struct claims *c, size_t model, size_t k)
{
    const bool bound = known_value(c->results, c->asked.quantity, usable(c, k)).kind > KNOWN_VALUE;
    return bound ? NAN : comparison_middle(c->results, model, usable(c, k)).value[c->asked.quantity];
}

/** The last over the first of a model's answers in order of roughness; negative: not each is above the one before. 0: a
 * surface has none. */
static double rise_of(const struct claims *c, size_t m)
{
    double first = NAN, before = 0;
    bool rises = true;
    for (size_t k = 0; k < c->results->usable_count; k++) {
        const double value = asked_shown(&c->asked, modelled(c, m, k));
        if (!(value > 0 && isfinite(value)))
            return 0;
        first = k == 0 ? value : first;
        rises = rises && value > before * (1 + c->results->scene->tolerance);
        before = value;
    }
    return rises ? before / first : -1;
}

/** The model whose answer rises most with roughness, and those whose answer does not rise at every step, where the
 * thesis's models run on three surfaces or more. Models of the leading one's material law alone: an elastic answer on a
 * surface that yields proves nothing. */
static bool by_roughness(struct claims *c)
{
    const size_t count = c->results->usable_count;
    size_t steepest = model_count;
    double most = 0;
    bool all = count >= 3 && differ_in_roughness(c->results) && scene_has_one_pair(c->results->scene, false);
    for (size_t m = 0; all && m < model_count; m++) {
        const struct model_row *row = model_rows[m];
        all = row->thesis_place == 0 || plan_runs_model(c->results->plan, m);
        if ((row->thesis_place == 0 && m != c->leading) || row->plastic != model_rows[c->leading]->plastic)
            continue;
        const double rise = rise_of(c, m);
        if (rise < 0)
            put_more(c, "others", row->label);
        steepest = rise > most ? m : steepest;
        most = fmax(rise, most);
    }
    if (!all || steepest == model_count || !json_object_get(c->told, "others"))
        return false;
    const double ends[] = {modelled(c, steepest, 0), modelled(c, steepest, count - 1)},
                 shown[] = {asked_shown(&c->asked, ends[0]), asked_shown(&c->asked, ends[1])};
    put_text(c, "label", model_rows[steepest]->label);
    put_quantity(c, true, 0);
    put_shown(c, "values", json_numbers(ends, 2), shown, 2, c->asked.unit);
    return true;
}

/** What the row's effect makes of the answer on a surface, in the unit of its words; NaN: nothing. */
static double share_of(const struct claims *c, size_t surface)
{
    const struct scene *scene = c->results->scene;
    const enum effect effect = c->row->effect;
    const bool touches = !nothing_touches(c, surface); /* else bond-line says it */
    const double carrying = summary_of(c, surface)->carrying, area = answer(c, surface, QUANTITY_AREA);
    /* of a measured number its part is not known */
    if (effect == EFFECT_GAP && touches && !known_value(c->results, QUANTITY_JOINT, surface).measured)
        return 100 * answer(c, surface, QUANTITY_GAP) / answer(c, surface, QUANTITY_JOINT);
    if (effect == EFFECT_FILM && !known_value(c->results, QUANTITY_VOLTAGE, surface).measured)
        return 100 * scene->joint.film_ohm_m2 / area / answer(c, surface, QUANTITY_JOINT_ECR);
    if (effect == EFFECT_PLATING)
        return answer(c, surface, QUANTITY_PLATING_FACTOR);
    if (effect == EFFECT_SHAPE && touches && carrying > 0)
        return 1e6 * carrying * scene->nominal_area_m2;
    if (effect == EFFECT_HEATING && !molten(c, surface) &&
        known_value(c->results, QUANTITY_TEMPERATURE, surface).kind <= KNOWN_VALUE)
        return known_value(c->results, QUANTITY_TEMPERATURE, surface).value - scene->joint.temperature_K;
    return NAN;
}

/** How much of the answer an effect makes, from the least to the most: of surfaces that are named, else only of all. */
static bool share(struct claims *c)
{
    const struct extent extent = extent_of(c, share_of, INFINITY);
    const bool near_one = fabs(extent.least - 1) < 0.05 && fabs(extent.most - 1) < 0.05; /* not "by 1.0" */
    const double ends[] = {extent.least, extent.most};
    put_shown(c, "share", json_numbers(ends, 2), ends, near_one && c->row->effect == EFFECT_PLATING ? 3 : 2, "");
    (void)put_names(c, &extent.on);
    put(c, "nominal", c->results->scene->nominal_area_m2);
    put(c, "current", c->results->scene->joint.current_A);
    const bool named = c->row->effect == EFFECT_GAP || c->row->effect == EFFECT_FILM, shaped = runs(c, EFFECT_SHAPE);
    return runs(c, c->row->effect) && extent.most > 0 &&
           (named ? !shaped : extent.on.count == c->results->usable_count);
}

/** The model that `accuracy` chose. */
static bool chosen(struct claims *c)
{
    const struct scene *scene = c->results->scene;
    const double factor =
        model_factor(model_sd(model_rows[c->leading], c->asked.quantity, surface_knows_both(summary_of(c, c->i))));
    c->key = factor - 1 <= scene->accuracy ? "chosen" : "chosen-nearest";
    put_text(c, "label", model_rows[c->leading]->label);
    put(c, "accuracy", scene->accuracy);
    put(c, "factor", factor);
    return scene->chosen_sd > 0 && !(accuracy_few_waves_sd(c->results, c->i) > 0);
}

/** Whose hardness counts, where there is a plating that may have its own. */
static bool hardness(struct claims *c)
{
    static const char *const whose[] = {[SURFACE_HARDNESS_BODIES] = "bodies",
                                        [SURFACE_HARDNESS_SCENE] = "scene",
                                        [SURFACE_HARDNESS_PLATING] = "plating"};
    const struct surface_summary *s = summary_of(c, c->i);
    struct named on = {0};
    for (size_t k = 0; k < c->results->usable_count; k++)
        if (summary_of(c, usable(c, k))->hardness == s->hardness &&
            summary_of(c, usable(c, k))->pair.hardness_Pa == s->pair.hardness_Pa)
            add_name(&on, usable(c, k));
    put_text(c, "whose", words_say(c->words, "hardness.%s", whose[s->hardness]));
    put(c, "hardness", s->pair.hardness_Pa);
    return put_names(c, &on) && c->results->scene->joint.plating_thickness_m > 0 && runs(c, EFFECT_PLASTICITY);
}

/** Files with the same heights as an earlier one, which are no further evidence. */
static bool duplicates(struct claims *c)
{
    for (size_t i = 0; i < c->results->surface_count; i++)
        for (size_t n = 0; summary_of(c, i)->usable && n < summary_of(c, i)->notes.count; n++) {
            const struct note *note = &summary_of(c, i)->notes.notes[n];
            if (!note->subject || strncmp(note->what, "note.copy\n", strlen("note.copy\n")) != 0)
                continue;
            if (!c->surface) {
                c->surface = json_shown(name_of(c, i));
                put_text(c, "file", note->subject);
            } else
                c->others++;
            c->others += note->more;
        }
    return c->surface;
}

/** Keys of the scene that a user's own part needs, where they are missing. */
static bool needs(struct claims *c)
{
    const bool material = results_has_material(c->results);
    c->key = material ? "needs" : "needs-material";
    return !material || !c->results->scene->path;
}

/* ---- The table ---- */

static const char stop[] = "stop", verdict[] = "verdict", unsure[] = "uncertainty", context[] = "context";

static const struct claim_row rows[] = {
    {"refused", stop, .when = refused},
    {"beyond-hardness", stop, beyond_hardness, .about = ABOUT_SURFACES},
    {"few-spots", stop, .when = few_spots},
    {"softens", stop, heated, .about = ABOUT_SURFACES},
    {"melts", stop, heated, .about = ABOUT_SURFACES, .melts = true},
    {"bond-line", stop, bond_line, .about = ABOUT_SURFACES},
    {"loads-short", stop, loads_short, .about = ABOUT_SURFACES},
    {"measured", verdict, measured, .about = ABOUT_SURFACES},
    {"not-flat", verdict, not_flat, .about = ABOUT_SURFACES},
    {"rank", verdict, .when = rank},
    {"target", verdict, further_target, .about = ABOUT_TARGETS},
    {"limit", verdict, further_limit, .about = ABOUT_LIMITS},
    {"scans-to-decide", verdict, scans_to_decide, .about = ABOUT_SURFACES},
    {"uncertainty", unsure, .when = uncertainty},
    {"not-flat-assumed", unsure, .when = not_flat_assumed},
    {"one-direction", unsure, .when = one_direction},
    {"short-scans", unsure, .when = short_scans},
    {"direct", context, .when = direct},
    {"textbook", context, .when = textbook},
    {"by-roughness", context, .when = by_roughness},
    {"shares-gap", context, share, .effect = EFFECT_GAP},
    {"shares-film", context, share, .effect = EFFECT_FILM},
    {"shares-plating", context, share, .effect = EFFECT_PLATING},
    {"shares-shape", context, share, .effect = EFFECT_SHAPE},
    {"heating", context, share, .effect = EFFECT_HEATING},
    {"chosen", context, .when = chosen},
    {"hardness", context, .when = hardness},
    {"duplicates", context, .when = duplicates},
    {"needs", context, .when = needs},
};

static struct claims begin(const struct results *results, const struct comparison *comparison, struct words *words)
{
    return (struct claims){.results = results,
                           .comparison = comparison,
                           .words = words,
                           .asked = asked_of(results),
                           .leading = plan_leading_model(results->plan)};
}

/** Begins the next claim; NULL: there is none. */
static void start(struct claims *c, const struct claim_row *row, size_t i)
{
    json_decref(c->numbers);
    json_decref(c->surface);
    json_decref(c->told);
    text_free(&c->text);
    text_free(&c->markdown);
    c->row = row;
    c->key = row ? row->key : "";
    c->i = i;
    c->weight = 1;
    c->others = 0;
    c->numbers = row ? json_object() : NULL;
    c->told = row ? json_object() : NULL;
    c->surface = NULL;
    if (row && row->about == ABOUT_SURFACES)
        put_surface(c, i);
}

/** Adds the words of a name to both texts. */
static bool add_words(struct claims *c, const char *name)
{
    json_auto_t *view = json_copy(c->told);
    json_object_update_missing(view, c->numbers);
    return words_fill(&c->text, c->words, name, view, text_add_unmarked) &&
           words_fill(&c->markdown, c->words, name, view, text_add_markdown_shown);
}

static void add_both(struct claims *c, const char *string)
{
    text_add(&c->text, "%s", string);
    text_add(&c->markdown, "%s", string);
}

/** Says of how many others a claim holds that names one, where it stops at one surface. */
static void add_others(struct claims *c)
{
    struct claims other = begin(c->results, c->comparison, c->words);
    for (size_t i = c->i + 1; i < c->results->surface_count && c->row->level == stop && c->row->about == ABOUT_SURFACES;
         i++) {
        start(&other, c->row, i);
        c->others += c->results->surfaces[i].summary.usable && c->row->when(&other) && strcmp(other.key, c->key) == 0;
    }
    start(&other, NULL, 0);
    if (c->others == 0)
        return;
    put_count(c, "others", c->others);
    add_both(c, " ");
    (void)add_words(c, "claims.others");
}

/** Puts the claim behind those of its level with as much weight or more; one that weighs more than `most` goes first of
 * all. */
static void insert(json_t *list, const struct claims *c, double most)
{
    size_t at = json_array_size(list);
    const char *level = "";
    double weight = 0;
    while (at > 0 && json_unpack(json_array_get(list, at - 1), "{s:s, s:f}", "level", &level, "weight", &weight) == 0 &&
           strcmp(level, c->row->level) == 0 && c->weight > weight)
        at--;
    json_array_insert_new(list, c->weight > most ? 0 : at,
                          json_pack("{s:s, s:s, s:O?, s:O, s:s, s:s, s:f}", "key", c->key, "level", c->row->level,
                                    "surface", c->surface, "numbers", c->numbers, "text", text_string(&c->text),
                                    "markdown", text_string(&c->markdown), "weight", fmin(c->weight, DBL_MAX)));
}

enum status_code claims_make(json_t **out, const struct results *results, const struct comparison *comparison,
                             struct words *words, struct status *status)
{
    struct claims c = begin(results, comparison, words);
    const size_t ends[] = {[ABOUT_BASELINE] = results->baseline + 1,
                           [ABOUT_SURFACES] = results->surface_count,
                           [ABOUT_TARGETS] = results->scene->target_count,
                           [ABOUT_LIMITS] = results->scene->limit_count};
    double interval = INFINITY;
    *out = json_array();
    for (const struct claim_row *row = rows; row < rows + sizeof rows / sizeof *rows; row++) {
        const bool surfaces = row->about == ABOUT_SURFACES;
        bool said = false;
        for (size_t i = row->about == ABOUT_BASELINE ? results->baseline : 0; i < ends[row->about]; i++) {
            char name[80];
            if (surfaces && (said || !results->surfaces[i].summary.usable))
                continue;
            start(&c, row, i);
            said = row->when(&c) && snprintf(name, sizeof name, "claim.%s", c.key) > 0 && add_words(&c, name);
            if (!said)
                continue;
            add_others(&c);
            text_strip_marks(&c.text);
            insert(*out, &c, row->when == not_flat_assumed ? interval : INFINITY);
            interval = row->when == uncertainty ? c.weight : interval;
        }
    }
    start(&c, NULL, 0);
    for (size_t i = 0; i < json_array_size(*out); i++)
        json_object_del(json_array_get(*out, i), "weight");
    return *out ? status->code : status_memory(status);
}

/* ---- The headline ---- */

/** One surface's part, behind `before`: "*as plated* needs 0.97 N (measured)". */
static bool add_part(struct claims *c, const char *before, size_t surface)
{
    const bool known = put_known(c, c->asked.target, surface);
    add_both(c, before);
    return add_words(c, c->asked.target ? known ? "headline.load-is" : "headline.load-never"
                        : known         ? "headline.value-is"
                                        : "headline.value-never");
}

enum status_code claims_headline(json_t **out, const struct results *results, const struct comparison *comparison,
                                 struct words *words, struct status *status)
{
    struct claims c = begin(results, comparison, words);
    const char *const name = c.asked.target ? "headline.load" : "headline.value";
    size_t ends[] = {best_or_worst(&c, c.asked.target, false), best_or_worst(&c, c.asked.target, true)};
    if (ends[0] == ends[1] && results->usable_count > 1) /* all alike: the first and the last */
        ends[1] = usable(&c, results->usable_count - 1);
    start(&c, rows, 0);
    if (c.asked.target)
        put_asked(&c, c.asked.target);
    put_quantity(&c, true, 0);
    put_load(&c, "load", results->baseline, results_operating_load(results, results->baseline), 3);
    *out = NULL;
    if (add_words(&c, name) && add_part(&c, " ", ends[0]) && (ends[1] == ends[0] || add_part(&c, " and ", ends[1]))) {
        add_both(&c, ".**");
        text_strip_marks(&c.text);
        *out = json_pack("{s:s, s:s}", "text", text_string(&c.text), "markdown", text_string(&c.markdown));
    }
    start(&c, NULL, 0);
    return *out ? status->code : status_memory(status);
}
