// Frames of meshes: their names, and what is written.
#include "writers/mesh_frame.h"

#include "formats/mesh_reader.h"
#include "support/program.h"
#include "support/support.h"

#include <string.h>

static const double moved[] = {0, 0, 0.5, 1, 0, 0.5, 0, 1, 0.1};

static bool write_frame(const char *folder, const char *name,
                        char path[TF_MESH_FRAME_PATH], tf_fault *fault)
{
    tf_mesh_file file = {0};
    tf_source source = {0};
    ck_assert(tf_mesh_file_read_all(&file, "a.obj", NULL, &source, fault));
    tf_mesh_frame frame = {folder, name, 12, &file, moved};
    bool good = tf_mesh_frame_write(&frame, path, fault);
    tf_mesh_file_free(&file);
    tf_source_free(&source);
    return good;
}

START_TEST(a_frame_has_new_positions_alone)
{
    char path[TF_MESH_FRAME_PATH];
    tf_fault fault = {0};
    run("mkdir folder");
    make_file("a.obj", "o shirt\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\n"
                       "f 1 2 3\n");
    ck_assert_msg(write_frame("folder", "shirt", path, &fault), "%s",
                  fault.text);
    ck_assert_str_eq(path, "folder/shirt-00012.obj");
    ck_assert_str_eq(file_text(path), "o shirt\nv 0 0 0.5\nv 1 0 0.5\n"
                                      "v 0 1 0.1\nusemtl red\nf 1 2 3\n");
}
END_TEST

START_TEST(what_cannot_be_written_is_told)
{
    char path[TF_MESH_FRAME_PATH], longest[TF_MESH_FRAME_PATH];
    tf_fault fault = {0};
    make_file("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    ck_assert(!write_frame("none", "shirt", path, &fault));
    ck_assert_str_eq(fault.file, path);
    memset(longest, 'a', sizeof longest);
    longest[sizeof longest - 1] = '\0';
    ck_assert(!write_frame("folder", longest, path, &fault));
    ck_assert_str_eq(fault.file, "folder");
    ck_assert_str_eq(fault.text, "cannot write: File name too long; give the "
                                 "mesh a shorter name");
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("writers/mesh_frame");
    TCase *tcase = tcase_create("frames");
    tcase_add_checked_fixture(tcase, enter_folder, leave_folder);
    tcase_add_test(tcase, a_frame_has_new_positions_alone);
    tcase_add_test(tcase, what_cannot_be_written_is_told);
    suite_add_tcase(suite, tcase);
    return suite;
}
