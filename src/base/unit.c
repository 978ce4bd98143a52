/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/unit.h"
#include "base/text.h"

#include <assert.h>
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#define COUNT(array) (sizeof(array) / sizeof *(array))

/* In UTF-8; then in latin-1, whose bytes UTF-8 has behind C2. */
static const struct {
    const char *bytes, *letters;
} unit_letters[] = {
    {"\xCE\xBC", "u"},        /* Greek mu */
    {"\xCE\xA9", "ohm "},     /* Ωm² is two words */
    {"\xE2\x84\xA6", "ohm "}, /* ohm sign */
    {"\xC3\x85", "angstrom"},
    {"\xE2\x84\xAB", "angstrom"},
    {"\xE2\x81\xB4", "4"},
    {"\xE2\x81\xBB", "-"}, /* raised minus */
    {"\xE2\x88\x92", "-"}, /* minus sign */
    {"\xE2\x8B\x85", "*"}, /* dot operator */
    {"\xC3\x97", "*"},     /* multiplication sign */
    {"\xE2\x84\x83", "degC"},
    {"\xE2\x84\x89", "degF"},
    {"\xE2\x80\x89", " "}, /* thin space */
    {"\xE2\x80\xAF", " "}, /* narrow no-break space */
    {"\xC2", ""},
    {"\xB5", "u"}, /* micro sign */
    {"\xC5", "angstrom"},
    {"\xB9", "1"},
    {"\xB2", "2"},
    {"\xB3", "3"},
    {"\xB7", "*"},   /* middle dot */
    {"\xB0", "deg"}, /* degree sign */
    {"\xA0", " "},   /* no-break space */
};

static const struct {
    const char *symbol, *name;
    int exponent; /* of ten */
} unit_prefixes[] = {
    {"", "", 0},        {"G", "giga", 9},   {"M", "mega", 6},   {"k", "kilo", 3},  {"h", "hecto", 2},
    {"c", "centi", -2}, {"m", "milli", -3}, {"u", "micro", -6}, {"n", "nano", -9}, {"p", "pico", -12},
};

/* One of each is mantissa * 10^exponent in SI. Names, in lower case and singular, may be NULL. Factors that are no
 * powers of ten: NIST SP 811 (2008), appendix B.8. */
static const struct unit_row {
    const char *symbol, *name;
    bool prefixes;
    double mantissa;
    int exponent;
    int power[UNIT_BASES];
    double offset; /* [K] of its zero, where it stands alone: a temperature, and not only a difference */
} unit_rows[] = {
    {"m", "metre", true, 1, 0, {[UNIT_METRE] = 1}, 0},
    {"m", "meter", true, 1, 0, {[UNIT_METRE] = 1}, 0},
    {"g", "gram", true, 1, -3, {[UNIT_KILOGRAM] = 1}, 0},
    {"in", "inch", false, 2.54, -2, {[UNIT_METRE] = 1}, 0},
    {"uin", "microinch", false, 2.54, -8, {[UNIT_METRE] = 1}, 0},
    {"mil", "mil", false, 2.54, -5, {[UNIT_METRE] = 1}, 0},
    {"angstrom", "angstrom", false, 1, -10, {[UNIT_METRE] = 1}, 0},
    {"s", NULL, true, 1, 0, {[UNIT_SECOND] = 1}, 0},
    {"min", "minute", false, 60, 0, {[UNIT_SECOND] = 1}, 0},
    {"h", "hour", false, 3600, 0, {[UNIT_SECOND] = 1}, 0},
    {"A", "ampere", true, 1, 0, {[UNIT_AMPERE] = 1}, 0},
    {"K", "kelvin", true, 1, 0, {[UNIT_KELVIN] = 1}, 0},
    {"degC", NULL, false, 1, 0, {[UNIT_KELVIN] = 1}, 273.15}, /* in a product a difference: degC/W is K/W */
    {"degF", NULL, false, 1 / 1.8, 0, {[UNIT_KELVIN] = 1}, 273.15 - 32 / 1.8},
    {"N", "newton", true, 1, 0, {1, 1, -2, 0, 0}, 0},
    {"gf", NULL, false, 9.80665, -3, {1, 1, -2, 0, 0}, 0},
    {"kgf", NULL, false, 9.80665, 0, {1, 1, -2, 0, 0}, 0},
    {"lbf", NULL, false, 4.4482216152605, 0, {1, 1, -2, 0, 0}, 0},
    {"Pa", "pascal", true, 1, 0, {-1, 1, -2, 0, 0}, 0},
    {"bar", "bar", true, 1, 5, {-1, 1, -2, 0, 0}, 0},
    {"psi", NULL, false, 6.894757293168361, 3, {-1, 1, -2, 0, 0}, 0},
    {"atm", NULL, false, 1.01325, 5, {-1, 1, -2, 0, 0}, 0},
    {"HV", NULL, false, 9.80665, 6, {-1, 1, -2, 0, 0}, 0}, /* Vickers: kgf/mm² */
    {"torr", "torr", false, 1.01325e5 / 760, 0, {-1, 1, -2, 0, 0}, 0},
    {"J", "joule", true, 1, 0, {2, 1, -2, 0, 0}, 0},
    {"W", "watt", true, 1, 0, {2, 1, -3, 0, 0}, 0},
    {"V", "volt", true, 1, 0, {2, 1, -3, -1, 0}, 0},
    {"ohm", "ohm", true, 1, 0, {2, 1, -3, -2, 0}, 0},
    {"Ohm", NULL, true, 1, 0, {2, 1, -3, -2, 0}, 0},
    {"ohms", NULL, true, 1, 0, {2, 1, -3, -2, 0}, 0},
    {"Ohms", NULL, true, 1, 0, {2, 1, -3, -2, 0}, 0},
    {"S", "siemens", true, 1, 0, {-2, -1, 3, 2, 0}, 0},
    {"%", "percent", false, 1, -2, {0, 0, 0, 0, 0}, 0},
    {"1", "dimensionless", false, 1, 0, {0, 0, 0, 0, 0}, 0},
    {"-", NULL, false, 1, 0, {0, 0, 0, 0, 0}, 0},
};

