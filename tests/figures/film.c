// The figures that move: what is the same in all frames, and the time.
#define _POSIX_C_SOURCE 200809L // open_memstream

#include "kit/film.h"
#include "figures/pages.h"
#include "support/support.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    TIMES = 9,
    WIDTH = 48,
    HEIGHT = 36
};

static fig_page_options options_at(double t)
{
    return (fig_page_options){
        .pixels_x = WIDTH, .pixels_y = HEIGHT, .moves = true, .time = t};
}

/// A frame, of which labels have their places.
static fig_page *draw_frame(const fig_figure *figure, double t)
{
    uint32_t pixels[WIDTH * HEIGHT];
    fig_page *page = draw_figure(figure, options_at(t), NULL);
    ck_assert_int_eq(fig_page_paint(page, pixels), FIG_OK);
    return page;
}

/// Expect that labels of two frames with the same anchor have the same place.
static void expect_same_places(const fig_figure *figure, const fig_page *a,
                               const fig_page *b, double t)
{
    for (int i = 0; i < fig_page_labels(a); i++)
        for (int j = 0; j < fig_page_labels(b); j++) {
            fig_placed first = fig_page_placed(a, i);
            fig_placed second = fig_page_placed(b, j);
            if (memcmp(&first.anchor, &second.anchor, sizeof first.anchor) != 0)
                continue;
            ck_assert_msg(memcmp(&first.box, &second.box, sizeof first.box) ==
                              0,
                          "%s: label %d jumps at t = %g", figure->name, i, t);
        }
}

START_TEST(labels_do_not_jump)
{
    const fig_figure *figure = fig_figures[_i];
    fig_page *first = figure->moves ? draw_frame(figure, 0) : NULL;
    for (int i = 1; i < TIMES && figure->moves; i++) {
        double t = i / (TIMES - 1.0);
        fig_page *page = draw_frame(figure, t);
        expect_same_places(figure, first, page, t);
        fig_page_free(page);
    }
    fig_page_free(first);
}
END_TEST

START_TEST(one_frame_is_at_the_event)
{
    char *text = NULL;
    size_t size;
    FILE *numbers = open_memstream(&text, &size);
    const double event = 0.3;
    int hits = 0;
    for (int i = 0; i < FIG_FILM_FRAMES; i++) {
        double t = i / (FIG_FILM_FRAMES - 1.0);
        fig_page *page = draw_figure(fig_figures[0], options_at(t), NULL);
        double shown = fig_film_time(page, numbers, 0.5, event);
        ck_assert_msg(shown == t || shown == event, "%g for %g", shown, t);
        ck_assert_double_le(fabs(shown - t), 0.5 / (FIG_FILM_FRAMES - 1));
        hits += shown == event;
        fig_page_free(page);
    }
    ck_assert_int_eq(hits, 1);
    fclose(numbers);
    ck_assert_int_eq(strncmp(text, "film_still 0.5\n", 15), 0);
    free(text);
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_create("figures/film");
    TCase *films = tcase_create("films");
    tcase_add_loop_test(films, labels_do_not_jump, 0, count_figures());
    tcase_add_test(films, one_frame_is_at_the_event);
    suite_add_tcase(s, films);
    return s;
}
