#include "figures/numbers.h"

#include "support/sums.h"

#include <float.h>

enum {
    WORD_BITS = 64
};

/// How many words of a sum are not zero, and its first and last.
static int count_words(const mpz_t sum, int *first, int *last)
{
    int count = 0, bits = (int)mpz_sizeinbase(sum, 2);
    mpz_t word;
    mpz_init(word);
    for (int i = 0; i * WORD_BITS < bits; i++) {
        mpz_tdiv_q_2exp(word, sum, (mp_bitcnt_t)(i * WORD_BITS));
        mpz_tdiv_r_2exp(word, word, WORD_BITS);
        if (mpz_sgn(word) == 0)
            continue;
        *first = count == 0 && i < *first ? i : *first;
        *last = i > *last ? i : *last;
        count++;
    }
    mpz_clear(word);
    return count;
}

static void expect_sums(const char *text, const char *name,
                        const double e[3][3])
{
    mpz_t sum[2];
    mpz_inits(sum[0], sum[1], NULL);
    for (int j = 0; j < 3; j++)
        for (int turn = 1; turn <= 2; turn++) {
            double a = e[0][j], b = e[1][(j + turn) % 3];
            double c = e[2][(j + 2 * turn) % 3];
            double sign = turn == 1 ? 1 : -1;
            bool negative =
                !signbit(sign) ^ !signbit(a) ^ !signbit(b) ^ !signbit(c);
            sum_add(sum[!negative], fabs(a), fabs(b), fabs(c));
        }
    int first = 1000, last = 0;
    const char *const key[] = {"negative", "positive"};
    for (int i = 0; i < 2; i++) {
        char whole[32];
        snprintf(whole, sizeof whole, "%s_%s", name, key[i]);
        expect_number(text, whole, count_words(sum[i], &first, &last));
    }
    char used[32];
    snprintf(used, sizeof used, "%s_used", name);
    // A word above may be in use and zero.
    double extra = number_of(text, used) - (last - first + 1);
    ck_assert_msg(extra >= 0 && extra <= 1, "%s: %g words more", used, extra);
    mpz_clears(sum[0], sum[1], NULL);
}

START_TEST(words_are_counted)
{
    static const double mixed[3][3] = {{DBL_MAX, 1, DBL_TRUE_MIN},
                                       {DBL_TRUE_MIN, DBL_MAX, 1},
                                       {1, DBL_TRUE_MIN, DBL_MAX}};
    static const double ordinary[3][3] = {
        {0x1.39adc5cd900e1p-2, -0x1.5fd7e4fab497p-4, -0x1.382988f3c19d2p-2},
        {-0x1.72b9bad814c5fp-2, 0x1.08b61d7e26e86p-4, 0x1.5c960fdb4427ap-2},
        {-0x1.7426e4871b6b3p-2, 0x1.a16e455e5683p-4, 0x1.725a4884d51d7p-2}};
    char *text = printed(&fig_accumulator_words);
    expect_sums(text, "mixed", mixed);
    expect_sums(text, "ordinary", ordinary);
    // Units of 2^-3222, and 48 products below 2^3072.
    expect_number(text, "words", ceil((3222 + 3072 + log2(48)) / WORD_BITS));
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/accumulator_words", words_are_counted);
}
