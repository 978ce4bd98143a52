/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cooper, Mikic and Yovanovich's contact as a model: plastic, by truncation. */
#include "contact/cmy.h"
#include "contact/truncation_model.h"

static struct truncation law(const struct model_task *task)
{
    return cmy_plastic(truncation_model_sigma(task), truncation_model_slope(task), task->hardness_Pa);
}

static double correlation(double pressure_over_hardness, const struct model_task *task)
{
    (void)task;
    return cmy_plastic_correlation(pressure_over_hardness);
}

static const struct truncation_model plastic = {
    .label = "CMY, plastic",
    .hardness = "the hardness",
    .law = law,
    .formula = "1.25 (P/H)^0.95",
    .correlation = correlation,
    .least = 1.2e-4,
    .most = 2e-2,
    .agreement = "0.987…1.010 of the closed form; 6 % less at P/H = 0.07",
};

const struct model_row model_cmy = {
    .name = "cmy",
    .label = "CMY",
    .short_label = "CMY",
    .family = "cmy",
    .plastic = true,
    .truncation_model = &plastic,
    .quantities = TRUNCATION_MODEL_QUANTITIES,
    .may_be_empty = QUANTITY_BIT(QUANTITY_SEPARATION),
    .largest_area = TRUNCATION_VALID_AREA,
    .style = "cy",
    .colour = "#8C6D31",
    .marker = 15,
    .equations = "truncation",
    .source = "Cooper, Mikic and Yovanovich, Int. J. Heat Mass Transf. 12 (1969) 279",
    .assumes = "isotropic Gaussian surface, of which all that is truncated touches; every spot bears the hardness (the "
               "scene's, else 2.84 S_y); round spots",
    .valid = "Gaussian heights, first loading, P/H up to 0.1: beyond, islands run together; it ends at P = H. From ten "
             "spots on, resistance 0.6 to 1.1 of direct solutions of the same islands, which are neither round nor "
             "evenly spread",
    .method = "closed form",
    .run = truncation_model_run,
    .spots = truncation_model_spots,
};
