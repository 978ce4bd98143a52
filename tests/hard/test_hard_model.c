/* SPDX-License-Identifier: GPL-3.0-or-later */
/* All models as a run calls them, from no load to far beyond full contact of each. */
#include "hard_support.h"

HARD_CASES("All models as a run calls them")

enum { EVERYTHING = QUANTITY_BIT(QUANTITY_SEPARATION) | QUANTITY_RESISTANCES };
enum { LOADS = 37, SCALES = 600 };

/** Everything, of a surface whose heights are not kept. */
static struct model_task task_of(const struct spectrum *spectrum, const struct asperities *surface,
                                 const struct material_pair *pair, const double *loads, size_t count)
{
    struct model_task task = model_support_task(spectrum, pair, loads, count);
    task.asperities = surface;
    task.wanted = EVERYTHING;
    task.tolerance = 1e-10;
    return task;
}

static struct model_curve run(struct contact_point *points, size_t model, const struct model_task *task)
{
    return model_support_run(points, model_rows[model]->name, task);
}

static struct asperities asperities_of(const struct spectrum *spectrum)
{
    struct roughness roughness = {0};
    struct asperities surface;
    roughness_from_spectrum(&roughness, spectrum);
    expect_ok(roughness_asperities, &surface, &roughness);
    return surface;
}

/** A number is there where the model computes it, and may be missing only where its row says so. */
static void check_number(const struct model_row *row, const struct contact_point *point, enum quantity q)
{
    double value = point->value[q];
    bool computes = row->quantities & QUANTITY_BIT(q),
         may_lack = (row->may_be_empty | QUANTITY_BIT(QUANTITY_STIFFNESS) | QUANTITY_BIT(QUANTITY_ECR_LAST_SCALE)) &
                    QUANTITY_BIT(q);
    assert_true(computes ? isfinite(value) || (may_lack && isnan(value)) : isnan(value));
}

static void check_point(const struct model_row *row, const struct contact_point *point, double full_load)
{
    assert_true(isfinite(point->value[QUANTITY_AREA]) && point->value[QUANTITY_AREA] > 0 &&
                point->value[QUANTITY_AREA] <= 1);
    for (int q = 0; q < QUANTITY_COUNT; q++)
        if (!quantity_rows[q].from) /* what is made of them is added later */
            check_number(row, point, (enum quantity)q);
    for (int q = QUANTITY_ECR; q <= QUANTITY_TCR_SCALE_DEPENDENT; q++)
        assert_true(isnan(point->value[q]) || isnan(full_load) ||
                    ((point->value[q] > 0) == (point->value[QUANTITY_LOAD] < full_load) && point->value[q] >= 0));
    if (isgreaterequal(point->value[QUANTITY_LOAD], full_load)) /* quiet where there is none */
        assert_true(point->value[QUANTITY_AREA] == 1);
}

static void check_ends(const struct model_curve *curve, const struct model_row *row)
{
    const struct contact_point *last = &curve->points[curve->count - 1];
    if (row->largest_area > 0 &&
        isnan(curve->full_load)) { /* ends where it says no more: it knows of no full contact */
        assert_true(last->value[QUANTITY_LOAD] < 1e6);
        return;
    }
    if (isnan(curve->full_load)) { /* complete only in the limit, or not known when */
        assert_true(last->value[QUANTITY_LOAD] == 1e6);
        assert_true(last->value[QUANTITY_AREA] > 0.99);
        return;
    }
    assert_true(curve->full_load > 0 && curve->full_load < 1e6);
    check_point(row, &curve->full, curve->full_load);
    bool empty = row->may_be_empty & QUANTITY_BIT(QUANTITY_ECR);
    assert_true(last->value[QUANTITY_AREA] == 1);
    assert_same_number(last->value[QUANTITY_ECR], empty ? NAN : 0, 0);
    assert_true(last->value[QUANTITY_LOAD] == (row->sums_asperities ? curve->full_load : 1e6));
    assert_same_number(last->value[row->sums_asperities ? QUANTITY_ADJUSTED : QUANTITY_SEPARATION], empty ? NAN : 0, 0);
}

static void check_curve(const struct model_curve *curve, const struct model_row *row, const struct model_task *task)
{
    bool statistical = row->sums_asperities;
    if (row->uses_strip || row->uses_map) { /* none is given */
        assert_false(curve->exists);
        return;
    }
    assert_true(curve->exists && curve->count > 1 && curve->count <= task->load_count + 1);
    assert_true(statistical ? isfinite(curve->beta) : isnan(curve->beta));
    for (size_t i = 0; i < curve->count; i++) {
        const struct contact_point *point = &curve->points[i], *before = i > 0 ? point - 1 : point;
        check_point(row, point, curve->full_load);
        hard_case("every model, loads of 1e-30 to 1e6, γ = 0.5 to 2, both closures",
                  "a curve that turns back at its end", "areas from above 0 to 1 that never fall", "fall of the area",
                  fmax(0, before->value[QUANTITY_AREA] - point->value[QUANTITY_AREA]), 0);
        assert_true(point->value[QUANTITY_AREA] >= before->value[QUANTITY_AREA]);
        for (int q = QUANTITY_SEPARATION; q <= QUANTITY_TCR; q++)
            assert_false(q != QUANTITY_ADJUSTED && isgreater(point->value[q], before->value[q]));
        if (statistical)
            assert_true(isfinite(point->value[QUANTITY_ADJUSTED]) && point->value[QUANTITY_ADJUSTED] >= 0);
        else
            assert_true(!isless(point->value[QUANTITY_SEPARATION], 0));
    }
    check_ends(curve, row);
    assert_true(row->plastic || curve->clamped == 0);
}

