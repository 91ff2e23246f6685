//: Include what geodesic spheres need
#include "simulate/geodesic.h"

#include "geometry/vector.h"

#include <math.h>

enum {
    TIPS = 12,
    SIDES = 20
};

/// The icosahedron; phi is the golden ratio.
static const double phi = 1.618033988749895;

static tf_vector tip_place(int tip)
{
    double one = tip & 1 ? 1 : -1, other = tip & 2 ? phi : -phi;
    int axis = tip / 4;
    tf_vector at = {{0}};
    at.x[axis] = one;
    at.x[(axis + 1) % 3] = other;
    return at;
}

static const int side_tips[SIDES][3] = {
    {0, 4, 1},   {0, 1, 6},  {0, 8, 4},   {0, 6, 9},  {0, 9, 8},
    {1, 4, 10},  {1, 11, 6}, {1, 10, 11}, {2, 3, 5},  {2, 7, 3},
    {2, 5, 8},   {2, 9, 7},  {2, 8, 9},   {3, 10, 5}, {3, 7, 11},
    {3, 11, 10}, {4, 8, 5},  {4, 5, 10},  {6, 7, 9},  {6, 11, 7}};

//: Number the points of an icosahedron
/// Whose sides are divided into rows, n along each edge.
typedef struct dividing {
    tf_body *body;
    int n;
    int first[TIPS][TIPS]; ///< of each edge, the first of n - 1 vertices, from
                           ///< the tip with the lower number on, and of a tip
                           ///< and itself its vertex; or -1
} dividing;

static int add_point(dividing *d, const int tip[3], const int part[3])
{
    tf_vector at = {{0}};
    for (int i = 0; i < 3; i++)
        at = tf_vector_sum(at, part[i], tip_place(tip[i]));
    at = tf_vector_unit(at);
    tf_body_add_vertex(d->body, at.x);
    return d->body->vertices - 1;
}

//: Number the points of its edges
static int vertex_of_tip(dividing *d, int tip)
{
    int *vertex = &d->first[tip][tip];
    if (*vertex < 0)
        *vertex = add_point(d, (int[]){tip, 0, 0}, (int[]){1, 0, 0});
    return *vertex;
}

/// So far from a towards b.
static int vertex_of_edge(dividing *d, int a, int b, int far)
{
    if (far == 0 || far == d->n)
        return vertex_of_tip(d, far == 0 ? a : b);
    if (a > b)
        return vertex_of_edge(d, b, a, d->n - far);
    int *first = &d->first[a][b];
    if (*first < 0) {
        *first = d->body->vertices;
        for (int i = 1; i < d->n; i++)
            add_point(d, (int[]){a, b, 0}, (int[]){d->n - i, i, 0});
    }
    return *first + far - 1;
}

//: Number the points of a side
/// A row of a side: n + 1 - row points, from its first tip towards the second;
/// the rows go from there towards the third.
static int vertex_in_side(dividing *d, const int tip[3], int row, int along,
                          int inside)
{
    if (row == 0)
        return vertex_of_edge(d, tip[0], tip[1], along);
    if (along == 0)
        return vertex_of_edge(d, tip[0], tip[2], row);
    if (row + along == d->n)
        return vertex_of_edge(d, tip[1], tip[2], row);
    // Of the points inside, n - 1 - r are in the row r.
    return inside + (row - 1) * (2 * d->n - 2 - row) / 2 + along - 1;
}

static int add_inside(dividing *d, const int tip[3])
{
    int first = d->body->vertices;
    for (int row = 1; row < d->n; row++)
        for (int along = 1; along < d->n - row; along++)
            add_point(d, tip, (int[]){d->n - row - along, along, row});
    return first;
}

//: Add a geodesic sphere
static void add_side(dividing *d, const int tip[3])
{
    int inside = add_inside(d, tip), n = d->n;
    for (int row = 0; row < n; row++)
        for (int i = 0; i < n - row; i++) {
            int a = vertex_in_side(d, tip, row, i, inside);
            int b = vertex_in_side(d, tip, row, i + 1, inside);
            int c = vertex_in_side(d, tip, row + 1, i, inside);
            tf_body_add_triangle(d->body, a, b, c);
            if (i + 1 < n - row)
                tf_body_add_triangle(
                    d->body, b, vertex_in_side(d, tip, row + 1, i + 1, inside),
                    c);
        }
}

void tf_geodesic_add(tf_body *body, int n)
{
    dividing d = {.body = body, .n = n};
    for (int i = 0; i < TIPS * TIPS; i++)
        d.first[i / TIPS][i % TIPS] = -1;
    for (int i = 0; i < SIDES && !body->failed; i++)
        add_side(&d, side_tips[i]);
}

int tf_geodesic_division(double radius, double edge)
{
    // An equilateral triangle of a 20 n^2-th of the sphere's area has this side.
    const double side = 1.2046;
    return (int)fmax(1, rint(side * radius / edge));
}
