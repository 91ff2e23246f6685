#include "figures/numbers.h"

#include "support/oracle.h"

/// Coordinates in sixteenths of a cell.
static const int triangle[3][2] = {{6, 6}, {58, 41}, {25, 23}};
static const int edges[4][2] = {{6, 7}, {57, 41}, {7, 9}, {52, 39}};
static const double sixteenths_y = 39.5; // of the last end

/// The nearest multiple of 16, in sixteenths; none of the places is in the
/// middle.
static int snap(int sixteenths)
{
    return (sixteenths + 8) / 16 * 16;
}

/// Twice the area of the triangle, in cells.
static double double_area(bool rounded)
{
    int x[3][2];
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 2; k++)
            x[i][k] = rounded ? snap(triangle[i][k]) : triangle[i][k];
    // The surveyor's formula.
    int sum = 0;
    for (int i = 0; i < 3; i++) {
        const int *a = x[i], *b = x[(i + 1) % 3];
        sum += a[0] * b[1] - b[0] * a[1];
    }
    return sum / 256.0;
}

static bool edges_meet(bool rounded)
{
    tf_event end[4] = {{.t = 0}};
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 2; k++)
            end[i].x[k] = rounded ? snap(edges[i][k]) : edges[i][k];
    if (!rounded)
        end[3].x[1] = sixteenths_y;
    oracle_simplex first = {2, {&end[0], &end[1]}};
    oracle_simplex second = {2, {&end[2], &end[3]}};
    return oracle_slices_meet(2, &first, &second);
}

START_TEST(rounding_turns_and_crosses)
{
    char *text = printed(&fig_grid_rounding);
    expect_number(text, "double_area", double_area(false));
    expect_number(text, "double_area_rounded", double_area(true));
    ck_assert(double_area(false) > 0 && double_area(true) < 0);
    expect_number(text, "cross", edges_meet(false));
    expect_number(text, "cross_rounded", edges_meet(true));
    ck_assert(!edges_meet(false) && edges_meet(true));

    // The first end of the second edge is 1/12 above the first edge, which
    // rises by 2 on 3.
    expect_number(text, "distance", 3 / sqrt(13) / 12);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/grid_rounding", rounding_turns_and_crosses);
}
