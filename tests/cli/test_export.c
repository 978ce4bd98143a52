/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tables for other programs: each is read back as that program would and has the numbers of data/. CalculiX, if
 * installed, computes with them. */
#include "cli/process.h"

enum { TABLES = 6, POINTS = 13, ROWS = 20 /* for CalculiX, at most */, NUMBERS = 16 };

/* Where a program has the six tables: h, its low and high end, g, its own. A row's line is the prefix, then numbers
 * and what separates them, between a line that begins with `section` and one that begins with `stop`. */
struct place_of {
    const char *section, *stop, *prefix;
    int pressure, value; /* columns; the same one: of two lines, whose column before is 0 and 1 */
};
#define ABAQUS(head)                                                                                                   \
    {head, "*", "", 1, 0}, {head, "*GAP", "**low ", 1, 0},                                                             \
    {                                                                                                                  \
        head, "*GAP", "**high ", 1, 0                                                                                  \
    }
#define APDL_ONE(name)                                                                                                 \
    {                                                                                                                  \
        "*DIM," name ",TABLE,14,1,1,PRESSURE\n", "*", name "(", 2, 2                                                   \
    }
#define APDL(name) APDL_ONE(name), APDL_ONE(name "_LOW"), APDL_ONE(name "_HIGH")
#define SIF_ONE(name)                                                                                                  \
    {                                                                                                                  \
        "\n" name " = Variable \"Contact Pressure\"\n  Real\n", "  End", "", 0, 1                                      \
    }
#define SIF(name) SIF_ONE(name), SIF_ONE(name " Low"), SIF_ONE(name " High")
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
    {"abaqus.inp", {ABAQUS("*GAP CONDUCTANCE, PRESSURE"), ABAQUS("*GAP ELECTRICAL CONDUCTANCE, PRESSURE")}},
    {"ansys.mac", {APDL("RC1_TCC"), APDL("RC1_ECC")}},
    {"elmer.sif", {SIF("Heat Gap Coefficient"), SIF("Electric Gap Coefficient")}},
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
    workspace_scans(place, "d", 3, 300, 1);
}

TEST_IN_WORKSPACE(each_is_read_back)
{
    make_scene(place, POINTS, "export: [calculix, ansys elmer, 'abaqus,moose', comsol]\n");
    report_scene(place, "o", NULL);
    struct table contact = workspace_table(place, "o/data/contact.csv"),
                 bands = workspace_table(place, "o/data/bands.csv");
    static const char *const columns[] = {"tcr_K_m2_per_W", "ecr_ohm_m2"};
    static const char *const ends[] = {"", "_mean_high_95", "_mean_low_95"}; /* of a resistance */
    for (size_t f = 0; f < sizeof formats / sizeof *formats; f++) {
        char column[64];
        double pressure[ROWS], value[ROWS];
        char *text = workspace_read(place, filled("o/export/plain.%s", formats[f].file));
        expect_parts(text, "surface: plain\n", "it holds from 100000 Pa to ", " Pa", "Units: N, m, s, J, K.\n",
                     "Thermal: spots. Electrical: spots. At no pressure nothing conducts.\n", "[W/(m2 K)]", "[S/m2]",
                     "[Pa]");
        for (int t = 0; t < TABLES; t++) {
            assert_int_equal(read_table(pressure, value, text, &formats[f].table[t]), POINTS + 1);
            snprintf(column, sizeof column, "%s%s", columns[t / 3], ends[t % 3]);
            assert_true(pressure[0] == 0 && value[0] == 0); /* else a program would carry the next row on */
            for (size_t r = 0; r < POINTS; r++) {
                assert_string_equal(table_text(&contact, r, "surface"), "plain");
                assert_near(pressure[r + 1], table_number(&contact, r, "pressure_Pa"), 5e-9);
                assert_near(value[r + 1], 1 / table_number(t % 3 ? &bands : &contact, r, column), 5e-9);
                assert_true(pressure[r + 1] > pressure[r]);
            }
        }
        text = workspace_read(place, filled("o/export/_STEP_____~2.%s", formats[f].file));
        expect_part(text, "surface: _STEP ____\n"); /* nothing that any program would compute */
        assert_true(workspace_has(place, filled("o/export/_rf~3.%s", formats[f].file))); /* no option's name */
    }
    assert_int_equal(workspace_count(place, "-"), 0);
    struct table surfaces = workspace_table(place, "o/data/surfaces.csv");
    char *text = workspace_read(place, "o/export/plain.comsol.txt");
    expect_parts(text, "[m] rms height", " mean absolute slope", "[Pa] hardness", "mean absolute slope");
    assert_near(strtod(strstr(text, "\n% m ") + 5, NULL), sqrt(2 * table_number(&surfaces, 0, "m2") / acos(-1)), 0.1);
    expect_in_file(place, "o/manifest.txt", "\nexport/plain.ansys.mac\n");
    expect_in_file(place, "o/report.md", "For other programs", "export/plain.ansys.mac,", "export/plain.moose.csv");
}

