#include "support/linear_methods.h"

#include "linear/additive.h"
#include "linear/cubic.h"
#include "linear/quadratic.h"
#include "support/linear_truth.h"
#include "support/scenes.h"

#include <math.h>
#include <string.h>

tf_status cubic_query(query_kind kind, const tf_tolerances *tolerances,
                      const tf_motion *motion, const int vertex[],
                      tf_contact *contact)
{
    if (kind == POINT_EDGE)
        return tf_quadratic_point_edge(tolerances, motion, vertex[0],
                                       vertex + 1, contact);
    if (kind == POINT_TRIANGLE)
        return tf_cubic_point_triangle(tolerances, motion, vertex[0],
                                       vertex + 1, contact);
    return tf_cubic_edge_edge(tolerances, motion, vertex, vertex + 2, contact);
}

tf_status additive_query(query_kind kind, const tf_advance_limits *limits,
                         const tf_motion *motion, const int vertex[],
                         tf_contact *contact, tf_advancement *advancement)
{
    if (kind == POINT_EDGE)
        return tf_additive_point_edge(limits, motion, vertex[0], vertex + 1,
                                      contact, advancement);
    if (kind == POINT_TRIANGLE)
        return tf_additive_point_triangle(limits, motion, vertex[0], vertex + 1,
                                          contact, advancement);
    return tf_additive_edge_edge(limits, motion, vertex, vertex + 2, contact,
                                 advancement);
}

static const int in_order[QUERY_VERTICES] = {0, 1, 2, 3};

static query_kind kind_of(const query *q)
{
    return q->axes == 2       ? POINT_EDGE
           : q->vertices == 1 ? POINT_TRIANGLE
                              : EDGE_EDGE;
}

tf_contact cubic_answer(const query *q, double tolerance)
{
    scene s = scene_of(q, in_order);
    tf_motion motion = scene_motion(&s);
    tf_tolerances tolerances = {.distance = tolerance};
    tf_contact contact;
    ck_assert_int_eq(
        cubic_query(kind_of(q), &tolerances, &motion, in_order, &contact),
        TF_OK);
    return contact;
}

tf_contact additive_answer(const query *q, const tf_advance_limits *limits,
                           tf_advancement *advancement)
{
    scene s = scene_of(q, in_order);
    tf_motion motion = scene_motion(&s);
    tf_contact contact;
    ck_assert_int_eq(additive_query(kind_of(q), limits, &motion, in_order,
                                    &contact, advancement),
                     TF_OK);
    return contact;
}

bool linear_query_truth(const query *q, double *toi)
{
    scene s = scene_of(q, in_order);
    return linear_truth(q->axes, q->vertices, s.start, s.end, toi);
}

static bool sums_to_one(int vertices, const double barycentric[3])
{
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        bool used = i < vertices;
        if (!(used ? barycentric[i] >= 0 : barycentric[i] == 0))
            return false;
        sum += barycentric[i];
    }
    return fabs(sum - 1) < 1e-12;
}

void expect_contact(const query *q, const tf_contact *contact)
{
    static const tf_contact apart = {.verdict = TF_APART};
    if (contact->verdict == TF_APART) {
        ck_assert_msg(memcmp(contact, &apart, sizeof apart) == 0,
                      "apart, but described:\n%s", query_text(q));
        return;
    }
    double length2 = 0;
    for (int k = 0; k < 3; k++) {
        length2 += contact->normal[k] * contact->normal[k];
        ck_assert_msg(isfinite(contact->velocity[k]), "velocity:\n%s",
                      query_text(q));
    }
    ck_assert_msg(contact->toi_lo >= 0 && contact->toi_lo <= 1 &&
                      contact->toi_lo == contact->toi_hi,
                  "time %a:\n%s", contact->toi_lo, query_text(q));
    ck_assert_msg(length2 == 0 || fabs(length2 - 1) < 1e-12, "normal:\n%s",
                  query_text(q));
    ck_assert_msg(isfinite(contact->normal_velocity), "normal velocity:\n%s",
                  query_text(q));
    ck_assert_msg(sums_to_one(q->vertices, contact->barycentric[0]) &&
                      sums_to_one(q->others, contact->barycentric[1]),
                  "barycentric coordinates:\n%s", query_text(q));
}

void expect_linear_truth(const query *q)
{
    double toi = 0;
    bool hit = linear_query_truth(q, &toi);
    tf_contact contact = cubic_answer(q, 0);
    expect_contact(q, &contact);
    ck_assert_msg((contact.verdict == TF_HIT) == hit, "verdict %d:\n%s",
                  contact.verdict, query_text(q));
    ck_assert_msg(!hit || fabs(contact.toi_lo - toi) < 1e-7,
                  "time %.17g, not %.17g:\n%s", contact.toi_lo, toi,
                  query_text(q));
}
