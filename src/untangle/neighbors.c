//: Include what neighbors need
#include "untangle/neighbors.h"

#include "surface/elements.h"

#include <string.h>

//: Count what belongs to each list
/// Makes lists of `count` elements, each of which belongs to the lists of its
/// corners: start[i + 1] counts list i, and then tells where list i begins.
static void start_lists(int lists, int *start, int corners, int count,
                        const int *corner)
{
    memset(start, 0, sizeof *start * ((size_t)lists + 2));
    for (ptrdiff_t i = 0; i < (ptrdiff_t)corners * count; i++)
        start[corner[i] + 2]++;
    for (int i = 0; i <= lists; i++)
        start[i + 1] += start[i];
}

//: List the elements of each vertex
static void list_elements(tf_lists *lists, int vertices, int corners, int count,
                          const int *corner)
{
    start_lists(vertices, lists->start, corners, count, corner);
    for (ptrdiff_t i = 0; i < (ptrdiff_t)corners * count; i++)
        lists->item[lists->start[corner[i] + 1]++] = (int)(i / corners);
}

//: List the neighbors of each vertex
/// The edges are sorted, so the neighbors of a vertex are increasing.
static void list_neighbors(tf_neighbors *all)
{
    list_elements(&all->edges_at, all->vertices, 2, all->edges, all->edge);
    memcpy(all->around.start, all->edges_at.start,
           sizeof(int) * ((size_t)all->vertices + 1));
    for (int v = 0; v < all->vertices; v++)
        for (int i = all->around.start[v]; i < all->around.start[v + 1]; i++) {
            const int *edge = all->edge + 2 * (ptrdiff_t)all->edges_at.item[i];
            all->around.item[i] = edge[0] == v ? edge[1] : edge[0];
        }
}

//: Find an element by bisection
static int compare(int corners, const int a[], const int b[])
{
    for (int i = 0; i < corners; i++)
        if (a[i] != b[i])
            return a[i] < b[i] ? -1 : 1;
    return 0;
}

static int find_element(int corners, int count, const int *corner,
                        const int wanted[])
{
    int low = 0, high = count;
    while (low < high) {
        int middle = low + (high - low) / 2;
        int order =
            compare(corners, corner + (ptrdiff_t)corners * middle, wanted);
        if (order == 0)
            return middle;
        if (order < 0)
            low = middle + 1;
        else
            high = middle;
    }
    return -1;
}

//: Find an edge or a triangle
int tf_edge_of(const tf_neighbors *all, int a, int b)
{
    int wanted[2] = {a, b};
    tf_element_sort(2, wanted);
    return find_element(2, all->edges, all->edge, wanted);
}

int tf_triangle_of(const tf_neighbors *all, int a, int b, int c)
{
    int wanted[3] = {a, b, c};
    tf_element_sort(3, wanted);
    return find_element(3, all->triangles, all->triangle, wanted);
}

//: List the triangles of each edge
/// First the edges of each triangle take the place of the lists, then the lists
/// take theirs.
static void list_triangles_of_edges(tf_neighbors *all, int *side)
{
    for (int t = 0; t < all->triangles; t++) {
        const int *corner = all->triangle + 3 * (ptrdiff_t)t;
        for (int i = 0; i < 3; i++)
            side[3 * (ptrdiff_t)t + i] =
                tf_edge_of(all, corner[i], corner[(i + 1) % 3]);
    }
    list_elements(&all->at_edge, all->edges, 3, all->triangles, side);
}

//: Find connected parts
static void find_parts(tf_neighbors *all, int *stack)
{
    memset(all->part, -1, sizeof *all->part * (size_t)all->vertices);
    all->parts = 0;
    for (int first = 0; first < all->vertices; first++) {
        if (all->part[first] >= 0 || tf_list_length(&all->around, first) == 0)
            continue;
        int height = 0;
        all->part[first] = all->parts;
        stack[height++] = first;
        while (height > 0) {
            int v = stack[--height];
            for (int i = all->around.start[v]; i < all->around.start[v + 1];
                 i++) {
                int other = all->around.item[i];
                if (all->part[other] >= 0)
                    continue;
                all->part[other] = all->parts;
                stack[height++] = other;
            }
        }
        all->parts++;
    }
}

//: Turn a triangle as its neighbor
/// Which way a triangle, its vertices in increasing order, passes along an edge:
/// 1 from the lower vertex to the higher, or -1.
static int way_along(const int corner[], const int edge[])
{
    return edge[0] == corner[0] && edge[1] == corner[2] ? -1 : 1;
}

/// Two triangles have one side up if they pass along their edge opposite ways.
static signed char turn_like(const tf_neighbors *all, int triangle, int other,
                             int edge)
{
    const int *ends = all->edge + 2 * (ptrdiff_t)edge;
    int own = way_along(all->triangle + 3 * (ptrdiff_t)triangle, ends);
    int next = way_along(all->triangle + 3 * (ptrdiff_t)other, ends);
    return (signed char)(-all->turn[triangle] * own * next);
}

