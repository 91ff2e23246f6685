//: Multiply by a zone's matrix
#include "response/zone.h"

#include "base/require.h"
#include "response/impulse.h"

#include <string.h>

void tf_zone_push(const tf_zone *zone, const double impulse[],
                  double displacement[])
{
    TF_REQUIRE(zone && impulse && displacement);
    tf_bodies bodies = {zone->axes, zone->inverse_mass, displacement};
    for (int i = 0; i < zone->rows; i++) {
        const tf_row *row = &zone->row[i];
        double push[3];
        for (int k = 0; k < 3; k++)
            push[k] = impulse[i] * row->normal[k];
        tf_row_push(row, push, &bodies);
    }
}

void tf_zone_partings(const tf_zone *zone, const double displacement[],
                      double parting[])
{
    TF_REQUIRE(zone && displacement && parting);
    for (int i = 0; i < zone->rows; i++)
        parting[i] = tf_row_parting(zone->axes, &zone->row[i], displacement);
}

void tf_zone_multiply(const tf_zone *zone, const double impulse[],
                      double parting[], double room[])
{
    TF_REQUIRE(zone && impulse && parting && room);
    size_t numbers = (size_t)zone->axes * (size_t)zone->vertices;
    memset(room, 0, numbers * sizeof *room);
    tf_zone_push(zone, impulse, room);
    tf_zone_partings(zone, room, parting);
}
