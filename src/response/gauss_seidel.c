//: Include what projected Gauss-Seidel needs
#include "response/gauss_seidel.h"

#include "base/require.h"
#include "response/impulse.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

//: Start from the impulses of the last time
/// The largest violation of some of the rows.
static double worst(const tf_zone *zone, int begin, int end)
{
    double violation = 0;
    for (int i = begin; i < end; i++) {
        const tf_row *row = &zone->row[i];
        double parting = tf_row_parting(zone->axes, row, zone->displacement);
        violation = fmax(violation, row->bound - parting);
    }
    return violation;
}

/// Applies the impulses that the rows have; returns how large violations were:
/// that of rows that were solved before by the proposal, that of others now.
static double start(const tf_zone *zone, const tf_bodies *bodies)
{
    double violation = worst(zone, 0, zone->solved);
    for (int i = 0; i < zone->rows; i++) {
        const tf_row *row = &zone->row[i];
        double push[3];
        for (int k = 0; k < 3; k++)
            push[k] = row->impulse * row->normal[k] + row->friction[k];
        tf_row_push(row, push, bodies);
    }
    return fmax(violation, worst(zone, zone->solved, zone->rows));
}

//: Note what has happened to a row
/// When rows were visited and vertices were moved, in visits since the start.
typedef struct visits {
    double now;
    double *of_row, *of_vertex;
} visits;

/// Rows that were solved before need a visit only after others have moved their
/// vertices; all others need one.
static visits no_visits(const tf_zone *zone)
{
    visits all = {.now = 1, .of_row = zone->room};
    all.of_vertex = all.of_row + zone->rows;
    for (int i = 0; i < zone->rows; i++)
        all.of_row[i] = i < zone->solved ? 1 : 0;
    for (int i = 0; i < zone->vertices; i++)
        all.of_vertex[i] = 1;
    return all;
}

/// Whether a vertex of a row has moved since the row was visited.
static bool is_disturbed(const visits *all, const tf_zone *zone, int row)
{
    const int *vertex = zone->row[row].vertex;
    for (int i = 0; i < 4 && vertex[i] >= 0; i++)
        if (all->of_vertex[vertex[i]] > all->of_row[row])
            return true;
    return false;
}

static void note_visit(visits *all, const tf_zone *zone, int row, bool moved)
{
    const int *vertex = zone->row[row].vertex;
    all->of_row[row] = ++all->now;
    for (int i = 0; moved && i < 4 && vertex[i] >= 0; i++)
        all->of_vertex[vertex[i]] = all->now;
}

//: Sweep until little changes
static const double tolerance = 1e-2;

/// Whether a row pushes too little or, so that it can be taken back, too much,
/// by more than `least`.
static bool is_off(const tf_row *row, double least, const tf_bodies *bodies)
{
    double missing =
        row->bound - tf_row_parting(bodies->axes, row, bodies->displacement);
    return missing > least || (row->impulse > 0 && missing < -least);
}

/// Visits a row if it is new or off; with friction also if it may be off across
/// the normal.  Returns by how much its parting changes.
static double visit(tf_row *row, bool is_new, double friction, double least,
                    const tf_bodies *bodies)
{
    if (!is_new && !(friction > 0) && !is_off(row, least, bodies))
        return 0;
    return tf_row_visit(row, friction, bodies);
}

/// Visits the rows whose vertices have moved; returns whether one of them
/// changed its parting by more than `least`.
static bool sweep(const tf_zone *zone, double least, const tf_bodies *bodies,
                  visits *all)
{
    bool any = false;
    for (int i = 0; i < zone->rows; i++) {
        if (!is_disturbed(all, zone, i))
            continue;
        bool is_new = !(all->of_row[i] > 0);
        double change =
            visit(&zone->row[i], is_new, zone->friction, least, bodies);
        note_visit(all, zone, i, change > least);
        any |= change > least;
    }
    return any;
}

static int solve_by_gauss_seidel(tf_zone *zone)
{
    TF_REQUIRE(zone && zone->row && zone->inverse_mass && zone->displacement &&
               zone->room);
    tf_bodies bodies = {zone->axes, zone->inverse_mass, zone->displacement};
    double least = tolerance * start(zone, &bodies);
    visits all = no_visits(zone);
    int sweeps = 1;
    while (sweep(zone, least, &bodies, &all) && sweeps < zone->sweeps)
        sweeps++;
    return sweeps;
}

//: Offer projected Gauss-Seidel
static size_t room_for(int axes, int vertices, int rows)
{
    (void)axes;
    return (size_t)vertices + (size_t)rows;
}

const tf_zone_solver tf_gauss_seidel = {
    .name = "gauss-seidel", .room = room_for, .solve = solve_by_gauss_seidel};
