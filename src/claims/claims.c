/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "claims/claims.h"

#include "answers/direct_study.h"
#include "answers/shaped.h"
#include "base/number_format.h"
#include "joint/heating.h"
#include "output/record.h"
#include "results/accuracy.h"
#include "results/known.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { NAMED = 2 /* surfaces that one claim names */, SCANS_MOST = 50 /* that are worth advising */ };

/** A claim that is being made, and the list it goes to. */
struct claims {
    const struct results *results;
    const struct comparison *comparison;
    struct words *words;
    struct asked asked;
    size_t leading;
    const char *key; /* of the row, or of one of its variants */
    size_t i;        /* of those that the row says one after another */
    double weight;   /* a factor: within a level the largest comes first */
    json_t *numbers, *surface;
    struct text told; /* what its words are filled with, as words_add() takes it */
    struct text text, markdown;
};

/* ---- Putting one together ---- */

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

static void put_text(struct claims *c, const char *name, const char *string)
{
    text_add(&c->told, "\n%s ", name);
    text_add_shown(&c->told, string);
}

static void put_number(struct claims *c, const char *name, double value, double shown, int digits, const char *unit)
{
    struct text text = {0};
    json_set(c->numbers, name, value);
    number_format(&text, shown, digits);
    if (unit[0])
        text_add(&text, "\u00a0%s", unit);
    put_text(c, name, text_string(&text));
    text_free(&text);
}

static void put_count(struct claims *c, const char *name, size_t count)
{
    json_object_set_new(c->numbers, name, json_integer((json_int_t)count));
    text_add(&c->told, "\n%s %zu", name, count);
}

static void put_load(struct claims *c, const char *name, size_t surface, double load)
{
    const struct asked_load as = asked_load_of(c->results, surface);
    put_number(c, name, load, load * as.scale, 3, as.unit[0] ? as.unit : "E′Aₙ");
}

/** "a to b", or one of them where both read alike. */
static void put_range(struct claims *c, const char *name, double least, double most, int digits, const char *unit)
{
    struct text text = {0};
    json_set_all(c->numbers, name, (const double[]){least, most}, 2);
    number_format_range(&text, least, most, digits);
    if (unit[0])
        text_add(&text, "\u00a0%s", unit);
    put_text(c, name, text_string(&text));
    text_free(&text);
}

static void put_surface(struct claims *c, size_t surface)
{
    if (!c->surface)
        c->surface = json_shown(name_of(c, surface));
    put_text(c, "name", name_of(c, surface));
}

/** At most two names, and how many more: "*a*, *b* and 3 more". */
static void put_names(struct claims *c, const size_t *surfaces, size_t count)
{
    struct text text = {0};
    for (size_t i = 0; i < count && i < NAMED; i++) {
        text_add(&text, i > 0 && count == NAMED ? " and " : i > 0 ? ", " : "");
        text_add(&text, "%s", name_of(c, surfaces[i]));
    }
    if (count > NAMED)
        text_add(&text, " and %zu more", count - NAMED);
    if (count == 1 && !c->surface)
        c->surface = json_shown(name_of(c, surfaces[0]));
    put_text(c, "names", text_string(&text));
    text_free(&text);
}

/** Of a value and its interval: two digits where that is wider than a factor 1.2 to either side. */
static int digits_of(double low, double high)
{
    return high > 1.44 * low ? 2 : 3;
}

static bool say(struct claims *c, json_t **out, const char *level)
{
    struct text later = {0};
    text_add(&later, "claim.%s%s", c->key, text_string(&c->told));
    bool said = words_add(&c->text, c->words, text_string(&later), text_add_unmarked) &&
                words_add(&c->markdown, c->words, text_string(&later), text_add_markdown_shown);
    text_strip_marks(&c->text);
    if (said)
        *out = json_pack("{s:s, s:s, s:o, s:o, s:s, s:s}", "key", c->key, "level", level, "surface",
                         c->surface ? json_incref(c->surface) : json_null(), "numbers", json_incref(c->numbers), "text",
                         text_string(&c->text), "markdown", text_string(&c->markdown));
    text_free(&later);
    return said && *out;
}

static void reset(struct claims *c, const char *key)
{
    json_decref(c->numbers);
    json_decref(c->surface);
    text_free(&c->told);
    text_free(&c->text);
    text_free(&c->markdown);
    c->key = key;
    c->weight = 1;
    c->numbers = json_object();
    c->surface = NULL;
}

/* ---- What stops a reader ---- */

static bool refused(struct claims *c)
{
    size_t files = 0, all = 0, names[NAMED] = {0}, count = 0;
    for (size_t i = 0; i < c->results->surface_count; i++) {
        const struct surface_summary *s = summary_of(c, i);
        const size_t own = s->scene->files.count + s->scene->along.count, out = s->usable ? s->refused_scans : own;
        all += own;
        files += out;
        if (out > 0 && count++ < NAMED)
            names[count - 1] = i;
    }
    if (files == 0)
        return false;
    put_count(c, "count", files);
    put_count(c, "all", all);
    put_names(c, names, count);
    return true;
}

/** Is the mean pressure where the summary stands beyond what the softer body bears? */
static bool beyond_hardness(struct claims *c)
{
    for (size_t k = 0; k < c->results->usable_count; k++) {
        const size_t i = usable(c, k);
        const struct material_pair *pair = results_pair(c->results, i);
        const double pressure_Pa = material_pair_pressure(pair, results_operating_load(c->results, i));
        if (!model_rows[c->leading]->plastic || !(pressure_Pa >= pair->hardness_Pa))
            continue;
        put_surface(c, i);
        put_number(c, "hardness", pair->hardness_Pa, pair->hardness_Pa * 1e-6, 3, "MPa");
        put_number(c, "pressure", pressure_Pa, pressure_Pa * 1e-6, 3, "MPa");
        return true;
    }
    return false;
}

/** Spots where the answer stands, by the model's own count or by spots all alike that have its area and resistance, the
 * fewer; at another load than the summary's as many more as that is larger. NaN: nothing counts them. */
