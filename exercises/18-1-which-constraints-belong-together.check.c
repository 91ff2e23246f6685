#include "check.h"

#include "response/constraint.h"
#include "support/support.h"

#include <stdbool.h>
#include <stdio.h>

enum {
    MOST_CONSTRAINTS = 24,
    MOST_VERTICES = 40
};

int number_zones(int constraints, const tf_constraint constraint[],
                 const double inverse_mass[], int zone[]);

static tf_constraint constraint_of(int a, int b, int c)
{
    return (tf_constraint){.vertex = {a, b, c, -1},
                           .coefficient = {1, -0.5, -0.5},
                           .normal = {0, 1}};
}

/// Whether a constraint moves a vertex.
static bool constraint_moves(const tf_constraint *constraint, int vertex,
                             const double inverse_mass[])
{
    for (int i = 0; i < 4; i++)
        if (constraint->vertex[i] == vertex)
            return inverse_mass[vertex] > 0;
    return false;
}

/// Walks from a constraint to all that can be reached, vertex by vertex.
static void spread(int constraints, const tf_constraint constraint[],
                   const double inverse_mass[], int from, int number,
                   int zone[])
{
    zone[from] = number;
    for (int v = 0; v < MOST_VERTICES; v++)
        for (int i = 0; i < constraints &&
                        constraint_moves(&constraint[from], v, inverse_mass);
             i++)
            if (zone[i] < 0 &&
                constraint_moves(&constraint[i], v, inverse_mass))
                spread(constraints, constraint, inverse_mass, i, number, zone);
}

static bool constraint_moves_any(const tf_constraint *constraint,
                                 const double inverse_mass[])
{
    bool any = false;
    for (int v = 0; v < MOST_VERTICES; v++)
        any |= constraint_moves(constraint, v, inverse_mass);
    return any;
}

static void expect(int constraints, const tf_constraint constraint[],
                   const double inverse_mass[])
{
    int right[MOST_CONSTRAINTS], got[MOST_CONSTRAINTS], zones = 0;
    for (int i = 0; i < constraints; i++)
        right[i] = -1;
    for (int i = 0; i < constraints; i++)
        if (right[i] < 0 && constraint_moves_any(&constraint[i], inverse_mass))
            spread(constraints, constraint, inverse_mass, i, zones++, right);

    char text[40 * MOST_CONSTRAINTS];
    int length = 0;
    for (int i = 0; i < constraints; i++)
        length += snprintf(text + length, sizeof text - (size_t)length,
                           "%s%d %d %d", i ? ", " : "", constraint[i].vertex[0],
                           constraint[i].vertex[1], constraint[i].vertex[2]);
    char scripted[8 * MOST_VERTICES] = "";
    length = 0;
    for (int v = 0; v < MOST_VERTICES; v++)
        if (!(inverse_mass[v] > 0))
            length += snprintf(scripted + length,
                               sizeof scripted - (size_t)length, " %d", v);
    check_input("constraints of the vertices %s; scripted vertices:%s", text,
                scripted);
    for (int i = 0; i < MOST_CONSTRAINTS; i++)
        got[i] = -2;
    int count;
    check_value(count,
                number_zones(constraints, constraint, inverse_mass, got));
    check_also(got);
    char number[16];
    for (int i = 0; i < constraints; i++) {
        snprintf(number, sizeof number, "%d", right[i]);
        check_that(got[i] == right[i], number, "%d for constraint %d", got[i],
                   i);
    }
    snprintf(number, sizeof number, "%d", zones);
    check_that(count == zones, number, "%d zones", count);
}

static void free_all(double inverse_mass[MOST_VERTICES])
{
    for (int v = 0; v < MOST_VERTICES; v++)
        inverse_mass[v] = 1;
}

TEST(constraints_share_a_vertex)
{
    double inverse_mass[MOST_VERTICES];
    free_all(inverse_mass);
    expect(2, (tf_constraint[]){constraint_of(0, 1, 2), constraint_of(3, 4, 5)},
           inverse_mass);
    expect(2, (tf_constraint[]){constraint_of(0, 1, 2), constraint_of(3, 4, 2)},
           inverse_mass);
    expect(3,
           (tf_constraint[]){constraint_of(0, 1, 2), constraint_of(3, 4, 5),
                             constraint_of(5, 2, 6)},
           inverse_mass);
}

TEST(a_floor_connects_nothing)
{
    double inverse_mass[MOST_VERTICES];
    free_all(inverse_mass);
    inverse_mass[8] = inverse_mass[9] = 0;
    expect(2, (tf_constraint[]){constraint_of(0, 8, 9), constraint_of(1, 8, 9)},
           inverse_mass);
    inverse_mass[0] = 0;
    expect(3,
           (tf_constraint[]){constraint_of(0, 8, 9), constraint_of(1, 8, 9),
                             constraint_of(2, 1, 9)},
           inverse_mass);
}

TEST(some_at_random)
{
    generator random = generator_new(18);
    for (int times = 0; times < 500; times++) {
        double inverse_mass[MOST_VERTICES];
        tf_constraint constraint[MOST_CONSTRAINTS];
        for (int v = 0; v < MOST_VERTICES; v++)
            inverse_mass[v] = below(&random, 4) > 0;
        int constraints = 1 + below(&random, MOST_CONSTRAINTS);
        for (int i = 0; i < constraints; i++) {
            int a = below(&random, MOST_VERTICES - 2);
            int b = a + 1 + below(&random, MOST_VERTICES - 2 - a);
            constraint[i] = constraint_of(
                a, b, b + 1 + below(&random, MOST_VERTICES - 1 - b));
        }
        expect(constraints, constraint, inverse_mass);
    }
}

void run_tests(void)
{
    check_run(1, constraints_share_a_vertex);
    check_run(1, a_floor_connects_nothing);
    check_run(1, some_at_random);
}
