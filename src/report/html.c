/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "report/html.h"

#include "base/hash.h"
#include "base/mustache.h"

#include <ctype.h>
#include <limits.h>
#include <md4c.h>
#include <stdlib.h>
#include <string.h>

/* md4c reads the Markdown and calls back for each block, span and piece of text. A block's words are gathered in `line`
 * and written when the block ends or another begins in it: only then is it known what a heading's id is and whether a
 * paragraph is a row of figures. */

struct page {
    struct text body, contents;
    struct text ids;     /* of the headings so far, each between line ends */
    struct text line;    /* the open block's words, with their tags */
    struct text words;   /* the same without tags */
    struct text figures; /* its charts as figures, for when it holds nothing else */
    struct text target;  /* of the last link or image */
    struct text label;   /* of the open image, escaped */
    const char *title, *directory;
    unsigned parts;  /* headings of the first level so far: below the second, sections are folded */
    bool in_folded;  /* inside the <details> of a section */
    unsigned images; /* open, each but the outermost in the label of another */
    bool mixed;      /* the line holds more than charts */
    bool in_figures; /* inside the <div> of a run of figures */
    bool in_link;    /* inside a link that was kept */
    unsigned char script_hash[HASH_BYTES]; /* of the only script that the page's policy lets run: the skeleton's own */
    struct status *status;
};

static void empty(struct text *text)
{
    text->length = 0;
    text_add_bytes(text, "", 0);
}

/* Takes over where a link or image leads, as plain text: nowhere where characters stand as references, behind which a
 * scheme could hide. */
static void read_target(struct page *page, const MD_ATTRIBUTE *target)
{
    bool plain = true;
    empty(&page->target);
    for (size_t i = 0; target->size > 0 && target->substr_offsets[i] < target->size; i++)
        plain = plain && target->substr_types[i] == MD_TEXT_NORMAL;
    if (plain)
        text_add_bytes(&page->target, target->text, target->size);
}

/* GitHub's rule, so that a link inside report.md finds its section in both places: lower case, blanks become '-',
 * punctuation goes, and what is not ASCII stays. */
static void add_slug(struct text *out, const char *heading)
{
    size_t before = out->length;
    for (; *heading; heading++) {
        unsigned char c = (unsigned char)*heading;
        char lower = (char)tolower(c);
        if (c == '&')
            heading = strchr(heading, ';'); /* a character reference, of punctuation */
        else if (c == ' ' || c == '\n')
            text_add(out, "-");
        else if (c >= 0x80 || isalnum(c) || c == '-' || c == '_')
            text_add_bytes(out, &lower, 1);
    }
    if (out->length == before)
        text_add(out, "section");
}

/* Adds the id of `heading`, numbered if the page has it already, to `ids` and returns it with a line end after it. */
static const char *add_id(struct text *ids, const char *heading)
{
    if (ids->length == 0)
        text_add(ids, "\n");
    size_t start = ids->length;
    add_slug(ids, heading);
    size_t plain = ids->length;
    text_add(ids, "\n");
    for (unsigned number = 1; !ids->failed; number++) {
        const char *line = ids->data + start - 1;
        if (strstr(ids->data, line) == line)
            return line + 1;
        ids->length = plain;
        text_add(ids, "-%u\n", number);
    }
    return "";
}

static void empty_line(struct page *page)
{
    empty(&page->line);
    empty(&page->words);
    empty(&page->figures);
    page->mixed = false;
}

/* Writes the line between `start` and `end`. */
static void end_line(struct page *page, const char *start, const char *end)
{
    if (page->in_figures)
        text_add(&page->body, "</div>\n");
    page->in_figures = false;
    text_add(&page->body, "%s", start);
    text_add_bytes(&page->body, text_string(&page->line), page->line.length);
    text_add(&page->body, "%s", end);
    empty_line(page);
}

static void end_paragraph(struct page *page)
{
    if (page->mixed || page->figures.length == 0) {
        end_line(page, "<p>", "</p>\n");
        return;
    }
    if (!page->in_figures)
        text_add(&page->body, "<div class=\"figures\">\n");
    text_add(&page->body, "%s\n", text_string(&page->figures));
    empty_line(page);
    page->in_figures = true;
}

static const char fold_end[] = "</details>\n";

