#include "kit/random.h"

#include "support/support.h"

#include <math.h>

enum {
    MANY = 100000,
    BINS = 64
};

START_TEST(bits_are_splitmix64s)
{
    // Those that its authors' program prints from these seeds.
    static const struct {
        uint64_t seed, bits[3];
    } row[] = {
        {0, {0xe220a8397b1dcdaf, 0x6e789e6aa1b965f4, 0x06c45d188009454f}},
        {1234567,
         {6457827717110365317, 3203168211198807973, 9817491932198370423u}}};
    for (int i = 0; i < 2; i++) {
        uint64_t state = row[i].seed;
        for (int k = 0; k < 3; k++)
            ck_assert_uint_eq(fig_random_bits(&state), row[i].bits[k]);
    }
}
END_TEST

START_TEST(congruences_are_knuths)
{
    // From 0 the increment, then the increment times 6364136223846793006,
    // divided with remainder by 2^64 by hand.
    uint64_t state = 0;
    ck_assert_uint_eq(fig_congruent_bits(&state), 1442695040888963407);
    ck_assert_uint_eq(fig_congruent_bits(&state), 0x1a08ee1184ba6d32);
}
END_TEST

/// Expect as many numbers in each of the bins as chance would have there, but
/// for five times the deviation.
static void expect_even(const int count[BINS])
{
    double mean = (double)MANY / BINS;
    for (int i = 0; i < BINS; i++)
        ck_assert_msg(fabs(count[i] - mean) < 5 * sqrt(mean),
                      "%d in bin %d, not about %g", count[i], i, mean);
}

static int bin_of(double x)
{
    ck_assert_msg(x >= 0 && x < 1, "%g is out of range", x);
    return (int)(BINS * x);
}

START_TEST(numbers_are_spread_evenly)
{
    int count[2][BINS] = {{0}};
    uint64_t state[2] = {1, 1};
    for (int i = 0; i < MANY; i++) {
        count[0][bin_of(fig_random_number(&state[0]))]++;
        count[1][fig_congruent_bits(&state[1]) >> 58]++;
    }
    expect_even(count[0]);
    expect_even(count[1]);
}
END_TEST

START_TEST(vertices_start_anywhere_and_move_either_way)
{
    static const double displacement = 0.25;
    for (int axes = 2; axes <= TF_AXES; axes++)
        for (int k = 0; k < axes; k++) {
            int start[BINS] = {0}, way[BINS] = {0};
            uint64_t state = 1;
            for (int i = 0; i < MANY / 4; i++) {
                tf_worldline vertex[4];
                fig_random_vertices(&state, axes, displacement, 4, vertex);
                for (int v = 0; v < 4; v++) {
                    double x = vertex[v].at[0].x[k];
                    double moved = (vertex[v].at[1].x[k] - x) / displacement;
                    start[bin_of(x)]++;
                    way[bin_of((moved + 1) / 2)]++;
                }
            }
            expect_even(start);
            expect_even(way);
        }
}
END_TEST

Suite *suite(void)
{
    Suite *made = suite_create("kit/random");
    TCase *tests = tcase_create("random");
    suite_add_tcase(made, tests);
    tcase_add_test(tests, bits_are_splitmix64s);
    tcase_add_test(tests, congruences_are_knuths);
    tcase_add_test(tests, numbers_are_spread_evenly);
    tcase_add_test(tests, vertices_start_anywhere_and_move_either_way);
    return made;
}
