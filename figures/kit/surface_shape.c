#include "kit/surface_shape.h"

#include "base/require.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// Places -----------------------------------------------------------------

tf_vector fig_turned(int axes, fig_up up, const double x[])
{
    if (axes == 2)
        return (tf_vector){{x[0], x[1], 0}};
    if (up == FIG_UP_X)
        return (tf_vector){{x[1], x[2], x[0]}};
    if (up == FIG_UP_Y)
        return (tf_vector){{x[2], x[0], x[1]}};
    return fig_vector_of(x);
}

static bool place_vertices(fig_shape *shape, const tf_motion *motion, fig_up up)
{
    size_t count = (size_t)motion->vertices;
    tf_vector *all = malloc((2 * count + 1) * sizeof *all);
    if (!all)
        return false;
    const double *const given[2] = {motion->start, motion->end};
    for (int t = 0; t < 2; t++) {
        shape->at[t] = all + (size_t)t * count;
        for (size_t i = 0; i < count; i++)
            shape->at[t][i] =
                fig_turned(shape->axes, up, given[t] + i * (size_t)shape->axes);
    }
    shape->fit = fig_fit_points_alike(shape->axes, 2 * motion->vertices, all);
    return true;
}

static double mean_length(const fig_shape *shape)
{
    double sum = 0;
    for (int i = 0; i < shape->edges; i++) {
        const int *end = shape->edge + 2 * (size_t)i;
        sum += fig_length(
            fig_difference(shape->at[0][end[1]], shape->at[0][end[0]]));
    }
    return sum / shape->edges;
}

// Neighbors --------------------------------------------------------------

static int compare(int vertices, const int a[], const int b[])
{
    for (int i = 0; i < vertices; i++)
        if (a[i] != b[i])
            return a[i] < b[i] ? -1 : 1;
    return 0;
}

/// The index of an element in a sorted list of elements.
static int find_element(int count, int vertices, const int *list,
                        const int vertex[])
{
    int begin = 0, end = count;
    for (;;) {
        TF_REQUIRE(begin < end);
        int middle = begin + (end - begin) / 2;
        int order =
            compare(vertices, list + (size_t)middle * (size_t)vertices, vertex);
        if (order == 0)
            return middle;
        if (order < 0)
            begin = middle + 1;
        else
            end = middle;
    }
}

int fig_shape_edge(const fig_shape *shape, const int vertex[2])
{
    return find_element(shape->edges, 2, shape->edge, vertex);
}

int fig_shape_triangle(const fig_shape *shape, const int vertex[3])
{
    return find_element(shape->triangles, 3, shape->triangle, vertex);
}

/// Count a triangle at one of its edges.
static void join_side(fig_shape *shape, int triangle, int edge)
{
    if (shape->degree[edge] < 2)
        shape->beside[edge][shape->degree[edge]] = triangle;
    if (shape->degree[edge] < 3)
        shape->degree[edge]++;
}

static bool join_sides(fig_shape *shape)
{
    size_t edges = (size_t)shape->edges;
    shape->side = malloc((3 * (size_t)shape->triangles + 1) * sizeof(int));
    shape->beside = malloc((edges + 1) * sizeof *shape->beside);
    shape->degree = calloc(edges + 1, 1);
    if (!shape->side || !shape->beside || !shape->degree)
        return false;
    for (size_t i = 0; i < edges; i++)
        shape->beside[i][0] = shape->beside[i][1] = -1;
    for (int i = 0; i < shape->triangles; i++) {
        const int *v = shape->triangle + 3 * (size_t)i;
        const int end[3][2] = {{v[0], v[1]}, {v[0], v[2]}, {v[1], v[2]}};
        for (int c = 0; c < 3; c++) {
            int edge = fig_shape_edge(shape, end[c]);
            shape->side[3 * (size_t)i + (size_t)c] = edge;
            join_side(shape, i, edge);
        }
    }
    return true;
}

/// Whether a triangle's boundary, from its first vertex to its second and on,
/// runs along an edge from the lower vertex to the higher one.
static bool runs_up(const fig_shape *shape, int triangle, int edge)
{
    return shape->side[3 * (size_t)triangle + 1] != edge;
}

double fig_shape_sense(const fig_shape *shape, int edge)
{
    const int *beside = shape->beside[edge];
    return runs_up(shape, beside[0], edge) == runs_up(shape, beside[1], edge)
               ? -1
               : 1;
}

// Parts ------------------------------------------------------------------

/// The vertex that stands for the part of a vertex: the lowest so far.
static int root_of(int *parent, int vertex)
{
    while (parent[vertex] != vertex) {
        parent[vertex] = parent[parent[vertex]];
        vertex = parent[vertex];
    }
    return vertex;
}