/** Loads by decades from 1e-30 to 1e6, every model, rough and smooth spectra, both closures. */
TEST_CASE(loads_beyond_full_contact)
{
    static const double alphas[] = {1e-3, 0.085, 1e3}, gammas[] = {0.5, 1.5, 2};
    struct material_pair pair = model_support_tin();
    double loads[LOADS];
    model_support_loads(loads, LOADS, 1e-30, 1e6);
    for (int k = 0; k < 3; k++)
        for (int closure = 0; closure < SINUSOID_FIT_COUNT; closure++) {
            struct spectrum spectrum = model_support_law(hard_length_m, alphas[k], gammas[k], SCALES);
            struct asperities surface = asperities_of(&spectrum);
            struct model_task task = task_of(&spectrum, &surface, &pair, loads, LOADS);
            task.sinusoid_fit = (enum sinusoid_fit_id)closure;
            for (size_t m = 0; m < model_count; m++) {
                struct contact_point points[LOADS + 1];
                struct model_curve curve = run(points, m, &task);
                check_curve(&curve, model_rows[m], &task);
            }
        }
}

/** All loads beyond full contact, and a single one. */
TEST_CASE(nothing_but_full_contact)
{
    struct material_pair pair = model_support_tin();
    struct spectrum spectrum = model_support_law(hard_length_m, 0.085, 1.5, SCALES);
    struct asperities surface = asperities_of(&spectrum);
    const double loads[] = {1e3, 1e6, 1e100};
    for (size_t count = 1; count <= 3; count++)
        for (size_t m = 0; m < model_count; m++) {
            struct contact_point points[4];
            struct model_task task = task_of(&spectrum, &surface, &pair, loads, count);
            struct model_curve curve = run(points, m, &task);
            bool silent = model_rows[m]->largest_area > 0 && !model_rows[m]->sums_asperities;
            assert_int_equal(curve.count, silent ? 0 : model_rows[m]->sums_asperities ? 1 : count);
            assert_int_equal(curve.exists, !silent);
            bool empty = model_rows[m]->may_be_empty & QUANTITY_BIT(QUANTITY_ECR);
            for (size_t i = 0; i < curve.count; i++) {
                hard_case("loads of 1e3 to 1e100, beyond complete contact alone", "a curve without a point, or inf",
                          "the point of complete contact; models that end before say nothing", "area, difference",
                          fabs(points[i].value[QUANTITY_AREA] - 1), 0);
                assert_same_number(points[i].value[QUANTITY_ECR], empty ? NAN : 0, 0);
                assert_true(!isgreater(points[i].value[QUANTITY_TCR_SCALE_DEPENDENT], 0));
            }
        }
}

/** Without asperities (sigma_s² <= 0) the statistical models have no curve and the multiscale ones stay. */
TEST_CASE(no_asperities)
{
    struct material_pair pair = model_support_tin();
    struct spectrum spectrum = model_support_law(hard_length_m, 0.085, 1.5, SCALES);
    const double loads[] = {1e-9, 1e-3};
    struct model_task task = task_of(&spectrum, NULL, &pair, loads, 2);
    for (size_t m = 0; m < model_count; m++) {
        struct contact_point points[3];
        struct model_curve curve = run(points, m, &task);
        assert_true(curve.exists ==
                    !(model_rows[m]->sums_asperities || model_rows[m]->uses_strip || model_rows[m]->uses_map));
        bool ends = model_rows[m]->plastic && model_rows[m]->largest_area > 0;
        assert_int_equal(curve.count, !curve.exists ? 0 : ends ? 1 : 2);
        hard_case("no asperities (σ_s² ≤ 0)", "the square root of a negative number",
                  "statistical models have no curve, the others theirs", "integrals of what has no curve",
                  curve.exists ? 0 : (double)curve.evaluations, 0);
    }
}

