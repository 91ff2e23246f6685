// Near pairs in the list of contacts.
#include "distance/near_contacts.h"

#include "support/near_oracle.h"
#include "support/proposals.h"
#include "support/support.h"
#include "support/surface_of.h"

#include <math.h>

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
    generator random = generator_new((uint64_t)_i);
    proposal_make(&random, (proposal_shape)(_i / PROPOSAL_WAYS), 2,
                  (proposal_way)(_i % PROPOSAL_WAYS), &made);
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
    const tf_contact *contact = &found.contact->contact;
    ck_assert(contact->normal[0] == 0 && contact->normal[1] == 0 &&
              contact->normal[2] == 1);
    ck_assert_double_eq_tol(contact->barycentric[1][0], 0.5, 1e-15);
    ck_assert_double_eq_tol(contact->barycentric[1][1], 0.25, 1e-15);
    tf_buffer_free(&thickness.row);
    tf_surface_free(surface);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("distance/near_contacts");
    TCase *tcase = tcase_create("near_contacts");
    tcase_add_loop_test(tcase, near_pairs_are_listed_as_contacts, 0,
                        PROPOSAL_SHAPES * PROPOSAL_WAYS);
    tcase_add_test(tcase, the_normal_goes_to_the_first_element);
    suite_add_tcase(suite, tcase);
    return suite;
}
