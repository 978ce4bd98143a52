/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How far each model is from the contact of a surface of any heights: all that is said of a model's error comes from
 * this table. */
#include "contact/model.h"

#include <math.h>

#define ERROR(name, ...) ROW(name, false, __VA_ARGS__)
#define ROW(name, two_directions, ...)                                                                                 \
    {                                                                                                                  \
        &model_##name, two_directions,                                                                                 \
        {                                                                                                              \
            __VA_ARGS__                                                                                                \
        }                                                                                                              \
    }
#define DECLARE(name) extern const struct model_row model_##name;
DECLARE(multiscale_elastic)
DECLARE(multiscale_plastic)
DECLARE(gw)
DECLARE(jg)
DECLARE(corrected_persson)
DECLARE(corrected_persson_plastic)
DECLARE(strip)
DECLARE(strip_plastic)
DECLARE(cmy)

/* Standard deviations of ln(model/direct solution) of area, gap and resistance. Elastic models on elastic contact,
 * those with a hardness on contact that yields: of five scans of four longest waves on surfaces of eight laws of
 * heights, as docs/validation.md prints them ("other heights"; a test compares). Of strips those of 18 measured maps,
 * which are larger; of two directions, too (12 scans each): on pieces of five other maps .26 .39 .37, on synthetic ones
 * of Peklenik's ratio 1, 3 and 10, four scans each, .18 .20 .28, .19 .24 .30 and .22 .29 .35. With a hardness a second
 * direction makes .33 .44 .39 of .42 .49 .38 (gap) there, .40 .47 .43 of .43 .52 .44 (resistance), and changes
 * nothing on the pieces; about half of that is taken off. A map's own direct solution has its grid's error alone, and
 * is not in the table. */
const struct model_error model_errors[] = {
    ERROR(multiscale_elastic, 0.92, 2.57, 1.52),
    ERROR(multiscale_plastic, 0.54, 2.50, 1.36),
    ERROR(gw, 0.94, 1.85, 0.87),
    ERROR(jg, 0.46, 0.84, 1.13),
    ERROR(corrected_persson, 0.81, 0.53, 0.83),
    ERROR(corrected_persson_plastic, 0.50, 0.60, 0.68),
    ERROR(strip, 0.37, 0.48, 0.54),
    ROW(strip, true, 0.28, 0.38, 0.42),
    ERROR(strip_plastic, 0.11, 0.47, 0.50),
    ROW(strip_plastic, true, 0.11, 0.45, 0.47),
    ERROR(cmy, 0.61, 0.56, 0.87),
};
const size_t model_error_count = sizeof model_errors / sizeof *model_errors;

double model_sd(const struct model_row *row, enum quantity quantity, bool two_directions)
{
    const enum quantity_follows follows = quantity_rows[quantity].follows;
    double sd = 0;
    for (size_t i = 0; i < model_error_count; i++)
        if (model_errors[i].model == row && follows != FOLLOWS_NOTHING &&
            model_errors[i].two_directions <= two_directions)
            sd = model_errors[i].ln_sd[follows - 1]; /* that of two stands behind that of one */
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
