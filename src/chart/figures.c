/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "chart/figures.h"

#include "answers/direct_study.h"
#include "base/number_format.h"
#include "base/unit.h"
#include "chart/chart.h"
#include "joint/heating.h"
#include "output/record.h"
#include "results/accuracy.h"
#include "results/asked.h"
#include "results/comparison.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* Surfaces: Okabe and Ito's hues with their lightness moved until each stands out from white, and any two still differ
 * for deuteranopes and protanopes. Sweeps: one ramp from dark violet to gold. Models have their colours in their rows.
 */
static const char *const surface_colours[] = {"#1257d0", "#cc5500", "#1fb380", "#a8366a",
                                              "#ee9400", "#4fa6f0", "#85858f", "#734ca4"};
static const char *const sweep_colours[] = {"#431575", "#2b338f", "#025185", "#04657a", "#017775",
                                            "#058a64", "#4f9737", "#939803", "#c79608"};
static const char ink[] = "#222222", quiet[] = "#8a8a8a";
static const char no_break[] = "\u00a0";
enum { COLOURS = sizeof surface_colours / sizeof *surface_colours, DASH_OUTSIDE = 2, DASH_OTHER = 4 };

#define NOTE(note) (1u << (note))

const char *const figure_notes[] = {
    "band", "outside", "adjusted",  "scale_dependent", "last_scale", "cut",   "direct", "few_points",
    "law",  "bins",    "open_bins", "knees",           "measured",   "limit", "bound",  "unadjusted"};
_Static_assert(sizeof figure_notes / sizeof *figure_notes == FIGURE_NOTES, "every note has its name");

/* Beyond this A/A_n a resistance goes to 0 over as many decades as a load happens to come close to full contact. */
static const double nearly_full_area = 0.99;
/* A separation of the mean planes may go on below it, to where the statistical models end. */
static const double lowest_separation = -0.5;

/** What the figures are made from, and how they are drawn. */
struct source {
    const struct results *results;
    const struct surface_record *baseline;
    size_t leading;
    struct asked asked;
    double hottest_C; /* charts of a temperature end there: the metal melts */
    struct words *words;
    const struct figures_task *task;
    struct mustache_folder *templates;
    const char *directory;
};

/** As words_say() has them. */
#define SAY(...) words_say(source->words, __VA_ARGS__)
/** Begins a curve that looks so: members of a struct chart_curve. */
#define CURVE(...) chart_curve(chart, &(struct chart_curve){__VA_ARGS__})

static const char *surface_colour(size_t k)
{
    return surface_colours[k % COLOURS];
}

/** What stands on an axis: its quantity, times a scale. */
static struct asked axis_of(enum quantity quantity, double scale)
{
    return (struct asked){.quantity = quantity, .scale = scale};
}

static double on_axis(const struct contact_point *point, const struct asked *axis, double sigma_m)
{
    return asked_shown(axis, quantity_shown(point, axis->quantity, sigma_m) - quantity_unit(axis->quantity).offset);
}

/** Is point i drawn? Of more than MOST, evenly spread ones and both ends. */
static bool is_drawn(size_t i, size_t count)
{
    enum { MOST = 400 };
    return count <= MOST || i == 0 || i * (MOST - 1) / (count - 1) > (i - 1) * (MOST - 1) / (count - 1);
}

/** Points of a curve as one line over x and y. */
static void put_part(struct chart *chart, const struct source *source, const struct contact_point *points, size_t count,
                     const struct asked axis[2], double sigma_m)
{
    const struct asked *y = &axis[1];
    for (size_t i = 0; i < count; i++) {
        double value = on_axis(&points[i], y, sigma_m);
        bool full =
            (quantity_rows[y->quantity].is & QUANTITY_ENDS) && points[i].value[QUANTITY_AREA] > nearly_full_area;
        chart->curve.notes |= full ? NOTE(FIGURE_CUT) : 0;
        if (full || !is_drawn(i, count) || (quantity_rows[y->quantity].sigma_column && value < lowest_separation) ||
            (quantity_unit(y->quantity).offset != 0 && value > source->hottest_C))
            continue;
        chart_row(chart, on_axis(&points[i], axis, sigma_m), value, 0, 0);
    }
}

/** A model's curve of a surface, dashed outside its range of validity. */
static void put_curve(struct chart *chart, const struct source *source, const struct surface_record *record, size_t m,
                      const struct asked axis[2], struct chart_curve look)
{
    const struct model_curve *curve = &record->curves[m];
    const double sigma_m = record->summary.asperities.sigma_m;
    if (!curve->exists)
        return;
    struct curve_validity valid = curve_summary_validity(curve, model_rows[m]);
    for (int n = 0; n < FIGURE_NOTES && quantity_rows[axis[1].quantity].note; n++)
        look.notes |= strcmp(figure_notes[n], quantity_rows[axis[1].quantity].note) == 0 ? NOTE(n) : 0;
    struct chart_curve outside = look;
    outside.dash = DASH_OUTSIDE;
    outside.width = 1.2;
    outside.legend = valid.end > valid.first ? "" : look.legend;
    outside.notes |= NOTE(FIGURE_OUTSIDE);
    chart_curve(chart, &look);
    put_part(chart, source, curve->points + valid.first, valid.end - valid.first, axis, sigma_m);
    if (valid.first > 0) {
        chart_curve(chart, &outside);
        put_part(chart, source, curve->points, valid.first + 1, axis, sigma_m);
    }
    if (valid.end < curve->count) {
        size_t from = valid.end > 0 ? valid.end - 1 : 0;
        chart_curve(chart, &outside);
        put_part(chart, source, curve->points + from, curve->count - from, axis, sigma_m);
    }
}

static struct chart_curve model_look(size_t m)
{
    return (struct chart_curve){.legend = model_rows[m]->label, .colour = model_rows[m]->colour};
}

/** A name, shortened for a legend or a title. */
static const char *short_name(const struct source *source, const char *name)
{
    OWNED(text_free) struct text cut = {0};
    words_cut(&cut, name, strlen(name), 28);
    return SAY("name\nsurface\t%s", text_string(&cut));
}

