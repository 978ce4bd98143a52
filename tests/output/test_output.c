/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "directory.h"
#include "output/output.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <sys/xattr.h>

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

static pid_t divide(void)
{
    pid_t child = fork();
    assert_true(child >= 0);
    return child;
}

/* Waits for a process that exits with 0, or 77 for what is not possible here. */
static void expect_done(pid_t child)
{
    int how;
    assert_int_equal(waitpid(child, &how, 0), child);
    assert_true(WIFEXITED(how));
    if (WEXITSTATUS(how) == 77)
        skip();
    assert_int_equal(WEXITSTATUS(how), 0);
}

static void begin(struct output *output, const struct directory *place, const char *target)
{
    struct status status = {0};
    if (output_begin(output, directory_path(place, target), &status) != STATUS_OK)
        fail_msg("%s", status.message);
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
    assert_string_equal(output->staging, "");
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
    assert_int_equal(directory_entries(place, target), 6);
}

/* Puts the report `word` at `target`. */
static void publish(const struct directory *place, const char *target, const char *word)
{
    struct output output;
    begin(&output, place, target);
    fill(&output, word);
    commit(&output);
}

static void assert_content(const struct directory *place, const char *name, const char *content)
{
    struct text text = directory_read(place, name);
    assert_string_equal(text_string(&text), content);
    text_free(&text);
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

static void test_a_report_takes_the_place_of_the_one_before(void **state)
{
    for (int k = 0; k < 3; k++) {
        const char *words[] = {"one", "two", "three"};
        struct output output;
        begin(&output, *state, "out");
        fill(&output, words[k]);
        if (k > 0)
            assert_report(*state, "out", words[k - 1]);
        else
            assert_false(directory_has(*state, "out"));
        commit(&output);
        assert_report(*state, "out", words[k]);
    }
    assert_int_equal(directory_entries(*state, ""), 1);
}

static void test_an_abandoned_run_leaves_the_report_before(void **state)
{
    struct output output;
    begin(&output, *state, "out");
    fill(&output, "one");
    commit(&output);
    begin(&output, *state, "out");
    fill(&output, "half a report");
    output_abandon(&output);
    assert_string_equal(output.staging, "");
    output_abandon(&output); /* twice is once */
    assert_report(*state, "out", "one");
    assert_int_equal(directory_entries(*state, ""), 1);

    begin(&output, *state, "other");
    output_abandon(&output);
    assert_int_equal(directory_entries(*state, ""), 1);
}

/* Nothing of an earlier, larger report stays behind in a smaller one. */
static void test_files_of_the_report_before_do_not_survive(void **state)
{
    const struct directory *place = *state;
    struct output output;
    begin(&output, place, "out");
    fill(&output, "one");
    struct text path = {0};
    struct status status = {0};
    text_add(&path, "%s/figures/6-30.svg", output.staging);
    assert_int_equal(text_write_file(text_string(&path), "old", 3, &status), STATUS_OK);
    text_free(&path);
    commit(&output);
    assert_true(directory_has(place, "out/figures/6-30.svg"));
    publish(place, "out", "two");
    assert_false(directory_has(place, "out/figures/6-30.svg"));
    assert_report(place, "out", "two");
    assert_int_equal(directory_entries(place, ""), 1);
}

static void test_the_manifest_names_each_file(void **state)
{
    publish(*state, "out", "one");
    assert_content(*state, "out/manifest.txt",
                   OUTPUT_MANIFEST_HEADER
                   "manifest.txt\nreport.html\nreport.md\nresults.json\ndata/contact.csv\nfigures/6-05.svg\n");
}

static void test_an_empty_directory_may_be_the_target(void **state)
{
    const struct directory *place = *state;
    assert_int_equal(mkdir(directory_path(place, "out"), 0777), 0);
    directory_write(place, "out/.gitkeep", "kept");
    publish(place, "out///", "one");
    assert_content(place, "out/.gitkeep", "kept");
    assert_int_equal(remove(directory_path(place, "out/.gitkeep")), 0);
    assert_report(place, "out", "one");
    assert_int_equal(directory_entries(place, ""), 1);
}

static void test_missing_parents_are_made(void **state)
{
    struct output output;
    begin(&output, *state, "a/b/c/out");
    fill(&output, "one");
    commit(&output);
    assert_report(*state, "a/b/c/out", "one");
    assert_int_equal(directory_entries(*state, "a/b/c"), 1);
}

static void test_a_directory_that_is_no_report_is_refused(void **state)
{
    const struct directory *place = *state;
    assert_int_equal(mkdir(directory_path(place, "out"), 0777), 0);
    assert_int_equal(mkdir(directory_path(place, "out/figures"), 0777), 0);
    directory_write(place, "out/figures/plot1.svg", "mine");
    assert_refused(place, "out", "holds 'figures/plot1.svg', and no manifest.txt names it as part of a report");
    directory_write(place, "out/report.md", "mine");
    directory_write(place, "out/results.json", "mine"); /* or a report of an earlier version */
    assert_refused(place, "out", "(a report of an earlier version: remove it first)");
    assert_refused(place, "out", "choose another directory with -o");
    directory_write(place, "out/manifest.txt", "report.md\nresults.json\nfigures/plot1.svg\nmanifest.txt\n");
    assert_refused(place, "out", "and no manifest.txt names it");
    assert_int_equal(remove(directory_path(place, "out/manifest.txt")), 0);
    assert_int_equal(mkfifo(directory_path(place, "out/manifest.txt"), 0666), 0); /* which would be read for ever */
    assert_refused(place, "out", "and no manifest.txt names it");
    assert_content(place, "out/figures/plot1.svg", "mine");
    assert_content(place, "out/report.md", "mine");
    assert_content(place, "out/results.json", "mine");
    assert_int_equal(directory_entries(place, "out"), 4);
    assert_int_equal(directory_entries(place, ""), 1);
}

static const char *const users_files[] = {
    "notes.md",
    "figures/holiday.svg",
    ".hidden",
    "data/mine.csv",
    "figures/6-05.svg\nreport.md",
    /* nearly the names of the report's files */
    "report",
    "data/contact.cs",
    "figures/6-05.svg~",
    "# the files of this report by roughcontact, which its next run replaces; no others",
};
enum { USERS_FILES = sizeof users_files / sizeof *users_files, FEW = 2 };

static void write_users_files(const struct directory *place, const char *target, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        char name[128];
        snprintf(name, sizeof name, "%s/%s", target, users_files[i]);
        directory_write(place, name, users_files[i]);
    }
}

