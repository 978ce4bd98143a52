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
static void known_integrals(void **state)
{
    (void)state;
    double cube = 3, root = 0.5, width = 1e-4;
    assert_near(integral(power, &cube, 1, 2, 1e-14), 3.75, 1e-14);
    assert_near(integral(power, &cube, 2, 1, 1e-14), -3.75, 1e-14);
    assert_near(integral(power, &root, 0, 4, 1e-10), 16.0 / 3, 1e-10);
    assert_near(integral(peak, &width, -1, 3, 1e-12), atan(1 / width) + atan(3 / width), 1e-12);
    assert_within(integral(power, &cube, 2, 2, 1e-14), 0, 0);
}

/** A jump costs its last part only. */
static void a_jump_is_found(void **state)
{
    (void)state;
    double at = 0.3;
    assert_near(integral(step, &at, 0, 1, 1e-6), 0.3 + 3 * 0.7, 1e-3);
}

struct counted {
    integral_function *f;
    double of;
    int calls;
};

static double count(double x, void *context)
{
    struct counted *counted = context;
    counted->calls++;
    return counted->f(x, &counted->of);
}

/** 7 points do for a stretch that is short, to all digits; where they do not, the whole of
 * integral() follows. */
static void a_short_stretch_takes_fewer_points(void **state)
{
    (void)state;
    struct counted root = {power, 0.5, 0};
    assert_near(integral_short(count, &root, 4, 4.1, 1e-6), (pow(4.1, 1.5) - 8) / 1.5, 2e-15);
    assert_int_equal(root.calls, 7);
    root.calls = 0;
    double whole = integral(count, &root, 0, 1, 1e-6);
    int calls = root.calls;
    root.calls = 0;
    assert_within(integral_short(count, &root, 0, 1, 1e-6), whole, 0);
    assert_int_equal(root.calls, 7 + calls);
    root.calls = 0;
    assert_near(integral_short(count, &root, 1, 1.1, 0.1), (pow(1.1, 1.5) - 1) / 1.5, 2e-15);
    assert_int_equal(root.calls, 7 + 15);         /* within the tolerance, but in doubt */
    for (int degree = 0; degree <= 5; degree++) { /* Gauss's are exact too */
        struct counted polynomial = {power, degree, 0};
        assert_near(integral_short(count, &polynomial, 0, 2, 1e-6), pow(2, degree + 1) / (degree + 1), 1e-15);
        assert_int_equal(polynomial.calls, 7);
    }
    for (int degree = 6; degree <= 11; degree++) { /* about 1: next to it what Gauss's miss is small */
        struct counted polynomial = {power, degree, 0};
        double exact = (pow(1.005, degree + 1) - pow(0.995, degree + 1)) / (degree + 1);
        assert_near(integral_short(count, &polynomial, 0.995, 1.005, 1e-6), exact, 1e-13);
        assert_int_equal(polynomial.calls, 7);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(known_integrals),
        cmocka_unit_test(a_jump_is_found),
        cmocka_unit_test(a_short_stretch_takes_fewer_points),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
