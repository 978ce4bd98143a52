/* SPDX-License-Identifier: GPL-3.0-or-later */
/* X3P and other scans in zip archives. */
#include "zip_support.h"

#define AXIS(name, kind, type, increment, offset)                                                                      \
    "<" name "><AxisType>" kind "</AxisType><DataType>" type "</DataType>" increment offset "</" name ">"
#define INCREMENT(value) "<Increment>" value "</Increment>"
#define OFFSET(value)    "<Offset>" value "</Offset>"
#define MAIN(feature, axes, record3)                                                                                   \
    "\xEF\xBB\xBF<?xml version=\"1.0\"?>\n<!-- x --><p:ISO5436_2 xmlns:p=\"http://www.opengps.eu/2008/ISO5436_2\">"    \
    "<Record1><FeatureType>" feature "</FeatureType><Axes>" axes "</Axes></Record1>"                                   \
    "<Record3>" record3 "</Record3></p:ISO5436_2>\n"
#define MATRIX(x, y, z)                                                                                                \
    "<MatrixDimension><SizeX>" x "</SizeX><SizeY>" y "</SizeY><SizeZ>" z "</SizeZ></MatrixDimension>"
#define GRID AXIS("CX", "I", "D", INCREMENT("0.5E-6"), "") AXIS("CY", "I", "D", INCREMENT("2e-6"), OFFSET("0"))
#define LINK "<DataLink><PointDataLink>bindata/data.bin</PointDataLink></DataLink>"
#define VALID_LINK                                                                                                     \
    "<DataLink><PointDataLink>bindata/data.bin</PointDataLink><ValidPointsLink>valid.bin</ValidPointsLink></DataLink>"

/* The sample's heights as data.bin has them: type letter, integers in steps of 0.125 um; with x in between. */
static struct text points(char type, bool with_x)
{
    struct text text = {0};
    for (size_t i = 0; i < SAMPLE_POINTS; i++) {
        if (with_x)
            put_f64(&text, 0.5e-6 * (double)i);
        if (type == 'D')
            put_f64(&text, sample_um[i] * 1e-6);
        else if (type == 'F')
            put_f32(&text, i == 1 ? INFINITY : sample_um[i] * 1e-6);
        else
            put_bytes(&text, (uint64_t)(int64_t)(sample_um[i] * 8), type == 'I' ? 2 : 4);
    }
    return text;
}

static const struct {
    const char *main, *main_name;
    char type;
    bool with_x, valid;
    enum scan_kind kind;
    size_t missing;
} samples[] = {
    {MAIN("SUR", GRID AXIS("CZ", "A", "D", "", ""), MATRIX("3", "2", "1") LINK), "main.xml", 'D', false, false,
     SCAN_AREAL, SAMPLE_POINTS},
    {MAIN("SUR", GRID AXIS("CZ", "A", "F", "<Increment/>", "<Offset></Offset>"), MATRIX("3", "2", "1") LINK),
     "main.xml", 'F', false, false, SCAN_AREAL, 1},
    {MAIN("SUR", GRID AXIS("CZ", "A", "I", INCREMENT("0.125e-6"), OFFSET("0")), MATRIX("3", "2", "1") VALID_LINK),
     "folder/main.xml", 'I', false, true, SCAN_AREAL, 3},
    {MAIN("PRF",
          AXIS("CX", "A", "D", INCREMENT("1"), OFFSET("0")) AXIS("CY", "I", "D", "", "")
              AXIS("CZ", "A", "L", INCREMENT("0.125e-6"), ""),
          MATRIX("6", "1", "1") LINK),
     "main.xml", 'L', true, false, SCAN_PROFILE, SAMPLE_POINTS},
    {MAIN("PRF", GRID AXIS("CZ", "A", "D", "", ""), "<ListDimension>6</ListDimension>" LINK), "main.xml", 'D', false,
     false, SCAN_PROFILE, SAMPLE_POINTS},
};
enum { X3P_SAMPLES = sizeof samples / sizeof *samples };

static struct text x3p(size_t k, bool deflated)
{
    struct text data = points(samples[k].type, samples[k].with_x);
    bool folder = strchr(samples[k].main_name, '/') != NULL;
    const struct member members[] = {
        {folder ? "folder/bindata/data.bin" : "bindata/data.bin", data.data, data.length},
        {samples[k].main_name, samples[k].main, strlen(samples[k].main)},
        {folder ? "folder/valid.bin" : "valid.bin", "\x37", 1},
        {NULL, NULL, 0},
    };
    struct text text = zip(members, deflated);
    text_free(&data);
    return text;
}

