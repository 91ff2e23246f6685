// What is said of long work before it begins.
#include "scenes/forecast.h"

#include "support/meshes.h"
#include "support/program.h"
#include "support/support.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/// Starts to collect what is printed on standard error.
static void listen(void)
{
    ck_assert(freopen("err", "w", stderr) != NULL);
}

static const char *heard(void)
{
    fflush(stderr);
    return file_text("err");
}

// Triangles -------------------------------------------------------------------

/// An equilateral triangle with sides of that length, and one of half the size.
static tf_mesh_file two_triangles(double side)
{
    char text[400];
    double x[3] = {side, side / 2, side * sqrt(3) / 2};
    snprintf(text, sizeof text,
             "v 0 0 0\nv %a 0 0\nv %a 0 %a\nv %a 0 0\nv %a 0 %a\nf 1 2 3\nf 1 "
             "4 5\n",
             x[0], x[1], x[2], x[0] / 2, x[1] / 2, x[2] / 2);
    return good_mesh(text);
}

static const char *forecast_of(double side, double edge)
{
    tf_mesh_file file = two_triangles(side);
    listen();
    tf_forecast_triangles(&file, edge);
    tf_mesh_file_free(&file);
    return heard();
}

START_TEST(few_triangles_need_no_word)
{
    // 40,000 equilateral triangles and 10,000.
    ck_assert_str_eq(forecast_of(200, 1.0001), "");
    ck_assert_str_eq(forecast_of(200, 300), "");
}
END_TEST

START_TEST(many_triangles_are_forecast)
{
    ck_assert_str_eq(forecast_of(200, 0.9999),
                     "tanglefree: mesh: about 50000 triangles will be made of "
                     "2; if those are too many, give an --edge nearer to the "
                     "mean edge length, 150\n");
    ck_assert_str_eq(forecast_of(1, 0.0003),
                     "tanglefree: mesh: about 14000000 triangles will be made "
                     "of 2; if those are too many, give an --edge nearer to "
                     "the mean edge length, 0.75\n");
}
END_TEST

START_TEST(the_unit_does_not_matter)
{
    static const int exponents[] = {-1000, -500, 500, 1000};
    for (int i = 0; i < 4; i++) {
        double unit = ldexp(1, exponents[i]);
        expect_words(forecast_of(1000 * unit, unit),
                     "about 1300000 triangles will be made of 2");
        ck_assert_str_eq(forecast_of(100 * unit, unit), "");
    }
}
END_TEST

