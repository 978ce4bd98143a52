/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/mustache.h"
#include "base/limits.h"
#include "base/number_format.h"
#include "base/unit.h"

#include <stdlib.h>
#include <string.h>

/* A template is cut into tokens first, since only a whole line shows whether a tag stands alone on it; then the tokens
 * are rendered, those of a section once for each item. */

enum { DEPTH_MOST = 64, NAME_MOST = 200 };

enum token_kind { TOKEN_TEXT, TOKEN_VARIABLE, TOKEN_RAW, TOKEN_SECTION, TOKEN_INVERTED, TOKEN_END, TOKEN_PARTIAL };

struct token {
    enum token_kind kind;
    const char *start; /* of its text, or of its name */
    size_t length;
    const char *indent; /* of a partial that stands alone on its line: blanks before it */
    size_t indent_length;
    size_t end; /* of a section: the token that ends it */
};

struct tokens {
    const char *source, *name; /* of the template */
    struct token *token;       /* room for as many as the template has characters, and two */
    size_t count;
};

struct render {
    const struct mustache *how;
    struct text *out;
    struct status *status;
    const char *name;                /* of the whole */
    const json_t *stack[DEPTH_MOST]; /* what names are looked up in, the last first */
    size_t depth, partials;
    size_t item, items; /* of the innermost list that is gone over; 0: none is */
    size_t steps;       /* tokens rendered and objects looked into */
    size_t open;        /* bytes of the templates nested at the moment */
};

/** Bytes of a tag that a one-line message shows. */
static int first_line(const char *tag, size_t length)
{
    size_t line = strcspn(tag, "\r\n");
    return (int)(line < length ? line : length);
}

/** `at`: where in the template; `shown`: what the message quotes. */
static enum status_code fail(const struct tokens *tokens, const char *at, const char *what, const struct token *shown,
                             struct status *status)
{
    int line = 1;
    for (const char *p = tokens->source; p < at; p++)
        line += *p == '\n';
    return status_fail(status, STATUS_USAGE, "%s, line %d: %s '%.*s'", tokens->name, line, what,
                       first_line(shown->start, shown->length), shown->start);
}

static enum status_code refuse(struct status *status, const char *name, const char *what, enum limit limit)
{
    return status_fail(status, STATUS_USAGE, "template '%.400s' %s%s", name, what, limit_words(limit).text);
}

/** The tag's name without blanks around it. */
static void trim(const char **start, size_t *length)
{
    size_t blanks = strspn(*start, " \t\r\n"); /* the delimiter behind ends them */
    *start += blanks;
    *length -= blanks;
    while (*length > 0 && strchr(" \t\r\n", (*start)[*length - 1]))
        --*length;
}

/** Delimiters: "{{" and "}}" until a tag {{=<% %>=}} says others. */
struct delimiters {
    char open[16], close[16];
};

static bool set_delimiters(struct delimiters *out, const char *text, size_t length)
{
    char copy[40] = "";
    struct delimiters found = {"", ""};
    if (length < 2 || length >= sizeof copy || text[length - 1] != '=' ||
        sscanf(memcpy(copy, text, length - 1), " %15s %15s", found.open, found.close) != 2)
        return false;
    *out = found;
    return true;
}

/** Does a tag of these borders stand alone on its line? Then *start and *end become those of the line. */
static bool alone(const char *source, const char **start, const char **end)
{
    const char *first = *start, *last = *end;
    while (first > source && (first[-1] == ' ' || first[-1] == '\t'))
        first--;
    last += strspn(last, " \t");
    if ((first > source && first[-1] != '\n') || (*last && *last != '\n' && strncmp(last, "\r\n", 2) != 0))
        return false;
    last += *last == '\r';
    last += *last == '\n';
    *start = first;
    *end = last;
    return true;
}

