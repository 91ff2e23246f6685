// The command untangle with a scene, as a user runs it.
#include "program/scene_untangling.h"

#include "support/json.h"
#include "support/program.h"
#include "support/support.h"

#include <stdio.h>
#include <string.h>

// A floor, and a flap whose edge passes through it, or not any more.
#define FLOOR "# kept\nv -9 -9 0\nv 9 -9 0\nv 0 9 0\nf 1 2 3\n"
#define FLAP "o flap\nv 0 0 -1\nv 0 0 2\nv 1 1 2\nf 1 2 3\n"
#define HIGH "o flap\nv 0 0 1\nv 0 0 2\nv 1 1 2\nf 1 2 3\n"

#define SCENE                                                                  \
    "meshes:\n- {frames: floor.obj, role: fixed}\n- frames: flap.obj\n"
#define STEPS                                                                  \
    "meshes:\n- frames: [floor.obj, floor.obj, floor.obj]\n  role: scripted\n" \
    "- name: flap\n  frames: [flap.obj, high.obj, flap.obj]\n"

static void enter_folder_with_files(void)
{
    enter_folder();
    make_file("floor.obj", FLOOR);
    make_file("flap.obj", FLAP);
    make_file("high.obj", HIGH);
    make_file("scene.yaml", SCENE);
    make_file("steps.yaml", STEPS);
}

// What is written -------------------------------------------------------------

START_TEST(what_moves_is_written_and_clear)
{
    expect_words(run("$tf check scene.yaml --format summary").out,
                 "\nintersections: 2\n");
    outcome found = run("$tf untangle scene.yaml -o made");
    ck_assert_str_eq(found.err, "");
    ck_assert_int_eq(found.status, 0);
    expect_words(found.out, "frames: 1\ntangled frames: 0\n"
                            "intersections before: 2\nintersections: 0\n"
                            "farthest: ");
    expect(run("ls made; $tf check floor.obj made/flap-00000.obj "
               "--format summary | tail -n 1; "
               "grep -v '^v' made/flap-00000.obj"),
           0, "flap-00000.obj\nintersections: 0\no flap\nf 1 2 3\n", "");
    ck_assert_str_eq(file_text("floor.obj"), FLOOR);
}
END_TEST

// The scene of what is written is clear in all its frames, and a frame that was
// clear comes back byte for byte.
START_TEST(each_frame_is_untangled)
{
    outcome found = run("$tf untangle steps.yaml -o made --format csv | "
                        "cut -d , -f 1-4");
    expect(found, 0,
           "frame,status,intersections_before,intersections\n"
           "0,untangled,2,0\n1,clear,0,0\n2,untangled,2,0\n",
           "");
    make_file("made.yaml", "meshes:\n- {frames: floor.obj, role: fixed}\n"
                           "- frames: made/flap-*.obj\n");
    expect(run("$tf check made.yaml --format summary"), 0,
           "frames: 3\nframes with intersections: 0\nintersections: 0\n", "");
    expect(run("cmp high.obj made/flap-00001.obj"), 0, "", "");
}
END_TEST

// A mesh of one frame begins where the frame before has left it.
START_TEST(a_mesh_of_one_frame_stays_where_it_was_untangled)
{
    make_file("steps.yaml",
              "meshes:\n- frames: [floor.obj, floor.obj]\n  role: scripted\n"
              "- frames: flap.obj\n");
    expect(run("$tf untangle steps.yaml -o made --format csv | "
               "cut -d , -f 1-4; cmp made/*"),
           0,
           "frame,status,intersections_before,intersections\n"
           "0,untangled,2,0\n1,clear,0,0\n",
           "");
}
END_TEST

START_TEST(pinned_vertices_stay)
{
    make_file("scene.yaml", SCENE "  pinned: [1, 2]\n");
    ck_assert_int_eq(run("$tf untangle scene.yaml -o made").status, 0);
    outcome found = run("diff flap.obj made/flap-00000.obj");
    ck_assert_int_eq(occurrences(found.out, "\n<"), 1);
    expect_words(found.out, "< v 0 0 -1\n");
}
END_TEST

START_TEST(meshes_of_a_group_may_intersect)
{
    make_file("scene.yaml",
              "meshes:\n- {frames: floor.obj, role: fixed, group: a}\n"
              "- {frames: flap.obj, group: a}\n");
    expect(run("$tf untangle scene.yaml -o made | head -n 4; "
               "cmp flap.obj made/flap-00000.obj"),
           0,
           "frames: 1\ntangled frames: 0\nintersections before: 0\n"
           "intersections: 0\n",
           "");
}
END_TEST

START_TEST(threads_change_nothing)
{
    expect(run("for t in 1 2 7; do $tf untangle steps.yaml -o made$t -t $t "
               ">report; done; diff -r made1 made2 && diff -r made1 made7"),
           0, "", "");
}
END_TEST

// What is left ----------------------------------------------------------------

#define PINNED                                                                 \
    "meshes:\n- frames: [floor.obj, floor.obj]\n  role: scripted\n"            \
    "- name: flap\n  frames: [high.obj, flap.obj]\n  pinned: [0, 1, 2]\n"

START_TEST(what_is_left_is_listed_as_it_is_checked)
{
    make_file("scene.yaml", PINNED);
    outcome found = run("$tf untangle scene.yaml -o made");
    ck_assert_int_eq(found.status, 1);
    expect_words(found.out, "frames: 2\ntangled frames: 1\n"
                            "intersections before: 2\nintersections: 2\n"
                            "farthest: 0\n");
    expect_words(found.out, "\n\nframe,kind,a,b,c,d,e,f,mesh,other_mesh\n"
                            "1,edge-triangle,0,1,0,1,2,,flap,floor\n");
    expect_words(found.out, run("$tf check scene.yaml").out);
    expect(run("cmp high.obj made/flap-00000.obj && "
               "cmp flap.obj made/flap-00001.obj"),
           0, "", "");
}
END_TEST

