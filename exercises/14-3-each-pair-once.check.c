#include "check.h"

#include "support/support.h"

#include <stdint.h>

enum {
    LANES = 16,
    LEAVES = 5,
    ELEMENTS = LEAVES * LANES
};

uint32_t partners(int own, int lane, int other);

/// Whether an element takes another.
static bool takes(int element, int other)
{
    uint32_t set;
    check_value(set, partners(element / LANES, element % LANES, other / LANES));
    return set >> other % LANES & 1;
}

TEST(only_lanes)
{
    for (int own = 0; own < LEAVES; own++)
        for (int lane = 0; lane < LANES; lane++)
            for (int other = 0; other < LEAVES; other++) {
                check_input("own = %d, lane = %d, other = %d", own, lane,
                            other);
                uint32_t set;
                check_value(set, partners(own, lane, other));
                check_that(set >> LANES == 0, "a set of sixteen bits", "0x%x",
                           (unsigned)set);
            }
}

TEST(each_pair_once)
{
    for (int i = 0; i < ELEMENTS; i++)
        for (int j = 0; j <= i; j++) {
            check_input("leaf %d, lane %d and leaf %d, lane %d", j / LANES,
                        j % LANES, i / LANES, i % LANES);
            int times = takes(i, j) + (i == j ? 0 : takes(j, i));
            check_that(times == (i == j ? 0 : 1), i == j ? "never" : "once",
                       "%d times", times);
        }
}

void run_tests(void)
{
    check_run(1, only_lanes);
    check_run(1, each_pair_once);
}
