/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A host lives on whatever allocation of the library's fails: the call says that it is out of memory, keeps nothing of
 * its own, and the next one computes what it would have computed. This program has its own malloc(), which libraries
 * take, too; under AddressSanitizer, which has that, what the library's own objects call is wrapped by the linker. */
#include "cli/process.h"
#include "hard_case.h"
#include "library/roughcontact.h"
#include "scan/zip_support.h"

#include <errno.h>
#include <sys/mman.h>
#include <sys/wait.h>

HARD_CASES("No memory left")

#ifdef __SANITIZE_ADDRESS__
#define MINE(name)   __wrap_##name
#define THEIRS(name) __real_##name
#else
#define MINE(name)   name
#define THEIRS(name) __libc_##name
#endif

void *THEIRS(malloc)(size_t size);
void *THEIRS(calloc)(size_t count, size_t size);
void *THEIRS(realloc)(void *block, size_t size);
void *THEIRS(memalign)(size_t alignment, size_t size);
void THEIRS(free)(void *block);
void *MINE(malloc)(size_t size);
void *MINE(calloc)(size_t count, size_t size);
void *MINE(realloc)(void *block, size_t size);
void *MINE(memalign)(size_t alignment, size_t size);
void MINE(free)(void *block);

enum kind { OTHERS, FFTWS, KINDS };

/** Which allocation fails while `armed`, and what came of the others. */
static struct {
    bool armed, failed, lasting; /* lasting: all that come after it, too */
    enum kind kind;
    long failing, asked[KINDS]; /* of its kind, from 1; 0: none */
    long live;                  /* blocks that were not freed */
} memory;

static bool fails(enum kind kind)
{
    if (!memory.armed)
        return false;
    memory.asked[kind]++;
    bool hit = kind == memory.kind && memory.asked[kind] == memory.failing;
    if (hit || (memory.failed && memory.lasting)) {
        memory.failed = true;
        errno = ENOMEM;
        return true;
    }
    memory.live++;
    return false;
}

void *MINE(malloc)(size_t size)
{
    return fails(OTHERS) ? NULL : THEIRS(malloc)(size);
}

void *MINE(calloc)(size_t count, size_t size)
{
    return fails(OTHERS) ? NULL : THEIRS(calloc)(count, size);
}

void *MINE(realloc)(void *block, size_t size)
{
    if (fails(OTHERS))
        return NULL;
    memory.live -= memory.armed && block;
    return THEIRS(realloc)(block, size);
}

/** FFTW's alone. */
void *MINE(memalign)(size_t alignment, size_t size)
{
    return fails(FFTWS) ? NULL : THEIRS(memalign)(alignment, size);
}

void MINE(free)(void *block)
{
    memory.live -= memory.armed && block;
    THEIRS(free)(block);
}

/** One use of the library: a scan as a file or as bytes, and models of it. */
struct use {
    const char *path, *bytes;
    size_t length;
    const char *models[4];
    double lambda_s_m;
    bool zip; /* of which libzip loses blocks of its own where one of them fails */
    long asked[KINDS];
    char answer[1024]; /* every number that came of it */
    struct roughcontact_status status;
};

static int ask(struct use *use, const struct roughcontact_surface *surface, const struct roughcontact_material *tin,
               const char *model)
{
    static const double loads[] = {1e-5, 1e-3, 2e-2};
    struct roughcontact_run_options how;
    struct roughcontact_curve *curve;
    roughcontact_run_options_init(&how);
    how.material = tin;
    int code = roughcontact_run(&curve, surface, model, loads, 3, &how, &use->status);
    for (size_t i = 0; code == ROUGHCONTACT_OK && i < 3; i++) {
        const struct roughcontact_point *point = roughcontact_curve_point(curve, i);
        size_t at = strlen(use->answer);
        snprintf(use->answer + at, sizeof use->answer - at, " %a %a", point->area_ratio, point->ecr_ohm_m2);
    }
    assert_true(code == ROUGHCONTACT_OK || !curve);
    roughcontact_curve_free(curve);
    return code;
}

/** From the scan to the curves; the code of what failed first. All that it gets it gives back. */
static int run(struct use *use)
{
    struct roughcontact_scan *scan = NULL;
    struct roughcontact_surface *surface = NULL;
    struct roughcontact_material *tin = NULL;
    struct roughcontact_surface_options options;
    roughcontact_surface_options_init(&options);
    options.lambda_s_m = use->lambda_s_m;
    use->answer[0] = '\0';
    int code = use->path ? roughcontact_scan_read_file(&scan, use->path, NULL, &use->status)
                         : roughcontact_scan_read_bytes(&scan, use->bytes, use->length, "scan", NULL, &use->status);
    if (code == ROUGHCONTACT_OK)
        code = roughcontact_surface_make(&surface, scan, &options, &use->status);
    if (code == ROUGHCONTACT_OK)
        code = roughcontact_material_new(&tin, "tin", &use->status);
    if (code == ROUGHCONTACT_OK)
        snprintf(use->answer, sizeof use->answer, "%a %a", roughcontact_surface_roughness(surface)->rq_m,
                 roughcontact_surface_power_law(surface)->gamma);
    for (size_t m = 0; code == ROUGHCONTACT_OK && use->models[m]; m++)
        code = ask(use, surface, tin, use->models[m]);
    roughcontact_scan_free(scan);
    roughcontact_surface_free(surface);
    roughcontact_material_free(tin);
    return code;
}

