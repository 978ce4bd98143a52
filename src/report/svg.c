#include "report/svg.h"

#include <ctype.h>
#include <string.h>

#define NAME_CHARS  "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._:-"
#define SPACE_CHARS " \t\r\n"
/* No quote, colon, slash, ampersand or backslash: no value made of these can name anything outside the page. */
#define VALUE_CHARS "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.,;#%()+-_" SPACE_CHARS

enum { SVG_DEPTH = 64, SVG_ATTRIBUTES = 48 };

struct slice {
    const char *data;
    size_t length;
};

struct attribute {
    struct slice name, value;
};

struct element {
    const char *name;
    bool holds_text;
};

static const struct element root_element = {"svg", false};
static const struct element elements[] = {
    {"g", false},       {"defs", false},   {"path", false},    {"rect", false},        {"circle", false},
    {"polygon", false}, {"use", false},    {"text", true},     {"tspan", true},        {"title", true},
    {"pattern", false}, {"filter", false}, {"feFlood", false}, {"feComposite", false},
};

/* attributes whose value is copied if it is made of VALUE_CHARS, each between blanks */
static const char plain_attributes[] =
    " class d points transform x y dx dy cx cy r width height opacity fill-opacity fill-rule stroke-width"
    " stroke-opacity stroke-dasharray stroke-linecap stroke-linejoin shape-rendering font-family font-size"
    " font-style font-weight text-anchor xml:space clip-path patternUnits filter filterUnits flood-opacity in"
    " in2 operator result ";

enum attribute_kind { SVG_DROPPED, SVG_PLAIN, SVG_COLOUR, SVG_ID, SVG_REFERENCE, SVG_STYLE };

/* and those whose value is changed */
static const struct {
    const char *name;
    enum attribute_kind kind;
} special_attributes[] = {
    {"id", SVG_ID},       {"href", SVG_REFERENCE}, {"xlink:href", SVG_REFERENCE}, {"style", SVG_STYLE},
    {"fill", SVG_COLOUR}, {"stroke", SVG_COLOUR},  {"color", SVG_COLOUR},         {"flood-color", SVG_COLOUR},
};

#define PAPER "var(--paper)"
#define INK   "var(--ink)"

/* colours of the paper print, without blanks, and what they are on the page */
static const struct {
    const char *colour, *page;
} page_colours[] = {
    {"#222222", INK},    {"rgb(34,34,34)", INK}, {"black", INK},   {"#000000", INK},
    {"rgb(0,0,0)", INK}, {"#ffffff", PAPER},     {"white", PAPER}, {"rgb(255,255,255)", PAPER},
};

struct drawing {
    struct text *out;
    size_t before;          /* length of `out` before the drawing */
    const char *start, *at; /* NUL-terminated */
    const char *path, *label;
    unsigned number;
    bool done; /* the root element has ended */
    size_t depth;
    struct {
        struct slice name;
        const struct element *element; /* NULL: left out, with all inside it */
    } open[SVG_DEPTH];
    struct status *status;
};

static enum status_code malformed(const struct drawing *drawing, const char *problem)
{
    size_t line = 1;
    for (const char *at = drawing->start; at < drawing->at; at++)
        line += *at == '\n';
    return status_fail(drawing->status, STATUS_IO, "%s:%zu: not a well-formed SVG drawing (%s): draw it again",
                       drawing->path, line, problem);
}

static bool slice_equal(struct slice a, struct slice b)
{
    return a.length == b.length && memcmp(a.data, b.data, a.length) == 0;
}

static bool slice_is(struct slice slice, const char *string)
{
    return slice_equal(slice, (struct slice){string, strlen(string)});
}

static struct slice slice_trimmed(struct slice slice)
{
    while (slice.length > 0 && strchr(SPACE_CHARS, slice.data[0])) {
        slice.data++;
        slice.length--;
    }
    while (slice.length > 0 && strchr(SPACE_CHARS, slice.data[slice.length - 1]))
        slice.length--;
    return slice;
}

/* Is the slice made of `allowed` only? It ends before a character that is not one of them, or at the string's end. */
static bool slice_made_of(struct slice slice, const char *allowed)
{
    return strspn(slice.data, allowed) >= slice.length;
}

