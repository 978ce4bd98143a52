/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The Debian package: made, checked by lintian if that is installed, unpacked, and the program run from there. */
#include "cli/process.h"

static bool is_there(const char *place, const char *program)
{
    return workspace_can_run(place, filled("command -v %s", program));
}

TEST_IN_WORKSPACE(test_package)
{
    static const char *const needed[] = {CPACK_PROGRAM, "dpkg-deb", "dpkg-shlibdeps", "file", "readelf", "strip"};
    for (size_t i = 0; i < sizeof needed / sizeof *needed; i++)
        if (!is_there(place, needed[i])) {
            print_message("no packages without %s\n", needed[i]);
            skip();
        }
    if (*SANITIZE_OPTIONS) {
        print_message("no packages of a program with sanitizers\n");
        skip();
    }
    (void)expect_status(run_program(place, CPACK_PROGRAM, "-G", "DEB", "-B", "packages", "--config",
                                    BUILD_DIRECTORY "/CPackConfig.cmake"),
                        0);

    /* what each depends on, and holds */
    char *text = workspace_shell(place, "dpkg-deb -f packages/roughcontact_*.deb");
    expect_parts(text, "Package: roughcontact\n", "gnuplot-nox | gnuplot",
                 "libmd4c-html0"); /* GSL and others are inside it */
    expect_no_part(text, "libgsl");
    assert_string_equal(workspace_shell(place, "ls packages/*.deb | wc -l"), "1\n");
    text = workspace_shell(place,
                           "for p in packages/*.deb; do dpkg-deb -x $p root; done; cd root && find usr -type f | sort");
    expect_parts(text, "usr/bin/roughcontact\n", "usr/share/doc/roughcontact/copyright\n",
                 "usr/share/doc/roughcontact/changelog.gz\n", "usr/share/roughcontact/templates/page.html\n",
                 "usr/share/roughcontact/surfaces/chapter6/scene.yaml\n");

    /* the main job, from there, is what it is from the build */
    const char *program = lasting("%s/root/usr/bin/roughcontact", place);
    workspace_scan(place, "d/a.csv", 300, 1);
    report_scene(place, "built", NULL);
    const char *const report[] = {program, "report", "d", "-o", "unpacked", "--no-cost", NULL};
    run_list(place, report);
    expect_digest(place, "unpacked", workspace_digest(place, "built"));

    if (!is_there(place, "lintian")) {
        print_message("not looked over: there is no lintian\n");
        return;
    }
    text = workspace_shell(place, "lintian --fail-on none packages/*.deb");
    expect_no_part(text, "E: ");
}