static double spots_on(const struct claims *c, size_t surface)
{
    const struct contact_point at = comparison_middle(c->results, c->leading, surface);
    const struct material_pair *pair = results_pair(c->results, surface);
    const double *value = at.value;
    const bool electrical = isfinite(value[QUANTITY_ECR]);
    const struct contact_spots alike =
        joint_equal_spots(value[QUANTITY_AREA], value[electrical ? QUANTITY_ECR : QUANTITY_TCR],
                          electrical ? pair->resistivity_ohm_m : 1 / pair->conductivity_W_per_mK);
    double per_m2 = fmin(value[QUANTITY_SPOT_DENSITY], alike.density_per_m2);
    if (c->asked.target) {
        const struct known load = known_load(c->results, c->asked.target, surface);
        const size_t t = (size_t)(c->asked.target - c->results->scene->targets);
        const double counted = summary_of(c, surface)->answers[t * model_count + c->leading].spots_per_m2;
        if (load.kind != KNOWN_VALUE && load.kind != KNOWN_AT_MOST)
            return NAN;
        per_m2 = fmin(counted, per_m2 * load.value / results_operating_load(c->results, surface));
    }
    return per_m2 * c->results->scene->nominal_area_m2;
}

static bool few_spots(struct claims *c)
{
    double least = INFINITY, most = 0;
    size_t names[NAMED] = {0}, count = 0;
    for (size_t k = 0; k < c->results->usable_count; k++) {
        const double spots = spots_on(c, usable(c, k));
        if (!(spots < answers_least_spots))
            continue;
        least = fmin(least, spots);
        most = fmax(most, spots);
        if (count++ < NAMED)
            names[count - 1] = usable(c, k);
    }
    if (count == 0)
        return false;
    if (most < 1)
        c->key = "few-spots-one";
    put_range(c, "spots", fmax(least, 1), fmax(most, 1), 2, "");
    put_names(c, names, count);
    return true;
}

static bool heated(struct claims *c, bool melts)
{
    for (size_t k = 0; k < c->results->usable_count; k++) {
        const size_t i = usable(c, k);
        const struct scene_bodies *bodies = &summary_of(c, i)->scene->bodies;
        const bool other = bodies->counterface_kind == MATERIAL_COUNTERFACE_ELASTIC &&
                           bodies->counterface.yield_strength_Pa < bodies->material.yield_strength_Pa;
        const struct material *metal = other ? &bodies->counterface : &bodies->material;
        const struct heating_metal *stands = heating_metal_find(metal->name);
        const double voltage_V = comparison_middle(c->results, c->leading, i).value[QUANTITY_VOLTAGE];
        if (!stands || !isfinite(voltage_V))
            continue;
        const double melting_V = heating_voltage(stands->melting_K, c->results->scene->joint.temperature_K),
                     soft_V = stands->softening_voltage_V;
        if (melts ? !(voltage_V >= melting_V) : !(voltage_V >= soft_V && voltage_V < melting_V))
            continue;
        const double limit_V = melts ? melting_V : soft_V;
        put_number(c, "voltage", voltage_V, voltage_V, 2, "V");
        put_number(c, "limit", limit_V, limit_V, 2, "V");
        put_number(c, "current", c->results->scene->joint.current_A, c->results->scene->joint.current_A, 3, "A");
        put_text(c, "metal", metal->name);
        put_surface(c, i);
        return true;
    }
    return false;
}

static bool softens(struct claims *c)
{
    return heated(c, false);
}

static bool melts(struct claims *c)
{
    return heated(c, true);
}

/** Does a medium fill the gaps? */
static bool has_medium(const struct claims *c)
{
    return plan_runs(c->results->plan, EFFECT_GAP) && c->results->scene->joint.fill == JOINT_MEDIUM;
}

/** Does a filler's bond line keep the metals apart where the summary stands? */
static bool nothing_touches(const struct claims *c, size_t surface)
{
    return comparison_middle(c->results, c->leading, surface).value[QUANTITY_AREA] == 0;
}

static bool bond_line(struct claims *c)
{
    const struct joint *joint = &c->results->scene->joint;
    for (size_t k = 0; has_medium(c) && k < c->results->usable_count; k++) {
        if (!nothing_touches(c, usable(c, k)))
            continue;
        const double ceiling = joint->conductivity_W_per_mK / joint->bond_line_m;
        put_surface(c, usable(c, k));
        put_number(c, "line", joint->bond_line_m, joint->bond_line_m * 1e6, 3, "µm");
        put_number(c, "most", ceiling, ceiling, 2, "W/(m²·K)");
        return true;
    }
    return false;
}

static bool bond_line_missing(struct claims *c)
{
    static const double usual_m = 50e-6;
    const struct joint *joint = &c->results->scene->joint;
    if (!has_medium(c) || joint->bond_line_m > 0)
        return false;
    const double gap_m = comparison_middle(c->results, c->leading, c->results->baseline).value[QUANTITY_SEPARATION];
    put_number(c, "gap", gap_m, gap_m * 1e6, 2, "µm");
    put_number(c, "usual", usual_m, usual_m * 1e6, 2, "µm");
    put_number(c, "most", joint->conductivity_W_per_mK / usual_m, joint->conductivity_W_per_mK / usual_m, 2,
               "W/(m²·K)");
    return true;
}

static bool loads_short(struct claims *c)
{
    for (size_t k = 0; c->asked.target && k < c->results->usable_count; k++)
        if (known_load(c->results, c->asked.target, usable(c, k)).short_loads) {
            put_surface(c, usable(c, k));
            return true;
        }
    return false;
}

/* ---- Verdicts ---- */

