/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The page: structure, contents, charts, and that nothing in it acts or leads away. */
#include "report/report.h"
#include "support.h"

#include <nettle/base64.h>
#include <nettle/sha2.h>

#define TEMPLATES PROJECT_SOURCE "/templates"
#define DIRECTORY TEST_DATA "/report"

/* The skeleton's script, which alone may run: cut out of `page`, which has to name its hash. */
static void take_script_out(struct text *page)
{
    struct text *skeleton = support_text();
    expect_ok(text_read_file, skeleton, TEMPLATES "/page.html");
    const char *start = strstr(skeleton->data, "<script>"), *end = strstr(start, "</script>");
    size_t length = (size_t)(end - start);
    char *found = strstr(page->data, "<script>\n// ");
    assert_non_null(found);
    assert_memory_equal(found, start, length);
    unsigned char hash[SHA256_DIGEST_SIZE];
    char digits[BASE64_ENCODE_RAW_LENGTH(sizeof hash)];
    struct sha256_ctx context;
    size_t tag = strlen("<script>");
    sha256_init(&context);
    sha256_update(&context, length - tag, (const unsigned char *)start + tag);
    sha256_digest(&context, sizeof hash, hash);
    base64_encode_raw(digits, sizeof hash, hash);
    char *allowed = strstr(page->data, "script-src 'sha256-") + strlen("script-src 'sha256-");
    if (strncmp(allowed, digits, sizeof digits) != 0)
        fail_msg("the script of templates/page.html is sha256-%.*s, which its policy has to name", (int)sizeof digits,
                 digits);
    memmove(found, found + length, page->length - (size_t)(found - page->data) - length + 1);
    page->length -= length;
}

/* The page without its script. */
static void render(struct text *out, const char *markdown)
{
    expect_ok(html_render, out, markdown, "A title", DIRECTORY, TEMPLATES);
    take_script_out(out);
}

static const char *rendered(const char *markdown)
{
    struct text *out = support_text();
    render(out, markdown);
    return text_string(out);
}

static const char *body_of(const char *page)
{
    const char *body = strstr(page, "<main");
    assert_non_null(body);
    return body;
}

/* `markdown` gives a body that holds `expected`. */
static void assert_body(const char *markdown, const char *expected)
{
    expect_parts(body_of(rendered(markdown)), expected);
}

TEST_CASE(headings_and_contents)
{
    const char *page = rendered("# Report\n\n## One *part*\n\n### A & B: `x<y>`\n\n## Två γ_1\n");
    static const char contents[] = "<ul>\n<li><a href=\"#section-2\">One part</a></li>\n"
                                   "<li><a href=\"#section-4\">Två γ_1</a></li>\n</ul>";
    assert_int_equal(times(page, contents), 2); /* beside the text, and above it on narrow screens */
    expect_parts(page, "<h1 id=\"section-1\">Report</h1>",
                 "<h2 id=\"section-2\">One <em>part</em><a id=\"one-part\"></a></h2>",
                 "<h3 id=\"section-3\">A &amp; B: <code>x&lt;y&gt;</code></h3>");
}

TEST_CASE(tables)
{
    assert_body("| a | b |\n|---|---:|\n| x | 1 |\n",
                "<div class=\"table\" tabindex=\"0\"><table>\n<thead>\n<tr>\n<th>a</th>\n<th align=\"right\">b</th>");
    assert_body("| a | b |\n|---|---:|\n| x | 1 |\n", "<td align=\"right\">1</td>\n</tr>\n</tbody>\n</table></div>\n");
}

/* All values of id="..." in the page. */
static void assert_ids_unique(const char *page)
{
    size_t ids = 0;
    for (const char *at = strstr(page, " id=\""); at; at = strstr(at + 1, " id=\"")) {
        assert_int_equal(times(page, filled("%.*s", (int)strcspn(at + 5, "\"") + 6, at)), 1);
        ids++;
    }
    assert_true(ids > 0);
}

#define SHOWN "src=\"data:image/svg+xml;base64,"

