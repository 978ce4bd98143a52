/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is said of very many surfaces: a line a kind, with their number; all of it where no report has it. */
#include "run/messages.h"
#include "support.h"

#include <stdio.h>

enum { SURFACES = 50 };

static struct scene_surface surfaces[SURFACES];
static struct surface_record records[SURFACES];
static char names[SURFACES][32], refusals[SURFACES][200];

static void note_it(size_t i)
{
    note_add(&records[i].summary.notes, NULL, "holds from %g to 20 um", 1.5 + (double)i);
    if (i % 2)
        note_add(&records[i].summary.notes, NULL, "%s", "looks like 'a.csv', too");
}

/* Every surface has a note of one kind, every second one of another besides, every fifth is refused for the same. */
static void make(void)
{
    for (size_t i = 0; i < SURFACES; i++) {
        snprintf(names[i], sizeof names[i], "s%zu", i);
        snprintf(refusals[i], sizeof refusals[i], "s%zu.csv:%zu: 'x%c' is no number", i, i + 3, 'a' + (char)(i % 26));
        surfaces[i] = (struct scene_surface){.name = names[i]};
        bool refused = i % 5 == 4;
        note_list_free(&records[i].summary.notes);
        records[i].summary = (struct surface_summary){.scene = &surfaces[i], .refusal = refused ? refusals[i] : NULL};
        if (!refused)
            note_it(i);
    }
}

static size_t lines_with(const struct text *text, const char *part)
{
    size_t count = 0;
    for (const char *at = text_string(text); (at = strstr(at, part)); at++)
        count++;
    return count;
}

/* Is this said of these surfaces, of which so many are refused? */
static struct text said_of(const struct surface_record *surface, size_t count, bool reported, size_t refused)
{
    const struct scene scene = {.passed_over = NULL};
    struct results results = {.scene = &scene, .surfaces = (struct surface_record *)surface, .surface_count = count};
    struct text text = {0};
    assert_int_equal(messages_add(&text, &results, reported), refused);
    return text;
}

TEST_CASE(all_are_said_without_a_report)
{
    make();
    struct text text = said_of(records, SURFACES, false, 10);
    assert_int_equal(lines_with(&text, "holds from"), 40);
    assert_int_equal(lines_with(&text, "looks like"), 20);
    assert_int_equal(lines_with(&text, " refused: "), 10);
    assert_int_equal(lines_with(&text, " more: "), 0);
    text_free(&text);
}

TEST_CASE(notes_alike_are_a_line_beside_a_report)
{
    make();
    note_add(&records[0].summary.notes, NULL, "%s", "holds from 7 to 9 um"); /* twice on one surface */
    struct text text = said_of(records, SURFACES, true, 10);
    assert_int_equal(lines_with(&text, "holds from"), 1);
    assert_int_equal(lines_with(&text, "looks like"), 1);
    assert_int_equal(lines_with(&text, " refused: "), 10);
    expect_parts(text_string(&text), "surface 's0' and 39 more: holds from 1.5 to 20 um\n",
                 "surface 's1' and 19 more: looks like 'a.csv', too\n");
    text_free(&text);
}

/* More kinds than are told apart: nothing is held back. */
TEST_CASE(what_is_of_no_kind_is_said)
{
    enum { MANY = 300 };
    struct scene_surface *all = support_room(MANY * sizeof *all);
    struct surface_record *said = support_room(MANY * sizeof *said);
    char(*note)[8] = calloc(MANY, sizeof *note);
    assert_true(all && said && note);
    for (size_t i = 0; i < MANY; i++) {
        snprintf(note[i], sizeof *note, "%c%c%c", (char)('a' + i % 25), (char)('a' + i / 25), 'a');
        all[i].name = note[i];
        said[i].summary = (struct surface_summary){.scene = &all[i]};
        note_add(&said[i].summary.notes, NULL, "%s", note[i]);
    }
    struct text text = said_of(said, MANY, true, 0);
    assert_int_equal(lines_with(&text, "\n"), MANY);
    text_free(&text);
    for (size_t i = 0; i < MANY; i++)
        note_list_free(&said[i].summary.notes);
    free(note);
}

/* A refused surface's notes are in no report: none is left out. */
TEST_CASE(notes_of_the_refused_are_said)
{
    make();
    for (size_t i = 0; i < SURFACES; i++) {
        note_list_free(&records[i].summary.notes);
        note_it(i);
        records[i].summary.refusal = refusals[i];
    }
    struct text text = said_of(records, SURFACES, true, SURFACES);
    assert_int_equal(lines_with(&text, "holds from"), SURFACES);
    assert_int_equal(lines_with(&text, " refused: "), SURFACES); /* each has to be seen to */
    text_free(&text);
}

static int let_go(void **state)
{
    (void)state;
    for (size_t i = 0; i < SURFACES; i++)
        note_list_free(&records[i].summary.notes);
    return 0;
}

TEST_GROUP(NULL, let_go)
