/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "library/library.h"

#include <stdlib.h>
#include <string.h>

int roughcontact_material_new(struct roughcontact_material **out, const char *name, struct roughcontact_status *status)
{
    struct host host;
    struct status problem = {0};
    host_put_aside(&host);
    const struct material *found = name ? material_find(name) : NULL;
    *out = NULL;
    if (name && !found)
        (void)status_fail(&problem, STATUS_USAGE,
                          "unknown material '%.60s'; `roughcontact materials` lists those that are known", name);
    else if (!(*out = malloc(sizeof **out)))
        (void)status_memory(&problem);
    else
        (*out)->material = found ? *found : material_unknown("");
    return library_end(&host, &problem, status);
}

int roughcontact_material_set(struct roughcontact_material *material, const char *key, double value,
                              struct roughcontact_status *status)
{
    struct host host;
    struct status problem = {0};
    const struct material_property *property = key ? material_property_find(key) : NULL;
    host_put_aside(&host);
    if (!material)
        (void)status_fail(&problem, STATUS_USAGE, "no material is given");
    else if (!property)
        (void)status_fail(&problem, STATUS_USAGE,
                          "no property is called '%.60s'; `roughcontact materials --json` has those that are known",
                          key ? key : "");
    else if (!(value >= property->least && value <= property->most))
        (void)status_fail(&problem, STATUS_USAGE, "%s is %g; allowed is %g to %g", key, value, property->least,
                          property->most);
    else
        memcpy((char *)&material->material + property->offset, &value, sizeof value);
    return library_end(&host, &problem, status);
}

void roughcontact_material_free(struct roughcontact_material *material)
{
    free(material);
}
