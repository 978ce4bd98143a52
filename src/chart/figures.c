/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "chart/figures.h"

#include "analysis/direct_study.h"
#include "base/clock.h"
#include "chart/gnuplot.h"
#include "joint/heating.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Surfaces: Okabe and Ito's hues with their lightness moved until each stands out from white, and any two still differ
 * for deuteranopes and protanopes. Sweeps: one ramp from dark violet to gold. Models have their colours in their rows.
 */
static const char *const surface_colours[] = {"#1257d0", "#cc5500", "#1fb380", "#a8366a",
                                              "#ee9400", "#4fa6f0", "#85858f", "#734ca4"};
static const char *const sweep_colours[] = {"#431575", "#2b338f", "#025185", "#04657a", "#017775",
                                            "#058a64", "#4f9737", "#939803", "#c79608"};
static const char ink[] = "#222222", quiet[] = "#8a8a8a";
enum {
    COLOURS = sizeof surface_colours / sizeof *surface_colours,
    DASH_OUTSIDE = 2,
    DASH_OTHER = 4,
    DASH_UNLOADING = 5
};

/* Beyond this A/A_n a resistance goes to 0 over as many decades as a load happens to come close to full contact. */
static const double nearly_full_area = 0.99;
/* A separation of the mean planes may go on below it, to where the statistical models end. */
static const double lowest_separation = -0.5;

/** What the figures are made from. */
struct source {
    const struct results *results;
    const struct comparison *comparison;
    const struct surface_record *baseline;
    size_t leading;
};

const char *figures_surface_colour(size_t k)
{
    return surface_colours[k % COLOURS];
}

/** What stands on an axis. */
struct axis {
    enum quantity quantity;
    bool reciprocal;
    double scale; /* what is shown is scale times the quantity, or its inverse */
};

static double on_axis(const struct contact_point *point, const struct axis *axis, double sigma_m)
{
    double value = quantity_shown(point, axis->quantity, sigma_m);
    return axis->reciprocal ? axis->scale / value : axis->scale * value;
}

static bool is_resistance(enum quantity quantity)
{
    return quantity == QUANTITY_JOINT || quantity == QUANTITY_JOINT_ECR ||
           (QUANTITY_BIT(quantity) & QUANTITY_RESISTANCES);
}

/** Points of a curve as one line. */
static void put_part(struct chart *chart, const struct model_curve *curve, size_t from, size_t to, const struct axis *x,
                     const struct axis *y, double sigma_m)
{
    for (size_t i = from; i < to; i++) {
        const struct contact_point *point = &curve->points[i];
        double value = on_axis(point, y, sigma_m);
        if (is_resistance(y->quantity) && point->value[QUANTITY_AREA] > nearly_full_area)
            continue;
        if (quantity_rows[y->quantity].over_sigma && value < lowest_separation)
            continue;
        chart_row(chart, on_axis(point, x, sigma_m), value, 0, 0);
    }
}

/** A curve, dashed outside its model's range of validity. */
static void put_curve(struct chart *chart, const struct model_curve *curve, size_t m, const struct axis *x,
                      const struct axis *y, double sigma_m, const struct chart_curve *look)
{
    if (!curve->exists)
        return;
    struct curve_validity valid = curve_summary_validity(curve, model_rows[m]);
    struct chart_curve outside = *look;
    outside.dash = DASH_OUTSIDE;
    outside.width = 1.2;
    outside.legend = valid.end > valid.first ? "" : look->legend;
    chart_curve(chart, look);
    put_part(chart, curve, valid.first, valid.end, x, y, sigma_m);
    if (valid.first > 0) {
        chart_curve(chart, &outside);
        put_part(chart, curve, 0, valid.first + 1, x, y, sigma_m);
    }
    if (valid.end < curve->count) {
        chart_curve(chart, &outside);
        put_part(chart, curve, valid.end > 0 ? valid.end - 1 : 0, curve->count, x, y, sigma_m);
    }
}

/** The curve of falling load, if that is model m's; named once. */
static void put_unloading(struct chart *chart, const struct source *source, const struct surface_record *record,
                          size_t m, const struct axis *x, const struct axis *y, const struct chart_curve *look)
{
    struct surface_unloading *unloading = record->summary.unloading;
    struct chart_curve falling = *look;
    if (!unloading || unloading->model != m)
        return;
    struct model_curve curve = {.points = unloading->points};
    falling.legend = record == source->baseline ? "unloading" : "";
    falling.dash = DASH_UNLOADING;
    falling.width = 1.6;
    chart_curve(chart, &falling);
    put_part(chart, &curve, 0, unloading->ratio.count, x, y, record->summary.asperities.sigma_m);
}

static struct chart_curve model_look(size_t m)
{
    return (struct chart_curve){.legend = model_rows[m]->label, .colour = model_rows[m]->colour};
}

