/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The models against direct solutions: surfaces of nine height laws and three Hurst exponents are made by the program's
 * own synthesis and solved; some rows of each then go through the analysis as line scans, and every model's answer is
 * held against the solution. Minutes; hence no test. Writes Markdown to the file named.
 * cmake --workflow --preset validation */
#include "analysis/evaluate.h"
#include "base/text.h"
#include "direct/direct_ladder.h"
#include "direct/direct_surface.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { SIDE = 256, GIVEN = SIDE * SIDE, LAWS = 9, HURSTS = 3, HARDNESSES = 3, ASKED = 3, LOADS = 9 };

static const double spacing_m = 1e-6, gradient = 0.05, cut_off_m = 8e-6, resistivity_ohm_m = 5e-7, largest_area = 0.9;
static const double hursts[HURSTS] = {0.3, 0.6, 0.9}, hardnesses[HARDNESSES] = {0.03, 0.15, 0.5};
static const double loads[LOADS] = {0.003, 0.01, 0.03, 0.06, 0.12, 0.2, 0.35, 0.6, 1}; /* P/(A_n E' g) */
static const enum quantity asked[ASKED] = {QUANTITY_AREA, QUANTITY_SEPARATION, QUANTITY_ECR};

static double as_is(double u)
{
    return u;
}

static double plateau(double u)
{
    return u < 0 ? u : 0.15 * u;
}

static double pits(double u)
{
    return u < -1 ? u + 3 * (u + 1) : u;
}

static double peaks(double u)
{
    return -pits(-u);
}

static double lognormal(double u)
{
    return exp(0.5 * u);
}

static double valleys(double u)
{
    return -lognormal(-u);
}

static double clipped(double u)
{
    return fmin(u, 0.3) + 0.01 * u;
}

static double bimodal(double u)
{
    return 1.5 * tanh(3 * u) + 0.3 * u;
}

static double heavy(double u)
{
    return sinh(0.8 * u);
}

/** A set of surfaces and of line scans of them. */
static const struct part {
    const char *title;
    double roll_off;     /* waves of the longest length in a side */
    size_t rows, points; /* of the scans */
    size_t laws, seeds;
    bool hard;          /* with a hardness */
    const char *models; /* NULL: those that run by default */
} parts[] = {
    {"Five scans, four of the longest waves in each", 4, 5, SIDE, LAWS, 1, false, NULL},
    {"One scan, four of the longest waves in it", 4, 1, SIDE, LAWS, 1, false, NULL},
    {"Five scans, some 2.5 of the longest waves in each, ends open", 4, 5, 150, LAWS, 1, false, NULL},
    {"Five scans, shorter than the longest waves, ends open", 1, 5, 150, LAWS, 1, false, NULL},
    {"Five scans, four of the longest waves in each, hardness H/(E' g) = 0.03, 0.15, 0.5", 4, 5, SIDE, LAWS, 1, true,
     NULL},
    {"The spectrum of 64 scans of Gaussian surfaces", 4, 64, SIDE, 1, 4, false, "corrected-persson"},
};
enum { PARTS = sizeof parts / sizeof *parts };

/** Heights of a surface, as a function of normal ones. */
static const struct {
    const char *name;
    double (*of)(double normal);
} laws[LAWS] = {{"Gaussian", as_is},      {"plateau-honed", plateau}, {"deep pits", pits},
                {"peaks", peaks},         {"lognormal", lognormal},   {"lognormal, upside down", valleys},
                {"ground flat", clipped}, {"bimodal", bimodal},       {"heavy tails", heavy}};

static void must(enum status_code code, const struct status *status)
{
    if (code == STATUS_OK)
        return;
    fprintf(stderr, "validation: %s\n", status->message);
    exit(1);
}

static void *room(size_t count, size_t size)
{
    void *out = calloc(count, size);
    if (!out)
        must(STATUS_MEMORY, &(struct status){.message = "out of memory"});
    return out;
}

