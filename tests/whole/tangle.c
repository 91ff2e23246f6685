// The judge of surfaces at rest: finds what is planted, and what the library's
// own check finds.
#include "support/tangle.h"

#include "fast/detect.h"
#include "support/support.h"
#include "support/surface_of.h"
#include "support/surfaces.h"
#include "surface/check.h"

#include <math.h>
#include <string.h>

// Against the library's check -------------------------------------------------

static surface_case given;

static tf_crossings check(tf_surface *surface)
{
    tf_crossings found;
    ck_assert_int_eq(tf_surface_check(surface, given.mesh.vertices, given.start,
                                      NULL, &found, NULL),
                     TF_OK);
    return found;
}

static void expect_same(const tangle *judged, const tf_crossing *checked)
{
    static const tf_crossing_kind kinds[] = {
        TF_EDGE_THROUGH_TRIANGLE, TF_POINT_ON_TRIANGLE, TF_EDGE_ON_EDGE};
    ck_assert_msg(
        kinds[judged->kind] == checked->kind &&
            memcmp(judged->vertex, checked->vertex, sizeof judged->vertex) == 0,
        "%s: not found by the check", tangle_text(judged));
}

/// How many tangles are of those kinds that the check lists, and these first.
static size_t count_checked(const tangle_judge *judge, int count)
{
    const tangle *found = tangles(judge);
    while (count > 0 && found[count - 1].kind == POINT_IN_EDGE)
        count--;
    return (size_t)count;
}

static int compare(int (*count)(tangle_judge *, const double[]))
{
    tf_surface *surface = surface_of(&given.mesh);
    tangle_judge *judge = tangle_judge_new(&given.mesh);
    tf_crossings checked = check(surface);
    int judged = count(judge, given.start);
    ck_assert_uint_eq(count_checked(judge, judged), checked.count);
    for (size_t i = 0; i < checked.count; i++)
        expect_same(&tangles(judge)[i], &checked.crossing[i]);
    tangle_judge_free(judge);
    tf_surface_free(surface);
    return judged;
}

/// What was in one plane, or on one line, is now off it by rounding.
static void slant(void)
{
    int axes = given.mesh.axes;
    for (int v = 0; v < given.mesh.vertices; v++) {
        double *x = given.start + axes * v, sum = 0.7;
        for (int k = 0; k < axes; k++)
            sum += (0.1 + 0.2 * k) * x[k];
        x[1] = sum;
    }
}

START_TEST(tangles_are_those_of_the_check)
{
    generator random = generator_new((uint64_t)_i);
    int tangled = 0;
    for (int i = 0; i < cases(150) || (tangled == 0 && i < 150); i++) {
        random_surface(&random, 2 + i % 2, 20, (placement)_i, &given);
        if (i % 4 < 2)
            slant();
        int all = compare(tangle_count_all);
        ck_assert_int_eq(compare(tangle_count), all);
        tangled += all > 0;
    }
    ck_assert_int_gt(tangled, 0);
}
END_TEST

// The contacts of a step are those that detection finds.
START_TEST(tangles_of_a_step_are_its_contacts)
{
    generator random = generator_new(100 + (uint64_t)_i);
    size_t contacts = 0;
    for (int i = 0; i < cases(40) || (contacts == 0 && i < 40); i++) {
        random_surface(&random, 2 + i % 2, 8, (placement)_i, &given);
        tf_surface *surface = surface_of(&given.mesh);
        tangle_judge *judge = tangle_judge_new(&given.mesh);
        tf_contacts found;
        ck_assert_int_eq(
            tf_surface_detect(surface, &given.motion, NULL, &found, NULL),
            TF_OK);
        int judged = tangle_count_in_step(judge, given.start, given.end);
        ck_assert_uint_eq((size_t)judged, found.count);
        contacts += found.count;
        tangle_judge_free(judge);
        tf_surface_free(surface);
    }
    ck_assert(contacts > 0 || _i == AT_REST);
}
END_TEST

// Planted ---------------------------------------------------------------------

static int judge(tf_mesh mesh, const double position[], tangle *first)
{
    tangle_judge *judge = tangle_judge_new(&mesh);
    int count = tangle_count(judge, position);
    ck_assert_int_eq(tangle_count_all(judge, position), count);
    if (count > 0)
        *first = tangles(judge)[0];
    tangle_judge_free(judge);
    return count;
}

static const tf_mesh two_triangles = {.axes = 3,
                                      .vertices = 6,
                                      .triangles = 2,
                                      .triangle = (int[]){0, 1, 2, 3, 4, 5}};

