// How the crossings of some tangles become fewer, round by round.
#include "kit/figures.h"
#include "kit/untangled.h"
#include "renderer/plot.h"

enum {
    TANGLES = 4
};

static const struct {
    const char *name, *key;
    fig_role role;
} shown[TANGLES] = {
    {"cloth and ball", "cloth", FIG_ROLE_CONTACT},
    {"bump", "bump", FIG_ROLE_EDGE},
    {"half way in", "half", FIG_ROLE_TRIANGLE},
    {"loop", "loop", FIG_ROLE_POINT},
};

/// The crossings after some rounds of all that there were.
static fig_point point_of(const fig_untangling *all, int state)
{
    return (fig_point){all->rounds[state],
                       100. * (double)all->state[state].report.left /
                           (double)all->state[0].report.left};
}

static void draw_tangle(fig_page *page, const fig_plot *plot, int i,
                        const fig_untangling *all)
{
    fig_point curve[FIG_UNTANGLING_STATES];
    for (int state = 0; state < all->states; state++) {
        curve[state] = point_of(all, state);
        fig_plot_dot(page, plot, curve[state].x, curve[state].y, 3,
                     shown[i].role);
    }
    fig_plot_curve(page, plot, all->states, curve,
                   (fig_stroke){.paint = {.role = shown[i].role}});
    fig_plot_key(page, plot->box.x + plot->box.width + 14,
                 plot->box.y + 14 + 16 * i, shown[i].name, shown[i].role);
}

static void print_number(FILE *numbers, int i, const char *what, double value)
{
    char key[32];
    snprintf(key, sizeof key, "%s_%s", what, shown[i].key);
    fig_number(numbers, key, value);
}

static void draw(fig_page *page, FILE *numbers)
{
    const fig_untangling *all[TANGLES];
    int most = 0;
    for (int i = 0; i < TANGLES; i++) {
        all[i] = fig_untangling_of(shown[i].name);
        int rounds = all[i]->rounds[all[i]->states - 1];
        most = rounds > most ? rounds : most;
        print_number(numbers, i, "before",
                     (double)all[i]->state[0].report.left);
        print_number(numbers, i, "rounds", rounds);
        print_number(numbers, i, "left",
                     (double)all[i]->state[all[i]->states - 1].report.left);
    }
    fig_plot plot = {.box = {48, 10, 226, 116},
                     .x = {0, most},
                     .y = {0, 100},
                     .name_x = "rounds",
                     .name_y = "crossings left, %"};
    fig_plot_frame(page, &plot);
    for (int i = 0; i < TANGLES; i++)
        draw_tangle(page, &plot, i, all[i]);
}

const fig_figure fig_untangling_rounds = {
    .name = "untangling-rounds",
    .title = "Crossings that are left, round by round",
    .width = FIG_PAGE_WIDTH,
    .height = 162,
    .draw = draw,
};
