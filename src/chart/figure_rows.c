/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which figures a report may hold (docs/report.md, Figures). */
#include "chart/figure.h"

const double figure_lowest_separation = -0.5;

static const char scale_dependence[] = "scale-dependent / plain";

#define MODELS(first, where, words, in_terminal, across, up, under)                                                    \
    {                                                                                                                  \
        .number = (first), .kind = FIGURE_MODELS, .section = (where), .title = (words), .terminal = (in_terminal),     \
        .x = (across), .y = (up), .below = (under), .below_label = scale_dependence                                    \
    }
#define JOINT(file, words, up, ...)                                                                                    \
    {                                                                                                                  \
        .name = (file), .kind = FIGURE_MODELS, .section = "joint", .title = (words), .x = QUANTITY_LOAD, .y = (up),    \
        __VA_ARGS__                                                                                                    \
    }
#define BEYOND(file, words, up)                                                                                        \
    {                                                                                                                  \
        .name = (file), .kind = FIGURE_MODELS, .section = "beyond thesis", .title = (words), .x = QUANTITY_LOAD,       \
        .y = (up), .beyond_thesis = true                                                                               \
    }
#define SURFACES(first, file, where, in_terminal, across, up, under)                                                   \
    {                                                                                                                  \
        .number = (first), .name = (file), .kind = FIGURE_SURFACES, .section = (where), .terminal = (in_terminal),     \
        .x = (across), .y = (up), .below = (under), .below_label = scale_dependence                                    \
    }
#define SWEEP(first, parameter, words, what)                                                                           \
    {                                                                                                                  \
        .number = (first), .name = (parameter), .kind = FIGURE_SWEEP, .section = "convergence", .title = (words),      \
        .sweep = (what)                                                                                                \
    }
#define SENSITIVITY(file, words, up)                                                                                   \
    {                                                                                                                  \
        .name = (file), .kind = FIGURE_SENSITIVITY, .section = "sensitivity", .title = (words), .y = (up)              \
    }
#define BENCHMARK(file, words, what)                                                                                   \
    {                                                                                                                  \
        .name = (file), .kind = FIGURE_BENCHMARK, .section = "cost", .title = (words), .chart = (what)                 \
    }

#define DIRECT(file, what, words, in_terminal, up)                                                                     \
    {                                                                                                                  \
        .name = (file), .kind = (what), .section = "direct", .title = (words), .terminal = (in_terminal),              \
        .x = QUANTITY_LOAD, .y = (up)                                                                                  \
    }

const struct figure_row figure_rows[] = {
    SWEEP(1, "alpha", "Area against wavelength, α varied", CONVERGENCE_ALPHA),
    SWEEP(3, "gamma", "Area against wavelength, γ varied", CONVERGENCE_GAMMA),
    MODELS(5, "baseline area", "Real contact area against load", true, QUANTITY_LOAD, QUANTITY_AREA, QUANTITY_LOAD),
    MODELS(6, "baseline separation", "Separation against area", false, QUANTITY_AREA, QUANTITY_SEPARATION,
           QUANTITY_LOAD),
    MODELS(7, "baseline separation", "Separation against load", true, QUANTITY_LOAD, QUANTITY_SEPARATION,
           QUANTITY_LOAD),
    MODELS(8, "baseline electrical", "Electrical contact resistance against load", true, QUANTITY_LOAD, QUANTITY_ECR,
           QUANTITY_LOAD),
    MODELS(9, "baseline thermal", "Thermal contact resistance against load", false, QUANTITY_LOAD, QUANTITY_TCR,
           QUANTITY_TCR_SCALE_DEPENDENT),
    {.number = 10, .kind = FIGURE_PROFILES, .section = "profiles", .title = "Surface profiles"},
    BEYOND("models-area", "Area against load, every model", QUANTITY_AREA),
    BEYOND("models-separation", "Separation against load, every model", QUANTITY_SEPARATION),
    BEYOND("models-ecr", "ECR against load, every model", QUANTITY_ECR),
    JOINT("joint-conductance", "Joint conductance against load", QUANTITY_JOINT, .below = QUANTITY_GAP,
          .below_label = "share of what fills the gaps"),
    JOINT("joint-gap", "Gap conductance against load", QUANTITY_GAP, .below = QUANTITY_LOAD),
    JOINT("joint-ecr", "ECR with film and plating against load", QUANTITY_JOINT_ECR, .below = QUANTITY_LOAD),
    JOINT("joint-temperature", "Contact temperature against load", QUANTITY_TEMPERATURE, .below = QUANTITY_LOAD),
    DIRECT("direct-area", FIGURE_DIRECT, "Area against load, models and direct solution", true, QUANTITY_AREA),
    DIRECT("direct-gap", FIGURE_DIRECT, "Separation against load, models and direct solution", false,
           QUANTITY_SEPARATION),
    DIRECT("direct-ecr", FIGURE_DIRECT, "ECR against load, models and direct solution", false, QUANTITY_ECR),
    DIRECT("direct-ratio-area", FIGURE_DIRECT_RATIO, "Area, model over direct solution", false, QUANTITY_AREA),
    DIRECT("direct-ratio-gap", FIGURE_DIRECT_RATIO, "Separation, model over direct solution", false,
           QUANTITY_SEPARATION),
    DIRECT("direct-ratio-ecr", FIGURE_DIRECT_RATIO, "ECR, model over direct solution", false, QUANTITY_ECR),
    DIRECT("direct-patches", FIGURE_PATCHES, "Where the surfaces touch", false, QUANTITY_AREA),
    SURFACES(11, "area-load", "surfaces area", true, QUANTITY_LOAD, QUANTITY_AREA, QUANTITY_LOAD),
    SURFACES(15, "separation-load", "surfaces separation", true, QUANTITY_LOAD, QUANTITY_SEPARATION, QUANTITY_LOAD),
    SURFACES(19, "separation-area", "surfaces separation-area", false, QUANTITY_AREA, QUANTITY_SEPARATION,
             QUANTITY_LOAD),
    SURFACES(23, "ecr-load", "surfaces electrical", false, QUANTITY_LOAD, QUANTITY_ECR, QUANTITY_LOAD),
    SURFACES(27, "tcr-load", "surfaces thermal", false, QUANTITY_LOAD, QUANTITY_TCR, QUANTITY_TCR_SCALE_DEPENDENT),
    {.name = "power-law", .kind = FIGURE_SPECTRA, .section = "power law", .title = "Spectra and their power laws"},
    SENSITIVITY("sensitivity-area", "Area against the shortest wavelength included", QUANTITY_AREA),
    SENSITIVITY("sensitivity-ecr", "ECR against the shortest wavelength included", QUANTITY_ECR),
    BENCHMARK("cost-direct-area", "Mean error of the area against time, models and direct solution",
              BENCHMARK_DIRECT_AREA),
    BENCHMARK("cost-direct-gap", "Mean error of the separation against time, models and direct solution",
              BENCHMARK_DIRECT_GAP),
    BENCHMARK("cost-direct-ecr", "Mean error of ECR against time, models and direct solution", BENCHMARK_DIRECT_ECR),
    BENCHMARK("cost-integrals", "Error against time, integrals of the statistical models", BENCHMARK_INTEGRALS),
    BENCHMARK("cost-curves", "Error against time, scales and loads left out", BENCHMARK_CURVES),
};
const size_t figure_row_count = sizeof figure_rows / sizeof *figure_rows;
