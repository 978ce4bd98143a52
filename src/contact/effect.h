/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The effects a scene can call for. One row each: which material properties and effects it needs. */
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
    const char *key;           /* of the scene, that calls for it, and without which it does not run; NULL: none */
    bool adds;                 /* quantities of its own, and changes no other */
    bool studies;              /* changes no number: it says how far they can be trusted */
    bool only_listed;          /* nothing else calls for it: it runs where `effects` lists it */
};

extern const struct effect_row effect_rows[EFFECT_COUNT];

#endif
