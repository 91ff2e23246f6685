// The command resolve with a scene, as a user runs it.
#include "program/scene_resolving.h"

#include "support/json.h"
#include "support/program.h"
#include "support/support.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// A floor, and a tripod that falls through it within two steps.
#define FLOOR "v -9 -9 0\nv 9 -9 0\nv 0 9 0\nf 1 2 3\n"
#define FACES "f 1 2 3\nf 1 2 4\n"
#define HIGH "v 0 0 2\nv 1 0 3\nv 0 1 3\nv 1 1 3\n" FACES
#define LOW "v 0 0 1\nv 1 0 2\nv 0 1 2\nv 1 1 2\n" FACES
#define BELOW "v 0 0 -1\nv 1 0 0.5\nv 0 1 0.5\nv 1 1 0.5\n" FACES

#define SCENE                                                                  \
    "meshes:\n- frames: floor.obj\n  role: fixed\n"                            \
    "- name: tripod\n  frames: [high.obj, low.obj, below.obj]\n"

static void enter_folder_with_files(void)
{
    enter_folder();
    make_file("floor.obj", FLOOR);
    make_file("high.obj", HIGH);
    make_file("low.obj", LOW);
    make_file("below.obj", BELOW);
    make_file("scene.yaml", SCENE);
}

// What is written -------------------------------------------------------------

START_TEST(frames_of_what_moves_are_written)
{
    expect(run("$tf resolve scene.yaml -o made >report && ls -A made"), 0,
           "tripod-00000.obj\ntripod-00001.obj\ntripod-00002.obj\n", "");
    expect(
        run("$tf detect --format summary high.obj made/tripod-00000.obj "
            "low.obj made/tripod-00001.obj | tail -n 1; "
            "for i in 0 1 2; do $tf check floor.obj made/tripod-0000$i.obj || "
            "exit; done"),
        0,
        "decided by signs: 0\n"
        "file,kind,a,b,c,d,e,f,other_file\n"
        "file,kind,a,b,c,d,e,f,other_file\n"
        "file,kind,a,b,c,d,e,f,other_file\n",
        "");
    // The first two are as they were proposed.
    expect(
        run("grep '^v' made/tripod-00000.obj; grep '^v' made/tripod-00001.obj"),
        0,
        "v 0 0 2\nv 1 0 3\nv 0 1 3\nv 1 1 3\nv 0 0 1\nv 1 0 2\nv 0 1 2\n"
        "v 1 1 2\n",
        "");
    expect_words(run("$tf detect low.obj below.obj --format summary").out,
                 "contacts: 0");
}
END_TEST

START_TEST(the_step_to_each_frame_is_clear)
{
    run("$tf resolve scene.yaml -o made");
    make_file("resolved.yaml", "meshes: [{frames: floor.obj, role: fixed}, "
                               "{frames: made/tripod-*.obj}]");
    expect_words(run("$tf detect scene.yaml --format summary").out,
                 "steps: 2\nsteps with contacts: 1\n");
    expect_words(run("$tf detect resolved.yaml --format summary").out,
                 "steps: 2\nsteps with contacts: 0\n");
}
END_TEST

START_TEST(two_frames_are_enough)
{
    make_file("two.yml", "meshes: [{frames: floor.obj, role: scripted}, "
                         "{name: t, frames: [low.obj, below.obj]}]");
    expect(run("$tf resolve two.yml -o made --format csv | cut -d , -f 1,2 && "
               "ls made"),
           0, "step,status\n0,resolved\nt-00000.obj\nt-00001.obj\n", "");
}
END_TEST

START_TEST(each_mesh_keeps_its_format)
{
    make_file("high.ply",
              "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\n"
              "property double y\nproperty double z\nelement face 1\n"
              "property list uchar int vertex_indices\nend_header\n"
              "0 0 9\n1 0 9\n0 1 9\n3 0 1 2\n");
    make_file("two.yaml", "meshes: [{frames: [low.obj, below.obj], name: t}, "
                          "{frames: high.ply}, "
                          "{frames: floor.obj, role: fixed}]");
    expect(run("$tf resolve two.yaml -o made >report; ls made; "
               "head -n 2 made/high-00001.ply | tail -n 1"),
           0,
           "high-00000.ply\nhigh-00001.ply\nt-00000.obj\nt-00001.obj\n"
           "format ascii 1.0\n",
           "");
}
END_TEST

