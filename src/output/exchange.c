/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/exchange.h"

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

enum { FOLDERS = 4, LARGEST_MANIFEST = 1 << 20 }; /* bytes; a larger one is none of ours */
static const char *const folders[FOLDERS] = {".", "data", "figures", "export"};
static const char *const prefixes[FOLDERS] = {"", "data/", "figures/", "export/"};

/** Two reports whose files are gone over: their directories, open (itself and its folders; -1: none), and what is
 * made of them. What fails below leaves errno. */
struct visit {
    int old[FOLDERS], new[FOLDERS];
    char *listed;             /* the manifest of the former */
    FILE *manifest;           /* of the latter */
    int hidden;               /* the hidden directory in which the former is cleared away */
    bool trial;               /* nothing is to stay linked */
    char name[NAME_MAX + 16]; /* of the entry that was looked at last */
    const char *lost;         /* what it is that could be lost; "": errno says why it cannot be linked */
};

/** Opens the report `path` in the open directory `parent`, through no link. To be closed whatever comes back. */
static bool open_report(int folder[FOLDERS], int parent, const char *path)
{
    for (int i = 0; i < FOLDERS; i++)
        folder[i] = i == 0 ? temporary_open(parent, path) : folder[0] < 0 ? -1 : temporary_open(folder[0], folders[i]);
    return folder[0] >= 0;
}

static void close_report(const int folder[FOLDERS])
{
    for (int i = 0; i < FOLDERS; i++)
        if (folder[i] >= 0)
            close(folder[i]);
}

/** Visits all that lies in the folders, but themselves, in order of names, until one visit fails. */
static bool visit_all(const int folder[FOLDERS], bool (*visit)(struct visit *v, int i, const char *name),
                      struct visit *v)
{
    bool ok = true;
    for (int i = 0; i < FOLDERS; i++) {
        struct dirent **entry = NULL;
        int count = ok && folder[i] >= 0 ? scandirat(folder[i], ".", &entry, NULL, versionsort) : 0;
        ok = ok && count >= 0;
        for (int k = 0; k < count; k++) {
            const char *name = entry[k]->d_name;
            bool passed = strcmp(name, ".") == 0 || strcmp(name, "..") == 0;
            for (int f = 1; f < FOLDERS && i == 0; f++)
                passed |= folder[f] >= 0 && strcmp(name, folders[f]) == 0;
            ok = ok && (passed || visit(v, i, name));
            free(entry[k]);
        }
        free(entry);
    }
    return ok;
}

