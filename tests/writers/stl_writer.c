#include "writers/stl_writer.h"

#include "support/meshes.h"
#include "support/support.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/// A float or an unsigned integer of the least significant byte first.
static float float_at(const char *bytes)
{
    const unsigned char *b = (const unsigned char *)bytes;
    uint32_t bits = b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 |
                    (uint32_t)b[3] << 24;
    float number;
    memcpy(&number, &bits, sizeof number);
    return number;
}

START_TEST(stl_is_triangles_with_normals)
{
    tf_mesh_file file = good_mesh("v 0 0 0.1\nv 2 0 0.1\nv 0 3 0.1\nv 0 0 9\n"
                                  "f 1 2 3\nf 4 1 1\nf 3 1 4\n");
    tf_mesh_content content = content_of(&file);
    size_t size;
    char *bytes = bytes_of_mesh(&content, TF_STL_BINARY, &size);
    ck_assert_uint_eq(size, 84 + 3 * 50);
    ck_assert(strncmp(bytes, "solid", 5) != 0);
    ck_assert_mem_eq(bytes + 80, "\3\0\0\0", 4);
    static const float first[] = {0, 0, 1, 0, 0, 0.1F, 2, 0, 0.1F, 0, 3, 0.1F};
    for (int i = 0; i < 12; i++)
        ck_assert_float_eq(float_at(bytes + 84 + 4 * i), first[i]);
    ck_assert_mem_eq(bytes + 84 + 48, "\0\0", 2);
    for (int i = 0; i < 3; i++) // of no area
        ck_assert_float_eq(float_at(bytes + 134 + 4 * i), 0);
    ck_assert_float_eq(float_at(bytes + 184), -1);
    free(bytes);
    tf_mesh_file_free(&file);
}
END_TEST

START_TEST(normals_of_floats_of_all_sizes_are_units)
{
    static const double sizes[] = {1e38, 1e-37};
    for (int i = 0; i < 2; i++) {
        double x[] = {0, 0, 0, sizes[i], 0, 0, 0, sizes[i], 0};
        static const int triangle[] = {0, 1, 2};
        tf_mesh_content content = {.mesh = {.axes = 3,
                                            .vertices = 3,
                                            .triangles = 1,
                                            .triangle = triangle},
                                   .position = x};
        size_t size;
        char *bytes = bytes_of_mesh(&content, TF_STL_BINARY, &size);
        ck_assert_float_eq(float_at(bytes + 92), 1);
        free(bytes);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("writers/stl_writer");
    TCase *tcase = tcase_create("STL");
    tcase_add_test(tcase, stl_is_triangles_with_normals);
    tcase_add_test(tcase, normals_of_floats_of_all_sizes_are_units);
    suite_add_tcase(suite, tcase);
    return suite;
}
