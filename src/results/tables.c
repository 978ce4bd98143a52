#include "results/tables.h"

#include "results/cell.h"
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SWEEP_ROWS = 200 };

const double *results_sweep(const struct results *results, enum convergence_sweep sweep, bool plastic, size_t value)
{
    size_t before = 2 * value + (plastic ? 1 : 0);
    for (int s = 0; s < (int)sweep; s++)
        before += 2 * convergence_sweeps[s].count;
    return results->convergence + before * results->scene->convergence.scales;
}

size_t results_sweep_scales(size_t *index, size_t most, size_t scales)
{
    size_t count = 0, next = 0; /* the first scale not yet taken */
    for (size_t k = 0; k < most; k++) {
        double n = pow((double)scales, (double)k / (double)(most - 1));
        size_t i = (size_t)lround(n) - 1;
        if (i >= next) {
            index[count++] = i;
            next = i + 1;
        }
    }
    return count;
}

/** One column of a table: its name and, when not always there, the effect and the model family it needs. */
struct column {
    const char *name;
    unsigned effect;         /* EFFECT_BIT, 0: none needed */
    enum scene_model family; /* 0: none needed */
};

static bool column_present(const struct column *column, const struct plan *plan)
{
    return (column->effect == 0 || (plan->running & column->effect)) &&
           (column->family == 0 || (plan->families & column->family));
}

static FILE *open_table(const char *directory, const char *name, struct status *status)
{
    struct text path = {0};
    text_add(&path, "%s/data/%s", directory, name);
    FILE *file = fopen(text_string(&path), "w");
    if (!file)
        (void)status_fail(status, STATUS_IO, "cannot write '%s': %s", text_string(&path), strerror(errno));
    text_free(&path);
    return file;
}

/** Flushes a row into the file. */
static void put(FILE *file, struct text *row)
{
    text_add_bytes(row, "\n", 1);
    fwrite(row->data, 1, row->length, file);
    row->length = 0;
}

static enum status_code close_table(FILE *file, struct text *row, const char *name, struct status *status)
{
    bool bad = row->failed || ferror(file);
    text_free(row);
    if (fclose(file) != 0 || bad)
        return status_fail(status, STATUS_IO, "cannot write '%s': %s", name, strerror(errno));
    return status->code; /* of a number that could not be written */
}

static void put_header(FILE *file, struct text *row, const struct column *columns, size_t count,
                       const struct plan *plan)
{
    for (size_t i = 0; i < count; i++)
        if (column_present(&columns[i], plan))
            text_add(row, "%s%s", i > 0 ? "," : "", columns[i].name);
    put(file, row);
}

