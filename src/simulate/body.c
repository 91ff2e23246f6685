//: Include what bodies need
#include "simulate/body.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

//: Make room for one more
/// Room for a power of two of items: it grows where the count is one.
static void *extend(tf_body *body, void *items, int count, size_t size)
{
    if (body->failed || (count > 0 && (count & (count - 1)) != 0))
        return items;
    size_t room = count > 0 ? 2 * (size_t)count : 1;
    void *longer = realloc(items, room * size);
    if (longer)
        return longer;
    body->failed = true;
    return items;
}

//: Add to a body
void tf_body_add_vertex(tf_body *body, const double x[])
{
    size_t size = sizeof *x * (size_t)body->axes;
    int v = body->vertices;
    body->position = extend(body, body->position, v, size);
    body->mass = extend(body, body->mass, v, sizeof *body->mass);
    if (body->failed)
        return;
    memcpy(body->position + (ptrdiff_t)body->axes * v, x, size);
    body->mass[v] = 0;
    body->vertices++;
}

void tf_body_add_triangle(tf_body *body, int a, int b, int c)
{
    const int corners[] = {a, b, c};
    int t = body->triangles;
    body->triangle = extend(body, body->triangle, t, sizeof corners);
    if (body->failed)
        return;
    memcpy(body->triangle + (ptrdiff_t)3 * t, corners, sizeof corners);
    body->triangles++;
}

void tf_body_add_edge(tf_body *body, int a, int b)
{
    const int ends[] = {a, b};
    int e = body->edges;
    body->edge = extend(body, body->edge, e, sizeof ends);
    if (body->failed)
        return;
    memcpy(body->edge + (ptrdiff_t)2 * e, ends, sizeof ends);
    body->edges++;
}

void tf_body_add_elastic(tf_body *body, const tf_elastic *elastic)
{
    int e = body->elastics;
    body->elastic = extend(body, body->elastic, e, sizeof *elastic);
    if (body->failed)
        return;
    body->elastic[e] = *elastic;
    body->elastics++;
}

//: Add a spring
static double length_of(int axes, const double x[])
{
    double sum = 0;
    for (int k = 0; k < axes; k++)
        sum += x[k] * x[k];
    return sqrt(sum);
}

static double length_in(const tf_body *body, const tf_elastic *elastic,
                        const double position[])
{
    double sum[3];
    tf_elastic_sum(elastic, body->axes, position, sum);
    return length_of(body->axes, sum);
}

void tf_body_add_spring(tf_body *body, int a, int b, double stiffness)
{
    tf_elastic spring = {2, {a, b}, {-1, 1}, 0, stiffness};
    if (body->failed)
        return;
    spring.rest = length_in(body, &spring, body->position);
    tf_body_add_elastic(body, &spring);
}

//: Measure a body
void tf_elastic_sum(const tf_elastic *elastic, int axes,
                    const double position[], double sum[3])
{
    for (int k = 0; k < axes; k++) {
        sum[k] = 0;
        for (int i = 0; i < elastic->count; i++)
            sum[k] +=
                elastic->weight[i] * position[axes * elastic->vertex[i] + k];
    }
}

double tf_body_elastic_energy(const tf_body *body, const double position[])
{
    double energy = 0;
    for (int i = 0; i < body->elastics; i++) {
        const tf_elastic *elastic = &body->elastic[i];
        double amiss = length_in(body, elastic, position) - elastic->rest;
        energy += elastic->stiffness / 2 * amiss * amiss;
    }
    return energy;
}

double tf_body_stretch(const tf_body *body, const double position[])
{
    double most = 1;
    for (int i = 0; i < body->elastics; i++) {
        const tf_elastic *elastic = &body->elastic[i];
        if (elastic->count == 2)
            most =
                fmax(most, length_in(body, elastic, position) / elastic->rest);
    }
    return most;
}

double tf_body_kinetic_energy(const tf_body *body, const double velocity[])
{
    double energy = 0;
    for (int v = 0; v < body->vertices; v++) {
        double speed =
            length_of(body->axes, velocity + (ptrdiff_t)body->axes * v);
        energy += body->mass[v] / 2 * speed * speed;
    }
    return energy;
}

//: Lend the mesh of a body, and free it
tf_mesh tf_body_mesh(const tf_body *body)
{
    return (tf_mesh){.axes = body->axes,
                     .vertices = body->vertices,
                     .triangles = body->triangles,
                     .triangle = body->triangle,
                     .edges = body->edges,
                     .edge = body->edge};
}

void tf_body_free(tf_body *body)
{
    free(body->position);
    free(body->mass);
    free(body->triangle);
    free(body->edge);
    free(body->elastic);
    *body = (tf_body){0};
}
