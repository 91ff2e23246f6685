#include "figures/numbers.h"

static int cross(const int a[2], const int b[2])
{
    return a[0] * b[1] - a[1] * b[0];
}

/// A bit for each negative barycentric coordinate of the origin.
static int pattern_of(const int corner[3][2])
{
    int weight[3], sum = 0, pattern = 0;
    for (int i = 0; i < 3; i++)
        sum += weight[i] = cross(corner[(i + 1) % 3], corner[(i + 2) % 3]);
    for (int i = 0; i < 3; i++)
        pattern |= (weight[i] * sum < 0) << i;
    return pattern;
}

START_TEST(patterns_are_those_of_the_origin)
{
    // The point goes from (1, 3) to (2, 0), the edge from (0, 0), (4, 0) to
    // (0, 1), (4, 2); each corner less the point of its time.
    static const int apart[3][2] = {{-1, -3}, {3, -3}, {2, 2}};
    static const int hit[3][2] = {{-1, -3}, {-2, 1}, {2, 2}};
    char *text = printed(&fig_sign_regions);
    expect_number(text, "apart_pattern", pattern_of(apart));
    expect_number(text, "hit_pattern", pattern_of(hit));
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/sign_regions", patterns_are_those_of_the_origin);
}
