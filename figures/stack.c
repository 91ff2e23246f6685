#include "stack.h"

#include "base/require.h"
#include "surface/surface.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void *room_for(int count, size_t size)
{
    void *room = calloc((size_t)count + 1, size);
    TF_REQUIRE(room);
    return room;
}

fig_stack fig_stack_new(int edges)
{
    int vertices = 2 * edges;
    fig_stack stack = {.edges = edges,
                       .vertices = vertices,
                       .edge = room_for(vertices, sizeof(int)),
                       .start = room_for(2 * vertices, sizeof(double)),
                       .proposed = room_for(2 * vertices, sizeof(double)),
                       .end = room_for(2 * vertices, sizeof(double)),
                       .inverse_mass = room_for(vertices, sizeof(double))};
    for (int v = 0; v < vertices; v++) {
        stack.edge[v] = v;
        stack.inverse_mass[v] = v >= 2;
    }
    return stack;
}

void fig_stack_free(fig_stack *stack)
{
    free(stack->edge);
    free(stack->start);
    free(stack->proposed);
    free(stack->end);
    free(stack->inverse_mass);
    tf_zones_free(&stack->zones);
}

void fig_stack_put(fig_stack *stack, int edge, const double place[2][2],
                   const double displacement[2][2])
{
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 2; k++) {
            int at = 2 * (2 * edge + i) + k;
            stack->start[at] = place[i][k];
            stack->proposed[at] = place[i][k] + displacement[i][k];
        }
}

// Rounds -----------------------------------------------------------------

static void answer(fig_stack *stack, tf_step *step, const tf_contacts *found,
                   const tf_zone_solver *solver, int sweeps)
{
    const tf_row_rule rule = {.base = stack->proposed};
    const tf_zone_choice choice = {.solver = solver, .sweeps = sweeps};
    tf_zone_effort effort = {.smallest_gap = INFINITY};
    TF_REQUIRE(tf_zones_add(&stack->zones, step, found, &rule, &effort));
    TF_REQUIRE(tf_zones_solve(&stack->zones, step, &rule, &choice, &effort));
}

void fig_stack_resolve(fig_stack *stack, const tf_zone_solver *solver,
                       int sweeps, int most_rounds)
{
    const tf_mesh mesh = {.axes = 2,
                          .vertices = stack->vertices,
                          .edges = stack->edges,
                          .edge = stack->edge};
    tf_surface *surface;
    TF_REQUIRE(tf_surface_create(&mesh, &surface, NULL) == TF_OK);
    memcpy(stack->end, stack->proposed,
           2 * sizeof(double) * (size_t)stack->vertices);
    tf_step step = {.axes = 2,
                    .vertices = stack->vertices,
                    .start = stack->start,
                    .proposed = stack->proposed,
                    .inverse_mass = stack->inverse_mass,
                    .end = stack->end,
                    .changed = room_for(stack->vertices, sizeof(bool))};
    const tf_motion motion = {stack->vertices, stack->start, stack->end};
    TF_REQUIRE(tf_zones_begin(&stack->zones));
    for (stack->rounds = 0; stack->rounds < most_rounds; stack->rounds++) {
        tf_contacts found;
        TF_REQUIRE(tf_surface_detect(surface, &motion, NULL, &found, NULL) ==
                   TF_OK);
        if (stack->rounds == 0)
            stack->contacts = (int)found.count;
        if (!found.any)
            break;
        answer(stack, &step, &found, solver, sweeps);
    }
    free(step.changed);
    tf_surface_free(surface);
}

// The zone ---------------------------------------------------------------

fig_some_zone fig_stack_zone(const fig_stack *stack, int more)
{
    int rows = stack->zones.rows, numbers = 2 * stack->vertices;
    fig_some_zone some = {.proposal = room_for(numbers, sizeof(double)),
                          .displacement = room_for(numbers, sizeof(double)),
                          .inverse_mass =
                              room_for(stack->vertices, sizeof(double)),
                          .row = room_for(rows + more, sizeof(tf_row))};
    memcpy(some.row, stack->zones.row.data, sizeof(tf_row) * (size_t)rows);
    memcpy(some.inverse_mass, stack->inverse_mass,
           sizeof(double) * (size_t)stack->vertices);
    for (int i = 0; i < numbers; i++)
        some.proposal[i] = stack->proposed[i] - stack->start[i];
    some.zone = (tf_zone){.axes = 2,
                          .vertices = stack->vertices,
                          .rows = rows,
                          .row = some.row,
                          .inverse_mass = some.inverse_mass,
                          .displacement = some.displacement};
    fig_zone_reset(&some);
    return some;
}

void fig_some_zone_free(fig_some_zone *some)
{
    free(some->proposal);
    free(some->displacement);
    free(some->inverse_mass);
    free(some->row);
}

void fig_zone_reset(fig_some_zone *some)
{
    const tf_zone *zone = &some->zone;
    memcpy(some->displacement, some->proposal,
           sizeof(double) * (size_t)(zone->axes * zone->vertices));
    for (int i = 0; i < zone->rows; i++)
        some->row[i].impulse = 0;
}

double fig_zone_energy(const fig_some_zone *some)
{
    const tf_zone *zone = &some->zone;
    double sum = 0;
    for (int v = 0; v < zone->vertices; v++)
        for (int k = 0; k < zone->axes && zone->inverse_mass[v] > 0; k++) {
            double d = zone->displacement[zone->axes * v + k];
            sum += d * d / (2 * zone->inverse_mass[v]);
        }
    return sum;
}

/// The matrix, row after row.
static double *dense(const tf_zone *zone)
{
    int n = zone->rows;
    double *a = room_for(n * n, sizeof *a), *unit = room_for(n, sizeof *unit);
    double *room = room_for(zone->axes * zone->vertices, sizeof *room);
    for (int j = 0; j < n; j++) {
        unit[j] = 1;
        tf_zone_multiply(zone, unit, a + (ptrdiff_t)n * j, room);
        unit[j] = 0;
    }
    free(unit);
    free(room);
    return a;
}

/// By elimination; the pivot is the largest entry that is left on the diagonal.
int fig_zone_rank(const tf_zone *zone)
{
    int n = zone->rows, rank = 0;
    double *a = dense(zone);
    bool *used = room_for(n, sizeof *used);
    for (; rank < n; rank++) {
        int p = 0;
        for (int i = 1; i < n; i++)
            if (!used[i] && (used[p] || a[n * i + i] > a[n * p + p]))
                p = i;
        if (used[p] || !(a[n * p + p] > 1e-12))
            break;
        used[p] = true;
        for (int i = 0; i < n; i++)
            for (int j = 0; j < n && !used[i]; j++)
                if (!used[j])
                    a[n * i + j] -= a[n * i + p] * a[n * p + j] / a[n * p + p];
    }
    free(used);
    free(a);
    return rank;
}
