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

Suite *suite(void)
{
    Suite *suite = suite_create("formats/mesh_file");
    TCase *mesh = tcase_create("mesh");
    tcase_add_test(mesh, places_beyond_an_int_are_unknown);
    tcase_add_test(mesh, no_more_is_added_than_a_surface_counts);
    tcase_add_test(mesh, faults_count_what_the_file_counts);
    tcase_add_test(mesh, elements_are_lent);
    suite_add_tcase(suite, mesh);
    return suite;
}
