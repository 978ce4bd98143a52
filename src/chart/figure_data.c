#include "chart/figure_data.h"

#include "results/measured.h"

#include <errno.h>
#include <math.h>
#include <string.h>

static const double touching_area = 0.1, outside_share = 0.1; /* beyond them a statistical curve is dashed */
/* Resistance goes to 0 with the last per cent of the area, over as many decades as a load happens to come close to full
 * contact: the axis ends where a curve's last point at or below this A/A_n stands. */
static const double nearly_full_area = 0.99;

const struct figure_axis_row figure_axes[] = {
    [FIGURE_LOAD] = {"load P/(Aₙ E′)", true, 0},
    [FIGURE_AREA] = {"area ratio A/Aₙ", true, 0},
    [FIGURE_SEPARATION] = {"separation / σ", false, EFFECT_BIT(EFFECT_SEPARATION)},
    [FIGURE_ECR] = {"ECR·Aₙ (Ω·m²)", true, EFFECT_BIT(EFFECT_ELECTRICAL)},
    [FIGURE_TCR] = {"TCR·Aₙ (K·m²/W)", true, EFFECT_BIT(EFFECT_THERMAL)},
    [FIGURE_WAVELENGTH] = {"shortest wavelength included (m)", true, 0},
};

/** Starts a curve: its first row is the legend. */
static void begin_block(struct figure_file *out, const char *style, const char *legend)
{
    char field[256];
    gnuplot_field(field, sizeof field, legend);
    fprintf(out->file, "%s%s\n", out->blocks++ > 0 ? "\n\n" : "", field);
    text_add(&out->styles, "%s%s", out->styles.length > 0 ? " " : "", style);
}

/** One point, left out where a logarithmic axis cannot show it. */
static void put_point(struct figure_file *out, double x, double y)
{
    if (!isfinite(x) || !isfinite(y) || (figure_axes[out->row->x].logarithmic && x <= 0) ||
        (figure_axes[out->row->y].logarithmic && y <= 0))
        return;
    fprintf(out->file, "%.17g,%.17g\n", x, y);
}

enum variant { VARIANT_PLAIN, VARIANT_ADJUSTED, VARIANT_SCALE_DEPENDENT };

static double coordinate(const struct contact_point *point, enum figure_axis axis, enum variant variant, double sigma_m)
{
    switch (axis) {
    case FIGURE_LOAD:
        return point->load;
    case FIGURE_AREA:
        return point->area_ratio;
    case FIGURE_SEPARATION:
        return (variant == VARIANT_ADJUSTED ? point->adjusted_m : point->separation_m) / sigma_m;
    case FIGURE_ECR:
        return point->ecr_ohm_m2;
    case FIGURE_TCR:
        return variant == VARIANT_SCALE_DEPENDENT ? point->tcr_sd_K_m2_per_W : point->tcr_K_m2_per_W;
    case FIGURE_WAVELENGTH:
        break;
    }
    return NAN;
}

/** First point of a curve that is outside the model's validity; `count` when all are inside. */
static size_t first_outside(const struct model_curve *curve, const struct model_row *model)
{
    size_t i = 0;
    if (model->family == SCENE_MODEL_STATISTICAL)
        while (i < curve->count && curve->points[i].area_ratio <= touching_area &&
               curve->points[i].outside <= outside_share)
            i++;
    else
        i = curve->count;
    return i;
}

/** A curve as two blocks: inside the model's validity, and (dashed, starting at the last valid point) outside. */
static void put_curve(struct figure_file *out, const struct model_curve *curve, const struct model_row *model,
                      enum variant variant, double sigma_m, const char *style, const char *legend)
{
    size_t border = first_outside(curve, model);
    if (out->row->y == FIGURE_ECR || out->row->y == FIGURE_TCR)
        for (size_t i = 0; i < curve->count && curve->points[i].area_ratio <= nearly_full_area; i++)
            out->floor = fmin(out->floor, coordinate(&curve->points[i], out->row->y, variant, sigma_m));
    char outside_style[32];
    snprintf(outside_style, sizeof outside_style, "%sx", style);
    begin_block(out, style, legend);
    for (size_t i = 0; i < border; i++)
        put_point(out, coordinate(&curve->points[i], out->row->x, variant, sigma_m),
                  coordinate(&curve->points[i], out->row->y, variant, sigma_m));
    if (border == curve->count)
        return;
    begin_block(out, outside_style, legend);
    for (size_t i = border > 0 ? border - 1 : 0; i < curve->count; i++)
        put_point(out, coordinate(&curve->points[i], out->row->x, variant, sigma_m),
                  coordinate(&curve->points[i], out->row->y, variant, sigma_m));
}

