/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "directory.h"
#include "output/exchange.h"

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

static int on_no_disk(void **state)
{
    (void)state;
    return access("/dev/shm", W_OK) == 0 ? setenv("TMPDIR", "/dev/shm", 1) : 0; /* where no disk is waited for */
}

TEST_GROUP(on_no_disk, NULL)

static pid_t divide(void)
{
    pid_t child = fork();
    assert_true(child >= 0);
    return child;
}

/* Waits for a process, which exits with what is returned; 77 is for what is not possible here. */
static int exit_of(pid_t child)
{
    int how;
    assert_int_equal(waitpid(child, &how, 0), child);
    assert_true(WIFEXITED(how));
    if (WEXITSTATUS(how) == 77)
        skip();
    return WEXITSTATUS(how);
}

static void begin(struct exchange *output, const struct directory *place, const char *target)
{
    expect_ok(exchange_begin, output, directory_path(place, target));
}

/* Writes a file into the staging directory. */
static void stage(const struct exchange *output, const char *name, const char *word)
{
    expect_ok(text_write_file, filled("%s/%s", output->staging, name), word, strlen(word));
}

static const char *const reports_files[] = {"report.md", "report.html", "results.json", "data/contact.csv",
                                            "figures/6-05.svg"};
enum { REPORTS_FILES = sizeof reports_files / sizeof *reports_files };

/* Writes a one-word report into the staging directory. */
static void fill(const struct exchange *output, const char *word)
{
    for (size_t i = 0; i < REPORTS_FILES; i++)
        stage(output, reports_files[i], word);
}

static void commit(struct exchange *output)
{
    expect_ok(exchange_commit, output);
    assert_string_equal(output->staging, "");
    exchange_abandon(output); /* has nothing left to do, as in a run */
}

/* All of the report at `target` is of one word, this one or (NULL) "one" or "two". */
static void assert_whole(const struct directory *place, const char *target, const char *word)
{
    char *text = directory_read(place, filled("%s/results.json", target));
    if (!word)
        word = strcmp(text, "one") == 0 ? "one" : "two";
    for (size_t i = 0; i < REPORTS_FILES; i++)
        directory_holds(place, filled("%s/%s", target, reports_files[i]), word);
    assert_true(directory_has(place, filled("%s/manifest.txt", target)));
}

/* Puts the report `word` at `target`. */
static void publish(const struct directory *place, const char *target, const char *word)
{
    struct exchange output;
    begin(&output, place, target);
    fill(&output, word);
    commit(&output);
}

static void assert_refused(const struct directory *place, const char *target, const char *words)
{
    struct exchange output;
    expect_fails(STATUS_IO, words, exchange_begin, &output, directory_path(place, target));
    exchange_abandon(&output);
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
    for (size_t i = 0; i < count; i++)
        directory_write(place, filled("%s/%s", target, users_files[i]), users_files[i]);
}

static void assert_users_files(const struct directory *place, const char *target, size_t count)
{
    for (size_t i = 0; i < count; i++)
        directory_holds(place, filled("%s/%s", target, users_files[i]), users_files[i]);
}

/* Of the process that it was: 'f' a file, 'l' a link, 'p' a pipe, 'd' a directory. */
static char kind_of(const struct directory *place, const char *name)
{
    struct stat info;
    assert_int_equal(lstat(directory_path(place, name), &info), 0);
    return S_ISLNK(info.st_mode) ? 'l' : S_ISFIFO(info.st_mode) ? 'p' : S_ISDIR(info.st_mode) ? 'd' : 'f';
}

static mode_t mode_of(const struct directory *place, const char *name)
{
    struct stat info;
    assert_int_equal(stat(directory_path(place, name), &info), 0);
    return info.st_mode & 07777;
}

/* Something of the user's of that kind. */
static void put_in_place(const struct directory *place, char kind, const char *name, const char *content)
{
    const char *path = directory_path(place, name);
    if (kind == 'f')
        directory_write(place, name, content);
    else
        assert_int_equal(kind == 'd'   ? mkdir(path, 0700)
                         : kind == 'p' ? mkfifo(path, 0600)
                                       : symlink(content, path),
                         0);
}

