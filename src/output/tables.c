/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/tables.h"

#include "answers/direct_study.h"
#include "base/number_format.h"
#include "certainty/sensitivity.h"
#include "results/comparison.h"
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define SURFACE(...) RECORD_FIELD(struct surface_summary, __VA_ARGS__)
#define SHOWN(...)   RECORD_SHOWN(struct surface_summary, __VA_ARGS__)
const struct record_field surface_fields[] = {
    SURFACE(COUNT, "points", points, ALWAYS),
    SURFACE(NUMBER, "spacing_m", spacing_m, ALWAYS),
    SURFACE(NUMBER, "scan_length_m", length_m, ALWAYS),
    SHOWN(NUMBER, "rq_m", roughness.rq_m, ALWAYS, 3, "um"),
    SHOWN(NUMBER, "ra_m", roughness.ra_m, ALWAYS, 3, "um"),
    SURFACE(NUMBER, "pv_m", roughness.pv_m, JSON),
    SURFACE(NUMBER, "m0_m2", roughness.m0_m2, ALWAYS),
    SURFACE(NUMBER, "m2", roughness.m2, ALWAYS),
    SURFACE(NUMBER, "m4_per_m2", roughness.m4_per_m2, ALWAYS),
    SHOWN(NUMBER, "sq_m", measured.sq_m, JSON | RECORD_MAPS, 3, "um"),
    SURFACE(NUMBER, "sa_m", measured.sa_m, JSON | RECORD_MAPS),
    SURFACE(NUMBER, "sz_m", measured.sz_m, JSON | RECORD_MAPS),
    SURFACE(NUMBER, "ssk", measured.ssk, JSON | RECORD_MAPS),
    SURFACE(NUMBER, "sku", measured.sku, JSON | RECORD_MAPS),
    SURFACE(NUMBER, "sdq", measured.sdq, JSON | RECORD_MAPS),
    SURFACE(NUMBER, "sigma_m", rough.sigma_m, JSON),
    SURFACE(NUMBER, "mean_slope", rough.slope, JSON),
    SURFACE(NUMBER, "nayak", asperities.nayak, ALWAYS),
    SURFACE(NUMBER, "asperity_density_per_m2", asperities.density_per_m2, JSON | RECORD_ASPERITIES),
    SURFACE(NUMBER, "asperity_radius_m", asperities.radius_m, JSON | RECORD_ASPERITIES),
    SURFACE(NUMBER, "asperity_sigma_m", asperities.sigma_s_m, JSON | RECORD_ASPERITIES),
    SURFACE(NUMBER, "asperity_offset_m", asperities.offset_m, JSON | RECORD_ASPERITIES),
    SURFACE(NUMBER, "alpha_SI", power_law.alpha, ALWAYS),
    SURFACE(NUMBER, "gamma", power_law.gamma, ALWAYS),
    SURFACE(NUMBER, "gamma_stderr", power_law.gamma_error, ALWAYS),
    SURFACE(NUMBER, "fit_amplitude_m", power_law.amplitude_m, ALWAYS),
    SURFACE(NUMBER, "fit_amplitude_stderr_decades", power_law.amplitude_error_decades, ALWAYS),
    SURFACE(NUMBER, "fit_wavelength_m", power_law.wavelength_m, ALWAYS),
    SURFACE(NUMBER, "fit_low_m", power_law.band_m[0], ALWAYS),
    SURFACE(NUMBER, "fit_high_m", power_law.band_m[1], ALWAYS),
    SURFACE(NUMBER, "fit_misfit_decades", power_law.misfit_decades, ALWAYS),
    SURFACE(NUMBER, "line_alpha_SI", line.alpha, ALWAYS),
    SURFACE(NUMBER, "line_gamma", line.gamma, ALWAYS),
    SURFACE(NUMBER, "line_rms_decades", line.misfit_decades, ALWAYS),
    SURFACE(NUMBER, "fit_psd_m3", power_law.psd_m3, JSON),
    {0},
};

