// How often staircase motion and linear motion disagree, by how far things
// move: random points and edges in the plane.
#include "kit/figures.h"

#include "arithmetic/exact.h"
#include "kit/random.h"
#include "query/query.h"
#include "renderer/plot.h"

#include <math.h>

enum {
    QUERIES = 200000, ///< for each displacement
    VERTICES = 3,     ///< the point, then the edge's
    SIZES = 9
};

static const double size[SIZES] = {0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 3};

/// What was counted for one displacement.
typedef struct count {
    long hits;         ///< of staircase motion
    long extra, fewer; ///< hits of it alone, of linear motion alone
} count;

// Linear motion ----------------------------------------------------------

/// An edge's end as seen from the point: at + t by.
typedef struct seen {
    double at[2], by[2];
} seen;

static seen see(const tf_worldline *vertex, const tf_worldline *point)
{
    seen s;
    for (int k = 0; k < 2; k++) {
        s.at[k] = vertex->at[0].x[k] - point->at[0].x[k];
        s.by[k] = vertex->at[1].x[k] - point->at[1].x[k] - s.at[k];
    }
    return s;
}

static double cross(const double a[2], const double b[2])
{
    return a[0] * b[1] - a[1] * b[0];
}

/// Whether the point is between the ends at the time t, given that it is on
/// their line.
static bool between(const seen end[2], double t)
{
    double dot = 0;
    for (int k = 0; k < 2; k++)
        dot += (end[0].at[k] + t * end[0].by[k]) *
               (end[1].at[k] + t * end[1].by[k]);
    return t >= 0 && t <= 1 && dot <= 0;
}

/// Whether the straight edge meets the point: the cross product of its ends as
/// seen from the point is a quadratic function of time.
static bool meets_linearly(const tf_worldline vertex[VERTICES])
{
    seen end[2] = {see(&vertex[1], &vertex[0]), see(&vertex[2], &vertex[0])};
    double a = cross(end[0].by, end[1].by);
    double b = cross(end[0].at, end[1].by) + cross(end[0].by, end[1].at);
    double c = cross(end[0].at, end[1].at);
    double discriminant = b * b - 4 * a * c;
    if (discriminant < 0)
        return false;
    double q = -(b + copysign(sqrt(discriminant), b)) / 2;
    return between(end, q / a) || between(end, c / q);
}

// Short motions ----------------------------------------------------------

/// What an edge sweeps in a motion so short that its square does not matter,
/// in units of half its length: how far its ends come out of their line, seen
/// from the point.
typedef struct swept {
    double all;   ///< by the staircase
    double extra; ///< of it, what linear motion avoids
} swept;

static swept sweep_briefly(const tf_worldline vertex[VERTICES])
{
    seen end[2] = {see(&vertex[1], &vertex[0]), see(&vertex[2], &vertex[0])};
    double along[2] = {end[1].at[0] - end[0].at[0],
                       end[1].at[1] - end[0].at[1]};
    double a = cross(along, end[0].by), b = cross(along, end[1].by);
    double sum = fabs(a) + fabs(b);
    double extra = a * b < 0 ? -a * b / sum : 0;
    return (swept){.all = a * b < 0 ? sum - extra : sum, .extra = extra};
}

/// The share that the contacts of the staircase alone tend to as motions get
/// shorter: that of what it sweeps alone.
static double share_in_the_limit(void)
{
    swept total = {0, 0};
    uint64_t state = 1;
    for (int i = 0; i < QUERIES; i++) {
        tf_worldline vertex[VERTICES];
        fig_random_vertices(&state, 2, 1, VERTICES, vertex);
        swept one = sweep_briefly(vertex);
        total.all += one.all;
        total.extra += one.extra;
    }
    return total.extra / total.all;
}

// The comparison ---------------------------------------------------------

static count compare(double displacement)
{
    count n = {0, 0, 0};
    uint64_t state = 1;
    for (int i = 0; i < QUERIES; i++) {
        tf_worldline vertex[VERTICES];
        tf_contact contact;
        fig_random_vertices(&state, 2, displacement, VERTICES, vertex);
        tf_query(&tf_exact, 2, 1, &vertex[0], 2, &vertex[1], &contact);
        bool bent = contact.verdict == TF_HIT;
        bool straight = meets_linearly(vertex);
        n.hits += bent;
        n.extra += bent && !straight;
        n.fewer += straight && !bent;
    }
    return n;
}

static void print_count(double displacement, const count *n, FILE *numbers)
{
    const struct {
        const char *key;
        double number;
    } line[] = {
        {"hits", (double)n->hits / QUERIES},
        {"extra", (double)n->extra},
        {"fewer", (double)n->fewer},
        {"differ", (double)(n->extra + n->fewer) / QUERIES},
        {"one_in", QUERIES / (double)(n->extra + n->fewer)},
        {"share", (double)(n->extra + n->fewer) / (double)n->hits},
        {"error", sqrt((double)(n->extra + n->fewer)) / (double)n->hits}};
    for (size_t i = 0; i < sizeof line / sizeof *line; i++) {
        char key[32];
        snprintf(key, sizeof key, "%s_%g", line[i].key, displacement);
        fig_number(numbers, key, line[i].number);
    }
}

/// A curve through dots, named at the fourth of them; no dot for a fraction 0.
static void draw_fractions(fig_page *page, const fig_plot *plot,
                           const fig_point at[SIZES], fig_label name)
{
    fig_plot_curve(page, plot, SIZES, at,
                   (fig_stroke){.paint = {.role = name.role}});
    for (int i = 0; i < SIZES; i++)
        if (at[i].y > 0)
            fig_plot_dot(page, plot, at[i].x, at[i].y, 4, name.role);
    fig_point named = fig_plot_place(plot, at[3].x, at[3].y);
    fig_page_label(page, named.x, named.y, name);
}

static void draw(fig_page *page, FILE *numbers)
{
    fig_point hits[SIZES], differ[SIZES];
    fig_number(numbers, "queries", QUERIES);
    fig_number(numbers, "share_in_the_limit", share_in_the_limit());
    for (int i = 0; i < SIZES; i++) {
        count n = compare(size[i]);
        print_count(size[i], &n, numbers);
        hits[i] = (fig_point){size[i], (double)n.hits / QUERIES};
        differ[i] = (fig_point){size[i], (double)(n.extra + n.fewer) / QUERIES};
    }
    double width = fig_page_width(page), height = fig_page_height(page);
    fig_plot plot = {.box = {52, 10, width - 72, height - 48},
                     .x = {0.008, 4},
                     .y = {1e-5, 1},
                     .log_x = true,
                     .log_y = true,
                     .name_x = "displacement, in widths of the scene",
                     .name_y = "fraction of the queries",
                     .ticks_y = 6};
    fig_plot_frame(page, &plot);
    draw_fractions(page, &plot, hits,
                   (fig_label){.text = "hit",
                               .role = FIG_ROLE_INK,
                               .side = FIG_SIDE_NW,
                               .gap = 4});
    draw_fractions(page, &plot, differ,
                   (fig_label){.text = "hit in one motion only",
                               .role = FIG_ROLE_NEUTRAL,
                               .side = FIG_SIDE_SE,
                               .gap = 4});
}

const fig_figure fig_model_disagreement = {
    .name = "model-disagreement",
    .title = "How often staircase and linear motion disagree",
    .width = FIG_PAGE_WIDTH,
    .height = 204,
    .draw = draw,
};