/** A surface of rms gradient `gradient`, SIDE x SIDE. */
static double *make_surface(size_t law, double hurst, double roll_off, uint64_t seed)
{
    double *height_m = room((size_t)SIDE * SIDE, sizeof *height_m), *given = room(GIVEN, sizeof *given), m2 = 0;
    struct direct_law rows = {1, hurst + 0.5, cut_off_m, SIDE * spacing_m, roll_off};
    struct direct_spectrum spectrum;
    struct status status = {0};
    for (size_t m = 1; m <= direct_law_harmonics(&rows); m++)
        m2 += pow(2 * M_PI * (double)m / rows.length_m * direct_law_amplitude(&rows, m), 2) / 2;
    rows.alpha *= gradient / sqrt(2 * m2);
    must(direct_spectrum_of_law(&spectrum, &rows, &status), &status);
    for (size_t k = 0; k < GIVEN; k++)
        given[k] = laws[law].of(gsl_cdf_ugaussian_Pinv(((double)k + 0.5) / GIVEN));
    must(direct_surface_make(height_m, SIDE, direct_spectrum_variance, &spectrum, law == 0 ? NULL : given, GIVEN, seed,
                             &status),
         &status);
    direct_spectrum_free(&spectrum);
    free(given);
    return height_m;
}

/** Solutions at `loads`, for a hardness over E' g; INFINITY: elastic. */
static void solve(struct direct_point *out, const double *height_m, double hardness)
{
    double own[LOADS], *copy = room((size_t)SIDE * SIDE, sizeof *copy);
    struct status status = {0};
    memcpy(copy, height_m, (size_t)SIDE * SIDE * sizeof *copy);
    for (size_t i = 0; i < LOADS; i++)
        own[i] = loads[i] * gradient;
    const struct direct_ladder_def def = {
        .load = own, .loads = LOADS, .hardness = hardness * gradient, .tolerance = 1e-6, .resistance = true};
    must(direct_ladder_of_heights(out, NULL, NULL, copy, SIDE, spacing_m, &def, NULL, &status), &status);
}

/** Writes rows and a scene into the directory. */
static void write_scans(const char *directory, const double *height_m, const struct part *part, double hardness)
{
    struct text scene = {0}, row = {0};
    char path[192];
    struct status status = {0};
    double hardness_Pa = 1e11 * gradient * (isinf(hardness) ? 10 : hardness);
    text_add(&scene, "material: {E: 100 GPa, nu: 0, Sy: %.17g, resistivity: %g ohm m, hardness: %.17g}\n",
             hardness_Pa / material_hardness_ratio, resistivity_ohm_m, hardness_Pa);
    if (part->models)
        text_add(&scene, "models: [%s]\n", part->models);
    text_add(&scene, "effects: [separation, electrical, uncertainty%s]\n", isinf(hardness) ? "" : ", plasticity");
    text_add(&scene, "load: {values: [");
    for (size_t i = 0; i < LOADS; i++)
        text_add(&scene, "%s%.17g", i > 0 ? ", " : "", loads[i] * gradient);
    text_add(&scene, "]}\nsurfaces: [{name: s, file: [");
    for (size_t r = 0; r < part->rows; r++) {
        const double *z = height_m + (2 * r + 1) * SIDE / (2 * part->rows) * SIDE;
        text_add(&row, "x [um],z [nm]\n");
        for (size_t i = 0; i < part->points; i++)
            text_add(&row, "%zu,%.9g\n", i, z[i] * 1e9);
        snprintf(path, sizeof path, "%s/row-%zu.csv", directory, r);
        (void)remove(path);
        must(text_write_file(path, text_string(&row), row.length, &status), &status);
        text_free(&row);
        text_add(&scene, "%srow-%zu.csv", r > 0 ? ", " : "", r);
    }
    text_add(&scene, "]}]\n");
    snprintf(path, sizeof path, "%s/scene.yaml", directory);
    (void)remove(path);
    must(text_write_file(path, text_string(&scene), scene.length, &status), &status);
    text_free(&scene);
}

/** What was found of one number. */
struct finding {
    size_t model, law, quantity;
    bool leads;
    double ln_ratio, ln_half_width; /* NaN: not printed */
    bool holds;
};

struct findings {
    struct finding *all;
    size_t count;
};

