#include "kit/surface_normals.h"

#include "support/support.h"
#include "support/surface_of.h"
#include "support/surfaces.h"

#include <math.h>
#include <stdlib.h>

/// A surface at rest with its shape and its normals.
typedef struct trial {
    tf_surface *surface;
    fig_shape shape;
    fig_normals normals;
} trial;

/// All parts are soft, or none.
static trial begin(const tf_mesh *mesh, const double at[], bool all_soft)
{
    bool soft[256];
    for (int i = 0; i < 256; i++)
        soft[i] = all_soft;
    trial tried = {.surface = surface_of(mesh)};
    const tf_motion rest = {mesh->axes, mesh->vertices, at, at};
    ck_assert(fig_shape_make(&tried.shape, tried.surface, 3, &rest, FIG_UP_Z));
    ck_assert(fig_normals_find(&tried.normals, &tried.shape, 0, soft));
    return tried;
}

static void end(trial *tried)
{
    fig_normals_free(&tried->normals);
    fig_shape_free(&tried->shape);
    tf_surface_free(tried->surface);
}

/// The absolute cosine of the angle between a corner's normal and a direction.
static double along(const trial *tried, int corner, tf_vector direction)
{
    const float *n = tried->normals.corner[corner];
    return fabs(tf_vector_dot((tf_vector){{n[0], n[1], n[2]}}, direction));
}

enum {
    AROUND = 48,
    ACROSS = 24
};

/// The vertex (i, j) of a torus, and its normal.
static void place_on_torus(int i, int j, double at[3], tf_vector *normal)
{
    double u = 6.283185307179586 * i / AROUND;
    double v = 6.283185307179586 * j / ACROSS;
    *normal = (tf_vector){{cos(v) * cos(u), cos(v) * sin(u), sin(v)}};
    at[0] = cos(u) + 0.4 * normal->x[0];
    at[1] = sin(u) + 0.4 * normal->x[1];
    at[2] = 0.4 * normal->x[2];
}

START_TEST(smooth_surfaces_are_lit_smoothly)
{
    static double at[AROUND * ACROSS][3];
    static int triangle[2 * AROUND * ACROSS][3];
    static tf_vector normal[AROUND * ACROSS];
    int count = 0;
    for (int i = 0; i < AROUND; i++)
        for (int j = 0; j < ACROSS; j++) {
            int a = i * ACROSS + j, b = (i + 1) % AROUND * ACROSS + j;
            int c = i * ACROSS + (j + 1) % ACROSS;
            int d = (i + 1) % AROUND * ACROSS + (j + 1) % ACROSS;
            place_on_torus(i, j, at[a], &normal[a]);
            const int two[2][3] = {{a, b, d}, {a, d, c}};
            for (int k = 0; k < 2; k++, count++)
                for (int l = 0; l < 3; l++)
                    triangle[count][l] = two[k][l];
        }
    const tf_mesh mesh = {3, AROUND * ACROSS, count, *triangle, 0, NULL};
    trial tried = begin(&mesh, *at, false);
    for (int c = 0; c < 3 * tried.shape.triangles; c++)
        ck_assert_double_gt(along(&tried, c, normal[tried.shape.triangle[c]]),
                            0.995);
    for (int e = 0; e < tried.shape.edges; e++)
        ck_assert(!tried.normals.crease[e]);
    end(&tried);
}
END_TEST

/// The unit cube, soft or not.
static trial begin_cube(bool soft)
{
    static const int triangle[][3] = {
        {0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
        {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
    double at[8][3];
    for (int i = 0; i < 8; i++)
        for (int k = 0; k < 3; k++)
            at[i][k] = i >> k & 1;
    const tf_mesh mesh = {3, 8, 12, *triangle, 0, NULL};
    return begin(&mesh, *at, soft);
}

static int count_creases(const trial *tried)
{
    int creases = 0;
    for (int e = 0; e < tried->shape.edges; e++)
        creases += tried->normals.crease[e];
    return creases;
}

START_TEST(soft_cubes_have_no_creases)
{
    trial tried = begin_cube(true);
    ck_assert_int_eq(count_creases(&tried), 0);
    for (int c = 0; c < 36; c++) {
        tf_vector at = tried.shape.at[0][tried.shape.triangle[c]];
        ck_assert_double_gt(along(&tried, c, fig_normalized(at)), 0.9);
    }
    end(&tried);
}
END_TEST

START_TEST(cubes_have_twelve_creases)
{
    trial tried = begin_cube(false);
    ck_assert_int_eq(count_creases(&tried), 12);
    // Each corner is lit as its face: along an axis.
    for (int c = 0; c < 36; c++) {
        double most = 0;
        for (int k = 0; k < 3; k++)
            most = fmax(most, fabs((double)tried.normals.corner[c][k]));
        ck_assert_double_eq_tol(most, 1, 1e-6);
    }
    end(&tried);
}
END_TEST

/// Two triangles on the two sides of an edge, the second folded over by an
/// angle in degrees, in any order of vertices.
static bool is_creased(double angle, int flipped)
{
    double turn = angle * 0.017453292519943295;
    const double at[4][3] = {
        {0, 0, 0}, {0, 1, 0}, {-1, 0.5, 0}, {cos(turn), 0.5, sin(turn)}};
    const int triangle[2][3] = {{0, 1, 2},
                                {flipped ? 1 : 0, flipped ? 0 : 1, 3}};
    const tf_mesh mesh = {3, 4, 2, *triangle, 0, NULL};
    trial tried = begin(&mesh, *at, false);
    bool creased =
        tried.normals.crease[fig_shape_edge(&tried.shape, (int[]){0, 1})];
    end(&tried);
    return creased;
}

START_TEST(folds_are_creases_however_sharp)
{
    for (int flipped = 0; flipped < 2; flipped++) {
        ck_assert(!is_creased(0, flipped));
        ck_assert(!is_creased(30, flipped));
        ck_assert(is_creased(45, flipped));
        ck_assert(is_creased(150, flipped));
        ck_assert(is_creased(180, flipped));
        ck_assert(is_creased(-179, flipped));
    }
}
END_TEST

START_TEST(normals_are_of_length_one_or_zero)
{
    generator random = generator_new(1);
    static surface_case made;
    for (long n = cases(200); n > 0; n--) {
        random_surface(&random, 3, 60, (placement)below(&random, PLACEMENTS),
                       &made);
        trial tried = begin(&made.mesh, made.start, below(&random, 2));
        for (int c = 0; c < 3 * tried.shape.triangles; c++) {
            const float *x = tried.normals.corner[c];
            double length = sqrt((double)x[0] * x[0] + (double)x[1] * x[1] +
                                 (double)x[2] * x[2]);
            ck_assert(length == 0 || fabs(length - 1) < 1e-5);
        }
        end(&tried);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_create("kit/surface_normals");
    TCase *normals = tcase_create("normals");
    tcase_add_test(normals, smooth_surfaces_are_lit_smoothly);
    tcase_add_test(normals, cubes_have_twelve_creases);
    tcase_add_test(normals, soft_cubes_have_no_creases);
    tcase_add_test(normals, folds_are_creases_however_sharp);
    tcase_add_test(normals, normals_are_of_length_one_or_zero);
    suite_add_tcase(s, normals);
    return s;
}
