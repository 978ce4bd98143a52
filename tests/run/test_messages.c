/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Messages on very many surfaces: one line for each kind, with their number; all lines if there is no report. */
#include "run/messages.h"
#include "support.h"

#include <stdio.h>

enum { SURFACES = 50 };

static struct scene_surface surfaces[SURFACES];
static struct surface_record records[SURFACES];
static char names[SURFACES][32], refusals[SURFACES][200];

static void note_it(size_t i)
{
    note_add(&records[i].summary.notes, NULL, "note.narrow\nfrom %g\nto 20", 1.5 + (double)i);
    if (i % 2)
        note_add(&records[i].summary.notes, NULL, "note.text\ntext\tlooks like 'a.csv', too");
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

/* The messages on these surfaces, of which `refused` must be refused. */
static const char *said_of(const struct surface_record *surface, size_t count, bool reported, size_t refused)
{
    const struct scene scene = {.passed_over = NULL};
    const struct plan plan = {.words = support_words()};
    struct results results = {
        .scene = &scene, .plan = &plan, .surfaces = (struct surface_record *)surface, .surface_count = count};
    struct text *text = support_text();
    assert_int_equal(messages_add(text, &(size_t){0}, &results, reported), refused);
    return text_string(text);
}

TEST_CASE(all_are_said_without_a_report)
{
    make();
    const char *text = said_of(records, SURFACES, false, 10);
    assert_int_equal(times(text, "holds from"), 40);
    assert_int_equal(times(text, "looks like"), 20);
    assert_int_equal(times(text, " refused: "), 10);
    assert_int_equal(times(text, "such a note"), 0);
}

TEST_CASE(notes_alike_are_a_line_beside_a_report)
{
    make();
    note_add(&records[0].summary.notes, NULL, "note.narrow\nfrom 7\nto 9"); /* twice on one surface */
    const char *text = said_of(records, SURFACES, true, 10);
    assert_int_equal(times(text, "holds from"), 1);
    assert_int_equal(times(text, "looks like"), 1);
    assert_int_equal(times(text, " refused: "), 10);
    expect_parts(
        text,
        "surface 's0': the power law is narrow: it holds from 1.5 to 20 um only, under a decade (and such a note on 39 "
        "more)\n",
        "surface 's1': looks like 'a.csv', too (and such a note on 19 more)\n");
}

/* Notes on different files of a counterface are different kinds; each names its file. */
TEST_CASE(notes_of_the_counterface_name_its_files)
{
    struct note_list other = {0}, *own = &records[0].summary.notes;
    make();
    note_add(&other, "a1.csv", "note.text\ntext\tsteps of 1");
    note_add(&other, "a2.csv", "note.text\ntext\tsteps of 1");
    note_add(&other, "a3.csv", "note.text\ntext\tsteps of 2");
    note_add(&other, "b\n.csv", "note.text\ntext\tsteps of 3");
    note_add_refused(&other, "used 4\nscans 5", "c.csv:1: no scan");
    note_add(own, "a1.csv", "note.text\ntext\tsteps of 1");
    for (size_t n = 0; n < other.count; n++)
        note_add_counterface(own, &other.notes[n]);
    const char *text = said_of(records, 1, true, 0);
    assert_string_equal(text, "surface 's0': the power law is narrow: it holds from 1.5 to 20 um only, under a decade\n"
                              "surface 's0': a1.csv: steps of 1\n"
                              "surface 's0': counterface c.csv:1: no scan - refused; 4 of its 5 scans are used\n"
                              "surface 's0': counterface a1.csv: steps of 1 (and of 1 more scan)\n"
                              "surface 's0': counterface b\\x0a.csv: steps of 3\n");
    note_list_free(own);
    note_list_free(&other);
}

/* With more kinds than are counted, every note gets a line. */
TEST_CASE(what_is_of_no_kind_is_said)
{
    enum { MANY = 300 };
    struct scene_surface *all = support_room(MANY * sizeof *all);
    struct surface_record *said = support_room(MANY * sizeof *said);
    char(*note)[8] = support_room(MANY * sizeof *note);
    for (size_t i = 0; i < MANY; i++) {
        snprintf(note[i], sizeof *note, "%c%c%c", (char)('a' + i % 25), (char)('a' + i / 25), 'a');
        all[i].name = note[i];
        said[i].summary = (struct surface_summary){.scene = &all[i]};
        note_add(&said[i].summary.notes, NULL, "note.text\ntext\t%s", note[i]);
    }
    const char *text = said_of(said, MANY, true, 0);
    assert_int_equal(times(text, "\n"), MANY);
    for (size_t i = 0; i < MANY; i++)
        note_list_free(&said[i].summary.notes);
}

/* Notes of refused surfaces are not in the report, so all of them are shown, for the first ten surfaces. */
TEST_CASE(notes_of_the_refused_are_said)
{
    make();
    for (size_t i = 0; i < SURFACES; i++) {
        note_list_free(&records[i].summary.notes);
        note_it(i);
        records[i].summary.refusal = refusals[i];
    }
    const char *text = said_of(records, SURFACES, true, SURFACES);
    assert_int_equal(times(text, "holds from"), 10);
    assert_int_equal(times(text, " refused: "), 10);
    assert_int_equal(times(text, "more refused"), 1);
    text = said_of(records, 10, true, 10);
    assert_int_equal(times(text, " refused: "), 10);
    assert_int_equal(times(text, "more refused"), 0);
}

static int let_go(void **state)
{
    (void)state;
    for (size_t i = 0; i < SURFACES; i++)
        note_list_free(&records[i].summary.notes);
    return 0;
}

TEST_GROUP(NULL, let_go)
