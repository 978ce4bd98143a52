/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "report/report.h"

#include "base/mustache.h"
#include "output/json.h"

#include <ctype.h>
#include <limits.h>
#include <md4c-html.h>
#include <nettle/base64.h>
#include <string.h>

/* md4c renders the Markdown. As raw HTML is no HTML to it, each `<` of what comes out begins a tag of its own making:
 * those of which more is made here are replaced, the others and the words between them copied. A paragraph's tag waits
 * for its first words: one of charts alone is their figures. */

struct page {
    struct text *body, *contents;
    const char *directory;
    unsigned headings;    /* so far: their ids */
    unsigned parts;       /* those of the first level: below the second, sections are folded */
    bool in_folded;       /* inside the <details> of a section */
    bool in_entry;        /* inside a heading that stands in the contents */
    size_t named;         /* where the words of the heading, or of a bold cell, begin in the body; 0: none */
    bool paragraph_waits; /* its words are still to come */
    bool cell_waits;      /* a cell of a table, the same */
    bool in_verdict;      /* inside the <span> of a cell that judges */
    bool in_link;         /* inside a link that was kept */
    struct status *status;
};

static bool starts(const char *html, const char *beginning)
{
    return strncmp(html, beginning, strlen(beginning)) == 0;
}

/* What a cell that begins with a mark says of a limit; page.html has colours for it, beside the mark's words. */
static const struct {
    const char *mark, *start;
} verdicts[] = {
    {"✓", "<span class=\"met\">"},
    {"✗", "<span class=\"missed\">"},
    {"? ", "<span class=\"untold\">"},
};

/* Before the first words of a paragraph or cell, which begin so; "<": with a tag. */
static void begin_words(struct page *page, const char *words)
{
    if (page->paragraph_waits)
        text_add(page->body, "<p>");
    for (size_t i = 0; page->cell_waits && i < sizeof verdicts / sizeof *verdicts; i++)
        if (starts(words, verdicts[i].mark)) {
            text_add(page->body, "%s", verdicts[i].start);
            page->in_verdict = true;
        }
    page->paragraph_waits = page->cell_waits = false;
}

static const char fold_end[] = "</details>\n";

static void start_heading(struct page *page, unsigned level)
{
    page->parts += level == 1;
    page->headings++;
    if (page->in_folded && level <= 2) {
        text_add(page->body, "%s", fold_end);
        page->in_folded = false;
    }
    bool folds = level == 2 && page->parts > 1;
    page->in_folded |= folds;
    page->in_entry = level == 2 || (level == 1 && page->parts > 1);
    text_add(page->body, "%s<h%u id=\"section-%u\">", folds ? "<details class=\"folded\"><summary>" : "", level,
             page->headings);
    if (page->in_entry)
        text_add(page->contents, "<li><a href=\"#section-%u\">", page->headings);
    page->named = page->body->length;
}

void html_anchor(struct text *out, const char *heading)
{
    bool tag = false;
    for (const char *at = heading; *at; at++) {
        tag = *at == '<' || (tag && at[-1] != '>');
        if (!tag && (isalnum((unsigned char)*at) || *at == ' ' || *at == '-'))
            text_add(out, "%c", *at == ' ' ? '-' : tolower((unsigned char)*at));
    }
}

/* Names what links lead to by its words. */
static void add_anchor(struct page *page)
{
    OWNED(text_free) struct text anchor = {0};
    html_anchor(&anchor, text_string(page->body) + page->named);
    text_add(page->body, "<a id=\"%s\"></a>", text_string(&anchor));
    page->named = 0;
}

static void end_heading(struct page *page, unsigned level)
{
    if (page->in_entry)
        add_anchor(page);
    text_add(page->body, "</h%u>%s", level, page->in_folded && level == 2 ? "</summary>" : "");
    if (page->in_entry)
        text_add(page->contents, "</a></li>\n");
    page->in_entry = false;
    page->named = 0;
}