/** Arms, runs, and says what came of it. */
static int run_armed(struct use *use, enum kind kind, long failing, bool lasting)
{
    memset(&memory, 0, sizeof memory);
    memory.kind = kind;
    memory.failing = failing;
    memory.lasting = lasting;
    memory.armed = true;
    int code = run(use);
    memory.armed = false;
    memcpy(use->asked, memory.asked, sizeof use->asked);
    return code;
}

/** What is wrong with the end of such a run, and with the next one; NULL: nothing. With that allocation failing there
 * is an error that says so, or, where what is not needed failed, the same answer. What FFTW has got when it is left is
 * lost. */
static const char *check(struct use *use, const char *answer, enum kind kind, long failing, bool lasting)
{
    if (kind == OTHERS) /* what FFTW keeps for good it then has */
        (void)run(use);
    int code = run_armed(use, kind, failing, lasting);
    bool said = strstr(use->status.message, "out of memory") || strstr(use->status.message, "Cannot allocate memory");
    if (code == ROUGHCONTACT_OK ? strcmp(use->answer, answer) != 0
                                : !said || (code != ROUGHCONTACT_MEMORY && code != ROUGHCONTACT_IO))
        return use->status.message;
    if (memory.live > 0 && kind == OTHERS && !lasting && !use->zip)
        return "blocks are left";
    return run(use) == ROUGHCONTACT_OK && strcmp(use->answer, answer) == 0 ? NULL : "the next answer is another";
}

/** The same in a process of its own, in which FFTW knows nothing yet. */
static void expect_survived(struct use *use, const char *answer, enum kind kind, long failing, bool lasting)
{
    int status;
    pid_t child = fork();
    if (child == 0) {
        const char *wrong = check(use, answer, kind, failing, lasting);
        if (wrong)
            fprintf(stderr, "%s: %s\n", wrong, use->answer);
        _exit(wrong ? 1 : 0);
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    hard_case("each allocation fails, alone and with all after it", "a crash in the host, or memory that is lost",
              "the call says out of memory; the next one computes what it would have", "hosts that did not survive",
              status != 0, 0);
    if (status != 0)
        fail_msg("allocation %ld of %s%s: status %d", failing, kind == FFTWS ? "FFTW" : "others",
                 lasting ? " and all after it" : "", status);
}

/** Every allocation fails, of FFTW's thousands every `stride`th, alone and with all after it. */
static void expect_survives(const struct use *given, long stride)
{
    char answer[sizeof given->answer];
    long step[KINDS] = {1, getenv("ROUGHCONTACT_SLOW_TESTS") ? 1 : stride};
    struct use *use = mmap(NULL, sizeof *use, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    assert_true(use != MAP_FAILED);
    *use = *given;
    pid_t child = fork();
    if (child == 0)
        _exit(run_armed(use, OTHERS, 0, false));
    assert_int_equal(waitpid(child, &(int){0}, 0), child);
    long asked[KINDS] = {use->asked[OTHERS], use->asked[FFTWS]};
    strcpy(answer, use->answer);
    assert_true(*answer && asked[OTHERS] > 10);
    print_message("%ld of FFTW's allocations, %ld others\n", asked[FFTWS], asked[OTHERS]);
    for (int kind = 0; kind < KINDS; kind++)
        for (long n = 1; n <= asked[kind]; n += step[kind])
            for (int lasting = 0; lasting < 2; lasting++)
                expect_survived(use, answer, (enum kind)kind, n, lasting);
    munmap(use, sizeof *use);
}

TEST_IN_WORKSPACE(a_host_survives_every_failing_allocation)
{
    char path[512];
    workspace_scan(place, "a.csv", 128, 3);
    snprintf(path, sizeof path, "%s/a.csv", place);
    struct use plain = {.path = path, .models = {"multiscale-plastic", "jg"}},
               strip = {.path = path, .models = {"corrected-persson-plastic", "strip", "gw"}, .lambda_s_m = 4e-6};
    expect_survives(&plain, 397);
    expect_survives(&strip, 797);
}

/** Bluestein's and Rader's transforms, of lengths that are prime, allocate whenever they run. */
TEST_IN_WORKSPACE(transforms_may_find_no_memory_either)
{
    char path[512];
    workspace_scan(place, "a.csv", 127, 3);
    snprintf(path, sizeof path, "%s/a.csv", place);
    struct use use = {.path = path, .models = {"strip"}};
    expect_survives(&use, 797);
}

TEST_IN_WORKSPACE(so_do_readers_of_what_is_packed)
{
    workspace_scan(place, "a.csv", 60, 3);
    char *csv = workspace_read(place, "a.csv");
    struct packed members[] = {pack("one.csv", csv, strlen(csv), true), pack("two.csv", csv, strlen(csv), true)};
    struct text packed[] = {zip_of(members, 2), gzip(csv, strlen(csv))};
    for (size_t i = 0; i < 2; i++) {
        struct use use = {.bytes = packed[i].data, .length = packed[i].length, .zip = i == 0};
        expect_survives(&use, 397);
        text_free(&packed[i]);
        text_free(&members[i].bytes);
    }
}