static struct slice take(struct drawing *drawing, const char *chars)
{
    struct slice taken = {drawing->at, strspn(drawing->at, chars)};
    drawing->at += taken.length;
    return taken;
}

static const struct element *find_element(struct slice name)
{
    for (size_t i = 0; i < sizeof elements / sizeof *elements; i++)
        if (slice_is(name, elements[i].name))
            return &elements[i];
    return NULL;
}

/* The page's colour for one of the print's, or NULL. */
static const char *page_colour(struct slice value)
{
    char colour[24] = ""; /* longer than any of them */
    size_t length = 0;
    for (size_t i = 0; i < value.length && length + 1 < sizeof colour; i++)
        if (!strchr(SPACE_CHARS, value.data[i]))
            colour[length++] = value.data[i];
    for (size_t i = 0; i < sizeof page_colours / sizeof *page_colours; i++)
        if (strcasecmp(colour, page_colours[i].colour) == 0)
            return page_colours[i].page;
    return NULL;
}

static enum attribute_kind attribute_kind(struct slice name)
{
    for (size_t i = 0; i < sizeof special_attributes / sizeof *special_attributes; i++)
        if (slice_is(name, special_attributes[i].name))
            return special_attributes[i].kind;
    for (const char *at = plain_attributes; at[1] != '\0'; at += strcspn(at + 1, " ") + 1)
        if (slice_equal(name, (struct slice){at + 1, strcspn(at + 1, " ")}))
            return SVG_PLAIN;
    return SVG_DROPPED;
}

static const struct attribute *find_attribute(const struct attribute *attributes, size_t count, const char *name)
{
    for (size_t i = 0; i < count; i++)
        if (slice_is(attributes[i].name, name))
            return &attributes[i];
    return NULL;
}

static bool mentions_url(struct slice value)
{
    for (size_t i = 0; i + 3 <= value.length; i++)
        if (strncasecmp(value.data + i, "url", 3) == 0)
            return true;
    return false;
}

/* Writes name="before fig1.ID after" if what stands between the marks of a reference is an identifier. */
static void write_reference(const struct drawing *drawing, struct slice name, struct slice value, const char *before,
                            const char *after)
{
    size_t around = strlen(before) + strlen(after);
    if (value.length <= around || memcmp(value.data, before, strlen(before)) != 0 ||
        memcmp(value.data + value.length - strlen(after), after, strlen(after)) != 0)
        return;
    struct slice id = {value.data + strlen(before), value.length - around};
    if (slice_made_of(id, NAME_CHARS))
        text_add(drawing->out, " %.*s=\"%sfig%u.%.*s%s\"", (int)name.length, name.data, before, drawing->number,
                 (int)id.length, id.data, after);
}

static void write_value(const struct drawing *drawing, enum attribute_kind kind, struct slice name, struct slice value)
{
    value = slice_trimmed(value);
    if (mentions_url(value)) {
        write_reference(drawing, name, value, "url(#", ")");
        return;
    }
    const char *colour = kind == SVG_COLOUR ? page_colour(value) : NULL;
    if (colour)
        value = (struct slice){colour, strlen(colour)};
    else if (!slice_made_of(value, VALUE_CHARS))
        return;
    text_add(drawing->out, " %.*s=\"%.*s\"", (int)name.length, name.data, (int)value.length, value.data);
}

/* style='fill:none; stroke:red' is written as fill="none" stroke="red", by the rules of these attributes. */
static void write_style(const struct drawing *drawing, struct slice style)
{
    const char *at = style.data, *end = style.data + style.length;
    while (at < end) {
        const char *stop = memchr(at, ';', (size_t)(end - at));
        stop = stop ? stop : end;
        const char *colon = memchr(at, ':', (size_t)(stop - at));
        if (colon) {
            struct slice name = slice_trimmed((struct slice){at, (size_t)(colon - at)});
            enum attribute_kind kind = attribute_kind(name);
            if (kind == SVG_PLAIN || kind == SVG_COLOUR)
                write_value(drawing, kind, name, (struct slice){colon + 1, (size_t)(stop - colon - 1)});
        }
        at = stop + 1;
    }
}