#define REPEATS(...) RECORD_FIELD(struct repeats, __VA_ARGS__)
const struct record_field repeats_fields[] = {
    REPEATS(COUNT, "scans_run_alone", count, JSON), REPEATS(COUNT, "files", scans, JSON),
    REPEATS(ESTIMATE, "rq_m", rq_m, JSON),          REPEATS(ESTIMATE, "gamma", gamma, JSON),
    REPEATS(ESTIMATE, "fit_psd_m3", psd_m3, JSON),  {0}};

enum {
    SWEEP_ROWS = 200,
    HELD_BYTES = 1 << 20 /* of rows before they are written; those of an ordinary surface wait for nobody then */
};

/** A file being written, which is opened with its first rows; or what one surface adds to it, whose rows are written in
 * the surfaces' order. */
struct table {
    const char *directory, *name;
    FILE *file;
    int problem;               /* errno of what failed; 0: nothing did */
    struct text header;        /* the columns' names, as the first row goes over them */
    bool named;                /* it has */
    size_t cells;              /* of the row begun */
    struct text rows;          /* not written yet */
    struct table *whole;       /* of a part: the table that other threads write too; NULL: this is it */
    struct threads_turn *turn; /* of a part; NULL: no other thread writes */
    json_t *objects;           /* records go there instead; NULL: rows are written */
};

/** Opens the file and writes the columns' names. */
static void open_table(struct table *table, const struct text *header)
{
    OWNED(text_free) struct text path = {0};
    text_add(&path, "%s/data/%s", table->directory, table->name);
    table->file = fopen(text_string(&path), "w");
    if (table->file)
        fwrite(text_string(header), 1, header->length, table->file);
    else
        table->problem = errno;
}

/** Writes the rows held when it is their turn; in a run that has failed they are dropped. */
static void write_rows(struct table *table)
{
    struct table *whole = table->whole ? table->whole : table;
    if (threads_wait(table->turn)) {
        if (table->rows.length > 0 && !whole->file && !whole->problem)
            open_table(whole, &table->header);
        if (table->rows.length > 0 && whole->file &&
            fwrite(text_string(&table->rows), 1, table->rows.length, whole->file) < table->rows.length)
            whole->problem = errno;
        table->problem = whole->problem;
    }
    table->rows.length = 0;
}

/** Ends a row of cells. */
static void end_row(struct table *table)
{
    if (!table->named)
        text_add_bytes(&table->header, "\n", 1);
    table->named = true;
    table->cells = 0;
    text_add_bytes(&table->rows, "\n", 1);
    if (table->rows.length >= HELD_BYTES)
        write_rows(table);
}

/* Each of these adds a cell, in the column of that name. */

static void begin_cell(struct table *table, const char *name, const char *end)
{
    const char *before = table->cells++ > 0 ? "," : "";
    if (!table->named)
        text_add(&table->header, "%s%s%s", before, name, end);
    text_add_bytes(&table->rows, before, strlen(before));
}

/** A number (%.17g, SI), nothing where it is not finite; the column's name has two parts. */
static void put(struct table *table, const char *name, const char *end, double value)
{
    begin_cell(table, name, end);
    if (isfinite(value))
        number_digits(&table->rows, value, 17);
}

static void put_number(struct table *table, const char *name, double value)
{
    put(table, name, "", value);
}

static void put_count(struct table *table, const char *name, size_t count)
{
    begin_cell(table, name, "");
    text_add(&table->rows, "%zu", count);
}

/** Text that may hold anything. */
static void put_text(struct table *table, const char *name, const char *text)
{
    begin_cell(table, name, "");
    text_add_csv(&table->rows, text);
}

/** Begins a row of a model on a surface. */
static void put_whose(struct table *table, const struct surface_summary *surface, size_t model)
{
    put_text(table, "surface", surface->scene->name);
    put_text(table, "model", model_rows[model]->name);
}