// The tripod stands in the way of the floor, which rises and takes it along;
// with one frame, it stays where the last step has left it.
// The floor can be pushed, but for its pinned vertices.
START_TEST(pinned_vertices_go_where_their_frames_say)
{
    make_file("scene.yaml", "meshes:\n- frames: floor.obj\n  pinned: [1, 0]\n"
                            "- frames: [low.obj, below.obj]\n"
                            "  role: scripted\n");
    ck_assert_int_eq(run("$tf resolve scene.yaml -o made").status, 0);
    outcome found = run("diff floor.obj made/floor-00001.obj");
    ck_assert_int_eq(found.status, 1);
    ck_assert_int_eq(occurrences(found.out, "\n<"), 1);
    expect_words(found.out, "< v 0 9 0\n");
    make_file("scene.yaml", SCENE "  pinned:\n  - 4\n");
    expect(run("$tf resolve scene.yaml -o other"), 2, "",
           "tanglefree: scene.yaml:7: 'tripod' has no vertex 4; its vertices "
           "are numbered from 0 to 3\n");
}
END_TEST

START_TEST(a_mesh_of_one_frame_stays_where_it_was_pushed)
{
    make_file("up1.obj", "v -9 -9 3\nv 9 -9 3\nv 0 9 3\nf 1 2 3\n");
    make_file("up2.obj", "v -9 -9 3\nv 9 -9 3\nv 0 9 3\nf 1 2 3\n");
    make_file("up.yaml", "meshes:\n- frames: [floor.obj, up1.obj, up2.obj]\n"
                         "  role: scripted\n- {name: t, frames: high.obj}\n");
    expect(run("$tf resolve up.yaml -o made --format csv | cut -d , -f 1,2"), 0,
           "step,status\n0,resolved\n1,clear\n", "");
    expect(
        run("cmp made/t-00001.obj made/t-00002.obj && "
            "$tf check up1.obj made/t-00001.obj --format summary | tail -n 1 "
            "&& ! cmp -s made/t-00000.obj made/t-00001.obj"),
        0, "intersections: 0\n", "");
}
END_TEST

// In the plane two scripted plates close upon a bar.
START_TEST(scripted_meshes_that_are_held_back_are_written)
{
    make_file("open.obj", "v -2 -1\nv 2 -1\nv -2 1\nv 2 1\nl 1 2\nl 3 4\n");
    make_file("closed.obj", "v -2 1\nv 2 1\nv -2 -1\nv 2 -1\nl 1 2\nl 3 4\n");
    make_file("bar.obj", "v -1 0\nv 1 0\nl 1 2\n");
    make_file("press.yaml", "meshes: [{name: plates, role: scripted, "
                            "frames: [open.obj, closed.obj]}, "
                            "{frames: bar.obj}]");
    expect(run("$tf resolve press.yaml -o made >report; ls made; "
               "grep -e held report; "
               "$tf check made/*1.obj --format summary | tail -n 1"),
           0,
           "bar-00000.obj\nbar-00001.obj\nplates-00001.obj\nheld steps: 1\n"
           "intersections: 0\n",
           "tanglefree: plates was held back in frame 1; made/plates-00001.obj "
           "has its actual positions\n");
}
END_TEST

// Reports ---------------------------------------------------------------------

START_TEST(a_report_has_a_row_for_each_step)
{
    outcome found = run("$tf resolve scene.yaml -o made --format json");
    ck_assert_msg(!json_fault(found.out), "%s", json_fault(found.out));
    expect_words(found.out, "{\"steps\":[\n{\"step\":0,\"status\":\"clear\",");
    expect_words(found.out, "},\n{\"step\":1,\"status\":\"resolved\",");
    expect_words(found.out,
                 "\"exempt_crossings\":0}\n],\n\"summary\":{\"steps\":2,"
                 "\"resolved_steps\":1,\"first_contacts\":");
    found = run("$tf resolve scene.yaml -o csv-out --format csv | head -n 1");
    expect_words(found.out, "step,status,first_contacts,contacts,");
    expect_words(found.out, ",near_at_start,exempt_zones,exempt_crossings\n");
    found = run("$tf resolve scene.yaml -o more | cut -d : -f 1");
    expect(found, 0,
           "steps\nresolved steps\nfirst contacts\nheld steps\nseconds\n", "");
}
END_TEST

START_TEST(threads_change_nothing)
{
    expect(run("for t in 1 2 7; do $tf resolve scene.yaml -o made$t -t $t "
               ">report; done; diff -r made1 made2 && diff -r made1 made7"),
           0, "", "");
}
END_TEST

