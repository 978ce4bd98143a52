/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/tables.h"

#include "analysis/direct_study.h"
#include "results/comparison.h"
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

const struct cell_column cell_columns[] = {
#define COLUMN(name, member, in_table)                                                                                 \
    {                                                                                                                  \
        name, offsetof(struct surface_summary, member), in_table                                                       \
    }
    COLUMN("spacing_m", spacing_m, CELL_ALWAYS),
    COLUMN("scan_length_m", length_m, CELL_ALWAYS),
    COLUMN("rq_m", roughness.rq_m, CELL_ALWAYS),
    COLUMN("ra_m", roughness.ra_m, CELL_ALWAYS),
    COLUMN("pv_m", roughness.pv_m, CELL_JSON),
    COLUMN("m0_m2", roughness.m0_m2, CELL_ALWAYS),
    COLUMN("m2", roughness.m2, CELL_ALWAYS),
    COLUMN("m4_per_m2", roughness.m4_per_m2, CELL_ALWAYS),
    COLUMN("nayak", asperities.nayak, CELL_ALWAYS),
    COLUMN("asperity_density_per_m2", asperities.density_per_m2, CELL_OF_ASPERITIES),
    COLUMN("asperity_radius_m", asperities.radius_m, CELL_OF_ASPERITIES),
    COLUMN("asperity_sigma_m", asperities.sigma_s_m, CELL_OF_ASPERITIES),
    COLUMN("asperity_offset_m", asperities.offset_m, CELL_OF_ASPERITIES),
    COLUMN("alpha_SI", power_law.alpha, CELL_ALWAYS),
    COLUMN("gamma", power_law.gamma, CELL_ALWAYS),
    COLUMN("gamma_stderr", power_law.gamma_error, CELL_ALWAYS),
    COLUMN("fit_amplitude_m", power_law.amplitude_m, CELL_ALWAYS),
    COLUMN("fit_amplitude_stderr_decades", power_law.amplitude_error_decades, CELL_ALWAYS),
    COLUMN("fit_wavelength_m", power_law.wavelength_m, CELL_ALWAYS),
    COLUMN("fit_low_m", power_law.band_m[0], CELL_ALWAYS),
    COLUMN("fit_high_m", power_law.band_m[1], CELL_ALWAYS),
    COLUMN("fit_misfit_decades", power_law.misfit_decades, CELL_ALWAYS),
    COLUMN("fit_psd_m3", power_law.psd_m3, CELL_JSON),
#undef COLUMN
};
const size_t cell_column_count = sizeof cell_columns / sizeof *cell_columns;

double cell_column_of(const struct surface_summary *surface, size_t column)
{
    double value;
    memcpy(&value, (const char *)surface + cell_columns[column].offset, sizeof value);
    return value;
}

enum {
    SWEEP_ROWS = 200,
    HELD_BYTES = 1 << 20 /* of rows before they are written; those of an ordinary surface wait for nobody then */
};

/** A file being written, which is opened with its first rows; or what one surface adds to it, whose rows are written in
 * the surfaces' order. */
struct table {
    const char *directory, *name;
    struct results_infinite *counted; /* infinite numbers of all tables; NULL: not */
    size_t infinite;                  /* those of the rows held */
    const char *infinite_column;      /* of the first of them */
    FILE *file;
    int problem;               /* errno of what failed; 0: nothing did */
    struct text header;        /* the columns' names, as the first row goes over them */
    bool named;                /* it has */
    size_t cells;              /* of the row begun */
    struct text rows;          /* not written yet */
    struct table *whole;       /* of a part: the table that other threads write too; NULL: this is it */
    struct threads_turn *turn; /* of a part; NULL: no other thread writes */
};

static struct table table_make(const struct results *results, const char *directory, const char *name)
{
    return (struct table){.directory = directory, .name = name, .counted = results->infinite};
}

/** What one surface adds to a table. */
static struct table table_part(struct table *whole, struct threads_turn *turn)
{
    return (struct table){.name = whole->name, .whole = whole, .turn = turn};
}

