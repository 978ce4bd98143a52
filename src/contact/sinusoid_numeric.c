/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Closure `numeric`: a direct numerical solution of the elastic cell, interpolated (docs/equations.md, One sinusoidal
 * scale). ln[G/(1-x)^(5/2)] and a/x^(2/3) are smooth in x^(1/3); Steffen's cubic keeps both monotone between the nodes.
 * The ends are the exact limits: Hertz at x = 0 (4.3), Johnson, Greenwood and Higginson's (4.9) at x = 1. */
#include "contact/sinusoid.h"

#include <math.h>

/** The solution on a 1024 x 1024 grid: x = p/p*, area ratio within 3e-4, gap/amplitude within 2e-6. */
struct sinusoid_bem_row {
    double x, area, gap;
};
static const struct sinusoid_bem_row sinusoid_bem[] = {
    {0.0002, 0.002608, 0.98442297}, {0.0005, 0.004811, 0.97183260}, {0.001, 0.007654, 0.95611729},
    {0.002, 0.012193, 0.93201222},  {0.005, 0.022665, 0.88015147},  {0.01, 0.036392, 0.81829047},
    {0.02, 0.058791, 0.72882288},   {0.05, 0.112945, 0.55637067},   {0.1, 0.190555, 0.38474924},
    {0.15, 0.265347, 0.27661282},   {0.2, 0.345096, 0.20463362},    {0.21, 0.362813, 0.19352108},
    {0.22, 0.382057, 0.18339181},   {0.23, 0.405367, 0.17426535},   {0.235, 0.416348, 0.17004686},
    {0.24, 0.426037, 0.16597322},   {0.245, 0.435041, 0.16202631},  {0.25, 0.443538, 0.15819466},
    {0.26, 0.459428, 0.15084457},   {0.27, 0.474237, 0.14387167},   {0.28, 0.488150, 0.13723872},
    {0.3, 0.514107, 0.12488127},    {0.35, 0.570741, 0.09839035},   {0.4, 0.619906, 0.07690821},
    {0.45, 0.663905, 0.05937722},   {0.5, 0.704183, 0.04507795},    {0.55, 0.741331, 0.03347987},
    {0.6, 0.776160, 0.02417005},    {0.65, 0.808945, 0.01681395},   {0.7, 0.839925, 0.01113132},
    {0.75, 0.869442, 0.00688044},   {0.8, 0.897616, 0.00384653},    {0.85, 0.924645, 0.00183276},
    {0.9, 0.950658, 0.00065145},    {0.95, 0.975764, 0.00011296},   {0.98, 0.990377, 0.00001131},
    {0.99, 0.995199, 0.00000199},
};
enum { NODES = sizeof sinusoid_bem / sizeof sinusoid_bem[0], POINTS = NODES + 2 };

/** The two quantities at point i; 0 and POINTS-1 are the exact limits. */
static double point_area(int i)
{
    static const double hertz_factor = 0.7616184731724445; /* pi (3/(8 pi))^(2/3), from (4.3) */
    if (i == 0)
        return hertz_factor;
    return i == POINTS - 1 ? 1 : sinusoid_bem[i - 1].area / pow(sinusoid_bem[i - 1].x, 2.0 / 3);
}

static double point_gap(int i)
{
    static const double near_complete = 16 / (15 * M_PI * M_PI) * 1.8371173070873836; /* (4.9); (3/2)^(3/2) */
    if (i == 0)
        return 0;
    return i == POINTS - 1 ? log(near_complete) : log(sinusoid_bem[i - 1].gap) - 2.5 * log1p(-sinusoid_bem[i - 1].x);
}

/** Steffen's slope at the middle of three points: no overshoot between them. */
static double steffen_slope(const double t[3], const double y[3])
{
    double left_step = t[1] - t[0], right_step = t[2] - t[1];
    double left = (y[1] - y[0]) / left_step, right = (y[2] - y[1]) / right_step;
    double parabola = (left * right_step + right * left_step) / (left_step + right_step);
    return (copysign(1, left) + copysign(1, right)) * fmin(fmin(fabs(left), fabs(right)), 0.5 * fabs(parabola));
}

