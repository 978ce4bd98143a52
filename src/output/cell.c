/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/cell.h"

#include <string.h>

const struct cell_column cell_columns[] = {
#define COLUMN(name, member, in_table)                                                                                 \
    {                                                                                                                  \
        name, offsetof(struct surface_summary, member), in_table                                                       \
    }
    COLUMN("spacing_m", spacing_m, CELL_ALWAYS),
    COLUMN("scan_length_m", length_m, CELL_ALWAYS),
    COLUMN("rq_m", roughness.rq_m, CELL_ALWAYS),
    COLUMN("ra_m", roughness.ra_m, CELL_ALWAYS),
    COLUMN("pv_m", roughness.pv_m, CELL_JSON),
    COLUMN("m0_m2", roughness.m0_m2, CELL_ALWAYS),
    COLUMN("m2", roughness.m2, CELL_ALWAYS),
    COLUMN("m4_per_m2", roughness.m4_per_m2, CELL_ALWAYS),
    COLUMN("nayak", asperities.nayak, CELL_ALWAYS),
    COLUMN("asperity_density_per_m2", asperities.density_per_m2, CELL_OF_ASPERITIES),
    COLUMN("asperity_radius_m", asperities.radius_m, CELL_OF_ASPERITIES),
    COLUMN("asperity_sigma_m", asperities.sigma_s_m, CELL_OF_ASPERITIES),
    COLUMN("asperity_offset_m", asperities.offset_m, CELL_OF_ASPERITIES),
    COLUMN("alpha_SI", power_law.alpha, CELL_ALWAYS),
    COLUMN("gamma", power_law.gamma, CELL_ALWAYS),
    COLUMN("gamma_stderr", power_law.gamma_error, CELL_ALWAYS),
    COLUMN("fit_amplitude_m", power_law.amplitude_m, CELL_ALWAYS),
    COLUMN("fit_amplitude_stderr_decades", power_law.amplitude_error_decades, CELL_ALWAYS),
    COLUMN("fit_wavelength_m", power_law.wavelength_m, CELL_ALWAYS),
    COLUMN("fit_low_m", power_law.band_m[0], CELL_ALWAYS),
    COLUMN("fit_high_m", power_law.band_m[1], CELL_ALWAYS),
    COLUMN("fit_misfit_decades", power_law.misfit_decades, CELL_ALWAYS),
    COLUMN("fit_psd_m3", power_law.psd_m3, CELL_JSON),
#undef COLUMN
};
const size_t cell_column_count = sizeof cell_columns / sizeof *cell_columns;

double cell_column_of(const struct surface_summary *surface, size_t column)
{
    double value;
    memcpy(&value, (const char *)surface + cell_columns[column].offset, sizeof value);
    return value;
}
