#define _GNU_SOURCE // open_memstream

#include "writers/encoder.h"

#include "support/matrices.h"
#include "support/support.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static char *text;
static size_t size;
static tf_encoder encoder;

static void begin(bool is_text, bool is_big_endian)
{
    free(text);
    encoder =
        (tf_encoder){open_memstream(&text, &size), is_text, is_big_endian};
}

static void expect_bytes(const char *bytes, size_t count)
{
    ck_assert_int_eq(fclose(encoder.stream), 0);
    ck_assert_uint_eq(size, count);
    ck_assert_mem_eq(text, bytes, count);
}

START_TEST(bytes_have_either_order)
{
    static const struct {
        tf_number_type type;
        double number;
        int bytes;
        const char *little, *big;
    } cases[] = {
        {TF_CHAR, -2, 1, "\xfe", "\xfe"},
        {TF_UCHAR, 254, 1, "\xfe", "\xfe"},
        {TF_SHORT, -2, 2, "\xfe\xff", "\xff\xfe"},
        {TF_USHORT, 513, 2, "\1\2", "\2\1"},
        {TF_INT, -2, 4, "\xfe\xff\xff\xff", "\xff\xff\xff\xfe"},
        {TF_UINT, 4278190081, 4, "\1\0\0\xff", "\xff\0\0\1"},
        {TF_FLOAT, 1, 4, "\0\0\x80\x3f", "\x3f\x80\0\0"},
        {TF_DOUBLE, -2, 8, "\0\0\0\0\0\0\0\xc0", "\xc0\0\0\0\0\0\0\0"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        ck_assert_int_eq(tf_number_bytes(cases[i].type), cases[i].bytes);
        begin(false, false);
        tf_encode(&encoder, cases[i].type, cases[i].number);
        expect_bytes(cases[i].little, (size_t)cases[i].bytes);
        begin(false, true);
        tf_encode(&encoder, cases[i].type, cases[i].number);
        expect_bytes(cases[i].big, (size_t)cases[i].bytes);
    }
}
END_TEST

START_TEST(texts_have_as_few_digits_as_they_need)
{
    static const struct {
        tf_number_type type;
        double number;
        const char *text;
    } cases[] = {{TF_DOUBLE, 0.1, "0.1"},
                 {TF_DOUBLE, 1.0 / 3, "0.3333333333333333"},
                 {TF_DOUBLE, (double)0.1F, "0.10000000149011612"},
                 {TF_FLOAT, (double)0.1F, "0.1"},
                 {TF_FLOAT, (double)(1 / 3.0F), "0.33333334"},
                 {TF_FLOAT, 0x1.fffffep-3, "0.24999999"},
                 {TF_FLOAT, 0x1.000002p0, "1.0000001"},
                 {TF_FLOAT, -0.0, "-0"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        begin(true, false);
        tf_encode(&encoder, cases[i].type, cases[i].number);
        expect_bytes(cases[i].text, strlen(cases[i].text));
    }
}
END_TEST

START_TEST(integers_are_limited)
{
    static const struct {
        tf_number_type type;
        double number;
        const char *text;
    } cases[] = {
        {TF_CHAR, -1e9, "-128"},      {TF_CHAR, 1e9, "127"},
        {TF_UCHAR, -1, "0"},          {TF_UCHAR, 256, "255"},
        {TF_SHORT, -1e9, "-32768"},   {TF_SHORT, 1e9, "32767"},
        {TF_USHORT, 1e9, "65535"},    {TF_INT, -1e99, "-2147483648"},
        {TF_INT, 1e99, "2147483647"}, {TF_UINT, 1e99, "4294967295"},
        {TF_INT, NAN, "0"},           {TF_UCHAR, INFINITY, "255"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        begin(true, false);
        tf_encode(&encoder, cases[i].type, cases[i].number);
        expect_bytes(cases[i].text, strlen(cases[i].text));
    }
}
END_TEST

static void expect_double_again(double number)
{
    begin(true, false);
    tf_encode_double(&encoder, number);
    fclose(encoder.stream);
    ck_assert_msg(strtod(text, NULL) == number, "%a: %s", number, text);
}

static void expect_float_again(float number)
{
    begin(true, false);
    tf_encode(&encoder, TF_FLOAT, (double)number);
    fclose(encoder.stream);
    ck_assert_msg(strtof(text, NULL) == number, "%a: %s", (double)number, text);
}

START_TEST(text_determines_numbers)
{
    generator random = generator_new(4);
    for (long i = 0; i < cases(20000); i++) {
        expect_double_again(any_double(&random));
        expect_float_again((float)uniform(&random, -1, 1));
    }
}
END_TEST

START_TEST(blanks_and_lines_are_of_text)
{
    begin(true, false);
    tf_encode_integer(&encoder, -7, 4);
    tf_encode_blank(&encoder);
    tf_encode_double(&encoder, 0.5);
    tf_encode_line_end(&encoder);
    expect_bytes("-7 0.5\n", 7);
    begin(false, true);
    tf_encode_integer(&encoder, 258, 8);
    tf_encode_blank(&encoder);
    tf_encode_line_end(&encoder);
    expect_bytes("\0\0\0\0\0\0\1\2", 8);
}
END_TEST

START_TEST(types_hold_what_they_can)
{
    static const struct {
        tf_number_type type;
        double number;
        bool fits;
    } cases[] = {
        {TF_CHAR, -128, true},           {TF_CHAR, -129, false},
        {TF_UCHAR, 255, true},           {TF_UCHAR, 256, false},
        {TF_UCHAR, -1, false},           {TF_SHORT, 0.5, false},
        {TF_INT, 2147483647, true},      {TF_INT, 2147483648, false},
        {TF_UINT, 4294967295, true},     {TF_UINT, 4294967296, false},
        {TF_INT, -0.0, false},           {TF_FLOAT, -0.0, true},
        {TF_FLOAT, 0.5, true},           {TF_FLOAT, 0.1, false},
        {TF_FLOAT, FLT_MAX, true},       {TF_FLOAT, DBL_MAX, false},
        {TF_FLOAT, 0x1p-149, true},      {TF_FLOAT, 0x1p-150, false},
        {TF_FLOAT, 0x1.000001p0, false}, {TF_FLOAT, 0x1.000002p0, true},
        {TF_DOUBLE, 0.1, true},          {TF_DOUBLE, 0x1p-1074, true},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        ck_assert_msg(tf_number_fits(cases[i].type, cases[i].number) ==
                          cases[i].fits,
                      "type %d, %a", (int)cases[i].type, cases[i].number);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("writers/encoder");
    TCase *tcase = tcase_create("numbers");
    tcase_add_test(tcase, bytes_have_either_order);
    tcase_add_test(tcase, integers_are_limited);
    tcase_add_test(tcase, texts_have_as_few_digits_as_they_need);
    tcase_add_test(tcase, text_determines_numbers);
    tcase_add_test(tcase, blanks_and_lines_are_of_text);
    tcase_add_test(tcase, types_hold_what_they_can);
    suite_add_tcase(suite, tcase);
    return suite;
}