START_TEST(more_than_can_be_counted_are_left_to_the_error)
{
    expect_words(forecast_of(1, 0.00005), "about 500000000 triangles");
    ck_assert_str_eq(forecast_of(1, 0.00004), "");
    ck_assert_str_eq(forecast_of(1, 1e-300), "");
    make_file("square", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
    outcome found = run("$tf remesh square -o out.obj -e 1e-300");
    ck_assert_int_eq(found.status, 2);
    ck_assert_int_eq(occurrences(found.err, "about"), 0);
}
END_TEST

// Frames ----------------------------------------------------------------------

static const char *bytes_told(int frames, double bytes)
{
    listen();
    tf_forecast_frames("a\tb", frames, bytes);
    return heard();
}

START_TEST(few_bytes_need_no_word)
{
    ck_assert_str_eq(bytes_told(1000, 100000), "");
    ck_assert_str_eq(bytes_told(0, 1e12), "");
    ck_assert_str_eq(bytes_told(-5, 1e12), "");
}
END_TEST

START_TEST(many_bytes_are_forecast)
{
    ck_assert_str_eq(
        bytes_told(1001, 100000),
        "tanglefree: a\\x09b: 1001 frames will be written, about 0.1 GB\n");
    ck_assert_str_eq(
        bytes_told(99999, 12345678),
        "tanglefree: a\\x09b: 99999 frames will be written, about 1234.6 GB\n");
}
END_TEST

START_TEST(the_bytes_of_a_file)
{
    make_file("five", "12345");
    ck_assert_double_eq(tf_bytes_of("five"), 5);
    ck_assert_double_eq(tf_bytes_of("none"), 0);
}
END_TEST

// The program -----------------------------------------------------------------

/// What it has said when it has told what will be; then it is ended.
static const char *first_words(const char *command)
{
    return run("%s >out 2>err & while ! grep -q 'will be' err; do "
               "kill -0 $! || exit; sleep 0.01; done; kill $!; wait $!; cat "
               "err",
               command)
        .out;
}

START_TEST(remesh_tells_it_before_it_begins)
{
    make_file("square", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
    expect_words(first_words("$tf remesh square -o out.obj -e 0.0005"),
                 "square: about 9200000 triangles will be made of 2; if those "
                 "are too many, give an --edge nearer to the mean edge length, "
                 "1.14\n");
}
END_TEST

START_TEST(simulate_tells_it_before_it_begins)
{
    run("$tf simulate sphere --size 20 -o made --steps 2");
    outcome found = run("$tf simulate sphere --size 20 -o made --steps 3 "
                        "--resume");
    ck_assert_str_eq(found.err, "");
    expect_words(first_words("$tf simulate sphere --size 20 -o made --steps "
                             "20003 --resume"),
                 "tanglefree: made: 20000 frames will be written, about ");
    expect_words(first_words("$tf simulate sphere --size 20 -o again --steps "
                             "20000"),
                 "tanglefree: again: 20000 frames will be written, about ");
}
END_TEST

START_TEST(simulate_counts_the_files_of_meshes_too)
{
    double bytes, alone;
    make_file("sheet.obj", "v 0 0 1\nv 1 0 1\nv 0 1 1\nf 1 2 3\n");
    run("printf '#%%02000d' 1 >>sheet.obj"); // in all frames
    make_file("scene.yaml", "steps: 0\nmeshes: [{frames: sheet.obj}]\n");
    outcome found = run("$tf simulate scene.yaml -o one >out && cat one/*-0* | "
                        "wc -c && wc -c <one/frame-00000.ply");
    ck_assert_int_eq(sscanf(found.out, "%lf %lf", &bytes, &alone), 2);
    ck_assert_double_gt(bytes, alone + 2000);
    char command[100], words[100];
    int steps = (int)(1e8 / bytes) + 2;
    snprintf(command, sizeof command,
             "$tf simulate scene.yaml -o made --steps %d", steps);
    snprintf(words, sizeof words,
             "tanglefree: made: %d frames will be written, about 0.1 GB",
             steps);
    expect_words(first_words(command), words);
}
END_TEST

/// Frames of a mesh with 100 vertices, of which the second one, if there are
/// more than two, has other elements.
static void make_scene(int frames)
{
    FILE *mesh = fopen("mesh.obj", "w"), *scene = fopen("scene.yaml", "w");
    ck_assert(mesh && scene);
    for (int v = 0; v < 100; v++)
        fprintf(mesh, "v %d.5 %d %d\n", v, v * v, v % 7);
    fputs("f 1 2 3\n", mesh);
    fputs("meshes:\n- frames: [mesh.obj", scene);
    for (int i = 1; i < frames; i++)
        fputs(frames == 2 ? ", mesh.obj" : ", other.obj", scene);
    fputs("]\n- frames: fixed.obj\n  role: fixed\n", scene);
    ck_assert_int_eq(fclose(mesh) | fclose(scene), 0);
    make_file("other.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
    make_file("fixed.obj", "v 0 0 9\nv 1 0 9\nv 1 1 9\nf 1 2 3\n");
}

START_TEST(scenes_tell_it_after_the_first_frame)
{
    static const char *const commands[] = {"resolve scene.yaml -o",
                                           "resolve scene.yaml -o",
                                           "detect scene.yaml -o"};
    static const char *const names[] = {"made", "made.pvd", "shown.pvd"};
    double bytes[3];
    for (int i = 0; i < 3; i++) {
        make_scene(2);
        ck_assert_int_eq(
            occurrences(run("$tf %s %s", commands[i], names[i]).err,
                        "frames will be written"),
            0);
        sscanf(run("cat %.*s/*-00000.* | wc -c", (int)strcspn(names[i], "."),
                   names[i])
                   .out,
               "%lf", &bytes[i]);
        int frames = (int)(1e8 / bytes[i]) + 2;
        make_scene(frames);
        char words[100];
        snprintf(words, sizeof words, "%d frames will be written, about 0.1 GB",
                 frames);
        run("rm -rf made shown");
        expect_words(run("$tf %s %s", commands[i], names[i]).err, words);
        run("rm -rf made shown");
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("scenes/forecast");
    TCase *triangles = tcase_create("triangles");
    tcase_add_checked_fixture(triangles, enter_folder, leave_folder);
    tcase_add_test(triangles, few_triangles_need_no_word);
    tcase_add_test(triangles, many_triangles_are_forecast);
    tcase_add_test(triangles, the_unit_does_not_matter);
    tcase_add_test(triangles, more_than_can_be_counted_are_left_to_the_error);
    suite_add_tcase(suite, triangles);

    TCase *frames = tcase_create("frames");
    tcase_add_checked_fixture(frames, enter_folder, leave_folder);
    tcase_add_test(frames, few_bytes_need_no_word);
    tcase_add_test(frames, many_bytes_are_forecast);
    tcase_add_test(frames, the_bytes_of_a_file);
    suite_add_tcase(suite, frames);

    TCase *program = tcase_create("the program");
    tcase_set_timeout(program, 60);
    tcase_add_checked_fixture(program, enter_folder, leave_folder);
    tcase_add_test(program, remesh_tells_it_before_it_begins);
    tcase_add_test(program, simulate_tells_it_before_it_begins);
    tcase_add_test(program, simulate_counts_the_files_of_meshes_too);
    tcase_add_test(program, scenes_tell_it_after_the_first_frame);
    suite_add_tcase(suite, program);
    return suite;
}
