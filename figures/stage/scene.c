#include "stage/scene.h"

#include "contract.h"
#include "stage/list.h"
#include "stage/scene_parts.h"
#include "stage/vector.h"

#include <stdlib.h>

/// How much darker than a sheet its creases are.
static const double crease_shade = 0.25;

void tf_scene_clear(tf_scene *scene)
{
    free(scene->balls);
    free(scene->tubes);
    free(scene->faces);
    free(scene->reached);
}

void tf_scene_reach(tf_scene *scene, const double at[3])
{
    if (!tf_list_room(&scene->reached, scene->reached_count, 1,
                      &scene->reached_room, sizeof *scene->reached)) {
        scene->out_of_memory = true;
        return;
    }
    TF_REQUIRE(isfinite(at[0]) && isfinite(at[1]) && isfinite(at[2]));
    tf_add(at, 0, at, scene->reached[scene->reached_count++]);
}

void tf_scene_ball(tf_scene *scene, const double at[3], double diameter,
                   tf_paint paint)
{
    tf_scene_reach(scene, at);
    if (!tf_list_room(&scene->balls, scene->ball_count, 1, &scene->ball_room,
                      sizeof *scene->balls)) {
        scene->out_of_memory = true;
        return;
    }
    tf_ball *ball = &scene->balls[scene->ball_count++];
    *ball = (tf_ball){.diameter = diameter, .paint = paint};
    tf_add(at, 0, at, ball->at);
}

/// Add a tube with its ends still to be told.
static void add_tube(tf_scene *scene, const double from[3], const double to[3],
                     tf_tube kind)
{
    tf_scene_reach(scene, from);
    tf_scene_reach(scene, to);
    if (!tf_list_room(&scene->tubes, scene->tube_count, 1, &scene->tube_room,
                      sizeof *scene->tubes)) {
        scene->out_of_memory = true;
        return;
    }
    tf_tube *tube = &scene->tubes[scene->tube_count++];
    *tube = kind;
    tf_add(from, 0, from, tube->from);
    tf_add(to, 0, to, tube->to);
}

void tf_scene_tube(tf_scene *scene, const double from[3], const double to[3],
                   double width, tf_paint paint)
{
    add_tube(scene, from, to, (tf_tube){.width = width, .paint = paint});
}

void tf_scene_arrow(tf_scene *scene, const double from[3], const double to[3],
                    double width, tf_paint paint)
{
    add_tube(scene, from, to,
             (tf_tube){.width = width, .head = 1, .paint = paint});
}

void tf_scene_worldline(tf_scene *scene, const double from[3],
                        const double to[3], double width, tf_paint paint)
{
    add_tube(scene, from, to,
             (tf_tube){.width = width, .head = 0.56, .paint = paint});
}

void tf_scene_dashes(tf_scene *scene, const double from[3], const double to[3],
                     double width, double dash, tf_paint paint)
{
    add_tube(scene, from, to,
             (tf_tube){.width = width, .dash = dash, .paint = paint});
}

void tf_scene_path(tf_scene *scene, int count, const double at[][3],
                   double width, tf_paint paint)
{
    for (int i = 0; i + 1 < count; i++)
        tf_scene_tube(scene, at[i], at[i + 1], width, paint);
}

void tf_scene_add_face(tf_scene *scene, const tf_face *face)
{
    for (int i = 0; i < 3; i++)
        tf_scene_reach(scene, face->corner[i]);
    if (!tf_list_room(&scene->faces, scene->face_count, 1, &scene->face_room,
                      sizeof *scene->faces)) {
        scene->out_of_memory = true;
        return;
    }
    scene->faces[scene->face_count++] = *face;
}

/// A flat face; nothing if its corners lie on a line.
static void add_flat(tf_scene *scene, const double a[3], const double b[3],
                     const double c[3], tf_paint paint)
{
    const double *corner[3] = {a, b, c};
    double u[3], v[3], normal[3];
    tf_add(b, -1, a, u);
    tf_add(c, -1, a, v);
    tf_cross(u, v, normal);
    if (tf_normalize(normal) == 0)
        return;
    tf_face face = {.paint = paint};
    for (int i = 0; i < 3; i++) {
        tf_add(corner[i], 0, corner[i], face.corner[i]);
        tf_add(normal, 0, normal, face.normal[i]);
    }
    tf_scene_add_face(scene, &face);
}

tf_paint tf_crease_paint(tf_paint sheet)
{
    return (tf_paint){sheet.role, 1, fmax(sheet.shade, 0) + crease_shade};
}

void tf_scene_triangle(tf_scene *scene, const double corner[3][3],
                       double crease, tf_paint paint)
{
    add_flat(scene, corner[0], corner[1], corner[2], paint);
    for (int i = 0; i < 3 && crease > 0; i++)
        tf_scene_tube(scene, corner[i], corner[(i + 1) % 3], crease,
                      tf_crease_paint(paint));
}

void tf_scene_tetrahedron(tf_scene *scene, const double corner[4][3],
                          double crease, tf_paint paint)
{
    for (int i = 0; i < 4; i++)
        add_flat(scene, corner[(i + 1) % 4], corner[(i + 2) % 4],
                 corner[(i + 3) % 4], paint);
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < i && crease > 0; j++)
            tf_scene_tube(scene, corner[i], corner[j], crease,
                          tf_crease_paint(paint));
}

void tf_scale_about(const double center[3], double scale, const double point[3],
                    double moved[3])
{
    double off[3];
    tf_add(point, -1, center, off);
    tf_add(center, scale, off, moved);
}
