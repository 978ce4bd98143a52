/* The four models side by side: one row each, from name to evaluation. A new model is one row (and its file). */
#ifndef CONTACT_MODEL_H
#define CONTACT_MODEL_H

#include "contact/point.h"
#include "scene/scene.h"
#include "spectrum/roughness.h"
#include "spectrum/spectrum.h"
#include <stdint.h>

enum model_id { MODEL_MULTISCALE_ELASTIC, MODEL_MULTISCALE_PLASTIC, MODEL_GW, MODEL_JG, MODEL_COUNT };

/** What a model is asked: one surface, one pair of bodies, a list of loads. */
struct model_task {
    const struct spectrum *spectrum;
    const struct asperities *asperities; /* NULL: no statistical model exists for this surface */
    const struct material_pair *pair;
    const double *loads; /* P/(A_n E'), ascending */
    size_t load_count;
    unsigned wanted; /* enum contact_quantity bits */
    double tolerance;
    enum scene_closure closure;
};

/** What answering took. A separation is one load of a statistical model, solved for; the rest are visits or law values.
 */
struct model_work {
    uint64_t scales;      /* area of a scale at a load */
    uint64_t gaps;        /* gap of a scale at a load */
    uint64_t spots;       /* resistance of a scale at a load */
    uint64_t laws;        /* asperity laws at a quadrature node */
    uint64_t separations; /* loads solved for a separation */
};

/** What it answers. `points` is the caller's, load_count + 1 long. */
struct model_curve {
    bool exists;    /* false: the model was not run, or has no solution for this surface */
    bool overflows; /* it has none because its numbers leave the range of double; then no points */
    struct contact_point *points;
    size_t count;              /* statistical: ends with the point of full contact, when the loads reach it */
    double full_load;          /* P/(A_n E') at which A = A_n */
    double closed_load;        /* at which the (adjusted) separation is 0 */
    double beta;               /* statistical, else NaN */
    struct contact_point full; /* at full_load itself */
    size_t yielding_scales;    /* multiscale plastic: scales that can yield; else 0 */
    uint64_t clamped; /* multiscale plastic: visits in which the published area was limited: see multiscale_solve() */
    struct model_work work;
};

struct model_row {
    const char *name;  /* as in contact.csv */
    const char *label; /* as in charts and tables */
    const char *style; /* style word of templates/curves.gp */
    enum scene_model family;
    bool plastic;
    const char *equations; /* of the thesis, as in physics.md */
    const char *source;
    const char *assumes;
    const char *valid;
    /** What `run` will take, known before it runs. */
    struct model_work (*work)(const struct model_row *row, const struct model_task *task);
    enum status_code (*run)(struct model_curve *curve, const struct model_row *row, const struct model_task *task,
                            struct status *status);
};

extern const struct model_row model_rows[MODEL_COUNT];

/** Runs a model. A curve any of whose loads, areas or wanted quantities is not finite does not exist: materials and
 * heights may each be possible and still leave the range of double together (JG's exponent 23 S_y/E' of 1e6).
 * Error: STATUS_MEMORY. */
MUST_CHECK enum status_code model_run(struct model_curve *curve, enum model_id model, const struct model_task *task,
                                      struct status *status);

/** Adds `more` to `sum`. */
void model_work_add(struct model_work *sum, const struct model_work *more);

/** May this model run: its family is asked for and, for a plastic one, the effect plasticity runs. */
bool model_called_for(enum model_id model, unsigned families, unsigned effects);

#endif
