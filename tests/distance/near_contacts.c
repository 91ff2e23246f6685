// Near pairs in the list of contacts.
#include "distance/near_contacts.h"

#include "support/near_oracle.h"
#include "support/proposals.h"
#include "support/support.h"
#include "support/surface_of.h"
#include "support/watches.h"

#include <math.h>
#include <string.h>

static proposal made;

static void expect_near_row(const tf_surface_contact *row,
                            const near_oracle_pair *pair)
{
    const tf_contact *contact = &row->contact;
    const double *n = contact->normal;
    double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    ck_assert_int_eq((int)row->kind, pair->kind);
    ck_assert_mem_eq(row->vertex, pair->vertex, sizeof row->vertex);
    ck_assert(fabs(length - 1) < 1e-12 || length == 0);
    ck_assert(contact->verdict == TF_APART);
    ck_assert(contact->toi_lo == 1 && contact->toi_hi == 1);
    ck_assert(contact->normal_velocity == 0);
    for (int i = 0; i < 2; i++) {
        const double *b = contact->barycentric[i];
        ck_assert_double_eq_tol(b[0] + b[1] + b[2], 1, 1e-12);
    }
}

START_TEST(near_pairs_are_listed_as_contacts)
{
    int number = proposal_number(_i);
    generator random = generator_new((uint64_t)number);
    proposal_make(&random, (proposal_shape)(number / PROPOSAL_WAYS), 2,
                  (proposal_way)(number % PROPOSAL_WAYS), &made);
    tf_surface *surface = surface_of(&made.mesh);
    tf_motion motion = {made.mesh.axes, made.mesh.vertices, made.start,
                        made.end};
    double length = made.unit * uniform(&random, 0.05, 0.5);
    tf_thickness thickness = {.length = length};
    tf_contacts found = {.statistics = {.candidates = 7}};
    size_t pairs, at_start;
    ck_assert_int_eq(
        tf_near_contacts_find(&thickness, surface, &motion, NULL, &found, NULL),
        TF_OK);
    const near_oracle_pair *pair =
        near_oracle(surface, made.end, made.start, length, &pairs);
    ck_assert_uint_eq(found.count, pairs);
    ck_assert(found.any == (pairs > 0) && found.statistics.candidates == 7);
    for (size_t i = 0; i < pairs; i++)
        expect_near_row(&found.contact[i], &pair[i]);
    ck_assert_int_eq(tf_near_contacts_count_start(&thickness, surface, &motion,
                                                  NULL, &at_start, NULL),
                     TF_OK);
    near_oracle(surface, made.start, NULL, length, &pairs);
    ck_assert_uint_eq(at_start, pairs);
    tf_buffer_free(&thickness.row);
    tf_surface_free(surface);
}
END_TEST

/// A point that ends above the middle of a triangle.
START_TEST(the_normal_goes_to_the_first_element)
{
    static const int triangle[] = {0, 1, 2};
    static const double start[] = {0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, 3},
                        end[] = {0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, 0.5};
    tf_surface *surface = surface_of(&(tf_mesh){
        .axes = 3, .vertices = 4, .triangles = 1, .triangle = triangle});
    tf_motion motion = {3, 4, start, end};
    tf_thickness thickness = {.length = 1};
    tf_contacts found = {0};
    ck_assert_int_eq(
        tf_near_contacts_find(&thickness, surface, &motion, NULL, &found, NULL),
        TF_OK);
    ck_assert_uint_eq(found.count, 1);
    ck_assert(found.any);
    const tf_contact *contact = &found.contact->contact;
    ck_assert(contact->normal[0] == 0 && contact->normal[1] == 0 &&
              contact->normal[2] == 1);
    ck_assert_double_eq_tol(contact->barycentric[1][0], 0.5, 1e-15);
    ck_assert_double_eq_tol(contact->barycentric[1][1], 0.25, 1e-15);
    tf_buffer_free(&thickness.row);
    tf_surface_free(surface);
}
END_TEST

// What is near at the end -------------------------------------------------------

static const int corner[] = {0, 1, 2, 3};

/// A triangle and a point, or two edges.
static tf_mesh mesh_of(tf_kind kind)
{
    return kind == TF_EDGE_EDGE
               ? (tf_mesh){.axes = 3, .vertices = 4, .edges = 2, .edge = corner}
               : (tf_mesh){.axes = 3,
                           .vertices = 4,
                           .triangles = 1,
                           .triangle = corner};
}

