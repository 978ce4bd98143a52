/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/leftover.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { MOST = 128, PASSES = 50 };

/* Of the process, as its threads and its end are. */
static pthread_mutex_t lock = PTHREAD_RECURSIVE_MUTEX_INITIALIZER_NP; /* guards what follows */
static char *directories[MOST];
static char note[PATH_MAX + 64];

size_t leftover_add(const char *directory)
{
    char *path = realpath(directory, NULL); /* whatever the working directory will be */
    size_t number = 0;
    if (!path)
        return 0;
    pthread_mutex_lock(&lock);
    for (size_t i = 0; i < MOST && number == 0; i++)
        if (!directories[i]) {
            directories[i] = path;
            number = i + 1;
        }
    pthread_mutex_unlock(&lock);
    if (number == 0)
        free(path);
    return number;
}

void leftover_forget(size_t number)
{
    if (number == 0)
        return;
    pthread_mutex_lock(&lock);
    free(directories[number - 1]);
    directories[number - 1] = NULL;
    pthread_mutex_unlock(&lock);
}

bool leftover_make(char *directory, size_t *number)
{
    leftover_hold();
    bool made = mkdtemp(directory) != NULL;
    int error = errno;
    *number = made ? leftover_add(directory) : 0;
    leftover_release();
    errno = error;
    return made;
}

void leftover_note(const char *text)
{
    snprintf(note, sizeof note, "%s", text);
}

void leftover_hold(void)
{
    pthread_mutex_lock(&lock);
}

void leftover_release(void)
{
    pthread_mutex_unlock(&lock);
}

static void remove_at(int parent, const char *name)
{
    if (unlinkat(parent, name, 0) == 0)
        return;
    int directory = openat(parent, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    DIR *list = directory >= 0 ? fdopendir(directory) : NULL;
    for (const struct dirent *entry; list && (entry = readdir(list));)
        if (strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0)
            remove_at(directory, entry->d_name);
    if (list)
        closedir(list);
    else if (directory >= 0)
        close(directory);
    unlinkat(parent, name, AT_REMOVEDIR);
}

void leftover_remove(const char *path)
{
    remove_at(AT_FDCWD, path);
}

const char *leftover_clear(void)
{
    pthread_mutex_lock(&lock);
    for (size_t i = 0; i < MOST; i++) /* again where a file came between the list and the end of its directory */
        for (int pass = 0; directories[i] && pass < PASSES && access(directories[i], F_OK) == 0; pass++)
            leftover_remove(directories[i]);
    return note;
}
