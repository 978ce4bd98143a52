/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Writes docs/validation.md: what is known from elsewhere (truths.c), and the models against direct solutions. For
 * these surfaces of nine height laws and three Hurst exponents are made by the program's own synthesis and solved; some
 * rows of each then go through the analysis as line scans, and every model's answer is held against the solution. Fails
 * where a number is beyond its bound. Minutes; hence no test. cmake --workflow --preset validation */
#include "answers/answers.h"
#include "answers/direct_study.h"
#include "direct/direct_quantities.h"
#include "direct/direct_surface.h"
#include "directory.h"
#include "members/surface_read.h"
#include "plan/effects.h"
#include "statistics/coverage.h"
#include "validation/height_laws.h"
#include "validation/nulls.h"

#include <fftw3.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>

enum { SIDE = 256, GIVEN = SIDE * SIDE, LAWS = HEIGHT_LAWS, HURSTS = 3, HARDNESSES = 3, ASKED = 3, LOADS = 9 };

static const double spacing_m = 1e-6, gradient = 0.05, cut_off_m = 8e-6, resistivity_ohm_m = 5e-7, largest_area = 0.9;
static const double hursts[HURSTS] = {0.3, 0.6, 0.9}, hardnesses[HARDNESSES] = {0.03, 0.15, 0.5};
static const double loads[LOADS] = {0.003, 0.01, 0.03, 0.06, 0.12, 0.2, 0.35, 0.6, 1}; /* P/(A_n E' g) */
static const enum quantity asked[ASKED] = {QUANTITY_AREA, QUANTITY_SEPARATION, QUANTITY_ECR};

#define PERSSON "models: [corrected-persson]\n"
#define DIRECT  "direct: {grid: 256, seeds: 4, loads: [0.00015, 0.003, 0.0175]}\n"

/** A set of surfaces and of line scans of them; the first five are columns of the page's tables. */
static const struct part {
    const char *title;
    double roll_off;     /* waves of the longest length in a side */
    size_t rows, points; /* of the scans */
    size_t laws;         /* laws of heights, from the first */
    size_t each;       /* surfaces of a law: Hurst exponents in turn, then other seeds; from the 13th twice the waves */
    size_t hardnesses; /* 0: elastic */
    const char *bounded; /* in the table of bounds; NULL: not there */
    double bound[ASKED]; /* of the rms over all */
    size_t along;        /* scans of the columns beside those of the rows; every second surface has the two exchanged */
    double ratio;        /* Peklenik's: waves are so many times as long along y as along x */
    const char *more;    /* of the scene; NULL: nothing */
} parts[] = {
    {"5 scans, 4 waves", 4, 5, SIDE, LAWS, 3, 0, "leading answer, 5 scans, 4 waves", {0.30, 0.36, 0.42}, 0, 0, NULL},
    {"1 scan, 4 waves", 4, 1, SIDE, LAWS, 3, 0, NULL, {0}, 0, 0, NULL},
    {"5 scans, 2.5 waves", 4, 5, 150, LAWS, 3, 0, NULL, {0}, 0, 0, NULL},
    {"5 scans, 0.6 waves", 1, 5, 150, LAWS, 3, 0, NULL, {0}, 0, 0, NULL},
    {"5 scans, 4 waves, hardness",
     4,
     5,
     SIDE,
     LAWS,
     4,
     HARDNESSES,
     "the same with hardness",
     {0.22, 0.50, 0.53},
     0,
     0,
     NULL},
    {"64 scans, 4 or 8 waves",
     4,
     64,
     SIDE,
     1,
     24,
     0,
     "corrected-persson, 64 scans, 4 or 8 waves",
     {0.068, 0.058, 0.086},
     .more = PERSSON},
    {"5 scans, 4 waves, synthesis", 4, 5, SIDE, 1, 6, .more = PERSSON DIRECT},
    {"two directions, 4 + 4",
     4,
     4,
     SIDE,
     LAWS,
     2,
     0,
     "two directions, 4 + 4 scans, isotropic",
     {0.22, 0.26, 0.34},
     4,
     1,
     NULL},
    {"two directions, 4 + 4", 4, 4, SIDE, LAWS, 2, 0, "the same, Peklenik 3", {0.23, 0.29, 0.36}, 4, 3, NULL},
    {"two directions, 4 + 4", 8, 4, SIDE, LAWS, 2, 0, "the same, Peklenik 10", {0.26, 0.35, 0.42}, 4, 10, NULL},
    {"one direction, 8", 4, 8, SIDE, LAWS, 2, .ratio = 1},
    {"one direction, 8", 4, 8, SIDE, LAWS, 2, .ratio = 3},
    {"one direction, 8", 8, 8, SIDE, LAWS, 2, .ratio = 10},
};
enum { HARD = 4, SPECTRUM, SYNTHESIS, TWO, ONE = TWO + 3, PARTS = ONE + 3 };

