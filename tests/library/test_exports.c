/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What libroughcontact.so shows: the functions of its header, no more and no fewer. */
#include "cli/process.h"

enum { NAMES = 1024, NAME = 64 };

struct names {
    char name[NAMES][NAME];
    size_t count;
};

static void add(struct names *names, const char *name, size_t length)
{
    assert_true(names->count < NAMES && length < NAME);
    memcpy(names->name[names->count], name, length);
    names->name[names->count++][length] = '\0';
}

static bool has(const struct names *names, const char *name)
{
    for (size_t i = 0; i < names->count; i++)
        if (strcmp(names->name[i], name) == 0)
            return true;
    return false;
}

static bool is_word(char c)
{
    return c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/** Every function that the header declares: a name between ROUGHCONTACT_API and the next bracket. */
static struct names read_header(void)
{
    static struct names names;
    char *text = workspace_read(PROJECT_SOURCE, "src/library/roughcontact.h");
    const char *at = strstr(text, "extern \"C\"");
    names.count = 0;
    while ((at = strstr(at, "ROUGHCONTACT_API"))) {
        const char *bracket = strchr(at, '('), *start = bracket;
        while (start > at && is_word(start[-1]))
            start--;
        add(&names, start, (size_t)(bracket - start));
        at = bracket;
    }
    return names;
}

/** Names that nm prints with `option`, without their versions. */
static struct names read_symbols(const char *option)
{
    static struct names names;
    const char *const nm[] = {"nm", "-D", option, LIBRARY, NULL};
    struct process process = process_expect(process_end(process_start_list("/", nm, NULL)), 0, __FILE__, __LINE__);
    names.count = 0;
    for (char *line = strtok(process.out, "\n"); line; line = strtok(NULL, "\n")) {
        const char *name = strrchr(line, ' ') + 1;
        if (strncmp(name - 2, "A ", 2) != 0) /* the version itself */
            add(&names, name, strcspn(name, "@"));
    }
    return names;
}

TEST_CASE(only_the_header_is_exported)
{
    struct names declared = read_header(), exported = read_symbols("--defined-only");
    assert_true(declared.count >= 20);
    for (size_t i = 0; i < declared.count; i++)
        if (!has(&exported, declared.name[i]))
            fail_msg("%s is declared, but not exported", declared.name[i]);
    for (size_t i = 0; i < exported.count; i++)
        if (!has(&declared, exported.name[i]) && strncmp(exported.name[i], "__odr_asan", 10) != 0)
            fail_msg("%s is exported, but not declared", exported.name[i]);
}

/** It cannot print, end the program, take its signals or read a scene: it does not even know how. (sigaction() and
 * _exit() are there for a child that becomes another program, which readers start for the program alone.) */
TEST_CASE(it_leaves_the_host_alone)
{
    static const char *const never[] = {
        "printf",       "puts",   "putchar",   "perror", "fprintf",       "vprintf",         "exit",  "abort",
        "quick_exit",   "signal", "setlocale", "srand",  "rand",          "system",          "popen", "fork",
        "__printf_chk", "stdout", "stderr",    "atexit", "__fprintf_chk", "yaml_parser_load"};
    struct names used = read_symbols("--undefined-only");
    assert_true(has(&used, "malloc"));
    for (size_t i = 0; i < sizeof never / sizeof *never; i++)
        if (has(&used, never[i]))
            fail_msg("the library uses %s", never[i]);
}

/** The header stands alone, in C and in C++, under strict warnings. */
TEST_IN_WORKSPACE(the_header_stands_alone)
{
    static const char *const languages[][3] = {{"cc", "c", "-std=c99"}, {"c++", "c++", "-std=c++11"}};
    char include[512];
    snprintf(include, sizeof include, "-I%s/src/library", PROJECT_SOURCE);
    workspace_write(place, "use",
                    "#include <roughcontact.h>\n#include <roughcontact.h>\n"
                    "int main() { struct roughcontact_run_options how;\n"
                    "roughcontact_run_options_init(&how);\n"
                    "return roughcontact_model_name(0) == 0; }\n");
    for (size_t i = 0; i < 2; i++) {
        const char *compiler = i == 0 ? C_COMPILER : languages[i][0];
        const char *const there[] = {"sh", "-c", "command -v \"$0\"", compiler, NULL};
        struct process found = process_end(process_start_list(place, there, NULL));
        int missing = found.status;
        if (missing && i == 1) {
            print_message("there is no C++ compiler here\n");
            continue;
        }
        const char *const compile[] = {compiler,  "-x",        languages[i][1], languages[i][2], "-Wall", "-Wextra",
                                       "-Werror", "-pedantic", "-Wconversion",  "-fsyntax-only", include, "use",
                                       NULL};
        run_list(place, compile);
    }
}