// Options reach the response: with a thickness, the tripod keeps its distance.
START_TEST(options_are_passed_on)
{
    expect(run("$tf resolve scene.yaml -o made --thickness 0.25 >report; "
               "$tf resolve scene.yaml -o near >report; "
               "for f in made near; do $tf check --thickness 0.25 floor.obj "
               "$f/tripod-00002.obj --format summary | tail -n 1; done"),
           0, "near pairs: 0\nnear pairs: 1\n", "");
}
END_TEST

// Mistakes --------------------------------------------------------------------

START_TEST(starts_that_are_not_clear_are_refused)
{
    make_file("in.obj", "v 0 0 -1\nv 0 0 1\nv 0 1 1\nf 1 2 3\n");
    make_file("in.yaml", "meshes: [{frames: [floor.obj, floor.obj]}, "
                         "{frames: in.obj}]");
    expect(run("$tf resolve in.yaml -o made"), 2, "",
           "tanglefree: in.obj: edge 0 1 passes through triangle 0 1 2 of "
           "floor.obj (numbered from 0) before the step begins; move them "
           "apart, see 'tanglefree check' for all such pairs\n");
    ck_assert_int_ne(run("ls made").status, 0);
    // Meshes of a group are no business of each other, nor are scripted ones.
    make_file("in.yaml", "meshes: [{frames: [floor.obj, floor.obj], group: a}, "
                         "{frames: in.obj, group: a}]");
    ck_assert_int_eq(run("$tf resolve in.yaml -o made2").status, 0);
    make_file("in.yaml",
              "meshes: [{frames: [floor.obj, floor.obj], role: scripted}, "
              "{frames: in.obj, role: fixed}]");
    expect(run("$tf resolve in.yaml -o made3"), 2, "",
           "tanglefree: in.yaml: no mesh is moving, so there is nothing to "
           "resolve; let one be, by its role\n");
    make_file("far.obj", "v 9 9 9\nv 9 9 8\nv 9 8 9\nf 1 2 3\n");
    make_file("in.yaml",
              "meshes: [{frames: [floor.obj, floor.obj], role: scripted}, "
              "{frames: in.obj, role: fixed}, {frames: far.obj}]");
    expect(run("$tf resolve in.yaml -o made3 >report && ls made3"), 0,
           "far-00000.obj\nfar-00001.obj\n", "");
}
END_TEST

START_TEST(frames_before_a_bad_one_stay)
{
    make_file("below.obj", LOW "f 2 3 4\n");
    expect(run("$tf resolve scene.yaml -o made --format csv | cut -d , -f 1,2; "
               "ls made"),
           0, "step,status\n0,clear\ntripod-00000.obj\ntripod-00001.obj\n",
           "tanglefree: below.obj: 3 triangles, but low.obj has 2; all files "
           "must have the same elements\n"
           "tanglefree: made has the frames before that; delete it, or choose "
           "another, to begin again\n");
    outcome found = run("$tf resolve scene.yaml -o again");
    ck_assert_int_eq(found.status, 2);
    ck_assert_str_eq(found.out, "");
}
END_TEST

START_TEST(nothing_is_written_over)
{
    run("mkdir made; touch made/mine");
    expect(run("$tf resolve scene.yaml -o made"), 2, "",
           "tanglefree: made: exists, and is not an empty folder; choose "
           "another\n");
    expect(run("$tf resolve scene.yaml -o /dev/null/out"), 2, "",
           "tanglefree: /dev/null/out: cannot make this folder: Not a "
           "directory; choose another with -o\n");
}
END_TEST

START_TEST(a_scene_without_steps_is_refused)
{
    make_file("one.yaml", "meshes: [{frames: high.obj}]");
    expect(run("$tf resolve one.yaml -o made; ls"), 0,
           "below.obj\nerr\nfloor.obj\nhigh.obj\nlow.obj\none.yaml\nout\n"
           "scene.yaml\n",
           "tanglefree: one.yaml: there is no step, as each mesh has only one "
           "frame; give one that isn't fixed two or more\n");
    ck_assert_int_eq(run("$tf resolve one.yaml -o made").status, 2);
}
END_TEST

START_TEST(a_full_disk_is_reported)
{
    expect(run("$tf resolve scene.yaml -o made >/dev/full"), 2, "",
           "tanglefree: standard output: cannot write: No space left on "
           "device; mend that, and run again\n"
           "tanglefree: made has the frames before that; delete it, or choose "
           "another, to begin again\n");
}
END_TEST

