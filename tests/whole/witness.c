// A collision that is missed when a sign that is not known counts as zero.
#include "arithmetic/clamped.h"
#include "arithmetic/exact.h"
#include "arithmetic/published.h"
#include "intersect/cascade.h"
#include "support/judge.h"

/// The tetrahedron: A, B and C at t = 0 and D at t = 1.
static const double corner[4][TF_AXES] = {
    {0x1.39adc5cd900e1p-2, -0x1.5fd7e4fab497p-4, -0x1.382988f3c19d2p-2},
    {-0x1.72b9bad814c5fp-2, 0x1.08b61d7e26e86p-4, 0x1.5c960fdb4427ap-2},
    {-0x1.7426e4871b6b3p-2, 0x1.a16e455e5683p-4, 0x1.725a4884d51d7p-2},
    {0x1.31d6b0a9f41e9p-2, -0x1.b4c2778e24ec8p-5, -0x1.1f9303fc4c4acp-2},
};

/// What the origin at rest and the tetrahedron do.
static tf_intersection meet_witness(const tf_arithmetic *arithmetic)
{
    tf_event event[6] = {{.t = 0}, {.t = 1}};
    tf_simplex point = {.count = 2, .pivot = 0, .event = {event, event + 1}};
    tf_simplex solid = {.count = 4, .pivot = 2};
    for (int i = 0; i < 4; i++) {
        event[2 + i].t = i == 3;
        for (int k = 0; k < TF_AXES; k++)
            event[2 + i].x[k] = corner[i][k];
        solid.event[i] = &event[2 + i];
    }
    tf_pair pair = tf_pair_of(&point, &solid, 3);
    return tf_intersect(arithmetic, &pair, TF_WITH_POINT);
}

START_TEST(exact_signs_find_the_contact)
{
    tf_intersection found = meet_witness(&tf_exact);
    ck_assert_int_eq(found.verdict, TF_HIT);
    ck_assert_int_eq(found.classification, TF_GENERIC);
}
END_TEST

START_TEST(the_published_rule_misses_the_contact)
{
    ck_assert_int_eq(meet_witness(&tf_published).verdict, TF_APART);
}
END_TEST

START_TEST(clamped_signs_leave_the_contact_undecided)
{
    ck_assert_int_eq(meet_witness(&tf_clamped).verdict, TF_UNDECIDED);
}
END_TEST

/// A step of a triangle that sweeps the tetrahedron first: C goes to D, and A
/// and B stay.  The two other tetrahedra are flat.
static query whole_step(void)
{
    query q = query_new(POINT_TRIANGLE);
    tf_worldline *vertex = query_others(&q);
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < TF_AXES; k++) {
            vertex[i].at[0].x[k] = corner[i][k];
            vertex[i].at[1].x[k] = corner[i == 2 ? 3 : i][k];
        }
    return q;
}

START_TEST(the_published_rule_misses_the_whole_query)
{
    query q = whole_step();
    truth known;
    truth_init(&known);
    truth_find(&q, &known);
    ck_assert(known.hit);
    expect_truth(&q, &known);

    tf_contact contact;
    tf_query(&tf_published, 3, 1, q.vertex, 3, query_others(&q), &contact);
    ck_assert_int_eq(contact.verdict, TF_APART);
    truth_clear(&known);
}
END_TEST

Suite *suite(void)
{
    Suite *witness = suite_create("witness");
    TCase *rules = tcase_create("rules");
    tcase_add_test(rules, exact_signs_find_the_contact);
    tcase_add_test(rules, the_published_rule_misses_the_contact);
    tcase_add_test(rules, clamped_signs_leave_the_contact_undecided);
    tcase_add_test(rules, the_published_rule_misses_the_whole_query);
    suite_add_tcase(witness, rules);
    return witness;
}
