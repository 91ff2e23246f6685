#include "renderer/scene.h"

#include "base/require.h"
#include "renderer/list.h"
#include "renderer/scene_parts.h"

#include <stdlib.h>

/// How much darker than a sheet its creases are.
static const double crease_shade = 0.25;

void fig_scene_clear(fig_scene *scene)
{
    free(scene->balls);
    free(scene->tubes);
    free(scene->faces);
    free(scene->facets);
    free(scene->painted);
    free(scene->reached);
}

void fig_scene_fail(fig_scene *scene)
{
    scene->out_of_memory = true;
}

void fig_scene_reach(fig_scene *scene, tf_vector at)
{
    if (!fig_list_room(&scene->reached, scene->reached_count, 1,
                       &scene->reached_room, sizeof *scene->reached)) {
        scene->out_of_memory = true;
        return;
    }
    TF_REQUIRE(isfinite(at.x[0]) && isfinite(at.x[1]) && isfinite(at.x[2]));
    scene->reached[scene->reached_count++] = at;
}

void fig_scene_ball(fig_scene *scene, tf_vector at, double diameter,
                    fig_paint paint)
{
    fig_scene_reach(scene, at);
    if (!fig_list_room(&scene->balls, scene->ball_count, 1, &scene->ball_room,
                       sizeof *scene->balls)) {
        scene->out_of_memory = true;
        return;
    }
    scene->balls[scene->ball_count++] = (fig_ball){at, diameter, paint};
}

static void add_tube(fig_scene *scene, fig_tube tube)
{
    fig_scene_reach(scene, tube.from);
    fig_scene_reach(scene, tube.to);
    if (!fig_list_room(&scene->tubes, scene->tube_count, 1, &scene->tube_room,
                       sizeof *scene->tubes)) {
        scene->out_of_memory = true;
        return;
    }
    scene->tubes[scene->tube_count++] = tube;
}

void fig_scene_tube(fig_scene *scene, tf_vector from, tf_vector to,
                    double width, fig_paint paint)
{
    add_tube(scene, (fig_tube){from, to, .width = width, .paint = paint});
}

void fig_scene_arrow(fig_scene *scene, tf_vector from, tf_vector to,
                     double width, fig_paint paint)
{
    add_tube(scene,
             (fig_tube){from, to, .width = width, .head = 1, .paint = paint});
}

void fig_scene_worldline(fig_scene *scene, tf_vector from, tf_vector to,
                         double width, fig_paint paint)
{
    add_tube(scene, (fig_tube){from, to, .width = width, .head = 0.56,
                               .paint = paint});
}

void fig_scene_dashes(fig_scene *scene, tf_vector from, tf_vector to,
                      double width, double dash, fig_paint paint)
{
    add_tube(scene, (fig_tube){from, to, .width = width, .dash = dash,
                               .paint = paint});
}

void fig_scene_path(fig_scene *scene, int count, const tf_vector at[],
                    double width, fig_paint paint)
{
    for (int i = 0; i + 1 < count; i++)
        fig_scene_tube(scene, at[i], at[i + 1], width, paint);
}

void fig_scene_add_face(fig_scene *scene, const fig_face *face)
{
    for (int i = 0; i < 3; i++)
        fig_scene_reach(scene, face->corner[i]);
    if (!fig_list_room(&scene->faces, scene->face_count, 1, &scene->face_room,
                       sizeof *scene->faces)) {
        scene->out_of_memory = true;
        return;
    }
    scene->faces[scene->face_count++] = *face;
}

/// A flat face; nothing if its corners lie on a line.
static void add_flat(fig_scene *scene, tf_vector a, tf_vector b, tf_vector c,
                     fig_paint paint)
{
    tf_vector across = fig_cross(fig_difference(b, a), fig_difference(c, a));
    if (fig_length(across) == 0)
        return;
    tf_vector normal = fig_normalized(across);
    fig_scene_add_face(scene, &(fig_face){.corner = {a, b, c},
                                          .normal = {normal, normal, normal},
                                          .paint = paint});
}

fig_paint fig_crease_paint(fig_paint sheet)
{
    return (fig_paint){sheet.role, 1, fmax(sheet.shade, 0) + crease_shade};
}

void fig_scene_triangle(fig_scene *scene, const tf_vector corner[3],
                        double crease, fig_paint paint)
{
    add_flat(scene, corner[0], corner[1], corner[2], paint);
    for (int i = 0; i < 3 && crease > 0; i++)
        fig_scene_tube(scene, corner[i], corner[(i + 1) % 3], crease,
                       fig_crease_paint(paint));
}

fig_facet *fig_scene_facets(fig_scene *scene, int count)
{
    if (!fig_list_more(&scene->facets, scene->facet_count, count,
                       &scene->facet_room, sizeof *scene->facets)) {
        scene->out_of_memory = true;
        return NULL;
    }
    scene->facet_count += count;
    return &scene->facets[scene->facet_count - count];
}

fig_painted *fig_scene_painted(fig_scene *scene, int count)
{
    if (!fig_list_more(&scene->painted, scene->painted_count, count,
                       &scene->painted_room, sizeof *scene->painted)) {
        scene->out_of_memory = true;
        return NULL;
    }
    scene->painted_count += count;
    return &scene->painted[scene->painted_count - count];
}

void fig_scene_tetrahedron(fig_scene *scene, const tf_vector corner[4],
                           double crease, fig_paint paint)
{
    for (int i = 0; i < 4; i++)
        add_flat(scene, corner[(i + 1) % 4], corner[(i + 2) % 4],
                 corner[(i + 3) % 4], paint);
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < i && crease > 0; j++)
            fig_scene_tube(scene, corner[i], corner[j], crease,
                           fig_crease_paint(paint));
}