/** A surface's measurement and what it makes of the model; only the first two surfaces. */
static bool measured_on(struct claims *c, size_t surface)
{
    const struct measured *measured = results_measured(c->results, surface);
    const struct measured_answers *answers = measured ? &c->results->answers[surface] : NULL;
    if (!measured)
        return false;
    put_surface(c, surface);
    if (answers->fit.count == 0) {
        c->key = "measured-elsewhere";
        return true;
    }
    const double factor = estimate_value(&answers->fit), low = estimate_end(&answers->fit, 0),
                 high = estimate_end(&answers->fit, 1);
    put_number(c, "factor", factor, factor, digits_of(low, high), "");
    put_range(c, "interval", isfinite(low) ? low : factor, isfinite(high) ? high : factor, digits_of(low, high), "");
    c->key =
        known_carried(c->results, results_measured_quantity(c->results), surface) == 1 ? "measured-beside" : "measured";
    const struct known load = c->asked.target && !strcmp(c->key, "measured")
                                  ? known_load(c->results, c->asked.target, surface)
                                  : (struct known){.kind = KNOWN_NOTHING};
    if (load.kind == KNOWN_VALUE && load.measured) {
        char target[UNIT_LENGTH + 20];
        asked_text(target, sizeof target, c->asked.target->text);
        put_text(c, "target", target);
        put_load(c, "load", surface, load.value);
        c->key = "measured-target";
    }
    return true;
}

static bool measured(struct claims *c)
{
    for (size_t i = 0; i < c->results->surface_count; i++)
        if (summary_of(c, i)->usable && measured_on(c, i))
            return true;
    return false;
}

static bool not_flat(struct claims *c)
{
    for (size_t i = 0; i < c->results->surface_count; i++) {
        const struct measured_exponent *exponent =
            results_measured(c->results, i) ? &c->results->answers[i].exponent : NULL;
        if (!exponent || !exponent->not_flat)
            continue;
        put_surface(c, i);
        put_number(c, "exponent", exponent->measured, exponent->measured, 2, "");
        put_number(c, "model", exponent->model, exponent->model, 2, "");
        return true;
    }
    return false;
}

/** Is the area load over hardness on all surfaces, so that they cannot differ in it? */
static bool area_pressed(struct claims *c)
{
    if (c->asked.quantity != QUANTITY_AREA || c->results->usable_count < 2)
        return false;
    for (size_t k = 0; k < c->results->usable_count; k++) {
        const struct contact_point at = comparison_middle(c->results, c->leading, usable(c, k));
        const struct material_pair *pair = results_pair(c->results, usable(c, k));
        const double ratio = material_pair_pressure(pair, at.value[QUANTITY_LOAD]) / pair->hardness_Pa;
        if (!model_area_is_pressed(model_rows[c->leading], &at, ratio))
            return false;
    }
    return true;
}

/** Does the table have a measured number of any surface, which models do not rank? */
static bool any_measured(const struct claims *c)
{
    for (size_t k = 0; k < c->results->usable_count; k++)
        if (known_value(c->results, c->asked.quantity, usable(c, k)).measured)
            return true;
    return false;
}

/** Is a surface better than the first of the ranking that is not in it, as nothing is known of its scatter? */
static bool better_unranked(const struct claims *c)
{
    const struct comparison_ranking *ranking = &c->comparison->ranking;
    const enum quantity quantity = ranking->criterion;
    const double best = comparison_middle(c->results, c->leading, ranking->surface[0]).value[quantity];
    for (size_t k = 0; k < c->results->usable_count; k++) {
        const double value = comparison_middle(c->results, c->leading, usable(c, k)).value[quantity];
        if ((quantity_rows[quantity].is & QUANTITY_RISES) ? value > best : value < best)
            return true;
    }
    return false;
}

/** Where the surfaces are not told apart by what stands in the table, or are. */
static bool rank(struct claims *c)
{
    const struct comparison_ranking *ranking = &c->comparison->ranking;
    size_t like = 0, next = 1, names[NAMED] = {0};
    if (c->results->usable_count < 2 || ranking->count < 2 || any_measured(c) || area_pressed(c) || better_unranked(c))
        return false;
    for (size_t j = 1; j < ranking->count; j++) {
        const struct comparison_pair *pair = comparison_pair_of(ranking, 0, j);
        if (!comparison_told_apart(pair)) {
            next = like == 0 ? j : next;
            if (like++ < NAMED)
                names[like - 1] = ranking->surface[j];
        } else if (like == 0 && pair->p > comparison_pair_of(ranking, 0, next)->p)
            next = j;
    }
    const double p = comparison_pair_of(ranking, 0, next)->p;
    put_text(c, "quantity", words_say(c->words, "rank.%s", quantity_rows[ranking->criterion].name));
    put_surface(c, ranking->surface[0]);
    put_text(c, "next", name_of(c, ranking->surface[next]));
    put_count(c, "count", ranking->count);
    put_names(c, names, like);
    put_number(c, "p", p, fmax(p, 1e-4), 2, "");
    c->key = like == 0 ? "best" : like + 1 < ranking->count ? "same-some" : ranking->count == 2 ? "same-two" : "same";
    return true;
}

/** The other targets' loads: the surface that each takes the least on. */
static bool further_target(struct claims *c)
{
    const struct scene_asked *target = &c->results->scene->targets[c->i];
    struct known best = {.kind = KNOWN_NOTHING, .value = INFINITY};
    size_t on = 0;
    for (size_t k = 0; target != c->asked.target && k < c->results->usable_count; k++) {
        const struct known own = known_load(c->results, target, usable(c, k));
        if ((own.kind == KNOWN_VALUE || own.kind == KNOWN_AT_MOST) && own.value < best.value) {
            best = own;
            on = usable(c, k);
        }
    }
    if (target == c->asked.target)
        return false;
    char text[UNIT_LENGTH + 20];
    asked_text(text, sizeof text, target->text);
    put_text(c, "target", text);
    put_text(c, "symbol", target->symbol);
    c->key = best.kind == KNOWN_NOTHING ? "target-never" : isnan(best.low) ? "target-alone" : "target";
    if (best.kind == KNOWN_NOTHING)
        return true;
    const double scale = asked_load_of(c->results, on).scale;
    put_surface(c, on);
    put_load(c, "load", on, best.value);
    if (!isnan(best.low))
        put_range(c, "interval", best.low * scale, best.high * scale, 2, "");
    return true;
}

