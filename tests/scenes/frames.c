// Sequences of files, and the steps between them.
#include "scenes/frames.h"

#include "base/status.h"
#include "support/program.h"
#include "support/support.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define START "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 2 2\nf 1 2 3\nf 2 3 4\nl 1 4\n"
#define END "v 0 0 1\nv 1 0 1\nv 0 1 1\nv 2 2 3\nf 1 2 3\nf 2 3 4\nl 1 4\n"

/// Reads these texts as files, of which all but perhaps the last are good.
static bool read_frames(tf_frames *frames, int count, const char *const text[])
{
    static const char *const names[] = {"start", "next", "end"};
    bool good = true;
    *frames = (tf_frames){0};
    for (int i = 0; i < count; i++) {
        ck_assert_msg(good, "%s", frames->fault.text);
        make_file(names[i], text[i]);
        good = tf_frames_next(frames, names[i]);
        ck_assert_str_eq(tf_frames_file(frames)->name, names[i]);
    }
    return good;
}

// Steps -----------------------------------------------------------------------

START_TEST(two_frames_are_a_step)
{
    tf_frames frames;
    ck_assert(read_frames(&frames, 2, (const char *[]){START, END}));
    tf_motion motion = tf_frames_motion(&frames);
    ck_assert_int_eq(frames.count, 2);
    ck_assert_int_eq(frames.axes, 3);
    ck_assert_int_eq(motion.vertices, 4);
    ck_assert(motion.start[2] == 0 && motion.end[2] == 1);
    ck_assert(motion.start[11] == 2 && motion.end[11] == 3);
    int triangles, edges;
    tf_surface_triangles(frames.surface, &triangles);
    tf_surface_edges(frames.surface, &edges);
    ck_assert(triangles == 2 && edges == 6);
    tf_frames_free(&frames);
}
END_TEST

START_TEST(each_end_is_the_next_start)
{
    tf_frames frames = {0};
    make_file("start", START);
    make_file("end", END);
    static const char *const names[] = {"start", "end", "end", "start"};
    tf_surface *surface = NULL;
    for (int i = 0; i < 4; i++) {
        ck_assert(tf_frames_next(&frames, names[i]));
        tf_motion motion = tf_frames_motion(&frames);
        ck_assert(motion.end[2] == (i == 1 || i == 2));
        ck_assert(motion.start[2] == (i == 2 || i == 3));
        // It is one surface all the time.
        ck_assert(i == 0 || frames.surface == surface);
        surface = frames.surface;
    }
    tf_frames_free(&frames);
}
END_TEST

START_TEST(one_frame_is_at_rest)
{
    tf_frames frames;
    ck_assert(read_frames(&frames, 1, (const char *[]){END}));
    tf_motion motion = tf_frames_motion(&frames);
    ck_assert_ptr_eq(motion.start, motion.end);
    ck_assert(motion.end[2] == 1);
    tf_frames_free(&frames);
}
END_TEST

START_TEST(edges_with_z_0_are_a_step_of_the_plane)
{
    tf_frames frames;
    ck_assert(read_frames(
        &frames, 2,
        (const char *[]){"v 1 2\nv 3 4\nl 1 2\n", "v 5 6 0\nv 7 8\nl 1 2\n"}));
    tf_motion motion = tf_frames_motion(&frames);
    ck_assert_int_eq(frames.axes, 2);
    static const double start[] = {1, 2, 3, 4}, end[] = {5, 6, 7, 8};
    ck_assert_mem_eq(motion.start, start, sizeof start);
    ck_assert_mem_eq(motion.end, end, sizeof end);
    tf_frames_free(&frames);
}
END_TEST

START_TEST(changed_ends_are_in_the_file)
{
    tf_frames frames;
    ck_assert(read_frames(&frames, 2, (const char *[]){START, END}));
    double *end = tf_frames_end(&frames);
    end[2] = 7;
    ck_assert(tf_frames_motion(&frames).end[2] == 7);
    tf_frames_change(&frames);
    ck_assert(tf_frames_file(&frames)->position.item[2] == 7);
    ck_assert(frames.file[0].position.item[2] == 0);
    tf_frames_free(&frames);
}
END_TEST

