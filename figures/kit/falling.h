// Vertices without springs that fall upon what stays, for figures about rest,
// bounces and slopes: the simplest client that a response can have.
#ifndef FIG_FALLING_H
#define FIG_FALLING_H

#include "response/resolve.h"

#include <stdbool.h>

enum {
    FIG_FALLING_MOST = 12 ///< vertices
};

/// What falls and where it falls.  Whoever sets it up begins with zero.
typedef struct fig_falling {
    int axes, vertices;
    double position[3 * FIG_FALLING_MOST], velocity[3 * FIG_FALLING_MOST];
    double inverse_mass[FIG_FALLING_MOST]; ///< 0: stays
    int edge[2 * FIG_FALLING_MOST], edges;
    int triangle[3 * FIG_FALLING_MOST], triangles;
    double step;                 ///< seconds
    tf_response_options options; ///< with a separation, if any
    bool hops; ///< pushes are a quarter of what is missing to the separation,
               ///< and become velocities
    tf_surface *surface;
    tf_resolver *resolver;
} fig_falling;

#define FIG_GRAVITY 9.81 ///< along the last axis, m/s^2

/// Add a vertex of mass 1, or one that stays, and return its number.
int fig_falling_vertex(fig_falling *falling, const double at[], bool stays);

void fig_falling_begin(fig_falling *falling);
void fig_falling_step(fig_falling *falling);
void fig_falling_finish(fig_falling *falling);

#endif