/** A name as it stands, in at most `most` characters: its middle is cut, as names often differ at their end. */
static void short_name(char *out, size_t size, const char *name, size_t most)
{
    size_t count = 0, at = 0, used = 0, bytes;
    for (const char *c = name; *c; c += bytes, count++)
        bytes = text_character(c) ? text_character(c) : 1;
    for (const char *c = name; *c && used + 8 < size; c += bytes, at++) {
        bytes = text_character(c) ? text_character(c) : 1;
        if (count > most && at == most / 2)
            used += (size_t)snprintf(out + used, size - used, "…");
        if (count <= most || at < most / 2 || at > count - most / 2) {
            memcpy(out + used, c, bytes);
            used += bytes;
        }
    }
    out[used] = '\0';
}

/** Of more than eight surfaces the best, the worst and the baseline stand out. */
static struct chart_curve surface_look(const struct source *source, size_t k, char *legend, size_t size)
{
    const struct results *results = source->results;
    bool many = results->usable_count > results->shown_count;
    bool baseline = results->shown[k] == results->baseline, last = k + 1 == results->shown_count;
    bool plain = many && k > 0 && !last && !baseline;
    char name[100];
    short_name(name, sizeof name, results->surfaces[results->shown[k]].summary.scene->name, 28);
    snprintf(legend, size, "%s%s%s", name,
             many && k == 0 ? ", best"
             : many && last ? ", worst"
                            : "",
             many && baseline ? ", baseline" : "");
    return (struct chart_curve){.legend = plain ? "others" : legend,
                                .colour = plain ? "#b4b4bc" : figures_surface_colour(k),
                                .width = plain ? 1.2 : 2};
}

static struct axis load_axis(const struct source *source, size_t surface)
{
    return (struct axis){QUANTITY_LOAD, false, results_load_axis(source->results, surface).scale};
}

/** "load (N)", "pressure (bar)", "load P/(Aₙ E′)" of the charts after the first page. */
static const char *load_label(const struct source *source, char *out, size_t size)
{
    const struct results_load_axis axis = results_load_axis(source->results, source->results->baseline);
    char unit[64];
    asked_unit(unit, sizeof unit, axis.unit ? axis.unit : "");
    snprintf(out, size, axis.unit ? "%s (%s)" : "%s%s",
             !axis.unit                                        ? quantity_rows[QUANTITY_LOAD].label
             : source->results->scene->load.kind == UNIT_FORCE ? "load"
                                                               : "pressure",
             unit);
    return out;
}

/** The same of the unit that the user has loads in. */
static void asked_load_label(char *out, size_t size, const struct results *results, const struct asked_load *load)
{
    bool force = results->scene->load.unit_text[0] ? results->scene->load.kind == UNIT_FORCE
                                                   : isfinite(results->scene->nominal_area_m2);
    snprintf(out, size,
             !load->unit[0] ? "%s"
             : force        ? "load (%s)"
                            : "pressure (%s)",
             load->unit[0] ? load->unit : quantity_rows[QUANTITY_LOAD].label);
}

/* ---- The first page ---- */

/** The 95 % band of the asked quantity about a curve. */
static void put_band(struct chart *chart, const struct surface_record *record, size_t m, const struct asked *asked,
                     double load_scale, const char *colour)
{
    const struct model_curve *curve = &record->curves[m];
    if (!record->bands || !record->bands[m])
        return;
    chart_curve(chart, &(struct chart_curve){.kind = CHART_BAND, .legend = "", .colour = colour});
    for (size_t i = 0; i < record->band_count && i < curve->count; i++) {
        double ends[2];
        if (record->bands[m][i].load != curve->points[i].value[QUANTITY_LOAD] ||
            (is_resistance(asked->quantity) && curve->points[i].value[QUANTITY_AREA] > nearly_full_area))
            continue;
        asked_ends(ends, asked, &curve->points[i], (const double(*)[2])record->bands[m][i].mean);
        chart_row(chart, load_scale * record->bands[m][i].load, ends[0], ends[1], 0);
    }
}

/** What was measured, loading filled, unloading open: from the largest load on. */
static void put_measured(struct chart *chart, const struct measured *measured, const struct asked *asked, double scale)
{
    size_t turn = measured_turn(measured);
    for (int branch = 0; branch < 2; branch++) {
        bool both = turn + 1 < measured->count && turn > 0;
        chart_curve(chart, &(struct chart_curve){.kind = CHART_BARS,
                                                 .legend = !both    ? "measured"
                                                           : branch ? "measured, unloading"
                                                                    : "measured, loading",
                                                 .colour = ink,
                                                 .marker = both && branch ? 6 : 7});
        for (size_t i = branch ? turn + 1 : 0; i < (branch ? measured->count : turn + 1); i++) {
            double error = isnan(measured->error[i]) ? 0 : measured->error[i], value = measured->resistance[i];
            double ends[2] = {asked_shown(asked, fmax(value - error, value * 1e-3)), asked_shown(asked, value + error)};
            chart_row(chart, scale * measured->load[i], asked_shown(asked, value), fmin(ends[0], ends[1]),
                      fmax(ends[0], ends[1]));
        }
    }
}