/// The only near pair at the end of a step, in a buffer that was used before.
static tf_contact near_contact(tf_kind kind, const double end[12])
{
    double start[12];
    tf_mesh mesh = mesh_of(kind);
    tf_surface *surface = surface_of(&mesh);
    for (int i = 0; i < 12; i++)
        start[i] = end[i] == 0.5 ? 9 : end[i];
    tf_motion motion = {3, 4, start, end};
    tf_thickness thickness = {.length = 1};
    tf_contacts found = {0};
    size_t room = 4 * sizeof(tf_surface_contact);
    ck_assert(tf_buffer_reserve(&thickness.row, room, 1));
    memset(thickness.row.data, 0x55, room);
    ck_assert_int_eq(
        tf_near_contacts_find(&thickness, surface, &motion, NULL, &found, NULL),
        TF_OK);
    ck_assert_uint_eq(found.count, 1);
    ck_assert_int_eq(found.contact->kind, kind);
    tf_contact contact = found.contact->contact;
    tf_buffer_free(&thickness.row);
    tf_surface_free(surface);
    return contact;
}

/// Turns coordinates such that what was along the last axis is along another.
static void turn(const double from[12], int axis, double to[12])
{
    for (int i = 0; i < 12; i++)
        to[i / 3 * 3 + (i + axis + 1) % 3] = from[i];
}

// A point over a triangle, and an edge below another, which it crosses at other
// fractions of their lengths.
START_TEST(normals_may_have_any_axis)
{
    static const double over[] = {0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, 0.5},
                        below[] = {0, 0, 0, 4, 0, 0, 1, -1, 0.5, 1, 1, 0.5};
    for (int axis = 0; axis < 3; axis++) {
        double end[12];
        turn(over, axis, end);
        tf_contact contact = near_contact(TF_POINT_TRIANGLE, end);
        for (int k = 0; k < 3; k++)
            ck_assert(contact.normal[k] == (k == axis ? 1 : 0));
        turn(below, axis, end);
        contact = near_contact(TF_EDGE_EDGE, end);
        for (int k = 0; k < 3; k++)
            ck_assert(contact.normal[k] == (k == axis ? -1 : 0));
    }
}
END_TEST

START_TEST(a_row_has_nothing_of_those_before)
{
    static const double at[] = {0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, 0.5};
    tf_contact contact = near_contact(TF_POINT_TRIANGLE, at);
    for (int k = 0; k < 3; k++)
        ck_assert(contact.velocity[k] == 0);
    ck_assert(contact.normal_velocity == 0);
    ck_assert(contact.pivot[0] == 0 && contact.pivot[1] == 0);
}
END_TEST

enum {
    MANY = 1500
};

// Points that come near a triangle, so many that it takes a while to list them: the
// caller may cancel at each call.
START_TEST(a_list_can_be_cancelled)
{
    static double start[3 * MANY] = {0, 0, 0, 9, 0, 0, 0, 9, 0}, end[3 * MANY];
    for (int v = 3; v < MANY; v++)
        for (int k = 0; k < 3; k++)
            start[3 * v + k] = (double)v / MANY + (k == 2 ? 8 : 0);
    for (int i = 0; i < 3 * MANY; i++)
        end[i] = start[i] > 7 && i > 8 ? start[i] - 8 : start[i];
    tf_surface *surface = surface_of(&(tf_mesh){
        .axes = 3, .vertices = MANY, .triangles = 1, .triangle = corner});
    tf_motion motion = {3, MANY, start, end};
    tf_thickness thickness = {.length = 2};
    watched_call call;
    tf_contacts found = {0};
    long calls = 1;
    for (long last = 0; last <= calls; last += calls / cases(calls)) {
        surface->workers.watch = watched_begin(&call, last);
        ck_assert_int_eq(tf_near_contacts_find(&thickness, surface, &motion,
                                               NULL, &found, NULL),
                         last == 0 ? TF_OK : TF_CANCELLED);
        calls = last == 0 ? call.calls : calls;
    }
    ck_assert_uint_eq(found.count, MANY - 3);
    surface->workers.watch = NULL;
    tf_buffer_free(&thickness.row);
    tf_surface_free(surface);
}
END_TEST

START_TEST(what_fails_is_told)
{
    static const double at[] = {0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, 9},
                        end[] = {0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, NAN};
    tf_mesh mesh = mesh_of(TF_POINT_TRIANGLE);
    tf_surface *surface = surface_of(&mesh);
    tf_motion motion = {3, 4, at, end};
    tf_thickness thickness = {.length = 1};
    tf_contacts found = {.count = 42};
    ck_assert_int_eq(
        tf_near_contacts_find(&thickness, surface, &motion, NULL, &found, NULL),
        TF_NOT_FINITE);
    ck_assert_uint_eq(found.count, 42);
    tf_buffer_free(&thickness.row);
    tf_surface_free(surface);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("distance/near_contacts");
    TCase *tcase = tcase_create("near_contacts");
    tcase_add_loop_test(tcase, near_pairs_are_listed_as_contacts, 0,
                        proposal_tries());
    tcase_add_test(tcase, the_normal_goes_to_the_first_element);
    tcase_add_test(tcase, normals_may_have_any_axis);
    tcase_add_test(tcase, a_row_has_nothing_of_those_before);
    tcase_add_test(tcase, a_list_can_be_cancelled);
    tcase_add_test(tcase, what_fails_is_told);
    suite_add_tcase(suite, tcase);
    return suite;
}
