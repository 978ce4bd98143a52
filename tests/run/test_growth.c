/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The work of a whole report, counted in evaluations, grows no faster than points and loads: captions and tables use
 * what the models have computed, and solve nothing again. */
#include "hard_case.h"
#include "pipeline.h"

HARD_CASES("Large reports")

static uint64_t presses; /* of a scale at a load, by the whole program */

/* In place of sinusoid_press() where any file calls it (ld --wrap, tests/CMakeLists.txt). */
void __real_sinusoid_press(struct sinusoid_cell *out, const struct sinusoid_scale *scale,
                           const struct sinusoid_fit *closure, double pressure_Pa, bool with_gap);
void __wrap_sinusoid_press(struct sinusoid_cell *out, const struct sinusoid_scale *scale,
                           const struct sinusoid_fit *closure, double pressure_Pa, bool with_gap);
void __wrap_sinusoid_press(struct sinusoid_cell *out, const struct sinusoid_scale *scale,
                           const struct sinusoid_fit *closure, double pressure_Pa, bool with_gap)
{
    presses++;
    __real_sinusoid_press(out, scale, closure, pressure_Pa, with_gap);
}

/** Evaluations for a report on one tin surface with much roughness at short waves, whose curves have a kink. */
static double presses_of(size_t points, size_t loads)
{
    struct directory place = directory_make();
    struct synth_def def = synth_def_default();
    struct text *csv = support_text();
    double *height_m = support_room(points * sizeof *height_m);
    def.points = points;
    def.length_m = 3e-4;
    def.gamma = 1.2;
    def.seed = 1;
    expect_ok(synth_profile, height_m, &def);
    text_add(csv, "x [m],z [m]\n");
    for (size_t i = 0; i < points; i++)
        text_add(csv, "%.9g,%.9g\n", def.length_m / (double)points * (double)i, height_m[i]);
    directory_write(&place, "in/a.csv", text_string(csv));
    presses = 0;
    pipeline_report(&place, "in", "out",
                    filled("material: tin\nmodels: [multiscale]\neffects: [plasticity, electrical, thermal]\n"
                           "load: {from: 1e-6, to: 0.1, points: %zu}\n",
                           loads));
    expect_in_file(&place, "out/report.md", " has a kink at ");
    char *chart = directory_read(&place, "out/figures/one-surface.csv");
    const char *line = chart;
    for (size_t run = 0; (line = strchr(line, '\n')); line++) { /* a line goes through 400 points at most */
        run = line[1] == '\n' || line[1] == '"' ? 0 : run + 1;
        assert_in_range(run, 0, 401);
    }
    directory_remove(&place);
    return (double)presses;
}

TEST_CASE(test_points)
{
    hard_case("four times as many points: 16 000 for 4000", "work that grows with the square",
              "no faster than the points", "evaluations of a scale, as a factor",
              presses_of(16000, 121) / presses_of(4000, 121), 4.4);
}

TEST_CASE(test_loads)
{
    hard_case("four times as many loads: 484 for 121", "captions and tables that solve again",
              "no faster than the loads", "evaluations of a scale, as a factor",
              presses_of(4000, 484) / presses_of(4000, 121), 4.4);
}
