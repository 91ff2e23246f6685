// What the figures of the response print.
#include "figures/numbers.h"

#include "kit/cloth_run.h"
#include "support/queries.h"

enum {
    BEADS = 16
};

/// Rounds of one impulse for each pair that meets, worked out on a line.
static int rounds_alone(int beads)
{
    double d[BEADS + 1] = {1};
    for (int rounds = 0;; rounds++) {
        bool met[BEADS], any = false;
        for (int i = 0; i < beads; i++)
            any |= met[i] = d[i] >= d[i + 1] + 0x1p-10;
        if (!any)
            return rounds;
        for (int i = 0; i < beads; i++)
            if (met[i] && d[i] > d[i + 1]) {
                d[i] = i + 1 < beads ? (d[i] + d[i + 1]) / 2 : 0;
                if (i + 1 < beads)
                    d[i + 1] = d[i];
            }
    }
}

static void single_impulses_take_these_rounds(void)
{
    for (int beads = 2; beads <= BEADS; beads++)
        expect(rounds_alone(beads), "alone_%d", beads);
}

// Rows for one pair -----------------------------------------------------------

enum {
    PAIRS = 4000,
    ROUNDS = 50,
    VERTICES = 3, ///< the point, then the edge's
    ROWS = 4      ///< the library's choice parts every pair that these do
};

static const char *const rows[ROWS] = {"coordinates", "gradient", "pivots",
                                       "both"};

/// A point and an edge, as the figure makes them.
typedef struct pair {
    double start[VERTICES][2], move[VERTICES][2];
} pair;

static double up_to(generator *random, double most)
{
    return uniform(random, -most, most);
}

static pair make_pair(generator *random, double deformation)
{
    pair p;
    double way[2], apart[2], square;
    do {
        way[0] = up_to(random, 1);
        way[1] = up_to(random, 1);
        square = way[0] * way[0] + way[1] * way[1];
    } while (square > 1 || square < 1e-4);
    for (int k = 0; k < 2; k++)
        apart[k] = up_to(random, 0.2);
    for (int v = 0; v < VERTICES; v++)
        for (int k = 0; k < 2; k++) {
            p.start[v][k] = up_to(random, 0.5) + (v == 0 ? apart[k] : 0);
            p.move[v][k] = up_to(random, deformation) +
                           (v == 0 ? way[k] / sqrt(square) : 0);
        }
    return p;
}

/// A contact: of the sweep's triangle with the pivot e_1 or e_0.
typedef struct meeting {
    int pivot;
    double time, coordinate, normal[2]; ///< the coordinate of e_1
} meeting;

static double cross(const double a[2], const double b[2])
{
    return a[0] * b[1] - a[1] * b[0];
}

/// The edge at the pivot's time, turned left, of length 1.
static void find_normal(const pair *p, int pivot, double normal[2])
{
    double along[2];
    for (int k = 0; k < 2; k++)
        along[k] = p->start[2][k] - p->start[1][k] +
                   (pivot == 0 ? p->move[2][k] - p->move[1][k] : 0);
    normal[0] = -along[1] / hypot(along[0], along[1]);
    normal[1] = along[0] / hypot(along[0], along[1]);
}

/// The first time that the origin is in a triangle of the sweep of the edge as
/// seen from the point.
static bool meets(const pair *p, meeting *found)
{
    double seen[2][2][2]; // by end and time
    for (int i = 0; i < 8; i++) {
        int e = i / 4, t = i / 2 % 2, k = i % 2;
        seen[e][t][k] = p->start[e + 1][k] - p->start[0][k] +
                        t * (p->move[e + 1][k] - p->move[0][k]);
    }
    found->time = 2;
    for (int pivot = 1; pivot >= 0; pivot--) {
        const double *corner[3] = {seen[0][0], seen[pivot][1 - pivot],
                                   seen[1][1]};
        double part[3], sum = 0;
        for (int i = 0; i < 3; i++)
            sum += part[i] = cross(corner[(i + 1) % 3], corner[(i + 2) % 3]);
        for (int i = 0; i < 3; i++)
            part[i] /= sum;
        double time = part[2] + (pivot == 0 ? part[1] : 0);
        if (part[0] < 0 || part[1] < 0 || part[2] < 0 || time >= found->time)
            continue;
        *found = (meeting){.pivot = pivot,
                           .time = time,
                           .coordinate = part[2] + (pivot == 1 ? part[1] : 0)};
        find_normal(p, pivot, found->normal);
    }
    return found->time <= 1;
}

