// What falls comes to rest, bounces, sticks or slides as mechanics says, in
// steps of any length: the velocities are those of tf_resolver_unpushed.
#include "response/resolve.h"

#include "simulate/coupling.h"
#include "simulate/dynamics.h"
#include "support/memory.h"
#include "support/support.h"
#include "support/surface_of.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double gravity = 9.81;

// A world ---------------------------------------------------------------------

/// Bodies that fall upon what is scripted to stay.
typedef struct world {
    tf_body body;
    double step; ///< in seconds
    tf_response_options options;
    tf_surface *surface;
    tf_resolver *resolver;
    bool coupled; ///< whether the response knows of what is elastic
    tf_coupling *coupling;
    tf_dynamics *dynamics;
    double *velocity, *end, *inverse_mass;
} world;

/// The body, the step and the options are set.
static void begin(world *w)
{
    const tf_body *body = &w->body;
    size_t numbers = (size_t)(body->axes * body->vertices);
    tf_mesh mesh = tf_body_mesh(body);
    ck_assert(!body->failed);
    w->surface = surface_of(&mesh);
    ck_assert_int_eq(tf_resolver_create(w->surface, &w->resolver), TF_OK);
    ck_assert_int_eq(tf_dynamics_create(body, w->step, &w->dynamics), TF_OK);
    ck_assert_int_eq(
        tf_coupling_create(body, w->step, w->resolver, &w->coupling), TF_OK);
    w->velocity = allocate(numbers, sizeof(double));
    w->end = allocate(numbers, sizeof(double));
    w->inverse_mass = allocate((size_t)body->vertices, sizeof(double));
    for (int v = 0; v < body->vertices; v++)
        w->inverse_mass[v] = body->mass[v] > 0 ? 1 / body->mass[v] : 0;
}

static void finish(world *w)
{
    tf_dynamics_free(w->dynamics);
    tf_coupling_free(w->coupling);
    tf_resolver_free(w->resolver);
    tf_surface_free(w->surface);
    tf_body_free(&w->body);
    free(w->velocity);
    free(w->end);
    free(w->inverse_mass);
}

static void fall(world *w)
{
    const tf_body *body = &w->body;
    for (int i = 0; i < body->axes * body->vertices; i++) {
        bool up = i % body->axes == body->axes - 1;
        if (up && body->mass[i / body->axes] > 0)
            w->velocity[i] -= gravity * w->step;
        w->end[i] = body->position[i] + w->step * w->velocity[i];
    }
}

static void resolve(world *w)
{
    const tf_body *body = &w->body;
    tf_response_report report;
    tf_status status =
        w->coupled
            ? tf_coupling_resolve(w->coupling, body->position, w->end,
                                  w->inverse_mass, &w->options, NULL, &report)
            : tf_step_resolve(w->resolver, body->vertices, body->position,
                              w->end, w->inverse_mass, &w->options, NULL, NULL);
    ck_assert_int_eq(status, TF_OK);
}

static void go_on(world *w)
{
    tf_body *body = &w->body;
    fall(w);
    ck_assert_int_eq(tf_dynamics_step(w->dynamics, w->end, 10), TF_OK);
    resolve(w);
    const double *to = tf_resolver_unpushed(w->resolver);
    for (int i = 0; i < body->axes * body->vertices; i++) {
        w->velocity[i] = (to[i] - body->position[i]) / w->step;
        body->position[i] = w->end[i];
    }
}

// On a floor ------------------------------------------------------------------

/// In the plane: a floor, and above it a bar of 10 cm; the separation is what is
/// usual for the bar, 5 mm.
static void drop_bar(world *w, double height, double step)
{
    *w = (world){.body.axes = 2,
                 .step = step,
                 .options = {.size = sizeof w->options, .separation = 0.005}};
    tf_body_add_vertex(&w->body, (double[]){-1, 0});
    tf_body_add_vertex(&w->body, (double[]){1, 0});
    tf_body_add_edge(&w->body, 0, 1);
    for (int v = 2; v < 4; v++) {
        tf_body_add_vertex(&w->body, (double[]){0.1 * v, height});
        w->body.mass[v] = 0.5;
    }
    tf_body_add_edge(&w->body, 2, 3);
}