/** Of more than eight surfaces the best, the worst and the baseline stand out. */
static struct chart_curve surface_look(const struct source *source, size_t k)
{
    const struct results *results = source->results;
    bool many = results->usable_count > results->shown_count;
    bool baseline = results->shown[k] == results->baseline, last = k + 1 == results->shown_count;
    if (many && k > 0 && !last && !baseline)
        return (struct chart_curve){.legend = SAY("others"), .colour = "#b4b4bc", .width = 1.2};
    const char *name = short_name(source, results->surfaces[results->shown[k]].summary.scene->name);
    return (struct chart_curve){.legend =
                                    SAY("surface\n%s\n%s\n%s\nsurface\t%s", many && k == 0 ? "best" : "",
                                        many && k > 0 && last ? "worst" : "", many && baseline ? "baseline" : "", name),
                                .colour = surface_colour(k),
                                .width = 2};
}

/** That of the baseline, which is always shown; ink where there is no other. */
static const char *baseline_colour(const struct source *source)
{
    size_t k = 0;
    while (k + 1 < source->results->shown_count && source->results->shown[k] != source->results->baseline)
        k++;
    return source->results->usable_count > 1 ? surface_look(source, k).colour : ink;
}

/** Loads in the user's unit; behind the first page, where the scene gives none, P/(A_n E') as in the thesis. */
static struct asked_load load_of(const struct source *source, size_t surface, bool asked)
{
    const struct results *results = source->results;
    if (asked || results->scene->load.unit_text[0] || results->loads_apart)
        return asked_load_of(results, surface);
    return (struct asked_load){"", 1, false};
}

static const char *load_label(const struct source *source, bool asked)
{
    const struct asked_load load = load_of(source, source->results->baseline, asked);
    return SAY("%s\nunit %s",
               !load.unit[0] ? "axis.load_over_AnEp"
               : load.force  ? "axis.force"
                             : "axis.pressure",
               load.unit);
}

/** The asked quantity and its unit, in the words of `name`. */
static const char *asked_label(const struct source *source, const char *name)
{
    return SAY("%s\nasked %s\nunit %s", name, SAY("%s", source->asked.name), source->asked.unit);
}

/** The words of `kind` and a quantity's name. */
static const char *quantity_words(const struct source *source, const char *kind, enum quantity quantity)
{
    return SAY("%s.%s", kind, quantity_rows[quantity].name);
}

/* ---- The first page ---- */

/** The 95 % band of the asked quantity about a curve. */
static void put_band(struct chart *chart, const struct surface_record *record, size_t m, const struct asked *asked,
                     double load_scale, const char *colour)
{
    const struct model_curve *curve = &record->curves[m];
    if (!record->bands || !record->bands[m])
        return;
    CURVE(.kind = CHART_BAND, .legend = "", .colour = colour, .notes = NOTE(FIGURE_BAND));
    size_t count = record->band_count < curve->count ? record->band_count : curve->count;
    for (size_t i = 0; i < count; i++) {
        double ends[2];
        if (!is_drawn(i, count) || record->bands[m][i].load != curve->points[i].value[QUANTITY_LOAD] ||
            ((quantity_rows[asked->quantity].is & QUANTITY_ENDS) &&
             curve->points[i].value[QUANTITY_AREA] > nearly_full_area))
            continue;
        asked_ends(ends, asked, record->bands[m][i].mean[asked->quantity]);
        chart_row(chart, load_scale * record->bands[m][i].load, ends[0], ends[1], 0);
    }
}

/** A value with its error as the asked quantity shows them. */
static void put_bar(struct chart *chart, const struct asked *asked, double load, double value, double error)
{
    error = isnan(error) ? 0 : error;
    double a = asked_shown(asked, fmax(value - error, value * 1e-3)), b = asked_shown(asked, value + error);
    chart_row(chart, load, asked_shown(asked, value), fmin(a, b), fmax(a, b));
}

/** The surface's name, where others shown were measured as well. */
static const char *measured_name(const struct source *source, size_t k)
{
    const struct results *results = source->results;
    size_t measured = 0;
    for (size_t i = 0; i < results->shown_count; i++)
        measured += results_measured(results, results->shown[i]) != NULL;
    return measured > 1 ? short_name(source, results->surfaces[results->shown[k]].summary.scene->name) : "";
}

/** What was measured on a surface shown, in its colour, loading filled, unloading open: from the largest load on. */
static void put_measured(struct chart *chart, const struct source *source, const struct asked *asked, size_t k)
{
    const struct results *results = source->results;
    const struct measured *measured = results_measured(results, results->shown[k]);
    double scale = asked_load_of(results, results->shown[k]).scale;
    struct asked resistance = *asked; /* of which the quantity may be the inverse */
    resistance.reciprocal = asked->reciprocal != ((quantity_rows[asked->quantity].is & QUANTITY_RISES) > 0);
    for (size_t part = 0; measured && part < 2 * measured->run_count; part++) {
        const struct measured_run *run = &measured->runs[part / 2];
        bool branch = part % 2, both = run->turn + 1 < run->end && run->turn > run->first;
        const char *name = !both ? "measured" : branch ? "measured.unloading" : "measured.loading";
        CURVE(.kind = CHART_BARS, .legend = SAY("%s\nsurface\t%s", name, measured_name(source, k)),
              .colour = surface_look(source, k).colour, .marker = both && branch ? 6 : 7);
        for (size_t i = branch ? run->turn + 1 : run->first; i < (branch ? run->end : run->turn + 1); i++)
            put_bar(chart, &resistance, scale * measured->load[i], measured->resistance[i], measured->error[i]);
    }
}

/** Do few points of the grid touch at load `i`? By the area. */
static bool few_touch(const struct direct_study *study, const struct material_pair *pair, enum direct_study_kind kind,
                      size_t i)
{
    double grid = (double)study->plan.grid;
    return direct_study_value(study, pair, kind, QUANTITY_AREA, i, NULL) * grid * grid < FIGURE_FEW_POINTS;
}

