/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "report/svg.h"

#include "report/html.h"

#include <expat.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>

#define NAME_CHARS "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._:-"
/* No quote, colon, slash, ampersand or backslash: no value made of these can name anything outside the page. */
#define VALUE_CHARS "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.,;#%()+-_ "

enum { SVG_DEPTH = 64 };

/* What is kept, each name between blanks: elements, those of them whose text shows, attributes whose value is copied if
 * it is made of VALUE_CHARS, and those that hold a colour. Besides these there are id and href. */
static const char elements[] =
    " g defs path rect circle polygon use text tspan title pattern filter feFlood feComposite ";
static const char text_elements[] = " text tspan title ";
static const char plain_attributes[] =
    " class d points transform x y dx dy cx cy r width height opacity fill-opacity fill-rule stroke-width"
    " stroke-opacity stroke-dasharray stroke-linecap stroke-linejoin shape-rendering font-family font-size"
    " font-style font-weight text-anchor xml:space clip-path patternUnits filter filterUnits flood-opacity in"
    " in2 operator result ";
static const char colour_attributes[] = " fill stroke color flood-color ";

#define PAPER "var(--paper)"
#define INK   "var(--ink)"

/* colours of the paper print, without blanks, and what they are on the page */
static const struct {
    const char *colour, *page;
} page_colours[] = {
    {"#222222", INK},    {"rgb(34,34,34)", INK}, {"black", INK},   {"#000000", INK},
    {"rgb(0,0,0)", INK}, {"#ffffff", PAPER},     {"white", PAPER}, {"rgb(255,255,255)", PAPER},
};

/* the call by which gnuplot's own page would show a point's text, which stands between these */
static const char hypertext_start[] = "gnuplot_svg.showHypertext(evt,'", hypertext_end[] = "')";

struct drawing {
    struct text *out;
    struct svg_curves *curves;
    unsigned plot;      /* depth inside the group of a plotted curve, 0 outside */
    bool takes_title;   /* the next title is that group's */
    bool in_plot_title; /* it is open */
    bool titled;        /* the open element has been given a title */
    struct text name;   /* the plotted curve's as the legend has it; empty: it stands in none */

    size_t before; /* length of `out` before the drawing */
    const char *label;
    unsigned number;
    unsigned depth; /* kept elements that are open */
    struct {
        size_t start, inside; /* length of `out` before and behind its tag */
        bool named;           /* it has an id */
    } open[SVG_DEPTH + 1];
    unsigned texts;  /* those of them whose text shows */
    unsigned hidden; /* the outermost open element that is left out, and all open inside it */
    bool in_title;
    const char *problem; /* NULL, or why parsing was stopped */
    XML_Parser parser;
};

static void stop(struct drawing *drawing, const char *problem)
{
    drawing->problem = problem;
    XML_StopParser(drawing->parser, XML_FALSE);
}

/* Is the XML name, which holds no blank, in the list? */
static bool listed(const char *list, const char *name)
{
    for (const char *at = strstr(list, name); at; at = strstr(at + 1, name))
        if (at[-1] == ' ' && at[strlen(name)] == ' ')
            return true;
    return false;
}

/* The page's colour for one of the print's, or NULL. */
static const char *page_colour(const char *value)
{
    char colour[24] = ""; /* longer than any of them */
    size_t length = 0;
    for (; *value && length + 1 < sizeof colour; value++)
        if (*value != ' ')
            colour[length++] = *value;
    for (size_t i = 0; i < sizeof page_colours / sizeof *page_colours; i++)
        if (strcasecmp(colour, page_colours[i].colour) == 0)
            return page_colours[i].page;
    return NULL;
}

/* Reads "#1257d0" or "rgb(18, 87, 208)". */
static bool read_colour(unsigned *rgb, const char *value)
{
    int end = 0;
    unsigned red, green, blue;
    if (sscanf(value, "#%2x%2x%2x%n", &red, &green, &blue, &end) != 3 &&
        sscanf(value, "rgb( %u , %u , %u )%n", &red, &green, &blue, &end) != 3)
        return false;
    *rgb = red << 16 | green << 8 | blue;
    return end > 0 && value[end] == '\0' && (*value != '#' || end == 7) && red < 256 && green < 256 && blue < 256;
}

