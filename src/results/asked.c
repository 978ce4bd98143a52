/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results/asked.h"

#include "answers/direct_study.h"
#include "base/number_format.h"
#include "joint/heating.h"
#include "results/comparison.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

void asked_unit(char *out, size_t size, const char *unit)
{
    static const char *const words[][2] = {{"W/(m2*K)", "W/(m²·K)"},
                                           {"W/(m2 K)", "W/(m²·K)"},
                                           {"W/m2/K", "W/(m²·K)"},
                                           {"W/m2K", "W/(m²·K)"},
                                           {"ohm", "Ω"},
                                           {"Ohm", "Ω"},
                                           {"deg", "°"},
                                           {"m2", "m²"},
                                           {" m2", "·m²"},
                                           {" m", "·m"},
                                           {"*", "·"}};
    size_t used = 0;
    if (unit[0] == 'u' && unit[1]) {
        used = (size_t)snprintf(out, size, "µ");
        unit++;
    }
    while (*unit && used + 12 < size) {
        size_t w = 0;
        while (w < sizeof words / sizeof *words && strncmp(unit, words[w][0], strlen(words[w][0])) != 0)
            w++;
        if (w < sizeof words / sizeof *words) {
            used += (size_t)snprintf(out + used, size - used, "%s", words[w][1]);
            unit += strlen(words[w][0]);
        } else
            out[used++] = *unit++;
    }
    out[used] = '\0';
}

void asked_text(char *out, size_t size, const char *text)
{
    int number = (int)strcspn(text, " "), mantissa = (int)strcspn(text, " e");
    char unit[UNIT_LENGTH + 16];
    OWNED(text_free) struct text power = {0};
    if (mantissa < number)
        number_format(&power, strtod(text, NULL), mantissa > 1 ? mantissa - 1 : 1);
    asked_unit(unit, sizeof unit, text[number] ? text + number + 1 : "");
    snprintf(out, size, "%.*s%s%s%s", power.length ? 0 : number, text, text_string(&power), unit[0] ? "\u00a0" : "",
             unit);
}

double asked_shown(const struct asked *asked, double value)
{
    return asked->reciprocal ? asked->scale / value : asked->scale * value;
}

size_t asked_textbook(const struct results *results)
{
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs_model(results->plan, m) && model_rows[m]->textbook)
            return m;
    return model_count;
}

double asked_prefix(char *out, size_t size, const char *unit, double value)
{
    static const struct {
        const char *sign;
        double factor;
    } prefixes[] = {{"k", 1e3}, {"", 1}, {"m", 1e-3}, {"µ", 1e-6}, {"n", 1e-9}};
    size_t p = 1;
    if (value > 0 && isfinite(value))
        for (p = 0; p + 1 < sizeof prefixes / sizeof *prefixes && value < prefixes[p].factor; p++)
            ;
    snprintf(out, size, "%s%s", prefixes[p].sign, unit);
    return prefixes[p].factor;
}

struct asked asked_of(const struct results *results)
{
    const struct scene *scene = results->scene;
    struct asked out = {.scale = 1};
    double area_m2 = scene->nominal_area_m2;
    char unit[UNIT_LENGTH];
    bool is_target;
    const struct scene_asked *said = results_asked(results, &is_target);
    out.target = is_target ? said : NULL;
    out.quantity = results_asked_quantity(results);
    const struct quantity_row *row = &quantity_rows[out.quantity];
    const struct quantity_asked *how = said ? said->how : &row->asked[!results->measured && row->asked[1].key];
    out.reciprocal = how->reciprocal;
    out.more_is_better = out.reciprocal != ((row->is & QUANTITY_RISES) > 0);
    snprintf(out.name, sizeof out.name, "asked.%s", out.reciprocal ? how->key : row->name);
    if (said) {
        out.scale = scene_asked_shown(said, 1);
        asked_unit(out.unit, sizeof out.unit, said->unit_text);
    } else if (how->total && isfinite(area_m2)) {
        out.scale = 1 / area_m2;
        asked_unit(unit, sizeof unit, unit_si(how->total));
        const struct contact_point at =
            comparison_middle(results, plan_leading_model(results->plan), results->baseline);
        out.scale /= asked_prefix(out.unit, sizeof out.unit, unit, asked_shown(&out, at.value[out.quantity]));
    } else {
        const struct quantity_unit shown = quantity_unit(out.quantity);
        out.scale = out.reciprocal ? 1 : shown.scale;
        asked_unit(out.unit, sizeof out.unit, out.reciprocal ? unit_si(how->per_area) : shown.unit);
    }
    return out;
}

void asked_ends(double out[2], const struct asked *asked, const double of[2])
{
    for (int side = 0; side < 2; side++) /* the inverse has them the other way round */
        out[side] = asked_shown(asked, of[asked->reciprocal ? !side : side]);
}

