#include "renderer/placement.h"

#include "support/support.h"

#include <math.h>

static const fig_box page = {0, 0, 400, 300};

static fig_wish wish_at(double x, double y)
{
    return (fig_wish){.anchor = {x, y},
                      .width = 20,
                      .height = 10,
                      .any_side = true,
                      .gap = 3,
                      .reach = 40,
                      .distance_cost = 1};
}

static bool lies_in(const fig_box *box)
{
    return box->x >= page.x && box->y >= page.y &&
           box->x + box->width <= page.x + page.width &&
           box->y + box->height <= page.y + page.height;
}

START_TEST(a_label_alone_is_placed_where_asked)
{
    const double middle[8][2] = {{1, 0},  {1, -1}, {0, -1}, {-1, -1},
                                 {-1, 0}, {-1, 1}, {0, 1},  {1, 1}};
    fig_wish wish = wish_at(200, 150);
    wish.any_side = false;
    wish.direction = _i * 0.7853981633974483;
    fig_box box;
    ck_assert(fig_place(page, 1, &wish, 0, NULL, 0, NULL, &box));
    double x = box.x + 10 - 200, y = box.y + 5 - 150;
    ck_assert_double_ge(x * middle[_i][0] + y * middle[_i][1], 7.9);
    double off_x = fmax(fabs(x) - 10, 0), off_y = fmax(fabs(y) - 5, 0);
    ck_assert_double_eq_tol(hypot(off_x, off_y), 3, 1e-3);
}
END_TEST

START_TEST(labels_stay_inside_the_page)
{
    const double corner[4][2] = {{1, 1}, {399, 1}, {1, 299}, {399, 299}};
    fig_wish wish = wish_at(corner[_i][0], corner[_i][1]);
    fig_box box;
    ck_assert(fig_place(page, 1, &wish, 0, NULL, 0, NULL, &box));
    ck_assert(lies_in(&box));
}
END_TEST

START_TEST(crowded_labels_are_disjoint)
{
    enum {
        COUNT = 14
    };
    generator random = generator_new((uint64_t)_i);
    fig_wish wishes[COUNT];
    fig_box boxes[COUNT], taken = {150, 140, 40, 20};
    for (int i = 0; i < COUNT; i++)
        wishes[i] =
            wish_at(uniform(&random, 120, 280), uniform(&random, 80, 220));
    ck_assert(fig_place(page, COUNT, wishes, 1, &taken, 0, NULL, boxes));
    for (int i = 0; i < COUNT; i++) {
        ck_assert(lies_in(&boxes[i]));
        ck_assert_double_eq(fig_box_overlap(&boxes[i], &taken), 0);
        for (int j = 0; j < i; j++)
            ck_assert_msg(fig_box_overlap(&boxes[i], &boxes[j]) == 0,
                          "labels %d and %d of seed %d", i, j, _i);
    }
}
END_TEST

START_TEST(labels_avoid_lines)
{
    // A wall to the right of the anchor.
    fig_obstacle wall = {{215, 0}, {215, 300}, 1, 5};
    fig_wish wish = wish_at(200, 150);
    wish.any_side = false;
    fig_box box;
    ck_assert(fig_place(page, 1, &wish, 0, NULL, 1, &wall, &box));
    ck_assert(box.x + box.width < 214 || box.x > 216);
}
END_TEST

Suite *suite(void)
{
    Suite *made = suite_create("renderer/placement");
    TCase *tests = tcase_create("placement");
    suite_add_tcase(made, tests);
    tcase_add_loop_test(tests, a_label_alone_is_placed_where_asked, 0, 8);
    tcase_add_loop_test(tests, labels_stay_inside_the_page, 0, 4);
    tcase_add_loop_test(tests, crowded_labels_are_disjoint, 0, 20);
    tcase_add_test(tests, labels_avoid_lines);
    return made;
}
