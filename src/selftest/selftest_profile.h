/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A profile to compute on: worn flat on top. Private to src/selftest. */
#ifndef SELFTEST_SELFTEST_PROFILE_H
#define SELFTEST_SELFTEST_PROFILE_H

enum { SELFTEST_PROFILE_POINTS = 512 };
extern const double selftest_profile_spacing_m;
extern const double selftest_profile_height[SELFTEST_PROFILE_POINTS]; /* heights in 1e-17 m */

#endif
