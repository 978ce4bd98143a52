/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The error of each model on surfaces of any heights. Everything the program says of a model's error reads this table.
 */
#include "contact/model.h"

#include <math.h>

extern const struct model_row model_multiscale_elastic, model_multiscale_plastic, model_gw, model_jg,
    model_corrected_persson, model_corrected_persson_plastic, model_strip, model_strip_plastic, model_cmy;

/* Standard deviations of ln(model/direct solution) of area, gap and resistance; elastic models against elastic
 * contact, those with a hardness against contact that yields. From five scans of four longest waves on surfaces of
 * eight height distributions ("other heights" in docs/validation.md; a test compares). Strips: from 18 measured maps,
 * where their errors are larger. Strips with two directions (12 scans each): from 11 pieces of five other maps, .26 .39
 * .37; synthetic maps of Peklenik's ratio 1, 3 and 10 give .18 .20 .28, .19 .24 .30 and .22 .29 .35 (four scans each).
 * With a hardness, a second direction improves the synthetic gap from .42 .49 .38 to .33 .44 .39 and resistance from
 * .43 .52 .44 to .40 .47 .43, but nothing on the pieces: half of that gain is taken. A direct solution has its grid's
 * error alone and no row. */
const struct model_error model_errors[] = {
    {&model_multiscale_elastic, false, {0.92, 2.57, 1.52}},
    {&model_multiscale_plastic, false, {0.54, 2.50, 1.36}},
    {&model_gw, false, {0.94, 1.85, 0.87}},
    {&model_jg, false, {0.46, 0.84, 1.13}},
    {&model_corrected_persson, false, {0.81, 0.53, 0.83}},
    {&model_corrected_persson_plastic, false, {0.50, 0.60, 0.68}},
    {&model_strip, false, {0.37, 0.48, 0.54}},
    {&model_strip, true, {0.28, 0.38, 0.42}},
    {&model_strip_plastic, false, {0.11, 0.47, 0.50}},
    {&model_strip_plastic, true, {0.11, 0.45, 0.47}},
    {&model_cmy, false, {0.61, 0.56, 0.87}},
};
const size_t model_error_count = sizeof model_errors / sizeof *model_errors;

double model_sd(const struct model_row *row, enum quantity quantity, bool two_directions)
{
    const enum quantity_follows follows = quantity_rows[quantity].follows;
    double sd = 0;
    for (size_t i = 0; i < model_error_count; i++)
        if (model_errors[i].model == row && follows != FOLLOWS_NOTHING &&
            model_errors[i].two_directions <= two_directions)
            sd = model_errors[i].ln_sd[follows - 1]; /* the row of two directions comes second */
    return sd;
}

double model_few_waves_sd(double longest_waves)
{
    static const double waves = 2.5, sd = 1.3;
    return longest_waves > 0 && longest_waves < waves ? sd * log(waves / longest_waves) : 0;
}

double model_surface_sd(const struct model_row *row, enum quantity quantity, struct scans_reach reach)
{
    double own = model_sd(row, quantity, reach.two_directions);
    return own > 0 ? hypot(own, model_few_waves_sd(reach.longest_waves)) : own;
}

double model_factor(double ln_sd)
{
    return exp(1.96 * ln_sd);
}
