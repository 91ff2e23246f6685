// Coordinates from 4.9e-324 to 1.7e308 mixed in one query: degenerate, nearly
// so, and any.  The verdict and the interval of the time are judged; of the
// other fields, that all are finite, whatever overflows on the way to them.
#include "arithmetic/clamped.h"
#include "arithmetic/exact.h"
#include "arithmetic/functions.h"
#include "arithmetic/perturbed.h"
#include "arithmetic/published.h"
#include "support/judge.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

typedef query maker(generator *random, query_kind kind);

/// A coordinate of the query becomes x or -x.
static void plant(generator *random, query *q, double x)
{
    *query_coordinate(q, below(random, query_size(q))) =
        below(random, 2) ? x : -x;
}

/// Whether the least and the largest of doubles are both there.
static bool is_mixed(query *q)
{
    bool least = false, largest = false;
    for (int i = 0; i < query_size(q); i++) {
        double size = fabs(*query_coordinate(q, i));
        least = least || size == DBL_TRUE_MIN;
        largest = largest || size == DBL_MAX;
    }
    return least && largest;
}

/// Make queries until one is mixed.
static query mixed(maker *make, generator *random, query_kind kind)
{
    query q;
    do
        q = make(random, kind);
    while (!is_mixed(&q));
    return q;
}

/// Judge queries of each kind by the oracle.  At least one in `every` must be a
/// hit and one a miss: else little has been tried.
static void judge_all(maker *make, uint64_t stream, int every)
{
    generator random = generator_new(stream);
    truth known;
    truth_init(&known);
    for (int kind = 0; kind < KINDS; kind++) {
        long count = cases(3000), hits = 0;
        for (long i = 0; i < count; i++) {
            query q = mixed(make, &random, (query_kind)kind);
            truth_find(&q, &known);
            expect_truth(&q, &known);
            hits += known.hit;
        }
        if (count >= 1000)
            ck_assert_msg(hits * every >= count &&
                              (count - hits) * every >= count,
                          "kind %d: %ld hits of %ld", kind, hits, count);
    }
    truth_clear(&known);
}

// Degenerate ------------------------------------------------------------------

/// Coordinates from -1, 0 and 1, each axis with a unit of its own: the least
/// double, the largest and one between.
static query lattice(generator *random, query_kind kind)
{
    query q = query_lattice(random, kind, 3);
    double unit[] = {DBL_TRUE_MIN, DBL_MAX,
                     ldexp(1, below(random, 2000) - 1000)};
    int first = below(random, 3);
    for (int i = 0; i < query_size(&q); i++)
        *query_coordinate(&q, i) =
            (*query_coordinate(&q, i) - 1) * unit[(i % q.axes + first) % 3];
    return q;
}

/// On each axis three places only, of any magnitudes.
static query three_places(generator *random, query_kind kind)
{
    static const double size[] = {0, DBL_TRUE_MIN, 0x1p-600,
                                  1, 0x1.8p971,    DBL_MAX};
    query q = query_lattice(random, kind, 3);
    double place[TF_AXES][3];
    for (int i = 0; i < TF_AXES * 3; i++) {
        double x = size[below(random, 6)];
        place[i / 3][i % 3] = below(random, 2) ? x : -x;
    }
    for (int i = 0; i < query_size(&q); i++) {
        double *x = query_coordinate(&q, i);
        *x = place[i % q.axes][(int)*x];
    }
    return q;
}

/// On a line or a plane that rises by the least double over the largest, or in
/// the reverse direction; the third axis is free.
static query steep(generator *random, query_kind kind)
{
    query q = query_new(kind);
    int turn = below(random, 2);
    for (int i = 0; i < query_size(&q); i += q.axes) {
        int along = below(random, 3) - 1;
        *query_coordinate(&q, i + turn) = along * DBL_MAX;
        *query_coordinate(&q, i + 1 - turn) = along * DBL_TRUE_MIN;
        if (q.axes == 3)
            *query_coordinate(&q, i + 2) = below(random, 4) * 0x1p-300;
    }
    return q;
}

START_TEST(lattices_of_extreme_units_are_answered_right)
{
    judge_all(lattice, 1, 10);
}
END_TEST

START_TEST(three_coordinates_on_each_axis_are_answered_right)
{
    judge_all(three_places, 2, 10);
}
END_TEST

START_TEST(steep_lines_and_planes_are_answered_right)
{
    judge_all(steep, 3, 20);
}
END_TEST

// Nearly degenerate -----------------------------------------------------------

/// One of the above, of which each coordinate is moved to a neighbour or stays.
static query beside(generator *random, query_kind kind)
{
    static maker *const degenerate[] = {lattice, three_places, steep};
    query q = degenerate[below(random, 3)](random, kind);
    query_nudge(random, &q, 1);
    return q;
}

/// Contacts that are left of ordinary ones when all places but the last few of
/// a double are gone, beside one coordinate that is huge.
static query tiny_contacts(generator *random, query_kind kind)
{
    query q = query_any(random, kind);
    for (int axis = 0; axis < q.axes; axis++)
        query_scale(&q, axis, below(random, 8) - 1074);
    plant(random, &q, DBL_MAX);
    return q;
}

/// Contacts of huge elements, of which one coordinate has become tiny.
static query huge_contacts(generator *random, query_kind kind)
{
    query q = query_any(random, kind);
    for (int axis = 0; axis < q.axes; axis++)
        query_scale(&q, axis, 1020 + below(random, 2));
    plant(random, &q, DBL_MAX);
    plant(random, &q, DBL_TRUE_MIN);
    return q;
}

