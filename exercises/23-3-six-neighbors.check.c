#include "check.h"

#include "support/support.h"

#include <stdbool.h>

bool is_flip_wanted(const int neighbors[4], const bool on_boundary[4]);

static void expect(bool right, const int neighbors[4],
                   const bool on_boundary[4])
{
    check_input("neighbors %d, %d, %d, %d; on the boundary %d, %d, %d, %d",
                neighbors[0], neighbors[1], neighbors[2], neighbors[3],
                on_boundary[0], on_boundary[1], on_boundary[2], on_boundary[3]);
    bool got;
    check_value(got, is_flip_wanted(neighbors, on_boundary));
    check_that(got == right, right ? "true" : "false", "%s",
               got ? "true" : "false");
}

static const bool inside[4] = {false};

TEST(seven_and_five)
{
    expect(true, (int[]){7, 7, 5, 5}, inside);
    expect(false, (int[]){5, 5, 7, 7}, inside);
    expect(false, (int[]){6, 6, 6, 6}, inside);
}

// What would not change is left alone.
TEST(a_draw)
{
    expect(false, (int[]){7, 6, 6, 5}, inside);
    expect(false, (int[]){8, 5, 6, 5}, inside);
}

TEST(on_the_boundary)
{
    expect(true, (int[]){5, 6, 4, 5}, (bool[]){true, false, false, false});
    expect(false, (int[]){6, 6, 4, 4}, (bool[]){false, false, true, true});
    expect(false, (int[]){6, 6, 3, 3}, (bool[]){false, false, true, true});
    expect(true, (int[]){7, 6, 3, 3}, (bool[]){false, false, true, true});
}

TEST(what_is_impossible)
{
    expect(false, (int[]){3, 20, 3, 3}, inside);
    expect(false, (int[]){20, 3, 3, 3}, inside);
    expect(false, (int[]){2, 20, 3, 3}, (bool[]){true, false, false, false});
}

void run_tests(void)
{
    check_run(1, seven_and_five);
    check_run(1, a_draw);
    check_run(1, on_the_boundary);
    check_run(1, what_is_impossible);
}