/* Begins in a process of its own, with `note` ("": does not) fills and links that file of the user's, and is killed.
 */
static void begin_and_die(const struct directory *place, const char *target, const char *note)
{
    int state;
    pid_t child = divide();
    if (child == 0) {
        struct exchange output;
        begin(&output, place, target);
        if (*note)
            fill(&output, "half");
        if (*note &&
            linkat(AT_FDCWD, directory_path(place, note), AT_FDCWD, filled("%s/notes.md", output.staging), 0) != 0)
            _exit(1);
        raise(SIGKILL);
    }
    assert_int_equal(waitpid(child, &state, 0), child);
    assert_true(WIFSIGNALED(state));
}

/* What happens in an empty directory, step by step: a word, a name and the rest of the line.
 *
 * begin OUT, stage NAME WORD, fill WORD, commit, abandon: as a run does; publish OUT WORD does all of it
 * die OUT NOTE: begin_and_die()
 * refused OUT MESSAGE, refused-late OUT MESSAGE: it does not begin, or the one under way is not committed
 * file NAME WORD, directory NAME, link NAME TO, pipe NAME, remove NAME, move NAME TO, users OUT: the user does
 * is NAME KIND, holds NAME WORD, report OUT WORD, no NAME, entries NAME COUNT, stay OUT: so it is then */
static void take_step(const struct directory *place, struct exchange *output, const char *word, const char *name,
                      const char *rest)
{
    if (strcmp(word, "begin") == 0)
        begin(output, place, name);
    else if (strcmp(word, "stage") == 0)
        stage(output, name, rest);
    else if (strcmp(word, "fill") == 0)
        fill(output, name);
    else if (strcmp(word, "commit") == 0)
        commit(output);
    else if (strcmp(word, "abandon") == 0) {
        exchange_abandon(output);
        assert_string_equal(output->staging, "");
        exchange_abandon(output); /* twice is once */
    } else if (strcmp(word, "publish") == 0)
        publish(place, name, rest);
    else if (strcmp(word, "die") == 0)
        begin_and_die(place, name, rest);
    else if (strcmp(word, "refused") == 0)
        assert_refused(place, name, rest);
    else if (strcmp(word, "refused-late") == 0) {
        expect_fails(STATUS_IO, rest, exchange_commit, output);
    } else if (strcmp(word, "remove") == 0)
        assert_int_equal(remove(directory_path(place, name)), 0);
    else if (strcmp(word, "move") == 0)
        assert_int_equal(rename(directory_path(place, name), directory_path(place, rest)), 0);
    else if (strcmp(word, "users") == 0)
        write_users_files(place, name, USERS_FILES);
    else if (strcmp(word, "is") == 0)
        assert_int_equal(kind_of(place, name), *rest);
    else if (strcmp(word, "holds") == 0)
        directory_holds(place, name, rest);
    else if (strcmp(word, "report") == 0) {
        assert_whole(place, name, rest);
        assert_int_equal(directory_entries(place, name), 6);
    } else if (strcmp(word, "no") == 0)
        assert_false(directory_has(place, name));
    else if (strcmp(word, "entries") == 0)
        assert_int_equal(directory_entries(place, name), atoi(rest));
    else if (strcmp(word, "stay") == 0)
        assert_users_files(place, name, USERS_FILES);
    else {
        assert_true(strstr("file directory link pipe", word));
        put_in_place(place, *word, name, rest);
    }
}

static void play(const struct directory *place, const char *story)
{
    struct exchange output = {.staging = ""};
    char step[1024], word[32], name[256];
    for (const char *line = story; *line; line += strcspn(line, "|") + (line[strcspn(line, "|")] == '|')) {
        int used = 0;
        snprintf(step, sizeof step, "%.*s", (int)strcspn(line, "|"), line);
        *name = '\0';
        assert_true(sscanf(step, "%31s%n %255s %n", word, &used, name, &used) > 0);
        print_message("%s\n", step); /* the last one is where it failed */
        take_step(place, &output, word, name, step + used);
    }
}

