/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "answers/measured.h"

#include "base/limits.h"
#include "joint/joint.h"

#include "scene/measured_file.h"
#include "statistics/interval.h"
#include <gsl/gsl_sort.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *const column_keys[] = {[MEASURED_LOAD] = "load_unit", [MEASURED_RESISTANCE] = "resistance_unit"};

/** Takes missing units of the file from the scene; where both name one they must agree. */
static enum status_code complete_units(struct measured_file *file, const char *name, const struct scene_measured *scene,
                                       const unsigned *quantities, struct status *status)
{
    const char *const given[] = {[MEASURED_LOAD] = scene->load_unit, [MEASURED_RESISTANCE] = scene->resistance_unit};
    for (size_t c = MEASURED_LOAD; c <= MEASURED_RESISTANCE; c++) {
        struct measured_unit *own = &file->units[c];
        struct unit unit;
        bool known = unit_read(&unit, given[c], strlen(given[c])) && unit_of(&unit, quantities[c]);
        if (known && own->known && !unit_equal(&unit, &own->unit))
            return status_fail(status, STATUS_SCENE,
                               "%s:%zu: the unit is '%s' here, but the scene's %s says '%s'; correct one of them", name,
                               own->line, own->text, column_keys[c], given[c]);
        if (!known && !own->known)
            return status_fail(status, STATUS_SCENE,
                               "%s: nothing says the unit of the %s; name it in the heading, such as '%s', or add '%s' "
                               "to 'measured' in the scene",
                               name, c == MEASURED_LOAD ? "load" : "resistance",
                               c == MEASURED_LOAD                ? "load (N)"
                               : quantities[c] & UNIT_RESISTANCE ? "ECR (mohm)"
                                                                 : "TCR (K/W)",
                               column_keys[c]);
        if (!own->known) {
            *own = (struct measured_unit){.known = true, .unit = unit};
            memcpy(own->text, given[c], strlen(given[c]) + 1);
        }
    }
    return STATUS_OK;
}

/** Factor from a column's unit to P/(A_n E'), or to the resistance per nominal area. */
static enum status_code unit_factor(double *factor, const char *name, const struct measured_unit *unit,
                                    const struct scene *scene, const struct material_pair *pair, struct status *status)
{
    enum unit_quantity load = (enum unit_quantity)unit_of(&unit->unit, UNIT_LOADS);
    bool whole = load == UNIT_FORCE || unit_of(&unit->unit, UNIT_RESISTANCE | UNIT_THERMAL_RESISTANCE);
    *factor = load    ? unit->unit.factor / scene_load_divisor(scene, load, pair)
              : whole ? unit->unit.factor * scene->nominal_area_m2
                      : unit->unit.factor;
    if (!whole || isfinite(scene->nominal_area_m2))
        return STATUS_OK;
    return status_fail(status, STATUS_SCENE,
                       "%s: measured %s in %s need the contact's area; add nominal_area to the scene", name,
                       load ? "loads" : "resistances", unit->text);
}