TEST_CASE(figures)
{
    const char *page = rendered("# R\n\n![Figure 6-05. Area *A* \"x\"](figures/chart.svg)\n\n"
                                "![Again](figures/chart.svg)\n\ntext\n\n![Third](figures/chart.svg)\n"
                                "![Fourth](figures/chart.svg)\n");
    const char *body = body_of(page);
    assert_ids_unique(page);
    assert_int_equal(times(body, "<figure>\n<img alt=\""), 4);
    assert_int_equal(times(body, SHOWN), 4);
    assert_int_equal(times(body, "\">\n<figcaption>"), 4);
    expect_parts(body, "</figure>\n<p>text</p>\n<figure>", "</figure>\n</main>",
                 "alt=\"Figure 6-05. Area A &quot;x&quot;\"",
                 "<figcaption>Figure 6-05. Area A &quot;x&quot;</figcaption>", "<figcaption>Again</figcaption>");
}

TEST_CASE(images_among_text)
{
    assert_body("see ![that](figures/chart.svg) one\n", "<p>see <img alt=\"that\" " SHOWN);
    assert_body("![that](figures/chart.svg) one\n", "</figure><p> one</p>");
    assert_body("![words](figures/picture.gif)\n", "<p>words</p>");
    assert_body("a ![photo \"x\"](photo.png)\n", "<p>a photo &quot;x&quot;</p>");
    assert_body("![far](http://example.org/x.svg)\n", "<p>far</p>");
}

TEST_CASE(paths_stay_in_figures)
{
    assert_body("![words](figures/../secret.svg)\n", "<p>words</p>");
    assert_body("![words](secret.svg)\n", "<p>words</p>");
    assert_body("![words](figures/..%2fsecret.svg)\n", "<p>words</p>");
    assert_body("![words](/figures/chart.svg)\n", "<p>words</p>");
    assert_body("![words](figures/chart.svg?x)\n", "<p>words</p>");
    assert_body("![words](figures/.svg)\n", "<p>words</p>");
}

TEST_CASE(raw_html_is_text)
{
    assert_body("<script>alert(1)</script>\n", "<p>&lt;script&gt;alert(1)&lt;/script&gt;</p>");
    assert_body("a <b onclick=\"x\">b</b> &lt;i&gt; &#60;u>\n",
                "a &lt;b onclick=&quot;x&quot;&gt;b&lt;/b&gt; &lt;i&gt; &#60;u&gt;");
    assert_body("![<b>](figures/chart.svg)\n", "alt=\"&lt;b&gt;\"");
    expect_no_parts(rendered("<script>\n\n<table>\n\n<img src=x>\n"), "<script");
}

TEST_CASE(characters)
{
    assert_body("a\x01 \x1b[31m \xff \xc2\x85 &#7; &nbsp;&eacute; b\n",
                "<p>a\\x01 \\x1b[31m \\xff \\u0085 &#7; &nbsp;&eacute; b</p>");
    assert_body("]]> &#93;&#93;&#62; --> 'q' \"r\"\n", "<p>]]&gt; &#93;&#93;&#62; --&gt; 'q' &quot;r&quot;</p>");
    assert_body("a\\\nb  \nc\nd\n", "<p>a<br>\nb<br>\nc\nd</p>");
    assert_body("![a *b*\n`<c>` ![d](e) f](x.png)\n", "<p>a b &lt;c&gt; d f</p>");
}

TEST_CASE(blocks)
{
    assert_body("- a\n- **b**\n", "<ul>\n<li>a</li>\n<li><strong>b</strong></li>\n</ul>\n");
    assert_body("1. a\n   - b\n", "<ol>\n<li>a<ul>\n<li>b</li>\n</ul>\n</li>\n</ol>\n");
    assert_body("- a\n  # b\n", "<ul>\n<li>a<h1 id=\"section-1\">b</h1>\n</li>\n</ul>\n");
    assert_body("7) a\n\n8) b\n", "<ol start=\"7\">\n<li><p>a</p>\n</li>\n<li><p>b</p>\n</li>\n</ol>\n");
    assert_body("> a\n\n---\n", "<blockquote>\n<p>a</p>\n</blockquote>\n<hr>\n");
    assert_body("```x\na < b\n\nc\n```\n", "<pre><code>a &lt; b\n\nc\n</code></pre>\n");
    assert_body("![a](figures/chart.svg)\n\n## b\n", "</figure>\n<h2 id=\"section-1\">b<a id=\"b\"></a></h2>\n");
}