/* In base 64 (RFC 4648). */
static void add_base64(struct text *out, const unsigned char *bytes, size_t length)
{
    enum { PIECE = 48 }; /* bytes, in threes */
    char digits[BASE64_ENCODE_RAW_LENGTH(PIECE)];
    for (size_t at = 0; at < length; at += PIECE) {
        size_t count = length - at < PIECE ? length - at : PIECE;
        base64_encode_raw(digits, count, bytes + at);
        text_add_bytes(out, digits, BASE64_ENCODE_RAW_LENGTH(count));
    }
}

/* The chart's file name, or NULL for a picture that is none of the report's charts. */
static const char *chart_name(const char *source)
{
    static const char directory[] = "figures/";
    if (strncmp(source, directory, strlen(directory)) != 0)
        return NULL;
    const char *name = source + strlen(directory);
    size_t length = strspn(name, "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._-");
    return name[length] == '\0' && length > 4 && strcmp(name + length - 4, ".svg") == 0 ? name : NULL;
}

/* A chart stands where its image does, as a picture in which nothing can act, whatever names it holds; outside of words
 * it is a figure with its caption. Of anything else only the words remain, as the page may not refer to other files. */
static void add_image(struct page *page, const char *source, const char *label)
{
    const char *name = chart_name(source);
    OWNED(text_free) struct text path = {0}, drawing = {0};
    struct text *out = page->body;
    if (!name) {
        begin_words(page, label);
        text_add(out, "%s", label);
        return;
    }
    text_add(&path, "%s/figures/%s", page->directory, name);
    if (text_read_file(&drawing, text_string(&path), page->status) == STATUS_OK) {
        text_add(out, "%s<img alt=\"%s\" src=\"data:image/svg+xml;base64,", page->paragraph_waits ? "<figure>\n" : "",
                 label);
        add_base64(out, (const unsigned char *)text_string(&drawing), drawing.length);
        text_add(out, "\">");
        if (page->paragraph_waits)
            text_add(out, "\n<figcaption>%s</figcaption>\n</figure>", label);
    }
}

/* May a link lead there? Within the page or report, or by a scheme that only opens a page or a letter; nowhere where
 * characters stand as references, behind which a scheme could hide. */
static bool link_allowed(const char *target)
{
    static const char *const schemes[] = {"http:", "https:", "mailto:"};
    for (const char *at = target; (at = strchr(at, '&')); at++)
        if (!starts(at, "&amp;"))
            return false;
    if (target[strcspn(target, ":/?#")] != ':')
        return *target && !starts(target, "//");
    for (size_t i = 0; i < sizeof schemes / sizeof *schemes; i++)
        if (strncasecmp(target, schemes[i], strlen(schemes[i])) == 0)
            return true;
    return false;
}

/* The value of the tag's attribute, escaped as it stands there. */
static struct text value_of(const char *tag, const char *attribute)
{
    struct text value = {0};
    const char *start = strstr(tag, attribute) + strlen(attribute);
    text_add_bytes(&value, start, strcspn(start, "\""));
    return value;
}

