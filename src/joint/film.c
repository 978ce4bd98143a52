/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "joint/film.h"

double film_resistance(double contact_ohm_m2, double film_ohm_m2, double area_ratio)
{
    return contact_ohm_m2 + film_ohm_m2 / area_ratio;
}
