/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Adaptive integration against integrals known in closed form. */
#include "base/integral.h"
#include "support.h"

static double power(double x, void *context)
{
    return pow(x, *(double *)context);
}

static double step(double x, void *context)
{
    return x < *(double *)context ? 1 : 3;
}

static double peak(double x, void *context)
{
    double width = *(double *)context;
    return width / (x * x + width * width);
}

/** Smooth, with a branch point at the end, and a narrow peak within; both directions; nothing between equal limits. */
TEST_CASE(known_integrals)
{
    double cube = 3, root = 0.5, width = 1e-4;
    assert_near(integral(power, &cube, 1, 2, 1e-14), 3.75, 1e-14);
    assert_near(integral(power, &cube, 2, 1, 1e-14), -3.75, 1e-14);
    assert_near(integral(power, &root, 0, 4, 1e-10), 16.0 / 3, 1e-10);
    assert_near(integral(peak, &width, -1, 3, 1e-12), atan(1 / width) + atan(3 / width), 1e-12);
    assert_within(integral(power, &cube, 2, 2, 1e-14), 0, 0);
}

/** A jump costs its last part only. */
TEST_CASE(a_jump_is_found)
{
    double at = 0.3;
    assert_near(integral(step, &at, 0, 1, 1e-6), 0.3 + 3 * 0.7, 1e-3);
}