/** Adds the rows of a file, in the models' units, as a run. */
static enum status_code add_run(struct measured *out, const struct measured_file *file, const char *name,
                                const struct scene *scene, const struct material_pair *pair, struct status *status)
{
    const struct measured_unit *units = file->units;
    const struct measured_unit *error_unit = &units[units[MEASURED_ERROR].known ? MEASURED_ERROR : MEASURED_RESISTANCE];
    bool relative = unit_of(&error_unit->unit, UNIT_NUMBER | UNIT_PERCENT);
    struct measured_run *run = &out->runs[out->run_count++];
    double **const columns[] = {&out->load, &out->resistance, &out->error};
    double load, resistance, error = error_unit->unit.factor;
    if (out->before + out->count + file->count > limit_most(LIMIT_MEASURED_LINES))
        return status_fail(status, STATUS_SCENE, "%s: too many rows of all that was measured%s", name,
                           limit_words(LIMIT_MEASURED_LINES).text);
    *run = (struct measured_run){out->count, out->count, out->count + file->count};
    if (unit_factor(&load, name, &units[MEASURED_LOAD], scene, pair, status) != STATUS_OK ||
        unit_factor(&resistance, name, &units[MEASURED_RESISTANCE], scene, pair, status) != STATUS_OK ||
        (!relative && unit_factor(&error, name, error_unit, scene, pair, status) != STATUS_OK))
        return status->code;
    for (size_t c = 0; c < sizeof columns / sizeof *columns; c++) {
        double *more = reallocarray(*columns[c], run->end, sizeof *more);
        if (!more)
            return status_memory(status);
        *columns[c] = more;
    }
    for (size_t i = out->count; i < run->end; i++) {
        const struct measured_row *row = &file->rows[i - run->first];
        out->load[i] = row->value[MEASURED_LOAD] * load;
        out->resistance[i] = row->value[MEASURED_RESISTANCE] * resistance;
        out->error[i] = fabs(row->value[MEASURED_ERROR]) * error * (relative ? out->resistance[i] : 1);
        if (!(out->load[i] > 0 && out->resistance[i] > 0 && isfinite(out->load[i]) && isfinite(out->resistance[i])) ||
            isinf(out->error[i]))
            return status_fail(status, STATUS_SCENE, "%s:%zu: too large or too small in its unit; correct the row",
                               name, row->line);
        run->turn = out->load[i] > out->load[run->turn] ? i : run->turn;
    }
    out->count = run->end;
    memcpy(out->load_unit, units[MEASURED_LOAD].text, UNIT_LENGTH);
    memcpy(out->resistance_unit, units[MEASURED_RESISTANCE].text, UNIT_LENGTH);
    return STATUS_OK;
}

static enum status_code read_run(struct measured *out, const char *name, const struct scene *scene,
                                 const struct material_pair *pair, struct status *status)
{
    const unsigned resistances = scene_measured_resistances[out->given->quantity];
    const unsigned quantities[MEASURED_COLUMNS] = {UNIT_LOADS, resistances, resistances | UNIT_NUMBER | UNIT_PERCENT};
    OWNED(measured_file_free) struct measured_file file = {0};
    OWNED(memory_free) char *path = scene_file_path(scene, name);
    if (!path)
        return status_memory(status);
    if (measured_file_take(&file, path, name, quantities, status) == STATUS_OK &&
        complete_units(&file, name, out->given, quantities, status) == STATUS_OK)
        (void)add_run(out, &file, name, scene, pair, status);
    return status->code;
}

enum status_code measured_read(struct measured *out, const struct scene *scene, const struct plan *plan,
                               const struct material_pair *pair, struct status *status)
{
    const struct scene_measured *given = out->given;
    out->thermal = given->quantity == SCENE_MEASURED_TCR;
    enum effect needed = out->thermal ? EFFECT_THERMAL : EFFECT_ELECTRICAL;
    if (!plan_runs(plan, needed))
        return status_fail(status, STATUS_SCENE,
                           "'%s' holds measured %s, but the effect %s does not run; add it to "
                           "effects, or take out measured",
                           given->files.path[0], out->thermal ? "TCR" : "ECR", effect_rows[needed].name);
    if (!(out->runs = calloc(given->files.count, sizeof *out->runs)))
        return status_memory(status);
    for (size_t f = 0; f < given->files.count; f++)
        if (read_run(out, given->files.path[f], scene, pair, status) != STATUS_OK)
            return status->code;
    return STATUS_OK;
}

void measured_free(struct measured *measured)
{
    free(measured->load);
    free(measured->resistance);
    free(measured->error);
    free(measured->runs);
    *measured = (struct measured){0};
}

double measured_as(enum quantity quantity, double resistance)
{
    return quantity_rows[quantity].is & QUANTITY_RISES ? 1 / resistance : resistance;
}

enum quantity measured_quantity(const struct measured *measured, unsigned effects)
{
    const struct quantity_asked *how;
    return quantity_of_key(&how, measured->thermal ? "tcr" : "ecr", effects);
}

/** The distinct measured loads within the task's, ascending; returns their number. */
static size_t loads_within(double *loads, const struct measured *measured, const struct model_task *task)
{
    size_t count = 0, kept = 0;
    for (size_t i = 0; i < measured->count; i++)
        if (measured->load[i] >= task->loads[0] && measured->load[i] <= task->loads[task->load_count - 1])
            loads[count++] = measured->load[i];
    gsl_sort(loads, 1, count);
    for (size_t i = 0; i < count; i++)
        if (kept == 0 || loads[i] != loads[kept - 1])
            loads[kept++] = loads[i];
    return kept;
}