/** Cells of a record: the fields that are always in tables, and those under the conditions `when`. */
static void put_fields(struct table *table, const struct record_field *fields, const void *of, unsigned when)
{
    for (const struct record_field *field = fields; field->key; field++) {
        const void *at = (const char *)of + field->offset;
        if (!(field->when & (when | RECORD_CSV)))
            continue;
        if (field->kind == RECORD_NUMBER)
            put_number(table, field->key, *(const double *)at);
        else if (field->kind == RECORD_COUNT)
            put_count(table, field->key, *(const size_t *)at);
        else
            put_text(table, field->key, *(const char *const *)at);
    }
}

/** Writes what is held; of a surface's part the file stays open. */
static enum status_code table_close(struct table *table, struct status *status)
{
    write_rows(table);
    text_free(&table->header);
    text_free(&table->rows);
    if (!table->whole && table->file && fclose(table->file) != 0)
        table->problem = errno;
    if (table->problem && status->code == STATUS_OK)
        return status_fail(status, STATUS_IO, "cannot write '%s': %s", table->name, status_reason(table->problem));
    return status->code;
}

unsigned tables_surface_when(const struct results *results)
{
    unsigned when = plan_uses_asperities(results->plan) ? RECORD_ASPERITIES : 0;
    for (size_t i = 0; i < results->surface_count; i++)
        when |= results->surfaces[i].summary.has_map ? RECORD_MAPS : 0;
    return when;
}

static void fill_surface(struct table *table, const struct results *results, size_t index)
{
    const struct plan *plan = results->plan;
    const struct surface_summary *s = &results->surfaces[index].summary;
    OWNED(text_free) struct text files = {0};
    if (!s->usable)
        return;
    for (size_t f = 0; f < s->scene->files.count; f++)
        text_add(&files, "%s%s", f > 0 ? ";" : "", s->scene->files.path[f]);
    put_text(table, "surface", s->scene->name);
    put_text(table, "files", text_string(&files));
    put_fields(table, surface_fields, s, tables_surface_when(results));
    put_number(table, "heights_factor_ecr", comparison_heights_factor(results, index));
    for (size_t m = 0; m < model_count; m++)
        if (plan_runs_model(plan, m) && (model_rows[m]->quantities & QUANTITY_BIT(QUANTITY_ADJUSTED)))
            put(table, "beta_", model_rows[m]->name, surface_model(s, m)->exists ? surface_model(s, m)->beta : NAN);
    end_row(table);
}

/** A row a harmonic, or a bin of them, of harmonics `first` to before `end`. */
static void put_spectrum(struct table *table, const struct surface_record *record, bool binned)
{
    const struct spectrum *spectrum = &record->spectrum;
    struct text name = {0}; /* worded once: half of the time of 200 000 rows otherwise */
    text_add_csv(&name, record->summary.scene->name);
    for (size_t i = 0; i < spectrum->count;) {
        const struct spectrum_bin bin = binned ? spectrum_bin_from(spectrum, i) : spectrum_bin_of(spectrum, i);
        begin_cell(table, "surface", "");
        text_add_bytes(&table->rows, text_string(&name), name.length);
        double wavelength_m = bin.wavelength_m * surface_kappa(&record->summary); /* as the scans have it */
        put_number(table, "wavelength_m", wavelength_m);
        put_number(table, "amplitude_m", bin.amplitude_m);
        put_number(table, "fit_m", power_law_amplitude(&record->summary.power_law, wavelength_m));
        if (binned)
            put_count(table, "harmonics", bin.count);
        end_row(table);
        i += bin.count;
    }
    text_free(&name);
}

enum { SPECTRUM, CONTACT, BANDS, CURVE_TABLES };

struct curve_tables {
    const struct results *results;
    struct table table[CURVE_TABLES];
    unsigned quantities, band_quantities; /* QUANTITY_BITs that contact and bands have columns of */
};

