// How far the ends of the interval are from the true time, query by query.
#include "arithmetic/functions.h"
#include "kit/figures.h"

#include "arithmetic/exact.h"
#include "intersect/complementary.h"
#include "kit/random.h"
#include "renderer/plot.h"

#include <inttypes.h>
#include <math.h>

enum {
    QUERIES = 1500,
    CURVE = 101,
    COORDINATE_BITS = 29 // determinants are then below 2^59
};

__extension__ typedef __int128 int128;

/// A path and a triangle that meet, and the true time: late / all.
typedef struct hit {
    tf_intersection meeting;
    int64_t late, all;
} hit;

static uint64_t random_bits(uint64_t *state)
{
    return fig_congruent_bits(state) >> (64 - COORDINATE_BITS);
}

/// The determinant of the differences without an event, in integers.
static int64_t determinant(const tf_pair *pair, int without)
{
    tf_differences d;
    tf_pair_differences(pair, without, &d);
    int64_t e[2][2];
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 2; k++)
            e[i][k] = (int64_t)(d.to[i]->x[k] - d.from[i]->x[k]);
    return e[0][0] * e[1][1] - e[0][1] * e[1][0];
}

static bool random_hit(uint64_t *state, hit *h)
{
    tf_worldline vertex[3];
    for (int i = 0; i < 3; i++) {
        double at[2][2];
        for (int k = 0; k < 4; k++)
            at[k / 2][k % 2] = (double)random_bits(state);
        vertex[i] = tf_worldline_between(2, at[0], at[1]);
    }
    tf_simplex path[1], sweep[2];
    tf_sweep(1, vertex, path);
    tf_sweep(2, vertex + 1, sweep);
    tf_pair pair = tf_pair_of(&path[0], &sweep[0], 2);
    if (!tf_complementary_intersect(&tf_exact, &pair, TF_WITH_POINT,
                                    &h->meeting) ||
        h->meeting.verdict != TF_HIT)
        return false;

    // The point's events are the first of each time; both count alike.
    h->late = imaxabs(determinant(&pair, pair.start_count));
    h->all = h->late + imaxabs(determinant(&pair, 0));
    return true;
}

/// x minus the true time, in units of 2^-53, rounded only at the end.
static double error_of(double x, const hit *h)
{
    int shift = 53 - ilogb(x);
    int128 scaled = (int128)ldexp(x, shift);
    int128 error = scaled * h->all - ((int128)h->late << shift);
    return ldexp((double)error / (double)h->all, 53 - shift);
}

/// In units of u, without what is small of second order.  What the computed
/// time is off by, with the rounding of an end, is at most as much; so an end
/// is at most two margins from the true time.
static double margin(double t)
{
    return t * (6 - 3 * t);
}

/// The curve of some margins after t = 0 (+1) or before it (-1).
static void find_curve(double margins, fig_point at[CURVE])
{
    for (int i = 0; i < CURVE; i++) {
        at[i].x = (double)i / (CURVE - 1);
        at[i].y = margins * margin(at[i].x);
    }
}

/// Where the ends have to be, two margins on either side, and the margin.
static void draw_bounds(fig_page *page, const fig_plot *plot)
{
    for (int sign = -1; sign <= 1; sign += 2) {
        fig_point at[CURVE], corner[CURVE + 1];
        find_curve(2 * sign, at);
        for (int i = 0; i < CURVE; i++)
            corner[i] = fig_plot_place(plot, at[i].x, at[i].y);
        corner[CURVE] = fig_plot_place(plot, 1, 0);
        fig_page_fill(page, CURVE + 1, corner,
                      (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.16});
        fig_plot_curve(page, plot, CURVE, at,
                       (fig_stroke){.width = FIG_WIDTH_LINE});
        find_curve(sign, at);
        fig_plot_curve(page, plot, CURVE, at,
                       (fig_stroke){.width = FIG_WIDTH_THIN, .dash = 3});
    }
    const fig_point truth[2] = {{0, 0}, {1, 0}};
    fig_plot_curve(page, plot, 2, truth,
                   (fig_stroke){.paint.role = FIG_ROLE_CONTACT});
}

static void name(fig_page *page, const fig_plot *plot, double y,
                 const char *text, fig_role role)
{
    fig_point at = fig_plot_place(plot, 1, y);
    fig_page_text(page, at.x + 4, at.y + 3, FIG_ALIGN_LEFT, text,
                  FIG_LETTERS_SMALL, role);
}

static void draw_names(fig_page *page, const fig_plot *plot)
{
    name(page, plot, 6, "two margins", FIG_ROLE_INK);
    name(page, plot, 3, "margin", FIG_ROLE_INK);
    name(page, plot, 0, "true time $t$", FIG_ROLE_CONTACT);
    fig_point end = fig_plot_place(plot, 0.15, 3.2);
    fig_page_text(page, end.x, end.y, FIG_ALIGN_RIGHT, "toi_hi",
                  FIG_LETTERS_SMALL, FIG_ROLE_POINT);
    end = fig_plot_place(plot, 0.15, -3.7);
    fig_page_text(page, end.x, end.y, FIG_ALIGN_RIGHT, "toi_lo",
                  FIG_LETTERS_SMALL, FIG_ROLE_POINT);
}

static void draw(fig_page *page, FILE *numbers)
{
    fig_plot plot = {.box = {44, 8, fig_page_width(page) - 110, 166},
                     .x = {0, 1},
                     .y = {-6.4, 6.4},
                     .name_x = "$t$",
                     .name_y = "distance from $t$, in $u$"};
    draw_bounds(page, &plot);
    fig_plot_frame(page, &plot);
    uint64_t state = 2009;
    double widest = 0, slack = INFINITY, farthest = 0;
    for (int found = 0; found < QUERIES;) {
        hit h;
        if (!random_hit(&state, &h) || h.meeting.toi_lo < 0x1p-6)
            continue;
        double t = (double)h.late / (double)h.all;
        double low = error_of(h.meeting.toi_lo, &h);
        double high = error_of(h.meeting.toi_hi, &h);
        fig_plot_dot(page, &plot, t, low, 1.5, FIG_ROLE_POINT);
        fig_plot_dot(page, &plot, t, high, 1.5, FIG_ROLE_POINT);
        widest = fmax(widest, high - low);
        slack = fmin(slack, fmin(-low, high) / margin(t));
        farthest = fmax(farthest, fmax(-low, high) / margin(t));
        found++;
    }
    draw_names(page, &plot);
    fig_number(numbers, "queries", QUERIES);
    fig_number(numbers, "widest", widest);
    fig_number(numbers, "slack", slack);
    fig_number(numbers, "farthest", farthest);
}

const fig_figure fig_time_margins = {
    .name = "time-margins",
    .title = "The ends of the interval around the true time",
    .width = FIG_PAGE_WIDTH,
    .height = 212,
    .draw = draw,
};