/** The direct solutions in the asked quantity: with what lies in the joint where it is made of that. */
static void put_direct(struct chart *chart, const struct source *source, double scale)
{
    const struct direct_study *study = results_direct_baseline(source->results);
    if (!study || quantity_rows[source->asked.quantity].from)
        return;
    const struct material_pair *pair = results_pair(source->results, study->surface);
    enum direct_study_kind kind = direct_study_kind_of(study, source->leading);
    const char *name = short_name(source, source->baseline->summary.scene->name);
    struct chart_curve look = {.kind = CHART_BARS,
                               .legend = SAY("direct\nsurface\t%s", source->results->usable_count > 1 ? name : ""),
                               .colour = baseline_colour(source)};
    for (int few = 0; few < 2; few++) {
        look.marker = few ? 4 : 5;
        look.notes = NOTE(FIGURE_DIRECT) | (few ? NOTE(FIGURE_FEW) : 0);
        chart_curve(chart, &look);
        for (size_t i = 0; i < study->curves[kind].loads; i++) {
            double error, value = direct_study_value(study, pair, kind, source->asked.quantity, i, &error);
            if (value > 0 && few_touch(study, pair, kind, i) == few)
                put_bar(chart, &source->asked, scale * study->plan.load[i], value, error);
        }
    }
}

/** A target or a limit, with its value as the scene has it. */
static void mark_asked(struct chart *chart, const struct source *source, const struct scene_asked *mark,
                       const char *name, bool vertical)
{
    char value[UNIT_LENGTH + 32];
    asked_text(value, sizeof value, mark->text);
    chart_mark(chart, vertical, asked_shown(&source->asked, mark->value), SAY("%s\nvalue %s", name, value));
}

/** The first target. */
static void mark_target(struct chart *chart, const struct source *source, bool vertical)
{
    if (source->asked.target)
        mark_asked(chart, source, source->asked.target, "target", vertical);
}

static void make_answer(struct chart *chart, const struct source *source)
{
    const struct results *results = source->results;
    const struct asked *asked = &source->asked;
    const double scale = asked_load_of(results, results->baseline).scale;
    struct asked axis[2] = {axis_of(QUANTITY_LOAD, scale), *asked};
    size_t textbook = asked_textbook(results);
    chart_panel(chart, "", load_label(source, true), asked_label(source, "axis.asked"), true, true);
    for (size_t k = 0; k < results->shown_count && results->shown_count <= 4; k++)
        put_band(chart, &results->surfaces[results->shown[k]], source->leading, asked,
                 asked_load_of(results, results->shown[k]).scale, surface_colour(k));
    if (textbook < model_count && textbook != source->leading)
        put_curve(chart, source, source->baseline, textbook, axis,
                  (struct chart_curve){.legend = SAY("textbook\nmodel %s", model_rows[textbook]->label),
                                       .colour = quiet,
                                       .dash = DASH_OTHER});
    for (size_t k = 0; k < results->shown_count; k++) {
        struct chart_curve look = surface_look(source, k);
        look.width = look.width < 2 ? look.width : 2.6;
        axis[0].scale = asked_load_of(results, results->shown[k]).scale;
        put_curve(chart, source, &results->surfaces[results->shown[k]], source->leading, axis, look);
    }
    put_direct(chart, source, scale);
    for (size_t k = 0; k < results->shown_count && asked->quantity == results_measured_quantity(results); k++)
        put_measured(chart, source, asked, k);
    mark_target(chart, source, false);
    const struct asked_load as = asked_load_of(results, results->baseline);
    const double load = as.scale * results_operating_load(results, results->baseline);
    OWNED(text_free) struct text value = {0};
    number_format(&value, load, 3);
    chart_mark(chart, true, load,
               SAY("operating_load\nvalue %s%s%s", text_string(&value), as.unit[0] ? no_break : "", as.unit));
}

/** What has an answer at the operating load: a model, a surface. */
struct row {
    double value, ends[2]; /* as shown; ends NaN: no interval */
    const char *label, *colour;
    double place; /* the least on top */
    size_t surface;
    int marker; /* 0: a dot */
    unsigned notes;
};
/* Models, by the bits that name them, and the direct solution; surfaces at the upper end, and at the lower. */
enum { ROWS_MOST = 64, ROWS_OF_AN_END = 10 };

static int is_lower(const void *a, const void *b)
{
    const struct row *f = a, *g = b;
    return (f->place > g->place) - (f->place < g->place);
}

/** One below the other, in a panel of their own. */
static void put_rows(struct chart *chart, const struct row *rows, size_t count)
{
    for (size_t r = 0; r < count; r++) {
        double y = (double)(count - r);
        bool ends = rows[r].ends[0] > 0 && isfinite(rows[r].ends[1]);
        chart_name_row(chart, y, rows[r].label);
        CURVE(.kind = ends ? CHART_DOTS : CHART_POINTS, .legend = "", .colour = rows[r].colour,
              .marker = rows[r].marker, .notes = rows[r].notes | (ends ? NOTE(FIGURE_BAND) : 0));
        chart_row(chart, rows[r].value, y, rows[r].ends[0], rows[r].ends[1]);
    }
    chart->panel_height = 42 + 26 * (double)count;
}

/** What is known of a surface; the mark says how. */
static struct row surface_row(const struct source *source, size_t surface)
{
    const struct asked *asked = &source->asked;
    const struct known known = known_shown(source->results, asked, NULL, surface);
    const bool bound = known.kind != KNOWN_VALUE, measured = known.measured && !known.beyond;
    struct row row = {.value = known.kind == KNOWN_NOTHING ? NAN : known.value,
                      .ends = {bound || known.beyond ? NAN : known.low, bound || known.beyond ? NAN : known.high},
                      .surface = surface,
                      .marker = measured ? 5
                                : bound  ? 6
                                         : 7,
                      .notes = measured ? NOTE(FIGURE_MEASURED)
                               : bound  ? NOTE(FIGURE_BOUND)
                                        : 0};
    row.place = asked->more_is_better ? -row.value : row.value;
    return row;
}