static void put_contact(struct table *table, const struct surface_record *record, unsigned quantities)
{
    double sigma_m = record->summary.asperities.sigma_m;
    for (size_t m = 0; m < model_count; m++)
        for (size_t i = 0; i < record->curves[m].count; i++) {
            const struct contact_point *point = &record->curves[m].points[i];
            put_whose(table, &record->summary, m);
            for (enum quantity q = 0; q < QUANTITY_COUNT; q++) {
                const struct quantity_row *row = &quantity_rows[q];
                if (!(quantities & QUANTITY_BIT(q)))
                    continue;
                const double value = point->value[q];
                if (!(row->is & QUANTITY_SIGMA_ALONE))
                    put_number(table, row->name, value);
                if (q == QUANTITY_LOAD)
                    put_number(table, "pressure_Pa", material_pair_pressure(&record->summary.pair, value));
                if (row->sigma_column)
                    put_number(table, row->sigma_column, value / sigma_m);
            }
            end_row(table);
        }
}

static void put_bands(struct table *table, const struct surface_record *record, unsigned quantities)
{
    static const char *const ends[] = {"_mean_low_95", "_mean_high_95", "_next_scan_low_95", "_next_scan_high_95"};
    for (size_t m = 0; m < model_count; m++)
        for (size_t i = 0; record->bands && record->bands[m] && i < record->band_count; i++) {
            const struct ensemble_band *band = &record->bands[m][i];
            put_whose(table, &record->summary, m);
            put_number(table, quantity_rows[QUANTITY_LOAD].name, band->load);
            for (enum quantity q = 0; q < QUANTITY_COUNT; q++)
                for (int end = 0; end < 4 && (quantities & QUANTITY_BIT(q)); end++)
                    put(table, quantity_shown_name(q), ends[end],
                        end < 2 ? band->mean[q][end] : band->next[q][end - 2]);
            end_row(table);
        }
}

enum status_code curve_tables_put(struct curve_tables *all, const struct surface_record *record,
                                  struct threads_turn *turn, struct status *status)
{
    struct table part[CURVE_TABLES]; /* what one surface adds to a table */
    for (int t = 0; t < CURVE_TABLES; t++)
        part[t] = (struct table){.name = all->table[t].name, .whole = &all->table[t], .turn = turn};
    put_spectrum(&part[SPECTRUM], record, scene_bins_spectra(all->results->scene));
    put_contact(&part[CONTACT], record, all->quantities);
    put_bands(&part[BANDS], record, all->band_quantities);
    for (int t = 0; t < CURVE_TABLES; t++)
        (void)table_close(&part[t], status);
    return status->code;
}

enum status_code curve_tables_open(struct curve_tables **out, const struct results *results, const char *directory,
                                   struct status *status)
{
    static const char *const names[] = {"spectrum.csv", "contact.csv", "bands.csv"};
    struct curve_tables *all = *out = calloc(1, sizeof *all);
    if (!all)
        return status_memory(status);
    all->results = results;
    all->quantities = plan_quantities(results->plan);
    for (int t = 0; t < CURVE_TABLES; t++)
        all->table[t] = (struct table){.directory = directory, .name = names[t]};
    for (enum quantity q = 0; q < QUANTITY_COUNT; q++)
        if ((quantity_rows[q].is & QUANTITY_BANDED) && (results->plan->wanted & QUANTITY_BIT(q)))
            all->band_quantities |= QUANTITY_BIT(q);
    return STATUS_OK;
}

enum status_code curve_tables_close(struct curve_tables *all, struct status *status)
{
    for (int t = 0; all && t < CURVE_TABLES; t++)
        (void)table_close(&all->table[t], status);
    free(all);
    return status->code;
}

