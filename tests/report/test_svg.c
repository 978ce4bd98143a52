/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Drawings made inline: what is kept, what is changed, what must never come through. */
#include "chart/look.h"
#include "contact/model.h"
#include "report/svg.h"
#include "support.h"

#include <stdio.h>

static const char *const label = "Figure 1. A &quot;chart&quot;";

static enum status_code drawn(struct text *out, const struct text *svg, unsigned number, const char *words,
                              struct status *status)
{
    struct svg_curves curves = {0};
    enum status_code code = svg_inline(out, svg, "figures/x.svg", number, words, &curves, status);
    svg_curves_free(&curves);
    return code;
}

static enum status_code inlined(struct text *out, const char *svg, struct status *status)
{
    struct text text = {0};
    text_add_bytes(&text, svg, strlen(svg));
    enum status_code code = drawn(out, &text, 3, label, status);
    text_free(&text);
    return code;
}

/* `content` inside a drawing gives `expected` inside the page's. */
static void assert_inlined(const char *content, const char *expected)
{
    struct text svg = {0}, out = {0}, page = {0};
    struct status status = {0};
    text_add(&svg, "<svg viewBox=\"0 0 6 4\">%s</svg>", content);
    text_add(&page, "<svg viewBox=\"0 0 6 4\" role=\"img\" aria-label=\"%s\">%s</svg>", label, expected);
    assert_int_equal(inlined(&out, text_string(&svg), &status), STATUS_OK);
    assert_string_equal(text_string(&out), text_string(&page));
    text_free(&svg);
    text_free(&out);
    text_free(&page);
}

static void assert_refused(const char *svg, const char *message)
{
    struct text out = {0};
    struct status status = {0};
    assert_int_equal(inlined(&out, svg, &status), STATUS_IO);
    if (!strstr(status.message, message))
        fail_msg("'%s' does not say '%s'", status.message, message);
    text_free(&out);
}

static struct text read_chart(void)
{
    struct text chart = {0};
    struct status status = {0};
    assert_int_equal(text_read_file(&chart, TEST_DATA "/report/figures/chart.svg", &status), STATUS_OK);
    return chart;
}

TEST_CASE(gnuplot_chart)
{
    static const char *const kept[] = {
        "<svg viewBox=\"0 0 600 420\" role=\"img\" aria-label=\"Figure 1. A &quot;chart&quot;\">",
        "<g id=\"fig3.gnuplot_canvas\">",
        "<use href=\"#fig3.gpPt5\" id=\"fig3.gpPt6\" fill=\"currentColor\" stroke=\"none\"/>",
        "<feFlood flood-color=\"var(--paper)\"",
        "<g fill=\"none\" color=\"var(--ink)\" stroke=\"currentColor\" stroke-width=\"1.00\"",
        "<path stroke=\"var(--ink)\" d=\"M53.84,299.26 L64.34,299.26  \"/>",
        "fill=\"var(--ink)\" font-family=\"sans-serif\"",
        "a &lt; b ]]&gt; c &amp; d &gt; e",
        "<title>surface 1</title>",
        "<pattern id=\"fig3.gpPat1\" patternUnits=\"userSpaceOnUse\"",
        "<polygon fill=\"url(#fig3.gpPat1)\" points=\"53.84,211.94 58.23,214.76 \"/>",
        "color=\"var(--0072b2,#0072b2)\"",
    };
    static const char *const gone[] = {"<rect", "Gnuplot", "GNUPLOT", "xmlns", "http", "<!", "<?", "xlink", "style="};
    struct text chart = read_chart(), out = {0};
    struct status status = {0};
    assert_int_equal(drawn(&out, &chart, 3, label, &status), STATUS_OK);
    for (size_t i = 0; i < sizeof kept / sizeof *kept; i++)
        if (!strstr(text_string(&out), kept[i]))
            fail_msg("no %s in %s", kept[i], text_string(&out));
    for (size_t i = 0; i < sizeof gone / sizeof *gone; i++)
        if (strstr(text_string(&out), gone[i]))
            fail_msg("%s in %s", gone[i], text_string(&out));
    text_free(&chart);
    text_free(&out);
}

