// What a scene is made of, for the meshes and for the placing of labels.
#ifndef FIG_RENDERER_SCENE_PARTS_H
#define FIG_RENDERER_SCENE_PARTS_H

#include "renderer/scene.h"

typedef struct fig_ball {
    tf_vector at;
    double diameter; ///< points
    fig_paint paint;
} fig_ball;

typedef struct fig_tube {
    tf_vector from, to;
    double width; ///< points
    double head;  ///< where along the tube an arrow head's tip is, 0..1; 0:
                  ///< no head
    double dash;  ///< points; 0: not dashed
    fig_paint paint;
} fig_tube;

typedef struct fig_face {
    tf_vector corner[3];
    tf_vector normal[3]; ///< at the corners, of length 1
    fig_paint paint;
} fig_face;

struct fig_scene {
    fig_ball *balls;
    fig_tube *tubes;
    fig_face *faces;
    fig_facet *facets;
    fig_painted *painted;
    tf_vector *reached; ///< points to which the camera is fitted
    int ball_count, tube_count, face_count, facet_count, painted_count;
    int ball_room, tube_room, face_room, facet_room, painted_room;
    int reached_count, reached_room;
    bool out_of_memory;
};

void fig_scene_add_face(fig_scene *scene, const fig_face *face);

/// The paint of creases on a sheet.
fig_paint fig_crease_paint(fig_paint sheet);

/// Free what a scene holds, not the scene.
void fig_scene_clear(fig_scene *scene);

#endif