static void assert_users_files(const struct directory *place, const char *target, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        char name[128];
        snprintf(name, sizeof name, "%s/%s", target, users_files[i]);
        assert_content(place, name, users_files[i]);
    }
}

static void test_files_of_the_user_stay(void **state)
{
    const struct directory *place = *state;
    struct stat before, after;
    publish(place, "out", "one");
    write_users_files(place, "out", USERS_FILES);
    assert_int_equal(symlink("../elsewhere", directory_path(place, "out/data/link")), 0);
    assert_int_equal(mkfifo(directory_path(place, "out/pipe"), 0600), 0);
    assert_int_equal(stat(directory_path(place, "out/notes.md"), &before), 0);
    publish(place, "out", "two");
    publish(place, "out", "three");
    assert_users_files(place, "out", USERS_FILES);
    assert_content(place, "out/report.md", "three");
    assert_int_equal(stat(directory_path(place, "out/notes.md"), &after), 0);
    assert_true(before.st_ino == after.st_ino); /* the file itself, no copy of it */
    assert_int_equal(after.st_nlink, 1);
    assert_int_equal(lstat(directory_path(place, "out/data/link"), &after), 0);
    assert_true(S_ISLNK(after.st_mode));
    assert_int_equal(stat(directory_path(place, "out/pipe"), &after), 0);
    assert_true(S_ISFIFO(after.st_mode));
    assert_int_equal(directory_entries(place, "out"), 6 + 5);
    assert_int_equal(directory_entries(place, "out/data"), 1 + 3);
    assert_int_equal(directory_entries(place, "out/figures"), 1 + 3);
    assert_int_equal(directory_entries(place, ""), 1);

    struct output output;
    begin(&output, place, "out"); /* and where nothing comes of the run */
    output_abandon(&output);
    assert_users_files(place, "out", USERS_FILES);
}

static void test_a_directory_of_the_user_stops_the_run(void **state)
{
    const struct directory *place = *state;
    publish(place, "out", "one");
    struct output output;
    begin(&output, place, "out");
    struct status status = {0};
    assert_int_equal(mkdir(directory_path(place, "out/figures/src.csv"), 0777), 0);
    directory_write(place, "out/figures/src.csv/thesis.tex", "mine");
    assert_refused(place, "out", "holds 'figures/src.csv', a directory, which is not part of a report; move it away");
    fill(&output, "two"); /* the same when it comes during the run */
    assert_int_equal(output_commit(&output, &status), STATUS_IO);
    assert_non_null(strstr(status.message, "holds 'figures/src.csv', a directory"));
    output_abandon(&output);
    assert_content(place, "out/figures/src.csv/thesis.tex", "mine");
    assert_content(place, "out/report.md", "one");
    assert_int_equal(directory_entries(place, ""), 1);
}

static void test_files_that_come_during_a_run_stay(void **state)
{
    const struct directory *place = *state;
    struct output output;
    begin(&output, place, "out"); /* where there is no report yet */
    fill(&output, "one");
    assert_int_equal(mkdir(directory_path(place, "out"), 0777), 0);
    directory_write(place, "out/results.json", "mine");
    struct status status = {0};
    assert_int_equal(output_commit(&output, &status), STATUS_IO);
    assert_non_null(strstr(status.message, "holds 'results.json', and no manifest.txt names it"));
    output_abandon(&output);
    assert_content(place, "out/results.json", "mine");
    assert_int_equal(remove(directory_path(place, "out/results.json")), 0);

    publish(place, "out", "one");
    begin(&output, place, "out");
    fill(&output, "two");
    write_users_files(place, "out", USERS_FILES);
    commit(&output);
    assert_users_files(place, "out", USERS_FILES);
    assert_content(place, "out/report.md", "two");
    assert_int_equal(directory_entries(place, ""), 1);
}

/* The user's file has a name that only the new report writes. */
static void test_a_file_of_the_user_is_never_replaced(void **state)
{
    const struct directory *place = *state;
    publish(place, "out", "one");
    directory_write(place, "out/data/cost.csv", "mine");
    struct output output;
    begin(&output, place, "out");
    struct text path = {0};
    struct status status = {0};
    fill(&output, "two");
    text_add(&path, "%s/data/cost.csv", output.staging);
    assert_int_equal(text_write_file(text_string(&path), "two", 3, &status), STATUS_OK);
    text_free(&path);
    assert_int_equal(output_commit(&output, &status), STATUS_IO);
    assert_non_null(strstr(status.message, "holds 'data/cost.csv', which is not of the report before"));
    output_abandon(&output);
    assert_content(place, "out/data/cost.csv", "mine");
    assert_content(place, "out/report.md", "one");
    assert_int_equal(directory_entries(place, ""), 1);
}

/* Links, pipes and directories under the names of the report's own files and folders. */
static void test_what_is_no_file_is_never_replaced(void **state)
{
    static const char *const names[] = {"out/report.md", "out/data/contact.csv", "out/manifest.txt", "out/data"};
    const struct directory *place = *state;
    for (size_t i = 0; i < 3 * sizeof names / sizeof *names; i++) {
        const char *name = names[i / 3];
        struct status status = {0};
        publish(place, "out", "one");
        struct output output;
        begin(&output, place, "out");
        assert_int_equal(rename(directory_path(place, name), directory_path(place, "aside")), 0);
        if (i % 3 == 0)
            assert_int_equal(symlink(directory_path(place, "aside"), directory_path(place, name)), 0);
        else if (i % 3 == 1)
            assert_int_equal(mkfifo(directory_path(place, name), 0666), 0);
        else if (i / 3 == 3)
            directory_write(place, name, "mine");
        else
            assert_int_equal(mkdir(directory_path(place, name), 0777), 0);
        assert_refused(place, "out",
                       i / 3 == 3   ? "data'"
                       : i / 3 == 2 ? "and no manifest.txt names it"
                                    : "', which is in the place of a file of the report but is none; move it");
        fill(&output, "two");
        assert_int_equal(output_commit(&output, &status), STATUS_IO);
        output_abandon(&output);
        struct stat info;
        assert_int_equal(lstat(directory_path(place, name), &info), 0);
        assert_true(i % 3 == 0   ? S_ISLNK(info.st_mode)
                    : i % 3 == 1 ? S_ISFIFO(info.st_mode)
                                 : S_ISDIR(info.st_mode) || i / 3 == 3);
        assert_int_equal(directory_entries(place, ""), 2);
        assert_int_equal(remove(directory_path(place, name)), 0);
        assert_int_equal(rename(directory_path(place, "aside"), directory_path(place, name)), 0);
        assert_report(place, "out", "one");
    }
}

