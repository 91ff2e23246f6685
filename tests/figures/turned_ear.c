#include "figures/numbers.h"

START_TEST(an_edge_objects)
{
    char *text = printed(&fig_turned_ear);
    expect_number(text, "refused", 1);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/turned_ear", an_edge_objects);
}
