#include "support/damage.h"

#include "support/surgery_runs.h"

#include <string.h>

static int corner_of_scene(generator *random, const adaptive_scene *scene)
{
    return scene->triangle[below(random, 3 * scene->triangles)];
}

static void add_triangle(adaptive_scene *scene, int a, int b, int c)
{
    int *v = scene->triangle + 3 * scene->triangles;
    if (a == b || b == c || c == a || scene->triangles == PLACED_TRIANGLES)
        return;
    memcpy(v, (int[]){a, b, c}, 3 * sizeof *v);
    scene->triangles++;
}

/// Divides a triangle on one side only: at the middle of an edge, up to
/// rounding.
static void divide_one_side(generator *random, adaptive_scene *scene)
{
    int *v = scene->triangle + 3 * below(random, scene->triangles);
    int a = v[0], b = v[1], c = v[2], middle = scene->vertices;
    if (middle == PLACED_VERTICES)
        return;
    for (int k = 0; k < 3; k++)
        scene->position[3 * middle + k] =
            (scene->position[3 * a + k] + scene->position[3 * b + k]) / 2;
    scene->vertices++;
    v[1] = middle;
    add_triangle(scene, middle, b, c);
    add_triangle(scene, a, b, middle);
}

/// Makes two vertices that have no neighbor in common one.
static void weld_two(generator *random, adaptive_scene *scene)
{
    int from = corner_of_scene(random, scene),
        to = corner_of_scene(random, scene);
    for (int t = 0; t < scene->triangles; t++) {
        int has = 0;
        for (int i = 0; i < 3; i++)
            has += scene->triangle[3 * t + i] == from ||
                   scene->triangle[3 * t + i] == to;
        if (has > 1)
            return;
    }
    for (int c = 0; c < 3 * scene->triangles; c++)
        if (scene->triangle[c] == from)
            scene->triangle[c] = to;
}

void damage(generator *random, adaptive_scene *scene)
{
    int *v = scene->triangle + 3 * below(random, scene->triangles);
    int a = corner_of_scene(random, scene), b = corner_of_scene(random, scene);
    switch (below(random, 6)) {
    case 0: // another triangle on an edge
        add_triangle(scene, v[1], v[0], a);
        break;
    case 1: // a vertex of one triangle onto another vertex
        memcpy(scene->position + 3 * a, scene->position + 3 * b,
               3 * sizeof(double));
        break;
    case 2: // a triangle twice
        add_triangle(scene, v[0], v[1], v[2]);
        break;
    case 3:
        divide_one_side(random, scene);
        break;
    case 4:
        weld_two(random, scene);
        break;
    default: { // a triangle turned over
        int first = v[0];
        v[0] = v[1];
        v[1] = first;
    }
    }
}

int tangles_of(const tf_adaptive_surface *surface, int most, tangle found[])
{
    static int triangle[3 * LABELLED];
    static bool used[LABELLED];
    tf_mesh mesh = *tf_adaptive_mesh(surface);
    int triangles = 0, count = 0;
    memset(used, 0, sizeof used);
    for (int t = 0; t < mesh.triangles; t++) {
        if (mesh.triangle[3 * t] < 0)
            continue;
        for (int i = 0; i < 3; i++)
            used[triangle[3 * triangles + i] = mesh.triangle[3 * t + i]] = true;
        triangles++;
    }
    mesh.triangles = triangles;
    mesh.triangle = triangle;
    tangle_judge *judge = tangle_judge_new(&mesh);
    int all = tangle_count(judge, tf_adaptive_positions(surface));
    for (int i = 0; i < all; i++)
        if (used[tangles(judge)[i].vertex[0]] && count < most)
            found[count++] = tangles(judge)[i];
    tangle_judge_free(judge);
    return count;
}
