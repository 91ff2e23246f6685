#include "writers/vtp_writer.h"

#include "support/meshes.h"
#include "support/polydata.h"
#include "support/support.h"

#include <stdlib.h>

START_TEST(a_mesh_is_triangles_and_lines)
{
    tf_columns columns;
    read_columns(&columns);
    tf_mesh_file file = good_mesh("v 0 0 1 .5 .25 0\nv 1 0 0\nv 1 1 0\n"
                                  "v 0 1 0.1\nf 1 2 3 4\nl 4 2 1\n");
    read_columns(NULL);
    tf_mesh_content content = content_of(&file);
    content.from = &file;
    content.columns = &columns;
    size_t size;
    char *text = bytes_of_mesh(&content, TF_VTP, &size);
    for (size_t i = 0; i < 12; i++)
        ck_assert(polydata_number(text, size, "Points", "Points", "Float64", 3,
                                  12, i) == file.position.item[i]);
    ck_assert_int_eq(polydata_count(text, "NumberOfPolys"), 2);
    for (size_t i = 0; i < 6; i++)
        ck_assert(polydata_number(text, size, "Polys", "connectivity", "Int32",
                                  1, 6, i) == file.triangle.item[i]);
    ck_assert_int_eq(polydata_count(text, "NumberOfLines"), 2);
    for (size_t i = 0; i < 4; i++)
        ck_assert(polydata_number(text, size, "Lines", "connectivity", "Int32",
                                  1, 4, i) == file.edge.item[i]);
    for (size_t i = 0; i < 4; i++)
        ck_assert(polydata_number(text, size, "PointData", "green", "Float64",
                                  1, 4, i) == (i > 0 ? 1 : 0.25));
    free(text);
    tf_columns_free(&columns);
    tf_mesh_file_free(&file);
}
END_TEST

START_TEST(velocities_are_vectors)
{
    static const double x[] = {1, 2, 3, 4}, velocity[] = {5, 6, 7, 8};
    static const double wanted[] = {5, 6, 0, 7, 8, 0};
    static const int edge[] = {0, 1};
    tf_mesh_content content = {
        .mesh = {.axes = 2, .vertices = 2, .edges = 1, .edge = edge},
        .position = x,
        .velocity = velocity};
    size_t size;
    char *text = bytes_of_mesh(&content, TF_VTP, &size);
    for (size_t i = 0; i < 6; i++)
        ck_assert(polydata_number(text, size, "PointData", "velocity",
                                  "Float64", 3, 6, i) == wanted[i]);
    free(text);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("writers/vtp_writer");
    TCase *tcase = tcase_create("PolyData of meshes");
    tcase_add_test(tcase, a_mesh_is_triangles_and_lines);
    tcase_add_test(tcase, velocities_are_vectors);
    suite_add_tcase(suite, tcase);
    return suite;
}
