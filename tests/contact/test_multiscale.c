/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/convergence.h"
#include "model_support.h"

enum { EVERYTHING = QUANTITY_BIT(QUANTITY_SEPARATION) | QUANTITY_RESISTANCES | QUANTITY_BIT(QUANTITY_ECR_LAST_SCALE) };

TEST_CASE(matches_reference)
{
    struct table table = table_read("golden/multiscale.csv");
    struct material_pair pair = model_support_tin();
    struct constriction spot = constriction_make(&pair);
    for (size_t i = 0; i < table.rows; i++) {
        struct spectrum spectrum =
            model_support_law(table_number(&table, i, "scan_length_m"), table_number(&table, i, "alpha_SI"),
                              table_number(&table, i, "gamma"), (size_t)table_number(&table, i, "scales"));
        double sigma = sqrt(spectrum_moment(&spectrum, 0));
        bool plastic = strcmp(table_text(&table, i, "model"), "plastic") == 0;
        struct multiscale stack = model_support_stack(&spectrum, &pair, plastic, SINUSOID_FIT_THESIS);
        struct contact_point point;
        uint64_t evaluations = 0;
        multiscale_solve(&point, &stack, &spot, EVERYTHING, table_number(&table, i, "load_over_AnEp"), &evaluations);
        assert_true(evaluations <= spectrum.count);
        model_support_matches(&point, &table, i, 1e-10);
        assert_near(point.value[QUANTITY_SEPARATION] / sigma, table_number(&table, i, "separation_over_sigma"), 1e-10);
    }
}

/** The convergence study's areas after each scale end in the area of the whole stack and never rise. */
TEST_CASE(areas_fall_to_the_total)
{
    struct material_pair pair = model_support_tin();
    struct constriction spot = constriction_make(&pair);
    struct spectrum spectrum = model_support_law(3e-4, 0.085, 0.5, 400);
    struct multiscale stack = model_support_stack(&spectrum, &pair, true, SINUSOID_FIT_THESIS);
    double area[400];
    uint64_t evaluations = 0;
    struct convergence_law law = {0.085, 0.5, 3e-4, 1e-3, 400};
    convergence_areas(area, &law, &pair, true, &evaluations);
    struct contact_point point;
    multiscale_solve(&point, &stack, &spot, 0, 1e-3, &evaluations);
    assert_near(area[399], point.value[QUANTITY_AREA], 1e-12);
    assert_true(area[0] <= 1);
    for (int i = 1; i < 400; i++)
        assert_true(area[i] <= area[i - 1]);
    assert_true(isnan(point.value[QUANTITY_SEPARATION]) && isnan(point.value[QUANTITY_ECR]) &&
                isnan(point.value[QUANTITY_TCR]));
}

/** What a walk through all scales gives, with nothing left out; `open` is how many of them are not closed. */
static size_t walk(struct contact_point *out, size_t *open, const struct sinusoid_scale *scales, size_t count,
                   const struct sinusoid_fit *closure, const struct material_pair *pair, double load)
{
    const struct constriction spot = constriction_make(pair);
    struct constriction_sum sum = {0};
    double area = 1, separation_m = 0, last = 0; /* resistance of the finest scale alone */
    size_t limited = 0;
    *open = 0;
    for (size_t i = 0; i < count; i++) {
        struct sinusoid_cell cell;
        sinusoid_press(&cell, &scales[i], closure, load * pair->effective_modulus_Pa / area, true);
        limited += cell.limited;
        separation_m += scales[i].amplitude_m * cell.gap_ratio;
        if (cell.area_complement > 0) {
            struct constriction_sum one = {0};
            constriction_add_scale(&sum, cell.area_ratio, cell.area_complement, scales[i].frequency_per_m, area);
            constriction_add_scale(&one, cell.area_ratio, cell.area_complement, scales[i].frequency_per_m, area);
            last = constriction_electrical(&spot, &one);
        }
        area *= cell.area_ratio;
        *open += cell.area_complement > 0 || cell.gap_ratio > 0;
    }
    *out = quantity_nothing();
    out->value[QUANTITY_LOAD] = load;
    out->value[QUANTITY_AREA] = area;
    out->value[QUANTITY_SEPARATION] = separation_m;
    out->value[QUANTITY_ECR] = constriction_electrical(&spot, &sum);
    out->value[QUANTITY_ECR_LAST_SCALE] = last;
    out->value[QUANTITY_TCR] = constriction_thermal(&spot, &sum);
    out->value[QUANTITY_TCR_SCALE_DEPENDENT] = constriction_thermal_scale_dependent(&spot, &sum);
    return limited;
}

