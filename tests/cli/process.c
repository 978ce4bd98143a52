/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/process.h"

#include "base/hash.h"
#include "contact/effect.h"
#include "contact/model.h"
#include "material/material.h"
#include "profile/synth.h"
#include <ctype.h>
#include <errno.h>
#include <fcntl.h>
#include <fts.h>
#include <poll.h>
#include <spawn.h>
#include <strings.h>
#include <sys/wait.h>

extern char **environ;

struct process_running process_start_list(const char *place, const char *const *arguments, const char *output)
{
    struct process_running running;
    int out[2], err[2];
    posix_spawn_file_actions_t actions;
    assert_int_equal(pipe2(out, O_CLOEXEC), 0);
    assert_int_equal(pipe2(err, O_CLOEXEC), 0);
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addchdir_np(&actions, place);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    if (output)
        posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, output, O_WRONLY, 0);
    else
        posix_spawn_file_actions_adddup2(&actions, out[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, err[1], STDERR_FILENO);
    char *list[64] = {0};
    for (size_t i = 0; arguments[i]; i++) {
        assert_true(i + 1 < sizeof list / sizeof *list);
        list[i] = strdup(arguments[i]);
    }
    int error = posix_spawnp(&running.pid, list[0], &actions, NULL, list, environ);
    for (size_t i = 0; list[i]; i++)
        free(list[i]);
    posix_spawn_file_actions_destroy(&actions);
    close(out[1]);
    close(err[1]);
    running.out = out[0];
    running.err = err[0];
    if (error)
        fail_msg("cannot run '%s': %s", arguments[0], strerror(error));
    return running;
}

/** Adds what is there to read; false at the end. */
static bool collect(int descriptor, char **text, size_t *length)
{
    char block[65536];
    ssize_t got = read(descriptor, block, sizeof block);
    if (got < 0 && errno == EINTR)
        return true;
    if (got <= 0)
        return false;
    *text = realloc(*text, *length + (size_t)got + 1);
    assert_non_null(*text);
    memcpy(*text + *length, block, (size_t)got);
    *length += (size_t)got;
    (*text)[*length] = '\0';
    return true;
}

struct process process_end(struct process_running running)
{
    struct process process = {.out = strdup(""), .err = strdup("")};
    struct pollfd ends[2] = {{.fd = running.out, .events = POLLIN}, {.fd = running.err, .events = POLLIN}};
    size_t err_length = 0;
    while (ends[0].fd >= 0 || ends[1].fd >= 0) {
        if (poll(ends, 2, -1) < 0)
            continue;
        if (ends[0].revents && !collect(ends[0].fd, &process.out, &process.out_length))
            ends[0].fd = -1;
        if (ends[1].revents && !collect(ends[1].fd, &process.err, &err_length))
            ends[1].fd = -1;
    }
    close(running.out);
    close(running.err);
    int end;
    while (waitpid(running.pid, &end, 0) < 0)
        assert_int_equal(errno, EINTR);
    process.status = WIFSIGNALED(end) ? 128 + WTERMSIG(end) : WEXITSTATUS(end);
    test_owns(process.out, free);
    test_owns(process.err, free);
    return process;
}

void process_unwrap(struct process *process)
{
    char *to = process->out;
    for (const char *from = process->out; *from;) {
        size_t blanks = *from == '\n' ? strspn(from + 1, " ") : 0;
        *to++ = blanks >= 10 ? ' ' : *from;
        from += blanks >= 10 ? blanks + 1 : 1;
    }
    *to = '\0';
}

static void complain(const struct process *process, const char *what, const char *file, int line)
{
    print_error("%s; status %d, stdout:\n%.2000s\nstderr:\n%.4000s\n", what, process->status, process->out,
                process->err);
    _fail(file, line);
}

struct process process_expect(struct process process, int status, const char *file, int line)
{
    if (process.status != status)
        complain(&process, "unexpected exit status", file, line);
    return process;
}

struct process process_report(const char *place, const char *out, const char *scene, const char *file, int line)
{
    if (scene)
        directory_write(place, "d/scene.yaml", scene);
    return process_expect(process_run(place, "report", "d", "-o", out, "--no-cost"), 0, file, line);
}

void process_expect_parts(struct process process, bool out, const char *const *parts, const char *file, int line)
{
    support_parts(out ? process.out : process.err, parts, true, file, line);
}

