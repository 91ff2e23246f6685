#include "check.h"

#include <math.h>

bool lie_upon_each_other(const double v[2], const double a[2],
                         const double c[2]);

typedef struct example {
    double v[2], a[2], c[2];
    bool expected;
} example;

static const example examples[] = {
    {{0, 0}, {4, 0}, {2, 0}, true},
    {{0, 0}, {4, 0}, {0, 2}, false},
    {{0, 0}, {4, 0}, {-2, 0}, false},
    {{1, 1}, {1, 5}, {1, 2}, true},
    {{1, 1}, {1, 5}, {1, -2}, false},
    {{3, 2}, {1, 1}, {-1, 0}, true},
    {{3, 2}, {3, 2}, {5, 4}, false},
    {{3, 2}, {5, 4}, {3, 2}, false},
    {{3, 2}, {5, 4}, {5, 4}, true},
    {{0, 0}, {3, 1}, {6, 2.0000000000000004}, false},
    // Turns too small for doubles, and too large.
    {{0, 0}, {0x1p-600, 0x1p-600}, {0x1p-600, 0x1.8p-600}, false},
    {{0, 0}, {0x1p-600, 0x1p-600}, {0x1p-601, 0x1p-601}, true},
    {{0, 0}, {0x1p-600, 0}, {0x1p-601, 0}, true},
    {{0, 0}, {0x1p600, 0x1p600}, {0x1p600, 0x1.8p600}, false},
    // Equal when rounded: (1 + e)(1 - e) is 1 - e * e.
    {{0, 0}, {1 + 0x1p-30, 1}, {1, 1 - 0x1p-30}, false},
};

TEST(same_direction)
{
    const example *given = &examples[_i];
    check_input("v: %s, a: %s, c: %s", text_point(2, given->v),
                text_point(2, given->a), text_point(2, given->c));
    bool got;
    check_value(got, lie_upon_each_other(given->v, given->a, given->c));
    check_bool(given->expected, got);
}

void run_tests(void)
{
    check_run(sizeof examples / sizeof *examples, same_direction);
}
