#define _GNU_SOURCE // open_memstream

#include "writers/contact_points.h"

#include "fast/detect.h"
#include "response/resolve.h"
#include "support/polydata.h"
#include "support/support.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static char *text;
static size_t size;

static void write_points(const tf_contact_points *points)
{
    FILE *stream = open_memstream(&text, &size);
    tf_polydata data = tf_contact_points_data(points);
    tf_polydata_write(stream, &data);
    fclose(stream);
}

/// Expects an array of points, up to rounding.
static void expect_array(const char *name, const char *type, int components,
                         size_t count, const double number[])
{
    const char *element = strcmp(name, "Points") == 0 ? "Points" : "PointData";
    for (size_t i = 0; i < count; i++) {
        double found = polydata_number(text, size, element, name, type,
                                       components, count, i);
        ck_assert_msg(fabs(found - number[i]) < 1e-14, "%s %zu: %g", name, i,
                      found);
    }
}

// Two edges that cross at (0.25 0 0.5), and a point that meets a triangle.
static const int triangle[] = {0, 1, 2}, edge[] = {4, 5, 6, 7};
static const tf_mesh in_space = {.axes = 3,
                                 .vertices = 8,
                                 .triangles = 1,
                                 .triangle = triangle,
                                 .edges = 2,
                                 .edge = edge};
static const double start[] = {9, 9,  0,  13, 9,    0,    9, 13,
                               0, 10, 10, 1,  0,    -1,   0, 0,
                               1, 0,  -1, 0,  0.75, 1.25, 0, 0.75};
static const double end[] = {9,   9,  0, 13,  9, 0, 9,  13, 0, 10,   10, -3,
                             0.5, -1, 1, 0.5, 1, 1, -1, 0,  0, 1.25, 0,  0};

static tf_surface *surface_of(const tf_mesh *mesh)
{
    tf_surface *surface;
    ck_assert_int_eq(tf_surface_create(mesh, &surface, NULL), TF_OK);
    return surface;
}

START_TEST(elements_are_found_where_they_touch)
{
    tf_surface *surface = surface_of(&in_space);
    tf_motion motion = {3, 8, start, end};
    tf_contacts found;
    ck_assert_int_eq(tf_surface_detect(surface, &motion, NULL, &found, NULL),
                     TF_OK);
    ck_assert_uint_eq(found.count, 2);
    tf_contact_points points = {0};
    ck_assert(tf_contact_points_found(&points, &motion, &found));
    write_points(&points);
    const double time = 3.0 / 7; // the edges: t = 0.75 - 0.75 t
    ck_assert_int_eq(polydata_count(text, "NumberOfVerts"), 2);
    expect_array("Points", "Float64", 3, 6,
                 (const double[]){10, 10, 0, 0.5 * time, 0, time});
    expect_array("time", "Float64", 1, 2, (const double[]){0.25, time});
    expect_array("kind", "UInt8", 1, 2,
                 (const double[]){TF_POINT_TRIANGLE, TF_EDGE_EDGE});
    expect_array("vertices", "Int32", 4, 8,
                 (const double[]){3, 0, 1, 2, 4, 5, 6, 7});
    expect_array("normal", "Float64", 3, 6,
                 (const double[]){0, 0, 1, 0, 0, -1});
    expect_array("normal_velocity", "Float64", 1, 2,
                 (const double[]){-4, -1.75});
    free(text);
    tf_contact_points_free(&points);
    tf_surface_free(surface);
}
END_TEST

START_TEST(points_of_the_plane_are_in_it)
{
    static const tf_mesh flat = {
        .axes = 2, .vertices = 3, .edges = 1, .edge = triangle};
    static const double from[] = {-1, 0, 1, 0, 0.5, 1};
    static const double to[] = {-1, 0, 1, 0, 0.5, -1};
    tf_surface *surface = surface_of(&flat);
    tf_motion motion = {2, 3, from, to};
    tf_contacts found;
    ck_assert_int_eq(tf_surface_detect(surface, &motion, NULL, &found, NULL),
                     TF_OK);
    tf_contact_points points = {0};
    ck_assert(tf_contact_points_found(&points, &motion, &found));
    write_points(&points);
    expect_array("Points", "Float64", 3, 3, (const double[]){0.5, 0, 0});
    expect_array("kind", "UInt8", 1, 1, (const double[]){TF_POINT_EDGE});
    expect_array("vertices", "Int32", 4, 4, (const double[]){2, 0, 1, -1});
    free(text);
    tf_contact_points_free(&points);
    tf_surface_free(surface);
}
END_TEST

