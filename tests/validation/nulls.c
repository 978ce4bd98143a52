/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The same surface twice: scans, and maps, of two halves of one stationary surface through the analysis and the test of
 * two surfaces. What is told apart is a false verdict; with one half's heights stretched, a true one. */
#include "validation/nulls.h"

#include "answers/answers.h"
#include "direct/direct_surface.h"
#include "directory.h"
#include "members/surface_read.h"
#include "plan/effects.h"
#include "results/comparison.h"
#include "statistics/coverage.h"
#include "validation/height_laws.h"

enum {
    SIDE = 512,
    MAP = 128,
    ROWS = 5,  /* scans of either half */
    EACH = 40, /* surfaces of a kind */
    MAPS_EACH = 12,
    MAPS = 2, /* of either half */
    POWER_EACH = 10,
    FAMILIES = 4, /* of a kind */
    MEMBERS = 20,
    SCANS_EACH = 4, /* of a surface, that lie two of the longest waves apart */
    KINDS = 5,
    HARDNESSES = 4,
    SETS = 5,
    STRETCHES = 4,
    ASKED = 3
};

static const double spacing_m = 1e-6, gradient = 0.05, cut_off_m = 8e-6, load = 0.02, resistivity_ohm_m = 5e-7;
static const double hardnesses[HARDNESSES] = {INFINITY, 0.03, 0.15, 0.5}; /* over E' g */
static const double stretches[STRETCHES] = {1, 1.5, 2, 4};
static const enum quantity asked[ASKED] = {QUANTITY_AREA, QUANTITY_SEPARATION, QUANTITY_ECR};

static const struct kind {
    const char *name;
    enum height_law law;
    double roll_off; /* waves of the longest length in a row */
} kinds[KINDS] = {{"Gaussian", HEIGHTS_GAUSSIAN, 8},
                  {"peaks", HEIGHTS_PEAKS, 8},
                  {"valleys", HEIGHTS_VALLEYS, 8},
                  {"worn", HEIGHTS_WORN, 8},
                  {"self-affine to the scan's length", HEIGHTS_GAUSSIAN, 1}};

/** Scans, or a map (0), of the first half against those of the second. */
static const struct set {
    const char *name;
    size_t scans[2];
    bool across; /* as many of the columns too */
} sets[SETS] = {{"1 and 1", {1, 1}, false},
                {"3 and 3", {3, 3}, false},
                {"5 and 5", {5, 5}, false},
                {"1 and 5", {1, 5}, false},
                {"3 + 3 and 3 + 3", {3, 3}, true}};
static const struct set maps = {"maps", {0, 0}, false};

/** Heights of rms gradient `gradient`, Hurst exponent 0.7. */
static double *make_surface(const struct kind *kind, uint64_t seed)
{
    struct direct_law rows = {1e-3, 1.2, cut_off_m, SIDE * spacing_m, kind->roll_off};
    struct direct_spectrum spectrum;
    double *height_m = coverage_allocate((size_t)SIDE * SIDE, sizeof *height_m), square = 0, slopes = 0;
    expect_ok(direct_spectrum_of_law, &spectrum, &rows);
    expect_ok(direct_surface_make, height_m, SIDE,
              &(struct direct_recipe){direct_spectrum_variance, &spectrum, NULL, 0}, 1000 + seed);
    direct_spectrum_free(&spectrum);
    for (size_t i = 0; i < (size_t)SIDE * SIDE; i++)
        square += height_m[i] * height_m[i];
    double rms_m = sqrt(square) / SIDE;
    for (size_t i = 0; i < (size_t)SIDE * SIDE; i++)
        height_m[i] = height_laws[kind->law].of(height_m[i] / rms_m);
    for (size_t i = 0; i < (size_t)SIDE * SIDE; i++) {
        double step = (height_m[i / SIDE * SIDE + (i + 1) % SIDE] - height_m[i]) / spacing_m;
        slopes += 2 * step * step;
    }
    for (size_t i = 0; i < (size_t)SIDE * SIDE; i++)
        height_m[i] *= gradient * SIDE / sqrt(slopes);
    return height_m;
}

/** Half a side's heights, every `step`-th value, as a scan NAME/NUMBER.csv. */
static void write_scan(const struct directory *place, const char *name, size_t number, const double *z, size_t step,
                       double stretch)
{
    char file[32];
    OWNED(text_free) struct text text = {0};
    text_add(&text, "x [um],z [nm]\n");
    for (size_t i = 0; i < SIDE / 2; i++)
        text_add(&text, "%zu,%.9g\n", i, stretch * z[i * step] * 1e9);
    snprintf(file, sizeof file, "%s/%zu.csv", name, number);
    directory_write(place, file, text_string(&text));
}

