#define _GNU_SOURCE // memfd_create

#include "files/number.h"

#include "support/support.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

/// Whether both are the same double to the last bit, the sign of zero included.
static bool same(double a, double b)
{
    return a == b && signbit(a) == signbit(b);
}

/// What strtod makes of the same text is right.
static void expect_as_strtod(const char *text)
{
    char *end;
    double right = strtod(text, &end), number = 0.5;
    const char *at = text;
    ck_assert_msg(tf_number_read(&at, &number), "'%s' is no number", text);
    ck_assert_msg(same(number, right), "'%s' is %a, not %a", text, number,
                  right);
    ck_assert_msg(at == end, "'%s' ends at '%s', not '%s'", text, at, end);
}

START_TEST(numbers_at_the_limits_are_exact)
{
    static const char *const texts[] = {"0",
                                        "-0",
                                        "+0",
                                        "0x0p0",
                                        "-0x0p+0",
                                        "1",
                                        "-1.5",
                                        "+1e3",
                                        ".5",
                                        "5.",
                                        "-.5e-3",
                                        "1e-400",
                                        "-1e-400",
                                        "1e400",
                                        "-1e400",
                                        "4.9e-324",
                                        "2.2250738585072011e-308",
                                        "1.7976931348623157e308",
                                        "1.7976931348623159e308",
                                        "0x1p-1074",
                                        "0x1p-1075",
                                        "0x1.8p-1075",
                                        "0x1p-1022",
                                        "0x0.8p-1022",
                                        "0x1.8p-1022",
                                        "0x1.fffffffffffffp1023",
                                        "0x1.fffffffffffff7p1023",
                                        "0x1.fffffffffffff8p1023",
                                        "0x1p1024",
                                        "0x0p1024",
                                        "-0x0p1025",
                                        "0x0p9999",
                                        "0x0p-9999",
                                        "0x.8p1024",
                                        "0x10p971",
                                        "0x1p971",
                                        "0x1p972",
                                        "0x3fffffffffffffp0",
                                        "0x1fffffffffffffp971",
                                        "0x1fffffffffffffp-1022",
                                        "0x1.00000000000008p0",
                                        "0x1.00000000000018p0",
                                        "0xFFFFFFFFFFFFFFFF",
                                        "0x12345678901234567p-3",
                                        "0x0000000000000000000000001.8p0",
                                        "0x.00000000000000000000000018p100",
                                        "0X1.8P+0001",
                                        "0x1p00000001",
                                        "0x1p-99999",
                                        "0x1p99999",
                                        "0x1p-999999999999999999999",
                                        "0xabcdefp1",
                                        "0xABCDEFp1",
                                        "0x1",
                                        "0x1.",
                                        "0x.1",
                                        "0x1p4,0x1p5"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        expect_as_strtod(texts[i]);
}
END_TEST

START_TEST(a_number_ends_where_it_ends)
{
    static const char *const texts[] = {
        "1.5abc", "1.5 ",      "1.2.3",   "1e",   "1e+",
        "0x",     "0xg",       "0x.",     "0x1p", "0x1p+",
        "0x1pz",  "0x1.8.8p0", "0x1p4.5", "1,2",  "0x1 p3"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        expect_as_strtod(texts[i]);
}
END_TEST

START_TEST(what_is_no_number_is_left_alone)
{
    static const char *const texts[] = {"",         ",",
                                        "-",        "+",
                                        ".",        "-.",
                                        "--1",      "+-1",
                                        "e5",       "nan",
                                        "inf",      "-inf",
                                        "NAN",      "-nan(1)",
                                        "infinity", " 1",
                                        "\t1",      "x1",
                                        "p0",       "-x",
                                        "abc",      "\xEF\xBB\xBF,1"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        const char *at = texts[i];
        double number = 0.5;
        ck_assert_msg(!tf_number_read(&at, &number), "'%s'", texts[i]);
        ck_assert_msg(at == texts[i] && number == 0.5, "'%s'", texts[i]);
    }
}
END_TEST

enum {
    BLOCK = 1 << 21
};

/// A text of 2^30 characters: the beginning, zeros, and the end.  In memory
/// there are two blocks of it, one of which comes again and again.
static char *endless_text(const char *beginning, const char *end)
{
    size_t size = (size_t)1 << 30;
    int zeros = memfd_create("zeros", 0);
    ck_assert(zeros >= 0 && ftruncate(zeros, BLOCK) == 0);
    char *text = mmap(NULL, size + BLOCK, PROT_READ | PROT_WRITE,
                      MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    ck_assert_ptr_ne(text, MAP_FAILED);
    for (size_t at = BLOCK; at < size; at += BLOCK)
        ck_assert_ptr_eq(mmap(text + at, BLOCK, PROT_READ | PROT_WRITE,
                              MAP_SHARED | MAP_FIXED, zeros, 0),
                         text + at);
    close(zeros);
    memset(text, '0', 2 * BLOCK);
    memcpy(text, beginning, strlen(beginning));
    strcpy(text + size, end);
    return text;
}

START_TEST(exponents_of_endless_digits_do_not_wrap_round)
{
    if (cases(100) < 100)
        return; // it takes seconds
    // 2^(8 - 2^32): in 32 bits the exponent is 8.
    char *text = endless_text("0x.0", "1");
    const char *at = text;
    double number = 0.5;
    ck_assert(tf_number_read(&at, &number));
    ck_assert_double_eq(number, 0);
    ck_assert_int_eq(*at, '\0');
}
END_TEST

static double any_double(generator *random)
{
    double x;
    do {
        uint64_t bits = next_bits(random);
        memcpy(&x, &bits, sizeof x);
    } while (!isfinite(x));
    return x;
}

START_TEST(doubles_come_back_to_the_last_bit)
{
    static const char *const formats[] = {"%a", "%.17g", "%A", "%.20a"};
    generator random = generator_new(1);
    for (long i = 0; i < cases(200000); i++) {
        double x = any_double(&random), number;
        char text[64];
        snprintf(text, sizeof text, formats[i % 4], x);
        const char *at = text;
        ck_assert_msg(tf_number_read(&at, &number), "'%s'", text);
        ck_assert_msg(same(number, x) && *at == '\0', "'%s' is %a", text,
                      number);
    }
}
END_TEST

START_TEST(any_hexadecimal_float_is_rounded_as_by_strtod)
{
    generator random = generator_new(2);
    for (long i = 0; i < cases(200000); i++) {
        char text[64];
        unsigned long long whole = next_bits(&random) >> below(&random, 64);
        unsigned long long part = next_bits(&random) >> below(&random, 64);
        int exponent = below(&random, 2400) - 1200;
        snprintf(text, sizeof text, "%s0x%llx.%llxp%d",
                 below(&random, 2) ? "-" : "", whole, part, exponent);
        expect_as_strtod(text);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("files/number");
    TCase *numbers = tcase_create("numbers");
    tcase_add_test(numbers, numbers_at_the_limits_are_exact);
    tcase_add_test(numbers, a_number_ends_where_it_ends);
    tcase_add_test(numbers, what_is_no_number_is_left_alone);
    tcase_add_test(numbers, exponents_of_endless_digits_do_not_wrap_round);
    tcase_add_test(numbers, doubles_come_back_to_the_last_bit);
    tcase_add_test(numbers, any_hexadecimal_float_is_rounded_as_by_strtod);
    suite_add_tcase(suite, numbers);
    return suite;
}
