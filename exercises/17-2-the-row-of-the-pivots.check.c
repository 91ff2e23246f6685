#include "check.h"

#include "query/query.h"
#include "support/queries.h"
#include "support/rational.h"

#include <math.h>

typedef struct pivot_row {
    double coefficient[4], normal[3], gap;
} pivot_row;

pivot_row row_of_pivots(const tf_contact *contact, int first, int second);

/// The parting of the vertices of a query at the start (late = 0) or the end,
/// along the row's normal, times its coefficients.
static double distance(const query *q, const pivot_row *row, int late)
{
    double sum = 0;
    for (int i = 0; i < q->vertices + q->others; i++)
        for (int k = 0; k < q->axes; k++)
            sum += row->coefficient[i] * row->normal[k] *
                   q->vertex[i].at[late].x[k];
    return sum;
}

static double length(const double v[3])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
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
        "%s\nfirst element: %d vertices, pivots: %d and %d, normal %s, "
        "normal velocity %s, toi %s",
        text_lines(q->axes, "vertex", q->vertices + q->others, q->vertex),
        q->vertices, contact.pivot[0], contact.pivot[1],
        text_point(3, contact.normal), text_real(contact.normal_velocity),
        text_real(contact.toi_lo));
    check_picture(q->axes, q->vertices, q->vertex, q->others, query_others(q));
    pivot_row row;
    check_value(row, row_of_pivots(&contact, q->vertices, q->others));
    double part[2] = {0, 0};
    int used = 0;
    for (int i = 0; i < q->vertices + q->others; i++) {
        part[i >= q->vertices] += row.coefficient[i];
        used += row.coefficient[i] != 0;
    }
    check_near(1, part[0], 1e-12);
    check_near(-1, part[1], 1e-12);
    check_that(used == 2, "two coefficients that are not 0", "%d", used);
    check_near(1, length(row.normal), 1e-12);

    // They start at the gap, on the positive side, and end on the other side.
    double start = distance(q, &row, 0), end = distance(q, &row, 1);
    check_that(start > 0, "a normal to whose positive side the pivots start",
               "distance %s at the start", text_real(start));
    check_near(start, row.gap, 1e-9);
    check_that(end < 0, "pivots that end on the negative side",
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
