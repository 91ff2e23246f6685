#include "support/blobs.h"

#include "support/adaptive_surfaces.h"
#include "support/surgery_runs.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

static int add_vertex(blobs *to, double x, double y, double z)
{
    const double place[] = {x, y, z};
    if (to->vertices == BLOB_VERTICES)
        abort();
    memcpy(to->position[to->vertices], place, sizeof place);
    return to->vertices++;
}

static void add_triangle(blobs *to, int a, int b, int c)
{
    const int vertex[] = {a, b, c};
    if (to->triangles == 2 * BLOB_VERTICES)
        abort();
    memcpy(to->triangle + 3 * to->triangles++, vertex, sizeof vertex);
}

// Balls -----------------------------------------------------------------------

/// A turn of space, so that nothing is on a line by chance.
static void turn(const double x[3], double turned[3])
{
    double a = 0.3, b = 0.5;
    double y = cos(a) * x[1] - sin(a) * x[2], z = sin(a) * x[1] + cos(a) * x[2];
    turned[0] = cos(b) * x[0] - sin(b) * y;
    turned[1] = sin(b) * x[0] + cos(b) * y;
    turned[2] = z;
}

/// The vertex of this ball in that direction, added if there is none.
static int vertex_towards(blobs *to, int first, const double middle[3],
                          double radius, const double way[3])
{
    double unit[3],
        length = sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
    turn(way, unit);
    double x[3];
    for (int k = 0; k < 3; k++)
        x[k] = middle[k] + radius / length * unit[k];
    for (int v = first; v < to->vertices; v++)
        if (fabs(to->position[v][0] - x[0]) + fabs(to->position[v][1] - x[1]) +
                fabs(to->position[v][2] - x[2]) <
            1e-9 * radius)
            return v;
    return add_vertex(to, x[0], x[1], x[2]);
}

void add_ball(blobs *to, const double middle[3], double radius, int divisions)
{
    int first = to->vertices, n = divisions;
    for (int octant = 0; octant < 8; octant++) {
        double s[3];
        for (int k = 0; k < 3; k++)
            s[k] = octant >> k & 1 ? -1 : 1;
        bool turned = s[0] * s[1] * s[2] < 0;
        for (int i = 0; i < n; i++)
            for (int j = 0; j < 2 * (n - i) - 1; j++) {
                int a = i, b = j / 2, odd = j % 2, v[3];
                const int at[3][2] = {
                    {a + odd, b + odd}, {a + 1, b}, {a, b + 1}};
                for (int k = 0; k < 3; k++) {
                    int p = at[k][0], q = at[k][1];
                    const double way[] = {s[0] * p, s[1] * q,
                                          s[2] * (n - p - q)};
                    v[k] = vertex_towards(to, first, middle, radius, way);
                }
                bool swap = turned != (odd == 1);
                add_triangle(to, v[0], v[swap ? 2 : 1], v[swap ? 1 : 2]);
            }
    }
}

// What turns ------------------------------------------------------------------

static void add_band(blobs *to, int first, int next, int around)
{
    for (int j = 0; j < around; j++) {
        int k = (j + 1) % around;
        add_triangle(to, first + j, first + k, next + k);
        add_triangle(to, first + j, next + k, next + j);
    }
}

void add_turned(blobs *to, int around, int rings, const double radius[],
                const double height[])
{
    double full = 2 * acos(-1);
    int first = to->vertices;
    for (int i = 0; i < rings; i++)
        for (int j = 0; j < around; j++)
            add_vertex(to, radius[i] * cos(full * j / around),
                       radius[i] * sin(full * j / around), height[i]);
    for (int i = 0; i + 1 < rings; i++)
        add_band(to, first + i * around, first + (i + 1) * around, around);
    double step = height[1] - height[0];
    int low = add_vertex(to, 0, 0, height[0] - 0.3 * step);
    int high = add_vertex(to, 0, 0, height[rings - 1] + 0.3 * step);
    for (int j = 0; j < around; j++) {
        int k = (j + 1) % around, last = first + (rings - 1) * around;
        add_triangle(to, low, first + k, first + j);
        add_triangle(to, high, last + j, last + k);
    }
}

void add_ring(blobs *to, const double at[3], double radius, double thickness,
              int around, int across)
{
    double full = 2 * acos(-1);
    int first = to->vertices;
    for (int i = 0; i < around; i++)
        for (int j = 0; j < across; j++) {
            double a = full * i / around, b = full * (j + 0.5) / across;
            double r = radius + thickness * cos(b);
            add_vertex(to, at[0] + r * cos(a), at[1] + r * sin(a),
                       at[2] + thickness * sin(b));
        }
    for (int i = 0; i < around; i++)
        for (int j = 0; j < across; j++) {
            int a = first + i * across + j;
            int b = first + (i + 1) % around * across + j;
            int c = first + (i + 1) % around * across + (j + 1) % across;
            int d = first + i * across + (j + 1) % across;
            add_triangle(to, a, b, c);
            add_triangle(to, a, c, d);
        }
}

tf_adaptive_surface *blobs_surface(const blobs *parts)
{
    return adaptive_of(parts->vertices, (double(*)[3])parts->position[0],
                       parts->triangles, parts->triangle);
}

// From afar -------------------------------------------------------------------

int parts_of(const tf_adaptive_surface *surface)
{
    static int part[LABELLED];
    return label_parts(surface, part);
}

int euler_of(const tf_adaptive_surface *surface)
{
    static int part[LABELLED];
    tf_mesh mesh = *tf_adaptive_mesh(surface);
    int vertices = 0, triangles = triangles_of(surface);
    label_parts(surface, part);
    for (int v = 0; v < mesh.vertices; v++)
        vertices += part[v] >= 0;
    return vertices - triangles / 2;
}

double volume_of(const tf_adaptive_surface *surface)
{
    tf_mesh mesh = *tf_adaptive_mesh(surface);
    double sum = 0;
    for (int t = 0; t < mesh.triangles; t++) {
        const int *v = mesh.triangle + 3 * t;
        if (*v < 0)
            continue;
        const double *a = coordinates_of(surface, v[0]),
                     *b = coordinates_of(surface, v[1]),
                     *c = coordinates_of(surface, v[2]);
        sum += a[0] * (b[1] * c[2] - b[2] * c[1]) +
               a[1] * (b[2] * c[0] - b[0] * c[2]) +
               a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
    return sum / 6;
}

int is_sound(const tf_adaptive_surface *surface)
{
    static int kept[3 * LABELLED];
    tf_mesh mesh = *tf_adaptive_mesh(surface);
    int count = 0;
    for (int t = 0; t < mesh.triangles; t++)
        if (mesh.triangle[3 * t] >= 0)
            memcpy(kept + 3 * count++, mesh.triangle + 3 * t, 3 * sizeof *kept);
    tf_adaptive_surface *again = NULL;
    mesh.triangle = kept;
    mesh.triangles = count;
    tf_status status =
        tf_adaptive_create(&mesh, tf_adaptive_positions(surface), &again, NULL);
    tf_adaptive_free(again);
    return status == TF_OK;
}