/// Pushes follow `share`, and make the sum of `want` times the displacements 0.
static void make_row(const pair *p, const meeting *m, int row,
                     double share[VERTICES], double want[VERTICES],
                     double normal[2])
{
    double w = m->coordinate, t = m->time, late = fmin(t, w), side = 0;
    const double coefficients[ROWS][VERTICES] = {{1, w - 1, -w},
                                                 {t, late - t, -late},
                                                 {1, m->pivot - 1, -m->pivot},
                                                 {1, w - 1, -w}};
    for (int k = 0; k < 2; k++)
        for (int v = 0; v < VERTICES; v++)
            side += m->normal[k] * coefficients[row == 2 ? 2 : 0][v] *
                    p->start[v][k];
    for (int k = 0; k < 2; k++)
        normal[k] = side < 0 ? -m->normal[k] : m->normal[k];
    memcpy(share, coefficients[row], sizeof coefficients[row]);
    memcpy(want, coefficients[row == 3 ? 1 : row], sizeof coefficients[row]);
}

/// Push until the pair is apart: how often, or -1.
static int part(pair *p, int row)
{
    for (int round = 0; round <= ROUNDS; round++) {
        meeting m;
        if (!meets(p, &m))
            return round;
        double share[VERTICES], want[VERTICES], normal[2];
        double parting = 0, compliance = 0;
        make_row(p, &m, row, share, want, normal);
        for (int v = 0; v < VERTICES; v++) {
            parting += want[v] *
                       (normal[0] * p->move[v][0] + normal[1] * p->move[v][1]);
            compliance += share[v] * want[v];
        }
        if (parting >= -1e-12)
            return -1;
        for (int v = 0; v < VERTICES; v++)
            for (int k = 0; k < 2; k++)
                p->move[v][k] -= parting / compliance * share[v] * normal[k];
    }
    return -1;
}

static double change_of_shape(const pair *before, const pair *after)
{
    double d[2];
    for (int k = 0; k < 2; k++)
        d[k] = after->move[2][k] - before->move[2][k] - after->move[1][k] +
               before->move[1][k];
    return hypot(d[0], d[1]);
}

/// Pairs that stay stuck, and the mean rounds and change of shape of those that
/// every kind of row has parted.
static void expect_rows(double deformation)
{
    generator random = {.state = 1};
    double stuck[ROWS] = {0}, rounds[ROWS] = {0}, change[ROWS] = {0};
    int parted = 0;
    for (int i = 0; i < PAIRS;) {
        pair p = make_pair(&random, deformation), pushed[ROWS];
        meeting m;
        if (!meets(&p, &m))
            continue;
        i++;
        int took[ROWS], least = ROUNDS;
        for (int row = 0; row < ROWS; row++) {
            pushed[row] = p;
            took[row] = part(&pushed[row], row);
            stuck[row] += took[row] < 0;
            least = took[row] < least ? took[row] : least;
        }
        parted += least >= 0;
        for (int row = 0; least >= 0 && row < ROWS; row++) {
            rounds[row] += took[row];
            change[row] += change_of_shape(&p, &pushed[row]);
        }
    }
    // What is at a limit may be stuck or not, as rounding has it.
    for (int row = 0; row < ROWS; row++) {
        expect_within(2e-3, rounds[row] / parted, "rounds_%s_pe_%g", rows[row],
                      deformation);
        expect_within(2e-3, change[row] / parted, "change_%s_pe_%g", rows[row],
                      deformation);
        expect_within(0.6, 1000 * stuck[row] / PAIRS, "stuck_%s_pe_%g",
                      rows[row], deformation);
    }
}

static void rows_do_what_is_told(void)
{
    static const char *const kinds[] = {"pe", "pt", "ee"};
    static const double deformation[] = {0.01, 0.1, 1};
    expect_rows(0.1);
    expect_rows(1);
    for (int i = 0; i < 27; i++)
        expect(0, "gained_%s_%s_%g", rows[i / 9], kinds[i / 3 % 3],
               deformation[i % 3]);
}

// Single contacts -------------------------------------------------------------

/// When the point meets the edge whose right end rises by `height`.
static double time_of_rise(double height)
{
    tf_worldline v[3];
    const double ways[][4] = {{0.5, 0.2, 0.5, 0.2}, {1, 0, 1, height}, {0}};
    make_vertices(2, 3, *ways, v);
    return oracle_time(2, 1, v, 2, v + 1);
}

static void half_the_step_has_a_contact_and_a_quarter_has_none(void)
{
    expect(time_of_rise(1), "toi");
    ck_assert_double_gt(time_of_rise(0.5), 0);
    ck_assert_double_eq(time_of_rise(0.25), -1);
}