static const char *const stories[] = {
    /* a report takes the place of the one before */
    "begin out|fill one|no out|commit|report out one|begin out|fill two|report out one|commit|report out two|"
    "publish out three|report out three|entries . 1",
    /* an abandoned run leaves it */
    "publish out one|begin out|fill half|abandon|report out one|entries . 1|begin other|abandon|entries . 1",
    /* nothing of an earlier, larger report stays behind in a smaller one */
    "begin out|fill one|stage figures/6-30.svg old|commit|holds out/figures/6-30.svg old|publish out two|"
    "no out/figures/6-30.svg|report out two|entries . 1",
    /* the manifest names each file */
    "publish out one|holds out/manifest.txt " OUTPUT_MANIFEST_HEADER
    "manifest.txt\nreport.html\nreport.md\nresults.json\ndata/contact.csv\nfigures/6-05.svg\n",
    /* an empty directory may be the target */
    "directory out|file out/.gitkeep kept|publish out/// one|holds out/.gitkeep kept|remove out/.gitkeep|report out "
    "one|"
    "entries . 1",
    /* missing parents are made */
    "publish a/b/c/out one|report a/b/c/out one|entries a/b/c 1",
    /* a directory that is no report is refused, or a report of an earlier version; a pipe would be read for ever */
    "directory out|directory out/figures|file out/figures/plot1.svg mine|"
    "refused out holds 'figures/plot1.svg', and no manifest.txt names it as part of a report|"
    "file out/report.md mine|file out/results.json mine|"
    "refused out (a report of an earlier version: remove it first)|refused out choose another directory with -o|"
    "file out/manifest.txt report.md\nresults.json\nfigures/plot1.svg\nmanifest.txt\n|"
    "refused out and no manifest.txt names it|remove out/manifest.txt|pipe out/manifest.txt|"
    "refused out and no manifest.txt names it|holds out/figures/plot1.svg mine|holds out/report.md mine|"
    "holds out/results.json mine|entries out 4|entries . 1",
    /* files of the user's stay, also where nothing comes of the run */
    "publish out one|users out|link out/data/link ../elsewhere|pipe out/pipe|publish out two|publish out three|"
    "stay out|holds out/report.md three|is out/data/link l|is out/pipe p|entries out 11|entries out/data 4|"
    "entries out/figures 4|entries . 1|begin out|abandon|stay out",
    /* a directory of the user's stops the run, also when it comes during it */
    "publish out one|begin out|directory out/figures/src.csv|file out/figures/src.csv/thesis.tex mine|"
    "refused out holds 'figures/src.csv', a directory, which is not part of a report; move it away|fill two|"
    "refused-late out holds 'figures/src.csv', a directory|abandon|holds out/figures/src.csv/thesis.tex mine|"
    "holds out/report.md one|entries . 1",
    /* files that come during a run stay, at first where there is no report yet */
    "begin out|fill one|directory out|file out/results.json mine|"
    "refused-late out holds 'results.json', and no manifest.txt names it|abandon|holds out/results.json mine|"
    "remove out/results.json|publish out one|begin out|fill two|users out|commit|stay out|holds out/report.md two|"
    "entries . 1",
    /* the user's file has a name that only the new report writes */
    "publish out one|file out/data/cost.csv mine|begin out|fill two|stage data/cost.csv two|"
    "refused-late out holds 'data/cost.csv', which is not of the report before|abandon|holds out/data/cost.csv mine|"
    "holds out/report.md one|entries . 1",
    /* a link to the directory stays a link */
    "publish real/out one|file real/out/notes.md mine|link link real/out|publish link two|is link l|"
    "holds real/out/report.md two|holds link/notes.md mine|entries real 1",
    /* a target that cannot be written is named: files in the way stop root too */
    "file file mine|refused file Not a directory|refused file/out Not a directory|refused file/a/b/out file|"
    "link link nowhere/at/all|refused link/out link|holds file mine|entries . 2",
    /* the directory around is moved away while the report is being made; made for it, it goes with it */
    "begin a/out|fill one|move a b|refused-late out a/out|move b a|abandon|no a",
    /* files of the user's below names that the program uses; nothing says that it made them */
    "directory .roughcontact-abcdef|directory .roughcontact-abcdef/report|file .roughcontact-abcdef/report/mine.csv a|"
    "directory .roughcontact-abcdeg|file .roughcontact-abcdeg/lock b|directory .roughcontact-abcdeh|"
    "file .roughcontact-abcdeh/run c|directory .roughcontact-abcdej|directory .roughcontact-abcdej/done|"
    "file .roughcontact-abcdej/done/mine.csv d|directory .roughcontact-longer1|file .roughcontact-longer1/mine e|"
    "publish out one|holds .roughcontact-abcdef/report/mine.csv a|holds .roughcontact-abcdeg/lock b|"
    "holds .roughcontact-abcdeh/run c|holds .roughcontact-abcdej/done/mine.csv d|holds .roughcontact-longer1/mine e|"
    "entries . 6",
    /* what killed runs left is cleared away, by whichever run comes there next */
    "publish out one|users out|die out|die a out/notes.md|entries . 2|publish out two|entries . 1|die a out/notes.md|"
    "publish other one|entries . 2|holds out/report.md two|stay out",
};

