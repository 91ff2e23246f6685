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
    list_elements(&all->sides, all->edges, 3, all->triangles, side);
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

//: Turn a facet as its neighbor
/// Which way a triangle, its vertices in increasing order, passes along an
/// edge: 1 from the lower vertex to the higher, or -1; in the plane, which way
/// an edge passes by a vertex: 1 if it begins there.
static int way_along(const tf_neighbors *all, int facet, int shared)
{
    const int *corner = all->facet + (ptrdiff_t)all->axes * facet;
    if (all->axes == 2)
        return corner[0] == shared ? 1 : -1;
    const int *edge = all->edge + 2 * (ptrdiff_t)shared;
    return edge[0] == corner[0] && edge[1] == corner[2] ? -1 : 1;
}

/// Two facets have one side up if they pass along what they share opposite
/// ways.
static signed char turn_like(const tf_neighbors *all, int facet, int other,
                             int shared)
{
    return (signed char)(-all->turn[facet] * way_along(all, facet, shared) *
                         way_along(all, other, shared));
}

//: Go on to the facets next to a facet
static int reach(tf_neighbors *all, int facet, int shared, int *stack,
                 int height)
{
    const tf_lists *lists = all->axes == 3 ? &all->sides : &all->edges_at;
    for (int i = lists->start[shared]; i < lists->start[shared + 1]; i++) {
        int other = lists->item[i];
        if (all->sheet[other] >= 0)
            continue;
        all->sheet[other] = all->sheet[facet];
        all->turn[other] = turn_like(all, facet, other, shared);
        stack[height++] = other;
    }
    return height;
}

static int go_on(tf_neighbors *all, int facet, int *stack, int height)
{
    const int *corner = all->facet + (ptrdiff_t)all->axes * facet;
    for (int i = 0; i < all->axes; i++) {
        int shared = all->axes == 3
                         ? tf_edge_of(all, corner[i], corner[(i + 1) % 3])
                         : corner[i];
        height = reach(all, facet, shared, stack, height);
    }
    return height;
}

//: Find sheets
static void find_sheets(tf_neighbors *all, int *stack)
{
    all->sheets = 0;
    for (int f = 0; f < all->facets; f++)
        all->sheet[f] = -1;
    for (int first = 0; first < all->facets; first++) {
        if (all->sheet[first] >= 0)
            continue;
        int height = 0;
        all->sheet[first] = all->sheets++;
        all->turn[first] = 1;
        stack[height++] = first;
        while (height > 0) {
            int own = stack[--height];
            height = go_on(all, own, stack, height);
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

/// Takes lists of some items.
static tf_lists take_lists(int **memory, size_t lists, size_t items)
{
    int *start = take(memory, lists + 2);
    return (tf_lists){start, take(memory, items)};
}

//: Make room for neighbors
/// And for a workspace of three times as many integers as there are triangles,
/// as many as vertices, and as facets.
static bool reserve(tf_neighbors *all, int **workspace)
{
    size_t v = (size_t)all->vertices, e = (size_t)all->edges;
    size_t t = (size_t)all->triangles, f = (size_t)all->facets;
    size_t count = 3 * (v + 2) + 4 * e + 3 * t + (e + 2) + 3 * t + v + f;
    if (!tf_buffer_reserve(&all->counts, count + 3 * t + v + f, sizeof(int)) ||
        !tf_buffer_reserve(&all->turns, f + 1, 1))
        return false;
    int *memory = all->counts.data;
    all->around = take_lists(&memory, v, 2 * e);
    all->edges_at = take_lists(&memory, v, 2 * e);
    all->triangles_at = take_lists(&memory, v, 3 * t);
    all->sides = take_lists(&memory, e, 3 * t);
    all->part = take(&memory, v);
    all->sheet = take(&memory, f);
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
    bool flat = all->axes == 2;
    all->facets = flat ? all->edges : all->triangles;
    all->facet = flat ? all->edge : all->triangle;
    if (!reserve(all, &workspace))
        return false;
    list_elements(&all->triangles_at, all->vertices, 3, all->triangles,
                  all->triangle);
    list_neighbors(all);
    all->facets_at = flat ? all->edges_at : all->triangles_at;
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

//: Find how long edges are
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

//: Find the normal of a facet in its sheet
tf_vector tf_facet_normal(const tf_neighbors *all, const double x[], int facet)
{
    const int *corner = all->facet + (ptrdiff_t)all->axes * facet;
    tf_vector a = tf_place(all, x, corner[0]);
    tf_vector along = tf_vector_difference(tf_place(all, x, corner[1]), a);
    tf_vector up = {{0, 0, 1}};
    if (all->axes == 3)
        up = tf_vector_difference(tf_place(all, x, corner[2]), a);
    tf_vector normal = tf_vector_cross(along, up);
    double length = tf_vector_length(normal);
    return tf_vector_scaled(length > 0 ? all->turn[facet] / length : 0, normal);
}
