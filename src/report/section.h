/* The computed parts of the report: one function a field of templates/report.md. */
#ifndef REPORT_SECTION_H
#define REPORT_SECTION_H

#include "report/study.h"

/** What the sections are written from. */
struct section_context {
    const struct results *results;
    const struct study *study;
    const struct surface_record *baseline;
};

struct section_row {
    const char *name; /* as in the template */
    void (*write)(struct text *out, const struct section_context *context);
};

/** Tables and lists of fields, each ended by a row without a name. */
extern const struct section_row section_tables[];
extern const struct section_row section_prose[];
extern const struct section_row section_cost[];

#endif
