#include "report/html.h"

#include "report/svg.h"

#include <ctype.h>
#include <limits.h>
#include <md4c-html.h>
#include <string.h>

/* md4c writes the HTML; this file goes once over its tags. As raw HTML is off, every '<' in it begins a tag of md4c's
 * own, in md4c's own spelling: text and attribute values have theirs escaped. */

enum { HTML_MARKDOWN = MD_FLAG_TABLES | MD_FLAG_NOHTML };

struct page {
    struct text body, contents;
    struct text slugs; /* the ids given so far, each between line ends */
    const char *at;    /* where in md4c's output */
    const char *directory;
    int level; /* of the last entry in the contents: 0 (none), 2 or 3 */
    unsigned figures;
    bool in_figures; /* inside the <div> of a run of figures */
    bool in_link;    /* inside a link that was kept */
    struct status *status;
};

struct image {
    const char *name;  /* of the file in figures/ */
    int name_length;   /* 0: not a chart of the report */
    const char *label; /* escaped */
    int label_length;
    const char *end; /* after the tag */
};

static bool starts(const char *at, const char *with)
{
    return strncmp(at, with, strlen(with)) == 0;
}

static void collect(const MD_CHAR *bytes, MD_SIZE length, void *text)
{
    text_add_bytes(text, bytes, length);
}

static void add_escaped(struct text *out, const char *string)
{
    static const char *const escapes[128] = {['<'] = "&lt;", ['>'] = "&gt;", ['&'] = "&amp;", ['"'] = "&quot;"};
    for (size_t length; *string; string += length ? length : 1) {
        length = text_character(string);
        if (length == 1 && escapes[(unsigned char)*string])
            text_add(out, "%s", escapes[(unsigned char)*string]);
        else
            text_add_bytes(out, length ? string : "?", length ? length : 1);
    }
}

/* The text of a heading, without its tags. */
static void add_without_tags(struct text *out, const char *html, const char *end)
{
    while (html < end) {
        size_t length = strcspn(html, "<");
        if (length > (size_t)(end - html))
            length = (size_t)(end - html);
        text_add_bytes(out, html, length);
        html += length;
        if (html < end)
            html = strchr(html, '>') + 1;
    }
}

/* GitHub's rule, so that a link inside report.md finds its section in both places: lower case, blanks become '-',
 * punctuation goes, and what is not ASCII stays. */
static void add_slug(struct text *out, const char *heading)
{
    size_t before = out->length;
    for (; *heading; heading++) {
        unsigned char c = (unsigned char)*heading;
        char lower = (char)tolower(c);
        if (c == '&' && strchr(heading, ';'))
            heading = strchr(heading, ';'); /* a character reference, of punctuation */
        else if (c == ' ' || c == '\n')
            text_add(out, "-");
        else if (c >= 0x80 || isalnum(c) || c == '-' || c == '_')
            text_add_bytes(out, &lower, 1);
    }
    if (out->length == before)
        text_add(out, "section");
}

/* Puts into `out` the slug of `heading`, numbered if the page has it already. */
static void unique_slug(struct page *page, struct text *out, const char *heading)
{
    struct text line = {0};
    add_slug(out, heading);
    size_t plain = out->length;
    for (unsigned number = 1; !out->failed && !line.failed; number++) {
        line.length = 0;
        text_add(&line, "\n%s\n", text_string(out));
        if (!strstr(text_string(&page->slugs), text_string(&line)))
            break;
        out->length = plain;
        text_add(out, "-%u", number);
    }
    text_add(&page->slugs, "%s\n", text_string(out));
    page->slugs.failed |= line.failed || out->failed;
    text_free(&line);
}

static void add_contents_entry(struct page *page, int level, const char *slug, const char *heading)
{
    if (page->level == 0)
        level = 2; /* a subsection before any section stands as one */
    if (level == 3)
        text_add(&page->contents, page->level == 2 ? "\n<ul>\n" : "</li>\n");
    else if (page->level > 0)
        text_add(&page->contents, page->level == 2 ? "</li>\n" : "</li>\n</ul></li>\n");
    text_add(&page->contents, "<li><a href=\"#%s\">%s</a>", slug, heading);
    page->level = level;
}

static void end_contents(struct page *page)
{
    if (page->level > 0)
        text_add(&page->contents, page->level == 2 ? "</li>\n" : "</li>\n</ul></li>\n");
}

static enum status_code heading(struct page *page)
{
    int level = page->at[2] - '0';
    const char *inner = page->at + strlen("<h2>"), *end = strstr(inner, "</h");
    struct text plain = {0}, slug = {0};
    add_without_tags(&plain, inner, end);
    unique_slug(page, &slug, text_string(&plain));
    text_add(&page->body, "<h%d id=\"%s\">", level, text_string(&slug));
    if (level == 2 || level == 3)
        add_contents_entry(page, level, text_string(&slug), text_string(&plain));
    page->contents.failed |= plain.failed;
    text_free(&plain);
    text_free(&slug);
    page->at = inner;
    return STATUS_OK;
}

