#include "writers/off_writer.h"

#include "support/meshes.h"
#include "support/support.h"

#include <stdio.h>

START_TEST(off_is_written_to_the_letter)
{
    tf_mesh_file file = good_mesh("v 0.5 0 1\nv 1 0 0\nv 0 1 0.1\nv 2 2 2\n"
                                  "f 1 2 3\nf 1 2 3 4\nl 3 1\n");
    tf_mesh_content content = content_of(&file);
    content.from = &file;
    expect_mesh_text(&content, TF_OFF,
                     "OFF\n4 2 0\n0.5 0 1\n1 0 0\n0 1 0.1\n"
                     "2 2 2\n3 0 1 2\n4 0 1 2 3\n");
    tf_mesh_file_free(&file);
}
END_TEST

static void expect_colored(const char *text, const char *vertices)
{
    char wanted[200];
    tf_columns columns;
    read_columns(&columns);
    tf_mesh_file file = good_mesh(text);
    read_columns(NULL);
    tf_mesh_content content = content_of(&file);
    content.columns = &columns;
    sprintf(wanted, "COFF\n3 1 0\n%s3 0 1 2\n", vertices);
    expect_mesh_text(&content, TF_OFF, wanted);
    tf_columns_free(&columns);
    tf_mesh_file_free(&file);
}

START_TEST(colors_are_written)
{
    expect_colored("v 0 0 1 .5 .25 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
                   "0 0 1 0.5 0.25 0 1\n1 0 0 1 1 1 1\n0 1 0 1 1 1 1\n");
    expect_colored("ply\nformat ascii 1.0\nelement vertex 3\n"
                   "property float x\nproperty float y\nproperty float z\n"
                   "property uchar red\nproperty uchar green\n"
                   "property uchar blue\nelement face 1\n"
                   "property list uchar int vertex_indices\nend_header\n"
                   "0 0 1 255 1 2\n1 0 0 77 254 3\n0 1 0 0 0 0\n3 0 1 2\n",
                   "0 0 1 255 1 2 255\n1 0 0 77 254 3 255\n"
                   "0 1 0 0 0 0 255\n");
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("writers/off_writer");
    TCase *tcase = tcase_create("OFF");
    tcase_add_test(tcase, off_is_written_to_the_letter);
    tcase_add_test(tcase, colors_are_written);
    suite_add_tcase(suite, tcase);
    return suite;
}