/** Limits of one quantity of a band, NULL when bands do not show it. */
static const double *band_of(const struct spread_band *band, enum figure_axis axis)
{
    switch (axis) {
    case FIGURE_AREA:
        return band->area;
    case FIGURE_SEPARATION:
        return band->separation_m;
    case FIGURE_ECR:
        return band->ecr_ohm_m2;
    case FIGURE_TCR:
        return band->tcr_K_m2_per_W;
    case FIGURE_LOAD:
    case FIGURE_WAVELENGTH:
        break;
    }
    return NULL;
}

/** The band of repeated scans against load, where there is one. */
static void put_band(struct figure_file *out, const struct surface_record *record, enum model_id model,
                     const char *style)
{
    if (!record->bands[model] || out->row->x != FIGURE_LOAD || !band_of(record->bands[model], out->row->y))
        return;
    double scale = out->row->y == FIGURE_SEPARATION ? 1 / record->summary.asperities.sigma_m : 1;
    char band_style[32];
    snprintf(band_style, sizeof band_style, "%sb", style);
    begin_block(out, band_style, "band");
    for (size_t i = 0; i < record->band_count; i++) {
        const struct spread_band *band = &record->bands[model][i];
        const double *limits = band_of(band, out->row->y), low = limits[0] * scale, high = limits[1] * scale;
        if (isfinite(low) && isfinite(high) && (!figure_axes[out->row->y].logarithmic || low > 0))
            fprintf(out->file, "%.17g,%.17g,%.17g\n", band->load, low, high);
    }
}

/** What was measured, with its error where one is given. */
static void put_measured(struct figure_file *out, const struct measured *measured)
{
    if (!measured || out->row->y != (measured->thermal ? FIGURE_TCR : FIGURE_ECR))
        return;
    begin_block(out, "meas", "measured");
    for (size_t i = 0; i < measured->count; i++) {
        double value = measured->resistance[i], error = isnan(measured->error[i]) ? 0 : measured->error[i];
        fprintf(out->file, "%.17g,%.17g,%.17g,%.17g\n", measured->load[i], value, fmax(value - error, value * 1e-3),
                value + error);
    }
}

static void put_models(struct figure_file *out, const struct surface_record *record, const struct plan *plan)
{
    double sigma_m = record->summary.asperities.sigma_m;
    for (int m = 0; m < MODEL_COUNT; m++) {
        const struct model_curve *curve = &record->curves[m];
        const struct model_row *model = &model_rows[m];
        char style[32], legend[80];
        if (!curve->exists)
            continue;
        if (out->row->y != FIGURE_SEPARATION || model->family == SCENE_MODEL_MULTISCALE)
            put_band(out, record, (enum model_id)m, model->style);
        put_curve(out, curve, model, VARIANT_PLAIN, sigma_m, model->style, model->label);
        if (out->row->y == FIGURE_SEPARATION && model->family == SCENE_MODEL_STATISTICAL) {
            snprintf(style, sizeof style, "%sa", model->style);
            snprintf(legend, sizeof legend, "%s, adjusted", model->label);
            put_curve(out, curve, model, VARIANT_ADJUSTED, sigma_m, style, legend);
        }
        if (out->row->y == FIGURE_TCR && plan_runs(plan, EFFECT_SCALE_DEPENDENT)) {
            snprintf(style, sizeof style, "%sS", model->style);
            snprintf(legend, sizeof legend, "%s, scale-dependent", model->label);
            put_curve(out, curve, model, VARIANT_SCALE_DEPENDENT, sigma_m, style, legend);
        }
    }
    if (out->blocks == 0) /* gnuplot complains of a file without any */
        begin_block(out, model_rows[0].style, "no model exists for this surface");
}

static void surface_legend(char *legend, size_t size, const struct surface_summary *summary)
{
    snprintf(legend, size, "%s, Rq %.3g µm", summary->scene->name, summary->roughness.rq_m * 1e6);
}

/** Spectrum of one surface: points (thinned evenly in log wavelength), the fit over its band, the fit beyond. */
static void put_spectrum(struct figure_file *out, const struct surface_record *record, const char *style,
                         const char *legend)
{
    enum { MOST = 400 };
    size_t index[MOST], count = results_sweep_scales(index, MOST, record->spectrum.count);
    const struct powerlaw *law = &record->summary.law;
    double longest = record->spectrum.length_m, shortest = longest / (double)record->spectrum.count;
    begin_block(out, style, legend);
    for (size_t k = 0; k < count; k++)
        put_point(out, 1 / spectrum_frequency(&record->spectrum, index[k]), record->spectrum.amplitude_m[index[k]]);
    char fit[80] = "no power law";
    if (isfinite(law->gamma))
        snprintf(fit, sizeof fit, "α %.3g, γ %.3f ± %.3f", law->alpha, law->gamma, law->gamma_error);
    begin_block(out, "fit", fit);
    for (int i = 0; i < 2; i++)
        put_point(out, law->band_m[i], powerlaw_amplitude(law, law->band_m[i]));
    begin_block(out, "fitx", fit);
    put_point(out, shortest, powerlaw_amplitude(law, shortest));
    put_point(out, law->band_m[0], powerlaw_amplitude(law, law->band_m[0]));
}

