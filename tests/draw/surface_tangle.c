// Zones, as their definition has them: pair by pair of facets.
#include "draw/surface_tangle.h"

#include "support/support.h"
#include "support/surface_of.h"
#include "support/surfaces.h"

#include <math.h>
#include <string.h>

enum {
    FACETS = 1000
};

typedef struct trial {
    int axes;
    tf_surface *surface;
    fig_shape shape;
    tf_crossings found;
    fig_tangled tangled;
} trial;

static void begin(trial *tried, const tf_mesh *mesh, const double x[])
{
    const tf_motion rest = {mesh->axes, mesh->vertices, x, x};
    tried->axes = mesh->axes;
    tried->surface = surface_of(mesh);
    ck_assert(fig_shape_make(&tried->shape, tried->surface, mesh->axes, &rest,
                             FIG_UP_Z));
    tf_error error;
    ck_assert_int_eq(fig_tangled_find(&tried->tangled, tried->surface,
                                      &tried->shape, x, NULL, &tried->found,
                                      &error),
                     TF_OK);
}

static void end(trial *tried)
{
    fig_tangled_free(&tried->tangled);
    fig_shape_free(&tried->shape);
    tf_surface_free(tried->surface);
}

// The definition --------------------------------------------------------------

static int facets_of(const trial *tried)
{
    return tried->axes == 2 ? tried->shape.edges : tried->shape.triangles;
}

static const int *corners(const trial *tried, int facet)
{
    const int *list =
        tried->axes == 2 ? tried->shape.edge : tried->shape.triangle;
    return list + (ptrdiff_t)tried->axes * facet;
}

/// Whether a facet has all vertices of an element.
static bool has(const trial *tried, int facet, int vertices, const int vertex[])
{
    const int *own = corners(tried, facet);
    for (int i = 0; i < vertices; i++) {
        bool found = false;
        for (int k = 0; k < tried->axes; k++)
            found = found || own[k] == vertex[i];
        if (!found)
            return false;
    }
    return true;
}

/// Whether an element belongs to a facet; that of a rod does not.
static bool has_facet(const trial *tried, int vertices, const int vertex[])
{
    for (int f = 0; f < facets_of(tried); f++)
        if (has(tried, f, vertices, vertex))
            return true;
    return false;
}

/// Whether a facet is at an element of a crossing, of which both have facets.
static bool is_at(const trial *tried, int facet, const tf_crossing *crossing)
{
    int first = crossing->kind == TF_POINT_ON_TRIANGLE ? 1 : 2;
    int second = crossing->kind == TF_EDGE_ON_EDGE ? 2 : 3;
    const int *other = crossing->vertex + first;
    return (has(tried, facet, first, crossing->vertex) ||
            has(tried, facet, second, other)) &&
           has_facet(tried, first, crossing->vertex) &&
           has_facet(tried, second, other);
}

static bool touch(const trial *tried, int a, int b)
{
    for (int k = 0; k < tried->axes; k++)
        if (has(tried, b, 1, corners(tried, a) + k))
            return true;
    return false;
}

/// The zone of each facet by flooding, the lowest of its facets; -1: none.
static void flood(const trial *tried, int zone[FACETS])
{
    static bool crosses[FACETS];
    int count = facets_of(tried);
    ck_assert_int_le(count, FACETS);
    for (int f = 0; f < count; f++) {
        crosses[f] = false;
        for (size_t i = 0; i < tried->found.count; i++)
            crosses[f] =
                crosses[f] || is_at(tried, f, &tried->found.crossing[i]);
    }
    for (int f = 0; f < count; f++) {
        zone[f] = -1;
        for (int g = 0; g < count; g++)
            if (crosses[g] && touch(tried, f, g))
                zone[f] = f;
    }
    for (bool changes = true; changes;) {
        changes = false;
        for (int f = 0; f < count; f++)
            for (int g = 0; g < count; g++) {
                bool same = touch(tried, f, g);
                for (size_t i = 0; i < tried->found.count && !same; i++)
                    same = is_at(tried, f, &tried->found.crossing[i]) &&
                           is_at(tried, g, &tried->found.crossing[i]);
                if (same && zone[f] >= 0 && zone[g] >= 0 && zone[g] < zone[f]) {
                    zone[f] = zone[g];
                    changes = true;
                }
            }
    }
}