/** Cuts the template. */
static enum status_code tokenize(struct tokens *out, struct status *status)
{
    static const char signs[] = "#^/>!={&";
    static const enum token_kind kinds[] = {TOKEN_SECTION, TOKEN_INVERTED, TOKEN_END, TOKEN_PARTIAL,
                                            TOKEN_TEXT,    TOKEN_TEXT,     TOKEN_RAW, TOKEN_RAW};
    struct delimiters delimiters = {"{{", "}}"};
    size_t open[DEPTH_MOST], depth = 0;
    const char *p = out->source;
    for (const char *tag; (tag = strstr(p, delimiters.open));) {
        const char *inside = tag + strlen(delimiters.open), *sign = *inside ? strchr(signs, *inside) : NULL;
        inside += sign != NULL; /* with which a closing delimiter may begin, too */
        char closing[24];
        snprintf(closing, sizeof closing, "%s%s", sign && *sign == '{' ? "}" : "", delimiters.close);
        const char *close = strstr(inside, closing);
        if (!close)
            return fail(out, tag, "tag that is not closed:", &(struct token){.start = tag, .length = strlen(tag)},
                        status);
        const char *start = tag, *end = close + strlen(closing);
        struct token token = {
            .kind = sign ? kinds[sign - signs] : TOKEN_VARIABLE, .start = inside, .length = (size_t)(close - inside)};
        bool line = sign && *sign != '{' && *sign != '&' && alone(out->source, &start, &end);
        if (start < p)
            start = p; /* two tags on one line: blanks before the second belong to the first */
        out->token[out->count++] = (struct token){.start = p, .length = (size_t)(start - p)};
        if (sign && *sign == '=' && !set_delimiters(&delimiters, token.start, token.length))
            return fail(out, tag, "delimiters not understood:", &token, status);
        p = end;
        if (token.kind == TOKEN_TEXT)
            continue;
        trim(&token.start, &token.length);
        if (line && token.kind == TOKEN_PARTIAL) {
            token.indent = start;
            token.indent_length = (size_t)(tag - start);
        }
        if (token.kind == TOKEN_SECTION || token.kind == TOKEN_INVERTED) {
            if (depth == DEPTH_MOST)
                return fail(out, tag, "too many sections within each other:", &token, status);
            open[depth++] = out->count;
        }
        if (token.kind == TOKEN_END) {
            const struct token *begun = depth > 0 ? &out->token[open[--depth]] : NULL;
            if (!begun || begun->length != token.length || memcmp(begun->start, token.start, token.length) != 0)
                return fail(out, tag, "section ended that is not open:", &token, status);
            out->token[open[depth]].end = out->count;
        }
        out->token[out->count++] = token;
    }
    if (depth > 0)
        return fail(out, out->token[open[0]].start, "section that does not end:", &out->token[open[0]], status);
    out->token[out->count++] = (struct token){.start = p, .length = strlen(p)};
    return STATUS_OK;
}

/** Is it the `first` item of the list, the `last`, or are there `more`? NULL: that is none of these, or there is no
 * list.
 */
static const json_t *place_of_item(const struct render *render, const char *start, size_t length)
{
    static const char *const names[] = {"first", "last", "more"};
    const bool is[] = {render->item == 0, render->item + 1 == render->items, render->item + 1 < render->items};
    for (size_t n = 0; n < sizeof names / sizeof *names && render->items > 0; n++)
        if (length == strlen(names[n]) && memcmp(start, names[n], length) == 0)
            return json_boolean(is[n]);
    return NULL;
}

/** The value of a name; NULL: none. The first part of a.b.c is looked up in all open sections. */
static const json_t *look_up(struct render *render, const char *start, size_t length)
{
    const char *dot = memchr(start, '.', length), *end = start + length;
    const json_t *found = NULL;
    if (length == 1 && dot)
        return render->stack[render->depth - 1];
    for (size_t d = render->depth; d-- > 0 && !found; render->steps += 1 + length / NAME_MOST)
        found = json_object_getn(render->stack[d], start, (size_t)((dot ? dot : end) - start));
    while (found && dot) {
        start = dot + 1;
        dot = memchr(start, '.', (size_t)(end - start));
        found = json_object_getn(found, start, (size_t)((dot ? dot : end) - start));
    }
    return found || dot ? found : place_of_item(render, start, length);
}

/** A number, an array of two, or an object of two: `least` and `most`, or `value` and `error`, with digits and in the
 * unit that `how` says, "3 um", or as printf has it, "4g Pa". False: it says none. */