START_TEST(changed_ends_of_the_plane_keep_their_z)
{
    static const char start[] = "v 0 0\nv 1 2 -0\nl 1 2\n";
    tf_frames frames;
    ck_assert(read_frames(&frames, 2, (const char *[]){start, start}));
    double *end = tf_frames_end(&frames);
    end[2] = 7;
    end[3] = 8;
    ck_assert(tf_frames_motion(&frames).end[3] == 8);
    tf_frames_change(&frames);
    const double *x = tf_frames_file(&frames)->position.item;
    ck_assert(x[0] == 0 && x[1] == 0 && x[2] == 0);
    ck_assert(x[3] == 7 && x[4] == 8 && x[5] == 0 && signbit(x[5]));
    ck_assert(frames.file[0].position.item[3] == 1);
    tf_frames_free(&frames);
}
END_TEST

START_TEST(a_curve_may_leave_the_plane_and_return)
{
    static const char flat[] = "v 1 2\nv 3 4\nl 1 2\n";
    static const char deep[] = "v 1 2\nv 3 4 5\nl 1 2\n";
    make_file("flat", flat);
    make_file("deep", deep);
    static const struct {
        const char *name;
        int axes;
    } steps[] = {{"flat", 2}, {"flat", 2}, {"deep", 3},
                 {"flat", 3}, {"flat", 2}, {"deep", 3}};
    tf_frames frames = {0};
    for (int i = 0; i < 6; i++) {
        ck_assert(tf_frames_next(&frames, steps[i].name));
        ck_assert_int_eq(frames.axes, steps[i].axes);
        tf_motion motion = tf_frames_motion(&frames);
        int last = 2 * frames.axes - 1;
        double z = strcmp(steps[i].name, "deep") == 0 ? 5 : 0;
        ck_assert(motion.end[last] == (frames.axes == 2 ? 4 : z));
        ck_assert(motion.start[0] == 1);
    }
    tf_frames_free(&frames);
}
END_TEST

START_TEST(formats_may_differ)
{
    tf_frames frames;
    ck_assert(read_frames(
        &frames, 2,
        (const char *[]){
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
            "property float y\nproperty float z\nelement face 1\n"
            "property list uchar int vertex_index\nend_header\n"
            "0 0 1\n1 0 1\n0 1 1\n3 0 1 2\n"}));
    tf_frames_free(&frames);
}
END_TEST

// Polygons --------------------------------------------------------------------

// A dart, whose notch is at vertex 3 or 4, and a triangle.
#define NOTCH_3 "v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\nv 9 9 9\n"
#define NOTCH_4 "v 0 0 0\nv 0 4 0\nv 4 4 0\nv 1 3 0\nv 9 9 9\n"
#define DART "f 4 1 2 3\nf 2 3 5\n"

static void expect_dart(const tf_frames *frames, const int corners[6])
{
    ck_assert_mem_eq(tf_frames_file(frames)->triangle.item, corners,
                     6 * sizeof *corners);
    int count;
    tf_surface_triangles(frames->surface, &count);
    ck_assert_int_eq(count, 3);
}

static const int fan_of_1[] = {0, 1, 2, 0, 2, 3};
static const int fan_of_2[] = {3, 0, 1, 1, 2, 3};

START_TEST(all_frames_have_the_triangles_of_the_first)
{
    tf_frames frames;
    ck_assert(read_frames(&frames, 1, (const char *[]){NOTCH_3 DART}));
    expect_dart(&frames, fan_of_1);
    tf_frames_free(&frames);
    ck_assert(read_frames(&frames, 1, (const char *[]){NOTCH_4 DART}));
    expect_dart(&frames, fan_of_2);
    tf_frames_free(&frames);
    ck_assert(read_frames(
        &frames, 3,
        (const char *[]){NOTCH_3 DART, NOTCH_4 DART, NOTCH_4 DART}));
    expect_dart(&frames, fan_of_1);
    tf_frames_free(&frames);
}
END_TEST

START_TEST(frames_that_begin_anew_have_their_own_triangles)
{
    make_file("start", NOTCH_3 DART);
    make_file("next", NOTCH_4 DART "f 1 2 5\n");
    tf_frames frames = {.may_differ = true};
    ck_assert(tf_frames_next(&frames, "start"));
    ck_assert(tf_frames_next(&frames, "next"));
    ck_assert(frames.is_new);
    ck_assert_mem_eq(tf_frames_file(&frames)->triangle.item, fan_of_2,
                     sizeof fan_of_2);
    tf_frames_free(&frames);
}
END_TEST

// Other elements --------------------------------------------------------------

