/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sridhar and Yovanovich's contact as a model: elastoplastic, by truncation. */
#include "contact/sridhar_yovanovich.h"
#include "contact/truncation_model.h"

static struct truncation law(const struct model_task *task)
{
    return sridhar_yovanovich(truncation_model_sigma(task), truncation_model_slope(task),
                              task->pair->effective_modulus_Pa, task->pair->yield_strength_Pa);
}

static double correlation(double pressure_over_hardness, const struct model_task *task)
{
    return sridhar_yovanovich_correlation(
        pressure_over_hardness, sridhar_yovanovich_strain(task->pair->effective_modulus_Pa,
                                                          task->pair->yield_strength_Pa, truncation_model_slope(task)));
}

static const struct truncation_model elastoplastic = {
    .label = "Sridhar-Yovanovich, elastoplastic",
    .hardness = "H_ep = 2.76 S_y/√(1 + (6.5/e)²), e = 1.67 E′m/S_y",
    .law = law,
    .formula = "1.245 b₁ (P/H)^(0.95 b₂) with b₁ = (1 + 46690/e^2.49)^(1/30), b₂ = (1 + 2086.9/e^1.842)^(−1/600); up "
               "to e = 5 1.54 (P/H)^0.94",
    .correlation = correlation,
    .least = 1e-5,
    .most = 1e-2,
    .agreement = "within 4 %; constants not seen in a readable source",
};

const struct model_row model_sridhar_yovanovich = {
    .name = "sridhar-yovanovich",
    .label = "Sridhar-Yovanovich",
    .short_label = "SY",
    .family = "sridhar-yovanovich",
    .plastic = true,
    .truncation_model = &elastoplastic,
    .quantities = TRUNCATION_MODEL_QUANTITIES,
    .may_be_empty = QUANTITY_BIT(QUANTITY_SEPARATION),
    .largest_area = TRUNCATION_VALID_AREA,
    .style = "sy",
    .colour = "#5F5F5F",
    .marker = 13,
    .equations = "truncation",
    .source = "Sridhar and Yovanovich, J. Heat Transf. 118 (1996) 3; its constants were not seen in a readable source, "
              "and pass five numerical checks, no more",
    .assumes = "isotropic Gaussian surface, of which between half (elastic) and all (plastic) of what is truncated "
               "touches; flow stress S_y of the softer body, whatever the scene's hardness",
    .valid = "Gaussian heights, first loading, P/H_ep up to 0.1: beyond, islands run together; it ends at P/H_ep = f; "
             "resistance no nearer than that of CMY",
    .method = "closed form",
    .run = truncation_model_run,
    .spots = truncation_model_spots,
};
