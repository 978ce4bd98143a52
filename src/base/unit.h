/* Units of measurement as people write them: spelling, prefix, products, powers and quotients to a factor to SI. */
#ifndef BASE_UNIT_H
#define BASE_UNIT_H

#include <stdbool.h>
#include <stddef.h>

enum unit_base { UNIT_METRE, UNIT_KILOGRAM, UNIT_SECOND, UNIT_AMPERE, UNIT_KELVIN, UNIT_BASES };

/** One of it is `factor` of the coherent SI unit of its dimension. */
struct unit {
    int power[UNIT_BASES]; /* of the SI base units: the dimension */
    double factor;
};

/** What a unit may be a unit of: bits. */
enum unit_quantity {
    UNIT_NUMBER = 1, /* a plain number: 1 or - */
    UNIT_PERCENT = 2,
    UNIT_FORCE = 4,                    /* N */
    UNIT_PRESSURE = 8,                 /* Pa */
    UNIT_RESISTANCE = 16,              /* Ω */
    UNIT_RESISTANCE_AREA = 32,         /* Ω m²: a resistance times an area */
    UNIT_THERMAL_RESISTANCE = 64,      /* K/W */
    UNIT_THERMAL_RESISTANCE_AREA = 128 /* K m²/W */
};

enum { UNIT_LENGTH = 48 }; /* bytes of a spelling, with the NUL */

/** Writes `text` with each letter and sign that has several codes, or none in ASCII, as ASCII: every mu as u, ohm sign
 * and Greek omega as ohm, Å as angstrom, raised digits as digits, dots and crosses as *, special blanks as blanks
 * (UTF-8, and what latin-1 has of them). False when it is empty or does not fit. */
bool unit_spell(char spelling[UNIT_LENGTH], const char *text, size_t length);

/** Reads a unit: `kN`, `mΩ`, `µOhm`, `milliohm`, `K m²/W`, `ohm_m2`, `K_m2_per_W`, `W/(m2 K)`, `N/mm^2`. Symbols are
 * told apart by case (m is milli, M is mega), words are not. False when it does not fit into UNIT_LENGTH, any part is
 * unknown, and where what is divided by is in doubt (`W/m2 K`: write `W/m2/K` or `W/(m2 K)`). */
bool unit_read(struct unit *out, const char *text, size_t length);

/** The one of `quantities` (bits) that it is a unit of, 0 where it is of none of them. */
unsigned unit_of(const struct unit *unit, unsigned quantities);

/** Do both stand for the same? */
bool unit_equal(const struct unit *a, const struct unit *b);

/** Units of each of `quantities` for a message: "N, mN, kN, gf or lbf; Pa, kPa, ...". */
struct unit_known {
    char text[512];
};
struct unit_known unit_known(unsigned quantities);

#endif
