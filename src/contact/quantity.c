/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/quantity.h"

#include <math.h>

#define ON_SPOTS (EFFECT_BIT(EFFECT_FILM) | EFFECT_BIT(EFFECT_PLATING) | EFFECT_BIT(EFFECT_HEATING))
#define SPOTS    (QUANTITY_BIT(QUANTITY_AREA) | QUANTITY_BIT(QUANTITY_ECR))

/* In the order of enum quantity. */
const struct quantity_row quantity_rows[] = {
    {"load_over_AnEp", "load_over_AnEp", NULL, "P/(Aₙ E′)", "load", "", 0, 0, true},
    {"area_ratio", "area_ratio", NULL, "A/Aₙ", "area", "", 0, 0, true},
    {"separation_m", "separation_m", "separation_over_sigma", "separation/σ", "separation", "σ",
     EFFECT_BIT(EFFECT_SEPARATION), 0, false},
    {"adjusted_separation_m", NULL, "adjusted_separation_over_sigma", "adjusted", "separation", "σ",
     EFFECT_BIT(EFFECT_SEPARATION), 0, false},
    {"ecr_ohm_m2", "ecr_ohm_m2", NULL, "ECR·Aₙ", "ECR", "Ω·m²", EFFECT_BIT(EFFECT_ELECTRICAL), 0, true},
    {"tcr_K_m2_per_W", "tcr_K_m2_per_W", NULL, "TCR·Aₙ", "TCR", "K·m²/W", EFFECT_BIT(EFFECT_THERMAL), 0, true},
    {"tcr_sd_K_m2_per_W", "tcr_sd_K_m2_per_W", NULL, "TCR·Aₙ, scale-dependent", "TCR", "K·m²/W",
     EFFECT_BIT(EFFECT_SCALE_DEPENDENT), 0, true},
    {"ecr_last_scale_ohm_m2", "ecr_last_scale_ohm_m2", NULL, "ECR·Aₙ, last scale", "ECR", "Ω·m²",
     EFFECT_BIT(EFFECT_LAST_SCALE), 0, true},
    {"stiffness_Pa_per_m", "stiffness_Pa_per_m", NULL, "k/Aₙ", "stiffness", "Pa/m", EFFECT_BIT(EFFECT_STIFFNESS), 0,
     true},
    {"gap_W_per_m2K", "gap_W_per_m2K", NULL, "h_g", "h_g", "W/(m²·K)", EFFECT_BIT(EFFECT_GAP),
     QUANTITY_BIT(QUANTITY_SEPARATION), true},
    {"joint_W_per_m2K", "joint_W_per_m2K", NULL, "h_j", "h_j", "W/(m²·K)", EFFECT_BIT(EFFECT_GAP),
     QUANTITY_BIT(QUANTITY_SEPARATION) | QUANTITY_BIT(QUANTITY_TCR), true},
    {"spots_per_m2", "spots_per_m2", NULL, "n", "n", "1/m²", ON_SPOTS, SPOTS, true},
    {"spot_radius_m", "spot_radius_m", NULL, "a", "a", "m", ON_SPOTS, SPOTS, true},
    {"plating_factor", "plating_factor", NULL, "plating factor", "plating factor", "", EFFECT_BIT(EFFECT_PLATING),
     SPOTS, true},
    {"joint_ecr_ohm_m2", "joint_ecr_ohm_m2", NULL, "ECR·Aₙ with film and plating", "joint ECR", "Ω·m²",
     EFFECT_BIT(EFFECT_FILM) | EFFECT_BIT(EFFECT_PLATING), SPOTS, true},
    {"contact_voltage_V", "contact_voltage_V", NULL, "V", "V", "V", EFFECT_BIT(EFFECT_HEATING), SPOTS, true},
    {"contact_temperature_K", "contact_temperature_K", NULL, "T_max", "T_max", "K", EFFECT_BIT(EFFECT_HEATING), SPOTS,
     true},
};
_Static_assert(sizeof quantity_rows / sizeof *quantity_rows == QUANTITY_COUNT, "a quantity has its row");

double quantity_shown(const struct contact_point *point, enum quantity quantity, double sigma_m)
{
    double value = point->value[quantity];
    return quantity_rows[quantity].sigma_column ? value / sigma_m : value;
}

const char *quantity_shown_name(enum quantity quantity)
{
    const struct quantity_row *row = &quantity_rows[quantity];
    return row->sigma_column ? row->sigma_column : row->name;
}

unsigned quantity_wanted(unsigned effects)
{
    unsigned wanted = 0;
    for (int q = 0; q < QUANTITY_COUNT; q++)
        if (quantity_rows[q].effect == 0 || (effects & quantity_rows[q].effect))
            wanted |= QUANTITY_BIT(q);
    return wanted;
}

unsigned quantity_with_made(unsigned computed)
{
    unsigned all = computed;
    for (int q = 0; q < QUANTITY_COUNT; q++)
        if (quantity_rows[q].from && (computed & quantity_rows[q].from) == quantity_rows[q].from)
            all |= QUANTITY_BIT(q);
    return all;
}

struct contact_point quantity_nothing(void)
{
    struct contact_point point = {.beyond_fit = 0};
    for (int q = 0; q < QUANTITY_COUNT; q++)
        point.value[q] = NAN;
    return point;
}
