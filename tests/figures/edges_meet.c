#include "figures/numbers.h"

START_TEST(edges_meet_when_the_other_figure_has_it)
{
    char *text = printed(&fig_edges_meet);
    char *sheets = printed(&fig_edge_edge_distances);
    expect_number(text, "toi", number_of(sheets, "toi"));
    expect_number(text, "toi", 0.5);
    free(sheets);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/edges_meet",
                    edges_meet_when_the_other_figure_has_it);
}