static enum status_code write_surfaces(const struct results *results, const char *directory, struct status *status)
{
    enum scene_model statistical = SCENE_MODEL_STATISTICAL;
    static const char name[] = "surfaces.csv";
    const unsigned plastic = EFFECT_BIT(EFFECT_PLASTICITY);
    const struct column columns[] = {
        {"surface", 0, 0},
        {"files", 0, 0},
        {"points", 0, 0},
        {"spacing_m", 0, 0},
        {"scan_length_m", 0, 0},
        {"rq_m", 0, 0},
        {"ra_m", 0, 0},
        {"m0_m2", 0, 0},
        {"m2", 0, 0},
        {"m4_per_m2", 0, 0},
        {"nayak", 0, 0},
        {"asperity_density_per_m2", 0, statistical},
        {"asperity_radius_m", 0, statistical},
        {"asperity_sigma_m", 0, statistical},
        {"asperity_offset_m", 0, statistical},
        {"alpha_SI", 0, 0},
        {"alpha_stderr", 0, 0},
        {"gamma", 0, 0},
        {"gamma_stderr", 0, 0},
        {"fit_rms_decades", 0, 0},
        {"beta_gw", 0, statistical},
        {"beta_jg", plastic, statistical},
    };
    enum { COLUMNS = sizeof columns / sizeof columns[0], TEXTS = 3 };
    struct text row = {0};
    FILE *file = open_table(directory, name, status);
    if (!file)
        return status->code;
    put_header(file, &row, columns, COLUMNS, results->plan);
    for (size_t i = 0; i < results->spool->count; i++) {
        const struct surface_summary *s = &results->spool->summaries[i];
        if (!s->usable)
            continue;
        const struct cell_guard guard = {s->scene->name, status};
        const struct surface_model *gw = &s->models[MODEL_GW], *jg = &s->models[MODEL_JG];
        const double values[COLUMNS] = {
            0,
            0,
            0,
            s->spacing_m,
            s->length_m,
            s->roughness.rq_m,
            s->roughness.ra_m,
            s->roughness.m0_m2,
            s->roughness.m2,
            s->roughness.m4_per_m2,
            s->asperities.nayak,
            s->asperities.density_per_m2,
            s->asperities.radius_m,
            s->asperities.sigma_s_m,
            s->asperities.offset_m,
            s->law.alpha,
            s->law.alpha_error,
            s->law.gamma,
            s->law.gamma_error,
            s->law.rms_decades,
            gw->exists ? gw->beta : NAN,
            jg->exists ? jg->beta : NAN,
        };
        text_add_csv(&row, s->scene->name);
        struct text files = {0};
        for (size_t f = 0; f < s->scene->file_count; f++)
            text_add(&files, "%s%s", f > 0 ? ";" : "", s->scene->files[f]);
        text_add_bytes(&row, ",", 1);
        text_add_csv(&row, text_string(&files));
        text_free(&files);
        text_add(&row, ",%zu", s->points);
        for (size_t c = TEXTS; c < COLUMNS; c++)
            if (column_present(&columns[c], results->plan))
                cell_number(&row, &guard, columns[c].name, values[c]);
        put(file, &row);
    }
    return close_table(file, &row, name, status);
}

static void put_spectrum(FILE *file, struct text *row, const struct surface_record *record,
                         const struct cell_guard *guard)
{
    const struct spectrum *spectrum = &record->spectrum;
    for (size_t i = 0; i < spectrum->count; i++) {
        double wavelength_m = 1 / spectrum_frequency(spectrum, i);
        text_add_csv(row, record->summary.scene->name);
        cell_number(row, guard, "wavelength_m", wavelength_m);
        cell_number(row, guard, "amplitude_m", spectrum->amplitude_m[i]);
        cell_number(row, guard, "fit_m", powerlaw_amplitude(&record->summary.law, wavelength_m));
        put(file, row);
    }
}

static void put_contact(FILE *file, struct text *row, const struct surface_record *record,
                        const struct cell_guard *guard, const struct column *columns, size_t column_count,
                        const struct plan *plan)
{
    double sigma_m = record->summary.asperities.sigma_m;
    for (int m = 0; m < MODEL_COUNT; m++)
        for (size_t i = 0; i < record->curves[m].count; i++) {
            const struct contact_point *p = &record->curves[m].points[i];
            const double values[] = {0,
                                     0,
                                     p->load,
                                     p->load * plan->pair.effective_modulus_Pa,
                                     p->area_ratio,
                                     p->separation_m,
                                     p->separation_m / sigma_m,
                                     p->adjusted_m / sigma_m,
                                     p->ecr_ohm_m2,
                                     p->tcr_K_m2_per_W,
                                     p->tcr_sd_K_m2_per_W};
            text_add_csv(row, record->summary.scene->name);
            text_add(row, ",%s", model_rows[m].name);
            for (size_t c = 2; c < column_count; c++)
                if (column_present(&columns[c], plan))
                    cell_number(row, guard, columns[c].name, values[c]);
            put(file, row);
        }
}

