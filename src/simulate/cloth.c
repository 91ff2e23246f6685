//: Include what cloth needs
#include "simulate/cloth.h"

#include "geometry/vector.h"

#include <stdlib.h>

//: List the edges of triangles, once for each triangle
typedef struct side {
    int vertex[3]; ///< its ends, the lower index first, and the third corner
} side;

static side side_of(const int corner[3], int i)
{
    int a = corner[i], b = corner[(i + 1) % 3], c = corner[(i + 2) % 3];
    return (side){{a < b ? a : b, a < b ? b : a, c}};
}

static int compare_sides(const void *left, const void *right)
{
    const side *l = left, *r = right;
    for (int i = 0; i < 3; i++)
        if (l->vertex[i] != r->vertex[i])
            return l->vertex[i] < r->vertex[i] ? -1 : 1;
    return 0;
}

/// Sorted; NULL without memory.
static side *list_sides(const tf_body *body, int first)
{
    size_t count = 3 * (size_t)(body->triangles - first);
    side *list = malloc(sizeof *list * (count + 1));
    if (!list)
        return NULL;
    for (size_t i = 0; i < count; i++)
        list[i] =
            side_of(body->triangle + 3 * ((size_t)first + i / 3), (int)(i % 3));
    qsort(list, count, sizeof *list, compare_sides);
    return list;
}

static bool same_edge(const side *a, const side *b)
{
    return a->vertex[0] == b->vertex[0] && a->vertex[1] == b->vertex[1];
}

/// How many of the next sides, `most` or fewer, are of the first one's edge.
static int sides_at(const side *first, int most)
{
    int sides = 1;
    while (sides < most && same_edge(first, first + sides))
        sides++;
    return sides;
}

//: Measure a triangle
static tf_vector side_between(const tf_body *body, int a, int b)
{
    return tf_vector_difference(tf_vector_at(body->position, b),
                                tf_vector_at(body->position, a));
}

static double twice_area(tf_vector a, tf_vector b)
{
    return tf_vector_length(tf_vector_cross(a, b));
}

/// The cotangent of the angle at a corner, and twice the area.
static double cotangent(const tf_body *body, int corner, int b, int c,
                        double *area)
{
    tf_vector to_b = side_between(body, corner, b);
    tf_vector to_c = side_between(body, corner, c);
    *area = twice_area(to_b, to_c);
    return tf_vector_dot(to_b, to_c) / *area;
}

//: Resist stretching
/// What a triangle at an edge adds to the edge's stiffness: as much as the area
/// there is large, and the square of the edge's length small.
static double share_of(const tf_body *body, const side *one, double stretch)
{
    int a = one->vertex[0], b = one->vertex[1];
    tf_vector along = side_between(body, a, b);
    double area = twice_area(along, side_between(body, a, one->vertex[2])) / 2;
    return stretch * area / tf_vector_dot(along, along);
}

/// @param one the first of the sides at an edge
/// @param sides how many there are
static void add_stretch(tf_body *body, const side *one, int sides,
                        double stretch)
{
    double stiffness = 0;
    for (int i = 0; i < sides; i++)
        stiffness += share_of(body, &one[i], stretch);
    tf_body_add_spring(body, one->vertex[0], one->vertex[1], stiffness);
}

//: Resist folds
/// Two triangles at an edge, whose angles there weight the four vertices.
static void add_fold(tf_body *body, const side *one, const side *other,
                     double bend)
{
    int a = one->vertex[0], b = one->vertex[1];
    int c = one->vertex[2], d = other->vertex[2];
    double area[2];
    double c_at_a = cotangent(body, a, b, c, &area[0]);
    double c_at_b = cotangent(body, b, a, c, &area[0]);
    double d_at_a = cotangent(body, a, b, d, &area[1]);
    double d_at_b = cotangent(body, b, a, d, &area[1]);
    tf_elastic fold = {
        .count = 4,
        .vertex = {a, b, c, d},
        .weight = {c_at_b + d_at_b, c_at_a + d_at_a, -c_at_a - c_at_b,
                   -d_at_a - d_at_b},
        .stiffness = 2 * bend / (area[0] + area[1]),
    };
    tf_body_add_elastic(body, &fold);
}

//: Stiffen cloth
static void add_masses(tf_body *body, int first, double density)
{
    for (int t = first; t < body->triangles; t++) {
        const int *corner = body->triangle + (ptrdiff_t)3 * t;
        double area = twice_area(side_between(body, corner[0], corner[1]),
                                 side_between(body, corner[0], corner[2])) /
                      2;
        for (int i = 0; i < 3; i++)
            body->mass[corner[i]] += density * area / 3;
    }
}

void tf_cloth_stiffen(tf_body *body, int first, const tf_material *material)
{
    if (body->failed)
        return;
    side *list = list_sides(body, first);
    int count = 3 * (body->triangles - first);
    body->failed = !list;
    for (int i = 0, sides; list && i < count; i += sides) {
        sides = sides_at(&list[i], count - i);
        add_stretch(body, &list[i], sides, material->stretch);
        for (int k = 1; material->bend > 0 && k < sides; k++)
            add_fold(body, &list[i + k - 1], &list[i + k], material->bend);
    }
    free(list);
    add_masses(body, first, material->density);
}

//: Add a sheet
static void add_rows(tf_body *body, const tf_sheet *sheet)
{
    for (int j = 0; j <= sheet->along; j++)
        for (int i = 0; i <= sheet->across; i++) {
            double x[3];
            for (int k = 0; k < 3; k++)
                x[k] = sheet->corner[k] + i * sheet->across_step[k] +
                       j * sheet->along_step[k];
            tf_body_add_vertex(body, x);
        }
}

/// The diagonals alternate, so that the cloth is as stiff in one direction as in
/// the other.
static void add_cell(tf_body *body, int v, int row, bool odd)
{
    int right = v + 1, above = v + row, beyond = v + row + 1;
    tf_body_add_triangle(body, v, right, odd ? above : beyond);
    tf_body_add_triangle(body, odd ? right : v, beyond, above);
}

void tf_sheet_add(tf_body *body, const tf_sheet *sheet,
                  const tf_material *material)
{
    int corner = body->vertices, first = body->triangles;
    int row = sheet->across + 1;
    add_rows(body, sheet);
    for (int j = 0; j < sheet->along; j++)
        for (int i = 0; i < sheet->across; i++)
            add_cell(body, corner + j * row + i, row, (i + j) % 2 != 0);
    if (material)
        tf_cloth_stiffen(body, first, material);
}