/* Air conducts heat where nothing touches; a film adds to the electrical resistance only. */
TEST_IN_WORKSPACE(what_is_in_the_joint_is_in_the_tables)
{
    static const char head[] = "| TCC, with gaps (W/(mm";
    make_scene(place, POINTS,
               "gap: {gas: air, pressure: 1 atm, temperature: 300 K}\nfilm: 1e-12 ohm m2\nexport: moose\n");
    report_scene(place, "o", NULL);
    struct table contact = workspace_table(place, "o/data/contact.csv"),
                 bands = workspace_table(place, "o/data/bands.csv");
    char *text = workspace_read(place, "o/export/plain.moose.csv");
    double pressure[ROWS], value[ROWS];
    expect_parts(text, "Thermal: spots and what fills the gaps. Electrical: spots with film and plating. "
                       "At no pressure what fills the gaps conducts alone.\n");
    for (int t = 0; t < 3; t++) {
        static const char *const ends[] = {"gap_W_per_m2K", "gap_W_per_m2K_mean_low_95", "gap_W_per_m2K_mean_high_95"};
        assert_int_equal(read_table(pressure, value, text, &formats[4].table[t]), POINTS + 1);
        assert_true(pressure[0] == 0);
        assert_near(value[0], table_number(t ? &bands : &contact, 0, ends[t]), 5e-9);
        assert_true(value[0] > 0 && value[0] < value[1]);
    }
    read_table(pressure, value, text, &formats[4].table[0]);
    assert_near(value[4], table_number(&contact, 3, "joint_W_per_m2K"), 5e-9);
    read_table(pressure, value, text, &formats[4].table[3]);
    assert_near(value[4], 1 / table_number(&contact, 3, "joint_ecr_ohm_m2"), 5e-9);
    assert_true(value[0] == 0);
    expect_in_file(place, "o/report.md", head);
    make_scene(place, POINTS, "");
    report_scene(place, "o", NULL);
    expect_not_in_file(place, "o/report.md", head);
    expect_in_file(place, "o/report.md", "| TCC (W/(mm");
}