/** Opens the file and writes the columns' names. */
static void open_table(struct table *table, const struct text *header)
{
    struct text path = {0};
    text_add(&path, "%s/data/%s", table->directory, table->name);
    table->file = fopen(text_string(&path), "w");
    text_free(&path);
    if (table->file)
        fwrite(header->data, 1, header->length, table->file);
    else
        table->problem = errno;
}

/** Writes the rows held, in turn; of a surface in vain they go. */
static void write_rows(struct table *table)
{
    struct table *whole = table->whole ? table->whole : table;
    if (threads_wait(table->turn)) {
        if (table->rows.length > 0 && !whole->file && !whole->problem)
            open_table(whole, &table->header);
        if (table->rows.length > 0 && whole->file &&
            fwrite(table->rows.data, 1, table->rows.length, whole->file) < table->rows.length)
            whole->problem = errno;
        table->problem = whole->problem;
        if (table->infinite > 0 && whole->counted) {
            if (whole->counted->count == 0)
                snprintf(whole->counted->first, sizeof whole->counted->first, "%s in data/%s", table->infinite_column,
                         whole->name);
            whole->counted->count += table->infinite;
        }
    }
    table->infinite = 0;
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
        text_add(&table->rows, "%.17g", value);
    if (isinf(value) && table->infinite++ == 0)
        table->infinite_column = name;
}

static void put_number(struct table *table, const char *name, double value)
{
    put(table, name, "", value);
}

