// A fold is relaxed until it is clear, and goes home.
#include "kit/figures.h"
#include "kit/film.h"
#include "kit/journeys.h"
#include "renderer/plot.h"

static void draw(fig_page *page, FILE *numbers)
{
    const fig_journey *all = fig_journey_of("fold", TF_RUNG_SMOOTH);
    double t = fig_film_time(page, numbers, 0.39, -1);
    double height = fig_page_height(page);
    fig_journey_draw(page, (fig_box){0, 2, 168, height - 4}, all, t);
    fig_journey_plot(page, (fig_box){270, 14, 106, height - 14 - FIG_PLOT_ROOM},
                     all, t, "rounds, steps");
    fig_number(numbers, "before", (double)all->crossings);
    fig_number(numbers, "rounds", all->rounds[all->found]);
    fig_number(numbers, "found", all->away[all->found]);
    fig_number(numbers, "home", all->away[all->states - 1]);
    fig_number(numbers, "steps", all->states - 1 - all->found);
}

const fig_figure fig_relaxed_fold = {
    .name = "relaxed-fold",
    .title = "A fold is relaxed, and goes home",
    .width = FIG_PAGE_WIDTH,
    .height = 130,
    .moves = true,
    .draw = draw,
};
