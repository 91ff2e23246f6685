//: Declare the patch of a round
#pragma once

#include "surface/contacts.h"
#include "surface/surface_memory.h"
#include "untangle/cells.h"

/// What moves in a round and all that it may meet, as a surface of its own.  In
/// it nothing is missed: what is left out neither moves nor is near.
typedef struct tf_near_patch {
    bool is_used;        ///< else the whole surface is looked at
    tf_surface *surface; ///< NULL: there has been none
    int vertices;
    int *vertex;         ///< of each of its vertices: the number in the whole
                         ///< surface, increasing
    double *start, *end; ///< where its vertices are, and where they go
    tf_cells cells;      ///< what moves stays within them
    tf_buffer marks, elements, places;
} tf_near_patch;

/// What a patch is cut from.
typedef struct tf_near_patch_source {
    tf_surface *surface;
    const tf_neighbors *near;
    double edge; ///< the mean length of edges
} tf_near_patch_source;

/// Looks for a patch of the elements that move, with some room around, and uses
/// it if it is much smaller than the surface, and the surface has no filter.
/// Returns TF_OK or TF_OUT_OF_MEMORY.
tf_status tf_near_patch_find(tf_near_patch *patch,
                             const tf_near_patch_source *source,
                             const double x[], const tf_vector move[]);

void tf_near_patch_free(tf_near_patch *patch);

//: Declare what a patch is asked
/// Gathers where the vertices of a patch are, of all vertices.
void tf_near_patch_gather(const tf_near_patch *patch, const tf_neighbors *near,
                          const double x[], double own[]);

/// Replaces numbers of a patch's vertices by those in the whole surface; those
/// that are negative stay.
void tf_near_patch_name(const tf_near_patch *patch, int count, int vertex[]);

/// Whether all elements that move from x stay where the patch misses nothing.
bool tf_near_patch_covers(const tf_near_patch *patch, const tf_neighbors *near,
                          const double x[], const double to[]);