/* m, kg, s, A, K */
#define SI(m, kg, s, A, K)                                                                                             \
    {                                                                                                                  \
        m, kg, s, A, K                                                                                                 \
    }
static const struct {
    enum unit_quantity quantity;
    const char *name, *si;
    int power[UNIT_BASES];
    double factor; /* the only one; 0: any */
    const char *known;
} unit_quantities[] = {
    {UNIT_NUMBER, "a plain number", "", SI(0, 0, 0, 0, 0), 1, "dimensionless"},
    {UNIT_PERCENT, "a percentage", "", SI(0, 0, 0, 0, 0), 1e-2, "%"},
    {UNIT_FORCE, "a force", "N", SI(1, 1, -2, 0, 0), 0, "N, mN, cN, kN, gf, kgf, lbf"},
    {UNIT_PRESSURE, "a pressure", "Pa", SI(-1, 1, -2, 0, 0), 0, "Pa, kPa, MPa, GPa, N/mm2, bar, psi, atm"},
    {UNIT_RESISTANCE, "a resistance", "ohm", SI(2, 1, -3, -2, 0), 0, "ohm (Ω), nohm, uohm (µΩ), mohm (mΩ), kohm"},
    {UNIT_RESISTANCE_AREA, "a resistance times an area", "ohm m2", SI(4, 1, -3, -2, 0), 0,
     "ohm m2 (Ω·m²), ohm mm2, mohm mm2, uohm cm2"},
    {UNIT_THERMAL_RESISTANCE, "a thermal resistance", "K/W", SI(-2, -1, 3, 0, 1), 0, "K/W, mK/W"},
    {UNIT_THERMAL_RESISTANCE_AREA, "a thermal resistance times an area", "K m2/W", SI(0, -1, 3, 0, 1), 0,
     "K m2/W, K mm2/W, K cm2/W"},
    {UNIT_DISTANCE, "a length", "m", SI(1, 0, 0, 0, 0), 0, "m, mm, um, nm, angstrom, in, uin, mil"},
    {UNIT_AREA, "an area", "m2", SI(2, 0, 0, 0, 0), 0, "m2, cm2, mm2, um2, in2"},
    {UNIT_TIME, "a time", "s", SI(0, 0, 1, 0, 0), 0, "s, ms, min, h"},
    {UNIT_SPEED, "a speed", "m/s", SI(1, 0, -1, 0, 0), 0, "m/s, km/s, mm/us"},
    {UNIT_TEMPERATURE, "a temperature", "K", SI(0, 0, 0, 0, 1), 0, "K, degC (°C), degF"},
    {UNIT_CURRENT, "a current", "A", SI(0, 0, 0, 1, 0), 0, "A, mA, kA"},
    {UNIT_VOLTAGE, "a voltage", "V", SI(2, 1, -3, -1, 0), 0, "V, mV, uV"},
    {UNIT_DENSITY, "a density", "kg/m3", SI(-3, 1, 0, 0, 0), 0, "kg/m3, g/cm3"},
    {UNIT_SPECIFIC_HEAT, "a specific heat", "J/kg/K", SI(2, 0, -2, 0, -1), 0, "J/kg/K, kJ/kg/K, J/g/K"},
    {UNIT_CONDUCTIVITY, "a thermal conductivity", "W/m/K", SI(1, 1, -3, 0, -1), 0, "W/m/K, W/cm/K"},
    {UNIT_RESISTIVITY, "a resistivity", "ohm m", SI(3, 1, -3, -2, 0), 0, "ohm m, uohm cm, ohm mm2/m, nohm m"},
    {UNIT_CONDUCTANCE, "a thermal conductance", "W/K", SI(2, 1, -3, 0, -1), 0, "W/K, mW/K, kW/K"},
    {UNIT_CONDUCTANCE_AREA, "a thermal conductance by area", "W/m2/K", SI(0, 1, -3, 0, -1), 0,
     "W/m2/K, kW/m2/K, W/cm2/K"},
    {UNIT_POWER, "a power", "W", SI(2, 1, -3, 0, 0), 0, "W, mW, kW"},
};

