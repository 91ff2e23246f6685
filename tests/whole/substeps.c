// Steps that are taken in parts: each part is clear, and what falls, bounces or
// pushes ends as closed forms say.
#include "response/resolve.h"

#include "fast/vectorized.h"
#include "support/proposals.h"
#include "support/support.h"
#include "support/surface_of.h"
#include "support/tangle.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static proposal made;
static double end[3 * PROPOSAL_VERTICES], motion[3 * PROPOSAL_VERTICES];
static tf_response_report report;

static void resolve(tf_response_options options)
{
    const tf_response_report *lent;
    tf_surface *surface = surface_of(&made.mesh);
    tf_resolver *resolver;
    options.size = sizeof options;
    ck_assert_int_eq(tf_resolver_create(surface, &resolver), TF_OK);
    memcpy(end, made.end, sizeof end);
    ck_assert_int_eq(tf_step_resolve(resolver, made.mesh.vertices, made.start,
                                     end, made.inverse_mass, &options, &lent,
                                     NULL),
                     TF_OK);
    report = *lent;
    memcpy(motion, tf_resolver_unpushed(resolver),
           sizeof *motion * (size_t)(made.mesh.axes * made.mesh.vertices));
    tf_resolver_free(resolver);
    tf_surface_free(surface);
}

// Parts -----------------------------------------------------------------------

enum {
    MOST_PARTS = 8,
    FEW_VERTICES = 30
};

/// The parts that a narrow phase has been asked about: where each starts, and
/// where it was proposed to end last.
static struct {
    int count, numbers;
    double start[MOST_PARTS][3 * PROPOSAL_VERTICES];
    double end[MOST_PARTS][3 * PROPOSAL_VERTICES];
} parts;

static void note(const tf_motion *own)
{
    size_t bytes = sizeof *end * (size_t)parts.numbers;
    if (parts.count == 0 ||
        memcmp(parts.start[parts.count - 1], own->start, bytes) != 0) {
        ck_assert_int_lt(parts.count, MOST_PARTS);
        memcpy(parts.start[parts.count++], own->start, bytes);
    }
    memcpy(parts.end[parts.count - 1], own->end, bytes);
}

static tf_status decide(void *context, const tf_arithmetic *arithmetic,
                        const tf_queries *queries, tf_verdict verdict[],
                        size_t *separated)
{
    (void)context;
    note(queries->motion);
    return tf_vectorized.decide(NULL, arithmetic, queries, verdict, separated);
}

static const tf_narrow_phase noting = {.name = "noting", .decide = decide};

/// Adds two edges, in the plane an edge and a point, that rest far away, so near
/// each other that all detections look at them.
static void add_beacon(void)
{
    double far = 0x1p10 * made.unit, size = made.unit;
    int axes = made.mesh.axes;
    int a = proposal_add_vertex(&made, far, far, far);
    int b = proposal_add_vertex(&made, far + size, far + size, far);
    proposal_add_edge(&made, a, b);
    a = proposal_add_vertex(&made, far + size / 4, far + size / 2, far + size);
    if (axes == 3) {
        b = proposal_add_vertex(&made, far + size / 2, far + size / 4,
                                far - size / 2);
        proposal_add_edge(&made, a, b);
    }
}

/// Expects that each part begins where the last one has ended, and is clear.
static void expect_clear_parts(tangle_judge *judge)
{
    size_t bytes = sizeof *end * (size_t)parts.numbers;
    const double *at = made.start;
    for (int i = 0; i < parts.count; i++) {
        ck_assert_mem_eq(parts.start[i], at, bytes);
        at = parts.end[i];
        ck_assert_int_eq(tangle_count_in_step(judge, parts.start[i], at), 0);
        ck_assert_int_eq(tangle_count(judge, at), 0);
    }
    ck_assert_mem_eq(at, end, bytes);
}