TEST_CASE(test_x3p)
{
    for (size_t k = 0; k < 2 * X3P_SAMPLES; k++)
        expect_sample(x3p(k / 2, k % 2), "x3p", samples[k / 2].kind, samples[k / 2].missing, &no_units);
}

TEST_CASE(test_x3p_list)
{
    static const char map[] =
        MAIN("SUR", GRID AXIS("CZ", "A", "I", INCREMENT("0.125e-6"), OFFSET("0")),
             MATRIX("3", "2", "1") "<DataList><Datum>4</Datum><Datum>-10</Datum>\n<Datum/><Datum> 1 </Datum><Datum>64"
                                   "</Datum><Datum>-28</Datum></DataList>");
    static const char profile[] = MAIN(
        "PRF", AXIS("CX", "A", "D", "", "") AXIS("CZ", "A", "D", INCREMENT("1e-6"), ""),
        MATRIX("6", "1", "1") "<DataList><Datum>0;0.5</Datum><Datum>0.5e-6;-1.25</Datum><Datum>1e-6;2.75</Datum>"
                              "<Datum>1.5e-6;0.125</Datum><Datum>2e-6;8</Datum><Datum>2.5e-6;-3.5</Datum></DataList>");
    const struct member maps[] = {{"main.xml", map, sizeof map - 1}, {NULL, NULL, 0}};
    const struct member profiles[] = {{"main.xml", profile, sizeof profile - 1}, {NULL, NULL, 0}};
    expect_sample(zip(maps, true), "x3p", SCAN_AREAL, 2, &no_units);
    expect_sample(zip(profiles, true), "x3p", SCAN_PROFILE, SAMPLE_POINTS, &no_units);
}

#define CZ AXIS("CZ", "A", "D", "", "")

TEST_CASE(test_x3p_refusals)
{
    static const char *const rows[][2] = {
        {MAIN("PCL", GRID CZ, MATRIX("3", "2", "1") LINK), "feature type 'PCL' is neither profile"},
        {MAIN("SUR", GRID CZ, MATRIX("3", "2", "4") LINK), "3 x 2 x 4 points are no surface of one layer"},
        {MAIN("PRF", GRID CZ, MATRIX("3", "2", "1") LINK), "3 x 2 x 1 points are no profile"},
        {MAIN("SUR", GRID CZ, MATRIX("10000", "10000", "1") LINK), "the file ends after 6"},
        {MAIN("SUR", GRID CZ, MATRIX("x", "2", "1") LINK), "main.xml, line 2: text where a number"},
        {MAIN("SUR", GRID CZ, MATRIX("3", "2", "1") "<DataList><Datum>x</Datum></DataList>"),
         "a <Datum> that is no number"},
        {MAIN("SUR", GRID CZ, MATRIX("3", "2", "1") "<DataList><Datum>1</Datum></DataList>"),
         "the header says 3 x 2 points, the file ends after 1"},
        {MAIN("SUR", GRID AXIS("CZ", "A", "Q", "", ""), MATRIX("3", "2", "1") LINK), "data type 'Q'"},
        {MAIN("SUR", GRID AXIS("CZ", "I", "D", "", ""), MATRIX("3", "2", "1") LINK), "no heights"},
        {MAIN("SUR", AXIS("CX", "A", "D", "", "") CZ, MATRIX("3", "2", "1") LINK), "on a grid"},
        {MAIN("PRF", AXIS("CX", "I", "D", "", "") CZ, MATRIX("3", "1", "1") LINK), "a spacing of nan m is no spacing"},
        {MAIN("SUR", GRID CZ, MATRIX("3", "2", "1") VALID_LINK), "no 'valid.bin' in the archive"},
        {"<x><y></x>", "main.xml, line 1: mismatched tag"},
        {"<!DOCTYPE x [<!ENTITY a \"aaaa\"><!ENTITY b \"&a;&a;\">]><x>&b;</x>",
         "main.xml, line 1: a DOCTYPE; export the scan again"},
        {"<!DOCTYPE x [<!ATTLIST x a CDATA \"1\">]><x/>", "a DOCTYPE"},
        {"<!DOCTYPE x SYSTEM \"x.dtd\"><x/>", "a DOCTYPE"},
    };
    struct text data = points('D', false);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const struct member members[] = {{"main.xml", rows[i][0], strlen(rows[i][0])},
                                         {"bindata/data.bin", data.data, data.length},
                                         {NULL, NULL, 0}};
        refuse_text(zip(members, false), &no_units, rows[i][1]);
    }
    text_free(&data);
}

