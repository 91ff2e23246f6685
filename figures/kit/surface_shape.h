// A surface as it is drawn: in a box, and with what lies beside what.
#ifndef FIG_SURFACE_SHAPE_H
#define FIG_SURFACE_SHAPE_H

#include "kit/fit.h"
#include "query/motion.h"
#include "surface/surface.h"

#include <stdbool.h>

/// The axis that points up in a picture.
typedef enum fig_up {
    FIG_UP_X = 0,
    FIG_UP_Y,
    FIG_UP_Z,
} fig_up;

/// The place of a vertex, with the axes turned so that the third one is up; in
/// the plane, as it is.
tf_vector fig_turned(int axes, fig_up up, const double x[]);

/// How vertices, edges and triangles move in mid-step.
typedef enum fig_motion {
    FIG_BENT = 0, ///< as the library has them: one vertex after another, so
                  ///< that edges and triangles bend
    FIG_STRAIGHT, ///< between the places of their vertices
} fig_motion;

typedef struct fig_shape {
    int axes, vertices, triangles, edges;
    const int *triangle; ///< three vertices each, in increasing order; borrowed
    const int *edge;     ///< two each, in increasing order; borrowed
    fig_fit fit;
    tf_vector *at[2]; ///< of the vertices at the start and at the end, in the
                      ///< box, up along the third axis
    int *side;        ///< of each triangle: the edges from its first vertex to
                      ///< its second, to its third, and between these two
    int (*beside)[2]; ///< of each edge: two of its triangles, -1 for none
    unsigned char *degree; ///< of each edge: how many triangles it has; 3 and
                           ///< more are 3
    int *part; ///< of each vertex: which connected part it is of, by their
               ///< lowest vertices, or -1: it is of no element
    int parts;
    double edge_length; ///< of an edge on the average, in the box
} fig_shape;

/// Make the shape of a surface, which it borrows from.  False if there is no
/// memory; the shape is to be freed in any case.
bool fig_shape_make(fig_shape *shape, const tf_surface *surface, int axes,
                    const tf_motion *motion, fig_up up);
void fig_shape_free(fig_shape *shape);

/// The index of the edge or the triangle that has these vertices, which must be
/// there, in increasing order.
int fig_shape_edge(const fig_shape *shape, const int vertex[2]);
int fig_shape_triangle(const fig_shape *shape, const int vertex[3]);

/// 1 or -1, by which the normal of the second triangle of an edge, which has
/// two, has to be multiplied for it to be to the same side as that of the first.
/// The normal of a triangle is to the side from which its vertices, in
/// increasing order, go counterclockwise.
double fig_shape_sense(const fig_shape *shape, int edge);

/// Where a vertex is at the time t, 0 to 1.
tf_vector fig_shape_place(const fig_shape *shape, int vertex, double t);

/// Where the point of an element is at the time t that has these weights of its
/// vertices, of which there are up to 3, in increasing order.
tf_vector fig_shape_point(const fig_shape *shape, int vertices,
                          const int vertex[], const double weight[],
                          fig_motion motion, double t);

enum {
    FIG_BENT_PIECES = 4
};

/// An edge at the time t as a polyline: how many points it has, 2 or 3.
int fig_shape_line(const fig_shape *shape, int edge, fig_motion motion,
                   double t, tf_vector line[3]);

/// A triangle at the time t as flat ones: how many, up to FIG_BENT_PIECES.
int fig_shape_pieces(const fig_shape *shape, int triangle, fig_motion motion,
                     double t, tf_vector piece[FIG_BENT_PIECES][3]);

/// Whether elements bend at the time t.
bool fig_motion_bends(fig_motion motion, double t);

#endif
