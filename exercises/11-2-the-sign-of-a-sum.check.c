#include "check.h"

#include "support/sums.h"
#include "support/support.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    MOST = 24
};

int sign_of_sum(int n, const double x[]);

static int true_sign(int n, const double x[])
{
    mpz_t sum;
    mpz_init(sum);
    for (int i = 0; i < n; i++)
        sum_add(sum, x[i], 1, 1);
    int sign = sum_sign(sum);
    mpz_clear(sum);
    return sign;
}

static void expect(int n, const double x[])
{
    char text[MOST * 32] = "none";
    for (int i = 0, length = 0; i < n; i++)
        length += snprintf(text + length, sizeof text - (size_t)length, "%s%a",
                           i > 0 ? ", " : "", x[i]);
    check_input("n = %d, x = %s", n, text);
    int got, truth = true_sign(n, x);
    check_value(got, sign_of_sum(n, x));
    check_that(got == truth, text_sign(truth), "%d", got);
}

TEST(plain_sums)
{
    expect(0, NULL);
    expect(2, (double[]){-2, 3});
    expect(3, (double[]){0, 0, 0});
    expect(3, (double[]){1, 2, -3});
}

TEST(what_rounding_hides)
{
    expect(3, (double[]){1, 0x1p-60, -1});
    expect(3, (double[]){1, -0x1p-1000, -1});
    expect(5, (double[]){1, 0x1p-60, -0x1p-120, -1, -0x1p-60});
    expect(5, (double[]){0x1p900, 1, 0x1p-900, -1, -0x1p900});
}

TEST(sums_of_many_signs)
{
    expect(4, (double[]){0x1p100, -0x1p40, 0x1p-20, -0x1p-80});
    expect(4, (double[]){-0x1p100, 0x1p40, -0x1p-20, 0x1p-80});
}

TEST(nearly_zero)
{
    generator random = generator_new(0);
    for (int i = 0; i < 500; i++) {
        double x[MOST];
        int half = 1 + below(&random, MOST / 2 - 1);
        for (int k = 0; k < half; k++) {
            int exponent = below(&random, 400) - 200;
            x[2 * k] = ldexp(uniform(&random, -1, 1), exponent);
            x[2 * k + 1] = -x[2 * k];
        }
        x[2 * half] = ldexp(below(&random, 3) - 1, -400);
        expect(2 * half + 1, x);
    }
}

void run_tests(void)
{
    check_run(1, plain_sums);
    check_run(1, what_rounding_hides);
    check_run(1, sums_of_many_signs);
    check_run(1, nearly_zero);
}
