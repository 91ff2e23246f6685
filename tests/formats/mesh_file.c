// The contents of a mesh file.
#include "formats/mesh_file.h"

#include "support/meshes.h"
#include "support/support.h"

START_TEST(places_beyond_an_int_are_unknown)
{
    tf_mesh_file file = empty_mesh("large");
    ck_assert(tf_mesh_file_add_edge(&file, (int[]){1, 2}, 0x7fffffff));
    ck_assert(tf_mesh_file_add_edge(&file, (int[]){1, 2}, 0x80000000));
    ck_assert_int_eq(file.edge_place.item[0], 0x7fffffff);
    ck_assert_int_eq(file.edge_place.item[1], -1);
    tf_mesh_file_free(&file);
}
END_TEST

START_TEST(no_more_is_added_than_a_surface_counts)
{
    // Of none is there more than a surface can count; no memory is touched.
    tf_mesh_file file = empty_mesh("large");
    double x[3] = {0};
    int vertex[3] = {0};
    file.vertex_place.count = file.triangle_place.count =
        file.edge_place.count = 0x1fffffff;
    ck_assert(!tf_mesh_file_add_vertex(&file, x, 7));
    ck_assert_str_eq(
        file.fault->text,
        "more than 536870911 vertices, triangles or edges; divide the mesh");
    ck_assert_int_eq(file.fault->place, 7);
    ck_assert(!tf_mesh_file_add_triangle(&file, vertex, 8));
    ck_assert_int_eq(file.fault->place, 8);
    ck_assert(!tf_mesh_file_add_edge(&file, vertex, 9));
    ck_assert_int_eq(file.fault->place, 9);
    tf_mesh_file_free(&file);
}
END_TEST

START_TEST(faults_count_what_the_file_counts)
{
    tf_mesh_file file = empty_mesh("a");
    file.counts_bytes = true;
    ck_assert(!tf_mesh_file_fault(&file, 0, "%s; %d", "bad", 7));
    ck_assert_str_eq(file.fault->file, "a");
    ck_assert_str_eq(file.fault->text, "bad; 7");
    ck_assert(file.fault->counts_bytes);
    file.counts_bytes = false;
    ck_assert(!tf_mesh_file_fault_in_memory(&file));
    ck_assert(!file.fault->counts_bytes);
    ck_assert_int_lt(file.fault->place, 0);
}
END_TEST

START_TEST(elements_are_lent)
{
    tf_mesh_file file =
        good_mesh("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 3 1\n");
    tf_mesh mesh = tf_mesh_file_elements(&file, 2);
    ck_assert_int_eq(mesh.axes, 2);
    ck_assert_int_eq(mesh.vertices, 3);
    ck_assert_int_eq(mesh.triangles, 1);
    ck_assert_ptr_eq(mesh.triangle, file.triangle.item);
    ck_assert_int_eq(mesh.edges, 1);
    ck_assert_ptr_eq(mesh.edge, file.edge.item);
    tf_mesh_file_free(&file);
}
END_TEST

// Faces -----------------------------------------------------------------------

START_TEST(faces_are_gone_through_in_order)
{
    static const int corners[][6] = {{3, 0, 1, 2},
                                     {4, 3, 0, 1, 2},
                                     {5, 4, 3, 2, 1, 0},
                                     {3, 2, 3, 4},
                                     {4, 1, 4, 0, 2}};
    tf_mesh_file file = empty_mesh("faces");
    for (int i = 0; i < 5; i++)
        ck_assert(tf_mesh_file_add_face(&file, corners[i] + 1, corners[i][0],
                                        10 + i));
    ck_assert_int_eq(tf_mesh_file_triangles(&file), 9);
    ck_assert_int_eq(tf_mesh_file_polygons(&file), 3);
    tf_face face = {0};
    for (int i = 0, triangle = 0; i < 5; i++) {
        ck_assert(tf_mesh_file_next_face(&file, &face));
        ck_assert_int_eq(face.corners, corners[i][0]);
        ck_assert_mem_eq(face.corner, corners[i] + 1,
                         sizeof *face.corner * (size_t)face.corners);
        ck_assert_int_eq(face.triangle, triangle);
        ck_assert_int_eq(face.polygon, i > 3 ? 2 : i > 0 ? i - 1 : 0);
        for (int j = 0; j < face.corners - 2; j++)
            ck_assert_int_eq(file.triangle_place.item[triangle++], 10 + i);
    }
    ck_assert(!tf_mesh_file_next_face(&file, &face));
    tf_mesh_file_free(&file);
    face = (tf_face){0};
    ck_assert(!tf_mesh_file_next_face(&file, &face));
}
END_TEST