static void end_heading(struct page *page, unsigned level)
{
    const char *id = add_id(&page->ids, text_string(&page->words));
    int id_length = (int)strcspn(id, "\n");
    struct text start = {0};
    page->parts += level == 1;
    bool folds = level == 2 && page->parts > 1;
    if (level == 2 || page->parts > 1)
        text_add(&page->contents, "<li><a href=\"#%.*s\">%s</a></li>\n", id_length, id, text_string(&page->words));
    if (page->in_folded && level <= 2) {
        text_add(&start, fold_end);
        page->in_folded = false;
    }
    text_add(&start, "%s<h%u id=\"%.*s\">", folds ? "<details class=\"folded\"><summary>" : "", level, id_length, id);
    end_line(page, text_string(&start), "");
    text_add(&page->body, "</h%u>%s\n", level, folds ? "</summary>" : "");
    page->in_folded |= folds;
    page->body.failed |= start.failed;
    text_free(&start);
}

/* what goes around a block's words; a paragraph's and a heading's tags are written when they end */
static const struct {
    const char *start, *end;
} block_tags[] = {
    [MD_BLOCK_DOC] = {"", ""},
    [MD_BLOCK_P] = {"", ""},
    [MD_BLOCK_H] = {"", ""},
    [MD_BLOCK_QUOTE] = {"<blockquote>\n", "</blockquote>\n"},
    [MD_BLOCK_UL] = {"<ul>\n", "</ul>\n"},
    [MD_BLOCK_OL] = {"<ol>\n", "</ol>\n"},
    [MD_BLOCK_LI] = {"<li>", "</li>\n"},
    [MD_BLOCK_HR] = {"<hr>\n", ""},
    [MD_BLOCK_CODE] = {"<pre><code>", "</code></pre>\n"},
    [MD_BLOCK_TABLE] = {"<div class=\"table\" tabindex=\"0\"><table>\n", "</table></div>\n"},
    [MD_BLOCK_THEAD] = {"<thead>\n", "</thead>\n"},
    [MD_BLOCK_TBODY] = {"<tbody>\n", "</tbody>\n"},
    [MD_BLOCK_TR] = {"<tr>\n", "</tr>\n"},
    [MD_BLOCK_TH] = {"<th>", "</th>\n"},
    [MD_BLOCK_TD] = {"<td>", "</td>\n"},
};

static int enter_block(MD_BLOCKTYPE type, void *detail, void *user)
{
    static const char *const alignments[] = {
        [MD_ALIGN_LEFT] = "left", [MD_ALIGN_CENTER] = "center", [MD_ALIGN_RIGHT] = "right"};
    struct page *page = user;
    if (type != MD_BLOCK_P || page->line.length > 0) /* a run of figures may go on in a paragraph */
        end_line(page, "", "");
    const MD_BLOCK_OL_DETAIL *list = type == MD_BLOCK_OL ? detail : NULL;
    const MD_BLOCK_TD_DETAIL *cell = type == MD_BLOCK_TH || type == MD_BLOCK_TD ? detail : NULL;
    if (list && list->start != 1)
        text_add(&page->body, "<ol start=\"%u\">\n", list->start);
    else if (cell && cell->align != MD_ALIGN_DEFAULT)
        text_add(&page->body, "<%s align=\"%s\">", type == MD_BLOCK_TH ? "th" : "td", alignments[cell->align]);
    else
        text_add(&page->body, "%s", block_tags[type].start);
    return 0;
}

/* What a cell that begins with a mark says of a limit; page.html has colours for it, beside the mark's words. */
static const struct {
    const char *mark, *start;
} verdicts[] = {
    {"✓", "<span class=\"met\">"},
    {"✗", "<span class=\"missed\">"},
    {"? ", "<span class=\"untold\">"},
};

static void end_cell(struct page *page)
{
    for (size_t i = 0; i < sizeof verdicts / sizeof *verdicts; i++)
        if (strncmp(text_string(&page->words), verdicts[i].mark, strlen(verdicts[i].mark)) == 0) {
            end_line(page, verdicts[i].start, "</span></td>\n");
            return;
        }
    end_line(page, "", "</td>\n");
}

static int leave_block(MD_BLOCKTYPE type, void *detail, void *user)
{
    struct page *page = user;
    if (type == MD_BLOCK_TD)
        end_cell(page);
    else if (type == MD_BLOCK_P)
        end_paragraph(page);
    else if (type == MD_BLOCK_H)
        end_heading(page, ((const MD_BLOCK_H_DETAIL *)detail)->level);
    else
        end_line(page, "", block_tags[type].end);
    return 0;
}

