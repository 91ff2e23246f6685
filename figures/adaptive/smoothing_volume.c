// A sphere whose vertices are moved to the middles of their stars again and
// again, in three ways.
#include "base/require.h"
#include "kit/figures.h"
#include "kit/remeshed.h"

#include "remesh/measure.h"
#include "remesh/original.h"
#include "surgery/move.h"

#include "renderer/plot.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    PASSES = 60,
    AROUND = 24, ///< of the sphere
    BELTS = 12,
    WAYS = 3
};

typedef enum way {
    PLAIN,
    SIDEWAYS, ///< without the component along the vector area
    PROJECTED ///< to the nearest point of the sphere at the beginning
} way;

static const struct {
    const char *name;
    fig_role role;
} ways[WAYS] = {
    [PLAIN] = {"plain", FIG_ROLE_CONTACT},
    [SIDEWAYS] = {"sideways", FIG_ROLE_EDGE},
    [PROJECTED] = {"projected", FIG_ROLE_TRIANGLE},
};

// The sphere ------------------------------------------------------------------

static int on_sphere(int belt, int i)
{
    return 2 + (belt - 1) * AROUND + i % AROUND;
}

static void put(fig_some_mesh *mesh, double x, double y, double z)
{
    const double at[] = {x, y, z};
    memcpy(mesh->x + 3 * (ptrdiff_t)mesh->vertices++, at, sizeof at);
}

static void face(fig_some_mesh *mesh, int a, int b, int c)
{
    const int corner[] = {a, b, c};
    memcpy(mesh->triangle + 3 * (ptrdiff_t)mesh->triangles++, corner,
           sizeof corner);
}

static fig_some_mesh make_sphere(void)
{
    const double pi = acos(-1);
    fig_some_mesh mesh = {.x = malloc(sizeof(double[3]) * BELTS * AROUND),
                          .triangle = malloc(sizeof(int[6]) * BELTS * AROUND)};
    TF_REQUIRE(mesh.x && mesh.triangle);
    put(&mesh, 0, 0, 1);
    put(&mesh, 0, 0, -1);
    for (int belt = 1; belt < BELTS; belt++)
        for (int i = 0; i < AROUND; i++) {
            double down = pi * belt / BELTS, turn = 2 * pi * i / AROUND;
            put(&mesh, sin(down) * cos(turn), sin(down) * sin(turn), cos(down));
        }
    for (int i = 0; i < AROUND; i++) {
        face(&mesh, 0, on_sphere(1, i), on_sphere(1, i + 1));
        face(&mesh, 1, on_sphere(BELTS - 1, i + 1), on_sphere(BELTS - 1, i));
        for (int belt = 1; belt < BELTS - 1; belt++) {
            face(&mesh, on_sphere(belt, i), on_sphere(belt + 1, i),
                 on_sphere(belt + 1, i + 1));
            face(&mesh, on_sphere(belt, i), on_sphere(belt + 1, i + 1),
                 on_sphere(belt, i + 1));
        }
    }
    return mesh;
}

// Smoothing -------------------------------------------------------------------

/// The mean of the triangles' middles, and twice the vector area, which is the
/// sum of the normals.
static tf_vector middle_and_area(const tf_adaptive_surface *surface, int vertex,
                                 tf_vector *area)
{
    tf_vector sum = {{0}};
    int count = 0, c = tf_first_corner(surface, vertex);
    *area = sum;
    for (; c != TF_NONE; c = tf_next_corner(surface, c)) {
        tf_shape shape = tf_shape_of(surface, c / 3);
        *area = tf_vector_sum(*area, 1, tf_shape_normal(&shape));
        for (int i = 0; i < 3; i++)
            sum = tf_vector_sum(sum, 1, shape.corner[i]);
        count += 3;
    }
    return tf_vector_scaled(1.0 / count, sum);
}