static const char *const verdict_keys[] = {[LIMIT_NO_VALUE] = "limit-no-value",
                                           [LIMIT_MET] = "limit-met",
                                           [LIMIT_MISSED] = "limit-missed",
                                           [LIMIT_UNDECIDED] = "limit-undecided"};

/** The limits that the table has no column for: by how many surfaces they are missed, else undecided, else met. */
static bool further_limit(struct claims *c)
{
    const size_t l = c->i + ASKED_LIMIT_COLUMNS;
    static const enum limit_verdict order[] = {LIMIT_MISSED, LIMIT_UNDECIDED, LIMIT_NO_VALUE, LIMIT_MET};
    const struct scene_asked *limit = &c->results->scene->limits[l];
    char text[4 * UNIT_LENGTH], unit[UNIT_LENGTH + 20];
    asked_text(unit, sizeof unit, limit->text);
    snprintf(text, sizeof text, "%s %s %s", limit->symbol, limit->is_most ? "≤" : "≥", unit);
    for (size_t o = 0; o < sizeof order / sizeof *order; o++) {
        size_t names[NAMED] = {0}, count = 0;
        for (size_t k = 0; k < c->results->usable_count; k++)
            if (summary_of(c, usable(c, k))->limits[l].verdict == order[o] && count++ < NAMED)
                names[count - 1] = usable(c, k);
        if (count == 0)
            continue;
        c->key = verdict_keys[order[o]];
        put_text(c, "limit", text);
        put_count(c, "count", count);
        put_names(c, names, count);
        return true;
    }
    return false;
}

/** Scans of a surface beyond those there are, after which an interval of this standard deviation of one scan, and of a
 * model's own error, is shorter than a distance; 0: so many as are worth advising do not do it. */
static size_t more_scans(double sd, double own, double distance, size_t scans)
{
    for (size_t n = scans + 1; n <= SCANS_MOST; n++) {
        const double s = sd / sqrt((double)n), both = hypot(s, own);
        if (interval_quantile(estimate_level, (double)(n - 1) * pow(both / s, 4)) * both < distance)
            return n - scans;
    }
    return 0;
}

/** Of what decides: a limit that is not decided, on the first surface that more scans would tell. */
static bool scans_to_decide(struct claims *c)
{
    for (size_t l = 0; l < c->results->scene->limit_count; l++)
        for (size_t k = 0; k < c->results->usable_count; k++) {
            const struct surface_summary *s = summary_of(c, usable(c, k));
            const struct limit_check *check = &s->limits[l];
            const struct scene_asked *limit = &c->results->scene->limits[l];
            const struct estimate *known = curve_summary_estimate(surface_model(s, c->leading), (int)limit->quantity);
            const double sd = known->count > 1 ? known->sd : known->s;
            if (check->verdict != LIMIT_UNDECIDED || !(sd > 0) || s->has_tiles)
                continue;
            const size_t more = more_scans(sd, known->model_sd, fabs(log(check->value / limit->value)), s->scans);
            if (more == 0)
                continue;
            put_count(c, "scans", more);
            put_surface(c, usable(c, k));
            return true;
        }
    return false;
}

/* ---- How far the answer may be off ---- */

/** What is known of the asked quantity of a surface by the leading model. */
static const struct estimate *estimate_on(const struct claims *c, size_t surface)
{
    return curve_summary_estimate(surface_model(summary_of(c, surface), c->leading), (int)c->asked.quantity);
}

/** The factor to either side of the interval of the asked quantity; NaN: it has none. */
static double factor_on(const struct claims *c, size_t surface)
{
    const struct estimate *estimate = estimate_on(c, surface);
    return sqrt(estimate_end(estimate, 1) / estimate_end(estimate, 0));
}

/** The usable surface whose interval is widest; SIZE_MAX: none has any. */
static size_t widest(const struct claims *c)
{
    size_t at = SIZE_MAX;
    for (size_t k = 0; k < c->results->usable_count; k++)
        if (!known_value(c->results, c->asked.quantity, usable(c, k)).measured &&
            factor_on(c, usable(c, k)) > (at == SIZE_MAX ? 1 : factor_on(c, at)))
            at = usable(c, k);
    return at;
}

/** The interval's factor, and what part of its variance each cause has: standard deviations of one total. */
static bool uncertainty(struct claims *c)
{
    const size_t surface = widest(c);
    if (surface == SIZE_MAX)
        return false;
    const struct estimate *known = estimate_on(c, surface);
    const double few = summary_of(c, surface)->has_tiles ? 0 : accuracy_few_waves_sd(c->results, surface),
                 own = model_sd(model_rows[c->leading], c->asked.quantity, surface_knows_both(summary_of(c, surface))),
                 ofs = known->model_sd * known->model_sd,
                 waves = few > 0 ? ofs * few * few / (few * few + own * own) : 0;
    const double variance[] = {ofs - waves, known->s * known->s, waves};
    static const char *const causes[] = {"cause.model", "cause.scans", "cause.waves"};
    static const char *const names[] = {"model", "scans", "waves"};
    const double all = variance[0] + variance[1] + variance[2];
    struct text parts = {0};
    bool taken[3] = {false};
    for (int n = 0; n < 3; n++) {
        int most = -1;
        for (int i = 0; i < 3; i++)
            most = !taken[i] && (most < 0 || variance[i] > variance[most]) ? i : most;
        taken[most] = true;
        json_set(c->numbers, names[most], variance[most] / all);
        if (variance[most] < 0.03 * all)
            continue;
        text_add(&parts, parts.length > 0 ? ", " : "");
        text_add(&parts, "%s", words_say(c->words, "%s\npercent %.0f", causes[most], 100 * variance[most] / all));
    }
    c->weight = factor_on(c, surface);
    put_number(c, "factor", c->weight, c->weight, 2, "");
    put_text(c, "parts", text_string(&parts));
    text_free(&parts);
    return true;
}