/** What is not wanted is NaN, needs no property of the material and changes nothing else. */
TEST_CASE(every_choice_of_quantities)
{
    struct material_pair known = model_support_tin(), bare = known;
    bare.resistivity_ohm_m = bare.conductivity_W_per_mK = NAN;
    bare.mean_free_path_m[0] = bare.mean_free_path_m[1] = NAN;
    bare.side_conductivity_W_per_mK[0] = bare.side_conductivity_W_per_mK[1] = NAN;
    struct spectrum spectrum = model_support_law(hard_length_m, 0.085, 1.5, SCALES);
    struct asperities surface = asperities_of(&spectrum);
    const double loads[] = {1e-30, 1e-9, 1e-6, 1e-3, 1e6};
    for (size_t m = 0; m < model_count; m++)
        for (unsigned wanted = 0; wanted <= EVERYTHING; wanted++) {
            if (wanted & ~(unsigned)EVERYTHING)
                continue;
            bool conducts = wanted & (QUANTITY_RESISTANCES);
            struct contact_point all[6], some[6];
            struct model_task task = task_of(&spectrum, &surface, &known, loads, 5);
            struct model_curve reference = run(all, m, &task);
            task.wanted = wanted;
            task.pair = conducts ? &known : &bare;
            struct model_curve curve = run(some, m, &task);
            assert_int_equal(curve.count, reference.count);
            for (size_t i = 0; i < curve.count; i++) {
                hard_case("every choice of quantities, without the properties of those left out",
                          "NaN of a resistivity that is not known in an area", "what is asked for does not change",
                          "area, relative", off_by(some[i].value[QUANTITY_AREA], all[i].value[QUANTITY_AREA]), 1e-9);
                for (int q = QUANTITY_ECR; q <= QUANTITY_TCR_SCALE_DEPENDENT; q++)
                    assert_same_number(some[i].value[q], wanted & QUANTITY_BIT(q) ? all[i].value[q] : NAN, 1e-9);
                assert_true((wanted & QUANTITY_BIT(QUANTITY_SEPARATION)) || model_rows[m]->sums_asperities ||
                            isnan(some[i].value[QUANTITY_SEPARATION]));
            }
        }
}

/** Two bodies that have nothing in common: what is softer, and what conducts worse, decides. */
TEST_CASE(two_bodies_of_huge_ratio)
{
    static const double factors[] = {1e3, 1e6, 1e12, 1e100};
    for (int f = 0; f < 4; f++) {
        struct material first = *material_find("tin"), second = first;
        second.youngs_modulus_Pa *= factors[f];
        second.resistivity_ohm_m *= factors[f];
        struct material_pair pair = material_pair(&first, MATERIAL_COUNTERFACE_ELASTIC, &second);
        struct material_pair rigid = material_pair(&first, MATERIAL_COUNTERFACE_RIGID, NULL);
        hard_case("moduli of the bodies 1e3 to 1e100 apart", "the softer body's compliance is lost in the sum",
                  "E' of the softer one on a rigid one", "E', difference times the ratio of the moduli",
                  off_by(pair.effective_modulus_Pa, rigid.effective_modulus_Pa) * fmin(factors[f], 1e12), 1.001);
        hard_case("resistivities 1e3 to 1e100 apart", "the same", "the mean, half of the worse conductor's",
                  "resistivity, relative",
                  off_by(pair.resistivity_ohm_m, first.resistivity_ohm_m * (1 + factors[f]) / 2), 1e-12);
        if (factors[f] > 1e12)
            continue;
        struct spectrum spectrum = model_support_law(hard_length_m, 0.085, 1.5, 100);
        const double loads[] = {1e-9, 1e-3};
        for (size_t m = 0; m < model_count; m++) {
            struct contact_point points[2][3];
            struct model_task task = task_of(&spectrum, NULL, &pair, loads, 2);
            struct model_curve curve = run(points[0], m, &task);
            task.pair = &rigid;
            struct model_curve alone = run(points[1], m, &task);
            assert_int_equal(curve.count, alone.count);
            for (size_t i = 0; i < curve.count; i++)
                hard_case("areas of such bodies, every model", "a pressure of the wrong body",
                          "those of the softer one on a rigid one", "area, difference times the ratio of the moduli",
                          off_by(points[0][i].value[QUANTITY_AREA], points[1][i].value[QUANTITY_AREA]) *
                              fmin(factors[f], 1e9),
                          2);
        }
    }
}

/** A million loads at once: none lost, none out of order. */
TEST_CASE(a_million_loads)
{
    enum { MANY = 1000000 / HARD_COARSER };
    struct material_pair pair = model_support_tin();
    struct spectrum spectrum = model_support_law(hard_length_m, 0.085, 1.5, 12);
    double *loads = support_room(MANY * sizeof *loads);
    struct contact_point *points = support_room((MANY + 1) * sizeof *points);
    for (size_t i = 0; i < MANY; i++)
        loads[i] = 1e-9 * exp(log(1e6) * (double)i / MANY);
    struct model_task task = task_of(&spectrum, NULL, &pair, loads, MANY);
    struct model_curve curve = model_support_run(points, "multiscale-elastic", &task);
    hard_case("10^6 loads of one curve", "memory, or points that are left out", "one point for each",
              "loads without a point", (double)MANY - (double)curve.count, 0);
    double fall = 0;
    for (size_t i = 1; i < curve.count; i++)
        fall = fmax(fall, 1 - points[i].value[QUANTITY_AREA] / points[i - 1].value[QUANTITY_AREA]);
    hard_case("10^6 loads: neighbours 1e-5 apart", "rounding turns the curve back",
              "only the published step at p/p* = 0.8 does", "fall of the area, relative", fall, 5e-4);
}