bool unit_spell(char spelling[UNIT_LENGTH], const char *text, size_t length)
{
    size_t used = 0;
    for (size_t i = 0, bytes; i < length; i += bytes) {
        const char same[] = {text[i], '\0'}, *letters = same;
        bytes = 1;
        bool ascii = (unsigned char)text[i] < 0x80; /* the others are what has another spelling */
        for (size_t k = 0; !ascii && k < COUNT(unit_letters) && letters == same; k++) {
            size_t known = strlen(unit_letters[k].bytes);
            if (length - i >= known && memcmp(text + i, unit_letters[k].bytes, known) == 0) {
                letters = unit_letters[k].letters;
                bytes = known;
            }
        }
        if (used + strlen(letters) >= UNIT_LENGTH)
            return false;
        memcpy(spelling + used, letters, strlen(letters));
        used += strlen(letters);
    }
    spelling[used] = '\0';
    return used > 0;
}

bool unit_shown(char shown[UNIT_LENGTH], const char *text, size_t length)
{
    size_t seen = 0;
    if (length >= UNIT_LENGTH)
        return false;
    memcpy(shown, text, length);
    shown[length] = '\0';
    for (size_t bytes; (bytes = text_character(shown + seen)) > 0;)
        seen += bytes;
    return seen == length || unit_spell(shown, text, length); /* latin-1 */
}

/* A unit as it is put together: decimal powers are counted, so that mm² is 1e-6 and no rounded square of 1e-3. */
struct product {
    struct unit unit;
    int exponent; /* of ten, beside the unit's factor */
};

/* Is the word the prefix and the name, in any case? Microhm and kilohm lose a vowel between them. */
static bool is_named(const char *word, size_t length, const char *prefix, const char *name)
{
    size_t before = strlen(prefix), after = strlen(name);
    if (length == before + after + 1 && (word[length - 1] == 's' || word[length - 1] == 'S'))
        length--;
    if (before > 0 && name[0] == 'o' && length + 1 == before + after && strchr("oa", prefix[before - 1]))
        before--;
    return length == before + after && strncasecmp(word, prefix, before) == 0 &&
           strncasecmp(word + before, name, after) == 0;
}

static bool is_symbol(const char *word, size_t length, const char *prefix, const char *symbol)
{
    size_t before = strlen(prefix), after = strlen(symbol);
    return length == before + after && memcmp(word, prefix, before) == 0 && memcmp(word + before, symbol, after) == 0;
}

/* Prefix and unit of a word; a unit without prefix goes first. */
static const struct unit_row *find_word(const char *word, size_t length, int *exponent)
{
    for (size_t p = 0; p < COUNT(unit_prefixes); p++) {
        const char *symbol = unit_prefixes[p].symbol, first = unit_prefixes[p].name[0];
        if (p > 0 && word[0] != symbol[0] && tolower((unsigned char)word[0]) != first) /* saves 1 % of `inspect` */
            continue;
        for (size_t u = 0; u < COUNT(unit_rows); u++) {
            const struct unit_row *row = &unit_rows[u];
            if (p > 0 && !row->prefixes)
                continue;
            if (is_symbol(word, length, unit_prefixes[p].symbol, row->symbol) ||
                (row->name && is_named(word, length, unit_prefixes[p].name, row->name))) {
                *exponent = unit_prefixes[p].exponent + row->exponent;
                return row;
            }
        }
    }
    return NULL;
}

static const char *skip_blanks(const char *p)
{
    return p + strspn(p, " \t");
}

static const char *read_product(struct product *out, const char *p, int sign);

