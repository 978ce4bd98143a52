/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What all sections write with: names of surfaces. */
#include "report/section.h"
#include "support.h"

TEST_CASE(test_surface_names_are_harmless)
{
    static char name[] = "| <script>*x*\n";
    struct scene_surface surface = {.name = name};
    struct surface_record record = {.summary.scene = &surface};
    struct results results = {.surfaces = &record, .surface_count = 1};
    struct text text = {0};
    section_surface_name(&text, &results, 0);
    assert_string_equal(text_string(&text), "\\| &#60;script&#62;\\*x\\*\\\\x0a");
    text_free(&text);
}

/* A name that begins with the word goes without it. */
TEST_CASE(test_surfaces_are_named_once)
{
    static char names[2][16] = {"2", "Surface-2"};
    struct scene_surface surfaces[2] = {{.name = names[0]}, {.name = names[1]}};
    struct surface_record records[2] = {{.summary.scene = &surfaces[0]}, {.summary.scene = &surfaces[1]}};
    struct results results = {.surfaces = records, .surface_count = 2};
    struct text text = {0};
    section_named(&text, "surface ", &results, 0);
    section_named(&text, ", surface ", &results, 0);
    text_add(&text, " and ");
    section_named(&text, "surface ", &results, 1);
    assert_string_equal(text_string(&text), "surface 2, surface 2 and Surface-2");
    text_free(&text);
}
