// Visits of a constraint, and what they preserve.
#include "response/impulse.h"

#include "support/support.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

enum {
    VERTICES = 4,
    TRIALS = 500
};

/// A constraint, and the vertices that it is about.
typedef struct scene {
    int axes;
    tf_constraint constraint;
    double inverse_mass[VERTICES], move[3 * VERTICES];
} scene;

static tf_bodies bodies_of(scene *s)
{
    return (tf_bodies){s->axes, s->inverse_mass, s->move};
}

/// A constraint of a point and an element of two or three vertices.
static scene random_scene(generator *random)
{
    scene s = {.axes = 2 + below(random, 2)};
    double sum = 0, square = 0;
    for (int i = 0; i < VERTICES; i++) {
        bool used = i <= s.axes;
        s.constraint.vertex[i] = used ? i : -1;
        s.constraint.coefficient[i] = used ? uniform(random, 0.01, 1) : 0;
        s.inverse_mass[i] = uniform(random, 0.1, 2);
        sum += i > 0 ? s.constraint.coefficient[i] : 0;
    }
    s.constraint.coefficient[0] = 1;
    for (int i = 1; i <= s.axes; i++)
        s.constraint.coefficient[i] /= -sum;
    for (int k = 0; k < s.axes; k++) {
        s.constraint.normal[k] = uniform(random, -1, 1);
        square += s.constraint.normal[k] * s.constraint.normal[k];
    }
    for (int k = 0; k < s.axes; k++)
        s.constraint.normal[k] /= sqrt(square);
    for (int i = 0; i < 3 * VERTICES; i++)
        s.move[i] = uniform(random, -1, 1);
    return s;
}

static double gap_change(const scene *s)
{
    return tf_constraint_gap_change(s->axes, &s->constraint, s->move);
}

static double energy(const scene *s)
{
    double sum = 0;
    for (int v = 0; v <= s->axes; v++)
        for (int k = 0; k < s->axes && s->inverse_mass[v] > 0; k++) {
            double d = s->move[s->axes * v + k];
            sum += d * d / s->inverse_mass[v] / 2;
        }
    return sum;
}

/// The sum over vertices of mass times the square of what has changed.
static double change(const scene *s, const scene *from)
{
    double sum = 0;
    for (int v = 0; v <= s->axes; v++)
        for (int k = 0; k < s->axes; k++) {
            int i = s->axes * v + k;
            sum += pow(s->move[i] - from->move[i], 2) / s->inverse_mass[v];
        }
    return sum;
}

static void visit(scene *s, double friction)
{
    tf_bodies bodies = bodies_of(s);
    tf_constraint_visit(&s->constraint, friction, &bodies);
}

START_TEST(visits_widen_the_gap_to_the_bound)
{
    generator random = generator_new(1);
    for (long i = cases(TRIALS); i > 0; i--) {
        scene s = random_scene(&random);
        s.constraint.bound = uniform(&random, 0, 1);
        double before = gap_change(&s);
        visit(&s, 0);
        ck_assert_double_eq_tol(gap_change(&s),
                                fmax(before, s.constraint.bound), 1e-12);
        ck_assert((s.constraint.impulse > 0) == (before < s.constraint.bound));
    }
}
END_TEST

START_TEST(no_other_push_changes_less)
{
    generator random = generator_new(2);
    for (long i = cases(TRIALS); i > 0; i--) {
        scene s = random_scene(&random), other = s, from = s;
        s.constraint.bound = gap_change(&s) + uniform(&random, 0, 1);
        visit(&s, 0);

        // Any change, scaled to part the elements as far.
        for (int v = 0; v < 3 * VERTICES; v++)
            other.move[v] = uniform(&random, -1, 1);
        double part =
            (s.constraint.bound - gap_change(&from)) / gap_change(&other);
        for (int v = 0; v < 3 * VERTICES; v++)
            other.move[v] = from.move[v] + part * other.move[v];
        ck_assert_double_eq_tol(gap_change(&other), s.constraint.bound, 1e-9);
        ck_assert_double_le(change(&s, &from),
                            change(&other, &from) * (1 + 1e-12));
    }
}
END_TEST

START_TEST(visits_keep_momentum)
{
    generator random = generator_new(3);
    for (long i = cases(TRIALS); i > 0; i--) {
        scene s = random_scene(&random), from = s;
        s.constraint.bound = 1;
        visit(&s, (double)(i % 2));
        for (int k = 0; k < s.axes; k++) {
            double gained = 0;
            for (int v = 0; v <= s.axes; v++) {
                int place = s.axes * v + k;
                gained +=
                    (s.move[place] - from.move[place]) / s.inverse_mass[v];
            }
            ck_assert_double_eq_tol(gained, 0, 1e-12);
        }
    }
}
END_TEST

