/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results/asked.h"

#include "answers/direct_study.h"
#include "base/number_format.h"
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
    struct text power = {0};
    if (mantissa < number)
        number_format(&power, strtod(text, NULL), mantissa > 1 ? mantissa - 1 : 1);
    asked_unit(unit, sizeof unit, text[number] ? text + number + 1 : "");
    snprintf(out, size, "%.*s%s%s%s", power.length ? 0 : number, text, text_string(&power), unit[0] ? "\u00a0" : "",
             unit);
    text_free(&power);
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

void asked_interval(double out[2], const struct asked *asked, const struct results *results, size_t model,
                    size_t surface)
{
    const struct curve_summary *curve = surface_model(&results->surfaces[surface].summary, model);
    const struct estimate *estimate = curve_summary_estimate(curve, (int)asked->quantity);
    asked_ends(out, asked, (const double[]){estimate_end(estimate, 0), estimate_end(estimate, 1)});
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
