#include "check.h"

#include "arithmetic/exact.h"
#include "query/query.h"
#include "support/support.h"

#include <math.h>
#include <string.h>

int halve(const double start[6], double end[6]);

static bool touch(const double start[6], const double end[6])
{
    tf_worldline line[3];
    for (int v = 0; v < 3; v++)
        line[v] = tf_worldline_between(2, start + 2 * v, end + 2 * v);
    tf_contact contact;
    tf_query(&tf_exact, 2, 1, line, 2, line + 1, &contact);
    return contact.verdict == TF_HIT;
}

static void tell(const double start[6], const double end[6])
{
    check_input("point: %s -> %s\nedge: %s -> %s, %s -> %s",
                text_point(2, start), text_point(2, end),
                text_point(2, start + 2), text_point(2, end + 2),
                text_point(2, start + 4), text_point(2, end + 4));
}

/// Expects the k for which the step scaled by 2^-k is the first that is clear.
static void expect(const double start[6], const double proposed[6])
{
    double expected[6], end[6];
    memcpy(expected, proposed, sizeof expected);
    int k = 0;
    while (touch(start, expected)) {
        k++;
        for (int i = 0; i < 6; i++)
            expected[i] = start[i] + ldexp(proposed[i] - start[i], -k);
    }
    if (memcmp(start, expected, sizeof expected) == 0)
        k = -1;
    memcpy(end, proposed, sizeof end);
    tell(start, proposed);
    double got;
    check_value(got, halve(start, end));
    check_also(end);
    check_real(k, got);
    for (int i = 0; i < 6; i++)
        check_real(expected[i], end[i]);
}

TEST(of_the_chapter)
{
    // The time of impact is 0.7, and half the step has a contact.
    expect((double[]){0.5, 0.2, 1, 0, 0, 0}, (double[]){0.5, 0.2, 1, 1, 0, 0});
}

TEST(nothing_in_the_way)
{
    expect((double[]){0, 2, -1, 0, 1, 0}, (double[]){0, 1, -1, 0, 1, 0});
}

TEST(a_point_that_falls_far)
{
    expect((double[]){0, 1, -1, 0, 1, 0}, (double[]){0, -99, -1, 0, 1, 0});
    expect((double[]){0, 0.1, -1, 0, 1, 0}, (double[]){0, -0.7, -1, 0, 1, 0});
}

TEST(no_room)
{
    // One unit in the last place above the edge, and moving by little more.
    double above = nextafter(1, 2);
    expect((double[]){0, above, -1, 1, 1, 1},
           (double[]){0, 1 - 0x1p-51, -1, 1, 1, 1});
}

TEST(at_random)
{
    generator random = generator_new(0);
    for (int i = 0; i < 400; i++) {
        double start[6], end[6];
        for (int k = 0; k < 6; k++) {
            start[k] = uniform(&random, 0, 1);
            end[k] = start[k] + uniform(&random, -9, 9);
        }
        expect(start, end);
    }
}

void run_tests(void)
{
    check_run(1, of_the_chapter);
    check_run(1, nothing_in_the_way);
    check_run(1, a_point_that_falls_far);
    check_run(1, no_room);
    check_run(1, at_random);
}
