// How far the ends of the interval are from the true time, query by query.
#include "figures.h"

#include "arithmetic/exact.h"
#include "spacetime/complementary.h"
#include "stage/plot.h"

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
    tf_meeting meeting;
    int64_t late, all;
} hit;

static uint64_t random_bits(uint64_t *state)
{
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return *state >> (64 - COORDINATE_BITS);
}

/// The determinant of the differences without an event, in integers.
static int64_t determinant(const tf_pair *pair, int without)
{
    tf_differences d = tf_pair_differences(pair, without);
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
    if (!tf_complementary_meet(&tf_exact, &pair, &h->meeting) ||
        h->meeting.verdict != TF_HIT)
        return false;

    // The point's events are the first of each time; both count alike.
    h->late = imaxabs(determinant(&pair, pair.early));
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

static double margin(double t)
{
    return t * (6 - 3 * t);
}

static void draw_margin(tf_page *page, const tf_plot *plot, double sign)
{
    double at[CURVE][2];
    for (int i = 0; i < CURVE; i++) {
        at[i][0] = (double)i / (CURVE - 1);
        at[i][1] = sign * margin(at[i][0]);
    }
    tf_plot_curve(page, plot, CURVE, (const double(*)[2])at,
                  (tf_stroke){.width = TF_WIDTH_LINE, .under_labels = true});
}

static void draw_dot(tf_page *page, const tf_plot *plot, double t, double error,
                     tf_role role)
{
    double at[2];
    tf_plot_place(plot, t, error, at);
    tf_page_dot(page, at[0], at[1], 1.5, (tf_paint){.role = role});
}

static void name(tf_page *page, const tf_plot *plot, double y, const char *text,
                 tf_role role)
{
    double at[2];
    tf_plot_place(plot, 1, y, at);
    tf_page_text(page, at[0] + 4, at[1] + 3, TF_ALIGN_LEFT, text,
                 TF_LETTERS_SMALL, role);
}

static void draw(tf_page *page, FILE *numbers)
{
    tf_plot plot = {.box = {44, 8, tf_page_width(page) - 100, 150},
                    .x = {0, 1},
                    .y = {-5, 5},
                    .name_x = "$t$",
                    .name_y = "distance from $t$, in $u$"};
    tf_plot_frame(page, &plot);
    double zero[2][2] = {{0, 0}, {1, 0}};
    tf_plot_curve(
        page, &plot, 2, (const double(*)[2])zero,
        (tf_stroke){.paint.role = TF_ROLE_NEUTRAL, .width = TF_WIDTH_HAIR});
    uint64_t state = 2009;
    double widest = 0, slack = INFINITY;
    for (int found = 0; found < QUERIES;) {
        hit h;
        if (!random_hit(&state, &h) || h.meeting.toi_lo < 0x1p-6)
            continue;
        double t = (double)h.late / (double)h.all;
        double low = error_of(h.meeting.toi_lo, &h);
        double high = error_of(h.meeting.toi_hi, &h);
        draw_dot(page, &plot, t, low, TF_ROLE_START);
        draw_dot(page, &plot, t, high, TF_ROLE_END);
        widest = fmax(widest, high - low);
        slack = fmin(slack, fmin(-low, high) / margin(t));
        found++;
    }
    draw_margin(page, &plot, +1);
    draw_margin(page, &plot, -1);
    name(page, &plot, 3, "margin", TF_ROLE_INK);
    name(page, &plot, 1.6, "toi_hi", TF_ROLE_END);
    name(page, &plot, -1.6, "toi_lo", TF_ROLE_START);
    name(page, &plot, 0, "$t$ itself", TF_ROLE_NEUTRAL);
    tf_figure_number(numbers, "queries", QUERIES);
    tf_figure_number(numbers, "widest", widest);
    tf_figure_number(numbers, "slack", slack);
}

const tf_figure tf_figure_time_margins = {
    .name = "time-margins",
    .title = "The ends of the interval around the true time",
    .width = TF_FIGURE_WIDTH,
    .height = 196,
    .draw = draw,
};