START_TEST(polygons_are_divided_when_all_vertices_are_known)
{
    tf_mesh_file file = good_mesh("f 4 1 2 3\nf 1 2 3\nf 2 3 1 4\n"
                                  "v 2 3 0\nv 0 1 0\nv -2 3 0\nv 0 0 0\n");
    static const int triangles[] = {3, 0, 1, 1, 2, 3, 0, 1, 2};
    ck_assert_int_eq(tf_mesh_file_triangles(&file), 5);
    for (int i = 0; i < 9; i++)
        ck_assert_int_eq(file.triangle.item[i], triangles[i]);
    tf_mesh_file_free(&file);
}
END_TEST

START_TEST(polygons_have_different_corners_that_exist)
{
    static const struct {
        int corner[4];
        const char *fault;
    } bad[] = {
        {{0, 1, 2, 4}, "there is no vertex 5; they are numbered from 1 to 4"},
        {{0, 1, 2147483647, 3},
         "there is no vertex 2147483648; they are numbered from 1 to 4"},
        {{3, 1, 2, 3},
         "vertex 4 is a corner twice; divide the face, or delete it, "
         "here and in all files"}};
    for (int i = 0; i < 3; i++) {
        tf_mesh_file file = empty_mesh("bad");
        double x[3] = {0};
        file.first_index = 1;
        for (int v = 0; v < 4; v++)
            ck_assert(tf_mesh_file_add_vertex(&file, x, v));
        ck_assert(tf_mesh_file_add_face(&file, (int[]){3, 2, 1, 0}, 4, 7) &&
                  tf_mesh_file_add_face(&file, bad[i].corner, 4, 8) &&
                  tf_mesh_file_add_face(&file, (int[]){0, 1, 2, 2}, 4, 9));
        ck_assert(!tf_mesh_file_divide(&file));
        ck_assert_str_eq(file.fault->text, bad[i].fault);
        ck_assert_int_eq(file.fault->place, 8);
        tf_mesh_file_free(&file);
    }
}
END_TEST

START_TEST(faces_with_too_few_corners_are_refused)
{
    tf_mesh_file file = empty_mesh("few");
    ck_assert(tf_mesh_file_check_corners(&file, 3, 4));
    ck_assert(!tf_mesh_file_check_corners(&file, 2, 4));
    ck_assert_str_eq(file.fault->text,
                     "a face with 2 corners; each must have three or more");
    ck_assert_int_eq(file.fault->place, 4);
}
END_TEST

#define RING                                                                   \
    "v 0 0 0\nv 9 0 0\nv 9 9 0\nv 0 9 0\nv 3 3 0\nv 3 6 0\nv 6 6 0\nv 6 3 0\n"

START_TEST(a_slit_may_lead_to_a_hole)
{
    tf_mesh_file file = good_mesh(RING "f 1 2 3 4 1 5 6 7 8 5\n");
    double area = 0;
    ck_assert_int_eq(tf_mesh_file_triangles(&file), 8);
    for (int t = 0; t < 8; t++) {
        const int *v = file.triangle.item + (ptrdiff_t)3 * t;
        const double *a = file.position.item + (ptrdiff_t)3 * v[0];
        const double *b = file.position.item + (ptrdiff_t)3 * v[1];
        const double *c = file.position.item + (ptrdiff_t)3 * v[2];
        double twice =
            (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        ck_assert_double_gt(twice, 0);
        area += twice / 2;
    }
    ck_assert_double_eq(area, 81 - 9);
    tf_mesh_file_free(&file);
    // Filled, around twice, and two triangles on one side.
    expect_bad_mesh(RING "f 1 2 3 4 1 5 8 7 6 5\n", 9,
                    "vertex 1 is a corner twice; divide the face, or delete "
                    "it, here and in all files");
    expect_bad_mesh(RING "f 5 6 7\nf 1 2 3 4 1 2 3 4\n", 10,
                    "vertex 1 is a corner twice");
    expect_bad_mesh("v 0 0 0\nv 2 0 0\nv 1 1 0\nv 1 2 0\nf 4 2 1 3 2 1\n", 5,
                    "vertex 2 is a corner twice");
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("formats/mesh_file");
    TCase *mesh = tcase_create("mesh");
    tcase_add_test(mesh, places_beyond_an_int_are_unknown);
    tcase_add_test(mesh, no_more_is_added_than_a_surface_counts);
    tcase_add_test(mesh, faults_count_what_the_file_counts);
    tcase_add_test(mesh, elements_are_lent);
    suite_add_tcase(suite, mesh);

    TCase *faces = tcase_create("faces");
    tcase_add_test(faces, faces_are_gone_through_in_order);
    tcase_add_test(faces, polygons_are_divided_when_all_vertices_are_known);
    tcase_add_test(faces, polygons_have_different_corners_that_exist);
    tcase_add_test(faces, a_slit_may_lead_to_a_hole);
    tcase_add_test(faces, faces_with_too_few_corners_are_refused);
    suite_add_tcase(suite, faces);
    return suite;
}