/** Normal heights of waves that are `ratio` times as long along y, of random phases. */
static void make_lay(double *height_m, const struct direct_spectrum *spectrum, double ratio, uint64_t seed)
{
    enum { HALF = SIDE / 2, ROW = HALF + 1 };
    fftw_complex *mode = fftw_alloc_complex((size_t)SIDE * ROW);
    memset(mode, 0, (size_t)SIDE * ROW * sizeof *mode);
    for (long j = 1 - HALF; j < HALF; j++)
        for (long i = 0; i < HALF; i++) {
            const size_t row = (size_t)((j + SIDE) % SIDE), turned = (size_t)((SIDE - j) % SIDE);
            const double amplitude = sqrt(direct_spectrum_variance(hypot((double)i, ratio * (double)j), spectrum)),
                         phase = 2 * M_PI * direct_random(seed, row * ROW + (size_t)i);
            if (i == 0 && j <= 0) /* of its other half */
                continue;
            mode[row * ROW + (size_t)i][0] = amplitude * cos(phase);
            mode[row * ROW + (size_t)i][1] = amplitude * sin(phase);
            if (i > 0)
                continue;
            mode[turned * ROW][0] = mode[row * ROW][0];
            mode[turned * ROW][1] = -mode[row * ROW][1];
        }
    fftw_plan plan = fftw_plan_dft_c2r_2d(SIDE, SIDE, mode, height_m, FFTW_ESTIMATE);
    fftw_execute(plan);
    fftw_destroy_plan(plan);
    fftw_free(mode);
    const double sd = gsl_stats_sd(height_m, 1, GIVEN), mean = gsl_stats_mean(height_m, 1, GIVEN);
    for (size_t k = 0; k < GIVEN; k++)
        height_m[k] = (height_m[k] - mean) / sd;
}

/** Heights of that law with the rms gradient `gradient`, in place of normal ones. */
static void give_law(double *height_m, size_t law)
{
    double sum = 0;
    for (size_t k = 0; k < GIVEN; k++)
        height_m[k] = height_laws[law].of(height_m[k]);
    for (size_t k = 0; k < GIVEN; k++) {
        const size_t i = k % SIDE, row = k / SIDE;
        const double x = height_m[row * SIDE + (i + 1) % SIDE] - height_m[k],
                     y = height_m[(row + 1) % SIDE * SIDE + i] - height_m[k];
        sum += (x * x + y * y) / GIVEN;
    }
    for (size_t k = 0; k < GIVEN; k++)
        height_m[k] *= gradient * spacing_m / sqrt(sum);
}

/** A surface of rms gradient `gradient`, SIDE x SIDE; ratio 0: isotropic, of a given law of heights to the letter. */
static double *make_surface(size_t law, double hurst, double roll_off, double ratio, uint64_t seed)
{
    double *height_m = coverage_allocate(GIVEN, sizeof *height_m);
    OWNED(memory_free) double *given = coverage_allocate(GIVEN, sizeof *given);
    double m2 = 0;
    struct direct_law rows = {1, hurst + 0.5, cut_off_m, SIDE * spacing_m, roll_off};
    struct direct_spectrum spectrum;
    for (size_t m = 1; m <= direct_law_harmonics(&rows); m++)
        m2 += pow(2 * M_PI * (double)m / rows.length_m * direct_law_amplitude(&rows, m), 2) / 2;
    rows.alpha *= gradient / sqrt(2 * m2);
    expect_ok(direct_spectrum_of_law, &spectrum, &rows);
    for (size_t k = 0; k < GIVEN; k++)
        given[k] = height_laws[law].of(gsl_cdf_ugaussian_Pinv(((double)k + 0.5) / GIVEN));
    const struct direct_recipe recipe = {direct_spectrum_variance, &spectrum, law == 0 ? NULL : given, GIVEN};
    if (ratio > 0) {
        make_lay(height_m, &spectrum, ratio, seed);
        give_law(height_m, law);
    } else {
        expect_ok(direct_surface_make, height_m, SIDE, &recipe, seed);
    }
    direct_spectrum_free(&spectrum);
    return height_m;
}