START_TEST(visits_change_the_energy_as_proved)
{
    generator random = generator_new(4);
    for (long i = cases(TRIALS); i > 0; i--) {
        scene s = random_scene(&random);
        if (i % 2 == 0) { // the point is scripted to rest
            s.inverse_mass[0] = 0;
            memset(s.move, 0, sizeof(double) * (size_t)s.axes);
        }
        double before = energy(&s), at = gap_change(&s);
        double restitution = uniform(&random, 0, 1);
        s.constraint.bound = fmax(0, -restitution * at);
        visit(&s, 0);
        double lost =
            at < 0 ? at * at - s.constraint.bound * s.constraint.bound : 0;
        double compliance =
            tf_constraint_compliance(&s.constraint, s.inverse_mass);
        ck_assert_double_eq_tol(before - energy(&s), lost / (2 * compliance),
                                1e-12);
    }
}
END_TEST

// A scripted point comes down by 1 onto an edge of which one end is scripted,
// so that the other end has to move 1 / free times as far.
START_TEST(a_short_lever_pushes_nothing)
{
    const double least = 1. / 1024;
    const double free[] = {nextafter(least, 0), least, 1e-200, 0.5};
    for (int i = 0; i < 4; i++) {
        scene s = {.axes = 2,
                   .constraint = {.vertex = {0, 1, 2, -1},
                                  .coefficient = {1, free[i] - 1, -free[i]},
                                  .normal = {0, 1, 0}},
                   .inverse_mass = {0, 0, 3},
                   .move = {0, -1}};
        bool pushes = free[i] >= least;
        ck_assert_double_eq(
            tf_constraint_compliance(&s.constraint, s.inverse_mass),
            pushes ? 3 * free[i] * free[i] : 0);
        visit(&s, 0.5);
        ck_assert_double_eq(s.move[5], pushes ? -1 / free[i] : 0);
    }
}
END_TEST

// What counts is the vertex that moves farthest, however light it is.
START_TEST(a_light_vertex_is_no_lever)
{
    scene s = {.axes = 2,
               .constraint = {.vertex = {0, 1, 2, -1},
                              .coefficient = {1, 1e-6 - 1, -1e-6},
                              .normal = {0, 1, 0}},
               .inverse_mass = {1, 0, 1e6},
               .move = {0, -1}};
    visit(&s, 0);
    ck_assert_double_eq_tol(gap_change(&s), 0, 1e-15);
}
END_TEST

START_TEST(friction_is_that_of_coulomb)
{
    // A mass of 1 on a floor at rest comes down by 1 and slides by (3, 4).
    const double friction[] = {0, 0.5, 2, 6};
    for (int i = 0; i < 4; i++) {
        scene s = {.axes = 3,
                   .constraint = {.vertex = {0, 1, -1, -1},
                                  .coefficient = {1, -1},
                                  .normal = {0, 0, 1}},
                   .inverse_mass = {1, 0},
                   .move = {3, 4, -1}};
        double left = fmax(0, 1 - friction[i] / 5);
        for (int visits = 0; visits < 3; visits++) { // the later ones in vain
            visit(&s, friction[i]);
            ck_assert_double_eq_tol(s.move[0], 3 * left, 1e-14);
            ck_assert_double_eq_tol(s.move[1], 4 * left, 1e-14);
            ck_assert_double_eq_tol(s.move[2], 0, 1e-14);
        }
    }
}
END_TEST

START_TEST(friction_takes_energy)
{
    generator random = generator_new(5);
    for (long i = cases(TRIALS); i > 0; i--) {
        scene s = random_scene(&random), smooth = s;
        visit(&smooth, 0);
        visit(&s, uniform(&random, 0, 2));
        ck_assert_double_le(energy(&s), energy(&smooth) * (1 + 1e-12));
    }
}
END_TEST

START_TEST(impulses_are_taken_back_but_never_pull)
{
    scene s = {.axes = 2,
               .constraint = {.vertex = {0, 1, -1, -1},
                              .coefficient = {1, -1},
                              .normal = {0, 1}},
               .inverse_mass = {1, 1},
               .move = {0, 0, 0, 1}};
    visit(&s, 0);
    ck_assert_double_eq(s.constraint.impulse, 0.5);

    // Another constraint has pushed the second vertex away in the meantime.
    s.move[3] -= 0.75;
    visit(&s, 0);
    ck_assert_double_eq(s.constraint.impulse, 0.125);
    ck_assert_double_eq(gap_change(&s), 0);
    s.move[3] -= 3;
    visit(&s, 0);
    ck_assert_double_eq(s.constraint.impulse, 0);
    ck_assert_double_eq(s.move[1], 0);
}
END_TEST

START_TEST(scripted_vertices_are_left_alone)
{
    scene s = {.axes = 2,
               .constraint = {.vertex = {0, 1, -1, -1},
                              .coefficient = {1, -1},
                              .normal = {0, 1}},
               .move = {0, 0, 0, 1}};
    scene before = s;
    visit(&s, 1);
    ck_assert_mem_eq(&s, &before, sizeof s);
}
END_TEST

// Friction of vertices --------------------------------------------------------

static tf_constraint random_pair(generator *random)
{
    scene s = random_scene(random);
    if (s.axes == 2 || below(random, 2))
        return s.constraint;
    double a = uniform(random, 0, 1), b = uniform(random, 0, 1);
    const double edges[] = {a, 1 - a, -b, b - 1};
    memcpy(s.constraint.coefficient, edges, sizeof edges);
    return s.constraint;
}

