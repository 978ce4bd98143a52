/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "material/material.h"

#include "base/constants.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

/* Ranges leave room for every metal, solder and conductive ceramic, and catch a wrong power of ten. */
#define PROPERTY(member) offsetof(struct material, member)
const struct material_property material_properties[] = {
    {"E_Pa", "E", "E", "Pa", "Young's modulus", PROPERTY(youngs_modulus_Pa), 1e6, 1e13, UNIT_PRESSURE, false},
    {"nu", "nu", "ν", "", "Poisson's ratio", PROPERTY(poisson_ratio), 0.0, 0.5, UNIT_NUMBER, false},
    {"Sy_Pa", "Sy", "S_y", "Pa", "yield strength", PROPERTY(yield_strength_Pa), 1e3, 1e12, UNIT_PRESSURE, false},
    {"resistivity_ohm_m", "resistivity", "ρ_L", "Ω·m", "electrical resistivity", PROPERTY(resistivity_ohm_m), 1e-12,
     1e18, UNIT_RESISTIVITY, false},
    {"conductivity_W_per_mK", "conductivity", "k", "W/(m·K)", "thermal conductivity", PROPERTY(conductivity_W_per_mK),
     1e-4, 1e5, UNIT_CONDUCTIVITY, false},
    {"density_kg_per_m3", "density", "ρ", "kg/m³", "density", PROPERTY(density_kg_per_m3), 1.0, 1e5, UNIT_DENSITY,
     false},
    {"specific_heat_J_per_kgK", "specific_heat", "c_p", "J/(kg·K)", "specific heat per unit mass",
     PROPERTY(specific_heat_J_per_kgK), 1.0, 1e5, UNIT_SPECIFIC_HEAT, false},
    {"sound_speed_m_per_s", "sound_speed", "v_s", "m/s", "speed of sound", PROPERTY(sound_speed_m_per_s), 1.0, 1e5,
     UNIT_SPEED, false},
    {"hardness_Pa", "hardness", "H", "Pa", "hardness", PROPERTY(hardness_Pa), 1e3, 1e12, UNIT_PRESSURE, true},
    {"mean_free_path_m", "mean_free_path", "λ_mfp", "m", "mean free path of the heat carriers",
     PROPERTY(mean_free_path_m), 1e-12, 1e-3, UNIT_DISTANCE, true},
};
const size_t material_property_count = sizeof material_properties / sizeof *material_properties;

