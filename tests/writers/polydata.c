#define _GNU_SOURCE // open_memstream

#include "writers/polydata.h"

#include "support/polydata.h"
#include "support/support.h"

#include <stdlib.h>
#include <string.h>

static char *text;
static size_t size;

static void write_data(const tf_polydata *data)
{
    FILE *stream = open_memstream(&text, &size);
    tf_polydata_write(stream, data);
    ck_assert_int_eq(fclose(stream), 0);
    static const char end[] = "\n</AppendedData>\n</VTKFile>\n";
    ck_assert_str_eq(text + size - strlen(end), end);
}

/// Expects an array of that type, and its numbers.
static void expect_array(const char *element, const char *name,
                         const char *type, int components, size_t count,
                         const double number[])
{
    for (size_t i = 0; i < count; i++) {
        double found = polydata_number(text, size, element, name, type,
                                       components, count, i);
        ck_assert_msg(found == number[i], "%s of %s, %zu: %g", name, element, i,
                      found);
    }
}

START_TEST(points_and_cells_are_written)
{
    static const double x[] = {0.1, 2, 3, 4, 5, 6, 7, 8, 1e300};
    static const int triangle[] = {2, 0, 1}, edges[] = {0, 1, 1, 2};
    tf_polydata data = tf_polydata_of(3, x, 3);
    data.verts = tf_polydata_cells_of(3, 1, NULL);
    data.lines = tf_polydata_cells_of(2, 2, edges);
    data.polys = tf_polydata_cells_of(1, 3, triangle);
    write_data(&data);
    ck_assert_int_eq(polydata_count(text, "NumberOfPoints"), 3);
    ck_assert_int_eq(polydata_count(text, "NumberOfVerts"), 3);
    ck_assert_int_eq(polydata_count(text, "NumberOfLines"), 2);
    ck_assert_int_eq(polydata_count(text, "NumberOfPolys"), 1);
    expect_array("Points", "Points", "Float64", 3, 9, x);
    expect_array("Verts", "connectivity", "Int32", 1, 3,
                 (const double[]){0, 1, 2});
    expect_array("Verts", "offsets", "Int32", 1, 3, (const double[]){1, 2, 3});
    expect_array("Lines", "connectivity", "Int32", 1, 4,
                 (const double[]){0, 1, 1, 2});
    expect_array("Lines", "offsets", "Int32", 1, 2, (const double[]){2, 4});
    expect_array("Polys", "connectivity", "Int32", 1, 3,
                 (const double[]){2, 0, 1});
    expect_array("Polys", "offsets", "Int32", 1, 1, (const double[]){3});
    free(text);
}
END_TEST

START_TEST(points_of_the_plane_have_a_third_coordinate)
{
    static const double x[] = {1, 2, 3, 4};
    tf_polydata data = tf_polydata_of(2, x, 2);
    write_data(&data);
    expect_array("Points", "Points", "Float64", 3, 6,
                 (const double[]){1, 2, 0, 3, 4, 0});
    free(text);
}
END_TEST

START_TEST(arrays_have_types_and_strides)
{
    static const double x[6], rows[] = {1, 2, 3, 4, 0.25, 6, 7, 8};
    static const int index[] = {-1, 2, 3, 4};
    tf_polydata data = tf_polydata_of(2, x, 3);
    tf_polydata_add(&data, &(tf_polydata_array){"a<&\"\x7f\xc3", TF_FLOAT, 3, 2,
                                                rows, 4, NULL, 0, 0});
    tf_polydata_add(&data, &(tf_polydata_array){"byte", TF_UCHAR, 1, 2,
                                                rows + 3, 4, NULL, 0, 0});
    tf_polydata_add(&data, &(tf_polydata_array){"index", TF_INT, 2, 2, NULL, 0,
                                                index, 0, 0});
    write_data(&data);
    expect_array("PointData", "a&#60;&#38;&#34;__", "Float32", 3, 6,
                 (const double[]){1, 2, 3, 0.25, 6, 7});
    expect_array("PointData", "byte", "UInt8", 1, 2, (const double[]){4, 8});
    expect_array("PointData", "index", "Int32", 2, 4,
                 (const double[]){-1, 2, 3, 4});
    free(text);
}
END_TEST

START_TEST(no_more_arrays_are_added_than_fit)
{
    tf_polydata data = tf_polydata_of(0, NULL, 3);
    for (int i = 0; i < 2 * TF_MOST_ARRAYS; i++)
        tf_polydata_add(&data,
                        &(tf_polydata_array){.name = "a", .components = 1});
    ck_assert_int_eq(data.arrays, TF_MOST_ARRAYS);
    write_data(&data);
    free(text);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("writers/polydata");
    TCase *tcase = tcase_create("PolyData");
    tcase_add_test(tcase, points_and_cells_are_written);
    tcase_add_test(tcase, points_of_the_plane_have_a_third_coordinate);
    tcase_add_test(tcase, arrays_have_types_and_strides);
    tcase_add_test(tcase, no_more_arrays_are_added_than_fit);
    suite_add_tcase(suite, tcase);
    return suite;
}
