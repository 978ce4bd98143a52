/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results/limits_of_answer.h"

#include "analysis/direct_study.h"
#include <math.h>

const double limit_of_answer_tolerance = 0.05;

static const struct curve_summary *leading_of(const struct results *results, const struct comparison *comparison,
                                              size_t surface)
{
    return surface_model(&results->surfaces[surface].summary, comparison->leading);
}

/** Is there a direct solution of the surface that the leading model can be held against: a plastic one against one with
 * a hardness? NULL: none. */
static const struct direct_study *direct_of(const struct results *results, const struct comparison *comparison,
                                            size_t surface)
{
    for (size_t k = 0; k < results->direct_count; k++) {
        const struct direct_study *study = &results->direct[k];
        bool capped = direct_study_kind_of(study, comparison->leading) == DIRECT_STUDY_CAPPED;
        if (study->surface == surface && capped == model_rows[comparison->leading]->plastic)
            return study;
    }
    return NULL;
}

/** Mean distance from the direct solution: exp of the mean |ln ratio| over its loads. */
static double against_direct(const struct results *results, const struct comparison *comparison, enum quantity quantity,
                             size_t surface)
{
    const struct direct_study *study = direct_of(results, comparison, surface);
    if (!study)
        return NAN;
    struct direct_study_distance distance =
        direct_study_distance(study, results_pair(results, surface), comparison->leading, quantity);
    return distance.loads > 0 ? distance.mean_factor : NAN;
}

/** The valid model of the same material law that is farthest from the leading one; where a direct solution says more,
 * that counts instead. */
static double other_models(const struct results *results, const struct comparison *comparison, enum quantity quantity,
                           size_t surface)
{
    const struct surface_summary *summary = &results->surfaces[surface].summary;
    const struct contact_point leading = comparison_middle(results, comparison->leading, surface);
    double own = leading.value[quantity], factor = NAN;
    if (isfinite(against_direct(results, comparison, quantity, surface)))
        return NAN;
    for (size_t m = 0; m < model_count; m++) {
        const struct contact_point point = comparison_middle(results, m, surface);
        double ratio = point.value[quantity] / own;
        if (m == comparison->leading || model_rows[m]->plastic != model_rows[comparison->leading]->plastic ||
            !(ratio > 0) || !isfinite(ratio) ||
            !curve_summary_is_valid(surface_model(summary, m), point.value[QUANTITY_LOAD]))
            continue;
        if (!(fabs(log(ratio)) <= fabs(log(factor)))) /* the first: of NaN */
            factor = ratio;
    }
    return factor;
}

/** Half of the 95 % interval of the surface's mean. */
static double scatter(const struct results *results, const struct comparison *comparison, enum quantity quantity,
                      size_t surface)
{
    const struct estimate *estimate = curve_summary_estimate(leading_of(results, comparison, surface), (int)quantity);
    return estimate_has_width(estimate, estimate->half_width) ? exp(estimate->half_width) : NAN;
}

/** As in sensitivity.csv; resistances are proportional. */
static double sensitivity(const struct results *results, const struct comparison *comparison, enum quantity quantity,
                          size_t surface, enum sensitivity_change change)
{
    const struct sensitivity_factors *factors = &leading_of(results, comparison, surface)->sensitivity;
    if (sensitivity_changes[change].plastic && !model_rows[comparison->leading]->plastic)
        return NAN;
    return quantity == QUANTITY_AREA ? factors->area[change] : factors->ecr[change];
}

static double scan_halved(const struct results *results, const struct comparison *comparison, enum quantity quantity,
                          size_t surface)
{
    return sensitivity(results, comparison, quantity, surface, SENSITIVITY_SCAN_HALVED);
}

static double cutoff_doubled(const struct results *results, const struct comparison *comparison, enum quantity quantity,
                             size_t surface)
{
    return sensitivity(results, comparison, quantity, surface, SENSITIVITY_CUTOFF_DOUBLED);
}

