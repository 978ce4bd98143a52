/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Small files that unpack to gigabytes or announce them, and entries of a directory that are no files: the program
 * refuses each within little memory and processor time. */
#include "base/limits.h"
#include "cli/process.h"
#include "hard_case.h"
#include "scan/zip_support.h"

#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/un.h>

HARD_CASES("Small files that would fill a memory")

#ifdef __SANITIZE_ADDRESS__
static const rlim_t memory = RLIM_INFINITY; /* the sanitizer's shadow is larger than any limit */
#else
static const rlim_t memory = 512 << 20;
#endif
static const rlim_t seconds = 60;

static rlim_t set_limit(__rlimit_resource_t resource, rlim_t value)
{
    struct rlimit limit;
    assert_int_equal(getrlimit(resource, &limit), 0);
    rlim_t before = limit.rlim_cur;
    limit.rlim_cur = value < limit.rlim_max ? value : limit.rlim_max;
    assert_int_equal(setrlimit(resource, &limit), 0);
    return before;
}

/* Runs the program with little memory and time. */
static struct process run_bounded(const char *place, const char *const *arguments)
{
    rlim_t own_memory = set_limit(RLIMIT_AS, memory), own_seconds = set_limit(RLIMIT_CPU, seconds);
    struct process_running running = process_start_list(place, arguments, NULL);
    set_limit(RLIMIT_AS, own_memory);
    set_limit(RLIMIT_CPU, own_seconds);
    return process_end(running);
}

#define RUN(place, ...) run_bounded((place), (const char *const[]){PROGRAM, __VA_ARGS__, NULL})

/* The largest memory that any program had so far [MB]; not known where a sanitizer has its own. */
static double megabytes(void)
{
    struct rusage used;
    assert_int_equal(getrusage(RUSAGE_CHILDREN, &used), 0);
    return memory == RLIM_INFINITY ? 0 : (double)used.ru_maxrss / 1000;
}

/* Writes the bytes to a file, which `inspect` has to refuse with one line that holds `message`. Frees them. */
static void expect_refused(const char *place, struct text *text, const char *message)
{
    workspace_write_bytes(place, "hostile", text_string(text), text->length);
    text_free(text);
    expect_failed(RUN(place, "inspect", "--x-unit", "um", "--z-unit", "um", "hostile"), 4, 1, message);
}

static const char *limit_message(enum limit limit)
{
    return filled("%s", limit_words(limit).text);
}

/* 64 entries of an archive that are one stream of 4 MiB; and a stored entry that holds the whole of the next. */
TEST_IN_WORKSPACE(test_shared_streams)
{
    enum { ENTRIES = 64, SIZE = 4 << 20 };
    char *zeros = support_room(SIZE);
    struct packed all[ENTRIES];
    all[0] = pack("a.csv", zeros, SIZE, true);
    for (size_t i = 1; i < ENTRIES; i++) {
        all[i] = all[0];
        all[i].at = 0;
    }
    struct text text = zip_of(all, ENTRIES);
    expect_refused(place, &text, "entries of the archive share their bytes");
    struct packed inner = pack("b.csv", zeros, SIZE, true);
    struct text archive = zip_of(&inner, 1);
    size_t local = 30 + strlen("b.csv") + inner.bytes.length;
    struct packed two[2] = {pack("c.csv", archive.data, local, false), inner};
    two[1].at = 30 + strlen("c.csv");
    text = zip_of(two, 2);
    expect_refused(place, &text, "entries of the archive share their bytes");
    hard_case("an archive whose 64 entries are one stream, or one within the other", "each is unpacked: 256 MB of 4 kB",
              "refused: they share their bytes", "memory, MB", megabytes(), 512);
    text_free(&archive);
    text_free(&two[0].bytes);
    text_free(&inner.bytes);
    text_free(&all[0].bytes);
}

