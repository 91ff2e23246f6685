#include "check.h"

#include "support/matrices.h"

#include <gmp.h>

int coordinate_bits(int n, int word);

/// The determinant of the n x n matrix, row by row, without one of the columns
/// 0..2 for each bit of `used`: by its first row.
static int expand(int n, int row, unsigned used, const double entry[])
{
    if (row == n)
        return 1;
    int sum = 0, sign = 1; // of the column among those that are left
    for (int j = 0; j < n; j++) {
        if (used >> j & 1)
            continue;
        sum += sign * (int)entry[row * n + j] *
               expand(n, row + 1, used | 1U << j, entry);
        sign = -sign;
    }
    return sum;
}

/// The largest determinant of entries -1, 0 and 1: all are tried.
static int largest_of_signs(int n)
{
    double entry[9] = {-1, -1, -1, -1, -1, -1, -1, -1, -1};
    int largest = 0;
    do {
        int own = expand(n, 0, 0, entry);
        largest = own > largest ? own : largest;
    } while (next_signs(n * n, entry));
    return largest;
}

/// Whether a word can hold the largest determinant of differences of
/// coordinates below 2^bits: a determinant is linear in each entry, so in the
/// largest all entries are as large as possible.
static bool fits(int n, int largest_sign, int bits, int word)
{
    mpz_t largest;
    mpz_init(largest);
    mpz_setbit(largest, (mp_bitcnt_t)bits + 1);
    mpz_sub_ui(largest, largest, 2);
    mpz_pow_ui(largest, largest, (unsigned long)n);
    mpz_mul_si(largest, largest, largest_sign);
    bool fits = mpz_sizeinbase(largest, 2) <= (size_t)(word - 1);
    mpz_clear(largest);
    return fits;
}

static void expect(int n, int largest_sign, int word)
{
    int bits = 1;
    while (fits(n, largest_sign, bits + 1, word))
        bits++;
    check_input("n = %d, word = %d", n, word);
    double got;
    check_value(got, coordinate_bits(n, word));
    check_real(bits, got);
}

TEST(words_that_exist)
{
    for (int n = 2; n <= 3; n++) {
        int largest_sign = largest_of_signs(n);
        for (int word = 16; word <= 128; word *= 2)
            expect(n, largest_sign, word);
    }
}

TEST(all_words)
{
    for (int n = 2; n <= 3; n++) {
        int largest_sign = largest_of_signs(n);
        for (int word = 12; word <= 128; word++)
            expect(n, largest_sign, word);
    }
}

void run_tests(void)
{
    check_run(1, words_that_exist);
    check_run(1, all_words);
}