static bool ends_with(const char *name, const char *extension)
{
    size_t length = strlen(name), size = strlen(extension);
    return length > size && strcmp(name + length - size, extension) == 0;
}

/* In base 64 (RFC 4648). */
static void add_base64(struct text *out, const unsigned char *bytes, size_t length)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < length; i += 3) {
        unsigned group = 0;
        size_t here = length - i < 3 ? length - i : 3;
        for (size_t k = 0; k < 3; k++)
            group = group << 8 | (k < here ? bytes[i + k] : 0u);
        char quad[4];
        for (size_t k = 0; k < 4; k++)
            quad[k] = k <= here ? digits[group >> (18 - 6 * k) & 63] : '=';
        text_add_bytes(out, quad, sizeof quad);
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
    bool chart = name[length] == '\0' && ends_with(name, ".svg");
    return chart ? name : NULL;
}

/* The caption, "Figures 6-05 to 6-09." in bold where it begins so. */
static void add_caption(struct text *out, const char *label)
{
    const char *stop = strncmp(label, "Figure", strlen("Figure")) == 0 ? strstr(label, ". ") : NULL;
    text_add(out, "\n<figcaption>");
    if (stop)
        text_add(out, "<b>%.*s</b>", (int)(stop + 1 - label), label);
    text_add(out, "%s</figcaption>", stop ? stop + 1 : label);
}

/* Reads figures/NAME. */
static enum status_code read_figure(struct text *out, struct text *path, struct page *page, const char *name)
{
    text_add(path, "%s/figures/%s", page->directory, name);
    return path->failed ? status_memory(page->status) : text_read_file(out, text_string(path), page->status);
}

/* The chart as a picture in the page: nothing in it can act, whatever names it holds. */
static enum status_code add_chart(struct page *page, const char *name)
{
    struct text path = {0}, drawing = {0}, *out = &page->line;
    size_t before = out->length;
    enum status_code code = read_figure(&drawing, &path, page, name);
    if (code == STATUS_OK) {
        text_add(out, "<img alt=\"");
        text_add_bytes(out, text_string(&page->label), page->label.length); /* escaped already */
        text_add(out, "\" src=\"data:image/svg+xml;base64,");
        add_base64(out, (const unsigned char *)text_string(&drawing), drawing.length);
        text_add(out, "\">");
        text_add(&page->figures, "<figure>\n");
        text_add_bytes(&page->figures, text_string(out) + before, out->length - before);
        add_caption(&page->figures, text_string(&page->label));
        text_add(&page->figures, "\n</figure>\n");
    }
    text_free(&path);
    text_free(&drawing);
    return code;
}

/* A chart stands where its image does; of anything else only the words remain, as the page may not refer to other
 * files. */
static enum status_code end_image(struct page *page)
{
    const char *name = chart_name(text_string(&page->target));
    if (name)
        return add_chart(page, name);
    text_add_bytes(&page->line, text_string(&page->label), page->label.length);
    page->mixed = true;
    return STATUS_OK;
}

/* May a link lead there? Within the page or report, or by a scheme that only opens a page or a letter. */
static bool link_allowed(const char *target)
{
    static const char *const schemes[] = {"http:", "https:", "mailto:"};
    if (target[strcspn(target, ":/?#")] != ':')
        return strncmp(target, "//", 2) != 0;
    for (size_t i = 0; i < sizeof schemes / sizeof *schemes; i++)
        if (strncasecmp(target, schemes[i], strlen(schemes[i])) == 0)
            return true;
    return false;
}

static void start_link(struct page *page, const MD_ATTRIBUTE *href)
{
    read_target(page, href);
    page->in_link = page->target.length > 0 && link_allowed(text_string(&page->target));
    if (page->in_link) {
        text_add(&page->line, "<a href=\"");
        text_add_html(&page->line, text_string(&page->target), page->target.length);
        text_add(&page->line, "\">");
    }
}

static const char *const span_tags[] = {[MD_SPAN_EM] = "em", [MD_SPAN_STRONG] = "strong", [MD_SPAN_CODE] = "code"};