static enum status_code put_surface(void *context, size_t index, struct threads_turn *turn, struct status *status)
{
    struct curve_tables *all = context;
    const struct surface_record *record = &all->results->surfaces[index];
    return record->summary.usable ? curve_tables_put(all, record, turn, status) : STATUS_OK;
}

/** Of surfaces whose arrays are all in memory. */
static enum status_code write_curves(const struct results *results, const char *directory, struct status *status)
{
    struct curve_tables *all;
    if (curve_tables_open(&all, results, directory, status) == STATUS_OK)
        (void)!threads_run(&results->threads, results->surface_count, put_surface, all, status);
    return curve_tables_close(all, status);
}

static void fill_convergence(struct table *table, const struct results *results, size_t sweep)
{
    const struct scene_convergence *study = &results->scene->convergence;
    size_t index[SWEEP_ROWS], count = results_sweep_scales(index, SWEEP_ROWS, study->scales);
    for (size_t v = 0; v < convergence_sweeps[sweep].count; v++)
        for (size_t m = 0; m < model_count; m++) {
            if (!plan_runs_model(results->plan, m) || !model_rows[m]->stacks_scales)
                continue;
            const double *area = results_sweep(results, (enum convergence_sweep)sweep, m, v);
            for (size_t k = 0; k < count; k++) {
                put_text(table, "sweep", convergence_sweeps[sweep].name);
                put_number(table, "value", convergence_sweeps[sweep].values[v]);
                put_text(table, "model", model_rows[m]->name);
                put_number(table, "wavelength_m", study->scan_length_m / (double)(index[k] + 1));
                put_number(table, "area_ratio", area[index[k]]);
                end_row(table);
            }
        }
}

static void fill_cost(struct table *table, const struct results *results, size_t index)
{
    const struct benchmark_row *row = &results->benchmark->rows[index];
    put_text(table, "study", "tolerance");
    put_text(table, "method", model_rows[row->model]->name);
    begin_cell(table, "setting", "");
    text_add(&table->rows, "%g", row->tolerance);
    put_count(table, "evaluations", row->evaluations);
    put_number(table, "seconds", row->seconds);
    put_number(table, "max_relative_error", row->error);
    end_row(table);
}

const char *tables_estimate_key(int which)
{
    return which == CURVE_FULL_LOAD                    ? "full_contact_load_over_AnEp"
           : which == CURVE_BETA                       ? "beta"
           : quantity_rows[which].is & QUANTITY_BANDED ? quantity_shown_name((enum quantity)which)
                                                       : NULL;
}

static void put_estimate(struct table *table, const char *surface, const char *quantity,
                         const struct estimate *estimate)
{
    const struct record_estimate record = record_estimate(estimate);
    if (estimate->count == 0)
        return;
    put_text(table, "surface", surface);
    put_text(table, "quantity", quantity);
    put_fields(table, record_estimate_fields, &record, 0);
    end_row(table);
}

static void fill_spread(struct table *table, const struct results *results, size_t index)
{
    const struct surface_summary *s = &results->surfaces[index].summary;
    if (!s->usable)
        return;
    for (const struct record_field *field = repeats_fields; field->key && s->repeats.scans > 1; field++)
        if (field->kind == RECORD_ESTIMATE)
            put_estimate(table, s->scene->name, field->key, (const void *)((const char *)&s->repeats + field->offset));
    for (size_t m = 0; m < model_count; m++)
        for (int i = 0; i < CURVE_ESTIMATES; i++) {
            int which = i < 2 ? CURVE_BETA - i : i - 2; /* of the curve first */
            const char *key = tables_estimate_key(which);
            char quantity[80];
            snprintf(quantity, sizeof quantity, "%s%s_%s", key ? key : "",
                     which < QUANTITY_COUNT ? "_at_middle_load" : "", model_rows[m]->name);
            if (key)
                put_estimate(table, s->scene->name, quantity, curve_summary_estimate(surface_model(s, m), which));
        }
}

