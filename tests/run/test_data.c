/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The files in data/ for many surfaces; they do not depend on the number of threads. */
#include "run/pipeline.h"

enum { POINTS = 64, MANY = 101 };

static void write_scene(const struct directory *place, const char *more)
{
    directory_write(place, "in/scene.yaml",
                    filled("effects: [separation]\nmodels: [multiscale, gw]\n"
                           "load: {from: 1e-5, to: 1e-3, points: 3}\n%s",
                           more));
}

static void make_surfaces(const struct directory *place, int count)
{
    for (int i = 0; i < count; i++)
        pipeline_rough(place, filled("in/%03d.csv", i), POINTS, 1 + i / 50.0, (unsigned long)i + 1);
}

/* Spectra are binned by tenths of a decade, and bins keep each surface's mean square height. */
TEST_IN_DIRECTORY(of_many_surfaces_bins)
{
    make_surfaces(place, MANY);
    write_scene(place, "material: tin\n");
    assert_int_equal(pipeline_run(place, "in", "one", 1), 0);
    write_scene(place, "material: tin\nexport: calculix\n");
    assert_int_equal(pipeline_run(place, "in", "other", 3), 0);
    struct table bins = directory_table(place, "one/data/spectrum.csv");
    struct table all = directory_table(place, "other/data/spectrum.csv");
    assert_int_equal(all.rows, MANY * POINTS / 2);
    assert_int_equal(all.columns, 4);
    assert_int_equal(bins.rows, MANY * 13); /* of 16 tenths up to 32 harmonics, 1, 2 and 5 hold none */
    size_t row = 0;
    for (size_t r = 0; r < bins.rows; r++) {
        size_t harmonics = (size_t)table_number(&bins, r, "harmonics");
        double square = 0, longest = table_number(&all, row, "wavelength_m");
        assert_string_equal(table_text(&bins, r, "surface"), table_text(&all, row, "surface"));
        for (size_t i = 0; i < harmonics; i++, row++) {
            double amplitude_m = table_number(&all, row, "amplitude_m");
            bool nyquist = (row + 1) % (POINTS / 2) == 0;
            square += (nyquist ? 2 : 1) * amplitude_m * amplitude_m;
        }
        double shortest = table_number(&all, row - 1, "wavelength_m"), mean = table_number(&bins, r, "wavelength_m");
        assert_true(mean >= shortest * (1 - 1e-14) && mean <= longest * (1 + 1e-14) && longest / shortest < 1.2589255);
        assert_near(table_number(&bins, r, "amplitude_m"), sqrt(square / (double)harmonics), 1e-13);
        if (harmonics == 1)
            assert_string_equal(table_text(&bins, r, "fit_m"), table_text(&all, row - 1, "fit_m"));
    }
    assert_int_equal(row, all.rows);
    directory_expect_same(place, "one/data/contact.csv", "other/data/contact.csv"); /* by one thread and by three */
    directory_expect_same(place, "one/data/surfaces.csv", "other/data/surfaces.csv");
    directory_expect_same(place, "one/data/sensitivity.csv", "other/data/sensitivity.csv");
    expect_in_file(place, "one/results.json", "\"spectra\": \"bins\"", "\"curves\": \"in data/contact.csv alone\"",
                   "\"full_contact_load_over_AnEp\": ");
    expect_not_in_file(place, "one/results.json", "\"area_ratio\": [");
    expect_in_file(place, "one/report.md", "`data/spectrum.csv` holds bins of a tenth of a decade",
                   "| … 1 more in data/ |");
    expect_in_file(place, "other/results.json", "\"spectra\": \"every harmonic\"", "\"area_ratio\": [");
    expect_not_in_file(place, "other/results.json", "data/contact.csv alone");
    expect_not_in_file(place, "other/report.md", "bins of a tenth");
}

/* Number of surfaces listed on the terminal, and whether it says that there are more. */
static size_t lines_of_surfaces(const struct directory *place, bool *more)
{
    const struct run_outcome *outcome = pipeline_outcome(place, "in", "one", (struct run_options){.jobs = 2});
    size_t lines = 0;
    for (const char *line = text_string(&outcome->table); (line = strchr(line, '\n')) != NULL && *++line;)
        lines += line[0] >= '0' && line[0] <= '9';
    *more = strstr(text_string(&outcome->table), "\n… 1 more in data/surfaces.csv\n") != NULL;
    return lines;
}

TEST_IN_DIRECTORY(the_terminal_shows_a_hundred)
{
    bool more;
    make_surfaces(place, MANY - 1);
    write_scene(place, "");
    assert_int_equal(lines_of_surfaces(place, &more), MANY - 1);
    assert_false(more);
    assert_int_equal(directory_table(place, "one/data/spectrum.csv").rows, (MANY - 1) * POINTS / 2); /* no bins */
    make_surfaces(place, MANY);
    assert_int_equal(lines_of_surfaces(place, &more), MANY - 1);
    assert_true(more);
}