static bool word_numbers(struct text *out, const json_t *value, const char *how, size_t length)
{
    static const char *const names[][2] = {{"least", "most"}, {"value", "error"}};
    const bool uncertain = json_object_get(value, "error");
    struct unit unit = {.factor = 1};
    double shown[2];
    char *rest;
    int digits = (int)strtol(how, &rest, 10);
    bool plain = *rest == 'g';
    rest += plain;
    rest += strspn(rest, " ");
    if (digits < 1 || digits > 17 || (rest < how + length && !unit_read(&unit, rest, (size_t)(how + length - rest))))
        return false;
    for (int i = 0; i < 2; i++)
        shown[i] = (json_number_value(json_is_object(value)  ? json_object_get(value, names[uncertain][i])
                                      : json_is_array(value) ? json_array_get(value, (size_t)i)
                                                             : value) -
                    unit.offset) /
                   unit.factor;
    if (uncertain)
        number_format_uncertain(out, shown[0], shown[1]);
    else if (plain)
        text_add(out, "%.*g", digits, shown[0]);
    else
        number_format_range(out, shown[0], shown[1], digits, " to ");
    return true;
}

/** The value of a {{variable}}, or of a {{number|3 um}}. */
static enum status_code render_value(struct render *render, const struct token *token)
{
    const char *bar = memchr(token->start, '|', token->length);
    const size_t length = bar ? (size_t)(bar - token->start) : token->length;
    const json_t *value = look_up(render, token->start, length);
    OWNED(text_free) struct text words = {0};
    if (bar && (json_is_number(value) || json_is_object(value) || json_is_array(value)) &&
        !word_numbers(&words, value, bar + 1, token->length - length - 1))
        return status_fail(render->status, STATUS_USAGE, "'%s': no digits and unit: '%.*s'", render->name,
                           first_line(token->start, token->length), token->start);
    if (json_is_string(value))
        text_add_bytes(&words, json_string_value(value), json_string_length(value));
    else if (json_is_integer(value) && !bar)
        text_add(&words, "%lld", (long long)json_integer_value(value));
    else if (json_is_real(value) && !bar)
        text_add(&words, "%.15g", json_real_value(value));
    else if (json_is_boolean(value))
        text_add(&words, "%s", json_is_true(value) ? "true" : "false");
    if (token->kind == TOKEN_RAW || !render->how->escape)
        text_add_bytes(render->out, text_string(&words), words.length);
    else
        render->how->escape(render->out, text_string(&words));
    render->out->failed |= words.failed;
    return STATUS_OK;
}

static bool holds(const json_t *value)
{
    return !(!value || json_is_null(value) || json_is_false(value) ||
             (json_is_array(value) && json_array_size(value) == 0) ||
             (json_is_string(value) && json_string_length(value) == 0));
}

static enum status_code render_tokens(struct render *render, const struct tokens *tokens, size_t from, size_t to);

static enum status_code render_text(struct render *render, const char *source, const char *name)
{
    const size_t length = strlen(source);
    render->open += length;
    render->steps += length;
    if (render->open > limit_most(LIMIT_TEMPLATE_BYTES))
        return refuse(render->status, name, "is too long", LIMIT_TEMPLATE_BYTES);
    struct tokens tokens = {source, name, calloc(length + 2, sizeof *tokens.token), 0};
    enum status_code rc = tokens.token ? tokenize(&tokens, render->status) : status_memory(render->status);
    if (rc == STATUS_OK)
        rc = render_tokens(render, &tokens, 0, tokens.count);
    free(tokens.token);
    render->open -= length;
    return rc;
}

static enum status_code render_partial(struct render *render, const struct token *token)
{
    char name[NAME_MOST];
    OWNED(text_free) struct text indented = {0};
    snprintf(name, sizeof name, "%.*s", first_line(token->start, token->length), token->start);
    const char *source = render->how->partial ? render->how->partial(render->how->context, name) : NULL;
    if (!source)
        return render->status->code;
    if (++render->partials > DEPTH_MOST)
        return status_fail(render->status, STATUS_USAGE, "template '%s' holds itself without end", name);
    for (const char *line = source; *line && indented.length <= limit_most(LIMIT_TEMPLATE_BYTES);) {
        size_t length = strcspn(line, "\n");
        length += line[length] == '\n';
        text_add_bytes(&indented, token->indent_length ? token->indent : "", token->indent_length);
        text_add_bytes(&indented, line, length);
        line += length;
    }
    enum status_code rc = render_text(render, text_string(&indented), name);
    render->partials--;
    return rc;
}

