/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scan/reader.h"
#include "scan/string_view.h"
#include "support.h"

#include <locale.h>
#include <stdio.h>

static void assert_scans(const char *text, unsigned allowed, double expected, const char *rest)
{
    double value = NAN;
    const char *end = number_scan((struct string_view){text, text + strlen(text)}, allowed, NULL, &value);
    assert_non_null(end);
    if (value != expected || signbit(value) != signbit(expected))
        fail_msg("'%s' read as %.17g, expected %.17g", text, value, expected);
    assert_string_equal(end, rest);
}

TEST_CASE(test_forms)
{
    assert_scans("0", 3, 0.0, "");
    assert_scans("-0.0", 3, -0.0, "");
    assert_scans("+1.5e-3x", 3, 1.5e-3, "x");
    assert_scans("1.", 3, 1.0, "");
    assert_scans(".25", 3, 0.25, "");
    assert_scans("1D2", 3, 100.0, "");
    assert_scans("1e", 3, 1.0, "e");
    assert_scans("1e+", 3, 1.0, "e+");
    assert_scans("0,5", NUMBER_COMMA, 0.5, "");
    assert_scans("0,5", NUMBER_POINT, 0.0, ",5");
    assert_scans("0.5", NUMBER_COMMA, 0.0, ".5");
    assert_scans("1e400", 3, INFINITY, "");
    assert_scans("1e-400", 3, 0.0, "");
    assert_scans("0e999999999999", 3, 0.0, "");
    assert_scans("1e99999999999999999999", 3, INFINITY, "");
    assert_scans("0.000000000000000000000000000001e30", 3, 1.0, "");
    static const char *const none[] = {"", "-", "+", ".", "e5", "nan", "inf", "x", ",5", "5,", "--1", " 1"};
    for (size_t i = 0; i < sizeof none / sizeof *none; i++) {
        double value;
        assert_null(number_scan((struct string_view){none[i], none[i] + strlen(none[i])}, NUMBER_POINT | NUMBER_COMMA,
                                NULL, &value));
    }
}

/* strtod of the C library is the reference: it rounds correctly. */
TEST_CASE(test_against_strtod)
{
    uint64_t seed = 5;
    for (int i = 0; i < 300000; i++) {
        seed = seed * 6364136223846793005u + 1442695040888963407u;
        char text[64];
        int digits = (int)(seed >> 40 & 31) + 1;
        uint64_t bits = seed ^ seed >> 29;
        double value;
        if (i % 2) { /* any double */
            memcpy(&value, &bits, sizeof value);
            if (!isfinite(value))
                continue;
            snprintf(text, sizeof text, "%.*g", digits > 20 ? 17 : digits, value);
        } else { /* what scans hold */
            uint64_t fraction = bits;
            for (int digit = 19; digit > digits % 19; digit--)
                fraction /= 10; /* up to 18 digits, so that 16 to 19 in all are frequent */
            snprintf(text, sizeof text, "%s%d.%0*llu", seed & 1 ? "-" : "", (int)(seed >> 54), digits % 19,
                     (unsigned long long)fraction);
        }
        assert_scans(text, NUMBER_POINT, strtod(text, NULL), "");
    }
}

/* Half-way cases between two doubles, with up to 800 digits. */
TEST_CASE(test_halfway)
{
    static const char *const cases[] = {"9007199254740993", "9007199254740993.0000000000000000000000000001",
                                        "2.2250738585072011e-308", "2.4703282292062327208e-324",
                                        "1.7976931348623158e308"};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        assert_scans(cases[i], NUMBER_POINT, strtod(cases[i], NULL), "");
    /* 1 + 2^-53 exactly, then something behind 1000 zeros */
    char text[1200];
    strcpy(text, "1.00000000000000011102230246251565404236316680908203125");
    assert_scans(text, NUMBER_POINT, 1.0, "");
    size_t length = strlen(text);
    memset(text + length, '0', 1000);
    text[length + 1000] = '\0';
    assert_scans(text, NUMBER_POINT, 1.0, "");
    text[length + 999] = '1';
    assert_scans(text, NUMBER_POINT, 1.0 + 0x1p-52, "");
    char longer[2100]; /* no instrument writes that */
    memset(longer, '7', sizeof longer);
    assert_null(number_scan((struct string_view){longer, longer + sizeof longer}, NUMBER_POINT, NULL, &(double){0}));
}

TEST_CASE(test_locale)
{
    /* without such a locale installed the test still holds, just says less */
    (void)setlocale(LC_ALL, "de_DE.UTF-8");
    assert_scans("0.1234567890123456789012", NUMBER_POINT, 0.1234567890123456789012, "");
    setlocale(LC_ALL, "C");
}

TEST_CASE(test_units)
{
    static const struct {
        const char *names;
        double si;
    } units[] = {
        {"m metres meter", 1},
        {"dm", 1e-1},
        {"cm centimeter centimetres", 1e-2},
        {"mm MM millimeter millimetre", 1e-3},
        {"um UM u \xC2\xB5m \xCE\xBCm \xB5m \xB5 micron microns Micrometer micrometre", 1e-6},
        {"nm nanometer nanometre", 1e-9},
        {"pm picometer picometre", 1e-12},
        {"A \xC3\x85 \xC5 Angstroms", 1e-10},
        {"in inches", 0.0254},
        {"mil mils thou", 2.54e-5},
        {"uin \xC2\xB5in microinches uinch uinches", 2.54e-8},
        {"rad Radians m/m mrad um/mm \xC2\xB5rad nm/mm deg arcseconds", 0},
        {"me a V micrometerss averyveryverylongword", 0},
    };
    assert_true(scan_unit_m("") == 0);
    for (size_t i = 0; i < sizeof units / sizeof *units; i++) {
        struct string_view names = string_view_of(units[i].names);
        for (struct string_view name; cell_next(&names, ' ', &name);)
            if (scan_unit_find(name).si != units[i].si)
                fail_msg("a unit of '%s' is %g, expected %g", units[i].names, scan_unit_find(name).si, units[i].si);
    }
}
