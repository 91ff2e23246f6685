#include "kit/patches.h"

void fig_patch_triangles(fig_scene *scene, const tf_vector at[], int count,
                         const int triangle[][3], fig_paint paint)
{
    for (int i = 0; i < count; i++) {
        tf_vector corner[3];
        for (int j = 0; j < 3; j++)
            corner[j] = at[triangle[i][j]];
        fig_scene_triangle(scene, corner, FIG_WIDTH_LINE, paint);
    }
}

void fig_patch_outline(fig_scene *scene, const tf_vector at[], int count,
                       const int corner[], fig_paint paint)
{
    for (int i = 0; i < count; i++)
        fig_scene_tube(scene, at[corner[i]], at[corner[(i + 1) % count]],
                       FIG_WIDTH_TUBE, paint);
}

void fig_patch_body(fig_scene *scene, const tf_vector at[], const int corner[4],
                    fig_paint paint)
{
    tf_vector place[4];
    for (int i = 0; i < 4; i++)
        place[i] = at[corner[i]];
    fig_scene_tetrahedron(scene, place, FIG_WIDTH_HAIR, paint);
}

void fig_patch_swept(fig_scene *scene, const tf_vector at[],
                     const int corner[4])
{
    fig_patch_body(scene, at, corner,
                   (fig_paint){.role = FIG_ROLE_EDGE, .opacity = 0.13});
}
