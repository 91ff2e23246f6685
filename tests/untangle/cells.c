// A grid of cells misses no boxes that overlap.
#include "untangle/cells.h"

#include "support/generator.h"
#include "support/support.h"
#include "support/tangles.h"

enum {
    BOXES = 12,
    ASKED = 400
};

static made_tangle own;
static tf_cells cells;
static tf_cell_box box[BOXES];

static tf_cell_box random_box(generator *random, int axes, double length)
{
    tf_cell_box made = {.low = {0, 0, 0}};
    for (int k = 0; k < axes; k++) {
        made.low[k] = uniform(random, -1, 9);
        made.high[k] = made.low[k] + uniform(random, 0, length);
    }
    return made;
}

static void begin(generator *random, int axes, int most)
{
    double up[3] = {0, 1, 0};
    tangle_begin(&own, axes);
    if (axes == 3)
        tangle_add_sheet(&own, 9, (double[]){1, 0, 0.5}, up,
                         (double[]){0, 0, 0});
    else {
        tangle_add(&own, 4, (double[]){0, 0, 8, 1, 3, 8, 1, 2});
        tangle_add_edge(&own, 0, 1);
        tangle_add_edge(&own, 2, 3);
    }
    tangle_finish(&own);
    ck_assert(tf_cells_begin(&cells, &own.tangle.near, own.x, 0.5, most));
    for (int i = 0; i < BOXES; i++) {
        box[i] = random_box(random, axes, 2);
        tf_cells_add(&cells, &box[i]);
    }
    tf_cells_sum(&cells);
}

static void release(void)
{
    tf_cells_free(&cells);
    tangle_free(&own);
    cells = (tf_cells){.sum = NULL};
}

/// The cell of a coordinate, found by stepping.
static int cell_at(int axis, double coordinate)
{
    int cell = 0;
    while (cell + 1 < cells.count[axis] &&
           (coordinate - cells.low[axis]) / cells.size >= cell + 1)
        cell++;
    return cell;
}

static bool reaches(const tf_cell_box *some, const int cell[3])
{
    for (int k = 0; k < 3; k++)
        if (cell[k] < cell_at(k, some->low[k]) ||
            cell[k] > cell_at(k, some->high[k]))
            return false;
    return true;
}

static bool is_filled(const int cell[3])
{
    for (int i = 0; i < BOXES; i++)
        if (reaches(&box[i], cell))
            return true;
    return false;
}

/// Asks about a box, and looks at each cell.
static void compare(const tf_cell_box *asked)
{
    int all = 0, filled = 0, cell[3];
    for (cell[0] = 0; cell[0] < cells.count[0]; cell[0]++)
        for (cell[1] = 0; cell[1] < cells.count[1]; cell[1]++)
            for (cell[2] = 0; cell[2] < cells.count[2]; cell[2]++)
                if (reaches(asked, cell)) {
                    all++;
                    filled += is_filled(cell);
                }
    ck_assert_int_eq(tf_cells_touch(&cells, asked), filled > 0);
    ck_assert_int_eq(tf_cells_cover(&cells, asked), filled == all);
}

START_TEST(cells_answer_as_looking_at_each_does)
{
    generator random = generator_new(11);
    for (int trial = 0; trial < 6; trial++) {
        begin(&random, 2 + trial % 2, trial < 4 ? 400 : 60);
        for (int i = 0; i < ASKED; i++) {
            tf_cell_box asked = random_box(&random, 2 + trial % 2, 1);
            compare(&asked);
        }
        release();
    }
}
END_TEST

START_TEST(boxes_that_overlap_touch)
{
    generator random = generator_new(12);
    begin(&random, 3, 1000);
    for (int i = 0; i < BOXES; i++) {
        tf_cell_box corner = box[i];
        ck_assert(tf_cells_cover(&cells, &corner));
        for (int k = 0; k < 3; k++)
            corner.low[k] = corner.high[k];
        ck_assert(tf_cells_touch(&cells, &corner));
    }
    release();
}
END_TEST

START_TEST(there_are_not_too_many_cells)
{
    generator random = generator_new(13);
    for (int most = 1; most < 300; most += 37) {
        begin(&random, 3, most);
        ck_assert_int_le(cells.count[0] * cells.count[1] * cells.count[2],
                         most);
        ck_assert_double_ge(cells.size, 0.5);
        release();
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("untangle/cells");
    TCase *tcase = tcase_create("cells");
    tcase_add_test(tcase, cells_answer_as_looking_at_each_does);
    tcase_add_test(tcase, boxes_that_overlap_touch);
    tcase_add_test(tcase, there_are_not_too_many_cells);
    suite_add_tcase(suite, tcase);
    return suite;
}
