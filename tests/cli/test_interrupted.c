/* OUT is complete or untouched, whatever ends the run. */
#include "cli/process.h"

#include <signal.h>
#include <stdio.h>
#include <sys/resource.h>
#include <time.h>

static void wait_a_little(void)
{
    const struct timespec pause = {.tv_nsec = 5000000};
    nanosleep(&pause, NULL);
}

/** A scene whose run takes seconds: one scan under many names. */
static void write_slow_scene(const char *place)
{
    char *scene = NULL;
    size_t size;
    FILE *file = open_memstream(&scene, &size);
    fputs("tolerance: 1e-12\nsurfaces:\n", file);
    for (int i = 0; i < 3000; i++)
        fprintf(file, "  - {name: s%d, file: a.csv}\n", i);
    assert_int_equal(fclose(file), 0);
    workspace_scan(place, "slow/a.csv", 2000, 1);
    workspace_write(place, "slow/scene.yaml", scene);
    free(scene);
}

/** A good report to be kept: out/slow. */
static void write_report(const char *place)
{
    workspace_scan(place, "good/a.csv", 200, 1);
    struct process process =
        expect_exit(place, 0, "report", "--no-cost", "good", "-o", "out/slow", "-m", "tin", "-e", "plasticity");
    process_free(&process);
}

/** Starts the slow run and sends it `signal_number` while it works. */
static struct process interrupt(const char *place, int signal_number)
{
    struct process_running running = process_start(place, "report", "slow");
    for (int i = 0; i < 2000 && workspace_count(place, ".roughcontact-") == 0; i++)
        wait_a_little();
    wait_a_little();
    assert_true(workspace_count(place, ".roughcontact-") > 0);
    assert_int_equal(kill(running.pid, signal_number), 0);
    return process_end(running);
}

static void test_signals(void **state)
{
    const char *place = *state;
    write_slow_scene(place);
    write_report(place);
    char *before = workspace_digest(place, ".");
    static const int signals[] = {SIGINT, SIGTERM, SIGHUP};
    for (size_t i = 0; i < sizeof signals / sizeof *signals; i++) {
        process_expect_failure(interrupt(place, signals[i]), 4, 1,
                               "roughcontact: stopped by a signal; 'out/slow' is as it was before\n", __FILE__,
                               __LINE__);
        char *after = workspace_digest(place, ".");
        assert_string_equal(before, after);
        free(after);
    }
    free(before);
}

static void test_kill(void **state)
{
    const char *place = *state;
    write_slow_scene(place);
    write_report(place);
    char *before = workspace_digest(place, "out/slow");
    struct process process = interrupt(place, SIGKILL);
    assert_int_equal(process.status, 128 + SIGKILL);
    process_free(&process);
    char *after = workspace_digest(place, "out/slow");
    assert_string_equal(before, after);
    /* what is left behind disturbs no later run */
    process = expect_exit(place, 0, "report", "--no-cost", "good", "-o", "out/slow", "-m", "tin", "-e", "plasticity");
    process_free(&process);
    free(after);
    after = workspace_digest(place, "out/slow");
    assert_string_equal(before, after);
    free(before);
    free(after);
}

static void expect_content(const char *place, const char *path, const char *content)
{
    char *text = workspace_read(place, path);
    assert_string_equal(text, content);
    free(text);
}

/** The user's files in OUT outlive every run, those too that come while one lasts. */
static void test_files_of_the_user(void **state)
{
    const char *place = *state;
    static const char *const files[] = {"out/slow/figures/holiday.svg", "out/slow/data/mine.csv", "out/slow/notes.md"};
    write_report(place);
    for (size_t i = 0; i < 2; i++)
        workspace_write(place, files[i], files[i]);
    char *manifest = workspace_read(place, "out/slow/manifest.txt");
    expect_part(manifest, "\nfigures/6-05.svg\n");
    workspace_write(place, "good/scene.yaml", "models: [multiscale]\neffects: []\n");
    struct process process = expect_exit(place, 0, "report", "--no-cost", "good", "-o", "out/slow");
    process_free(&process);
    char *smaller = workspace_read(place, "out/slow/manifest.txt");
    assert_string_not_equal(manifest, smaller); /* the files that are no longer written are gone */
    for (const char *line = strchr(manifest, '\n') + 1; *line; line = strchr(line, '\n') + 1) {
        char *name, *path;
        assert_true(asprintf(&name, "\n%.*s\n", (int)strcspn(line, "\n"), line) > 0);
        assert_true(asprintf(&path, "out/slow/%.*s", (int)strcspn(line, "\n"), line) > 0);
        assert_int_equal(workspace_has(place, path), strstr(smaller, name) != NULL);
        free(name);
        free(path);
    }
    free(manifest);
    free(smaller);

    workspace_scan(place, "good/b.csv", 20000, 2); /* takes a while */
    struct process_running running = process_start(place, "report", "good", "-o", "out/slow", "--tolerance", "1e-12");
    for (int i = 0; i < 2000 && workspace_count(place, ".roughcontact-") == 0; i++)
        wait_a_little();
    wait_a_little();
    assert_true(workspace_count(place, ".roughcontact-") > 0);
    workspace_write(place, files[2], files[2]);
    process = process_expect(process_end(running), 0, __FILE__, __LINE__);
    process_free(&process);
    for (size_t i = 0; i < sizeof files / sizeof *files; i++)
        expect_content(place, files[i], files[i]);
    assert_int_equal(workspace_count(place, ".roughcontact-"), 0);
    assert_int_equal(workspace_count(place, "slow"), 1); /* no slow.kept-... */
}

/** No room for files: as on a full disk, every write beyond some size fails. */
static void test_no_room(void **state)
{
    const char *place = *state;
    write_report(place);
    workspace_scan(place, "good/b.csv", 200, 2);
    char *before = workspace_digest(place, ".");
    struct rlimit usual, small;
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &usual), 0);
    assert_true(signal(SIGXFSZ, SIG_IGN) != SIG_ERR); /* inherited: write() then fails with EFBIG */
    static const rlim_t sizes[] = {100, 4000, 30000, 100000};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        small = (struct rlimit){sizes[i], usual.rlim_max};
        assert_int_equal(setrlimit(RLIMIT_FSIZE, &small), 0);
        struct process_running running = process_start(place, "report", "--no-cost", "good", "-o", "out/slow");
        assert_int_equal(setrlimit(RLIMIT_FSIZE, &usual), 0);
        process_expect_failure(process_end(running), 4, 1, "roughcontact: ", __FILE__, __LINE__);
        char *after = workspace_digest(place, ".");
        assert_string_equal(before, after);
        free(after);
    }
    free(before);
}

static void test_full_output(void **state)
{
    const char *place = *state;
    workspace_scan(place, "a.csv", 200, 1);
    static const char *const commands[][5] = {
        {PROGRAM, "models"}, {PROGRAM, "materials"},        {PROGRAM, "--help"},
        {PROGRAM, "synth"},  {PROGRAM, "inspect", "a.csv"}, {PROGRAM, "inspect", "--json", "a.csv"},
    };
    for (size_t i = 0; i < sizeof commands / sizeof *commands; i++) {
        process_expect_failure(process_end(process_start_list(place, commands[i], "/dev/full")), 4, 1,
                               "cannot write to standard output: No space left on device", __FILE__, __LINE__);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        workspace_test(test_signals), workspace_test(test_kill),        workspace_test(test_files_of_the_user),
        workspace_test(test_no_room), workspace_test(test_full_output),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
