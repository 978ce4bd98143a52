#include "results/measured.h"

#include "base/text.h"
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char byte_order_mark[] = "\xEF\xBB\xBF";

/* As for the scene's loads: any that keeps its distance from the ends of double. */
static const double least = 1e-100, most = 1e100;
static const char *const columns[] = {"a load", "a resistance", "an error"};

struct row {
    double value[3]; /* of `columns` */
};

/** Numbers of one line, delimited by a comma, a semicolon or blanks; words between them (units) do not count. How many
 * there are; 4 for more than 3, and for an empty cell before the last: what stands behind it is in another column. */
static size_t numbers_of(const char *line, double value[3])
{
    size_t count = 0;
    for (const char *p = line + strspn(line, " \t"); *p;) {
        char *end;
        double number = strtod(p, &end);
        bool empty = *p == ',' || *p == ';';
        if (count == 3 && end != p)
            return 4;
        if (end != p)
            value[count++] = number;
        else
            end += strcspn(end, ",; \t");
        p = end + strspn(end, " \t");
        p += *p == ',' || *p == ';';
        p += strspn(p, " \t");
        if (empty && p[strspn(p, ",; \t")] != '\0')
            return 4;
    }
    return count;
}

static bool is_data(const char *line)
{
    const char *p = line + strspn(line, " \t");
    return isdigit((unsigned char)p[strspn(p, "+-.")]);
}

static int compare_rows(const void *a, const void *b)
{
    double x = ((const struct row *)a)->value[0], y = ((const struct row *)b)->value[0];
    return (x > y) - (x < y);
}

/** Splits `content` into rows; the array is malloc'ed. */
static enum status_code parse(struct row **rows, size_t *count, char *content, const char *name, struct status *status)
{
    size_t capacity = 0;
    int line_number = 0;
    for (char *line; (line = strsep(&content, "\n"));) {
        struct row row = {{0, 0, NAN}};
        line_number++;
        line[strcspn(line, "\r#")] = '\0';
        if (line_number == 1 && strncmp(line, byte_order_mark, strlen(byte_order_mark)) == 0)
            line += strlen(byte_order_mark);
        if (!is_data(line))
            continue;
        if (strchr(line, ',') && strchr(line, ';'))
            return status_fail(status, STATUS_SCENE, "%s:%d: both ',' and ';' in a row; write decimals with a point",
                               name, line_number);
        size_t numbers = numbers_of(line, row.value);
        if (numbers < 2 || numbers > 3)
            return status_fail(status, STATUS_SCENE, "%s:%d: a row is load, resistance and perhaps its error", name,
                               line_number);
        if (!(row.value[0] > 0 && row.value[1] > 0))
            return status_fail(status, STATUS_SCENE, "%s:%d: load and resistance must be positive", name, line_number);
        for (size_t i = 0; i < numbers; i++)
            if (!(fabs(row.value[i]) <= most) || (i < 2 && row.value[i] < least))
                return status_fail(status, STATUS_SCENE, "%s:%d: %s of %g; allowed is %g to %g", name, line_number,
                                   columns[i], row.value[i], i < 2 ? least : 0, most);
        if (*count == capacity) {
            capacity = capacity ? 2 * capacity : 64;
            struct row *more = realloc(*rows, capacity * sizeof *more);
            if (!more)
                return status_memory(status);
            *rows = more;
        }
        (*rows)[(*count)++] = row;
    }
    if (*count == 0)
        return status_fail(status, STATUS_SCENE, "%s: no row of load and resistance", name);
    return STATUS_OK;
}

/** What a load and a resistance in the file's units are times, to be in the models'. */
static enum status_code factors(double *load, double *resistance, const struct scene *scene, const struct plan *plan,
                                struct status *status)
{
    double area_m2 = scene->nominal_area_m2, modulus_Pa = plan->pair.effective_modulus_Pa;
    bool has_area = isfinite(area_m2);
    *resistance = has_area ? area_m2 : 1;
    *load = 1;
    if (scene->measured.load_unit == SCENE_LOAD_PASCAL)
        *load = 1 / modulus_Pa;
    if (scene->measured.load_unit == SCENE_LOAD_NEWTON) {
        if (!has_area)
            return status_fail(status, STATUS_SCENE,
                               "%s: measured loads in N need the contact's area; add nominal_area_m2 to the scene",
                               scene->measured.file);
        *load = 1 / (modulus_Pa * area_m2);
    }
    return STATUS_OK;
}

