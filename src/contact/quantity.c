/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/quantity.h"

#include "base/unit.h"
#include "direct/direct_quantities.h"

#include <math.h>
#include <string.h>

#define ON_SPOTS  (EFFECT_BIT(EFFECT_FILM) | EFFECT_BIT(EFFECT_PLATING) | EFFECT_BIT(EFFECT_HEATING))
#define SPOTS     (QUANTITY_BIT(QUANTITY_AREA) | QUANTITY_BIT(QUANTITY_ECR))
#define RESISTING UNIT_RESISTANCE, UNIT_RESISTANCE_AREA, 1e-30, 1e30

/* What the mean constriction length l of a direct solution is multiplied by. */

static double electrical(const struct material_pair *pair, double constriction_m)
{
    (void)constriction_m;
    return 2 * pair->resistivity_ohm_m; /* rho1 + rho2 */
}

static double thermal(const struct material_pair *pair, double constriction_m)
{
    (void)constriction_m;
    return 2 / pair->conductivity_W_per_mK; /* 1/k1 + 1/k2 */
}

/** Over the length; Barber. */
static double stiff(const struct material_pair *pair, double constriction_m)
{
    return constriction_m > 0 ? pair->effective_modulus_Pa / 2 / (constriction_m * constriction_m) : NAN;
}

static double separation(const double value[QUANTITY_COUNT], const struct material_pair *pair)
{
    (void)pair;
    return value[QUANTITY_SEPARATION];
}

