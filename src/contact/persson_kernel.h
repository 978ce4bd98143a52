/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The two integrals that Persson's mean separation and its slope with load are made of, fast and to rounding. */
#ifndef CONTACT_PERSSON_KERNEL_H
#define CONTACT_PERSSON_KERNEL_H

enum { PERSSON_TERMS = 14, PERSSON_PANELS = 10, PERSSON_PANEL_TERMS = 13 };

/** s and I_2 for one energy factor g, f(t) = [g + 3(1-g) erf² t] exp(-t²). Make it with persson_kernel(). */
struct persson_kernel {
    double energy_factor;         /* g */
    double constant, slope;       /* small x: s = -g ln x + constant + slope x + sum taylor_k x^(2k) */
    double taylor[PERSSON_TERMS]; /* k = 1, 2, ... */
    /* middle x: s and I_2 without exp(-x²), polynomials in ln x on panels of equal width */
    double separation[PERSSON_PANELS][PERSSON_PANEL_TERMS], conductance[PERSSON_PANELS][PERSSON_PANEL_TERMS];
};

/** s(x) = int_x^inf f(t) (t-x)/t² dt and its slope I_2(x) = -s'(x) = int_x^inf f(t)/t² dt. */
struct persson_integrals {
    double separation, conductance;
};

/** Prepares the kernel of g (0 < g <= 1). */
struct persson_kernel persson_kernel(double energy_factor);

/** Both integrals at x > 0, with ln x; relative error below 1e-13:
 *  x < 0.5    Taylor series, after the logarithm and the pole of I_2
 *  x < 6.75   polynomials through Gauss-Legendre integrals over v = t - x, exp(-x²) apart
 *  beyond     asymptotic series in 1/x², where erf t is 1 */
struct persson_integrals persson_integrals(const struct persson_kernel *kernel, double x, double logarithm);

#endif
