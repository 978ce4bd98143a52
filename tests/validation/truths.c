/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is known in closed form or was published, and what the program says of it. */
#include "validation/truths.h"

#include "contact/corrected_persson.h"
#include "contact/random_surface.h"
#include "contact/sinusoid.h"
#include "contact/statistical.h"
#include "direct/direct_support.h"
#include "directory.h"
#include "profile/profile.h"
#include "scan/scan.h"
#include "spectrum/power_law.h"
#include "statistics/coverage.h"

enum { GRIDS = 4 };

void page_rows(struct page *page, const char *name)
{
    char line[32];
    snprintf(line, sizeof line, "@%s\n", name);
    const char *at = strstr(page->rest, line);
    if (!at)
        fail_msg("page.md has no '@%s', or not there", name);
    text_add_bytes(&page->text, page->rest, (size_t)(at - page->rest));
    page->rest = at + strlen(line);
}

void page_number(struct page *page, double value, double bound)
{
    text_add(&page->text, bound > 0 ? " %.2g (≤ %.2g) |" : " %.2g |", value, bound);
    if (bound > 0 && !(value <= bound)) {
        fprintf(stderr, "validation: the last of%s\n", strrchr(text_string(&page->text), '\n'));
        page->outside++;
    }
}

/** A row of a table of grids: bounds hold for the finest. */
static void add_grid(struct page *page, size_t n, const double *deviation, const double *bound, size_t count, bool last)
{
    text_add(&page->text, "| %zu |", n);
    for (size_t c = 0; c < count; c++)
        page_number(page, fabs(deviation[c]), last ? bound[c] : 0);
    text_add(&page->text, "\n");
}

/** The elastic cell: by a closure, or (NULL) as solved on 1024 x 1024 points. */
static double cell_of(const struct sinusoid_fit *closure, const struct table *solved, size_t row, bool gap)
{
    struct sinusoid_cell cell = {0};
    double x = table_number(solved, row, "p_over_pstar");
    if (!closure)
        return table_number(solved, row, gap ? "gap_over_amplitude" : "area_ratio");
    closure->area(&cell, x);
    return gap ? closure->gap(x) : cell.area_ratio;
}

enum side { LIGHT, COMPLETE, SOLVED, SIDES };

/** (4.8), (4.3) for light loads, (4.9), (4.4) near complete contact. */
static double asymptote(enum side side, double x, bool gap)
{
    if (side == LIGHT)
        return gap ? 1 - pow(3 * M_PI * M_PI * x, 2.0 / 3) / 2 + 4 * log(sqrt(2) + 1) * x
                   : M_PI * pow(3 * x / (8 * M_PI), 2.0 / 3);
    return gap ? 16 / (15 * M_PI * M_PI) * pow(1.5, 1.5) * pow(1 - x, 2.5) : 1 - 3 / (2 * M_PI) * (1 - x);
}

/** One of these, or the direct solution. */
static double truth_of(enum side side, const struct table *solved, size_t row, bool gap)
{
    return side == SOLVED ? cell_of(NULL, solved, row, gap)
                          : asymptote(side, table_number(solved, row, "p_over_pstar"), gap);
}

