// Near pairs in the list of contacts.
#include "distance/near_contacts.h"

#include "fast/detect.h"
#include "support/near_oracle.h"
#include "support/proposals.h"
#include "support/support.h"
#include "support/surface_of.h"

#include <math.h>
#include <string.h>

static proposal made;

static int compare(const tf_surface_contact *contact, int kind,
                   const int vertex[4])
{
    if ((int)contact->kind != kind)
        return (int)contact->kind - kind;
    for (int i = 0; i < 4; i++)
        if (contact->vertex[i] != vertex[i])
            return contact->vertex[i] - vertex[i];
    return 0;
}

static void expect_sorted(const tf_contacts *contacts)
{
    for (size_t i = 1; i < contacts->count; i++) {
        const tf_surface_contact *own = &contacts->contact[i];
        ck_assert_int_lt(compare(own - 1, (int)own->kind, own->vertex), 0);
    }
}

/// Whether a list has a pair, with the verdict that is given.
static bool has_pair(const tf_contacts *contacts, const near_oracle_pair *pair,
                     tf_verdict verdict)
{
    for (size_t i = 0; i < contacts->count; i++)
        if (compare(&contacts->contact[i], pair->kind, pair->vertex) == 0 &&
            contacts->contact[i].contact.verdict == verdict)
            return true;
    return false;
}

static void expect_near_row(const tf_contact *contact)
{
    const double *n = contact->normal;
    double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    ck_assert(fabs(length - 1) < 1e-12 || length == 0);
    ck_assert(contact->toi_lo == 1 && contact->toi_hi == 1);
    ck_assert(contact->normal_velocity == 0);
    for (int i = 0; i < 2; i++) {
        const double *b = contact->barycentric[i];
        ck_assert_double_eq_tol(b[0] + b[1] + b[2], 1, 1e-12);
    }
}

START_TEST(near_pairs_follow_in_the_order_of_contacts)
{
    generator random = generator_new((uint64_t)_i);
    proposal_make(&random, (proposal_shape)(_i / PROPOSAL_WAYS), 2,
                  (proposal_way)(_i % PROPOSAL_WAYS), &made);
    tf_surface *surface = surface_of(&made.mesh);
    tf_motion motion = {made.mesh.axes, made.mesh.vertices, made.start,
                        made.end};
    double length = made.unit * uniform(&random, 0.05, 0.5);
    tf_thickness thickness = {.length = length};
    tf_contacts found;
    ck_assert_int_eq(tf_surface_detect(surface, &motion, NULL, &found, NULL),
                     TF_OK);
    size_t contacts = found.count, near, pairs, at_start;
    ck_assert_int_eq(tf_near_contacts_add(&thickness, surface, &motion, NULL,
                                          &found, NULL),
                     TF_OK);
    ck_assert_uint_eq(found.count, contacts + thickness.near);
    ck_assert(found.any == (found.count > 0));
    expect_sorted(&found);
    for (size_t i = near = 0; i < found.count; i++)
        if (found.contact[i].contact.verdict == TF_APART) {
            near++;
            expect_near_row(&found.contact[i].contact);
        }
    ck_assert_uint_eq(near, thickness.near);
    const near_oracle_pair *pair =
        near_oracle(surface, made.end, made.start, length, &pairs);
    for (size_t i = near = 0; i < pairs; i++) {
        near += has_pair(&found, &pair[i], TF_APART);
        ck_assert(has_pair(&found, &pair[i], TF_APART) !=
                  has_pair(&found, &pair[i], TF_HIT));
    }
    ck_assert_uint_eq(near, thickness.near);
    ck_assert_int_eq(tf_near_contacts_count_start(&thickness, surface, &motion,
                                                  NULL, &at_start, NULL),
                     TF_OK);
    near_oracle(surface, made.start, NULL, length, &pairs);
    ck_assert_uint_eq(at_start, pairs);
    tf_thickness_free(&thickness);
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
    ck_assert_int_eq(tf_near_contacts_add(&thickness, surface, &motion, NULL,
                                          &found, NULL),
                     TF_OK);
    ck_assert_uint_eq(found.count, 1);
    const tf_contact *contact = &found.contact->contact;
    ck_assert(contact->normal[0] == 0 && contact->normal[1] == 0 &&
              contact->normal[2] == 1);
    ck_assert_double_eq_tol(contact->barycentric[1][0], 0.5, 1e-15);
    ck_assert_double_eq_tol(contact->barycentric[1][1], 0.25, 1e-15);
    ck_assert_uint_gt(tf_thickness_memory(&thickness), 0);
    tf_thickness_free(&thickness);
    tf_surface_free(surface);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("distance/near_contacts");
    TCase *tcase = tcase_create("near_contacts");
    tcase_add_loop_test(tcase, near_pairs_follow_in_the_order_of_contacts, 0,
                        PROPOSAL_SHAPES * PROPOSAL_WAYS);
    tcase_add_test(tcase, the_normal_goes_to_the_first_element);
    suite_add_tcase(suite, tcase);
    return suite;
}
