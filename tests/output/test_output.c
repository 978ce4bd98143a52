#include "output/output.h"
#include "results/directory.h"

static int place_setup(void **state)
{
    static struct directory place;
    place = directory_make();
    *state = &place;
    return 0;
}

static int place_teardown(void **state)
{
    directory_remove(*state);
    return 0;
}

static struct output begin(const struct directory *place, const char *target)
{
    struct output output;
    struct status status = {0};
    if (output_begin(&output, directory_path(place, target), &status) != STATUS_OK)
        fail_msg("%s", status.message);
    return output;
}

/* Writes a one-word report into the staging directory. */
static void fill(const struct output *output, const char *word)
{
    static const char *const files[] = {"report.md", "report.html", "results.json", "data/contact.csv",
                                        "figures/6-05.svg"};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        struct text path = {0};
        struct status status = {0};
        text_add(&path, "%s/%s", output->staging, files[i]);
        assert_int_equal(text_write_file(text_string(&path), word, strlen(word), &status), STATUS_OK);
        text_free(&path);
    }
}

static void commit(struct output *output)
{
    struct status status = {0};
    if (output_commit(output, &status) != STATUS_OK)
        fail_msg("%s", status.message);
    output_abandon(output); /* has nothing left to do, as in a run */
}

static void assert_report(const struct directory *place, const char *target, const char *word)
{
    char name[256];
    static const char *const files[] = {"report.md", "data/contact.csv", "figures/6-05.svg"};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        snprintf(name, sizeof name, "%s/%s", target, files[i]);
        struct text text = directory_read(place, name);
        assert_string_equal(text_string(&text), word);
        text_free(&text);
    }
    assert_int_equal(directory_entries(place, target), 5);
}

static void assert_refused(const struct directory *place, const char *target, const char *words)
{
    struct output output;
    struct status status = {0};
    assert_int_equal(output_begin(&output, directory_path(place, target), &status), STATUS_IO);
    if (!strstr(status.message, words))
        fail_msg("'%s' without '%s'", status.message, words);
    output_abandon(&output);
}

static void test_a_first_report_appears_at_once(void **state)
{
    struct output output = begin(*state, "out");
    fill(&output, "one");
    assert_false(directory_has(*state, "out"));
    commit(&output);
    assert_report(*state, "out", "one");
    assert_int_equal(directory_entries(*state, ""), 1);
}

static void test_a_report_takes_the_place_of_the_one_before(void **state)
{
    for (int k = 0; k < 3; k++) {
        const char *words[] = {"one", "two", "three"};
        struct output output = begin(*state, "out");
        fill(&output, words[k]);
        if (k > 0)
            assert_report(*state, "out", words[k - 1]);
        commit(&output);
        assert_report(*state, "out", words[k]);
    }
    assert_int_equal(directory_entries(*state, ""), 1);
}

static void test_an_abandoned_run_leaves_the_report_before(void **state)
{
    struct output output = begin(*state, "out");
    fill(&output, "one");
    commit(&output);
    output = begin(*state, "out");
    fill(&output, "half a report");
    output_abandon(&output);
    assert_string_equal(output.staging, "");
    output_abandon(&output); /* twice is once */
    assert_report(*state, "out", "one");
    assert_int_equal(directory_entries(*state, ""), 1);

    output = begin(*state, "other");
    output_abandon(&output);
    assert_int_equal(directory_entries(*state, ""), 1);
}

/* Nothing of an earlier, larger report stays behind in a smaller one. */
static void test_files_of_the_report_before_do_not_survive(void **state)
{
    const struct directory *place = *state;
    struct output output = begin(place, "out");
    fill(&output, "one");
    commit(&output);
    directory_write(place, "out/figures/6-30.svg", "old");
    output = begin(place, "out");
    fill(&output, "two");
    commit(&output);
    assert_false(directory_has(place, "out/figures/6-30.svg"));
    assert_report(place, "out", "two");
}

static void test_an_empty_directory_may_be_the_target(void **state)
{
    const struct directory *place = *state;
    assert_int_equal(mkdir(directory_path(place, "out"), 0777), 0);
    directory_write(place, "out/.gitkeep", "");
    struct output output = begin(place, "out///");
    fill(&output, "one");
    commit(&output);
    assert_report(place, "out", "one");
    assert_int_equal(directory_entries(place, ""), 1);
}

