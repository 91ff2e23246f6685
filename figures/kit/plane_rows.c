#include "kit/plane_rows.h"

#include "base/require.h"
#include "response/conjugate_residuals.h"
#include "response/impulse.h"

#include <string.h>

enum {
    VERTICES = 2, ///< the vertex, and an obstacle
    ROOM = 128
};

static const double inverse_mass[VERTICES] = {1, 0};

tf_constraint fig_plane_row(const double normal[2], double bound)
{
    return (tf_constraint){.vertex = {0, 1, -1, -1},
                           .coefficient = {1, -1},
                           .normal = {normal[0], normal[1]},
                           .bound = bound};
}

void fig_plane_sweeps(const fig_plane_rows *rows, const double proposal[2],
                      int sweeps, double displacement[2], double impulse[])
{
    fig_plane_rows own = *rows;
    double place[2 * VERTICES] = {proposal[0], proposal[1]};
    const tf_bodies bodies = {2, inverse_mass, place};
    for (int i = 0; i < sweeps * own.count; i++)
        tf_constraint_visit(&own.row[i % own.count], 0, &bodies);
    memcpy(displacement, place, 2 * sizeof *place);
    for (int i = 0; i < own.count; i++)
        impulse[i] = own.row[i].impulse;
}

void fig_plane_residuals(const fig_plane_rows *rows, const double proposal[2],
                         int iterations, double displacement[2],
                         double impulse[])
{
    fig_plane_rows own = *rows;
    double place[2 * VERTICES] = {proposal[0], proposal[1]}, room[ROOM];
    TF_REQUIRE(tf_conjugate_residuals.workspace(2, VERTICES, own.count) <=
               ROOM);
    tf_zone zone = {.axes = 2,
                    .vertices = VERTICES,
                    .constraints = own.count,
                    .constraint = own.row,
                    .inverse_mass = inverse_mass,
                    .displacement = place,
                    .sweeps = iterations,
                    .workspace = room};
    tf_conjugate_residuals.solve(&zone);
    memcpy(displacement, place, 2 * sizeof *place);
    for (int i = 0; i < own.count; i++)
        impulse[i] = own.row[i].impulse;
}
