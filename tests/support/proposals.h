// Surfaces free of tangles with proposals of where their vertices should go,
// most of which are absurd.
#ifndef SUPPORT_PROPOSALS_H
#define SUPPORT_PROPOSALS_H

#include "support/generator.h"
#include "surface/mesh.h"

enum {
    PROPOSAL_VERTICES = 300,
    PROPOSAL_TRIANGLES = 600,
    PROPOSAL_EDGES = 300
};

/// What starts.  The edges are about 1 long, but for a factor.
typedef enum proposal_shape {
    LONE_TRIANGLE,  ///< in space, or in the plane as a curve
    SHEETS,         ///< open, one above the other
    BALLS,          ///< closed, one in another
    LOOPS,          ///< closed curves in the plane, one in another
    CHAINS,         ///< open curves in the plane, side by side
    RODS_AND_SPECKS ///< edges of no triangle, and particles above a sheet
} proposal_shape;

enum {
    PROPOSAL_SHAPES = RODS_AND_SPECKS + 1
};

/// What is proposed.
typedef enum proposal_way {
    SCATTERED,   ///< each vertex by up to several edge lengths, any way
    SPIKED,      ///< a few vertices by 100 edge lengths
    TO_A_POINT,  ///< all of it
    INSIDE_OUT,  ///< to the other side of the middle
    FLATTENED,   ///< to a plane, or line, through the middle
    TURNED_OVER, ///< to the other side of such a plane or line
    SHUFFLED,    ///< each vertex to where another is
    ROTATED,     ///< about the middle
    CARRIED,     ///< far away
    RESTING      ///< nowhere
} proposal_way;

enum {
    PROPOSAL_WAYS = RESTING + 1
};

extern const char *const proposal_shapes[PROPOSAL_SHAPES];
extern const char *const proposal_ways[PROPOSAL_WAYS];

/// How many proposals a test tries: one of each shape in each way, or with a
/// TF_TEST_PERCENT below 100 one in each way, of all shapes in turn.
int proposal_tries(void);

/// The i-th of these: its shape times PROPOSAL_WAYS, plus its way.
int proposal_number(int i);

/// The arrays are the mesh's.
typedef struct proposal {
    tf_mesh mesh;
    int triangle[3 * PROPOSAL_TRIANGLES], edge[2 * PROPOSAL_EDGES];
    double start[3 * PROPOSAL_VERTICES], end[3 * PROPOSAL_VERTICES];
    double inverse_mass[PROPOSAL_VERTICES];
    double unit; ///< the factor
} proposal;

/// Without vertices.
void proposal_begin(proposal *made, int axes);

/// Adds a vertex of inverse mass 1 that rests; returns its index.
int proposal_add_vertex(proposal *made, double x, double y, double z);

void proposal_add_edge(proposal *made, int a, int b);
void proposal_add_triangle(proposal *made, int a, int b, int c);

/// Adds n x n squares, level; returns the first vertex.
int proposal_add_sheet(proposal *made, int n, double height);

/// Fills it.  Vertices are in a random order; the start is free of tangles, but
/// perhaps for rounding.  All inverse masses are 1.
/// @param size how fine, from 1; the largest that fits is 4
void proposal_make(generator *random, proposal_shape shape, int size,
                   proposal_way way, proposal *made);

/// Some inverse masses random, some 0; sometimes all on one side are.
void proposal_weigh(generator *random, proposal *made);

#endif
