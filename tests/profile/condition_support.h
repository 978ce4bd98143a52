/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Shared by the tests of conditioning: a scan in memory, and its profile with its notes. */
#ifndef TEST_CONDITION_SUPPORT_H
#define TEST_CONDITION_SUPPORT_H

#include "profile/profile.h"
#include "support.h"

/* A profile scan on `points` heights that the caller owns; x_m may be NULL. */
static inline struct scan scan_on(double *x_m, double *z_m, size_t points, double spacing_m)
{
    struct scan scan = {.format = "test", .nx = points, .ny = 1, .x_m = x_m, .z_m = z_m, .dx_m = spacing_m};
    for (size_t i = 0; i < points; i++)
        scan.missing += isnan(z_m[i]) ? 1 : 0;
    if (x_m)
        scan.dx_m = (x_m[points - 1] - x_m[0]) / (double)(points - 1);
    return scan;
}

static inline struct profile profile_good(const struct scan *scan, const struct profile_options *options)
{
    struct profile profile;
    struct status status = {0};
    if (profile_make(&profile, scan, 0, options, &status) != STATUS_OK)
        fail_msg("refused: %s", status.message);
    return profile;
}

static inline void assert_profile_refused(const struct scan *scan, const struct profile_options *options,
                                          const char *words)
{
    struct profile profile;
    expect_fails(STATUS_SCAN, words, profile_make, &profile, scan, 0, options);
    profile_free(&profile);
}

/* The note that holds `words`, or NULL. */
static inline const char *find_note(const struct profile *profile, const char *words)
{
    for (size_t n = 0; n < profile->note_count; n++)
        if (strstr(profile->notes[n], words))
            return profile->notes[n];
    return NULL;
}

static inline void assert_note(const struct profile *profile, const char *words)
{
    if (find_note(profile, words))
        return;
    for (size_t n = 0; n < profile->note_count; n++)
        print_error("note: %s\n", profile->notes[n]);
    fail_msg("no note holds '%s'", words);
}

/* A profile, which is freed, whose notes hold `words`, or where not `there` do not. */
static inline void expect_note(struct profile profile, const char *words, bool there)
{
    if (there)
        assert_note(&profile, words);
    else
        assert_null(find_note(&profile, words));
    profile_free(&profile);
}

/* A number between -1 and 1, the same in every run. */
static inline double noise(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(int64_t)*seed * 0x1p-63;
}

#endif