static bool not_flat_assumed(struct claims *c)
{
    const struct results *results = c->results;
    const struct surface_record *record = &results->surfaces[results->baseline];
    const enum quantity asked = c->asked.quantity;
    const int way = asked == QUANTITY_ECR || asked == QUANTITY_JOINT_ECR ? JOINT_CURRENT : JOINT_HEAT;
    const struct joint_task joint = {&results->scene->joint, &record->summary.pair,
                                     .nominal_area_m2 = results->scene->nominal_area_m2,
                                     .effects = results->plan->running};
    if (plan_runs(results->plan, EFFECT_SHAPE) || /* gaps that conduct need loads far below those of the report */
        (way == JOINT_HEAT && plan_runs(results->plan, EFFECT_GAP) && joint.joint->fill != JOINT_VACUUM) ||
        !(joint.nominal_area_m2 > 0) || record->summary.pair.unknown || !record->curves ||
        !record->curves[c->leading].exists || (way == JOINT_HEAT && asked != QUANTITY_TCR && asked != QUANTITY_JOINT))
        return false;
    c->weight = shaped_usual_factor(&record->curves[c->leading], model_rows[c->leading], &joint,
                                    results_operating_load(results, results->baseline), way);
    if (!(c->weight >= 1.05))
        return false;
    const double side_m = sqrt(joint.nominal_area_m2), bulge_m = shaped_usual_flatness * side_m;
    c->key = way == JOINT_CURRENT || c->asked.reciprocal == (asked == QUANTITY_JOINT) ? "not-flat-assumed"
                                                                                      : "not-flat-assumed-conductance";
    put_number(c, "factor", c->weight, c->weight, 2, "");
    put_number(c, "bulge", bulge_m, bulge_m * 1e6, 2, "µm");
    put_number(c, "side", side_m, side_m * 1e3, 2, "mm");
    return true;
}

/** What scans in another direction would make of the model's error, where a surface has none. */
static bool one_direction(struct claims *c)
{
    const struct model_row *leading = model_rows[c->leading];
    const double one = model_factor(model_sd(leading, c->asked.quantity, false)),
                 two = model_factor(model_sd(leading, c->asked.quantity, true));
    bool some = false;
    for (size_t k = 0; k < c->results->usable_count; k++)
        some = some || (!summary_of(c, usable(c, k))->has_lay && !nothing_touches(c, usable(c, k)) &&
                        !known_value(c->results, c->asked.quantity, usable(c, k)).measured);
    c->weight = one / two;
    put_number(c, "one", one, one, 2, "");
    put_number(c, "two", two, two, 2, "");
    return some && two < one;
}

static bool short_scans(struct claims *c)
{
    double waves = INFINITY;
    for (size_t k = 0; k < c->results->usable_count && !model_rows[c->leading]->uses_map; k++)
        if (accuracy_few_waves_sd(c->results, usable(c, k)) > 0 && !nothing_touches(c, usable(c, k)))
            waves = fmin(waves, summary_of(c, usable(c, k))->longest_waves);
    if (!(waves < INFINITY))
        return false;
    c->weight = model_factor(model_few_waves_sd(waves));
    put_number(c, "waves", waves, waves, 2, "");
    put_number(c, "factor", c->weight, c->weight, 2, "");
    return c->weight >= 1.1;
}

/* ---- What stands beside the answer ---- */

static bool direct(struct claims *c)
{
    const struct results *results = c->results;
    const size_t baseline = results->baseline;
    const enum quantity quantity =
        quantity_rows[c->asked.quantity].from ? results_criterion(results) : c->asked.quantity;
    const struct asked_solved solved = asked_direct(results, quantity, results_operating_load(results, baseline));
    if (!(solved.value > 0) || !(solved.ratio > 0) || nothing_touches(c, baseline))
        return false;
    const bool own =
        quantity == c->asked.quantity || (quantity == QUANTITY_ECR && c->asked.quantity == QUANTITY_JOINT_ECR);
    const struct quantity_unit unit = quantity_unit(quantity);
    const double model = solved.value * solved.ratio,
                 shown = own ? asked_shown(&c->asked, solved.value) : solved.value * unit.scale,
                 modelled = own ? asked_shown(&c->asked, model) : model * unit.scale;
    put_surface(c, baseline);
    put_text(c, "quantity", words_say(c->words, "rank.%s", quantity_rows[quantity].name));
    put_number(c, "direct", solved.value, shown, 2, own ? c->asked.unit : unit.unit);
    put_number(c, "model", model, modelled, 2, own ? c->asked.unit : unit.unit);
    put_load(c, "load", baseline, solved.load);
    return true;
}

static bool textbook(struct claims *c)
{
    const size_t book = asked_textbook(c->results), baseline = c->results->baseline;
    if (book == model_count || book == c->leading)
        return false;
    const struct curve_summary *curve = surface_model(summary_of(c, baseline), book);
    put_text(c, "label", model_rows[book]->label);
    put_surface(c, baseline);
    if (c->asked.target) {
        const size_t t = (size_t)(c->asked.target - c->results->scene->targets);
        const struct answer *answer = &summary_of(c, baseline)->answers[t * model_count + book];
        if (answer->kind != ANSWER_LOAD || answer->full || answer->invalid)
            return false;
        put_load(c, "value", baseline, answer->load);
        return true;
    }
    const double value = comparison_middle(c->results, book, baseline).value[c->asked.quantity];
    if (!isfinite(value) || !curve_summary_is_valid(curve, results_operating_load(c->results, baseline)))
        return false;
    put_number(c, "value", value, asked_shown(&c->asked, value), 3, c->asked.unit);
    return true;
}

/** Is the roughest surface rougher than the smoothest one by more than chance: the mean square of w longest waves has
 * the relative standard deviation 1/sqrt(w), so ln Rq half of it; two of them? */
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

