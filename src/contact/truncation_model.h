/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the models by truncation share: a law made of one surface and one pair of bodies, its curve, its spots, and the
 * correlation that handbooks print for it (docs/equations.md, Truncation). */
#ifndef CONTACT_TRUNCATION_MODEL_H
#define CONTACT_TRUNCATION_MODEL_H

#include "contact/model.h"
#include "contact/truncation.h"

struct truncation_model {
    const char *label;    /* of the closed form */
    const char *hardness; /* what H stands for */
    /** The law for truncation_press(), of sigma = sqrt(m0) and m = sqrt(2 m2/pi) of the task's spectrum. */
    struct truncation (*law)(const struct model_task *task);
    const char *formula; /* the correlation, as handbooks print it */
    /** h sigma/(k m) by it, at P/H. */
    double (*correlation)(double pressure_over_hardness, const struct model_task *task);
    double least, most;    /* P/H between which it was held against the closed form */
    const char *agreement; /* how near it is there */
};

/** Mikic's elastic contact: no model of its own, but what its correlation is fitted to. */
extern const struct truncation_model truncation_model_elastic;

/** Is P/H where the correlation was held against its closed form? */
bool truncation_model_tested(const struct truncation_model *model, double pressure_over_hardness);

/** sigma and m of a task's spectrum. */
double truncation_model_sigma(const struct model_task *task);
double truncation_model_slope(const struct model_task *task);

/** P/H at P/(A_n E') = load. */
double truncation_model_ratio(const struct truncation *law, const struct model_task *task, double load);

/* For model_row: run and spots. The curve ends where the law does, at P/H = f; there is no point of full contact.
 * The separation is empty from f/2 on, where the other's plane would lie below the mean plane: that is no gap.
 * No curve where the surface has no slope, the hardness is not known, or every load is beyond that end. */
enum status_code truncation_model_run(struct model_curve *curve, const struct model_row *row,
                                      const struct model_task *task, struct status *status);
enum status_code truncation_model_spots(struct contact_spots *spots, const struct model_row *row,
                                        const struct model_task *task, struct status *status);

/** What these models compute. */
enum {
    TRUNCATION_MODEL_QUANTITIES = QUANTITY_BIT(QUANTITY_LOAD) | QUANTITY_BIT(QUANTITY_AREA) |
                                  QUANTITY_BIT(QUANTITY_SEPARATION) | QUANTITY_BIT(QUANTITY_ECR) |
                                  QUANTITY_BIT(QUANTITY_TCR)
};
#endif
