// The command simulate, as a user runs it.

#include "program/command.h"

#include "simulate/flow_scenes.h"
#include "support/environments.h"
#include "support/json.h"
#include "support/program.h"
#include "support/simulations.h"
#include "support/support.h"
#include "support/terminal.h"

#include <stdio.h>
#include <string.h>

// A scene that is quick.
#define CHAIN "$tf simulate plane-chain --size 40"

START_TEST(a_simulation)
{
    outcome found = run(CHAIN " -o made --steps 120");
    ck_assert_str_eq(found.err, "");
    ck_assert_int_eq(found.status, 0);
    expect_words(found.out, "steps: 120\nvertices: 45\ntriangles: 0\n");
    expect_words(found.out, "\nheld: 0\ndynamics seconds: ");
    ck_assert_int_eq(occurrences(found.out, "\ncontacts: 0\n"), 0);
    found = run("ls made | wc -l; tail -n 1 made/steps.csv | cut -d, -f 1-2");
    expect(found, 0, "122\n120,0.6\n", "");
}
END_TEST

START_TEST(the_report_may_be_json_or_csv)
{
    outcome found = run(CHAIN " -o made --steps 2 --format json");
    ck_assert_msg(!json_fault(found.out), "%s", json_fault(found.out));
    expect_words(found.out, "{\"steps\":2,\"vertices\":45,\"triangles\":0,");
    found = run(CHAIN " --output=other --steps 2 --format csv");
    expect_words(found.out, "steps,vertices,triangles,contacts,");
    expect_words(found.out, "response_seconds\n2,45,0,");
    ck_assert_int_eq(run(CHAIN " -o more --steps 2 >/dev/full").status, 2);
}
END_TEST

START_TEST(no_step_has_a_contact)
{
    run(CHAIN " -o made --steps 120");
    outcome found = run("$tf detect --format summary made/*.ply | head -n 2 && "
                        "$tf check --each made/*.ply | wc -l");
    expect(found, 0, "steps: 120\nsteps with contacts: 0\n1\n", "");
}
END_TEST

START_TEST(the_usual_steps_and_size)
{
    outcome found = run("$tf simulate plane-chain -o made --steps=0 && "
                        "$tf simulate plane-chain -o made --resume");
    expect_words(found.out, "steps: 0\nvertices: 205\n");
    expect_words(found.out, "steps: 400\nvertices: 205\n");
    ck_assert_int_eq(found.status, 0);
}
END_TEST

START_TEST(threads_change_no_bit)
{
    run("$tf simulate sphere --size 8 -o one --steps 40 --threads 1");
    run("$tf simulate sphere --size 8 -o two --steps 40 -t 2");
    expect(run("for i in one two; do cat $i/*.ply | cksum; "
               "cut -d, -f 1-15 $i/steps.csv | cksum; done | sort | uniq -c | "
               "wc -l"),
           0, "2\n", "");
}
END_TEST

START_TEST(going_on_changes_no_bit)
{
    run("$tf simulate flag --size 4 -o whole --steps 60");
    run("$tf simulate flag --size 4 -o parts --steps 25");
    outcome found =
        run("$tf simulate flag --size 4 -o parts --steps 60 --resume");
    expect_words(found.out, "steps: 35\n");
    expect(run("for i in whole parts; do cat $i/*.ply | cksum; "
               "cut -d, -f 1-15 $i/steps.csv | cksum; done | sort | uniq -c | "
               "wc -l"),
           0, "2\n", "");
    found = run("$tf simulate flag --size 4 -o parts --steps 50 --resume");
    expect_words(found.out, "steps: 0\n");
    expect(run("ls parts | wc -l"), 0, "62\n", "");
}
END_TEST

// Flows -----------------------------------------------------------------------

// A scene that is quick.
#define FLOW "$tf simulate dumbbell --edge 0.06"