/** Every surface, the best on top; of many those at both ends. */
static void make_surfaces_at_load(struct chart *chart, const struct source *source)
{
    const struct results *results = source->results;
    OWNED(memory_free)
    struct row *rows = results->usable_count > 1 ? calloc(results->usable_count, sizeof *rows) : NULL;
    size_t count = 0;
    for (size_t k = 0; rows && k < results->usable_count; k++) {
        rows[count] = surface_row(source, results->by_roughness[k]);
        count += rows[count].value > 0 && isfinite(rows[count].value);
    }
    if (count > 1) {
        qsort(rows, count, sizeof *rows, is_lower);
        if (count > 2 * (size_t)ROWS_OF_AN_END) { /* a row without a mark stands for those between */
            const size_t left_out = count - 2 * (size_t)ROWS_OF_AN_END;
            rows[ROWS_OF_AN_END] = (struct row){.value = NAN, .label = SAY("others.count\ncount %zu", left_out)};
            memmove(&rows[ROWS_OF_AN_END + 1], &rows[count - ROWS_OF_AN_END], ROWS_OF_AN_END * sizeof *rows);
            count -= left_out - 1;
        }
        for (size_t r = 0; r < count; r++) {
            size_t k = 0;
            while (k < results->shown_count && results->shown[k] != rows[r].surface)
                k++;
            rows[r].colour = k < results->shown_count ? surface_look(source, k).colour : quiet;
            if (!rows[r].label)
                rows[r].label = short_name(source, results->surfaces[rows[r].surface].summary.scene->name);
        }
        chart_panel(chart, "", asked_label(source, "axis.asked_operating"), "", true, false);
        put_rows(chart, rows, count);
        for (size_t l = 0; l < results->scene->limit_count; l++)
            if (results->scene->limits[l].quantity == source->asked.quantity) {
                mark_asked(chart, source, &results->scene->limits[l], "limit", true);
                chart->notes |= NOTE(FIGURE_LIMIT);
            }
    }
}

/** Every model and the direct solution, the nearest to it (else to the leading model) on top. */
static void make_models(struct chart *chart, const struct source *source)
{
    const struct results *results = source->results;
    const struct asked *asked = &source->asked;
    struct row rows[ROWS_MOST + 1];
    size_t count = 0;
    double load = results_operating_load(results, results->baseline);
    const struct asked_solved solved = asked_direct(results, asked->quantity, load);
    bool known = solved.load == load && !quantity_rows[asked->quantity].from;
    double direct = known ? asked_shown(asked, solved.value) : NAN, error = solved.error;
    double leading =
        asked_shown(asked, comparison_middle(results, source->leading, results->baseline).value[asked->quantity]);
    chart_panel(chart, "", asked_label(source, "axis.asked_operating"), "", true, false);
    if (known)
        rows[count++] = (struct row){.value = direct,
                                     .ends = {direct / (1 + error), direct * (1 + error)},
                                     .label = SAY("direct"),
                                     .colour = ink,
                                     .place = -1,
                                     .notes = NOTE(FIGURE_DIRECT)};
    for (size_t m = 0; m < model_count; m++) {
        const struct contact_point at = comparison_middle(results, m, results->baseline);
        const bool valid = curve_summary_is_valid(surface_model(&source->baseline->summary, m), load);
        struct row row = {.value = asked_shown(asked, at.value[asked->quantity]),
                          .label = model_rows[m]->label,
                          .colour = model_rows[m]->colour,
                          .marker = valid ? 7 : 6,
                          .notes = valid ? 0 : NOTE(FIGURE_OUTSIDE)};
        if (!plan_runs_model(results->plan, m) || !(row.value > 0) || !isfinite(row.value))
            continue;
        const struct estimate *estimate =
            curve_summary_estimate(surface_model(&source->baseline->summary, m), (int)asked->quantity);
        asked_ends(row.ends, asked, (const double[]){estimate_end(estimate, 0), estimate_end(estimate, 1)});
        row.place = m == source->leading && !known ? -1 : fabs(log(row.value / (known ? direct : leading)));
        rows[count++] = row;
    }
    qsort(rows, count, sizeof *rows, is_lower);
    put_rows(chart, rows, count);
    mark_target(chart, source, true);
}

/* ---- The surfaces ---- */

/** One of the unit in brackets that a label ends in, in SI. */
static double label_unit(const char *label)
{
    const char *open = strpbrk(label, "([");
    struct unit unit;
    return open && unit_read(&unit, open + 1, strcspn(open + 1, ")]")) ? unit.factor : 1;
}

/** Begins a panel that is given numbers in SI, and draws them in the units of its labels. */
static struct chart_panel *panel_in_SI(struct chart *chart, const char *title, const char *x_label, const char *y_label,
                                       bool logarithmic)
{
    struct chart_panel *panel = chart_panel(chart, title, x_label, y_label, logarithmic, logarithmic);
    panel->unit[0] = label_unit(x_label);
    panel->unit[1] = label_unit(y_label);
    return panel;
}

/** Bins of the spectrum that the law was, or was not, fitted to. */
static void put_bins(struct chart *chart, const struct power_law_band *band, bool used)
{
    CURVE(.kind = CHART_BARS, .legend = "", .colour = used ? ink : "#a0a0a8", .marker = used ? 7 : 6,
          .notes = NOTE(used ? FIGURE_BINS : FIGURE_OPEN_BINS));
    for (size_t j = 0; j < band->bins; j++) {
        double s = sqrt(band->bin[j].variance), y = band->bin[j].y;
        if ((band->use[j] == POWER_LAW_BAND_USED) == used)
            chart_row(chart, pow(10, band->bin[j].x), pow(10, y), pow(10, y - s), pow(10, y + s));
    }
}

static void put_profile(struct chart *chart, const struct source *source, const struct surface_record *record,
                        const char *name, const char *colour)
{
    const double rq_um = record->summary.roughness.rq_m * 1e6;
    panel_in_SI(chart, SAY("panel.profile\nrq %.3g\nsurface\t%s", rq_um, short_name(source, name)),
                SAY("axis.position"), SAY("axis.height"), false)
        ->alone = true;
    CURVE(.legend = "", .width = 1, .colour = colour);
    for (size_t i = 0; i < record->preview_points; i++)
        chart_row(chart, record->preview_x_m[i], record->preview_z_m[i], 0, 0);
}

static void put_spectrum(struct chart *chart, const struct source *source, const struct surface_record *record,
                         const char *colour)
{
    enum { MOST = 300 };
    const struct power_law *law = &record->summary.power_law;
    size_t index[MOST], count = results_sweep_scales(index, MOST, record->spectrum.count);
    panel_in_SI(chart,
                isfinite(law->gamma) ? SAY("panel.spectrum\ngamma %.2f\nerror %.2f", law->gamma, law->gamma_error)
                                     : SAY("panel.no_law"),
                SAY("axis.wavelength"), SAY("axis.amplitude"), true);
    CURVE(.legend = "", .width = 0.8, .colour = colour);
    for (size_t i = 0; i < count; i++)
        chart_row(chart, 1 / spectrum_frequency(&record->spectrum, index[i]), record->spectrum.amplitude_m[index[i]], 0,
                  0);
    if (record->band && record->band->bins > 0) {
        put_bins(chart, record->band, true);
        put_bins(chart, record->band, false);
    }
    CURVE(.legend = "", .colour = ink, .width = 2.4, .notes = NOTE(FIGURE_LAW));
    for (int i = 0; i < 2; i++)
        chart_row(chart, law->band_m[i], power_law_amplitude(law, law->band_m[i]), 0, 0);
    for (size_t i = 0; record->band && i + 1 < record->band->pieces; i++) {
        chart_mark(chart, true, record->band->knee_m[i], "");
        chart->notes |= NOTE(FIGURE_KNEES);
    }
}