static bool is_row_name(const char *key, bool properties)
{
    bool is = strcmp(key, "area") == 0; /* the base of the table of work */
    for (size_t m = 0; m < model_count; m++)
        is = is || strcmp(key, model_rows[m]->name) == 0;
    for (size_t p = 0; p < material_property_count && !properties; p++)
        is = is || strcmp(key, material_properties[p].key) == 0;
    for (int e = 0; e < EFFECT_COUNT; e++)
        is = is || strcmp(key, effect_rows[e].name) == 0;
    return is;
}

size_t expect_keys_described(const char *document, json_t *json, bool properties)
{
    size_t keys = 0, index;
    const char *key;
    json_t *value;
    json_object_foreach (json, key, value) {
        if (!is_row_name(key, properties))
            expect_part(document, filled("`%s`", key));
        keys += 1 + expect_keys_described(document, value, properties);
    }
    if (json_is_array(json))
        json_array_foreach (json, index, value)
            keys += expect_keys_described(document, value, properties);
    return keys;
}

void expect_narrow(const char *text)
{
    for (; *text; text += strcspn(text, "\n"), text += *text == '\n')
        if (text_width(text, strcspn(text, "\n")) > 80)
            fail_msg("wider than 80 columns: %.200s", text);
}

void process_expect_failure(struct process process, int status, size_t lines, const char *message, const char *file,
                            int line)
{
    process_expect(process, status, file, line);
    if (process.out[0])
        complain(&process, "a failure wrote to stdout", file, line);
    if (times(process.err, "\n") != lines)
        complain(&process, "unexpected number of lines on stderr", file, line);
    if (!strstr(process.err, message)) {
        print_error("missing: %s\n", message);
        complain(&process, "unexpected message", file, line);
    }
}

void workspace_scan(const char *place, const char *path, size_t points, unsigned seed)
{
    struct synth_def def = synth_def_default();
    double *height_m = support_room(points * sizeof *height_m);
    def.points = points;
    def.length_m = 0.5e-6 * (double)points;
    def.seed = seed;
    expect_ok(synth_profile, height_m, &def);
    struct text *csv = support_text();
    text_add(csv, "x [um],z [um]\n");
    for (size_t i = 0; i < points; i++)
        text_add(csv, "%.1f,%.6f\n", 0.5 * (double)i, height_m[i] * 1e6);
    directory_write(place, path, text_string(csv));
}

void workspace_scans(const char *place, const char *folder, unsigned count, size_t points, unsigned seed)
{
    for (unsigned i = 0; i < count; i++)
        workspace_scan(place, filled("%s/%c.csv", folder, (char)('a' + i)), points, seed + i);
}

void workspace_write_bytes(const char *place, const char *path, const char *bytes, size_t length)
{
    workspace_write(place, path, ""); /* makes its folder */
    expect_ok(text_write_file, directory_path(place, path), bytes, length);
}

static int by_name(const FTSENT **a, const FTSENT **b)
{
    return strcmp((*a)->fts_name, (*b)->fts_name);
}

/** Walks everything below `path`; adds names and contents to `hash` (NULL: none) and counts names with `prefix`. */
static size_t walk(const char *place, const char *path, struct hash *hash, const char *prefix)
{
    OWNED(memory_free) char *root = strdup(directory_path(place, path));
    char *roots[] = {root, NULL};
    FTS *tree = fts_open(roots, FTS_PHYSICAL | FTS_NOCHDIR, by_name);
    size_t count = 0, start = strlen(root), found = 0;
    assert_non_null(tree);
    for (FTSENT *entry; (entry = fts_read(tree));) {
        if (entry->fts_info == FTS_DP)
            continue;
        count++;
        found += prefix && strncmp(entry->fts_name, prefix, strlen(prefix)) == 0;
        if (!hash)
            continue;
        hash_add(hash, entry->fts_path + start, strlen(entry->fts_path + start) + 1);
        if (entry->fts_info != FTS_F)
            continue;
        OWNED(text_free) struct text content = {0};
        expect_ok(text_read_file, &content, entry->fts_path);
        hash_add(hash, text_string(&content), content.length + 1);
    }
    fts_close(tree);
    assert_true(count > 0);
    return found;
}

