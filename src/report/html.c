/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "report/html.h"

#include "base/hash.h"
#include "base/mustache.h"
#include "output/json.h"

#include <limits.h>
#include <md4c.h>
#include <string.h>

/* md4c reads the Markdown and calls back for each block, span and piece of text, which are written as they come. A
 * paragraph's tag waits for its first words: one of charts alone is their figures. */

struct page {
    struct text body, contents;
    struct text target; /* of the last link or image */
    struct text label;  /* of the open image, escaped */
    const char *title, *directory;
    unsigned headings;                     /* so far: their ids */
    unsigned parts;                        /* those of the first level: below the second, sections are folded */
    bool in_folded;                        /* inside the <details> of a section */
    bool in_entry;                         /* inside a heading that stands in the contents */
    bool paragraph_waits;                  /* its words are still to come */
    bool in_paragraph;                     /* inside <p> */
    bool cell_waits;                       /* a cell of a table, the same */
    bool in_verdict;                       /* inside the <span> of a cell that judges */
    bool in_link;                          /* inside a link that was kept */
    unsigned images;                       /* open, each but the outermost in the label of another */
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

/* What a cell that begins with a mark says of a limit; page.html has colours for it, beside the mark's words. */
static const struct {
    const char *mark, *start;
} verdicts[] = {
    {"✓", "<span class=\"met\">"},
    {"✗", "<span class=\"missed\">"},
    {"? ", "<span class=\"untold\">"},
};

/* Before the first words of a paragraph or cell, which begin so; NULL: with a span. */
static void begin_words(struct page *page, const char *words, size_t size)
{
    if (page->paragraph_waits)
        text_add(&page->body, "<p>");
    page->in_paragraph |= page->paragraph_waits;
    for (size_t i = 0; page->cell_waits && words && i < sizeof verdicts / sizeof *verdicts; i++)
        if (size >= strlen(verdicts[i].mark) && strncmp(words, verdicts[i].mark, strlen(verdicts[i].mark)) == 0) {
            text_add(&page->body, "%s", verdicts[i].start);
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
        text_add(&page->body, "%s", fold_end);
        page->in_folded = false;
    }
    bool folds = level == 2 && page->parts > 1;
    page->in_folded |= folds;
    page->in_entry = level == 2 || (level == 1 && page->parts > 1);
    text_add(&page->body, "%s<h%u id=\"section-%u\">", folds ? "<details class=\"folded\"><summary>" : "", level,
             page->headings);
    if (page->in_entry)
        text_add(&page->contents, "<li><a href=\"#section-%u\">", page->headings);
}

static void end_heading(struct page *page, unsigned level)
{
    text_add(&page->body, "</h%u>%s\n", level, page->in_folded && level == 2 ? "</summary>" : "");
    if (page->in_entry)
        text_add(&page->contents, "</a></li>\n");
    page->in_entry = false;
}

/* what goes around a block's words; a heading's tags have its level */
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
    const MD_BLOCK_OL_DETAIL *list = type == MD_BLOCK_OL ? detail : NULL;
    const MD_BLOCK_TD_DETAIL *cell = type == MD_BLOCK_TH || type == MD_BLOCK_TD ? detail : NULL;
    page->paragraph_waits = type == MD_BLOCK_P;
    page->cell_waits = type == MD_BLOCK_TD;
    if (type == MD_BLOCK_H)
        start_heading(page, ((const MD_BLOCK_H_DETAIL *)detail)->level);
    else if (list && list->start != 1)
        text_add(&page->body, "<ol start=\"%u\">\n", list->start);
    else if (cell && cell->align != MD_ALIGN_DEFAULT)
        text_add(&page->body, "<%s align=\"%s\">", type == MD_BLOCK_TH ? "th" : "td", alignments[cell->align]);
    else
        text_add(&page->body, "%s", block_tags[type].start);
    return 0;
}

static int leave_block(MD_BLOCKTYPE type, void *detail, void *user)
{
    struct page *page = user;
    if (type == MD_BLOCK_H)
        end_heading(page, ((const MD_BLOCK_H_DETAIL *)detail)->level);
    if (type == MD_BLOCK_P && page->in_paragraph)
        text_add(&page->body, "</p>\n");
    if (type == MD_BLOCK_TD && page->in_verdict)
        text_add(&page->body, "</span>");
    page->in_paragraph = page->in_verdict = page->paragraph_waits = page->cell_waits = false;
    text_add(&page->body, "%s", block_tags[type].end);
    return 0;
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
    return name[length] == '\0' && length > 4 && strcmp(name + length - 4, ".svg") == 0 ? name : NULL;
}

