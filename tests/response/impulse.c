// Visits of a row, and what they preserve.
#include "response/impulse.h"

#include "support/support.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

enum {
    VERTICES = 4,
    TRIALS = 500
};

/// A row, and the vertices that it is about.
typedef struct scene {
    int axes;
    tf_row row;
    double inverse_mass[VERTICES], move[3 * VERTICES];
} scene;

static tf_bodies bodies_of(scene *s)
{
    return (tf_bodies){s->axes, s->inverse_mass, s->move};
}

/// A row of a point and an element of two or three vertices.
static scene random_scene(generator *random)
{
    scene s = {.axes = 2 + below(random, 2)};
    double sum = 0, square = 0;
    for (int i = 0; i < VERTICES; i++) {
        bool used = i <= s.axes;
        s.row.vertex[i] = used ? i : -1;
        s.row.coefficient[i] = used ? uniform(random, 0.01, 1) : 0;
        s.inverse_mass[i] = uniform(random, 0.1, 2);
        sum += i > 0 ? s.row.coefficient[i] : 0;
    }
    s.row.coefficient[0] = 1;
    for (int i = 1; i <= s.axes; i++)
        s.row.coefficient[i] /= -sum;
    for (int k = 0; k < s.axes; k++) {
        s.row.normal[k] = uniform(random, -1, 1);
        square += s.row.normal[k] * s.row.normal[k];
    }
    for (int k = 0; k < s.axes; k++)
        s.row.normal[k] /= sqrt(square);
    for (int i = 0; i < 3 * VERTICES; i++)
        s.move[i] = uniform(random, -1, 1);
    return s;
}

static double parting(const scene *s)
{
    return tf_row_parting(s->axes, &s->row, s->move);
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
    tf_row_visit(&s->row, friction, &bodies);
}

START_TEST(parts_the_elements_as_far_as_is_wanted)
{
    generator random = generator_new(1);
    for (long i = cases(TRIALS); i > 0; i--) {
        scene s = random_scene(&random);
        s.row.bound = uniform(&random, 0, 1);
        double before = parting(&s);
        visit(&s, 0);
        ck_assert_double_eq_tol(parting(&s), fmax(before, s.row.bound), 1e-12);
        ck_assert((s.row.impulse > 0) == (before < s.row.bound));
    }
}
END_TEST

START_TEST(no_other_push_is_less)
{
    generator random = generator_new(2);
    for (long i = cases(TRIALS); i > 0; i--) {
        scene s = random_scene(&random), other = s, from = s;
        s.row.bound = parting(&s) + uniform(&random, 0, 1);
        visit(&s, 0);

        // Any change, scaled to part the elements as far.
        for (int v = 0; v < 3 * VERTICES; v++)
            other.move[v] = uniform(&random, -1, 1);
        double part = (s.row.bound - parting(&from)) / parting(&other);
        for (int v = 0; v < 3 * VERTICES; v++)
            other.move[v] = from.move[v] + part * other.move[v];
        ck_assert_double_eq_tol(parting(&other), s.row.bound, 1e-9);
        ck_assert_double_le(change(&s, &from),
                            change(&other, &from) * (1 + 1e-12));
    }
}
END_TEST

START_TEST(keeps_momentum)
{
    generator random = generator_new(3);
    for (long i = cases(TRIALS); i > 0; i--) {
        scene s = random_scene(&random), from = s;
        s.row.bound = 1;
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

START_TEST(changes_the_energy_as_proved)
{
    generator random = generator_new(4);
    for (long i = cases(TRIALS); i > 0; i--) {
        scene s = random_scene(&random);
        if (i % 2 == 0) { // the point is scripted to rest
            s.inverse_mass[0] = 0;
            memset(s.move, 0, sizeof(double) * (size_t)s.axes);
        }
        double before = energy(&s), at = parting(&s);
        double restitution = uniform(&random, 0, 1);
        s.row.bound = fmax(0, -restitution * at);
        visit(&s, 0);
        double lost = at < 0 ? at * at - s.row.bound * s.row.bound : 0;
        double compliance = tf_row_compliance(&s.row, s.inverse_mass);
        ck_assert_double_eq_tol(before - energy(&s), lost / (2 * compliance),
                                1e-12);
    }
}
END_TEST

START_TEST(friction_is_that_of_coulomb)
{
    // A mass of 1 on a floor at rest comes down by 1 and slides by (3, 4).
    const double friction[] = {0, 0.5, 2, 6};
    for (int i = 0; i < 4; i++) {
        scene s = {.axes = 3,
                   .row = {.vertex = {0, 1, -1, -1},
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

START_TEST(takes_back_what_it_gave_and_no_more)
{
    scene s = {.axes = 2,
               .row = {.vertex = {0, 1, -1, -1},
                       .coefficient = {1, -1},
                       .normal = {0, 1}},
               .inverse_mass = {1, 1},
               .move = {0, 0, 0, 1}};
    visit(&s, 0);
    ck_assert_double_eq(s.row.impulse, 0.5);

    // Another row has pushed the second vertex away in the meantime.
    s.move[3] -= 0.75;
    visit(&s, 0);
    ck_assert_double_eq(s.row.impulse, 0.125);
    ck_assert_double_eq(parting(&s), 0);
    s.move[3] -= 3;
    visit(&s, 0);
    ck_assert_double_eq(s.row.impulse, 0);
    ck_assert_double_eq(s.move[1], 0);
}
END_TEST

START_TEST(leaves_what_cannot_be_moved)
{
    scene s = {.axes = 2,
               .row = {.vertex = {0, 1, -1, -1},
                       .coefficient = {1, -1},
                       .normal = {0, 1}},
               .move = {0, 0, 0, 1}};
    scene before = s;
    visit(&s, 1);
    ck_assert_mem_eq(&s, &before, sizeof s);
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_create("response/impulse");
    TCase *visits = tcase_create("visits");
    tcase_add_test(visits, parts_the_elements_as_far_as_is_wanted);
    tcase_add_test(visits, no_other_push_is_less);
    tcase_add_test(visits, keeps_momentum);
    tcase_add_test(visits, changes_the_energy_as_proved);
    tcase_add_test(visits, takes_back_what_it_gave_and_no_more);
    tcase_add_test(visits, leaves_what_cannot_be_moved);
    suite_add_tcase(s, visits);
    TCase *friction = tcase_create("friction");
    tcase_add_test(friction, friction_is_that_of_coulomb);
    tcase_add_test(friction, friction_takes_energy);
    suite_add_tcase(s, friction);
    return s;
}