char *workspace_digest(const char *place, const char *path)
{
    char digits[65];
    struct hash hash = hash_start();
    walk(place, path, &hash, NULL);
    hash_finish(&hash, digits);
    return test_owns(strdup(digits), free);
}

void workspace_expect_digest(const char *place, const char *path, const char *digest, const char *file, int line)
{
    if (strcmp(workspace_digest(place, path), digest) != 0) {
        print_error("'%s' is not what it was\n", path);
        _fail(file, line);
    }
}

size_t workspace_count(const char *place, const char *prefix)
{
    return walk(place, ".", NULL, prefix);
}

void process_expect_numbers(const char *text, const char *where)
{
    static const char *const words[] = {"nan", "inf", "infinity"};
    for (const char *at = text; *at;) {
        size_t length = 0;
        while (isalnum((unsigned char)at[length]) || at[length] == '_')
            length++;
        for (size_t w = 0; w < sizeof words / sizeof *words; w++)
            if (strlen(words[w]) == length && strncasecmp(at, words[w], length) == 0) {
                const char *from = at - text > 60 ? at - 60 : text;
                fail_msg("%s: %.100s", where, from);
            }
        at += length ? length : 1;
    }
}

/* Characters that must not be written: controls, and those that are not visible. */
static bool is_forbidden(unsigned long code)
{
    return (code < 0x20 && code != '\n' && code != '\t') || (code >= 0x7f && code < 0xa0) || code == 0xad ||
           (code >= 0x200b && code <= 0x200f) || (code >= 0x2028 && code <= 0x202e) ||
           (code >= 0x2060 && code <= 0x206f) || code == 0x61c || code == 0xfeff ||
           (code >= 0xe0000 && code <= 0xe0fff) || (code >= 0xd800 && code <= 0xdfff) || (code & 0xfffe) == 0xfffe;
}

void process_expect_clean(const char *text, size_t length, const char *where, bool tabs)
{
    for (size_t i = 0; i < length;) {
        const unsigned char *s = (const unsigned char *)text + i;
        size_t more = *s >= 0xf0 ? 3 : *s >= 0xe0 ? 2 : *s >= 0xc0 ? 1 : 0;
        unsigned long code = more ? *s & (0x3fu >> more) : *s;
        bool good = more > 0 || *s < 0x80;
        for (size_t k = 1; k <= more; k++) {
            good = good && i + k < length && (s[k] & 0xc0) == 0x80;
            code = code << 6 | (s[k] & 0x3fu);
        }
        if (!good || is_forbidden(code) || (code == '\t' && !tabs))
            fail_msg("%s: byte %zu is 0x%02x, of U+%04lX, before: %.40s", where, i, *s, code, text + i + more + 1);
        i += more + 1;
    }
}

static size_t files_seen;

static int expect_numbers_in(const char *path, const struct stat *info, int type, struct FTW *level)
{
    (void)info;
    if (type != FTW_F)
        return 0;
    if (access(filled("%s/templates/%s", PROJECT_SOURCE, path + level->base), F_OK) == 0)
        return 0; /* gnuplot's NaN, as in the templates */
    OWNED(text_free) struct text content = {0};
    expect_ok(text_read_file, &content, path);
    process_expect_numbers(text_string(&content), path);
    files_seen++;
    return 0;
}

size_t workspace_expect_numbers(const char *place, const char *path)
{
    files_seen = 0;
    assert_int_equal(nftw(directory_path(place, path), expect_numbers_in, 16, FTW_PHYS), 0);
    return files_seen;
}

char *workspace_program(const char *place, const char *name, const char *lines)
{
    const char *file = filled("bin/%s", name);
    char *before = test_owns(strdup(getenv("PATH")), free);
    workspace_write(place, file, lines);
    assert_int_equal(chmod(directory_path(place, file), 0755), 0);
    assert_int_equal(setenv("PATH", filled("%s/bin:%s", place, before), 1), 0);
    return before;
}

void workspace_take_back(char *path)
{
    assert_int_equal(setenv("PATH", path, 1), 0);
}

bool workspace_can_run(const char *place, const char *line)
{
    return run_program(place, "sh", "-c", line).status == 0;
}

char *workspace_shell(const char *place, const char *line)
{
    return expect_status(run_program(place, "sh", "-ec", line), 0).out;
}