TEST_CASE(elements)
{
    assert_inlined("<script>alert(1)</script><g/>", "<g/>");
    assert_inlined("<script> if (a &lt; b) alert(1) </script>", "");
    assert_inlined("<SCRIPT>x</SCRIPT><style>g{}</style><image/><a><path/></a>", "");
    assert_inlined("<foreignObject><g><text>x</text></g></foreignObject><g></g>", "");
    assert_inlined("<title>Gnuplot</title><g><title>a<g/>b</title></g>", "<g><title>ab</title></g>");
    assert_inlined("<svg><g/></svg><set/><animate/>", "");
    assert_inlined("loose<g> text </g><text>kept\n</text>", "<text>kept\n</text>");
    assert_inlined("<text>&#60;b&gt; \"&amp;x;\" ]]></text>", "<text>&lt;b&gt; &quot;&amp;x;&quot; ]]&gt;</text>");
    assert_inlined("<text><script>a</script>b<tspan>c</tspan><a>d</a>e</text>f", "<text>b<tspan>c</tspan>e</text>");
    assert_inlined("<text>&#133;</text>", "<text>\\u0085</text>"); /* a control character of two bytes */
    assert_inlined("<g xmlns:x='http://www.w3.org/1999/xhtml'><x:script>a</x:script></g>", "");
    assert_inlined("<rect fill='White'/><rect fill='rgb(255, 255, 255)'></rect><rect fill='red'/>",
                   "<rect fill=\"red\"/>");
}

TEST_CASE(the_attributes)
{
    assert_inlined("<g onload='x()' onclick=\"y\" ONLOAD='z' tabindex='0' xmlns='a'/>", "<g/>");
    assert_inlined("<use href='http://a/b.svg#c'/><use xlink:href='b.svg'/><use href='#'/>", "<use/><use/><use/>");
    assert_inlined("<use href='#a&quot;b'/><use href='# a'/><use xlink:href='#a'/>",
                   "<use/><use/><use href=\"#fig3.a\"/>");
    assert_inlined("<g fill='url(http://a)' stroke='URL(b.png)' filter='url(#a) url(b)' clip-path='url(#c)'/>",
                   "<g clip-path=\"url(#fig3.c)\"/>");
    assert_inlined("<g fill='u\\72l(a)' stroke='&#117;rl(a)' class='\"' d='a&quot;'/>", "<g/>");
    assert_inlined("<g style='fill:red' d='M0,0\n\tL1,1' class='&lt;&#10;'/>", "<g d=\"M0,0  L1,1\"/>");
    assert_inlined("<g fill='#222222' stroke='Black' color='rgb( 0,0,0 )' d='black'/>",
                   "<g fill=\"var(--ink)\" stroke=\"var(--ink)\" color=\"var(--ink)\" d=\"black\"/>");
    assert_inlined("<g id='a'/><g id='b'/><g id='a'/>", "<g id=\"fig3.a\"/><g id=\"fig3.b\"/><g/>");
    assert_inlined("<g id='' class=''/><g id='a b'/><g id='a:b'/>", "<g class=\"\"/><g/><g id=\"fig3.a:b\"/>");
}

TEST_CASE(malformed)
{
    assert_refused("", "figures/x.svg:1: not a well-formed SVG drawing");
    assert_refused("plain words", "syntax error");
    assert_refused("<svg viewBox='0 0 1 1'>\n\n<g>",
                   "figures/x.svg:3: not a well-formed SVG drawing (no element found)");
    assert_refused("<svg viewBox='0 0 1 1'>\n<g id='a",
                   "figures/x.svg:2: not a well-formed SVG drawing (unclosed token)");
    assert_refused("<svg viewBox='0 0 1 1'><g></svg>", "mismatched tag");
    assert_refused("<html></html>", "does not begin with <svg>");
    assert_refused("<svg/>", "no viewBox");
    assert_refused("<svg viewBox='0 0 1 1&quot; onload=&quot;x'/>", "no viewBox");
    assert_refused("<svg viewBox='0 0 1 1'/><svg viewBox='0 0 1 1'/>", "junk after document element");
    assert_refused("</svg>", "not well-formed");
    assert_refused("<svg viewBox='0 0 1 1'><g a=b/></svg>", "invalid token");
    assert_refused("<svg viewBox='0 0 1 1'><g a='1' a='2'/></svg>", "duplicate attribute");
    assert_refused("<svg viewBox='0 0 1 1'><!-- </svg>", "unclosed token");
    assert_refused("<svg viewBox='0 0 1 1'><text>\x01</text></svg>", "invalid token");
    assert_refused("<svg viewBox='0 0 1 1'><text>\xff</text></svg>", "invalid token");
    assert_refused("<?xml version='1.0' encoding='utf-7'?><svg viewBox='0 0 1 1'><text>+ADw-\xe9</text></svg>",
                   "invalid");
}

