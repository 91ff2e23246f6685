#include "figures/numbers.h"

#include <gmp.h>

enum {
    CELLS = 255
};

/// 4 most^2 (x + y + most), six times the volume of the tetrahedron that
/// (x, y, 0) makes with three corners of a cube: its base has the normal
/// (1, 1, 1).
static void find_volume(mpz_t volume, long most, long x, long y)
{
    mpz_set_si(volume, x + y + most);
    mpz_mul_si(volume, volume, 4 * most);
    mpz_mul_si(volume, volume, most);
}

/// The sign of the number from -2^63 to 2^63 - 1 that differs from `value` by
/// a multiple of 2^64.
static int sign_around(const mpz_t value)
{
    mpz_t rest;
    mpz_init(rest);
    mpz_fdiv_r_2exp(rest, value, 64);
    int sign = mpz_sgn(rest) == 0 ? 0 : mpz_tstbit(rest, 63) ? -1 : 1;
    mpz_clear(rest);
    return sign;
}

static void judge(const char *text, int bits)
{
    long most = (1L << bits) - 1;
    int wrong = 0;
    mpz_t volume, largest;
    mpz_inits(volume, largest, NULL);
    for (int i = 0; i < CELLS; i++)
        for (int j = 0; j < CELLS; j++) {
            // C cuts quotients toward zero.
            long x = most * (2 * i - 254) / 255, y = most * (2 * j - 254) / 255;
            find_volume(volume, most, x, y);
            wrong += sign_around(volume) != mpz_sgn(volume);
            if (mpz_cmpabs(volume, largest) > 0)
                mpz_abs(largest, volume);
        }
    char key[32];
    snprintf(key, sizeof key, "wrong_%d", bits);
    expect_number(text, key, wrong);
    snprintf(key, sizeof key, "wrong_percent_%d", bits);
    expect_number(text, key, wrong / 650.25);
    snprintf(key, sizeof key, "largest_log2_%d", bits);
    expect_number(text, key, log2(mpz_get_d(largest)));
    mpz_clears(volume, largest, NULL);
}

START_TEST(signs_go_around_from_twenty_bits_on)
{
    char *text = printed(&fig_integer_overflow);
    for (int bits = 19; bits <= 21; bits++)
        judge(text, bits);
    ck_assert(number_of(text, "wrong_19") == 0);
    ck_assert(fabs(number_of(text, "wrong_percent_20") - 12.5) < 0.01);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/integer_overflow",
                    signs_go_around_from_twenty_bits_on);
}