static enum status_code put_surfaces(struct figure_file *out, const struct results *results, struct status *status)
{
    for (size_t k = 0; k < results->shown_count; k++) {
        struct surface_record record;
        if (spool_get(&record, results->spool, results->shown[k], status) != STATUS_OK)
            return status->code;
        const struct figure_row *row = out->row;
        char legend[200], style[24];
        surface_legend(legend, sizeof legend, &record.summary);
        snprintf(style, sizeof style, "s%zu", k + 1);
        if (row->kind == FIGURE_PROFILES) {
            begin_block(out, style, legend);
            for (size_t i = 0; i < record.preview_points; i++)
                fprintf(out->file, "%.9g,%.9g\n", record.preview_x_m[i] * 1e3, record.preview_z_m[i] * 1e6);
        } else if (row->kind == FIGURE_SPECTRA) {
            put_spectrum(out, &record, style, legend);
        } else {
            const struct model_row *model = &model_rows[row->model];
            enum variant variant = model->family == SCENE_MODEL_STATISTICAL ? VARIANT_ADJUSTED : VARIANT_PLAIN;
            put_band(out, &record, row->model, style);
            put_curve(out, &record.curves[row->model], model, variant, record.summary.asperities.sigma_m, style,
                      legend);
        }
        surface_record_free(&record, false);
    }
    return STATUS_OK;
}

static void put_sweep(struct figure_file *out, const struct results *results)
{
    enum { MOST = 150 };
    const struct scene_convergence *study = &results->scene->convergence;
    const struct convergence_sweep_row *sweep = &convergence_sweeps[out->row->sweep];
    size_t index[MOST], count = results_sweep_scales(index, MOST, study->scales);
    for (size_t v = 0; v < sweep->count; v++) {
        char legend[40], style[24];
        snprintf(legend, sizeof legend, "%s = %g", out->row->sweep == CONVERGENCE_ALPHA ? "α" : "γ", sweep->values[v]);
        snprintf(style, sizeof style, "r%zu", v + 1);
        begin_block(out, style, legend);
        const double *area = results_sweep(results, out->row->sweep, model_rows[out->row->model].plastic, v);
        for (size_t k = 0; k < count; k++)
            put_point(out, study->scan_length_m / (double)(index[k] + 1), area[index[k]]);
    }
}

/** One line a study and method, and a ring round what the report uses. */
static void put_cost(struct figure_file *out, const struct cost *cost)
{
    const double floor = 1e-16; /* an error of exactly 0 has no place on a logarithmic axis */
    size_t methods = 0;
    const struct cost_row *before = NULL;
    for (size_t i = 0; i < cost->count; before = &cost->rows[i++]) {
        const struct cost_row *row = &cost->rows[i];
        if (row->chart != out->row->cost)
            continue;
        if (!before || strcmp(before->study, row->study) != 0 || strcmp(before->method, row->method) != 0) {
            char legend[80], style[24];
            bool integral = row->chart == COST_INTEGRALS;
            snprintf(style, sizeof style, "c%zu", methods++ % 9 + 1);
            snprintf(legend, sizeof legend, "%s, %s", integral ? (row->study[0] == 'g' ? "GW" : "JG") : row->method,
                     integral ? row->method : row->study);
            begin_block(out, style, legend);
        }
        fprintf(out->file, "%.17g,%.17g\n", row->seconds, fmax(row->error, floor));
    }
    begin_block(out, "choice", "used in this report");
    for (size_t i = 0; i < cost->count; i++)
        if (cost->rows[i].chart == out->row->cost && cost->rows[i].chosen)
            fprintf(out->file, "%.17g,%.17g\n", cost->rows[i].seconds, fmax(cost->rows[i].error, floor));
}

enum status_code figure_data_put(struct figure_file *file, const struct results *results,
                                 const struct surface_record *baseline, struct status *status)
{
    switch (file->row->kind) {
    case FIGURE_SWEEP:
        put_sweep(file, results);
        break;
    case FIGURE_COST:
        put_cost(file, results->cost);
        break;
    case FIGURE_MODELS:
        put_models(file, baseline, results->plan);
        put_measured(file, results->measured);
        break;
    case FIGURE_SURFACES:
    case FIGURE_PROFILES:
    case FIGURE_SPECTRA:
        return put_surfaces(file, results, status);
    }
    return STATUS_OK;
}