/* Near 20 °C. Yield strength depends on temper far more than the rest: each source names the temper. */
/* Free electrons per m³: Ashcroft and Mermin 1976, Solid State Physics, table 1.1; of alloys those of the base. */
#define COPPER_ELECTRONS 8.47e28
#define GOLD_ELECTRONS   5.90e28
const struct material material_table[] = {
    {"tin", 41.369e9, 0.36, 14e6, 11.5e-8, 66.8, 7310, 227, 2730,
     "Wilson 2008, table 6.1 (E, nu, S_y, resistivity); CRC Handbook of Chemistry and Physics (k, density, c_p, "
     "v_s along a thin rod)",
     NAN, NAN, 14.8e28, NULL},
    {"copper", 117e9, 0.34, 250e6, 1.72e-8, 391, 8940, 385, 4760,
     "ETP copper C11000, half hard (H02): ASM Handbook vol. 2; longitudinal v_s, annealed: CRC Handbook of Chemistry "
     "and Physics",
     NAN, NAN, COPPER_ELECTRONS, NULL},
    {"brass", 110e9, 0.35, 300e6, 6.45e-8, 120, 8440, 377, 4700,
     "CuZn37 (CW508L, C27200), hard (R410): S_y minimum of EN 1652, others ASM Handbook vol. 2; longitudinal v_s of "
     "70/30 brass: CRC Handbook of Chemistry and Physics",
     NAN, NAN, COPPER_ELECTRONS, "CuZn37"},
    {"bronze", 110e9, 0.34, 434e6, 12.2e-8, 66, 8840, 377, 4380,
     "phosphor bronze CuSn6 (CW452K, C51900), half hard (H02): ASM Handbook vol. 2; longitudinal v_s computed from E, "
     "nu and density",
     NAN, NAN, COPPER_ELECTRONS, "CuSn6"},
    {"gold", 78e9, 0.44, 205e6, 2.214e-8, 318, 19300, 129, 3240,
     "bulk gold for soft plating; S_y cold worked 60 %, near a third of a soft plate's hardness: ASM Handbook vol. 2; "
     "resistivity, k, density, c_p, longitudinal v_s: CRC Handbook of Chemistry and Physics",
     NAN, NAN, GOLD_ELECTRONS, NULL},
    {"silver", 83e9, 0.37, 54e6, 1.587e-8, 429, 10490, 235, 3650,
     "fine silver, bulk, annealed (plated silver is harder): E, nu, S_y ASM Handbook vol. 2; others, longitudinal v_s: "
     "CRC Handbook of Chemistry and Physics",
     NAN, NAN, 5.86e28, NULL},
    {"nickel", 207e9, 0.31, 59e6, 6.93e-8, 90.7, 8900, 444, 6040,
     "pure nickel, bulk, annealed (plated nickel is far harder): E, nu, S_y ASM Handbook vol. 2; others, longitudinal "
     "v_s: CRC Handbook of Chemistry and Physics",
     NAN, NAN, 0, NULL},
    {"aluminium", 68.9e9, 0.33, 276e6, 3.99e-8, 167, 2700, 896, 6420,
     "alloy 6061-T6 (solution treated, aged): ASM Handbook vol. 2; longitudinal v_s of rolled aluminium: CRC Handbook "
     "of Chemistry and Physics",
     NAN, NAN, 18.1e28, "aluminum,Al,Al6061"},
    {"steel", 193e9, 0.29, 215e6, 7.2e-7, 16.2, 8000, 500, 5790,
     "stainless steel AISI 304, annealed: ASM Handbook vol. 1; longitudinal v_s of AISI 347: CRC Handbook of Chemistry "
     "and Physics",
     NAN, NAN, 0, "stainless,304"},
    {"carbon-steel", 200e9, 0.29, 350e6, 1.59e-7, 51.9, 7870, 486, 5770,
     "AISI 1020, cold drawn: E, nu, resistivity, c_p matmake.com, in whose range of 240 to 380 MPa S_y is; k, density: "
     "theworldmaterial.com; longitudinal v_s computed from E, nu and density",
     NAN, NAN, 0, "carbon steel"},
    {"hard-gold", 78e9, 0.44, 587e6, NAN, NAN, NAN, NAN, NAN,
     "cobalt-hardened gold plate, type I code C of ASTM B488, 130...200 HK25: hardness 170 HK = 1.67 GPa; "
     "S_y computed as H/2.84; E, nu of bulk gold; what it conducts depends on its cobalt and carbon: give it",
     1.667e9, NAN, GOLD_ELECTRONS, NULL},
    {"beryllium-copper", 131e9, 0.30, 965e6, 7.68e-8, 107, 8350, 419, 4590,
     "CuBe2 (C17200), solution treated and aged (TF00): S_y minimum of ASTM B194; E, nu, c_p ASM Handbook vol. 2; "
     "resistivity, k, density: wire maker's data (Little Falls Alloys); longitudinal v_s computed from E, nu and "
     "density",
     NAN, NAN, COPPER_ELECTRONS, "CuBe,CuBe2,C17200"},
    {"copper-nickel-silicon", 135e9, 0.34, 500e6, 4.31e-8, 190, 8800, 399, 4860,
     "CuNi3SiMg (C70250), R620: S_y minimum, 40 % IACS, E, nu: conductivity-app.org, CuNi3Si (EN CW112C); k, density, "
     "c_p: maker's data sheet (KME STOL); longitudinal v_s computed from E, nu and density",
     NAN, NAN, COPPER_ELECTRONS, "CuNiSi,CuNi3Si,C7025,C70250"},
    {"solder", 30e9, 0.40, NAN, 14.5e-8, 50, 8400, 191, 2770,
     "Sn63Pb37, Indalloy 106: resistivity, k, density, 17 HB: tables of solder alloys (alasir.com); E: Topline; nu of "
     "tin-lead: makeitfrom.com; c_p of its metals by mass; longitudinal v_s computed; it creeps, so S_y depends on "
     "time: give it",
     167e6, NAN, 0, "SnPb,Sn63Pb37"},
    {"indium", 12.7e9, 0.45, 1.88e6, 8.37e-8, 81.8, 7310, 233, 2570,
     "pure indium, bulk: E, 0.9 HB: AZoM 9093; nu: Kim and Ledbetter 1998, Mater. Sci. Eng. A; S_y as its tensile "
     "strength, 273 psi (Indium Corporation), as it hardly hardens; others CRC Handbook of Chemistry and Physics; "
     "longitudinal v_s computed from E, nu and density",
     8.8e6, NAN, 11.5e28, NULL},
    {"galinstan", NAN, NAN, NAN, 2.89e-7, 16.5, 6440, 296, NAN,
     "liquid Ga-In-Sn between the bodies, which bears no load: resistivity of 3.46 MS/m, k, density: Geratherm's data "
     "as quoted by Wikipedia; c_p: Hodes et al. 2014, IEEE Trans. Compon. Packag. Manuf. Technol. 4",
     NAN, NAN, 0, NULL},
};
const size_t material_table_count = sizeof material_table / sizeof *material_table;

/* C = 1.295 exp(0.736 nu): where yielding starts under a spherical tip. Jackson & Green 2005; thesis (4.14). */
static const double yield_coefficient_factor = 1.295;
static const double yield_coefficient_exponent = 0.736;
/* k = density c_p v_s lambda/3, kinetic theory; thesis (4.52). */
static const double kinetic_dimensions = 3.0;