static void put_sur_header(struct text *text, uint32_t nx, uint32_t ny)
{
    put_field(text, "DSCOMPRESSED", 12);
    put_bytes(text, 0, 2);
    put_bytes(text, 1, 2);
    put_bytes(text, 1, 2);
    put_bytes(text, 2, 2); /* a surface */
    put_field(text, "", 30 + 30 + 6 + 2 + 10);
    put_bytes(text, 16, 2); /* bits */
    put_field(text, "", 8);
    put_bytes(text, nx, 4);
    put_bytes(text, ny, 4);
    put_field(text, "", 4);
    for (size_t i = 0; i < 3; i++)
        put_f32(text, 1);
    put_field(text, "", 3 * 16);
    for (size_t i = 0; i < 3; i++)
        put_field(text, "um", 16);
    put_field(text, "", 512 - text->length);
}

/* A megabyte of compressed heights: more points than may be, and a gigabyte behind a header of six. */
TEST_IN_WORKSPACE(test_expanding)
{
    char *zeros = support_room(1 << 20);
    for (int few = 0; few < 2; few++) {
        struct text text = {0};
        put_sur_header(&text, few ? 3 : 32768, few ? 2 : 16384);
        put_bytes(&text, 1, 4);
        put_bytes(&text, 1 << 30, 4);
        put_bytes(&text, 1 << 20, 4);
        text_add_bytes(&text, zeros, 1 << 20);
        expect_refused(place, &text,
                       few ? "compressed streams longer than the file can hold" : limit_message(LIMIT_POINTS));
    }
    hard_case("compressed heights: a gigabyte behind a header of six points", "a gigabyte is unpacked",
              "refused: longer than the file can hold", "memory, MB", megabytes(), 512);
}

/* Heights and then as many zeros as say, deflated. */
static struct text deflated_with_zeros(const struct text *heights, size_t zeros)
{
    static Bytef piece[1 << 20];
    struct text text = {0};
    Bytef out[65536];
    z_stream stream = {.next_in = (Bytef *)heights->data, .avail_in = (uInt)heights->length};
    assert_int_equal(deflateInit2(&stream, 1, Z_DEFLATED, -15, 8, Z_DEFAULT_STRATEGY), Z_OK);
    for (int code = Z_OK; code == Z_OK;) {
        if (stream.avail_in == 0 && zeros > 0) {
            stream.next_in = piece;
            stream.avail_in = zeros < sizeof piece ? (uInt)zeros : (uInt)sizeof piece;
            zeros -= stream.avail_in;
        }
        stream.next_out = out;
        stream.avail_out = sizeof out;
        code = deflate(&stream, zeros == 0 ? Z_FINISH : Z_NO_FLUSH);
        text_add_bytes(&text, (const char *)out, sizeof out - stream.avail_out);
    }
    deflateEnd(&stream);
    return text;
}

/* Of a file of points only as many are unpacked as main.xml announces, though it holds 4 MB; 600 MB are refused. */
TEST_IN_WORKSPACE(test_points_as_announced)
{
    enum { POINTS = 4096, FEW = 4 << 20, ZEROS = 600 << 20 };
    static const char main[] =
        "<p><Record1><FeatureType>PRF</FeatureType><Axes><CX><AxisType>I</AxisType><Increment>1e-6</Increment></CX>"
        "<CZ><AxisType>A</AxisType><DataType>D</DataType></CZ></Axes></Record1><Record3><MatrixDimension>"
        "<SizeX>4096</SizeX><SizeY>1</SizeY></MatrixDimension>"
        "<DataLink><PointDataLink>d</PointDataLink></DataLink></Record3></p>";
    struct text *heights = support_text();
    for (size_t i = 0; i < POINTS; i++)
        put_f64(heights, 1e-6 * (double)(i * i % 101));
    for (int few = 0; few < 2; few++) {
        size_t zeros = few ? FEW : ZEROS;
        struct packed members[2] = {pack("main.xml", main, sizeof main - 1, true),
                                    {.name = "d",
                                     .bytes = deflated_with_zeros(heights, zeros),
                                     .method = 8,
                                     .size = heights->length + zeros,
                                     .at = SIZE_MAX}};
        struct text text = zip_of(members, 2);
        workspace_write_bytes(place, "a.x3p", text.data, text.length);
        text_free(&text);
        if (few)
            expect_output(expect_status(RUN(place, "inspect", "a.x3p"), 0), "4096");
        else
            expect_failed(RUN(place, "inspect", "a.x3p"), 4, 1, limit_message(LIMIT_UNPACKED_RATIO));
        text_free(&members[0].bytes);
        text_free(&members[1].bytes);
    }
    hard_case("600 MB of zeros deflated behind 4096 points", "all is unpacked to see what it is",
              "no more than the header announces; refused beyond 100 times the packed size", "memory, MB", megabytes(),
              512);
}