START_TEST(a_name_that_is_too_long_is_told_and_leaves_nothing)
{
    char text[400], name[301];
    memset(name, 'a', 300);
    name[300] = '\0';
    snprintf(text, sizeof text,
             "meshes: [{frames: [high.obj, low.obj], name: %s}]", name);
    make_file("long.yaml", text);
    outcome found = run("$tf resolve long.yaml -o made");
    ck_assert_int_eq(found.status, 2);
    expect_words(found.err, "tanglefree: made/aaaa");
    expect_words(found.err, "-00000.obj: cannot write: ");
    ck_assert_int_ne(run("ls made").status, 0);
}
END_TEST

START_TEST(meshes_are_no_folders)
{
    expect(run("$tf resolve scene.yaml -o made.obj"), 2, "",
           "tanglefree: made.obj: the frames of a scene need a folder; leave "
           "out .obj, or end the name in .pvd\n");
    expect_words(run("$tf resolve scene.yaml -o made.PLY.gz").err,
                 "leave out .ply, or");
    expect_words(run("$tf resolve scene.yaml -o made.glb").err,
                 "leave out .glb, or");
    expect(run("$tf simulate sphere --steps 1 -o made.ply"), 2, "",
           "tanglefree: made.ply: frames need a folder; leave out .ply\n");
    expect(run("$tf check floor.obj -o rows.vtp"), 2, "",
           "tanglefree: rows.vtp: the output is rows, not a mesh; leave out "
           ".vtp, or end the name in .pvd for ParaView\n");
    ck_assert_str_eq(run("ls | grep -e made -e rows").out, "");
}
END_TEST

START_TEST(wrong_arguments_are_refused)
{
    expect_usage("resolve scene.yaml",
                 "tanglefree resolve: --output OUT is required");
    expect_usage("resolve scene.yaml high.obj -o made",
                 "tanglefree resolve: two files are required, START and END, "
                 "or a scene, whose name ends in .yaml, .yml or .json\n");
    expect_usage("resolve high.obj -o made",
                 "tanglefree resolve: two files are required, START and END, "
                 "or a scene, whose name ends in .yaml, .yml or .json\n");
    expect_usage("resolve scene.yaml -o -",
                 "tanglefree resolve: --output must be a folder for the frames "
                 "of a scene, got '-'\n");
    expect_usage("resolve scene.yaml -o made --fixed a",
                 "tanglefree resolve: --fixed is for two meshes; write 'role: "
                 "scripted' in the scene\n");
    expect_usage("resolve scene.yaml -o made --masses a",
                 "tanglefree resolve: --masses is for two meshes; write "
                 "'mass:' in the scene\n");
    expect_usage("resolve scene.yaml -o made --vertex-friction a",
                 "tanglefree resolve: --vertex-friction is for two meshes; "
                 "write 'friction:' in the scene\n");
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/scene_resolving");
    TCase *written = tcase_create("what is written");
    tcase_add_checked_fixture(written, enter_folder_with_files, leave_folder);
    tcase_add_test(written, frames_of_what_moves_are_written);
    tcase_add_test(written, the_step_to_each_frame_is_clear);
    tcase_add_test(written, two_frames_are_enough);
    tcase_add_test(written, each_mesh_keeps_its_format);
    tcase_add_test(written, pinned_vertices_go_where_their_frames_say);
    tcase_add_test(written, a_mesh_of_one_frame_stays_where_it_was_pushed);
    tcase_add_test(written, scripted_meshes_that_are_held_back_are_written);
    suite_add_tcase(suite, written);

    TCase *reports = tcase_create("reports");
    tcase_add_checked_fixture(reports, enter_folder_with_files, leave_folder);
    tcase_add_test(reports, a_report_has_a_row_for_each_step);
    tcase_add_test(reports, threads_change_nothing);
    tcase_add_test(reports, options_are_passed_on);
    suite_add_tcase(suite, reports);

    TCase *mistakes = tcase_create("mistakes");
    tcase_add_checked_fixture(mistakes, enter_folder_with_files, leave_folder);
    tcase_add_test(mistakes, starts_that_are_not_clear_are_refused);
    tcase_add_test(mistakes, frames_before_a_bad_one_stay);
    tcase_add_test(mistakes, nothing_is_written_over);
    tcase_add_test(mistakes, a_scene_without_steps_is_refused);
    tcase_add_test(mistakes, a_full_disk_is_reported);
    tcase_add_test(mistakes, meshes_are_no_folders);
    tcase_add_test(mistakes,
                   a_name_that_is_too_long_is_told_and_leaves_nothing);
    tcase_add_test(mistakes, wrong_arguments_are_refused);
    suite_add_tcase(suite, mistakes);
    return suite;
}