static enum status_code render_section(struct render *render, const struct tokens *tokens, size_t at)
{
    const struct token *token = &tokens->token[at];
    const json_t *value = look_up(render, token->start, token->length);
    if (holds(value) == (token->kind == TOKEN_INVERTED))
        return STATUS_OK;
    if (token->kind == TOKEN_INVERTED)
        return render_tokens(render, tokens, at + 1, token->end);
    if (render->depth == DEPTH_MOST)
        return status_fail(render->status, STATUS_USAGE, "too many sections within each other: '%.*s'",
                           first_line(token->start, token->length), token->start);
    const bool list = json_is_array(value);
    const size_t items = list ? json_array_size(value) : 1, item = render->item, of = render->items;
    enum status_code rc = STATUS_OK;
    for (size_t i = 0; i < items && rc == STATUS_OK; i++) {
        render->item = list ? i : item;
        render->items = list ? items : of;
        render->stack[render->depth++] = list ? json_array_get(value, i) : value;
        rc = render_tokens(render, tokens, at + 1, token->end);
        render->depth--;
    }
    render->item = item;
    render->items = of;
    return rc;
}

static enum status_code render_tokens(struct render *render, const struct tokens *tokens, size_t from, size_t to)
{
    enum status_code rc = STATUS_OK;
    for (size_t i = from; i < to && rc == STATUS_OK; i++) {
        const struct token *token = &tokens->token[i];
        if (render->steps++ > limit_most(LIMIT_TEMPLATE_STEPS))
            return refuse(render->status, render->name, "takes too many steps", LIMIT_TEMPLATE_STEPS);
        if (render->out->length > limit_most(LIMIT_PAGE_BYTES))
            return refuse(render->status, render->name, "makes too long a page", LIMIT_PAGE_BYTES);
        if (token->kind == TOKEN_TEXT)
            text_add_bytes(render->out, token->start, token->length);
        else if (token->kind == TOKEN_VARIABLE || token->kind == TOKEN_RAW)
            rc = render_value(render, token);
        else if (token->kind == TOKEN_PARTIAL)
            rc = render_partial(render, token);
        else if (token->kind != TOKEN_END) {
            rc = render_section(render, tokens, i);
            i = token->end;
        }
    }
    return rc;
}

enum status_code mustache_render(struct text *out, const char *source, const char *name, const struct mustache *how,
                                 struct status *status)
{
    struct render render = {.how = how, .out = out, .status = status, .name = name, .stack = {how->view}, .depth = 1};
    enum status_code rc = render_text(&render, source, name);
    return rc == STATUS_OK && out->failed ? status_memory(status) : rc;
}

const char *mustache_folder_partial(void *context, const char *name)
{
    struct mustache_folder *folder = context;
    const char *known = json_string_value(json_object_get(folder->read, name));
    OWNED(text_free) struct text path = {0}, content = {0};
    if (known)
        return known;
    if (!folder->read)
        folder->read = json_object();
    text_add(&path, "%s/%s%s", folder->path, name, folder->ending);
    if (strncmp(name, "../", 3) == 0 || strstr(name, "/../")) /* it would lead out of the folder */
        (void)status_fail(folder->status, STATUS_USAGE, "'%.400s' is no name for a part of a template", name);
    else if (text_read_file(&content, text_string(&path), folder->status) == STATUS_OK &&
             (strlen(text_string(&content)) < content.length ||
              json_object_set_new(folder->read, name, json_string(text_string(&content))) != 0))
        (void)status_fail(folder->status, STATUS_USAGE, "%.400s: no text in UTF-8", text_string(&path));
    return json_string_value(json_object_get(folder->read, name));
}

void mustache_folder_free(struct mustache_folder *folder)
{
    json_decref(folder->read);
    folder->read = NULL;
}

enum status_code mustache_file(struct text *out, struct mustache_folder *folder, const char *name, const json_t *view,
                               void (*escape)(struct text *out, const char *string))
{
    const char *source = mustache_folder_partial(folder, name);
    struct mustache how = {view, escape, mustache_folder_partial, folder};
    return source ? mustache_render(out, source, name, &how, folder->status) : folder->status->code;
}
