#include "check.h"

#include "query/query.h"
#include "support/oracle.h"
#include "support/rational.h"

typedef struct encounter {
    double point[2][2];
    double edge[2][2][2];
} encounter;

encounter contact_without_approach(void);

static void expect_velocity(const tf_contact *contact)
{
    check_that(contact->verdict == TF_HIT, "a contact", "none");
    check_that(contact->toi_lo > 0 && contact->toi_hi < 1,
               "0 < t < 1 when they meet first", "t = %s",
               text_real((contact->toi_lo + contact->toi_hi) / 2));
    check_that(contact->normal[0] != 0 || contact->normal[1] != 0,
               "a normal that is not zero", "%s",
               text_point(2, contact->normal));
    check_that(contact->velocity[0] != 0 || contact->velocity[1] != 0,
               "a relative velocity that is not zero", "%s",
               text_point(2, contact->velocity));
}

/// Adds or subtracts a number, exactly.
static void add(mpq_t sum, int sign, double number, mpq_t room)
{
    mpq_set_d(room, sign * number);
    mpq_add(sum, sum, room);
}

/// The sign of the normal velocity, up to its direction: that of the determinant
/// of the relative velocity and of the edge that the contact's triangle shares
/// with the start or the end.  (What the library reports is rounded, and may miss
/// a zero by an ulp.)
static int sign_of_approach(const tf_contact *contact,
                            const tf_worldline *point,
                            const tf_worldline edge[2])
{
    int pivot = contact->pivot[1], t = pivot == 1 ? 0 : 1;
    mpq_t velocity[2], direction[2], number;
    mpq_init(number);
    for (int k = 0; k < 2; k++) {
        mpq_inits(velocity[k], direction[k], NULL);
        add(velocity[k], 1, point->at[1].x[k], number);
        add(velocity[k], -1, point->at[0].x[k], number);
        add(velocity[k], -1, edge[pivot].at[1].x[k], number);
        add(velocity[k], 1, edge[pivot].at[0].x[k], number);
        add(direction[k], 1, edge[1].at[t].x[k], number);
        add(direction[k], -1, edge[0].at[t].x[k], number);
    }
    mpq_mul(velocity[0], velocity[0], direction[1]);
    mpq_mul(velocity[1], velocity[1], direction[0]);
    int sign = mpq_cmp(velocity[0], velocity[1]);
    for (int k = 0; k < 2; k++)
        mpq_clears(velocity[k], direction[k], NULL);
    mpq_clear(number);
    return sign;
}

/// The determinant of the directions of the edge at both times.
static double turn(const tf_worldline edge[2])
{
    double d[2][2];
    for (int t = 0; t < 2; t++)
        for (int k = 0; k < 2; k++)
            d[t][k] = edge[1].at[t].x[k] - edge[0].at[t].x[k];
    return d[0][0] * d[1][1] - d[0][1] * d[1][0];
}

TEST(meets_and_does_not_approach)
{
    check_input("none: the function gives an encounter");
    encounter e;
    check_value(e, contact_without_approach());
    tf_worldline point = tf_worldline_between(2, e.point[0], e.point[1]);
    tf_worldline edge[2];
    for (int v = 0; v < 2; v++)
        edge[v] = tf_worldline_between(2, e.edge[v][0], e.edge[v][1]);
    check_input("point: %s\n%s", text_line(2, &point),
                text_lines(2, "vertex", 2, edge));
    check_picture(2, 1, &point, 2, edge);
    check_finite(2, 1, &point);
    check_finite(2, 2, edge);
    check_that(turn(edge) != 0, "an edge that turns", "one that does not");
    tf_contact contact;
    tf_query(&oracle_arithmetic, 2, 1, &point, 2, edge, &contact);
    expect_velocity(&contact);
    check_that(sign_of_approach(&contact, &point, edge) == 0,
               "a normal velocity that is exactly zero",
               "%s, from the normal %s and the relative velocity %s",
               text_real(contact.normal_velocity),
               text_point(2, contact.normal), text_point(2, contact.velocity));
    mpq_t toi;
    mpq_init(toi);
    check_that(oracle_meet(2, 1, &point, 2, edge, toi), "a contact", "none");
    mpq_clear(toi);
}

void run_tests(void)
{
    check_run(1, meets_and_does_not_approach);
}
