/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/output.h"

#include "base/leftover.h"
#include "output/manifest.h"
#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static int open_directory(const char *path)
{
    return open(path, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
}

/** Refuses an entry of OUT that could be lost, and links it into the report in the making when it is a file of the
 * user's: both directories then hold it, whichever a kill leaves at OUT. `trial` takes the link away again. */
static enum status_code keep_entry(const struct output *out, int old, int new, const char *name,
                                   const struct text *manifest, bool trial, struct status *status)
{
    static const char remedy[] = "move it away or choose another directory with -o";
    struct stat info;
    if (fstatat(old, name, &info, AT_SYMLINK_NOFOLLOW) != 0)
        return STATUS_OK; /* gone meanwhile */
    if (manifest_lists(manifest, name))
        return S_ISREG(info.st_mode)
                   ? STATUS_OK
                   : status_fail(status, STATUS_IO, "'%s/%s' is in the place of a file of the report but is none; %s",
                                 out->target, name, remedy);
    if (!manifest->length && *name != '.')
        return status_fail(status, STATUS_IO,
                           "'%s' holds '%s', and no " MANIFEST_NAME " names it as part of a report; choose another "
                           "directory with -o (a report of an earlier version: remove it first)",
                           out->target, name);
    if (S_ISDIR(info.st_mode))
        return status_fail(status, STATUS_IO, "'%s' holds the directory '%s', which is not part of a report; %s",
                           out->target, name, remedy);
    if (linkat(old, name, new, name, 0) == 0) {
        if (trial)
            unlinkat(new, name, 0);
        return STATUS_OK;
    }
    if (errno == ENOENT)
        return STATUS_OK;
    if (errno == EEXIST)
        return status_fail(status, STATUS_IO, "'%s/%s' is not of the report before, and the new one needs its name; %s",
                           out->target, name, remedy);
    return status_fail(status, STATUS_IO, "cannot keep '%s/%s' in the new report: %s; %s", out->target, name,
                       strerror(errno), remedy);
}

/** Goes over all that lies in OUT (there may be no such directory) by keep_entry(). */
static enum status_code keep_others(const struct output *out, bool trial, struct status *status)
{
    struct text manifest = {0};
    struct manifest_entries entries = {0};
    int old = open_directory(out->target), new = open_directory(out->staging);
    enum status_code rc = STATUS_OK;
    if (old < 0 && errno == ENOENT)
        goto done;
    if (old < 0 || new < 0) {
        rc = status_fail(status, STATUS_IO, "cannot write the report to '%s': %s", out->target, strerror(errno));
        goto done;
    }
    static const char *const folders[] = {".", "data", "figures"};
    for (int i = 0; rc == STATUS_OK && i < 3; i++)
        if (faccessat(old, folders[i], W_OK | X_OK, 0) != 0 && errno != ENOENT)
            rc = status_fail(status, STATUS_IO, "cannot replace what is in '%s/%s': %s", out->target, folders[i],
                             strerror(errno));
    if (rc == STATUS_OK)
        rc = manifest_read(&manifest, out->target, status);
    if (rc == STATUS_OK)
        rc = manifest_entries(&entries, out->target, status);
    for (size_t i = 0; rc == STATUS_OK && i < entries.count; i++)
        rc = keep_entry(out, old, new, entries.names[i], &manifest, trial, status);
done:
    manifest_entries_free(&entries);
    text_free(&manifest);
    if (old >= 0)
        close(old);
    if (new >= 0)
        close(new);
    return rc;
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

/** Stores the path of OUT without slashes at its end; of a link, where it leads. */
static enum status_code set_target(struct output *out, const char *target, struct status *status)
{
    struct stat info;
    size_t length = strlen(target);
    while (length > 1 && target[length - 1] == '/')
        length--;
    if (length + 64 >= sizeof out->target)
        return status_fail(status, STATUS_IO, "the name of the report directory is too long");
    memcpy(out->target, target, length);
    const char *slash = strrchr(out->target, '/'), *name = slash ? slash + 1 : out->target;
    if (*name == '\0' || strcmp(name, ".") == 0 || strcmp(name, "..") == 0)
        return status_fail(status, STATUS_USAGE, "'%s' is no name for a report's directory; name one, such as ./report",
                           target);
    if (lstat(out->target, &info) == 0 && S_ISLNK(info.st_mode)) {
        char *real = realpath(out->target, NULL);
        if (!real || strlen(real) + 64 >= sizeof out->target) {
            free(real);
            return status_fail(status, STATUS_IO, "'%s' is a link that leads nowhere; remove it", out->target);
        }
        strcpy(out->target, real);
        free(real);
    }
    return STATUS_OK;
}

/** Gives the new report the mode and the group of OUT, or what the umask allows; mkdtemp() gives neither. */
static enum status_code set_mode(const struct output *out, struct status *status)
{
    struct stat info;
    mode_t mask = umask(0), mode = 0777 & ~mask;
    umask(mask);
    if (stat(out->staging, &info) == 0)
        mode |= info.st_mode & S_ISGID; /* of the directory around it */
    if (stat(out->target, &info) == 0) {
        mode = info.st_mode & 07777;
        if (chown(out->staging, (uid_t)-1, info.st_gid) != 0)
            mode &= ~(mode_t)(S_ISGID | S_IRWXG); /* not for another group than it was */
    }
    if (chmod(out->staging, mode) != 0)
        return status_fail(status, STATUS_IO, "cannot set up '%s': %s", out->staging, strerror(errno));
    return STATUS_OK;
}

/** What could not be replaced once the report is there; known before. */
static enum status_code check_place(const struct output *out, struct status *status)
{
    static const char *const parts[] = {"", "/data", "/figures"};
    static const char remedy[] = "choose another directory with -o";
    const char *slash = strrchr(out->target, '/');
    char path[PATH_MAX + 16];
    struct statx info, around;
    snprintf(path, sizeof path, "%.*s", slash ? (int)(slash - out->target) + 1 : 1, slash ? out->target : ".");
    if (statx(AT_FDCWD, path, 0, STATX_BASIC_STATS, &around) != 0)
        return status_fail(status, STATUS_IO, "cannot write beside '%s': %s", out->target, strerror(errno));
    if ((around.stx_attributes & (STATX_ATTR_IMMUTABLE | STATX_ATTR_APPEND)) != 0)
        return status_fail(status, STATUS_IO, "cannot write beside '%s': '%s' is immutable; %s", out->target, path,
                           remedy);
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
        snprintf(path, sizeof path, "%s%s", out->target, parts[i]);
        if (statx(AT_FDCWD, path, AT_SYMLINK_NOFOLLOW, STATX_BASIC_STATS, &info) != 0)
            continue;
        if ((info.stx_attributes & STATX_ATTR_MOUNT_ROOT) != 0 || info.stx_dev_major != around.stx_dev_major ||
            info.stx_dev_minor != around.stx_dev_minor)
            return status_fail(status, STATUS_IO,
                               "'%s' is a mount point, which a report cannot take the place of; name a directory in it "
                               "with -o",
                               path);
        if ((info.stx_attributes & (STATX_ATTR_IMMUTABLE | STATX_ATTR_APPEND)) != 0)
            return status_fail(status, STATUS_IO, "'%s' is immutable; %s", path, remedy);
        if (i == 0 && (around.stx_mode & S_ISVTX) != 0 && geteuid() != 0 && info.stx_uid != geteuid() &&
            around.stx_uid != geteuid())
            return status_fail(status, STATUS_IO, "'%s' is another user's, and only they can replace it; %s", path,
                               remedy);
    }
    return STATUS_OK;
}

/** What to say should the program be made to end. */
static void note(const char *before, const char *target, const char *after)
{
    char text[PATH_MAX + 64];
    snprintf(text, sizeof text, "%s'%s'%s", before, target, after);
    leftover_note(text);
}

enum status_code output_begin(struct output *out, const char *target, struct status *status)
{
    static const char *const parts[] = {"", "/data", "/figures"};
    *out = (struct output){.hidden.lock = -1};
    if (set_target(out, target, status) != STATUS_OK || make_parents(out, status) != STATUS_OK ||
        check_place(out, status) != STATUS_OK)
        return status->code;
    staging_clear_stale(out->target);
    leftover_hold();
    enum status_code rc = staging_make(&out->hidden, out->target, status);
    if (rc == STATUS_OK) {
        out->leftover = leftover_add(out->hidden.path);
        note("", out->target, " is as it was before");
    }
    leftover_release();
    if (rc != STATUS_OK)
        return rc;
    staging_part(out->staging, &out->hidden, "report");
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
        char part[PATH_MAX + 16];
        snprintf(part, sizeof part, "%s%s", out->staging, parts[i]);
        if (mkdir(part, 0777) != 0)
            return status_fail(status, STATUS_IO, "cannot make '%s': %s", part, strerror(errno));
    }
    if (keep_others(out, true, status) != STATUS_OK)
        return status->code;
    return set_mode(out, status);
}