/* Two curves of one colour, one of another, and what is grey: only the legend's titles are names. */
TEST_CASE(curves_by_colour)
{
    static const char drawing[] =
        "<svg viewBox='0 0 1 1'><title>Gnuplot</title><path stroke='rgb(9,9,200)'/>"
        "<g id='gnuplot_plot_1'><title>gnuplot_plot_1</title><path stroke='rgb(  0, 114, 178)'/></g>"
        "<g id='gnuplot_plot_2'><title>gnuplot_plot_2</title><polygon fill='#d55e00'/></g>"
        "<g id='gnuplot_plot_3'><title>A &lt; B</title><g stroke='#d55e00'/><path stroke='rgb(0,114,178)'/>"
        "<use color='rgb(1,2,3)'/></g>"
        "<g id='gnuplot_plot_4'><title>outside</title><path stroke='rgb(119,119,119)'/></g></svg>";
    struct text svg = {0}, out = {0};
    struct status status = {0};
    struct svg_curves curves = {0};
    text_add(&svg, "%s", drawing);
    assert_int_equal(svg_inline(&out, &svg, "figures/x.svg", 1, "", &curves, &status), STATUS_OK);
    assert_int_equal(curves.count, 3);
    assert_int_equal(curves.curve[0].colour, 0x0072b2);
    assert_string_equal(text_string(&curves.curve[0].name), "A &lt; B");
    assert_int_equal(curves.curve[1].colour, 0xd55e00);
    assert_int_equal(curves.curve[1].name.length, 0);
    expect_parts(text_string(&out), "<path stroke=\"var(--0072b2,#0072b2)\" class=\"curve1\"/>",
                 "<path stroke=\"var(--0072b2,#0072b2)\" class=\"curve1\"/><use",
                 "<path stroke=\"var(--0909c8,#0909c8)\"/>", "<path stroke=\"var(--777777,#777777)\"/>");
    svg_curves_free(&curves);
    text_free(&svg);
    text_free(&out);
}

TEST_CASE(what_a_point_says)
{
    assert_inlined(
        "<g onmousemove=\"gnuplot_svg.showHypertext(evt,'it&apos;s &lt;1')\" onmouseout=\"x()\"><title> </title>"
        "<circle r=\"1\"/></g><g><title>t</title></g>",
        "<g><title>it's &lt;1</title><circle r=\"1\"/></g><g><title>t</title></g>");
    assert_inlined("<g onmousemove=\"steal(evt,'x')\"><title>t</title></g>", "<g><title>t</title></g>");
    assert_inlined("<g onmousemove=\"gnuplot_svg.showHypertext(evt,'\"/>", "<g/>");
    assert_inlined("<g onmousemove=\"gnuplot_svg.showHypertext(evt,'a')\"/><g/>", "<g><title>a</title></g><g/>");
}

TEST_CASE(cut_off_anywhere)
{
    struct text chart = read_chart();
    size_t whole = (size_t)(strstr(chart.data, "</svg>") - chart.data) + strlen("</svg>");
    for (size_t length = 0; length < whole; length++) {
        struct text svg = {.data = chart.data, .length = length}, out = {0};
        struct status status = {0};
        assert_int_equal(drawn(&out, &svg, 3, label, &status), STATUS_IO);
        assert_int_equal(strncmp(status.message, "figures/x.svg:", 14), 0);
        text_free(&out);
    }
    text_free(&chart);
}

TEST_CASE(entities)
{
    assert_refused("<svg viewBox='0 0 1 1'><text>&x;</text></svg>", "undefined entity");
    assert_refused("<!DOCTYPE svg [<!ENTITY a 'aaaa'><!ENTITY b '&a;&a;'>]>\n<svg viewBox='0 0 1 1'>&b;</svg>",
                   "figures/x.svg:1: not a well-formed SVG drawing (a declaration inside its DOCTYPE)");
    assert_refused("<!DOCTYPE svg SYSTEM 'x.dtd' [<!ENTITY % a SYSTEM 'file:///etc/passwd'> %a;]><svg/>",
                   "declaration");
}