static void fill_sensitivity(struct table *table, const struct results *results, size_t index)
{
    const struct surface_summary *s = &results->surfaces[index].summary;
    for (size_t m = 0; m < model_count; m++)
        for (int c = 0; c < SENSITIVITY_CHANGES && s->usable && surface_model(s, m)->exists; c++) {
            if (sensitivity_changes[c].plastic && !model_rows[m]->plastic)
                continue;
            put_whose(table, s, m);
            put_text(table, "change", sensitivity_changes[c].name);
            put_number(table, "area_factor", surface_model(s, m)->sensitivity.area[c]);
            if (plan_runs(results->plan, EFFECT_ELECTRICAL))
                put_number(table, "ecr_factor", surface_model(s, m)->sensitivity.ecr[c]);
            end_row(table);
        }
}

/** A row, or an object. */
static void put_record(struct table *table, const struct record_field *fields, const void *row)
{
    if (table->objects) {
        json_array_append_new(table->objects, record_json(fields, row));
        return;
    }
    put_fields(table, fields, row, 0);
    end_row(table);
}

struct answer_row {
    const char *surface, *model, *target, *note, *quantity, *spots_by;
    double load_N, load, interval[2], value, spots;
};

#define ANSWER(...) RECORD_FIELD(struct answer_row, __VA_ARGS__)
const struct record_field answer_fields[] = {ANSWER(TEXT, "surface", surface, ALWAYS),
                                             ANSWER(TEXT, "model", model, ALWAYS),
                                             ANSWER(TEXT, "target", target, ALWAYS),
                                             ANSWER(TEXT, "note", note, JSON),
                                             ANSWER(NUMBER, "load_N", load_N, ALWAYS),
                                             ANSWER(NUMBER, "load_over_AnEp", load, ALWAYS),
                                             ANSWER(NUMBER, "low", interval[0], CSV),
                                             ANSWER(NUMBER, "high", interval[1], CSV),
                                             ANSWER(TEXT, "note", note, CSV),
                                             ANSWER(PAIR, "load_over_AnEp_95", interval, JSON),
                                             ANSWER(TEXT, "quantity", quantity, JSON),
                                             ANSWER(NUMBER, "value", value, JSON),
                                             ANSWER(NUMBER, "spots", spots, JSON),
                                             ANSWER(TEXT, "spots_by", spots_by, JSON),
                                             {0}};

/** What one model says of one target. */
static void put_answer(struct table *table, const struct results *results, const struct surface_summary *s, size_t m,
                       size_t t)
{
    const struct scene_asked *target = &results->scene->targets[t];
    const struct answer *answer = &s->answers[t * model_count + m];
    bool met = answer->kind == ANSWER_LOAD || answer->kind == ANSWER_LIGHTEST;
    double load = met ? answer->load : NAN, area_m2 = results->scene->nominal_area_m2;
    OWNED(text_free) struct text asked = {0}, note = {0};
    text_add(&asked, "%s %s", target->how->key, target->text);
    answers_note(&note, answer, area_m2);
    const struct answer_row row = {
        .surface = s->scene->name,
        .model = model_rows[m]->name,
        .target = text_string(&asked),
        .note = text_string(&note),
        .load_N = load * scene_load_divisor(results->scene, UNIT_FORCE, &s->pair),
        .load = load,
        .interval = {answer->low, answer->high},
        .quantity = quantity_rows[target->quantity].name,
        .value = target->value,
        .spots = answer->spots_per_m2 * area_m2,
        .spots_by = isnan(answer->spots_per_m2) ? NULL : model_rows[answer->counted_by]->name,
    };
    put_record(table, answer_fields, &row);
}

static void fill_answers(struct table *table, const struct results *results, size_t index)
{
    const struct surface_summary *s = &results->surfaces[index].summary;
    for (size_t m = 0; m < model_count && s->usable; m++)
        for (size_t t = 0; t < results->scene->target_count && plan_runs_model(results->plan, m); t++)
            put_answer(table, results, s, m, t);
}

