/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "coverage.h"

#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static const struct {
    const char *name;
    void (*run)(FILE *out, size_t sets);
} sections[] = {{"band", coverage_band}, {"fit", coverage_fit},       {"scans", coverage_scans},
                {"rows", coverage_rows}, {"single", coverage_single}, {"pairs", coverage_pairs},
                {"cost", coverage_cost}};
enum { SECTIONS = sizeof sections / sizeof *sections, AT_ONCE = 2 };

static int usage(void)
{
    fprintf(stderr, "usage: coverage [SETS [SECTION]]\nsections:");
    for (size_t s = 0; s < SECTIONS; s++)
        fprintf(stderr, " %s", sections[s].name);
    fprintf(stderr, "\n");
    return 2;
}

static void print(FILE *page)
{
    char part[4096];
    rewind(page);
    for (size_t read; (read = fread(part, 1, sizeof part, page)) > 0;)
        fwrite(part, 1, read, stdout);
    fflush(stdout);
}

/** Sections run as processes of their own, two at once, and print in order. The last, of times, runs alone. */
int main(int count, char **word)
{
    size_t sets = count > 1 ? strtoul(word[1], NULL, 10) : 400, running = 0;
    FILE *page[SECTIONS] = {0};
    int failed = 0, state;
    if (sets < 10 || count > 3)
        return usage();
    size_t only = SECTIONS;
    for (size_t s = 0; s < SECTIONS && count > 2; s++)
        only = strcmp(word[2], sections[s].name) == 0 ? s : only;
    if (count > 2 && only == SECTIONS)
        return usage();
    for (size_t s = 0; s < SECTIONS; s++) {
        if (only != SECTIONS && only != s)
            continue;
        for (; running >= AT_ONCE || (running > 0 && s + 1 == SECTIONS); running--)
            failed |= wait(&state) < 0 || state != 0;
        page[s] = tmpfile();
        if (!page[s])
            coverage_must(STATUS_MEMORY, NULL);
        pid_t child = fork();
        if (child < 0)
            coverage_must(STATUS_MEMORY, NULL);
        if (child == 0) {
            sections[s].run(page[s], sets);
            _exit(fclose(page[s]) != 0);
        }
        running++;
    }
    for (; running > 0; running--)
        failed |= wait(&state) < 0 || state != 0;
    for (size_t s = 0; s < SECTIONS; s++)
        if (page[s])
            print(page[s]);
    return failed || fflush(stdout) != 0;
}
