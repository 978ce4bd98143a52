/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The effects that a scene can ask for: one row each. */
#ifndef CONTACT_EFFECT_H
#define CONTACT_EFFECT_H

#include <stdbool.h>
#include <stddef.h>

enum effect {
    EFFECT_PLASTICITY,
    EFFECT_SEPARATION,
    EFFECT_ELECTRICAL,
    EFFECT_THERMAL,
    EFFECT_SCALE_DEPENDENT,
    EFFECT_STIFFNESS,
    EFFECT_LAST_SCALE,
    EFFECT_CONVERGENCE,
    EFFECT_UNCERTAINTY,
    EFFECT_DIRECT,
    EFFECT_GAP,
    EFFECT_FILM,
    EFFECT_PLATING,
    EFFECT_HEATING,
    EFFECT_SHAPE,
    EFFECT_COUNT
};

/** Bit of an effect in a set of effects. */
#define EFFECT_BIT(effect) (1u << (effect))

struct effect_row {
    const char *name;          /* scene spelling */
    const char *properties[5]; /* material keys it needs besides E_Pa and nu, NULL-terminated */
    unsigned needs_effects;    /* effects it builds on (bits) */
    const char *key;           /* scene key that asks for it and that it needs; NULL: none */
    bool adds;                 /* adds quantities and changes no others */
    bool studies;              /* changes no number, but says how far numbers can be trusted */
    bool only_listed;          /* runs only where `effects` lists it */
};

extern const struct effect_row effect_rows[EFFECT_COUNT];

#endif
