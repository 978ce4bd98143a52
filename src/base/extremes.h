/* SPDX-License-Identifier: GPL-3.0-or-later */
/* fmax() and fmin() of one number after another, without a call each: a comparison with NaN is false. */
#ifndef BASE_EXTREMES_H
#define BASE_EXTREMES_H

/** The larger of `most`, which is a number, and `value`; NaN is passed over. */
static inline double extremes_larger(double most, double value)
{
    return value > most ? value : most;
}

/** The smaller of the two, likewise. */
static inline double extremes_smaller(double least, double value)
{
    return value < least ? value : least;
}

#endif
