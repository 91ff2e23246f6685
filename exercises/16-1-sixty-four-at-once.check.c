#include "check.h"

#include "arithmetic/exact.h"
#include "arithmetic/functions.h"
#include "support/support.h"

#include <math.h>
#include <stdint.h>

enum {
    LANES = 64
};

void sides(const double at[3][2][64], uint64_t *left, uint64_t *right);

static tf_event event_of(const double at[3][2][LANES], int v, int i)
{
    return (tf_event){.x = {at[v][0][i], at[v][1][i]}};
}

/// The exact sign of a lane.
static tf_sign sign_of(const double at[3][2][LANES], int i)
{
    tf_event p = event_of(at, 0, i), q = event_of(at, 1, i),
             r = event_of(at, 2, i);
    tf_differences d = {
        .n = 2, .to = {&q, &r}, .from = {&p, &p}, .axis = {0, 1}};
    return tf_exact.sign(&d);
}

/// Whether the determinant is so large that it must be decided.
static bool is_large(const double at[3][2][LANES], int i)
{
    double d[2][2], most[2];
    for (int k = 0; k < 2; k++) {
        for (int v = 0; v < 2; v++)
            d[v][k] = at[v + 1][k][i] - at[0][k][i];
        most[k] = fmax(fabs(d[0][k]), fabs(d[1][k]));
    }
    return fabs(d[0][0] * d[1][1] - d[0][1] * d[1][0]) >
           17 * 0x1p-53 * most[0] * most[1];
}

static void expect(const double at[3][2][LANES])
{
    uint64_t left = 0, right = 0;
    check_input("64 lanes, the first with p = (%s, %s)", text_real(at[0][0][0]),
                text_real(at[0][1][0]));
    check_call(left, sides(at, &left, &right));
    check_also(right);
    for (int i = 0; i < LANES; i++) {
        tf_sign sign = sign_of(at, i);
        int got = (int)(left >> i & 1) - (int)(right >> i & 1);
        bool both = left >> i & right >> i & 1;
        if (!both && got == (got != 0 || is_large(at, i) ? (int)sign : 0))
            continue;
        double p[2] = {at[0][0][i], at[0][1][i]};
        double q[2] = {at[1][0][i], at[1][1][i]};
        double r[2] = {at[2][0][i], at[2][1][i]};
        check_input("lane %d: p = %s, q = %s, r = %s", i, text_point(2, p),
                    text_point(2, q), text_point(2, r));
        check_that(!both, "one bit at most", "both bits");
        check_that(got == (int)sign, text_sign(sign), "%s",
                   got > 0   ? "left"
                   : got < 0 ? "right"
                             : "no bit, of a large determinant");
    }
}

TEST(far_from_the_line)
{
    generator random = generator_new(1);
    double at[3][2][LANES];
    for (int n = 0; n < 10; n++) {
        for (int i = 0; i < 6 * LANES; i++)
            at[i / (2 * LANES)][i / LANES % 2][i % LANES] =
                uniform(&random, -1, 1);
        expect(at);
    }
}

/// The square of the chapter on signs, some rows of it.
TEST(near_the_line)
{
    double at[3][2][LANES];
    for (int row = 0; row < 256; row += 8) {
        for (int i = 0; i < LANES; i++)
            for (int k = 0; k < 2; k++) {
                at[0][k][i] = 0.5 + 0x1p-53 * (k == 0 ? i + row % 32 * 8 : row);
                at[1][k][i] = 12;
                at[2][k][i] = 24;
            }
        expect(at);
    }
}

/// Two points that are close to each other and far from the third, on a line
/// with it but for the last bits: errors are as large as they get.
TEST(near_each_other)
{
    generator random = generator_new(3);
    double at[3][2][LANES];
    for (int n = 0; n < 40; n++) {
        for (int i = 0; i < LANES; i++) {
            double far = uniform(&random, 8, 16), step = uniform(&random, 0, 1);
            for (int k = 0; k < 2; k++) {
                at[0][k][i] = 0.5 + 0x1p-53 * below(&random, 64);
                at[1][k][i] = far;
                at[2][k][i] = far + step;
            }
        }
        expect(at);
    }
}

TEST(with_axes_of_other_units)
{
    generator random = generator_new(2);
    double at[3][2][LANES];
    for (int n = 0; n < 10; n++) {
        int exponent = below(&random, 200) - 100;
        for (int i = 0; i < 6 * LANES; i++) {
            int k = i / LANES % 2;
            at[i / (2 * LANES)][k][i % LANES] =
                ldexp(uniform(&random, -1, 1), k == 0 ? exponent : -exponent);
        }
        expect(at);
    }
}

void run_tests(void)
{
    check_run(1, far_from_the_line);
    check_run(1, near_the_line);
    check_run(1, near_each_other);
    check_run(1, with_axes_of_other_units);
}
