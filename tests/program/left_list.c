// The list of what is left, to the letter.
#define _GNU_SOURCE // open_memstream

#include "program/left_list.h"

#include "support/json.h"
#include "support/program.h"
#include "support/support.h"

#include <stdlib.h>

static tf_scene_meshes meshes;
static tf_scene_frames frames;
static const char *names[] = {"body", "shirt"};

static void enter_folder_with_scene(void)
{
    enter_folder();
    make_file("a", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    meshes = (tf_scene_meshes){.frames = 2};
    frames = (tf_scene_frames){.meshes = &meshes};
    for (int m = 0; m < 2; m++)
        ck_assert(
            tf_frame_names_add(&tf_scene_meshes_add(&meshes)->frames, "a"));
    ck_assert(tf_scene_frames_next(&frames));
}

static void leave_folder_with_scene(void)
{
    tf_scene_frames_free(&frames);
    tf_scene_meshes_free(&meshes);
    leave_folder();
}

static const tf_crossing crossed[] = {
    {TF_EDGE_THROUGH_TRIANGLE, {3, 4, 0, 1, 2}},
    {TF_POINT_ON_TRIANGLE, {0, 3, 4, 5, -1}},
};

/// Lists nothing in a frame, and then so many intersections in the next.
static void expect_list(tf_format format, tf_row_names rows, size_t count,
                        const char *right)
{
    tf_left_list list = {0};
    char *text;
    size_t size;
    FILE *stream = open_memstream(&text, &size);
    ck_assert(tf_left_list_begin(&list, &frames, format, rows, names));
    ck_assert(tf_left_list_add(&list, &frames, &(tf_crossings){0, NULL}));
    ck_assert(
        tf_left_list_add(&list, &frames, &(tf_crossings){count, crossed}));
    ck_assert(tf_left_list_write(&list, &frames, stream));
    tf_left_list_free(&list);
    fclose(stream);
    ck_assert_str_eq(text, right);
    free(text);
}

START_TEST(rows_name_the_meshes_and_the_frame)
{
    static const char rows[] = "\nframe,kind,a,b,c,d,e,f,mesh,other_mesh\n"
                               "1,edge-triangle,0,1,0,1,2,,shirt,body\n"
                               "1,point-triangle,0,0,1,2,,,body,shirt\n";
    expect_list(TF_CSV, TF_NAMES_OF_MESHES, 2, rows);
    expect_list(TF_SUMMARY, TF_NAMES_OF_MESHES, 2, rows);
    expect_list(TF_JSON, TF_NAMES_OF_MESHES, 1,
                "{\"intersections\":[\n{\"frame\":1,\"kind\":"
                "\"edge-triangle\",\"a\":0,\"b\":1,\"c\":0,\"d\":1,\"e\":2,"
                "\"mesh\":\"shirt\",\"other_mesh\":\"body\"}\n],\n"
                "\"summary\":{\"frames\":2,\"frames_with_intersections\":1,"
                "\"intersections\":1}}\n");
}
END_TEST

START_TEST(nothing_is_written_where_nothing_is_left)
{
    expect_list(TF_CSV, TF_NAMES_OF_FILE, 0, "");
    expect_list(TF_JSON, TF_NAMES_OF_MESHES, 0, "");
}
END_TEST

START_TEST(a_full_disk_is_told)
{
    tf_left_list list = {0};
    FILE *full = fopen("/dev/full", "w");
    ck_assert(
        tf_left_list_begin(&list, &frames, TF_CSV, TF_NAMES_OF_FILE, names));
    ck_assert(tf_left_list_add(&list, &frames, &(tf_crossings){2, crossed}));
    ck_assert(!tf_left_list_write(&list, &frames, full));
    ck_assert_str_eq(frames.fault.file, "the list");
    expect_words(frames.fault.text, "cannot write: No space left on device");
    tf_left_list_free(&list);
    fclose(full);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/left_list");
    TCase *tcase = tcase_create("lists");
    tcase_add_checked_fixture(tcase, enter_folder_with_scene,
                              leave_folder_with_scene);
    tcase_add_test(tcase, rows_name_the_meshes_and_the_frame);
    tcase_add_test(tcase, nothing_is_written_where_nothing_is_left);
    tcase_add_test(tcase, a_full_disk_is_told);
    suite_add_tcase(suite, tcase);
    return suite;
}