/** The direct solutions in the asked quantity: with what lies in the joint where it is made of that. */
static void put_direct(struct chart *chart, const struct source *source, const struct asked *asked, double scale)
{
    const struct results *results = source->results;
    for (size_t k = 0; k < results->direct_count; k++) {
        const struct direct_study *study = &results->direct[k];
        enum direct_study_kind kind = direct_study_kind_of(study, source->leading);
        if (study->surface != results->baseline || quantity_rows[asked->quantity].from)
            continue;
        chart_curve(chart, &(struct chart_curve){
                               .kind = CHART_BARS, .legend = "direct solution", .colour = "#c2185b", .marker = 5});
        for (size_t i = 0; i < study->curves[kind].loads; i++) {
            double error, value = direct_study_value(study, results_pair(results, study->surface), kind,
                                                     asked->quantity, i, &error);
            error = isnan(error) ? 0 : error;
            double a = asked_shown(asked, fmax(value - error, value * 1e-3)), b = asked_shown(asked, value + error);
            if (value > 0)
                chart_row(chart, scale * study->plan.load[i], asked_shown(asked, value), fmin(a, b), fmax(a, b));
        }
    }
}

static void make_answer(struct chart *chart, const struct source *source)
{
    const struct results *results = source->results;
    const struct asked asked = asked_of(results);
    const struct asked_load load = asked_load_of(results, results->baseline);
    const struct axis y = {asked.quantity, asked.reciprocal, asked.scale};
    size_t textbook = asked_textbook(results);
    char x_label[CHART_TEXT], y_label[CHART_TEXT], legend[120];
    asked_load_label(x_label, sizeof x_label, results, &load);
    snprintf(y_label, sizeof y_label, asked.unit[0] ? "%s (%s)" : "%s", asked.symbol, asked.unit);
    if (!chart_panel(chart, "", x_label, y_label, true, true))
        return;
    for (size_t k = 0; k < results->shown_count && results->shown_count <= 4; k++)
        put_band(chart, &results->surfaces[results->shown[k]], source->leading, &asked,
                 asked_load_of(results, results->shown[k]).scale, figures_surface_colour(k));
    if (textbook < model_count && textbook != source->leading) {
        const struct axis x = {QUANTITY_LOAD, false, load.scale};
        snprintf(legend, sizeof legend, "textbook (%s)", model_rows[textbook]->label);
        put_curve(chart, &source->baseline->curves[textbook], textbook, &x, &y,
                  source->baseline->summary.asperities.sigma_m,
                  &(struct chart_curve){.legend = legend, .colour = quiet, .dash = DASH_OTHER});
    }
    for (size_t k = 0; k < results->shown_count; k++) {
        const struct surface_record *record = &results->surfaces[results->shown[k]];
        const struct axis x = {QUANTITY_LOAD, false, asked_load_of(results, results->shown[k]).scale};
        struct chart_curve look = surface_look(source, k, legend, sizeof legend);
        look.width = look.width < 2 ? look.width : 2.6;
        put_curve(chart, &record->curves[source->leading], source->leading, &x, &y, record->summary.asperities.sigma_m,
                  &look);
        put_unloading(chart, source, record, source->leading, &x, &y, &look);
    }
    put_direct(chart, source, &asked, load.scale);
    if (results->measured && asked.quantity == measured_quantity(results->measured, results->plan->running))
        put_measured(chart, results->measured, &asked, load.scale);
    if (asked.target)
        chart_mark(chart, false, asked_shown(&asked, asked.target->value), "target");
    chart_mark(chart, true, load.scale * results_operating_load(results, results->baseline), "operating load");
}

/** A model at the operating load on the baseline. */
struct row {
    double value, ends[2];
    const char *label, *colour;
    double distance;
};

static int nearer(const void *a, const void *b)
{
    const struct row *f = a, *g = b;
    return (f->distance > g->distance) - (f->distance < g->distance);
}

/** Every model and the direct solution, the nearest to it (else to the leading model) on top. */
static void make_models(struct chart *chart, const struct source *source)
{
    const struct results *results = source->results;
    const struct asked asked = asked_of(results);
    struct row *rows = calloc(model_count + 1, sizeof *rows);
    size_t count = 0;
    char x_label[CHART_TEXT];
    double load = results_operating_load(results, results->baseline);
    const struct asked_solved solved = asked_direct(results, asked.quantity, load);
    bool known = solved.load == load && !quantity_rows[asked.quantity].from;
    double direct = known ? asked_shown(&asked, solved.value) : NAN, error = solved.error;
    double truth =
        known
            ? direct
            : asked_shown(&asked, comparison_middle(results, source->leading, results->baseline).value[asked.quantity]);
    snprintf(x_label, sizeof x_label, asked.unit[0] ? "%s at the operating load (%s)" : "%s at the operating load",
             asked.symbol, asked.unit);
    if (!rows || !chart_panel(chart, "", x_label, "", true, false)) {
        free(rows);
        chart->failed = true;
        return;
    }
    if (known)
        rows[count++] =
            (struct row){direct, {direct / (1 + error), direct * (1 + error)}, "direct solution", "#c2185b", -1};
    for (size_t m = 0; m < model_count; m++) {
        const struct contact_point at = comparison_middle(results, m, results->baseline);
        struct row row = {asked_shown(&asked, at.value[asked.quantity]),
                          {NAN, NAN},
                          model_rows[m]->label,
                          model_rows[m]->colour,
                          NAN};
        if (!plan_runs_model(results->plan, m) || !(row.value > 0) || !isfinite(row.value))
            continue;
        asked_interval(row.ends, &asked, results, m, results->baseline);
        row.distance = m == source->leading && !known ? -1 : fabs(log(row.value / truth));
        rows[count++] = row;
    }
    qsort(rows, count, sizeof *rows, nearer);
    for (size_t r = 0; r < count; r++) {
        double y = (double)(count - r);
        bool ends = rows[r].ends[0] > 0 && isfinite(rows[r].ends[1]);
        chart_name_row(chart, y, rows[r].label);
        chart_curve(chart, &(struct chart_curve){.kind = CHART_DOTS, .legend = "", .colour = rows[r].colour});
        chart_row(chart, rows[r].value, y, ends ? rows[r].ends[0] : rows[r].value,
                  ends ? rows[r].ends[1] : rows[r].value);
    }
    if (asked.target)
        chart_mark(chart, true, asked_shown(&asked, asked.target->value), "target");
    chart->panel_height = 40 + 24 * (double)count;
    free(rows);
}