/* In millimetres: pressures in MPa, conductances in mW/(mm2 K) and S/mm2. */
TEST_IN_WORKSPACE(decks_in_millimetres)
{
    static const double of_SI[] = {1e-3, 1e-6};
    make_scene(place, POINTS, "");
    run_to_exit(place, 0, "report", "d", "--no-cost", "-o", "o", "--export", "calculix:mm, abaqus:mm,calculix,moose");
    struct table contact = workspace_table(place, "o/data/contact.csv");
    assert_true(workspace_has(place, "o/export/plain.calculix.inp") &&
                workspace_has(place, "o/export/plain.moose.csv"));
    assert_false(workspace_has(place, "o/export/plain.abaqus.inp"));
    assert_false(workspace_has(place, "o/export/plain.moose-mm.csv"));
    expect_in_file(place, "o/report.md", "export/plain.calculix-mm.inp");
    for (int f = 0; f < 2; f++) {
        double pressure[ROWS], value[ROWS];
        char *text = workspace_read(place, filled("o/export/plain.%s-mm.inp", f ? "abaqus" : "calculix"));
        expect_parts(text, "Units: N, mm, s, mJ, K.\n", "it holds from 0.1 MPa to ", "[mW/(mm2 K)]", "[S/mm2]",
                     "[MPa]");
        for (int way = 0; way < 2; way++) {
            assert_int_equal(read_table(pressure, value, text, &formats[f].table[3 * way]), POINTS + 1);
            assert_near(pressure[3], 1e-6 * table_number(&contact, 2, "pressure_Pa"), 5e-9);
            assert_near(value[3], of_SI[way] / table_number(&contact, 2, way ? "ecr_ohm_m2" : "tcr_K_m2_per_W"), 5e-9);
        }
    }
    expect_failure(place, 2, 1, "--export: unknown program 'moose:cm'; there are abaqus, ", "report", "d", "--export",
                   "moose:cm");
    expect_failure(place, 2, 1, "moose; :mm behind one gives N, mm, s", "report", "d", "--export", "fluent:mm");
}

/* CalculiX takes twenty rows of a thousand: pressure 0, both ends, and others spaced evenly between. */
TEST_IN_WORKSPACE(calculix_takes_twenty_rows)
{
    make_scene(place, 1000, "export: calculix\n");
    report_scene(place, "o", NULL);
    struct table contact = workspace_table(place, "o/data/contact.csv");
    double p[ROWS], h[ROWS];
    char *text = workspace_read(place, "o/export/plain.calculix.inp");
    for (int t = 0; t < TABLES; t++)
        assert_int_equal(read_table(p, h, text, &formats[0].table[t]), ROWS);
    read_table(p, h, text, &formats[0].table[0]);
    assert_true(p[0] == 0 && h[0] == 0);
    assert_near(h[1], 1 / table_number(&contact, 0, "tcr_K_m2_per_W"), 5e-9);
    assert_near(h[ROWS - 1], 1 / table_number(&contact, 999, "tcr_K_m2_per_W"), 5e-9);
    for (int r = 2; r < ROWS; r++)
        assert_near(log(p[r] / p[r - 1]), log(1000) / (ROWS - 2), 0.03);
}