/* Each begins with name, symbol, SI unit, effect, what it is made of, what it is. */
const struct quantity_row quantity_rows[] = {
    [QUANTITY_LOAD] = {"load_over_AnEp", "load", "", .at_full = NAN},
    [QUANTITY_AREA] = {"area_ratio", "area", "", 0, 0, QUANTITY_RISES | QUANTITY_BANDED, .precedence = 1, .at_full = 1,
                       .shown = {"%", 100}, .handy = {"%", 100},
                       .asked = {{"area", "A/Aₙ", 0, UNIT_NUMBER | UNIT_PERCENT, 1e-12, 1}},
                       .panels = {{"area", QUANTITY_LOAD, 5, 11}}, .solved = {"area_ratio", "area", DIRECT_AREA},
                       .follows = FOLLOWS_AREA},
    [QUANTITY_SEPARATION] = {"separation_m", "separation", "m", EFFECT_BIT(EFFECT_SEPARATION), 0,
                             QUANTITY_LINEAR | QUANTITY_BANDED, .sigma_column = "separation_over_sigma",
                             .shown = {"σ", 1}, .handy = {"σ", 1},
                             .panels = {{"separation-area", QUANTITY_AREA, 6, 19},
                                        {"separation-load", QUANTITY_LOAD, 7, 15}},
                             .solved = {"gap_m", "gap", DIRECT_GAP}, .follows = FOLLOWS_GAP},
    [QUANTITY_ADJUSTED] = {"adjusted_separation_m", "separation", "m", EFFECT_BIT(EFFECT_SEPARATION), 0,
                           QUANTITY_LINEAR | QUANTITY_SIGMA_ALONE, .sigma_column = "adjusted_separation_over_sigma",
                           .shown = {"σ", 1}, .note = "adjusted", .follows = FOLLOWS_GAP},
    [QUANTITY_ECR] = {"ecr_ohm_m2", "ECR", "Ω·m²", EFFECT_BIT(EFFECT_ELECTRICAL), 0, QUANTITY_ENDS | QUANTITY_BANDED,
                      .precedence = 3, .handy = {"mΩ·mm²", 1e9}, .asked = {{"ecr", "ECR", RESISTING}},
                      .panels = {{"ecr", QUANTITY_LOAD, 8, 23}}, .dotted = QUANTITY_ECR_LAST_SCALE,
                      .solved = {"ecr_ohm_m2", "ecr", DIRECT_CONSTRICTION, electrical}, .follows = FOLLOWS_RESISTANCE},
    [QUANTITY_TCR] = {"tcr_K_m2_per_W", "TCR", "K·m²/W", EFFECT_BIT(EFFECT_THERMAL), 0, QUANTITY_ENDS | QUANTITY_BANDED,
                      .precedence = 2, .handy = {"K·mm²/W", 1e6},
                      .asked = {{"tcr", "TCR", UNIT_THERMAL_RESISTANCE, UNIT_THERMAL_RESISTANCE_AREA, 1e-30, 1e30},
                                {"conductance", "h", 0, UNIT_CONDUCTANCE_AREA, 1e-30, 1e30, true}},
                      .panels = {{"tcr", QUANTITY_LOAD, 9, 27}}, .dotted = QUANTITY_TCR_SCALE_DEPENDENT,
                      .solved = {"tcr_K_m2_per_W", NULL, DIRECT_CONSTRICTION, thermal}, .follows = FOLLOWS_RESISTANCE},
    [QUANTITY_TCR_SCALE_DEPENDENT] = {"tcr_sd_K_m2_per_W", "TCR", "K·m²/W", EFFECT_BIT(EFFECT_SCALE_DEPENDENT), 0,
                                      QUANTITY_ENDS, .note = "scale_dependent", .follows = FOLLOWS_RESISTANCE},
    [QUANTITY_ECR_LAST_SCALE] = {"ecr_last_scale_ohm_m2", "ECR", "Ω·m²", EFFECT_BIT(EFFECT_LAST_SCALE), 0,
                                 QUANTITY_ENDS, .note = "last_scale", .follows = FOLLOWS_RESISTANCE},
    [QUANTITY_STIFFNESS] = {"stiffness_Pa_per_m", "stiffness", "Pa/m", EFFECT_BIT(EFFECT_STIFFNESS), 0,
                            QUANTITY_RISES | QUANTITY_ENDS, .at_full = INFINITY, .handy = {"TPa/m", 1e-12},
                            .panels = {{"stiffness"}},
                            .solved = {"stiffness_Pa_per_m", "stiffness", DIRECT_CONSTRICTION, stiff, true},
                            .follows = FOLLOWS_RESISTANCE},
    [QUANTITY_GAP] = {"gap_W_per_m2K", "h_g", "W/(m²·K)", EFFECT_BIT(EFFECT_GAP), QUANTITY_BIT(QUANTITY_SEPARATION),
                      QUANTITY_RISES | QUANTITY_BANDED, .panels = {{""}}, .follows = FOLLOWS_GAP},
    [QUANTITY_JOINT] = {"joint_W_per_m2K", "h_j", "W/(m²·K)", EFFECT_BIT(EFFECT_GAP),
                        QUANTITY_BIT(QUANTITY_SEPARATION) | QUANTITY_BIT(QUANTITY_TCR),
                        QUANTITY_RISES | QUANTITY_ENDS | QUANTITY_BANDED, .precedence = 5, .at_full = INFINITY,
                        .handy = {"W/(m²·K)", 1},
                        .asked = {{"tcr", "TCR of the joint", UNIT_THERMAL_RESISTANCE, UNIT_THERMAL_RESISTANCE_AREA,
                                   1e-30, 1e30, true},
                                  {"conductance", "h_j", 0, UNIT_CONDUCTANCE_AREA, 1e-30, 1e30}},
                        .panels = {{""}}, .follows = FOLLOWS_RESISTANCE},
    [QUANTITY_SPOT_DENSITY] = {"spots_per_m2", "n", "1/m²", ON_SPOTS, SPOTS, QUANTITY_BANDED},
    [QUANTITY_SPOT_RADIUS] = {"spot_radius_m", "a", "m", ON_SPOTS, SPOTS, QUANTITY_BANDED},
    [QUANTITY_PLATING_FACTOR] = {"plating_factor", "plating factor", "", EFFECT_BIT(EFFECT_PLATING), SPOTS,
                                 QUANTITY_BANDED},
    [QUANTITY_JOINT_ECR] = {"joint_ecr_ohm_m2", "joint ECR", "Ω·m²",
                            EFFECT_BIT(EFFECT_FILM) | EFFECT_BIT(EFFECT_PLATING), SPOTS,
                            QUANTITY_ENDS | QUANTITY_BANDED, .precedence = 4, .handy = {"mΩ·mm²", 1e9},
                            .asked = {{"ecr", "ECR", RESISTING}}, .panels = {{""}}, .follows = FOLLOWS_RESISTANCE},
    [QUANTITY_SHAPE_JOINT] = {"shape_W_per_m2K", "h with shape", "W/(m²·K)", EFFECT_BIT(EFFECT_SHAPE),
                              QUANTITY_BIT(QUANTITY_SEPARATION) | QUANTITY_BIT(QUANTITY_TCR),
                              QUANTITY_RISES | QUANTITY_ENDS | QUANTITY_BANDED, .precedence = 6,
                              .handy = {"W/(m²·K)", 1},
                              .asked = {{"tcr", "TCR with shape", UNIT_THERMAL_RESISTANCE, UNIT_THERMAL_RESISTANCE_AREA,
                                         1e-30, 1e30, true},
                                        {"conductance", "h with shape", 0, UNIT_CONDUCTANCE_AREA, 1e-30, 1e30}},
                              .panels = {{""}}, .follows = FOLLOWS_RESISTANCE},
    [QUANTITY_SHAPE_ECR] = {"shape_ecr_ohm_m2", "ECR with shape", "Ω·m²", EFFECT_BIT(EFFECT_SHAPE),
                            QUANTITY_BIT(QUANTITY_SEPARATION) | QUANTITY_BIT(QUANTITY_AREA) |
                                QUANTITY_BIT(QUANTITY_ECR),
                            QUANTITY_ENDS | QUANTITY_BANDED, .precedence = 7, .handy = {"mΩ·mm²", 1e9},
                            .asked = {{"ecr", "ECR with shape", RESISTING}}, .panels = {{""}},
                            .follows = FOLLOWS_RESISTANCE},
    [QUANTITY_VOLTAGE] = {"contact_voltage_V", "V", "V", EFFECT_BIT(EFFECT_HEATING), SPOTS, QUANTITY_BANDED,
                          .shown = {"mV", 1e3}, .follows = FOLLOWS_RESISTANCE},
    [QUANTITY_TEMPERATURE] = {"contact_temperature_K", "T_max", "K", EFFECT_BIT(EFFECT_HEATING), SPOTS,
                              .shown = {"°C", 1, 273.15},
                              .asked = {{"temperature", "T_max", 0, UNIT_TEMPERATURE, 0, 1e5}}, .panels = {{""}},
                              .follows = FOLLOWS_RESISTANCE},
    [QUANTITY_MEAN_GAP] = {"gap_m", "gap", "m", EFFECT_BIT(EFFECT_SEPARATION), QUANTITY_BIT(QUANTITY_SEPARATION),
                           QUANTITY_BANDED, .shown = {"µm", 1e6}, .handy = {"µm", 1e6},
                           .asked = {{"gap", "gap", 0, UNIT_DISTANCE, 1e-12, 1}}, .derive = separation,
                           .follows = FOLLOWS_GAP},
};
_Static_assert(sizeof quantity_rows / sizeof *quantity_rows == QUANTITY_COUNT, "a quantity has its row");