/* ---- The surfaces ---- */

/** Bins of the spectrum that the law was, or was not, fitted to. */
static void put_bins(struct chart *chart, const struct power_law_band *band, bool used)
{
    chart_curve(chart, &(struct chart_curve){
                           .kind = CHART_BARS, .legend = "", .colour = used ? ink : "#a0a0a8", .marker = used ? 7 : 6});
    for (size_t j = 0; j < band->bins; j++) {
        double s = sqrt(band->bin[j].variance), y = band->bin[j].y;
        if ((band->use[j] == POWER_LAW_BAND_USED) == used)
            chart_row(chart, pow(10, band->bin[j].x) * 1e6, pow(10, y) * 1e6, pow(10, y - s) * 1e6,
                      pow(10, y + s) * 1e6);
    }
}

static void put_profile(struct chart *chart, const struct surface_record *record, const char *name, const char *colour)
{
    char title[CHART_TEXT], cut[120];
    short_name(cut, sizeof cut, name, 28);
    snprintf(title, sizeof title, "%s, Rq %.3g µm", cut, record->summary.roughness.rq_m * 1e6);
    struct chart_panel *panel = chart_panel(chart, title, "position (mm)", "height (µm)", false, false);
    if (!panel)
        return;
    panel->alone = true;
    chart_curve(chart, &(struct chart_curve){.legend = "", .width = 1, .colour = colour});
    for (size_t i = 0; i < record->preview_points; i++)
        chart_row(chart, record->preview_x_m[i] * 1e3, record->preview_z_m[i] * 1e6, 0, 0);
}

static void put_spectrum(struct chart *chart, const struct surface_record *record, const char *colour)
{
    enum { MOST = 300 };
    const struct power_law *law = &record->summary.power_law;
    size_t index[MOST], count = results_sweep_scales(index, MOST, record->spectrum.count);
    char title[CHART_TEXT];
    snprintf(title, sizeof title, isfinite(law->gamma) ? "γ %.2f ± %.2f" : "no power law", law->gamma,
             law->gamma_error);
    if (!chart_panel(chart, title, "wavelength (µm)", "amplitude (µm)", true, true))
        return;
    chart_curve(chart, &(struct chart_curve){.legend = "", .width = 0.8, .colour = colour});
    for (size_t i = 0; i < count; i++)
        chart_row(chart, 1e6 / spectrum_frequency(&record->spectrum, index[i]),
                  record->spectrum.amplitude_m[index[i]] * 1e6, 0, 0);
    if (record->band && record->band->bins > 0) {
        put_bins(chart, record->band, true);
        put_bins(chart, record->band, false);
    }
    chart_curve(chart, &(struct chart_curve){.legend = "", .colour = ink, .width = 2.4});
    for (int i = 0; i < 2; i++)
        chart_row(chart, law->band_m[i] * 1e6, power_law_amplitude(law, law->band_m[i]) * 1e6, 0, 0);
    for (size_t i = 0; record->band && i + 1 < record->band->pieces; i++)
        chart_mark(chart, true, record->band->knee_m[i] * 1e6, "");
}

/** A row a surface: its profile, and its spectrum on the axes of all. */
static void make_surfaces(struct chart *chart, const struct source *source)
{
    const struct results *results = source->results;
    chart->shares = true;
    chart->columns = 2;
    chart->panel_height = 76;
    for (size_t k = 0; k < results->shown_count; k++) {
        const struct surface_record *record = &results->surfaces[results->shown[k]];
        put_profile(chart, record, record->summary.scene->name, figures_surface_colour(k));
        put_spectrum(chart, record, figures_surface_colour(k));
    }
    if (results->counterface)
        put_profile(chart, results->counterface, "counterface", quiet);
}

/* ---- Chapter 6 ---- */

