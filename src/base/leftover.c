#include "base/leftover.h"

#include <ftw.h>
#include <limits.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { MOST = 128, PASSES = 50 };

/* Of the process, as its threads and its end are. */
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER; /* guards what follows */
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

static int remove_one(const char *path, const struct stat *info, int kind, struct FTW *walk)
{
    (void)info, (void)kind, (void)walk;
    remove(path);
    return 0;
}

const char *leftover_clear(void)
{
    pthread_mutex_lock(&lock);
    for (size_t i = 0; i < MOST; i++) /* again where a file came between the list and the end of its directory */
        for (int pass = 0; directories[i] && pass < PASSES && access(directories[i], F_OK) == 0; pass++)
            nftw(directories[i], remove_one, 16, FTW_DEPTH | FTW_PHYS);
    return note;
}
