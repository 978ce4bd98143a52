/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "contact/effect.h"

const struct effect_row effect_rows[EFFECT_COUNT] = {
    [EFFECT_PLASTICITY] = {"plasticity", {"Sy_Pa"}, 0},
    [EFFECT_SEPARATION] = {"separation", {NULL}, 0, .adds = true},
    [EFFECT_ELECTRICAL] = {"electrical", {"resistivity_ohm_m"}, 0, .adds = true},
    [EFFECT_THERMAL] = {"thermal", {"conductivity_W_per_mK"}, 0, .adds = true},
    [EFFECT_SCALE_DEPENDENT] = {"scale-dependent",
                                {"conductivity_W_per_mK", "density_kg_per_m3", "specific_heat_J_per_kgK",
                                 "sound_speed_m_per_s"},
                                EFFECT_BIT(EFFECT_THERMAL),
                                .adds = true},
    [EFFECT_STIFFNESS] = {"stiffness", {NULL}, EFFECT_BIT(EFFECT_SEPARATION), .adds = true, .only_listed = true},
    [EFFECT_LAST_SCALE] =
        {"last-scale", {"resistivity_ohm_m"}, EFFECT_BIT(EFFECT_ELECTRICAL), .adds = true, .only_listed = true},
    [EFFECT_CONVERGENCE] = {"convergence", {NULL}, 0, .studies = true},
    [EFFECT_UNCERTAINTY] = {"uncertainty", {NULL}, 0, .studies = true},
    [EFFECT_DIRECT] = {"direct", {NULL}, 0, .studies = true},
    [EFFECT_GAP] = {"gap",
                    {"conductivity_W_per_mK"},
                    EFFECT_BIT(EFFECT_SEPARATION) | EFFECT_BIT(EFFECT_THERMAL),
                    "gap"},
    [EFFECT_FILM] = {"film", {"resistivity_ohm_m"}, EFFECT_BIT(EFFECT_ELECTRICAL), "film"},
    [EFFECT_PLATING] = {"plating", {"resistivity_ohm_m"}, EFFECT_BIT(EFFECT_ELECTRICAL), "plating"},
    [EFFECT_HEATING] = {"heating", {"resistivity_ohm_m"}, EFFECT_BIT(EFFECT_ELECTRICAL), "current", .adds = true},
    [EFFECT_SHAPE] = {"shape",
                      {"conductivity_W_per_mK"},
                      EFFECT_BIT(EFFECT_SEPARATION) | EFFECT_BIT(EFFECT_THERMAL),
                      "shape"},
};