/* An entry that claims more than deflate can unpack from its bytes. */
TEST_CASE(test_bomb)
{
    char *zeros = support_room(6000);
    const struct member members[] = {{"main.xml", zeros, 6000}, {NULL, NULL, 0}};
    struct text text = zip(members, true);
    static const char size[] = {0x70, 0x17, 0, 0}; /* 6000 */
    for (size_t i = 0; i + 4 < text.length; i++)
        if (memcmp(text.data + i, size, 4) == 0)
            text.data[i + 3] = 0x7f;
    assert_refused_bytes(text_string(&text), text.length, &no_units, "claims 2130712432 bytes, packed in");
    text_free(&text);
}

static const char table[] = "x [um],z [um]\n0,0.5\n0.5,-1.25\n1,2.75\n1.5,0.125\n2,8\n2.5,-3.5\n";

/* Entries whose headers are right, or wrong in one thing. */
TEST_CASE(test_entries)
{
    static const char damaged[] = "'a.csv' in the archive is damaged; copy the file again";
    static const struct {
        bool zip64, fits; /* the checksum is that of the claimed size */
        int longer;
        uint32_t crc;
        unsigned flags, method; /* method 0: its own */
        const char *refused;    /* NULL: it has to be read */
    } rows[] = {
        {.refused = NULL},
        {.zip64 = true},
        {.longer = 1, .refused = damaged},
        {.longer = -1, .refused = damaged},
        {.longer = -1, .fits = true, .refused = damaged},
        {.crc = 0x10000, .refused = damaged},
        {.flags = 1, .refused = "'a.csv' in the archive is encrypted; unpack it"},
        {.method = 12, .refused = "packed by method 12, and only deflate is read; unpack it"},
    };
    for (size_t i = 0; i < 2 * (sizeof rows / sizeof *rows); i++) {
        size_t r = i / 2;
        struct packed member = pack("a.csv", table, sizeof table - 1, i % 2);
        member.zip64 = rows[r].zip64;
        member.size += (size_t)rows[r].longer;
        if (rows[r].fits)
            member.crc = (uint32_t)crc32(0, (const Bytef *)table, (uInt)member.size);
        member.crc ^= rows[r].crc;
        member.flags = rows[r].flags;
        member.method = rows[r].method ? rows[r].method : member.method;
        struct text text = zip_of(&member, 1);
        if (rows[r].refused)
            assert_refused_bytes(text.data, text.length, &no_units, rows[r].refused);
        else
            assert_sample(&text, "text", SCAN_PROFILE, SAMPLE_POINTS, &no_units);
        text_free(&text);
        text_free(&member.bytes);
    }
    struct packed member = pack("a.csv", table, sizeof table - 1, true);
    struct text text = zip_of(&member, 1);
    text.data[0] = 'Q'; /* no local header: and no archive by its first bytes */
    assert_refused_bytes(text.data, text.length, &no_units, "is a binary file of no known format");
    text.data[0] = 'P';
    put_field(&text, "a comment", 9);
    text.data[text.length - 9 - 2] = 9; /* is part of the archive */
    assert_sample(&text, "text", SCAN_PROFILE, SAMPLE_POINTS, &no_units);
    text_free(&text);
    text_free(&member.bytes);
}

/* An archive with a ZIP64 end record; the usual one refers to it. */
static struct text zip64_of(const struct packed *member)
{
    enum { END = 22, START = 16 };
    struct text text = zip_of(member, 1);
    const unsigned char *end = (const unsigned char *)text.data + text.length - END;
    size_t start = end[START] + 256u * end[START + 1], at = text.length - END;
    text.length = at;
    PUT(&text, {0x06064b50, 4}, {44, 8}, {0, 12}, {1, 8}, {1, 8}, {at - start, 8}, {start, 8}, {0x07064b50, 4}, {0, 4},
        {at, 8}, {1, 4}, {0x06054b50, 4}, {0, 4}, {UINT32_MAX, 4}, {UINT64_MAX, 8}, {0, 2});
    return text;
}

TEST_CASE(test_ends)
{
    struct packed member = pack("a.csv", table, sizeof table - 1, true);
    struct text text = zip64_of(&member);
    assert_sample(&text, "text", SCAN_PROFILE, SAMPLE_POINTS, &no_units);
    for (size_t length = 5; length < text.length; length++)
        assert_refused_bytes(text.data, length, &no_units, "damaged zip archive; copy the file again");
    text_free(&text);
    text = zip_of(&member, 1);
    text.data[text.length - 1] = text.data[text.length - 2] = '\xff'; /* the longest comment */
    for (size_t i = 0; i < UINT16_MAX; i++)
        text_add_bytes(&text, " ", 1);
    assert_sample(&text, "text", SCAN_PROFILE, SAMPLE_POINTS, &no_units);
    text_add_bytes(&text, " ", 1);
    assert_refused_bytes(text.data, text.length, &no_units, "damaged zip archive; copy the file again");
    text_free(&text);
    text_free(&member.bytes);
}