static void test_missing_parents_are_made(void **state)
{
    struct output output = begin(*state, "a/b/c/out");
    fill(&output, "one");
    commit(&output);
    assert_report(*state, "a/b/c/out", "one");
    assert_int_equal(directory_entries(*state, "a/b/c"), 1);
}

static void test_a_file_of_the_user_is_never_replaced(void **state)
{
    const struct directory *place = *state;
    assert_int_equal(mkdir(directory_path(place, "out"), 0777), 0);
    directory_write(place, "out/report.md", "mine?");
    directory_write(place, "out/thesis.tex", "mine");
    assert_refused(place, "out", "holds 'thesis.tex', which is not part of a report");
    assert_refused(place, "out", "-o");
    struct text text = directory_read(place, "out/thesis.tex");
    assert_string_equal(text_string(&text), "mine");
    text_free(&text);
    assert_int_equal(directory_entries(place, "out"), 2);
    assert_int_equal(directory_entries(place, ""), 1);
}

/* Files in the way, which stop root too. */
static void test_a_target_that_cannot_be_written_is_named(void **state)
{
    const struct directory *place = *state;
    directory_write(place, "file", "mine");
    assert_refused(place, "file", "Not a directory");
    assert_refused(place, "file/out", "Not a directory");
    assert_refused(place, "file/a/b/out", "file");
    assert_int_equal(symlink("nowhere/at/all", directory_path(place, "link")), 0);
    assert_refused(place, "link/out", "link");
    struct text text = directory_read(place, "file");
    assert_string_equal(text_string(&text), "mine");
    text_free(&text);
    assert_int_equal(directory_entries(place, ""), 2);
}

static void test_a_name_that_is_too_long_is_refused(void **state)
{
    char name[PATH_MAX];
    struct output output;
    struct status status = {0};
    (void)state;
    memset(name, 'x', sizeof name - 1);
    name[sizeof name - 1] = '\0';
    assert_int_equal(output_begin(&output, name, &status), STATUS_IO);
    assert_non_null(strstr(status.message, "too long"));
    output_abandon(&output);
}

/* As the user's umask has it, not as mkdtemp leaves it. */
static void test_the_report_can_be_read_by_whom_the_umask_allows(void **state)
{
    const struct directory *place = *state;
    static const mode_t masks[] = {022, 077, 0};
    mode_t before = umask(0);
    for (size_t i = 0; i < sizeof masks / sizeof *masks; i++) {
        struct stat info;
        umask(masks[i]);
        struct output output = begin(place, "out");
        fill(&output, "one");
        commit(&output);
        assert_int_equal(stat(directory_path(place, "out"), &info), 0);
        assert_int_equal(info.st_mode & 0777, 0777 & ~masks[i]);
        assert_int_equal(stat(directory_path(place, "out/data"), &info), 0);
        assert_int_equal(info.st_mode & 0777, 0777 & ~masks[i]);
    }
    umask(before);
}

/* The directory around the target is moved away while the report is being made. */
static void test_a_commit_that_fails_keeps_what_stands_there(void **state)
{
    const struct directory *place = *state;
    struct output output = begin(place, "a/out");
    struct status status = {0};
    fill(&output, "one");
    assert_int_equal(rename(directory_path(place, "a"), directory_path(place, "b")), 0);
    assert_int_equal(output_commit(&output, &status), STATUS_IO);
    assert_non_null(strstr(status.message, "a/out"));
    assert_int_equal(rename(directory_path(place, "b"), directory_path(place, "a")), 0);
    output_abandon(&output);
    assert_false(directory_has(place, "a")); /* made for the report, so it goes with it */
}

int main(void)
{
#define TEST(function) cmocka_unit_test_setup_teardown(function, place_setup, place_teardown)
    const struct CMUnitTest tests[] = {
        TEST(test_a_first_report_appears_at_once),
        TEST(test_a_report_takes_the_place_of_the_one_before),
        TEST(test_an_abandoned_run_leaves_the_report_before),
        TEST(test_files_of_the_report_before_do_not_survive),
        TEST(test_an_empty_directory_may_be_the_target),
        TEST(test_missing_parents_are_made),
        TEST(test_a_file_of_the_user_is_never_replaced),
        TEST(test_a_target_that_cannot_be_written_is_named),
        TEST(test_a_name_that_is_too_long_is_refused),
        TEST(test_the_report_can_be_read_by_whom_the_umask_allows),
        TEST(test_a_commit_that_fails_keeps_what_stands_there),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
