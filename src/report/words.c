#include "report/words.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

void words_number(struct text *out, double value, int digits)
{
    static const char *const superscripts[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    char buffer[64];
    if (!isfinite(value)) {
        text_add(out, "–");
        return;
    }
    snprintf(buffer, sizeof buffer, "%.*e", digits - 1, value);
    char *exponent_text = strchr(buffer, 'e');
    int exponent;
    if (value == 0 || !exponent_text || sscanf(exponent_text, "e%d", &exponent) != 1) {
        text_add(out, "0");
        return;
    }
    if (exponent >= -3 && exponent <= 3) {
        int decimals = digits - 1 - exponent;
        text_add(out, "%s%.*f", value < 0 ? "−" : "", decimals > 0 ? decimals : 0, fabs(value));
        return;
    }
    *exponent_text = '\0';
    text_add(out, "%s%s·10%s", value < 0 ? "−" : "", buffer + (value < 0), exponent < 0 ? "⁻" : "");
    snprintf(buffer, sizeof buffer, "%d", exponent < 0 ? -exponent : exponent);
    for (const char *digit = buffer; *digit; digit++)
        text_add(out, "%s", superscripts[*digit - '0']);
}

void words_surface(struct text *out, const struct results *results, size_t index)
{
    text_add_markdown(out, results->spool->summaries[index].scene->name);
}

void words_range(struct text *out, double least, double most, int digits)
{
    struct text low = {0}, high = {0};
    words_number(&low, least, digits);
    words_number(&high, most, digits);
    text_add(out, "%s", text_string(&low));
    if (strcmp(text_string(&low), text_string(&high)) != 0)
        text_add(out, " to %s", text_string(&high));
    text_free(&low);
    text_free(&high);
}
