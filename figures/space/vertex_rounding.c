// A point that passes exactly through the vertex that two edges share: where
// rounding puts it on either edge, and how often it slips between both.
#include "kit/figures.h"

#include "arithmetic/exact.h"
#include "base/require.h"
#include "kit/random.h"
#include "linear/linear_pair.h"
#include "linear/quadratic.h"
#include "query/point_edge.h"
#include "renderer/plot.h"

#include <math.h>

enum {
    SCENES = 2000,
    VERTICES = 4, ///< the point, the shared vertex, the other two
    EDGES = 2
};

static const double unit = 0x1p-53;
static const double reach = 6; ///< of the plot, in units of roundoff

/// The vertices at t = 0 and at t = 1.  The point and the shared vertex are at
/// one place at t = 1/3.
typedef struct scene {
    double start[VERTICES][2], end[VERTICES][2];
} scene;

static double random_integer(uint64_t *state)
{
    return rint(ldexp(fig_random_number(state) - 0.5, 21));
}

static scene random_scene(uint64_t *state)
{
    scene s;
    for (int i = 0; i < VERTICES; i++)
        for (int k = 0; k < 2; k++) {
            s.start[i][k] = random_integer(state);
            s.end[i][k] = random_integer(state);
        }
    for (int k = 0; k < 2; k++)
        s.end[0][k] = 2 * s.start[1][k] + s.end[1][k] - 2 * s.start[0][k];
    return s;
}

static const int edges[EDGES][2] = {{1, 2}, {1, 3}};

static tf_motion motion_of(const scene *s)
{
    return (tf_motion){2, VERTICES, s->start[0], s->end[0]};
}

static bool hits(const scene *s, int edge, double tolerance)
{
    tf_motion motion = motion_of(s);
    tf_contact contact;
    tf_status status =
        tf_quadratic_point_edge(&(tf_tolerances){.barycentric = tolerance},
                                &motion, 0, edges[edge], &contact);
    TF_REQUIRE(status == TF_OK);
    return contact.verdict == TF_HIT;
}

/// Whether exact signs find the contact.
static bool hits_exactly(const scene *s, int edge)
{
    tf_motion motion = motion_of(s);
    tf_contact contact;
    tf_status status =
        tf_point_edge(&tf_exact, &motion, 0, edges[edge], &contact);
    TF_REQUIRE(status == TF_OK);
    return contact.verdict == TF_HIT;
}

/// The barycentric coordinate of the far end at the rounded root, as the test
/// of proximity computes it.
static double far_coordinate(const scene *s, int edge)
{
    tf_motion motion = motion_of(s);
    tf_contact contact;
    tf_status status =
        tf_quadratic_point_edge(&(tf_tolerances){.barycentric = 1e-6}, &motion,
                                0, edges[edge], &contact);
    TF_REQUIRE(status == TF_OK && contact.verdict == TF_HIT);
    tf_linear_pair elements;
    tf_vector x[TF_LINEAR_PAIR_VERTICES];
    double weight[TF_LINEAR_PAIR_VERTICES];
    status = tf_linear_pair_take(2, &motion, 1, (const int[]){0}, 2,
                                 edges[edge], &elements);
    tf_linear_pair_positions(&elements, contact.toi_lo, x);
    TF_REQUIRE(status == TF_OK && tf_crossing_weights(1, 2, x, weight));
    return weight[2];
}

/// How many scenes there are of each kind.
typedef struct counts {
    int both, one, none, exact;
} counts;

static void count_scene(const scene *s, double tolerance, counts *c)
{
    int found = hits(s, 0, tolerance) + hits(s, 1, tolerance);
    c->both += found == 2;
    c->one += found == 1;
    c->none += found == 0;
    c->exact += hits_exactly(s, 0) || hits_exactly(s, 1);
}

/// A dot where the point is on either edge, in units of roundoff.
static void draw_dot(fig_page *page, const fig_plot *plot, const scene *s)
{
    double x = far_coordinate(s, 0) / unit, y = far_coordinate(s, 1) / unit;
    int found = hits(s, 0, 0) + hits(s, 1, 0);
    if (fabs(x) > reach || fabs(y) > reach)
        return;
    fig_plot_dot(page, plot, x, y, 2.2,
                 found == 0   ? FIG_ROLE_CONTACT
                 : found == 1 ? FIG_ROLE_OTHER_EDGE
                              : FIG_ROLE_EDGE);
}

static void print_counts(FILE *numbers, const char *key, const counts *c)
{
    char name[32];
    const struct {
        const char *name;
        int count;
    } print[] = {{"both", c->both}, {"one", c->one}, {"none", c->none}};
    for (int i = 0; i < 3; i++) {
        snprintf(name, sizeof name, "%s_%s", print[i].name, key);
        fig_number(numbers, name, print[i].count);
    }
}

static void draw_keys(fig_page *page, const counts *c)
{
    const struct {
        const char *name;
        int count;
        fig_role role;
    } keys[] = {{"both edges hit", c->both, FIG_ROLE_EDGE},
                {"one edge hit", c->one, FIG_ROLE_OTHER_EDGE},
                {"none: slips through", c->none, FIG_ROLE_CONTACT}};
    for (int i = 0; i < 3; i++) {
        char text[64];
        snprintf(text, sizeof text, "%s, %d", keys[i].name, keys[i].count);
        fig_plot_key(page, 256, 60 + 24 * i, text, keys[i].role);
    }
}

static void draw(fig_page *page, FILE *numbers)
{
    fig_plot plot = {.box = {46, 8, 186, 186},
                     .x = {-reach, reach},
                     .y = {-reach, reach},
                     .name_x = "$s$ on one edge, in $u$",
                     .name_y = "$s$ on the other, in $u$"};
    uint64_t state = 1997;
    counts zero = {0}, tolerant = {0};
    fig_plot_frame(page, &plot);
    fig_plot_level(page, &plot, 0);
    for (int i = 0; i < SCENES; i++) {
        scene s = random_scene(&state);
        count_scene(&s, 0, &zero);
        count_scene(&s, 0x1p-40, &tolerant);
        draw_dot(page, &plot, &s);
    }
    draw_keys(page, &zero);
    print_counts(numbers, "zero", &zero);
    print_counts(numbers, "tolerant", &tolerant);
    fig_number(numbers, "scenes", SCENES);
    fig_number(numbers, "exact", zero.exact);
}

const fig_figure fig_vertex_rounding = {
    .name = "vertex-rounding",
    .title = "Where rounding puts a point that passes through a vertex",
    .width = FIG_PAGE_WIDTH,
    .height = 232,
    .draw = draw,
};