static const struct {
    const char *text;
    long line;
    const char *fault;
} others[] = {
    {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", -1,
     "3 vertices, but start has 4; all files must have the "
     "same elements"},
    {START "v 0 0 0\n", -1,
     "5 vertices, but start has 4; all files must have the "
     "same elements"},
    {"v 0 0 1\nv 1 0 1\nv 0 1 1\nv 2 2 3\nf 1 2 3\nf 4 2 3\nl 1 4\n", 6,
     "this triangle is not as in start; all files must have the same elements "
     "in the same order"},
    {"v 0 0 1\nv 1 0 1\nv 0 1 1\nv 2 2 3\nf 1 2 3\nf 2 3 1\nl 1 4\n", 6,
     "this triangle is not as in start; all files must have the same elements "
     "in the same order"},
    {"v 0 0 1\nv 1 0 1\nv 0 1 1\nv 2 2 3\nf 2 3 4\nl 1 4\n", 5,
     "this triangle is not as in start; all files must have the same elements "
     "in the same order"},
    {"v 0 0 1\nv 1 0 1\nv 0 1 1\nv 2 2 3\nf 1 2 3\nl 1 4\n", -1,
     "1 triangles, but start has 2; all files must have the "
     "same elements"},
    {START "f 1 2 4\n", -1,
     "3 triangles, but start has 2; all files must have the "
     "same elements"},
    {"v 0 0 1\nv 1 0 1\nv 0 1 1\nv 2 2 3\nf 1 2 3\nf 2 3 4\nl 4 1\n", 7,
     "this edge is not as in start; all files must have the same elements in "
     "the same order"},
    {"v 0 0 1\nv 1 0 1\nv 0 1 1\nv 2 2 3\nf 1 2 3\nf 2 3 4\n", -1,
     "0 edges, but start has 1; all files must have the same "
     "elements"},
    {START "l 1 4\n", -1,
     "2 edges, but start has 1; all files must have the same "
     "elements"},
    {"v 0 0 1\nv 1 0 1\nv 0 1 1\nv 2 2 3\nf 1 2 3 4\nl 1 4\n", 5,
     "this face is not as in start; all files must have the same elements in "
     "the same order"},
    {"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 2 2\nl 1 4\n", -1,
     "0 triangles, but start has 2; all files must have the "
     "same elements"},
};

START_TEST(other_elements_are_refused)
{
    tf_frames frames;
    ck_assert(
        !read_frames(&frames, 2, (const char *[]){START, others[_i].text}));
    ck_assert_str_eq(frames.fault.text, others[_i].fault);
    ck_assert_int_eq(frames.fault.place, others[_i].line);
    tf_frames_free(&frames);
}
END_TEST

START_TEST(other_polygons_are_refused)
{
    static const struct {
        const char *faces, *fault;
    } bad[] = {{"f 1 2 3 4\nf 2 3 5\n", "this face is not as in start; "},
               {"f 4 1 2\nf 2 3 4\nf 2 3 5\n", "this triangle is not as in "},
               {"f 4 1 2 3 5\nf 2 3 5\n", "this face is not as in "},
               {"f 4 1 2 5\nf 2 3 5\n", "this face is not as in "}};
    for (int i = 0; i < 4; i++) {
        tf_frames frames;
        char text[200];
        snprintf(text, sizeof text, NOTCH_3 "%s", bad[i].faces);
        ck_assert(
            !read_frames(&frames, 2, (const char *[]){NOTCH_3 DART, text}));
        expect_words(frames.fault.text, bad[i].fault);
        ck_assert_int_eq(frames.fault.place, 6);
        tf_frames_free(&frames);
    }
}
END_TEST

START_TEST(other_elements_are_refused_later_too)
{
    tf_frames frames;
    ck_assert(!read_frames(&frames, 3,
                           (const char *[]){START, END, START "f 1 2 4\n"}));
    expect_words(frames.fault.text, "but next has 2; ");
    tf_frames_free(&frames);
}
END_TEST

// Flaws of the surface --------------------------------------------------------