static void add_sinusoid(struct page *page)
{
    static const struct {
        const char *name;
        const struct sinusoid_fit *closure;
        bool gap;
        double bound[SIDES];
    } rows[] = {{"gap, (4.10)", &sinusoid_fits[SINUSOID_FIT_THESIS], true, {0.12, 0.36, 0.1}},
                {"gap, closure `numeric`", &sinusoid_fits[SINUSOID_FIT_NUMERIC], true, {0.016, 0.04, 1e-12}},
                {"gap, direct solution", NULL, true, {0.016, 0.04, 0}},
                {"area, (4.5)", &sinusoid_fits[SINUSOID_FIT_THESIS], false, {0.16, 1e-12, 0.125}},
                {"area, closure `numeric`", &sinusoid_fits[SINUSOID_FIT_NUMERIC], false, {0.05, 0.002, 1e-12}},
                {"area, direct solution", NULL, false, {0.05, 0.002, 0}}};
    static const double within[SIDES][2] = {{0, 0.02}, {0.9, 1}, {0, 1}};
    struct table solved = table_read("golden/sinusoid_bem.csv");
    page_rows(page, "sinusoid");
    for (size_t r = 0; r < sizeof rows / sizeof *rows; r++) {
        text_add(&page->text, "| %s |", rows[r].name);
        for (enum side side = LIGHT; side < (rows[r].closure ? SIDES : SOLVED); side++) {
            double most = 0, where = within[side][1];
            for (size_t row = 0; row < solved.rows; row++) {
                double x = table_number(&solved, row, "p_over_pstar");
                bool inside = x >= within[side][0] && x <= within[side][1] && x < 1;
                if (!inside || (side == SOLVED && rows[r].gap && x > 0.55))
                    continue;
                double deviation =
                    cell_of(rows[r].closure, &solved, row, rows[r].gap) / truth_of(side, &solved, row, rows[r].gap) - 1;
                where = fabs(deviation) > fabs(most) ? x : where;
                most = fabs(deviation) > fabs(most) ? deviation : most;
            }
            page_number(page, fabs(most), rows[r].bound[side]);
            text_add(&page->text, " %s%.2g |", most < 0 ? "below, " : most > 0 ? "above, " : "", where);
        }
        text_add(&page->text, rows[r].closure ? "\n" : " – | – |\n");
    }
}

/** A wave of one dimension by one row, as strips are: Westergaard 1939. */
static void add_westergaard(struct page *page)
{
    static const size_t grids[GRIDS] = {64, 256, 1024, 4096};
    static const double loads[] = {0.01, 0.05, 0.2, 0.5, 0.8, 0.95}, amplitude = 0.01, bound[] = {1, 1e-6, 5e-6, 2e-3};
    page_rows(page, "westergaard");
    for (size_t g = 0; g < GRIDS; g++) {
        size_t n = grids[g];
        double worst[4] = {0}, *height = wave_of(n, 1, amplitude);
        struct direct_contact contact = contact_of(height, n, 1);
        for (size_t k = 0; k < sizeof loads / sizeof *loads; k++) {
            double x = loads[k], p = x * M_PI * amplitude;
            struct direct_contact_load load = load_of(p, INFINITY, 1e-12);
            struct direct_quantities found = solved(&contact, &load);
            double now[4] = {(double)found.contact_points - 2 / M_PI * asin(sqrt(x)) * (double)n,
                             found.gap_m / amplitude / (1 - x + x * log(x)) - 1,
                             largest_pressure(&contact) / (2 * p / sqrt(x)) - 1,
                             constriction_of(&contact, 1e-10) / (-log(x) / (2 * M_PI)) - 1};
            for (int c = 0; c < 4; c++)
                worst[c] = fmax(worst[c], fabs(now[c]));
        }
        add_grid(page, n, worst, bound, 4, g == GRIDS - 1);
        direct_contact_free(&contact);
    }
}

/** Of P on a square lattice of period L the mean displacement is that of one P less 3.900264920 P/(pi E' L). */
static void add_hertz(struct page *page)
{
    static const double a = 0.05, p = 4.0 / 3 * a * a * a, bound[] = {2e-4, 5e-5, 3e-4};
    page_rows(page, "hertz");
    for (size_t n = 64; n <= 512; n *= 2) {
        double mean, *height = paraboloid_of(n, &mean);
        struct direct_contact contact = contact_of(height, n, n);
        struct direct_contact_load load = load_of(p, INFINITY, 1e-11);
        struct direct_quantities found = solved(&contact, &load);
        double deviation[] = {sqrt(direct_area_corrected(&found, n * n, direct_kappa) / M_PI) / a - 1,
                              largest_pressure(&contact) / (2 * a / M_PI) - 1,
                              -(found.gap_m + mean) / (a * a - 3.900264920 * p / M_PI) - 1};
        add_grid(page, n, deviation, bound, 3, n == 512);
        direct_contact_free(&contact);
    }
}

