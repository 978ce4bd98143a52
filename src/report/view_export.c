/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The leading model's conductances over pressure, raw SI numbers for other programs; only where the scene asks. */
#include "report/view.h"

#include "base/version.h"
#include "contact/cmy.h"
#include <ctype.h>
#include <math.h>
#include <string.h>

enum { LAWS = 2, NUMBER = 32, NAME_MOST = 100, FEW = 20 };

/** h and g of the templates: 1/(TCR Aₙ), or h_j of the joint where something fills its gaps; 1/(ECR Aₙ), with film and
 * plating where there are such. */
struct law {
    const char *name, *ends_name, *value, *low, *high;
    enum quantity whole, contact;
    struct asked asked;
    bool exists, ends;
};

static void put_si(json_t *out, const char *name, double value)
{
    char number[NUMBER];
    snprintf(number, sizeof number, "%.9g", value);
    if (isfinite(value))
        json_object_set_new(out, name, json_string(number));
}

/** A name of a file from that of a surface, neither hidden nor like an option; where characters gave way, its number
 * tells it from all others. */
static void put_file(json_t *out, const char *surface, size_t number)
{
    char name[NAME_MOST + NUMBER];
    size_t length = 0;
    bool same = true;
    for (const char *s = surface; *s && length < NAME_MOST; s++, length++) {
        name[length] = isalnum((unsigned char)*s) || (strchr("-.", *s) && length > 0) ? *s : '_';
        same = same && name[length] == *s && (length + 1 < NAME_MOST || !s[1]);
    }
    snprintf(name + length, NUMBER, same ? "" : "~%zu", number);
    json_object_set_new(out, "file", json_string(name));
}

/** The points at which each law that exists has a number, by rising pressure. FEW of them, evenly chosen with both
 * ends, are `few`: contact between faces in CalculiX holds no more (2.20: springforc_f2f_th.f). */
static void put_rows(json_t *rows, struct law laws[LAWS], const struct surface_record *record, size_t m)
{
    const struct model_curve *curve = &record->curves[m];
    const struct ensemble_band *bands = record->bands ? record->bands[m] : NULL;
    double last = 0;
    for (size_t i = 0; i < curve->count && (!bands || i < record->band_count); i++) {
        const struct contact_point *point = &curve->points[i];
        double pressure_Pa = material_pair_pressure(&record->summary.pair, point->value[QUANTITY_LOAD]);
        bool whole = (laws[0].exists || laws[1].exists) && pressure_Pa > last * (1 + 1e-8);
        for (int k = 0; k < LAWS; k++)
            whole = whole && (!laws[k].exists || point->value[laws[k].asked.quantity] > 0);
        if (!whole)
            continue;
        json_t *row = view_item(rows);
        put_si(row, "pressure", last = pressure_Pa);
        for (int k = 0; k < LAWS; k++) {
            double ends[2] = {NAN, NAN};
            if (bands)
                asked_ends(ends, &laws[k].asked, bands[i].mean[laws[k].asked.quantity]);
            laws[k].ends = laws[k].ends && ends[0] < ends[1] && isfinite(ends[1] - ends[0]);
            put_si(row, laws[k].value, asked_shown(&laws[k].asked, point->value[laws[k].asked.quantity]));
            put_si(row, laws[k].low, ends[0]);
            put_si(row, laws[k].high, ends[1]);
        }
    }
    size_t j, steps = json_array_size(rows) - 1;
    json_t *row;
    json_array_foreach(rows, j, row)
    {
        view_count(row, "number", j + 1);
        view_flag(row, "few", steps < FEW || j == 0 || j * (FEW - 1) / steps > (j - 1) * (FEW - 1) / steps);
    }
}

static void put_surface(json_t *item, const struct view_source *source, size_t surface)
{
    const struct results *results = source->results;
    const struct surface_record *record = &results->surfaces[surface];
    const struct model_row *model = model_rows[source->leading];
    const struct model_curve *curve = &record->curves[source->leading];
    const unsigned computed = plan_quantities(results->plan);
    struct law laws[LAWS] = {
        {"thermal", "thermal_ends", "h", "h_low", "h_high", QUANTITY_JOINT, QUANTITY_TCR, .ends = true},
        {"electrical", "electrical_ends", "g", "g_low", "g_high", QUANTITY_JOINT_ECR, QUANTITY_ECR, .ends = true}};
    for (int k = 0; k < LAWS; k++) {
        struct law *law = &laws[k];
        bool whole = computed & QUANTITY_BIT(law->whole);
        law->asked.quantity = whole ? law->whole : law->contact;
        law->asked.reciprocal = law->asked.quantity != QUANTITY_JOINT;
        law->asked.scale = 1;
        for (size_t i = 0; i < curve->count; i++)
            law->exists = law->exists || isfinite(curve->points[i].value[law->asked.quantity]);
    }
    json_t *rows = view_list(item, "rows");
    put_rows(rows, laws, record, source->leading);
    for (int k = 0; k < LAWS; k++) {
        view_flag(item, laws[k].name, laws[k].exists);
        view_flag(item, laws[k].ends_name, laws[k].exists && laws[k].ends);
    }
    const struct curve_validity valid = curve_summary_validity(curve, model);
    for (int end = 0; end < 2 && valid.end > valid.first; end++) {
        const struct contact_point *point = &curve->points[end == 0 ? valid.first : valid.end - 1];
        put_si(item, end == 0 ? "valid_from" : "valid_to",
               material_pair_pressure(&record->summary.pair, point->value[QUANTITY_LOAD]));
    }
    view_count(item, "count", json_array_size(rows));
    view_count(item, "surface_number", surface + 1);
    put_file(item, view_name(source, surface), surface + 1);
    view_text(item, "surface", view_name(source, surface));
    view_text(item, "model", model->label);
    view_text(item, "version", version_string());
    view_flag(item, "gap", laws[0].asked.quantity == QUANTITY_JOINT);
    view_flag(item, "film_or_plating", laws[1].asked.quantity == QUANTITY_JOINT_ECR);
    view_flag(item, "shape", plan_runs(results->plan, EFFECT_SHAPE));
    put_si(item, "sigma", record->summary.rough.sigma_m);
    put_si(item, "slope", record->summary.rough.slope);
    put_si(item, "hardness", record->summary.pair.hardness_Pa);
}

void view_export(json_t *out, const struct view_source *source)
{
    for (size_t i = 0; i < source->results->surface_count && source->results->scene->exports; i++) {
        const struct surface_record *record = &source->results->surfaces[i];
        json_t *item = json_object();
        if (record->summary.usable && record->curves && record->curves[source->leading].exists)
            put_surface(item, source, i);
        if (json_array_size(json_object_get(item, "rows")) > 0)
            json_array_append(view_list(out, "exports"), item);
        json_decref(item);
    }
}