/// When the fly and the plank meet, as their displacements are printed.
static void times_are_those_of_the_displacements(void)
{
    static const char *const states[] = {"proposed", "gradient", "coordinates"};
    for (int i = 0; i < 3; i++) {
        double ways[][4] = {{0, 0.125, 0, 0.125}, {-2, 0, -2, 0}, {2, 0, 2, 0}};
        tf_worldline v[3];
        for (int k = 0; k < 3; k++)
            ways[k][3] += number("move_%d_%s", k, states[i]);
        make_vertices(2, 3, *ways, v);
        expect(oracle_time(2, 1, v, 2, v + 1), "toi_%s", states[i]);
    }
}

static void each_bar_moves_less(void)
{
    for (int round = 0; round < (int)number("bars"); round++)
        expect(1.0 / (round + 1), "displacement_%d", round);
}

static void points_are_met_farther_and_farther(void)
{
    for (int round = 1; round <= (int)number("vertices") - 2; round++) {
        double far = 0.4 + 0.2 * round;
        expect_within(1e-12, round % 2 == 0 ? far : -far, "displacement_%d",
                      round);
    }
}

/// The pair meets as proposed, and not as it was pushed.
static void expect_failure(const char *failure, double ways[3][4])
{
    tf_worldline v[3];
    make_vertices(2, 3, *ways, v);
    expect(oracle_time(2, 1, v, 2, v + 1), "%s_toi", failure);
    for (int i = 0; i < 3; i++) {
        ways[i][2] = number("%s_end_%d_x", failure, i);
        ways[i][3] = number("%s_end_%d_y", failure, i);
    }
    make_vertices(2, 3, *ways, v);
    ck_assert_double_eq(oracle_time(2, 1, v, 2, v + 1), -1);
}

static void pairs_meet_until_they_are_pushed(void)
{
    double seesaw[][4] = {{0, 1, 0, 1}, {-2, 2, -2, -2}, {2, -2, 2, 2}};
    double turn[][4] = {{1, 1, 1, -2}, {0, 0, 1, 2}, {4, 0, 2, -2}};
    double slide[][4] = {{0, 0, 2, 0}, {1, 0, 1, 0}, {3, 0, 3, 0}};
    expect_failure("seesaw", seesaw);
    expect_failure("turn", turn);
    expect_failure("slide", slide);
}

static void the_turned_pair_meets_when_the_oracle_says(void)
{
    double angle = number("angle") * PI / 180, c = cos(angle), s = sin(angle);
    const double x = 0.62, y = 0.1;
    tf_worldline v[3];
    const double ways[][4] = {
        {x, y, c * x - s * y, s * x + c * y}, {0}, {1, 0, c, s}};
    make_vertices(2, 3, *ways, v);
    expect(oracle_time(2, 1, v, 2, v + 1), "toi");
}

/// One vertex moves by 1 at a time.
static void turns_are_those_of_the_staircase(void)
{
    const double weight[] = {number("w_0"), number("w_1"), number("w_2")};
    for (int i = 0; i < 3; i++) {
        tf_worldline vertex[3];
        double ways[3][4] = {{0}}, place[2];
        ways[i][2] = 1;
        make_vertices(2, 3, *ways, vertex);
        staircase_point(2, 3, vertex, weight, number("toi"), place);
        expect(place[0], "b_%d", i);
    }
}

static void distances_of_two_rows_are_those_of_geometry(void)
{
    const double u = 0.3, v = 0.42, p[2] = {-0.35, -0.25};
    const double angle = PI * 7 / 180, s = sin(angle), c = cos(angle);
    double lack[2] = {u - p[1], v - s * p[0] - c * p[1]};

    // The second row is the farther one, and to satisfy it satisfies the first.
    ck_assert_double_gt(p[1] + lack[1] * c, u);
    expect(lack[1], "nearest");
    double crossing[2] = {(v - c * u) / s, u};
    expect_within(1e-6, hypot(crossing[0] - p[0], crossing[1] - p[1]),
                  "second");

    // One iteration of conjugate residuals: along b, to the least residual.
    double image[2] = {lack[0] + c * lack[1], c * lack[0] + lack[1]};
    double step = (lack[0] * image[0] + lack[1] * image[1]) /
                  (image[0] * image[0] + image[1] * image[1]);
    expect_within(1e-9, step * hypot(s * lack[1], lack[0] + c * lack[1]),
                  "first");
}

static void a_run_counts_every_intersection(void)
{
    const fig_cloth_plan plan = {
        .scene = "twist", .size = 3, .steps = 350, .check = 1};
    fig_cloth_plan other = plan;
    other.unresolved = true;
    const fig_cloth_run *run = fig_cloth_run_of(&plan);
    const fig_cloth_run *tangled = fig_cloth_run_of(&other);
    int found = 0;
    for (int i = 0; i <= plan.steps; i++) {
        ck_assert_int_eq(run->step[i].crossings, 0);
        found += tangled->step[i].crossings;
    }
    ck_assert_int_gt(found, 0);
    ck_assert_int_gt(fig_cloth_run_count(run, TF_ZONES), 0);
    ck_assert_int_eq(fig_cloth_run_count(tangled, TF_ZONES), 0);
    ck_assert_ptr_eq(fig_cloth_run_of(&plan), run);
}

