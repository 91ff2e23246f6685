//: Include what bodies need
#include "simulate/body.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

//: Append an item to a list
/// Counts it in, and returns the list, which has room for a power of two of
/// items: it grows where the count is one.
static void *append(tf_body *body, void *items, int *count, const void *item,
                    size_t size)
{
    size_t old = (size_t)*count;
    bool full = old == 0 || (old & (old - 1)) == 0;
    if (full && !body->failed) {
        void *longer = realloc(items, (old > 0 ? 2 * old : 1) * size);
        if (longer)
            items = longer;
        else
            body->failed = true;
    }
    if (!body->failed) {
        memcpy((char *)items + old * size, item, size);
        ++*count;
    }
    return items;
}

//: Add to a body
void tf_body_add_vertex(tf_body *body, const double x[])
{
    const double massless = 0;
    int count = body->vertices;
    body->position =
        append(body, body->position, &count, x, sizeof *x * (size_t)body->axes);
    body->mass = append(body, body->mass, &body->vertices, &massless,
                        sizeof *body->mass);
}

void tf_body_add_triangle(tf_body *body, int a, int b, int c)
{
    const int corners[] = {a, b, c};
    body->triangle =
        append(body, body->triangle, &body->triangles, corners, sizeof corners);
}

void tf_body_add_edge(tf_body *body, int a, int b)
{
    const int ends[] = {a, b};
    body->edge = append(body, body->edge, &body->edges, ends, sizeof ends);
}

void tf_body_add_elastic(tf_body *body, const tf_elastic *elastic)
{
    body->elastic =
        append(body, body->elastic, &body->elastics, elastic, sizeof *elastic);
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

int tf_body_up(const tf_body *body)
{
    return (body->axes - 1 + body->up) % body->axes;
}

double tf_body_potential_energy(const tf_body *body, double gravity,
                                const double position[])
{
    double energy = tf_body_elastic_energy(body, position);
    for (int v = 0; v < body->vertices; v++)
        energy += body->mass[v] * gravity *
                  position[(ptrdiff_t)body->axes * v + tf_body_up(body)];
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
