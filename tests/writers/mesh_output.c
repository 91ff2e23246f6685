#include "writers/mesh_output.h"

#include "support/meshes.h"
#include "support/program.h"
#include "support/support.h"

#include <stdio.h>

static const char text[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

static tf_fault fault;

static bool write_to(const char *path)
{
    static const tf_field fields[] = {{"done", TF_COUNT, 0, NULL}, {0}};
    static const size_t count = 1;
    static const tf_mesh_report report = {TF_SUMMARY, fields, &count};
    tf_destination output = {0};
    tf_mesh_file mesh = good_mesh(text);
    tf_mesh_content content = content_of(&mesh);
    fault = (tf_fault){0};
    bool good = tf_mesh_output_begin(&output, path, &mesh, &fault) &&
                tf_mesh_output_write(&output, &content, &mesh, &report);
    ck_assert(good == (fault.text[0] == '\0'));
    tf_destination_end(&output);
    tf_mesh_file_free(&mesh);
    return good;
}

START_TEST(a_mesh_is_written_to_a_file)
{
    ck_assert_ptr_nonnull(freopen("told", "w", stdout));
    ck_assert(write_to("made"));
    ck_assert_str_eq(file_text("made"), text);
    ck_assert_str_eq(file_text("told"), "done: 1\n");
    ck_assert(write_to("made.ply"));
    expect_words(file_text("made.ply"), "ply\n");
}
END_TEST

START_TEST(a_mesh_is_written_to_standard_output)
{
    ck_assert_ptr_nonnull(freopen("made", "w", stdout));
    ck_assert_ptr_nonnull(freopen("told", "w", stderr));
    ck_assert(write_to("-"));
    ck_assert_str_eq(file_text("made"), text);
    ck_assert_str_eq(file_text("told"), "done: 1\n");
}
END_TEST

// Not in part, and not at all if the report cannot be written.
START_TEST(what_fails_leaves_the_file_as_it_was)
{
    make_file("made", "before\n");
    ck_assert_ptr_nonnull(freopen("/dev/full", "w", stdout));
    ck_assert(!write_to("made"));
    ck_assert_str_eq(fault.file, "standard output");
    ck_assert_str_eq(file_text("made"), "before\n");
    ck_assert(!write_to("no/folder/made"));
    ck_assert_str_eq(fault.file, "no/folder/made");
    expect_words(fault.text, "there is no folder 'no/folder'; ");
}
END_TEST

START_TEST(what_cannot_be_written_is_refused_at_once)
{
    make_file("made.fbx", "before\n");
    ck_assert(!write_to("made.fbx"));
    ck_assert_str_eq(fault.file, "made.fbx");
    expect_words(fault.text, ".fbx is not written; ");
    ck_assert_str_eq(file_text("made.fbx"), "before\n");
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("writers/mesh_output");
    TCase *tcase = tcase_create("files");
    tcase_add_checked_fixture(tcase, enter_folder, leave_folder);
    tcase_add_test(tcase, a_mesh_is_written_to_a_file);
    tcase_add_test(tcase, a_mesh_is_written_to_standard_output);
    tcase_add_test(tcase, what_fails_leaves_the_file_as_it_was);
    tcase_add_test(tcase, what_cannot_be_written_is_refused_at_once);
    suite_add_tcase(suite, tcase);
    return suite;
}
