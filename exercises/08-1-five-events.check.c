#include "check.h"

#include "arithmetic/sign.h"
#include "geometry/event.h"
#include "support/support.h"

#include <stdio.h>
#include <string.h>

tf_sign orientation(const tf_event event[5]);

/// The determinant of the rows from `row` on, in the columns not yet taken.
static double determinant(double m[5][5], int row, bool taken[5])
{
    if (row == 5)
        return 1;
    double sum = 0, sign = 1;
    for (int j = 0; j < 5; j++) {
        if (taken[j])
            continue;
        taken[j] = true;
        sum += sign * m[row][j] * determinant(m, row + 1, taken);
        taken[j] = false;
        sign = -sign;
    }
    return sum;
}

static tf_sign expected_sign(const tf_event event[5])
{
    double m[5][5];
    for (int i = 0; i < 5; i++) {
        for (int k = 0; k < 3; k++)
            m[i][k] = event[i].x[k];
        m[i][3] = event[i].t;
        m[i][4] = 1;
    }
    bool taken[5] = {false};
    double value = determinant(m, 0, taken);
    return (tf_sign)((value > 0) - (value < 0));
}

static void expect(const tf_event event[5])
{
    char text[400] = "";
    for (int i = 0; i < 5; i++)
        snprintf(text + strlen(text), sizeof text - strlen(text),
                 "%sevent %d: %s at t = %d", i == 0 ? "" : "\n", i,
                 text_point(3, event[i].x), event[i].t);
    check_input("%s", text);
    tf_sign expected = expected_sign(event), got;
    check_value(got, orientation(event));
    check_that(got == expected, text_sign(expected), "%s", text_sign(got));
}

TEST(one_event_late)
{
    expect((const tf_event[5]){{.x = {1, 0, 0}},
                               {.x = {0, 1, 0}},
                               {.x = {0, 0, 1}},
                               {.x = {2, 2, 2}, .t = 1},
                               {.x = {0, 0, 0}}});
}

TEST(events_of_any_times)
{
    generator random = generator_new(0);
    for (int i = 0; i < 500; i++) {
        tf_event event[5];
        for (int j = 0; j < 5; j++) {
            event[j].t = below(&random, 2);
            for (int k = 0; k < 3; k++)
                event[j].x[k] = below(&random, 9) - 4;
        }
        expect(event);
    }
}

void run_tests(void)
{
    check_run(1, one_event_late);
    check_run(1, events_of_any_times);
}
