#include "output/output.h"

#include "output/manifest.h"
#include <errno.h>
#include <fcntl.h>
#include <ftw.h>
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
    if (length + 32 >= sizeof out->target)
        return status_fail(status, STATUS_IO, "the name of the report directory is too long");
    memcpy(out->target, target, length);
    const char *slash = strrchr(out->target, '/'), *name = slash ? slash + 1 : out->target;
    if (*name == '\0' || strcmp(name, ".") == 0 || strcmp(name, "..") == 0)
        return status_fail(status, STATUS_USAGE, "'%s' is no name for a report's directory; name one, such as ./report",
                           target);
    if (lstat(out->target, &info) == 0 && S_ISLNK(info.st_mode)) {
        char *real = realpath(out->target, NULL);
        if (!real || strlen(real) + 32 >= sizeof out->target) {
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
    if (stat(out->target, &info) == 0) {
        mode = info.st_mode & 07777;
        if (chown(out->staging, (uid_t)-1, info.st_gid) != 0)
            mode &= ~(mode_t)(S_ISGID | S_IRWXG); /* not for another group than it was */
    }
    if (chmod(out->staging, mode) != 0)
        return status_fail(status, STATUS_IO, "cannot set up '%s': %s", out->staging, strerror(errno));
    return STATUS_OK;
}

enum status_code output_begin(struct output *out, const char *target, struct status *status)
{
    *out = (struct output){0};
    if (set_target(out, target, status) != STATUS_OK || make_parents(out, status) != STATUS_OK)
        return status->code;

    char *slash = strrchr(out->target, '/');
    size_t parent = slash ? (size_t)(slash - out->target) + 1 : 0;
    char name[PATH_MAX + 32], part[PATH_MAX + 40];
    snprintf(name, sizeof name, "%.*s.roughcontact-XXXXXX", (int)parent, out->target);
    if (!mkdtemp(name))
        return status_fail(status, STATUS_IO, "cannot write beside '%s': %s", out->target, strerror(errno));
    snprintf(out->staging, sizeof out->staging, "%.*s", PATH_MAX - 1, name);
    static const char *const parts[] = {"data", "figures"};
    for (int i = 0; i < 2; i++) {
        snprintf(part, sizeof part, "%s/%s", name, parts[i]);
        if (mkdir(part, 0777) != 0)
            return status_fail(status, STATUS_IO, "cannot make '%s': %s", part, strerror(errno));
    }
    if (keep_others(out, true, status) != STATUS_OK)
        return status->code;
    return set_mode(out, status);
}

static int remove_entry(const char *path, const struct stat *info, int type, struct FTW *level)
{
    (void)info;
    (void)type;
    (void)level;
    return remove(path);
}

static void remove_tree(const char *path)
{
    nftw(path, remove_entry, 16, FTW_DEPTH | FTW_PHYS);
}

/** Removes an entry of the report before when it is the program's or the new report holds it too; else (it came during
 * the exchange) moves it there, in the place of nothing. It is looked at under the name `aside`, where nobody replaces
 * it meanwhile. False when it had to stay there. */
static bool clear_entry(int old, int new, const char *name, const char *aside, const struct text *manifest)
{
    struct stat before, after;
    if (renameat(old, name, AT_FDCWD, aside) != 0 || lstat(aside, &before) != 0)
        return true;
    if (S_ISDIR(before.st_mode))
        return renameat(AT_FDCWD, aside, new, name) == 0 || renameat(AT_FDCWD, aside, old, name) == 0;
    if ((manifest_lists(manifest, name) && S_ISREG(before.st_mode)) || linkat(AT_FDCWD, aside, new, name, 0) == 0 ||
        (fstatat(new, name, &after, AT_SYMLINK_NOFOLLOW) == 0 && before.st_dev == after.st_dev &&
         before.st_ino == after.st_ino) ||
        linkat(AT_FDCWD, aside, old, name, 0) == 0)
        return unlink(aside) == 0;
    return false;
}

/** Removes the report before, now at `path`, once nothing in it is the user's. False when something has to stay. */
static bool clear_old(const char *path, const char *target, const char *aside)
{
    enum { PASSES = 3 }; /* a file may come between the list and the end of its directory */
    struct status status = {0};
    struct text manifest = {0};
    int old = open_directory(path), new = open_directory(target);
    bool gone = false, stuck = false;
    if (old >= 0 && new >= 0 && manifest_read(&manifest, path, &status) == STATUS_OK)
        for (int pass = 0; pass < PASSES && !gone && !stuck && status.code == STATUS_OK; pass++) {
            struct manifest_entries entries;
            if (manifest_entries(&entries, path, &status) == STATUS_OK)
                for (size_t i = 0; i < entries.count && !stuck; i++)
                    stuck = !clear_entry(old, new, entries.names[i], aside, &manifest);
            manifest_entries_free(&entries);
            unlinkat(old, "data", AT_REMOVEDIR);
            unlinkat(old, "figures", AT_REMOVEDIR);
            gone = !stuck && rmdir(path) == 0;
        }
    text_free(&manifest);
    if (old >= 0)
        close(old);
    if (new >= 0)
        close(new);
    return gone;
}

/** Puts `staging` in the place of OUT; what was there is then at `old`, or `old` is "". */
static enum status_code exchange(const struct output *out, char *old, const char *kept, struct status *status)
{
    strcpy(old, out->staging);
    if (renameat2(AT_FDCWD, out->staging, AT_FDCWD, out->target, RENAME_EXCHANGE) == 0)
        return STATUS_OK;
    int reason = errno;
    if (reason == EINVAL || reason == ENOSYS) { /* a file system that cannot exchange: clear the way, then rename */
        strcpy(old, kept);
        if (rename(out->target, kept) == 0) {
            if (rename(out->staging, out->target) == 0)
                return STATUS_OK;
            reason = errno;
            if (rename(kept, out->target) != 0)
                return status_fail(status, STATUS_IO, "cannot put the report at '%s' (%s); the one before is in '%s'",
                                   out->target, strerror(reason), kept);
        } else {
            reason = errno;
        }
    }
    *old = '\0';
    if (reason == ENOENT && rename(out->staging, out->target) == 0)
        return STATUS_OK;
    return status_fail(status, STATUS_IO, "cannot put the report at '%s': %s", out->target,
                       strerror(reason == ENOENT ? errno : reason));
}

enum status_code output_commit(struct output *out, struct status *status)
{
    char old[PATH_MAX + 16], kept[sizeof old], aside[sizeof kept + 8];
    snprintf(kept, sizeof kept, "%s.kept%s", out->target, strrchr(out->staging, '-'));
    snprintf(aside, sizeof aside, "%s.file", kept);
    if (manifest_write(out->staging, status) != STATUS_OK)
        return status_prefix(status, "cannot put the report at '%s'", out->target);
    if (keep_others(out, false, status) != STATUS_OK || exchange(out, old, kept, status) != STATUS_OK)
        return status->code;
    out->staging[0] = '\0'; /* no longer ours to remove */
    if (*old == '\0' || clear_old(old, out->target, aside))
        return STATUS_OK;
    bool named = strcmp(old, kept) == 0 || renameat2(AT_FDCWD, old, AT_FDCWD, kept, RENAME_NOREPLACE) == 0;
    return status_fail(status, STATUS_IO,
                       "the report is in '%s', but what was put there meanwhile could not be moved into it; it is in "
                       "'%s'",
                       out->target,
                       access(aside, F_OK) == 0 ? aside
                       : named                  ? kept
                                                : old);
}

void output_abandon(struct output *out)
{
    if (out->staging[0])
        remove_tree(out->staging);
    out->staging[0] = '\0';
    for (char *slash; out->made && (slash = strrchr(out->target, '/')) && (size_t)(slash - out->target) >= out->made;) {
        *slash = '\0'; /* the parents made for it: those that are empty go */
        if (rmdir(out->target) != 0)
            break;
    }
    out->made = 0;
}