bool quantity_of_joint(enum quantity quantity)
{
    const struct quantity_row *row = &quantity_rows[quantity];
    return row->from && row->effect && !row->derive;
}

struct quantity_unit quantity_unit(enum quantity quantity)
{
    const struct quantity_row *row = &quantity_rows[quantity];
    return row->shown.scale > 0 ? row->shown : (struct quantity_unit){row->unit, 1, 0};
}

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

enum quantity quantity_first(unsigned quantities)
{
    enum quantity first = QUANTITY_LOAD;
    if (quantities & QUANTITY_BIT(QUANTITY_JOINT)) /* filled gaps carry heat alone */
        quantities &= ~QUANTITY_BIT(QUANTITY_SHAPE_ECR);
    for (int q = 0; q < QUANTITY_COUNT; q++)
        if ((quantities & QUANTITY_BIT(q)) && quantity_rows[q].precedence > quantity_rows[first].precedence)
            first = (enum quantity)q;
    return first;
}

enum quantity quantity_of_key(const struct quantity_asked **how, const char *key, unsigned called)
{
    enum quantity found = QUANTITY_COUNT;
    *how = NULL;
    for (int q = 0; q < QUANTITY_COUNT; q++)
        for (size_t k = 0; k < 2 && quantity_rows[q].asked[k].key; k++) {
            const struct quantity_row *row = &quantity_rows[q];
            bool there = !quantity_of_joint((enum quantity)q) || (row->effect & called);
            if (strcmp(row->asked[k].key, key) != 0 || (!there && found < QUANTITY_COUNT))
                continue;
            found = (enum quantity)q;
            *how = there ? &row->asked[k] : NULL;
        }
    return found;
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
