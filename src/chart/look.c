/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "chart/look.h"

#include "contact/model.h"
#include <ctype.h>
#include <stdio.h>
#include <string.h>

/* Surfaces: Okabe and Ito's hues with their lightness moved until each stands out from white, and any two still differ
 * for deuteranopes and protanopes. page.html has lighter ones of the dark among these colours for a dark page. Sweeps:
 * one ramp from dark violet to light gold, so that the order of the values is that of the lightness. Methods: the
 * surfaces' colours, each with a marker. Models: their rows give each its colour and marker, light and open for elastic
 * contact, dark and filled for plastic. Dashes are not free for this: they mean outside the range of validity. */
static const struct {
    const char *name, *colour;
    int marker;
} looks[] = {
    {"s1", "#1257D0", -1},   {"s2", "#CC5500", -1},  {"s3", "#1FB380", -1},  {"s4", "#A8366A", -1},
    {"s5", "#EE9400", -1},   {"s6", "#4FA6F0", -1},  {"s7", "#85858F", -1},  {"s8", "#734CA4", -1},
    {"r1", "#431575", -1},   {"r2", "#2B338F", -1},  {"r3", "#025185", -1},  {"r4", "#04657A", -1},
    {"r5", "#017775", -1},   {"r6", "#058A64", -1},  {"r7", "#4F9737", -1},  {"r8", "#939803", -1},
    {"r9", "#C79608", -1},   {"c1", "#1257D0", 7},   {"c2", "#CC5500", 5},   {"c3", "#1FB380", 9},
    {"c4", "#A8366A", 13},   {"c5", "#EE9400", 11},  {"c6", "#4FA6F0", 6},   {"c7", "#85858F", 4},
    {"c8", "#734CA4", 8},    {"c9", "#8A6D1B", 12},  {"meas", LOOK_INK, 2},  {"dirl", LOOK_INK, 7},
    {"diro", LOOK_QUIET, 6}, {"dirp", "#C2185B", 5}, {"cf", LOOK_QUIET, -1},
};

static void find(struct look *look)
{
    for (size_t i = 0; i < sizeof looks / sizeof *looks; i++)
        if (strcmp(look->base, looks[i].name) == 0) {
            look->colour = looks[i].colour;
            look->marker = looks[i].marker;
        }
    for (size_t m = 0; m < model_count; m++)
        if (strcmp(look->base, model_rows[m]->style) == 0) {
            look->colour = model_rows[m]->colour;
            look->marker = model_rows[m]->marker;
        }
}

struct look look_of(const char *style)
{
    struct look look = {.marker = -1};
    size_t length = strlen(style);
    const char *h = length > 4 ? style + length - 3 : "";
    look.hidden = *h == 'h' && isdigit((unsigned char)h[1]) && isdigit((unsigned char)h[2]);
    if (look.hidden) {
        look.covers = (unsigned)(h[1] - '0');
        look.together = (unsigned)(h[2] - '0');
        length -= 3;
    } else if (length > 2 && style[length - 1] == 'x' && strcmp(style, "binx") != 0 && strcmp(style, "fitx") != 0) {
        look.outside = true;
        length--;
    } else if (length > 2 && style[length - 1] == 'b') {
        look.band = true;
        length--;
    }
    snprintf(look.stem, sizeof look.stem, "%.*s", (int)length, style);
    look.adjusted = length == 3 && style[2] == 'a';
    look.scaled = length == 3 && style[2] == 'S';
    snprintf(look.base, sizeof look.base, "%.*s", look.adjusted || look.scaled ? 2 : (int)length, style);
    find(&look);
    return look;
}

int look_single(const struct look *look)
{
    static const int of_surfaces[] = {7, 5, 9, 13, 11, 6, 4, 8};
    if (look->marker > 0)
        return look->marker;
    return look->base[0] == 's' ? of_surfaces[(look->base[1] - '1') & 7] : 7;
}

bool look_in_bars(const struct look *look)
{
    return look->outside || look->band || look->hidden
               ? false
               : strcmp(look->base, "meas") == 0 || strncmp(look->base, "dir", 3) == 0;
}
