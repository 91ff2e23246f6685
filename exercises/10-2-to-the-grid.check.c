#include "check.h"

#include "support/support.h"

#include <math.h>
#include <stdio.h>

bool snap(double cell, int bits, const double place[3], double snapped[3]);

/// The nearest integer, halves away from zero: the lower neighbor or the upper
/// one.  The differences between x and its neighbors are exact.
static double nearest(double x)
{
    double low = floor(x), high = ceil(x);
    if (x - low == high - x)
        return x < 0 ? low : high;
    return x - low < high - x ? low : high;
}

static void expect(double cell, int bits, const double place[3])
{
    double expected[3], got[3] = {NAN, NAN, NAN};
    bool inside = true;
    for (int k = 0; k < 3; k++) {
        expected[k] = nearest(place[k] / cell);
        inside &= fabs(expected[k]) <= ldexp(1, bits) - 1;
    }
    check_input("cell = %s, bits = %d, place = %s", text_real(cell), bits,
                text_point(3, place));
    bool answer;
    check_value(answer, snap(cell, bits, place, got));
    check_also(got);
    check_bool(inside, answer);
    if (inside)
        check_point(3, expected, got, 0);
}

TEST(places_between)
{
    expect(1, 19, (double[]){0.25, 0.75, -0.75});
    expect(0.25, 19, (double[]){10.0625, -10.0625, 3});
    expect(4, 19, (double[]){5, 7, -7});
}

TEST(places_in_the_middle)
{
    expect(1, 19, (double[]){0.5, -0.5, 1.5});
    expect(1, 19, (double[]){2.5, -2.5, -1.5});
    expect(1, 19, (double[]){0x1.fffffffffffffp-2, -0x1.fffffffffffffp-2, 0});
    expect(1, 53, (double[]){0x1.0000000000001p52, -0x1.0000000000001p52, 0});
}

TEST(ends_of_the_range)
{
    for (int bits = 1; bits <= 53; bits++)
        for (int quarter = -4; quarter <= 4; quarter++)
            for (int k = 0; k < 3; k++) {
                double place[3] = {0, 0, 0};
                place[k] =
                    (k == 1 ? -1 : 1) * (ldexp(1, bits) + 0.25 * quarter);
                expect(1, bits, place);
            }
    expect(1, 19, (double[]){0, 1e300, 0});
}

TEST(any_place)
{
    generator random = generator_new(0);
    for (int i = 0; i < 2000; i++) {
        double place[3], cell = ldexp(1, below(&random, 20) - 10);
        for (int k = 0; k < 3; k++)
            place[k] = cell * uniform(&random, -300, 300);
        expect(cell, 8, place);
    }
}

void run_tests(void)
{
    check_run(1, places_between);
    check_run(1, places_in_the_middle);
    check_run(1, ends_of_the_range);
    check_run(1, any_place);
}