TEST_IN_WORKSPACE(only_what_is_asked_for)
{
    make_scene(place, POINTS, "");
    run_to_exit(place, 0, "report", "d", "--no-cost", "-o", "o", "--export", "moose");
    assert_true(workspace_has(place, "o/export/plain.moose.csv"));
    assert_false(workspace_has(place, "o/export/plain.ansys.mac"));
    workspace_write(place, "o/export/mine.txt", "mine\n");
    report_scene(place, "o", NULL);
    assert_false(workspace_has(place, "o/export/plain.moose.csv"));
    expect_in_file(place, "o/export/mine.txt", "mine\n");
    expect_not_in_file(place, "o/view.json", "\"exports\"");
    report_scene(place, "none", NULL);
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

/* Blocks of 20 mm at 100 W/(m K) and 30 mm at 30 W/(m K), pressed together, in the units of a deck: with a, 2a, 5a for
 * 10, 20 and 50 mm. */
#define DECK(a, b, c, modulus, stiffness, least, table, load)                                                          \
    "*NODE, NSET=ALL\n1,0,0,0\n2," a ",0,0\n3," a "," a ",0\n4,0," a ",0\n5,0,0," b "\n6," a ",0," b "\n7," a "," a    \
    "," b "\n8,0," a "," b "\n11,0,0," b "\n12," a ",0," b "\n13," a "," a "," b "\n14,0," a "," b "\n15,0,0," c       \
    "\n16," a ",0," c "\n17," a "," a "," c "\n18,0," a "," c "\n"                                                     \
    "*ELEMENT, TYPE=C3D8, ELSET=LOWER\n1,1,2,3,4,5,6,7,8\n"                                                            \
    "*ELEMENT, TYPE=C3D8, ELSET=UPPER\n2,11,12,13,14,15,16,17,18\n"                                                    \
    "*MATERIAL, NAME=ONE\n*ELASTIC\n" modulus ",0\n*CONDUCTIVITY\n100.\n"                                              \
    "*MATERIAL, NAME=TWO\n*ELASTIC\n" modulus ",0\n*CONDUCTIVITY\n30.\n"                                               \
    "*SOLID SECTION, ELSET=LOWER, MATERIAL=ONE\n*SOLID SECTION, ELSET=UPPER, MATERIAL=TWO\n"                           \
    "*SURFACE, NAME=SLAVE\n2,S1\n*SURFACE, NAME=MASTER\n1,S2\n"                                                        \
    "*SURFACE INTERACTION, NAME=JOINT\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n" stiffness "," least           \
    "\n*INCLUDE, INPUT=o/export/" table ".inp\n"                                                                       \
    "*CONTACT PAIR, INTERACTION=JOINT, TYPE=SURFACE TO SURFACE\nSLAVE,MASTER\n"                                        \
    "*INITIAL CONDITIONS, TYPE=TEMPERATURE\nALL,300.\n"                                                                \
    "*STEP, NLGEOM\n*COUPLED TEMPERATURE-DISPLACEMENT, STEADY STATE\n1.,1.\n"                                          \
    "*BOUNDARY\n1,1,3\n2,1,3\n3,1,3\n4,1,3\nALL,1,2\n1,11,11,400.\n2,11,11,400.\n3,11,11,400.\n4,11,11,400.\n"         \
    "15,11,11,300.\n16,11,11,300.\n17,11,11,300.\n18,11,11,300.\n"                                                     \
    "*DLOAD\n2,P2," load "\n*EL PRINT, ELSET=UPPER\nHFL\n*END STEP\n"
static const struct {
    const char *job;
    double pressure_Pa, flux; /* of a W/m2 in the deck's units */
} decks[] = {
    {DECK(".01", ".02", ".05", "1e11", "1e14", "1e3", "plain.calculix", "5.5e5"), 5.5e5, 1}, /* between two rows */
    {DECK(".01", ".02", ".05", "1e11", "1e14", "1e3", "plain.calculix", "5e4"), 5e4, 1}, /* below the lightest load */
    {DECK("10.", "20.", "50.", "1e5", "1e5", "1e-3", "plain.calculix-mm", ".55"), 5.5e5, 1e-3},
};

TEST_IN_WORKSPACE(calculix_conducts_with_it)
{
    if (!workspace_can_run(place, "command -v ccx >/dev/null")) {
        print_message("[  SKIPPED ] no ccx (Debian: calculix-ccx)\n");
        skip();
    }
    make_scene(place, 1000, "");
    run_to_exit(place, 0, "report", "d", "--no-cost", "-o", "o", "--export", "calculix,calculix:mm");
    double p[ROWS], h[ROWS];
    char *text = workspace_read(place, "o/export/plain.calculix.inp");
    assert_int_equal(read_table(p, h, text, &formats[0].table[0]), ROWS);
    for (size_t d = 0; d < sizeof decks / sizeof *decks; d++) {
        size_t r = 1;
        while (p[r] < decks[d].pressure_Pa)
            r++;
        double between = h[r - 1] + (h[r] - h[r - 1]) * (decks[d].pressure_Pa - p[r - 1]) / (p[r] - p[r - 1]);
        workspace_write(place, "job.inp", decks[d].job);
        workspace_shell(place, "ccx job");
        double flux = strtod(workspace_shell(place, "awk 'NF == 5 && $1 == 2 {print $5; exit}' job.dat"), NULL);
        assert_near(100 * decks[d].flux / flux, 0.02 / 100 + 1 / between + 0.03 / 30, 1e-6);
        assert_true(1 / between > 1e-5); /* of which the contact is a part that would be missed */
    }
}