/// The sum of what an array of the points gives to a vertex of theirs, with
/// weights of the contacts.
static void add_impulses(double sum[3], const tf_answered_contact *c,
                         size_t count, size_t i, int k)
{
    for (int axis = 0; axis < 3; axis++)
        sum[axis] +=
            c->coefficient[k] *
            (polydata_number(text, size, "PointData", "impulse", "Float64", 3,
                             3 * count, 3 * i + (size_t)axis) +
             polydata_number(text, size, "PointData", "push", "Float64", 1,
                             count, i) *
                 polydata_number(text, size, "PointData", "normal", "Float64",
                                 3, 3 * count, 3 * i + (size_t)axis));
}

// Impulses and pushes are what moves the vertices from their proposed end.
START_TEST(impulses_explain_how_vertices_were_moved)
{
    double before[24], after[24];
    memcpy(before, start, sizeof before);
    memcpy(after, end, sizeof after);
    before[11] = 0.1; // so near that the pair is pushed apart
    tf_surface *surface = surface_of(&in_space);
    tf_resolver *resolver;
    ck_assert_int_eq(tf_resolver_create(surface, &resolver), TF_OK);
    ck_assert_int_eq(
        tf_step_resolve(resolver, 8, before, after, NULL, NULL, NULL, NULL),
        TF_OK);
    tf_motion motion = {3, 8, before, after};
    tf_contact_points points = {0};
    ck_assert(tf_contact_points_answered(&points, &motion, resolver));
    write_points(&points);
    size_t count;
    const tf_answered_contact *contact;
    ck_assert_int_eq(tf_resolver_contacts(resolver, &count, &contact), TF_OK);
    ck_assert_uint_ge(count, 2);
    ck_assert_int_eq(polydata_count(text, "NumberOfPoints"), (int)count);
    double moved[24] = {0}, pushes = 0;
    for (size_t i = 0; i < count; i++) {
        pushes += polydata_number(text, size, "PointData", "push", "Float64", 1,
                                  count, i);
        ck_assert_int_le(contact[i].level, TF_ZONES);
        for (int k = 0; k < 4; k++)
            add_impulses(moved + 3 * contact[i].vertex[k], &contact[i], count,
                         i, k);
        ck_assert(polydata_number(text, size, "PointData", "vertices", "Int32",
                                  4, 4 * count, 4 * i) == contact[i].vertex[0]);
        ck_assert(polydata_number(text, size, "PointData", "level", "UInt8", 1,
                                  count, i) == (int)contact[i].level);
        ck_assert(polydata_number(text, size, "PointData", "round", "Int32", 1,
                                  count, i) == contact[i].round);
    }
    for (int i = 0; i < 24; i++)
        ck_assert_msg(fabs(end[i] + moved[i] - after[i]) < 1e-9, "%d: %g %g", i,
                      end[i] + moved[i], after[i]);
    ck_assert_msg(pushes > 0.001, "%g", pushes);
    // A point is where it is at the end of the step.
    for (size_t k = 0; k < 3; k++)
        ck_assert(polydata_number(text, size, "Points", "Points", "Float64", 3,
                                  3 * count, k) == after[9 + k]);
    free(text);
    tf_contact_points_free(&points);
    tf_resolver_free(resolver);
    tf_surface_free(surface);
}
END_TEST

START_TEST(no_contacts_are_no_points)
{
    for (int answered = 0; answered < 2; answered++) {
        tf_contact_points points = {.answered = answered};
        write_points(&points);
        ck_assert_int_eq(polydata_count(text, "NumberOfPoints"), 0);
        ck_assert_ptr_nonnull(
            strstr(text, answered ? "\"impulse\"" : "\"normal_velocity\""));
        free(text);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("writers/contact_points");
    TCase *tcase = tcase_create("points of contacts");
    tcase_add_test(tcase, elements_are_found_where_they_touch);
    tcase_add_test(tcase, points_of_the_plane_are_in_it);
    tcase_add_test(tcase, impulses_explain_how_vertices_were_moved);
    tcase_add_test(tcase, no_contacts_are_no_points);
    suite_add_tcase(suite, tcase);
    return suite;
}
