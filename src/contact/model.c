#include "contact/model.h"

#include "contact/multiscale.h"
#include "contact/statistical.h"
#include <math.h>

enum { CONDUCTS = CONTACT_ELECTRICAL | CONTACT_THERMAL | CONTACT_SCALE_DEPENDENT };

/** Every scale at every load, and once more at the load of full contact. */
static struct model_work work_multiscale(const struct model_row *row, const struct model_task *task)
{
    (void)row;
    uint64_t visits = task->spectrum->count * (task->load_count + 1);
    return (struct model_work){
        .scales = visits,
        .gaps = task->wanted & CONTACT_SEPARATION ? visits : 0,
        .spots = task->wanted & CONDUCTS ? visits : 0,
    };
}

static enum status_code run_multiscale(struct model_curve *curve, const struct model_row *row,
                                       const struct model_task *task, struct status *status)
{
    struct multiscale stack;
    struct spot spot = spot_make(task->pair);
    uint64_t visits = 0;
    if (multiscale_make(&stack, task->spectrum, task->pair, row->plastic, task->closure, status) != STATUS_OK)
        return status->code;
    for (size_t i = 0; i < task->load_count; i++)
        curve->clamped += multiscale_solve(&curve->points[i], &stack, &spot, task->wanted, task->loads[i], &visits);
    multiscale_solve(&curve->full, &stack, &spot, task->wanted, stack.full_load, &visits);
    curve->count = task->load_count;
    curve->full_load = stack.full_load;
    curve->closed_load = stack.closed_load;
    curve->yielding_scales = stack.critical_scales;
    curve->beta = NAN;
    curve->exists = true;
    curve->work = (struct model_work){
        .scales = visits,
        .gaps = task->wanted & CONTACT_SEPARATION ? visits : 0,
        .spots = task->wanted & CONDUCTS ? visits : 0,
    };
    multiscale_free(&stack);
    return STATUS_OK;
}

static enum asperity_law_id law_of(const struct model_row *row)
{
    return row->plastic ? ASPERITY_JG : ASPERITY_HERTZ;
}

/** The law at the quadrature's nodes, and one solution a load. */
static struct model_work work_statistical(const struct model_row *row, const struct model_task *task)
{
    if (!task->asperities)
        return (struct model_work){0};
    return (struct model_work){
        .laws = statistical_law_count(task->asperities, task->pair, law_of(row), task->wanted, task->tolerance),
        .separations = task->load_count,
    };
}

static enum status_code run_statistical(struct model_curve *curve, const struct model_row *row,
                                        const struct model_task *task, struct status *status)
{
    if (!task->asperities)
        return STATUS_OK;
    struct statistical model;
    enum status_code rc = statistical_make(&model, task->asperities, task->pair, law_of(row), task->wanted,
                                           task->tolerance, INFINITY, &curve->work.laws, status);
    if (rc == STATUS_OK) {
        double d = 3; /* a first guess; the solution of one load starts the next */
        for (size_t i = 0; i < task->load_count; i++) {
            curve->work.separations++;
            if (statistical_solve(&curve->points[curve->count], &model, task->loads[i], &d))
                curve->count++;
        }
        statistical_full(&curve->full, &model);
        if (curve->count < task->load_count)
            curve->points[curve->count++] = curve->full;
        curve->full_load = curve->closed_load = model.full_load;
        curve->beta = model.beta;
        curve->exists = true;
    }
    statistical_free(&model);
    return rc;
}

const struct model_row model_rows[MODEL_COUNT] = {
    [MODEL_MULTISCALE_ELASTIC] = {"multiscale-elastic", "multiscale elastic", "me", SCENE_MODEL_MULTISCALE, false,
                                  "4.1-4.11, 4.40-4.42",
                                  "Jackson and Streator, Wear 261 (2006) 1337; Johnson, Greenwood and Higginson, Int. "
                                  "J. Mech. Sci. 27 (1985) 383; "
                                  "Wilson, Auburn University (2008)",
                                  "every harmonic is a scale of sinusoids on top of the longer ones; all asperities of "
                                  "a scale carry the same load; "
                                  "no yield",
                                  "any area ratio; needs a spectrum that converges (gamma >= 1)", work_multiscale,
                                  run_multiscale},
    [MODEL_MULTISCALE_PLASTIC] =
        {"multiscale-plastic", "multiscale elastic-plastic", "mp", SCENE_MODEL_MULTISCALE, true, "4.12-4.18, 4.40-4.42",
         "Krithivasan and Jackson, Tribol. Lett. 27 (2007) 31; Jackson, Krithivasan and Wilson, Proc. IMechE J 222 "
         "(2008) "
         "1; Wilson, Auburn University (2008)",
         "as multiscale elastic, with yield of every scale above its critical amplitude; no hardening",
         "any area ratio; the area steps up by up to 8 % where a scale begins to yield", work_multiscale,
         run_multiscale},
    [MODEL_GW] = {"gw", "GW", "gw", SCENE_MODEL_STATISTICAL, false, "4.19-4.30, 4.43, 4.54",
                  "Greenwood and Williamson, Proc. R. Soc. A 295 (1966) 300; McCool, Wear 107 (1986) 37",
                  "asperities of one radius, Gaussian heights, no interaction, no yield",
                  "A/A_n up to 0.1: asperities must not touch each other", work_statistical, run_statistical},
    [MODEL_JG] = {"jg", "JG", "jg", SCENE_MODEL_STATISTICAL, true, "4.31-4.38, 4.45-4.46, 4.54",
                  "Jackson and Green, J. Tribol. 127 (2005) 343; Jackson and Green, Tribol. Int. 39 (2006) 906",
                  "as GW, with Jackson and Green's elastic-plastic sphere",
                  "A/A_n up to 0.1; fitted for contact radius / asperity radius up to 0.41", work_statistical,
                  run_statistical},
};

static bool is_finite(const struct contact_point *point, unsigned wanted)
{
    return isfinite(point->load) && isfinite(point->area_ratio) &&
           (!(wanted & CONTACT_SEPARATION) || isfinite(point->separation_m)) &&
           (!(wanted & CONTACT_ELECTRICAL) || isfinite(point->ecr_ohm_m2)) &&
           (!(wanted & CONTACT_THERMAL) || isfinite(point->tcr_K_m2_per_W)) &&
           (!(wanted & CONTACT_SCALE_DEPENDENT) || isfinite(point->tcr_sd_K_m2_per_W));
}

enum status_code model_run(struct model_curve *curve, enum model_id model, const struct model_task *task,
                           struct status *status)
{
    if (model_rows[model].run(curve, &model_rows[model], task, status) != STATUS_OK)
        return status->code;
    bool finite = !curve->exists || is_finite(&curve->full, task->wanted);
    for (size_t i = 0; i < curve->count && finite; i++)
        finite = is_finite(&curve->points[i], task->wanted);
    if (!finite) {
        curve->exists = false;
        curve->overflows = true;
        curve->count = 0;
    }
    return STATUS_OK;
}

bool model_called_for(enum model_id model, unsigned families, unsigned effects)
{
    const struct model_row *row = &model_rows[model];
    return (families & row->family) && (!row->plastic || (effects & EFFECT_BIT(EFFECT_PLASTICITY)));
}

void model_work_add(struct model_work *sum, const struct model_work *more)
{
    sum->scales += more->scales;
    sum->gaps += more->gaps;
    sum->spots += more->spots;
    sum->laws += more->laws;
    sum->separations += more->separations;
}
