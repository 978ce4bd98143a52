/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tables for other programs: each is read back as that program would and holds the numbers of data/; CalculiX, where
 * it is installed, conducts with them. */
#include "cli/process.h"

enum { TABLES = 6, POINTS = 13, ROWS = 20 /* for CalculiX, at most */, NUMBERS = 16 };

/* Where a program has the six tables: h, its low and high end, g, its own. A row's line is the prefix, then numbers
 * and what separates them, between a line that begins with `section` and one that begins with `stop`. */
struct place_of {
    const char *section, *stop, *prefix;
    int pressure, value; /* columns; the same one: of two lines, whose column before is 0 and 1 */
};
#define APDL(name) "*DIM," name ",TABLE,13,1,1,PRESSURE\n", "*", name "(", 2, 2
#define SIF(name)  "\n" name " = Variable \"Contact Pressure\"\n  Real\n", "  End", "", 0, 1
#define COLUMNS(head)                                                                                                  \
    {head, NULL, "", 0, 1}, {head, NULL, "", 0, 2}, {head, NULL, "", 0, 3}, {head, NULL, "", 0, 4},                    \
        {head, NULL, "", 0, 5},                                                                                        \
    {                                                                                                                  \
        head, NULL, "", 0, 6                                                                                           \
    }
static const struct format {
    const char *file;
    struct place_of table[TABLES];
} formats[] = {
    {"calculix.inp",
     {{"*GAP CONDUCTANCE", "*", "", 1, 0},
      {NULL, NULL, "**low ", 1, 0},
      {NULL, NULL, "**high ", 1, 0},
      {NULL, NULL, "**electrical ", 1, 0},
      {NULL, NULL, "**electrical_low ", 1, 0},
      {NULL, NULL, "**electrical_high ", 1, 0}}},
    {"abaqus.inp",
     {{"*GAP CONDUCTANCE, PRESSURE", "*", "", 1, 0},
      {"*GAP CONDUCTANCE, PRESSURE", "*GAP", "**low ", 1, 0},
      {"*GAP CONDUCTANCE, PRESSURE", "*GAP", "**high ", 1, 0},
      {"*GAP ELECTRICAL CONDUCTANCE, PRESSURE", "*", "", 1, 0},
      {"*GAP ELECTRICAL CONDUCTANCE, PRESSURE", "*GAP", "**low ", 1, 0},
      {"*GAP ELECTRICAL CONDUCTANCE, PRESSURE", "*GAP", "**high ", 1, 0}}},
    {"ansys.mac",
     {{APDL("RC1_TCC")},
      {APDL("RC1_TCC_LOW")},
      {APDL("RC1_TCC_HIGH")},
      {APDL("RC1_ECC")},
      {APDL("RC1_ECC_LOW")},
      {APDL("RC1_ECC_HIGH")}}},
    {"elmer.sif",
     {{SIF("Heat Gap Coefficient")},
      {SIF("Heat Gap Coefficient Low")},
      {SIF("Heat Gap Coefficient High")},
      {SIF("Electric Gap Coefficient")},
      {SIF("Electric Gap Coefficient Low")},
      {SIF("Electric Gap Coefficient High")}}},
    {"moose.csv",
     {COLUMNS("pressure_Pa,h_W_per_m2K,h_low_W_per_m2K,h_high_W_per_m2K,g_S_per_m2,g_low_S_per_m2,g_high_S_per_m2\n")}},
    {"comsol.txt",
     {COLUMNS(
         "% pressure_Pa h_W_per_m2K h_low_W_per_m2K h_high_W_per_m2K g_S_per_m2 g_low_S_per_m2 g_high_S_per_m2\n")}},
};

/* The numbers of a line; 0: it holds something else. */
static int numbers_of(double out[NUMBERS], const char *line)
{
    int count = 0;
    for (line += strspn(line, " "); *line != '\n' && *line != '\0' && count < NUMBERS; line += strspn(line, " ,()=")) {
        char *end;
        out[count++] = strtod(line, &end);
        if (end == line)
            return 0;
        line = end;
    }
    return count;
}

static size_t read_table(double pressure[ROWS], double value[ROWS], const char *text, const struct place_of *at)
{
    size_t pressures = 0, values = 0;
    double number[NUMBERS];
    const char *line = at->section ? strstr(text, at->section) : text;
    assert_non_null(line);
    for (line = at->section ? strchr(line + 1, '\n') + 1 : line; *line; line = strchr(line, '\n') + 1) {
        bool row = strncmp(line, at->prefix, strlen(at->prefix)) == 0;
        int count = row ? numbers_of(number, line + strlen(at->prefix)) : 0;
        if (count == 0 && at->stop && strncmp(line, at->stop, strlen(at->stop)) == 0)
            break;
        if (count == 0)
            continue;
        bool apart = at->pressure == at->value;
        assert_true(count > at->pressure && count > at->value);
        assert_true(pressures < ROWS || (apart && values < ROWS));
        if (!apart || number[at->pressure - 1] == 0)
            pressure[pressures++] = number[at->pressure];
        if (!apart || number[at->value - 1] == 1)
            value[values++] = number[at->value];
    }
    assert_int_equal(pressures, values);
    return values;
}

