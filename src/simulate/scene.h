//: Declare scenes
#pragma once

#include "geometry/vector.h"
#include "simulate/air.h"
#include "simulate/body.h"
#include "simulate/cloth.h"
#include "simulate/script.h"
#include "surface/pair_filter.h"

enum {
    TF_MOST_SCRIPTS = 2
};

/// Moves vertices that are scripted, but of no script.
typedef struct tf_path {
    /// Writes where they are at a time; false: that cannot be found.
    /// NULL: there are none.
    bool (*place)(void *context, double time, double position[]);
    void *context; ///< passed on to `place`
} tf_path;

/// What a scene begins with.
typedef struct tf_scene_setup {
    const struct tf_scene *scene; ///< to be set first
    tf_body body;
    tf_path path;
    tf_pair_filter filter;  ///< of the body's pairs; all zero: there is none
    const double *friction; ///< of each vertex; NULL: that of the scene
    int scripts;
    tf_script script[TF_MOST_SCRIPTS];
} tf_scene_setup;

/// Lets a script move its vertices, from now on scripted.
void tf_scene_setup_add_script(tf_scene_setup *setup, tf_script script);

//: Declare what scenes are
/// The velocity of a surface at a point where it has that normal, of length 1.
typedef tf_vector tf_velocity_field(double time, tf_vector at,
                                    tf_vector normal);

/// How fine a scene is: for cloth a whole number, of cells along a side for
/// instance; for a surface that flows the usual length of an edge.
typedef struct tf_resolution {
    double usual, least, most;
    const char *counts; ///< of what it is the number; NULL: it is a length
} tf_resolution;

/// A scene that can be simulated.
typedef struct tf_scene {
    const struct tf_simulation_kind *kind;
    const char *name;
    const char *shows; ///< what happens in it, in a line
    tf_resolution resolution;
    int steps;          ///< how many there usually are
    bool plane;         ///< whether it has two axes instead of three
    bool keep_topology; ///< whether it neither merges nor comes apart
    double step;        ///< how long one takes, in seconds

    /// Adds what there is at the start to an empty setup; without memory, its
    /// body has failed.
    void (*build)(tf_scene_setup *setup, double resolution);

    double gravity; ///< on cloth, in meters per square second
    tf_air air;
    double friction;      ///< Coulomb's coefficient
    tf_material material; ///< of cloth; of a chain per meter, not square meter
    void *own;            ///< what else `build` needs, or NULL
    bool filed;           ///< whether it is from a file
    unsigned checksum;    ///< of what a file says about it
    const char *notes;    ///< lines for the headers of its frames; or NULL
    tf_velocity_field *field; ///< along which a surface flows
} tf_scene;

/// The scene of that name in a list that ends with one without a name; NULL if
/// there is none.
const tf_scene *tf_scene_named(const tf_scene list[], const char *name);