/** Solutions at `loads`, for a hardness over E' g; INFINITY: elastic. */
static void solve(struct direct_point *out, const double *height_m, double hardness)
{
    double own[LOADS];
    struct direct_contact contact;
    for (size_t i = 0; i < LOADS; i++)
        own[i] = loads[i] * gradient;
    const struct direct_ladder_def def = {
        .load = own, .loads = LOADS, .hardness = hardness * gradient, .tolerance = 1e-6, .resistance = true};
    expect_ok(direct_contact_make, &contact, height_m, &(struct direct_grid){SIDE, SIDE, spacing_m, false, false});
    expect_ok(direct_ladder_run, out, &contact, &def);
    direct_contact_free(&contact);
}

/** Writes evenly spaced rows, or columns, and lists them under `key`. */
static void write_lines(const struct directory *place, struct text *scene, const char *key, const double *height_m,
                        const struct part *part, bool columns)
{
    const size_t count = columns ? part->along : part->rows;
    struct text row = {0};
    char name[32];
    text_add(scene, "%s: [", key);
    for (size_t r = 0; r < count; r++) {
        const size_t at = (2 * r + 1) * SIDE / (2 * count);
        text_add(&row, "x [um],z [nm]\n");
        for (size_t i = 0; i < part->points; i++)
            text_add(&row, "%zu,%.9g\n", i, height_m[columns ? i * SIDE + at : at * SIDE + i] * 1e9);
        snprintf(name, sizeof name, "%s-%zu.csv", columns ? "column" : "row", r);
        directory_write(place, name, text_string(&row));
        text_free(&row);
        text_add(scene, "%s%s", r > 0 ? ", " : "", name);
    }
    text_add(scene, "]");
}

/** Writes scans and a scene into the directory; turned: those of the columns as if they ran across. */
static void write_scans(const struct directory *place, const double *height_m, const struct part *part, double hardness,
                        bool turned)
{
    OWNED(text_free) struct text scene = {0};
    double hardness_Pa = 1e11 * gradient * (isinf(hardness) ? 10 : hardness);
    text_add(&scene, "material: {E: 100 GPa, nu: 0, Sy: %.17g, resistivity: %g ohm m, hardness: %.17g}\n",
             hardness_Pa / material_hardness_ratio, resistivity_ohm_m, hardness_Pa);
    text_add(&scene, "%seffects: [separation, electrical, uncertainty%s%s]\n", part->more ? part->more : "",
             isinf(hardness) ? "" : ", plasticity", part == &parts[SYNTHESIS] ? ", direct" : "");
    text_add(&scene, "load: {values: [");
    for (size_t i = 0; i < LOADS; i++)
        text_add(&scene, "%s%.17g", i > 0 ? ", " : "", loads[i] * gradient);
    text_add(&scene, "]}\nsurfaces: [{name: s, ");
    write_lines(place, &scene, part->along > 0 && turned ? "along" : "file", height_m, part, false);
    text_add(&scene, ", ");
    if (part->along > 0)
        write_lines(place, &scene, turned ? "file" : "along", height_m, part, true);
    text_add(&scene, "}]\n");
    directory_write(place, "scene.yaml", text_string(&scene));
}

/** What was found of one number; model model_count + 1: by direct solution of a synthesis. */
struct finding {
    size_t model, law, quantity, load;
    size_t surface; /* counted from the first */
    bool leads;
    double ln_ratio, ln_end[2]; /* of the answer to the solution, NaN: not printed, and of its interval's ends */
};

struct findings {
    struct finding *all;
    size_t count, surfaces;
};

static bool has_interval(const struct finding *finding)
{
    return !isnan(finding->ln_end[0]);
}

static bool holds(const struct finding *finding)
{
    return finding->ln_end[0] <= 0 && finding->ln_end[1] >= 0;
}

static void add(struct findings *findings, const struct finding *finding)
{
    findings->all = reallocarray(findings->all, findings->count + 1, sizeof *findings->all);
    if (!findings->all)
        coverage_must(STATUS_MEMORY, &(struct status){.message = "out of memory"});
    findings->all[findings->count++] = *finding;
}

