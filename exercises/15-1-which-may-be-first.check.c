#include "check.h"

#include "support/support.h"
#include "surface/detect.h"

#include <stdio.h>
#include <string.h>

enum {
    MOST = 12
};

size_t may_be_first(size_t count, const tf_surface_contact row[],
                    size_t place[]);

/// Whether a row may be the first: no other row is certainly earlier.
static bool may_be(size_t count, const tf_surface_contact row[], size_t i)
{
    for (size_t j = 0; j < count; j++)
        if (row[j].contact.toi_hi < row[i].contact.toi_lo)
            return false;
    return true;
}

static void list(char text[], size_t size, size_t count, const size_t place[])
{
    snprintf(text, size, count == 0 ? "none" : "");
    for (size_t i = 0; i < count; i++) {
        size_t length = strlen(text);
        snprintf(text + length, size - length, "%s%zu", i ? ", " : "",
                 place[i]);
    }
}

static void expect(size_t count, const double lo[], const double hi[])
{
    tf_surface_contact row[MOST] = {{0}};
    char input[512] = "no rows", wanted[128], got[128];
    size_t right[MOST], place[MOST + 1] = {0}, rights = 0, length = 0;
    for (size_t i = 0; i < count; i++) {
        row[i].kind = TF_EDGE_EDGE;
        row[i].contact.toi_lo = lo[i];
        row[i].contact.toi_hi = hi[i];
        length += (size_t)snprintf(input + length, sizeof input - length,
                                   "%srow %zu: [%g, %g]", i ? ", " : "", i,
                                   lo[i], hi[i]);
    }
    for (size_t i = 0; i < count; i++)
        if (may_be(count, row, i))
            right[rights++] = i;
    list(wanted, sizeof wanted, rights, right);
    check_input("%s", input);
    size_t found;
    check_value(found, may_be_first(count, row, place));
    check_also(place);
    check_that(found <= count, wanted, "%zu rows of %zu", found, count);
    list(got, sizeof got, found, place);
    check_that(found == rights &&
                   memcmp(place, right, sizeof *place * rights) == 0,
               wanted, "%s", got);
}

TEST(no_contact)
{
    expect(0, NULL, NULL);
}

TEST(a_long_interval_before_a_short_one)
{
    expect(3, (const double[]){0.1, 0.2, 0.35},
           (const double[]){0.4, 0.3, 0.5});
}

TEST(intervals_with_a_common_end)
{
    expect(2, (const double[]){0.5, 0.25}, (const double[]){0.75, 0.5});
}

TEST(contacts_at_the_end)
{
    expect(2, (const double[]){1, 1}, (const double[]){1, 1});
}

TEST(any_intervals)
{
    generator random = generator_new(0);
    for (int i = 0; i < 500; i++) {
        size_t count = 1 + (size_t)below(&random, MOST);
        double lo[MOST], hi[MOST];
        for (size_t j = 0; j < count; j++) {
            lo[j] = below(&random, 24) / 32.0;
            hi[j] = lo[j] + below(&random, 9) / 32.0;
        }
        expect(count, lo, hi);
    }
}

void run_tests(void)
{
    check_run(1, no_contact);
    check_run(1, a_long_interval_before_a_short_one);
    check_run(1, intervals_with_a_common_end);
    check_run(1, contacts_at_the_end);
    check_run(1, any_intervals);
}