TEST_CASE(links)
{
    assert_body("[a](https://example.org/?a=b&c) b\n", "<a href=\"https://example.org/?a=b&amp;c\">a</a> b");
    assert_body("[a](data/contact.csv \"t\")\n", "<a href=\"data/contact.csv\">a</a>");
    assert_body("[a](#one:two)\n", "<a href=\"#one:two\">a</a>");
    assert_body("[a](MAILTO:b@example.org)\n", "<a href=\"MAILTO:b@example.org\">a</a>");
    assert_body("[*a*](javascript:b) [c](d)\n", "<p><em>a</em> <a href=\"d\">c</a></p>");
    assert_body("[a](java&#115;cript:b)\n", "<p>a</p>");
    assert_body("[a](javascript&colon;b)\n", "<p>a</p>");
    assert_body("[a](java&#9;script:b) [c](&#1;javascript:b)\n", "<p>a c</p>");
    assert_body("[a](b&#34;&#x3C;&#39;&amp;c)\n", "<p>a</p>");
    assert_body("<DATA:text/html,x>\n", "<p>DATA:text/html,x</p>");
    assert_body("[a](//example.org) [b](httpx:c) [d](:e)\n", "<p>a b d</p>");
    assert_body("www.example.org ~~a~~\n", "<p>www.example.org ~~a~~</p>");
}

static void assert_fails(enum status_code code, const char *markdown, const char *templates, const char *message)
{
    struct text *out = support_text();
    expect_fails(code, message, html_render, out, markdown, "t", DIRECTORY, templates);
}

TEST_CASE(nothing_from_outside)
{
    static const char report[] = "# R\n\n![Figure 1. C](figures/chart.svg)\n\n![x](http://example.org/a.png)\n";
    expect_no_parts(rendered(report), "http:", "https:", " src=\"h", "@import", "<link", "<script", "url(h", "{{");
}

/* Below a second title each section is folded, and its contents go on as before. */
TEST_CASE(folded_sections)
{
    const char *page = rendered("# R\n\n## One\n\na\n\n# Rest\n\nb\n\n## Two\n\n![C](figures/chart.svg)\n\n## Three\n\n"
                                "### Four\n\nc\n");
    const char *body = body_of(page);
    expect_parts(
        body,
        "<h2 id=\"section-2\">One<a id=\"one\"></a></h2>\n<p>a</p>\n<h1 id=\"section-3\">Rest<a "
        "id=\"rest\"></a></h1>\n<p>b</p>\n"
        "<details class=\"folded\"><summary><h2 id=\"section-4\">Two<a id=\"two\"></a></h2></summary>\n<figure>",
        "</figure>\n</details>\n<details class=\"folded\"><summary><h2 id=\"section-5\">",
        "<h3 id=\"section-6\">Four</h3>\n<p>c</p>\n</details>\n</main>");
    assert_non_null(strstr(page, "<li><a href=\"#section-3\">Rest</a></li>\n<li><a href=\"#section-4\">Two</a></li>"));
}

/* A cell in bold is led to by its words, as a heading is. */
TEST_CASE(bold_cells_have_anchors)
{
    const char *page =
        rendered("[x](#elastic-plastic-strip)\n\n| a |\n|---|\n| **Elastic-plastic strip** |\n| plain **b** |\n");
    expect_parts(body_of(page), "<a href=\"#elastic-plastic-strip\">x</a>",
                 "<td><strong>Elastic-plastic strip</strong><a id=\"elastic-plastic-strip\"></a></td>",
                 "<td>plain <strong>b</strong></td>");
}