static double bar_height(const world *w)
{
    return fmax(w->body.position[5], w->body.position[7]);
}

static double bar_speed(const world *w)
{
    return fmax(fabs(w->velocity[5]), fabs(w->velocity[7]));
}

// In a step of 10 ms gravity draws by 0.98 mm, and the bar comes to rest at half
// of that.  Shorter steps draw by less, and the bar stays where it arrived.
START_TEST(a_bar_comes_to_rest)
{
    static const double steps[] = {0.01, 0.0025, 0.001, 0.00025};
    double most = 0, late = 0;
    world w;
    drop_bar(&w, 0.0002, steps[_i]);
    begin(&w);
    for (int i = 0; i * w.step < 1; i++) {
        go_on(&w);
        most = fmax(most, bar_height(&w));
        late = i * w.step > 0.5 ? fmax(late, bar_speed(&w)) : 0;
    }
    printf("bar, step %g s: at most %g m, at last %g m, %g m/s late\n", w.step,
           most, bar_height(&w), late);
    ck_assert_double_le(most, 0.0006);
    ck_assert_double_lt(late, 1e-12);
    if (_i == 0)
        ck_assert_double_eq_tol(bar_height(&w), gravity * 0.00005, 1e-9);
    finish(&w);
}
END_TEST

/// Lets a bar fall and finds how high it rises after each time that it bounces.
static void find_apexes(world *w, int count, double apex[])
{
    double last = bar_height(w);
    bool rises = false;
    for (int found = 0; found < count;) {
        go_on(w);
        double height = bar_height(w);
        if (rises && height < last)
            apex[found++] = last;
        rises = height > last;
        last = height;
    }
}

static const struct {
    double restitution;
    int bounces; ///< as long as the way of a step is much less than the apex
} bounces[] = {{0.5, 2}, {0.7, 4}, {0.9, 9}};

START_TEST(apexes_fall_by_the_square_of_restitution)
{
    double apex[9], last = 0.5, e = bounces[_i].restitution;
    world w;
    drop_bar(&w, last, 0.001);
    w.options.restitution = e;
    begin(&w);
    find_apexes(&w, bounces[_i].bounces, apex);
    for (int i = 0; i < bounces[_i].bounces; i++) {
        printf("restitution %g: %g m\n", e, apex[i]);
        ck_assert_double_eq_tol(apex[i] / last, e * e, 0.05 * e * e);
        last = apex[i];
    }
    finish(&w);
}
END_TEST

// Of what gravity gives in a step, 1 / (1 - restitution) can go on forever, and
// twice as much is no bounce.
START_TEST(a_threshold_brings_bounces_to_an_end)
{
    static const double restitution[] = {0.2, 0.5, 0.7, 0.8, 0.9};
    double e = restitution[_i];
    double late[2] = {0};
    for (int with = 0; with < 2; with++) {
        world w;
        drop_bar(&w, 0.05, 0.001);
        w.options.restitution = e;
        w.options.restitution_threshold =
            with * 2 * gravity * w.step * w.step / (1 - e);
        begin(&w);
        for (int i = 0; i < 6000; i++) {
            go_on(&w);
            late[with] = i > 5000 ? fmax(late[with], bar_speed(&w)) : 0;
        }
        finish(&w);
    }
    printf("restitution %g: late speeds of %g m/s without a threshold, %g with "
           "one\n",
           e, late[0], late[1]);
    ck_assert_double_gt(late[0], 0);
    ck_assert_double_lt(late[1], 1e-12);
}
END_TEST

// On slopes -------------------------------------------------------------------

/// A slope of two triangles, with friction.
typedef struct slope {
    double angle, friction;
    world w;
} slope;

/// A point of the slope's own axes: down, across, and off the slope.
static void add_vertex(slope *s, double down, double across, double off,
                       double mass)
{
    double sine = sin(s->angle), cosine = cos(s->angle);
    tf_body_add_vertex(&s->w.body,
                       (double[]){down * cosine + off * sine, across,
                                  off * cosine - down * sine});
    s->w.body.mass[s->w.body.vertices - 1] = mass;
}

