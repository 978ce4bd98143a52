/* Which figures a report may hold (contract "Figures of the report"). */
#include "chart/figure.h"

#include <string.h>

#define SURFACES(number, x, y, model, terminal, title)                                                                 \
    {                                                                                                                  \
        number, FIGURE_SURFACES, x, y, model, CONVERGENCE_ALPHA, terminal, title, BENCHMARK_CHARTS                     \
    }
#define MODELS(number, x, y, terminal, title)                                                                          \
    {                                                                                                                  \
        number, FIGURE_MODELS, x, y, MODEL_COUNT, CONVERGENCE_ALPHA, terminal, title, BENCHMARK_CHARTS                 \
    }
#define SWEEP(number, model, sweep, title)                                                                             \
    {                                                                                                                  \
        number, FIGURE_SWEEP, FIGURE_WAVELENGTH, FIGURE_AREA, model, sweep, false, title, BENCHMARK_CHARTS             \
    }
#define OTHER(number, kind, cost, title)                                                                               \
    {                                                                                                                  \
        number, kind, FIGURE_WAVELENGTH, FIGURE_AREA, MODEL_COUNT, CONVERGENCE_ALPHA, false, title, cost               \
    }

const struct figure_row figure_rows[] = {
    SWEEP("6-01", MODEL_MULTISCALE_ELASTIC, CONVERGENCE_ALPHA, "Area against wavelength, α varied, elastic"),
    SWEEP("6-02", MODEL_MULTISCALE_PLASTIC, CONVERGENCE_ALPHA, "Area against wavelength, α varied, elastic-plastic"),
    SWEEP("6-03", MODEL_MULTISCALE_ELASTIC, CONVERGENCE_GAMMA, "Area against wavelength, γ varied, elastic"),
    SWEEP("6-04", MODEL_MULTISCALE_PLASTIC, CONVERGENCE_GAMMA, "Area against wavelength, γ varied, elastic-plastic"),
    MODELS("6-05", FIGURE_LOAD, FIGURE_AREA, true, "Real contact area against load"),
    MODELS("6-06", FIGURE_AREA, FIGURE_SEPARATION, false, "Separation against area"),
    MODELS("6-07", FIGURE_LOAD, FIGURE_SEPARATION, true, "Separation against load"),
    MODELS("6-08", FIGURE_LOAD, FIGURE_ECR, true, "Electrical contact resistance against load"),
    MODELS("6-09", FIGURE_LOAD, FIGURE_TCR, false, "Thermal contact resistance against load"),
    OTHER("6-10", FIGURE_PROFILES, BENCHMARK_CHARTS, "Surface profiles"),
    SURFACES("6-11", FIGURE_LOAD, FIGURE_AREA, MODEL_MULTISCALE_PLASTIC, true,
             "Area against load, multiscale elastic-plastic"),
    SURFACES("6-12", FIGURE_LOAD, FIGURE_AREA, MODEL_MULTISCALE_ELASTIC, false,
             "Area against load, multiscale elastic"),
    SURFACES("6-13", FIGURE_LOAD, FIGURE_AREA, MODEL_JG, false, "Area against load, JG"),
    SURFACES("6-14", FIGURE_LOAD, FIGURE_AREA, MODEL_GW, false, "Area against load, GW"),
    SURFACES("6-15", FIGURE_LOAD, FIGURE_SEPARATION, MODEL_MULTISCALE_PLASTIC, true,
             "Separation against load, multiscale elastic-plastic"),
    SURFACES("6-16", FIGURE_LOAD, FIGURE_SEPARATION, MODEL_MULTISCALE_ELASTIC, false,
             "Separation against load, multiscale elastic"),
    SURFACES("6-17", FIGURE_LOAD, FIGURE_SEPARATION, MODEL_JG, false, "Adjusted separation against load, JG"),
    SURFACES("6-18", FIGURE_LOAD, FIGURE_SEPARATION, MODEL_GW, false, "Adjusted separation against load, GW"),
    SURFACES("6-19", FIGURE_AREA, FIGURE_SEPARATION, MODEL_MULTISCALE_PLASTIC, false,
             "Separation against area, multiscale elastic-plastic"),
    SURFACES("6-20", FIGURE_AREA, FIGURE_SEPARATION, MODEL_MULTISCALE_ELASTIC, false,
             "Separation against area, multiscale elastic"),
    SURFACES("6-21", FIGURE_AREA, FIGURE_SEPARATION, MODEL_JG, false, "Adjusted separation against area, JG"),
    SURFACES("6-22", FIGURE_AREA, FIGURE_SEPARATION, MODEL_GW, false, "Adjusted separation against area, GW"),
    SURFACES("6-23", FIGURE_LOAD, FIGURE_ECR, MODEL_MULTISCALE_PLASTIC, false,
             "ECR against load, multiscale elastic-plastic"),
    SURFACES("6-24", FIGURE_LOAD, FIGURE_ECR, MODEL_MULTISCALE_ELASTIC, false, "ECR against load, multiscale elastic"),
    SURFACES("6-25", FIGURE_LOAD, FIGURE_ECR, MODEL_JG, false, "ECR against load, JG"),
    SURFACES("6-26", FIGURE_LOAD, FIGURE_ECR, MODEL_GW, false, "ECR against load, GW"),
    SURFACES("6-27", FIGURE_LOAD, FIGURE_TCR, MODEL_MULTISCALE_PLASTIC, false,
             "TCR against load, multiscale elastic-plastic"),
    SURFACES("6-28", FIGURE_LOAD, FIGURE_TCR, MODEL_MULTISCALE_ELASTIC, false, "TCR against load, multiscale elastic"),
    SURFACES("6-29", FIGURE_LOAD, FIGURE_TCR, MODEL_JG, false, "TCR against load, JG"),
    SURFACES("6-30", FIGURE_LOAD, FIGURE_TCR, MODEL_GW, false, "TCR against load, GW"),
    OTHER("power-law", FIGURE_SPECTRA, BENCHMARK_CHARTS, "Spectra and their power laws"),
    OTHER("cost-integrals", FIGURE_COST, BENCHMARK_INTEGRALS,
          "Error against time, integrals of the statistical models"),
    OTHER("cost-curves", FIGURE_COST, BENCHMARK_CURVES, "Error against time, scales and loads left out"),
};
const size_t figure_count = sizeof figure_rows / sizeof figure_rows[0];

const struct figure_row *figure_find(const char *number)
{
    for (size_t i = 0; i < figure_count; i++)
        if (strcmp(figure_rows[i].number, number) == 0)
            return &figure_rows[i];
    return NULL;
}
