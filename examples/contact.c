/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a scan says of its surface: cc contact.c $(pkg-config --cflags --libs roughcontact) && ./a.out scan.csv [um] */
#include <roughcontact.h>
#include <stdio.h>

int main(int argc, char **argv)
{
    const double loads[] = {1e-6, 1e-5, 1e-4, 1e-3, 1e-2}; /* P/(A_n E') */
    const size_t count = sizeof loads / sizeof *loads;
    struct roughcontact_status status = {0};
    struct roughcontact_scan_options units;
    struct roughcontact_run_options how;
    struct roughcontact_scan *scan = NULL;
    struct roughcontact_surface *surface = NULL;
    struct roughcontact_material *tin = NULL;
    struct roughcontact_curve *curve = NULL;
    roughcontact_scan_options_init(&units);
    roughcontact_run_options_init(&how);
    units.x_unit = units.z_unit = argc > 2 ? argv[2] : NULL; /* where the file names none */
    if (argc < 2 || roughcontact_scan_read_file(&scan, argv[1], &units, &status) != ROUGHCONTACT_OK ||
        roughcontact_surface_make(&surface, scan, NULL, &status) != ROUGHCONTACT_OK ||
        roughcontact_material_new(&tin, "tin", &status) != ROUGHCONTACT_OK)
        goto end;
    for (size_t i = 0; roughcontact_scan_warning(scan, i); i++)
        fprintf(stderr, "%s\n", roughcontact_scan_warning(scan, i));
    for (size_t i = 0; roughcontact_surface_note(surface, i); i++)
        fprintf(stderr, "%s\n", roughcontact_surface_note(surface, i));
    const struct roughcontact_roughness *roughness = roughcontact_surface_roughness(surface);
    const struct roughcontact_power_law *law = roughcontact_surface_power_law(surface);
    printf("Rq %.6g um, gamma %.4g +- %.2g\n", roughness->rq_m * 1e6, law->gamma, law->gamma_error);
    how.material = tin;
    if (roughcontact_run(&curve, surface, "strip-plastic", loads, count, &how, &status) != ROUGHCONTACT_OK)
        goto end;
    printf("%-12s %-12s %-12s %s\n", "P/A_n (Pa)", "A/A_n", "ECR (ohm m2)", "TCR (K m2/W)");
    for (size_t i = 0; i < count; i++) {
        const struct roughcontact_point *point = roughcontact_curve_point(curve, i);
        printf("%-12.5g %-12.5g %-12.5g %.5g%s\n", point->pressure_Pa, point->area_ratio, point->ecr_ohm_m2,
               point->tcr_K_m2_per_W, point->valid ? "" : "  beyond the model's range");
    }
end:
    if (!curve)
        fprintf(stderr, "%s\n", argc < 2 ? "usage: contact SCAN [UNIT]" : status.message);
    roughcontact_curve_free(curve);
    roughcontact_material_free(tin);
    roughcontact_surface_free(surface);
    roughcontact_scan_free(scan);
    return curve ? 0 : 1;
}
