// Rows of a single vertex of the plane, of mass 1, against obstacles that rest.
#ifndef FIG_PLANE_ROWS_H
#define FIG_PLANE_ROWS_H

#include "response/zone.h"

enum {
    FIG_PLANE_ROWS = 4
};

typedef struct fig_plane_rows {
    int count;
    tf_constraint row[FIG_PLANE_ROWS];
} fig_plane_rows;

/// The row that asks for at least `bound` along a normal of length 1.
tf_constraint fig_plane_row(const double normal[2], double bound);

/// The displacement, and the impulses, after so many sweeps of projected
/// Gauss-Seidel from impulses of zero.
void fig_plane_sweeps(const fig_plane_rows *rows, const double proposal[2],
                      int sweeps, double displacement[2], double impulse[]);

/// The same after so many iterations of conjugate residuals.
void fig_plane_residuals(const fig_plane_rows *rows, const double proposal[2],
                         int iterations, double displacement[2],
                         double impulse[]);

#endif
