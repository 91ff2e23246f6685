// No contact, no tunneling: in a step in which a vertex meets no element of a
// closed curve or surface it stays inside or outside, and loops of edges that
// do not meet stay linked or apart.  How often things go around each other is
// counted by other code, at the two ends of the step alone.
#include "arithmetic/clamped.h"
#include "arithmetic/exact.h"
#include "query/narrow_phase.h"
#include "support/support.h"
#include "support/winding.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

enum {
    POINTS = 4,    ///< in a scene
    ROUND = 6,     ///< the most vertices around a loop, or each way
    VERTICES = 48, ///< of a scene
    ELEMENTS = 96, ///< of a cycle
    HALVINGS = 12, ///< of the displacements, until no contact is left
    COORDINATES = 3 * VERTICES
};

/// Points and what they may be inside of, or a loop and another one.
typedef struct scene {
    tf_kind kind;
    int vertices, axes;
    double start[COORDINATES], end[COORDINATES];
    int number[VERTICES]; ///< of the vertices as they were made
    int count[2], list[2][3 * ELEMENTS];
} scene;

static scene scene_new(generator *random, tf_kind kind)
{
    scene s = {.kind = kind, .axes = kind == TF_POINT_EDGE ? 2 : 3};
    for (int v = 0; v < VERTICES; v++) {
        int other = below(random, v + 1);
        s.number[v] = s.number[other];
        s.number[other] = v;
    }
    return s;
}

static cycle cycle_of(const scene *s, int which)
{
    bool points = which == 0 && s->kind != TF_EDGE_EDGE;
    int size = points ? 1 : s->kind == TF_POINT_TRIANGLE ? 3 : 2;
    return (cycle){s->count[which], size, s->list[which]};
}

/// Add a vertex in the plane or in space, and return its index.
static int add_vertex(scene *s, double x, double y, double z)
{
    ck_assert_int_lt(s->vertices, VERTICES);
    int v = s->number[s->vertices++];
    const double place[3] = {x, y, z};
    memcpy(s->start + s->axes * v, place, sizeof *place * (size_t)s->axes);
    return v;
}

static void add_element(scene *s, int which, int size, const int vertices[])
{
    ck_assert_int_lt(s->count[which], ELEMENTS);
    memcpy(s->list[which] + size * s->count[which]++, vertices,
           sizeof *vertices * (size_t)size);
}

// Closed things ---------------------------------------------------------------

static double turn(double part)
{
    return 2 * acos(-1) * part;
}

/// A loop around the middle of the plane, or around the origin in space, upright
/// if it is the second one, which is shifted.
static void add_loop(generator *random, scene *s, int which)
{
    int count = 3 + below(random, ROUND - 2), vertex[ROUND];
    double shift = s->kind == TF_EDGE_EDGE ? which : 0;
    for (int i = 0; i < count; i++) {
        double a = turn((i + uniform(random, 0, 0.8)) / count);
        double r = uniform(random, 0.3, 1.5), height = uniform(random, -1, 1);
        double x = r * cos(a) + shift, y = r * sin(a);
        vertex[i] = which == 0 || s->kind == TF_POINT_EDGE
                        ? add_vertex(s, x, y, height / 2)
                        : add_vertex(s, x, height / 2, y);
    }
    for (int i = 0; i < count; i++) {
        const int edge[2] = {vertex[i], vertex[(i + 1) % count]};
        add_element(s, which, 2, edge);
    }
}

/// The two triangles of a cell of a grid with `rows` rows that close.
static void add_cell(scene *s, const int *vertex, int rows, int columns, int i,
                     int j)
{
    int a = vertex[i * columns + j];
    int b = vertex[(i + 1) % rows * columns + j];
    int c = vertex[(i + 1) % rows * columns + (j + 1) % columns];
    int d = vertex[i * columns + (j + 1) % columns];
    add_element(s, 1, 3, (const int[]){a, b, c});
    add_element(s, 1, 3, (const int[]){a, c, d});
}

/// A sphere with dents: rows of vertices between two poles.
static void add_sphere(generator *random, scene *s)
{
    int rows = 1 + below(random, 3), columns = 3 + below(random, ROUND - 2);
    int vertex[ROUND * ROUND];
    for (int i = 0; i < rows * columns; i++) {
        double up = turn((i / columns + 1.0) / (rows + 1) / 2);
        double a = turn((double)(i % columns) / columns);
        double r = uniform(random, 0.5, 1.5);
        vertex[i] = add_vertex(s, r * sin(up) * cos(a), r * sin(up) * sin(a),
                               r * cos(up));
    }
    int north = add_vertex(s, 0, 0, uniform(random, 0.5, 1.5));
    int south = add_vertex(s, 0, 0, uniform(random, -1.5, -0.5));
    const int *last = vertex + (rows - 1) * columns;
    for (int j = 0; j < columns; j++) {
        int next = (j + 1) % columns;
        add_element(s, 1, 3, (const int[]){north, vertex[j], vertex[next]});
        add_element(s, 1, 3, (const int[]){south, last[next], last[j]});
        for (int i = 0; i + 1 < rows; i++)
            add_cell(s, vertex, rows, columns, i, j);
    }
}

