// Constraints of contacts: whom they push, in which direction and how far.
#include "response/contact_constraint.h"

#include "arithmetic/exact.h"
#include "query/query.h"
#include "support/queries.h"
#include "support/support.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

enum {
    TRIALS = 2000
};

/// Two elements in a step, and their contact.
typedef struct scene {
    tf_step step;
    double start[12], end[12];
    tf_surface_contact contact;
} scene;

/// Whether they meet.  The scene must stay where it is.
static bool ready(scene *s, query_kind kind, int axes)
{
    static const tf_kind kinds[] = {TF_POINT_EDGE, TF_POINT_TRIANGLE,
                                    TF_EDGE_EDGE};
    s->step = (tf_step){.axes = axes,
                        .vertices = axes + 1,
                        .start = s->start,
                        .proposed = s->end,
                        .end = s->end};
    s->contact.kind = kinds[kind];
    for (int v = 0; v < 4; v++)
        s->contact.vertex[v] = v <= axes ? v : -1;
    tf_worldline vertex[4];
    for (int v = 0; v <= axes; v++)
        vertex[v] =
            tf_worldline_between(axes, s->start + axes * v, s->end + axes * v);
    int first = kind == EDGE_EDGE ? 2 : 1;
    ck_assert(tf_query(&tf_exact, axes, first, vertex, axes + 1 - first,
                       vertex + first, &s->contact.contact) == TF_OK);
    return s->contact.contact.verdict == TF_HIT;
}

static bool random_scene(generator *random, query_kind kind, scene *s)
{
    query q = query_soup(random, kind);
    for (int v = 0; v <= q.axes; v++)
        for (int k = 0; k < q.axes; k++) {
            s->start[q.axes * v + k] = q.vertex[v].at[0].x[k];
            s->end[q.axes * v + k] = q.vertex[v].at[1].x[k];
        }
    return ready(s, kind, q.axes);
}

static tf_constraint constraint_of(const scene *s, bool by_pivots,
                                   tf_contact_gap *gap)
{
    tf_contact_rule rule = {.base = s->end};
    return tf_contact_constraint(&s->step, &s->contact, &rule, by_pivots, gap);
}