const double material_hardness_ratio = 2.84;

static bool is_one_of(const char *name, const char *names)
{
    const size_t length = strlen(name);
    for (const char *end; names; names = *end ? end + 1 : NULL) {
        end = strchrnul(names, ',');
        if ((size_t)(end - names) == length && strncasecmp(names, name, length) == 0)
            return true;
    }
    return false;
}

const struct material *material_find(const char *name)
{
    for (size_t i = 0; i < material_table_count; i++)
        if (strcasecmp(material_table[i].name, name) == 0 || is_one_of(name, material_table[i].aliases))
            return &material_table[i];
    return NULL;
}

const struct material_property *material_property_find(const char *key)
{
    for (size_t i = 0; i < material_property_count; i++)
        if (strcmp(material_properties[i].key, key) == 0)
            return &material_properties[i];
    return NULL;
}

struct material material_unknown(const char *name)
{
    struct material material = {.source = ""};
    const double none = NAN;
    for (size_t p = 0; p < material_property_count; p++)
        memcpy((char *)&material + material_properties[p].offset, &none, sizeof none);
    snprintf(material.name, sizeof material.name, "%s", name);
    return material;
}

double material_value(const struct material *material, const struct material_property *property)
{
    double value;
    memcpy(&value, (const char *)material + property->offset, sizeof value);
    return value;
}

/* (1 - nu²)/E of one body: what it adds to 1/E'. */
static double compliance_per_Pa(const struct material *material)
{
    return (1.0 - material->poisson_ratio * material->poisson_ratio) / material->youngs_modulus_Pa;
}

/* lambda_mfp = 3k/(density v_s c_p) (4.52*), unless it is given. */
static double mean_free_path_m(const struct material *material)
{
    if (!isnan(material->mean_free_path_m))
        return material->mean_free_path_m;
    return kinetic_dimensions * material->conductivity_W_per_mK /
           (material->density_kg_per_m3 * material->sound_speed_m_per_s * material->specific_heat_J_per_kgK);
}

/* If one yield strength is missing, the softer body is not known, and nothing of its yield. */
static struct material softer_body(const struct material *first, const struct material *second)
{
    if (isnan(first->yield_strength_Pa) || isnan(second->yield_strength_Pa))
        return material_unknown("");
    return second->yield_strength_Pa < first->yield_strength_Pa ? *second : *first;
}

double material_hardness(const struct material *material)
{
    return isnan(material->hardness_Pa) ? material_hardness_ratio * material->yield_strength_Pa : material->hardness_Pa;
}

struct material_pair material_pair(const struct material *material, enum material_counterface kind,
                                   const struct material *other)
{
    bool elastic = kind == MATERIAL_COUNTERFACE_ELASTIC;
    const struct material *second = elastic ? other : material;
    struct material softer = elastic ? softer_body(material, second) : *material;
    double k1 = material->conductivity_W_per_mK, k2 = second->conductivity_W_per_mK;
    double nu = material->poisson_ratio;

    return (struct material_pair){
        .effective_modulus_Pa = elastic ? 1.0 / (compliance_per_Pa(material) + compliance_per_Pa(second))
                                        : material->youngs_modulus_Pa / (1.0 - nu * nu),
        .yield_strength_Pa = softer.yield_strength_Pa,
        .hardness_Pa = material_hardness(&softer),
        .poisson_ratio = softer.poisson_ratio,
        .yield_coefficient = yield_coefficient_factor * exp(yield_coefficient_exponent * softer.poisson_ratio),
        .resistivity_ohm_m = (material->resistivity_ohm_m + second->resistivity_ohm_m) / 2.0,
        .conductivity_W_per_mK = k1 * (2.0 * k2 / (k1 + k2)), /* exactly k when both are k */
        .mean_free_path_m = {mean_free_path_m(material), mean_free_path_m(second)},
        .side_conductivity_W_per_mK = {k1, k2},
        .side_resistivity_ohm_m = {material->resistivity_ohm_m, second->resistivity_ohm_m},
    };
}

struct material_pair material_pair_unknown(void)
{
    const struct material none = material_unknown("");
    struct material_pair pair = material_pair(&none, MATERIAL_COUNTERFACE_RIGID, NULL);
    pair.unknown = true;
    pair.effective_modulus_Pa = 1.0;
    return pair;
}

double material_pair_pressure(const struct material_pair *pair, double load)
{
    return pair->unknown ? NAN : load * pair->effective_modulus_Pa;
}

double electron_mean_free_path(double density_per_m3, double resistivity_ohm_m)
{
    double charge = constant_electron_charge_C, reduced_planck = constant_planck_J_s / (2 * M_PI);
    double product = reduced_planck / charge * cbrt(3 * M_PI * M_PI) / charge / pow(density_per_m3, 2.0 / 3);
    return product / resistivity_ohm_m;
}