struct limit_row {
    const char *surface, *model, *limit, *verdict, *quantity;
    double least, most, value, interval[2];
};

#define LIMIT(...) RECORD_FIELD(struct limit_row, __VA_ARGS__)
const struct record_field limit_fields[] = {
    LIMIT(TEXT, "surface", surface, ALWAYS), LIMIT(TEXT, "model", model, JSON),
    LIMIT(TEXT, "limit", limit, JSON),       LIMIT(TEXT, "quantity", quantity, ALWAYS),
    LIMIT(NUMBER, "least", least, CSV),      LIMIT(NUMBER, "most", most, CSV),
    LIMIT(NUMBER, "value", value, ALWAYS),   LIMIT(NUMBER, "low", interval[0], CSV),
    LIMIT(NUMBER, "high", interval[1], CSV), LIMIT(PAIR, "interval_95", interval, JSON),
    LIMIT(TEXT, "verdict", verdict, ALWAYS), {0}};

/** The spots of a map at the operating load. */
static void fill_spots(struct table *table, const struct results *results, size_t index)
{
    const struct surface_record *record = &results->surfaces[index];
    const struct material_pair *pair = &record->summary.pair;
    const bool turned = results->scene->direction == SCAN_DIRECTION_Y; /* the map was, to read its columns */
    for (size_t i = 0; record->contact.spots && i < record->contact.spot_count; i++) {
        const struct map_spot *spot = &record->contact.spots[i];
        put_text(table, "surface", record->summary.scene->name);
        put_number(table, "x_m", turned ? spot->y_m : spot->x_m);
        put_number(table, "y_m", turned ? spot->x_m : spot->y_m);
        put_number(table, "area_m2", spot->area_m2);
        put_number(table, "load_N", pair->unknown ? NAN : spot->force_m2 * pair->effective_modulus_Pa);
        end_row(table);
    }
}

/** How a surface stands to every limit, by the leading model. */
static void fill_limits(struct table *table, const struct results *results, size_t index)
{
    const struct surface_summary *s = &results->surfaces[index].summary;
    for (size_t l = 0; l < results->scene->limit_count && s->usable; l++) {
        const struct scene_asked *limit = &results->scene->limits[l];
        const struct limit_check *check = &s->limits[l];
        OWNED(text_free) struct text asked = {0};
        text_add(&asked, "%s %s %s", limit->how->key, limit->is_most ? "most" : "least", limit->text);
        const struct limit_row row = {.surface = s->scene->name,
                                      .model = model_rows[plan_leading_model(results->plan)]->name,
                                      .limit = text_string(&asked),
                                      .verdict = limit_verdict_words[check->verdict],
                                      .quantity = quantity_rows[limit->quantity].name,
                                      .least = limit->is_upper ? NAN : limit->value,
                                      .most = limit->is_upper ? limit->value : NAN,
                                      .value = check->value,
                                      .interval = {check->low, check->high}};
        put_record(table, limit_fields, &row);
    }
}

static void fill_direct(struct table *table, const struct results *results, size_t index)
{
    const struct direct_study *study = &results->direct[index / DIRECT_STUDY_KINDS];
    enum direct_study_kind kind = index % DIRECT_STUDY_KINDS;
    const struct direct_study_curve *curve = &study->curves[kind];
    for (size_t i = 0; curve->points && i < curve->loads; i++) {
        put_text(table, "surface", results->surfaces[study->surface].summary.scene->name);
        put_text(table, "source", study->plan.side > 0 ? "map" : "law");
        put_number(table, "load_over_AnEp", study->plan.load[i]);
        for (enum quantity q = 0; q < QUANTITY_COUNT; q++) {
            const struct quantity_solved *solved = &quantity_rows[q].solved;
            if (!solved->column || !(results->plan->wanted & QUANTITY_BIT(q)))
                continue;
            double error, value = direct_study_value(study, results_pair(results, study->surface), kind, q, i, &error);
            put_number(table, solved->column, value);
            if (solved->ratio)
                put(table, solved->ratio, "_stderr", error);
        }
        put_number(table, "patches", curve->points[i].mean[DIRECT_PATCHES].value);
        put_count(table, "seeds", curve->seeds);
        put_count(table, "grid", study->plan.grid);
        put_text(table, "heights", direct_study_heights(study));
        put_number(table, "hardness_Pa",
                   kind == DIRECT_STUDY_CAPPED
                       ? study->plan.hardness * results_pair(results, study->surface)->effective_modulus_Pa
                       : NAN);
        end_row(table);
    }
}

