/* main.xml of an X3P archive (ISO 25178-72). */
#ifndef SCAN_X3P_XML_H
#define SCAN_X3P_XML_H

#include "base/text.h"
#include "scan/bytes.h"

struct x3p_axis {
    char kind; /* 'I': increment x index, 'A': stored for each point */
    char type; /* of stored values: 'I' int16, 'L' int32, 'F' float, 'D' double */
    double increment, offset;
};

struct x3p_xml {
    char feature[8]; /* PRF, SUR or PCL */
    struct x3p_axis axis[3];
    double size[3]; /* of the matrix; 0 where there is none */
    double list;    /* points of a list; 0 where there is none */
    char data_link[256], valid_link[256];
    char data_md5[40];
    double *datum; /* datum_count x {x, z} of <DataList>, x 0 where it is not stored; NaN: missing */
    size_t datum_count, datum_capacity;
};

/** `out` is to be freed with x3p_xml_free() whatever comes back. */
MUST_CHECK enum status_code x3p_xml_read(struct x3p_xml *out, const struct text *xml, const struct scan_bytes *file,
                                         struct status *status);
void x3p_xml_free(struct x3p_xml *xml);

#endif