static void make_convergence(struct chart *chart, const struct source *source)
{
    enum { MOST = 120 };
    const struct results *results = source->results;
    const struct scene_convergence *study = &results->scene->convergence;
    static const char *const parameter[] = {[CONVERGENCE_ALPHA] = "α", [CONVERGENCE_GAMMA] = "γ"};
    size_t index[MOST], count = results_sweep_scales(index, MOST, study->scales);
    int number = 1;
    chart->shares = true;
    chart->panel_height = 80;
    for (int s = 0; s < CONVERGENCE_SWEEP_COUNT; s++)
        for (size_t m = 0; m < model_count; m++) {
            const struct convergence_sweep_row *sweep = &convergence_sweeps[s];
            char title[CHART_TEXT], legend[40];
            if (!plan_runs_model(results->plan, m) || !model_rows[m]->stacks_scales)
                continue;
            snprintf(title, sizeof title, "6-%02d  %s varied, %s", number++, parameter[s], model_rows[m]->label);
            if (!chart_panel(chart, title, "shortest wavelength included (m)", "area ratio A/Aₙ", true, true))
                return;
            for (size_t v = 0; v < sweep->count; v++) {
                const double *area = results_sweep(results, (enum convergence_sweep)s, m, v);
                snprintf(legend, sizeof legend, "%s = %g", parameter[s], sweep->values[v]);
                chart_curve(chart, &(struct chart_curve){.legend = legend,
                                                         .dash = s == CONVERGENCE_GAMMA ? 4 : 1,
                                                         .colour = sweep_colours[8 * v / (sweep->count - 1)]});
                for (size_t k = 0; k < count; k++)
                    chart_row(chart, study->scan_length_m / (double)(index[k] + 1), area[index[k]], 0, 0);
            }
        }
}

/** Does this model's quantity have a chart of its own here? */
static bool computes(const struct source *source, size_t m, enum quantity quantity)
{
    return plan_runs_model(source->results->plan, m) &&
           (quantity_with_made(model_rows[m]->quantities) & source->results->plan->wanted & QUANTITY_BIT(quantity));
}

/* The charts of one surface, and of all. */
static const struct quantity_figure {
    int number, first; /* of the one surface's panel, and of the four of all surfaces, in chapter 6 */
    const char *name;  /* of the latter's file */
    enum quantity x, y, also;
} quantity_figures[] = {
    {5, 11, "area", QUANTITY_LOAD, QUANTITY_AREA, QUANTITY_LOAD},
    {7, 15, "separation-load", QUANTITY_LOAD, QUANTITY_SEPARATION, QUANTITY_ADJUSTED},
    {6, 19, "separation-area", QUANTITY_AREA, QUANTITY_SEPARATION, QUANTITY_ADJUSTED},
    {8, 23, "ecr", QUANTITY_LOAD, QUANTITY_ECR, QUANTITY_LOAD},
    {9, 27, "tcr", QUANTITY_LOAD, QUANTITY_TCR, QUANTITY_TCR_SCALE_DEPENDENT},
};
enum { QUANTITY_FIGURES = sizeof quantity_figures / sizeof *quantity_figures };

static struct axis axis_of(const struct source *source, enum quantity quantity, size_t surface)
{
    return quantity == QUANTITY_LOAD ? load_axis(source, surface) : (struct axis){quantity, false, 1};
}

static const char *label_of(const struct source *source, enum quantity quantity, char *out, size_t size)
{
    return quantity == QUANTITY_LOAD ? load_label(source, out, size) : quantity_rows[quantity].label;
}

/** The baseline in every model; statistical separations adjusted, scale-dependent resistances dashed. */
static void make_one_surface(struct chart *chart, const struct source *source)
{
    const struct surface_record *record = source->baseline;
    size_t surface = source->results->baseline;
    chart->panel_height = 88;
    for (size_t f = 0; f < QUANTITY_FIGURES; f++) {
        const struct quantity_figure *figure = &quantity_figures[f];
        char title[CHART_TEXT], label[CHART_TEXT];
        const struct axis x = axis_of(source, figure->x, surface);
        if (!(plan_quantities(source->results->plan) & QUANTITY_BIT(figure->y)))
            continue;
        snprintf(title, sizeof title, "6-%02d  %s versus %s", figure->number,
                 figure->y == QUANTITY_SEPARATION ? "Gap" : quantity_rows[figure->y].title,
                 quantity_rows[figure->x].short_symbol);
        struct chart_panel *panel =
            chart_panel(chart, title, label_of(source, figure->x, label, sizeof label), quantity_rows[figure->y].label,
                        quantity_rows[figure->x].logarithmic, quantity_rows[figure->y].logarithmic);
        for (size_t m = 0; panel && m < model_count; m++) {
            const struct axis y = {model_shown(model_rows[m], figure->y), false, 1}, also = {figure->also, false, 1};
            struct chart_curve look = model_look(m);
            if (!computes(source, m, figure->y))
                continue;
            put_curve(chart, &record->curves[m], m, &x, &y, record->summary.asperities.sigma_m, &look);
            look.dash = 3;
            look.width = 1.4;
            look.legend = "";
            if (figure->also == QUANTITY_TCR_SCALE_DEPENDENT && computes(source, m, figure->also))
                put_curve(chart, &record->curves[m], m, &x, &also, record->summary.asperities.sigma_m, &look);
        }
    }
}

