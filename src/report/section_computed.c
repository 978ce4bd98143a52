/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What was computed: effects with their work, settings, inputs, notes and refusals. */
#include "report/section.h"

#include "base/version.h"
#include <stdio.h>
#include <string.h>

static void work_rows(struct text *out, const struct section_context *context)
{
    struct effects_row rows[EFFECTS_ROWS];
    const struct results *results = context->results;
    effects_account(rows, results->plan, results->surfaces, results->surface_count, &results->studies);
    text_add(out, "| effect | | why | how | evaluations |\n|---|---|---|---|---:|\n");
    for (int r = 0; r < EFFECTS_ROWS; r++) {
        text_add(out, "| %s | %s | ", rows[r].name, rows[r].runs ? "run" : "skipped");
        text_add_markdown(out, rows[r].reason); /* may name a surface */
        text_add(out, " | %s | ", rows[r].method);
        text_add(out, rows[r].evaluations > 0 ? "%llu |\n" : "– |\n", (unsigned long long)rows[r].evaluations);
    }
}

static void settings_text(struct text *out, const struct section_context *context)
{
    const struct scene *scene = context->results->scene;
    section_given(out, "Tolerance ", scene->tolerance, " (relative)");
    if (plan_stacks_scales(context->results->plan))
        text_add(out, ", sinusoid closure `%s`: %s", sinusoid_fits[scene->closure].name,
                 sinusoid_fits[scene->closure].source);
    text_add(out, ".");
    if (scene_bins_spectra(scene))
        text_add(out,
                 " `data/spectrum.csv` holds bins of a tenth of a decade, as of more than %d surfaces, and the points "
                 "of the curves stand in `data/contact.csv` alone; with `data: full` every harmonic, and "
                 "`results.json` has the curves too.",
                 SCENE_DATA_SURFACES);
}

static void surface_inputs(struct text *out, const struct section_context *context, size_t index)
{
    const struct surface_summary *s = section_surface(context, index);
    text_add(out, " | ");
    for (size_t f = 0; f < s->scene->file_count; f++) {
        text_add(out, "%s", f > 0 ? ", " : "");
        text_add_markdown(out, s->scene->files[f]);
    }
    text_add(out, " | %s | ", s->format);
    text_add_markdown(out, s->units);
    text_add(out, " | `%.16s…`", s->hash);
}

/** One line of the lists of notes and refusals. */
static void list_item(struct text *out, const struct section_context *context, size_t index, const char *line)
{
    text_add(out, "- ");
    section_surface_name(out, context->results, index);
    text_add(out, ": ");
    text_add_markdown(out, line);
    text_add(out, "\n");
}

static void notes(struct text *out, const struct section_context *context)
{
    size_t items = 0;
    for (size_t i = 0; i < context->results->surface_count; i++)
        for (size_t n = 0; n < section_surface(context, i)->notes.count; n++) {
            struct text line = {0};
            note_line(&line, &section_surface(context, i)->notes.notes[n]);
            if (items++ < SECTION_ROWS)
                list_item(out, context, i, text_string(&line));
            text_free(&line);
        }
    if (items > SECTION_ROWS)
        text_add(out, "- … %zu more in results.json\n", items - SECTION_ROWS);
}

static void refused(struct text *out, const struct section_context *context)
{
    size_t items = 0;
    for (size_t i = 0; i < context->results->surface_count; i++)
        if (section_surface(context, i)->refusal && items++ < SECTION_ROWS)
            list_item(out, context, i, section_surface(context, i)->refusal);
    if (items > SECTION_ROWS)
        text_add(out, "- … %zu more in results.json\n", items - SECTION_ROWS);
}

/** Files of the directory that are no scans. */
static void passed_over(struct text *out, const struct scene *scene)
{
    for (const char *line = scene->passed_over; line && *line;) {
        struct text one = {0};
        size_t length = strcspn(line, "\n");
        text_add_bytes(&one, line, length);
        text_add(out, "- ");
        text_add_markdown(out, text_string(&one));
        text_add(out, "\n");
        text_free(&one);
        line += length + (line[length] == '\n');
    }
}

static void write(struct text *out, const struct section_context *context)
{
    struct text list = {0};
    text_add(out, "## What was computed\n\n");
    work_rows(out, context);
    text_add(out, "\n");
    settings_text(out, context);
    text_add(out, "\n\n| surface | files | format | units | SHA-256 |\n|---|---|---|---|---|\n");
    section_each_surface(out, context, surface_inputs);
    notes(&list, context);
    if (list.length > 0)
        text_add(out, "\n**Notes on the scans.**\n\n%s", text_string(&list));
    list.length = 0;
    refused(&list, context);
    if (list.length > 0)
        text_add(out, "\n**Refused.**\n\n%s", text_string(&list));
    list.length = 0;
    passed_over(&list, context->results->scene);
    if (list.length > 0)
        text_add(out, "\n**Passed over.**\n\n%s", text_string(&list));
    text_free(&list);
}

const struct section section_computed = {"computed", NULL, write};
