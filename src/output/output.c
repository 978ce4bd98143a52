/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/output.h"

#include "output/manifest.h"
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

/* The report before, and what of it is not the program's, once the new one is in its place. */
struct clearing {
    int hidden;              /* the directory around it */
    struct folders old, new; /* the report before; the new one, of which a later run knows nothing */
    struct names listed;     /* what the manifest of the former names */
};

/** Removes an entry of the report before when it is the program's or in the new report too; else it came there during
 * the exchange, and is moved to the new one, in the place of nothing. False: it stays. Files that are not listed are
 * looked at as `aside`, where nobody replaces them meanwhile. */
static bool clear_entry(const struct clearing *c, const char *name)
{
    static const char aside[] = "aside";
    struct stat before, after;
    const char *base;
    int to = folders_in(&c->new, name, &base), from = folders_in(&c->old, name, &base);
    bool listed = names_have(&c->listed, name);
    if (fstatat(from, base, &before, AT_SYMLINK_NOFOLLOW) != 0)
        return true;
    if (listed && S_ISREG(before.st_mode))
        return unlinkat(from, base, 0) == 0;
    if (c->new.at[0] < 0) /* the other name of a file of the user's */
        return !S_ISDIR(before.st_mode) && before.st_nlink > 1 && unlinkat(from, base, 0) == 0;
    if (S_ISDIR(before.st_mode))
        return renameat(from, base, to, base) == 0;
    if (renameat(from, base, c->hidden, aside) != 0 || fstatat(c->hidden, aside, &before, AT_SYMLINK_NOFOLLOW) != 0)
        return errno == ENOENT;
    bool both = fstatat(to, base, &after, AT_SYMLINK_NOFOLLOW) == 0 && before.st_dev == after.st_dev &&
                before.st_ino == after.st_ino;
    if (both || linkat(c->hidden, aside, to, base, 0) == 0)
        return unlinkat(c->hidden, aside, 0) == 0;
    (void)!renameat2(c->hidden, aside, from, base, RENAME_NOREPLACE);
    return false;
}

/** Removes the report before, `done` in the hidden directory, its manifest last: killed halfway, the next run still has
 * it. False when something has to stay. Without a `target`: what a killed run has left, none of which comes to OUT. */
static bool clear_before(int hidden, const char *target)
{
    enum { PASSES = 3 }; /* a file may come between the list and the end of its directory */
    struct clearing c = {.hidden = hidden, .new = {{-1, -1, -1}}};
    bool gone = false, ok;
    if (!folders_open(&c.old, hidden, "done"))
        return errno == ENOENT;
    ok = (!target || folders_open(&c.new, AT_FDCWD, target)) && names_read(&c.listed, &c.old);
    for (int pass = 0; pass < PASSES && ok && !gone; pass++) {
        struct names names = {0};
        ok = names_list(&names, &c.old);
        for (size_t i = 0; i < names.count && ok; i++)
            ok = strcmp(names.at[i], MANIFEST_NAME) == 0 || clear_entry(&c, names.at[i]);
        for (int i = 1; i < FOLDERS && ok; i++)
            unlinkat(c.old.at[0], folder_names[i], AT_REMOVEDIR);
        gone = ok && clear_entry(&c, MANIFEST_NAME) && unlinkat(hidden, "done", AT_REMOVEDIR) == 0;
        names_free(&names);
    }
    names_free(&c.listed);
    folders_close(&c.old);
    folders_close(&c.new);
    return gone;
}

void output_clear(int hidden)
{
    const struct clearing rest = {.hidden = hidden, .old = {{hidden, -1, -1}}, .new = {{-1, -1, -1}}};
    (void)clear_before(hidden, NULL);
    (void)clear_entry(&rest, "aside");
    temporary_remove_entry(hidden, "report");
}

/** Links an entry of OUT into the report in the making when it is a file of the user's: both directories then hold it,
 * whichever a kill leaves at OUT. `trial` takes the link away again. Returns NULL or what it is that could be lost;
 * "": errno says why it cannot be linked. */