/* A chart stands where its image does, as a picture in which nothing can act, whatever names it holds; outside of words
 * it is a figure with its caption. Of anything else only the words remain, as the page may not refer to other files. */
static enum status_code end_image(struct page *page)
{
    const char *name = chart_name(text_string(&page->target)), *label = text_string(&page->label);
    struct text path = {0}, drawing = {0}, *out = &page->body;
    if (!name) {
        begin_words(page, label, page->label.length);
        text_add_bytes(out, label, page->label.length);
        return STATUS_OK;
    }
    text_add(&path, "%s/figures/%s", page->directory, name);
    enum status_code code =
        path.failed ? status_memory(page->status) : text_read_file(&drawing, text_string(&path), page->status);
    if (code == STATUS_OK) {
        bool figure = page->paragraph_waits;
        text_add(out, "%s<img alt=\"%s\" src=\"data:image/svg+xml;base64,", figure ? "<figure>\n" : "", label);
        add_base64(out, (const unsigned char *)text_string(&drawing), drawing.length);
        text_add(out, "\">");
        if (figure)
            text_add(out, "\n<figcaption>%s</figcaption>\n</figure>\n", label);
    }
    text_free(&path);
    text_free(&drawing);
    return code;
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
        text_add(&page->body, "<a href=\"");
        text_add_html(&page->body, text_string(&page->target), page->target.length);
        text_add(&page->body, "\">");
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
    begin_words(page, NULL, 0);
    if (type == MD_SPAN_A)
        start_link(page, &((const MD_SPAN_A_DETAIL *)detail)->href);
    else
        text_add(&page->body, "<%s>", span_tags[type]);
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
        text_add(&page->body, "</%s>", span_tags[type]);
    else if (page->in_link)
        text_add(&page->body, "</a>");
    return 0;
}

static int add_words(MD_TEXTTYPE type, const MD_CHAR *bytes, MD_SIZE size, void *user)
{
    struct page *page = user;
    struct text *out = page->images > 0 ? &page->label : &page->body;
    if (type == MD_TEXT_SOFTBR && page->images == 0 && page->paragraph_waits)
        return 0; /* between figures */
    if (page->images == 0)
        begin_words(page, bytes, size);
    if (type == MD_TEXT_BR && page->images == 0)
        text_add(out, "<br>");
    size_t before = out->length;
    if (type == MD_TEXT_BR || type == MD_TEXT_SOFTBR)
        text_add(out, page->images > 0 ? " " : "\n");
    else if (type == MD_TEXT_ENTITY)
        text_add_bytes(out, bytes, size); /* the browser knows them all */
    else
        text_add_html(out, bytes, size);
    if (page->in_entry && page->images == 0)
        text_add_bytes(&page->contents, text_string(out) + before, out->length - before);
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
    json_object_set_new(view, "title", json_shown(page->title));
    text_free(&hash);
    return view;
}

static void hash_script(struct page *page, const char *skeleton)
{
    const char *start = strstr(skeleton, "<script>"), *end = start ? strstr(start, "</script>") : NULL;
    struct hash hash = hash_start();
    if (end)
        hash_add(&hash, start + strlen("<script>"), (size_t)(end - start) - strlen("<script>"));
    SHA256_Final(page->script_hash, &hash.context);
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
    struct text *const texts[] = {&page.body, &page.contents, &page.target, &page.label};
    struct mustache_folder folder = {templates, ".html", NULL, status};
    const char *skeleton = mustache_folder_partial(&folder, "page");
    size_t length = strlen(markdown);
    bool memory = length > UINT_MAX;
    enum status_code code = memory ? status_memory(status) : skeleton ? STATUS_OK : status->code;
    if (code == STATUS_OK) {
        hash_script(&page, skeleton);
        int failed = md_parse(markdown, (MD_SIZE)length, &parser, &page);
        text_add(&page.body, "%s", page.in_folded ? fold_end : "");
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
