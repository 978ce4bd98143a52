/* SPDX-License-Identifier: GPL-3.0-or-later */
/* An installed program finds its templates, also after its tree was moved; and it can be uninstalled. */
#include "cli/process.h"

/** Installs the build into `prefix` of the workspace, and returns its whole path. */
static char *install(const char *place, const char *prefix)
{
    char *path = lasting("%s/%s", place, prefix);
    (void)expect_status(run_program(place, CMAKE_PROGRAM, "--install", BUILD_DIRECTORY, "--prefix", path), 0);
    return path;
}

static int unlink_in(const char *place, const char *path)
{
    return unlink(filled("%s/%s", place, path));
}

static void run_installed(const char *place, const char *program, const char *output)
{
    const char *const arguments[] = {program, "report", "--no-cost", "d",          "-o", output,
                                     "-m",    "tin",    "-e",        "plasticity", NULL};
    run_list(place, arguments);
}

TEST_IN_WORKSPACE(test_install)
{
    static const char *const installed[] = {"roughcontact/templates/page.html", "man/man1/roughcontact.1.gz",
                                            "bash-completion/completions/roughcontact"};
    char *prefix = install(place, "first"), *moved = lasting("%s/moved here", place),
         *links = lasting("%s/roughcontact", place), *program = lasting("%s/bin/roughcontact", prefix),
         *moved_program = lasting("%s/bin/roughcontact", moved);
    for (size_t i = 0; i < sizeof installed / sizeof *installed; i++)
        assert_true(workspace_has(place, filled("first/share/%s", installed[i])));

    workspace_scan(place, "d/a.csv", 200, 1);
    run_installed(place, program, "one");
    char *reference = workspace_digest(place, "one");

    assert_int_equal(rename(prefix, moved), 0);
    run_installed(place, moved_program, "two");
    assert_int_equal(symlink(moved_program, links), 0);
    run_installed(place, links, "three");
    expect_digest(place, "two", reference);
    expect_digest(place, "three", reference);

    /* without its templates it says what to do */
    assert_int_equal(rename(moved, prefix), 0);
    assert_int_equal(rename(lasting("%s/share/roughcontact/templates", prefix), moved), 0);
    const char *const report[] = {program, "report", "d", NULL};
    expect_failed(process_end(process_start_list(place, report, NULL)), 4, 1,
                  "first/share/roughcontact/templates'; install the program with cmake --install");
    assert_false(workspace_has(place, "out"));
}

/** Takes out what the installation before put, as the target `uninstall` does. */
static struct process uninstall(const char *place)
{
    const char *const command[] = {CMAKE_PROGRAM,
                                   "-D",
                                   "MANIFEST=" BUILD_DIRECTORY "/install_manifest.txt",
                                   "-D",
                                   "RECORD=" BUILD_DIRECTORY "/install_folders.txt",
                                   "-P",
                                   PROJECT_SOURCE "/cmake/uninstall.cmake",
                                   NULL};
    return process_end(process_start_list(place, command, NULL));
}

/** Uninstalling removes the installed files and their new folders; what was there before, or came later, stays. */
TEST_IN_WORKSPACE(test_uninstall)
{
    workspace_folder(place, "new");
    install(place, "new/made/by it");
    struct process process = expect_status(uninstall(place), 0);
    assert_true(workspace_has(place, "new"));
    assert_false(workspace_has(place, "new/made"));
    process = uninstall(place); /* nothing is left to take out */
    assert_int_equal(process.status, 1);
    expect_part(process.err, "nothing to uninstall");

    workspace_folder(place, "shared/bin"); /* empty before, and so again */
    workspace_folder(place, "shared/share/doc");
    workspace_write(place, "shared/include/other.h", "");
    install(place, "shared");
    workspace_write(place, "shared/share/roughcontact/surfaces/mine.csv", "");
    workspace_write(place, "shared/share/roughcontact/templates/.hidden", "");
    char *digest = workspace_digest(place, "shared/include/other.h");
    assert_int_equal(unlink_in(place, "shared/share/roughcontact/templates/page.html"), 0); /* gone already */
    process = expect_status(uninstall(place), 0);
    char *left = workspace_shell(place, "cd shared && find . | LC_ALL=C sort | tr '\\n' ' '");
    assert_string_equal(left, ". ./bin ./include ./include/other.h ./share ./share/doc ./share/roughcontact "
                              "./share/roughcontact/surfaces ./share/roughcontact/surfaces/mine.csv "
                              "./share/roughcontact/templates ./share/roughcontact/templates/.hidden ");
    expect_digest(place, "shared/include/other.h", digest);
}