START_TEST(each_part_is_clear)
{
    generator random = generator_new(32);
    int judged = 0, bent = 0;
    for (int i = 0; i < (int)cases(240); i++) {
        proposal_make(&random, (proposal_shape)(i % PROPOSAL_SHAPES), 1,
                      (proposal_way)(i / PROPOSAL_SHAPES % PROPOSAL_WAYS),
                      &made);
        proposal_weigh(&random, &made);
        add_beacon();
        tangle_judge *judge = tangle_judge_new(&made.mesh);
        bool clear = tangle_count(judge, made.start) == 0;
        tangle_judge_script(judge, made.inverse_mass);
        parts.count = 0;
        parts.numbers = made.mesh.axes * made.mesh.vertices;
        if (clear && made.mesh.vertices <= FEW_VERTICES) {
            resolve((tf_response_options){.substeps = 2 + below(&random, 3),
                                          .restitution =
                                              below(&random, 2) ? 0 : 0.5,
                                          .narrow_phase = &noting});
            expect_clear_parts(judge);
            judged += parts.count;
            bent += tangle_count_in_step(judge, made.start, end) > 0;
        }
        tangle_judge_free(judge);
    }
    printf("%d parts judged; %d steps that are not clear as a whole\n", judged,
           bent);
    ck_assert_int_gt(judged, 0);
}
END_TEST

// Closed forms ----------------------------------------------------------------

/// In the plane, a floor from -4 to 4 at height 0, which is scripted.
static void make_floor(void)
{
    proposal_begin(&made, 2);
    proposal_add_edge(&made, proposal_add_vertex(&made, -4, 0, 0),
                      proposal_add_vertex(&made, 4, 0, 0));
    made.inverse_mass[0] = made.inverse_mass[1] = 0;
}

static int add_point(double x, double y, double dx, double dy)
{
    int v = proposal_add_vertex(&made, x, y, 0);
    made.end[2 * v] += dx;
    made.end[2 * v + 1] += dy;
    return v;
}

static const int substeps[] = {1, 2, 3, 7, 16, 100};

enum {
    SUBSTEPS = sizeof substeps / sizeof *substeps
};

START_TEST(a_step_without_contacts_ends_as_proposed)
{
    generator random = generator_new(33);
    make_floor();
    made.end[0] = -5.1;
    for (int i = 0; i < 20; i++)
        add_point(uniform(&random, -4, 4), 1 + uniform(&random, 0, 1),
                  uniform(&random, -9, 9), uniform(&random, 0, 1));
    resolve((tf_response_options){.substeps = substeps[_i]});
    size_t bytes = sizeof *end * 2 * (size_t)made.mesh.vertices;
    ck_assert_mem_eq(end, made.end, bytes);
    ck_assert_mem_eq(motion, made.end, bytes);
    ck_assert_uint_eq(report.first_contacts, 0);
    ck_assert_int_eq(report.moved, 0);
    ck_assert_double_eq(report.energy_before, report.energy_after);
}
END_TEST

// A point at height 1 falls by 2.6 and slides by 1.  It stops above the floor, by
// less than the way of one part, and all of its motion down is gone.
START_TEST(what_falls_stops_at_the_floor)
{
    double part = 2.6 / substeps[_i];
    make_floor();
    int v = add_point(-0.5, 1, 1, -2.6);
    int free = add_point(3, 2, 0.3, -0.7);
    resolve((tf_response_options){.substeps = substeps[_i], .separation = -1});
    ck_assert_double_gt(end[2 * v + 1], 0);
    ck_assert_double_le(end[2 * v + 1], fmin(part, 1) + 1e-12);
    ck_assert_double_eq_tol(end[2 * v], 0.5, 1e-12);
    ck_assert_double_eq_tol(motion[2 * v + 1], 1, 1e-12);
    ck_assert_double_eq_tol(motion[2 * v], 0.5, 1e-12);
    ck_assert_mem_eq(end + 2 * free, made.end + 2 * free, 2 * sizeof *end);
    ck_assert_double_eq_tol(report.energy_before - report.energy_after,
                            2.6 * 2.6 / 2, 1e-9);
}
END_TEST

// With restitution it rises again, for what is left of the time.
START_TEST(what_bounces_rises_for_the_rest_of_the_step)
{
    double part = 2.6 / substeps[_i], left = 1 - 1 / 2.6;
    make_floor();
    int v = add_point(-0.5, 1, 1, -2.6);
    resolve((tf_response_options){
        .substeps = substeps[_i], .restitution = 0.5, .separation = -1});
    ck_assert_double_eq_tol(end[2 * v], 0.5, 1e-12);
    ck_assert_double_eq_tol(motion[2 * v + 1], 1 + 0.5 * 2.6, 1e-12);
    if (substeps[_i] > 1) // or it rises at once, from where it starts
        ck_assert_double_eq_tol(end[2 * v + 1], 0.5 * 2.6 * left, 2 * part);
}
END_TEST