/** Twenty spots in a cell: Greenwood's sum with the periodic Green's function. */
static void add_greenwood(struct page *page)
{
    struct table known = table_read("golden/direct/greenwood.csv");
    double before = 0;
    page_rows(page, "greenwood");
    for (size_t n = 256; n <= 1024; n *= 2) {
        double now = twenty_spots_of(n) / table_number(&known, 0, "greenwood_periodic") - 1;
        add_grid(page, n, &now, NULL, 1, false);
        before = n < 1024 ? now : 2 * now - before;
    }
    text_add(&page->text, "| extrapolated |");
    page_number(page, fabs(before), 0.005);
    text_add(&page->text, "\n");
}

/** The gap at two areas, and how far apart their loads are: a Nayak parameter of 140, but the slope is not known. */
static void add_published(struct page *page)
{
    static const struct {
        const char *name;
        double published, bound;
    } rows[] = {{"gap/σ at A/A_n = 0.00086", 2.63, 0.02},
                {"gap/σ at A/A_n = 0.433", 0.128, 0.13},
                {"load of the second over that of the first", 650, 0.09}};
    struct spectrum spectrum;
    double sigma = sqrt(random_surface(&spectrum, 0.8, 8, 800, false)); /* of the whole surface */
    struct persson persson;
    struct corrected_persson_point point[2] = {{.area_ratio = 0.00086}, {.area_ratio = 0.433}};
    expect_ok(persson_make, &persson, &spectrum, 0);
    corrected_persson_curve(point, 2, &persson, true);
    const double mine[] = {point[0].separation_m / sigma, point[1].separation_m / sigma,
                           corrected_persson_load(point[1].area_ratio, persson.m2) /
                               corrected_persson_load(point[0].area_ratio, persson.m2)};
    page_rows(page, "published");
    for (int k = 0; k < 3; k++) {
        text_add(&page->text, "| %s | %g | %.3g |", rows[k].name, rows[k].published, mine[k]);
        page_number(page, fabs(mine[k] / rows[k].published - 1), rows[k].bound);
        text_add(&page->text, "\n");
    }
    persson_free(&persson);
    spectrum_free(&spectrum);
}

static double beta_of(const struct roughness *roughness, bool plastic)
{
    struct material_pair pair = material_pair(material_find("tin"), MATERIAL_COUNTERFACE_RIGID, NULL);
    struct asperities asperities;
    struct statistical model;
    const struct model_task task = {
        .asperities = &asperities, .pair = &pair, .wanted = QUANTITY_BIT(QUANTITY_SEPARATION), .tolerance = 1e-6};
    expect_ok(roughness_asperities, &asperities, roughness);
    expect_ok(statistical_make, &model, &task, plastic, INFINITY);
    double beta = model.beta;
    statistical_free(&model);
    return beta;
}

/** The Nayak parameter with which GW has this beta, which falls with it; NaN: none of 1 or more (m2² <= m0 m4). */
static double nayak_for(double beta)
{
    double low = 1, high = 1e6;
    for (int k = 0; k < 60; k++) {
        struct roughness middle = {.m0_m2 = 1, .m2 = 1, .m4_per_m2 = sqrt(low * high)};
        *(beta_of(&middle, false) > beta ? &low : &high) = middle.m4_per_m2;
    }
    return high > 1 + 1e-9 ? high : NAN;
}

enum { REMADE = 7 };

/** One of the thesis's surfaces as made again. Owned: profile_free(). */
static void read_remade(struct profile *out, int surface)
{
    char path[4096];
    struct scan scan;
    snprintf(path, sizeof path, "%s/surfaces/chapter6/surface-%d.csv", PROJECT_SOURCE, surface);
    expect_ok(scan_read, &scan, path, &(struct scan_options){0});
    expect_ok(profile_make, out, &scan, 0, &(struct profile_options){.level = LEVEL_MEAN});
    scan_free(&scan);
}

struct asperities truths_asperities(int surface)
{
    struct profile profile;
    struct asperities asperities;
    read_remade(&profile, surface);
    struct roughness roughness = roughness_of_heights(profile.height_m, profile.points, profile.spacing_m);
    expect_ok(roughness_asperities, &asperities, &roughness);
    profile_free(&profile);
    return asperities;
}

