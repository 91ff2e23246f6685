// How large determinants are, their errors, and two bounds on these: by the
// permanent, and by the ranges of the query.  All in units of u Mx My Mz.
#include "arithmetic/functions.h"
#include "kit/figures.h"

#include "arithmetic/filter.h"
#include "arithmetic/two_sum.h"
#include "base/require.h"
#include "fast/lanes.h"
#include "intersect/pair.h"
#include "kit/expansion.h"
#include "kit/random.h"
#include "renderer/plot.h"

#include <math.h>
#include <string.h>

enum {
    QUERIES = 4000, ///< of each kind and scene
    VERTICES = 4,
    LEAST_POWER = -9, ///< of two
    MOST_POWER = 55,
    BINS = MOST_POWER - LEAST_POWER
};

static const double unit_roundoff = 0x1p-53;

typedef enum quantity {
    ERROR,
    PERMANENT,
    MOVING,
    RESTING,
    QUANTITIES
} quantity;

static const struct shown {
    const char *key, *name;
    fig_role role;
} shown[QUANTITIES] = {
    [ERROR] = {"error", "errors", FIG_ROLE_CONTACT},
    [PERMANENT] = {"permanent", "bounds by permanents", FIG_ROLE_TRIANGLE},
    [MOVING] = {"near", "determinants, moving", FIG_ROLE_EDGE},
    [RESTING] = {"rest", "determinants, at rest", FIG_ROLE_OTHER_EDGE},
};

/// What was found: how many of each quantity are between two powers of two.
typedef struct tally {
    long bin[QUANTITIES][BINS], all[QUANTITIES];
    long small[QUANTITIES]; ///< not more than the bound by ranges
    double largest[QUANTITIES];
} tally;

static const double bound_by_ranges = TF_SHARE_SURE / TF_UNIT_ROUNDOFF;

static void count(tally *found, quantity what, double units)
{
    int power = ilogb(fmax(units, 0x1p-1000)) - LEAST_POWER;
    found->all[what]++;
    found->small[what] += !(units > bound_by_ranges);
    found->largest[what] = fmax(found->largest[what], units);
    if (power >= 0 && power < BINS)
        found->bin[what][power]++;
}

// The determinants -------------------------------------------------------

/// The exact determinant minus the rounded one, to many digits: that of the
/// rounded differences exactly, and what these were rounded by to first order.
static double error_of(const tf_differences *d, double number)
{
    double entry[TF_AXES][TF_AXES];
    tf_differences_round(d, entry);
    expansion exact, negative = {1, {-number}}, error;
    expansion_determinant(TF_AXES, entry, &exact);
    expansion_add(&exact, &negative, &error);
    double sum = 0;
    for (int i = 0; i < error.count; i++)
        sum += error.term[i];
    for (int i = 0; i < TF_AXES; i++) {
        double row[TF_AXES], *a = entry[(i + 1) % 3], *b = entry[(i + 2) % 3];
        for (int k = 0; k < TF_AXES; k++)
            row[k] = tf_two_sum(d->to[i]->x[k], -d->from[i]->x[k]).lo;
        sum += row[0] * (a[1] * b[2] - a[2] * b[1]) +
               row[1] * (a[2] * b[0] - a[0] * b[2]) +
               row[2] * (a[0] * b[1] - a[1] * b[0]);
    }
    return sum;
}

/// The product over the axes of the largest difference at one time between a
/// vertex of the first element, which has `first` of them, and one of the second.
static double volume_of(int first, const tf_worldline vertex[VERTICES])
{
    double volume = 1;
    for (int k = 0; k < TF_AXES; k++) {
        double reach = 0;
        for (int i = 0; i < first; i++)
            for (int j = first; j < VERTICES; j++)
                for (int t = 0; t < 2; t++)
                    reach = fmax(reach, fabs(vertex[i].at[t].x[k] -
                                             vertex[j].at[t].x[k]));
        volume *= reach;
    }
    return volume;
}

static void count_pair(tally *found, const tf_pair *pair, double unit,
                       quantity scene)
{
    for (int i = 0; i < pair->count; i++) {
        tf_differences d;
        tf_pair_differences(pair, i, &d);
        tf_estimate e = tf_differences_estimate(&d);
        count(found, scene, fabs(e.number) / unit);
        if (scene == RESTING)
            continue;
        count(found, ERROR, fabs(error_of(&d, e.number)) / unit);
        count(found, PERMANENT, e.bound / unit);
    }
}

static void count_query(tally *found, int first, const tf_worldline vertex[],
                        quantity scene)
{
    tf_simplex s[TF_VERTICES], r[TF_VERTICES];
    int second = VERTICES - first;
    double unit = unit_roundoff * volume_of(first, vertex);
    tf_sweep(first, vertex, s);
    tf_sweep(second, vertex + first, r);
    for (int i = 0; i < first * second; i++) {
        tf_pair pair = tf_pair_of(&s[i / second], &r[i % second], TF_AXES);
        count_pair(found, &pair, unit, scene);
    }
}

// The scenes -------------------------------------------------------------