// A bar falls upon another of the same mass, which rests: both go on together
// with half of the velocity, as momentum demands.
START_TEST(what_is_hit_goes_on)
{
    proposal_begin(&made, 2);
    for (int i = 0; i < 2; i++) {
        int left = add_point(-2 + i, i, 0, -3. * i);
        proposal_add_edge(&made, left, add_point(2 - i, i, 0, -3. * i));
    }
    resolve((tf_response_options){.substeps = substeps[_i], .separation = -1});
    double momentum = 0, sum = 0;
    for (int v = 0; v < 4; v++) {
        momentum += motion[2 * v + 1] - made.start[2 * v + 1];
        sum += end[2 * v + 1] - made.start[2 * v + 1];
    }
    ck_assert_double_eq_tol(momentum, -6, 1e-9);
    ck_assert_double_eq_tol(sum, -6, 1e-9);
    // They meet after 1/3 of the step.
    double after = substeps[_i] == 1 ? 1 : 2 / 3.;
    ck_assert_double_eq_tol(end[1], -1.5 * after, 3. / substeps[_i] + 1e-9);
}
END_TEST

// A lid from height 2 to -2, and a point at 1 above a floor: what is scripted
// goes half of its way, in one part or in many.
START_TEST(scripted_vertices_follow_in_parts)
{
    make_floor();
    add_point(-0.5, 1, 0, 0);
    int left = add_point(-4, 2, 0, -4), right = add_point(4, 2, 0, -4);
    proposal_add_edge(&made, left, right);
    made.inverse_mass[left] = made.inverse_mass[right] = 0;
    resolve((tf_response_options){.substeps = substeps[_i]});
    ck_assert_int_eq(report.held, 2);
    ck_assert_double_le(report.followed, 0.5);
    ck_assert_double_ge(report.followed, 0.49);
    ck_assert_double_eq(motion[2 * left + 1], end[2 * left + 1]);
}
END_TEST

// A cube ----------------------------------------------------------------------

enum {
    FACES = 8, ///< along an edge
    CUBE_VERTICES = 6 * FACES * FACES + 2,
    CUBE_TRIANGLES = 12 * FACES * FACES
};

typedef struct cubes {
    int vertices, triangles;
    double start[2 * CUBE_VERTICES][3], end[2 * CUBE_VERTICES][3];
    double inverse_mass[2 * CUBE_VERTICES];
    int triangle[2 * CUBE_TRIANGLES][3];
    int number[FACES + 1][FACES + 1][FACES + 1]; ///< and 1; 0: none yet
} cubes;

static int corner_of(cubes *c, const int at[3], const double from[3])
{
    int *number = &c->number[at[0]][at[1]][at[2]];
    if (*number == 0) {
        for (int k = 0; k < 3; k++)
            c->start[c->vertices][k] = from[k] + (double)at[k] / FACES;
        *number = ++c->vertices;
    }
    return *number - 1;
}

static void add_face(cubes *c, int axis, int side, int i, int j,
                     const double from[3])
{
    int corner[4];
    for (int n = 0; n < 4; n++) {
        int at[3];
        at[axis] = side * FACES;
        at[(axis + 1) % 3] = i + (n == 1 || n == 2);
        at[(axis + 2) % 3] = j + (n >= 2);
        corner[n] = corner_of(c, at, from);
    }
    for (int n = 1; n < 3; n++) {
        int *t = c->triangle[c->triangles++];
        t[0] = corner[0];
        t[1 + side] = corner[n + 1];
        t[2 - side] = corner[n];
    }
}

/// Adds a cube of size 1.
static void add_cube(cubes *c, const double from[3])
{
    memset(c->number, 0, sizeof c->number);
    for (int axis = 0; axis < 3; axis++)
        for (int side = 0; side < 2; side++)
            for (int i = 0; i < FACES; i++)
                for (int j = 0; j < FACES; j++)
                    add_face(c, axis, side, i, j, from);
}

