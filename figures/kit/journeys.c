#include "kit/journeys.h"

#include "base/require.h"
#include "kit/tangle_picture.h"
#include "renderer/plot.h"
#include "response/resolve.h"
#include "untangle/apart.h"
#include "untangle/smooth.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    RELAX_ROUNDS = 4000,
    STEPS = 40,
    FAILURES = 3
};

/// What a journey needs of the library.
typedef struct travel {
    fig_journey *all;
    tf_surface *surface;
    tf_resolver *resolver;
    tf_tangle tangle;
    size_t numbers;
    double *x;
} travel;

static double squares(const travel *own, const double x[])
{
    double sum = 0;
    for (size_t i = 0; i < own->numbers; i++)
        sum += (x[i] - own->tangle.in[i]) * (x[i] - own->tangle.in[i]);
    return sum;
}

static void add_state(travel *own, int rounds)
{
    fig_journey *all = own->all;
    TF_REQUIRE(all->states < FIG_JOURNEY_STATES);
    double *x = malloc(own->numbers * sizeof *x);
    TF_REQUIRE(x);
    memcpy(x, own->x, own->numbers * sizeof *x);
    all->x[all->states] = x;
    all->rounds[all->states] = rounds;
    all->away[all->states++] =
        sqrt(3 * squares(own, x) / (double)own->numbers) / own->tangle.edge;
}

/// How many crossings there are now.
static size_t check(travel *own)
{
    TF_REQUIRE(tf_tangle_check(&own->tangle, own->x) == TF_OK);
    return own->tangle.crossings.count;
}

// Away -------------------------------------------------------------------------

static int next_kept(int rounds)
{
    return rounds + 1 + rounds / 4;
}

/// Smooths everything until it is clear; returns after how many rounds.
static int relax(travel *own)
{
    tf_change change = {.storage = {0}};
    int rounds = 0, kept = next_kept(0);
    while (check(own) > 0) {
        if (rounds == kept) {
            add_state(own, rounds);
            kept = next_kept(kept);
        }
        TF_REQUIRE(rounds++ < RELAX_ROUNDS);
        TF_REQUIRE(tf_change_begin(&change, &own->tangle));
        TF_REQUIRE(tf_smooth(&change, &own->tangle, own->x, INT_MAX));
        for (size_t i = 0; i < own->numbers; i++)
            own->x[i] += change.move[i / 3].x[i % 3];
    }
    tf_change_free(&change);
    return rounds;
}

static int move_apart(travel *own)
{
    bool moved;
    TF_REQUIRE(tf_move_apart(&own->tangle, own->x, &moved) && moved);
    TF_REQUIRE(check(own) == 0);
    return 1;
}

// Home -------------------------------------------------------------------------

/// Takes a part of the way, and returns by which part the sum of squares falls;
/// 0: it doesn't, and nothing is moved.
static double step_home(travel *own, double part, double end[])
{
    tf_response_options options = {.size = sizeof options};
    const double *in = own->tangle.in;
    double before = squares(own, own->x);
    for (size_t i = 0; i < own->numbers; i++)
        end[i] = own->x[i] + part * (in[i] - own->x[i]);
    TF_REQUIRE(tf_step_resolve(own->resolver, own->tangle.near.vertices, own->x,
                               end, NULL, &options, NULL, NULL) == TF_OK);
    double after = squares(own, end);
    if (after >= before)
        return 0;
    memcpy(own->x, end, own->numbers * sizeof *end);
    return 1 - after / before;
}

/// Goes a tenth of the way again and again, as the library does.
static void go_home(travel *own, int rounds)
{
    double *end = malloc(own->numbers * sizeof *end), part = 0.1;
    TF_REQUIRE(end);
    for (int i = 0, failures = 0; i < STEPS && failures <= FAILURES; i++) {
        double gain = step_home(own, part, end);
        failures += gain < 0.005;
        if (gain > 0)
            add_state(own, ++rounds);
        else
            part /= 2;
    }
    if (step_home(own, 1, end) > 0)
        add_state(own, ++rounds);
    free(end);
}

// There and back ---------------------------------------------------------------