/** spectrum.csv and contact.csv in one pass over the spool. */
static enum status_code write_curves(const struct results *results, const char *directory, struct status *status)
{
    const unsigned separation = EFFECT_BIT(EFFECT_SEPARATION);
    const struct column columns[] = {
        {"surface", 0, 0},
        {"model", 0, 0},
        {"load_over_AnEp", 0, 0},
        {"pressure_Pa", 0, 0},
        {"area_ratio", 0, 0},
        {"separation_m", separation, 0},
        {"separation_over_sigma", separation, 0},
        {"adjusted_separation_over_sigma", separation, SCENE_MODEL_STATISTICAL},
        {"ecr_ohm_m2", EFFECT_BIT(EFFECT_ELECTRICAL), 0},
        {"tcr_K_m2_per_W", EFFECT_BIT(EFFECT_THERMAL), 0},
        {"tcr_sd_K_m2_per_W", EFFECT_BIT(EFFECT_SCALE_DEPENDENT), 0},
    };
    enum { COLUMNS = sizeof columns / sizeof columns[0] };
    struct text row = {0}, contact_row = {0};
    FILE *spectrum = open_table(directory, "spectrum.csv", status);
    if (!spectrum)
        return status->code;
    FILE *contact = open_table(directory, "contact.csv", status);
    if (!contact) {
        fclose(spectrum);
        return status->code;
    }
    fputs("surface,wavelength_m,amplitude_m,fit_m\n", spectrum);
    put_header(contact, &contact_row, columns, COLUMNS, results->plan);
    enum status_code rc = STATUS_OK;
    for (size_t i = 0; i < results->spool->count && rc == STATUS_OK; i++) {
        struct surface_record record;
        if (!results->spool->summaries[i].usable)
            continue;
        rc = spool_get(&record, results->spool, i, status);
        if (rc != STATUS_OK)
            break;
        const struct cell_guard guard = {record.summary.scene->name, status};
        put_spectrum(spectrum, &row, &record, &guard);
        put_contact(contact, &contact_row, &record, &guard, columns, COLUMNS, results->plan);
        surface_record_free(&record, false);
    }
    enum status_code first = close_table(spectrum, &row, "spectrum.csv", status);
    enum status_code second = close_table(contact, &contact_row, "contact.csv", status);
    return rc != STATUS_OK ? rc : first != STATUS_OK ? first : second;
}

static enum status_code write_convergence(const struct results *results, const char *directory, struct status *status)
{
    const struct scene_convergence *study = &results->scene->convergence;
    size_t index[SWEEP_ROWS], count = results_sweep_scales(index, SWEEP_ROWS, study->scales);
    const struct cell_guard guard = {NULL, status};
    struct text row = {0};
    FILE *file = open_table(directory, "convergence.csv", status);
    if (!file)
        return status->code;
    fputs("sweep,value,model,wavelength_m,area_ratio\n", file);
    for (int s = 0; s < CONVERGENCE_SWEEP_COUNT; s++)
        for (size_t v = 0; v < convergence_sweeps[s].count; v++)
            for (int m = MODEL_MULTISCALE_ELASTIC; m <= MODEL_MULTISCALE_PLASTIC; m++) {
                if (!model_called_for((enum model_id)m, SCENE_MODEL_MULTISCALE, results->plan->running))
                    continue;
                const double *area = results_sweep(results, (enum convergence_sweep)s, model_rows[m].plastic, v);
                for (size_t k = 0; k < count; k++) {
                    text_add(&row, "%s", convergence_sweeps[s].name);
                    cell_number(&row, &guard, "value", convergence_sweeps[s].values[v]);
                    text_add(&row, ",%s", model_rows[m].name);
                    cell_number(&row, &guard, "wavelength_m", study->scan_length_m / (double)(index[k] + 1));
                    cell_number(&row, &guard, "area_ratio", area[index[k]]);
                    put(file, &row);
                }
            }
    return close_table(file, &row, "convergence.csv", status);
}

enum status_code tables_write(const struct results *results, const char *directory, struct status *status)
{
    if (write_surfaces(results, directory, status) != STATUS_OK ||
        write_curves(results, directory, status) != STATUS_OK)
        return status->code;
    if (results->convergence)
        return write_convergence(results, directory, status);
    return STATUS_OK;
}