START_TEST(a_flow)
{
    outcome found = run(FLOW " -o made --steps 10");
    ck_assert_str_eq(found.err, "");
    ck_assert_int_eq(found.status, 0);
    expect_words(found.out, "steps: 10\nvertices: ");
    expect_words(found.out, "\ncomponents: 1\ngenus: 0\narea: 0.7");
    expect_words(found.out, "\nadvance seconds: ");
    expect(run("ls made | wc -l; tail -n 1 made/steps.csv | cut -d, -f 1-2; "
               "$tf check --each made/*.ply"),
           0, "12\n10,0.1\nfile,kind,a,b,c,d,e,f\n", "");
}
END_TEST

START_TEST(a_flow_goes_on_bit_by_bit)
{
    run(FLOW " -o whole --steps 12 -t 1");
    run(FLOW " -o parts --steps 5 -t 2");
    outcome found = run(FLOW " -o parts --steps 12 --resume -t 2");
    expect_words(found.out, "steps: 7\n");
    expect(run("for i in whole parts; do cat $i/*.ply | cksum; rev "
               "$i/steps.csv | cut -d, -f 4- | cksum; done | sort | uniq -c | "
               "wc -l"),
           0, "2\n", "");
    expect(run("$tf simulate dumbbell --edge 0.07 -o parts --resume"), 2, "",
           "tanglefree: parts/frame-00012.ply: is no frame of 'tanglefree "
           "simulate dumbbell --edge 0.07'; correct the arguments, or delete "
           "the file to go on from the one before\n");
}
END_TEST

START_TEST(a_flow_that_is_interrupted)
{
    outcome found = run("timeout --preserve-status -s INT 1 $tf simulate star "
                        "-o made --steps 99999");
    ck_assert_int_eq(found.status, 130);
    expect_words(found.err, "tanglefree: interrupted after step ");
}
END_TEST

// Scene files -----------------------------------------------------------------