static void put_word(struct table *table, const char *name, const char *word)
{
    begin_cell(table, name, "");
    text_add_bytes(&table->rows, word, strlen(word));
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

/** Writes what is held; of a surface's part the file stays open. */
static enum status_code table_close(struct table *table, struct status *status)
{
    write_rows(table);
    if (table->rows.failed || table->header.failed)
        table->problem = ENOMEM;
    text_free(&table->header);
    text_free(&table->rows);
    if (!table->whole && table->file && fclose(table->file) != 0)
        table->problem = errno;
    if (table->problem && status->code == STATUS_OK)
        return status_fail(status, STATUS_IO, "cannot write '%s': %s", table->name, status_reason(table->problem));
    return status->code;
}

static void fill_surfaces(struct table *table, const struct results *results)
{
    const struct plan *plan = results->plan;
    const int most = plan_uses_asperities(plan) ? CELL_OF_ASPERITIES : CELL_ALWAYS;
    for (size_t i = 0; i < results->surface_count; i++) {
        const struct surface_summary *s = &results->surfaces[i].summary;
        if (!s->usable)
            continue;
        put_text(table, "surface", s->scene->name);
        struct text files = {0};
        for (size_t f = 0; f < s->scene->file_count; f++)
            text_add(&files, "%s%s", f > 0 ? ";" : "", s->scene->files[f]);
        put_text(table, "files", text_string(&files));
        text_free(&files);
        put_count(table, "points", s->points);
        for (size_t c = 0; c < cell_column_count; c++)
            if ((int)cell_columns[c].in_table <= most)
                put_number(table, cell_columns[c].name, cell_column_of(s, c));
        put_number(table, "heights_factor_ecr", comparison_heights_factor(results, i, QUANTITY_ECR));
        for (size_t m = 0; m < model_count; m++)
            if (plan_runs_model(plan, m) && (model_rows[m]->quantities & QUANTITY_BIT(QUANTITY_ADJUSTED)))
                put(table, "beta_", model_rows[m]->name, surface_model(s, m)->exists ? surface_model(s, m)->beta : NAN);
        end_row(table);
    }
}

/** A row a harmonic, or a bin of them, of harmonics `first` to before `end`. */
static void put_spectrum(struct table *table, const struct surface_record *record, bool binned)
{
    const struct spectrum *spectrum = &record->spectrum;
    struct text name = {0}; /* worded once: half of the time of 200 000 rows otherwise */
    text_add_csv(&name, record->summary.scene->name);
    for (size_t i = 0; i < spectrum->count;) {
        const struct spectrum_bin bin = binned ? spectrum_bin_from(spectrum, i) : spectrum_bin_of(spectrum, i);
        put_word(table, "surface", text_string(&name));
        double wavelength_m = bin.wavelength_m * surface_kappa(&record->summary); /* as the scans have it */
        put_number(table, "wavelength_m", wavelength_m);
        put_number(table, "amplitude_m", bin.amplitude_m);
        put_number(table, "fit_m", power_law_amplitude(&record->summary.power_law, wavelength_m));
        if (binned)
            put_count(table, "harmonics", bin.count);
        end_row(table);
        i += bin.count;
    }
    table->rows.failed = table->rows.failed || name.failed;
    text_free(&name);
}

struct curve_tables {
    bool binned;
    struct table spectrum, contact, bands;
    unsigned quantities, band_quantities; /* QUANTITY_BITs that contact and bands have columns of */
};

static void put_contact(struct table *table, const struct surface_record *record, unsigned quantities)
{
    double sigma_m = record->summary.asperities.sigma_m;
    for (size_t m = 0; m < model_count; m++)
        for (size_t i = 0; i < record->curves[m].count; i++) {
            const struct contact_point *point = &record->curves[m].points[i];
            put_text(table, "surface", record->summary.scene->name);
            put_word(table, "model", model_rows[m]->name);
            for (int q = 0; q < QUANTITY_COUNT; q++) {
                const struct quantity_row *row = &quantity_rows[q];
                if (!(quantities & QUANTITY_BIT(q)))
                    continue;
                double value = point->value[q];
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
            put_text(table, "surface", record->summary.scene->name);
            put_word(table, "model", model_rows[m]->name);
            put_number(table, quantity_rows[QUANTITY_LOAD].name, band->load);
            for (int q = 0; q < QUANTITY_COUNT; q++)
                for (int end = 0; end < 4 && (quantities & QUANTITY_BIT(q)); end++)
                    put(table, quantity_shown_name((enum quantity)q), ends[end],
                        end < 2 ? band->mean[q][end] : band->next[q][end - 2]);
            end_row(table);
        }
}

enum status_code curve_tables_put(struct curve_tables *all, const struct surface_record *record,
                                  struct threads_turn *turn, struct status *status)
{
    struct table spectrum = table_part(&all->spectrum, turn), contact = table_part(&all->contact, turn),
                 bands = table_part(&all->bands, turn);
    put_spectrum(&spectrum, record, all->binned);
    put_contact(&contact, record, all->quantities);
    put_bands(&bands, record, all->band_quantities);
    (void)table_close(&spectrum, status);
    (void)table_close(&contact, status);
    return table_close(&bands, status);
}

enum status_code curve_tables_open(struct curve_tables **out, const struct results *results, const struct plan *plan,
                                   const char *directory, struct status *status)
{
    struct curve_tables *all = *out = calloc(1, sizeof *all);
    if (!all)
        return status_memory(status);
    *all = (struct curve_tables){.binned = scene_bins_spectra(results->scene),
                                 .spectrum = table_make(results, directory, "spectrum.csv"),
                                 .contact = table_make(results, directory, "contact.csv"),
                                 .bands = table_make(results, directory, "bands.csv"),
                                 .quantities = plan_quantities(plan)};
    for (int q = 0; q < QUANTITY_COUNT; q++)
        if ((quantity_rows[q].is & QUANTITY_BANDED) && (plan->wanted & QUANTITY_BIT(q)))
            all->band_quantities |= QUANTITY_BIT(q);
    return STATUS_OK;
}

enum status_code curve_tables_close(struct curve_tables *all, struct status *status)
{
    if (!all)
        return status->code;
    (void)table_close(&all->spectrum, status);
    (void)table_close(&all->contact, status);
    (void)table_close(&all->bands, status);
    free(all);
    return status->code;
}

/** Of surfaces whose arrays are all in memory. */
static enum status_code write_curves(const struct results *results, const char *directory, struct status *status)
{
    struct curve_tables *all;
    enum status_code rc = curve_tables_open(&all, results, results->plan, directory, status);
    for (size_t i = 0; i < results->surface_count && rc == STATUS_OK; i++)
        if (results->surfaces[i].summary.usable)
            rc = curve_tables_put(all, &results->surfaces[i], NULL, status);
    return curve_tables_close(all, status);
}

static void fill_convergence(struct table *table, const struct results *results)
{
    const struct scene_convergence *study = &results->scene->convergence;
    size_t index[SWEEP_ROWS], count = results_sweep_scales(index, SWEEP_ROWS, study->scales);
    for (int s = 0; s < CONVERGENCE_SWEEP_COUNT; s++)
        for (size_t v = 0; v < convergence_sweeps[s].count; v++)
            for (size_t m = 0; m < model_count; m++) {
                if (!plan_runs_model(results->plan, m) || !model_rows[m]->stacks_scales)
                    continue;
                const double *area = results_sweep(results, (enum convergence_sweep)s, m, v);
                for (size_t k = 0; k < count; k++) {
                    put_word(table, "sweep", convergence_sweeps[s].name);
                    put_number(table, "value", convergence_sweeps[s].values[v]);
                    put_word(table, "model", model_rows[m]->name);
                    put_number(table, "wavelength_m", study->scan_length_m / (double)(index[k] + 1));
                    put_number(table, "area_ratio", area[index[k]]);
                    end_row(table);
                }
            }
}

static void fill_cost(struct table *table, const struct results *results)
{
    const struct benchmark *benchmark = results->benchmark;
    for (size_t i = 0; i < benchmark->count; i++) {
        const struct benchmark_row *row = &benchmark->rows[i];
        put_word(table, "study", row->study);
        put_word(table, "method", row->method);
        begin_cell(table, "setting", "");
        text_add(&table->rows, "%g", row->setting);
        put_count(table, "evaluations", row->evaluations);
        put_number(table, "seconds", row->seconds);
        put_number(table, "max_relative_error", row->error);
        end_row(table);
    }
}

/** Scans, the sum of their weights, mean, standard deviation of one of them (of the logarithm where the mean is
 * geometric), ends of the 95 % interval of the mean, and of another scan's. */
static void put_spread_number(struct table *table, const struct surface_summary *surface, const char *quantity,
                              const struct estimate *estimate)
{
    if (estimate->count == 0)
        return;
    put_text(table, "surface", surface->scene->name);
    put_word(table, "quantity", quantity);
    put_count(table, "scans", estimate->count);
    put_number(table, "effective", estimate->effective);
    put_number(table, "mean", estimate_value(estimate));
    put_number(table, "standard_deviation", estimate->sd);
    put_number(table, "mean_low_95", estimate_end(estimate, 0));
    put_number(table, "mean_high_95", estimate_end(estimate, 1));
    put_number(table, "next_scan_low_95", estimate_next_end(estimate, 0));
    put_number(table, "next_scan_high_95", estimate_next_end(estimate, 1));
    end_row(table);
}

static void fill_spread(struct table *table, const struct results *results)
{
    for (size_t i = 0; i < results->surface_count; i++) {
        const struct surface_summary *s = &results->surfaces[i].summary;
        if (!s->usable)
            continue;
        const struct repeats *repeats = &s->repeats;
        char quantity[80];
        if (repeats->scans > 1) {
            put_spread_number(table, s, "rq_m", &repeats->rq_m);
            put_spread_number(table, s, "gamma", &repeats->gamma);
            put_spread_number(table, s, "fit_psd_m3", &repeats->psd_m3);
        }
        for (size_t m = 0; m < model_count; m++) {
            snprintf(quantity, sizeof quantity, "beta_%s", model_rows[m]->name);
            put_spread_number(table, s, quantity, curve_summary_estimate(surface_model(s, m), CURVE_BETA));
            snprintf(quantity, sizeof quantity, "full_contact_load_over_AnEp_%s", model_rows[m]->name);
            put_spread_number(table, s, quantity, curve_summary_estimate(surface_model(s, m), CURVE_FULL_LOAD));
            for (int q = 0; q < QUANTITY_COUNT; q++) {
                snprintf(quantity, sizeof quantity, "%s_at_middle_load_%s", quantity_shown_name((enum quantity)q),
                         model_rows[m]->name);
                if (quantity_rows[q].is & QUANTITY_BANDED)
                    put_spread_number(table, s, quantity, curve_summary_estimate(surface_model(s, m), q));
            }
        }
    }
}

static void fill_sensitivity(struct table *table, const struct results *results)
{
    bool ecr = plan_runs(results->plan, EFFECT_ELECTRICAL);
    for (size_t i = 0; i < results->surface_count; i++)
        for (size_t m = 0; m < model_count; m++) {
            const struct surface_summary *s = &results->surfaces[i].summary;
            if (!s->usable || !surface_model(s, m)->exists)
                continue;
            for (int c = 0; c < SENSITIVITY_CHANGES; c++) {
                if (sensitivity_changes[c].plastic && !model_rows[m]->plastic)
                    continue;
                put_text(table, "surface", s->scene->name);
                put_word(table, "model", model_rows[m]->name);
                put_word(table, "change", sensitivity_changes[c].name);
                put_number(table, "area_factor", surface_model(s, m)->sensitivity.area[c]);
                if (ecr)
                    put_number(table, "ecr_factor", surface_model(s, m)->sensitivity.ecr[c]);
                end_row(table);
            }
        }
}

static void put_answer(struct table *table, const struct results *results, size_t surface, size_t m, size_t t)
{
    const struct scene_asked *target = &results->scene->targets[t];
    const struct surface_summary *s = &results->surfaces[surface].summary;
    const struct answer *answer = &s->answers[t * model_count + m];
    bool met = answer->kind == ANSWER_LOAD || answer->kind == ANSWER_LIGHTEST;
    double force_N = scene_load_divisor(results->scene, UNIT_FORCE, &s->pair),
           area_m2 = results->scene->nominal_area_m2;
    struct text asked = {0}, note = {0};
    put_text(table, "surface", s->scene->name);
    text_add(&asked, "%s %s", target->how->key, target->text);
    answers_note(&note, answer, area_m2, 1, "");
    put_word(table, "model", model_rows[m]->name);
    put_text(table, "target", text_string(&asked));
    put_number(table, "load_N", met ? answer->load * force_N : NAN);
    put_number(table, "load_over_AnEp", met ? answer->load : NAN);
    put_number(table, "low", answer->low);
    put_number(table, "high", answer->high);
    put_text(table, "note", text_string(&note));
    end_row(table);
    text_free(&asked);
    text_free(&note);
}

static void fill_answers(struct table *table, const struct results *results)
{
    for (size_t i = 0; i < results->surface_count; i++)
        for (size_t m = 0; m < model_count && results->surfaces[i].summary.usable; m++)
            for (size_t t = 0; t < results->scene->target_count && plan_runs_model(results->plan, m); t++)
                put_answer(table, results, i, m, t);
}

static void fill_unloading(struct table *table, const struct results *results)
{
    for (size_t s = 0; s < results->surface_count; s++) {
        const struct surface_summary *summary = &results->surfaces[s].summary;
        const struct surface_unloading *unloading = summary->unloading;
        for (size_t i = 0; unloading && i < unloading->ratio.count; i++) {
            const struct contact_point *point = &unloading->points[i];
            double load = point->value[QUANTITY_LOAD];
            put_text(table, "surface", summary->scene->name);
            put_word(table, "model", model_rows[unloading->model]->name);
            put_number(table, "load_over_AnEp", load);
            put_number(table, "largest_load_over_AnEp", unloading->largest_load);
            for (int q = 0; q < QUANTITY_COUNT; q++)
                if ((quantity_rows[q].is & QUANTITY_BANDED) && !quantity_rows[q].from &&
                    (plan_quantities(results->plan) & QUANTITY_BIT(q))) {
                    put_number(table, quantity_rows[q].name, point->value[q]);
                    put(table, quantity_rows[q].name, "_over_loading",
                        unloading_factor(&unloading->ratio, (enum quantity)q, load / unloading->largest_load));
                }
            end_row(table);
        }
    }
}

static void put_direct(struct table *table, const struct results *results, const struct direct_study *study,
                       enum direct_study_kind kind)
{
    const struct direct_study_curve *curve = &study->curves[kind];
    for (size_t i = 0; curve->points && i < curve->loads; i++) {
        put_text(table, "surface", results->surfaces[study->surface].summary.scene->name);
        put_word(table, "source", study->plan.side > 0 ? "map" : "law");
        put_number(table, "load_over_AnEp", study->plan.load[i]);
        for (int q = 0; q < QUANTITY_COUNT; q++) {
            const struct quantity_solved *solved = &quantity_rows[q].solved;
            if (!solved->column || !(results->plan->wanted & QUANTITY_BIT(q)))
                continue;
            double error, value = direct_study_value(study, results_pair(results, study->surface), kind,
                                                     (enum quantity)q, i, &error);
            put_number(table, solved->column, value);
            if (solved->ratio)
                put(table, solved->ratio, "_stderr", error);
        }
        put_number(table, "patches", curve->points[i].mean[DIRECT_PATCHES].value);
        put_count(table, "seeds", curve->seeds);
        put_count(table, "grid", study->plan.grid);
        put_word(table, "heights", direct_study_heights(study));
        put_number(table, "hardness_Pa",
                   kind == DIRECT_STUDY_CAPPED
                       ? study->plan.hardness * results_pair(results, study->surface)->effective_modulus_Pa
                       : NAN);
        end_row(table);
    }
}

static void fill_direct(struct table *table, const struct results *results)
{
    for (size_t k = 0; k < results->direct_count; k++)
        for (int kind = 0; kind < DIRECT_STUDY_KINDS; kind++)
            put_direct(table, results, &results->direct[k], (enum direct_study_kind)kind);
}

static void fill_direct_ratio(struct table *table, const struct results *results)
{
    for (size_t k = 0; k < results->direct_count; k++)
        for (size_t m = 0; m < model_count; m++) {
            const struct direct_study *study = &results->direct[k];
            size_t loads = study->curves[direct_study_kind_of(study, m)].loads;
            for (size_t i = 0; study->models[m].exists && i < loads; i++) {
                put_text(table, "surface", results->surfaces[study->surface].summary.scene->name);
                put_word(table, "model", model_rows[m]->name);
                put_number(table, "load_over_AnEp", study->plan.load[i]);
                for (int q = 0; q < QUANTITY_COUNT; q++)
                    if (quantity_rows[q].solved.ratio && (results->plan->wanted & QUANTITY_BIT(q)))
                        put_number(
                            table, quantity_rows[q].solved.ratio,
                            direct_study_ratio(study, results_pair(results, study->surface), m, (enum quantity)q, i));
                end_row(table);
            }
        }
}

enum status_code tables_write(const struct results *results, const char *directory, struct status *status)
{
    const struct {
        const char *name;
        bool wanted;
        void (*fill)(struct table *table, const struct results *results);
    } files[] = {
        {"surfaces.csv", true, fill_surfaces},
        {"sensitivity.csv", true, fill_sensitivity},
        {"answers.csv", results->scene->target_count > 0, fill_answers},
        {"unloading.csv", plan_runs(results->plan, EFFECT_UNLOADING), fill_unloading},
        {"convergence.csv", results->convergence != NULL, fill_convergence},
        {"direct.csv", results->direct != NULL, fill_direct},
        {"direct_ratio.csv", results->direct != NULL, fill_direct_ratio},
        {"cost.csv", results->benchmark != NULL, fill_cost},
        {"spread.csv", results_intervals(results), fill_spread},
    };
    enum status_code rc = scene_bins_spectra(results->scene) ? STATUS_OK : write_curves(results, directory, status);
    for (size_t f = 0; f < sizeof files / sizeof *files && rc == STATUS_OK; f++) {
        struct table table = table_make(results, directory, files[f].name);
        if (files[f].wanted)
            files[f].fill(&table, results);
        rc = table_close(&table, status);
    }
    return rc;
}
