//: Include what projected Gauss-Seidel needs
#include "response/gauss_seidel.h"

#include "base/require.h"
#include "response/impulse.h"

#include <math.h>

//: Start from the impulses of the last time
/// Applies the impulses that the rows have; returns the largest violation that
/// there was before.
static double start(const tf_zone *zone, const tf_bodies *bodies)
{
    double violation = 0;
    for (int i = 0; i < zone->rows; i++) {
        const tf_row *row = &zone->row[i];
        double parting = tf_row_parting(zone->axes, row, bodies->displacement);
        violation = fmax(violation, row->bound - parting);
    }
    for (int i = 0; i < zone->rows; i++) {
        const tf_row *row = &zone->row[i];
        double push[3];
        for (int k = 0; k < 3; k++)
            push[k] = row->impulse * row->normal[k] + row->friction[k];
        tf_row_push(row, push, bodies);
    }
    return violation;
}

//: Sweep until little changes
static const double tolerance = 1e-5;

static int solve(tf_zone *zone)
{
    TF_REQUIRE(zone && zone->row && zone->inverse_mass && zone->displacement);
    tf_bodies bodies = {zone->axes, zone->inverse_mass, zone->displacement};
    double enough = tolerance * start(zone, &bodies);
    for (int sweep = 1; sweep <= zone->sweeps; sweep++) {
        double largest = 0;
        for (int i = 0; i < zone->rows; i++)
            largest = fmax(
                largest, tf_row_visit(&zone->row[i], zone->friction, &bodies));
        if (largest <= enough)
            return sweep;
    }
    return zone->sweeps;
}

//: Offer projected Gauss-Seidel
static size_t no_room(int axes, int vertices, int rows)
{
    (void)axes;
    (void)vertices;
    (void)rows;
    return 0;
}

const tf_zone_solver tf_gauss_seidel = {
    .name = "gauss-seidel", .room = no_room, .solve = solve};