TEST_CASE(test_stories)
{
    for (size_t i = 0; i < sizeof stories / sizeof *stories; i++) {
        struct directory place = directory_make();
        play(&place, stories[i]);
        directory_remove(&place);
    }
}

TEST_IN_DIRECTORY(test_a_file_of_the_user_is_no_copy)
{
    struct stat before, after;
    publish(place, "out", "one");
    write_users_files(place, "out", FEW);
    assert_int_equal(stat(directory_path(place, "out/notes.md"), &before), 0);
    publish(place, "out", "two");
    assert_int_equal(stat(directory_path(place, "out/notes.md"), &after), 0);
    assert_true(before.st_ino == after.st_ino);
    assert_int_equal(after.st_nlink, 1);
}

/* Links, pipes and directories (or, of a folder, a file) under the names of the report's own files and folders. */
TEST_IN_DIRECTORY(test_what_is_no_file_is_never_replaced)
{
    static const struct {
        const char *name, *kinds, *words;
    } cases[] = {
        {"out/report.md", "lpd", "', which is in the place of a file of the report but is none; move it"},
        {"out/data/contact.csv", "lpd", "', which is in the place of a file of the report but is none; move it"},
        {"out/manifest.txt", "lpd", "and no manifest.txt names it"},
        {"out/data", "lpf", "data'"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        for (const char *kind = cases[i].kinds; *kind; kind++) {
            const char *name = cases[i].name;
            struct exchange output;
            publish(place, "out", "one");
            begin(&output, place, "out");
            assert_int_equal(rename(directory_path(place, name), directory_path(place, "aside")), 0);
            put_in_place(place, *kind, name, *kind == 'l' ? directory_path(place, "aside") : "mine");
            assert_refused(place, "out", cases[i].words);
            fill(&output, "two");
            expect_fails(STATUS_IO, "", exchange_commit, &output);
            exchange_abandon(&output);
            assert_int_equal(kind_of(place, name), *kind);
            assert_int_equal(directory_entries(place, ""), 2);
            assert_int_equal(remove(directory_path(place, name)), 0);
            assert_int_equal(rename(directory_path(place, "aside"), directory_path(place, name)), 0);
            play(place, "report out one");
        }
}

/* A manifest reaches nothing outside OUT, whatever it says. */
TEST_IN_DIRECTORY(test_a_hostile_manifest_removes_nothing_else)
{
    publish(place, "out", "one");
    const char *more = filled("%s../victim\n%s\n.\n..\ndata\nfigures\n\nnotes.md", /* a line without its end is none */
                              directory_read(place, "out/manifest.txt"), directory_path(place, "victim"));
    directory_write(place, "victim", "mine");
    directory_write(place, "out/manifest.txt", more);
    directory_write(place, "out/notes.md", "mine");
    publish(place, "out", "two");
    directory_holds(place, "victim", "mine");
    directory_holds(place, "out/notes.md", "mine");
    assert_int_equal(directory_entries(place, ""), 2);
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

/* Runs exchange_commit(), where a call fails, in a process of its own up to its `step`-th system call that could change
 * something or opens a directory, does `act` before it and kills the process or lets it go on. False when it ended
 * before. */
static bool commit_stepwise(struct exchange *output, unsigned without, size_t step, bool end,
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
        _exit((int)exchange_commit(output, &status));
    }
    assert_int_equal(waitpid(child, &state, 0), child);
    if (WIFSTOPPED(state) && ptrace(PTRACE_SETOPTIONS, child, NULL, PTRACE_O_TRACESECCOMP) == 0)
        for (size_t i = 0; i <= step && WIFSTOPPED(state); i++) {
            assert_int_equal(ptrace(PTRACE_CONT, child, NULL, NULL), 0);
            assert_int_equal(waitpid(child, &state, 0), child);
        }
    if (WIFEXITED(state) && WEXITSTATUS(state) == 77) {
        exchange_abandon(output);
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

/* As if this process had been killed, which holds its locks too. */
static void leave(struct exchange *output)
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
TEST_CASE(test_a_kill_at_any_instant_loses_nothing)
{
    for (int exchange = 1; exchange >= 0; exchange--) {
        bool ended = false, absent = false;
        size_t steps = 0;
        for (; !ended; steps++) {
            struct directory place = directory_make();
            struct exchange output;
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
            assert_whole(&place, "out", NULL);
            assert_users_files(&place, "out", FEW);
            leave(&output);
            publish(&place, "out", "three"); /* what is left behind disturbs no later run, which clears it away */
            if (directory_entries(&place, "") != 1 || directory_entries(&place, "out") != 6 + 1)
                fail_msg("something is left of a kill at step %zu", steps);
            directory_holds(&place, "out/report.md", "three");
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
        struct text *text = support_text();
        struct status status = {0};
        if (strcmp(entry->d_name, "out") != 0 && strncmp(entry->d_name, "out.kept-", 9) != 0)
            continue;
        found = text_read_file(text,
                               filled("%s/%s/%s%s", place->path, entry->d_name,
                                      strcmp(entry->d_name, "out") == 0 ? "" : "done/", name),
                               &status) == STATUS_OK &&
                strcmp(text_string(text), content) == 0;
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

/* What comes: a file, or one in a directory of its own, into whatever is at OUT; or by a process that stands in the
 * directory, wherever that is meanwhile: a new one, or one saved as an editor does, renamed over the one before. */
static const struct {
    const char *name;
    bool inside, saved;
} acts[] = {{"figures/late.txt", false, false},
            {"late/late.txt", false, false},
            {"late.txt", true, false},
            {"notes.md", true, true}};
static size_t acting;
static bool came; /* it arrived */

static void act(const struct directory *place, int old)
{
    const char *name = acts[acting].name;
    if (!acts[acting].inside)
        directory_write(place, filled("out/%s", name), "late");
    came = !acts[acting].inside || (put(old, acts[acting].saved ? "notes.md~" : name, "late") &&
                                    (!acts[acting].saved || renameat(old, "notes.md~", old, name) == 0));
}

TEST_CASE(test_what_comes_at_any_instant_is_not_lost)
{
    for (size_t i = acting = 0; i < sizeof acts / sizeof *acts; acting = ++i) {
        bool ended = false, left = false;
        for (size_t steps = i % 2; !ended; steps += 2) { /* every instant is one of two acts' */
            struct directory place = directory_make();
            int code = 0;
            publish(&place, "out", "one");
            write_users_files(&place, "out", FEW);
            struct exchange output;
            begin(&output, &place, "out");
            fill(&output, "two");
            int old = open(directory_path(&place, "out"), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
            assert_true(old >= 0);
            came = false;
            ended = !commit_stepwise(&output, 0, steps, false, act, &place, old, &code);
            close(old);
            leave(&output);
            assert_whole(&place, "out", NULL);
            for (size_t k = 0; k < FEW; k++)
                if (!came || strcmp(users_files[k], acts[i].name) != 0)
                    assert_true(survives(&place, users_files[k], users_files[k]));
            if (came && !survives(&place, acts[i].name, "late"))
                fail_msg("'%s' is lost when it comes at step %zu", acts[i].name, steps);
            if (code == 0)
                directory_holds(&place, "out/report.md", "two");
            if (has_kept(&place)) {
                assert_int_equal(code, STATUS_IO); /* and says so */
                left = true;
            }
            directory_remove(&place);
        }
        assert_true(left); /* at some instant it has to stay beside OUT */
    }
}

/* Begins, fills and commits in a process of its own where `call` fails; returns the status code. */
static int publish_without(const struct directory *place, unsigned call, unsigned reason)
{
    pid_t child = divide();
    if (child == 0) {
        struct exchange output;
        struct status status = {0};
        forbid(call, reason);
        if (exchange_begin(&output, directory_path(place, "out"), &status) == STATUS_OK) {
            fill(&output, "two");
            (void)!exchange_commit(&output, &status);
        }
        exchange_abandon(&output);
        _exit((int)status.code);
    }
    return exit_of(child);
}

TEST_IN_DIRECTORY(test_file_systems_that_can_do_less)
{
    static const unsigned reasons[] = {EINVAL, ENOSYS};
    for (size_t i = 0; i < sizeof reasons / sizeof *reasons; i++) { /* no exchange: with two renames */
        play(place, "publish out one|users out");
        assert_int_equal(publish_without(place, SYS_renameat2, reasons[i]), STATUS_OK);
        assert_whole(place, "out", "two");
        play(place, "stay out|entries . 1");
    }
    assert_int_equal(rename(directory_path(place, "out"), directory_path(place, "aside")), 0);
    assert_int_equal(publish_without(place, SYS_renameat2, EINVAL), STATUS_OK); /* nothing there */
    play(place, "report out two");
    assert_int_equal(publish_without(place, SYS_linkat, EPERM), STATUS_OK); /* links: for others' files only */
    directory_write(place, "out/notes.md", "mine");
    assert_int_equal(publish_without(place, SYS_linkat, EPERM), STATUS_IO);
    play(place, "holds out/notes.md mine|entries . 2");
}

TEST_CASE(test_a_name_that_is_too_long_is_refused)
{
    char name[PATH_MAX];
    struct exchange output;
    memset(name, 'x', sizeof name - 1);
    name[sizeof name - 1] = '\0';
    expect_fails(STATUS_IO, "too long", exchange_begin, &output, name);
    exchange_abandon(&output);
}

TEST_IN_DIRECTORY(test_what_a_living_run_makes_stays)
{
    struct exchange output;
    begin(&output, place, "out");
    fill(&output, "two");
    play(place, "publish out one|publish other one"); /* in the same process: each run locks its own */
    pid_t child = divide();
    if (child == 0) {
        publish(place, "third", "one");
        _exit(0);
    }
    assert_int_equal(exit_of(child), 0);
    assert_int_equal(directory_entries(place, ""), 4);
    commit(&output);
    play(place, "report out two|entries . 3");
}

/* Killed while the report before was cleared away, and somebody had put something there: that stays, where it is seen,
 * and what is in OUT too goes. */
TEST_IN_DIRECTORY(test_what_came_before_a_kill_stays)
{
    struct exchange output;
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
    directory_holds(place, strcat(strrchr(left, '/') + 1, "/done/figures/late.txt"), "late");
}

/* What an archive may bring along: a directory that looks left by a killed run, once as it was in earlier versions,
 * once with every lock there could be, and an OUT whose folder leads elsewhere. Nothing comes there. */
TEST_IN_DIRECTORY(test_a_forged_leftover_leads_nowhere)
{
    struct stat info;
    char lock[128];
    play(place, "directory autostart|directory h|directory .roughcontact-abcdef|directory .roughcontact-abcdef/done|"
                "directory .roughcontact-abcdef/done/data|link h/data ../autostart|"
                "link .roughcontact-abcdef/run roughcontact x h|file .roughcontact-abcdef/lock|"
                "file .roughcontact-abcdef/done/manifest.txt " OUTPUT_MANIFEST_HEADER
                "|file .roughcontact-abcdef/done/data/evil.desktop evil");
    assert_int_equal(stat(directory_path(place, ".roughcontact-abcdef"), &info), 0);
    snprintf(lock, sizeof lock, ".roughcontact-abcdef/lock-%jx-%jx-", (uintmax_t)info.st_ino, (uintmax_t)info.st_dev);
    for (int guessed = 0; guessed < 2; guessed++) {
        play(place, "refused h holds 'data'|entries autostart 0|entries h 1|"
                    "holds .roughcontact-abcdef/done/data/evil.desktop evil");
        directory_write(place, lock, "");
    }
}

/* Many at once in one directory, each clearing away what the others seem to have left, each into its own OUT or all
 * into one. */
static void run_side_by_side(const struct directory *place, int runs, int times, bool one_out)
{
    pid_t children[8];
    for (int k = 0; k < runs; k++) {
        children[k] = divide();
        if (children[k] == 0) {
            const char own[2] = {(char)('a' + k)};
            for (int i = 0; i < times; i++) {
                struct exchange output;
                struct status status = {0};
                enum status_code rc = exchange_begin(&output, directory_path(place, one_out ? "out" : own), &status);
                if (rc == STATUS_OK) {
                    fill(&output, !one_out ? own : i % 2 ? "one" : "two");
                    if (one_out || i % 3 > 0)
                        rc = exchange_commit(&output, &status);
                }
                if (rc != STATUS_OK && !one_out) /* else another was faster */
                    _exit(2);
                exchange_abandon(&output);
            }
            _exit(0);
        }
    }
    for (int k = 0; k < runs; k++)
        assert_int_equal(exit_of(children[k]), 0);
}

TEST_IN_DIRECTORY(test_runs_side_by_side_do_not_disturb_each_other)
{
    run_side_by_side(place, 4, 40, false);
    play(place, "entries . 4|report a a|report b b|report c c|report d d");
}

/* Each report is whole, the user's files outlive both, nothing is left. */
TEST_IN_DIRECTORY(test_runs_into_one_out)
{
    publish(place, "out", "one");
    write_users_files(place, "out", FEW);
    run_side_by_side(place, 3, 10, true);
    assert_whole(place, "out", NULL);
    for (size_t k = 0; k < FEW; k++)
        assert_true(survives(place, users_files[k], users_files[k]));
    if (!has_kept(place)) {
        assert_users_files(place, "out", FEW);
        assert_int_equal(directory_entries(place, ""), 1);
    }
}

TEST_CASE(test_a_mount_point_is_refused)
{
    struct exchange output;
    expect_fails(STATUS_IO, "is a mount point, which a report cannot take the place of; name a directory in it",
                 exchange_begin, &output, "/proc/");
    assert_string_equal(output.staging, ""); /* nothing was made */
    exchange_abandon(&output);
}

/* Of all its directories, with extended attributes, if there are any. */
TEST_IN_DIRECTORY(test_the_attributes_of_out_stay)
{
    static const mode_t modes[] = {0700, 0755, 0770, 01777, 0711};
    static const char *const folders[] = {"out", "out/data", "out/figures"};
    struct exchange output;
    char value[8];
    bool can = false;
    publish(place, "out", "one");
    for (size_t i = 0; i < 3; i++)
        can = setxattr(directory_path(place, folders[i]), "user.kept", folders[i], 4, 0) == 0;
    for (size_t i = 0; i < 3 * sizeof modes / sizeof *modes; i++) {
        const char *folder = folders[i % 3];
        assert_int_equal(chmod(directory_path(place, folder), modes[i / 3]), 0);
        publish(place, "out", "two");
        assert_int_equal(mode_of(place, folder), modes[i / 3]);
        assert_true(!can || getxattr(directory_path(place, folder), "user.kept", value, sizeof value) == 4);
    }
    mode_t before = umask(027); /* a new one is as the umask has it, not as mkdtemp() leaves it */
    publish(place, "new", "one");
    assert_int_equal(mode_of(place, "new") | mode_of(place, "new/data"), 0750);
    umask(before);
    begin(&output, place, "out"); /* also one that comes during the run */
    fill(&output, "three");
    assert_int_equal(chmod(directory_path(place, "out"), 0700), 0);
    commit(&output);
    assert_int_equal(mode_of(place, "out"), 0700);
}

/* Below a directory whose group its entries take: stale directories have that bit too, and OUT as any other. */
TEST_IN_DIRECTORY(test_a_set_group_id_directory)
{
    assert_int_equal(chmod(place->path, 02700), 0);
    assert_int_equal(mkdir(directory_path(place, "plain"), 0777), 0);
    publish(place, "out", "one");
    assert_int_equal(mode_of(place, "out"), mode_of(place, "plain"));
    begin_and_die(place, "out", "");
    assert_int_equal(directory_entries(place, ""), 3);
    publish(place, "out", "two");
    assert_int_equal(mode_of(place, "out"), mode_of(place, "plain"));
    assert_int_equal(directory_entries(place, ""), 2);
}

/* A disk that is full, whenever that shows: no inode for the n-th entry. */
TEST_IN_DIRECTORY(test_a_full_disk_leaves_the_report_before)
{
    enum { MOST = 60 };
    pid_t child = divide();
    if (child == 0) { /* which sees the disk alone */
        size_t refused = 0, written = 0;
        if (unshare(CLONE_NEWNS) != 0 || mount("none", "/", NULL, MS_REC | MS_PRIVATE, NULL) != 0)
            _exit(77);
        for (int inodes = 2; inodes < MOST; inodes++) {
            struct directory disk;
            struct exchange output;
            struct status status = {0};
            if (mount("tmpfs", place->path, "tmpfs", 0, "size=4m") != 0)
                _exit(77);
            snprintf(disk.path, sizeof disk.path, "%s", place->path);
            publish(&disk, "out", "one"); /* takes 9 */
            write_users_files(&disk, "out", FEW);
            if (mount("tmpfs", disk.path, "tmpfs", MS_REMOUNT, filled("nr_inodes=%d", 11 + inodes)) != 0)
                _exit(77);
            enum status_code rc = exchange_begin(&output, directory_path(&disk, "out"), &status);
            for (int i = 0; i < 3 && rc == STATUS_OK; i++) {
                static const char *const files[] = {"report.md", "data/contact.csv", "figures/6-05.svg"};
                rc = text_write_file(filled("%s/%s", output.staging, files[i]), "two", 3, &status);
            }
            if (rc == STATUS_OK)
                rc = exchange_commit(&output, &status);
            exchange_abandon(&output);
            directory_holds(&disk, "out/report.md", rc == STATUS_OK ? "two" : "one");
            directory_holds(&disk, "out/data/contact.csv", rc == STATUS_OK ? "two" : "one");
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
    assert_int_equal(exit_of(child), 0);
}

/* As another user than the one whose directories these are. */
TEST_IN_DIRECTORY(test_what_others_own_is_refused)
{
    enum { NOBODY = 65534 };
    static const struct {
        const char *name;
        mode_t mode;
    } modes[] = {{"sticky/out", 0777},
                 {"sticky/out/data", 0777},
                 {"sticky/out/figures", 0777},
                 {"sticky", 01777},
                 {"closed/out", 0777},
                 {"closed", 0555},
                 {"open", 0777},
                 {".", 0755}};
    if (geteuid() != 0)
        skip();
    publish(place, "sticky/out", "one");
    publish(place, "closed/out", "one");
    publish(place, "open/out", "one");
    for (size_t i = 0; i < sizeof modes / sizeof *modes; i++)
        assert_int_equal(chmod(directory_path(place, modes[i].name), modes[i].mode), 0);
    begin_and_die(place, "sticky/out", ""); /* is root's: stays */
    pid_t child = divide();
    if (child == 0) {
        if (setgid(NOBODY) != 0 || setuid(NOBODY) != 0)
            _exit(77);
        assert_refused(place, "closed/out", "cannot make a directory in");
        assert_refused(place, "closed/new", "cannot make a directory in");
        assert_refused(place, "open/out", "cannot write the report to");
        publish(place, "sticky/new", "one");
        _exit(directory_entries(place, "sticky") == 3 ? 0 : 78);
    }
    assert_int_equal(exit_of(child), 0);
    publish(place, "sticky/new", "two"); /* what root left, root removes */
    assert_int_equal(directory_entries(place, "sticky"), 2);
}