/// How far a vertex ends from its path.
static double distance_from_path(const double a[3], const double b[3],
                                 const double x[3])
{
    double square = 0, along = 0, sum = 0;
    for (int k = 0; k < 3; k++) {
        square += (b[k] - a[k]) * (b[k] - a[k]);
        along += (b[k] - a[k]) * (x[k] - a[k]);
    }
    double t = square > 0 ? fmin(1, fmax(0, along / square)) : 0;
    for (int k = 0; k < 3; k++) {
        double off = x[k] - (a[k] + t * (b[k] - a[k]));
        sum += off * off;
    }
    return sqrt(sum);
}

static double thrown(cubes *c, int parts_of_step)
{
    tf_mesh mesh = {.axes = 3,
                    .vertices = c->vertices,
                    .triangles = c->triangles,
                    .triangle = c->triangle[0]};
    static double to[2 * CUBE_VERTICES][3];
    tf_surface *surface = surface_of(&mesh);
    tf_resolver *resolver;
    tf_response_options options = {.size = sizeof options,
                                   .substeps = parts_of_step};
    tangle_judge *judge = tangle_judge_new(&mesh);
    memcpy(to, c->end, sizeof to);
    ck_assert_int_eq(tf_resolver_create(surface, &resolver), TF_OK);
    ck_assert_int_eq(tf_step_resolve(resolver, c->vertices, c->start[0], to[0],
                                     c->inverse_mass, &options, NULL, NULL),
                     TF_OK);
    tangle_judge_script(judge, c->inverse_mass);
    ck_assert_int_eq(tangle_count(judge, to[0]), 0);
    double most = 0;
    for (int v = 0; v < c->vertices; v++)
        most = fmax(most, distance_from_path(c->start[v], c->end[v], to[v]));
    tangle_judge_free(judge);
    tf_resolver_free(resolver);
    tf_surface_free(surface);
    return most;
}

// A cube falls by 1.2 of its size upon a fixed one, 0.3 below, aligned with it or
// not.  No vertex ends farther from its path than an edge is long.
START_TEST(a_cube_that_falls_upon_another_keeps_to_its_path)
{
    static const double aside[] = {0, 0.03, 0.3};
    cubes *c = calloc(1, sizeof *c);
    ck_assert_ptr_nonnull(c);
    add_cube(c, (double[]){0, 0, 0});
    int fixed = c->vertices;
    ck_assert_int_eq(fixed, CUBE_VERTICES);
    add_cube(c, (double[]){aside[_i], 0.6 * aside[_i], 1.3});
    memcpy(c->end, c->start, sizeof c->end);
    for (int v = fixed; v < c->vertices; v++) {
        c->inverse_mass[v] = 1;
        c->end[v][2] -= 1.2;
    }
    double whole = thrown(c, 1), in_parts = thrown(c, 128);
    printf("aside by %g: %g from the paths in one part, %g in 128\n", aside[_i],
           whole, in_parts);
    ck_assert_double_lt(in_parts, 1. / FACES);
    free(c);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("whole/substeps");
    TCase *each = tcase_create("parts");
    tcase_set_timeout(each, 600);
    tcase_add_test(each, each_part_is_clear);
    suite_add_tcase(suite, each);
    TCase *forms = tcase_create("closed forms");
    tcase_add_loop_test(forms, a_step_without_contacts_ends_as_proposed, 0,
                        SUBSTEPS);
    tcase_add_loop_test(forms, what_falls_stops_at_the_floor, 0, SUBSTEPS);
    tcase_add_loop_test(forms, what_bounces_rises_for_the_rest_of_the_step, 0,
                        SUBSTEPS);
    tcase_add_loop_test(forms, what_is_hit_goes_on, 0, SUBSTEPS);
    tcase_add_loop_test(forms, scripted_vertices_follow_in_parts, 0, SUBSTEPS);
    suite_add_tcase(suite, forms);
    TCase *cube = tcase_create("a cube");
    tcase_set_timeout(cube, 600);
    tcase_add_loop_test(cube, a_cube_that_falls_upon_another_keeps_to_its_path,
                        0, 3);
    suite_add_tcase(suite, cube);
    return suite;
}
