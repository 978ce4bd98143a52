/* The thesis's multiscale models: every harmonic of the spectrum is a scale of the stack (thesis 4.1, 4.2, 4.11). */
#include "contact/multiscale.h"

#include <math.h>

static struct model_work work_of(uint64_t visits, unsigned wanted)
{
    return (struct model_work){
        .scales = visits,
        .gaps = wanted & QUANTITY_BIT(QUANTITY_SEPARATION) ? visits : 0,
        .constrictions = wanted & QUANTITY_RESISTANCES ? visits : 0,
    };
}

/** Every scale at every load, and once more at the load of full contact. */
static struct model_work work(const struct model_row *row, const struct model_task *task)
{
    (void)row;
    return work_of(task->spectrum->count * (task->load_count + 1), task->wanted);
}

static enum status_code run(struct model_curve *curve, const struct model_row *row, const struct model_task *task,
                            struct status *status)
{
    struct multiscale stack;
    struct constriction constriction = constriction_make(task->pair);
    uint64_t visits = 0;
    if (multiscale_make(&stack, task->spectrum, task->pair, row->plastic, task->sinusoid_fit, status) != STATUS_OK)
        return status->code;
    for (size_t i = 0; i < task->load_count; i++)
        curve->clamped +=
            multiscale_solve(&curve->points[i], &stack, &constriction, task->wanted, task->loads[i], &visits);
    multiscale_solve(&curve->full, &stack, &constriction, task->wanted, stack.full_load, &visits);
    curve->count = task->load_count;
    curve->full_load = stack.full_load;
    curve->closed_load = stack.closed_load;
    curve->yielding_scales = stack.critical_scales;
    curve->beta = NAN;
    curve->exists = true;
    curve->work = work_of(visits, task->wanted);
    multiscale_free(&stack);
    return STATUS_OK;
}

enum {
    COMPUTES = QUANTITY_BIT(QUANTITY_LOAD) | QUANTITY_BIT(QUANTITY_AREA) | QUANTITY_BIT(QUANTITY_SEPARATION) |
               QUANTITY_RESISTANCES
};

const struct model_row model_multiscale_elastic = {
    .name = "multiscale-elastic",
    .label = "multiscale elastic",
    .short_label = "MS el.",
    .family = "multiscale",
    .by_default = true,
    .stacks_scales = true,
    .quantities = COMPUTES,
    .precedence = 3,
    .thesis_place = 2,
    .style = "me",
    .colour = "#3F9BE0",
    .marker = 6,
    .equations = "4.1-4.11, 4.40-4.42",
    .source = "Jackson and Streator, Wear 261 (2006) 1337; Johnson, Greenwood and Higginson, Int. "
              "J. Mech. Sci. 27 (1985) 383; "
              "Wilson, Auburn University (2008)",
    .assumes = "every harmonic is a scale of sinusoids on top of the longer ones; all asperities of "
               "a scale carry the same load; "
               "no yield",
    .valid = "any area ratio; needs a spectrum that converges (gamma >= 1)",
    .method = "direct sum over scales",
    .work = work,
    .run = run,
};

const struct model_row model_multiscale_plastic = {
    .name = "multiscale-plastic",
    .label = "multiscale elastic-plastic",
    .short_label = "MS pl.",
    .family = "multiscale",
    .by_default = true,
    .plastic = true,
    .elastic = &model_multiscale_elastic,
    .stacks_scales = true,
    .quantities = COMPUTES,
    .precedence = 4,
    .thesis_place = 1,
    .style = "mp",
    .colour = "#1560B4",
    .marker = 7,
    .equations = "4.12-4.18, 4.40-4.42",
    .source =
        "Krithivasan and Jackson, Tribol. Lett. 27 (2007) 31; Jackson, Krithivasan and Wilson, Proc. IMechE J 222 "
        "(2008) 1; Wilson, Auburn University (2008)",
    .assumes = "as multiscale elastic, with yield of every scale above its critical amplitude; no hardening",
    .valid = "any area ratio; the area steps up by up to 8 % where a scale begins to yield",
    .method = "direct sum over scales",
    .work = work,
    .run = run,
};