/* Writes name="before fig1.ID after" if what stands between the marks of a reference is an identifier. */
static void write_reference(const struct drawing *drawing, const char *name, const char *value, const char *before,
                            const char *after)
{
    if (strncmp(value, before, strlen(before)) != 0)
        return;
    const char *id = value + strlen(before);
    size_t length = strspn(id, NAME_CHARS);
    if (length > 0 && strcmp(id + length, after) == 0)
        text_add(drawing->out, " %s=\"%sfig%u.%.*s%s\"", name, before, drawing->number, (int)length, id, after);
}

/* The first of its name only: gnuplot repeats those of the curves when it draws an opaque key. */
static void write_id(const struct drawing *drawing, const char *id)
{
    struct text *out = drawing->out;
    size_t end = out->length;
    write_reference(drawing, "id", id, "", "");
    if (out->length > end && strstr(out->data + drawing->before, out->data + end) < out->data + end) {
        out->length = end;
        text_add_bytes(out, "", 0);
    }
}

static void write_attribute(const struct drawing *drawing, const char *name, const char *value)
{
    const char *colour = listed(colour_attributes, name) ? page_colour(value) : NULL;
    unsigned rgb;
    if (strcmp(name, "id") == 0)
        write_id(drawing, value);
    else if (strcmp(name, "href") == 0 || strcmp(name, "xlink:href") == 0) /* xlink: is not needed any more */
        write_reference(drawing, "href", value, "#", "");
    else if (!colour && !listed(colour_attributes, name) && !listed(plain_attributes, name))
        return;
    else if (!colour && listed(colour_attributes, name) && read_colour(&rgb, value)) /* the page may have its own */
        text_add(drawing->out, " %s=\"var(--%06x,#%06x)\"", name, rgb, rgb);
    else if (strcasestr(value, "url"))
        write_reference(drawing, name, value, "url(#", ")");
    else if (colour || value[strspn(value, VALUE_CHARS)] == '\0')
        text_add(drawing->out, " %s=\"%s\"", name, colour ? colour : value);
}

/* Number of a colour among those of the curves, 1 and up; 0 for greys, which are nobody's own, and for what is none. */
static unsigned curve_colour(struct drawing *drawing, const char *value)
{
    struct svg_curves *curves = drawing->curves;
    unsigned colour;
    if (!read_colour(&colour, value) || ((colour >> 16) == (colour & 255) && (colour >> 8 & 255) == (colour & 255)))
        return 0;
    for (unsigned i = 0; i < curves->count; i++)
        if (curves->curve[i].colour == colour)
            return i + 1;
    if (curves->count == SVG_CURVES)
        return 0;
    curves->curve[curves->count++].colour = colour;
    return curves->count;
}

/* In a plotted curve: the class of its colour, by which the page can hide it; its name is noted with the colour. A
 * group's colour says nothing: it is the one that was drawn with last. */
static void write_curve(struct drawing *drawing, const char *element, const XML_Char **attributes)
{
    bool drawn = drawing->plot > 0 && strcmp(element, "g") != 0;
    for (; drawn && *attributes; attributes += 2) {
        unsigned number = listed(colour_attributes, attributes[0]) ? curve_colour(drawing, attributes[1]) : 0;
        if (number == 0)
            continue;
        struct text *name = &drawing->curves->curve[number - 1].name;
        text_add(drawing->out, " class=\"curve%u\"", number);
        if (name->length == 0)
            text_add_bytes(name, text_string(&drawing->name), drawing->name.length);
        return;
    }
}