/** The resistance at a load; NaN where the curve has none above 0. */
static double resistance_at(const struct model_curve *curve, double load, enum quantity quantity)
{
    for (size_t i = 0; i < curve->count; i++)
        if (curve->points[i].value[QUANTITY_LOAD] == load && curve->points[i].value[quantity] > 0)
            return measured_as(quantity, curve->points[i].value[quantity]);
    return NAN;
}

enum status_code measured_answer(struct measured_answers *out, const struct measured *measured,
                                 const struct surface_record *record, const struct surface_task *asked,
                                 struct status *status)
{
    const uint64_t models = plan_running_models(asked->plan);
    const struct model_task task = surface_model_task(record, asked);
    const struct joint_task joint = surface_joint(record, asked->scene, asked->plan, &task);
    const enum quantity quantity = measured_quantity(measured, joint.effects);
    OWNED(memory_free) double *loads = calloc(measured->count, sizeof *loads);
    OWNED(memory_free) struct contact_point *points = malloc((measured->count + 1) * sizeof *points);
    *out = (struct measured_answers){.resistance = calloc(model_count * measured->count, sizeof *out->resistance)};
    bool stored = loads && points && out->resistance;
    size_t count = stored ? loads_within(loads, measured, &task) : 0;
    struct model_task at_loads = model_task_at(&task, loads, count);
    const unsigned own = QUANTITY_BIT(measured_quantity(measured, 0)); /* all that is needed from the models */
    at_loads.wanted = QUANTITY_BIT(QUANTITY_LOAD) | QUANTITY_BIT(QUANTITY_AREA) | own | quantity_rows[quantity].from;
    if (joint_has_bond_line(&joint))
        at_loads.wanted |= QUANTITY_BIT(QUANTITY_SEPARATION);
    enum status_code rc = stored ? STATUS_OK : status_memory(status);
    for (size_t m = 0; m < model_count && rc == STATUS_OK; m++) {
        struct model_curve curve = {.points = points};
        if ((models & MODEL_BIT(m)) && count > 0 && (model_rows[m]->quantities & own))
            rc = ensemble_curve(&curve, NULL, &record->ensemble, model_rows[m], &at_loads, status);
        joint_hold(points, curve.count, &joint);
        if (rc == STATUS_OK && quantity_rows[quantity].from)
            rc = joint_curve(&curve, model_rows[m], &at_loads, &joint, status);
        for (size_t i = 0; i < measured->count; i++)
            out->resistance[m * measured->count + i] = resistance_at(&curve, measured->load[i], quantity);
    }
    return rc;
}

/** The loading points for which a model has an answer, run by run. */
struct answered {
    double *ln_load, *ln_model, *ln_conductance;
    size_t *run, count, runs; /* those without a point are not counted */
};

/** Least squares of `of` over ln load, each run with its own level. Returns the residual sum of squares, at least that
 * of errors of 1e-9 in the logarithms. */
static double residual(double *slope, double *spread, const double *of, const struct answered *points)
{
    const double *by = points->ln_load;
    const size_t *run = points->run, count = points->count;
    double xx = 0, xy = 0, yy = 0;
    for (size_t r = 0; r < points->runs; r++) {
        double x = 0, y = 0, n = 0;
        for (size_t i = 0; i < count; i++)
            if (run[i] == r) {
                x += by[i];
                y += of[i];
                n++;
            }
        for (size_t i = 0; i < count; i++)
            if (run[i] == r) {
                xx += (by[i] - x / n) * (by[i] - x / n);
                xy += (by[i] - x / n) * (of[i] - y / n);
                yy += (of[i] - y / n) * (of[i] - y / n);
            }
    }
    *slope = xy / xx;
    *spread = xx;
    return fmax(yy - 2 * *slope * xy + *slope * *slope * xx, 1e-18 * (double)count);
}

/** Residual sum of squares of ln R with a resistance in series: R = a R_model + b, a for each run, b >= 0 for all; the
 * best of SERIES_STEPS values of b that approach the least measured resistance. */