/// The sum over a constraint's vertices of coefficient times place along the
/// normal.
static double along(const scene *s, const tf_constraint *constraint,
                    const double place[])
{
    double sum = 0;
    for (int i = 0; i < 4 && constraint->vertex[i] >= 0; i++)
        for (int k = 0; k < s->step.axes; k++)
            sum += constraint->coefficient[i] * constraint->normal[k] *
                   place[s->step.axes * constraint->vertex[i] + k];
    return sum;
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static double length(const double v[3])
{
    return sqrt(dot(v, v));
}

static void expect_well_made(const scene *s, const tf_constraint *constraint)
{
    int first = s->contact.kind == TF_EDGE_EDGE ? 2 : 1;
    double part[2] = {0, 0};
    for (int i = 0; i < 4 && constraint->vertex[i] >= 0; i++) {
        ck_assert(constraint->coefficient[i] != 0);
        part[constraint->vertex[i] >= first] += constraint->coefficient[i];
    }
    ck_assert_double_eq_tol(part[0], 1, 1e-12);
    ck_assert_double_eq_tol(part[1], -1, 1e-12);
    ck_assert_double_eq_tol(length(constraint->normal), 1, 1e-12);
    ck_assert(constraint->bound >= 0 && constraint->impulse == 0);
}

START_TEST(constraints_are_violated_by_the_step)
{
    generator random = generator_new((uint64_t)_i);
    for (long i = cases(TRIALS); i > 0; i--) {
        scene s;
        tf_contact_gap gap;
        if (!random_scene(&random, (query_kind)_i, &s))
            continue;
        tf_constraint constraint = constraint_of(&s, false, &gap);
        expect_well_made(&s, &constraint);
        ck_assert_double_gt(gap.start, 0);
        ck_assert_double_eq_tol(along(&s, &constraint, s.start), gap.start,
                                1e-9);
        ck_assert_double_lt(along(&s, &constraint, s.end) -
                                along(&s, &constraint, s.start),
                            constraint.bound);
        ck_assert_double_lt(dot(constraint.normal, s.contact.contact.velocity),
                            1e-12);
    }
}
END_TEST

START_TEST(pivots_meet_along_the_normal)
{
    generator random = generator_new((uint64_t)_i);
    for (long i = cases(TRIALS); i > 0; i--) {
        scene s;
        tf_contact_gap gap;
        if (!random_scene(&random, (query_kind)_i, &s))
            continue;
        const tf_contact *contact = &s.contact.contact;
        double velocity = fabs(contact->normal_velocity);
        tf_constraint constraint = constraint_of(&s, true, &gap);
        expect_well_made(&s, &constraint);
        ck_assert(constraint.vertex[1] >= 0 && constraint.vertex[2] < 0);
        ck_assert_double_eq_tol(gap.start, contact->toi_lo * velocity, 1e-12);
        ck_assert_double_eq_tol(along(&s, &constraint, s.start), gap.start,
                                1e-9);
        ck_assert_double_eq_tol(along(&s, &constraint, s.end),
                                (contact->toi_lo - 1) * velocity, 1e-9);
    }
}
END_TEST

static tf_constraint constraint_in_plane(scene *s, const double start[6],
                                         const double end[6],
                                         tf_contact_gap *gap)
{
    memcpy(s->start, start, 6 * sizeof *start);
    memcpy(s->end, end, 6 * sizeof *end);
    ck_assert(ready(s, POINT_EDGE, 2));
    tf_constraint constraint = constraint_of(s, false, gap);
    expect_well_made(s, &constraint);
    return constraint;
}

static void expect_pair(const tf_constraint *constraint, int first, int second,
                        double x, double y)
{
    ck_assert_int_eq(constraint->vertex[0], first);
    ck_assert_int_eq(constraint->vertex[1], second);
    ck_assert_int_eq(constraint->vertex[2], -1);
    ck_assert_double_eq_tol(constraint->normal[0], x, 1e-15);
    ck_assert_double_eq_tol(constraint->normal[1], y, 1e-15);
    ck_assert_double_eq(constraint->normal[2], 0);
}

START_TEST(coordinates_share_a_push)
{
    scene s;
    tf_contact_gap gap;
    tf_constraint constraint =
        constraint_in_plane(&s, (double[]){0, 0.125, -2, 0, 2, 0},
                            (double[]){0, 0.125, -2, 1, 2, 1}, &gap);
    ck_assert_double_eq(gap.start, 0.125);
    ck_assert_double_eq_tol(constraint.coefficient[1], -0.5, 1e-15);
    ck_assert_double_eq_tol(constraint.coefficient[2], -0.5, 1e-15);
    ck_assert_double_eq(constraint.normal[1], 1);
}
END_TEST

START_TEST(pivots_are_pushed_where_the_dots_want_nothing)
{
    // A plank turns under a fly, and its middle comes back.
    scene s;
    tf_contact_gap gap;
    tf_constraint constraint =
        constraint_in_plane(&s, (double[]){0, 1, -2, 2, 2, -2},
                            (double[]){0, 1, -2, -2, 2, 2}, &gap);
    expect_pair(&constraint, 0, 2, sqrt(0.5), sqrt(0.5));
    ck_assert_double_eq_tol(gap.start, sqrt(0.5), 1e-15);
}
END_TEST

START_TEST(pivots_are_pushed_where_the_dots_start_on_the_other_side)
{
    scene s;
    tf_contact_gap gap;
    tf_constraint constraint = constraint_in_plane(
        &s, (double[]){1, 1, 0, 0, 4, 0}, (double[]){1, -2, 1, 2, 2, -2}, &gap);
    expect_pair(&constraint, 0, 1, 4 / sqrt(17), 1 / sqrt(17));
    ck_assert_double_eq_tol(gap.start, 5 / sqrt(17), 1e-14);
}
END_TEST

START_TEST(dots_move_apart_in_their_direction_where_there_is_no_side)
{
    scene s;
    tf_contact_gap gap;
    tf_constraint constraint = constraint_in_plane(
        &s, (double[]){0, 0, 1, 0, 3, 0}, (double[]){2, 0, 1, 0, 3, 0}, &gap);
    expect_pair(&constraint, 0, 1, -1, 0);
    ck_assert_double_eq(gap.start, 1);
}
END_TEST

START_TEST(edges_without_a_normal_move_apart)
{
    // Two parallel edges in space, one of which moves through the other.
    scene s = {.start = {0, 0, 1, 2, 0, 1, 0, 0, 0, 2, 0, 0},
               .end = {0, 0, -1, 2, 0, -1, 0, 0, 0, 2, 0, 0}};
    tf_contact_gap gap;
    ck_assert(ready(&s, EDGE_EDGE, 3));
    ck_assert_double_eq(length(s.contact.contact.normal), 0);
    tf_constraint constraint = constraint_of(&s, false, &gap);
    expect_well_made(&s, &constraint);
    ck_assert_double_eq(gap.start, 1);
    ck_assert_double_eq(constraint.normal[2], 1);
}
END_TEST

// Along any axis, and where squares of lengths vanish or overflow.
START_TEST(directions_have_any_size)
{
    static const double size[] = {1, 0x1p-600, 0x1p600};
    int axis = _i % 3;
    scene s = {.start = {0}};
    for (int v = 0; v < 4; v++) {
        int i = 3 * v + axis;
        s.start[3 * v + (axis + 1) % 3] = v % 2 ? 2 * size[_i / 3] : 0;
        s.start[i] = v < 2 ? size[_i / 3] : 0;
        for (int k = 0; k < 3; k++)
            s.end[3 * v + k] = s.start[3 * v + k];
        s.end[i] = -s.start[i];
    }
    tf_contact_gap gap;
    ck_assert(ready(&s, EDGE_EDGE, 3));
    tf_constraint constraint = constraint_of(&s, false, &gap);
    ck_assert_double_eq(gap.start, size[_i / 3]);
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq(constraint.normal[k], k == axis ? 1 : 0);
}
END_TEST

START_TEST(pivots_that_do_not_approach_are_not_pushed)
{
    scene s;
    tf_contact_gap gap;
    tf_constraint points =
        constraint_in_plane(&s, (double[]){0, 0.125, -2, 0, 2, 0},
                            (double[]){0, 0.125, -2, 1, 2, 1}, &gap);
    memset(s.contact.contact.velocity, 0, sizeof s.contact.contact.velocity);
    s.contact.contact.normal_velocity = 0;
    tf_constraint pivots = constraint_of(&s, true, &gap);
    ck_assert_mem_eq(pivots.vertex, points.vertex, sizeof points.vertex);
    ck_assert_mem_eq(pivots.normal, points.normal, sizeof points.normal);
    ck_assert_double_eq(gap.start, 0.125);
}
END_TEST

// Far from the origin a gap of 16 units in the last place tells no side, but the
// points are at a distance of 20, and in its direction.
START_TEST(rounding_chooses_no_side)
{
    const double far = 0x1p20, unit = 0x1p-32;
    scene s;
    tf_contact_gap gap;
    constraint_in_plane(&s, (double[]){far, 16 * unit, far - 1, 0, far + 1, 0},
                        (double[]){far, -1, far - 1, 0, far + 1, 0}, &gap);
    ck_assert_double_eq(gap.start, 16 * unit);
    s.start[0] += 12 * unit;
    tf_constraint constraint = constraint_of(&s, false, &gap);
    ck_assert_double_eq_tol(gap.start, 20 * unit, unit / 1024);
    ck_assert_double_eq_tol(constraint.normal[0], 0.6, 1e-12);
    ck_assert_double_eq_tol(constraint.normal[1], 0.8, 1e-12);
}
END_TEST

START_TEST(contacts_approach_along_their_normals)
{
    generator random = generator_new((uint64_t)_i);
    int turned = 0;
    for (long i = cases(TRIALS); i > 0; i--) {
        scene s;
        if (!random_scene(&random, (query_kind)_i, &s))
            continue;
        const tf_contact *contact = &s.contact.contact;
        tf_constraint points = tf_contact_points(&s.contact);
        double velocity = dot(points.normal, contact->velocity);
        ck_assert_double_eq_tol(velocity, -fabs(contact->normal_velocity),
                                1e-9);
        ck_assert_int_eq(points.vertex[3], s.contact.vertex[3]);
        turned += contact->normal_velocity > 0;
    }
    ck_assert_int_gt(turned, 0);
}
END_TEST

/// A point that sinks from 3 over an edge in the plane, but not to it.
START_TEST(near_pairs_are_kept_at_the_thickness)
{
    scene s = {.start = {0, 3, -1, 0, 1, 0}, .end = {0, 0.5, -1, 0, 1, 0}};
    ck_assert(!ready(&s, POINT_EDGE, 2));
    tf_contact near = {.verdict = TF_APART,
                       .toi_lo = 1,
                       .toi_hi = 1,
                       .barycentric = {{1}, {0.5, 0.5}},
                       .normal = {0, 1}};
    s.contact.contact = near;
    tf_contact_rule rule = {.base = s.end, .thickness = 2};
    tf_contact_gap gap;
    for (int by_pivots = 0; by_pivots < 2; by_pivots++) {
        tf_constraint own =
            tf_contact_constraint(&s.step, &s.contact, &rule, by_pivots, &gap);
        ck_assert(own.normal[1] == 1);
        // It may sink down to the thickness, but for a margin.
        ck_assert(own.bound < -0.9 && own.bound > -1);
        ck_assert(own.coefficient[0] == 1 && own.coefficient[2] == -0.5);
        ck_assert(gap.start == 3 && gap.room == 0 && gap.push == 0);
    }
    // What starts nearer along the normal is pushed there, and a bit farther.
    rule.thickness = 3;
    ck_assert_double_eq(
        tf_contact_constraint(&s.step, &s.contact, &rule, false, &gap).bound,
        0);
    ck_assert(gap.room > 0 && gap.room < 0.1);
    rule.restitution = 0.5;
    ck_assert_double_eq(
        tf_contact_constraint(&s.step, &s.contact, &rule, false, &gap).bound,
        1.25);
    // Along a direction in which these points start side by side, too.
    s.contact.contact.normal[0] = 1;
    s.contact.contact.normal[1] = 0;
    tf_contact_constraint(&s.step, &s.contact, &rule, false, &gap);
    ck_assert(gap.start == 3 && gap.room > 3);
}
END_TEST

START_TEST(bounds_ask_for_restitution_and_gaps_for_room)
{
    scene s;
    tf_contact_gap gap;
    constraint_in_plane(&s, (double[]){0, 0.125, -2, 0, 2, 0},
                        (double[]){0, 0.125, -2, 1, 2, 1}, &gap);
    // The approach is 1, so no gap gets wider than half of that.
    const double near = nextafter(0.5, 0), far = nextafter(0.5, 1);
    const struct {
        double separation, restitution, threshold, bound, room;
    } expected[] = {{0, 0, 0, 0, 0},
                    {0.125, 0, 0, 0, 0},
                    {0.325, 0, 0, 0, 0.05},
                    {0.325, 0.25, 0, 0.25, 0.05},
                    {near, 0, 0, 0, (near - 0.125) / 4},
                    {far, 0, 0, 0, 0.09375},
                    {8, 0, 0, 0, 0.09375},
                    {-1, 1, 0, 1, 0},
                    {0, 1, 1, 1, 0},
                    {0, 1, nextafter(1, 2), 0, 0},
                    {8, 0.5, 9, 0, 0.09375}};
    for (size_t i = 0; i < sizeof expected / sizeof *expected; i++) {
        tf_contact_rule rule = {expected[i].separation,
                                expected[i].restitution,
                                expected[i].threshold,
                                s.end,
                                NULL,
                                0};
        tf_constraint constraint =
            tf_contact_constraint(&s.step, &s.contact, &rule, false, &gap);
        ck_assert_double_eq_tol(constraint.bound, expected[i].bound, 1e-15);
        ck_assert_double_eq_tol(gap.room, expected[i].room, 1e-15);
        ck_assert_double_eq(gap.push, 0);
    }
}
END_TEST

// Of the gap of 1/8, 2^-9 is to be left where one of the vertices is squeezed.
START_TEST(what_is_squeezed_may_approach)
{
    scene s;
    tf_contact_gap gap;
    constraint_in_plane(&s, (double[]){0, 0.125, -2, 0, 2, 0},
                        (double[]){0, 0.125, -2, 1, 2, 1}, &gap);
    for (int v = 0; v <= 3; v++) {
        unsigned char squeezed[4] = {0};
        squeezed[v] = 1;
        tf_contact_rule rule = {8, 0.5, 0, s.end, squeezed, 0};
        tf_constraint constraint =
            tf_contact_constraint(&s.step, &s.contact, &rule, false, &gap);
        double least = 0x1p-9 * 0.125;
        ck_assert_double_eq(constraint.bound, v < 3 ? least - 0.125 : 0.5);
        ck_assert_double_eq(gap.room, v < 3 ? 0 : 0.09375);
        ck_assert_double_eq(gap.start, 0.125);
        ck_assert_double_eq(gap.push, 0);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_create("response/contact_constraint");
    TCase *any = tcase_create("any contacts");
    tcase_add_loop_test(any, constraints_are_violated_by_the_step, 0, KINDS);
    tcase_add_loop_test(any, pivots_meet_along_the_normal, 0, KINDS);
    suite_add_tcase(s, any);
    TCase *one = tcase_create("single contacts");
    tcase_add_test(one, what_is_squeezed_may_approach);
    tcase_add_test(one, coordinates_share_a_push);
    tcase_add_test(one, pivots_are_pushed_where_the_dots_want_nothing);
    tcase_add_test(one,
                   pivots_are_pushed_where_the_dots_start_on_the_other_side);
    tcase_add_test(one,
                   dots_move_apart_in_their_direction_where_there_is_no_side);
    tcase_add_test(one, edges_without_a_normal_move_apart);
    tcase_add_loop_test(one, directions_have_any_size, 0, 9);
    tcase_add_test(one, pivots_that_do_not_approach_are_not_pushed);
    tcase_add_test(one, rounding_chooses_no_side);
    tcase_add_loop_test(one, contacts_approach_along_their_normals, 0, 3);
    tcase_add_test(one, bounds_ask_for_restitution_and_gaps_for_room);
    tcase_add_test(one, near_pairs_are_kept_at_the_thickness);
    suite_add_tcase(s, one);
    return s;
}