/* What a point says when it is pointed at. */
static void write_hypertext(struct drawing *drawing, const XML_Char **attributes)
{
    for (drawing->titled = false; *attributes; attributes += 2) {
        const char *value = attributes[1], *end = value + strlen(value) - strlen(hypertext_end);
        if (strcmp(attributes[0], "onmousemove") != 0 || strncmp(value, hypertext_start, strlen(hypertext_start)) != 0)
            continue;
        value += strlen(hypertext_start);
        if (end < value || strcmp(end, hypertext_end) != 0)
            continue;
        text_add(drawing->out, "<title>");
        text_add_html(drawing->out, value, (size_t)(end - value));
        text_add(drawing->out, "</title>");
        drawing->titled = true;
    }
}

static const char *find_attribute(const XML_Char **attributes, const char *name)
{
    while (*attributes && strcmp(*attributes, name) != 0)
        attributes += 2;
    return *attributes ? attributes[1] : NULL;
}

static void write_root(struct drawing *drawing, const char *name, const XML_Char **attributes)
{
    const char *view = find_attribute(attributes, "viewBox");
    if (strcmp(name, "svg") != 0)
        stop(drawing, "it does not begin with <svg>");
    else if (!view || view[strspn(view, "0123456789.- ")] != '\0')
        stop(drawing, "it has no viewBox");
    else
        text_add(drawing->out, "<svg viewBox=\"%s\" role=\"img\" aria-label=\"%s\">", view, drawing->label);
}

/* Does the element stand on the page? If not, it is left out with all inside it. */
static bool is_kept(const struct drawing *drawing, const char *name, const XML_Char **attributes)
{
    if (drawing->hidden > 0 || drawing->in_title || !listed(elements, name))
        return false;
    if (drawing->depth == 1 && strcmp(name, "title") == 0) /* gnuplot's name: the caption says what the drawing is */
        return false;
    if (drawing->titled && strcmp(name, "title") == 0)
        return false;
    const char *fill = find_attribute(attributes, "fill");
    const char *colour = fill && strcmp(name, "rect") == 0 ? page_colour(fill) : NULL;
    return !colour || strcmp(colour, PAPER) != 0; /* a rectangle of paper is the background */
}

/* Gnuplot draws each curve in a group of its own, whose title is the legend's entry, else its id again. */
static void enter_plot(struct drawing *drawing, const char *element, const char *id)
{
    static const char plot[] = "gnuplot_plot_";
    drawing->in_plot_title = drawing->takes_title && strcmp(element, "title") == 0;
    drawing->takes_title = false;
    if (drawing->plot > 0)
        drawing->plot++;
    else if (id && strncmp(id, plot, strlen(plot)) == 0) {
        drawing->plot = 1;
        drawing->takes_title = true;
        text_free(&drawing->name);
    }
}

static void XMLCALL on_start(void *user, const XML_Char *name, const XML_Char **attributes)
{
    struct drawing *drawing = user;
    const XML_Char **all = attributes;
    size_t start = drawing->out->length;
    if (drawing->depth == 0)
        write_root(drawing, name, attributes);
    else if (!is_kept(drawing, name, attributes)) {
        drawing->hidden++;
        return;
    } else {
        text_add(drawing->out, "<%s", name);
        for (; *attributes; attributes += 2)
            write_attribute(drawing, attributes[0], attributes[1]);
        write_curve(drawing, name, all);
        text_add(drawing->out, ">");
        write_hypertext(drawing, all);
    }
    enter_plot(drawing, name, find_attribute(all, "id"));
    drawing->open[drawing->depth].start = start;
    drawing->open[drawing->depth].inside = drawing->out->length;
    drawing->open[drawing->depth].named = find_attribute(all, "id") != NULL;
    drawing->texts += listed(text_elements, name);
    drawing->in_title = strcmp(name, "title") == 0;
    if (++drawing->depth > SVG_DEPTH)
        stop(drawing, "nested too deep");
}