static void add(struct findings *findings, const struct finding *finding)
{
    findings->all = reallocarray(findings->all, findings->count + 1, sizeof *findings->all);
    if (!findings->all)
        must(STATUS_MEMORY, &(struct status){.message = "out of memory"});
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
            struct finding finding = {m, law, a, leads, NAN, NAN, false};
            double mine = point ? point->value[model_shown(model_rows[m], asked[a])] : NAN;
            if (mine > 0)
                finding.ln_ratio = log(mine / value[a]);
            if (mine > 0 && leads && record->bands[m]) {
                const double *end = record->bands[m][i].mean[asked[a]];
                double held =
                    asked[a] == QUANTITY_SEPARATION ? value[a] / record->summary.asperities.sigma_m : value[a];
                finding.ln_half_width = log(end[1] / end[0]) / 2;
                finding.holds = held >= end[0] && held <= end[1];
            }
            add(findings, &finding);
        }
    }
}

/** A surface's rows through the analysis. */
static void hold(struct findings *findings, const char *directory, const double *height_m, const struct part *part,
                 size_t law, double hardness, const struct direct_point *truth)
{
    struct scene scene;
    struct plan plan;
    struct surface_record record = {0};
    struct status status = {0};
    double *own;
    size_t count, operating;
    write_scans(directory, height_m, part, hardness);
    must(scene_read(&scene, directory, NULL, &status), &status);
    plan_make(&plan, &scene);
    struct material_pair pair = scene_pair(scene.surfaces[0].bodies);
    must(scene_loads(&own, &count, &operating, &scene, &pair, &status), &status);
    plan.operating_place = operating + 1;
    const struct evaluate_task task = {
        .scene = &scene, .surface = &scene.surfaces[0], .plan = &plan, .loads = own, .load_count = count};
    must(evaluate_surface(&record, &task, &status), &status);
    if (!record.summary.usable)
        must(STATUS_SCAN, &(struct status){.message = "a surface was refused"});
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs_model(&plan, m) && (isinf(hardness) || model_rows[m]->plastic || !model_rows[m]->elastic))
            hold_curve(findings, &record, m, m == plan_leading_model(&plan), law, truth);
    surface_record_free(&record);
    scene_free(&scene);
    free(own);
}

/** Which of the findings: of a model (model_count: the leading one), of a law (LAWS: any; LAWS + 1: any but Gaussian).
 */
static bool is_of(const struct finding *finding, size_t model, size_t law, size_t quantity)
{
    return finding->quantity == quantity && (model == model_count ? finding->leads : finding->model == model) &&
           (law == LAWS + 1 ? finding->law > 0 : law == LAWS || finding->law == law);
}

static void add_rms(struct text *page, const struct findings *findings, size_t model, size_t law)
{
    size_t printed = 0, all = 0; /* numbers */
    for (size_t a = 0; a < ASKED; a++) {
        double sum = 0, count = 0;
        for (size_t k = 0; k < findings->count; k++) {
            const struct finding *finding = &findings->all[k];
            if (!is_of(finding, model, law, a))
                continue;
            all++;
            printed += isnan(finding->ln_ratio) ? 0 : 1;
            sum += isnan(finding->ln_ratio) ? 0 : pow(finding->ln_ratio, 2);
            count += !isnan(finding->ln_ratio);
        }
        text_add(page, count > 0 ? " %.2f" : " –", sqrt(sum / count));
    }
    if (printed < all)
        text_add(page, " (%zu of %zu)", printed, all);
    text_add(page, " |");
}

static void add_models(struct text *page, const struct findings *findings)
{
    text_add(page, "\n| rms ln of A, gap, ECR | Gaussian heights | other heights |\n|---|---|---|\n");
    for (size_t m = 0; m < model_count; m++) {
        bool ran = false;
        for (size_t k = 0; k < findings->count; k++)
            ran = ran || findings->all[k].model == m;
        if (!ran)
            continue;
        text_add(page, "| %s |", model_rows[m]->name);
        add_rms(page, findings, m, 0);
        add_rms(page, findings, m, LAWS + 1);
        text_add(page, "\n");
    }
}

/** The leading answer, law by law. */
static void add_laws(struct text *page, const struct findings *findings)
{
    text_add(page, "\n| leading answer, heights | rms ln of A, gap, ECR |\n|---|---|\n");
    for (size_t law = 0; law <= LAWS; law++) {
        text_add(page, "| %s |", law < LAWS ? laws[law].name : "all");
        add_rms(page, findings, model_count, law);
        text_add(page, "\n");
    }
}