static void hold_curve(struct findings *findings, const struct surface_record *record, size_t m, bool leads, size_t law,
                       const struct direct_point *truth)
{
    const struct model_curve *curve = &record->curves[m];
    for (size_t i = 0; i < LOADS; i++) {
        const struct contact_point *point = NULL;
        double value[ASKED] = {truth[i].quantities.area_ratio, truth[i].quantities.gap_m,
                               2 * resistivity_ohm_m * truth[i].constriction_m};
        if (!truth[i].exists || !(value[0] < largest_area))
            continue;
        for (size_t k = 0; k < curve->count; k++)
            if (fabs(curve->points[k].value[QUANTITY_LOAD] / (loads[i] * gradient) - 1) < 1e-9)
                point = &curve->points[k];
        for (size_t a = 0; a < ASKED; a++) {
            struct finding finding = {m, law, a, i, findings->surfaces, leads, NAN, {NAN, NAN}};
            double mine = point ? point->value[model_shown(model_rows[m], asked[a])] : NAN;
            if (mine > 0)
                finding.ln_ratio = log(mine / value[a]);
            for (size_t end = 0; end < 2 && mine > 0 && record->bands[m]; end++) {
                double unit = asked[a] == QUANTITY_SEPARATION ? record->summary.asperities.sigma_m : 1;
                finding.ln_end[end] = log(record->bands[m][i].mean[asked[a]][end] * unit / value[a]);
            }
            add(findings, &finding);
        }
    }
}

/** Surfaces made of what the rows say, solved, against the one they are rows of. */
static void hold_synthesis(struct findings *findings, const struct surface_record *record, const struct scene *scene,
                           const struct plan *plan, size_t law, const struct direct_point *truth)
{
    struct direct_study study;
    const struct direct_study_task task = {.surface = record, .asked = {.scene = scene, .plan = plan}};
    assert_true(record->summary.direct->possible);
    expect_ok(direct_study_run, &study, &task);
    for (size_t k = 0; k < study.plan.loads; k++)
        for (size_t i = 0; i < LOADS; i++)
            for (size_t a = 0; a < ASKED && fabs(study.plan.load[k] / (loads[i] * gradient) - 1) < 1e-9; a++) {
                double value[ASKED] = {truth[i].quantities.area_ratio, truth[i].quantities.gap_m,
                                       2 * resistivity_ohm_m * truth[i].constriction_m};
                double mine =
                    direct_study_value(&study, &record->summary.pair, DIRECT_STUDY_ELASTIC, asked[a], k, NULL);
                add(findings,
                    &(struct finding){model_count + 1, law, a, i, 0, false, log(mine / value[a]), {NAN, NAN}});
            }
    direct_study_free(&study);
}

/** A surface's rows through the analysis. */
static void hold(struct findings *findings, const double *height_m, const struct part *part, size_t law,
                 double hardness, bool turned, const struct direct_point *truth)
{
    struct directory place = directory_make();
    struct analysis analysis;
    write_scans(&place, height_m, part, hardness, turned);
    analysis_make(&analysis, &place);
    const struct surface_record *record = &analysis.record[0];
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs_model(&analysis.plan, m) &&
            (isinf(hardness) || model_rows[m]->plastic || !model_rows[m]->elastic))
            hold_curve(findings, record, m, m == plan_leading_model(&analysis.plan), law, truth);
    findings->surfaces++;
    if (part == &parts[SYNTHESIS])
        hold_synthesis(findings, record, &analysis.scene, &analysis.plan, law, truth);
    analysis_free(&analysis);
    directory_remove(&place);
}

/** Which of the findings: of a model (model_count: the leading one), of a law (LAWS: any; LAWS + 1: any but Gaussian).
 */
static bool is_of(const struct finding *finding, size_t model, size_t law, size_t quantity)
{
    return finding->quantity == quantity && (model == model_count ? finding->leads : finding->model == model) &&
           (law == LAWS + 1 ? finding->law > 0 : law == LAWS || finding->law == law);
}

/** Has the model (model_count: any) said anything? */
static bool ran(const struct findings *findings, size_t model)
{
    for (size_t k = 0; k < findings->count; k++)
        if (findings->all[k].model == model || model == model_count)
            return true;
    return false;
}

