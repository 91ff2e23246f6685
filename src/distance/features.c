//: Include what features need
#include "distance/features.h"

#include <limits.h>
#include <math.h>
#include <string.h>

//: List the features of two elements
int tf_features_of(tf_kind kind, const tf_features **features)
{
    static const tf_features of_triangle[] = {
        {TF_VERTEX_AND_TRIANGLE, {0, 1, 2, 3}},
        {TF_VERTEX_AND_EDGE, {0, 1, 2}},
        {TF_VERTEX_AND_EDGE, {0, 2, 3}},
        {TF_VERTEX_AND_EDGE, {0, 3, 1}},
        {TF_TWO_VERTICES, {0, 1}},
        {TF_TWO_VERTICES, {0, 2}},
        {TF_TWO_VERTICES, {0, 3}},
    };
    static const tf_features of_edges[] = {
        {TF_TWO_EDGES, {0, 1, 2, 3}},    {TF_VERTEX_AND_EDGE, {0, 2, 3}},
        {TF_VERTEX_AND_EDGE, {1, 2, 3}}, {TF_VERTEX_AND_EDGE, {2, 0, 1}},
        {TF_VERTEX_AND_EDGE, {3, 0, 1}}, {TF_TWO_VERTICES, {0, 2}},
        {TF_TWO_VERTICES, {0, 3}},       {TF_TWO_VERTICES, {1, 2}},
        {TF_TWO_VERTICES, {1, 3}},
    };
    static const tf_features of_edge[] = {
        {TF_VERTEX_AND_EDGE, {0, 1, 2}},
        {TF_TWO_VERTICES, {0, 1}},
        {TF_TWO_VERTICES, {0, 2}},
    };
    *features = kind == TF_POINT_TRIANGLE ? of_triangle
                : kind == TF_EDGE_EDGE    ? of_edges
                                          : of_edge;
    return kind == TF_POINT_TRIANGLE ? 7 : kind == TF_EDGE_EDGE ? 9 : 3;
}

//: Make exact vertices
void tf_exact_vertices_set(tf_kind kind, const double *const x[], double length,
                           tf_exact_vertices *exact)
{
    int axes = kind == TF_POINT_EDGE ? 2 : 3, vertices = axes + 1;
    exact->unit = tf_lowest_bit(length);
    for (int v = 0; v < vertices; v++)
        for (int k = 0; k < axes; k++) {
            int bit = tf_lowest_bit(x[v][k]);
            exact->unit = bit < exact->unit ? bit : exact->unit;
        }
    if (exact->unit == INT_MAX) // all are zero
        exact->unit = 0;
    for (int v = 0; v < vertices; v++)
        for (int k = 0; k < TF_AXES; k++)
            tf_wide_set(k < axes ? x[v][k] : 0, exact->unit, &exact->x[v][k]);
}

//: Take exact products of vectors
typedef struct wide_vector {
    tf_wide x[TF_AXES];
} wide_vector;

/// The vector from one vertex to another.
static void vector_between(const tf_exact_vertices *exact, int from, int to,
                           wide_vector *v)
{
    for (int k = 0; k < TF_AXES; k++)
        tf_wide_subtract(&exact->x[to][k], &exact->x[from][k], &v->x[k]);
}

static void wide_dot(const wide_vector *a, const wide_vector *b, tf_wide *dot)
{
    tf_wide product;
    tf_wide_multiply(&a->x[0], &b->x[0], dot);
    for (int k = 1; k < TF_AXES; k++) {
        tf_wide_multiply(&a->x[k], &b->x[k], &product);
        tf_wide_add(dot, &product, dot);
    }
}

static void wide_cross(const wide_vector *a, const wide_vector *b,
                       wide_vector *cross)
{
    tf_wide product;
    for (int k = 0; k < TF_AXES; k++) {
        int l = (k + 1) % TF_AXES, m = (k + 2) % TF_AXES;
        tf_wide_multiply(&a->x[l], &b->x[m], &cross->x[k]);
        tf_wide_multiply(&a->x[m], &b->x[l], &product);
        tf_wide_subtract(&cross->x[k], &product, &cross->x[k]);
    }
}

/// (a x b) . c
static void wide_triple(const wide_vector *a, const wide_vector *b,
                        const wide_vector *c, tf_wide *product)
{
    wide_vector cross;
    wide_cross(a, b, &cross);
    wide_dot(&cross, c, product);
}

//: Weight the vertices of features
/// Whether a number is between 0 and the scale, these left out.
static bool is_inside(const tf_wide *part, const tf_wide *scale)
{
    return part->sign == TF_POSITIVE &&
           tf_wide_compare(part, scale) == TF_NEGATIVE;
}