static const struct {
    const char *text;
    long line;
    const char *fault;
} flaws[] = {
    {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", 4,
     "there is no vertex 4; they are numbered from 1 to 3"},
    {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2147483647 3\n", 5,
     "there is no vertex 2147483647; they are numbered from 1 to 3"},
    {"v 0 0 0\nv 1 0 0\nl 1 2 3\n", 3,
     "there is no vertex 3; they are numbered from 1 to 2"},
    {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n\nf 1 2 2\n", 6,
     "vertex 2 is a corner twice; delete the triangle or edge, here and in all "
     "files"},
    {"v 0 0 0\nv 1 0 0\nl 1 2\nl 1 1\n", 4,
     "vertex 1 is a corner twice; delete the triangle or edge, here and in all "
     "files"},
    {"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
     "property float y\nproperty float z\nelement face 1\n"
     "property list uchar int vertex_index\nend_header\n"
     "0 0 1\n1 0 1\n0 1 1\n3 0 1 2147483647\n",
     13, "there is no vertex 2147483647; they are numbered from 0 to 2"},
    {"ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\n"
     "property float y\nelement edge 1\n"
     "property int vertex1\nproperty int vertex2\nend_header\n"
     "0 0\n1 0\n0 2\n",
     12, "there is no vertex 2; they are numbered from 0 to 1"},
};

START_TEST(flaws_have_a_line)
{
    tf_frames frames;
    ck_assert(!read_frames(&frames, 1, (const char *[]){flaws[_i].text}));
    ck_assert_str_eq(frames.fault.text, flaws[_i].fault);
    ck_assert_int_eq(frames.fault.place, flaws[_i].line);
    tf_frames_free(&frames);
}
END_TEST

START_TEST(flaws_of_all_elements_have_a_line)
{
    tf_frames frames;
    ck_assert(read_frames(&frames, 1, (const char *[]){START}));
    static const struct {
        tf_error error;
        long line;
    } kinds[] = {{{.subject = TF_NO_SUBJECT}, -1},
                 {{.subject = TF_VERTEX, .index = 3, .vertex = {3}}, 4},
                 {{.subject = TF_TRIANGLE, .index = 1}, 6},
                 {{.subject = TF_EDGE, .index = 0}, 7}};
    for (int i = 0; i < 4; i++) {
        tf_error error = kinds[i].error;
        error.status = TF_NOT_FINITE;
        ck_assert(!tf_frames_fault(&frames, &error));
        ck_assert_str_eq(frames.fault.text, tf_status_message(TF_NOT_FINITE));
        ck_assert_int_eq(frames.fault.place, kinds[i].line);
    }
    tf_frames_free(&frames);
}
END_TEST

START_TEST(unreadable_files_are_refused)
{
    tf_frames frames = {0};
    make_file("start", START);
    ck_assert(tf_frames_next(&frames, "start"));
    ck_assert(!tf_frames_next(&frames, "absent"));
    expect_words(frames.fault.text, "cannot open: ");
    ck_assert_str_eq(tf_frames_file(&frames)->name, "absent");
    tf_frames_free(&frames);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("scenes/frames");
    TCase *steps = tcase_create("steps");
    tcase_add_checked_fixture(steps, enter_folder, leave_folder);
    tcase_add_test(steps, two_frames_are_a_step);
    tcase_add_test(steps, each_end_is_the_next_start);
    tcase_add_test(steps, one_frame_is_at_rest);
    tcase_add_test(steps, edges_with_z_0_are_a_step_of_the_plane);
    tcase_add_test(steps, changed_ends_are_in_the_file);
    tcase_add_test(steps, changed_ends_of_the_plane_keep_their_z);
    tcase_add_test(steps, a_curve_may_leave_the_plane_and_return);
    tcase_add_test(steps, formats_may_differ);
    suite_add_tcase(suite, steps);

    TCase *polygons = tcase_create("polygons");
    tcase_add_checked_fixture(polygons, enter_folder, leave_folder);
    tcase_add_test(polygons, all_frames_have_the_triangles_of_the_first);
    tcase_add_test(polygons, frames_that_begin_anew_have_their_own_triangles);
    suite_add_tcase(suite, polygons);

    TCase *other = tcase_create("other elements");
    tcase_add_checked_fixture(other, enter_folder, leave_folder);
    tcase_add_loop_test(other, other_elements_are_refused, 0,
                        sizeof others / sizeof *others);
    tcase_add_test(other, other_polygons_are_refused);
    tcase_add_test(other, other_elements_are_refused_later_too);
    suite_add_tcase(suite, other);

    TCase *flaw = tcase_create("flaws");
    tcase_add_checked_fixture(flaw, enter_folder, leave_folder);
    tcase_add_loop_test(flaw, flaws_have_a_line, 0,
                        sizeof flaws / sizeof *flaws);
    tcase_add_test(flaw, flaws_of_all_elements_have_a_line);
    tcase_add_test(flaw, unreadable_files_are_refused);
    suite_add_tcase(suite, flaw);
    return suite;
}