/** All surfaces, a panel a model: the thesis's in its own order, then the leading one. */
static void make_all_surfaces(struct chart *chart, const struct source *source, const struct quantity_figure *figure)
{
    const struct results *results = source->results;
    chart->shares = true;
    for (int place = 1; place <= 5; place++)
        for (size_t m = 0; m < model_count; m++) {
            char title[CHART_TEXT], label[CHART_TEXT], legend[120];
            bool leads = m == source->leading && model_rows[m]->thesis_place == 0;
            if (!computes(source, m, figure->y) || (place < 5 ? model_rows[m]->thesis_place != place : !leads))
                continue;
            if (place < 5)
                snprintf(title, sizeof title, "6-%02d  %s", figure->first + place - 1, model_rows[m]->label);
            else
                snprintf(title, sizeof title, "%s", model_rows[m]->label);
            if (!chart_panel(chart, title, label_of(source, figure->x, label, sizeof label),
                             quantity_rows[figure->y].label, quantity_rows[figure->x].logarithmic,
                             quantity_rows[figure->y].logarithmic))
                return;
            for (size_t k = 0; k < results->shown_count; k++) {
                const struct surface_record *record = &results->surfaces[results->shown[k]];
                const struct axis x = axis_of(source, figure->x, results->shown[k]),
                                  y = {model_shown(model_rows[m], figure->y), false, 1},
                                  also = {figure->also, false, 1};
                struct chart_curve look = surface_look(source, k, legend, sizeof legend);
                put_curve(chart, &record->curves[m], m, &x, &y, record->summary.asperities.sigma_m, &look);
                put_unloading(chart, source, record, m, &x, &y, &look);
                look.dash = 3;
                look.width = 1.4;
                look.legend = "";
                if (figure->also == QUANTITY_TCR_SCALE_DEPENDENT && computes(source, m, figure->also))
                    put_curve(chart, &record->curves[m], m, &x, &also, record->summary.asperities.sigma_m, &look);
            }
        }
    if (source->results->convergence || chart->panels > 1) {
        size_t thesis = 0;
        for (size_t m = 0; m < model_count; m++)
            thesis += computes(source, m, figure->y) && model_rows[m]->thesis_place > 0;
        if (thesis == 4)
            snprintf(chart->numbers, sizeof chart->numbers, "6-%02d to 6-%02d", figure->first, figure->first + 3);
    }
}

/* ---- What is called for ---- */

/** The metal that melts first, °C; NaN: not known. */
static double melting_C(const struct source *source)
{
    const struct scene_bodies *bodies = &source->baseline->summary.scene->bodies;
    const struct heating_metal *metal = heating_metal_find(bodies->material.name);
    return metal ? metal->melting_K - 273.15 : NAN;
}

static void make_joint(struct chart *chart, const struct source *source)
{
    static const struct {
        enum quantity quantity;
        const char *title, *label;
    } panels[] = {{QUANTITY_JOINT, "Joint conductance", "W/(m²·K)"},
                  {QUANTITY_GAP, "Conductance of the gaps", "W/(m²·K)"},
                  {QUANTITY_JOINT_ECR, "ECR with film and plating", "Ω·m²"},
                  {QUANTITY_TEMPERATURE, "Hottest place", "°C"}};
    for (size_t p = 0; p < sizeof panels / sizeof *panels; p++) {
        enum quantity quantity = panels[p].quantity;
        char label[CHART_TEXT];
        const struct axis x = load_axis(source, source->results->baseline), y = {quantity, false, 1};
        if (!(plan_quantities(source->results->plan) & QUANTITY_BIT(quantity)))
            continue;
        bool heat = quantity == QUANTITY_TEMPERATURE;
        struct chart_panel *panel =
            chart_panel(chart, panels[p].title, load_label(source, label, sizeof label), panels[p].label, true, !heat);
        if (!panel)
            return;
        for (size_t m = 0; m < model_count; m++) {
            const struct model_curve *curve = &source->baseline->curves[m];
            struct chart_curve look = model_look(m);
            if (!curve->exists || !computes(source, m, quantity))
                continue;
            if (!heat) {
                put_curve(chart, curve, m, &x, &y, NAN, &look);
                continue;
            }
            chart_curve(chart, &look);
            for (size_t i = 0; i < curve->count; i++) {
                double at_C = curve->points[i].value[quantity] - 273.15;
                if (!(at_C > melting_C(source)) && at_C < 1000)
                    chart_row(chart, x.scale * curve->points[i].value[QUANTITY_LOAD], at_C, 0, 0);
            }
        }
    }
}