START_TEST(what_is_left_is_an_object)
{
    make_file("scene.yaml", PINNED);
    outcome found = run("$tf untangle scene.yaml -o made --format json >all; "
                        "grep -n '^{\"[fi]' all | cut -d : -f 1,2; "
                        "sed '/^{\"intersections/,$d' all >report");
    ck_assert_str_eq(found.out, "1:{\"frames\"\n2:{\"frame\"\n3:{\"frame\"\n"
                                "6:{\"intersections\"\n7:{\"frame\"\n"
                                "8:{\"frame\"\n");
    const char *fault = json_fault(file_text("report"));
    ck_assert_msg(!fault, "%s", fault);
}
END_TEST

// Mistakes --------------------------------------------------------------------

static const struct {
    const char *scene, *error;
} bad[] = {
    {"meshes: [{frames: floor.obj, role: fixed}]",
     "tanglefree: bad.yaml: no mesh is moving, so there is nothing to "
     "untangle; let one be, by its role\n"},
    {"meshes: [{frames: gone.obj}]",
     "tanglefree: bad.yaml:1: there is no file 'gone.obj'"},
    {"meshes: [{frames: nan.obj}]",
     "tanglefree: nan.obj:2: 'nan' is not a finite number; "},
    {"meshes: [{frames: flap.obj, pinned: [3]}]",
     "tanglefree: bad.yaml:1: 'flap' has no vertex 3; its vertices are "
     "numbered from 0 to 2\n"},
    {"meshes: [{frames: [flap.obj, nan.obj]}]", "tanglefree: nan.obj:2: "},
};

START_TEST(a_bad_scene_is_told)
{
    make_file("nan.obj", "v 0 0 0\nv nan 1 0\nv 0 1 0\nf 1 2 3\n");
    make_file("bad.yaml", bad[_i].scene);
    outcome found = run("$tf untangle bad.yaml -o made");
    ck_assert_int_eq(found.status, 2);
    ck_assert_str_eq(found.out, "");
    expect_words(found.err, bad[_i].error);
    // What was done before a bad frame stays.
    bool begun = strstr(bad[_i].scene, "[flap.obj, nan");
    expect_words(found.err, begun ? "tanglefree: made has the frames before "
                                    "that; delete it, or choose another, to "
                                    "begin again\n"
                                  : "");
    ck_assert_int_eq(run("ls made/flap-00000.obj").status == 0, begun);
    ck_assert_int_eq(run("ls -d made").status == 0, begun);
}
END_TEST

START_TEST(nothing_is_written_over)
{
    run("mkdir made; touch made/mine");
    expect(run("$tf untangle scene.yaml -o made"), 2, "",
           "tanglefree: made: exists, and is not an empty folder; choose "
           "another\n");
    expect(run("$tf untangle scene.yaml -o made.obj"), 2, "",
           "tanglefree: made.obj: the frames of a scene need a folder; leave "
           "out .obj\n");
    ck_assert_str_eq(run("ls made*").out, "mine\n");
}
END_TEST

START_TEST(a_full_disk_is_reported)
{
    outcome found = run("$tf untangle scene.yaml -o made >/dev/full");
    ck_assert_int_eq(found.status, 2);
    expect_words(found.err, "tanglefree: standard output: cannot write: No "
                            "space left on device; ");
    ck_assert_int_eq(run("ls made/flap-00000.obj").status, 0);
}
END_TEST

START_TEST(wrong_arguments_are_refused)
{
    expect_usage("untangle scene.yaml -o made --fixed a",
                 "tanglefree untangle: --fixed is for a mesh; write 'role: "
                 "fixed' or 'pinned:' in the scene\n");
    expect_usage("untangle scene.yaml -o -",
                 "tanglefree untangle: --output must be a folder for the "
                 "frames of a scene, got '-'\n");
    expect_usage("untangle scene.yaml -o made.pvd",
                 "tanglefree untangle: --output must be a folder for the "
                 "frames of a scene, got 'made.pvd'; only detect and resolve "
                 "write collections for ParaView\n");
    expect_usage("untangle scene.yaml flap.obj -o made",
                 "tanglefree untangle: one file is required: IN, or a scene, "
                 "whose name ends in .yaml, .yml or .json\n");
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/scene_untangling");
    TCase *tcase = tcase_create("scenes");
    tcase_add_checked_fixture(tcase, enter_folder_with_files, leave_folder);
    tcase_add_test(tcase, what_moves_is_written_and_clear);
    tcase_add_test(tcase, each_frame_is_untangled);
    tcase_add_test(tcase, a_mesh_of_one_frame_stays_where_it_was_untangled);
    tcase_add_test(tcase, pinned_vertices_stay);
    tcase_add_test(tcase, meshes_of_a_group_may_intersect);
    tcase_add_test(tcase, threads_change_nothing);
    tcase_add_test(tcase, what_is_left_is_listed_as_it_is_checked);
    tcase_add_test(tcase, what_is_left_is_an_object);
    tcase_add_loop_test(tcase, a_bad_scene_is_told, 0,
                        sizeof bad / sizeof *bad);
    tcase_add_test(tcase, nothing_is_written_over);
    tcase_add_test(tcase, a_full_disk_is_reported);
    tcase_add_test(tcase, wrong_arguments_are_refused);
    suite_add_tcase(suite, tcase);
    return suite;
}
