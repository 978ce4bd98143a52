#include "contact/quantity.h"

#include <string.h>

#define FIELD(member) offsetof(struct contact_point, member)

const struct quantity_row quantity_rows[QUANTITY_COUNT] = {
    [QUANTITY_LOAD] = {"load_over_AnEp", "load_over_AnEp", NULL, "P/(Aₙ E′)", "load", "Load", "", "load P/(Aₙ E′)", 0,
                       true, false, FIELD(load)},
    [QUANTITY_AREA] = {"area_ratio", "area_ratio", NULL, "A/Aₙ", "area", "Area", "", "area ratio A/Aₙ", 0, true, false,
                       FIELD(area_ratio)},
    [QUANTITY_SEPARATION] = {"separation_m", "separation_m", "separation_over_sigma", "separation/σ", "separation",
                             "Separation", "σ", "separation / σ", EFFECT_BIT(EFFECT_SEPARATION), false, true,
                             FIELD(separation_m)},
    [QUANTITY_ADJUSTED] = {"adjusted_separation_m", NULL, "adjusted_separation_over_sigma", "adjusted", "separation",
                           "Adjusted separation", "σ", "separation / σ", EFFECT_BIT(EFFECT_SEPARATION), false, true,
                           FIELD(adjusted_m)},
    [QUANTITY_ECR] = {"ecr_ohm_m2", "ecr_ohm_m2", NULL, "ECR·Aₙ", "ECR", "ECR", "Ω·m²", "ECR·Aₙ (Ω·m²)",
                      EFFECT_BIT(EFFECT_ELECTRICAL), true, false, FIELD(ecr_ohm_m2)},
    [QUANTITY_TCR] = {"tcr_K_m2_per_W", "tcr_K_m2_per_W", NULL, "TCR·Aₙ", "TCR", "TCR", "K·m²/W", "TCR·Aₙ (K·m²/W)",
                      EFFECT_BIT(EFFECT_THERMAL), true, false, FIELD(tcr_K_m2_per_W)},
    [QUANTITY_TCR_SCALE_DEPENDENT] = {"tcr_sd_K_m2_per_W", "tcr_sd_K_m2_per_W", NULL, "TCR·Aₙ, scale-dependent", "TCR",
                                      "TCR", "K·m²/W", "TCR·Aₙ (K·m²/W)", EFFECT_BIT(EFFECT_SCALE_DEPENDENT), true,
                                      false, FIELD(tcr_sd_K_m2_per_W)},
};

double quantity_value(const struct contact_point *point, enum quantity quantity)
{
    double value;
    memcpy(&value, (const char *)point + quantity_rows[quantity].offset, sizeof value);
    return value;
}

double quantity_shown(const struct contact_point *point, enum quantity quantity, double sigma_m)
{
    double value = quantity_value(point, quantity);
    return quantity_rows[quantity].over_sigma ? value / sigma_m : value;
}

unsigned quantity_wanted(unsigned effects)
{
    unsigned wanted = 0;
    for (int q = 0; q < QUANTITY_COUNT; q++)
        if ((effects & quantity_rows[q].effect) == quantity_rows[q].effect)
            wanted |= QUANTITY_BIT(q);
    return wanted;
}
