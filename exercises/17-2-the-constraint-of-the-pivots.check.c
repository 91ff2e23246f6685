#include "check.h"

#include "query/query.h"
#include "support/queries.h"
#include "support/rational.h"

#include <math.h>
#include <stdio.h>

typedef struct pivot_constraint {
    double coefficient[4], normal[3], gap;
} pivot_constraint;

pivot_constraint constraint_of_pivots(const tf_contact *contact, int first,
                                      int second);

/// The gap change of the vertices of a query at the start (late = 0) or the
/// end, along the constraint's normal, times its coefficients.
static double distance(const query *q, const pivot_constraint *constraint,
                       int late)
{
    double sum = 0;
    for (int i = 0; i < q->vertices + q->others; i++)
        for (int k = 0; k < q->axes; k++)
            sum += constraint->coefficient[i] * constraint->normal[k] *
                   q->vertex[i].at[late].x[k];
    return sum;
}

static double length(const double v[3])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/// That only the pivots have coefficients, 1 and -1.
static void check_coefficients(const query *q, const tf_contact *contact,
                               const pivot_constraint *constraint)
{
    for (int i = 0; i < q->vertices + q->others; i++) {
        double expected = i == contact->pivot[0]                 ? 1
                          : i == q->vertices + contact->pivot[1] ? -1
                                                                 : 0;
        char text[60];
        snprintf(text, sizeof text, "coefficient %g at vertex %d", expected, i);
        check_that(constraint->coefficient[i] == expected, text, "%s",
                   text_real(constraint->coefficient[i]));
    }
}

static void try_query(query *q)
{
    tf_contact contact;
    query_number(q);
    tf_query(&oracle_arithmetic, q->axes, q->vertices, q->vertex, q->others,
             query_others(q), &contact);
    if (contact.verdict != TF_HIT || contact.classification != TF_GENERIC)
        return;
    check_input(
        "%s\nvertices of the first element: %d\npivots: place %d of the first "
        "element, place %d of the second\nnormal %s, normal velocity %s, toi "
        "%s",
        text_lines(q->axes, "vertex", q->vertices + q->others, q->vertex),
        q->vertices, contact.pivot[0], contact.pivot[1],
        text_point(3, contact.normal), text_real(contact.normal_velocity),
        text_real(contact.toi_lo));
    check_picture(q->axes, q->vertices, q->vertex, q->others, query_others(q));
    pivot_constraint constraint;
    check_value(constraint,
                constraint_of_pivots(&contact, q->vertices, q->others));
    check_coefficients(q, &contact, &constraint);
    check_that(fabs(length(constraint.normal) - 1) <= 1e-12,
               "a normal of length 1", "length %s",
               text_real(length(constraint.normal)));

    // They start at the gap, on the positive side, and end on the other side.
    double start = distance(q, &constraint, 0),
           end = distance(q, &constraint, 1);
    check_that(start > 0,
               "the first pivot to start on the positive side of the second",
               "distance %s at the start", text_real(start));
    check_that(fabs(start - constraint.gap) <= 1e-9,
               "the distance along the normal at the start as the gap",
               "gap %s, while that distance is %s", text_real(constraint.gap),
               text_real(start));
    check_that(end < 0, "the first pivot to end on the negative side",
               "distance %s at the end", text_real(end));
}

TEST(pivots_start_apart_and_pass)
{
    generator random = generator_new(0);
    for (int i = 0; i < 600; i++) {
        query q = query_soup(&random, (query_kind)(i % KINDS));
        try_query(&q);
    }
}

void run_tests(void)
{
    check_run(1, pivots_start_apart_and_pass);
}