//: Go on to the triangles beyond the edges of a triangle
static int go_on(tf_neighbors *all, int triangle, int *stack, int height)
{
    const int *corner = all->triangle + 3 * (ptrdiff_t)triangle;
    for (int i = 0; i < 3; i++) {
        int edge = tf_edge_of(all, corner[i], corner[(i + 1) % 3]);
        for (int j = all->at_edge.start[edge]; j < all->at_edge.start[edge + 1];
             j++) {
            int other = all->at_edge.item[j];
            if (all->sheet[other] >= 0)
                continue;
            all->sheet[other] = all->sheet[triangle];
            all->turn[other] = turn_like(all, triangle, other, edge);
            stack[height++] = other;
        }
    }
    return height;
}

//: Find sheets
static void find_sheets(tf_neighbors *all, int *stack)
{
    all->sheets = 0;
    for (int t = 0; t < all->triangles; t++)
        all->sheet[t] = -1;
    for (int first = 0; first < all->triangles; first++) {
        if (all->sheet[first] >= 0)
            continue;
        int height = 0;
        all->sheet[first] = all->sheets++;
        all->turn[first] = 1;
        stack[height++] = first;
        while (height > 0) {
            int t = stack[--height];
            height = go_on(all, t, stack, height);
        }
    }
}

//: Make room for lists
/// Takes some integers of the memory.
static int *take(int **memory, size_t count)
{
    int *taken = *memory;
    *memory += count;
    return taken;
}

static bool reserve(tf_neighbors *all, int **workspace)
{
    size_t v = (size_t)all->vertices + 2, e = (size_t)all->edges + 2;
    size_t t = (size_t)all->triangles;
    size_t work = 3 * t > v ? 3 * t : v;
    size_t count = 4 * v + 5 * e + 7 * t + work;
    if (!tf_buffer_reserve(&all->counts, count, sizeof(int)) ||
        !tf_buffer_reserve(&all->turns, t + 1, 1))
        return false;
    int *memory = all->counts.data;
    all->at_vertex = (tf_lists){take(&memory, v), take(&memory, 3 * t)};
    all->around = (tf_lists){take(&memory, v), take(&memory, 2 * e)};
    all->edges_at = (tf_lists){take(&memory, v), take(&memory, 2 * e)};
    all->at_edge = (tf_lists){take(&memory, e), take(&memory, 3 * t)};
    all->part = take(&memory, v);
    all->sheet = take(&memory, t);
    all->turn = all->turns.data;
    *workspace = memory;
    return true;
}

//: Find what is next to what
bool tf_neighbors_find(tf_neighbors *all, const tf_surface *surface)
{
    int *workspace = NULL;
    all->axes = tf_surface_axes(surface);
    all->vertices = tf_surface_vertices(surface);
    all->edge = tf_surface_edges(surface, &all->edges);
    all->triangle = tf_surface_triangles(surface, &all->triangles);
    if (!reserve(all, &workspace))
        return false;
    list_elements(&all->at_vertex, all->vertices, 3, all->triangles,
                  all->triangle);
    list_neighbors(all);
    list_triangles_of_edges(all, workspace);
    find_parts(all, workspace);
    find_sheets(all, workspace);
    return true;
}

void tf_neighbors_free(tf_neighbors *all)
{
    tf_buffer_free(&all->counts);
    tf_buffer_free(&all->turns);
}

//: Measure edges
double tf_mean_edge(const tf_neighbors *all, const double x[], double around[])
{
    double sum = 0;
    for (int v = 0; around && v < all->vertices; v++)
        around[v] = 0;
    for (int e = 0; e < all->edges; e++) {
        const int *end = all->edge + 2 * (ptrdiff_t)e;
        double length = tf_vector_length(tf_vector_difference(
            tf_place(all, x, end[0]), tf_place(all, x, end[1])));
        sum += length;
        for (int i = 0; around && i < 2; i++)
            around[end[i]] += length;
    }
    for (int v = 0; around && v < all->vertices; v++)
        if (tf_list_length(&all->around, v) > 0)
            around[v] /= tf_list_length(&all->around, v);
    return all->edges > 0 ? sum / all->edges : 0;
}

//: Scale coordinates
int tf_scale_of(size_t coordinates, const double x[])
{
    double most = 0;
    for (size_t i = 0; i < coordinates; i++)
        most = fmax(most, fabs(x[i]));
    int power = 0;
    (void)frexp(most, &power);
    return most > 0 ? power - 1 : 0;
}

void tf_scale_by(size_t coordinates, const double from[], int power,
                 double to[])
{
    for (size_t i = 0; i < coordinates; i++)
        to[i] = ldexp(from[i], power);
}

//: Find the normal of a triangle in its sheet
tf_vector tf_sheet_normal(const tf_neighbors *all, const double x[],
                          int triangle)
{
    const int *corner = all->triangle + 3 * (ptrdiff_t)triangle;
    tf_vector a = tf_place(all, x, corner[0]);
    tf_vector normal =
        tf_vector_cross(tf_vector_difference(tf_place(all, x, corner[1]), a),
                        tf_vector_difference(tf_place(all, x, corner[2]), a));
    double length = tf_vector_length(normal);
    return tf_vector_scaled(length > 0 ? all->turn[triangle] / length : 0,
                            normal);
}