/** Puts `staging` in the place of OUT; what was there is then the part *old of the hidden directory, or there was
 * nothing (""). */
static enum status_code exchange(struct output *out, const char **old, const char *kept, struct status *status)
{
    char before[PATH_MAX];
    staging_part(before, &out->hidden, "before");
    *old = "done";
    if (renameat2(AT_FDCWD, out->staging, AT_FDCWD, out->target, RENAME_EXCHANGE) == 0)
        return STATUS_OK;
    int reason = errno;
    if (reason == EINVAL || reason == ENOSYS) { /* a file system that cannot exchange: clear the way, then rename */
        *old = "before";
        if (rename(out->target, before) == 0) {
            if (rename(out->staging, out->target) == 0)
                return STATUS_OK;
            reason = errno;
            if (rename(before, out->target) != 0) {
                bool moved = rename(before, kept) == 0;
                if (!moved)
                    staging_leave(&out->hidden);
                return status_fail(status, STATUS_IO, "cannot put the report at '%s' (%s); the one before is in '%s'",
                                   out->target, strerror(reason), moved ? kept : before);
            }
        } else {
            reason = errno;
        }
    }
    *old = "";
    if (reason == ENOENT && rename(out->staging, out->target) == 0)
        return STATUS_OK;
    return status_fail(status, STATUS_IO, "cannot put the report at '%s': %s", out->target,
                       strerror(reason == ENOENT ? errno : reason));
}

