#include "draw/surface_picture.h"

#include "fast/detect.h"
#include "support/picture_folder.h"
#include "support/support.h"
#include "support/surface_of.h"
#include "support/surfaces.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

// A surface that is shown -----------------------------------------------------

typedef struct trial {
    surface_case made;
    tf_surface *surface;
    fig_shown_surface shown;
} trial;

/// Mark what `made` has: the contacts of its step, or what intersects at rest.
static void mark(trial *tried, bool steps)
{
    fig_shown_surface *shown = &tried->shown;
    const tf_motion *motion = &tried->made.motion;
    tf_contacts contacts;
    tf_crossings crossings;
    tf_error error;
    shown->marked = true;
    if (steps) {
        ck_assert_int_eq(
            tf_surface_detect(tried->surface, motion, NULL, &contacts, &error),
            TF_OK);
        ck_assert(
            fig_marks_of_contacts(&shown->marks, &shown->shape, &contacts));
    } else {
        ck_assert_int_eq(fig_tangled_find(&shown->tangled, tried->surface,
                                          &shown->shape, motion->start, NULL,
                                          &crossings, &error),
                         TF_OK);
        ck_assert(
            fig_marks_of_crossings(&shown->marks, &shown->shape, &crossings));
    }
}

static void begin(trial *tried, generator *random, int axes, placement placed,
                  bool steps)
{
    random_surface(random, axes, 12, placed, &tried->made);
    tried->surface = surface_of(&tried->made.mesh);
    memset(&tried->shown, 0, sizeof tried->shown);
    tried->shown.steps = steps;
    tried->shown.motion = below(random, 2) ? FIG_BENT : FIG_STRAIGHT;
    tf_motion motion = tried->made.motion;
    if (!steps)
        motion.end = motion.start;
    ck_assert(fig_shape_make(&tried->shown.shape, tried->surface, axes, &motion,
                             (fig_up)below(random, 3)));
}

static void end(trial *tried)
{
    fig_tangled_free(&tried->shown.tangled);
    fig_marks_free(&tried->shown.marks);
    fig_shape_free(&tried->shown.shape);
    tf_surface_free(tried->surface);
}

/// Draw as a still picture (t < 0) or in a film, and from anywhere.
static void expect_picture(const fig_shown_surface *shown, double t,
                           bool turned)
{
    fig_drawing drawing = fig_surface_drawing(shown);
    fig_page_options options = {.width = drawing.width,
                                .height = drawing.height,
                                .pixels_x = 32,
                                .pixels_y = 24,
                                .moves = t >= 0,
                                .time = fmax(t, 0),
                                .turned = turned,
                                .azimuth = 77,
                                .elevation = -12};
    fig_page *page;
    FILE *numbers = fopen("/dev/null", "w");
    ck_assert_int_eq(fig_page_new(&options, &page), FIG_OK);
    drawing.draw(drawing.subject, page, numbers);
    fig_status status = fig_page_write(page, picture_path());
    ck_assert_msg(status == FIG_OK, "%s", fig_status_message(status));
    fig_page_free(page);
    fclose(numbers);
}

START_TEST(any_surface_is_drawn)
{
    generator random = generator_new(1);
    static trial tried;
    for (long n = cases(60); n > 0; n--) {
        bool steps = n % 3 > 0;
        begin(&tried, &random, 2 + below(&random, 2),
              (placement)below(&random, PLACEMENTS), steps);
        if (n % 2 == 0)
            mark(&tried, steps);
        tried.shown.crosses = tried.shown.tangled.zone && n % 4 == 0;
        fig_shown_surface_look(&tried.shown,
                               n % 5 == 0 ? uniform(&random, 0, 1) : -1);
        expect_picture(&tried.shown,
                       steps && n % 4 > 1 ? uniform(&random, 0, 1) : -1,
                       below(&random, 2));
        end(&tried);
    }
}
END_TEST

// Marks -----------------------------------------------------------------------

/// How far a point is from a segment or a triangle, about: the least over
/// samples of it.
static double distance(const fig_shape *shape, int vertices, const int vertex[],
                       fig_motion motion, double t, tf_vector from)
{
    enum {
        STEPS = 60
    };
    double least = INFINITY;
    for (int i = 0; i <= STEPS; i++)
        for (int j = 0; i + j <= STEPS; j++) {
            double weight[3] = {1, 0, 0};
            weight[1] = vertices > 1 ? (double)i / STEPS : 0;
            weight[2] = vertices > 2 ? (double)j / STEPS : 0;
            weight[0] = 1 - weight[1] - weight[2];
            tf_vector at =
                fig_shape_point(shape, vertices, vertex, weight, motion, t);
            least = fmin(least, fig_length(fig_difference(at, from)));
        }
    return least;
}

static tf_vector place_of(const fig_shape *shape, const fig_spot *spot)
{
    return fig_shape_point(shape, spot->vertices, spot->vertex, spot->weight,
                           FIG_BENT, spot->toi);
}

START_TEST(spots_are_on_both_elements)
{
    generator random = generator_new(2);
    static trial tried;
    for (long n = cases(10); n > 0; n--) {
        begin(&tried, &random, 2 + (int)(n % 2), ANYWHERE, true);
        const fig_shape *shape = &tried.shown.shape;
        tf_contacts found;
        tf_error error;
        ck_assert_int_eq(tf_surface_detect(tried.surface, &tried.made.motion,
                                           NULL, &found, &error),
                         TF_OK);
        fig_marks *marks = &tried.shown.marks;
        ck_assert(fig_marks_of_contacts(marks, shape, &found));
        ck_assert_int_eq(marks->count, (int)found.count);
        double first = FIG_NEVER;
        for (int i = 0; i < marks->count; i++) {
            const fig_spot *spot = &marks->spot[i];
            const int *other = found.contact[i].vertex + spot->vertices;
            int others =
                (found.contact[i].vertex[3] < 0 ? 3 : 4) - spot->vertices;
            first = fmin(first, found.contact[i].contact.toi_lo);
            ck_assert_double_lt(distance(shape, others, other, FIG_BENT,
                                         spot->toi, place_of(shape, spot)),
                                0.05);
            const float *since = others == 2 ? marks->edge : marks->triangle;
            int index = others == 2 ? fig_shape_edge(shape, other)
                                    : fig_shape_triangle(shape, other);
            ck_assert_double_le((double)since[index], spot->toi + 1e-6);
        }
        ck_assert_double_eq(marks->toi_lo, first);
        end(&tried);
    }
}
END_TEST

