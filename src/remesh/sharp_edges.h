//: Declare sharp edges
#pragma once

#include "geometry/vector.h"
#include "surgery/adaptive_surface.h"

/// The sharp edges of a surface and its corners.  They are found once, in the
/// original, and operations hand them on.
typedef struct tf_sharp_edges {
    tf_buffer first; ///< int of each vertex: its first link, or TF_NONE
    tf_buffer link;  ///< tf_sharp_link each, two for each sharp edge
    tf_buffer held;  ///< bool of each vertex: whether it is a corner
    int vertices, links;
    int sides;  ///< how many numbers of sides there are
    int unused; ///< the first of a list of links, or TF_NONE
} tf_sharp_edges;

/// From a vertex to the other end of a sharp edge.
typedef struct tf_sharp_link {
    int to, next;  ///< `next` is another link of the vertex, or TF_NONE
    double length; ///< of the original's edges that this one stands for
    int side; ///< the number of the left side, in this direction, of the line
              ///< of the original's sharp edges that it is a part of: such a
              ///< line ends at corners alone
} tf_sharp_link;

//: Declare how sharp edges are found
/// Which edges are sharp besides the boundary.
typedef struct tf_sharpness {
    double cosine; ///< those at which the angle between the normals of their
                   ///< triangles has a lower cosine than this
    double depth;  ///< those that a triangle across would cut off by more than
                   ///< this, a measured length
    int keeps;     ///< and so many that are given
    const int *keep; ///< by two vertices each; twice the same: that is a corner
} tf_sharpness;

/// The boundary alone is sharp.
extern const tf_sharpness tf_sharp_boundary;

/// Finds the sharp edges of a surface.  A vertex of sharp edges is a corner
/// unless there are two that go on nearly straight.  Returns TF_OK,
/// TF_OUT_OF_MEMORY or TF_CANCELLED; free them in any case.
tf_status tf_sharp_edges_find(tf_sharp_edges *all,
                              const tf_adaptive_surface *surface,
                              const tf_sharpness *sharpness, tf_watch *watch);

/// By how much a surface turns at an edge inside it, given by a corner: the
/// length of the difference of the unit normals of its triangles, about the
/// angle for a small one.
double tf_turn_at(const tf_adaptive_surface *surface, int corner);

/// The mean height of the triangles on such an edge.
double tf_height_at(const tf_adaptive_surface *surface, int corner);

void tf_sharp_edges_free(tf_sharp_edges *all);

//: Declare what sharp edges tell
/// How a vertex may move without changing the shape.
typedef enum tf_freedom {
    TF_HELD = 0,         ///< a corner: not at all
    TF_ALONG_SHARP_EDGE, ///< along two sharp edges that go on nearly straight
    TF_FREE,             ///< it is on no sharp edge
} tf_freedom;

tf_freedom tf_freedom_of(const tf_sharp_edges *all, int vertex);

/// The sharp edges along which a vertex of that freedom may move.
typedef struct tf_sharp_pair {
    const tf_sharp_link *link[2];
} tf_sharp_pair;

tf_sharp_pair tf_sharp_edges_along(const tf_sharp_edges *all, int vertex);

/// The sharp edge between two vertices, or NULL.
const tf_sharp_link *tf_find_sharp_edge(const tf_sharp_edges *all, int a,
                                        int b);

//: Declare how sharp edges are handed on
/// Hands on the sharp edge ab, which has been split at a new vertex.  False if
/// there is no memory.
bool tf_sharp_edges_split(tf_sharp_edges *all, int a, int b, int vertex);

/// Makes room for new vertices, which are on no sharp edge.  False if there is no
/// memory.
bool tf_sharp_edges_extend(tf_sharp_edges *all, int vertices);

/// Makes an edge of the surface sharp, of length `length`, unless it is so
/// already.  False if there is no memory.
bool tf_sharp_edges_add(tf_sharp_edges *all, int a, int b, double length);

/// Hands on the sharp edges of a vertex that has gone to another one.
void tf_sharp_edges_collapse(tf_sharp_edges *all, int from, int to);

/// Divides what two sharp edges stand for anew, in proportion to their lengths:
/// the vertex between them has moved along them.
void tf_sharp_edges_slide(tf_sharp_edges *all,
                          const tf_adaptive_surface *surface, int vertex);

/// Makes sharp edges the same as others.  False if there is no memory.
bool tf_sharp_edges_copy(tf_sharp_edges *all, const tf_sharp_edges *from);

/// Closes gaps: vertex v becomes map[v], or is gone.
void tf_sharp_edges_compact(tf_sharp_edges *all, const int map[]);

//: Declare collapses
/// How an edge collapses: which vertex goes, which stays, and where.
typedef struct tf_edge_collapse {
    int from, to;
    tf_vector position;
} tf_edge_collapse;

/// The freer of two vertices, at a corner and at the next one, goes to the
/// other.  False if it may not: if it is held; if it may only go along a sharp
/// edge, and this one is none; or if a sharp edge would be shorter than the
/// part `least` of the original's edges that it stands for.
bool tf_collapse_freer(const tf_adaptive_surface *surface,
                       const tf_sharp_edges *all, int corner, double least,
                       tf_edge_collapse *collapse);
