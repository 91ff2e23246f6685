// How often closed things go around each other at one time, exactly: signed
// crossings are counted, in integers of any length.  Nothing here moves, and no
// code of the library is used.
#ifndef SUPPORT_WINDING_H
#define SUPPORT_WINDING_H

/// Elements of `size` vertices each, in an orientation; all together closed:
/// each vertex of edges, each edge of triangles as often in one direction as in
/// the other.
typedef struct cycle {
    int count, size;
    const int *vertices; ///< count * size indices
} cycle;

/// How often edges of the plane or triangles of space go around a point that is
/// not on them: 0 outside.  `place` holds `axes` coordinates a vertex.
int winding_number(int axes, const double place[], const cycle *around,
                   int point);

/// How often two loops of edges in space, that do not meet, are linked.
int linking_number(const double place[], const cycle *first,
                   const cycle *second);

#endif