static void make_scene(const char *place, int points, const char *more)
{
    workspace_write(place, "d/scene.yaml",
                    filled("material: copper\nmodels: [cmy]\nload: {from: 0.1 MPa, to: 100 MPa, points: %d}\n"
                           "surfaces:\n  - {name: plain, file: [a.csv, b.csv, c.csv]}\n"
                           "  - {name: \"*STEP $#%%!\", file: [b.csv, c.csv]}\n"
                           "  - {name: -rf, file: c.csv}\n%s",
                           points, more));
    workspace_scan(place, "d/a.csv", 300, 1);
    workspace_scan(place, "d/b.csv", 300, 2);
    workspace_scan(place, "d/c.csv", 300, 3);
}

TEST_IN_WORKSPACE(each_is_read_back)
{
    make_scene(place, POINTS, "export: [calculix, ansys elmer, 'abaqus,moose', comsol]\n");
    run_to_exit(place, 0, "report", "d", "--no-cost", "-o", "o");
    struct table contact = workspace_table(place, "o/data/contact.csv"),
                 bands = workspace_table(place, "o/data/bands.csv");
    static const char *const columns[] = {"tcr_K_m2_per_W", "ecr_ohm_m2"};
    static const char *const ends[] = {"", "_mean_high_95", "_mean_low_95"}; /* of a resistance */
    for (size_t f = 0; f < sizeof formats / sizeof *formats; f++) {
        char path[64], column[64];
        double pressure[ROWS], value[ROWS];
        char *text = workspace_read(place, filled("o/export/plain.%s", formats[f].file));
        expect_parts(text, "surface: plain\n", "it holds from 100000 Pa to ", " Pa", "W/", "S/", "[Pa]");
        for (int t = 0; t < TABLES; t++) {
            assert_int_equal(read_table(pressure, value, text, &formats[f].table[t]), POINTS);
            snprintf(column, sizeof column, "%s%s", columns[t / 3], ends[t % 3]);
            for (size_t r = 0; r < POINTS; r++) {
                assert_string_equal(table_text(&contact, r, "surface"), "plain");
                assert_near(pressure[r], table_number(&contact, r, "pressure_Pa"), 5e-9);
                assert_near(value[r], 1 / table_number(t % 3 ? &bands : &contact, r, column), 5e-9);
                assert_true(r == 0 || pressure[r] > pressure[r - 1]);
            }
        }
        text = workspace_read(place, filled("o/export/_STEP_____~2.%s", formats[f].file));
        expect_part(text, "surface: _STEP ____\n");                        /* nothing that any program would compute */
        snprintf(path, sizeof path, "o/export/_rf~3.%s", formats[f].file); /* no name that is read as an option */
        assert_true(workspace_has(place, path));
    }
    assert_int_equal(workspace_count(place, "-"), 0);
    expect_in_file(place, "o/export/plain.comsol.txt", "[m] rms height", " mean absolute slope", "[Pa] hardness");
    expect_in_file(place, "o/manifest.txt", "\nexport/plain.ansys.mac\n");
    expect_in_file(place, "o/report.md", "For other programs", "export/plain.ansys.mac,", "export/plain.moose.csv");
}

TEST_IN_WORKSPACE(what_is_in_the_joint_is_in_the_tables)
{
    make_scene(place, POINTS,
               "gap: {gas: air, pressure: 1 atm, temperature: 300 K}\nfilm: 1e-12 ohm m2\nexport: moose\n");
    run_to_exit(place, 0, "report", "d", "--no-cost", "-o", "o");
    struct table contact = workspace_table(place, "o/data/contact.csv");
    char *text = workspace_read(place, "o/export/plain.moose.csv");
    double pressure[ROWS], value[ROWS];
    expect_parts(text, "; with what fills the gaps; with film and plating\n");
    assert_int_equal(read_table(pressure, value, text, &formats[4].table[0]), POINTS);
    assert_near(value[3], table_number(&contact, 3, "joint_W_per_m2K"), 5e-9);
    read_table(pressure, value, text, &formats[4].table[3]);
    assert_near(value[3], 1 / table_number(&contact, 3, "joint_ecr_ohm_m2"), 5e-9);
}