static double quotient_of(const tf_wide *part, const tf_wide *scale)
{
    int above, below;
    double number = tf_wide_round(part, &above);
    number /= tf_wide_round(scale, &below);
    return ldexp(number, above - below);
}

/// The coordinates of a point of an edge: `part` for its second vertex.
static void weight_edge(const int place[2], const tf_wide *part,
                        tf_feature_distance *found)
{
    tf_wide rest;
    tf_wide_subtract(&found->scale, part, &rest);
    found->weight[place[0]] = quotient_of(&rest, &found->scale);
    found->weight[place[1]] = quotient_of(part, &found->scale);
}

//: Measure two vertices
static void measure_two_vertices(const tf_exact_vertices *exact,
                                 const int place[2], tf_feature_distance *found)
{
    wide_vector between;
    vector_between(exact, place[0], place[1], &between);
    wide_dot(&between, &between, &found->square);
    tf_wide_set(1, 0, &found->scale);
    found->weight[place[0]] = found->weight[place[1]] = 1;
}

//: Measure a vertex and an edge
static bool measure_vertex_and_edge(const tf_exact_vertices *exact,
                                    const int place[3],
                                    tf_feature_distance *found)
{
    wide_vector edge, from;
    tf_wide along, square, product;
    vector_between(exact, place[1], place[2], &edge);
    vector_between(exact, place[1], place[0], &from);
    wide_dot(&edge, &edge, &found->scale);
    wide_dot(&from, &edge, &along);
    if (!is_inside(&along, &found->scale))
        return false;
    wide_dot(&from, &from, &square);
    tf_wide_multiply(&square, &found->scale, &found->square);
    tf_wide_multiply(&along, &along, &product);
    tf_wide_subtract(&found->square, &product, &found->square);
    found->weight[place[0]] = 1;
    weight_edge(place + 1, &along, found);
    return true;
}

//: Measure a vertex and a triangle
static bool measure_vertex_and_triangle(const tf_exact_vertices *exact,
                                        const int place[4],
                                        tf_feature_distance *found)
{
    wide_vector b, c, from, normal;
    tf_wide part[3], height;
    vector_between(exact, place[1], place[2], &b);
    vector_between(exact, place[1], place[3], &c);
    vector_between(exact, place[1], place[0], &from);
    wide_cross(&b, &c, &normal);
    wide_dot(&normal, &normal, &found->scale);
    wide_triple(&from, &c, &normal, &part[1]);
    wide_triple(&b, &from, &normal, &part[2]);
    tf_wide_subtract(&found->scale, &part[1], &part[0]);
    tf_wide_subtract(&part[0], &part[2], &part[0]);
    found->weight[place[0]] = 1;
    for (int i = 0; i < 3; i++) {
        if (!is_inside(&part[i], &found->scale))
            return false;
        found->weight[place[1 + i]] = quotient_of(&part[i], &found->scale);
    }
    wide_dot(&from, &normal, &height);
    tf_wide_multiply(&height, &height, &found->square);
    return true;
}

//: Measure two edges
static bool measure_two_edges(const tf_exact_vertices *exact,
                              const int place[4], tf_feature_distance *found)
{
    wide_vector first, second, between, normal;
    tf_wide part[2], height;
    vector_between(exact, place[0], place[1], &first);
    vector_between(exact, place[2], place[3], &second);
    vector_between(exact, place[0], place[2], &between);
    wide_cross(&first, &second, &normal);
    wide_dot(&normal, &normal, &found->scale);
    wide_triple(&between, &second, &normal, &part[0]);
    wide_triple(&between, &first, &normal, &part[1]);
    if (!is_inside(&part[0], &found->scale) ||
        !is_inside(&part[1], &found->scale))
        return false;
    weight_edge(place, &part[0], found);
    weight_edge(place + 2, &part[1], found);
    wide_dot(&between, &normal, &height);
    tf_wide_multiply(&height, &height, &found->square);
    return true;
}

//: Measure two features
bool tf_feature_distance_find(const tf_exact_vertices *exact,
                              const tf_features *features,
                              tf_feature_distance *found)
{
    memset(found->weight, 0, sizeof found->weight);
    switch (features->kind) {
    case TF_TWO_EDGES:
        return measure_two_edges(exact, features->place, found);
    case TF_VERTEX_AND_TRIANGLE:
        return measure_vertex_and_triangle(exact, features->place, found);
    case TF_VERTEX_AND_EDGE:
        return measure_vertex_and_edge(exact, features->place, found);
    default:
        measure_two_vertices(exact, features->place, found);
        return true;
    }
}
