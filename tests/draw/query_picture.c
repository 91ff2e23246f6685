#include "draw/query_picture.h"
#include "arithmetic/exact.h"
#include "support/picture_folder.h"
#include "support/queries.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/// Answer a query as the command does.
static fig_answered answered_of(const query *q)
{
    fig_answered answered = {
        .kind = tf_choice_named(tf_query_kinds, query_name(q))};
    memcpy(answered.vertex, q->vertex, sizeof q->vertex);
    ck_assert_int_eq(tf_query(&tf_exact, q->axes, q->vertices, q->vertex,
                              q->others, query_const_others(q),
                              &answered.contact),
                     TF_OK);
    return answered;
}

/// Draw an answered query, as a still picture (t < 0) or in a film; expect that
/// no coordinate is found odd and that all labels are on the page.  Returns how
/// many there are.
static int expect_drawing(const query *q, const fig_answered *answered,
                          double t)
{
    fig_drawing drawing = fig_query_drawing(answered);
    fig_page_options options = {.width = drawing.width,
                                .height = drawing.height,
                                .pixels_x = 32,
                                .pixels_y = 24,
                                .moves = t >= 0,
                                .time = fmax(t, 0)};
    fig_page *page;
    FILE *numbers = fopen("/dev/null", "w");
    ck_assert_int_eq(fig_page_new(&options, &page), FIG_OK);
    drawing.draw(drawing.subject, page, numbers);
    fig_status status = fig_page_write(page, picture_path());
    ck_assert_msg(status == FIG_OK, "%s\n%s", fig_status_message(status),
                  query_text(q));
    for (int i = 0; i < fig_page_labels(page); i++) {
        fig_box box = fig_page_placed(page, i).box;
        ck_assert_msg(box.x >= 0 && box.y >= 0 &&
                          box.x + box.width <= drawing.width &&
                          box.y + box.height <= drawing.height,
                      "label %d leaves the page\n%s", i, query_text(q));
    }
    int labels = fig_page_labels(page);
    fig_page_free(page);
    fclose(numbers);
    return labels;
}

static void expect_picture(const query *q, double t)
{
    fig_answered answered = answered_of(q);
    expect_drawing(q, &answered, t);
}

// Tests, by kind of query -----------------------------------------------------

START_TEST(everything_in_one_point_is_drawn)
{
    query q = query_new((query_kind)_i);
    for (int i = 0; i < query_size(&q); i++)
        *query_coordinate(&q, i) = 1e300;
    expect_picture(&q, -1);
    expect_picture(&q, 0.5);
}
END_TEST

START_TEST(lattice_queries_are_drawn)
{
    generator random = generator_new(10 + (uint64_t)_i);
    for (long n = cases(10); n > 0; n--) {
        query q = query_lattice(&random, (query_kind)_i, 2);
        expect_picture(&q, -1);
        expect_picture(&q, uniform(&random, 0, 1));
    }
}
END_TEST

START_TEST(hard_queries_are_drawn)
{
    generator random = generator_new(20 + (uint64_t)_i);
    for (long n = cases(10); n > 0; n--) {
        query q = query_any(&random, (query_kind)_i);
        query_scale(&q, below(&random, q.axes), 600 - below(&random, 1200));
        expect_picture(&q, -1);
    }
}
END_TEST

START_TEST(extreme_queries_are_drawn)
{
    generator random = generator_new(30 + (uint64_t)_i);
    for (long n = cases(10); n > 0; n--) {
        query q = query_extreme(&random, (query_kind)_i);
        expect_picture(&q, n % 2 == 0 ? -1 : uniform(&random, 0, 1));
    }
}
END_TEST

/// All vertices are named at any time; the table finds no number odd.
START_TEST(queries_are_drawn_at_one_time)
{
    generator random = generator_new(40 + (uint64_t)_i);
    for (long n = cases(10); n > 0; n--) {
        query q = n % 2 == 0 ? query_lattice(&random, (query_kind)_i, 2)
                             : query_extreme(&random, (query_kind)_i);
        fig_answered answered = answered_of(&q);
        int in_film = expect_drawing(&q, &answered, 0.5);
        answered.still = true;
        answered.time = 0.5;
        int vertices = answered.kind->axes == 2 ? 0 : q.vertices + q.others;
        ck_assert_int_eq(expect_drawing(&q, &answered, -1), in_film + vertices);
        answered.coordinates = true;
        ck_assert_int_ge(expect_drawing(&q, &answered, -1), in_film + vertices);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_create("draw/query_picture");
    TCase *drawn = tcase_create("drawn");
    tcase_add_checked_fixture(drawn, make_picture_folder,
                              remove_picture_folder);
    tcase_add_loop_test(drawn, everything_in_one_point_is_drawn, 0, KINDS);
    tcase_add_loop_test(drawn, lattice_queries_are_drawn, 0, KINDS);
    tcase_add_loop_test(drawn, hard_queries_are_drawn, 0, KINDS);
    tcase_add_loop_test(drawn, extreme_queries_are_drawn, 0, KINDS);
    tcase_add_loop_test(drawn, queries_are_drawn_at_one_time, 0, KINDS);
    suite_add_tcase(s, drawn);
    return s;
}