/// Vertices near each other that move about as far.
static void move_near(uint64_t *random, tf_worldline vertex[VERTICES])
{
    double corner[TF_AXES];
    for (int k = 0; k < TF_AXES; k++)
        corner[k] = fig_random_number(random);
    for (int i = 0; i < VERTICES; i++) {
        double at[2][TF_AXES];
        for (int k = 0; k < TF_AXES; k++) {
            at[0][k] = corner[k] + 0.1 * fig_random_number(random);
            at[1][k] = at[0][k] + 0.2 * fig_random_number(random) - 0.1;
        }
        vertex[i] = tf_worldline_between(TF_AXES, at[0], at[1]);
    }
}

/// The same, but all in a tilted plane, and at rest.
static void rest_tilted(uint64_t *random, tf_worldline vertex[VERTICES])
{
    double corner[2] = {fig_random_number(random), fig_random_number(random)};
    for (int i = 0; i < VERTICES; i++) {
        double u = corner[0] + 0.1 * fig_random_number(random);
        double v = corner[1] + 0.1 * fig_random_number(random);
        double x[TF_AXES] = {0.8 * u - 0.36 * v, 0.6 * u + 0.48 * v, 0.8 * v};
        vertex[i] = tf_worldline_between(TF_AXES, x, x);
    }
}

static void count_all(tally *found)
{
    uint64_t random = 15;
    memset(found, 0, sizeof *found);
    for (int i = 0; i < 2 * QUERIES; i++) {
        tf_worldline vertex[VERTICES];
        move_near(&random, vertex);
        count_query(found, 1 + i % 2, vertex, MOVING);
        rest_tilted(&random, vertex);
        count_query(found, 1 + i % 2, vertex, RESTING);
    }
}

// The picture ------------------------------------------------------------

/// A hill whose height is the share of the quantity in each power of two.
static void draw_hill(fig_page *page, const fig_plot *plot, const tally *found,
                      quantity what)
{
    fig_point at[BINS + 2], place[BINS + 2];
    for (int i = 0; i < BINS; i++)
        at[i] = (fig_point){ldexp(1.5, LEAST_POWER + i),
                            100.0 * (double)found->bin[what][i] /
                                (double)found->all[what]};
    for (int i = 0; i < BINS; i++)
        place[i] = fig_plot_place(plot, at[i].x, at[i].y);
    place[BINS] = fig_plot_place(plot, at[BINS - 1].x, 0);
    place[BINS + 1] = fig_plot_place(plot, at[0].x, 0);
    fig_page_fill(page, BINS + 2, place,
                  (fig_paint){.role = shown[what].role, .opacity = 0.3});
    fig_plot_curve(
        page, plot, BINS, at,
        (fig_stroke){.paint.role = shown[what].role, .width = FIG_WIDTH_LINE});
}

static void draw_bound(fig_page *page, const fig_plot *plot)
{
    fig_point at[2] = {{bound_by_ranges, plot->y[0]},
                       {bound_by_ranges, plot->y[1]}};
    fig_plot_curve(page, plot, 2, at,
                   (fig_stroke){.width = FIG_WIDTH_LINE, .dash = 4});
    fig_point top = fig_plot_place(plot, bound_by_ranges, plot->y[1]);
    fig_page_text(page, top.x, top.y - 5, FIG_ALIGN_CENTER, "256",
                  FIG_LETTERS_SMALL, FIG_ROLE_INK);
}

static void draw_keys(fig_page *page, const fig_plot *plot)
{
    for (int i = 0; i < QUANTITIES; i++) {
        fig_point at = fig_plot_place(plot, 0x1p20, plot->y[1]);
        fig_plot_key(page, at.x, at.y + 18 + 15 * i, shown[i].name,
                     shown[i].role);
    }
}

static void print_numbers(FILE *numbers, const tally *found)
{
    for (int i = 0; i < QUANTITIES; i++) {
        char key[48];
        snprintf(key, sizeof key, "%s_count", shown[i].key);
        fig_number(numbers, key, (double)found->all[i]);
        snprintf(key, sizeof key, "%s_small", shown[i].key);
        fig_number(numbers, key, (double)found->small[i]);
        snprintf(key, sizeof key, "%s_largest", shown[i].key);
        fig_number(numbers, key, found->largest[i]);
    }
    fig_number(numbers, "ranges", bound_by_ranges);
}

static void draw(fig_page *page, FILE *numbers)
{
    fig_plot plot = {.box = {40, 18, fig_page_width(page) - 52, 150},
                     .x = {ldexp(1, LEAST_POWER), ldexp(1, MOST_POWER)},
                     .y = {0, 30},
                     .log_x = true,
                     .name_x = "units of $u M_x M_y M_z$",
                     .name_y = "% per power of 2"};
    tally found;
    count_all(&found);
    for (int i = 0; i < QUANTITIES; i++)
        draw_hill(page, &plot, &found, (quantity)i);
    fig_plot_frame(page, &plot);
    draw_bound(page, &plot);
    draw_keys(page, &plot);
    print_numbers(numbers, &found);
}

const fig_figure fig_bound_margins = {
    .name = "bound-margins",
    .title = "Determinants, their errors and two bounds on the errors",
    .width = FIG_PAGE_WIDTH,
    .height = 204,
    .draw = draw,
};
