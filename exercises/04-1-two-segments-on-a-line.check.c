#include "check.h"

bool segments_intersect(const double a[2], const double b[2]);

enum {
    POINTS = 6
};

/// Whether an integer lies in both: enough if the ends are integers.
static bool share_a_number(const double a[2], const double b[2])
{
    bool meet = false;
    for (int x = 0; x < POINTS; x++)
        meet |= (x - a[0]) * (x - a[1]) <= 0 && (x - b[0]) * (x - b[1]) <= 0;
    return meet;
}

TEST(segments_of_small_integers)
{
    for (int i = 0; i < POINTS * POINTS * POINTS * POINTS; i++) {
        double a[2] = {i % POINTS, i / POINTS % POINTS};
        double b[2] = {i / POINTS / POINTS % POINTS,
                       i / POINTS / POINTS / POINTS};
        check_input("a: %g to %g, b: %g to %g", a[0], a[1], b[0], b[1]);
        bool got;
        check_value(got, segments_intersect(a, b));
        check_bool(share_a_number(a, b), got);
    }
}

void run_tests(void)
{
    check_run(1, segments_of_small_integers);
}