/// Join the vertices of each edge; those of triangles are among these.
static void join_vertices(const fig_shape *shape, int *parent)
{
    for (int i = 0; i < shape->edges; i++) {
        const int *end = shape->edge + 2 * (size_t)i;
        for (int k = 0; k < 2; k++)
            if (parent[end[k]] < 0)
                parent[end[k]] = end[k];
        int a = root_of(parent, end[0]), b = root_of(parent, end[1]);
        parent[a > b ? a : b] = a > b ? b : a;
    }
}

static bool find_parts(fig_shape *shape)
{
    size_t bytes = ((size_t)shape->vertices + 1) * sizeof(int);
    int *parent = malloc(bytes);
    shape->part = malloc(bytes);
    if (!parent || !shape->part) {
        free(parent);
        return false;
    }
    memset(parent, -1, bytes);
    join_vertices(shape, parent);
    for (int i = 0; i < shape->vertices; i++) {
        int root = parent[i] < 0 ? -1 : root_of(parent, i);
        shape->part[i] = root < 0    ? -1
                         : root == i ? shape->parts++
                                     : shape->part[root];
    }
    free(parent);
    return true;
}

// The shape --------------------------------------------------------------

bool fig_shape_make(fig_shape *shape, const tf_surface *surface, int axes,
                    const tf_motion *motion, fig_up up)
{
    *shape = (fig_shape){.axes = axes, .vertices = motion->vertices};
    shape->triangle = tf_surface_triangles(surface, &shape->triangles);
    shape->edge = tf_surface_edges(surface, &shape->edges);
    if (!place_vertices(shape, motion, up) || !join_sides(shape) ||
        !find_parts(shape))
        return false;
    shape->edge_length = mean_length(shape);
    return true;
}

void fig_shape_free(fig_shape *shape)
{
    free(shape->at[0]);
    free(shape->side);
    free(shape->beside);
    free(shape->degree);
    free(shape->part);
    *shape = (fig_shape){0};
}

// Motion -----------------------------------------------------------------

tf_vector fig_shape_place(const fig_shape *shape, int vertex, double t)
{
    return fig_lerp(shape->at[0][vertex], shape->at[1][vertex], t);
}

tf_vector fig_shape_point(const fig_shape *shape, int vertices,
                          const int vertex[], const double weight[],
                          fig_motion motion, double t)
{
    // When elements bend, the last vertices are at the end of the step, with t
    // of the weight, and the others at its start.
    double left = t;
    tf_vector place = {{0}};
    for (int i = vertices - 1; i >= 0; i--) {
        double late =
            motion == FIG_BENT ? fmin(weight[i], left) : t * weight[i];
        left -= late;
        place =
            fig_combination(place, weight[i] - late, shape->at[0][vertex[i]]);
        place = fig_combination(place, late, shape->at[1][vertex[i]]);
    }
    return place;
}

bool fig_motion_bends(fig_motion motion, double t)
{
    return motion == FIG_BENT && t > 0 && t < 1;
}

/// Where an edge bends: what is before is of its lower vertex, at the start.
static tf_vector bend_of(const fig_shape *shape, int low, int high, double t)
{
    return fig_lerp(shape->at[0][low], shape->at[1][high], t);
}

int fig_shape_line(const fig_shape *shape, int edge, fig_motion motion,
                   double t, tf_vector line[3])
{
    const int *end = shape->edge + 2 * (size_t)edge;
    int count = 0;
    line[count++] = fig_shape_place(shape, end[0], t);
    if (fig_motion_bends(motion, t))
        line[count++] = bend_of(shape, end[0], end[1], t);
    line[count++] = fig_shape_place(shape, end[1], t);
    return count;
}

static void set_piece(tf_vector piece[3], tf_vector a, tf_vector b, tf_vector c)
{
    piece[0] = a;
    piece[1] = b;
    piece[2] = c;
}

int fig_shape_pieces(const fig_shape *shape, int triangle, fig_motion motion,
                     double t, tf_vector piece[FIG_BENT_PIECES][3])
{
    const int *v = shape->triangle + 3 * (size_t)triangle;
    tf_vector a = fig_shape_place(shape, v[0], t);
    tf_vector b = fig_shape_place(shape, v[1], t);
    tf_vector c = fig_shape_place(shape, v[2], t);
    if (!fig_motion_bends(motion, t)) {
        set_piece(piece[0], a, b, c);
        return 1;
    }
    // The slices of the three simplices of the sweep: a triangle at the first
    // vertex, a parallelogram at the second, and a triangle at the third.
    tf_vector ab = bend_of(shape, v[0], v[1], t);
    tf_vector ac = bend_of(shape, v[0], v[2], t);
    tf_vector bc = bend_of(shape, v[1], v[2], t);
    set_piece(piece[0], a, ab, ac);
    set_piece(piece[1], ab, b, bc);
    set_piece(piece[2], ab, bc, ac);
    set_piece(piece[3], ac, bc, c);
    return FIG_BENT_PIECES;
}