/** A law with scatter, some harmonics missing; flat, steep, and of one slope; up to a thousand times too rough. */
static struct spectrum random_spectrum(uint64_t *state)
{
    static const size_t counts[] = {1, 2, 16, 17, 100, 777};
    double gamma = support_uniform(state) < 0.2 ? 1 : 0.2 + 2.8 * support_uniform(state),
           scatter = support_uniform(state) < 0.3 ? 0 : 1.2;
    struct spectrum out = model_support_law(3e-4, 1, gamma, counts[(size_t)(6 * support_uniform(state))]);
    double slope = pow(10, -4 + 5 * support_uniform(state)) * 3e-4 / out.amplitude_m[0];
    for (size_t i = 0; i < out.count; i++)
        out.amplitude_m[i] *= support_uniform(state) < 0.02 ? 0 : slope * exp(scatter * (support_uniform(state) - 0.5));
    return out;
}

/** The same bytes as of all scales, and the same loads of full contact, though only the scales that are open are
 * visited. */
TEST_CASE(passes_over_closed_scales)
{
    enum { STACKS = 400, TRIED = 24 };
    uint64_t random = 12, visits = 0, all = 0, opens = 0;
    for (int k = 0; k < STACKS; k++) {
        struct material_pair pair = material_pair(material_find(k % 3 ? "tin" : "copper"), 0, NULL);
        bool plastic = k % 4 > 0;
        enum sinusoid_fit_id closure = k % 5 == 0 ? SINUSOID_FIT_NUMERIC : SINUSOID_FIT_THESIS;
        struct spectrum spectrum = random_spectrum(&random);
        struct sinusoid_scale *scales = support_room(spectrum.count * sizeof *scales);
        struct constriction spot = constriction_make(&pair);
        double full_Pa = 0, closed_Pa = 0, loads[TRIED];
        uint64_t own = 0;
        for (size_t i = 0; i < spectrum.count; i++) {
            scales[i] = sinusoid_scale(spectrum.amplitude_m[i], spectrum_frequency(&spectrum, i), &pair, plastic);
            full_Pa = fmax(full_Pa, sinusoid_full_area_pressure(&scales[i]));
            closed_Pa = fmax(closed_Pa, sinusoid_closed_pressure(&scales[i]));
        }
        struct multiscale stack = model_support_stack(&spectrum, &pair, plastic, closure);
        assert_near(stack.full_load, full_Pa / pair.effective_modulus_Pa, 4e-16);
        assert_near(stack.closed_load, closed_Pa / pair.effective_modulus_Pa, 4e-16);
        assert_true(stack.full_load * pair.effective_modulus_Pa >= full_Pa);
        for (int i = 0; i < TRIED; i++) {
            struct contact_point point, expected;
            uint64_t visited = 0;
            size_t open;
            loads[i] = i == 0 ? stack.full_load : stack.closed_load * pow(10, 1 - 0.4 * i);
            size_t limited = multiscale_solve(&point, &stack, &spot, EVERYTHING, loads[i], &visited);
            assert_int_equal(limited,
                             walk(&expected, &open, scales, spectrum.count, &sinusoid_fits[closure], &pair, loads[i]));
            assert_memory_equal(&point, &expected, sizeof point);
            assert_true(visited >= open && visited <= spectrum.count);
            own += visited;
            opens += open;
        }
        visits += own;
        all += TRIED * spectrum.count;
    }
    assert_true((double)visits < 0.6 * (double)all && (double)visits < 1.3 * (double)opens);
}

/** Where scales just yield, less steep ones can stay open longer: those are not passed over. */
TEST_CASE(scales_that_just_yield)
{
    enum { SCALES = 300, STACKS = 40, TRIED = 200 };
    struct material_pair pair = model_support_tin();
    struct constriction spot = constriction_make(&pair);
    uint64_t random = 5;
    pair.poisson_ratio = 0.49;
    pair.yield_coefficient = 1.295 * exp(0.736 * pair.poisson_ratio);
    const double ordered_Pa = sinusoid_ordered_pressure(&pair);
    for (int k = 0; k < STACKS; k++) {
        struct spectrum spectrum = model_support_law(3e-4, 1, 1, SCALES);
        struct sinusoid_scale scales[SCALES];
        for (size_t i = 0; i < SCALES; i++) {
            double frequency = spectrum_frequency(&spectrum, i);
            spectrum.amplitude_m[i] = ordered_Pa * (0.995 + 0.01 * support_uniform(&random)) /
                                      sinusoid_full_pressure(1, frequency, pair.effective_modulus_Pa);
            scales[i] = sinusoid_scale(spectrum.amplitude_m[i], frequency, &pair, true);
        }
        struct multiscale stack = model_support_stack(&spectrum, &pair, true, SINUSOID_FIT_THESIS);
        for (int t = 0; t < TRIED; t++) {
            struct contact_point point, expected;
            uint64_t visited = 0;
            size_t open;
            double load = ordered_Pa / pair.effective_modulus_Pa * (0.99 + 0.012 * t / TRIED);
            multiscale_solve(&point, &stack, &spot, EVERYTHING, load, &visited);
            walk(&expected, &open, scales, SCALES, &sinusoid_fits[SINUSOID_FIT_THESIS], &pair, load);
            assert_memory_equal(&point, &expected, sizeof point);
            assert_true(visited >= open);
        }
    }
}