static void add_torus(generator *random, scene *s)
{
    int rows = 3 + below(random, ROUND - 2);
    int columns = 3 + below(random, ROUND - 2);
    int vertex[ROUND * ROUND];
    for (int i = 0; i < rows * columns; i++) {
        double a = turn((double)(i / columns) / rows);
        double b = turn((double)(i % columns) / columns);
        double r = uniform(random, 0.3, 0.7), out = 1 + r * cos(b);
        vertex[i] = add_vertex(s, out * cos(a), out * sin(a), r * sin(b));
    }
    for (int i = 0; i < rows * columns; i++)
        add_cell(s, vertex, rows, columns, i / columns, i % columns);
}

static void add_points(generator *random, scene *s)
{
    for (int i = 0; i < POINTS; i++) {
        int v = add_vertex(s, uniform(random, -1.2, 1.2),
                           uniform(random, -1.2, 1.2), uniform(random, -1, 1));
        add_element(s, 0, 1, &v);
    }
}

static scene random_scene(generator *random, tf_kind kind)
{
    scene s = scene_new(random, kind);
    if (kind == TF_EDGE_EDGE)
        add_loop(random, &s, 0);
    else
        add_points(random, &s);
    if (kind != TF_POINT_TRIANGLE)
        add_loop(random, &s, 1);
    else if (below(random, 2))
        add_sphere(random, &s);
    else
        add_torus(random, &s);
    return s;
}

/// Move all vertices by up to `reach` along each axis.
static void move_anywhere(generator *random, scene *s, double reach)
{
    for (int i = 0; i < COORDINATES; i++)
        s->end[i] = s->start[i] + uniform(random, -reach, reach);
}

/// Put all vertices on a lattice at both ends, degenerate as that may be.
static void move_on_lattice(generator *random, scene *s)
{
    int values = 3 + below(random, 6);
    for (int i = 0; i < COORDINATES; i++) {
        s->start[i] = below(random, values);
        s->end[i] = below(random, 6) ? s->start[i] : below(random, values);
    }
}

static void halve_displacements(scene *s)
{
    for (int i = 0; i < COORDINATES; i++)
        s->end[i] = s->start[i] + (s->end[i] - s->start[i]) / 2;
}

// What the library decides ----------------------------------------------------

/// Whether some elements of the first list, from..to-1, may meet one of the
/// second: an undecided query counts as a contact.
static bool in_contact(const tf_arithmetic *arithmetic, const scene *s,
                       int from, int to)
{
    cycle first = cycle_of(s, 0), second = cycle_of(s, 1);
    tf_motion motion = {s->axes, VERTICES, s->start, s->end};
    int vertices[4 * ELEMENTS], size = first.size + second.size;
    tf_verdict verdict[ELEMENTS];
    for (int i = from; i < to; i++) {
        for (int j = 0; j < second.count; j++) {
            memcpy(vertices + size * j, first.vertices + first.size * i,
                   sizeof(int) * (size_t)first.size);
            memcpy(vertices + size * j + first.size,
                   second.vertices + second.size * j,
                   sizeof(int) * (size_t)second.size);
        }
        tf_queries queries = {s->kind, &motion, (size_t)second.count, vertices};
        size_t separated = 0;
        ck_assert_int_eq(tf_reference.decide(NULL, arithmetic, &queries,
                                             verdict, &separated),
                         TF_OK);
        for (int j = 0; j < second.count; j++)
            if (verdict[j] != TF_APART)
                return true;
    }
    return false;
}

// What must not change --------------------------------------------------------

/// What goes around what: a point each, or the loops.
static int numbers_of(const scene *s)
{
    return s->kind == TF_EDGE_EDGE ? 1 : s->count[0];
}

static bool number_in_contact(const tf_arithmetic *arithmetic, const scene *s,
                              int i)
{
    return s->kind == TF_EDGE_EDGE ? in_contact(arithmetic, s, 0, s->count[0])
                                   : in_contact(arithmetic, s, i, i + 1);
}