/* A manifest reaches nothing outside OUT, whatever it says. */
static void test_a_hostile_manifest_removes_nothing_else(void **state)
{
    const struct directory *place = *state;
    publish(place, "out", "one");
    struct text text = directory_read(place, "out/manifest.txt");
    text_add(&text, "../victim\n%s\n.\n..\ndata\nfigures\n\n", directory_path(place, "victim"));
    text_add(&text, "notes.md"); /* a line without its end is none */
    directory_write(place, "victim", "mine");
    directory_write(place, "out/manifest.txt", text_string(&text));
    text_free(&text);
    directory_write(place, "out/notes.md", "mine");
    publish(place, "out", "two");
    assert_content(place, "victim", "mine");
    assert_content(place, "out/notes.md", "mine");
    assert_int_equal(directory_entries(place, ""), 2);
}

static void test_a_link_to_the_directory_stays_a_link(void **state)
{
    const struct directory *place = *state;
    struct stat info;
    publish(place, "real/out", "one");
    directory_write(place, "real/out/notes.md", "mine");
    assert_int_equal(symlink("real/out", directory_path(place, "link")), 0);
    publish(place, "link", "two");
    assert_int_equal(lstat(directory_path(place, "link"), &info), 0);
    assert_true(S_ISLNK(info.st_mode));
    assert_content(place, "real/out/report.md", "two");
    assert_content(place, "link/notes.md", "mine");
    assert_int_equal(directory_entries(place, "real"), 1);
}

/* Lets `result` become of the system calls in `calls` from here on. */
static void filter_calls(const unsigned *calls, size_t count, unsigned result)
{
    struct sock_filter filter[64] = {BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, nr))};
    unsigned short length = 1;
    for (size_t i = 0; i < count; i++) {
        filter[length++] = (struct sock_filter)BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, calls[i], 0, 1);
        filter[length++] = (struct sock_filter)BPF_STMT(BPF_RET | BPF_K, result);
    }
    filter[length++] = (struct sock_filter)BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
    struct sock_fprog program = {length, filter};
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 || prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0)
        _exit(77);
}

/* Makes a system call fail, as on a file system that has no such thing. */
static void forbid(unsigned call, unsigned reason)
{
    filter_calls(&call, 1, SECCOMP_RET_ERRNO | reason);
}

static void stop_at_changes(void)
{
    static const unsigned calls[] = {
        SYS_openat, SYS_newfstatat, SYS_getdents64, SYS_linkat, SYS_unlinkat, SYS_renameat, SYS_renameat2,
#ifdef SYS_rename /* the older calls, which newer machines do not have */
        SYS_rename, SYS_rmdir,      SYS_unlink,     SYS_open,
#endif
    };
    filter_calls(calls, sizeof calls / sizeof *calls, SECCOMP_RET_TRACE);
}

/* Runs output_commit(), where a call fails, in a process of its own up to its `step`-th system call that could change
 * something or opens a directory, does `act` before it and kills the process or lets it go on. False when it ended
 * before. */
static bool commit_stepwise(struct output *output, unsigned without, size_t step, bool end,
                            void (*act)(const struct directory *place, int old), const struct directory *place, int old,
                            int *code)
{
    int state;
    pid_t child = divide();
    if (child == 0) {
        struct status status = {0};
        if (ptrace(PTRACE_TRACEME, 0, NULL, NULL) != 0)
            _exit(77);
        raise(SIGSTOP);
        if (without)
            forbid(without, EINVAL);
        stop_at_changes();
        _exit((int)output_commit(output, &status));
    }
    assert_int_equal(waitpid(child, &state, 0), child);
    if (WIFSTOPPED(state) && ptrace(PTRACE_SETOPTIONS, child, NULL, PTRACE_O_TRACESECCOMP) == 0)
        for (size_t i = 0; i <= step && WIFSTOPPED(state); i++) {
            assert_int_equal(ptrace(PTRACE_CONT, child, NULL, NULL), 0);
            assert_int_equal(waitpid(child, &state, 0), child);
        }
    if (WIFEXITED(state) && WEXITSTATUS(state) == 77) {
        output_abandon(output);
        print_message("[  SKIPPED ] no process may be traced here\n");
        skip();
    }
    if (!WIFSTOPPED(state))
        return false;
    if (act)
        act(place, old);
    if (end)
        assert_int_equal(kill(child, SIGKILL), 0);
    for (; WIFSTOPPED(state); assert_int_equal(waitpid(child, &state, 0), child))
        assert_true(ptrace(PTRACE_CONT, child, NULL, NULL) == 0 || end);
    assert_true(end ? WIFSIGNALED(state) : WIFEXITED(state));
    *code = end ? 0 : WEXITSTATUS(state);
    return true;
}

static void assert_whole_report(const struct directory *place)
{
    struct text text = directory_read(place, "out/results.json");
    assert_true(strcmp(text_string(&text), "one") == 0 || strcmp(text_string(&text), "two") == 0);
    assert_content(place, "out/report.md", text_string(&text));
    assert_content(place, "out/report.html", text_string(&text));
    assert_content(place, "out/data/contact.csv", text_string(&text));
    assert_content(place, "out/figures/6-05.svg", text_string(&text));
    assert_true(directory_has(place, "out/manifest.txt"));
    text_free(&text);
}

/* As if this process had been killed, which holds its locks too. */
static void leave(struct output *output)
{
    temporary_close(&output->hidden); /* as it is not empty it stays */
}

/* The one entry whose name begins so; false: there is none. */
static bool find(char out[static PATH_MAX], const struct directory *place, const char *beginning)
{
    out[0] = '\0';
    DIR *list = opendir(place->path);
    assert_non_null(list);
    for (const struct dirent *entry; (entry = readdir(list));)
        if (strncmp(entry->d_name, beginning, strlen(beginning)) == 0)
            snprintf(out, PATH_MAX, "%s/%s", place->path, entry->d_name);
    closedir(list);
    return out[0] != '\0';
}