/** rms of ln(answer/solution) of A, gap and ECR: in one cell or, with bounds, in three; load LOADS: at any. */
static void add_rms(struct page *page, const struct findings *findings, size_t model, size_t law, size_t load,
                    const double *bound)
{
    size_t printed = 0, all = 0; /* numbers */
    for (size_t a = 0; a < ASKED && ran(findings, model); a++) {
        double sum = 0, count = 0;
        for (size_t k = 0; k < findings->count; k++) {
            const struct finding *finding = &findings->all[k];
            if (!is_of(finding, model, law, a) || (load < LOADS && finding->load != load))
                continue;
            all++;
            printed += isnan(finding->ln_ratio) ? 0 : 1;
            sum += isnan(finding->ln_ratio) ? 0 : pow(finding->ln_ratio, 2);
            count += !isnan(finding->ln_ratio);
        }
        if (bound)
            page_number(page, sqrt(sum / count), bound[a]);
        else
            text_add(&page->text, count > 0 ? " %.2f" : " –", sqrt(sum / count));
    }
    if (printed < all && !bound)
        text_add(&page->text, " (%zu of %zu)", printed, all);
    text_add(&page->text, bound ? "\n" : all > 0 ? " |" : " – |");
}

/** A row over the first five parts. */
static void add_row(struct page *page, const char *name, const struct findings *findings, size_t model, size_t law)
{
    text_add(&page->text, "| %s |", name);
    for (size_t p = 0; p <= HARD; p++)
        add_rms(page, &findings[p], model, law, LOADS, NULL);
    text_add(&page->text, "\n");
}

/** How many truths lie beyond a model's interval (model_count: the leading answer's), and its median half width. */
static void add_intervals(struct page *page, const struct findings *findings, size_t model, double bound)
{
    OWNED(memory_free) double *half_width = coverage_allocate(findings->count + 1, sizeof *half_width);
    double median[ASKED];
    for (size_t a = 0; a < ASKED; a++) {
        size_t count = 0, beyond = 0;
        for (size_t k = 0; k < findings->count; k++) {
            const struct finding *finding = &findings->all[k];
            if (!is_of(finding, model, LAWS, a) || !has_interval(finding))
                continue;
            half_width[count++] = (finding->ln_end[1] - finding->ln_end[0]) / 2;
            beyond += !holds(finding);
        }
        gsl_sort(half_width, 1, count);
        median[a] = count > 0 ? exp(gsl_stats_median_from_sorted_data(half_width, 1, count)) : 1;
        if (count > 0)
            page_number(page, (double)beyond / (double)count, bound);
        else /* the textbook's area is P/H, whatever the scan */
            text_add(&page->text, " – |");
    }
    text_add(&page->text, " %.1f %.1f %.1f |\n", median[0], median[1], median[2]);
}

/** Of the intervals that two models have of one number, the share that do not overlap. */
static void add_overlaps(struct page *page, const char *name, const struct findings *findings)
{
    text_add(&page->text, "| %s |", name);
    for (size_t a = 0; a < ASKED; a++) {
        size_t pairs = 0, apart = 0;
        for (size_t k = 0; k < findings->count; k++)
            for (size_t l = k + 1; l < findings->count && findings->all[l].surface == findings->all[k].surface; l++) {
                const struct finding *one = &findings->all[k], *other = &findings->all[l];
                if (one->quantity != a || other->quantity != a || one->load != other->load || !has_interval(one) ||
                    !has_interval(other))
                    continue;
                pairs++;
                apart += one->ln_end[0] > other->ln_end[1] || other->ln_end[0] > one->ln_end[1];
            }
        page_number(page, (double)apart / (double)pairs, 0.05);
    }
    text_add(&page->text, "\n");
}

/** Rms, share beyond the interval and its median half width: in two directions, and in one. */
static void add_directions(struct page *page, const struct findings *findings)
{
    page_rows(page, "directions");
    for (size_t p = TWO; p < PARTS; p++) {
        text_add(&page->text, "| %s | %g |", parts[p].title, parts[p].ratio);
        add_rms(page, &findings[p], model_count, LAWS, LOADS, NULL);
        add_intervals(page, &findings[p], model_count, p < ONE ? 0.09 : 0);
    }
}