// Rest, bounces and slopes ----------------------------------------------------

static const double gravity = 9.81;

/// How a body moves on a line above the floor at 0: millimeters and steps.
typedef struct body_on_a_line {
    double step, restitution, height, displacement;
    bool hops;
} body_on_a_line;

static void answer_on_a_line(body_on_a_line *b, double approach)
{
    double half = fmin(5, approach / 2), wanted = b->hops ? 5 : half;
    double room = fmax(0, (wanted - b->height) / 4);
    b->displacement = b->hops ? room : b->restitution * approach;
    b->height += fmax(room, b->displacement);
}

static void go_on_a_line(body_on_a_line *b)
{
    double d = b->displacement - 1000 * gravity * b->step * b->step;
    if (b->height + d <= 0) {
        answer_on_a_line(b, -d);
        return;
    }
    b->height += d;
    b->displacement = d;
}

static void expect_second(double milliseconds, bool hops)
{
    const char *panel = hops ? "hops" : "rests";
    body_on_a_line b = {
        .step = milliseconds / 1000, .height = 0.2, .hops = hops};
    double most = b.height;
    for (int i = 0; i < (int)lround(1 / b.step); i++) {
        go_on_a_line(&b);
        most = fmax(most, b.height);
    }
    double speed = fabs(b.displacement) / milliseconds;
    // The response rounds, and each hop is as high as the last one lets it be.
    double tolerance = hops ? 1e-3 : 1e-9;
    expect_within(tolerance, most, "most_%s_%g", panel, milliseconds);
    expect_within(tolerance, b.height, "last_%s_%g", panel, milliseconds);
    expect_within(tolerance, speed, "speed_%s_%g", panel, milliseconds);
}

static void the_bar_moves_as_on_a_line(void)
{
    static const double milliseconds[] = {0.25, 1, 2.5, 10};
    for (int i = 0; i < 8; i++)
        expect_second(milliseconds[i / 2], i % 2 == 0);
    body_on_a_line b = {.step = 0.001, .restitution = 0.5, .height = 500};
    for (int found = 0; found < 3;) {
        double last = b.height, rose = b.displacement;
        go_on_a_line(&b);
        if (rose > 0 && b.height < last)
            expect_within(1e-4, last, "apex_%d", ++found);
    }
}

static void sheets_slide_as_mechanics_says(void)
{
    static const double friction[] = {0.2, 0.4, 0.6, 0.8};
    int sticking = 0;
    for (int i = 0; i < 4; i++) {
        double way = gravity / 2 * (0.5 - friction[i] * sqrt(0.75));
        expect(fmax(0, way) * (1 + 1.0 / 400), "slid_%g", friction[i]);
        for (int k = 1; k <= 24; k++)
            sticking += tan(2 * k * PI / 180) <= friction[i];
    }
    expect(sticking, "sticking");
    expect(96 - sticking, "sliding");
}

/// A particle stops where gravity has worked as much as friction, which rises with
/// the root of the distance from 1 to 2 and is constant from there on.
static double stop_of(double friction)
{
    double along = sin(25 * PI / 180);
    double across = sqrt(friction) * cos(25 * PI / 180);
    return across * (2 - 2.0 / 3) / (across - along);
}

static void rough_particles_stop_where_mechanics_says(void)
{
    expect_within(0.005, stop_of(0.5), "stopped_0.5");
    expect_within(0.005, stop_of(1), "stopped_1");
}

const figure_test response_tests[] = {
    {&fig_kept_rows, single_impulses_take_these_rounds},
    {&fig_kinds_of_rows, rows_do_what_is_told},
    {&fig_clear_fractions, half_the_step_has_a_contact_and_a_quarter_has_none},
    {&fig_rising_plank, times_are_those_of_the_displacements},
    {&fig_failsafe_bars, each_bar_moves_less},
    {&fig_row_failures, pairs_meet_until_they_are_pushed},
    {&fig_thrown_edge, points_are_met_farther_and_farther},
    {&fig_turned_together, the_turned_pair_meets_when_the_oracle_says},
    {&fig_shares_over_time, turns_are_those_of_the_staircase},
    {&fig_nearly_parallel_rows, distances_of_two_rows_are_those_of_geometry},
    {&fig_resting_bar, the_bar_moves_as_on_a_line},
    {&fig_slopes, sheets_slide_as_mechanics_says},
    {&fig_greased_slope, rough_particles_stop_where_mechanics_says},
    {&fig_twisted_strips, a_run_counts_every_intersection},
    {NULL, NULL}};