static void make_measured(struct chart *chart, const struct source *source)
{
    const struct results *results = source->results;
    const struct asked_load load = asked_load_of(results, results->baseline);
    struct asked asked = asked_of(results);
    char x_label[CHART_TEXT], y_label[CHART_TEXT];
    if (asked.quantity != measured_quantity(results->measured, results->plan->running))
        asked = (struct asked){.quantity = measured_quantity(results->measured, results->plan->running), .scale = 1};
    const struct axis x = {QUANTITY_LOAD, false, load.scale}, y = {asked.quantity, asked.reciprocal, asked.scale};
    asked_load_label(x_label, sizeof x_label, results, &load);
    snprintf(y_label, sizeof y_label, "%s%s%s%s", asked.unit[0] ? asked.symbol : quantity_rows[asked.quantity].label,
             asked.unit[0] ? " (" : "", asked.unit, asked.unit[0] ? ")" : "");
    if (!chart_panel(chart, "", x_label, y_label, true, true))
        return;
    for (size_t m = 0; m < model_count; m++)
        if (computes(source, m, asked.quantity)) {
            const struct chart_curve look = model_look(m);
            put_curve(chart, &source->baseline->curves[m], m, &x, &y, NAN, &look);
            put_unloading(chart, source, source->baseline, m, &x, &y, &look);
        }
    put_measured(chart, results->measured, &asked, load.scale);
}

/** The models over the direct solution of the baseline, and how far that may itself be off. */
static void make_direct(struct chart *chart, const struct source *source)
{
    const struct results *results = source->results;
    const struct direct_study *study = NULL;
    char label[CHART_TEXT], x_label[CHART_TEXT];
    chart->shares = true;
    chart->panel_height = 160;
    for (size_t k = 0; k < results->direct_count; k++)
        if (results->direct[k].surface == results->baseline)
            study = &results->direct[k];
    for (int q = 0; study && q < DIRECT_STUDY_QUANTITIES; q++) {
        const struct material_pair *pair = results_pair(results, study->surface);
        const enum quantity quantity = direct_study_quantities[q];
        const double scale = load_axis(source, study->surface).scale;
        snprintf(label, sizeof label, "%s", quantity == QUANTITY_SEPARATION ? "Gap" : quantity_rows[quantity].title);
        struct chart_panel *panel =
            results->plan->wanted & QUANTITY_BIT(quantity)
                ? chart_panel(chart, label, load_label(source, x_label, sizeof x_label), "model / direct", true, true)
                : NULL;
        if (!panel)
            continue;
        panel->y_most = (struct chart_extent){0.1, 10};
        chart_curve(chart,
                    &(struct chart_curve){.kind = CHART_BAND, .legend = "error of the direct solution", .colour = ink});
        for (size_t i = 0; i < study->plan.loads; i++) {
            double error, value = direct_study_value(study, pair, study->leading, quantity, i, &error);
            double share =
                fmax(isnan(error) ? 0 : error / value, direct_study_grid_error(study, study->leading, quantity, i));
            if (value > 0)
                chart_row(chart, scale * study->plan.load[i], 1 / (1 + share), 1 + share, 0);
        }
        for (size_t m = 0; m < model_count; m++) {
            const struct chart_curve look = model_look(m);
            chart_curve(chart, &look);
            for (size_t i = 0; i < study->plan.loads && computes(source, m, quantity); i++)
                chart_row(chart, scale * study->plan.load[i], direct_study_ratio(study, pair, m, quantity, i), 0, 0);
        }
        chart_mark(chart, false, 1, "");
    }
}

/** Error against time: the report's own curves at several tolerances, and the rules that could take their place. */
static void make_accuracy(struct chart *chart, const struct source *source)
{
    const struct benchmark *cost = source->results->benchmark;
    const struct benchmark_row *before = NULL, *first = NULL; /* the first integral stands for all */
    size_t methods = 0;
    chart->panel_height = 170;
    if (!chart_panel(chart, "", "time (ms)", "largest relative error", true, true))
        return;
    for (size_t i = 0; i < cost->count; before = &cost->rows[i++]) {
        const struct benchmark_row *row = &cost->rows[i];
        bool own = strcmp(row->study, "tolerance") == 0;
        char legend[160];
        if (!own && (row->chart != BENCHMARK_INTEGRALS || (first && row->model != first->model)))
            continue;
        first = own || first ? first : row;
        if (!before || strcmp(before->study, row->study) != 0 || strcmp(before->method, row->method) != 0) {
            snprintf(legend, sizeof legend, own ? "all curves of this report" : "integrals of %s by %s",
                     row->model ? row->model->label : "", row->method);
            chart_curve(chart, &(struct chart_curve){.legend = legend,
                                                     .width = own ? 3 : 1.4,
                                                     .colour = own ? "#1257d0" : figures_surface_colour(++methods)});
        }
        if (row->error >= 1e-16)
            chart_row(chart, row->seconds * 1e3, row->error, 0, 0);
    }
    chart_mark(chart, false, source->results->scene->tolerance, "tolerance used");
}

/* ---- The list ---- */

/** A chart that was filled stays in the list; one without data goes. */
static void keep(struct figures *out, struct chart *chart)
{
    chart_end(chart);
    if (chart_has_data(chart) || chart->failed)
        out->chart[out->count++] = *chart;
    else
        chart_free(chart);
}

static bool has_joint(const struct source *source)
{
    return plan_quantities(source->results->plan) &
           (QUANTITY_BIT(QUANTITY_JOINT) | QUANTITY_BIT(QUANTITY_JOINT_ECR) | QUANTITY_BIT(QUANTITY_TEMPERATURE));
}

static bool has_sweeps(const struct source *source)
{
    return source->results->convergence;
}

static bool has_measured(const struct source *source)
{
    return source->results->measured;
}

