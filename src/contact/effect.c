#include "contact/effect.h"

const struct effect_row effect_rows[EFFECT_COUNT] = {
    [EFFECT_PLASTICITY] = {"plasticity",
                           "yielding: elastic-plastic multiscale and JG beside the elastic models",
                           {"Sy_Pa"},
                           0},
    [EFFECT_SEPARATION] = {"separation", "mean gap between the surfaces over load and over area", {NULL}, 0},
    [EFFECT_ELECTRICAL] = {"electrical", "electrical contact resistance over load", {"resistivity_ohm_m"}, 0},
    [EFFECT_THERMAL] = {"thermal", "thermal contact resistance over load", {"conductivity_W_per_mK"}, 0},
    [EFFECT_SCALE_DEPENDENT] = {"scale-dependent",
                                "thermal contact resistance of spots near the carriers' mean free path",
                                {"conductivity_W_per_mK", "density_kg_per_m3", "specific_heat_J_per_kgK",
                                 "sound_speed_m_per_s"},
                                EFFECT_BIT(EFFECT_THERMAL)},
    [EFFECT_CONVERGENCE] = {"convergence", "area over wavelength as finer and finer scales are added", {NULL}, 0},
    [EFFECT_UNCERTAINTY] = {"uncertainty",
                            "how far the numbers of a surface with one scan may be from those of another place on it",
                            {NULL},
                            0},
};