/// Expects the zones that flooding finds, numbered in the order of their first
/// facets.
static int expect_zones(const trial *tried)
{
    static int zone[FACETS], number[FACETS];
    int zones = 0;
    flood(tried, zone);
    for (int f = 0; f < facets_of(tried); f++) {
        if (zone[f] == f)
            number[f] = zones++;
        ck_assert_msg(tried->tangled.zone[f] ==
                          (zone[f] < 0 ? -1 : number[zone[f]]),
                      "facet %d is in %d, seed %llu", f, tried->tangled.zone[f],
                      (unsigned long long)seed());
    }
    ck_assert_int_eq(tried->tangled.zones, zones);
    return zones;
}

// Surfaces --------------------------------------------------------------------

START_TEST(random_surfaces_have_the_zones_that_flood)
{
    generator random = generator_new(1);
    static surface_case made;
    for (long n = cases(20); n > 0; n--) {
        trial tried;
        random_surface(&random, 2 + (int)(n % 2), 12,
                       n % 3 ? ANYWHERE : ON_LATTICE, &made);
        begin(&tried, &made.mesh, made.start);
        expect_zones(&tried);
        end(&tried);
    }
}
END_TEST

enum {
    STRIPS = 14,
    LONG = 8 ///< triangles of a strip
};

/// Strips that lie anywhere make several zones, and leave triangles out.
START_TEST(strips_have_zones_of_their_own)
{
    generator random = generator_new(2);
    static double x[STRIPS][LONG + 2][3];
    static int triangle[STRIPS * LONG][3];
    int most = 0;
    for (long n = cases(15); n > 0; n--) {
        for (int i = 0; i < STRIPS; i++) {
            double from[3], along[3];
            for (int k = 0; k < 3; k++) {
                from[k] = uniform(&random, 0, 3);
                along[k] = uniform(&random, -0.3, 0.3);
            }
            for (int v = 0; v < LONG + 2; v++)
                for (int k = 0; k < 3; k++)
                    x[i][v][k] = from[k] + v * along[k] +
                                 (v % 2) * uniform(&random, 0, 0.4);
            for (int t = 0; t < LONG; t++)
                for (int k = 0; k < 3; k++)
                    triangle[i * LONG + t][k] = i * (LONG + 2) + t + k;
        }
        const tf_mesh mesh = {
            3, STRIPS * (LONG + 2), STRIPS * LONG, *triangle, 0, NULL};
        trial tried;
        begin(&tried, &mesh, **x);
        int zones = expect_zones(&tried);
        most = zones > most ? zones : most;
        end(&tried);
    }
    ck_assert_int_gt(most, 1);
}
END_TEST

START_TEST(what_touches_is_told_from_what_passes)
{
    static const double x[][3] = {{0, 0, 0},  {4, 0, 0}, {0, 4, 0},
                                  {1, 1, 0},  {1, 1, 1}, {1.5, 1, 1},
                                  {2, 1, -1}, {2, 1, 2}, {3, 1.5, 2}};
    static const int triangle[][3] = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}};
    const tf_mesh mesh = {3, 9, 3, *triangle, 0, NULL};
    trial tried;
    begin(&tried, &mesh, *x);
    for (size_t i = 0; i < tried.found.count; i++)
        ck_assert(tried.tangled.touches[i] ==
                  (tried.found.crossing[i].vertex[0] == 3));
    ck_assert_int_eq(tried.tangled.curves.count, 1);
    ck_assert_int_eq(expect_zones(&tried), 1);
    end(&tried);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("draw/surface_tangle");
    TCase *tcase = tcase_create("zones");
    tcase_add_test(tcase, random_surfaces_have_the_zones_that_flood);
    tcase_add_test(tcase, strips_have_zones_of_their_own);
    tcase_add_test(tcase, what_touches_is_told_from_what_passes);
    suite_add_tcase(suite, tcase);
    return suite;
}