static bool has_direct(const struct source *source)
{
    return source->results->direct_count > 0;
}

static bool has_benchmark(const struct source *source)
{
    return source->results->benchmark;
}

/* In the report's order; those of all surfaces come between. */
static const struct figure_row {
    const char *name, *numbers;
    bool first_page, terminal;
    bool (*called_for)(const struct source *source); /* NULL: always */
    void (*make)(struct chart *chart, const struct source *source);
} figure_rows[] = {
    {"answer", "", true, true, NULL, make_answer},
    {"models", "", true, false, NULL, make_models},
    {"surfaces", "6-10", false, false, NULL, make_surfaces},
    {"convergence", "6-01 to 6-04", false, false, has_sweeps, make_convergence},
    {"one-surface", "6-05 to 6-09", false, false, NULL, make_one_surface},
    {"joint", "", false, false, has_joint, make_joint},
    {"measured", "", false, false, has_measured, make_measured},
    {"direct", "", false, true, has_direct, make_direct},
    {"accuracy", "", false, false, has_benchmark, make_accuracy},
};
enum { FIGURE_ROWS = sizeof figure_rows / sizeof *figure_rows };

enum status_code figures_make(struct figures *out, const struct results *results, const struct comparison *comparison,
                              bool brief, struct status *status)
{
    const struct asked asked = asked_of(results);
    const struct source source = {results, comparison, &results->surfaces[results->baseline],
                                  asked_leading(results, &asked)};
    *out = (struct figures){.chart = calloc(FIGURE_ROWS + QUANTITY_FIGURES, sizeof *out->chart)};
    if (!out->chart)
        return status_memory(status);
    for (size_t r = 0; r < FIGURE_ROWS; r++) {
        const struct figure_row *row = &figure_rows[r];
        if ((row->called_for && !row->called_for(&source)) || (brief && !row->first_page))
            continue;
        struct chart chart = chart_make(row->name);
        snprintf(chart.numbers, sizeof chart.numbers, "%s", row->numbers);
        chart.first_page = row->first_page;
        chart.terminal = row->terminal;
        row->make(&chart, &source);
        keep(out, &chart);
    }
    for (size_t f = 0; f < QUANTITY_FIGURES && !brief; f++) {
        if (!(plan_quantities(results->plan) & QUANTITY_BIT(quantity_figures[f].y)) || results->usable_count < 2)
            continue;
        struct chart chart = chart_make(quantity_figures[f].name);
        make_all_surfaces(&chart, &source, &quantity_figures[f]);
        keep(out, &chart);
    }
    for (size_t i = 0; i < out->count; i++)
        if (out->chart[i].failed)
            return status_memory(status);
    return STATUS_OK;
}

void figures_free(struct figures *figures)
{
    for (size_t i = 0; i < figures->count; i++)
        chart_free(&figures->chart[i]);
    free(figures->chart);
    *figures = (struct figures){0};
}

/** Writes a chart's files and tells gnuplot to draw it, as letters too where it is one for a terminal. */
static enum status_code draw_one(struct chart *chart, struct gnuplot *gnuplot, struct mustache_folder *templates,
                                 const char *directory, const char *terminal_size)
{
    struct text letters = {0};
    enum status_code rc = chart_write(chart, templates, directory);
    if (rc == STATUS_OK)
        gnuplot_send(gnuplot, "load '%s.gp'", chart->name);
    if (rc == STATUS_OK && terminal_size && chart->terminal) {
        rc = chart_script(&letters, chart, templates, terminal_size);
        gnuplot_send(gnuplot, "%s", text_string(&letters));
    }
    text_free(&letters);
    return rc;
}

enum status_code figures_draw(struct figures *figures, const char *directory, const char *templates,
                              const char *terminal_size, struct text *letters, double *seconds, struct status *status)
{
    struct text path = {0}, scripts = {0};
    struct gnuplot gnuplot;
    text_add(&path, "%s/figures", directory);
    struct mustache_folder folder = chart_templates(&scripts, templates, status);
    enum status_code rc = path.failed || scripts.failed ? status_memory(status) : STATUS_OK;
    double begun = clock_seconds();
    if (rc == STATUS_OK && (rc = gnuplot_start(&gnuplot, text_string(&path), status)) == STATUS_OK) {
        struct status own = {0};
        for (size_t i = 0; i < figures->count && rc == STATUS_OK; i++)
            rc = draw_one(&figures->chart[i], &gnuplot, &folder, text_string(&path), terminal_size);
        enum status_code end = gnuplot_finish(&gnuplot, &own);
        if (rc == STATUS_OK && end != STATUS_OK) {
            *status = own;
            rc = end;
        }
    }
    for (size_t i = 0; i < figures->count && rc == STATUS_OK && terminal_size; i++)
        if (figures->chart[i].terminal) {
            struct text file = {0};
            text_add(&file, "%s/%s.txt", text_string(&path), figures->chart[i].name);
            rc = gnuplot_take_text(letters, text_string(&file), status);
            text_free(&file);
        }
    *seconds = clock_seconds() - begun;
    mustache_folder_free(&folder);
    text_free(&path);
    text_free(&scripts);
    return rc;
}