/** Most over least of a model's answers in order of roughness; *rises: each is above the one before. 0: one has none.
 */
static double spread_of(const struct claims *c, size_t m, bool *rises)
{
    double least = INFINITY, most = 0, before = -INFINITY;
    *rises = true;
    for (size_t k = 0; k < c->results->usable_count; k++) {
        const double value =
            asked_shown(&c->asked, comparison_middle(c->results, m, usable(c, k)).value[c->asked.quantity]);
        if (!(value > 0 && isfinite(value)))
            return 0;
        *rises = *rises && value > before * (1 + c->results->scene->tolerance);
        least = fmin(least, value);
        most = fmax(most, value);
        before = value;
    }
    return most / least;
}

/** Where the models of the thesis run on three surfaces or more: the one by which the answer rises most, and those by
 * which it does not rise at every step. */
static bool by_roughness(struct claims *c)
{
    bool rises;
    size_t most = model_count;
    struct text others = {0};
    if (c->results->usable_count < 3 || !differ_in_roughness(c->results))
        return false;
    for (size_t m = 0; m < model_count; m++) {
        const bool told = (model_rows[m]->thesis_place > 0 || m == c->leading) &&
                          model_rows[m]->plastic == model_rows[c->leading]->plastic;
        if (model_rows[m]->thesis_place > 0 && !plan_runs_model(c->results->plan, m))
            return text_free(&others), false;
        if (!told || !(spread_of(c, m, &rises) > 0))
            continue;
        bool unused;
        if (rises && (most == model_count || spread_of(c, m, &unused) > spread_of(c, most, &unused)))
            most = m;
        if (!rises)
            text_add(&others, "%s%s", others.length > 0 ? ", " : "", model_rows[m]->label);
    }
    const bool said = most < model_count && others.length > 0; /* else they agree */
    if (said) {
        const size_t last = c->results->usable_count - 1;
        const double ends[] = {comparison_middle(c->results, most, usable(c, 0)).value[c->asked.quantity],
                               comparison_middle(c->results, most, usable(c, last)).value[c->asked.quantity]};
        put_text(c, "label", model_rows[most]->label);
        put_text(c, "quantity", words_say(c->words, "%s", c->asked.name));
        put_range(c, "values", asked_shown(&c->asked, ends[0]), asked_shown(&c->asked, ends[1]), 2, c->asked.unit);
        put_text(c, "others", text_string(&others));
    }
    text_free(&others);
    return said;
}

/** Least and most of what a function says of the usable surfaces; false: of none anything. */
static bool range_over(const struct claims *c, double out[2], double (*of)(const struct claims *c, size_t surface))
{
    out[0] = INFINITY;
    out[1] = -INFINITY;
    for (size_t k = 0; k < c->results->usable_count; k++) {
        const double value = of(c, usable(c, k));
        if (!isfinite(value))
            continue;
        out[0] = fmin(out[0], value);
        out[1] = fmax(out[1], value);
    }
    return out[0] <= out[1];
}

static double gap_share(const struct claims *c, size_t surface)
{
    const double *value = comparison_middle(c->results, c->leading, surface).value;
    return 100 * value[QUANTITY_GAP] / value[QUANTITY_JOINT];
}

static double film_share(const struct claims *c, size_t surface)
{
    const double *value = comparison_middle(c->results, c->leading, surface).value;
    return 100 * c->results->scene->joint.film_ohm_m2 / value[QUANTITY_AREA] / value[QUANTITY_JOINT_ECR];
}

static double plating_factor(const struct claims *c, size_t surface)
{
    return comparison_middle(c->results, c->leading, surface).value[QUANTITY_PLATING_FACTOR];
}

static double carrying(const struct claims *c, size_t surface)
{
    const double share = summary_of(c, surface)->carrying;
    return share > 0 ? 1e6 * share * c->results->scene->nominal_area_m2 : NAN;
}

static double rise_K(const struct claims *c, size_t surface)
{
    return comparison_middle(c->results, c->leading, surface).value[QUANTITY_TEMPERATURE] -
           c->results->scene->joint.temperature_K;
}

/** What an effect that runs makes of the answer, over all surfaces. */
static const struct claim_share {
    const char *key;
    enum effect effect;
    double (*of)(const struct claims *c, size_t surface);
    const char *unit;
} shares[] = {
    {"shares-gap", EFFECT_GAP, gap_share, "%"},
    {"shares-film", EFFECT_FILM, film_share, "%"},
    {"shares-plating", EFFECT_PLATING, plating_factor, ""},
    {"shares-shape", EFFECT_SHAPE, carrying, "mm²"},
    {"heating", EFFECT_HEATING, rise_K, "K"},
};

static bool share(struct claims *c)
{
    const struct claim_share *of = &shares[c->i];
    const struct scene *scene = c->results->scene;
    double range[2];
    if (!plan_runs(c->results->plan, of->effect) || !range_over(c, range, of->of) || !(range[1] > 0))
        return false;
    c->key = of->key;
    put_range(c, "share", range[0], range[1], 2, of->unit);
    put_number(c, "nominal", scene->nominal_area_m2, 1e6 * scene->nominal_area_m2, 3, "mm²");
    put_number(c, "current", scene->joint.current_A, scene->joint.current_A, 3, "A");
    return true;
}

/** The model that `accuracy` chose. */
static bool chosen(struct claims *c)
{
    const struct scene *scene = c->results->scene;
    if (!(scene->chosen_sd > 0))
        return false;
    const double factor = model_factor(scene->chosen_sd);
    c->key = factor - 1 <= scene->accuracy ? "chosen" : "chosen-nearest";
    put_text(c, "label", model_rows[c->leading]->label);
    put_number(c, "accuracy", scene->accuracy, 100 * scene->accuracy, 2, "%");
    put_number(c, "factor", factor, factor, 2, "");
    return true;
}