/* Reads md4c's <img src="..." alt="..." title="..."> at `at`. */
static struct image read_image(const char *at)
{
    static const char source[] = "<img src=\"", alternative[] = "\" alt=\"";
    struct image image = {.end = strchr(at, '>') + 1};
    const char *src = at + strlen(source);
    const char *alt = strstr(src, alternative) + strlen(alternative);
    image.label = alt;
    image.label_length = (int)strcspn(alt, "\"");
    if (starts(src, "figures/")) {
        image.name = src + strlen("figures/");
        size_t length = strspn(image.name, "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._-");
        if (length > 4 && image.name[length] == '"' && starts(image.name + length - 4, ".svg"))
            image.name_length = (int)length;
    }
    return image;
}

static enum status_code add_chart(struct page *page, const struct image *image)
{
    struct text path = {0}, svg = {0}, label = {0};
    text_add(&path, "%s/figures/%.*s", page->directory, image->name_length, image->name);
    text_add_bytes(&label, image->label, (size_t)image->label_length);
    enum status_code code = path.failed || label.failed ? status_memory(page->status)
                                                        : text_read_file(&svg, text_string(&path), page->status);
    if (code == STATUS_OK)
        code = svg_inline(&page->body, &svg, text_string(&path), ++page->figures, text_string(&label), page->status);
    text_free(&path);
    text_free(&svg);
    text_free(&label);
    return code;
}

/* The caption, "Figure 6-05." in bold where it begins so. */
static void add_caption(struct page *page, const struct image *image)
{
    int lead = 0;
    if (image->label_length > 0 && starts(image->label, "Figure "))
        for (int i = 0; i + 1 < image->label_length && lead == 0; i++)
            lead = image->label[i] == '.' && image->label[i + 1] == ' ' ? i + 1 : 0;
    text_add(&page->body, "\n<figcaption>");
    if (lead > 0)
        text_add(&page->body, "<b>%.*s</b>", lead, image->label);
    text_add(&page->body, "%.*s</figcaption>", image->label_length - lead, image->label + lead);
}

/* Where a paragraph that holds charts and nothing else ends, or NULL. */
static const char *figures_end(const char *at)
{
    if (!starts(at, "<p><img "))
        return NULL;
    for (at += strlen("<p>"); starts(at, "<img "); at += strspn(at, "\n")) {
        struct image image = read_image(at);
        if (image.name_length == 0)
            return NULL;
        at = image.end;
    }
    return starts(at, "</p>") ? at + strlen("</p>") : NULL;
}

static enum status_code figures(struct page *page, const char *end)
{
    if (!page->in_figures)
        text_add(&page->body, "<div class=\"figures\">\n");
    page->in_figures = true;
    for (const char *at = strstr(page->at, "<img "); at && at < end; at = strstr(at, "<img ")) {
        struct image image = read_image(at);
        text_add(&page->body, "<figure>\n");
        if (add_chart(page, &image) != STATUS_OK)
            return page->status->code;
        add_caption(page, &image);
        text_add(&page->body, "\n</figure>\n");
        at = image.end;
    }
    page->at = end;
    return STATUS_OK;
}

/* An image among text: a chart stands there as it is; of anything else only the words remain, as the page may not
 * refer to other files. */
static enum status_code inline_image(struct page *page)
{
    struct image image = read_image(page->at);
    page->at = image.end;
    if (image.name_length > 0)
        return add_chart(page, &image);
    text_add_bytes(&page->body, image.label, (size_t)image.label_length);
    return STATUS_OK;
}

/* May a link lead there? Within the page or report, or by a scheme that only opens a page or a letter. */
static bool link_allowed(const char *target)
{
    static const char *const schemes[] = {"http:", "https:", "mailto:"};
    size_t length = strcspn(target, ":/?#\"");
    if (target[length] != ':')
        return !starts(target, "//");
    for (size_t i = 0; i < sizeof schemes / sizeof *schemes; i++)
        if (strncasecmp(target, schemes[i], strlen(schemes[i])) == 0)
            return true;
    return false;
}

static enum status_code link_start(struct page *page)
{
    const char *end = strchr(page->at, '>') + 1;
    page->in_link = link_allowed(page->at + strlen("<a href=\""));
    if (page->in_link)
        text_add_bytes(&page->body, page->at, (size_t)(end - page->at));
    page->at = end;
    return STATUS_OK;
}

