// A point beside an edge, both moved together and then rounded: how often is
// the point on the other side afterwards?
#include "base/require.h"
#include "kit/figures.h"
#include "kit/random.h"

#include "arithmetic/exact.h"
#include "arithmetic/functions.h"
#include "renderer/plot.h"
#include "response/resolve.h"

#include <math.h>
#include <string.h>

enum {
    MOVES = 3,
    DOTS = 13,
    PAIRS = 4000, ///< for each dot
    STEPS = 2000  ///< to be resolved
};

/// The distance of the i-th dot.
static double distance_of(int i)
{
    return pow(10, -17 + i / 3.0);
}

/// How pairs are moved.
typedef enum move {
    FAR,    ///< by up to 100 along each axis
    NEAR,   ///< by up to 1
    TURNED, ///< about the origin
} move;

static const char *const names[MOVES] = {"moved by up to 100",
                                         "moved by up to 1", "turned"};
static const fig_role roles[MOVES] = {FIG_ROLE_CONTACT, FIG_ROLE_EDGE,
                                      FIG_ROLE_POINT};

/// The two ends of an edge, and a point.
typedef struct pair {
    double x[3][2];
} pair;

static double between(uint64_t *state, double low, double high)
{
    return low + (high - low) * fig_random_number(state);
}

/// On which side of its edge the point is, exactly; 1: on the left.
static int side_of(const pair *p)
{
    tf_event event[3] = {{{0}, 0, 0}};
    for (int i = 0; i < 3; i++)
        memcpy(event[i].x, p->x[i], sizeof p->x[i]);
    tf_differences differences = {.n = 2,
                                  .to = {&event[1], &event[2]},
                                  .from = {&event[0], &event[0]},
                                  .axis = {0, 1}};
    return tf_exact.sign(&differences);
}

/// A pair whose point is on the left, at about that distance.
static pair pair_at(uint64_t *state, double distance)
{
    pair made;
    do {
        double angle = between(state, 0, 2 * acos(-1));
        double along[2] = {cos(angle), sin(angle)};
        double weight = between(state, 0.1, 0.9);
        for (int k = 0; k < 2; k++) {
            double across = k == 0 ? -along[1] : along[0];
            double a = fig_random_number(state);
            made.x[0][k] = a;
            made.x[1][k] = a + along[k];
            made.x[2][k] = a + weight * along[k] + distance * across;
        }
    } while (side_of(&made) <= 0);
    return made;
}

static pair translate(const pair *p, const double by[2])
{
    pair moved = *p;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 2; k++)
            moved.x[i][k] += by[k];
    return moved;
}

static pair turn(const pair *p, double angle)
{
    double c = cos(angle), s = sin(angle);
    pair moved;
    for (int i = 0; i < 3; i++) {
        moved.x[i][0] = c * p->x[i][0] - s * p->x[i][1];
        moved.x[i][1] = s * p->x[i][0] + c * p->x[i][1];
    }
    return moved;
}

static pair move_at_random(uint64_t *state, move how, const pair *p)
{
    if (how == TURNED)
        return turn(p, between(state, 0, 2 * acos(-1)));
    double most = how == FAR ? 100 : 1;
    double by[2] = {between(state, -most, most), between(state, -most, most)};
    return translate(p, by);
}

/// How many percent of the points are no longer on the left.
static double percentage(move how, double distance)
{
    uint64_t state = 1;
    int crossed = 0;
    for (int i = 0; i < PAIRS; i++) {
        pair start = pair_at(&state, distance);
        pair end = move_at_random(&state, how, &start);
        crossed += side_of(&end) <= 0;
    }
    return 100.0 * crossed / PAIRS;
}

// In a step -------------------------------------------------------------------

/// Resolves steps of pairs that are moved together by the failsafe alone.
static void resolve_steps(FILE *numbers)
{
    const tf_mesh mesh = {
        .axes = 2, .vertices = 3, .edges = 1, .edge = (int[]){0, 1}};
    const tf_response_options options = {.zone_rounds = -1};
    tf_surface *surface;
    tf_resolver *resolver;
    TF_REQUIRE(tf_surface_create(&mesh, &surface, NULL) == TF_OK);
    TF_REQUIRE(tf_resolver_create(surface, &resolver) == TF_OK);
    uint64_t state = 2;
    int touching = 0, frozen = 0, rounds = 0;
    for (int i = 0; i < STEPS; i++) {
        pair start = pair_at(&state, 1e-15);
        pair end = move_at_random(&state, FAR, &start);
        const tf_response_report *report;
        TF_REQUIRE(tf_step_resolve(resolver, 3, start.x[0], end.x[0], NULL,
                                   &options, &report, NULL) == TF_OK);
        touching += report->first_contacts > 0;
        frozen += report->resting > 0;
        int own = report->rounds[TF_FAILSAFE];
        rounds = own > rounds ? own : rounds;
    }
    tf_resolver_free(resolver);
    tf_surface_free(surface);
    fig_number(numbers, "steps", STEPS);
    fig_number(numbers, "touching", touching);
    fig_number(numbers, "frozen", frozen);
    fig_number(numbers, "most_rounds", rounds);
}

// Drawing ---------------------------------------------------------------------

static void draw_move(fig_page *page, const fig_plot *plot, move how,
                      FILE *numbers)
{
    static const char *const keys[MOVES] = {"far", "near", "turned"};
    fig_point at[DOTS];
    for (int i = 0; i < DOTS; i++) {
        at[i] = (fig_point){distance_of(i), percentage(how, distance_of(i))};
        char key[16];
        snprintf(key, sizeof key, "%s_%d", keys[how], 17 - i / 3);
        if (i % 3 == 0)
            fig_number(numbers, key, at[i].y);
    }
    fig_plot_curve(page, plot, DOTS, at,
                   (fig_stroke){.paint = {.role = roles[how]}});
    for (int i = 0; i < DOTS; i++)
        fig_plot_dot(page, plot, at[i].x, at[i].y, 4, roles[how]);
    fig_plot_key(page, plot->box.x + plot->box.width - 122, 22 + 15 * how,
                 names[how], roles[how]);
}

static void draw(fig_page *page, FILE *numbers)
{
    fig_plot plot = {.box = {48, 8, fig_page_width(page) - 60, 150},
                     .x = {7e-18, 1.4e-13},
                     .y = {-2, 56},
                     .log_x = true,
                     .name_x = "distance from an edge of length 1",
                     .name_y = "% on or beyond"};
    fig_plot_frame(page, &plot);
    for (int how = 0; how < MOVES; how++)
        draw_move(page, &plot, (move)how, numbers);
    fig_number(numbers, "pairs", PAIRS);
    resolve_steps(numbers);
}

const fig_figure fig_moved_and_rounded = {
    .name = "moved-and-rounded",
    .title = "Points that change sides when they are moved and rounded",
    .width = FIG_PAGE_WIDTH,
    .height = 192,
    .draw = draw,
};
