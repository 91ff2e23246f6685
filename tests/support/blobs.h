// Round closed surfaces of even triangles, and what they look like from afar.
#ifndef SUPPORT_BLOBS_H
#define SUPPORT_BLOBS_H

#include "surgery/adaptive.h"

enum {
    BLOB_VERTICES = 4000
};

/// Parts of a surface that are being put together.
typedef struct blobs {
    int vertices, triangles;
    double position[BLOB_VERTICES][3];
    int triangle[6 * BLOB_VERTICES];
} blobs;

/// Adds a ball: an octahedron, each edge of which is divided into so many; its
/// directions are turned.
void add_ball(blobs *to, const double middle[3], double radius, int divisions);

/// Adds what turns around the axis 2: so many rings of `around` vertices, the
/// i-th of radius[i] at the height[i]; closed with a vertex at either end.
void add_turned(blobs *to, int around, int rings, const double radius[],
                const double height[]);

/// Adds a ring around the axis 2 through `at`, of `around` times `across`
/// vertices.
void add_ring(blobs *to, const double at[3], double radius, double thickness,
              int around, int across);

/// The surface.
tf_adaptive_surface *blobs_surface(const blobs *parts);

/// How many parts a surface has.
int parts_of(const tf_adaptive_surface *surface);

/// Vertices less edges plus triangles: 2 for each ball, 0 for each ring.
int euler_of(const tf_adaptive_surface *surface);

/// The volume of a closed surface, rounded.
double volume_of(const tf_adaptive_surface *surface);

/// Whether a surface is free of intersections and collinear triangles, as far
/// as making a new one of it shows.
int is_sound(const tf_adaptive_surface *surface);

#endif
