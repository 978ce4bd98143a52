/* SPDX-License-Identifier: GPL-3.0-or-later */
/* All models, in the order of tables and legends. */
#include "contact/model.h"

/* Each is the row `model_NAME` that ends the model's own file. */
#define MODELS(X)                                                                                                      \
    X(multiscale_elastic)                                                                                              \
    X(multiscale_plastic)                                                                                              \
    X(gw)                                                                                                              \
    X(jg)                                                                                                              \
    X(corrected_persson)                                                                                               \
    X(corrected_persson_plastic)                                                                                       \
    X(strip)                                                                                                           \
    X(strip_plastic)                                                                                                   \
    X(direct)                                                                                                          \
    X(direct_plastic)                                                                                                  \
    X(cmy)

#define DECLARE(name) extern const struct model_row model_##name;
#define ENTRY(name)   &model_##name,

MODELS(DECLARE)

const struct model_row *const model_rows[] = {MODELS(ENTRY)};
const size_t model_count = sizeof model_rows / sizeof *model_rows;
_Static_assert(sizeof model_rows / sizeof *model_rows < 64, "sets of models are bits of a uint64_t");
