// Scenes of embedded surfaces to operate on: small, and with things close to
// each other, one inside another, linked, or on a lattice.
#ifndef SUPPORT_ADAPTIVE_SCENES_H
#define SUPPORT_ADAPTIVE_SCENES_H

#include "support/generator.h"
#include "surgery/adaptive.h"

enum {
    SCENE_PARTS = 32,
    PLACED_VERTICES = 1000,
    PLACED_TRIANGLES = 2000
};

typedef enum adaptive_scene_kind {
    NESTED_SPHERES, ///< with a gap of 0.02, 1e-4 or 1e-9
    DUST,           ///< tetrahedra inside and around a sphere
    SLABS,          ///< boxes stacked on an integer lattice
    LINKED_TORI,    ///< two of them
    SHEETS,         ///< with boundary, stacked on an integer lattice
    FACING_BOXES ///< which may merge, one of them sometimes around the others,
                 ///< with tetrahedra between
} adaptive_scene_kind;

enum {
    ADAPTIVE_SCENES = SHEETS + 1, ///< those where parts do not merge
    MERGING_SCENES = FACING_BOXES + 1
};

typedef struct adaptive_scene {
    adaptive_scene_kind kind;
    double unit; ///< the length of a usual edge
    int vertices, triangles, parts;
    double position[3 * PLACED_VERTICES];
    int triangle[3 * PLACED_TRIANGLES];
    int part[PLACED_VERTICES]; ///< of each vertex
} adaptive_scene;

/// Makes a scene.
void adaptive_scene_make(generator *random, adaptive_scene_kind kind,
                         adaptive_scene *made);

/// The mesh of a scene, which it lends.
tf_mesh adaptive_scene_mesh(const adaptive_scene *scene);

/// Adds to a scene, as one part more: a tetrahedron, turned outwards.
void add_tetrahedron(adaptive_scene *to, const double corner[4][3]);

/// Adds a box with its faces divided into unit squares, as another part.
void add_box(adaptive_scene *to, const int low[3], const int high[3]);

/// Turns the last part of a scene inwards.
void turn_part_over(adaptive_scene *scene);

/// Adds a flat sheet of squares on a lattice, as another part.
void add_sheet(adaptive_scene *to, int x, int y, int z, int columns, int rows);

/// Adds a sphere of 32 triangles around the origin, as another part.
void add_sphere(adaptive_scene *to, double radius);

#endif