/** `count` scans of a half, from its edge, or (0) a map of the middle of its left or right half. */
static void write_half(const struct directory *place, const char *name, const double *height_m, int half, size_t right,
                       const struct set *set, double stretch)
{
    char file[32];
    OWNED(text_free) struct text text = {0};
    const size_t count = set->scans[half], row = (size_t)half * SIDE / 2;
    for (size_t r = 0; r < count; r++) {
        size_t at = (2 * r + 1) * SIDE / 2 / (2 * count);
        write_scan(place, name, r, height_m + (row + at) * SIDE, 1, stretch);
        if (set->across)
            write_scan(place, name, count + r, height_m + row * SIDE + at, SIDE, stretch);
    }
    if (count > 0)
        return;
    text_add(&text, "Gwyddion Simple Field 1.0\nXRes = %d\nYRes = %d\nXReal = %.9g\nYReal = %.9g\n", MAP, MAP,
             MAP * spacing_m, MAP * spacing_m);
    text_add(&text, "XYUnits = m\nZUnits = m\n");
    text_add_bytes(&text, "\0\0\0\0", 4 - text.length % 4);
    for (size_t i = 0; i < MAP * MAP; i++) {
        float z = (float)(stretch * height_m[((size_t)half * SIDE / 2 + SIDE / 8 + i / MAP) * SIDE + right * SIDE / 2 +
                                             SIDE / 8 + i % MAP]);
        text_add_bytes(&text, (const char *)&z, sizeof z);
    }
    snprintf(file, sizeof file, "%s/map.gsf", name);
    directory_write(place, file, "");
    expect_ok(text_write_file, directory_path(place, file), text.data, text.length);
}

/** `across`: scans 3 to 5 of a and c run along. */
static void write_scene(const struct directory *place, double hardness, bool across)
{
    OWNED(text_free) struct text scene = {0};
    double hardness_Pa = 1e11 * gradient * (isinf(hardness) ? 10 : hardness);
    text_add(&scene, "material: {E: 100 GPa, nu: 0, Sy: %.17g, resistivity: %g ohm m, hardness: %.17g}\n",
             hardness_Pa / material_hardness_ratio, resistivity_ohm_m, hardness_Pa);
    text_add(&scene, "effects: [separation, electrical, uncertainty%s]\n", isinf(hardness) ? "" : ", plasticity");
    text_add(&scene, "load: {values: [%.17g, %.17g, %.17g]}\noperating_load: %.17g Pa\n", load * gradient / 2,
             load * gradient, load * gradient * 2, load * gradient * 1e11);
    for (const char *name = "ac"; across && *name; name++)
        text_add(&scene, "%s  - {name: %c, file: '%c/[0-2].csv', along: '%c/[3-5].csv'}\n",
                 *name == 'a' ? "surfaces:\n" : "", *name, *name, *name);
    directory_write(place, "scene.yaml", text_string(&scene));
}

/** Pairs of answers that are told apart, of those that there are. */
struct count {
    size_t apart, pairs, lost; /* without an interval */
};

/** The test of two answers, quantity by quantity. */
static void compare(struct count *out, const struct surface_summary *first, const struct surface_summary *second,
                    size_t leading)
{
    for (size_t a = 0; a < ASKED; a++) {
        const struct estimate *of_first = curve_summary_estimate(surface_model(first, leading), (int)asked[a]),
                              *of_second = curve_summary_estimate(surface_model(second, leading), (int)asked[a]);
        if (of_first->count == 0 || of_second->count == 0 || !(of_first->s >= 0) || !(of_second->s >= 0)) {
            out->lost++;
            continue;
        }
        struct comparison_pair tested = comparison_of_two(of_first, of_second);
        out->apart += comparison_told_apart(&tested);
        out->pairs++;
    }
}

void analysis_make(struct analysis *out, const struct directory *place)
{
    struct plan *plan = &out->plan;
    size_t operating;
    expect_ok(scene_read, &out->scene, place->path, NULL);
    plan_make(plan, &out->scene, NULL);
    struct material_pair pair = scene_pair(&out->scene.surfaces[0].bodies);
    double *loads = support_room((out->scene.load.points + 1) * sizeof *loads);
    const size_t count = scene_loads(loads, &operating, &out->scene, &pair);
    plan->operating_place = operating + 1;
    out->record = coverage_allocate(out->scene.surface_count, sizeof *out->record);
    const struct surface_task task = {.scene = &out->scene, .plan = plan, .loads = loads, .load_count = count};
    for (size_t k = 0; k < out->scene.surface_count; k++) {
        expect_ok(surface_read, &out->record[k], &out->scene, &out->scene.surfaces[k], NULL);
        assert_true(out->record[k].summary.usable);
        expect_ok(effects_bound, &out->record[k], &task);
    }
    effects_decide(plan, &out->scene, out->record, out->scene.surface_count);
    for (size_t k = 0; k < out->scene.surface_count; k++)
        expect_ok(surface_answers_find, &out->record[k], &task);
    effects_fit_models(plan, out->record, out->scene.surface_count);
}

void analysis_free(struct analysis *analysis)
{
    for (size_t k = 0; k < analysis->scene.surface_count; k++)
        surface_record_free(&analysis->record[k]);
    free(analysis->record);
    scene_free(&analysis->scene);
}

/** Surfaces of one half held against each of the other's. */
static void hold(struct count *out, const struct directory *place)
{
    struct analysis analysis;
    analysis_make(&analysis, place);
    size_t each = analysis.scene.surface_count / 2;
    for (size_t k = 0; k < each * each; k++)
        compare(out, &analysis.record[k / each].summary, &analysis.record[each + k % each].summary,
                plan_leading_model(&analysis.plan));
    analysis_free(&analysis);
}