static void fill_direct_ratio(struct table *table, const struct results *results, size_t index)
{
    const struct direct_study *study = &results->direct[index];
    const struct material_pair *pair = results_pair(results, study->surface);
    for (size_t m = 0; m < model_count; m++)
        for (size_t i = 0; study->models[m].exists && i < study->curves[direct_study_kind_of(study, m)].loads; i++) {
            put_whose(table, &results->surfaces[study->surface].summary, m);
            put_number(table, "load_over_AnEp", study->plan.load[i]);
            for (enum quantity q = 0; q < QUANTITY_COUNT; q++)
                if (quantity_rows[q].solved.ratio && (results->plan->wanted & QUANTITY_BIT(q)))
                    put_number(table, quantity_rows[q].solved.ratio, direct_study_ratio(study, pair, m, q, i));
            end_row(table);
        }
}

json_t *tables_json(const struct results *results, enum tables_objects what)
{
    struct table table = {.objects = json_array()};
    for (size_t i = 0; i < results->surface_count; i++)
        (what == TABLES_ANSWERS ? fill_answers : fill_limits)(&table, results, i);
    return table.objects;
}

/** Is any surface's number known with an interval, by several scans, a map's direct solution or simulated records? */
static bool has_intervals(const struct results *results)
{
    for (size_t i = 0; i < results->surface_count; i++) {
        const struct surface_summary *summary = &results->surfaces[i].summary;
        if (summary->usable && (summary->repeats.scans > 1 || summary->has_tiles ||
                                (summary->single_points > 0 && plan_runs(results->plan, EFFECT_UNCERTAINTY))))
            return true;
    }
    return false;
}

enum status_code tables_write(const struct results *results, const char *directory, struct status *status)
{
    const size_t surfaces = results->surface_count, studies = results->direct_count;
    const struct {
        const char *name;
        size_t count; /* of what it has rows of; 0: there is no such table */
        void (*fill)(struct table *table, const struct results *results, size_t index);
    } files[] = {
        {"surfaces.csv", surfaces, fill_surface},
        {"sensitivity.csv", surfaces, fill_sensitivity},
        {"answers.csv", surfaces, fill_answers},
        {"limits.csv", surfaces, fill_limits},
        {"convergence.csv", results->convergence ? CONVERGENCE_SWEEP_COUNT : 0, fill_convergence},
        {"contact_spots.csv", surfaces, fill_spots},
        {"direct.csv", studies * DIRECT_STUDY_KINDS, fill_direct},
        {"direct_ratio.csv", studies, fill_direct_ratio},
        {"cost.csv", results->benchmark ? results->benchmark->count : 0, fill_cost},
        {"spread.csv", has_intervals(results) ? surfaces : 0, fill_spread},
    };
    enum status_code rc = scene_bins_spectra(results->scene) ? STATUS_OK : write_curves(results, directory, status);
    for (size_t f = 0; f < sizeof files / sizeof *files && rc == STATUS_OK; f++) {
        struct table table = {.directory = directory, .name = files[f].name};
        for (size_t i = 0; i < files[f].count; i++)
            files[f].fill(&table, results, i);
        rc = table_close(&table, status);
    }
    return rc;
}