/* Headers that announce more points than any file holds. */
TEST_IN_WORKSPACE(test_lying_headers)
{
    static const char *const texts[] = {
        "aISO-1.0\nNumPoints=1844674407370955160\nNumProfiles=1844674407370955160\nXscale=1\nYscale=1\nZscale=1\n*"
        "\n1 2 "
        "3\n",
        "aISO-1.0\nNumPoints=4000000000\nNumProfiles=4000000000\nXscale=1\nYscale=1\nZscale=1\n*\n1 2 3\n",
        "1 2\nx\nCX M 1e12 MM 1 D\nCZ M 1e12 MM 1 D\nEOR\nSPACING CX 1\nEOR\n1\n2\n3\nEOR\nEOF\n",
        "ISO 5436\n-\nCX I 1844674407370955160 um 1 D 1\nCZ A 1844674407370955160 um 1 D\n\003r\003 1 2 3\003",
        "<DATAFILE><UNITS>um</UNITS><NUMPOINTS>99999999999999</NUMPOINTS><SPACING>1</SPACING><DATA_POINT_VALUES>1\n2\n3"
        "</DATA_POINT_VALUES></DATAFILE>",
        "[PROFILE_HEADER]\nNO_POINTS=99999999999999\n[PROFILE_VALUES]\n0=1 2 3\n",
        "DSAA\n4294967295 4294967295\n0 1\n0 1\n0 1\n1 2 3\n",
        "Gwyddion Simple Field 1.0\nXRes=1844674407370955160\nYRes=9\nXReal=1\nYReal=1\n",
    };
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        struct text text = {0};
        text_add_bytes(&text, texts[i], strlen(texts[i]) + 1);
        expect_refused(place, &text, "points");
    }
    hard_case("eight headers that announce 10^9 to 10^37 points", "products that wrap around, and memory for them",
              "refused by what the file can hold", "memory, MB", megabytes(), 512);
}

/* A file larger than may be, of which nothing is read; and standard input that never ends. */
TEST_IN_WORKSPACE(test_endless_input)
{
    workspace_write(place, "large.csv", "1 2\n");
    assert_int_equal(truncate(directory_path(place, "large.csv"), (off_t)limit_most(LIMIT_FILE_BYTES) + 1), 0);
    expect_failed(RUN(place, "inspect", "large.csv"), 4, 1, limit_message(LIMIT_FILE_BYTES));
    if (memory == RLIM_INFINITY) {
        print_message("skipped: no limit of the memory here\n");
        skip();
    }
    const char *const arguments[] = {"/bin/sh", "-c", "exec " PROGRAM " inspect - </dev/zero", NULL};
    expect_failed(run_bounded(place, arguments), 4, 1, "out of memory");
}

static void make_socket(const char *place, const char *name)
{
    struct sockaddr_un address = {.sun_family = AF_UNIX};
    int descriptor = socket(AF_UNIX, SOCK_STREAM, 0);
    assert_true(descriptor >= 0);
    assert_true((size_t)snprintf(address.sun_path, sizeof address.sun_path, "%s/%s", place, name) <
                sizeof address.sun_path);
    assert_int_equal(bind(descriptor, (const struct sockaddr *)&address, sizeof address), 0);
    close(descriptor);
}