struct asked_load asked_load_of(const struct results *results, size_t surface)
{
    const struct scene *scene = results->scene;
    const struct scene_load *load = &scene->load;
    const struct material_pair *pair = results_pair(results, surface);
    double area_m2 = scene->nominal_area_m2;
    struct asked_load out = {"", 1, false};
    if (load->unit_text[0]) {
        enum unit_quantity kind = (enum unit_quantity)unit_of(&load->unit, UNIT_LOADS);
        out.force = kind == UNIT_FORCE;
        out.scale = scene_load_divisor(scene, kind, pair) / load->unit.factor;
        asked_unit(out.unit, sizeof out.unit, load->unit_text);
    } else if (!pair->unknown) {
        out.force = isfinite(area_m2);
        out.scale = pair->effective_modulus_Pa * (out.force ? area_m2 : 1e-6);
        snprintf(out.unit, sizeof out.unit, "%s", out.force ? "N" : "MPa");
    }
    return out;
}

struct asked_solved asked_direct(const struct results *results, enum quantity quantity, double load)
{
    struct asked_solved before = {NAN, NAN, NAN, NAN};
    const size_t leading = plan_leading_model(results->plan);
    const struct direct_study *study = results_direct_baseline(results);
    const struct material_pair *pair = results_pair(results, results->baseline);
    const enum direct_study_kind kind = study ? direct_study_kind_of(study, leading) : 0;
    for (size_t i = 0; study && i < study->curves[kind].loads; i++) {
        double error, value = direct_study_value(study, pair, kind, quantity, i, &error);
        struct asked_solved at = {
            study->plan.load[i], value,
            fmax(isnan(error) ? 0 : error / value, direct_study_grid_error(study, kind, quantity, i)),
            direct_study_ratio(study, pair, leading, quantity, i)};
        if (!(value > 0))
            continue;
        if (at.load > load && before.load < load) {
            double weight = log(load / before.load) / log(at.load / before.load);
            at.value = before.value * pow(at.value / before.value, weight);
            at.ratio = before.ratio * pow(at.ratio / before.ratio, weight);
            at.load = load;
        }
        if (at.load >= load)
            return at;
        before = at;
    }
    return before;
}

/* ---- What is known of it ---- */

/** The factor on a surface's predicted conductance that its measurement of this quantity gives, 1: none was measured,
 * or the scene does not carry it. */
static double carried_factor(const struct results *results, enum quantity quantity, size_t surface)
{
    const struct measured *measured = results_measured(results, surface);
    const struct estimate *fit = measured ? &results->answers[surface].fit : NULL;
    if (!fit || fit->count == 0 || !measured->given->carry || quantity != results_measured_quantity(results))
        return 1;
    return estimate_value(fit);
}

/** Where a measured curve passes `at` of one of its columns on the way up, or has it, the other column: straight in
 * the logarithms, the mean over the runs that pass it; NaN: none does. */
static double passing(const struct measured *measured, const double *column, const double *other, double at)
{
    double sum = 0;
    size_t count = 0;
    for (size_t r = 0; r < measured->run_count; r++)
        for (size_t i = measured->runs[r].first; i <= measured->runs[r].turn; i++) {
            const double *x = &column[i], *y = &other[i];
            const bool has = fabs(x[0] / at - 1) < 1e-9;
            if (!has && (i == measured->runs[r].turn || !((x[0] - at) * (x[1] - at) < 0)))
                continue;
            sum += log(y[0]) + (has ? 0 : log(y[1] / y[0]) * log(at / x[0]) / log(x[1] / x[0]));
            count++;
            break;
        }
    return count > 0 ? exp(sum / (double)count) : NAN;
}

/** Does a voltage or temperature follow from the surface's measured resistance at the current? */
static bool follows(struct known *out, const struct results *results, enum quantity quantity, size_t surface)
{
    const struct measured *measured = results_measured(results, surface);
    const struct joint *joint = &results->scene->joint;
    if ((quantity != QUANTITY_VOLTAGE && quantity != QUANTITY_TEMPERATURE) || !measured || measured->thermal)
        return false;
    *out = known_value(results, results_measured_quantity(results), surface);
    double *const numbers[] = {&out->value, &out->low, &out->high};
    for (size_t k = 0; k < sizeof numbers / sizeof *numbers; k++) {
        const double voltage_V = joint->current_A * *numbers[k] / results->scene->nominal_area_m2;
        *numbers[k] = quantity == QUANTITY_VOLTAGE
                          ? voltage_V
                          : joint->temperature_K + heating_rise(voltage_V, joint->temperature_K);
    }
    return out->measured;
}