/* The first of its name only: gnuplot repeats those of the curves when it draws an opaque key. */
static void write_id(const struct drawing *drawing, const struct attribute *id)
{
    struct text *out = drawing->out;
    size_t end = out->length;
    write_reference(drawing, id->name, id->value, "", "");
    if (out->length > end && strstr(out->data + drawing->before, out->data + end) < out->data + end) {
        out->length = end;
        text_add_bytes(out, "", 0);
    }
}

static void write_attribute(const struct drawing *drawing, const struct attribute *attribute)
{
    static const struct slice href = {"href", 4}; /* xlink: is not needed any more */
    enum attribute_kind kind = attribute_kind(attribute->name);
    if (kind == SVG_STYLE)
        write_style(drawing, attribute->value);
    else if (kind == SVG_ID)
        write_id(drawing, attribute);
    else if (kind == SVG_REFERENCE)
        write_reference(drawing, href, attribute->value, "#", "");
    else if (kind != SVG_DROPPED)
        write_value(drawing, kind, attribute->name, attribute->value);
}

static enum status_code read_attributes(struct drawing *drawing, struct attribute *attributes, size_t *count)
{
    for (*count = 0;; (*count)++) {
        struct slice space = take(drawing, SPACE_CHARS);
        if (*drawing->at == '>' || *drawing->at == '/')
            return STATUS_OK;
        if (space.length == 0 || *count == SVG_ATTRIBUTES)
            return malformed(drawing, space.length == 0 ? "a tag does not end" : "too many attributes");
        struct attribute *attribute = &attributes[*count];
        attribute->name = take(drawing, NAME_CHARS);
        take(drawing, SPACE_CHARS);
        if (attribute->name.length == 0 || *drawing->at != '=')
            return malformed(drawing, "an attribute has no name or no value");
        drawing->at++;
        take(drawing, SPACE_CHARS);
        const char quote[] = {*drawing->at, '<', '\0'};
        if (quote[0] != '"' && quote[0] != '\'')
            return malformed(drawing, "a value is not quoted");
        attribute->value = (struct slice){drawing->at + 1, strcspn(drawing->at + 1, quote)};
        if (attribute->value.data[attribute->value.length] != quote[0])
            return malformed(drawing, "a value does not end");
        drawing->at = attribute->value.data + attribute->value.length + 1;
    }
}

static enum status_code write_root(struct drawing *drawing, const struct attribute *attributes, size_t count)
{
    const struct attribute *view = find_attribute(attributes, count, "viewBox");
    if (!view || !slice_made_of(view->value, "0123456789.- "))
        return malformed(drawing, "it has no viewBox");
    text_add(drawing->out, "<svg viewBox=\"%.*s\" role=\"img\" aria-label=\"%s\"", (int)view->value.length,
             view->value.data, drawing->label);
    return STATUS_OK;
}

/* The element to write, or NULL to leave it out with all inside it. */
static const struct element *kept_element(const struct drawing *drawing, struct slice name,
                                          const struct attribute *attributes, size_t count)
{
    const struct element *parent = drawing->open[drawing->depth - 1].element;
    const struct element *element = find_element(name);
    if (!parent || !element || strcmp(parent->name, "title") == 0)
        return NULL;
    if (drawing->depth == 1 && slice_is(name, "title")) /* gnuplot's name: the caption says what the drawing is */
        return NULL;
    const struct attribute *fill = find_attribute(attributes, count, "fill");
    const char *colour = fill && slice_is(name, "rect") ? page_colour(fill->value) : NULL;
    return colour && strcmp(colour, PAPER) == 0 ? NULL : element; /* a rectangle of paper is the background */
}

static enum status_code start_tag(struct drawing *drawing)
{
    struct attribute attributes[SVG_ATTRIBUTES];
    size_t count;
    drawing->at++;
    struct slice name = take(drawing, NAME_CHARS);
    if (name.length == 0 || drawing->done)
        return malformed(drawing, name.length == 0 ? "a tag has no name" : "something follows the drawing");
    if (read_attributes(drawing, attributes, &count) != STATUS_OK)
        return drawing->status->code;