/** The manifest in a report, "" where it has none or one that is not the program's. NULL: cannot be read. */
static char *read_manifest(int report)
{
    struct stat info;
    int file = openat(report, OUTPUT_MANIFEST, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
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

/** Writes a file's line into the manifest and waits until the file is on the disk. */
static bool finish_entry(struct visit *v, int folder, const char *name)
{
    int file = openat(v->new[folder], name, O_RDONLY | O_CLOEXEC);
    bool ok = file >= 0 && fprintf(v->manifest, "%s%s\n", prefixes[folder], name) >= 0 && fsync(file) == 0;
    if (file >= 0)
        close(file);
    return ok;
}

/** Writes the manifest of all that lies in the report, itself included, and waits until the disk has it all. */
static bool finish_report(const char *path)
{
    struct visit v = {.manifest = NULL};
    int made = -1;
    if (open_report(v.new, AT_FDCWD, path))
        made = openat(v.new[0], OUTPUT_MANIFEST, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    v.manifest = made >= 0 ? fdopen(made, "w") : NULL;
    bool ok = v.manifest && fputs(OUTPUT_MANIFEST_HEADER, v.manifest) >= 0 && visit_all(v.new, finish_entry, &v) &&
              fflush(v.manifest) == 0 && fsync(made) == 0;
    for (int i = 0; i < FOLDERS && ok; i++)
        (void)!fsync(v.new[i]); /* which not every file system can */
    int reason = errno;
    if (v.manifest)
        fclose(v.manifest);
    close_report(v.new);
    errno = reason;
    return ok;
}

/** Removes a file of which there is another hard link. */
static bool remove_link(int directory, const char *name)
{
    struct stat info;
    return fstatat(directory, name, &info, AT_SYMLINK_NOFOLLOW) == 0 && !S_ISDIR(info.st_mode) && info.st_nlink > 1 &&
           unlinkat(directory, name, 0) == 0;
}

/** Removes an entry of the report before that is the program's, or is in the new report too, and leaves what came there
 * during the exchange. It is looked at as `aside`, where nobody replaces it meanwhile. False: it cannot be put back. */
static bool clear_entry(struct visit *v, int folder, const char *name)
{
    static const char aside[] = "aside";
    struct stat info;
    int from = v->old[folder];
    bool manifest = folder == 0 && strcmp(name, OUTPUT_MANIFEST) == 0; /* goes last */
    if (manifest || fstatat(from, name, &info, AT_SYMLINK_NOFOLLOW) != 0 || S_ISDIR(info.st_mode))
        return true;
    if (S_ISREG(info.st_mode) && is_listed(v->listed, folder, name))
        return unlinkat(from, name, 0) == 0;
    return renameat(from, name, v->hidden, aside) != 0 || remove_link(v->hidden, aside) ||
           renameat2(v->hidden, aside, from, name, RENAME_NOREPLACE) == 0;
}

/** Removes the report before, `done` in the hidden directory. False: something has to stay. Killed halfway, the next
 * run goes on with it, as the manifest goes last. */
static bool clear_before(int hidden)
{
    struct visit v = {.hidden = hidden};
    if (!open_report(v.old, hidden, "done"))
        return errno == ENOENT;
    v.listed = read_manifest(v.old[0]);
    bool ok = v.listed && visit_all(v.old, clear_entry, &v);
    for (int i = 1; i < FOLDERS && ok; i++)
        unlinkat(v.old[0], folders[i], AT_REMOVEDIR);
    if (ok && is_listed(v.listed, 0, OUTPUT_MANIFEST))
        unlinkat(v.old[0], OUTPUT_MANIFEST, 0);
    free(v.listed);
    close_report(v.old);
    return ok && unlinkat(hidden, "done", AT_REMOVEDIR) == 0;
}

void exchange_clear(int hidden)
{
    if (remove_link(hidden, "aside") || faccessat(hidden, "aside", F_OK, AT_SYMLINK_NOFOLLOW) != 0)
        (void)clear_before(hidden);
    temporary_remove_entry(hidden, "report");
}

/** Links an entry of OUT into the report in the making when it is a file of the user's: both directories then hold it,
 * whichever a kill leaves at OUT. `trial` takes the link away again. */
static bool keep_entry(struct visit *v, int folder, const char *name)
{
    struct stat info;
    snprintf(v->name, sizeof v->name, "%s%s", prefixes[folder], name);
    if (fstatat(v->old[folder], name, &info, AT_SYMLINK_NOFOLLOW) != 0)
        return true; /* gone meanwhile */
    bool listed = is_listed(v->listed, folder, name);
    if (listed && S_ISREG(info.st_mode))
        return true;
    if (listed)
        v->lost = "which is in the place of a file of the report but is none";
    else if (!*v->listed && *v->name != '.')
        v->lost =
            "and no " OUTPUT_MANIFEST " names it as part of a report (a report of an earlier version: remove it first)";
    else if (S_ISDIR(info.st_mode))
        v->lost = "a directory, which is not part of a report";
    temporary_hold(); /* the end comes between two */
    if (!v->lost && linkat(v->old[folder], name, v->new[folder], name, 0) != 0 && errno != ENOENT)
        v->lost = errno == EEXIST ? "which is not of the report before, and the new one needs its name" : "";
    else if (!v->lost && v->trial)
        unlinkat(v->new[folder], name, 0);
    temporary_release();
    return !v->lost;
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
static enum status_code keep_others(const struct exchange *out, bool trial, struct status *status)
{
    struct visit v = {.new = {-1, -1, -1, -1}, .trial = trial};
    if (!open_report(v.old, AT_FDCWD, out->target) && errno == ENOENT)
        return STATUS_OK;
    bool ok = v.old[0] >= 0 && open_report(v.new, AT_FDCWD, out->staging) && (v.listed = read_manifest(v.old[0]));
    for (int i = 0; i < FOLDERS && ok; i++) {
        strcpy(v.name, folders[i]);
        ok = faccessat(v.old[0], v.name, W_OK | X_OK, 0) == 0 || errno == ENOENT;
    }
    ok = ok && visit_all(v.old, keep_entry, &v);
    for (int i = 0; i < FOLDERS && ok && !trial; i++)
        ok = v.old[i] < 0 || take_attributes(v.old[i], v.new[i]);
    if (v.lost && *v.lost)
        (void)status_fail(status, STATUS_IO, "'%s' holds '%s', %s; move it away or choose another directory with -o",
                          out->target, v.name, v.lost);
    else if (!ok)
        (void)status_fail(status, STATUS_IO, "cannot write the report to '%s%s%s': %s", out->target, *v.name ? "/" : "",
                          v.name, strerror(errno));
    free(v.listed);
    close_report(v.old);
    close_report(v.new);
    return status->code;
}

/** Makes every directory on the way to the target, itself excluded, and notes the first that was missing. */
static enum status_code make_parents(struct exchange *out, struct status *status)
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

/** Stores the path of OUT without slashes at its end, of a link where it leads, and of the directory around it. */
static enum status_code set_target(struct exchange *out, char parent[static PATH_MAX], const char *target,
                                   struct status *status)
{
    struct stat info;
    char real[PATH_MAX];
    size_t length = strlen(target);
    while (length > 1 && target[length - 1] == '/')
        length--;
    snprintf(out->target, sizeof out->target, "%.*s", (int)length, target);
    if (length < sizeof out->target && lstat(out->target, &info) == 0 && S_ISLNK(info.st_mode)) {
        if (!realpath(out->target, real))
            return status_fail(status, STATUS_IO, "'%s' is a link that leads nowhere; remove it", out->target);
        length = strlen(strcpy(out->target, real));
    }
    if (length + 64 >= sizeof out->target)
        return status_fail(status, STATUS_IO, "the name of the report directory is too long");
    const char *slash = strrchr(out->target, '/'), *name = slash ? slash + 1 : out->target;
    if (*name == '\0' || strcmp(name, ".") == 0 || strcmp(name, "..") == 0)
        return status_fail(status, STATUS_USAGE, "'%s' is no name for a report's directory; name one, such as ./report",
                           target);
    snprintf(parent, PATH_MAX, "%.*s", slash ? (int)(name - out->target) : 1, slash ? out->target : ".");
    return STATUS_OK;
}

enum status_code exchange_begin(struct exchange *out, const char *target, struct status *status)
{
    char path[PATH_MAX + 16], parent[PATH_MAX];
    struct statx info;
    *out = (struct exchange){0};
    if (set_target(out, parent, target, status) != STATUS_OK || make_parents(out, status) != STATUS_OK)
        return status->code;
    if (statx(AT_FDCWD, out->target, AT_SYMLINK_NOFOLLOW, STATX_BASIC_STATS, &info) == 0 &&
        (info.stx_attributes & STATX_ATTR_MOUNT_ROOT) != 0)
        return status_fail(status, STATUS_IO,
                           "'%s' is a mount point, which a report cannot take the place of; name a directory in it",
                           out->target);
    temporary_note("", out->target, " is as it was before");
    if (temporary_make(&out->hidden, parent, exchange_clear, status) != STATUS_OK)
        return status->code;
    snprintf(out->staging, sizeof out->staging, "%.*s/report", PATH_MAX - 16, out->hidden.path);
    for (int i = 0; i < FOLDERS; i++) {
        snprintf(path, sizeof path, "%s%s%s", out->staging, i > 0 ? "/" : "", i > 0 ? folders[i] : "");
        if (mkdir(path, 0777) != 0)
            return status_fail(status, STATUS_IO, "cannot make '%s': %s", path, strerror(errno));
    }
    return keep_others(out, true, status);
}

/** Puts `staging` in the place of OUT; what was there, if anything, is then in the place of `staging`. */
static enum status_code exchange(const struct exchange *out, const char *kept, struct status *status)
{
    bool done = renameat2(AT_FDCWD, out->staging, AT_FDCWD, out->target, RENAME_EXCHANGE) == 0;
    if (!done && (errno == EINVAL || errno == ENOSYS || errno == ENOENT)) { /* it cannot; none is there */
        bool moved = rename(out->target, kept) == 0;
        done = (moved || errno == ENOENT) && rename(out->staging, out->target) == 0;
        int reason = errno;
        if (moved)
            (void)!rename(kept, done ? out->staging : out->target);
        errno = reason;
    }
    return done ? STATUS_OK
                : status_fail(status, STATUS_IO,
                              "cannot put the report at '%s': %s; the one before, if it is not there, is in '%s'",
                              out->target, status_reason(errno), kept);
}

enum status_code exchange_commit(struct exchange *out, struct status *status)
{
    char kept[PATH_MAX], done[PATH_MAX];
    snprintf(kept, sizeof kept, "%.*s.kept%s", PATH_MAX - 16, out->target, strrchr(out->hidden.path, '-'));
    snprintf(done, sizeof done, "%.*s/done", PATH_MAX - 16, out->hidden.path);
    if (!finish_report(out->staging) || rename(out->staging, done) != 0)
        return status_fail(status, STATUS_IO, "cannot put the report at '%s': %s", out->target, status_reason(errno));
    strcpy(out->staging, done);
    if (keep_others(out, false, status) != STATUS_OK)
        return status->code;
    unlinkat(out->hidden.directory, "done/export", AT_REMOVEDIR); /* of a run that was asked for none */
    temporary_hold();                                             /* a signal comes before it or after */
    if (exchange(out, kept, status) == STATUS_OK) {
        temporary_note("the report is in ", out->target, "");
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

void exchange_abandon(struct exchange *out)
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