/** Are any two of a family told apart, as a report ranks its surfaces? */
static bool family_apart(const struct directory *place)
{
    struct analysis analysis;
    struct comparison ranking = {.count = MEMBERS};
    const struct estimate *estimates[MEMBERS];
    bool apart = false;
    analysis_make(&analysis, place);
    for (size_t k = 0; k < MEMBERS; k++)
        estimates[k] = curve_summary_estimate(
            surface_model(&analysis.record[k].summary, plan_leading_model(&analysis.plan)), QUANTITY_ECR);
    expect_ok(comparison_test, &ranking, estimates);
    for (size_t k = 0; k < MEMBERS * (MEMBERS - 1) / 2; k++)
        apart = apart || comparison_told_apart(&ranking.pairs[k]);
    comparison_free(&ranking);
    analysis_free(&analysis);
    return apart;
}

/** One scan a surface of one population. */
static void write_family(const struct directory *place, const struct kind *kind, uint64_t seed)
{
    for (size_t k = 0; k < MEMBERS / SCANS_EACH; k++) {
        OWNED(memory_free) double *height_m = make_surface(kind, seed * MEMBERS + k);
        for (size_t r = 0; r < SCANS_EACH; r++)
            write_scan(place, (const char[]){(char)('a' + k * SCANS_EACH + r), 0}, 0,
                       height_m + r * SIDE / SCANS_EACH * SIDE, 1, 1);
    }
}

static void add_families(struct page *page)
{
    size_t apart[HARDNESSES] = {0};
    page_rows(page, "families");
    for (size_t k = 0; k < KINDS * FAMILIES; k++) {
        struct directory place = directory_make();
        fprintf(stderr, "a family of %s\n", kinds[k % KINDS].name);
        write_family(&place, &kinds[k % KINDS], 1 + k);
        for (size_t h = 0; h < HARDNESSES; h++) {
            write_scene(&place, hardnesses[h], false);
            apart[h] += family_apart(&place);
        }
        directory_remove(&place);
    }
    text_add(&page->text, "| told apart |");
    for (size_t h = 0; h < HARDNESSES; h++)
        page_number(page, (double)apart[h] / (KINDS * FAMILIES), 0.05);
    text_add(&page->text, "\n");
}

/** One kind of surface, `each` of them: the counts of every hardness. */
static void run(struct count out[HARDNESSES], const struct kind *kind, const struct set *set, size_t each,
                double stretch)
{
    for (size_t k = 0; k < each; k++) {
        struct directory place = directory_make();
        OWNED(memory_free) double *height_m = make_surface(kind, k);
        for (size_t half = 0; half < 2; half++)
            for (size_t right = 0; right < (set->scans[half] > 0 ? 1 : MAPS); right++)
                write_half(&place, (const char[]){(char)('a' + MAPS * half + right), 0}, height_m, (int)half, right,
                           set, half > 0 ? stretch : 1);
        for (size_t h = 0; h < HARDNESSES; h++) {
            write_scene(&place, hardnesses[h], set->across);
            hold(&out[h], &place);
        }
        directory_remove(&place);
    }
}

static double share(const struct count *count)
{
    return (double)count->apart / (double)count->pairs;
}

static void add_set(struct page *page, const struct set *set, size_t each, struct count *all)
{
    for (size_t k = 0; k < KINDS; k++) {
        struct count own[HARDNESSES] = {{0}};
        fprintf(stderr, "the same surface twice: %s, %s\n", set->name, kinds[k].name);
        run(own, &kinds[k], set, each, 1);
        text_add(&page->text, "| %s | %s |", set->name, kinds[k].name);
        for (size_t h = 0; h < HARDNESSES; h++) {
            page_number(page, share(&own[h]), 0.12);
            all->apart += own[h].apart;
            all->pairs += own[h].pairs;
            all->lost += own[h].lost;
        }
        text_add(&page->text, "\n");
    }
}

void nulls_add(struct page *page)
{
    struct count all = {0};
    page_rows(page, "nulls");
    for (size_t s = 0; s < SETS; s++)
        add_set(page, &sets[s], EACH, &all);
    add_set(page, &maps, MAPS_EACH, &all);
    text_add(&page->text, "| all | |");
    page_number(page, share(&all), 0.06);
    text_add(&page->text, " without an interval: | %zu of %zu | |\n", all.lost, all.lost + all.pairs);
    page_rows(page, "power");
    for (size_t s = 0; s < SETS; s++) {
        text_add(&page->text, "| %s |", sets[s].name);
        for (size_t f = 1; f < STRETCHES; f++) {
            struct count own[HARDNESSES] = {{0}};
            for (size_t k = 0; k < KINDS; k++)
                run(own, &kinds[k], &sets[s], POWER_EACH, stretches[f]);
            text_add(&page->text, " %.2f, %.2f |", share(&own[0]), share(&own[2]));
        }
        text_add(&page->text, "\n");
    }
    add_families(page);
}
