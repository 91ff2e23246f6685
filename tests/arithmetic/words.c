#include "arithmetic/words.h"

#include "support/rational.h"
#include "support/support.h"

enum {
    MOST_WORDS = 4
};

/// Expect the number of the words rounded to nearest.
static void judge(const uint64_t word[], int count)
{
    mpz_t integer;
    mpz_init(integer);
    mpz_import(integer, (size_t)count, -1, sizeof *word, 0, 0, word);
    tf_value value = {.number = 0};
    value.number = tf_words_round(word, count, &value.exponent);
    bool good = rational_is(integer, 0, value);
    mpz_clear(integer);
    ck_assert_msg(good, "%d words, the highest %#llx: %a 2^%d, seed %llu",
                  count, (unsigned long long)word[count - 1], value.number,
                  value.exponent, (unsigned long long)seed());
}

/// Zeros, ones or anything, with a bit moved now and then.
static uint64_t any_word(generator *random)
{
    uint64_t word = below(random, 3) == 0   ? 0
                    : below(random, 2) == 0 ? UINT64_MAX
                                            : next_bits(random);
    return below(random, 2) ? word : word ^ UINT64_C(1) << below(random, 64);
}

START_TEST(words_are_rounded_to_nearest)
{
    generator random = generator_new(1);
    long tries = cases(200000);
    for (long i = 0; i < tries; i++) {
        uint64_t word[MOST_WORDS], any = 0;
        int count = 1 + below(&random, MOST_WORDS);
        for (int k = 0; k < count; k++)
            any |= word[k] = any_word(&random);
        if (any != 0)
            judge(word, count);
    }
}
END_TEST

/// Add bits 2^position, at most 54 of them.
static void add_bits(uint64_t word[], uint64_t bits, int position)
{
    int i = position / TF_WORD_BITS, shift = position % TF_WORD_BITS;
    word[i] += bits << shift;
    if (shift > TF_WORD_BITS - 54)
        word[i + 1] += bits >> (TF_WORD_BITS - shift);
}

START_TEST(ties_go_to_even_unless_lower_bits_follow)
{
    // 53 bits, a half of the last, and one bit lower down, or none.
    for (int place = 1; place < 3 * TF_WORD_BITS - 53; place++)
        for (int odd = 0; odd < 2; odd++)
            for (int lower = 0; lower < place; lower++) {
                uint64_t word[MOST_WORDS] = {0};
                uint64_t bits = UINT64_C(1) << 52 | (uint64_t)odd;
                add_bits(word, bits << 1 | 1, place - 1);
                if (lower + 1 < place)
                    add_bits(word, 1, lower);
                judge(word, 3);
            }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("words");
    TCase *rounding = tcase_create("rounding");
    tcase_add_test(rounding, words_are_rounded_to_nearest);
    tcase_add_test(rounding, ties_go_to_even_unless_lower_bits_follow);
    suite_add_tcase(suite, rounding);
    return suite;
}