/* Cells that judge have a class for their colour, and keep mark and words; others have none. */
TEST_CASE(verdicts)
{
    const char *page = rendered("| a | b |\n|---|---:|\n| ✓ met: 1 | ✗ **missed**: 2 |\n| ? undecided | what? |\n");
    const char *body = body_of(page);
    expect_parts(body, "<td><span class=\"met\">✓ met: 1</span></td>",
                 "<span class=\"missed\">✗ <strong>missed</strong>: 2</span></td>",
                 "<td><span class=\"untold\">? undecided</span></td>", ">what?</td>");
}

TEST_CASE(title_is_escaped)
{
    struct text *out = support_text();
    expect_ok(html_render, out, "{{title}}\n", "</title><b> & \"γ\" {{body}}", DIRECTORY, TEMPLATES);
    assert_non_null(strstr(text_string(out), "<title>&lt;/title&gt;&lt;b&gt; &amp; &quot;γ&quot; {{body}}</title>"));
    assert_non_null(
        strstr(body_of(text_string(out)), "<p>{{title}}</p>")); /* what was filled in is not filled in again */
}

TEST_CASE(failures)
{
    assert_fails(STATUS_IO, "![a](figures/missing.svg)\n", TEMPLATES, "figures/missing.svg");
    assert_fails(STATUS_IO, "a ![a](figures/missing.svg)\n", TEMPLATES, "figures/missing.svg");
    assert_fails(STATUS_IO, "a\n", DIRECTORY "/none", "none/page.html");
    assert_fails(STATUS_USAGE, "a\n", DIRECTORY, "page, line 1: tag that is not closed");
}

TEST_CASE(same_bytes_every_time)
{
    static const char report[] = "# R\n\n## S\n\n![C](figures/chart.svg)\n\n| a |\n|---|\n| b |\n";
    assert_string_equal(rendered(report), rendered(report));
}

/* Fragments put together at random: the page keeps its tags in pairs and lets nothing through. */
TEST_CASE(random_markdown)
{
    static const char *const parts[] = {"# ",
                                        "\n## ",
                                        "\n### ",
                                        "\n\n",
                                        "![a](figures/chart.svg)",
                                        "![a",
                                        "](figures/chart.svg)",
                                        "[b](",
                                        "c)",
                                        "<b>",
                                        "javascript:",
                                        "| a | b |\n|---|---:|\n| c |",
                                        "\n> ",
                                        "\n- ",
                                        "`",
                                        "**",
                                        "&lt;",
                                        "&",
                                        "<script>",
                                        "\"",
                                        "'",
                                        "\\",
                                        "\xc3\xa9",
                                        "\xff",
                                        "\n```\n",
                                        "{{body}}",
                                        "text ",
                                        "<http://x>",
                                        "![](x)",
                                        "[![a](figures/chart.svg)](d)",
                                        "    ",
                                        "\n1. "};
    static const char *const pairs[][2] = {{"<a ", "</a>"},   {"<figure>", "</figure>"},  {"<div ", "</div>"},
                                           {"<ul>", "</ul>"}, {"<details", "</details>"}, {"<summary", "</summary>"}};
    uint64_t seed = 7;
    for (int round = 0; round < 1000; round++) {
        struct text *markdown = support_text();
        for (int i = 0; i < 30; i++) {
            seed = seed * 6364136223846793005u + 1442695040888963407u;
            text_add(markdown, "%s", parts[(seed >> 33) % (sizeof parts / sizeof *parts)]);
        }
        OWNED(text_free) struct text page = {0};
        render(&page, text_string(markdown));
        const char *text = text_string(&page);
        expect_no_parts(text, "<script", "<img src", "href=\"javascript");
        for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++)
            if (times(text, pairs[i][0]) != times(text, pairs[i][1]))
                fail_msg("%s without %s: %s", pairs[i][0], pairs[i][1], text_string(markdown));
    }
}