TEST_CASE(nul_byte)
{
    static const char svg[] = "<svg viewBox='0 0 1 1'/>\0<script>";
    struct text text = {0}, out = {0};
    struct status status = {0};
    text_add_bytes(&text, svg, sizeof svg - 1);
    assert_int_equal(drawn(&out, &text, 1, "", &status), STATUS_IO);
    text_free(&text);
    text_free(&out);
}

TEST_CASE(too_deep)
{
    struct text deep = {0}, left_out = {0};
    text_add(&deep, "<svg viewBox='0 0 1 1'>");
    for (int i = 0; i < 100; i++) {
        text_add(&deep, "<g>");
        text_add(&left_out, "<a>");
    }
    for (int i = 0; i < 100; i++)
        text_add(&left_out, "</a>");
    assert_refused(text_string(&deep), "nested too deep");
    assert_inlined(text_string(&left_out), "");
    text_free(&deep);
    text_free(&left_out);
}

/* Whatever went in: tags balance, and no tag carries a handler, an outside reference or an unknown element. */
static void assert_harmless(const char *html)
{
    static const char *const names[] = {"svg",    "g",       "defs",    "path",    "rect",
                                        "circle", "use",     "polygon", "text",    "tspan",
                                        "title",  "pattern", "filter",  "feFlood", "feComposite"};
    int depth = 0;
    for (const char *at = strchr(html, '<'); at; at = strchr(at, '<')) {
        bool closing = at[1] == '/';
        at += closing ? 2 : 1;
        size_t length = strcspn(at, " />"), known = 0, count = sizeof names / sizeof *names;
        while (known < count && !(strlen(names[known]) == length && strncmp(at, names[known], length) == 0))
            known++;
        assert_true(known < count);
        size_t size = strcspn(at, ">");
        assert_int_equal(at[size], '>');
        struct text tag = {0};
        text_add_bytes(&tag, at, size);
        const char *attributes = text_string(&tag);
        expect_no_parts(attributes, " on", "script", "//");
        for (const char *url = strcasestr(attributes, "url"); url; url = strcasestr(url + 1, "url"))
            assert_int_equal(strncmp(url, "url(#fig", 8), 0);
        for (const char *href = strstr(attributes, "href"); href; href = strstr(href + 1, "href"))
            assert_int_equal(strncmp(href, "href=\"#fig", 10), 0);
        depth += closing ? -1 : at[size - 1] == '/' ? 0 : 1;
        assert_true(depth >= 0);
        text_free(&tag);
    }
    assert_int_equal(depth, 0);
}

static uint32_t next_random(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (uint32_t)(*seed >> 33);
}

static void mutate(struct text *out, const struct text *chart, uint64_t *seed)
{
    static const char *const insertions[] = {"<script>",
                                             "</script>",
                                             " onload=\"x\"",
                                             " href='http://a'",
                                             " fill='url(//a)'",
                                             "<!--",
                                             "-->",
                                             "]]>",
                                             "<![CDATA[",
                                             "'",
                                             "\"",
                                             "<",
                                             ">",
                                             "/>",
                                             "&#60;",
                                             "=",
                                             "\\",
                                             "<g>",
                                             "</g>",
                                             "<title>",
                                             " style='fill:url(//a);:;'",
                                             "<svg>",
                                             "url(",
                                             "\t",
                                             "#"};
    size_t copied = 0, changes = 1 + next_random(seed) % 4;
    for (size_t i = 0; i < changes; i++) {
        size_t place = next_random(seed) % (chart->length + 1), skipped = next_random(seed) % 8;
        if (place < copied)
            continue;
        text_add_bytes(out, chart->data + copied, place - copied);
        uint32_t choice = next_random(seed) % 48;
        if (choice < sizeof insertions / sizeof *insertions)
            text_add(out, "%s", insertions[choice]);
        else
            text_add_bytes(out, &(char){(char)next_random(seed)}, 1);
        copied = place + skipped < chart->length ? place + skipped : chart->length;
        if (next_random(seed) % 16 == 0)
            return; /* cut off */
    }
    text_add_bytes(out, chart->data + copied, chart->length - copied);
}

