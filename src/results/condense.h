/* A curve in a few numbers: what the report says of it and what is kept for every surface. */
#ifndef RESULTS_CONDENSE_H
#define RESULTS_CONDENSE_H

#include "results/surface.h"

/** Fills `model` from a curve that exists; sigma_m is the surface's root mean square height. */
void condense_curve(struct surface_model *model, const struct model_curve *curve, const struct model_row *row,
                    double sigma_m);

#endif