static void add_synthesis(struct page *page, const struct findings *findings)
{
    static const size_t compared[] = {0, 3, 6}; /* of the loads */
    page_rows(page, "synthesis");
    for (size_t k = 0; k < sizeof compared / sizeof *compared; k++) {
        text_add(&page->text, "| %g |", loads[compared[k]]);
        add_rms(page, findings, model_count + 1, 0, compared[k], (double[]){0, 0, 0});
    }
    text_add(&page->text, "| 0.35, the worst map: share off |");
    for (size_t a = 0; a < ASKED; a++) {
        double worst = 0;
        for (size_t k = 0; k < findings->count; k++)
            if (is_of(&findings->all[k], model_count + 1, 0, a) && findings->all[k].load == compared[2])
                worst = fmax(worst, fabs(exp(findings->all[k].ln_ratio) - 1));
        page_number(page, worst, a > 0 ? 0.15 : 0);
    }
    text_add(&page->text, "\n");
}

static void run(struct findings *out, const struct part *part)
{
    for (size_t law = 0; law < part->laws; law++)
        for (size_t k = 0; k < part->each; k++) {
            double waves = part->roll_off * (k < 12 ? 1 : 2);
            OWNED(memory_free) double *height_m = make_surface(law, hursts[k % HURSTS], waves, part->ratio, 1 + k);
            for (size_t h = 0; h < part->hardnesses || h == 0; h++) {
                struct direct_point truth[LOADS];
                double hardness = part->hardnesses > 0 ? hardnesses[h] : INFINITY;
                solve(truth, height_m, hardness);
                hold(out, height_m, part, law, hardness, k % 2, truth);
            }
        }
}

static void add_tables(struct page *page, const struct findings *findings)
{
    for (size_t law = 0; law <= LAWS + 1; law += LAWS + 1) {
        page_rows(page, law == 0 ? "gaussian" : "other");
        for (size_t m = 0; m < model_count; m++)
            if (ran(&findings[HARD], m))
                add_row(page, model_rows[m]->name, findings, m, law);
    }
    page_rows(page, "laws");
    for (size_t law = 0; law <= LAWS; law++)
        add_row(page, law < LAWS ? height_laws[law].name : "all", findings, model_count, law);
    page_rows(page, "bounds");
    for (size_t p = 0; p < PARTS; p++)
        if (parts[p].bounded) {
            text_add(&page->text, "| %s |", parts[p].bounded);
            add_rms(page, &findings[p], model_count, LAWS, LOADS, parts[p].bound);
        }
    struct findings half = {findings[SPECTRUM].all, findings[SPECTRUM].count / 2, 0};
    text_add(&page->text, "| of these those of 4 waves |");
    add_rms(page, &half, model_count, LAWS, LOADS, (double[ASKED]){0});
    page_rows(page, "intervals");
    for (size_t p = 0; p <= HARD; p++) {
        text_add(&page->text, "| %s |", parts[p].title);
        add_intervals(page, &findings[p], model_count, parts[p].bounded ? 0.12 : 0);
    }
    page_rows(page, "models");
    for (size_t p = 0; p <= HARD; p += HARD)
        for (size_t m = 0; m < model_count; m++)
            if (ran(&findings[p], m)) {
                text_add(&page->text, "| %s | %s |", parts[p].title, model_rows[m]->name);
                add_intervals(page, &findings[p], m, p == HARD && !model_rows[m]->plastic ? 0.13 : 0.1);
            }
    page_rows(page, "overlaps");
    for (size_t p = 0; p <= HARD; p += HARD)
        add_overlaps(page, parts[p].title, &findings[p]);
    add_directions(page, findings);
    add_synthesis(page, &findings[SYNTHESIS]);
}

int main(int count, char **word)
{
    struct findings findings[PARTS] = {0};
    OWNED(text_free) struct text template = {0};
    if (count != 2)
        return 2;
    expect_ok(text_read_file, &template, PROJECT_SOURCE "/tests/validation/page.md");
    struct page page = {.rest = template.data};
    truths_add(&page);
    quadrature_add(&page);
    for (size_t p = 0; p < PARTS; p++) {
        fprintf(stderr, "%s\n", parts[p].title);
        run(&findings[p], &parts[p]);
    }
    add_tables(&page, findings);
    nulls_add(&page);
    truths_add_coverage(&page);
    text_add(&page.text, "%s", page.rest);
    (void)remove(word[1]);
    expect_ok(text_write_file, word[1], text_string(&page.text), page.text.length);
    for (size_t p = 0; p < PARTS; p++)
        free(findings[p].all);
    text_free(&page.text);
    return page.outside > 0;
}