static enum status_code link_end(struct page *page)
{
    if (page->in_link)
        text_add(&page->body, "</a>");
    page->in_link = false;
    page->at += strlen("</a>");
    return STATUS_OK;
}

static enum status_code table_start(struct page *page)
{
    text_add(&page->body, "<div class=\"table\" tabindex=\"0\"><table>");
    page->at += strlen("<table>");
    return STATUS_OK;
}

static enum status_code table_end(struct page *page)
{
    text_add(&page->body, "</table></div>");
    page->at += strlen("</table>");
    return STATUS_OK;
}

/* the tags that are not copied as they are */
static const struct tag {
    const char *start;
    enum status_code (*convert)(struct page *page);
} tags[] = {{"<h1>", heading},       {"<h2>", heading},        {"<h3>", heading},      {"<h4>", heading},
            {"<h5>", heading},       {"<h6>", heading},        {"<a ", link_start},    {"</a>", link_end},
            {"<img ", inline_image}, {"<table>", table_start}, {"</table>", table_end}};

static enum status_code convert_tag(struct page *page)
{
    for (size_t i = 0; i < sizeof tags / sizeof *tags; i++)
        if (starts(page->at, tags[i].start))
            return tags[i].convert(page);
    size_t length = strcspn(page->at, ">");
    text_add_bytes(&page->body, page->at, length);
    page->at += length;
    return STATUS_OK;
}

static enum status_code convert(struct page *page, const char *html)
{
    for (page->at = html; *page->at;) {
        const char *end = figures_end(page->at);
        if (end) {
            if (figures(page, end) != STATUS_OK)
                return page->status->code;
            continue;
        }
        if (page->in_figures && *page->at != '\n') {
            text_add(&page->body, "</div>\n");
            page->in_figures = false;
        }
        if (*page->at == '<') {
            if (convert_tag(page) != STATUS_OK)
                return page->status->code;
        } else {
            size_t length = strcspn(page->at + 1, "<\n") + 1;
            text_add_bytes(&page->body, page->at, length);
            page->at += length;
        }
    }
    if (page->in_figures)
        text_add(&page->body, "</div>\n");
    end_contents(page);
    return page->body.failed || page->contents.failed || page->slugs.failed ? status_memory(page->status) : STATUS_OK;
}

/* Copies the skeleton with its {{marks}} filled in, in one pass: what is filled in is not looked at again. */
static enum status_code fill_skeleton(struct text *out, const struct page *page, const char *title,
                                      const char *skeleton, const char *path)
{
    struct text escaped = {0};
    add_escaped(&escaped, title);
    const struct {
        const char *mark;
        const struct text *content;
    } marks[] = {{"{{title}}", &escaped}, {"{{contents}}", &page->contents}, {"{{body}}", &page->body}};
    enum status_code code = STATUS_OK;
    while (*skeleton && code == STATUS_OK) {
        const char *mark = strstr(skeleton, "{{");
        size_t length = mark ? (size_t)(mark - skeleton) : strlen(skeleton);
        text_add_bytes(out, skeleton, length);
        skeleton += length;
        size_t i = 0, count = sizeof marks / sizeof *marks;
        while (mark && i < count && !starts(mark, marks[i].mark))
            i++;
        if (mark && i == count)
            code = status_fail(page->status, STATUS_IO,
                               "%s: unknown mark '%.12s': write {{title}}, {{contents}} or {{body}}", path, mark);
        else if (mark) {
            text_add_bytes(out, text_string(marks[i].content), marks[i].content->length);
            skeleton += strlen(marks[i].mark);
        }
    }
    if (code == STATUS_OK && (escaped.failed || out->failed))
        code = status_memory(page->status);
    text_free(&escaped);
    return code;
}

enum status_code html_render(struct text *out, const char *markdown, const char *title, const char *directory,
                             const char *templates, struct status *status)
{
    struct text html = {0}, path = {0}, skeleton = {0};
    struct page page = {.directory = directory, .status = status};
    size_t length = strlen(markdown);
    enum status_code code = STATUS_OK;
    text_add(&path, "%s/page.html", templates);
    text_add(&page.slugs, "\n");
    if (length > UINT_MAX || md_html(markdown, (MD_SIZE)length, collect, &html, HTML_MARKDOWN, 0) != 0 || html.failed ||
        path.failed)
        code = status_memory(status);
    if (code == STATUS_OK)
        code = text_read_file(&skeleton, text_string(&path), status);
    if (code == STATUS_OK)
        code = convert(&page, text_string(&html));
    if (code == STATUS_OK)
        code = fill_skeleton(out, &page, title, text_string(&skeleton), text_string(&path));
    text_free(&html);
    text_free(&path);
    text_free(&skeleton);
    text_free(&page.body);
    text_free(&page.contents);
    text_free(&page.slugs);
    return code;
}
