#include "check.h"

#include "arithmetic/sign.h"
#include "support/support.h"

#include <gmp.h>
#include <math.h>
#include <string.h>

typedef struct estimate {
    double value, bound;
} estimate;

estimate estimate_nearer(const double p[2], const double q[2],
                         const double r[2]);
tf_sign nearer(const double p[2], const double q[2], const double r[2]);

/// |a - b|^2, exactly.
static void square_distance(mpq_t sum, const double a[2], const double b[2])
{
    mpq_t x, y;
    mpq_inits(x, y, NULL);
    mpq_set_ui(sum, 0, 1);
    for (int k = 0; k < 2; k++) {
        mpq_set_d(x, a[k]);
        mpq_set_d(y, b[k]);
        mpq_sub(x, x, y);
        mpq_mul(x, x, x);
        mpq_add(sum, sum, x);
    }
    mpq_clears(x, y, NULL);
}

// 16 u, and a little more, since the answer computes its bound with rounding.
static const double most = 16 * 0x1p-53 * (1 + 0x1p-45);

/// Whether the bound holds, and is not larger than it needs to be.
static void expect_bound(const mpq_t truth, const mpq_t sum, estimate got)
{
    double units = got.bound / (0x1p-53 * mpq_get_d(sum));
    mpq_t off, bound;
    mpq_inits(off, bound, NULL);
    mpq_set_d(off, got.value);
    mpq_sub(off, off, truth);
    mpq_abs(off, off);
    mpq_set_d(bound, got.bound);
    bool holds = mpq_cmp(off, bound) <= 0;
    check_that(holds, "a bound of at least the error",
               "the bound %.6g, %.4g u of the sum, of an error of %.6g",
               got.bound, units, mpq_get_d(off));
    mpq_set_d(off, most);
    mpq_mul(off, off, sum);
    check_that(mpq_cmp(bound, off) <= 0, "a bound of at most 16 u of the sum",
               "the bound %.6g, %.4g u of the sum %.6g", got.bound, units,
               mpq_get_d(sum));
    mpq_clears(off, bound, NULL);
}

static void expect(const double p[2], const double q[2], const double r[2])
{
    mpq_t near, far, sum;
    mpq_inits(near, far, sum, NULL);
    square_distance(near, q, p);
    square_distance(far, r, p);
    mpq_add(sum, near, far);
    mpq_sub(far, far, near);
    check_input("p = (%a, %a), q = (%a, %a), r = (%a, %a)", p[0], p[1], q[0],
                q[1], r[0], r[1]);
    estimate rounded;
    check_value(rounded, estimate_nearer(p, q, r));
    check_that(isfinite(rounded.value) && isfinite(rounded.bound),
               "finite numbers", "%g and %g", rounded.value, rounded.bound);
    expect_bound(far, sum, rounded);
    tf_sign got;
    check_value(got, nearer(p, q, r));
    int right = mpq_sgn(far);
    mpq_clears(near, far, sum, NULL);
    check_that((int)got == right, text_sign(right), "%s", text_sign(got));
}

TEST(clearly)
{
    expect((double[]){0, 0}, (double[]){1, 0}, (double[]){0, 2});
    expect((double[]){0, 0}, (double[]){3, 3}, (double[]){4, 0});
}

TEST(equally_near)
{
    expect((double[]){0, 0}, (double[]){3, 4}, (double[]){5, 0});
    expect((double[]){0.1, 0.7}, (double[]){0.3, 0.2}, (double[]){0.3, 0.2});
    expect((double[]){1, 1}, (double[]){1, 1}, (double[]){1, 1});
}

/// Mirror images, but for the last bits of one of them.
TEST(almost_equally_near)
{
    generator random = generator_new(12);
    for (int i = 0; i < 1000; i++) {
        double p[2], q[2], r[2], scale = ldexp(1, below(&random, 500) - 250);
        for (int k = 0; k < 2; k++) {
            p[k] = scale * uniform(&random, -1, 1);
            q[k] = scale * uniform(&random, -1, 1);
            r[k] = 2 * p[k] - q[k];
        }
        expect(p, q, r);
        r[i % 2] =
            nextafter(r[i % 2], below(&random, 2) ? INFINITY : -INFINITY);
        expect(p, r, q);
    }
}

TEST(from_far_away)
{
    generator random = generator_new(13);
    for (int i = 0; i < 1000; i++) {
        double p[2] = {0x1p200, uniform(&random, -1, 1)}, q[2], r[2];
        for (int k = 0; k < 2; k++) {
            q[k] = uniform(&random, -1, 1);
            r[k] = i % 3 == 0 && k == 0 ? q[k] : uniform(&random, -1, 1);
        }
        expect(p, q, r);
    }
}

TEST(anywhere)
{
    generator random = generator_new(14);
    for (int i = 0; i < 1000; i++) {
        double at[3][2];
        for (int j = 0; j < 6; j++)
            at[j / 2][j % 2] =
                ldexp(uniform(&random, -1, 1), below(&random, 60));
        expect(at[0], at[1], at[2]);
    }
}

void run_tests(void)
{
    check_run(1, clearly);
    check_run(1, equally_near);
    check_run(1, almost_equally_near);
    check_run(1, from_far_away);
    check_run(1, anywhere);
}