static void add_intervals(struct text *page, const struct findings *findings)
{
    double *half_width = room(findings->count + 1, sizeof *half_width);
    text_add(page, "\n| 95 %% interval of the leading answer | A | gap | ECR |\n|---|---|---|---|\n| holds |");
    for (int row = 0; row < 2; row++) {
        for (size_t a = 0; a < ASKED; a++) {
            size_t count = 0, holds = 0;
            for (size_t k = 0; k < findings->count; k++) {
                const struct finding *finding = &findings->all[k];
                if (!is_of(finding, model_count, LAWS, a) || isnan(finding->ln_half_width))
                    continue;
                half_width[count++] = finding->ln_half_width;
                holds += finding->holds;
            }
            gsl_sort(half_width, 1, count);
            if (row == 0)
                text_add(page, " %.2f of %zu |", (double)holds / (double)count, count);
            else
                text_add(page, " %.1f |", exp(gsl_stats_median_from_sorted_data(half_width, 1, count)));
        }
        text_add(page, row == 0 ? "\n| median half width, factor |" : "\n");
    }
    free(half_width);
}

static void run(struct findings *out, const struct part *part, const char *directory)
{
    for (size_t law = 0; law < part->laws; law++)
        for (size_t h = 0; h < HURSTS; h++)
            for (size_t seed = 0; seed < part->seeds; seed++) {
                struct direct_point truth[LOADS];
                double hardness = part->hard ? hardnesses[(h + law) % HARDNESSES] : INFINITY;
                double *height_m = make_surface(law, hursts[h], part->roll_off, 1 + h + HURSTS * seed);
                solve(truth, height_m, hardness);
                hold(out, directory, height_m, part, law, hardness, truth);
                free(height_m);
            }
}

static const char introduction[] =
    "<!-- SPDX-License-Identifier: GPL-3.0-or-later -->\n"
    "# Validation\n\n"
    "Made by `cmake --workflow --preset validation` (tests/validation): surfaces of nine height laws and three Hurst\n"
    "exponents (0.3, 0.6, 0.9), 256 x 256 points, cut-off at 8 spacings, are made by the program's own synthesis and\n"
    "solved directly at nine loads. Evenly spaced rows of them go through the analysis as line scans. Held against "
    "the\n"
    "solution, where it has A < 0.9: rms of ln(answer/solution) of the area, the mean gap and the electrical contact\n"
    "resistance; (printed of all) where a model leaves some empty. 0.10 is 10 %, 0.69 a factor of 2. The statistical\n"
    "models' gap is the distance of the mean planes. `longest_waves` in results.json says how many of its longest "
    "waves a\n"
    "scan holds: below 2.5 the intervals are wider for what it cannot know.\n";

int main(int count, char **word)
{
    char directory[128], path[192];
    const char *temporary = getenv("TMPDIR");
    struct text page = {0};
    struct status status = {0};
    snprintf(directory, sizeof directory, "%s/roughcontact-validation-XXXXXX", temporary ? temporary : "/tmp");
    if (count != 2 || !mkdtemp(directory))
        return 2;
    text_add(&page, "%s", introduction);
    for (size_t p = 0; p < PARTS; p++) {
        struct findings findings = {0};
        fprintf(stderr, "%s\n", parts[p].title);
        run(&findings, &parts[p], directory);
        text_add(&page, "\n## %s\n", parts[p].title);
        add_models(&page, &findings);
        if (!parts[p].models) {
            add_laws(&page, &findings);
            add_intervals(&page, &findings);
        }
        free(findings.all);
    }
    for (size_t p = 0; p < PARTS; p++)
        for (size_t r = 0; r < parts[p].rows; r++) {
            snprintf(path, sizeof path, "%s/row-%zu.csv", directory, r);
            (void)remove(path);
        }
    snprintf(path, sizeof path, "%s/scene.yaml", directory);
    (void)remove(path);
    (void)rmdir(directory);
    (void)remove(word[1]);
    must(text_write_file(word[1], text_string(&page), page.length, &status), &status);
    text_free(&page);
    return 0;
}
