// How often staircase motion and linear motion disagree, by how far things
// move: random points and edges in the plane.
#include "figures.h"

#include "arithmetic/exact.h"
#include "query/point_edge.h"
#include "stage/plot.h"

#include <math.h>
#include <stdint.h>

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

// Random queries ---------------------------------------------------------

/// The next of a sequence of numbers in 0..1 (Steele, Lea and Flood's
/// splitmix64).
static double next_random(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return (double)((z ^ z >> 31) >> 11) * 0x1p-53;
}

static void make_query(uint64_t *state, double displacement,
                       tf_worldline vertex[VERTICES])
{
    for (int i = 0; i < VERTICES; i++) {
        double start[2], end[2];
        for (int k = 0; k < 2; k++) {
            start[k] = next_random(state);
            end[k] = start[k] + displacement * (2 * next_random(state) - 1);
        }
        vertex[i] = tf_worldline_between(2, start, end);
    }
}

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

// The comparison ---------------------------------------------------------

static count compare(double displacement)
{
    count n = {0, 0, 0};
    uint64_t state = 1;
    for (int i = 0; i < QUERIES; i++) {
        tf_worldline vertex[VERTICES];
        tf_contact contact;
        make_query(&state, displacement, vertex);
        tf_point_edge(&tf_exact, &vertex[0], &vertex[1], &contact);
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
    } line[] = {{"hits", (double)n->hits / QUERIES},
                {"extra", (double)n->extra},
                {"fewer", (double)n->fewer},
                {"differ", (double)(n->extra + n->fewer) / QUERIES},
                {"one_in", QUERIES / (double)(n->extra + n->fewer)},
                {"share", (double)(n->extra + n->fewer) / (double)n->hits}};
    for (size_t i = 0; i < sizeof line / sizeof *line; i++) {
        char key[32];
        snprintf(key, sizeof key, "%s_%g", line[i].key, displacement);
        tf_figure_number(numbers, key, line[i].number);
    }
}

static void draw(tf_page *page, FILE *numbers)
{
    double hits[SIZES][2], differ[SIZES][2];
    tf_figure_number(numbers, "queries", QUERIES);
    for (int i = 0; i < SIZES; i++) {
        count n = compare(size[i]);
        print_count(size[i], &n, numbers);
        hits[i][0] = differ[i][0] = size[i];
        hits[i][1] = (double)n.hits / QUERIES;
        differ[i][1] = (double)(n.extra + n.fewer) / QUERIES;
    }
    double width = tf_page_width(page), height = tf_page_height(page);
    tf_plot plot = {.box = {52, 10, width - 72, height - 48},
                    .x = {0.008, 4},
                    .y = {1e-5, 1},
                    .log_x = true,
                    .log_y = true,
                    .name_x = "displacement, in widths of the scene",
                    .name_y = "fraction of the queries"};
    tf_plot_frame(page, &plot);
    tf_plot_curve(page, &plot, SIZES, (const double(*)[2])hits,
                  (tf_stroke){.paint = {.role = TF_ROLE_EDGE}});
    tf_plot_curve(page, &plot, SIZES, (const double(*)[2])differ,
                  (tf_stroke){.paint = {.role = TF_ROLE_CONTACT}});
    for (int i = 0; i < SIZES; i++) {
        double at[2][2];
        tf_plot_place(&plot, hits[i][0], hits[i][1], at[0]);
        tf_page_dot(page, at[0][0], at[0][1], 4,
                    (tf_paint){.role = TF_ROLE_EDGE});
        if (differ[i][1] <= 0)
            continue;
        tf_plot_place(&plot, differ[i][0], differ[i][1], at[1]);
        tf_page_dot(page, at[1][0], at[1][1], 4,
                    (tf_paint){.role = TF_ROLE_CONTACT});
    }
    double at[2][2];
    tf_plot_place(&plot, size[3], hits[3][1], at[0]);
    tf_plot_place(&plot, size[3], differ[3][1], at[1]);
    tf_page_label(
        page, at[0][0], at[0][1],
        (tf_label){
            .text = "hit", .role = TF_ROLE_EDGE, .side = TF_SIDE_NW, .gap = 4});
    tf_page_label(page, at[1][0], at[1][1],
                  (tf_label){.text = "hit in one motion only",
                             .role = TF_ROLE_CONTACT,
                             .side = TF_SIDE_SE,
                             .gap = 4});
}

const tf_figure tf_figure_models_apart = {
    .name = "models-apart",
    .title = "How often staircase and linear motion disagree",
    .width = TF_FIGURE_WIDTH,
    .height = 204,
    .draw = draw,
};
