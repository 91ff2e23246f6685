//: Declare the bodies of a simulation
#pragma once

#include "surface/mesh.h"

#include <stdbool.h>

/// What resists when it is stretched or bent: a weighted sum of positions with a
/// target length.
///
/// With the weights 1 and -1 the sum points from one end of a spring to the
/// other.  Other weights, whose sum is 0, too, make it a curvature, whose target
/// is that of a flat sheet, 0.  The energy is stiffness / 2 times the square of
/// the distance from the sum to the nearest vector of the target length.
typedef struct tf_elastic {
    int count;        ///< how many vertices: 2 to 4
    int vertex[4];    ///< which
    double weight[4]; ///< of each, 1 or without a dimension
    double rest;      ///< the target length, in meters
    double stiffness; ///< in newtons per meter
} tf_elastic;

/// Everything that is simulated: cloth, ropes, chains, and what they meet.
typedef struct tf_body {
    int axes;         ///< 3, or 2 in the plane; to be set first
    int vertices;     ///< how many
    double *position; ///< at the start, `axes` coordinates each, in meters
    double *mass;     ///< in kilograms; 0: the vertex is scripted
    int triangles;    ///< how many
    int *triangle;    ///< three indices each
    int edges;        ///< how many edges besides those of the triangles
    int *edge;        ///< two indices each
    int elastics;     ///< how many
    tf_elastic *elastic;
    int up; ///< from the last axis on to the one that points up: 0, or in space
            ///< 1 for the first axis, 2 for the second
    bool failed; ///< there was not enough memory: what is added is lost
} tf_body;

void tf_body_free(tf_body *body);

/// The axis that points up, from 0.
int tf_body_up(const tf_body *body);

/// The elements, borrowed from the body.
tf_mesh tf_body_mesh(const tf_body *body);

//: Declare how to add to a body
/// Each adds a part; a vertex has the index that `vertices` was before.
void tf_body_add_vertex(tf_body *body, const double x[]);
void tf_body_add_triangle(tf_body *body, int a, int b, int c);
void tf_body_add_edge(tf_body *body, int a, int b);

void tf_body_add_elastic(tf_body *body, const tf_elastic *elastic);

/// Adds a spring of that stiffness, as long as it is now.
void tf_body_add_spring(tf_body *body, int a, int b, double stiffness);

//: Declare what can be measured on a body
/// The weighted sum of an element.
/// @param[out] sum `axes` coordinates
void tf_elastic_sum(const tf_elastic *elastic, int axes,
                    const double position[], double sum[3]);

/// The energy of all elements in those positions, in joules.
double tf_body_elastic_energy(const tf_body *body, const double position[]);

/// That and the energy of the weight of all vertices, which is 0 at height 0.
/// @param gravity downwards, in meters per square second
double tf_body_potential_energy(const tf_body *body, double gravity,
                                const double position[]);

/// The largest ratio of a spring's length to its rest, but at least 1.
double tf_body_stretch(const tf_body *body, const double position[]);

/// The energy of those velocities, in joules; that of scripted vertices is 0.
double tf_body_kinetic_energy(const tf_body *body, const double velocity[]);