static double friction_of(const tf_constraint *constraint, const double own[])
{
    return tf_constraint_friction(constraint, (tf_friction){7, own});
}

START_TEST(one_coefficient_for_all_is_that_of_a_constraint)
{
    static const double ends[] = {0, 0x1p-1074, 0x1p-1022, 1, DBL_MAX};
    generator random = generator_new(77);
    for (int i = 0; i < TRIALS; i++) {
        tf_constraint constraint = random_pair(&random);
        double m = i < 5 ? ends[i] : uniform(&random, 0, 3);
        const double own[VERTICES] = {m, m, m, m};
        ck_assert_double_eq(friction_of(&constraint, own), m);
        ck_assert_double_eq(
            tf_constraint_friction(&constraint, (tf_friction){m, NULL}), m);
    }
}
END_TEST

START_TEST(friction_is_the_geometric_mean_of_both_elements)
{
    generator random = generator_new(78);
    for (int i = 0; i < TRIALS; i++) {
        tf_constraint constraint = random_pair(&random);
        long double mean[2] = {0};
        double own[VERTICES];
        for (int v = 0; v < VERTICES; v++) {
            double c = constraint.coefficient[v];
            own[v] = ldexp(uniform(&random, 0, 1), below(&random, 9));
            mean[c < 0] += fabsl((long double)c) * own[v];
        }
        double wanted = (double)sqrtl(mean[0] * mean[1]);
        ck_assert_double_eq_tol(friction_of(&constraint, own), wanted,
                                1e-14 * wanted);
        ck_assert_double_eq(
            tf_constraint_friction(&constraint, (tf_friction){7, NULL}), 7);
    }
}
END_TEST

// Whatever the other element is made of.
START_TEST(an_element_without_friction_slides)
{
    tf_constraint constraint = {.vertex = {0, 1, 2, 3},
                                .coefficient = {0.25, 0.75, -0.5, -0.5}};
    const double first[] = {0, 0, DBL_MAX, DBL_MAX}, second[] = {9, 1, 0, 0};
    ck_assert_double_eq(friction_of(&constraint, first), 0);
    ck_assert_double_eq(friction_of(&constraint, second), 0);
}
END_TEST

// The product of both would be infinite, or 0.
START_TEST(coefficients_are_of_any_size)
{
    const tf_constraint constraint = {.vertex = {0, 1, 2, 3},
                                      .coefficient = {0.25, 0.75, -0.5, -0.5}};
    const double large[] = {0x1p1020, 0x1p1020, 16, 16};
    ck_assert_double_eq(friction_of(&constraint, large), 0x1p512);
    const double small[] = {0x1p-900, 0x1p-900, 0x1p-1000, 0x1p-1000};
    ck_assert_double_eq(friction_of(&constraint, small), 0x1p-950);
}
END_TEST

// Which element comes first, and in which order it has its vertices, makes no
// difference but for rounding.
START_TEST(friction_has_no_order)
{
    generator random = generator_new(79);
    for (int i = 0; i < TRIALS; i++) {
        tf_constraint constraint = random_pair(&random), turned = constraint;
        int used = constraint.vertex[3] < 0 ? 3 : 4;
        double own[VERTICES];
        for (int v = 0; v < VERTICES; v++) {
            own[v] = uniform(&random, 0, 2);
            int from = used - 1 - v;
            if (v >= used)
                continue;
            turned.vertex[v] = constraint.vertex[from];
            turned.coefficient[v] = -constraint.coefficient[from];
        }
        double friction = friction_of(&constraint, own);
        ck_assert_double_eq_tol(friction_of(&turned, own), friction,
                                1e-15 * friction);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_create("response/impulse");
    TCase *visits = tcase_create("visits");
    tcase_add_test(visits, visits_widen_the_gap_to_the_bound);
    tcase_add_test(visits, no_other_push_changes_less);
    tcase_add_test(visits, visits_keep_momentum);
    tcase_add_test(visits, visits_change_the_energy_as_proved);
    tcase_add_test(visits, a_short_lever_pushes_nothing);
    tcase_add_test(visits, a_light_vertex_is_no_lever);
    tcase_add_test(visits, impulses_are_taken_back_but_never_pull);
    tcase_add_test(visits, scripted_vertices_are_left_alone);
    suite_add_tcase(s, visits);
    TCase *friction = tcase_create("friction");
    tcase_add_test(friction, friction_is_that_of_coulomb);
    tcase_add_test(friction, friction_takes_energy);
    suite_add_tcase(s, friction);
    TCase *own = tcase_create("friction of vertices");
    tcase_add_test(own, one_coefficient_for_all_is_that_of_a_constraint);
    tcase_add_test(own, friction_is_the_geometric_mean_of_both_elements);
    tcase_add_test(own, an_element_without_friction_slides);
    tcase_add_test(own, coefficients_are_of_any_size);
    tcase_add_test(own, friction_has_no_order);
    suite_add_tcase(s, own);
    return s;
}