static void add_tag(struct page *page, const char *tag, size_t size)
{
    bool closes = tag[1] == '/', waits = page->paragraph_waits;
    const char *name = tag + 1 + closes;
    OWNED(text_free) struct text target = {0}, label = {0};
    struct text *out = page->body;
    const bool names = page->cell_waits && starts(tag, "<strong>"); /* a cell in bold, as a heading */
    if (!starts(name, "p>") && !starts(tag, "<img "))
        begin_words(page, tag);
    page->cell_waits = starts(tag, "<td");
    if (starts(tag, "</td>") && page->named > 0)
        add_anchor(page);
    if (starts(name, "p>")) {
        page->paragraph_waits = !closes;
        text_add(out, "%s", closes && !waits ? "</p>" : "");
    } else if (starts(tag, "<img ")) {
        target = value_of(tag, " src=\"");
        label = value_of(tag, " alt=\"");
        add_image(page, text_string(&target), text_string(&label));
    } else if (starts(tag, "<a ")) {
        target = value_of(tag, " href=\"");
        page->in_link = link_allowed(text_string(&target));
        if (page->in_link)
            text_add(out, "<a href=\"%s\">", text_string(&target));
    } else if (starts(tag, "</a>")) {
        text_add(out, "%s", page->in_link ? "</a>" : "");
        page->in_link = false; /* md4c ends a link twice whose words hold an image within an image's */
    } else if (*name == 'h' && name[1] >= '1' && name[1] <= '6') {
        (closes ? end_heading : start_heading)(page, (unsigned)(name[1] - '0'));
    } else if (starts(tag, "</td>")) {
        text_add(out, "%s</td>", page->in_verdict ? "</span>" : "");
        page->in_verdict = false;
    } else if (starts(tag, "<code ")) { /* of a language, which nobody colours */
        text_add(out, "<code>");
    } else if (starts(name, "table>")) {
        text_add(out, "%s", closes ? "</table></div>" : "<div class=\"table\" tabindex=\"0\"><table>");
    } else {
        text_add_bytes(out, tag, size);
    }
    page->named = names ? out->length : page->named;
}

/* Adds what md4c makes of the Markdown. */
static void add_body(struct page *page, const char *html)
{
    for (size_t size; *html && page->status->code == STATUS_OK; html += size) {
        size = *html == '<' ? strcspn(html, ">") + 1 : strcspn(html, "<");
        if (*html == '<') {
            add_tag(page, html, size);
            continue;
        }
        if (*html != '\n' || size > 1) /* else the end of a line between blocks or figures */
            begin_words(page, html);
        text_add_bytes(page->body, html, size);
        if (page->in_entry)
            text_add_bytes(page->contents, html, size);
    }
    text_add(page->body, "%s", page->in_folded ? fold_end : "");
}

/* Takes over a piece of what md4c makes. */
static void add_piece(const MD_CHAR *bytes, MD_SIZE size, void *html)
{
    text_add_bytes(html, bytes, size);
}

/* Writes out what may not be shown. */
static struct text shown_markdown(const char *markdown)
{
    struct text shown = {0};
    while (*markdown) {
        bool plain = strchr("\\\n\r\t", *markdown); /* a backslash is Markdown's */
        struct text_shown here = text_show(markdown);
        text_add_bytes(&shown, plain ? markdown : here.text, plain ? 1 : strlen(here.text));
        markdown += here.bytes;
    }
    return shown;
}

static void escape_html(struct text *out, const char *string)
{
    text_add_html(out, string, strlen(string));
}

enum status_code html_render(struct text *out, const char *markdown, const char *title, const char *directory,
                             const char *templates, struct status *status)
{
    OWNED(text_free) struct text shown = shown_markdown(markdown), html = {0}, body = {0}, contents = {0};
    struct page page = {.body = &body, .contents = &contents, .directory = directory, .status = status};
    OWNED(mustache_folder_free) struct mustache_folder folder = {templates, ".html", NULL, status};
    json_auto_t *view = NULL;
    if (shown.length <= UINT_MAX && md_html(text_string(&shown), (MD_SIZE)shown.length, add_piece, &html,
                                            MD_FLAG_TABLES | MD_FLAG_NOHTML, MD_HTML_FLAG_VERBATIM_ENTITIES) == 0) {
        add_body(&page, text_string(&html));
        view = json_pack("{ss# ss# so}", "contents", text_string(&contents), contents.length, "body",
                         text_string(&body), body.length, "title", json_shown(title));
    }
    return status->code != STATUS_OK ? status->code
           : view                    ? mustache_file(out, &folder, "page", view, escape_html)
                                     : status_memory(status);
}
