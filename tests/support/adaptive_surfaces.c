#include "support/adaptive_surfaces.h"

#include "support/hash.h"
#include "surgery/adaptive_surface.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    SHEET_VERTICES = 100
};

tf_adaptive_surface *adaptive_of(int vertices, double position[][3],
                                 int triangles, const int triangle[])
{
    tf_mesh mesh = {.axes = 3,
                    .vertices = vertices,
                    .triangles = triangles,
                    .triangle = triangle};
    tf_adaptive_surface *made = NULL;
    if (tf_adaptive_create(&mesh, position[0], &made, NULL) != TF_OK)
        abort();
    return made;
}

tf_adaptive_surface *adaptive_tetrahedron(void)
{
    static const int triangle[] = {0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2};
    static double position[][3] = {
        {1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    return adaptive_of(4, position, 4, triangle);
}

tf_adaptive_surface *adaptive_sheet(int columns, int rows)
{
    static double position[SHEET_VERTICES][3];
    static int triangle[6 * SHEET_VERTICES];
    int across = columns + 1, count = 0;
    if (across * (rows + 1) > SHEET_VERTICES)
        abort();
    for (int v = 0; v < across * (rows + 1); v++) {
        position[v][0] = v % across;
        position[v][1] = v / across;
    }
    for (int j = 0; j < rows; j++)
        for (int i = 0; i < columns; i++) {
            int v = j * across + i;
            const int square[] = {v, v + 1,          v + across + 1,
                                  v, v + across + 1, v + across};
            for (int k = 0; k < 6; k++)
                triangle[count++] = square[k];
        }
    return adaptive_of(across * (rows + 1), position, 2 * columns * rows,
                       triangle);
}

const double *coordinates_of(const tf_adaptive_surface *surface, int vertex)
{
    return tf_adaptive_positions(surface) + 3 * vertex;
}

int triangles_of(const tf_adaptive_surface *surface)
{
    tf_mesh mesh = *tf_adaptive_mesh(surface);
    int count = 0;
    for (int t = 0; t < mesh.triangles; t++)
        count += mesh.triangle[3 * t] >= 0;
    return count;
}

uint64_t adaptive_hash(const tf_adaptive_surface *s)
{
    size_t vertices = (size_t)s->vertices, triangles = (size_t)s->triangles;
    const int counts[] = {s->vertices, s->triangles, s->free_triangle,
                          s->tree.branches, s->tree.free_branch};
    uint64_t hash = hash_bytes(HASH_OF_NOTHING, counts, sizeof counts);
    hash = hash_bytes(hash, s->position.data, 24 * vertices);
    hash = hash_bytes(hash, s->vertex.data, 12 * triangles);
    hash = hash_bytes(hash, s->first.data, 4 * vertices);
    return hash_bytes(hash, s->next.data, 12 * triangles);
}

int has_triangle(const tf_adaptive_surface *surface, int a, int b, int c)
{
    tf_mesh mesh = *tf_adaptive_mesh(surface);
    for (int i = 0; i < 3 * mesh.triangles; i++) {
        const int *t = mesh.triangle + i / 3 * 3;
        if (t[i % 3] == a && t[(i + 1) % 3] == b && t[(i + 2) % 3] == c)
            return 1;
    }
    return 0;
}

void adaptive_freeze(tf_adaptive_surface *surface, int vertex)
{
    size_t vertices = (size_t)surface->vertices;
    if (surface->marked == 0) {
        if (!tf_buffer_extend(&surface->frozen, vertices, sizeof(bool)))
            abort();
        memset(surface->frozen.data, false, vertices * sizeof(bool));
        surface->marked = surface->vertices;
    }
    ((bool *)surface->frozen.data)[vertex] = true;
}

tf_adaptive_surface *adaptive_prism(int sides)
{
    static double x[2 * 64][3];
    static int triangle[3 * 4 * 64];
    int count = 0;
    for (int i = 0; i < sides; i++)
        for (int k = 0; k < 2; k++) {
            double angle = 2 * acos(-1) * i / sides;
            double *at = x[i + k * sides];
            at[0] = cos(angle);
            at[1] = sin(angle);
            at[2] = k;
        }
    for (int i = 0; i < sides; i++) {
        int next = (i + 1) % sides;
        const int wall[] = {i, next, next + sides, i, next + sides, i + sides};
        memcpy(triangle + 3 * count, wall, sizeof wall);
        count += 2;
    }
    for (int i = 1; i + 1 < sides; i++) {
        const int caps[] = {0, i + 1, i, sides, sides + i, sides + i + 1};
        memcpy(triangle + 3 * count, caps, sizeof caps);
        count += 2;
    }
    return adaptive_of(2 * sides, x, count, triangle);
}