/** Puts what is left of the report before, and what was looked at last, where the user finds it. */
static void keep_rest(char kept[static PATH_MAX], const struct output *out, const char *old)
{
    char path[PATH_MAX];
    struct status status = {0};
    struct manifest_entries entries;
    staging_part(path, &out->hidden, old);
    bool named = renameat2(AT_FDCWD, path, AT_FDCWD, kept, RENAME_NOREPLACE) == 0;
    if (!named)
        named = access(kept, F_OK) != 0 && rename(path, kept) == 0;
    if (!named)
        strcpy(kept, path);
    staging_part(path, &out->hidden, "aside");
    if (manifest_entries(&entries, path, &status) == STATUS_OK && entries.count > 0) {
        char from[2 * PATH_MAX], to[PATH_MAX + 8];
        snprintf(from, sizeof from, "%s/%s", path, entries.names[0]); /* there is never more than one */
        snprintf(to, sizeof to, "%.*s.file", PATH_MAX - 8, kept);
        if (rename(from, to) == 0)
            snprintf(kept, PATH_MAX, "%.*s", PATH_MAX - 1, to);
    }
    manifest_entries_free(&entries);
}

/** From the complete report in the hidden directory to OUT. */
static enum status_code put(struct output *out, struct status *status)
{
    const char *old = "";
    char kept[PATH_MAX], done[PATH_MAX];
    snprintf(kept, sizeof kept, "%.*s.kept%s", PATH_MAX - 16, out->target, strrchr(out->hidden.path, '-'));
    staging_part(done, &out->hidden, "done");
    if (rename(out->staging, done) != 0)
        return status_fail(status, STATUS_IO, "cannot put the report at '%s': %s", out->target, strerror(errno));
    strcpy(out->staging, done);
    if (set_mode(out, status) != STATUS_OK || keep_others(out, false, status) != STATUS_OK ||
        exchange(out, &old, kept, status) != STATUS_OK)
        return status->code;
    note("the report is in ", out->target, "");
    bool gone = *old == '\0' || staging_clear_before(out->hidden.path, old, out->target);
    if (!gone)
        keep_rest(kept, out, old);
    staging_remove(&out->hidden, false);
    out->staging[0] = '\0'; /* no longer ours to remove */
    return gone ? STATUS_OK
                : status_fail(status, STATUS_IO,
                              "the report is in '%s', but what was put there meanwhile could not be moved into it; it "
                              "is in '%s'",
                              out->target, kept);
}

enum status_code output_commit(struct output *out, struct status *status)
{
    if (manifest_write(out->staging, status) != STATUS_OK)
        return status_prefix(status, "cannot put the report at '%s'", out->target);
    leftover_hold();
    enum status_code rc = put(out, status);
    if (!out->hidden.path[0]) { /* what may be left there is the user's */
        leftover_forget(out->leftover);
        out->leftover = 0;
    }
    leftover_release();
    return rc;
}

void output_abandon(struct output *out)
{
    staging_remove(&out->hidden, true);
    leftover_forget(out->leftover);
    out->leftover = 0;
    out->staging[0] = '\0';
    for (char *slash; out->made && (slash = strrchr(out->target, '/')) && (size_t)(slash - out->target) >= out->made;) {
        *slash = '\0'; /* the parents made for it: those that are empty go */
        if (rmdir(out->target) != 0)
            break;
    }
    out->made = 0;
}