/* Reads a word with its power, or a product in brackets. Returns its end; NULL: none. `sign` -1 divides. */
static const char *read_power(struct product *out, const char *p, int sign)
{
    if (*p == '(') {
        p = read_product(out, skip_blanks(p + 1), sign);
        return p && *p == ')' ? p + 1 : NULL;
    }
    size_t length = 0;
    while (isalpha((unsigned char)p[length]))
        length++;
    int exponent = 0;
    const struct unit_row *row = length > 0 ? find_word(p, length, &exponent) : NULL;
    if (!row)
        return NULL;
    p += length;
    bool raised = *p == '^';
    p += raised;
    int times = *p == '-' ? -1 : 1;
    bool signed_power = *p == '-' || (raised && *p == '+');
    p += signed_power;
    if (*p >= '1' && *p <= '4')
        times *= *p++ - '0';
    else if (raised || signed_power)
        return NULL;
    if (isdigit((unsigned char)*p))
        return NULL;
    times *= sign;
    out->unit.factor *= pow(row->mantissa, times);
    out->exponent += exponent * times;
    for (int i = 0; i < UNIT_BASES; i++)
        out->unit.power[i] += row->power[i] * times;
    return p;
}

static bool is_per(const char *p)
{
    return strncasecmp(p, "per", 3) == 0 && p[3] != '\0' && strchr(" _\t(", p[3]);
}

/* Powers side by side or with a sign between them, up to a slash, a bracket or the end. */
static const char *read_powers(struct product *out, const char *p, int sign)
{
    while ((p = read_power(out, p, sign))) {
        const char *next = p + strspn(p, " \t_*.");
        bool is_end = *next == '\0' || *next == '/' || *next == ')';
        if (is_per(next) || (is_end && next == skip_blanks(p)))
            return next;
        if (is_end || (next == p && !isdigit((unsigned char)p[-1]))) /* m2K is two words, mK one */
            return NULL;
        p = next;
    }
    return NULL;
}

/* A product and its divisors. Behind a slash stands one power or a bracket, since `W/m2 K` could be two units. */
static const char *read_product(struct product *out, const char *p, int sign)
{
    p = *p == '1' && strchr("/ ", p[1]) ? skip_blanks(p + 1) : read_powers(out, p, sign);
    while (p && (*p == '/' || is_per(p))) {
        p += *p == '/' ? 1 : 3;
        p = read_power(out, p + strspn(p, " \t_"), -sign);
        if (p)
            p += strspn(p, " \t") + (is_per(p + strspn(p, "_")) ? strspn(p, "_") : 0);
    }
    return p;
}

bool unit_read(struct unit *out, const char *text, size_t length)
{
    char letters[UNIT_LENGTH];
    if (length >= UNIT_LENGTH || memchr(text, '\0', length) || !unit_spell(letters, text, length))
        return false;
    char *spelling = letters + strspn(letters, " \t");
    for (size_t end = strlen(spelling); end > 0 && strchr(" \t", spelling[end - 1]); end--)
        spelling[end - 1] = '\0';
    struct product product = {.unit.factor = 1};
    const struct unit_row *alone = find_word(spelling, strlen(spelling), &product.exponent); /* also no letter: % */
    if (alone) {
        product.unit.factor = alone->mantissa;
        product.unit.offset = alone->offset;
        memcpy(product.unit.power, alone->power, sizeof alone->power);
    } else {
        const char *end = read_product(&product, spelling, 1);
        if (!end || *end != '\0')
            return false;
    }
    *out = product.unit;
    /* dividing by a power of ten that double holds exactly rounds once */
    out->factor =
        product.exponent < 0 ? out->factor / pow(10, -product.exponent) : out->factor * pow(10, product.exponent);
    return isfinite(out->factor) && out->factor > 0;
}

unsigned unit_of(const struct unit *unit, unsigned quantities)
{
    for (size_t i = 0; i < COUNT(unit_quantities); i++)
        if ((quantities & unit_quantities[i].quantity) &&
            memcmp(unit->power, unit_quantities[i].power, sizeof unit->power) == 0 &&
            (unit_quantities[i].factor == 0 || unit_quantities[i].factor == unit->factor))
            return unit_quantities[i].quantity;
    return 0;
}

bool unit_equal(const struct unit *a, const struct unit *b)
{
    return memcmp(a->power, b->power, sizeof a->power) == 0 && a->offset == b->offset &&
           fabs(a->factor - b->factor) <= 1e-12 * fabs(a->factor);
}

static size_t quantity_row(enum unit_quantity quantity)
{
    size_t i = 0;
    for (; unit_quantities[i].quantity != quantity; i++)
        assert(i + 1 < COUNT(unit_quantities));
    return i;
}

const char *unit_si(enum unit_quantity quantity)
{
    return unit_quantities[quantity_row(quantity)].si;
}

const char *unit_quantity_name(enum unit_quantity quantity)
{
    return unit_quantities[quantity_row(quantity)].name;
}

struct unit_known unit_known(unsigned quantities)
{
    struct unit_known out = {""};
    size_t used = 0;
    for (size_t i = 0; i < COUNT(unit_quantities); i++)
        if (quantities & unit_quantities[i].quantity)
            used += (size_t)snprintf(out.text + used, sizeof out.text - used, "%s%s", used ? "; " : "",
                                     unit_quantities[i].known);
    assert(used < sizeof out.text);
    return out;
}
