// Triangles that are oriented alike, the fewest turned.
#include "surgery/orient.h"

#include "support/support.h"
#include "surgery/adaptive.h"

#include <string.h>

enum {
    MOST = 12
};

/// A mesh of a few vertices on a moment curve: no four in a plane.
typedef struct small_mesh {
    int triangles, triangle[3 * MOST];
    double position[3 * MOST];
} small_mesh;

static void place_vertices(small_mesh *made)
{
    for (int v = 0; v < MOST; v++) {
        made->position[3 * v] = v;
        made->position[3 * v + 1] = v * v;
        made->position[3 * v + 2] = v * v * v;
    }
}

/// Returns how many triangles are turned; the mesh becomes the surface's.
static int orient(small_mesh *mesh)
{
    tf_mesh elements = {.axes = 3,
                        .vertices = MOST,
                        .triangles = mesh->triangles,
                        .triangle = mesh->triangle};
    tf_adaptive_surface *surface = NULL;
    const tf_defects *defects;
    ck_assert_int_eq(tf_adaptive_create_around(&elements, mesh->position,
                                               &surface, &defects, NULL),
                     TF_OK);
    int turned = defects->turned;
    memcpy(mesh->triangle, tf_adaptive_mesh(surface)->triangle,
           3 * sizeof(int) * (size_t)mesh->triangles);
    tf_adaptive_free(surface);
    return turned;
}

// The oracle ------------------------------------------------------------------

/// How often a triangle passes an edge forth, minus how often back.
static int passes(const small_mesh *mesh, int triangle, int a, int b)
{
    const int *v = mesh->triangle + 3 * triangle;
    for (int i = 0; i < 3; i++) {
        if (v[i] == a && v[(i + 1) % 3] == b)
            return 1;
        if (v[i] == b && v[(i + 1) % 3] == a)
            return -1;
    }
    return 0;
}

/// 1: two triangles share an edge with no third one, and disagree; -1: and
/// agree; 0: they do not.
static int disagreement(const small_mesh *mesh, int t, int u)
{
    for (int i = 0; i < 3; i++) {
        int a = mesh->triangle[3 * t + i];
        int b = mesh->triangle[3 * t + (i + 1) % 3];
        int count = 0;
        for (int k = 0; k < mesh->triangles; k++)
            count += passes(mesh, k, a, b) != 0;
        if (count == 2 && passes(mesh, u, a, b) != 0)
            return passes(mesh, u, a, b);
    }
    return 0;
}

static int disagreements(const small_mesh *mesh)
{
    int count = 0;
    for (int t = 0; t < mesh->triangles; t++)
        for (int u = 0; u < t; u++)
            count += disagreement(mesh, t, u) > 0;
    return count;
}

/// The fewest triangles to turn so that all agree, by trying all ways; -1: there
/// is none.
static int fewest_turns(const small_mesh *mesh)
{
    int least = -1;
    for (unsigned turned = 0; turned < 1u << mesh->triangles; turned++) {
        int turns = 0;
        bool agree = true;
        for (int t = 0; t < mesh->triangles && agree; t++) {
            turns += (int)(turned >> t & 1);
            for (int u = 0; u < t && agree; u++) {
                int found = disagreement(mesh, t, u);
                bool both = (turned >> t & 1) == (turned >> u & 1);
                agree = found == 0 || (found < 0) == both;
            }
        }
        if (agree && (least < 0 || turns < least))
            least = turns;
    }
    return least;
}

// Meshes ----------------------------------------------------------------------

/// Of triangles that are all different.
static void make_random(generator *random, small_mesh *made)
{
    int vertices = 5 + below(random, 2);
    made->triangles = 0;
    for (int i = 0; i < 9; i++) {
        int v[3], fresh = 1;
        for (int k = 0; k < 3; k++)
            v[k] = below(random, vertices);
        if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0])
            continue;
        for (int t = 0; t < made->triangles; t++)
            fresh &= passes(made, t, v[0], v[1]) == 0 ||
                     passes(made, t, v[1], v[2]) == 0;
        if (fresh)
            memcpy(made->triangle + 3 * made->triangles++, v, sizeof v);
    }
}

START_TEST(the_fewest_are_turned)
{
    generator random = generator_new(1);
    int oriented = 0, twisted = 0;
    small_mesh mesh;
    place_vertices(&mesh);
    for (long i = 0; i < cases_at_least(1000, 4000); i++) {
        make_random(&random, &mesh);
        if (mesh.triangles == 0)
            continue;
        int least = fewest_turns(&mesh), before = disagreements(&mesh);
        int turned = orient(&mesh);
        if (least >= 0)
            ck_assert_int_eq(turned, least);
        ck_assert_int_le(disagreements(&mesh), least >= 0 ? 0 : before);
        oriented += least > 0;
        twisted += least < 0;
    }
    ck_assert_int_gt(oriented, (int)cases(300));
    ck_assert_int_gt(twisted, 0);
}
END_TEST

START_TEST(of_as_many_the_first_triangle_decides)
{
    small_mesh mesh = {.triangles = 2, .triangle = {0, 1, 2, 0, 1, 3}};
    place_vertices(&mesh);
    ck_assert_int_eq(orient(&mesh), 1);
    static const int expected[] = {0, 1, 2, 0, 3, 1};
    ck_assert_mem_eq(mesh.triangle, expected, sizeof expected);
}
END_TEST

// A band of five triangles with one side: each has two vertices of the one
// before.  Its seam is where it was.
START_TEST(a_seam_stays)
{
    small_mesh mesh = {
        .triangles = 5,
        .triangle = {0, 1, 2, 2, 1, 3, 2, 3, 4, 4, 3, 0, 4, 0, 1}};
    place_vertices(&mesh);
    small_mesh before = mesh;
    ck_assert_int_eq(disagreements(&mesh), 1);
    ck_assert_int_eq(orient(&mesh), 0);
    ck_assert_mem_eq(mesh.triangle, before.triangle, sizeof before.triangle);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surgery/orient");
    TCase *tcase = tcase_create("orientation");
    tcase_add_test(tcase, the_fewest_are_turned);
    tcase_add_test(tcase, of_as_many_the_first_triangle_decides);
    tcase_add_test(tcase, a_seam_stays);
    suite_add_tcase(suite, tcase);
    return suite;
}
