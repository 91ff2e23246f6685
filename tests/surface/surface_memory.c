// What a surface holds when it is refilled, and when it moves.
#include "surface/surface_memory.h"

#include "support/scrambled_workers.h"
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
        ck_assert_int_eq(
            tf_surface_move(surface, &given.motion, i % 3 == 0, NULL, &error),
            TF_OK);
        ck_assert_int_eq(error.subject, TF_NO_SUBJECT);
        ck_assert_int_eq(surface->vertex_tree.count, surface->vertices);
        ck_assert_int_eq(surface->edge_tree.count, surface->edges.count);
        ck_assert_int_eq(surface->triangle_tree.count,
                         surface->triangles.count);
        for (int v = 0; v < surface->vertices; v++) {
            tf_path path = tf_vertex_path(&surface->frame, &given.motion, v);
            ck_assert_mem_eq((tf_path *)surface->paths.data + v, &path,
                             sizeof path);
        }
        tf_surface_free(surface);
    }
}
END_TEST

enum {
    SIDE = 20 ///< vertices of a sheet
};

/// A sheet of squares with unit sides.
static tf_surface *sheet(double x[3 * SIDE * SIDE])
{
    static int triangle[6 * (SIDE - 1) * (SIDE - 1)];
    int count = 0;
    for (int v = 0; v < SIDE * SIDE; v++) {
        x[3 * v] = v % SIDE;
        x[3 * v + 1] = v / SIDE; // NOLINT(bugprone-integer-division)
        x[3 * v + 2] = 0;
        if (v % SIDE == SIDE - 1 || v / SIDE == SIDE - 1)
            continue;
        const int square[] = {v,     v + 1,        v + SIDE,
                              v + 1, v + SIDE + 1, v + SIDE};
        for (int k = 0; k < 6; k++)
            triangle[count++] = square[k];
    }
    tf_mesh mesh = {.axes = 3,
                    .vertices = SIDE * SIDE,
                    .triangles = count / 3,
                    .triangle = triangle};
    return surface_of(&mesh);
}

static double start[3 * SIDE * SIDE], end[3 * SIDE * SIDE];

/// Moves each vertex of the sheet, at most by so much along each axis; returns
/// whether the trees are swept, which no number of workers may change.
static bool is_swept(tf_surface *surface, double most)
{
    generator random = generator_new(7);
    tf_motion motion = {3, SIDE * SIDE, start, end};
    tf_error error;
    for (int i = 0; i < 3 * SIDE * SIDE; i++)
        end[i] += uniform(&random, -most, most);
    ck_assert_int_eq(tf_surface_move(surface, &motion, false, NULL, &error),
                     TF_OK);
    bool swept = surface->edge_tree.swept;
    for (int workers = 2; workers < 5; workers++) {
        tf_parallel parallel = scrambled_workers(&workers);
        ck_assert_int_eq(
            tf_surface_move(surface, &motion, false, &parallel, &error), TF_OK);
        ck_assert_int_eq(surface->vertex_tree.swept, swept);
        ck_assert_int_eq(surface->edge_tree.swept, swept);
        ck_assert_int_eq(surface->triangle_tree.swept, swept);
    }
    // Swept boxes hold both ends, so these have one map.
    const double *center = surface->frame.center;
    for (int k = 0; swept && k < TF_AXES; k++)
        ck_assert(center[k] == center[TF_AXES + k]);
    return swept;
}

START_TEST(calm_motions_have_swept_boxes)
{
    tf_surface *surface = sheet(start);
    memcpy(end, start, sizeof end);
    ck_assert(is_swept(surface, 0));
    ck_assert(is_swept(surface, 0.1));
    memcpy(end, start, sizeof end);
    ck_assert(!is_swept(surface, 1));
    tf_surface_free(surface);
}
END_TEST

START_TEST(other_motions_have_boxes_at_both_ends)
{
    tf_surface *surface = sheet(start);
    const size_t place[] = {0, 1, 2};
    // As a whole: so that the shape stays the same, and so that it is lost.
    for (int k = 0; k < 6; k++) {
        memcpy(end, start, sizeof end);
        for (size_t i = 0; i < SIDE * SIDE; i++)
            end[3 * i + place[k % 3]] += k < 3 ? 64 : 1e300;
        ck_assert(!is_swept(surface, 0));
    }
    // A turn by a right angle, and an expansion.
    for (size_t i = 0; i < SIDE * SIDE; i++) {
        end[3 * i] = -start[3 * i + 1];
        end[3 * i + 1] = start[3 * i];
        end[3 * i + 2] = 0;
    }
    ck_assert(!is_swept(surface, 0));
    for (int i = 0; i < 3 * SIDE * SIDE; i++)
        end[i] = 2 * start[i];
    ck_assert(!is_swept(surface, 0));
    // A row that is shot out of the others, which stay.
    memcpy(end, start, sizeof end);
    for (size_t i = 0; i < SIDE; i++)
        end[3 * i + 2] += 10;
    ck_assert(!is_swept(surface, 0));
    tf_surface_free(surface);
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
    ck_assert_int_eq(tf_surface_move(surface, &more, false, NULL, &error),
                     TF_BAD_COUNT);
    ck_assert_int_eq(error.subject, TF_NO_SUBJECT);
    size_t bytes = sizeof(double) * 3 * (size_t)given.motion.vertices;
    double *place = malloc(bytes);
    ck_assert_ptr_nonnull(place);
    memcpy(place, given.motion.end, bytes);
    place[3 * 2 + 1] = INFINITY;
    tf_motion far = {given.motion.axes, given.motion.vertices,
                     given.motion.start, place};
    ck_assert_int_eq(tf_surface_move(surface, &far, false, NULL, &error),
                     TF_NOT_FINITE);
    ck_assert_int_eq(error.subject, TF_VERTEX);
    ck_assert_int_eq(error.vertex[0], 2);
    free(place);
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
    tcase_add_test(tcase, calm_motions_have_swept_boxes);
    tcase_add_test(tcase, other_motions_have_boxes_at_both_ends);
    tcase_add_test(tcase, bad_motions_are_refused);
    suite_add_tcase(suite, tcase);
    return suite;
}