static void travel_by(fig_journey *all, tf_untangle_rung rung)
{
    const fig_some_mesh *mesh = &all->tangle.mesh;
    tf_mesh in_space = fig_mesh_in_space(mesh);
    bool *fixed = calloc((size_t)mesh->vertices, sizeof *fixed);
    travel own = {.all = all,
                  .numbers = 3 * (size_t)mesh->vertices,
                  .tangle = {.in = mesh->x, .fixed = fixed}};
    own.x = malloc(own.numbers * sizeof *own.x);
    TF_REQUIRE(own.x && fixed);
    memcpy(own.x, mesh->x, own.numbers * sizeof *own.x);
    TF_REQUIRE(tf_surface_create(&in_space, &own.surface, NULL) == TF_OK);
    TF_REQUIRE(tf_resolver_create(own.surface, &own.resolver) == TF_OK);
    own.tangle.surface = own.surface;
    TF_REQUIRE(tf_tangle_begin(&own.tangle));
    all->crossings = check(&own);
    add_state(&own, 0);
    int rounds = rung == TF_RUNG_APART ? move_apart(&own) : relax(&own);
    all->found = all->states;
    add_state(&own, rounds);
    go_home(&own, rounds);
    tf_tangle_end(&own.tangle);
    tf_resolver_free(own.resolver);
    tf_surface_free(own.surface);
    free(own.x);
    free(fixed);
}

const fig_journey *fig_journey_of(const char *name, tf_untangle_rung rung)
{
    static struct kept {
        const char *name;
        tf_untangle_rung rung;
        fig_journey all;
        struct kept *next;
    } * first;
    for (const struct kept *one = first; one; one = one->next)
        if (strcmp(one->name, name) == 0 && one->rung == rung)
            return &one->all;
    struct kept *one = calloc(1, sizeof *one);
    TF_REQUIRE(one);
    one->name = name;
    one->rung = rung;
    one->all.tangle = fig_tangle_make(name);
    travel_by(&one->all, rung);
    one->next = first;
    return &(first = one)->all;
}

// Pictures ---------------------------------------------------------------------

/// Whether a journey jumps from one of its states to the next.
static bool jumps(const fig_journey *all, int state)
{
    return state == 0 && all->found == 1;
}

/// The last state up to a time, and sets how much of the way to the next one
/// has passed.  The input is seen for a while.
static int state_at(const fig_journey *all, double time, double *part)
{
    double hold = all->states / 16.0;
    double at = fmax(time * (all->states - 1 + hold) - hold, 0);
    int state = (int)fmin(floor(at), all->states - 2);
    *part = jumps(all, state) ? floor(at - state + 0.5) : at - state;
    return state;
}

void fig_journey_draw(fig_page *page, fig_box box, const fig_journey *all,
                      double time)
{
    const fig_tangle *tangle = &all->tangle;
    size_t numbers = 3 * (size_t)tangle->mesh.vertices;
    double part, *x = malloc(numbers * sizeof *x);
    int state = state_at(all, time, &part);
    TF_REQUIRE(x);
    for (size_t i = 0; i < numbers; i++)
        x[i] =
            all->x[state][i] + part * (all->x[state + 1][i] - all->x[state][i]);
    fig_panel *panel = fig_page_panel(page, box);
    for (int s = 0; s < all->states; s++)
        for (size_t i = 0; i < numbers; i += 3)
            fig_scene_reach(fig_panel_scene(panel),
                            fig_vector_of(all->x[s] + i));
    fig_tangle_draw_in(panel, tangle, x);
    free(x);
}

void fig_journey_plot(fig_page *page, fig_box box, const fig_journey *all,
                      double time, const char *name_x)
{
    int last = all->states - 1, found = all->found;
    fig_point curve[FIG_JOURNEY_STATES];
    fig_plot plot = {.box = box,
                     .x = {0, all->rounds[last]},
                     .y = {0, 0},
                     .name_x = name_x,
                     .name_y = "from home, edges",
                     .ticks_x = 4,
                     .ticks_y = 4};
    for (int i = 0; i <= last; i++) {
        curve[i] = (fig_point){all->rounds[i], all->away[i]};
        plot.y[1] = fmax(plot.y[1], 1.05 * all->away[i]);
    }
    fig_plot_frame(page, &plot);
    fig_plot_curve(page, &plot, found + 1, curve,
                   (fig_stroke){.paint = {.role = FIG_ROLE_CONTACT}});
    fig_plot_curve(page, &plot, last - found + 1, curve + found,
                   (fig_stroke){.paint = {.role = FIG_ROLE_TRIANGLE}});
    double part;
    int now = state_at(all, time, &part);
    now += jumps(all, now) || part == 1 ? (int)part : 0;
    fig_plot_dot(page, &plot, curve[now].x, curve[now].y, FIG_WIDTH_BALL,
                 FIG_ROLE_INK);
}
