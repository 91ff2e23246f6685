#include "program/defects.h"

#include "support/meshes.h"
#include "support/support.h"

#include <string.h>

/// A text, the line that is named, and words about it.
static const struct {
    const char *text;
    long place;
    const char *words;
} meshes[] = {
    {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 3 2\n", 5,
     "the edge from vertex 3 to 2 belongs to no triangle; remove it"},
    {"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\n", 5,
     "another triangle passes the edge from vertex 1 to 2 in the same"},
    {"v 0 0 0\nv 1 0 0\nv 1 1 0\nv -1 0 0\nv -1 -1 0\nf 1 2 3\nf 1 4 5\n", 1,
     "the triangles at vertex 1 form more than one ring or fan"},
    {"v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", 4,
     "the corners of this triangle are on one line"},
    {"v 0 0 0\nv 4 0 0\nv 0 4 0\nv 1 1 -1\nv 1 1 1\nv 9 9 9\nf 1 2 3\n"
     "f 4 5 6\n",
     -1, "edge 3 4 passes through triangle 0 1 2 (numbered from 0); move them"},
};

START_TEST(the_place_of_a_defect_is_named)
{
    tf_mesh_file file = good_mesh(meshes[_i].text);
    tf_mesh mesh = {3,
                    tf_mesh_file_vertices(&file),
                    tf_mesh_file_triangles(&file),
                    file.triangle.item,
                    tf_mesh_file_edges(&file),
                    file.edge.item};
    tf_adaptive_surface *surface;
    tf_defect defect;
    tf_status status =
        tf_adaptive_create(&mesh, file.position.item, &surface, &defect);
    ck_assert(!tf_defect_fault(&file, status, &defect));
    ck_assert_int_eq(file.fault_place, meshes[_i].place);
    ck_assert_ptr_nonnull(strstr(file.fault, meshes[_i].words));
    tf_mesh_file_free(&file);
}
END_TEST

START_TEST(other_statuses_have_their_message)
{
    tf_mesh_file file = {.name = "mesh"};
    ck_assert(!tf_defect_fault(&file, TF_OUT_OF_MEMORY, &(tf_defect){0}));
    ck_assert_str_eq(file.fault, tf_status_message(TF_OUT_OF_MEMORY));
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/defects");
    TCase *tcase = tcase_create("faults");
    tcase_add_loop_test(tcase, the_place_of_a_defect_is_named, 0,
                        sizeof meshes / sizeof *meshes);
    tcase_add_test(tcase, other_statuses_have_their_message);
    suite_add_tcase(suite, tcase);
    return suite;
}
