#include "figures/numbers.h"

START_TEST(memory_takes_a_push_back)
{
    char *text = printed(&fig_remembered_impulses);
    // One after another: (1 + 0) / 2, then (3 + 1/2) / 2.
    expect_number(text, "slow_loop", 0.5);
    expect_number(text, "fast_loop", 1.75);
    expect_number(text, "plate_loop", 1.75);
    // The least change: the slow stone is not in the way.
    expect_number(text, "slow_memory", 1);
    expect_number(text, "fast_memory", 1.5);
    expect_number(text, "plate_memory", 1.5);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/remembered_impulses", memory_takes_a_push_back);
}
