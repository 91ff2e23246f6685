//: Include what scenes of flows need
#include "simulate/flow_scenes.h"

#include "simulate/cloth.h"
#include "simulate/flow_fields.h"
#include "simulate/flow_simulation.h"
#include "simulate/geodesic.h"

#include <math.h>
#include <string.h>

//: Build surfaces from spheres
/// How far out a surface is from its center in a direction.
typedef double distance(tf_vector direction);

static void add_round(tf_scene_setup *setup, int division, tf_vector center,
                      distance *far)
{
    tf_body *body = &setup->body;
    int first = body->vertices;
    tf_geodesic_add(body, division);
    for (int v = first; v < body->vertices; v++) {
        tf_vector out = tf_vector_at(body->position, v);
        tf_vector at = tf_vector_sum(center, far(out), out);
        memcpy(body->position + (ptrdiff_t)3 * v, at.x, sizeof at.x);
    }
}

//: Build the scene spheres
static double small(tf_vector direction)
{
    (void)direction;
    return 0.15;
}

static void build_spheres(tf_scene_setup *setup, double edge)
{
    int division = tf_geodesic_division(0.15, edge);
    add_round(setup, division, (tf_vector){{-0.18, 0, 0}}, small);
    add_round(setup, division, (tf_vector){{0.18, 0.03, 0.02}}, small);
}

//: Build the scene dumbbell
/// A quarter as thick in the middle as it is long.
static double dumbbell(tf_vector direction)
{
    return 0.08 + 0.3 * direction.x[0] * direction.x[0];
}

static void build_dumbbell(tf_scene_setup *setup, double edge)
{
    add_round(setup, tf_geodesic_division(0.2, edge), (tf_vector){{0}},
              dumbbell);
}

//: Build the scenes enright and turbulence
static void build_enright(tf_scene_setup *setup, double edge)
{
    add_round(setup, tf_geodesic_division(0.15, edge),
              (tf_vector){{0.35, 0.35, 0.35}}, small);
}

static double large(tf_vector direction)
{
    (void)direction;
    return 0.25;
}

static void build_turbulence(tf_scene_setup *setup, double edge)
{
    add_round(setup, tf_geodesic_division(0.25, edge), (tf_vector){{0}}, large);
}

//: Build the scene star
/// Points out along the axes.
static double star(tf_vector direction)
{
    double far = 0;
    for (int k = 0; k < 3; k++) {
        double square = direction.x[k] * direction.x[k];
        far += square * square * square * square;
    }
    return 0.12 + 0.28 * far;
}

static void build_star(tf_scene_setup *setup, double edge)
{
    add_round(setup, tf_geodesic_division(0.3, edge), (tf_vector){{0}}, star);
}

//: Build the scene sheets
static void build_sheets(tf_scene_setup *setup, double edge)
{
    const double side = 0.8, gap = 0.05;
    int cells = (int)ceil(side / edge);
    tf_body *body = &setup->body;
    for (int i = -1; i <= 1; i++)
        tf_sheet_add(body,
                     &(tf_sheet){.across = cells,
                                 .along = cells,
                                 .corner = {0, 0, gap * i},
                                 .across_step = {1, 0, 0},
                                 .along_step = {0, 1, 0}},
                     NULL);
    for (int v = 0; v < body->vertices; v++)
        for (int k = 0; k < 2; k++) {
            double *x = &body->position[3 * v + k];
            *x = side * (*x / cells - 0.5);
        }
}

//: List the scenes of flows
const tf_scene tf_flow_scenes[] = {
    {&tf_flow_kind, .name = "spheres", .build = build_spheres,
     .shows = "two balls are pressed together, and merge",
     .resolution = {0.025, 0.001, 0.1, NULL}, .steps = 300, .step = 0.01,
     .field = tf_splash},
    {&tf_flow_kind, .name = "dumbbell", .build = build_dumbbell,
     .shows = "a dumbbell is squeezed until it comes apart",
     .resolution = {0.025, 0.001, 0.1, NULL}, .steps = 150, .step = 0.01,
     .field = tf_squeeze},
    {&tf_flow_kind, .name = "enright", .build = build_enright,
     .shows = "vortices stretch a ball to a thin sheet, and back",
     .resolution = {0.0226, 0.001, 0.1, NULL}, .steps = 300, .step = 0.01,
     .field = tf_vortices},
    {&tf_flow_kind, .name = "turbulence", .build = build_turbulence,
     .shows = "a ball is stirred by random waves",
     .resolution = {0.03, 0.001, 0.1, NULL}, .steps = 1000, .step = 0.01,
     .field = tf_turbulence},
    {&tf_flow_kind, .name = "star", .build = build_star,
     .shows = "a star grows along its normals",
     .resolution = {0.03, 0.001, 0.1, NULL}, .steps = 200, .step = 0.01,
     .field = tf_growth},
    {&tf_flow_kind, .name = "sheets", .build = build_sheets,
     .shows = "three thin sheets are rolled up together",
     .resolution = {0.03, 0.001, 0.2, NULL}, .steps = 400, .step = 0.01,
     .field = tf_whirl, .keep_topology = true},
    {0},
};