static const char *keep_entry(const struct clearing *c, const char *name, bool trial)
{
    struct stat info;
    const char *base;
    int old = folders_in(&c->old, name, &base), new = folders_in(&c->new, name, &base);
    if (fstatat(old, base, &info, AT_SYMLINK_NOFOLLOW) != 0)
        return NULL; /* gone meanwhile */
    if (names_have(&c->listed, name))
        return S_ISREG(info.st_mode) ? NULL : "which is in the place of a file of the report but is none";
    if (c->listed.count == 0 && *name != '.')
        return "and no " MANIFEST_NAME
               " names it as part of a report (a report of an earlier version: remove it first)";
    if (S_ISDIR(info.st_mode))
        return "a directory, which is not part of a report";
    if (linkat(old, base, new, base, 0) != 0)
        return errno == ENOENT   ? NULL
               : errno == EEXIST ? "which is not of the report before, and the new one needs its name"
                                 : "";
    if (trial)
        unlinkat(new, base, 0);
    return NULL;
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
    struct clearing c = {.new = {{-1, -1, -1}}};
    struct names entries = {0};
    const char *name = "", *lost = NULL;
    if (!folders_open(&c.old, AT_FDCWD, out->target) && errno == ENOENT)
        return STATUS_OK;
    bool ok = c.old.at[0] >= 0 && folders_open(&c.new, AT_FDCWD, out->staging) && names_read(&c.listed, &c.old) &&
              names_list(&entries, &c.old);
    for (int i = 0; i < FOLDERS && ok; i++)
        ok = faccessat(c.old.at[0], name = folder_names[i], W_OK | X_OK, 0) == 0 || errno == ENOENT;
    for (size_t i = 0; i < entries.count && ok; i++) {
        temporary_hold(); /* the end comes between two */
        ok = !(lost = keep_entry(&c, name = entries.at[i], trial));
        temporary_release();
    }
    for (int i = 0; i < FOLDERS && ok && !trial; i++)
        ok = c.old.at[i] < 0 || take_attributes(c.old.at[i], c.new.at[i]);
    if (lost && *lost)
        (void)status_fail(status, STATUS_IO, "'%s' holds '%s', %s; move it away or choose another directory with -o",
                          out->target, name, lost);
    else if (!ok)
        (void)status_fail(status, STATUS_IO, "cannot write the report to '%s%s%s': %s", out->target, *name ? "/" : "",
                          name, strerror(errno));
    names_free(&entries);
    names_free(&c.listed);
    folders_close(&c.old);
    folders_close(&c.new);
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
    struct folders folders;
    snprintf(kept, sizeof kept, "%.*s.kept%s", PATH_MAX - 16, out->target, strrchr(out->hidden.path, '-'));
    snprintf(done, sizeof done, "%.*s/done", PATH_MAX - 16, out->hidden.path);
    bool written = folders_open(&folders, AT_FDCWD, out->staging) && manifest_write(&folders);
    folders_close(&folders);
    if (!written || rename(out->staging, done) != 0)
        return status_fail(status, STATUS_IO, "cannot put the report at '%s': %s", out->target, status_reason(errno));
    strcpy(out->staging, done);
    if (keep_others(out, false, status) != STATUS_OK)
        return status->code;
    temporary_hold(); /* a signal comes before it or after */
    if (exchange(out, kept, status) == STATUS_OK) {
        note("the report is in ", out, "");
        temporary_forget(&out->hidden); /* what may be left there is the user's */
        out->staging[0] = '\0';
        if (!clear_before(out->hidden.directory, out->target)) {
            const char *where = rename(out->hidden.path, kept) == 0 ? strcpy(out->hidden.path, kept) : out->hidden.path;
            (void)status_fail(status, STATUS_IO,
                              "the report is in '%s', but what was put there meanwhile could not be moved into it; it "
                              "is in '%s'",
                              out->target, where);
        }
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
