/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The picture of a map has files with names that are safe, whatever the surface is called. */
#include "chart/figures.h"
#include "directory.h"

TEST_CASE(names_of_files)
{
    static const char *const names[][2] = {
        {"lapped-1", "map-lapped-1"},
        {"../a b'\n$(x).svg", "map----a-b----x--svg"},
        {"\xc3\xa4", "map---"},
        {"", "map-"},
        {"a234567890123456789012345678901234567890", "map-a23456789012345678901234567"}};
    char out[32];
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        figures_map_name(out, sizeof out, names[i][0]);
        assert_string_equal(out, names[i][1]);
    }
}
