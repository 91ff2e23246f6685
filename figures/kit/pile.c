#include "kit/pile.h"

#include "base/require.h"
#include "fast/detect.h"
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

fig_pile fig_pile_new(int edges)
{
    int vertices = 2 * edges;
    fig_pile pile = {.edges = edges,
                     .vertices = vertices,
                     .edge = room_for(vertices, sizeof(int)),
                     .start = room_for(2 * vertices, sizeof(double)),
                     .proposed = room_for(2 * vertices, sizeof(double)),
                     .end = room_for(2 * vertices, sizeof(double)),
                     .inverse_mass = room_for(vertices, sizeof(double))};
    for (int v = 0; v < vertices; v++) {
        pile.edge[v] = v;
        pile.inverse_mass[v] = v >= 2;
    }
    return pile;
}

void fig_pile_free(fig_pile *pile)
{
    free(pile->edge);
    free(pile->start);
    free(pile->proposed);
    free(pile->end);
    free(pile->inverse_mass);
    tf_zones_free(&pile->zones);
}

void fig_pile_put(fig_pile *pile, int edge, const double place[4],
                  const double displacement[4])
{
    for (int i = 0; i < 4; i++) {
        pile->start[4 * edge + i] = place[i];
        pile->proposed[4 * edge + i] = place[i] + displacement[i];
    }
}

// Rounds -----------------------------------------------------------------

static void answer(fig_pile *pile, tf_step *step, const tf_contacts *found,
                   const tf_zone_solver *solver, int sweeps)
{
    const tf_contact_rule rule = {.base = pile->proposed};
    const tf_zone_options choice = {.solver = solver, .sweeps = sweeps};
    tf_zone_statistics statistics = {.smallest_gap = INFINITY};
    TF_REQUIRE(tf_zones_add(&pile->zones, step, found, &rule, &statistics));
    TF_REQUIRE(tf_zones_solve(&pile->zones, step, &rule, &choice, &statistics));
    pile->zones_solved = (int)statistics.zones;
}

void fig_pile_resolve(fig_pile *pile, const tf_zone_solver *solver, int sweeps,
                      int most_rounds)
{
    const tf_mesh mesh = {.axes = 2,
                          .vertices = pile->vertices,
                          .edges = pile->edges,
                          .edge = pile->edge};
    tf_surface *surface;
    TF_REQUIRE(tf_surface_create(&mesh, &surface, NULL) == TF_OK);
    memcpy(pile->end, pile->proposed,
           2 * sizeof(double) * (size_t)pile->vertices);
    tf_step step = {.axes = 2,
                    .vertices = pile->vertices,
                    .start = pile->start,
                    .proposed = pile->proposed,
                    .inverse_mass = pile->inverse_mass,
                    .end = pile->end,
                    .unpushed = pile->end}; // nothing is pushed apart
    const tf_motion motion = {2, pile->vertices, pile->start, pile->end};
    TF_REQUIRE(tf_zones_begin(&pile->zones, &step));
    for (pile->rounds = 0; pile->rounds < most_rounds; pile->rounds++) {
        tf_contacts found;
        TF_REQUIRE(tf_surface_detect(surface, &motion, NULL, &found, NULL) ==
                   TF_OK);
        if (pile->rounds == 0)
            pile->contacts = (int)found.count;
        if (!found.any)
            break;
        answer(pile, &step, &found, solver, sweeps);
    }
    tf_surface_free(surface);
}

// The zone ---------------------------------------------------------------

fig_some_zone fig_pile_zone(const fig_pile *pile, int more)
{
    int rows = pile->zones.constraints, numbers = 2 * pile->vertices;
    fig_some_zone some = {.proposal = room_for(numbers, sizeof(double)),
                          .displacement = room_for(numbers, sizeof(double)),
                          .inverse_mass =
                              room_for(pile->vertices, sizeof(double)),
                          .row = room_for(rows + more, sizeof(tf_constraint))};
    memcpy(some.row, pile->zones.constraint.data,
           sizeof(tf_constraint) * (size_t)rows);
    memcpy(some.inverse_mass, pile->inverse_mass,
           sizeof(double) * (size_t)pile->vertices);
    for (int i = 0; i < numbers; i++)
        some.proposal[i] = pile->proposed[i] - pile->start[i];
    some.zone = (tf_zone){.axes = 2,
                          .vertices = pile->vertices,
                          .constraints = rows,
                          .constraint = some.row,
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
    for (int i = 0; i < zone->constraints; i++)
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

double *fig_zone_matrix(const tf_zone *zone)
{
    int n = zone->constraints;
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
    int n = zone->constraints, rank = 0;
    double *a = fig_zone_matrix(zone);
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