// A sheet that falls on a body, which then sinks; in another folder.
static void make_scene(void)
{
    make_file("own/sheet.obj", "o sheet\nv 0 0 0.05\nv 1 0 0.05\nv 1 1 0.05\n"
                               "v 0 1 0.05\nv 0.5 0.5 0.05\n"
                               "usemtl cotton\nf 1 2 5 4\nf 2 3 5\nf 3 4 5\n");
    make_file("own/body1.obj", "v -1 -1 0\nv 3 -1 0\nv -1 3 0\nv 0.4 0.4 -2\n"
                               "f 1 2 3\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    run("sed 's/0$/-0.5/' own/body1.obj >own/body2.obj");
    make_file("own/scene.yaml", "rate: 2.5\n"
                                "meshes:\n"
                                "- frames: sheet.obj\n"
                                "- frames: body*.obj\n"
                                "  role: scripted\n");
}

#define OWN "$tf simulate own/scene.yaml"

START_TEST(a_scene_file)
{
    run("mkdir own");
    make_scene();
    outcome found = run(OWN " -o made");
    ck_assert_int_eq(found.status, 0);
    expect_words(found.out, "steps: 40\nvertices: 9\ntriangles: 8\n");
    expect(run("ls made | sed 's/-.*//' | uniq -c | tr -s ' '; "
               "$tf detect --format summary made/frame-*.ply | head -n 2; "
               "$tf check --each made/frame-*.ply; "
               "tail -n 5 made/sheet-00040.obj | cut -c 1-6; "
               "head -n 1 made/sheet-00040.obj; tail -n 1 made/body-00040.obj; "
               "head -n 6 made/frame-00040.ply | tail -n 3"),
           0,
           " 41 body\n 41 frame\n 41 sheet\n 1 steps.csv\n"
           "steps: 40\nsteps with contacts: 0\nfile,kind,a,b,c,d,e,f\n"
           "v 0.50\nusemtl\nf 1 2 \nf 2 3 \nf 3 4 \n"
           "o sheet\nf 3 1 4\ncomment up z\n"
           "comment mesh of 5 vertices, moving: sheet\n"
           "comment mesh of 4 vertices, scripted: body\n",
           "");
}
END_TEST

// Two links, of which one end is pinned and the other one falls: z stays away.
START_TEST(a_scene_of_the_plane)
{
    make_file("chain.obj", "v 0 1\nv 1 1\nv 2 1\nl 1 2\nl 2 3\n");
    make_file("ground.obj", "v -9 0\nv 9 0\nl 1 2\n");
    make_file("scene.yaml", "steps: 70\nmeshes:\n"
                            "- frames: chain.obj\n"
                            "  pinned: [0]\n"
                            "  material: {stretch: 1000}\n"
                            "- frames: ground.obj\n"
                            "  role: fixed\n");
    expect_words(run("$tf simulate scene.yaml -o made").out,
                 "steps: 70\nvertices: 5\ntriangles: 0\n");
    expect(
        run("ls made | sed 's/-.*//' | uniq -c | tr -s ' '; "
            "$tf detect --format summary made/*.ply | head -n 2; "
            "head -n 1 made/chain-00070.obj; "
            "grep -c '^v [^ ]* [^ ]*$' made/chain-00070.obj; "
            "printf 'meshes: [{frames: made/chain-*.obj}, {frames: "
            "ground.obj, role: fixed}]' >judge.yaml; "
            "$tf detect --format summary judge.yaml | head -n 2"),
        0,
        " 71 chain\n 71 frame\n 1 steps.csv\nsteps: 70\n"
        "steps with contacts: 0\nv 0 1\n3\nsteps: 70\nsteps with contacts: 0\n",
        "");
}
END_TEST

START_TEST(a_scene_file_goes_on_bit_by_bit)
{
    run("mkdir own");
    make_scene();
    run(OWN " -o whole -t 1");
    run(OWN " -o parts --steps 17 -t 2");
    expect_words(run(OWN " -o parts --resume").out, "steps: 23\n");
    expect(run("for i in whole parts; do cat $i/*-*.* | cksum; "
               "cut -d, -f 1-15 $i/steps.csv | cksum; done | sort | uniq -c | "
               "wc -l"),
           0, "2\n", "");
    run("echo 'gravity: 9' >>own/scene.yaml");
    outcome found = run(OWN " -o parts --resume");
    ck_assert_int_eq(found.status, 2);
    expect_words(found.err, "tanglefree: parts/frame-00040.ply: is no frame of "
                            "'tanglefree simulate scene.yaml (checksum ");
    expect_words(found.err, ")'; correct the arguments, or delete the file to "
                            "go on from the one before\n");
}
END_TEST

START_TEST(the_end_of_a_mesh_is_a_fault_before_any_frame)
{
    run("mkdir own");
    make_scene();
    run("sed -i '$d' own/body2.obj");
    outcome found = run(OWN " -o made");
    ck_assert_int_eq(found.status, 2);
    expect_words(found.err, "tanglefree: own/body2.obj: ");
    ck_assert_int_eq(run("ls made").status, 2);
    run("echo 'rate: x' >own/scene.yaml");
    expect(run(OWN " -o made"), 2, "",
           "tanglefree: own/scene.yaml:1: rate must be a number above 0, got "
           "'x'\n");
    expect(run("$tf simulate none.yaml -o made"), 2, "",
           "tanglefree: none.yaml: cannot open: No such file or directory; "
           "check the name\n");
}
END_TEST

START_TEST(numbers_that_are_too_large_are_told)
{
    run("mkdir own");
    make_scene();
    run("echo 'gravity: 1e308' >>own/scene.yaml; "
        "echo 'step: 1e3' >>own/scene.yaml");
    expect(run(OWN " -o made 2>&1 >/dev/null | grep -v triangulated"), 0,
           "tanglefree: scene.yaml: step 1: positions grow without bounds; "
           "write lengths in meters, and take a shorter step or a softer "
           "material\n",
           "");
}
END_TEST

START_TEST(meshes_are_as_fine_as_their_files)
{
    run("mkdir own");
    make_scene();
    expect_words(run(OWN " -o made --size 10").err,
                 "tanglefree: own/scene.yaml: the meshes are as fine as their "
                 "files; leave out --size\n");
    expect_words(run(OWN " -o made --edge 1").err,
                 "tanglefree: own/scene.yaml: the meshes are as fine as their "
                 "files; leave out --edge\n");
}
END_TEST

// Each scene that is built in is the same as a file.
START_TEST(built_in_scenes_are_scene_files)
{
    static const struct {
        const char *name, *resolution;
    } scenes[] = {{"sphere", "--size 6"},       {"stack", "--size 5"},
                  {"twist", "--size 3"},        {"knot", "--size 3"},
                  {"curtain", "--size 10"},     {"flag", "--size 5"},
                  {"plane-chain", "--size 40"}, {"dumbbell", "--edge 0.06"},
                  {"sheets", "--edge 0.2"}};
    for (int i = 0; i < 9; i++) {
        expect(run("n=%s r='%s'; $tf simulate list $n >$n.yaml && "
                   "$tf simulate $n $r -o a-$n --steps 5 >/dev/null && "
                   "$tf simulate $n.yaml $r -o b-$n --steps 5 >/dev/null && "
                   "for i in a b; do cat $i-$n/*.ply | grep -av ^comment | "
                   "cksum; done | uniq | wc -l",
                   scenes[i].name, scenes[i].resolution),
               0, "1\n", "");
    }
}
END_TEST

START_TEST(a_scene_of_a_shape_has_a_resolution)
{
    run("$tf simulate list star >star.yaml; $tf simulate list sphere >a.yml");
    expect(run("$tf simulate star.yaml -o made --edge 0.2"), 2, "",
           "tanglefree: star.yaml: the scene has --edge, from 0.001 to 0.1\n");
    expect(run("$tf simulate star.yaml -o made --size 7"), 2, "",
           "tanglefree: star.yaml: the scene has --edge, from 0.001 to 0.1\n");
    expect(run("$tf simulate a.yml -o made --edge 5"), 2, "",
           "tanglefree: a.yml: the scene has --size, from 4 to 2000\n");
    expect(run("$tf simulate a.yml -o made --size 3"), 2, "",
           "tanglefree: a.yml: the scene has --size, from 4 to 2000\n");
    run("sed -i 's/^size: .*/size: 4/' a.yml");
    expect_words(run("$tf simulate a.yml -o made --steps 1").out,
                 "vertices: 52\n");
}
END_TEST

// Trouble ---------------------------------------------------------------------

START_TEST(ctrl_c_finishes_the_step)
{
    outcome found = run("timeout --preserve-status -s INT 1 $tf simulate "
                        "sphere -o made --steps 99999");
    ck_assert_int_eq(found.status, 130);
    ck_assert_str_eq(found.out, "");
    expect_words(found.err, "tanglefree: interrupted after step ");
    expect_words(found.err, " of 99999; go on with --resume\n");
    expect(
        run("cd made && test $(ls | wc -l) = $(($(wc -l <steps.csv) + 1)) && "
            "ls -A | grep -v 'frame-[0-9]*.ply'; rm frame-00000.ply; "
            "last=$(ls *.ply | tail -n 1); "
            "$tf check $last"),
        0, "steps.csv\nfile,kind,a,b,c,d,e,f\n", "");
}
END_TEST

// A file system on which files can have no more than a few blocks.
START_TEST(a_disk_that_is_full)
{
    outcome found = run("(ulimit -f 8; " CHAIN " -o made --steps 200)");
    ck_assert_int_eq(found.status, 2);
    ck_assert_str_eq(found.out, "");
    expect_words(found.err,
                 "tanglefree: made/steps.csv: cannot write: File too "
                 "large; mend that, and go on with --resume\n");
    found = run(CHAIN " -o made --steps 200 --resume");
    ck_assert_str_eq(found.err, "");
    run(CHAIN " -o whole --steps 200");
    expect(run("for i in whole made; do cat $i/*.ply | cksum; "
               "cut -d, -f 1-15 $i/steps.csv | cksum; done | sort | uniq -c | "
               "wc -l; ls -A made | wc -l"),
           0, "2\n202\n", "");
}
END_TEST

START_TEST(a_folder_that_is_not_empty)
{
    run("mkdir made && touch made/thesis.tex");
    expect(
        run(CHAIN " -o made"), 2, "",
        "tanglefree: made: exists, and is not an empty folder; choose another, "
        "or go on with the simulation in it by --resume\n");
    expect(run("ls made"), 0, "thesis.tex\n", "");
    expect(run(CHAIN " -o made --resume"), 2, "",
           "tanglefree: made: has no frames to go on from; leave out "
           "--resume\n");
}
END_TEST

START_TEST(another_size_cannot_go_on)
{
    run(CHAIN " -o made --steps 2");
    expect(run("$tf simulate plane-chain --size 41 -o made --resume"), 2, "",
           "tanglefree: made/frame-00002.ply: is no frame of 'tanglefree "
           "simulate plane-chain --size 41'; correct the arguments, or delete "
           "the file to go on from the one before\n");
}
END_TEST

static int run_simulate(int argc, char *argv[])
{
    return tf_command_run(&tf_simulate_command, argc, argv);
}

START_TEST(a_broken_environment)
{
    char message[300];
    const char *arguments[] = {"tanglefree simulate", "plane-chain", "-o",
                               "made", NULL};
    snprintf(message, sizeof message, "tanglefree: plane-chain: step 1: %s\n",
             tf_status_message(TF_BAD_ENVIRONMENT));
    expect(run_broken(_i, run_simulate, arguments), 2, "", message);
}
END_TEST

// Arguments -------------------------------------------------------------------

START_TEST(the_list_of_scenes)
{
    outcome found = run("$tf simulate list");
    ck_assert_int_eq(found.status, 0);
    ck_assert_int_eq(occurrences(found.out, "\n"),
                     scene_count(tf_cloth_scenes) +
                         scene_count(tf_flow_scenes));
    for (const tf_scene *s = tf_cloth_scenes; s->name; s++) {
        expect_words(found.out, s->name);
        expect_words(found.out, s->shows);
        expect_words(found.out, s->resolution.counts);
    }
    for (const tf_scene *s = tf_flow_scenes; s->name; s++) {
        expect_words(found.out, s->name);
        expect_words(found.out, s->shows);
    }
    expect_words(found.out, "; 400 steps, size 35: cells along a side of the "
                            "cloth\nstack  ");
    expect_words(found.out, "; 300 steps, edge 0.0226\nturbulence  ");
    expect(run("$tf simulate list >/dev/full"), 2, "",
           "tanglefree: standard output: cannot write: No space left on "
           "device; mend that, and run again\n");
}
END_TEST

START_TEST(usage)
{
    static const char *const cases[][2] = {
        {"simulate", "tanglefree simulate: one scene is required; 'tanglefree "
                     "simulate list' lists the scenes\n"},
        {"simulate cube -o made",
         "tanglefree simulate: unknown scene 'cube'; "
         "'tanglefree simulate list' lists the scenes, and the name of a scene "
         "file ends in .yaml, .yml or .json\n"},
        {"simulate list cube",
         "tanglefree simulate: unknown scene 'cube'; 'tanglefree simulate "
         "list' lists"},
        {"simulate list sphere stack",
         "tanglefree simulate: one scene is required; 'tanglefree simulate "
         "list' lists"},
        {"simulate scene.yaml", "tanglefree simulate: --output DIR is "
                                "required: the folder for the frames\n"},
        {"simulate scene.yaml sphere -o made",
         "tanglefree simulate: one scene is required, got two\n"},
        {"simulate sphere",
         "tanglefree simulate: --output DIR is required: the "
         "folder for the frames\n"},
        {"simulate sphere --size 3 -o made",
         "tanglefree simulate: --size must be 4 or more for the scene sphere, "
         "got '3'\n"},
        {"simulate sphere --size 2001 -o made",
         "tanglefree simulate: --size must be a whole number from 1 to 2000, "
         "got '2001'\n"},
        {"simulate sphere --steps x -o made",
         "tanglefree simulate: --steps must be a whole number from 0 to 99999, "
         "got 'x'\n"},
        {"simulate sphere --steps 100000 -o made",
         "tanglefree simulate: --steps must be"},
        {"simulate sphere --edge 0.1 -o made",
         "tanglefree simulate: --edge is for surfaces that flow; the scene "
         "sphere has a --size\n"},
        {"simulate star --size 4 -o made",
         "tanglefree simulate: --size is for cloth; the scene star has an "
         "--edge\n"},
        {"simulate star --edge 0 -o made",
         "tanglefree simulate: --edge must be a number above 0, got '0'\n"},
        {"simulate star --edge 0.1x -o made",
         "tanglefree simulate: --edge must be a number above 0, got '0.1x'\n"},
        {"simulate star --edge 7 -o made",
         "tanglefree simulate: --edge must be from 0.001 to 0.1 for the scene "
         "star, got '7'\n"},
        {"simulate star", "tanglefree simulate: --output DIR is required: the "
                          "folder for the frames\n"},
        {"simulate sphere stack -o made",
         "tanglefree simulate: one scene is required"},
        {"simulate sphere --write made",
         "tanglefree simulate: --write is an old spelling; write --output\n"},
        {"simulate sphere -o made --format xml",
         "tanglefree simulate: --format must be csv, json or summary, got "
         "'xml'\n"},
        {"simulate sphere -t 0 -o made",
         "tanglefree simulate: --threads must be"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        expect_usage(cases[i][0], cases[i][1]);
    expect(run("ls made"), 2, "",
           "ls: cannot access 'made': No such file or directory\n");
}
END_TEST

// More steps than any machine makes before it is interrupted: progress is shown
// after a second.
START_TEST(progress_on_a_terminal)
{
    terminal screen = terminal_open();
    run("timeout -s INT 1.2 $tf simulate sphere --size 12 -o made "
        "--steps 99999 -t 1 2>%s",
        screen.name);
    const char *shown = terminal_close(&screen);
    expect_words(shown, " of 99999 steps, ");
    expect_words(shown, " contacts\r\033[K");
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/simulate_command");
    TCase *good = tcase_create("runs");
    tcase_add_checked_fixture(good, enter_folder, leave_folder);
    tcase_add_test(good, a_simulation);
    tcase_add_test(good, the_report_may_be_json_or_csv);
    tcase_add_test(good, no_step_has_a_contact);
    tcase_add_test(good, the_usual_steps_and_size);
    tcase_add_test(good, threads_change_no_bit);
    tcase_add_test(good, going_on_changes_no_bit);
    tcase_add_test(good, progress_on_a_terminal);
    tcase_add_test(good, a_flow);
    tcase_add_test(good, a_flow_goes_on_bit_by_bit);
    tcase_add_test(good, a_scene_file);
    tcase_add_test(good, a_scene_of_the_plane);
    tcase_add_test(good, a_scene_file_goes_on_bit_by_bit);
    tcase_add_test(good, built_in_scenes_are_scene_files);
    tcase_add_test(good, a_scene_of_a_shape_has_a_resolution);
    suite_add_tcase(suite, good);
    TCase *bad = tcase_create("trouble");
    tcase_add_checked_fixture(bad, enter_folder, leave_folder);
    tcase_add_test(bad, ctrl_c_finishes_the_step);
    tcase_add_test(bad, a_flow_that_is_interrupted);
    tcase_add_test(bad, a_disk_that_is_full);
    tcase_add_test(bad, a_folder_that_is_not_empty);
    tcase_add_test(bad, another_size_cannot_go_on);
    tcase_add_test(bad, the_end_of_a_mesh_is_a_fault_before_any_frame);
    tcase_add_test(bad, numbers_that_are_too_large_are_told);
    tcase_add_test(bad, meshes_are_as_fine_as_their_files);
    tcase_add_loop_test(bad, a_broken_environment, 0, environments());
    suite_add_tcase(suite, bad);
    TCase *arguments = tcase_create("arguments");
    tcase_add_checked_fixture(arguments, enter_folder, leave_folder);
    tcase_add_test(arguments, the_list_of_scenes);
    tcase_add_test(arguments, usage);
    suite_add_tcase(suite, arguments);
    return suite;
}
