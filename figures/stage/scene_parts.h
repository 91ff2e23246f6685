// What a scene is made of, for the meshes and for the placing of labels.
#ifndef TF_STAGE_SCENE_PARTS_H
#define TF_STAGE_SCENE_PARTS_H

#include "stage/scene.h"

typedef struct tf_ball {
    double at[3];
    double diameter; ///< points
    tf_paint paint;
} tf_ball;

typedef struct tf_tube {
    double from[3], to[3];
    double width; ///< points
    double head;  ///< where along the tube an arrow head's tip is, 0..1; 0:
                  ///< no head
    double dash;  ///< points; 0: not dashed
    tf_paint paint;
} tf_tube;

typedef struct tf_face {
    double corner[3][3];
    double normal[3][3]; ///< at the corners, of length 1
    tf_paint paint;
} tf_face;

struct tf_scene {
    tf_ball *balls;
    tf_tube *tubes;
    tf_face *faces;
    double (*reached)[3]; ///< points to which the camera is fitted
    int ball_count, tube_count, face_count, reached_count;
    int ball_room, tube_room, face_room, reached_room;
    bool out_of_memory;
};

void tf_scene_add_face(tf_scene *scene, const tf_face *face);

/// The paint of creases on a sheet.
tf_paint tf_crease_paint(tf_paint sheet);

/// Free what a scene holds, not the scene.
void tf_scene_clear(tf_scene *scene);

#endif
