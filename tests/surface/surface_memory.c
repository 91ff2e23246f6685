// What a surface holds when it is refilled, and when it moves.
#include "surface/surface_memory.h"

#include "support/support.h"
#include "support/surface_of.h"
#include "support/surfaces.h"
#include "surface/detect.h"
#include "surface/surface.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void expect_same(const tf_elements *list, const tf_elements *expected)
{
    ck_assert_int_eq(list->count, expected->count);
    ck_assert_mem_eq(list->corner, expected->corner,
                     sizeof *list->corner *
                         (size_t)(list->corners * list->count));
}

// A surface takes other meshes in the same memory, also in another space.
START_TEST(a_refilled_surface_is_like_a_new_one)
{
    static surface_case given;
    generator random = generator_new(2);
    random_surface(&random, 2, 1, ANYWHERE, &given);
    tf_surface *refilled = surface_of(&given.mesh);
    for (int i = 0; i < (int)cases(200); i++) {
        random_surface(&random, 2 + below(&random, 2),
                       1 + below(&random, SURFACE_ELEMENTS), ANYWHERE, &given);
        ck_assert(tf_surface_refill(refilled, &given.mesh));
        tf_surface *surface = surface_of(&given.mesh);
        ck_assert_int_eq(refilled->axes, surface->axes);
        ck_assert_int_eq(refilled->vertices, surface->vertices);
        expect_same(&refilled->edges, &surface->edges);
        expect_same(&refilled->triangles, &surface->triangles);
        tf_contacts contacts, again;
        ck_assert_int_eq(
            tf_detect(surface, &given.motion, NULL, &contacts, NULL), TF_OK);
        ck_assert_int_eq(tf_detect(refilled, &given.motion, NULL, &again, NULL),
                         TF_OK);
        ck_assert_uint_eq(again.count, contacts.count);
        if (again.count > 0)
            ck_assert_mem_eq(again.contact, contacts.contact,
                             again.count * sizeof *again.contact);
        tf_surface_free(surface);
    }
    tf_surface_free(refilled);
}
END_TEST

START_TEST(a_refilled_surface_has_no_filter)
{
    static surface_case given;
    static const int group[SURFACE_VERTICES];
    generator random = generator_new(5);
    random_surface(&random, 3, SURFACE_ELEMENTS, ANYWHERE, &given);
    tf_surface *surface = surface_of(&given.mesh);
    tf_pair_filter filter = {.vertices = given.mesh.vertices, .group = group};
    ck_assert_int_eq(tf_surface_set_filter(surface, &filter, NULL), TF_OK);
    ck_assert_ptr_nonnull(surface->filter.group);
    ck_assert(tf_surface_refill(surface, &given.mesh));
    ck_assert(!surface->filter.group && !surface->filter.wanted);
    tf_surface_free(surface);
}
END_TEST

START_TEST(trees_have_all_elements_and_their_boxes)
{
    static surface_case given;
    generator random = generator_new(3);
    for (int i = 0; i < (int)cases(100); i++) {
        random_surface(&random, 2 + i % 2, SURFACE_ELEMENTS, ANYWHERE, &given);
        tf_surface *surface = surface_of(&given.mesh);
        tf_error error;
        ck_assert_int_eq(tf_surface_move(surface, &given.motion, NULL, &error),
                         TF_OK);
        ck_assert_int_eq(error.subject, TF_NO_SUBJECT);
        ck_assert_int_eq(surface->vertex_tree.count, surface->vertices);
        ck_assert_int_eq(surface->edge_tree.count, surface->edges.count);
        ck_assert_int_eq(surface->triangle_tree.count,
                         surface->triangles.count);
        for (int v = 0; v < surface->vertices; v++) {
            tf_box box = tf_vertex_box(&surface->frame, &given.motion, v);
            ck_assert_mem_eq((tf_box *)surface->boxes.data + v, &box,
                             sizeof box);
        }
        tf_surface_free(surface);
    }
}
END_TEST

START_TEST(bad_motions_are_refused)
{
    static surface_case given;
    generator random = generator_new(4);
    random_surface(&random, 3, SURFACE_ELEMENTS, ANYWHERE, &given);
    tf_surface *surface = surface_of(&given.mesh);
    tf_error error;
    tf_motion more = given.motion;
    more.vertices++;
    ck_assert_int_eq(tf_surface_move(surface, &more, NULL, &error),
                     TF_BAD_COUNT);
    ck_assert_int_eq(error.subject, TF_NO_SUBJECT);
    size_t bytes = sizeof(double) * 3 * (size_t)given.motion.vertices;
    double *end = malloc(bytes);
    ck_assert_ptr_nonnull(end);
    memcpy(end, given.motion.end, bytes);
    end[3 * 2 + 1] = INFINITY;
    tf_motion far = {given.motion.axes, given.motion.vertices,
                     given.motion.start, end};
    ck_assert_int_eq(tf_surface_move(surface, &far, NULL, &error),
                     TF_NOT_FINITE);
    ck_assert_int_eq(error.subject, TF_VERTEX);
    ck_assert_int_eq(error.vertex[0], 2);
    free(end);
    tf_surface_free(surface);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surface/surface_memory");
    TCase *tcase = tcase_create("memory");
    tcase_add_test(tcase, a_refilled_surface_is_like_a_new_one);
    tcase_add_test(tcase, a_refilled_surface_has_no_filter);
    tcase_add_test(tcase, trees_have_all_elements_and_their_boxes);
    tcase_add_test(tcase, bad_motions_are_refused);
    suite_add_tcase(suite, tcase);
    return suite;
}