static double series_residual(const struct answered *points)
{
    enum { SERIES_STEPS = 100 };
    double least_ohm = INFINITY, best = INFINITY;
    for (size_t i = 0; i < points->count; i++)
        least_ohm = fmin(least_ohm, exp(-points->ln_conductance[i]));
    for (int k = 0; k < SERIES_STEPS; k++) {
        const double b = least_ohm * (1 - pow(10, -3.0 * k / SERIES_STEPS));
        double squares = 0;
        for (size_t r = 0; r < points->runs; r++) {
            double ln_a = 0, n = 0;
            for (size_t i = 0; i < points->count; i++)
                if (points->run[i] == r) {
                    ln_a += log(exp(-points->ln_conductance[i]) - b) + points->ln_model[i];
                    n++;
                }
            for (size_t i = 0; i < points->count; i++)
                if (points->run[i] == r)
                    squares += pow(log(exp(ln_a / n - points->ln_model[i]) + b) + points->ln_conductance[i], 2);
        }
        best = fmin(best, squares);
    }
    return best;
}

/** Fits the exponents, and decides whether parts that are not flat explain their difference. */
static void find_exponent(struct measured_exponent *out, const struct answered *of)
{
    static const double clear = 0.08, as_well = 1.5;
    const double freedom = (double)(of->count - of->runs) - 1;
    double spread;
    const double least = residual(&out->measured, &spread, of->ln_conductance, of);
    out->sd = sqrt(least / freedom / spread);
    residual(&out->model, &spread, of->ln_model, of);
    const double error = interval_quantile(estimate_level, freedom) * out->sd;
    out->not_flat = out->measured + error + clear < out->model && series_residual(of) > as_well * least;
}

enum status_code measured_fit(struct measured_answers *out, const struct measured *measured, size_t m,
                              struct status *status)
{
    const size_t most = measured->count;
    OWNED(memory_free) double *room = calloc(5 * most + 1, sizeof *room);
    OWNED(memory_free) size_t *run = calloc(most + 1, sizeof *run);
    if (!room || !run)
        return status_memory(status);
    double *ratio = room, *mean = room + most;
    struct answered of = {room + 2 * most, room + 3 * most, room + 4 * most, run, 0, 0};
    for (size_t r = 0; r < measured->run_count; r++) {
        size_t before = of.count;
        double sum = 0;
        for (size_t i = measured->runs[r].first; i <= measured->runs[r].turn; i++) {
            double model = out->resistance[m * most + i];
            if (isnan(model))
                continue;
            ratio[of.count] = model / measured->resistance[i]; /* measured over modelled conductance */
            sum += log(ratio[of.count]);
            of.ln_load[of.count] = log(measured->load[i]);
            of.ln_model[of.count] = -log(model);
            of.ln_conductance[of.count] = -log(measured->resistance[i]);
            run[of.count++] = of.runs;
        }
        if (of.count > before)
            mean[of.runs++] = exp(sum / (double)(of.count - before));
    }
    out->exponent = (struct measured_exponent){.measured = NAN, .model = NAN, .sd = NAN};
    if (of.count >= of.runs + 3)
        find_exponent(&out->exponent, &of);
    return estimate_make(&out->fit, of.runs > 1 ? mean : ratio, NULL, of.runs > 1 ? of.runs : of.count, true, status);
}

void measured_answers_free(struct measured_answers *out)
{
    free(out->resistance);
    *out = (struct measured_answers){0};
}

struct measured_distance measured_compare(const struct measured *measured, const struct measured_answers *models,
                                          size_t m)
{
    struct measured_distance out = {0, NAN, NAN};
    double square = 0, sum = 0;
    for (size_t i = 0; i < measured->count; i++) {
        double model = models->resistance[m * measured->count + i];
        if (isnan(model))
            continue;
        double decades = log10(model / measured->resistance[i]);
        square += decades * decades;
        sum += decades;
        out.points++;
    }
    if (out.points > 0) {
        out.rms_decades = sqrt(square / (double)out.points);
        out.bias_decades = sum / (double)out.points;
    }
    return out;
}

size_t measured_nearest(const struct measured *measured, const struct measured_answers *models)
{
    size_t nearest = model_count, most = 1;
    double least = INFINITY;
    for (size_t m = 0; m < model_count; m++) {
        size_t points = measured_compare(measured, models, m).points;
        most = points > most ? points : most;
    }
    for (size_t m = 0; m < model_count; m++) {
        struct measured_distance distance = measured_compare(measured, models, m);
        if (2 * distance.points >= most && distance.rms_decades < least) {
            least = distance.rms_decades;
            nearest = m;
        }
    }
    return nearest;
}