/** Whose hardness counts, where there is a plating that may have its own. */
static bool hardness(struct claims *c)
{
    static const char *const keys[] = {[SURFACE_HARDNESS_BODIES] = "hardness-bodies",
                                       [SURFACE_HARDNESS_SCENE] = "hardness",
                                       [SURFACE_HARDNESS_PLATING] = "hardness-plating"};
    const struct surface_summary *s = summary_of(c, c->results->baseline);
    const struct joint *joint = &c->results->scene->joint;
    if (!(joint->plating_thickness_m > 0) || !plan_runs(c->results->plan, EFFECT_PLASTICITY))
        return false;
    c->key = keys[s->hardness];
    put_surface(c, c->results->baseline);
    put_number(c, "hardness", s->pair.hardness_Pa, s->pair.hardness_Pa * 1e-6, 3, "MPa");
    put_number(c, "thickness", joint->plating_thickness_m, joint->plating_thickness_m * 1e6, 2, "µm");
    return true;
}

/** Files that hold the heights of one before, which are no evidence of their own. */
static bool duplicates(struct claims *c)
{
    size_t copies = 0;
    for (size_t i = c->results->surface_count; i-- > 0;) {
        const struct surface_summary *s = summary_of(c, i);
        if (s->copies == 0)
            continue;
        copies += s->copies;
        json_decref(c->surface);
        c->surface = json_shown(s->scene->name);
        text_free(&c->told);
        put_text(c, "file", s->copy_file);
        put_text(c, "of", s->copy_of);
    }
    if (copies > 1)
        c->key = "duplicates-more";
    put_count(c, "more", copies - (copies > 0));
    return copies > 0;
}

/** Keys of the scene that a user's own part needs, where they are missing. */
static bool needs(struct claims *c)
{
    const bool material = results_has_material(c->results);
    c->key = material ? "needs" : "needs-material";
    return !c->results->scene->path || !material;
}

/* ---- The table ---- */

static const char *const levels[] = {[CLAIM_STOP] = "stop",
                                     [CLAIM_VERDICT] = "verdict",
                                     [CLAIM_UNCERTAINTY] = "uncertainty",
                                     [CLAIM_CONTEXT] = "context"};

static size_t once(const struct claims *c)
{
    (void)c;
    return 1;
}

static size_t effects(const struct claims *c)
{
    (void)c;
    return sizeof shares / sizeof *shares;
}

static size_t targets(const struct claims *c)
{
    return c->results->scene->target_count;
}

static size_t further_limits(const struct claims *c)
{
    const size_t count = c->results->scene->limit_count;
    return count > ASKED_LIMIT_COLUMNS ? count - ASKED_LIMIT_COLUMNS : 0;
}

/** A claim: said where `when` says so, which fills its numbers, and may take another key where the case is another; so
 * many times, claims.i of them before. */
static const struct claim_row {
    const char *key;
    enum claim_level level;
    bool (*when)(struct claims *c);
    size_t (*times)(const struct claims *c);
} rows[] = {
    {"refused", CLAIM_STOP, refused, once},
    {"beyond-hardness", CLAIM_STOP, beyond_hardness, once},
    {"few-spots", CLAIM_STOP, few_spots, once},
    {"softens", CLAIM_STOP, softens, once},
    {"melts", CLAIM_STOP, melts, once},
    {"bond-line", CLAIM_STOP, bond_line, once},
    {"bond-line-missing", CLAIM_STOP, bond_line_missing, once},
    {"loads-short", CLAIM_STOP, loads_short, once},
    {"measured", CLAIM_VERDICT, measured, once},
    {"not-flat", CLAIM_VERDICT, not_flat, once},
    {"rank", CLAIM_VERDICT, rank, once},
    {"area-pressed", CLAIM_VERDICT, area_pressed, once},
    {"target", CLAIM_VERDICT, further_target, targets},
    {"limit", CLAIM_VERDICT, further_limit, further_limits},
    {"scans-to-decide", CLAIM_VERDICT, scans_to_decide, once},
    {"uncertainty", CLAIM_UNCERTAINTY, uncertainty, once},
    {"not-flat-assumed", CLAIM_UNCERTAINTY, not_flat_assumed, once},
    {"one-direction", CLAIM_UNCERTAINTY, one_direction, once},
    {"short-scans", CLAIM_UNCERTAINTY, short_scans, once},
    {"direct", CLAIM_CONTEXT, direct, once},
    {"textbook", CLAIM_CONTEXT, textbook, once},
    {"by-roughness", CLAIM_CONTEXT, by_roughness, once},
    {"shares", CLAIM_CONTEXT, share, effects},
    {"chosen", CLAIM_CONTEXT, chosen, once},
    {"hardness", CLAIM_CONTEXT, hardness, once},
    {"duplicates", CLAIM_CONTEXT, duplicates, once},
    {"needs", CLAIM_CONTEXT, needs, once},
};

/** Puts a claim behind those of its level that weigh as much; one that weighs more than the whole interval before all.
 */
static void insert(json_t *list, double *weights, json_t *claim, size_t level_first, double weight, double interval)
{
    const size_t count = json_array_size(list);
    size_t at = count;
    while (at > level_first && weight > weights[at - 1])
        at--;
    at = interval > 0 && weight > interval ? 0 : at;
    memmove(weights + at + 1, weights + at, (count - at) * sizeof *weights);
    weights[at] = weight;
    json_array_insert_new(list, at, claim);
}

static struct claims begin(const struct results *results, const struct comparison *comparison, struct words *words)
{
    return (struct claims){.results = results,
                           .comparison = comparison,
                           .words = words,
                           .asked = asked_of(results),
                           .leading = plan_leading_model(results->plan)};
}

