#include "figures/numbers.h"

START_TEST(three_edges_are_crossed)
{
    char *text = printed(&fig_perturbed_ray);
    expect_number(text, "crossings", 3);
    expect_number(text, "sum", 1);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/perturbed_ray", three_edges_are_crossed);
}