START_TEST(nearly_degenerate_queries_are_answered_right)
{
    judge_all(beside, 4, 10);
}
END_TEST

START_TEST(tiny_contacts_beside_a_huge_coordinate_are_found)
{
    judge_all(tiny_contacts, 5, 10);
}
END_TEST

START_TEST(huge_contacts_beside_a_tiny_coordinate_are_found)
{
    judge_all(huge_contacts, 6, 10);
}
END_TEST

// Any -------------------------------------------------------------------------

static query extreme(generator *random, query_kind kind)
{
    query q = query_extreme(random, kind);
    plant(random, &q, DBL_TRUE_MIN);
    plant(random, &q, DBL_MAX);
    return q;
}

START_TEST(queries_of_any_magnitudes_are_answered_right)
{
    judge_all(extreme, 7, 10);
}
END_TEST

// Every field -----------------------------------------------------------------

/// Coordinates of about one magnitude, mostly one whose squares, cubes or sums
/// are near the largest double, and some of any.
static query near_overflow(generator *random, query_kind kind)
{
    static const int limit[] = {340, 511, 1022};
    int exponent = below(random, 4) ? limit[below(random, 3)] + below(random, 3)
                                    : below(random, 2098) - 1074;
    query q = below(random, 2) ? query_lattice(random, kind, 3)
                               : query_soup(random, kind);
    for (int i = 0; i < query_size(&q); i++) {
        double *x = query_coordinate(&q, i);
        *x = fmax(-DBL_MAX, fmin(ldexp(*x, exponent), DBL_MAX));
    }
    while (below(random, 2))
        plant(random, &q, ldexp(1, below(random, 2098) - 1074));
    return q;
}

static bool all_finite(int count, const double x[])
{
    for (int i = 0; i < count; i++)
        if (!isfinite(x[i]))
            return false;
    return true;
}

static double sum(const double x[3])
{
    return x[0] + x[1] + x[2];
}

static const char *field_fault(const tf_contact *contact)
{
    const double *n = contact->normal;
    double square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    if (!(contact->toi_lo >= 0 && contact->toi_lo <= contact->toi_hi &&
          contact->toi_hi <= 1))
        return "the time is no interval within 0 to 1";
    for (int i = 0; i < 2 && contact->verdict != TF_APART; i++)
        if (!(fabs(sum(contact->barycentric[i]) - 1) <= 1e-15))
            return "the barycentric coordinates do not sum to 1";
    if (square != 0 && !(fabs(square - 1) <= 1e-15))
        return "the normal is neither zero nor of length 1";
    if (!all_finite(3, contact->velocity))
        return "the velocity is not finite";
    return isfinite(contact->normal_velocity)
               ? NULL
               : "the normal velocity is not finite";
}

/// Judge the fields of a query's contact.  Whether there is a contact with a
/// normal.
static bool has_good_fields(const tf_arithmetic *arithmetic, const query *q)
{
    char text[200];
    tf_contact contact = ask(arithmetic, q);
    const char *fault = field_fault(&contact);
    snprintf(text, sizeof text, "%s: %s", arithmetic->name, fault ? fault : "");
    expect_no_fault(fault ? text : NULL, q);
    const double *n = contact.normal;
    return n[0] != 0 || n[1] != 0 || n[2] != 0;
}

static const tf_arithmetic *const arithmetics[] = {
    &tf_exact, &tf_clamped, &tf_published, &tf_perturbed};
enum {
    ARITHMETICS = sizeof arithmetics / sizeof *arithmetics
};

START_TEST(every_member_of_a_contact_is_finite)
{
    generator random = generator_new((uint64_t)(20 + _i));
    const tf_arithmetic *arithmetic = arithmetics[_i / KINDS];
    long normals = 0, count = cases(50000);
    for (long i = 0; i < count; i++) {
        query_kind kind = (query_kind)(_i % KINDS);
        query q = below(&random, 2) ? near_overflow(&random, kind)
                                    : query_extreme(&random, kind);
        query_number(&q);
        normals += has_good_fields(arithmetic, &q);
    }
    if (count >= 1000)
        ck_assert_msg(normals > count / 20, "%ld normals of %ld", normals,
                      count);
}
END_TEST

Suite *suite(void)
{
    Suite *magnitudes = suite_create("magnitudes");
    TCase *degenerate = tcase_create("degenerate");
    tcase_add_test(degenerate, lattices_of_extreme_units_are_answered_right);
    tcase_add_test(degenerate,
                   three_coordinates_on_each_axis_are_answered_right);
    tcase_add_test(degenerate, steep_lines_and_planes_are_answered_right);
    suite_add_tcase(magnitudes, degenerate);
    TCase *nearly = tcase_create("nearly degenerate");
    tcase_add_test(nearly, nearly_degenerate_queries_are_answered_right);
    tcase_add_test(nearly, tiny_contacts_beside_a_huge_coordinate_are_found);
    tcase_add_test(nearly, huge_contacts_beside_a_tiny_coordinate_are_found);
    suite_add_tcase(magnitudes, nearly);
    TCase *any = tcase_create("any");
    tcase_add_test(any, queries_of_any_magnitudes_are_answered_right);
    tcase_add_loop_test(any, every_member_of_a_contact_is_finite, 0,
                        ARITHMETICS * KINDS);
    suite_add_tcase(magnitudes, any);
    return magnitudes;
}