static void begin_slope(slope *s, int number, double step)
{
    *s = (slope){.angle = (5 + number / 8 * 5) * acos(-1) / 180,
                 .friction = (1 + number % 8) * 0.1,
                 .w = {.body.axes = 3, .step = step}};
    s->w.options.friction = s->friction;
    s->w.options.separation = 0.01;
    add_vertex(s, -1, -3, 0, 0);
    add_vertex(s, 20, -3, 0, 0);
    add_vertex(s, 20, 3, 0, 0);
    add_vertex(s, -1, 3, 0, 0);
    tf_body_add_triangle(&s->w.body, 0, 1, 2);
    tf_body_add_triangle(&s->w.body, 0, 2, 3);
}

/// So near that the first step has contacts.
static double gap_of(const slope *s)
{
    return 0.25 * gravity * cos(s->angle) * s->w.step * s->w.step;
}

/// Vertices without any springs, 4 by 4, so far across the slope.
static void add_sheet(slope *s, double across)
{
    int first = s->w.body.vertices;
    for (int i = 0; i < 16; i++)
        add_vertex(s, 0.1 * (i % 4), 0.1 * (i / 4) + across, gap_of(s), 0.1);
    for (int i = 0; i < 9; i++) {
        int v = first + i / 3 * 4 + i % 3;
        tf_body_add_triangle(&s->w.body, v, v + 1, v + 4);
        tf_body_add_triangle(&s->w.body, v + 1, v + 5, v + 4);
    }
}

