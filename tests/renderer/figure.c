#define _POSIX_C_SOURCE 200809L // open_memstream

#include "renderer/figure.h"

#include "support/support.h"

#include <stdlib.h>

static const struct {
    double value;
    const char *line;
} numbers[] = {
    {0, "key 0\n"},           {-7, "key -7\n"},
    {200000, "key 200000\n"}, {0x1p51, "key 2251799813685248\n"},
    {0.1, "key 0.1\n"},       {-2.5e-20, "key -2.5e-20\n"},
    {1e300, "key 1e+300\n"},  {0.1 + 0.2, "key 0.30000000000000004\n"},
};

START_TEST(numbers_are_printed_short_and_read_back_the_same)
{
    char *text = NULL;
    size_t size;
    FILE *stream = open_memstream(&text, &size);
    fig_number(stream, "key", numbers[_i].value);
    fclose(stream);
    ck_assert_str_eq(text, numbers[_i].line);
    ck_assert(strtod(text + 4, NULL) == numbers[_i].value);
    free(text);
}
END_TEST

Suite *suite(void)
{
    Suite *figure = suite_create("renderer/figure");
    TCase *printed = tcase_create("numbers");
    tcase_add_loop_test(printed,
                        numbers_are_printed_short_and_read_back_the_same, 0,
                        sizeof numbers / sizeof *numbers);
    suite_add_tcase(figure, printed);
    return figure;
}
