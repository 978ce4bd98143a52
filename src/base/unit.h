/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads units of measurement as people write them, with prefixes, products, powers and quotients, as a factor to SI. */
#ifndef BASE_UNIT_H
#define BASE_UNIT_H

#include <stdbool.h>
#include <stddef.h>

enum unit_base { UNIT_METRE, UNIT_KILOGRAM, UNIT_SECOND, UNIT_AMPERE, UNIT_KELVIN, UNIT_BASES };

/** A value in it is `factor` times as much in the coherent SI unit of its dimension, plus `offset`. */
struct unit {
    int power[UNIT_BASES]; /* of the SI base units: the dimension */
    double factor;
    double offset; /* of degC and degF standing alone, which are temperatures; else 0 */
};

/** What a unit may be a unit of: bits. */
enum unit_quantity {
    UNIT_NUMBER = 1, /* a plain number: 1 or - */
    UNIT_PERCENT = 2,
    UNIT_FORCE = 4,                                       /* N */
    UNIT_PRESSURE = 8,                                    /* Pa */
    UNIT_RESISTANCE = 16,                                 /* Ω */
    UNIT_RESISTANCE_AREA = 32,                            /* Ω m²: a resistance times an area */
    UNIT_THERMAL_RESISTANCE = 64,                         /* K/W */
    UNIT_THERMAL_RESISTANCE_AREA = 128,                   /* K m²/W */
    UNIT_DISTANCE = 1 << 8,                               /* m */
    UNIT_AREA = 1 << 9,                                   /* m² */
    UNIT_TIME = 1 << 10,                                  /* s */
    UNIT_SPEED = 1 << 11,                                 /* m/s */
    UNIT_TEMPERATURE = 1 << 12,                           /* K */
    UNIT_CURRENT = 1 << 13,                               /* A */
    UNIT_VOLTAGE = 1 << 14,                               /* V */
    UNIT_DENSITY = 1 << 15,                               /* kg/m³ */
    UNIT_SPECIFIC_HEAT = 1 << 16,                         /* J/(kg K) */
    UNIT_CONDUCTIVITY = 1 << 17,                          /* W/(m K): of heat */
    UNIT_RESISTIVITY = 1 << 18,                           /* Ω m */
    UNIT_CONDUCTANCE = 1 << 19,                           /* W/K: of heat */
    UNIT_CONDUCTANCE_AREA = 1 << 20,                      /* W/(m² K): of heat, by area */
    UNIT_POWER = 1 << 21,                                 /* W */
    UNIT_LOADS = UNIT_NUMBER | UNIT_FORCE | UNIT_PRESSURE /* P/(A_n E') or one of the others */
};

enum { UNIT_LENGTH = 48 }; /* bytes of a spelling, with the NUL */

/** Writes `text` (UTF-8 or latin-1) in ASCII: mu as u, the ohm sign and omega as ohm, Å as angstrom, raised digits as
 * digits, dots and crosses as *, special blanks as blanks. False when it is empty or does not fit. */
bool unit_spell(char spelling[UNIT_LENGTH], const char *text, size_t length);

/** A unit's `text` as it may be shown; where it is no UTF-8, by unit_spell(). False: it does not fit. */
bool unit_shown(char shown[UNIT_LENGTH], const char *text, size_t length);

/** Reads a unit: `kN`, `mΩ`, `µOhm`, `milliohm`, `K m²/W`, `ohm_m2`, `K_m2_per_W`, `W/(m2 K)`, `N/mm^2`. Case counts in
 * symbols (m is milli, M is mega), not in words. False when it is longer than UNIT_LENGTH, a part is unknown, or the
 * divisor is ambiguous (`W/m2 K`: write `W/m2/K` or `W/(m2 K)`). */
bool unit_read(struct unit *out, const char *text, size_t length);

/** The one of `quantities` (bits) that it is a unit of; 0: none. */
unsigned unit_of(const struct unit *unit, unsigned quantities);

/** Are they the same unit? */
bool unit_equal(const struct unit *a, const struct unit *b);

/** The coherent SI unit of one quantity: "Pa"; "" of a plain number. */
const char *unit_si(enum unit_quantity quantity);
/** What one quantity is called, with its article: "a pressure". */
const char *unit_quantity_name(enum unit_quantity quantity);

/** Units of each of `quantities` for a message: "N, mN, ...; Pa, kPa, ...". */
struct unit_known {
    char text[512];
};
struct unit_known unit_known(unsigned quantities);

#endif