/// A cube of 10 cm: eight vertices, with a spring between any two.
static void add_cube(slope *s)
{
    static const int side[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                   {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    tf_body *body = &s->w.body;
    int first = body->vertices;
    for (int i = 0; i < 8; i++)
        add_vertex(s, 0.1 * (i & 1), 0.1 * (i >> 1 & 1) + 0.013,
                   0.1 * (i >> 2) + gap_of(s), 0.125);
    for (int i = 0; i < 8; i++)
        for (int j = 0; j < i; j++)
            tf_body_add_spring(body, first + i, first + j, 20000);
    for (int i = 0; i < 6; i++) {
        tf_body_add_triangle(body, first + side[i][0], first + side[i][1],
                             first + side[i][2]);
        tf_body_add_triangle(body, first + side[i][0], first + side[i][2],
                             first + side[i][3]);
    }
}

/// How far down the slope the vertices are that are not of the slope.
static double way_down(const slope *s)
{
    double sum = 0;
    for (int v = 4; v < s->w.body.vertices; v++) {
        const double *x = s->w.body.position + 3 * (ptrdiff_t)v;
        sum += x[0] * cos(s->angle) - x[2] * sin(s->angle);
    }
    return sum / (s->w.body.vertices - 4);
}

/// How far something slides in the first steps, each of which accelerates it
/// before it moves.
static double exact_way(const slope *s, int steps)
{
    double acceleration =
        gravity * (sin(s->angle) - s->friction * cos(s->angle));
    return fmax(0, acceleration) * s->w.step * s->w.step * steps *
           (steps + 1.0) / 2;
}

/// How far it slides in the time from `from` to 1 second, less the exact way;
/// `*exact` is set to the latter.
static double slide(slope *s, double from, double *exact)
{
    int steps = (int)lround(1 / s->w.step), settled = (int)(from * steps);
    double begins = 0;
    begin(&s->w);
    for (int i = 0; i < steps; i++) {
        if (i == settled)
            begins = way_down(s);
        go_on(&s->w);
    }
    *exact = exact_way(s, steps) - exact_way(s, settled);
    double wrong = way_down(s) - begins - *exact;
    finish(&s->w);
    return wrong;
}

static const double slope_steps[] = {0.01, 0.001};

// What is to stick stays within a micrometer, and what slides is right to 0.01 %.
START_TEST(free_vertices_stick_or_slide)
{
    int stuck = 0, wrong = 0;
    double most = 0;
    for (int i = 0; i < 64; i++) {
        slope s;
        double exact;
        begin_slope(&s, i, slope_steps[_i]);
        add_sheet(&s, 0.013);
        double error = fabs(slide(&s, 0, &exact));
        stuck += exact == 0;
        wrong += error > 1e-6 + 1e-4 * exact;
        most = fmax(most, error);
    }
    printf("sheet, step %g s: %d of 64 stick, %d are wrong, by up to %g m\n",
           slope_steps[_i], stuck, wrong, most);
    ck_assert_int_gt(stuck, 20);
    ck_assert_int_eq(wrong, 0);
}
END_TEST

// In a short step the gap of what rests is tiny, and much less than the way that
// something fast slides.  Still nothing may slow it down.
START_TEST(speed_is_kept_without_friction)
{
    static const double steps[] = {0.01, 0.0025, 0.001, 0.00025};
    const double speed = 20;
    slope s;
    begin_slope(&s, 0, steps[_i]);
    s = (slope){.w = s.w};
    s.w.options.friction = 0;
    for (int v = 0; v < 4; v++)
        s.w.body.position[3 * v + 2] = 0;
    add_sheet(&s, 0.013);
    begin(&s.w);
    for (int v = 4; v < s.w.body.vertices; v++)
        s.w.velocity[3 * v] = speed;
    double least = speed;
    for (int i = 0; i * s.w.step < 0.25; i++) {
        go_on(&s.w);
        for (int v = 4; v < s.w.body.vertices; v++)
            least = fmin(least, s.w.velocity[3 * v]);
    }
    printf("step %g s: of %g m/s at least %.17g are left\n", s.w.step, speed,
           least);
    ck_assert_double_ge(least, speed * (1 - 1e-9));
    finish(&s.w);
}
END_TEST

// A cube that is set down swings first.  Then it sticks, or is right to 5 %; one
// of them, on a slope that is hardly too steep, is off by 3 millimeters.
START_TEST(an_elastic_cube_sticks_or_slides)
{
    int wrong = 0, wrongly_moved = 0;
    for (int i = 0; i < 64; i++) {
        slope s;
        double exact;
        begin_slope(&s, i, 0.01);
        add_cube(&s);
        s.w.coupled = true;
        double error = fabs(slide(&s, 0.5, &exact));
        wrong += error > 0.001 + 0.05 * exact;
        wrongly_moved += exact == 0 && error > 0.001;
    }
    printf("cube: %d of 64 are wrong, %d of those should stick\n", wrong,
           wrongly_moved);
    ck_assert_int_le(wrong, 1);
    ck_assert_int_eq(wrongly_moved, 0);
}
END_TEST

// Friction of vertices --------------------------------------------------------

/// A slope whose left half is slippery and whose right half is rough, and a sheet
/// on each.
typedef struct halves {
    double slippery, rough, sheet; ///< coefficients
    bool turned;                   ///< triangles and corners in another order
    slope s;
    double own[100]; ///< of each vertex
} halves;

/// Two strips down the slope, of two triangles each, which do not touch.
static void add_strips(halves *h)
{
    slope *s = &h->s;
    static const double across[] = {-3, -0.1, 0.1, 3};
    for (int i = 0; i < 4; i++) {
        add_vertex(s, -1, across[i], 0, 0);
        add_vertex(s, 20, across[i], 0, 0);
    }
    for (int strip = 0; strip < 2; strip++) {
        int v = 4 * (h->turned ? 1 - strip : strip);
        if (h->turned) {
            tf_body_add_triangle(&s->w.body, v + 3, v + 2, v);
            tf_body_add_triangle(&s->w.body, v + 1, v + 3, v);
        } else {
            tf_body_add_triangle(&s->w.body, v, v + 1, v + 3);
            tf_body_add_triangle(&s->w.body, v, v + 3, v + 2);
        }
    }
}

static void begin_halves(halves *h, int degrees, double step)
{
    slope *s = &h->s;
    *s = (slope){.angle = degrees * acos(-1) / 180,
                 .w = {.body.axes = 3, .step = step}};
    s->w.options = (tf_response_options){.size = sizeof s->w.options,
                                         .separation = 0.01,
                                         .friction = 7,
                                         .vertex_friction = h->own};
    add_strips(h);
    add_sheet(s, -2);
    add_sheet(s, 1);
    for (int v = 0; v < s->w.body.vertices; v++)
        h->own[v] = v < 4 ? h->slippery : v < 8 ? h->rough : h->sheet;
    begin(&s->w);
}

/// How far down the slope a sheet is, 0 or 1.
static double way_of_sheet(const halves *h, int sheet)
{
    double sum = 0;
    for (int v = 8 + 16 * sheet; v < 24 + 16 * sheet; v++) {
        const double *x = h->s.w.body.position + 3 * (ptrdiff_t)v;
        sum += x[0] * cos(h->s.angle) - x[2] * sin(h->s.angle);
    }
    return sum / 16;
}

/// How far each sheet slides in a second.
static void slide_halves(halves *h, int degrees, double step, double way[2])
{
    begin_halves(h, degrees, step);
    double begins[] = {way_of_sheet(h, 0), way_of_sheet(h, 1)};
    for (int i = 0; i < (int)lround(1 / step); i++)
        go_on(&h->s.w);
    for (int sheet = 0; sheet < 2; sheet++)
        way[sheet] = way_of_sheet(h, sheet) - begins[sheet];
    finish(&h->s.w);
}

// The geometric means are 0 to 0.9; with 0.2 and 0.8, for example, 0.4, which
// holds a sheet up to 21.8 degrees.
START_TEST(sheets_stick_or_slide_by_the_friction_of_both_sides)
{
    static const struct {
        double slippery, rough, sheet;
    } cases[] = {{0.2, 0.8, 0.2}, {0.2, 0.8, 0.8}, {0, 0.9, 0.9},
                 {0.1, 0.9, 0.4}, {0.3, 0.6, 0},   {0.05, 20, 0.02}};
    int stuck = 0;
    double most = 0;
    for (int i = 0; i < 48; i++) {
        halves h = {.slippery = cases[i % 6].slippery,
                    .rough = cases[i % 6].rough,
                    .sheet = cases[i % 6].sheet};
        double way[2], step = slope_steps[_i];
        slide_halves(&h, 5 + 5 * (i / 6), step, way);
        for (int sheet = 0; sheet < 2; sheet++) {
            h.s.friction = sqrt((sheet ? h.rough : h.slippery) * h.sheet);
            double exact = exact_way(&h.s, (int)lround(1 / step));
            double error = fabs(way[sheet] - exact);
            ck_assert_double_le(error, 1e-6 + 1e-4 * exact);
            stuck += exact == 0;
            most = fmax(most, error);
        }
    }
    printf("halves, step %g s: %d of 96 stick; wrong by up to %g m\n",
           slope_steps[_i], stuck, most);
    ck_assert_int_gt(stuck, 10);
}
END_TEST

START_TEST(friction_does_not_depend_on_the_order_of_elements)
{
    double way[2], turned[2];
    halves h = {.slippery = 0.2, .rough = 0.8, .sheet = 0.3};
    slide_halves(&h, 25, 0.01, way);
    h.turned = true;
    slide_halves(&h, 25, 0.01, turned);
    ck_assert_double_gt(way[0], 2 * way[1]);
    for (int sheet = 0; sheet < 2; sheet++)
        ck_assert_double_eq_tol(turned[sheet], way[sheet], 1e-12);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("whole/rest");
    TCase *tcase = tcase_create("on a floor");
    tcase_add_loop_test(tcase, a_bar_comes_to_rest, 0, 4);
    tcase_add_loop_test(tcase, apexes_fall_by_the_square_of_restitution, 0, 3);
    tcase_add_loop_test(tcase, a_threshold_brings_bounces_to_an_end, 0, 5);
    suite_add_tcase(suite, tcase);
    tcase = tcase_create("on slopes");
    tcase_add_loop_test(tcase, free_vertices_stick_or_slide, 0, 2);
    tcase_add_loop_test(tcase, speed_is_kept_without_friction, 0, 4);
    tcase_add_test(tcase, an_elastic_cube_sticks_or_slides);
    suite_add_tcase(suite, tcase);
    tcase = tcase_create("friction of vertices");
    tcase_add_loop_test(
        tcase, sheets_stick_or_slide_by_the_friction_of_both_sides, 0, 2);
    tcase_add_test(tcase, friction_does_not_depend_on_the_order_of_elements);
    suite_add_tcase(suite, tcase);
    return suite;
}
