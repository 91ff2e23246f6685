#include "figures/numbers.h"

#include "arithmetic/exact.h"
#include "intersect/complementary.h"
#include "kit/random.h"

enum {
    QUERIES = 1500,
    COORDINATE_BITS = 29
};

static void make_query(uint64_t *state, tf_worldline vertex[3])
{
    for (int i = 0; i < 3; i++) {
        double at[2][2];
        for (int k = 0; k < 4; k++)
            at[k / 2][k % 2] =
                (double)(fig_congruent_bits(state) >> (64 - COORDINATE_BITS));
        vertex[i] = tf_worldline_between(2, at[0], at[1]);
    }
}

/// The library's interval for the path of the first vertex and the triangle in
/// which the last moves; whether they meet.
static bool find_interval(const tf_worldline vertex[3],
                          tf_intersection *meeting)
{
    tf_simplex path[1], sweep[2];
    tf_sweep(1, vertex, path);
    tf_sweep(2, vertex + 1, sweep);
    tf_pair pair = tf_pair_of(&path[0], &sweep[0], 2);
    return tf_complementary_intersect(&tf_exact, &pair, TF_WITH_POINT,
                                      meeting) &&
           meeting->verdict == TF_HIT;
}

static void find_time(const tf_worldline vertex[3], mpq_t toi)
{
    const tf_worldline *p = &vertex[0], *a = &vertex[1], *b = &vertex[2];
    oracle_simplex path = {2, {&p->at[0], &p->at[1]}};
    oracle_simplex triangle = {3, {&a->at[0], &b->at[0], &b->at[1]}};
    ck_assert(oracle_simplices_meet(2, &path, &triangle, toi));
}

/// x minus the time, in units of 2^-53.
static double error_of(double x, const mpq_t toi)
{
    mpq_t difference;
    mpq_init(difference);
    mpq_set_d(difference, x);
    mpq_sub(difference, difference, toi);
    double error = ldexp(mpq_get_d(difference), 53);
    mpq_clear(difference);
    return error;
}

START_TEST(errors_are_those_from_the_true_time)
{
    uint64_t state = 2009;
    double widest = 0, slack = INFINITY, farthest = 0;
    mpq_t toi;
    mpq_init(toi);
    for (int found = 0; found < QUERIES;) {
        tf_worldline vertex[3];
        tf_intersection meeting;
        make_query(&state, vertex);
        if (!find_interval(vertex, &meeting) || meeting.toi_lo < 0x1p-6)
            continue;
        find_time(vertex, toi);
        double t = mpq_get_d(toi), margin = t * (6 - 3 * t);
        double low = error_of(meeting.toi_lo, toi);
        double high = error_of(meeting.toi_hi, toi);
        ck_assert_msg(low <= 0 && high >= 0, "%.17g is outside", t);
        widest = fmax(widest, high - low);
        slack = fmin(slack, fmin(-low, high) / margin);
        farthest = fmax(farthest, fmax(-low, high) / margin);
        found++;
    }
    mpq_clear(toi);
    char *text = printed(&fig_time_margins);
    expect_number(text, "queries", QUERIES);
    expect_number(text, "widest", widest);
    expect_number(text, "slack", slack);
    expect_number(text, "farthest", farthest);
    ck_assert_double_le(farthest, 2);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/time_margins",
                    errors_are_those_from_the_true_time);
}