/** On a steep law a load far below full contact is done with after a few scales, whatever their number. */
TEST_CASE(visits_do_not_grow_with_the_scales)
{
    struct material_pair pair = model_support_tin();
    uint64_t visits[2][2];
    for (int plastic = 0; plastic < 2; plastic++)
        for (int longer = 0; longer < 2; longer++) {
            struct spectrum spectrum = model_support_law(3e-4, 0.085, 1.5, longer ? 40000 : 4000);
            struct multiscale stack = model_support_stack(&spectrum, &pair, plastic, SINUSOID_FIT_THESIS);
            struct constriction none = {0};
            struct contact_point point;
            visits[plastic][longer] = 0;
            multiscale_solve(&point, &stack, &none, 0, 1e-3, &visits[plastic][longer]);
            multiscale_solve(&point, &stack, &none, 0, stack.full_load, &visits[plastic][longer]);
        }
    for (int plastic = 0; plastic < 2; plastic++) {
        assert_int_equal(visits[plastic][0], visits[plastic][1]);
        assert_true(visits[plastic][0] > 2 && visits[plastic][0] < 400);
    }
}

/** Is scale k complete at the load? From all scales before it. */
static bool is_complete(const struct sinusoid_scale *scales, size_t k, const struct sinusoid_fit *closure,
                        const struct material_pair *pair, double load)
{
    struct sinusoid_cell cell = {0};
    double area = 1;
    for (size_t i = 0; i <= k; i++) {
        sinusoid_press(&cell, &scales[i], closure, load * pair->effective_modulus_Pa / area, false);
        area *= cell.area_ratio;
    }
    return !(cell.area_complement > 0);
}

/** The longest scale that closes between two loads, against every scale in turn. */
TEST_CASE(the_longest_closing_scale)
{
    enum { STACKS = 600 };
    uint64_t random = 77;
    size_t closing = 0, shorter = 0;
    for (int k = 0; k < STACKS; k++) {
        struct material_pair pair = material_pair(material_find(k % 3 ? "tin" : "copper"), 0, NULL);
        bool plastic = k % 4 > 0;
        enum sinusoid_fit_id closure = k % 5 == 0 ? SINUSOID_FIT_NUMERIC : SINUSOID_FIT_THESIS;
        const struct sinusoid_fit *fit = &sinusoid_fits[closure];
        struct spectrum spectrum = random_spectrum(&random);
        struct sinusoid_scale *scales = support_room(spectrum.count * sizeof *scales);
        struct model_kink kink;
        for (size_t i = 0; i < spectrum.count; i++)
            scales[i] = sinusoid_scale(spectrum.amplitude_m[i], spectrum_frequency(&spectrum, i), &pair, plastic);
        struct multiscale stack = model_support_stack(&spectrum, &pair, plastic, closure);
        double low = stack.closed_load * pow(10, -3 * support_uniform(&random)),
               high = low * (1 + support_uniform(&random));
        size_t longest = 0;
        while (longest < spectrum.count &&
               (is_complete(scales, longest, fit, &pair, low) || !is_complete(scales, longest, fit, &pair, high)))
            longest++;
        assert_int_equal(multiscale_closing(&kink, &stack, low, high), longest < spectrum.count);
        if (longest < spectrum.count) {
            assert_near(kink.wavelength_m, 1 / spectrum_frequency(&spectrum, longest), 1e-12);
            assert_true(kink.load > low && kink.load <= high);
            assert_true(is_complete(scales, longest, fit, &pair, kink.load));
            bool open = false; /* just below; the yield of a longer scale may close and open it more than once */
            for (int i = 1; i <= 11; i++)
                open = open || !is_complete(scales, longest, fit, &pair, kink.load * (1 - i * 1e-5));
            assert_true(open);
            closing++;
            shorter += longest > 20;
        }
    }
    assert_in_range(closing, STACKS / 10, STACKS * 9 / 10);
    assert_true(shorter > 5);
}
