/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Scenes of valid keys, unlike in every way: lines that stand for themselves, each taken or not. */
#ifndef TEST_WILD_SCENE_H
#define TEST_WILD_SCENE_H

#include "base/text.h"
#include <string.h>

/* A key of the scene (scene_keys), taken once in so many scenes, and its values; an empty one leaves
 * it out. */
static const struct wild_key {
    const char *key;
    size_t once_in;
    const char *values[6];
} wild_keys[] = {
    {"material",
     1,
     {"tin", "tin", "{E: 1 MPa, nu: 0.49, Sy: 1e3, resistivity: 1e-8}", "hard-gold",
      "{E: 1e13 Pa, nu: 0, Sy: 1e12, resistivity: 1e-3, conductivity: 1e-2}", ""}},
    {"models",
     2,
     {"[corrected-persson]", "[multiscale]", "[gw, jg]", "[corrected-persson, cmy]", "[strip, cmy]",
      "[multiscale, statistical, corrected-persson, strip]"}},
    {"fit", 2, {"thesis"}},
    {"closure", 6, {"numeric"}},
    {"moments", 6, {"spectral"}},
    {"window", 4, {"none", "hann"}},
    {"level", 3, {"none", "mean", "parabola", "robust", "circle"}},
    {"load",
     4,
     {"{from: 1e-12, to: 1e3, points: 9}", "{values: [1e-3]}", "{from: 1e-3, to: 1, points: 5}",
      "{from: 1e-9 Pa, to: 1e12 Pa, points: 7}", "{values: [1 uN, 1 kN]}"}},
    {"tolerance", 6, {"0.1", "1e-13", "1e-2"}},
    {"accuracy", 12, {"10 %", "2"}},
    {"lambda_s", 6, {"2.5 um", "1 nm"}},
    {"lambda_c", 12, {"0.8 mm", "1 km"}},
    {"fit_band", 6, {"[1 um, 1 mm]", "[1 nm, 1 km]"}},
    {"gap",
     6,
     {"{gas: air}", "{conductivity: 0.8 W/m/K}", "{gas: vacuum}", "{filler: pad, bond_line: 1 um}",
      "{gas: helium, pressure: 1e-9, temperature: 600, accommodation: 1e-3}", "{liquid: water}"}},
    {"targets",
     8,
     {"[{area: 5 %}]", "[{ecr: 1e-12 ohm m2}, {area: 99.9 %}]", "[{tcr: 1e-9 K m2/W}, {conductance: 1e12}]"}},
    {"limits",
     8,
     {"{area: {least: 1 %}}", "{ecr: {most: 1e-20 ohm m2}, tcr: {most: 1 K m2/W}}", "{conductance: {least: 1}}"}},
    {"effects",
     6,
     {"[plasticity, separation, uncertainty]", "[]", "[separation, convergence]", "[separation, last-scale, stiffness]",
      "[separation, electrical, thermal, uncertainty]", "auto"}},
    {"nominal_area", 1, {"1 mm2", "1 mm2", "none", "1e-12", "1e6"}},
    {"counterface", 12, {"same", "copper", "{E: 3 GPa, nu: 0.4}", "rigid", "{surface: s1/scan0.csv}"}},
    {"hardness", 12, {"1 GPa", "HV 120", "{c1: 5 GPa, c2: -0.2}", "1e3", "1e12"}},
    {"direction", 12, {"y"}},
    {"lay", 12, {"0.3", "0", "1"}},
    {"mean_free_path", 12, {"electron"}},
    {"operating_load", 8, {"1e-3", "1e-2", "1e-3", "1e-6", "1 MPa"}},
    {"export", 12, {"[calculix, abaqus]", "[ansys, comsol, elmer, moose]"}},
    {"max_missing", 12, {"0", "50 %"}},
    {"tip_radius", 12, {"2 um", "1 m"}},
    {"baseline", 12, {"s1"}},
    {"direct", 24, {"{grid: 16, seeds: 1, loads: 2}", "{grid: 16, seeds: 2, loads: [1e-3, 1]}"}},
    {"film", 12, {"1e-12 ohm m2", "0", "1e6"}},
    {"shape",
     12,
     {"{flatness: 5 um, over: 20 mm}", "{bolts: [[1 mm, 1 mm]], force: 1 kN, head: 6 mm, thickness: [1 mm, 9 mm]}"}},
    {"plating",
     12,
     {"{thickness: 1 um, metal: hard gold}", "{thickness: 1e-12, resistivity: 1e10, sides: both}",
      "{thickness: 1, resistivity: 1e-12}"}},
    {"current", 12, {"1 A", "1e6 A", "1e-9"}},
    {"convergence", 12, {"{alpha: 1e-3, gamma: 1.5, load: 1e-3, scan_length: 1 mm, scales: 64}"}},
};
enum { WILD_KEYS = sizeof wild_keys / sizeof *wild_keys, WILD_VALUES = sizeof wild_keys->values / sizeof(char *) };

/* Adds the lines of a scene but those of keys in `but`, NULL behind the last; `below` gives a number from 0 to below
 * the one it is given. The value of number `sure`, counted over all keys, is taken for sure. Returns how many there
 * are.
 */
static inline size_t wild_scene(struct text *out, const char *const *but, size_t (*below)(size_t count), size_t sure)
{
    size_t values = 0;
    text_add(out, "title: wild\n");
    for (const struct wild_key *key = wild_keys; key < wild_keys + WILD_KEYS; key++) {
        size_t count = 0;
        while (count < WILD_VALUES && key->values[count])
            count++;
        const char *value = below(key->once_in) == 0 ? key->values[below(count)] : "";
        if (sure >= values && sure < values + count)
            value = key->values[sure - values];
        values += count;
        size_t i = 0;
        while (but[i] && strcmp(but[i], key->key) != 0)
            i++;
        if (*value && !but[i])
            text_add(out, "%s: %s\n", key->key, value);
    }
    return values;
}

#endif