/// The triangle z = 0, x, y >= 0, x + y <= 4 and another one.
static int judge_triangles(const double other[9], tangle *first)
{
    double position[18] = {0, 0, 0, 4, 0, 0, 0, 4, 0};
    memcpy(position + 9, other, 9 * sizeof *other);
    return judge(two_triangles, position, first);
}

START_TEST(a_pierced_triangle_is_one_tangle)
{
    static const double piercing[] = {1, 1, -1, 1, 1, 1, 9, 9, 1};
    static const int expected[] = {1, 2, 3, 4, 5};
    tangle first;
    ck_assert_int_eq(judge_triangles(piercing, &first), 2);
    ck_assert_int_eq(first.kind, EDGE_PIERCES_TRIANGLE);
    ck_assert_mem_eq(first.vertex, expected, sizeof expected);
}
END_TEST

START_TEST(a_vertex_on_a_triangle_is_a_tangle_a_subnormal_above_it_is_none)
{
    static const int expected[] = {3, 0, 1, 2, -1};
    double touching[] = {1, 1, 0, 1, 1, 1, 2, 1, 1};
    tangle first;
    ck_assert_int_eq(judge_triangles(touching, &first), 1);
    ck_assert_int_eq(first.kind, POINT_IN_TRIANGLE);
    ck_assert_mem_eq(first.vertex, expected, sizeof expected);
    touching[2] = 4.9e-324;
    ck_assert_int_eq(judge_triangles(touching, &first), 0);
}
END_TEST

START_TEST(an_ulp_to_the_side_decides_on_a_tangle)
{
    const tf_mesh curve = {
        .axes = 2, .vertices = 3, .edges = 1, .edge = (int[]){0, 1}};
    double position[] = {0, 0, 0.3, 0.3, 0.1, 0.1};
    tangle first;
    ck_assert_int_eq(judge(curve, position, &first), 1);
    ck_assert_int_eq(first.kind, POINT_IN_EDGE);
    position[5] = nextafter(0.1, 0);
    ck_assert_int_eq(judge(curve, position, &first), 0);
    position[5] = nextafter(0.1, 1);
    ck_assert_int_eq(judge(curve, position, &first), 0);
}
END_TEST

// Two triangles that share a vertex or an edge, and lie upon each other: other
// pairs of their elements tell.
START_TEST(overlapping_neighbors_are_no_tangle)
{
    const tf_mesh edge_shared = {.axes = 3,
                                 .vertices = 4,
                                 .triangles = 2,
                                 .triangle = (int[]){0, 1, 2, 0, 1, 3}};
    const tf_mesh vertex_shared = {.axes = 3,
                                   .vertices = 5,
                                   .triangles = 2,
                                   .triangle = (int[]){0, 1, 2, 0, 3, 4}};
    static const double crossed[] = {0, 0, 0, 4, 0, 0, 3, 4, 0, 1, 4, 0};
    static const double apart[] = {0, 0, 0, 4, 0, 0, 3, 4, 0, 1, -4, 0};
    static const double inside[] = {0, 0, 0, 4, 0, 0, 0, 4,
                                    0, 1, 1, 0, 2, 1, 0};
    tangle first;
    ck_assert_int_eq(judge(edge_shared, crossed, &first), 1);
    ck_assert_int_eq(first.kind, EDGES_MEET);
    ck_assert_int_eq(judge(edge_shared, apart, &first), 0);
    ck_assert_int_eq(judge(vertex_shared, inside, &first), 2);
    ck_assert_int_eq(first.kind, POINT_IN_TRIANGLE);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("whole/tangle");
    TCase *tcase = tcase_create("check");
    tcase_add_loop_test(tcase, tangles_are_those_of_the_check, 0, PLACEMENTS);
    tcase_add_loop_test(tcase, tangles_of_a_step_are_its_contacts, 0,
                        PLACEMENTS);
    suite_add_tcase(suite, tcase);

    TCase *planted = tcase_create("planted");
    tcase_add_test(planted, a_pierced_triangle_is_one_tangle);
    tcase_add_test(
        planted,
        a_vertex_on_a_triangle_is_a_tangle_a_subnormal_above_it_is_none);
    tcase_add_test(planted, an_ulp_to_the_side_decides_on_a_tangle);
    tcase_add_test(planted, overlapping_neighbors_are_no_tangle);
    suite_add_tcase(suite, planted);
    return suite;
}