/* The limit of measured rows holds for all files of a scene together. */
TEST_IN_WORKSPACE(test_measured_again_and_again)
{
    struct text *rows = support_text();
    text_add(rows, "F (N),R (mOhm)\n");
    while (rows->length < 4 * 60000)
        text_add(rows, "1,2\n");
    workspace_write(place, "d/ecr.txt", text_string(rows));
    workspace_scans(place, "d", 2, 200, 1);
    workspace_write(place, "d/scene.yaml",
                    "material: tin\nnominal_area: 1 mm2\nsurfaces:\n"
                    "  - {name: a, file: a.csv, measured: {file: ecr.txt, quantity: ecr}}\n"
                    "  - {name: b, file: b.csv, measured: {file: ecr.txt, quantity: ecr}}\n");
    struct process process = RUN(place, "report", "d");
    assert_int_equal(process.status, 3);
    expect_part(process.err, "too many rows of all that was measured");
}

/* A directory with pipes, sockets, devices, circular links, and folders nested a thousand deep. */
TEST_IN_WORKSPACE(test_no_files)
{
    static const char *const links[][2] = {{"zero.csv", "/dev/zero"},
                                           {"terminal.csv", "/dev/tty"},
                                           {"self.csv", "self.csv"},
                                           {"circle", "."},
                                           {"up", ".."}};
    static const char *const folders[] = {"d", "d/s"};
    char path[4096];
    workspace_scan(place, "d/a.csv", 200, 1);
    workspace_scan(place, "d/s/b.csv", 200, 2);
    for (size_t i = 0; i < 2; i++) {
        const char *folder = folders[i];
        assert_int_equal(mkfifo(directory_path(place, filled("%s/pipe.csv", folder)), 0666), 0);
        assert_int_equal(mkfifo(directory_path(place, filled("%s/a.txt", folder)), 0666), 0);
        make_socket(place, filled("%s/socket.csv", folder));
        for (size_t l = 0; l < sizeof links / sizeof *links; l++)
            assert_int_equal(symlink(links[l][1], directory_path(place, filled("%s/%s", folder, links[l][0]))), 0);
    }
    snprintf(path, sizeof path, "%s/d/deep", place);
    for (size_t depth = 0; depth < 1000; depth++) {
        assert_true(strlen(path) + 3 < sizeof path);
        assert_int_equal(mkdir(path, 0777), 0);
        strcat(path, "/d");
    }
    alarm(250); /* a pipe that is opened would keep everybody waiting */
    struct process process = expect_status(RUN(place, "inspect", "d"), 0);
    expect_parts(process.out, "d/a.csv", "b.csv");
    expect_no_parts(process.out, "pipe", "zero");
    process = expect_status(RUN(place, "plan", "d"), 0);
    static const char *const none[] = {"d/pipe.csv", "d/socket.csv", "d/zero.csv"};
    for (size_t i = 0; i < 3; i++) {
        struct process opened = RUN(place, "inspect", none[i]);
        hard_case("pipes, sockets, /dev/zero, links in circles, a thousand folders in folders", "it waits for ever",
                  "passed over; refused where named", "read as scans", opened.status != 4, 0);
        expect_failed(RUN(place, "inspect", none[i]), 4, 1, "is no regular file");
    }
    expect_failed(RUN(place, "inspect", "d/self.csv"), 4, 1, "Too many levels of symbolic links");
    workspace_write(place, "d/scene.yaml", "material: tin\nsurfaces:\n  - {name: p, file: pipe.csv}\n");
    expect_failed(RUN(place, "plan", "d"), 3, 1, "'pipe.csv' is no regular file");
    alarm(0);
}