static bool has_kept(const struct directory *place)
{
    char path[PATH_MAX];
    return find(path, place, "out.kept-");
}

/* Also where directories cannot be exchanged: OUT then has another name between two renames, and all that is in it. */
static void test_a_kill_at_any_instant_loses_nothing(void **state)
{
    (void)state;
    for (int exchange = 1; exchange >= 0; exchange--) {
        bool ended = false, absent = false;
        size_t steps = 0;
        for (; !ended; steps++) {
            struct directory place = directory_make();
            struct output output;
            char kept[PATH_MAX];
            int code;
            publish(&place, "out", "one");
            write_users_files(&place, "out", FEW);
            begin(&output, &place, "out");
            fill(&output, "two");
            ended = !commit_stepwise(&output, exchange ? 0 : SYS_renameat2, steps, true, NULL, &place, -1, &code);
            if (!exchange && find(kept, &place, "out.kept-")) {
                if (directory_has(&place, "out"))
                    assert_int_equal(rename(directory_path(&place, "out"), output.staging), 0);
                absent = true;
                assert_int_equal(rename(kept, directory_path(&place, "out")), 0);
                temporary_remove_entry(output.hidden.directory, "done");
            }
            assert_whole_report(&place);
            assert_users_files(&place, "out", FEW);
            leave(&output);
            publish(&place, "out", "three"); /* what is left behind disturbs no later run, which clears it away */
            if (directory_entries(&place, "") != 1 || directory_entries(&place, "out") != 6 + 1)
                fail_msg("something is left of a kill at step %zu", steps);
            assert_content(&place, "out/report.md", "three");
            assert_users_files(&place, "out", FEW);
            directory_remove(&place);
        }
        assert_true(steps > 30);
        assert_int_equal(absent, !exchange);
    }
}

/* Is there a file `name` with this content in OUT or where the message says? */
static bool survives(const struct directory *place, const char *name, const char *content)
{
    DIR *open = opendir(place->path);
    bool found = false;
    assert_non_null(open);
    for (const struct dirent *entry; !found && (entry = readdir(open));) {
        char path[512];
        struct text text = {0};
        struct status status = {0};
        if (strcmp(entry->d_name, "out") != 0 && strncmp(entry->d_name, "out.kept-", 9) != 0)
            continue;
        snprintf(path, sizeof path, "%s/%s/%s%s", place->path, entry->d_name,
                 strcmp(entry->d_name, "out") == 0 ? "" : "done/", name);
        found = text_read_file(&text, path, &status) == STATUS_OK && strcmp(text_string(&text), content) == 0;
        text_free(&text);
    }
    closedir(open);
    return found;
}