enum status_code claims_make(json_t **out, const struct results *results, const struct comparison *comparison,
                             struct words *words, struct status *status)
{
    struct claims c = begin(results, comparison, words);
    const size_t most =
        sizeof rows / sizeof *rows + effects(&c) + results->scene->target_count + results->scene->limit_count;
    double *weights = calloc(most + 1, sizeof *weights), interval = 0;
    json_t *list = json_array();
    for (size_t r = 0, first = 0; r < sizeof rows / sizeof *rows && weights; r++) {
        const size_t count = rows[r].times(&c);
        first = r > 0 && rows[r].level != rows[r - 1].level ? json_array_size(list) : first;
        for (size_t i = 0; i < count; i++) {
            json_t *claim = NULL;
            reset(&c, rows[r].key);
            c.i = i;
            if (!rows[r].when(&c) || !say(&c, &claim, levels[rows[r].level]))
                continue;
            insert(list, weights, claim, first, c.weight, rows[r].when == not_flat_assumed ? interval : 0);
            interval = rows[r].when == uncertainty ? c.weight : interval;
        }
    }
    reset(&c, "");
    json_decref(c.numbers);
    if (!weights || !list)
        (void)status_memory(status);
    free(weights);
    *out = list;
    return status->code;
}

/* ---- The headline ---- */

typedef void escape_text(struct text *out, const char *string);

static struct known known_of(const struct claims *c, size_t surface)
{
    return c->asked.target ? known_load(c->results, c->asked.target, surface)
                           : known_asked(c->results, &c->asked, surface);
}

/** What surfaces are ordered by: the load that the target needs, else the answer; less is better. */
static double cost_of(const struct claims *c, size_t surface)
{
    const struct known known = known_of(c, surface);
    if (known.kind == KNOWN_NOTHING ||
        known.kind == (!c->asked.target && c->asked.more_is_better ? KNOWN_AT_MOST : KNOWN_MORE_THAN))
        return INFINITY;
    if (c->asked.target)
        return known.value * asked_load_of(c->results, surface).scale;
    const double shown = asked_shown(&c->asked, known.value);
    return c->asked.more_is_better ? -shown : shown;
}

/** One surface's part: "*as plated* needs 0.97 N (measured)". */
static bool add_part(struct text *out, struct claims *c, size_t surface, escape_text *escape)
{
    static const char *const kinds[] = {
        [KNOWN_NOTHING] = "never", [KNOWN_VALUE] = "is", [KNOWN_AT_MOST] = "most", [KNOWN_MORE_THAN] = "more"};
    const struct scene_asked *target = c->asked.target;
    const struct asked_load load = asked_load_of(c->results, surface);
    const struct known known = known_of(c, surface);
    double ends[2] = {known.low * load.scale, known.high * load.scale};
    struct text later = {0};
    if (!target)
        asked_ends(ends, &c->asked, (const double[]){known.low, known.high});
    const bool has = known.kind == KNOWN_VALUE && isfinite(ends[0]) && isfinite(ends[1]);
    text_add(&later, "headline.%s-%s%s\nname ", target ? "load" : "value", kinds[known.kind],
             known.kind != KNOWN_VALUE ? ""
             : known.measured          ? "-measured"
             : has                     ? "-interval"
                                       : "");
    text_add_shown(&later, name_of(c, surface));
    text_add(&later, "\nvalue ");
    number_format(&later, target ? known.value * load.scale : asked_shown(&c->asked, known.value),
                  has ? digits_of(ends[0], ends[1]) : 3);
    text_add(&later, "\nunit ");
    text_add_shown(&later, target ? load.unit[0] ? load.unit : "E′Aₙ" : c->asked.unit);
    text_add(&later, "\nlow ");
    number_format(&later, ends[0], 2);
    text_add(&later, "\nhigh ");
    number_format(&later, ends[1], 2);
    const bool said = words_add(out, c->words, text_string(&later), escape);
    text_free(&later);
    return said;
}

/** The sentence with its marks, names escaped so. */
static bool add_headline(struct text *out, struct claims *c, const size_t surfaces[2], escape_text *escape)
{
    struct text parts = {0}, later = {0};
    char target[UNIT_LENGTH + 20] = "";
    bool said = add_part(&parts, c, surfaces[0], escape);
    if (surfaces[1] != surfaces[0]) {
        text_add(&parts, " and ");
        said = said && add_part(&parts, c, surfaces[1], escape);
    }
    if (c->asked.target)
        asked_text(target, sizeof target, c->asked.target->text);
    const size_t baseline = c->results->baseline;
    const struct asked_load load = asked_load_of(c->results, baseline);
    text_add(&later, "headline.%s\nquantity %s\ntarget ", c->asked.target ? "load" : "value",
             words_say(c->words, "%s", c->asked.name));
    text_add_shown(&later, target);
    text_add(&later, "\nload ");
    number_format(&later, results_operating_load(c->results, baseline) * load.scale, 3);
    text_add(&later, "\u00a0");
    text_add_shown(&later, load.unit[0] ? load.unit : "E′Aₙ");
    text_add(&later, "\nparts %s", text_string(&parts));
    said = said && words_add(out, c->words, text_string(&later), NULL);
    text_free(&parts);
    text_free(&later);
    return said;
}

enum status_code claims_headline(json_t **out, const struct results *results, const struct comparison *comparison,
                                 struct words *words, struct status *status)
{
    struct claims c = begin(results, comparison, words);
    size_t ends[2] = {results->by_roughness[0], results->by_roughness[0]};
    for (size_t k = 1; k < results->usable_count; k++) {
        const size_t i = usable(&c, k);
        ends[0] = cost_of(&c, i) < cost_of(&c, ends[0]) ? i : ends[0];
        ends[1] = cost_of(&c, i) >= cost_of(&c, ends[1]) ? i : ends[1];
    }
    if (ends[0] == ends[1] && results->usable_count > 1) /* all alike: the first and the last */
        ends[1] = usable(&c, results->usable_count - 1);
    *out = NULL;
    if (add_headline(&c.text, &c, ends, text_add_unmarked) &&
        add_headline(&c.markdown, &c, ends, text_add_markdown_shown)) {
        text_strip_marks(&c.text);
        *out = json_pack("{s:s, s:s}", "text", text_string(&c.text), "markdown", text_string(&c.markdown));
    }
    reset(&c, "");
    json_decref(c.numbers);
    return *out ? status->code : status_memory(status);
}