TEST_IN_WORKSPACE(only_what_is_asked_for)
{
    make_scene(place, POINTS, "");
    run_to_exit(place, 0, "report", "d", "--no-cost", "-o", "o", "--export", "moose");
    assert_true(workspace_has(place, "o/export/plain.moose.csv"));
    assert_false(workspace_has(place, "o/export/plain.ansys.mac"));
    workspace_write(place, "o/export/mine.txt", "mine\n");
    run_to_exit(place, 0, "report", "d", "--no-cost", "-o", "o");
    assert_false(workspace_has(place, "o/export/plain.moose.csv"));
    expect_in_file(place, "o/export/mine.txt", "mine\n");
    expect_not_in_file(place, "o/view.json", "\"exports\"");
    run_to_exit(place, 0, "report", "d", "--no-cost", "-o", "none");
    assert_false(workspace_has(place, "none/export"));
    expect_failure(place, 2, 1,
                   "--export: unknown program 'fluent'; there are abaqus, ansys, calculix, comsol, elmer, moose",
                   "report", "d", "--export", "moose,fluent");
    expect_failure(place, 2, 1, "--export: names no program", "report", "d", "--export", "");
    workspace_write(place, "d/scene.yaml", "export: moose\n");
    expect_failure(place, 3, 1, "d/scene.yaml: export: surface 'a' has no material", "report", "d");
    workspace_write(place, "d/scene.yaml", "material: copper\nexport: fluent\n");
    expect_failure(place, 3, 1, "d/scene.yaml: export: unknown program 'fluent'; there are abaqus", "plan", "d");
}

/* Blocks of 20 mm at 100 W/(m K) and 30 mm at 30 W/(m K), pressed together by 5.5 bar, which lies between two rows. */
static const char deck[] =
    "*NODE, NSET=ALL\n1,0,0,0\n2,.01,0,0\n3,.01,.01,0\n4,0,.01,0\n5,0,0,.02\n6,.01,0,.02\n7,.01,.01,.02\n8,0,.01,.02\n"
    "11,0,0,.02\n12,.01,0,.02\n13,.01,.01,.02\n14,0,.01,.02\n15,0,0,.05\n16,.01,0,.05\n17,.01,.01,.05\n18,0,.01,.05\n"
    "*ELEMENT, TYPE=C3D8, ELSET=LOWER\n1,1,2,3,4,5,6,7,8\n"
    "*ELEMENT, TYPE=C3D8, ELSET=UPPER\n2,11,12,13,14,15,16,17,18\n"
    "*MATERIAL, NAME=ONE\n*ELASTIC\n1e11,0\n*CONDUCTIVITY\n100.\n"
    "*MATERIAL, NAME=TWO\n*ELASTIC\n1e11,0\n*CONDUCTIVITY\n30.\n"
    "*SOLID SECTION, ELSET=LOWER, MATERIAL=ONE\n*SOLID SECTION, ELSET=UPPER, MATERIAL=TWO\n"
    "*SURFACE, NAME=SLAVE\n2,S1\n*SURFACE, NAME=MASTER\n1,S2\n"
    "*SURFACE INTERACTION, NAME=JOINT\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n1e14,1e3\n"
    "*INCLUDE, INPUT=o/export/plain.calculix.inp\n"
    "*CONTACT PAIR, INTERACTION=JOINT, TYPE=SURFACE TO SURFACE\nSLAVE,MASTER\n"
    "*INITIAL CONDITIONS, TYPE=TEMPERATURE\nALL,300.\n"
    "*STEP, NLGEOM\n*COUPLED TEMPERATURE-DISPLACEMENT, STEADY STATE\n1.,1.\n"
    "*BOUNDARY\n1,1,3\n2,1,3\n3,1,3\n4,1,3\nALL,1,2\n1,11,11,400.\n2,11,11,400.\n3,11,11,400.\n4,11,11,400.\n"
    "15,11,11,300.\n16,11,11,300.\n17,11,11,300.\n18,11,11,300.\n"
    "*DLOAD\n2,P2,5.5e5\n*EL PRINT, ELSET=UPPER\nHFL\n*END STEP\n";

TEST_IN_WORKSPACE(calculix_conducts_with_it)
{
    if (!workspace_can_run(place, "command -v ccx >/dev/null")) {
        print_message("[  SKIPPED ] no ccx (Debian: calculix-ccx)\n");
        skip();
    }
    make_scene(place, 1000, "export: calculix\n");
    run_to_exit(place, 0, "report", "d", "--no-cost", "-o", "o");
    struct table contact = workspace_table(place, "o/data/contact.csv");
    double p[ROWS], h[ROWS];
    char *text = workspace_read(place, "o/export/plain.calculix.inp");
    size_t r = 1, last = 999; /* of a thousand points the few that ccx takes */
    assert_int_equal(read_table(p, h, text, &formats[0].table[0]), ROWS);
    assert_near(h[0], 1 / table_number(&contact, 0, "tcr_K_m2_per_W"), 5e-9);
    assert_near(h[ROWS - 1], 1 / table_number(&contact, last, "tcr_K_m2_per_W"), 5e-9);
    while (p[r] < 5.5e5)
        r++;
    double between = h[r - 1] + (h[r] - h[r - 1]) * (5.5e5 - p[r - 1]) / (p[r] - p[r - 1]);
    workspace_write(place, "job.inp", deck);
    workspace_shell(place, "ccx job");
    char *flux = workspace_shell(place, "awk 'NF == 5 && $1 == 2 {print $5; exit}' job.dat");
    assert_near(100 / strtod(flux, NULL), 0.02 / 100 + 1 / between + 0.03 / 30, 1e-6);
    assert_true(1 / between > 1e-5); /* of which the contact is a part that would be missed */
}
