// Six balls jump apart, and go home.
#include "kit/figures.h"
#include "kit/film.h"
#include "kit/journeys.h"
#include "renderer/plot.h"

static void draw(fig_page *page, FILE *numbers)
{
    const fig_journey *all = fig_journey_of("six balls", TF_RUNG_APART);
    double t = fig_film_time(page, numbers, 0.16, -1);
    double height = fig_page_height(page);
    fig_journey_draw(page, (fig_box){0, 2, 180, height - 4}, all, t);
    fig_journey_plot(page, (fig_box){270, 14, 106, height - 14 - FIG_PLOT_ROOM},
                     all, t, "jump, and steps");
    fig_number(numbers, "before", (double)all->crossings);
    fig_number(numbers, "found", all->away[all->found]);
    fig_number(numbers, "home", all->away[all->states - 1]);
    fig_number(numbers, "steps", all->states - 1 - all->found);
}

const fig_figure fig_balls_apart = {
    .name = "balls-apart",
    .title = "Six balls jump apart, and go home",
    .width = FIG_PAGE_WIDTH,
    .height = 98,
    .moves = true,
    .draw = draw,
};