START_TEST(intersections_are_on_both_elements)
{
    generator random = generator_new(3);
    static trial tried;
    for (long n = cases(10); n > 0; n--) {
        begin(&tried, &random, 2 + (int)(n % 2), n % 3 ? ANYWHERE : ON_LATTICE,
              false);
        const fig_shape *shape = &tried.shown.shape;
        tf_crossings found;
        tf_error error;
        ck_assert_int_eq(
            tf_surface_check(tried.surface, tried.made.mesh.vertices,
                             tried.made.start, NULL, &found, &error),
            TF_OK);
        fig_marks *marks = &tried.shown.marks;
        ck_assert(fig_marks_of_crossings(marks, shape, &found));
        ck_assert_int_eq(marks->count, (int)found.count);
        for (int i = 0; i < marks->count; i++) {
            const fig_spot *spot = &marks->spot[i];
            const tf_crossing *row = &found.crossing[i];
            int others = row->kind == TF_EDGE_ON_EDGE ? 2 : 3;
            // Edges of the lattice that lie on each other have no one place.
            if (row->kind != TF_EDGE_ON_EDGE || n % 3)
                ck_assert_double_lt(
                    distance(shape, others, row->vertex + spot->vertices,
                             FIG_BENT, 0, place_of(shape, spot)),
                    0.05);
        }
        end(&tried);
    }
}
END_TEST

START_TEST(elements_in_no_contact_are_not_marked)
{
    generator random = generator_new(4);
    static trial tried;
    begin(&tried, &random, 3, ANYWHERE, true);
    ck_assert(fig_marks_of_contacts(&tried.shown.marks, &tried.shown.shape,
                                    &(tf_contacts){.count = 0}));
    for (int i = 0; i < tried.shown.shape.edges; i++)
        ck_assert(tried.shown.marks.edge[i] >= FIG_NEVER);
    for (int i = 0; i < tried.shown.shape.triangles; i++)
        ck_assert(tried.shown.marks.triangle[i] >= FIG_NEVER);
    end(&tried);
}
END_TEST

// Views -----------------------------------------------------------------------

enum {
    SIDE = 80 ///< of a lattice, in vertices
};

/// A flat square whose normal is an axis.
static void begin_square(trial *tried, int axis)
{
    static double at[SIDE * SIDE][3];
    static int triangle[2 * (SIDE - 1) * (SIDE - 1)][3];
    int count = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        at[i][axis] = 0;
        at[i][(axis + 1) % 3] = i / SIDE;
        at[i][(axis + 2) % 3] = i % SIDE;
        if (i % SIDE == SIDE - 1 || i / SIDE == SIDE - 1)
            continue;
        const int two[2][3] = {{i, i + 1, i + SIDE},
                               {i + 1, i + SIDE, i + SIDE + 1}};
        memcpy(triangle[count], two, sizeof two);
        count += 2;
    }
    const tf_mesh mesh = {3, SIDE * SIDE, count, *triangle, 0, NULL};
    const tf_motion rest = {3, SIDE * SIDE, *at, *at};
    memset(&tried->shown, 0, sizeof tried->shown);
    tried->surface = surface_of(&mesh);
    ck_assert(fig_shape_make(&tried->shown.shape, tried->surface, 3, &rest,
                             FIG_UP_Z));
}

START_TEST(squares_are_drawn_and_fit_the_page)
{
    static trial tried;
    for (int axis = 0; axis < 3; axis++) {
        begin_square(&tried, axis);
        const fig_shape *shape = &tried.shown.shape;
        fig_shown_surface_look(&tried.shown, -1);
        ck_assert_int_le(tried.shown.outline_count, FIG_OUTLINE);
        fig_view view =
            fig_view_of(&tried.shown.camera, (fig_box){0, 0, 384, 250});
        ck_assert_double_gt(fabs(view.back.x[axis]), 0.3);
        double widest = 0;
        for (int i = 0; i < shape->vertices; i++) {
            fig_point p = fig_view_project(&view, shape->at[0][i]);
            ck_assert(p.x > 5 && p.x < 379 && p.y > 5 && p.y < 245);
            widest = fmax(widest,
                          fmax(fabs(p.x - 192) / 192, fabs(p.y - 125) / 125));
        }
        ck_assert_double_gt(widest, 0.8);
        end(&tried);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_create("draw/surface_picture");
    TCase *drawn = tcase_create("drawn");
    tcase_add_checked_fixture(drawn, make_picture_folder,
                              remove_picture_folder);
    tcase_add_test(drawn, any_surface_is_drawn);
    suite_add_tcase(s, drawn);
    TCase *parts = tcase_create("parts");
    tcase_add_test(parts, spots_are_on_both_elements);
    tcase_add_test(parts, intersections_are_on_both_elements);
    tcase_add_test(parts, elements_in_no_contact_are_not_marked);
    tcase_add_test(parts, squares_are_drawn_and_fit_the_page);
    suite_add_tcase(s, parts);
    return s;
}
