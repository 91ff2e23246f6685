#include "figures/numbers.h"

/// By how many units intervals overlap whose facing ends are there, in units
/// from 3/4, once both are floats.
static double overlap_of(double high, double low)
{
    float ends[2] = {(float)(0.75 + 0x1p-24 * high),
                     (float)(0.75 + 0x1p-24 * low)};
    return ((double)ends[0] - (double)ends[1]) / 0x1p-24;
}

START_TEST(rounding_keeps_overlaps)
{
    static const struct {
        const char *before, *after;
        double high, low;
    } pairs[] = {
        {"overlap_before", "overlap_after", 2.7, 2.5},
        {"close_before", "close_after", 2.1, 2.3},
        {"apart_before", "apart_after", 1.7, 2.8},
    };
    char *text = printed(&fig_rounded_boxes);
    for (int i = 0; i < 3; i++) {
        expect_number(text, pairs[i].before, pairs[i].high - pairs[i].low);
        expect_number(text, pairs[i].after,
                      overlap_of(pairs[i].high, pairs[i].low));
        ck_assert(number_of(text, pairs[i].before) < 0 ||
                  number_of(text, pairs[i].after) >= 0);
    }
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/rounded_boxes", rounding_keeps_overlaps);
}