/** Slope at an end point from its own interval and the slope at the interval's other end. */
static double end_slope(double secant, double inner_slope)
{
    double slope = 1.5 * secant - 0.5 * inner_slope;
    return slope * secant <= 0 ? 0 : copysign(fmin(fabs(slope), 2 * fabs(secant)), secant);
}

/** The cubic between two points: values and slopes at its ends. */
struct piece {
    double start, step, low, high, slope_low, slope_high;
};

/** The piece around t = x^(1/3), 0 < t < 1. */
static struct piece piece_at(double (*value)(int), double x)
{
    int low = 0;
    while (low < NODES && sinusoid_bem[low].x <= x)
        low++;
    double t[4], y[4]; /* points low-1 ... low+2, those that exist */
    for (int k = 0; k < 4; k++) {
        int point = low - 1 + k;
        bool exists = point >= 0 && point < POINTS;
        t[k] = !exists || point == 0 ? 0 : point == POINTS - 1 ? 1 : cbrt(sinusoid_bem[point - 1].x);
        y[k] = exists ? value(point) : 0;
    }
    double step = t[2] - t[1], secant = (y[2] - y[1]) / step;
    double slope_low = low > 0 ? steffen_slope(t, y) : 0;
    double slope_high = low < NODES ? steffen_slope(t + 1, y + 1) : end_slope(secant, slope_low);
    if (low == 0)
        slope_low = end_slope(secant, slope_high);
    return (struct piece){t[1], step, y[1], y[2], slope_low, slope_high};
}

/** How far it is above its low end's value, at `u` from that end. */
static double piece_rise(const struct piece *piece, double u)
{
    double step = piece->step, secant = (piece->high - piece->low) / step;
    double cubic = (piece->slope_low + piece->slope_high - 2 * secant) / (step * step);
    double square = (3 * secant - 2 * piece->slope_low - piece->slope_high) / step;
    return u * (piece->slope_low + u * (square + u * cubic));
}

/** How far the cubic is below its high end's value, at `s` from that end. */
static double piece_rest(const struct piece *piece, double s)
{
    struct piece turned = {0, piece->step, -piece->high, -piece->low, piece->slope_high, piece->slope_low};
    return piece_rise(&turned, s);
}

static double interpolate(double (*value)(int), double x)
{
    struct piece piece = piece_at(value, x);
    return piece.low + piece_rise(&piece, cbrt(x) - piece.start);
}

void sinusoid_numeric_area(struct sinusoid_cell *cell, double x)
{
    if (x >= 1) {
        cell->area_ratio = 1;
        cell->area_complement = 0;
    } else if (x < sinusoid_bem[NODES - 1].x) {
        cell->area_ratio = interpolate(point_area, x) * pow(x, 2.0 / 3);
        cell->area_complement = 1 - cell->area_ratio;
    } else { /* 1 - y x^(2/3) = 1 - y + y (1 - x^(2/3)) from small terms, so that 1 - sqrt(a) keeps its digits */
        struct piece piece = piece_at(point_area, x);
        double rest = piece_rest(&piece, -expm1(log(x) / 3));
        cell->area_complement = rest - (1 - rest) * expm1(2.0 / 3 * log(x));
        cell->area_ratio = 1 - cell->area_complement;
    }
}

double sinusoid_numeric_gap(double x)
{
    if (x >= 1)
        return 0;
    if (x < sinusoid_bem[0].x) /* 1 - G ~ x^(2/3) (4.8), through the first node */
        return exp(log(sinusoid_bem[0].gap) * pow(x / sinusoid_bem[0].x, 2.0 / 3));
    return exp(interpolate(point_gap, x) + 2.5 * log1p(-x));
}
