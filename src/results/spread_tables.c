/* data/spread.csv and data/bands.csv: what repeated scans of a surface say apart. Written when a surface has several.
 */
#include "results/cell.h"
#include "results/tables.h"

#include <errno.h>
#include <math.h>
#include <string.h>

/** surface, quantity, scans, mean, standard deviation, and the 95 % interval where there is one. */
static void put_number(struct text *out, const struct cell_guard *guard, const char *quantity,
                       const struct spread_number *spread, const double interval[2])
{
    if (spread->count < 2)
        return;
    text_add_csv(out, guard->surface);
    text_add(out, ",%s,%zu", quantity, spread->count);
    cell_number(out, guard, quantity, spread->mean);
    cell_number(out, guard, quantity, spread_deviation(spread));
    cell_number(out, guard, quantity, interval ? interval[0] : NAN);
    cell_number(out, guard, quantity, interval ? interval[1] : NAN);
    text_add(out, "\n");
}

static void put_spread(struct text *out, const struct surface_summary *summary, struct status *status)
{
    const struct spread *spread = &summary->spread;
    const struct cell_guard guard = {summary->scene->name, status};
    double log_alpha[2] = {log(spread->alpha_interval[0]), log(spread->alpha_interval[1])};
    char quantity[64];
    put_number(out, &guard, "rq_m", &spread->rq_m, NULL);
    put_number(out, &guard, "gamma", &spread->gamma, spread->gamma_interval);
    put_number(out, &guard, "ln_alpha_SI", &spread->log_alpha, log_alpha);
    for (int m = 0; m < MODEL_COUNT; m++) {
        snprintf(quantity, sizeof quantity, "beta_%s", model_rows[m].name);
        put_number(out, &guard, quantity, &spread->beta[m], NULL);
        snprintf(quantity, sizeof quantity, "ln_full_contact_load_%s", model_rows[m].name);
        put_number(out, &guard, quantity, &spread->log_full_load[m], NULL);
    }
}

static void put_bands(struct text *out, const struct surface_record *record, const struct plan *plan,
                      struct status *status)
{
    const struct cell_guard guard = {record->summary.scene->name, status};
    for (int m = 0; m < MODEL_COUNT; m++)
        for (size_t i = 0; record->bands[m] && i < record->band_count; i++) {
            const struct spread_band *band = &record->bands[m][i];
            text_add_csv(out, guard.surface);
            text_add(out, ",%s", model_rows[m].name);
            cell_number(out, &guard, "load_over_AnEp", band->load);
            for (int side = 0; side < 2; side++)
                cell_number(out, &guard, "area_ratio", band->area[side]);
            for (int side = 0; side < 2 && plan_runs(plan, EFFECT_SEPARATION); side++)
                cell_number(out, &guard, "separation_m", band->separation_m[side]);
            for (int side = 0; side < 2 && plan_runs(plan, EFFECT_ELECTRICAL); side++)
                cell_number(out, &guard, "ecr_ohm_m2", band->ecr_ohm_m2[side]);
            for (int side = 0; side < 2 && plan_runs(plan, EFFECT_THERMAL); side++)
                cell_number(out, &guard, "tcr_K_m2_per_W", band->tcr_K_m2_per_W[side]);
            text_add(out, "\n");
        }
}

/** Adds the text to the file and empties it. */
static void flush(FILE *file, struct text *out)
{
    fwrite(out->data, 1, out->length, file);
    out->length = 0;
}

static FILE *open_table(const char *directory, const char *name, struct status *status)
{
    struct text path = {0};
    text_add(&path, "%s/data/%s", directory, name);
    FILE *file = fopen(text_string(&path), "w");
    if (!file)
        (void)status_fail(status, STATUS_IO, "cannot write '%s': %s", name, strerror(errno));
    text_free(&path);
    return file;
}

bool results_repeated(const struct results *results)
{
    for (size_t i = 0; i < results->spool->count; i++)
        if (results->spool->summaries[i].usable && results->spool->summaries[i].spread.parts > 0)
            return true;
    return false;
}

enum status_code tables_write_spread(const struct results *results, const char *directory, struct status *status)
{
    if (!results_repeated(results))
        return STATUS_OK;
    struct text row = {0};
    FILE *spread = open_table(directory, "spread.csv", status);
    FILE *bands = spread ? open_table(directory, "bands.csv", status) : NULL;
    enum status_code rc = bands ? STATUS_OK : status->code;
    text_add(&row, "surface,quantity,scans,mean,standard_deviation,low_95,high_95\n");
    for (size_t i = 0; i < results->spool->count && rc == STATUS_OK; i++)
        if (results->spool->summaries[i].usable)
            put_spread(&row, &results->spool->summaries[i], status);
    if (rc == STATUS_OK)
        flush(spread, &row);
    text_add(&row, "surface,model,load_over_AnEp,area_ratio_low,area_ratio_high%s%s%s\n",
             plan_runs(results->plan, EFFECT_SEPARATION) ? ",separation_m_low,separation_m_high" : "",
             plan_runs(results->plan, EFFECT_ELECTRICAL) ? ",ecr_ohm_m2_low,ecr_ohm_m2_high" : "",
             plan_runs(results->plan, EFFECT_THERMAL) ? ",tcr_K_m2_per_W_low,tcr_K_m2_per_W_high" : "");
    for (size_t i = 0; i < results->spool->count && rc == STATUS_OK; i++) {
        struct surface_record record;
        if (!results->spool->summaries[i].usable || results->spool->summaries[i].spread.parts == 0)
            continue;
        rc = spool_get(&record, results->spool, i, status);
        if (rc == STATUS_OK)
            put_bands(&row, &record, results->plan, status);
        if (rc == STATUS_OK)
            flush(bands, &row);
        if (rc == STATUS_OK)
            surface_record_free(&record, false);
    }
    bool bad = row.failed;
    text_free(&row);
    if (spread && fclose(spread) != 0)
        bad = true;
    if (bands && fclose(bands) != 0)
        bad = true;
    if (bad && rc == STATUS_OK)
        return status_fail(status, STATUS_IO, "cannot write spread.csv and bands.csv");
    return status->code; /* of a number that could not be written, too */
}