/** A row a surface: its profile, and its spectrum on the axes of all. */
static void make_surfaces(struct chart *chart, const struct source *source)
{
    const struct results *results = source->results;
    chart->number = 10;
    for (size_t k = 0; k < results->shown_count; k++) {
        const struct surface_record *record = &results->surfaces[results->shown[k]];
        put_profile(chart, source, record, record->summary.scene->name, surface_colour(k));
        put_spectrum(chart, source, record, surface_colour(k));
    }
    if (results->counterface)
        put_profile(chart, source, results->counterface, SAY("panel.counterface"), quiet);
}

/* ---- Chapter 6 ---- */

static void make_convergence(struct chart *chart, const struct source *source)
{
    enum { MOST = 120 };
    const struct results *results = source->results;
    const struct scene_convergence *study = &results->scene->convergence;
    static const char *const parameter[][2] = {
        [CONVERGENCE_ALPHA] = {"alpha", "panel.alpha"}, [CONVERGENCE_GAMMA] = {"gamma", "panel.gamma"}};
    size_t index[MOST], count = results_sweep_scales(index, MOST, study->scales);
    for (int s = 0; s < CONVERGENCE_SWEEP_COUNT && results->convergence; s++)
        for (size_t m = 0; m < model_count; m++) {
            const struct convergence_sweep_row *sweep = &convergence_sweeps[s];
            OWNED(text_free) struct text load = {0};
            if (!plan_runs_model(results->plan, m) || !model_rows[m]->stacks_scales)
                continue;
            chart->number = 1 + 2 * s + model_rows[m]->plastic;
            number_format(&load, results_sweep_load(results, m), 2);
            chart_panel(chart,
                        SAY("%s\nnumber 6-%02d\nmodel %s\nload %s", parameter[s][1], chart->number,
                            model_rows[m]->label, text_string(&load)),
                        SAY("axis.shortest_wavelength"), SAY("axis.area_ratio"), true, true);
            for (size_t v = 0; v < sweep->count; v++) {
                const double *area = results_sweep(results, (enum convergence_sweep)s, m, v);
                CURVE(.legend = SAY("%s\nvalue %g", parameter[s][0], sweep->values[v]),
                      .dash = s == CONVERGENCE_GAMMA ? 4 : 1, .colour = sweep_colours[8 * v / (sweep->count - 1)]);
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

/** A unit's scale on an axis: what has no unit is drawn as it is. */
static double scale_of(enum quantity quantity)
{
    return quantity_rows[quantity].unit[0] ? quantity_unit(quantity).scale : 1;
}

static void begin_panel(struct chart *chart, const struct source *source, enum quantity x, enum quantity y,
                        const char *title)
{
    chart_panel(chart, title, x == QUANTITY_LOAD ? load_label(source, false) : quantity_words(source, "axis", x),
                quantity_words(source, "axis", y), !(quantity_rows[x].is & QUANTITY_LINEAR),
                !(quantity_rows[y].is & QUANTITY_LINEAR) && quantity_unit(y).offset == 0);
}

/** A model's curve in a panel of one quantity over another: a statistical gap adjusted and, thin, unadjusted; dotted,
 * the quantity that is drawn beside it. */
static void put_quantity(struct chart *chart, const struct source *source, const enum quantity of[2], size_t surface,
                         size_t m, struct chart_curve look)
{
    const struct surface_record *record = &source->results->surfaces[surface];
    const double scale = of[1] == QUANTITY_LOAD ? load_of(source, surface, false).scale : scale_of(of[1]);
    struct asked axis[2] = {axis_of(of[1], scale), axis_of(model_shown(model_rows[m], of[0]), scale_of(of[0]))};
    if (!computes(source, m, of[0]))
        return;
    put_curve(chart, source, record, m, axis, look);
    look.width = 1.4;
    look.legend = "";
    if (axis[1].quantity != of[0]) {
        axis[1].quantity = of[0];
        look.dash = DASH_OTHER;
        look.notes |= NOTE(FIGURE_UNADJUSTED);
        put_curve(chart, source, record, m, axis, look);
    }
    axis[1].quantity = quantity_rows[of[0]].dotted;
    look.dash = 3;
    if (axis[1].quantity != QUANTITY_LOAD && computes(source, m, axis[1].quantity))
        put_curve(chart, source, record, m, axis, look);
}

/** Does a panel go to the appendix? Of a single surface: what the first page shows already, and gap against area. */
static bool is_more(const struct source *source, enum quantity quantity, const struct quantity_panel *panel)
{
    return source->results->usable_count == 1 &&
           (panel->against != QUANTITY_LOAD || quantity == source->asked.quantity);
}

/** The baseline in every model, a panel per quantity: of the contact, all but the appendix's (`whole`) or those; of the
 * joint, its total (`whole`) or its parts. */
static void put_baseline(struct chart *chart, const struct source *source, bool joint, bool whole)
{
    for (int p = 0; p < 2 * QUANTITY_COUNT; p++) {
        const enum quantity quantity = (enum quantity)(p / 2);
        const struct quantity_panel *panel = &quantity_rows[quantity].panels[p % 2];
        chart->number = panel->number;
        if (!panel->file || quantity_of_joint(quantity) != joint ||
            (joint ? quantity_rows[quantity].precedence > 0 : !is_more(source, quantity, panel)) != whole ||
            !(plan_quantities(source->results->plan) & QUANTITY_BIT(quantity)))
            continue;
        begin_panel(chart, source, panel->against, quantity,
                    panel->number == 0 ? quantity_words(source, "panel", quantity)
                                       : SAY("6-%02d\nnumber 6-%02d", panel->number, panel->number));
        for (size_t m = 0; m < model_count; m++)
            put_quantity(chart, source, (enum quantity[]){quantity, panel->against}, source->results->baseline, m,
                         model_look(m));
    }
}

/** What the shape of the parts does to the leading model's answer, and where it presses. */
static void put_shape(struct chart *chart, const struct source *source)
{
    static const enum quantity ways[][3] = {{QUANTITY_SHAPE_JOINT, QUANTITY_JOINT, QUANTITY_TCR},
                                            {QUANTITY_SHAPE_ECR, QUANTITY_JOINT_ECR, QUANTITY_ECR}};
    const struct asked load = axis_of(QUANTITY_LOAD, load_of(source, source->results->baseline, false).scale);
    const struct joint_shape *shape = source->baseline->shapes ? &source->baseline->shapes[source->leading] : NULL;
    const double *side_m = source->results->scene->joint.size_m;
    const double ring_m = hypot(side_m[0], side_m[1]) / 2 / JOINT_RINGS;
    if (!shape || !(shape->most > 0))
        return;
    for (int way = 0; way < 2; way++) {
        const enum quantity whole = ways[way][0];
        const bool made = computes(source, source->leading, ways[way][1]);
        if (!computes(source, source->leading, whole))
            continue;
        begin_panel(chart, source, QUANTITY_LOAD, whole,
                    SAY("panel.model\nmodel %s", model_rows[source->leading]->label));
        for (int flat = 0; flat < 2; flat++) {
            struct asked axis[2] = {load, axis_of(ways[way][flat == 0 ? 0 : made ? 1 : 2], scale_of(whole))};
            axis[1].reciprocal = axis[1].quantity == QUANTITY_TCR;
            put_curve(chart, source, source->baseline, source->leading, axis,
                      (struct chart_curve){.legend = SAY("%s", flat ? "flat_parts" : "with_shape"),
                                           .colour = flat ? quiet : baseline_colour(source),
                                           .width = flat ? 0 : 2.6});
        }
    }
    if (!(shape->ring_Pa[JOINT_RINGS / 2] > 0))
        return;
    panel_in_SI(chart, SAY("panel.rings"), SAY("axis.rings"), SAY("axis.ring_pressure"), false);
    CURVE(.legend = "", .colour = baseline_colour(source), .width = 2);
    for (int ring = 0; ring < JOINT_RINGS; ring++)
        if (shape->ring_Pa[ring] > 0)
            chart_row(chart, (ring + 0.5) * ring_m, shape->ring_Pa[ring], 0, 0);
}

static void make_joint(struct chart *chart, const struct source *source)
{
    put_shape(chart, source);
    put_baseline(chart, source, true, true);
    put_baseline(chart, source, true, false);
}

/** All surfaces, a panel a model: the thesis's in its own order, then the leading one. */
static void make_all_surfaces(struct chart *chart, const struct source *source, enum quantity quantity,
                              const struct quantity_panel *panel)
{
    const struct results *results = source->results;
    chart->shares = true;
    for (int place = 1; place <= 5 && results->usable_count > 1; place++)
        for (size_t m = 0; m < model_count; m++) {
            bool leads = m == source->leading && model_rows[m]->thesis_place == 0;
            if (!computes(source, m, quantity) || (place < 5 ? model_rows[m]->thesis_place != place : !leads))
                continue;
            chart->number = place < 5 && panel->first > 0 ? panel->first + place - 1 : 0;
            begin_panel(chart, source, panel->against, quantity,
                        SAY("panel.model\n%s 6-%02d\nmodel %s", chart->number > 0 ? "number" : "none", chart->number,
                            model_rows[m]->label));
            for (size_t k = 0; k < results->shown_count; k++)
                put_quantity(chart, source, (enum quantity[]){quantity, panel->against}, results->shown[k], m,
                             surface_look(source, k));
        }
}

/* ---- What is called for ---- */

/** Every model beside what was measured, a panel a surface. */
static void make_measured(struct chart *chart, const struct source *source)
{
    const struct results *results = source->results;
    struct asked asked = source->asked;
    enum quantity quantity = results_measured_quantity(results);
    bool own = asked.quantity == quantity;
    if (!own)
        asked = axis_of(quantity, 1);
    for (size_t k = 0, panels = 0; k < results->shown_count; k++) {
        const struct surface_record *record = &results->surfaces[results->shown[k]];
        const struct asked axis[2] = {axis_of(QUANTITY_LOAD, asked_load_of(results, results->shown[k]).scale), asked};
        const char *title = results->usable_count > 1 ? short_name(source, record->summary.scene->name) : "";
        if (!results_measured(results, results->shown[k]))
            continue;
        chart_panel(chart, title, load_label(source, true),
                    own ? asked_label(source, "axis.asked") : quantity_words(source, "axis", quantity), true, true);
        chart->shares = panels++ > 0;
        for (size_t m = 0; m < model_count; m++)
            if (computes(source, m, quantity))
                put_curve(chart, source, record, m, axis, model_look(m));
        put_measured(chart, source, &asked, k);
    }
}

/** The models over the direct solution of the baseline, and how far that may itself be off. */
static void make_direct(struct chart *chart, const struct source *source)
{
    const struct results *results = source->results;
    const struct direct_study *study = results_direct_baseline(results);
    const struct material_pair *pair = results_pair(results, results->baseline);
    const double scale = load_of(source, results->baseline, false).scale;
    for (int q = 0; study && q < QUANTITY_COUNT; q++) {
        const enum quantity quantity = (enum quantity)q;
        if (!quantity_rows[q].solved.ratio || !(results->plan->wanted & QUANTITY_BIT(q)))
            continue;
        chart_panel(chart, quantity_words(source, "panel.direct", quantity), load_label(source, false),
                    SAY("axis.model_over_direct"), true, true)
            ->y_most = (struct chart_extent){1e-3, 1e3};
        CURVE(.kind = CHART_BAND, .legend = SAY("direct.error"), .colour = ink);
        for (size_t i = 0; i < study->plan.loads; i++) {
            double error, value = direct_study_value(study, pair, DIRECT_STUDY_ELASTIC, quantity, i, &error);
            double share = fmax(isnan(error) ? 0 : error / value,
                                direct_study_grid_error(study, DIRECT_STUDY_ELASTIC, quantity, i));
            if (value > 0)
                chart_row(chart, scale * study->plan.load[i], 1 / (1 + share), 1 + share, 0);
        }
        for (size_t m = 0; m < model_count; m++)
            for (int few = 0; few < 2 && computes(source, m, quantity); few++) {
                const enum direct_study_kind kind = direct_study_kind_of(study, m);
                struct chart_curve look = model_look(m);
                look.kind = few ? CHART_POINTS : CHART_LINE;
                look.marker = few ? 6 : 7;
                look.notes = NOTE(FIGURE_DIRECT) | (few ? NOTE(FIGURE_FEW) : 0);
                chart_curve(chart, &look);
                for (size_t i = 0; i < study->plan.loads; i++)
                    if (few_touch(study, pair, kind, i) == few)
                        chart_row(chart, scale * study->plan.load[i], direct_study_ratio(study, pair, m, quantity, i),
                                  0, 0);
            }
        chart_mark(chart, false, 1, "");
    }
}

/** 95 % error, as the factor of the table beside it, against time: every model, at each tolerance. */
static void make_accuracy(struct chart *chart, const struct source *source)
{
    if (!source->results->benchmark)
        return;
    chart_panel(chart, "", SAY("axis.time"),
                SAY("axis.error_of\nquantity %s",
                    SAY("%s", quantity_of_joint(source->asked.quantity) ? "asked.spots" : source->asked.name)),
                true, true);
    for (size_t m = 0; m < model_count; m++) {
        const struct accuracy accuracy = accuracy_of(source->results, m, source->asked.quantity);
        if (!(accuracy.sd > 0))
            continue;
        struct chart_curve look = model_look(m);
        const char *name = look.legend;
        look.kind = CHART_LINE;
        look.width = 1.4;
        look.marker = model_rows[m]->marker;
        look.legend = "";
        chart_curve(chart, &look);
        for (size_t i = 0; i < BENCHMARK_STEPS; i++)
            chart_row(chart, accuracy.seconds[i], 1 + accuracy.total_error[i], 0, 0);
        look.kind = CHART_POINTS;
        look.legend = name;
        chart_curve(chart, &look);
        chart_row(chart, accuracy.seconds[accuracy.used], model_factor(accuracy.sd), 0, 0);
    }
}

/* ---- The list ---- */

/* In the report's order; those of all surfaces come behind. */
static const struct figure_row {
    const char *name;
    void (*make)(struct chart *chart, const struct source *source); /* NULL: put_baseline(), of the contact */
    double panel_height;
    bool whole, shares, first_page, terminal;
} figure_rows[] = {
    {"answer", make_answer, .first_page = true, .terminal = true},
    {"surfaces-at-load", make_surfaces_at_load, .first_page = true},
    {"models", .make = make_models},
    {"surfaces", make_surfaces, .panel_height = 90, .shares = true},
    {"convergence", make_convergence, .panel_height = 90, .shares = true},
    {"one-surface", .whole = true, .panel_height = 190},
    {"one-surface-more", .panel_height = 190},
    {"joint", .make = make_joint},
    {"measured", .make = make_measured},
    {"direct", make_direct, .panel_height = 150, .shares = true, .terminal = true},
    {"accuracy", make_accuracy, .panel_height = 180},
};
enum { FIGURE_ROWS = sizeof figure_rows / sizeof *figure_rows };
_Static_assert(FIGURE_ROWS + FIGURES_MAPS + 2 * QUANTITY_COUNT <= FIGURES_MOST, "all figures have a place");

/** The numbers of a chart's panels in chapter 6, which ascend; three or more in a row as from ... to. */
static void put_numbers(char *out, size_t size, const struct chart *chart)
{
    size_t used = 0;
    int before = 0, row = 0;
    for (size_t p = 0; p < chart->panels && used < size; p++) {
        int number = chart->panel[p].number;
        if (number == 0 || number == before)
            continue;
        row = number == before + 1 ? row + 1 : 1;
        used -= row > 2 ? strlen(row > 3 ? " to 6-00" : ", 6-00") : 0; /* the one before gives way */
        used += (size_t)snprintf(out + used, size - used, "%s6-%02d", row > 2 ? " to " : used > 0 ? ", " : "", number);
        before = number;
    }
}

static void draw_file(const struct source *source, const char *name)
{
    char command[FIGURE_NAME + 16];
    snprintf(command, sizeof command, "load '%s.gp'\n", name);
    gnuplot_send(source->task->gnuplot, command);
}

/** Writes the files of a chart with anything to see and has gnuplot draw it; with letters too for a `terminal`. */
static void draw_one(struct figures *out, struct chart *chart, bool terminal, const struct source *source)
{
    OWNED(text_free) struct text letters = {0};
    chart_end(chart);
    if (chart->blocks > 0 && chart_write(chart, source->templates, source->directory) == STATUS_OK) {
        draw_file(source, chart->name);
        if (terminal && chart_script(&letters, chart, source->templates, source->task->terminal_size) == STATUS_OK)
            gnuplot_send(source->task->gnuplot, text_string(&letters));
        snprintf(out->figure[out->count].name, FIGURE_NAME, "%s", chart->name);
        out->figure[out->count].terminal = terminal;
        out->figure[out->count].notes = chart->notes;
        put_numbers(out->figure[out->count].numbers, sizeof out->figure->numbers, chart);
        out->count++;
    }
    chart_free(chart);
}

void figures_map_name(char *out, size_t size, const char *surface)
{
    static const char letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-";
    snprintf(out, size, "map-%s", surface);
    for (char *c = out; *c; c++)
        if (!strchr(letters, *c))
            *c = '-';
}

/** Writes NAME.csv and NAME.gp of a map's heights with its contact, and of the pressure along a section. */
static enum status_code write_map(const struct surface_record *record, const char *name, const char *title,
                                  const struct source *source)
{
    const struct map_contact *contact = &record->contact;
    const struct material_pair *pair = &record->summary.pair;
    const size_t cells = contact->cells;
    const double side_m = (double)cells * contact->cell_m;
    const bool small = side_m < 1e-3; /* lengths from 1 mm on are in mm */
    const bool flows = contact->flowed > 0;
    struct status *status = source->templates->status;
    const double length = small ? 1e6 : 1e3, cell = contact->cell_m * length,
                 stress = pair->unknown ? 1 : pair->effective_modulus_Pa * 1e-6;
    OWNED(text_free) struct text script = {0}, data = {0};
    text_add(&data, "%zu", cells); /* no column is computed in gnuplot, which takes 10 us for each value */
    for (size_t i = 0; i < cells; i++)
        text_add(&data, ",%.6g", ((double)i + 0.5) * cell);
    for (size_t k = 0; k < cells * cells; k++) {
        if (k % cells == 0)
            text_add(&data, "\n%.6g", ((double)(k / cells) + 0.5) * cell);
        text_add_bytes(&data, ",", 1);
        number_digits(&data, contact->height_m[k] * 1e6, 3);
    }
    text_add(&data, "\n\n\n");
    for (size_t k = 0; k < cells * cells; k++)
        text_add(&data, contact->is[k] ? "%zu,%zu,%d\n" : "%zu,%zu,NaN\n", k % cells, k / cells, contact->is[k]);
    text_add(&data, "\n\n");
    for (size_t i = 0; i < contact->points; i++)
        text_add(&data, "%.6g,%.6g\n", (double)i * contact->spacing_m * length, contact->pressure[i] * stress);
    const bool turned = source->results->scene->direction == SCAN_DIRECTION_Y; /* the map was, to read its columns */
    json_auto_t *view = json_pack("{ss so ss ss ss si sf sf sb sb}", "name", name, "title", json_shown(title),
                                  "length_unit", small ? "µm" : "mm", "along", turned ? "y" : "x", "across",
                                  turned ? "x" : "y", "cells", (int)cells, "side", side_m * length, "section",
                                  contact->section_m * length, "has_material", !pair->unknown, "flows", flows);
    if (flows)
        json_set(view, "hardness", pair->hardness_Pa / pair->effective_modulus_Pa * stress);
    if (mustache_file(&script, source->templates, "charts/map", view, chart_escape) != STATUS_OK ||
        text_save(&script, status, "%s/%s.gp", source->directory, name) != STATUS_OK)
        return status->code;
    return text_save(&data, status, "%s/%s.csv", source->directory, name);
}

/** The contact of the first maps that are shown, as many as a page can hold: map-NAME, what may be in a file's name of
 * it, and a number where another one has that too. */
static void draw_maps(struct figures *out, const struct source *source)
{
    const struct results *results = source->results;
    for (size_t k = 0, maps = 0; k < results->shown_count && maps < FIGURES_MAPS; k++) {
        const size_t surface = results->shown[k];
        const struct surface_record *record = &results->surfaces[surface];
        const struct asked_load load = asked_load_of(results, surface);
        char *name = out->figure[out->count].name;
        OWNED(text_free) struct text at = {0};
        if (record->contact.cells == 0)
            continue;
        maps++;
        figures_map_name(name, FIGURE_NAME, record->summary.scene->name);
        for (size_t f = 0; f < out->count; f++)
            if (strcmp(out->figure[f].name, name) == 0)
                snprintf(name, FIGURE_NAME, "map-%zu", maps);
        text_add(&at, "%s: ", record->summary.scene->name);
        number_format(&at, load.scale * results_operating_load(results, surface), 3);
        text_add(&at, " %s", load.unit);
        if (write_map(record, name, text_string(&at), source) == STATUS_OK)
            draw_file(source, name);
        out->figure[out->count++].map = surface + 1;
    }
}

enum status_code figures_draw(struct figures *out, const struct results *results, const struct figures_task *task,
                              struct status *status)
{
    OWNED(mustache_folder_free) struct mustache_folder templates = {task->templates, ".gp", NULL, status};
    OWNED(text_free) struct text directory = {0};
    text_add(&directory, "%s/figures", task->directory);
    const struct surface_record *baseline = &results->surfaces[results->baseline];
    const struct heating_metal *metal = heating_metal_find(scene_softer(&baseline->summary.scene->bodies)->name);
    const struct source source = {.results = results,
                                  .baseline = baseline,
                                  .leading = plan_leading_model(results->plan),
                                  .asked = asked_of(results),
                                  .hottest_C = fmin(metal ? metal->melting_K - 273.15 : NAN, 1000),
                                  .words = task->words,
                                  .task = task,
                                  .templates = &templates,
                                  .directory = text_string(&directory)};
    for (const struct figure_row *row = figure_rows; row < figure_rows + FIGURE_ROWS && status->code == STATUS_OK;
         row++) {
        if (task->cost != (row->make == make_accuracy) || (task->brief && !row->first_page))
            continue;
        struct chart chart = chart_make(row->name);
        chart.panel_height = row->panel_height;
        chart.shares = row->shares;
        if (row->make)
            row->make(&chart, &source);
        else
            put_baseline(&chart, &source, false, row->whole);
        draw_one(out, &chart, row->terminal && task->terminal_size, &source);
    }
    for (int p = 0; p < 2 * QUANTITY_COUNT && !task->cost && !task->brief && status->code == STATUS_OK; p++) {
        const struct quantity_panel *panel = &quantity_rows[p / 2].panels[p % 2];
        if (!panel->file || !panel->file[0])
            continue;
        struct chart chart = chart_make(panel->file);
        make_all_surfaces(&chart, &source, (enum quantity)(p / 2), panel);
        draw_one(out, &chart, false, &source);
    }
    if (!task->cost && !task->brief && status->code == STATUS_OK)
        draw_maps(out, &source);
    return status->code;
}

enum status_code figures_finish(struct text *letters, const struct figures *figures, const struct figures_task *task,
                                struct status *status)
{
    (void)!gnuplot_finish(task->gnuplot, status);
    for (size_t i = 0; i < figures->count && status->code == STATUS_OK; i++) {
        const char *name = figures->figure[i].name;
        OWNED(text_free) struct text file = {0}, in_letters = {0};
        struct stat drawn;
        text_add(&file, "%s/figures/%s.svg", task->directory, name);
        text_add(&in_letters, "%s/figures/%s.txt", task->directory, name);
        if (stat(text_string(&file), &drawn) != 0 || drawn.st_size == 0)
            return status_fail(status, STATUS_CHART,
                               "gnuplot did not draw '%s.svg' and did not say why: see whether it runs by itself "
                               "('gnuplot -d')",
                               name);
        if (figures->figure[i].terminal)
            (void)!gnuplot_take_text(letters, text_string(&in_letters), status);
    }
    return status->code;
}