static bool put(int folder, const char *name, const char *content)
{
    int file = openat(folder, name, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (file < 0)
        return false; /* its directory is gone: whoever writes there is told */
    assert_int_equal(write(file, content, strlen(content)), (ssize_t)strlen(content));
    close(file);
    return true;
}

static bool came; /* what the act did arrived */

static void add_file(const struct directory *place, int old)
{
    (void)old;
    directory_write(place, "out/figures/late.txt", "late");
    came = true;
}

static void add_directory(const struct directory *place, int old)
{
    (void)old;
    assert_int_equal(mkdir(directory_path(place, "out/late"), 0777), 0);
    directory_write(place, "out/late/late.txt", "late");
    came = true;
}

/* By a process that stands in the directory, wherever that is meanwhile. */
static void add_file_inside(const struct directory *place, int old)
{
    (void)place;
    came = put(old, "late.txt", "late");
}

/* As an editor saves: a new file, then renamed over the one before. */
static void save_file(const struct directory *place, int old)
{
    (void)place;
    came = put(old, "notes.md~", "late") && renameat(old, "notes.md~", old, "notes.md") == 0;
}

static void test_what_comes_at_any_instant_is_not_lost(void **state)
{
    static const struct {
        void (*act)(const struct directory *place, int old);
        const char *name;
    } acts[] = {{add_file, "figures/late.txt"},
                {add_directory, "late/late.txt"},
                {add_file_inside, "late.txt"},
                {save_file, "notes.md"}};
    for (size_t i = 0; i < sizeof acts / sizeof *acts; i++) {
        bool ended = false, left = false;
        for (size_t steps = 0; !ended; steps++) {
            struct directory place = directory_make();
            int code = 0;
            publish(&place, "out", "one");
            write_users_files(&place, "out", FEW);
            struct output output;
            begin(&output, &place, "out");
            fill(&output, "two");
            int old = open(directory_path(&place, "out"), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
            assert_true(old >= 0);
            came = false;
            ended = !commit_stepwise(&output, 0, steps, false, acts[i].act, &place, old, &code);
            close(old);
            leave(&output);
            assert_whole_report(&place);
            for (size_t k = 0; k < FEW; k++)
                if (!came || strcmp(users_files[k], acts[i].name) != 0)
                    assert_true(survives(&place, users_files[k], users_files[k]));
            if (came && !survives(&place, acts[i].name, "late"))
                fail_msg("'%s' is lost when it comes at step %zu", acts[i].name, steps);
            if (code == 0)
                assert_content(&place, "out/report.md", "two");
            if (has_kept(&place)) {
                assert_int_equal(code, STATUS_IO); /* and says so */
                left = true;
            }
            directory_remove(&place);
        }
        assert_true(left); /* at some instant it has to stay beside OUT */
    }
    (void)state;
}

/* Begins, fills and commits in a process of its own where `call` fails; returns the status code. */
static int publish_without(const struct directory *place, unsigned call, unsigned reason)
{
    int state;
    pid_t child = divide();
    if (child == 0) {
        struct output output;
        struct status status = {0};
        forbid(call, reason);
        if (output_begin(&output, directory_path(place, "out"), &status) == STATUS_OK) {
            fill(&output, "two");
            (void)!output_commit(&output, &status);
        }
        output_abandon(&output);
        _exit((int)status.code);
    }
    assert_int_equal(waitpid(child, &state, 0), child);
    assert_true(WIFEXITED(state));
    if (WEXITSTATUS(state) == 77)
        skip();
    return WEXITSTATUS(state);
}

static void test_file_systems_that_can_do_less(void **state)
{
    const struct directory *place = *state;
    static const unsigned reasons[] = {EINVAL, ENOSYS};
    for (size_t i = 0; i < sizeof reasons / sizeof *reasons; i++) { /* no exchange: with two renames */
        publish(place, "out", "one");
        write_users_files(place, "out", USERS_FILES);
        assert_int_equal(publish_without(place, SYS_renameat2, reasons[i]), STATUS_OK);
        assert_whole_report(place);
        assert_content(place, "out/report.md", "two");
        assert_users_files(place, "out", USERS_FILES);
        assert_int_equal(directory_entries(place, ""), 1);
    }
    assert_int_equal(rename(directory_path(place, "out"), directory_path(place, "aside")), 0);
    assert_int_equal(publish_without(place, SYS_renameat2, EINVAL), STATUS_OK); /* nothing there */
    assert_report(place, "out", "two");
    assert_int_equal(publish_without(place, SYS_linkat, EPERM),
                     STATUS_OK); /* no links: needed for others' files only */
    directory_write(place, "out/notes.md", "mine");
    assert_int_equal(publish_without(place, SYS_linkat, EPERM), STATUS_IO);
    assert_content(place, "out/notes.md", "mine");
    assert_int_equal(directory_entries(place, ""), 2);
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
    static const char *const names[] = {"022", "077", "0"};
    char name[32];
    mode_t before = umask(0);
    for (size_t i = 0; i < sizeof masks / sizeof *masks; i++) {
        struct stat info;
        umask(masks[i]);
        publish(place, names[i], "one");
        snprintf(name, sizeof name, "%s/data", names[i]);
        assert_int_equal(stat(directory_path(place, names[i]), &info), 0);
        assert_int_equal(info.st_mode & 0777, 0777 & ~masks[i]);
        assert_int_equal(stat(directory_path(place, name), &info), 0);
        assert_int_equal(info.st_mode & 0777, 0777 & ~masks[i]);
    }
    assert_int_equal(chmod(directory_path(place, "022"), 02750), 0); /* a mode that was chosen stays */
    publish(place, "022", "two");
    struct stat info;
    assert_int_equal(stat(directory_path(place, "022"), &info), 0);
    assert_int_equal(info.st_mode & 07777, 02750);
    umask(before);
}

/* The directory around the target is moved away while the report is being made. */
static void test_a_commit_that_fails_keeps_what_stands_there(void **state)
{
    const struct directory *place = *state;
    struct output output;
    begin(&output, place, "a/out");
    struct status status = {0};
    fill(&output, "one");
    assert_int_equal(rename(directory_path(place, "a"), directory_path(place, "b")), 0);
    assert_int_equal(output_commit(&output, &status), STATUS_IO);
    assert_non_null(strstr(status.message, "a/out"));
    assert_int_equal(rename(directory_path(place, "b"), directory_path(place, "a")), 0);
    output_abandon(&output);
    assert_false(directory_has(place, "a")); /* made for the report, so it goes with it */
}

/* Runs act() in a process of its own and kills it there. */
static void kill_after(void (*act)(const struct directory *place), const struct directory *place)
{
    pid_t child = divide();
    if (child == 0) {
        act(place);
        raise(SIGKILL);
    }
    int state;
    assert_int_equal(waitpid(child, &state, 0), child);
    assert_true(WIFSIGNALED(state));
}

static void only_begin(const struct directory *place)
{
    static struct output output;
    begin(&output, place, "out");
}

static void only_begin_sticky(const struct directory *place)
{
    static struct output output;
    begin(&output, place, "sticky/out");
}

static void begin_and_fill(const struct directory *place)
{
    struct output output;
    begin(&output, place, "a");
    char link[PATH_MAX + 16];
    fill(&output, "half");
    snprintf(link, sizeof link, "%s/notes.md", output.staging);
    if (linkat(AT_FDCWD, directory_path(place, "out/notes.md"), AT_FDCWD, link, 0) != 0)
        _exit(1);
}

static void test_what_killed_runs_left_is_cleared_away(void **state)
{
    const struct directory *place = *state;
    publish(place, "out", "one");
    write_users_files(place, "out", FEW);
    kill_after(only_begin, place);
    kill_after(begin_and_fill, place);
    assert_int_equal(directory_entries(place, ""), 2);
    publish(place, "out", "two");
    assert_int_equal(directory_entries(place, ""), 1);
    kill_after(begin_and_fill, place);
    publish(place, "other", "one"); /* whichever run comes there next */
    assert_int_equal(directory_entries(place, ""), 2);
    assert_content(place, "out/report.md", "two");
    assert_users_files(place, "out", FEW);
}

static void test_what_a_living_run_makes_stays(void **state)
{
    const struct directory *place = *state;
    struct output output;
    begin(&output, place, "out");
    fill(&output, "two");
    publish(place, "out", "one"); /* in the same process: each run locks its own */
    publish(place, "other", "one");
    pid_t child = divide();
    if (child == 0) {
        publish(place, "third", "one");
        _exit(0);
    }
    expect_done(child);
    assert_int_equal(directory_entries(place, ""), 4);
    commit(&output);
    assert_report(place, "out", "two");
    assert_int_equal(directory_entries(place, ""), 3);
}

/* Files of the user's, below names that the program uses; nothing says that it made them. */
static void test_what_the_program_did_not_make_stays(void **state)
{
    static const char *const files[] = {
        ".roughcontact-abcdef/report/mine.csv", ".roughcontact-abcdeg/lock",  ".roughcontact-abcdeh/run",
        ".roughcontact-abcdej/done/mine.csv",   ".roughcontact-longer1/mine",
    };
    enum { FILES = sizeof files / sizeof *files };
    const struct directory *place = *state;
    for (size_t i = 0; i < FILES; i++) {
        char path[128];
        for (const char *slash = files[i]; (slash = strchr(slash, '/')); slash++) {
            snprintf(path, sizeof path, "%.*s", (int)(slash - files[i]), files[i]);
            mkdir(directory_path(place, path), 0700);
        }
        directory_write(place, files[i], "mine");
    }
    publish(place, "out", "one");
    for (size_t i = 0; i < FILES; i++)
        assert_content(place, files[i], "mine");
    assert_int_equal(directory_entries(place, ""), FILES + 1);
}

/* Killed while the report before was cleared away, and somebody had put something there: that stays, where it is seen,
 * and what is in OUT too goes. */
static void test_what_came_before_a_kill_stays(void **state)
{
    const struct directory *place = *state;
    struct output output;
    char done[PATH_MAX + 64], left[PATH_MAX + 64];
    publish(place, "out", "one");
    write_users_files(place, "out", FEW);
    for (int late = 0; late < 2; late++) {
        begin(&output, place, "out");
        fill(&output, "two");
        snprintf(done, sizeof done, "%s/done", output.hidden.path);
        assert_int_equal(rename(output.staging, done), 0);
        if (late)
            directory_write(place, strcat(strrchr(done, '.'), "/figures/late.txt"), "late");
        assert_int_equal(linkat(AT_FDCWD, directory_path(place, "out/notes.md"), output.hidden.directory, "aside", 0),
                         0);
        assert_int_equal(
            linkat(AT_FDCWD, directory_path(place, "out/notes.md"), output.hidden.directory, "done/notes.md", 0), 0);
        assert_int_equal(linkat(AT_FDCWD, directory_path(place, "out/manifest.txt"), output.hidden.directory,
                                "done/manifest.txt", 0),
                         0);
        leave(&output);
        publish(place, "out", "three");
        assert_users_files(place, "out", FEW);
        assert_false(find(left, place, ".roughcontact-"));
        assert_int_equal(find(left, place, "roughcontact-"), late);
    }
    assert_content(place, strcat(strrchr(left, '/') + 1, "/done/figures/late.txt"), "late");
}

/* What an archive may bring along: a directory that looks left by a killed run, once as it was in earlier versions,
 * once with every lock there could be, and an OUT whose folder leads elsewhere. Nothing comes there. */
static void test_a_forged_leftover_leads_nowhere(void **state)
{
    const struct directory *place = *state;
    static const char *const folders[] = {"autostart", "h", ".roughcontact-abcdef", ".roughcontact-abcdef/done",
                                          ".roughcontact-abcdef/done/data"};
    struct stat info;
    char lock[128];
    for (size_t i = 0; i < sizeof folders / sizeof *folders; i++)
        assert_int_equal(mkdir(directory_path(place, folders[i]), 0700), 0);
    assert_int_equal(symlink("../autostart", directory_path(place, "h/data")), 0);
    assert_int_equal(symlink("roughcontact x h", directory_path(place, ".roughcontact-abcdef/run")), 0);
    directory_write(place, ".roughcontact-abcdef/lock", "");
    directory_write(place, ".roughcontact-abcdef/done/manifest.txt", OUTPUT_MANIFEST_HEADER);
    directory_write(place, ".roughcontact-abcdef/done/data/evil.desktop", "evil");
    for (int guessed = 0; guessed < 2; guessed++) {
        assert_refused(place, "h", "holds 'data'");
        assert_int_equal(directory_entries(place, "autostart"), 0);
        assert_int_equal(directory_entries(place, "h"), 1);
        assert_content(place, ".roughcontact-abcdef/done/data/evil.desktop", "evil");
        assert_int_equal(stat(directory_path(place, ".roughcontact-abcdef"), &info), 0);
        snprintf(lock, sizeof lock, ".roughcontact-abcdef/lock-%jx-%jx-", (uintmax_t)info.st_ino,
                 (uintmax_t)info.st_dev);
        directory_write(place, lock, "");
    }
}

/* Many at once in one directory, each clearing away what the others seem to have left. */
static void test_runs_side_by_side_do_not_disturb_each_other(void **state)
{
    enum { RUNS = 4, TIMES = 40 };
    const struct directory *place = *state;
    pid_t children[RUNS];
    for (int k = 0; k < RUNS; k++) {
        children[k] = divide();
        if (children[k] == 0) {
            char name[2] = {(char)('a' + k)};
            for (int i = 0; i < TIMES; i++) {
                struct output output;
                struct status status = {0};
                if (output_begin(&output, directory_path(place, name), &status) != STATUS_OK)
                    _exit(2);
                fill(&output, name);
                if (i % 3 == 0)
                    output_abandon(&output);
                else if (output_commit(&output, &status) != STATUS_OK)
                    _exit(3);
            }
            _exit(0);
        }
    }
    for (int k = 0; k < RUNS; k++) {
        expect_done(children[k]);
    }
    assert_int_equal(directory_entries(place, ""), RUNS);
    for (int k = 0; k < RUNS; k++) {
        char name[2] = {(char)('a' + k)};
        assert_report(place, name, name);
    }
}

static void test_a_mount_point_is_refused(void **state)
{
    static const char *const mounts[] = {"/proc", "/proc/", "/dev/shm"};
    (void)state;
    for (size_t i = 0; i < sizeof mounts / sizeof *mounts; i++) {
        struct output output;
        struct status status = {0};
        struct stat info, root;
        if (stat(mounts[i], &info) != 0 || stat("/", &root) != 0 || info.st_dev == root.st_dev)
            continue; /* nothing is mounted there: a bare tree */
        assert_int_equal(output_begin(&output, mounts[i], &status), STATUS_IO);
        assert_non_null(strstr(status.message, "is a mount point, which a report cannot take the place of; name a "
                                               "directory in it"));
        assert_string_equal(output.staging, ""); /* nothing was made */
        output_abandon(&output);
    }
}

/* Of the same file system: what is mounted there is a directory of it. */
static void test_a_directory_mounted_elsewhere_is_refused(void **state)
{
    static const char *const mounts[] = {"out", "out/data"};
    const struct directory *place = *state;
    publish(place, "out", "one");
    publish(place, "other", "one");
    for (size_t i = 0; i < sizeof mounts / sizeof *mounts; i++) {
        pid_t child = divide();
        if (child == 0) { /* which sees the mount alone */
            if (unshare(CLONE_NEWNS) != 0 || mount("none", "/", NULL, MS_REC | MS_PRIVATE, NULL) != 0 ||
                mount(directory_path(place, i == 0 ? "other" : "other/data"), directory_path(place, mounts[i]), NULL,
                      MS_BIND, NULL) != 0)
                _exit(77);
            assert_refused(place, "out", "is a mount point, which a report cannot take the place of");
            _exit(0);
        }
        expect_done(child);
    }
}

/* Of all its directories, with extended attributes, if there are any. */
static void test_the_attributes_of_out_stay(void **state)
{
    static const mode_t modes[] = {0700, 0755, 0770, 01777, 0711};
    static const char *const folders[] = {"out", "out/data", "out/figures"};
    const struct directory *place = *state;
    struct stat info;
    struct output output;
    char value[8];
    bool can = false;
    publish(place, "out", "one");
    for (size_t i = 0; i < 3; i++)
        can = setxattr(directory_path(place, folders[i]), "user.kept", folders[i], 4, 0) == 0;
    for (size_t i = 0; i < 3 * sizeof modes / sizeof *modes; i++) {
        const char *folder = folders[i % 3];
        assert_int_equal(chmod(directory_path(place, folder), modes[i / 3]), 0);
        publish(place, "out", "two");
        assert_int_equal(stat(directory_path(place, folder), &info), 0);
        assert_int_equal(info.st_mode & 07777, modes[i / 3]);
        assert_true(!can || getxattr(directory_path(place, folder), "user.kept", value, sizeof value) == 4);
    }
    begin(&output, place, "out"); /* also one that comes during the run */
    fill(&output, "three");
    assert_int_equal(chmod(directory_path(place, "out"), 0700), 0);
    commit(&output);
    assert_int_equal(stat(directory_path(place, "out"), &info), 0);
    assert_int_equal(info.st_mode & 07777, 0700);
}

/* Below a directory whose group its entries take: stale directories have that bit too, and OUT as any other. */
static void test_a_set_group_id_directory(void **state)
{
    const struct directory *place = *state;
    struct stat info;
    assert_int_equal(chmod(place->path, 02700), 0);
    assert_int_equal(mkdir(directory_path(place, "plain"), 0777), 0);
    assert_int_equal(stat(directory_path(place, "plain"), &info), 0);
    mode_t plain = info.st_mode & 07777;
    publish(place, "out", "one");
    assert_int_equal(stat(directory_path(place, "out"), &info), 0);
    assert_int_equal(info.st_mode & 07777, plain);
    kill_after(only_begin, place);
    assert_int_equal(directory_entries(place, ""), 3);
    publish(place, "out", "two");
    assert_int_equal(stat(directory_path(place, "out"), &info), 0);
    assert_int_equal(info.st_mode & 07777, plain);
    assert_int_equal(directory_entries(place, ""), 2);
}

/* A disk that is full, whenever that shows: no inode for the n-th entry. */
static void test_a_full_disk_leaves_the_report_before(void **state)
{
    enum { MOST = 60 };
    const struct directory *place = *state;
    pid_t child = divide();
    if (child == 0) { /* which sees the disk alone */
        size_t refused = 0, written = 0;
        if (unshare(CLONE_NEWNS) != 0 || mount("none", "/", NULL, MS_REC | MS_PRIVATE, NULL) != 0)
            _exit(77);
        for (int inodes = 2; inodes < MOST; inodes++) {
            struct directory disk;
            char options[64];
            struct output output;
            struct status status = {0};
            if (mount("tmpfs", place->path, "tmpfs", 0, "size=4m") != 0)
                _exit(77);
            snprintf(disk.path, sizeof disk.path, "%s", place->path);
            publish(&disk, "out", "one"); /* takes 9 */
            write_users_files(&disk, "out", FEW);
            snprintf(options, sizeof options, "nr_inodes=%d", 11 + inodes);
            if (mount("tmpfs", disk.path, "tmpfs", MS_REMOUNT, options) != 0)
                _exit(77);
            enum status_code rc = output_begin(&output, directory_path(&disk, "out"), &status);
            for (int i = 0; i < 3 && rc == STATUS_OK; i++) {
                static const char *const files[] = {"report.md", "data/contact.csv", "figures/6-05.svg"};
                char path[PATH_MAX + 32];
                snprintf(path, sizeof path, "%s/%s", output.staging, files[i]);
                rc = text_write_file(path, "two", 3, &status);
            }
            if (rc == STATUS_OK)
                rc = output_commit(&output, &status);
            output_abandon(&output);
            assert_content(&disk, "out/report.md", rc == STATUS_OK ? "two" : "one");
            assert_content(&disk, "out/data/contact.csv", rc == STATUS_OK ? "two" : "one");
            assert_users_files(&disk, "out", FEW);
            assert_int_equal(directory_entries(&disk, ""), 1);
            if (rc == STATUS_OK)
                written++;
            else if (strstr(status.message, "No space left on device"))
                refused++;
            else
                fail_msg("%s", status.message);
            if (umount2(disk.path, MNT_DETACH) != 0)
                _exit(78);
        }
        _exit(refused > 8 && written > 8 ? 0 : 79);
    }
    expect_done(child);
}

/* Calls that fail from the beginning, with the report before in place. */
static void test_no_room_for_an_entry(void **state)
{
    static const unsigned calls[] = {
        SYS_linkat, SYS_mkdirat, SYS_renameat2,
#ifdef SYS_rename
        SYS_rename, SYS_mkdir,
#endif
    };
    const struct directory *place = *state;
    publish(place, "out", "one");
    write_users_files(place, "out", FEW);
    for (size_t i = 0; i < sizeof calls / sizeof *calls; i++)
        if (publish_without(place, calls[i], ENOSPC) == STATUS_OK) { /* another call does it */
            assert_true(calls[i] != SYS_linkat && calls[i] != SYS_renameat2);
            assert_content(place, "out/report.md", "two");
            publish(place, "out", "one");
        } else {
            assert_whole_report(place);
            assert_content(place, "out/report.md", "one");
            assert_users_files(place, "out", FEW);
            assert_int_equal(directory_entries(place, ""), 1);
        }
}

/* As another user than the one whose directories these are. */
static void test_what_others_own_is_refused(void **state)
{
    enum { NOBODY = 65534 };
    const struct directory *place = *state;
    if (geteuid() != 0)
        skip();
    publish(place, "sticky/out", "one");
    assert_int_equal(chmod(directory_path(place, "sticky/out"), 0777), 0);
    assert_int_equal(chmod(directory_path(place, "sticky/out/data"), 0777), 0);
    assert_int_equal(chmod(directory_path(place, "sticky/out/figures"), 0777), 0);
    assert_int_equal(chmod(directory_path(place, "sticky"), 01777), 0);
    publish(place, "closed/out", "one");
    assert_int_equal(chmod(directory_path(place, "closed/out"), 0777), 0);
    assert_int_equal(chmod(directory_path(place, "closed"), 0555), 0);
    publish(place, "open/out", "one");
    assert_int_equal(chmod(directory_path(place, "open"), 0777), 0);
    assert_int_equal(chmod(place->path, 0755), 0);
    kill_after(only_begin_sticky, place); /* is root's: stays */
    pid_t child = divide();
    if (child == 0) {
        if (setgid(NOBODY) != 0 || setuid(NOBODY) != 0)
            _exit(77);
        assert_refused(place, "sticky/out", "is another user's, and only they can replace it");
        assert_refused(place, "closed/out", "cannot make a directory in");
        assert_refused(place, "closed/new", "cannot make a directory in");
        assert_refused(place, "open/out", "cannot write the report to");
        publish(place, "sticky/new", "one");
        _exit(directory_entries(place, "sticky") == 3 ? 0 : 78);
    }
    expect_done(child);
    publish(place, "sticky/new", "two"); /* what root left, root removes */
    assert_int_equal(directory_entries(place, "sticky"), 2);
}

/* Even root, who could, lets another user's be. */
static void test_what_another_users_run_left_stays(void **state)
{
    enum { NOBODY = 65534 };
    const struct directory *place = *state;
    char left[PATH_MAX];
    if (geteuid() != 0)
        skip();
    kill_after(only_begin, place);
    assert_true(find(left, place, ".roughcontact-"));
    assert_int_equal(chown(left, NOBODY, NOBODY), 0);
    publish(place, "out", "one");
    assert_int_equal(access(left, F_OK), 0);
    assert_int_equal(chown(left, 0, 0), 0);
    publish(place, "out", "two");
    assert_int_equal(access(left, F_OK), -1);
}

/* Two runs into one OUT: each report is whole, the user's files outlive both, nothing is left. */
static void test_runs_into_one_out(void **state)
{
    enum { RUNS = 3, TIMES = 10 };
    const struct directory *place = *state;
    pid_t children[RUNS];
    publish(place, "out", "one");
    write_users_files(place, "out", FEW);
    for (int k = 0; k < RUNS; k++) {
        children[k] = divide();
        if (children[k] == 0) {
            for (int i = 0; i < TIMES; i++) {
                struct output output;
                struct status status = {0};
                if (output_begin(&output, directory_path(place, "out"), &status) == STATUS_OK) {
                    fill(&output, i % 2 ? "one" : "two");
                    (void)!output_commit(&output, &status); /* may be refused, as the other was faster */
                }
                output_abandon(&output);
            }
            _exit(0);
        }
    }
    for (int k = 0; k < RUNS; k++) {
        expect_done(children[k]);
    }
    assert_whole_report(place);
    for (size_t k = 0; k < FEW; k++)
        assert_true(survives(place, users_files[k], users_files[k]));
    if (!has_kept(place)) {
        assert_users_files(place, "out", FEW);
        assert_int_equal(directory_entries(place, ""), 1);
    }
}

/* Once the report is there, nothing that comes to have the name of its hidden directory is the program's. */
static void test_what_is_committed_is_forgotten(void **state)
{
    const struct directory *place = *state;
    struct output output;
    begin(&output, place, "out");
    char path[PATH_MAX];
    fill(&output, "one");
    strcpy(path, output.hidden.path);
    commit(&output);
    assert_int_equal(mkdir(path, 0700), 0);
    pid_t child = divide();
    if (child == 0) {
        const char *said = temporary_end();
        _exit(strstr(said, "the report is in '") && strstr(said, "/out'") ? 0 : 1);
    }
    expect_done(child);
    assert_int_equal(access(path, F_OK), 0);
    assert_int_equal(rmdir(path), 0);

    begin(&output, place, "out"); /* one that is under way goes */
    fill(&output, "two");
    child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        const char *said = temporary_end();
        _exit(strstr(said, "/out' is as it was before") ? 0 : 1);
    }
    expect_done(child);
    assert_int_equal(access(output.hidden.path, F_OK), -1);
    output_abandon(&output);
    assert_report(place, "out", "one");
}

int main(void)
{
    if (access("/dev/shm", W_OK) == 0 && setenv("TMPDIR", "/dev/shm", 1) != 0) /* where no disk is waited for */
        return 1;
#define TEST(function) cmocka_unit_test_setup_teardown(function, place_setup, place_teardown)
    const struct CMUnitTest tests[] = {
        TEST(test_what_is_committed_is_forgotten), /* before the others: theirs are not all forgotten */
        TEST(test_a_report_takes_the_place_of_the_one_before),
        TEST(test_an_abandoned_run_leaves_the_report_before),
        TEST(test_files_of_the_report_before_do_not_survive),
        TEST(test_an_empty_directory_may_be_the_target),
        TEST(test_missing_parents_are_made),
        TEST(test_the_manifest_names_each_file),
        TEST(test_a_directory_that_is_no_report_is_refused),
        TEST(test_files_of_the_user_stay),
        TEST(test_a_directory_of_the_user_stops_the_run),
        TEST(test_files_that_come_during_a_run_stay),
        TEST(test_a_file_of_the_user_is_never_replaced),
        TEST(test_what_is_no_file_is_never_replaced),
        TEST(test_a_hostile_manifest_removes_nothing_else),
        TEST(test_a_link_to_the_directory_stays_a_link),
        cmocka_unit_test(test_a_kill_at_any_instant_loses_nothing),
        cmocka_unit_test(test_what_comes_at_any_instant_is_not_lost),
        TEST(test_file_systems_that_can_do_less),
        TEST(test_a_target_that_cannot_be_written_is_named),
        TEST(test_a_name_that_is_too_long_is_refused),
        TEST(test_the_report_can_be_read_by_whom_the_umask_allows),
        TEST(test_a_commit_that_fails_keeps_what_stands_there),
        TEST(test_what_killed_runs_left_is_cleared_away),
        TEST(test_what_a_living_run_makes_stays),
        TEST(test_what_the_program_did_not_make_stays),
        TEST(test_what_came_before_a_kill_stays),
        TEST(test_a_forged_leftover_leads_nowhere),
        TEST(test_runs_side_by_side_do_not_disturb_each_other),
        TEST(test_a_mount_point_is_refused),
        TEST(test_a_directory_mounted_elsewhere_is_refused),
        TEST(test_the_attributes_of_out_stay),
        TEST(test_a_set_group_id_directory),
        TEST(test_a_full_disk_leaves_the_report_before),
        TEST(test_no_room_for_an_entry),
        TEST(test_what_others_own_is_refused),
        TEST(test_what_another_users_run_left_stays),
        TEST(test_runs_into_one_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