/// The i-th number at an end of the step.
static int number_at(const scene *s, const double place[], int i)
{
    cycle first = cycle_of(s, 0), second = cycle_of(s, 1);
    return s->kind == TF_EDGE_EDGE
               ? linking_number(place, &first, &second)
               : winding_number(s->axes, place, &second, first.vertices[i]);
}

static void fail_scene(const scene *s, int i, int before, int after)
{
    for (int v = 0; v < VERTICES; v++)
        for (int t = 0; t < 2; t++) {
            const double *x = (t == 0 ? s->start : s->end) + s->axes * v;
            printf("%d: %a,%a,%a\n", v, x[0], x[1], s->axes == 3 ? x[2] : 0);
        }
    ck_abort_msg("number %d of kind %d goes from %d to %d without a contact\n"
                 "seed %llu",
                 i, s->kind, before, after, (unsigned long long)seed());
}

/// Numbers that are not 0 and do not change, those that change, and steps in
/// which nothing meets.
typedef struct tally {
    long inside, changed, apart;
} tally;

/// Compare the numbers at both ends of the step where there is no contact.
static void expect_no_change(const tf_arithmetic *arithmetic, const scene *s,
                             tally *n)
{
    for (int i = 0; i < numbers_of(s); i++) {
        if (number_in_contact(arithmetic, s, i))
            continue;
        int before = number_at(s, s->start, i), after = number_at(s, s->end, i);
        if (before != after)
            fail_scene(s, i, before, after);
        n->inside += before != 0;
    }
}

/// Wherever a number changes there has to be a contact.
static void expect_contact_of_changes(const tf_arithmetic *arithmetic,
                                      const scene *s, tally *n)
{
    for (int i = 0; i < numbers_of(s); i++) {
        int before = number_at(s, s->start, i), after = number_at(s, s->end, i);
        if (before == after)
            continue;
        if (!number_in_contact(arithmetic, s, i))
            fail_scene(s, i, before, after);
        n->changed++;
    }
}

// Steps -----------------------------------------------------------------------

static const tf_arithmetic *const arithmetics[] = {&tf_exact, &tf_clamped};

/// Shorten the step until nothing meets.
START_TEST(without_contact_points_stay_inside_or_outside)
{
    tf_kind kind = (tf_kind)_i;
    generator random = generator_new((uint64_t)kind);
    tally n = {0};
    for (long i = cases(2000); i > 0; i--) {
        const tf_arithmetic *arithmetic = arithmetics[i % 2];
        scene s = random_scene(&random, kind);
        move_anywhere(&random, &s, uniform(&random, 0.2, 2));
        for (int k = 0; k < HALVINGS; k++, halve_displacements(&s))
            if (!in_contact(arithmetic, &s, 0, s.count[0])) {
                expect_no_change(arithmetic, &s, &n);
                n.apart++;
                break;
            }
    }
    ck_assert_int_ge(n.apart, cases(2000) * 9 / 10);
    ck_assert_int_ge(n.inside, cases(2000) / 5);
}
END_TEST

/// Long steps, in which much goes through.
START_TEST(nothing_gets_in_or_out_without_a_contact)
{
    tf_kind kind = (tf_kind)_i;
    generator random = generator_new((uint64_t)kind + 10);
    tally n = {0};
    for (long i = cases(2000); i > 0; i--) {
        scene s = random_scene(&random, kind);
        move_anywhere(&random, &s, uniform(&random, 0.2, 2));
        expect_contact_of_changes(arithmetics[i % 2], &s, &n);
    }
    ck_assert_int_ge(n.changed, cases(2000) / 5);
}
END_TEST

/// Surfaces through themselves, triangles without area, contacts at the ends.
START_TEST(degenerate_closed_things_keep_what_they_go_around)
{
    tf_kind kind = (tf_kind)_i;
    generator random = generator_new((uint64_t)kind + 20);
    tally n = {0};
    for (long i = cases(3000); i > 0; i--) {
        scene s = random_scene(&random, kind);
        move_on_lattice(&random, &s);
        expect_no_change(&tf_exact, &s, &n);
    }
    ck_assert_msg(cases(2000) < 1000 || n.inside > 0, "nothing is inside");
}
END_TEST

Suite *suite(void)
{
    Suite *tunneling = suite_create("tunneling");
    TCase *steps = tcase_create("steps");
    const int first = TF_POINT_EDGE, end = TF_EDGE_EDGE + 1;
    tcase_add_loop_test(steps, without_contact_points_stay_inside_or_outside,
                        first, end);
    tcase_add_loop_test(steps, nothing_gets_in_or_out_without_a_contact, first,
                        end);
    tcase_add_loop_test(
        steps, degenerate_closed_things_keep_what_they_go_around, first, end);
    suite_add_tcase(tunneling, steps);
    return tunneling;
}
