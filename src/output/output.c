/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/output.h"

#include <assert.h>
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

enum { FOLDERS = 3, LARGEST_MANIFEST = 1 << 20 }; /* bytes; a larger one is none of ours */
static const char *const folder_names[FOLDERS] = {".", "data", "figures"};
static const char *const prefixes[FOLDERS] = {"", "data/", "figures/"};

/** A report's directories, open: itself, data and figures; -1: none. What fails below leaves errno. */
struct report {
    int folder[FOLDERS];
};

static int open_directory(int parent, const char *name)
{
    return openat(parent, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
}

/** Opens the report `path` in the open directory `parent`, through no link. To be closed whatever comes back. */
static bool open_report(struct report *out, int parent, const char *path)
{
    *out = (struct report){{open_directory(parent, path), -1, -1}};
    for (int i = 1; i < FOLDERS && out->folder[0] >= 0; i++)
        out->folder[i] = open_directory(out->folder[0], folder_names[i]);
    return out->folder[0] >= 0;
}

static void close_report(const struct report *report)
{
    for (int i = 0; i < FOLDERS; i++)
        if (report->folder[i] >= 0)
            close(report->folder[i]);
}

/** Visits all that lies in the folders, but themselves, in order of names, until one visit fails. */
static bool visit_all(const struct report *report, bool (*visit)(void *context, int folder, const char *name),
                      void *context)
{
    bool ok = true;
    for (int i = 0; i < FOLDERS; i++) {
        struct dirent **entry = NULL;
        int count = ok && report->folder[i] >= 0 ? scandirat(report->folder[i], ".", &entry, NULL, versionsort) : 0;
        ok = ok && count >= 0;
        for (int k = 0; k < count; k++) {
            const char *name = entry[k]->d_name;
            bool passed = strcmp(name, ".") == 0 || strcmp(name, "..") == 0;
            for (int f = 1; f < FOLDERS && i == 0; f++)
                passed |= report->folder[f] >= 0 && strcmp(name, folder_names[f]) == 0;
            ok = ok && (passed || visit(context, i, name));
            free(entry[k]);
        }
        free(entry);
    }
    return ok;
}

/** The manifest in a report, "" where it has none or one that is not the program's. NULL: cannot be read. */
static char *read_manifest(const struct report *report)
{
    struct stat info;
    int file = openat(report->folder[0], OUTPUT_MANIFEST, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    bool ours = file >= 0 && fstat(file, &info) == 0 && S_ISREG(info.st_mode) && info.st_size <= LARGEST_MANIFEST;
    char *text = calloc(1, ours ? (size_t)info.st_size + 1 : 1);
    if (text && ours && read(file, text, (size_t)info.st_size) != info.st_size) {
        free(text);
        text = NULL;
    }
    if (text && strncmp(text, OUTPUT_MANIFEST_HEADER, strlen(OUTPUT_MANIFEST_HEADER)) != 0)
        *text = '\0';
    if (file >= 0)
        close(file);
    return text;
}

static bool is_listed(const char *manifest, int folder, const char *name)
{
    char line[NAME_MAX + 16];
    snprintf(line, sizeof line, "\n%s%s\n", prefixes[folder], name);
    return !strchr(name, '\n') && strstr(manifest, line);
}

static bool list_entry(void *stream, int folder, const char *name)
{
    assert(!strchr(name, '\n'));
    return fprintf(stream, "%s%s\n", prefixes[folder], name) >= 0;
}

/** Waits until a file is on the disk. */
static bool save_entry(void *context, int folder, const char *name)
{
    const struct report *report = context;
    int file = openat(report->folder[folder], name, O_RDONLY | O_CLOEXEC);
    bool ok = file >= 0 && fsync(file) == 0;
    if (file >= 0)
        close(file);
    return ok;
}

/** Writes the manifest of all that lies in the report, itself included, and waits until the disk has it all. */
static bool finish_report(const char *path)
{
    struct report report;
    int made = -1;
    if (open_report(&report, AT_FDCWD, path))
        made = openat(report.folder[0], OUTPUT_MANIFEST, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    FILE *stream = made >= 0 ? fdopen(made, "w") : NULL;
    bool ok = stream && fputs(OUTPUT_MANIFEST_HEADER, stream) >= 0 && visit_all(&report, list_entry, stream) &&
              fflush(stream) == 0 && visit_all(&report, save_entry, &report);
    for (int i = 0; i < FOLDERS && ok; i++)
        (void)!fsync(report.folder[i]); /* which not every file system can */
    int reason = errno;
    if (stream)
        fclose(stream);
    close_report(&report);
    errno = reason;
    return ok;
}

/** The report before, out of its place, in the hidden directory. */
struct clearing {
    int hidden;
    struct report old;
    char *listed; /* its manifest */
};

/** Removes a file of which there is another hard link. */
static bool remove_link(int directory, const char *name)
{
    struct stat info;
    return fstatat(directory, name, &info, AT_SYMLINK_NOFOLLOW) == 0 && !S_ISDIR(info.st_mode) && info.st_nlink > 1 &&
           unlinkat(directory, name, 0) == 0;
}

/** Removes an entry of the report before that is the program's, or is in the new report too, and leaves what came there
 * during the exchange. It is looked at as `aside`, where nobody replaces it meanwhile. False: it cannot be put back. */
static bool clear_entry(void *context, int folder, const char *name)
{
    static const char aside[] = "aside";
    const struct clearing *c = context;
    struct stat info;
    int from = c->old.folder[folder];
    bool manifest = folder == 0 && strcmp(name, OUTPUT_MANIFEST) == 0; /* goes last */
    if (manifest || fstatat(from, name, &info, AT_SYMLINK_NOFOLLOW) != 0 || S_ISDIR(info.st_mode))
        return true;
    if (S_ISREG(info.st_mode) && is_listed(c->listed, folder, name))
        return unlinkat(from, name, 0) == 0;
    return renameat(from, name, c->hidden, aside) != 0 || remove_link(c->hidden, aside) ||
           renameat2(c->hidden, aside, from, name, RENAME_NOREPLACE) == 0;
}

/** Removes the report before, `done` in the hidden directory. False: something has to stay. Killed halfway, the next
 * run goes on with it, as the manifest goes last. */
static bool clear_before(int hidden)
{
    struct clearing c = {.hidden = hidden};
    if (!open_report(&c.old, hidden, "done"))
        return errno == ENOENT;
    c.listed = read_manifest(&c.old);
    bool ok = c.listed && visit_all(&c.old, clear_entry, &c);
    for (int i = 1; i < FOLDERS && ok; i++)
        unlinkat(c.old.folder[0], folder_names[i], AT_REMOVEDIR);
    if (ok && is_listed(c.listed, 0, OUTPUT_MANIFEST))
        unlinkat(c.old.folder[0], OUTPUT_MANIFEST, 0);
    free(c.listed);
    close_report(&c.old);
    return ok && unlinkat(hidden, "done", AT_REMOVEDIR) == 0;
}

void output_clear(int hidden)
{
    if (remove_link(hidden, "aside") || faccessat(hidden, "aside", F_OK, AT_SYMLINK_NOFOLLOW) != 0)
        (void)clear_before(hidden);
    temporary_remove_entry(hidden, "report");
}

/** The user's files on their way into the new report. */
struct keeping {
    struct report old, new;
    char *listed; /* the manifest of the former */
    bool trial;
    char name[NAME_MAX + 16]; /* of the entry that was looked at last */
    const char *lost;         /* what it is that could be lost; "": errno says why it cannot be linked */
};

/** Links an entry of OUT into the report in the making when it is a file of the user's: both directories then hold it,
 * whichever a kill leaves at OUT. `trial` takes the link away again. */
static bool keep_entry(void *context, int folder, const char *name)
{
    struct keeping *k = context;
    struct stat info;
    int old = k->old.folder[folder], new = k->new.folder[folder];
    snprintf(k->name, sizeof k->name, "%s%s", prefixes[folder], name);
    if (fstatat(old, name, &info, AT_SYMLINK_NOFOLLOW) != 0)
        return true; /* gone meanwhile */
    if (is_listed(k->listed, folder, name) && S_ISREG(info.st_mode))
        return true;
    if (is_listed(k->listed, folder, name))
        k->lost = "which is in the place of a file of the report but is none";
    else if (!*k->listed && *k->name != '.')
        k->lost =
            "and no " OUTPUT_MANIFEST " names it as part of a report (a report of an earlier version: remove it first)";
    else if (S_ISDIR(info.st_mode))
        k->lost = "a directory, which is not part of a report";
    temporary_hold(); /* the end comes between two */
    if (!k->lost && linkat(old, name, new, name, 0) != 0 && errno != ENOENT)
        k->lost = errno == EEXIST ? "which is not of the report before, and the new one needs its name" : "";
    else if (!k->lost && k->trial)
        unlinkat(new, name, 0);
    temporary_release();
    return !k->lost;
}

/** Gives a directory the mode, the group and the extended attributes of another. */
static bool take_attributes(int from, int to)
{
    char names[1 << 14], value[1 << 14];
    struct stat info;
    if (fstat(from, &info) != 0)
        return false;
    mode_t mode = info.st_mode & 07777;
    if (fchown(to, (uid_t)-1, info.st_gid) != 0)
        mode &= ~(mode_t)(S_ISGID | S_IRWXG); /* not for another group than it was */
    if (fchmod(to, mode) != 0)
        return false;
    ssize_t length = flistxattr(from, names, sizeof names), size;
    for (const char *name = names; name < names + length; name += strlen(name) + 1)
        if ((size = fgetxattr(from, name, value, sizeof value)) >= 0 &&
            fsetxattr(to, name, value, (size_t)size, 0) != 0 && strncmp(name, "user.", 5) == 0)
            return false; /* others may be root's to give */
    return true;
}

/** Goes over all that lies in OUT (there may be no such directory) by keep_entry(). */
static enum status_code keep_others(const struct output *out, bool trial, struct status *status)
{
    struct keeping k = {.new = {{-1, -1, -1}}, .trial = trial};
    if (!open_report(&k.old, AT_FDCWD, out->target) && errno == ENOENT)
        return STATUS_OK;
    bool ok = k.old.folder[0] >= 0 && open_report(&k.new, AT_FDCWD, out->staging) && (k.listed = read_manifest(&k.old));
    for (int i = 0; i < FOLDERS && ok; i++) {
        strcpy(k.name, folder_names[i]);
        ok = faccessat(k.old.folder[0], k.name, W_OK | X_OK, 0) == 0 || errno == ENOENT;
    }
    ok = ok && visit_all(&k.old, keep_entry, &k);
    for (int i = 0; i < FOLDERS && ok && !trial; i++)
        ok = k.old.folder[i] < 0 || take_attributes(k.old.folder[i], k.new.folder[i]);
    if (k.lost && *k.lost)
        (void)status_fail(status, STATUS_IO, "'%s' holds '%s', %s; move it away or choose another directory with -o",
                          out->target, k.name, k.lost);
    else if (!ok)
        (void)status_fail(status, STATUS_IO, "cannot write the report to '%s%s%s': %s", out->target, *k.name ? "/" : "",
                          k.name, strerror(errno));
    free(k.listed);
    close_report(&k.old);
    close_report(&k.new);
    return status->code;
}

/** Makes every directory on the way to the target, itself excluded, and notes the first that was missing. */
static enum status_code make_parents(struct output *out, struct status *status)
{
    char part[PATH_MAX];
    snprintf(part, sizeof part, "%s", out->target);
    for (char *slash = strchr(part + 1, '/'); slash; slash = strchr(slash + 1, '/')) {
        *slash = '\0';
        if (mkdir(part, 0777) == 0)
            out->made = out->made ? out->made : strlen(part);
        else if (errno != EEXIST)
            return status_fail(status, STATUS_IO, "cannot make directory '%s': %s", part, strerror(errno));
        *slash = '/';
    }
    return STATUS_OK;
}

/** The last part of OUT's path. */
static const char *name_of(const struct output *out)
{
    const char *slash = strrchr(out->target, '/');
    return slash ? slash + 1 : out->target;
}

/** Stores the path of OUT without slashes at its end; of a link, where it leads. */
static enum status_code set_target(struct output *out, const char *target, struct status *status)
{
    struct stat info;
    size_t length = strlen(target);
    while (length > 1 && target[length - 1] == '/')
        length--;
    snprintf(out->target, sizeof out->target, "%.*s", (int)length, target);
    if (length < sizeof out->target && lstat(out->target, &info) == 0 && S_ISLNK(info.st_mode)) {
        char *real = realpath(out->target, NULL);
        if (!real)
            return status_fail(status, STATUS_IO, "'%s' is a link that leads nowhere; remove it", out->target);
        length = strlen(real);
        snprintf(out->target, sizeof out->target, "%s", real);
        free(real);
    }
    if (length + 64 >= sizeof out->target)
        return status_fail(status, STATUS_IO, "the name of the report directory is too long");
    const char *name = name_of(out);
    if (*name == '\0' || strcmp(name, ".") == 0 || strcmp(name, "..") == 0)
        return status_fail(status, STATUS_USAGE, "'%s' is no name for a report's directory; name one, such as ./report",
                           target);
    return STATUS_OK;
}

/** What could not be replaced once the report is there; known before. */
static enum status_code check_place(const struct output *out, const char *parent, struct status *status)
{
    struct statx info, around;
    if (statx(AT_FDCWD, parent, 0, STATX_BASIC_STATS, &around) != 0)
        return status_fail(status, STATUS_IO, "cannot write beside '%s': %s", out->target, strerror(errno));
    for (int i = 0; i < FOLDERS; i++) {
        char path[PATH_MAX + 16];
        snprintf(path, sizeof path, "%s%s%s", out->target, i > 0 ? "/" : "", i > 0 ? folder_names[i] : "");
        if (statx(AT_FDCWD, path, AT_SYMLINK_NOFOLLOW, STATX_BASIC_STATS, &info) != 0)
            continue;
        if ((info.stx_attributes & STATX_ATTR_MOUNT_ROOT) != 0 || info.stx_dev_major != around.stx_dev_major ||
            info.stx_dev_minor != around.stx_dev_minor)
            return status_fail(status, STATUS_IO,
                               "'%s' is a mount point, which a report cannot take the place of; name a directory in it "
                               "with -o",
                               path);
        bool others = i == 0 && (around.stx_mode & S_ISVTX) != 0 && geteuid() != 0 && info.stx_uid != geteuid() &&
                      around.stx_uid != geteuid();
        if (others || ((info.stx_attributes | around.stx_attributes) & (STATX_ATTR_IMMUTABLE | STATX_ATTR_APPEND)) != 0)
            return status_fail(status, STATUS_IO, "'%s' is %s; choose another directory with -o", path,
                               others ? "another user's, and only they can replace it" : "immutable");
    }
    return STATUS_OK;
}

/** What to say should the program be made to end. */
static void note(const char *before, const struct output *out, const char *after)
{
    char text[PATH_MAX + 64];
    snprintf(text, sizeof text, "%s'%s'%s", before, out->target, after);
    temporary_note(text);
}

enum status_code output_begin(struct output *out, const char *target, struct status *status)
{
    char path[PATH_MAX + 16];
    *out = (struct output){0};
    if (set_target(out, target, status) != STATUS_OK || make_parents(out, status) != STATUS_OK)
        return status->code;
    int length = (int)(name_of(out) - out->target);
    snprintf(path, sizeof path, "%.*s", length ? length : 1, length ? out->target : ".");
    if (check_place(out, path, status) != STATUS_OK)
        return status->code;
    note("", out, " is as it was before");
    if (temporary_make(&out->hidden, path, output_clear, status) != STATUS_OK)
        return status->code;
    snprintf(out->staging, sizeof out->staging, "%.*s/report", PATH_MAX - 16, out->hidden.path);
    for (int i = 0; i < FOLDERS; i++) {
        snprintf(path, sizeof path, "%s%s%s", out->staging, i > 0 ? "/" : "", i > 0 ? folder_names[i] : "");
        if (mkdir(path, 0777) != 0)
            return status_fail(status, STATUS_IO, "cannot make '%s': %s", path, strerror(errno));
    }
    return keep_others(out, true, status);
}

/** Puts `staging` in the place of OUT; what was there, if anything, is then in the place of `staging`. */
static enum status_code exchange(const struct output *out, const char *kept, struct status *status)
{
    if (renameat2(AT_FDCWD, out->staging, AT_FDCWD, out->target, RENAME_EXCHANGE) == 0)
        return STATUS_OK;
    if ((errno == EINVAL || errno == ENOSYS) && /* a file system that cannot: clear the way, then rename */
        rename(out->target, kept) == 0) {
        if (rename(out->staging, out->target) == 0 && rename(kept, out->staging) == 0)
            return STATUS_OK;
        int reason = errno;
        if (rename(kept, out->target) != 0)
            return status_fail(status, STATUS_IO, "cannot put the report at '%s' (%s); the one before is in '%s'",
                               out->target, strerror(reason), kept);
        errno = reason;
    }
    if (errno == ENOENT && rename(out->staging, out->target) == 0)
        return STATUS_OK;
    return status_fail(status, STATUS_IO, "cannot put the report at '%s': %s", out->target, strerror(errno));
}

enum status_code output_commit(struct output *out, struct status *status)
{
    char kept[PATH_MAX], done[PATH_MAX];
    snprintf(kept, sizeof kept, "%.*s.kept%s", PATH_MAX - 16, out->target, strrchr(out->hidden.path, '-'));
    snprintf(done, sizeof done, "%.*s/done", PATH_MAX - 16, out->hidden.path);
    if (!finish_report(out->staging) || rename(out->staging, done) != 0)
        return status_fail(status, STATUS_IO, "cannot put the report at '%s': %s", out->target, status_reason(errno));
    strcpy(out->staging, done);
    if (keep_others(out, false, status) != STATUS_OK)
        return status->code;
    temporary_hold(); /* a signal comes before it or after */
    if (exchange(out, kept, status) == STATUS_OK) {
        note("the report is in ", out, "");
        out->staging[0] = '\0';
        if (!clear_before(out->hidden.directory))
            (void)status_fail(status, STATUS_IO,
                              "the report is in '%s'; what was put there while it took its place is in '%s'",
                              out->target, rename(out->hidden.path, kept) == 0 ? kept : out->hidden.path);
        temporary_close(&out->hidden);
    }
    temporary_release();
    return status->code;
}

void output_abandon(struct output *out)
{
    if (out->hidden.path[0])
        temporary_remove(&out->hidden);
    out->staging[0] = '\0';
    for (char *slash; out->made && (slash = strrchr(out->target, '/')) && (size_t)(slash - out->target) >= out->made;) {
        *slash = '\0'; /* the parents made for it: those that are empty go */
        if (rmdir(out->target) != 0)
            break;
    }
    out->made = 0;
}
