#include "plane_rows.h"

#include "base/require.h"
#include "response/conjugate_residuals.h"
#include "response/gauss_seidel.h"

#include <string.h>

enum {
    VERTICES = 2, ///< the vertex, and an obstacle
    ROOM = 128
};

tf_row fig_plane_row(const double normal[2], double bound)
{
    return (tf_row){.vertex = {0, 1, -1, -1},
                    .coefficient = {1, -1},
                    .normal = {normal[0], normal[1]},
                    .bound = bound};
}

static void solve(const tf_zone_solver *solver, const fig_plane_rows *rows,
                  const double proposal[2], int most, double displacement[2],
                  double impulse[])
{
    fig_plane_rows own = *rows;
    double place[2 * VERTICES] = {proposal[0], proposal[1]}, room[ROOM];
    const double inverse_mass[VERTICES] = {1, 0};
    TF_REQUIRE(solver->room(2, VERTICES, own.count) <= ROOM);
    tf_zone zone = {.axes = 2,
                    .vertices = VERTICES,
                    .rows = own.count,
                    .row = own.row,
                    .inverse_mass = inverse_mass,
                    .displacement = place,
                    .sweeps = most,
                    .room = room};
    solver->solve(&zone);
    memcpy(displacement, place, 2 * sizeof *place);
    for (int i = 0; i < own.count; i++)
        impulse[i] = own.row[i].impulse;
}

void fig_plane_sweeps(const fig_plane_rows *rows, const double proposal[2],
                      int sweeps, double displacement[2], double impulse[])
{
    solve(&tf_gauss_seidel, rows, proposal, sweeps, displacement, impulse);
}

void fig_plane_residuals(const fig_plane_rows *rows, const double proposal[2],
                         int iterations, double displacement[2],
                         double impulse[])
{
    solve(&tf_conjugate_residuals, rows, proposal, iterations, displacement,
          impulse);
}
