#include "figures/numbers.h"

#include "support/matrices.h"
#include "support/rational.h"

/// How many bits the largest determinant of differences of `bits`-bit integers
/// has: an extreme one is found among those of extreme differences, because the
/// determinant is linear in each.
static double largest_bits(int n, int bits)
{
    double sign[9] = {-1, -1, -1, -1, -1, -1, -1, -1, -1};
    double most = ldexp(1, bits) - 1;
    size_t largest = 0;
    mpz_t determinant;
    mpz_init(determinant);
    generator random = generator_new(0);
    do {
        matrix m = matrix_new(&random, n);
        for (int k = 0; k < n * n; k++) {
            *matrix_coordinate(&m, 2 * k) = sign[k] * most;
            *matrix_coordinate(&m, 2 * k + 1) = -sign[k] * most;
        }
        tf_differences differences = matrix_differences(&m);
        int exponent = rational_determinant(determinant, &differences);
        if (mpz_sgn(determinant) == 0)
            continue;
        size_t own = mpz_sizeinbase(determinant, 2) + (size_t)exponent;
        largest = own > largest ? own : largest;
    } while (next_signs(n * n, sign));
    mpz_clear(determinant);
    return (double)largest;
}

START_TEST(bits_are_counted)
{
    static const struct {
        const char *key;
        int n, bits, spent;
    } row[] = {{"plane_64", 2, 30, 64},
               {"space_64", 3, 19, 64},
               {"plane_128", 2, 53, 110},
               {"space_128", 3, 40, 127}};
    char *text = printed(&fig_determinant_bits);
    for (int i = 0; i < (int)(sizeof row / sizeof *row); i++) {
        char key[32];
        snprintf(key, sizeof key, "spent_%s", row[i].key);
        expect_number(text, key, row[i].spent);
        snprintf(key, sizeof key, "largest_%s", row[i].key);
        expect_number(text, key, largest_bits(row[i].n, row[i].bits));
    }
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/determinant_bits", bits_are_counted);
}
