/* A curve in a few numbers: what the report says of it and what is kept for every surface. */
#ifndef ANALYSIS_CURVE_SUMMARY_H
#define ANALYSIS_CURVE_SUMMARY_H

#include "analysis/surface.h"

/** Fills `model` from a curve that exists; sigma_m is the surface's root mean square height. */
void curve_summary_make(struct curve_summary *model, const struct model_curve *curve, const struct model_row *row,
                        double sigma_m);

#endif
