//: Include what scenes of flows need
#include "simulate/flow_scene.h"

#include "geometry/vector.h"
#include "simulate/flow_fields.h"
#include "simulate/geodesic.h"

#include <math.h>
#include <string.h>

//: Build surfaces from spheres
/// Adds a sphere, and then moves each of its points, which comes from the origin
/// at distance 1, to where `place` has it.
static void add_deformed(tf_body *body, int division,
                         tf_vector place(tf_vector from))
{
    int first = body->vertices;
    tf_geodesic_add(body, division);
    for (int v = first; v < body->vertices; v++) {
        tf_vector at = place(tf_vector_at(body->position, v));
        memcpy(body->position + (ptrdiff_t)3 * v, at.x, sizeof at.x);
    }
}

static tf_vector ball_around(tf_vector center, double radius, tf_vector from)
{
    return tf_vector_sum(center, radius, from);
}

//: Build the scene spheres
static tf_vector left_ball(tf_vector from)
{
    return ball_around((tf_vector){{-0.18, 0, 0}}, 0.15, from);
}

static tf_vector right_ball(tf_vector from)
{
    return ball_around((tf_vector){{0.18, 0.03, 0.02}}, 0.15, from);
}

static void build_spheres(tf_body *body, double edge)
{
    int division = tf_geodesic_division(0.15, edge);
    add_deformed(body, division, left_ball);
    add_deformed(body, division, right_ball);
}

//: Build the scene dumbbell
/// A quarter as thick in the middle as it is long.
static tf_vector dumbbell_place(tf_vector from)
{
    double radius = 0.08 + 0.3 * from.x[0] * from.x[0];
    return ball_around((tf_vector){{0}}, radius, from);
}

static void build_dumbbell(tf_body *body, double edge)
{
    add_deformed(body, tf_geodesic_division(0.2, edge), dumbbell_place);
}

//: Build the scenes enright and turbulence
static tf_vector enright_ball(tf_vector from)
{
    return ball_around((tf_vector){{0.35, 0.35, 0.35}}, 0.15, from);
}

static void build_enright(tf_body *body, double edge)
{
    add_deformed(body, tf_geodesic_division(0.15, edge), enright_ball);
}

static tf_vector blob(tf_vector from)
{
    return ball_around((tf_vector){{0}}, 0.25, from);
}

static void build_turbulence(tf_body *body, double edge)
{
    add_deformed(body, tf_geodesic_division(0.25, edge), blob);
}

//: Build the scene star
/// Points out along the axes.
static tf_vector star_place(tf_vector from)
{
    double far = 0;
    for (int k = 0; k < 3; k++) {
        double square = from.x[k] * from.x[k];
        far += square * square * square * square;
    }
    return ball_around((tf_vector){{0}}, 0.12 + 0.28 * far, from);
}

static void build_star(tf_body *body, double edge)
{
    add_deformed(body, tf_geodesic_division(0.3, edge), star_place);
}

//: Build the scene sheets
/// A square across the first two axes, whose cells are divided along one
/// diagonal and along the other in turn.
static void add_sheet(tf_body *body, double side, double height, int cells)
{
    int first = body->vertices, across = cells + 1;
    for (int j = 0; j <= cells; j++)
        for (int i = 0; i <= cells; i++)
            tf_body_add_vertex(body,
                               (const double[]){side * (i / (double)cells - .5),
                                                side * (j / (double)cells - .5),
                                                height});
    for (int j = 0; j < cells; j++)
        for (int i = 0; i < cells; i++) {
            int a = first + j * across + i, b = a + 1, c = a + across;
            int d = c + 1;
            bool odd = (i + j) % 2 == 1;
            tf_body_add_triangle(body, a, b, odd ? c : d);
            tf_body_add_triangle(body, odd ? b : a, d, c);
        }
}

static void build_sheets(tf_body *body, double edge)
{
    const double side = 0.8, gap = 0.05;
    int cells = (int)ceil(side / edge);
    for (int i = -1; i <= 1; i++)
        add_sheet(body, side, gap * i, cells);
}

//: List the scenes of flows
static const tf_flow_scene flows[] = {
    {
        .name = "spheres",
        .shows = "two balls are pressed together, and merge",
        .edge = 0.025,
        .most = 0.1,
        .step = 0.01,
        .steps = 300,
        .velocity = tf_flow_splash,
        .build = build_spheres,
    },
    {
        .name = "dumbbell",
        .shows = "a dumbbell is squeezed until it comes apart",
        .edge = 0.025,
        .most = 0.1,
        .step = 0.01,
        .steps = 150,
        .velocity = tf_flow_squeeze,
        .build = build_dumbbell,
    },
    {
        .name = "enright",
        .shows = "vortices stretch a ball to a thin sheet, and back",
        .edge = 0.0226,
        .most = 0.1,
        .step = 0.01,
        .steps = 300,
        .velocity = tf_flow_vortices,
        .build = build_enright,
    },
    {
        .name = "turbulence",
        .shows = "a ball is stirred by random waves",
        .edge = 0.03,
        .most = 0.1,
        .step = 0.01,
        .steps = 1000,
        .velocity = tf_flow_turbulence,
        .build = build_turbulence,
    },
    {
        .name = "star",
        .shows = "a star grows along its normals",
        .edge = 0.03,
        .most = 0.1,
        .step = 0.01,
        .steps = 200,
        .velocity = tf_flow_growth,
        .build = build_star,
    },
    {
        .name = "sheets",
        .shows = "three thin sheets are rolled up together",
        .edge = 0.03,
        .most = 0.2,
        .step = 0.01,
        .steps = 400,
        .keep_topology = true,
        .velocity = tf_flow_whirl,
        .build = build_sheets,
    },
};

const tf_flow_scene *tf_flow_scenes(int *count)
{
    *count = sizeof flows / sizeof *flows;
    return flows;
}

//: Find a scene of a flow by its name
const tf_flow_scene *tf_flow_scene_named(const char *name)
{
    for (size_t i = 0; i < sizeof flows / sizeof *flows; i++)
        if (strcmp(name, flows[i].name) == 0)
            return &flows[i];
    return NULL;
}