/* Of what an image's label holds only the words count. */
static int enter_span(MD_SPANTYPE type, void *detail, void *user)
{
    struct page *page = user;
    if (type == MD_SPAN_IMG && page->images++ == 0) {
        empty(&page->label);
        read_target(page, &((const MD_SPAN_IMG_DETAIL *)detail)->src);
    }
    if (page->images > 0)
        return 0;
    page->mixed = true;
    if (type == MD_SPAN_A)
        start_link(page, &((const MD_SPAN_A_DETAIL *)detail)->href);
    else
        text_add(&page->line, "<%s>", span_tags[type]);
    return 0;
}

static int leave_span(MD_SPANTYPE type, void *detail, void *user)
{
    (void)detail;
    struct page *page = user;
    if (type == MD_SPAN_IMG && --page->images == 0)
        return end_image(page) == STATUS_OK ? 0 : -1; /* md4c goes on after a positive number */
    if (page->images > 0)
        return 0;
    if (type != MD_SPAN_A)
        text_add(&page->line, "</%s>", span_tags[type]);
    else if (page->in_link)
        text_add(&page->line, "</a>");
    return 0;
}

static int add_words(MD_TEXTTYPE type, const MD_CHAR *bytes, MD_SIZE size, void *user)
{
    struct page *page = user;
    struct text *out = page->images > 0 ? &page->label : &page->line;
    if (type == MD_TEXT_BR && page->images == 0)
        text_add(out, "<br>");
    size_t before = out->length;
    if (type == MD_TEXT_BR || type == MD_TEXT_SOFTBR)
        text_add(out, page->images > 0 ? " " : "\n");
    else if (type == MD_TEXT_ENTITY)
        text_add_bytes(out, bytes, size); /* the browser knows them all */
    else
        text_add_html(out, bytes, size);
    if (page->images > 0)
        return 0;
    text_add_bytes(&page->words, text_string(out) + before, out->length - before);
    page->mixed |= type != MD_TEXT_SOFTBR;
    return 0;
}

static void escape_html(struct text *out, const char *string)
{
    text_add_html(out, string, strlen(string));
}

/* What page.html is filled from. */
static json_t *page_view(const struct page *page)
{
    struct text hash = {0};
    add_base64(&hash, page->script_hash, sizeof page->script_hash);
    json_t *view = json_pack("{ss# ss# ss}", "contents", text_string(&page->contents), page->contents.length, "body",
                             text_string(&page->body), page->body.length, "script_hash", text_string(&hash));
    struct text title = {0};
    text_add_shown(&title, page->title);
    json_object_set_new(view, "title", json_string(text_string(&title)));
    text_free(&title);
    text_free(&hash);
    return view;
}

static void hash_script(struct page *page, const char *skeleton)
{
    const char *start = strstr(skeleton, "<script>"), *end = start ? strstr(start, "</script>") : NULL;
    struct hash hash = hash_start();
    if (end)
        hash_add(&hash, start + strlen("<script>"), (size_t)(end - start) - strlen("<script>"));
    SHA256Final(page->script_hash, &hash.context);
}

enum status_code html_render(struct text *out, const char *markdown, const char *title, const char *directory,
                             const char *templates, struct status *status)
{
    static const MD_PARSER parser = {.flags = MD_FLAG_TABLES | MD_FLAG_NOHTML,
                                     .enter_block = enter_block,
                                     .leave_block = leave_block,
                                     .enter_span = enter_span,
                                     .leave_span = leave_span,
                                     .text = add_words};
    struct page page = {.title = title, .directory = directory, .status = status};
    struct text *const texts[] = {&page.body,  &page.contents, &page.ids,    &page.line,
                                  &page.words, &page.figures,  &page.target, &page.label};
    struct mustache_folder folder = {templates, ".html", NULL, status};
    const char *skeleton = mustache_folder_partial(&folder, "page");
    size_t length = strlen(markdown);
    bool memory = length > UINT_MAX;
    enum status_code code = memory ? status_memory(status) : skeleton ? STATUS_OK : status->code;
    if (code == STATUS_OK) {
        hash_script(&page, skeleton);
        int failed = md_parse(markdown, (MD_SIZE)length, &parser, &page);
        end_line(&page, page.in_folded ? fold_end : "", "");
        for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
            memory |= texts[i]->failed;
        code = status->code != STATUS_OK ? status->code : failed || memory ? status_memory(status) : STATUS_OK;
    }
    if (code == STATUS_OK) {
        json_t *view = page_view(&page);
        code = view ? mustache_file(out, &folder, "page", view, escape_html) : status_memory(status);
        json_decref(view);
    }
    mustache_folder_free(&folder);
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        text_free(texts[i]);
    return code;
}