static void XMLCALL on_end(void *user, const XML_Char *name)
{
    struct drawing *drawing = user;
    struct text *out = drawing->out;
    if (drawing->problem || out->failed)
        return;
    if (drawing->hidden > 0) {
        drawing->hidden--;
        return;
    }
    drawing->depth--;
    bool short_form = XML_GetCurrentByteCount(drawing->parser) == 0; /* <name/> */
    bool empty = out->length == drawing->open[drawing->depth].inside && !drawing->open[drawing->depth].named;
    if (empty && !short_form && drawing->depth > 0 && strcmp(name, "g") == 0) { /* gnuplot leaves many */
        out->length = drawing->open[drawing->depth].start;
        text_add_bytes(out, "", 0);
    } else if (short_form && !drawing->titled) { /* just begun */
        out->length--;
        text_add(out, "/>");
    } else
        text_add(out, "</%s>", name);
    drawing->plot -= drawing->plot > 0;
    drawing->in_plot_title = false;
    drawing->texts -= listed(text_elements, name);
    drawing->in_title = false;
}

static void XMLCALL on_text(void *user, const XML_Char *text, int length)
{
    struct drawing *drawing = user;
    if (drawing->texts > 0 && drawing->hidden == 0)
        text_add_html(drawing->out, text, (size_t)length);
    if (drawing->in_plot_title && (drawing->name.length > 0 || strncmp(text, "gnuplot_plot_", 13) != 0))
        text_add_html(&drawing->name, text, (size_t)length);
}

/* Gnuplot declares no entities; files that do want to make little bytes large. */
static void XMLCALL on_doctype(void *user, const XML_Char *name, const XML_Char *system, const XML_Char *public,
                               int has_declarations)
{
    (void)name, (void)system, (void)public;
    if (has_declarations)
        stop(user, "a declaration inside its DOCTYPE");
}

/* Gnuplot leaves a name's "]]>" as it is, which XML does not allow in text. */
static void add_repaired(struct text *out, const struct text *svg)
{
    const char *at = text_string(svg), *end = at + svg->length;
    for (const char *mark; (mark = memmem(at, (size_t)(end - at), "]]>", 3)); at = mark + 3) {
        text_add_bytes(out, at, (size_t)(mark - at));
        text_add(out, "]]&gt;");
    }
    text_add_bytes(out, at, (size_t)(end - at));
}

enum status_code svg_inline(struct text *out, const struct text *svg, const char *path, unsigned number,
                            const char *label, struct svg_curves *curves, struct status *status)
{
    struct text repaired = {0};
    struct drawing drawing = {.out = out, .curves = curves, .before = out->length, .label = label, .number = number};
    enum status_code code = STATUS_OK;
    add_repaired(&repaired, svg);
    drawing.parser = XML_ParserCreate("UTF-8"); /* whatever the file says */
    if (!drawing.parser || repaired.failed || repaired.length > INT_MAX)
        code = status_memory(status);
    else {
        XML_SetUserData(drawing.parser, &drawing);
        XML_SetElementHandler(drawing.parser, on_start, on_end);
        XML_SetCharacterDataHandler(drawing.parser, on_text);
        XML_SetStartDoctypeDeclHandler(drawing.parser, on_doctype);
        enum XML_Status good = XML_Parse(drawing.parser, text_string(&repaired), (int)repaired.length, XML_TRUE);
        enum XML_Error error = XML_GetErrorCode(drawing.parser);
        if (out->failed || error == XML_ERROR_NO_MEMORY)
            code = status_memory(status);
        else if (good != XML_STATUS_OK)
            code = status_fail(status, STATUS_IO, "%s:%lu: not a well-formed SVG drawing (%s): draw it again", path,
                               (unsigned long)XML_GetCurrentLineNumber(drawing.parser),
                               drawing.problem ? drawing.problem : XML_ErrorString(error));
    }
    XML_ParserFree(drawing.parser);
    text_free(&repaired);
    text_free(&drawing.name);
    return code;
}

void svg_curves_free(struct svg_curves *curves)
{
    for (unsigned i = 0; i < curves->count; i++)
        text_free(&curves->curve[i].name);
    curves->count = 0;
}
