/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results/known.h"

#include "joint/heating.h"
#include "results/comparison.h"
#include <math.h>

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

/** Where a measured curve passes `at` of one of its columns on the way up, the other column: straight in the
 * logarithms, the mean over the runs that pass it; NaN: none does. */
static double passing(const struct measured *measured, const double *column, const double *other, double at)
{
    double sum = 0;
    size_t count = 0;
    for (size_t r = 0; r < measured->run_count; r++)
        for (size_t i = measured->runs[r].first; i < measured->runs[r].turn; i++) {
            const double *x = &column[i], *y = &other[i];
            if ((x[0] - at) * (x[1] - at) > 0 || x[0] == x[1])
                continue;
            sum += log(y[0]) + log(y[1] / y[0]) * log(at / x[0]) / log(x[1] / x[0]);
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
                     passing(measured, measured->load, measured->resistance, results_operating_load(results, surface)),
                 half = isnan(fit->half_width) ? NAN : fit->half_width;
    out.value = here > 0 ? measured_as(quantity, here) : model / measured_as(quantity, carried);
    out.kind = isfinite(out.value) ? KNOWN_VALUE : KNOWN_NOTHING;
    out.low = out.value * exp(-half);
    out.high = out.value * exp(half);
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
        if (!load.measured || load.kind != KNOWN_VALUE || load.value == answer->load)
            continue;
        *answer = (struct answer){.kind = ANSWER_LOAD,
                                  .load = load.value,
                                  .low = NAN,
                                  .high = NAN,
                                  .spots_per_m2 = answer->spots_per_m2 * load.value / answer->load,
                                  .counted_by = answer->counted_by};
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