TEST_CASE(mutations)
{
    struct text chart = read_chart();
    uint64_t seed = 20240611;
    size_t accepted = 0, rounds = 20000;
    for (size_t i = 0; i < rounds; i++) {
        struct text svg = {0}, out = {0};
        struct status status = {0};
        mutate(&svg, &chart, &seed);
        enum status_code code = drawn(&out, &svg, 7, label, &status);
        if (code == STATUS_OK) {
            assert_harmless(text_string(&out));
            accepted++;
        } else
            assert_int_equal(code, STATUS_IO);
        text_free(&svg);
        text_free(&out);
    }
    assert_in_range(accepted, rounds / 20, rounds - rounds / 20); /* both ways were walked */
    text_free(&chart);
}

/* Luminance of a colour, and the contrast of two (WCAG 2.1). */
static double luminance(unsigned rgb)
{
    static const double weight[] = {0.2126, 0.7152, 0.0722};
    double sum = 0;
    for (int k = 0; k < 3; k++) {
        double c = (double)(rgb >> (16 - 8 * k) & 255) / 255;
        sum += weight[k] * (c <= 0.04045 ? c / 12.92 : pow((c + 0.055) / 1.055, 2.4));
    }
    return sum;
}

static double contrast(unsigned a, unsigned b)
{
    double x = luminance(a), y = luminance(b);
    return (fmax(x, y) + 0.05) / (fmin(x, y) + 0.05);
}

/* Every colour of a curve stands out from the dark page as it is there, and dark ones from the white page. */
TEST_CASE(dark_page)
{
    struct status status = {0};
    struct text page = {0};
    assert_int_equal(text_read_file(&page, PROJECT_SOURCE "/templates/page.html", &status), STATUS_OK);
    const char *dark = strstr(page.data, "(prefers-color-scheme: dark)");
    unsigned paper;
    assert_non_null(dark);
    assert_int_equal(sscanf(strstr(dark, "--paper: #"), "--paper: #%6x", &paper), 1);
    static const char *const others[] = {"s1", "s2", "s3", "s4", "s5", "s6", "s7",  "s8", "r1", "r2",
                                         "r3", "r4", "r5", "r6", "r7", "r8", "r9",  "c1", "c2", "c3",
                                         "c4", "c5", "c6", "c7", "c8", "c9", "dirp"}; /* the others are ink and grey */
    enum { OTHERS = sizeof others / sizeof *others };
    for (size_t i = 0; i < OTHERS + model_count; i++) {
        unsigned colour, shown;
        char name[16];
        struct look look = look_of(i < OTHERS ? others[i] : model_rows[i - OTHERS]->style);
        assert_non_null(look.colour);
        assert_int_equal(sscanf(look.colour, "#%6x", &colour), 1);
        shown = colour;
        snprintf(name, sizeof name, "--%06x: #", colour);
        const char *own = strstr(dark, name);
        if (own)
            assert_int_equal(sscanf(own + strlen(name), "%6x", &shown), 1);
        if (contrast(shown, paper) < 3.8 || contrast(colour, 0xffffff) < 2.3)
            fail_msg("#%06x: %.2f on the dark page as #%06x, %.2f on white", colour, contrast(shown, paper), shown,
                     contrast(colour, 0xffffff));
    }
    text_free(&page);
}

/* A colour of a chart comes with its name on the page, whatever its form; what is none stays. */
TEST_CASE(colours)
{
    assert_inlined("<g stroke='rgb( 18,  87, 208)' fill='#CC5500' color='none'/>",
                   "<g stroke=\"var(--1257d0,#1257d0)\" fill=\"var(--cc5500,#cc5500)\" color=\"none\"/>");
    assert_inlined("<g stroke='rgb(1,2,300)' fill='#12345' color='#1234567'/>",
                   "<g stroke=\"rgb(1,2,300)\" fill=\"#12345\" color=\"#1234567\"/>");
    assert_inlined("<g stroke='rgb(1,2,3) red' fill='rgb(1,2,-3)'/>",
                   "<g stroke=\"rgb(1,2,3) red\" fill=\"rgb(1,2,-3)\"/>");
}
