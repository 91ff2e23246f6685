#include "check.h"

#include "support/rational.h"
#include "support/support.h"

#include <inttypes.h>
#include <math.h>

double round_once(const uint64_t word[3]);

static void set_words(mpz_t number, const uint64_t word[3])
{
    mpz_set_ui(number, 0);
    for (int i = 2; i >= 0; i--) {
        mpz_mul_2exp(number, number, 64);
        mpz_add_ui(number, number, word[i]);
    }
}

static void expect(uint64_t high, uint64_t middle, uint64_t low)
{
    const uint64_t word[3] = {low, middle, high};
    check_input("words %016" PRIx64 " %016" PRIx64 " %016" PRIx64
                ", the highest first",
                high, middle, low);
    double got;
    check_value(got, round_once(word));
    check_that(isfinite(got), "a finite number", "%g", got);
    mpz_t number;
    mpz_init(number);
    set_words(number, word);
    bool nearest = rational_is(number, 0, (tf_value){.number = got});
    mpz_clear(number);
    check_that(nearest, "the nearest double", "%a", got);
}

TEST(numbers_of_one_word)
{
    expect(0, 0, 0);
    expect(0, 0, 1);
    expect(0, 0, UINT64_MAX);
    expect(0, 0, (UINT64_C(1) << 63) + (UINT64_C(1) << 10));
    expect(0, 0, (UINT64_C(3) << 62) + (UINT64_C(3) << 10));
}

TEST(numbers_of_more_words)
{
    expect(0, 1, 0);
    expect(1, 0, 0);
    expect(0, 5, UINT64_C(7) << 60);
    expect(UINT64_MAX, UINT64_MAX, UINT64_MAX);
    expect(UINT64_C(1) << 63, 0, 0);
}

TEST(halfway_and_beside)
{
    uint64_t half = UINT64_C(1) << 10, one = UINT64_C(1) << 63;
    for (uint64_t odd = 0; odd < 2; odd++)
        for (uint64_t low = 0; low < 2; low++) {
            expect(0, one + (odd << 11) + half, low);
            expect(one + (odd << 11) + half, low, 0);
            expect(one + (odd << 11) + half, 0, low);
            expect(one + (odd << 11) + half - 1, UINT64_MAX, UINT64_MAX);
            // The same, shifted into two words.
            expect(1, odd << 12 | UINT64_C(1) << 11, low);
        }
}

TEST(any_words)
{
    generator random = generator_new(0);
    for (int i = 0; i < 3000; i++) {
        uint64_t word[3];
        for (int k = 0; k < 3; k++) {
            uint64_t bits = next_bits(&random);
            word[k] = below(&random, 3) ? bits >> below(&random, 64) : 0;
        }
        expect(word[2], word[1], word[0]);
    }
}

void run_tests(void)
{
    check_run(1, numbers_of_one_word);
    check_run(1, numbers_of_more_words);
    check_run(1, halfway_and_beside);
    check_run(1, any_words);
}