enum status_code measured_read(struct measured *out, const struct scene *scene, const struct plan *plan,
                               struct status *status)
{
    *out = (struct measured){.thermal = scene->measured.quantity == SCENE_MEASURED_TCR};
    enum effect needed = out->thermal ? EFFECT_THERMAL : EFFECT_ELECTRICAL;
    if (!plan_runs(plan, needed))
        return status_fail(status, STATUS_SCENE,
                           "'%s' holds measured %s, but the effect %s does not run; add it to "
                           "effects, or take out measured",
                           scene->measured.file, out->thermal ? "TCR" : "ECR", effect_rows[needed].name);
    struct text content = {0};
    struct row *rows = NULL;
    double load_factor, resistance_factor;
    char *path = scene_file_path(scene, scene->measured.file);
    enum status_code rc = path ? text_read_file(&content, path, status) : status_memory(status);
    if (rc == STATUS_OK)
        rc = factors(&load_factor, &resistance_factor, scene, plan, status);
    if (rc == STATUS_OK && memchr(content.data, '\0', content.length))
        rc = status_fail(status, STATUS_SCENE, "%s: a NUL byte in the file; save it as plain text (UTF-8)",
                         scene->measured.file);
    if (rc == STATUS_OK)
        rc = parse(&rows, &out->count, content.data, scene->measured.file, status);
    if (rc == STATUS_OK && !(out->load = malloc(3 * out->count * sizeof *out->load)))
        rc = status_memory(status);
    if (rc == STATUS_OK) {
        qsort(rows, out->count, sizeof *rows, compare_rows);
        out->resistance = out->load + out->count;
        out->error = out->resistance + out->count;
        for (size_t i = 0; i < out->count; i++) {
            out->load[i] = rows[i].value[0] * load_factor;
            out->resistance[i] = rows[i].value[1] * resistance_factor;
            out->error[i] = fabs(rows[i].value[2]) * resistance_factor;
        }
    }
    free(rows);
    free(path);
    text_free(&content);
    return rc;
}

void measured_free(struct measured *measured)
{
    free(measured->load);
    *measured = (struct measured){0};
}

/** The curve's resistance at a load, NaN outside its loads or where it is 0. */
static double resistance_at(const struct model_curve *curve, double load, bool thermal)
{
    for (size_t i = 1; i < curve->count; i++) {
        const struct contact_point *p = &curve->points[i - 1], *q = &curve->points[i];
        if (load < p->load || load > q->load)
            continue;
        double low = thermal ? p->tcr_K_m2_per_W : p->ecr_ohm_m2, high = thermal ? q->tcr_K_m2_per_W : q->ecr_ohm_m2;
        if (!(low > 0 && high > 0))
            return NAN;
        return low * pow(high / low, log(load / p->load) / log(q->load / p->load));
    }
    return NAN;
}

struct measured_distance measured_compare(const struct measured *measured, const struct model_curve *curve)
{
    struct measured_distance out = {0, NAN, NAN, {NAN, NAN}};
    double square = 0, sum = 0;
    for (size_t i = 0; i < measured->count; i++) {
        double model = resistance_at(curve, measured->load[i], measured->thermal);
        if (isnan(model))
            continue;
        double decades = log10(model / measured->resistance[i]);
        square += decades * decades;
        sum += decades;
        if (out.points == 0)
            out.load[0] = measured->load[i];
        out.load[1] = measured->load[i];
        out.points++;
    }
    if (out.points > 0) {
        out.rms_decades = sqrt(square / (double)out.points);
        out.bias_decades = sum / (double)out.points;
    }
    return out;
}