struct known known_value(const struct results *results, enum quantity quantity, size_t surface)
{
    const size_t leading = plan_leading_model(results->plan);
    const double carried = carried_factor(results, quantity, surface),
                 model = comparison_middle(results, leading, surface).value[quantity];
    const struct estimate *estimate = results_estimate(results, surface, quantity);
    struct known out = {isfinite(model) ? KNOWN_VALUE : KNOWN_NOTHING,
                        model,
                        estimate_end(estimate, 0),
                        estimate_end(estimate, 1),
                        .measured = carried != 1,
                        .overloaded = carried == 1 && comparison_overloaded(results, leading, surface)};
    struct known heated;
    if (follows(&heated, results, quantity, surface))
        return heated;
    for (int side = 0; side < 2 && !out.measured; side++)
        if (estimate->bound[side] > 0 && (side ? model > estimate->bound[1] : model < estimate->bound[0]))
            return (struct known){.kind = side ? KNOWN_AT_MOST : KNOWN_MORE_THAN,
                                  .value = estimate->bound[side],
                                  .low = NAN,
                                  .high = NAN};
    if (!out.measured)
        return out;
    const struct estimate *fit = &results->answers[surface].fit;
    const struct measured *measured = results_measured(results, surface);
    const double here =
        passing(measured, measured->load, measured->resistance, results_operating_load(results, surface));
    out.value = here > 0 ? measured_as(quantity, here) : model / measured_as(quantity, carried);
    out.beyond = !(here > 0);
    out.kind = isfinite(out.value) ? KNOWN_VALUE : KNOWN_NOTHING;
    out.low = out.value * exp(-fit->half_width);
    out.high = out.value * exp(fit->half_width);
    return out;
}

struct known known_load(const struct results *results, const struct scene_asked *target, size_t surface)
{
    static const enum known_kind kinds[] = {[ANSWER_NONE] = KNOWN_NOTHING,
                                            [ANSWER_LOAD] = KNOWN_VALUE,
                                            [ANSWER_LIGHTEST] = KNOWN_AT_MOST,
                                            [ANSWER_NOT_REACHED] = KNOWN_MORE_THAN};
    const struct surface_record *record = &results->surfaces[surface];
    const size_t t = (size_t)(target - results->scene->targets), leading = plan_leading_model(results->plan);
    const struct answer *answer = &record->summary.answers[t * model_count + leading];
    const bool heats = target->quantity == QUANTITY_TEMPERATURE,
               carried = known_value(results, target->quantity, surface).measured;
    struct known out = {kinds[answer->kind], answer->load, answer->low,
                        answer->high,        carried,      .overloaded = !carried && answer->above_hardness};
    if (answer->kind == ANSWER_LOAD && answer->most)
        out.kind = KNOWN_AT_MOST;
    if (carried) {
        const struct measured *measured = results_measured(results, surface);
        const struct joint *joint = &results->scene->joint;
        const double resistance = heats ? heating_voltage(target->value, joint->temperature_K) / joint->current_A *
                                              results->scene->nominal_area_m2
                                        : measured_as(target->quantity, target->value);
        const double load = passing(measured, measured->resistance, measured->load, resistance);
        out.low = out.high = NAN;
        out.beyond = !(load > 0);
        if (load > 0) {
            out.kind = KNOWN_VALUE;
            out.value = load;
        }
    }
    out.short_loads = !carried && answer->wider;
    return out;
}

void known_take_measured(struct results *results, size_t surface)
{
    for (size_t l = 0; l < results->scene->limit_count; l++) {
        const struct scene_asked *limit = &results->scene->limits[l];
        const struct known known = known_value(results, limit->quantity, surface);
        struct limit_check *check = &results->surfaces[surface].summary.limits[l];
        if (!known.measured)
            continue;
        *check = (struct limit_check){.value = known.value, .low = known.low, .high = known.high};
        check->verdict = answers_judge(check, limit);
    }
    for (size_t t = 0; t < results->scene->target_count; t++) {
        const struct known load = known_load(results, &results->scene->targets[t], surface);
        struct answer *answer =
            &results->surfaces[surface].summary.answers[t * model_count + plan_leading_model(results->plan)];
        if (!load.measured || load.kind != KNOWN_VALUE)
            continue;
        if (!load.beyond)
            *answer = (struct answer){.kind = ANSWER_LOAD,
                                      .load = load.value,
                                      .spots_per_m2 = answer->spots_per_m2 * load.value / answer->load,
                                      .counted_by = answer->counted_by};
        answer->low = answer->high = NAN; /* the model's error is not that of its curve times the factor */
    }
}

struct known known_shown(const struct results *results, const struct asked *asked, const struct scene_asked *target,
                         size_t surface)
{
    struct known out = target ? known_load(results, target, surface) : known_value(results, asked->quantity, surface);
    const double scale = asked_load_of(results, surface).scale;
    double ends[2] = {out.low * scale, out.high * scale};
    if (!target)
        asked_ends(ends, asked, (const double[]){out.low, out.high});
    out.value = target ? out.value * scale : asked_shown(asked, out.value);
    out.low = ends[0];
    out.high = ends[1];
    if (!target && asked->reciprocal && (out.kind == KNOWN_AT_MOST || out.kind == KNOWN_MORE_THAN))
        out.kind = out.kind == KNOWN_AT_MOST ? KNOWN_MORE_THAN : KNOWN_AT_MOST;
    return out;
}

int known_digits(const struct known *known)
{
    const bool wide = fmax(known->high, known->value) > 1.44 * fmin(known->low, known->value); /* one end may be NaN */
    return known->kind == KNOWN_VALUE && !known->measured && (wide || known->short_loads) ? 2 : 3;
}