    const struct element *element = &root_element;
    if (drawing->depth > 0) {
        element = kept_element(drawing, name, attributes, count);
        if (element)
            text_add(drawing->out, "<%s", element->name);
        for (size_t i = 0; element && i < count; i++)
            write_attribute(drawing, &attributes[i]);
    } else if (!slice_is(name, "svg"))
        return malformed(drawing, "it does not begin with <svg>");
    else if (write_root(drawing, attributes, count) != STATUS_OK)
        return drawing->status->code;

    bool closed = *drawing->at == '/';
    drawing->at += closed;
    if (*drawing->at != '>' || drawing->depth == SVG_DEPTH)
        return malformed(drawing, *drawing->at != '>' ? "a tag does not end" : "nested too deep");
    drawing->at++;
    if (element)
        text_add(drawing->out, closed ? "/>" : ">");
    if (!closed) {
        drawing->open[drawing->depth].name = name;
        drawing->open[drawing->depth++].element = element;
    }
    drawing->done = drawing->depth == 0;
    return STATUS_OK;
}

static enum status_code end_tag(struct drawing *drawing)
{
    drawing->at += 2;
    struct slice name = take(drawing, NAME_CHARS);
    take(drawing, SPACE_CHARS);
    if (*drawing->at != '>' || drawing->depth == 0)
        return malformed(drawing, "an end tag without its start");
    if (!slice_equal(name, drawing->open[--drawing->depth].name))
        return malformed(drawing, "an end tag does not match its start");
    drawing->at++;
    if (drawing->open[drawing->depth].element)
        text_add(drawing->out, "</%.*s>", (int)name.length, name.data);
    drawing->done = drawing->depth == 0;
    return STATUS_OK;
}

static enum status_code markup(struct drawing *drawing)
{
    static const struct {
        const char *open, *close;
    } dropped[] = {{"<!--", "-->"}, {"<?", "?>"}, {"<![CDATA[", "]]>"}, {"<!DOCTYPE", ">"}};
    for (size_t i = 0; i < sizeof dropped / sizeof *dropped; i++) {
        if (strncmp(drawing->at, dropped[i].open, strlen(dropped[i].open)) != 0)
            continue;
        const char *end = strstr(drawing->at + strlen(dropped[i].open), dropped[i].close);
        if (!end)
            return malformed(drawing, "a comment or declaration does not end");
        drawing->at = end + strlen(dropped[i].close);
        return STATUS_OK;
    }
    return drawing->at[1] == '/' ? end_tag(drawing) : start_tag(drawing);
}

/* Text counts only in elements that show it. An ampersand stays one unless it begins a character reference. */
static void write_text(struct drawing *drawing, size_t length)
{
    const struct element *element = drawing->depth > 0 ? drawing->open[drawing->depth - 1].element : NULL;
    for (const char *end = drawing->at + length; drawing->at < end; drawing->at++) {
        unsigned char c = (unsigned char)*drawing->at;
        if (!element || !element->holds_text || (c < 0x20 && !isspace(c)))
            continue;
        size_t reference = strspn(drawing->at + 1, "#abcdefghijklmnopqrstuvwxyzABCDEF0123456789");
        if (c == '&' && (reference == 0 || drawing->at[1 + reference] != ';'))
            text_add(drawing->out, "&amp;");
        else
            text_add_bytes(drawing->out, drawing->at, 1);
    }
}

enum status_code svg_inline(struct text *out, const struct text *svg, const char *path, unsigned number,
                            const char *label, struct status *status)
{
    struct drawing drawing = {.out = out,
                              .before = out->length,
                              .path = path,
                              .label = label,
                              .number = number,
                              .status = status,
                              .start = text_string(svg),
                              .at = text_string(svg)};
    while (*drawing.at != '\0') {
        write_text(&drawing, strcspn(drawing.at, "<"));
        if (*drawing.at == '<' && markup(&drawing) != STATUS_OK)
            return status->code;
    }
    if (!drawing.done || (size_t)(drawing.at - drawing.start) != svg->length)
        return malformed(&drawing, "it breaks off");
    return out->failed ? status_memory(status) : STATUS_OK;
}