static void smooth(tf_adaptive_surface *surface, tf_original *original,
                   way chosen)
{
    for (int v = 0; v < surface->vertices; v++) {
        tf_vector area, place = middle_and_area(surface, v, &area);
        tf_vector path =
            tf_vector_difference(place, tf_position_of(surface, v));
        if (chosen == SIDEWAYS)
            place = tf_vector_sum(
                place, -tf_vector_dot(path, area) / tf_vector_dot(area, area),
                area);
        if (chosen == PROJECTED)
            place = tf_original_project(original, place).point;
        tf_outcome outcome;
        TF_REQUIRE(tf_adaptive_move(surface, v, place.x, &outcome) == TF_OK);
    }
}

static double volume_of(const tf_adaptive_surface *surface)
{
    double sum = 0;
    for (int t = 0; t < surface->triangles; t++) {
        tf_shape shape = tf_shape_of(surface, t);
        sum += tf_vector_dot(shape.corner[0],
                             tf_vector_cross(shape.corner[1], shape.corner[2]));
    }
    return sum / 6;
}

/// The course of the volume, the first being 1.
static void run(const fig_some_mesh *mesh, way chosen,
                double volume[PASSES + 1])
{
    tf_mesh given = fig_mesh_in_space(mesh);
    tf_adaptive_surface *surface = NULL, *before = NULL;
    tf_original original = {0};
    TF_REQUIRE(tf_adaptive_create(&given, mesh->x, &surface, NULL) == TF_OK);
    TF_REQUIRE(tf_adaptive_create(&given, mesh->x, &before, NULL) == TF_OK);
    TF_REQUIRE(tf_original_begin(&original, before, NULL) == TF_OK);
    double first = volume_of(surface);
    for (int i = 0; i <= PASSES; i++) {
        volume[i] = volume_of(surface) / first;
        if (i < PASSES)
            smooth(surface, &original, chosen);
    }
    tf_original_free(&original);
    tf_adaptive_free(before);
    tf_adaptive_free(surface);
}

// Drawing ---------------------------------------------------------------------

static void draw_course(fig_page *page, const fig_plot *plot, way chosen,
                        const double volume[PASSES + 1])
{
    fig_point at[PASSES + 1];
    for (int i = 0; i <= PASSES; i++)
        at[i] = (fig_point){i, 100 * volume[i]};
    fig_plot_curve(page, plot, PASSES + 1, at,
                   (fig_stroke){.paint = {.role = ways[chosen].role},
                                .dash = chosen == PROJECTED ? 4 : 0});
    fig_plot_key(page, 300, 30 + 18.0 * (int)chosen, ways[chosen].name,
                 ways[chosen].role);
}

static void draw(fig_page *page, FILE *numbers)
{
    static double volume[WAYS][PASSES + 1];
    fig_some_mesh sphere = make_sphere();
    if (volume[0][0] == 0)
        for (int i = 0; i < WAYS; i++)
            run(&sphere, (way)i, volume[i]);
    fig_plot plot = {.box = {46, 12, 236, 122},
                     .x = {0, PASSES},
                     .y = {0, 105},
                     .name_x = "passes",
                     .name_y = "volume, %"};
    fig_plot_frame(page, &plot);
    for (int i = 0; i < WAYS; i++)
        draw_course(page, &plot, (way)i, volume[i]);
    fig_number(numbers, "triangles", sphere.triangles);
    fig_number(numbers, "passes", PASSES);
    fig_number(numbers, "plain", 100 * volume[PLAIN][PASSES]);
    fig_number(numbers, "error", fabs(volume[SIDEWAYS][PASSES] - 1));
    fig_number(numbers, "projected", 100 * volume[PROJECTED][PASSES]);
    fig_some_mesh_free(&sphere);
}

const fig_figure fig_smoothing_volume = {
    .name = "smoothing-volume",
    .title = "What smoothing does to the volume",
    .width = FIG_PAGE_WIDTH,
    .height = 170,
    .draw = draw,
};