/** Its numbers by the thesis's own methods. */
static void remake(double out[REMADE], int surface)
{
    struct profile profile;
    struct spectrum spectrum;
    read_remade(&profile, surface);
    expect_ok(spectrum_compute, &spectrum, profile.height_m, profile.points, profile.spacing_m, SPECTRUM_WINDOW_NONE);
    struct power_law law = power_law_fit(&spectrum, (double[]){8e-6, 2e-3});
    struct roughness roughness = roughness_of_heights(profile.height_m, profile.points, profile.spacing_m);
    const double found[REMADE] = {roughness.rq_m * 1e6,
                                  law.alpha,
                                  law.gamma,
                                  law.misfit_decades,
                                  beta_of(&roughness, false),
                                  beta_of(&roughness, true),
                                  roughness_nayak(&roughness)};
    memcpy(out, found, sizeof found);
    spectrum_free(&spectrum);
    profile_free(&profile);
}

static void add_thesis(struct page *page)
{
    struct {
        const char *name;
        double thesis[4], bound;
    } rows[REMADE] = {{"6.2: roughness [µm]", {0.24, 0.34, 1.05, 5.82}, 1e-4},
                      {"6.2: α [m^(1−γ)]", {0.13, 0.085, 0.037, 0.006}, 1e-4},
                      {"6.2: γ", {1.6, 1.5, 1.4, 1.0}, 1e-4},
                      {"6.2: rms error of the fit [decades]", {0.3322, 0.4134, 0.4053, 0.0678}, 1e-4},
                      {"6.3: β of GW", {153.7, 5.2, 8.8, 6.8}, 0},
                      {"6.3: β of JG", {159.9, 10.02, 14.2, 12.8}, 0},
                      {"Nayak parameter for that β of GW", {0}, 0}};
    static const double table[] = {14e6, 41.369e9, 0.36, 11.5e-8};
    const struct material *tin = material_find("tin");
    const double ours[] = {tin->yield_strength_Pa, tin->youngs_modulus_Pa, tin->poisson_ratio, tin->resistivity_ohm_m};
    double remade[4][REMADE], most = 0;
    page_rows(page, "thesis");
    text_add(&page->text, "| 6.1, tin: S_y, E, ν, ρ |");
    for (int k = 0; k < 4; k++) {
        remake(remade[k], k + 1);
        rows[REMADE - 1].thesis[k] = nayak_for(rows[4].thesis[k]);
        most = fmax(most, fabs(ours[k] / table[k] - 1));
        text_add(&page->text, " %.5g / %.5g |", table[k], ours[k]);
    }
    page_number(page, most, 1e-12);
    for (size_t r = 0; r < REMADE; r++) {
        text_add(&page->text, "\n| %s |", rows[r].name);
        most = 0;
        for (int k = 0; k < 4; k++) {
            text_add(&page->text, isnan(rows[r].thesis[k]) ? " none" : " %.4g", rows[r].thesis[k]);
            text_add(&page->text, " / %.4g |", remade[k][r]);
            most = fmax(most, fabs(remade[k][r] / rows[r].thesis[k] - 1));
        }
        page_number(page, most, rows[r].bound);
    }
    text_add(&page->text, "\n");
}

void truths_add(struct page *page)
{
    add_sinusoid(page);
    add_westergaard(page);
    add_hertz(page);
    add_greenwood(page);
    shapes_add(page);
    add_published(page);
    add_thesis(page);
}

void truths_add_coverage(struct page *page)
{
    static void (*const sections[])(FILE * out, size_t sets) = {coverage_band, coverage_fit, coverage_scans,
                                                                coverage_single, coverage_pairs};
    char line[4096];
    FILE *out = tmpfile();
    coverage_must(out ? STATUS_OK : STATUS_IO, &(struct status){.message = "no temporary file"});
    for (size_t i = 0; i < sizeof sections / sizeof *sections; i++)
        sections[i](out, 100);
    page_rows(page, "coverage");
    for (rewind(out); fgets(line, sizeof line, out);)
        text_add(&page->text, "%s", line);
    fclose(out);
}
