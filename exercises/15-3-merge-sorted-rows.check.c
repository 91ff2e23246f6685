#include "check.h"

#include "support/support.h"
#include "surface/detect.h"

#include <string.h>

enum {
    WORKERS = 8,
    MOST = 200
};

void merge_rows(int workers, const size_t count[],
                const tf_surface_contact *const row[],
                tf_surface_contact merged[]);

/// The i-th of some rows in order: many that differ late, or in the kind alone.
static tf_surface_contact row_at(int i)
{
    tf_surface_contact row;
    memset(&row, 0, sizeof row);
    row.kind = i < MOST / 2 ? TF_POINT_TRIANGLE : TF_EDGE_EDGE;
    int place = i % (MOST / 2);
    row.vertex[0] = place / 25;
    row.vertex[1] = 30 + place / 5 % 5;
    row.vertex[2] = 40;
    row.vertex[3] = 50 + place % 5;
    row.contact.verdict = TF_HIT;
    row.contact.toi_lo = 1.0 / (1 + i);
    row.contact.toi_hi = 1;
    return row;
}

/// Gives the rows to workers at random, and expects them back.
static void expect(generator *random, int rows, int workers)
{
    static tf_surface_contact given[WORKERS][MOST], merged[MOST + 1];
    const tf_surface_contact *row[WORKERS];
    size_t count[WORKERS] = {0};
    for (int i = 0; i < workers; i++)
        row[i] = given[i];
    for (int i = 0; i < rows; i++) {
        int worker = below(random, workers);
        given[worker][count[worker]++] = row_at(i);
    }
    memset(merged, 0, sizeof merged);
    check_input("%d rows of %d workers, of which the first has %zu", rows,
                workers, count[0]);
    check_call(merged, merge_rows(workers, count, row, merged));
    for (int i = 0; i < rows; i++) {
        tf_surface_contact right = row_at(i);
        check_that(
            memcmp(&merged[i], &right, sizeof right) == 0, "the rows in order",
            "kind %d, vertices %d %d %d %d in place %d", (int)merged[i].kind,
            merged[i].vertex[0], merged[i].vertex[1], merged[i].vertex[2],
            merged[i].vertex[3], i);
    }
    check_that(merged[rows].kind == TF_NO_KIND, "no more rows", "another one");
}

TEST(no_rows)
{
    generator random = generator_new(0);
    expect(&random, 0, 3);
}

TEST(rows_of_one_worker)
{
    generator random = generator_new(1);
    expect(&random, 20, 1);
}

TEST(rows_of_several_workers)
{
    generator random = generator_new(2);
    for (int i = 0; i < 100; i++)
        expect(&random, 1 + below(&random, MOST), 1 + below(&random, WORKERS));
}

void run_tests(void)
{
    check_run(1, no_rows);
    check_run(1, rows_of_one_worker);
    check_run(1, rows_of_several_workers);
}