static double harder(const struct results *results, const struct comparison *comparison, enum quantity quantity,
                     size_t surface)
{
    return sensitivity(results, comparison, quantity, surface, SENSITIVITY_HARDNESS_RAISED);
}

/** A resistance is proportional to what it is made of. */
static double property(const struct results *results, const struct comparison *comparison, enum quantity quantity,
                       enum quantity of, size_t surface)
{
    const struct contact_point leading = comparison_middle(results, comparison->leading, surface);
    bool has_one = quantity == of && leading.value[of] > 0;
    return has_one ? 1 + limit_of_answer_tolerance : NAN;
}

static double resistivity(const struct results *results, const struct comparison *comparison, enum quantity quantity,
                          size_t surface)
{
    return property(results, comparison, quantity, QUANTITY_ECR, surface);
}

static double conductivity(const struct results *results, const struct comparison *comparison, enum quantity quantity,
                           size_t surface)
{
    return property(results, comparison, quantity, QUANTITY_TCR, surface);
}

static const struct limit_of_answer_row rows[] = {
    {"model", "against the direct solution, mean of its loads", "the resistance itself, at one load", true,
     against_direct},
    {"choice of model", "the farthest valid one of the same material law", "nothing; let a direct solution run", false,
     other_models},
    {"place of the scans", "95 % of the mean, for scans of this length", "more scans, at other places", true, scatter},
    {"scan length", "halved", "a longer scan", false, scan_halved},
    {"bandwidth", "cut-off doubled", "at a finer spacing, with a sharper tip", false, cutoff_doubled},
    {"hardness", "raised by 10 %", "the hardness of the part", false, harder},
    {"resistivity", "off by 5 %", "the resistivity of the part", true, resistivity},
    {"conductivity", "off by 5 %", "the conductivity of the part", true, conductivity},
};
_Static_assert(sizeof rows / sizeof *rows <= LIMITS_OF_ANSWER_MOST, "room for all");

/** Of all usable surfaces; false: none has a number. */
static bool farthest(struct limit_of_answer *out, const struct limit_of_answer_row *row, const struct results *results,
                     const struct comparison *comparison)
{
    enum quantity quantity = results_criterion(results);
    size_t count = 0;
    for (size_t i = 0; i < results->surface_count; i++) {
        double factor = results->surfaces[i].summary.usable ? row->factor(results, comparison, quantity, i) : NAN;
        if (!(factor > 0) || !isfinite(factor))
            continue;
        if (count == 0)
            *out = (struct limit_of_answer){row, factor, i, row->next, true};
        out->alike = out->alike && fabs(factor / out->factor - 1) < 1e-9;
        if (fabs(log(factor)) > fabs(log(out->factor))) {
            out->factor = factor;
            out->surface = i;
        }
        count++;
    }
    return count > 0;
}

/** A direct solution that has run is not asked for: on this surface no more, on others alone. */
static const char *next_of(const struct limit_of_answer *doubt, const struct results *results)
{
    if (doubt->row->factor != other_models || results->direct_count == 0)
        return doubt->row->next;
    for (size_t k = 0; k < results->direct_count; k++)
        if (results->direct[k].surface == doubt->surface)
            return "nothing";
    return "nothing; solve all directly (`direct: {surfaces: all}`)";
}

size_t limits_of_answer(struct limit_of_answer out[LIMITS_OF_ANSWER_MOST], const struct results *results, const struct comparison *comparison)
{
    size_t count = 0;
    for (size_t r = 0; r < sizeof rows / sizeof *rows; r++) {
        struct limit_of_answer doubt;
        if (!farthest(&doubt, &rows[r], results, comparison))
            continue;
        doubt.next = next_of(&doubt, results);
        size_t at = count++;
        for (; at > 0 && fabs(log(doubt.factor)) > fabs(log(out[at - 1].factor)); at--)
            out[at] = out[at - 1];
        out[at] = doubt;
    }
    return count;
}
