// Surfaces with defects, which are left alone by every operation.
#include "surgery/frozen.h"

#include "support/adaptive_surfaces.h"
#include "support/damage.h"
#include "support/support.h"
#include "support/surgery_runs.h"
#include "surgery/collapse.h"
#include "surgery/draft.h"
#include "surgery/flip.h"
#include "surgery/move.h"
#include "surgery/split.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static tf_adaptive_surface *around(const tf_mesh *mesh, const double position[],
                                   const tf_defects **defects)
{
    tf_adaptive_surface *surface = NULL;
    ck_assert_int_eq(
        tf_adaptive_create_around(mesh, position, &surface, defects, NULL),
        TF_OK);
    return surface;
}

/// The vertices that are left alone, as digits.
static const char *frozen_text(const tf_adaptive_surface *surface)
{
    static char text[20];
    int count = 0;
    for (int v = 0; v < tf_adaptive_mesh(surface)->vertices; v++)
        if (tf_is_frozen(surface, v))
            text[count++] = (char)('0' + v);
    text[count] = '\0';
    return text;
}

// Defects of each kind ----------------------------------------------------------

typedef struct defective {
    const char *what;
    int vertices, triangles;
    double position[9][3];
    int triangle[12];
    int defects;
    tf_status first, last; ///< their kinds
    int turned, alone;     ///< triangles
    const char *frozen;
} defective;

static const defective meshes[] = {
    {"nothing",
     4,
     2,
     {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
     {0, 1, 2, 0, 2, 3},
     0,
     TF_OK,
     TF_OK,
     0,
     0,
     ""},
    {"a triangle to be turned",
     4,
     2,
     {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
     {0, 1, 2, 0, 3, 2},
     0,
     TF_OK,
     TF_OK,
     1,
     0,
     ""},
    {"three triangles on an edge",
     5,
     3,
     {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 1}, {0, -1, -1}},
     {0, 1, 2, 1, 0, 3, 0, 1, 4},
     1,
     TF_EDGE_NOT_MANIFOLD,
     TF_EDGE_NOT_MANIFOLD,
     0,
     0,
     "01"},
    {"four, two in each direction",
     6,
     4,
     {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 1}, {0, -1, -1}, {0, 0, -1}},
     {0, 1, 2, 1, 0, 3, 0, 1, 4, 1, 0, 5},
     1,
     TF_EDGE_NOT_MANIFOLD,
     TF_EDGE_NOT_MANIFOLD,
     0,
     0,
     "01"},
    {"two fans",
     5,
     2,
     {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}},
     {0, 1, 2, 0, 3, 4},
     1,
     TF_VERTEX_NOT_MANIFOLD,
     TF_VERTEX_NOT_MANIFOLD,
     0,
     0,
     "0"},
    {"a collinear triangle alone",
     3,
     1,
     {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}},
     {0, 1, 2},
     1,
     TF_COLLINEAR,
     TF_COLLINEAR,
     0,
     1,
     "012"},
    // The middle vertex lies on the neighbor.
    {"a collinear triangle",
     4,
     2,
     {{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {0, 1, 0}},
     {0, 2, 1, 0, 1, 3},
     2,
     TF_COLLINEAR,
     TF_NOT_EMBEDDED,
     0,
     2,
     "0123"},
    {"triangles that cross",
     7,
     3,
     {{0, 0, 0},
      {4, 0, 0},
      {0, 4, 0},
      {1, 1, -1},
      {1, 1, 1},
      {9, 9, 9},
      {5, 5, 0}},
     {0, 1, 2, 3, 4, 5, 2, 1, 6},
     2,
     TF_NOT_EMBEDDED,
     TF_NOT_EMBEDDED,
     0,
     2,
     "012345"},
    {"a vertex of no triangle",
     4,
     1,
     {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0}},
     {0, 1, 2},
     0,
     TF_OK,
     TF_OK,
     0,
     0,
     ""},
};

static tf_mesh mesh_of(const defective *given)
{
    return (tf_mesh){.axes = 3,
                     .vertices = given->vertices,
                     .triangles = given->triangles,
                     .triangle = given->triangle};
}

START_TEST(all_defects_are_listed)
{
    const defective *given = &meshes[_i];
    tf_mesh mesh = mesh_of(given);
    const tf_defects *found;
    tf_adaptive_surface *surface = around(&mesh, given->position[0], &found);
    ck_assert_msg((int)found->count == given->defects &&
                      found->turned == given->turned &&
                      found->triangles == given->alone &&
                      found->vertices == (int)strlen(given->frozen) &&
                      strcmp(frozen_text(surface), given->frozen) == 0,
                  "%s: %zu, %d, %d, %s", given->what, found->count,
                  found->turned, found->triangles, frozen_text(surface));
    if (found->count > 0) {
        ck_assert_int_eq(found->defect[0].status, given->first);
        ck_assert_int_eq(found->defect[found->count - 1].status, given->last);
    }
    tf_adaptive_free(surface);
}
END_TEST

// The first defect is the one for which a surface is refused, unless triangles
// were turned.
START_TEST(the_first_is_what_is_refused)
{
    const defective *given = &meshes[_i];
    tf_mesh mesh = mesh_of(given);
    const tf_defects *found;
    tf_adaptive_surface *surface = around(&mesh, given->position[0], &found),
                        *strict = NULL;
    tf_error error, freedom;
    tf_status status =
        tf_adaptive_create(&mesh, given->position[0], &strict, &error);
    ck_assert_int_eq(tf_check_freedom(surface, &freedom), freedom.status);
    if (given->turned == 0) {
        ck_assert_int_eq(status, freedom.status);
        ck_assert_int_eq((int)error.subject, (int)freedom.subject);
        ck_assert_uint_eq(error.index, freedom.index);
        ck_assert_mem_eq(error.vertex, freedom.vertex, sizeof error.vertex);
    }
    tf_adaptive_free(strict);
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(what_is_no_mesh_is_refused)
{
    static const int triangle[] = {0, 1, 7};
    static const double position[9] = {0};
    tf_mesh mesh = {
        .axes = 3, .vertices = 3, .triangles = 1, .triangle = triangle};
    tf_adaptive_surface *surface = NULL;
    tf_error error;
    ck_assert_int_eq(
        tf_adaptive_create_around(&mesh, position, &surface, NULL, &error),
        TF_BAD_INDEX);
    ck_assert_int_eq(error.vertex[0], 7);
    ck_assert_ptr_null(surface);
}
END_TEST

START_TEST(a_perfect_surface_is_the_same_either_way)
{
    static adaptive_scene scene;
    generator random = generator_new(1);
    for (int kind = 0; kind < ADAPTIVE_SCENES; kind++) {
        adaptive_scene_make(&random, (adaptive_scene_kind)kind, &scene);
        tf_mesh mesh = adaptive_scene_mesh(&scene);
        const tf_defects *defects;
        tf_adaptive_surface *strict = NULL,
                            *surface = around(&mesh, scene.position, &defects);
        tf_adaptive_create(&mesh, scene.position, &strict, NULL);
        ck_assert_uint_eq(defects->count, 0);
        ck_assert_int_eq(defects->turned, 0);
        ck_assert_int_eq(tf_check_freedom(surface, NULL), TF_OK);
        ck_assert(adaptive_hash(surface) == adaptive_hash(strict));
        ck_assert_uint_eq(surface->frozen.bytes, 0);
        tf_adaptive_free(surface);
        tf_adaptive_free(strict);
    }
}
END_TEST

// Operations ------------------------------------------------------------------

/// A sheet of 4 x 4 squares with another triangle on the edge from 12 to 13, in
/// the middle; the last vertex of that is 25.
static tf_adaptive_surface *sheet_with_fin(void)
{
    tf_adaptive_surface *sheet = adaptive_sheet(4, 4);
    tf_mesh mesh = *tf_adaptive_mesh(sheet);
    double position[3 * 26];
    int triangle[3 * 33];
    memcpy(position, tf_adaptive_positions(sheet), 3 * 25 * sizeof *position);
    memcpy(position + 75, (double[]){2.5, 2, 1}, 3 * sizeof *position);
    memcpy(triangle, mesh.triangle, 3 * 32 * sizeof *triangle);
    memcpy(triangle + 96, (int[]){12, 13, 25}, 3 * sizeof *triangle);
    tf_adaptive_free(sheet);
    mesh.vertices = 26;
    mesh.triangles = 33;
    mesh.triangle = triangle;
    return around(&mesh, position, NULL);
}

static void expect(tf_adaptive_surface *surface, surgery_choice request,
                   tf_outcome expected)
{
    int vertex;
    uint64_t hash = adaptive_hash(surface);
    ck_assert_int_eq(surgery_choice_try(surface, &request, &vertex), expected);
    ck_assert_int_eq(adaptive_hash(surface) == hash, expected != TF_COMMITTED);
}

START_TEST(operations_leave_vertices_and_edges_alone)
{
    tf_adaptive_surface *surface = sheet_with_fin();
    ck_assert(tf_is_frozen(surface, 12) && tf_is_frozen(surface, 13));
    ck_assert(!tf_is_frozen(surface, 25) && !tf_is_frozen(surface, 7));
    expect(surface, (surgery_choice){MOVE_VERTEX, 12, 12, {2.1, 2, 0}},
           TF_IMPOSSIBLE);
    expect(surface, (surgery_choice){SPLIT_EDGE, 12, 13, {2.5, 2, 0}},
           TF_IMPOSSIBLE);
    expect(surface, (surgery_choice){FLIP_EDGE, 12, 13, {0}}, TF_IMPOSSIBLE);
    expect(surface, (surgery_choice){COLLAPSE_HALF, 12, 13, {0}},
           TF_IMPOSSIBLE);
    expect(surface, (surgery_choice){COLLAPSE_HALF, 12, 7, {0}}, TF_IMPOSSIBLE);
    expect(surface, (surgery_choice){COLLAPSE_TO_PLACE, 7, 12, {2, 1.9, 0}},
           TF_IMPOSSIBLE);
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(operations_go_up_to_them)
{
    static const surgery_choice requests[] = {
        {MOVE_VERTEX, 25, 25, {2.5, 2.1, 1}},
        {MOVE_VERTEX, 7, 7, {2.1, 1, 0}},
        {SPLIT_EDGE, 12, 25, {2.25, 2, 0.5}},
        {SPLIT_EDGE, 12, 7, {2, 1.5, 0}},
        {FLIP_EDGE, 12, 18, {0}},
        {COLLAPSE_HALF, 7, 12, {0}},
        {COLLAPSE_TO_PLACE, 7, 12, {2, 2, 0}}};
    tf_adaptive_surface *surface = sheet_with_fin();
    expect(surface, requests[_i], TF_COMMITTED);
    tf_adaptive_free(surface);
}
END_TEST

// A triangle that hangs on one vertex would vanish with its edge, and the vertex
// would not.
START_TEST(a_frozen_vertex_keeps_its_fans)
{
    double position[][3] = {{0, 0, 0}, {1, 0, 0},  {0, 1, 0},
                            {1, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
    static const int triangle[] = {0, 1, 2, 2, 1, 3, 0, 4, 5};
    tf_mesh mesh = {
        .axes = 3, .vertices = 6, .triangles = 3, .triangle = triangle};
    tf_adaptive_surface *surface = around(&mesh, position[0], NULL);
    ck_assert_str_eq(frozen_text(surface), "0");
    expect(surface, (surgery_choice){COLLAPSE_HALF, 4, 5, {0}}, TF_IMPOSSIBLE);
    expect(surface, (surgery_choice){COLLAPSE_HALF, 5, 4, {0}}, TF_IMPOSSIBLE);
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(marks_are_handed_on)
{
    tf_adaptive_surface *surface = sheet_with_fin(), draft = {0};
    expect(surface, (surgery_choice){COLLAPSE_HALF, 6, 5, {0}}, TF_COMMITTED);
    ck_assert_int_eq(tf_draft_begin(&draft, surface, NULL), TF_OK);
    ck_assert(tf_is_frozen(&draft, 12) && !tf_is_frozen(&draft, 11));
    int map[26];
    ck_assert_int_eq(tf_adaptive_compact(&draft, map), TF_OK);
    ck_assert_int_eq(map[12], 11);
    for (int v = 0; v < 25; v++)
        ck_assert_int_eq(tf_is_frozen(&draft, v), v == 11 || v == 12);
    tf_draft_accept(&draft, surface);
    ck_assert(tf_is_frozen(surface, 11) && tf_is_frozen(&draft, 13));
    tf_draft_free(&draft);
    tf_adaptive_free(surface);
}
END_TEST

// Random operations -----------------------------------------------------------

enum {
    MOST_TANGLES = 20000
};

/// A run on a scene that has been damaged, and what it was like before.
typedef struct damaged_run {
    surgery_run run;
    const tf_defects *defects;
    int triangles, triangle[3 * PLACED_TRIANGLES]; ///< those left alone
    double position[3 * PLACED_VERTICES];
    int tangles;
    tangle tangle[MOST_TANGLES];
} damaged_run;

static bool is_frozen_triangle(const tf_adaptive_surface *surface,
                               const int v[3])
{
    return tf_is_frozen(surface, v[0]) && tf_is_frozen(surface, v[1]) &&
           tf_is_frozen(surface, v[2]);
}

static void begin_damaged(damaged_run *all, uint64_t stream)
{
    static surgery_counts counts;
    surgery_run *run = &all->run;
    *run = (surgery_run){.random = generator_new(stream), .counts = &counts};
    adaptive_scene_make(&run->random,
                        (adaptive_scene_kind)(stream % ADAPTIVE_SCENES),
                        &run->scene);
    for (int i = 1 + below(&run->random, 8); i > 0; i--)
        damage(&run->random, &run->scene);
    tf_mesh mesh = adaptive_scene_mesh(&run->scene);
    run->surface = around(&mesh, run->scene.position, &all->defects);
    memcpy(all->position, run->scene.position, sizeof all->position);
    mesh = *tf_adaptive_mesh(run->surface);
    all->triangles = 0;
    for (int t = 0; t < mesh.triangles; t++)
        if (is_frozen_triangle(run->surface, mesh.triangle + 3 * t))
            memcpy(all->triangle + 3 * all->triangles++, mesh.triangle + 3 * t,
                   3 * sizeof(int));
    all->tangles = tangles_of(run->surface, MOST_TANGLES, all->tangle);
}

// What has to stay ------------------------------------------------------------

static const char *tangle_fault(const damaged_run *all)
{
    static tangle now[MOST_TANGLES];
    int count = tangles_of(all->run.surface, MOST_TANGLES, now);
    for (int i = 0; i < count; i++)
        if (i >= all->tangles ||
            memcmp(&now[i], &all->tangle[i], sizeof now[i]) != 0)
            return tangle_text(&now[i]);
    return count == all->tangles ? NULL : "a tangle is gone";
}

static const char *frozen_fault(const damaged_run *all)
{
    const tf_adaptive_surface *surface = all->run.surface;
    for (int t = 0; t < all->triangles; t++) {
        const int *v = all->triangle + 3 * t;
        if (!has_triangle(surface, v[0], v[1], v[2]))
            return "a triangle that is left alone is gone";
        for (int i = 0; i < 3; i++)
            if (memcmp(coordinates_of(surface, v[i]), all->position + 3 * v[i],
                       3 * sizeof(double)) != 0)
                return "a vertex that is left alone has moved";
    }
    return NULL;
}

/// How many triangles have an edge in a direction.
static int passes(const tf_mesh *mesh, int from, int to)
{
    int count = 0;
    for (int c = 0; c < 3 * mesh->triangles; c++)
        count += mesh->triangle[c / 3 * 3] >= 0 && mesh->triangle[c] == from &&
                 mesh->triangle[c % 3 == 2 ? c - 2 : c + 1] == to;
    return count;
}

static const char *edge_fault(const damaged_run *all)
{
    const tf_adaptive_surface *surface = all->run.surface;
    tf_mesh mesh = *tf_adaptive_mesh(surface);
    for (int c = 0; c < 3 * mesh.triangles; c++) {
        int a = mesh.triangle[c], b = mesh.triangle[c % 3 == 2 ? c - 2 : c + 1];
        if (mesh.triangle[c / 3 * 3] >= 0 && passes(&mesh, a, b) > 1 &&
            !(tf_is_frozen(surface, a) && tf_is_frozen(surface, b)))
            return "an edge has too many triangles";
    }
    return NULL;
}

/// How many rings and fans the triangles at a vertex form.
static int fans_at(const tf_mesh *mesh, int vertex)
{
    int star[100], fan[100], count = 0, fans;
    for (int c = 0; c < 3 * mesh->triangles && count < 100; c++)
        if (mesh->triangle[c / 3 * 3] >= 0 && mesh->triangle[c] == vertex) {
            star[count] = c / 3;
            fan[count] = count;
            count++;
        }
    fans = count;
    for (int i = 0; i < count; i++)
        for (int j = 0; j < i; j++) {
            int common = 0;
            for (int k = 0; k < 9; k++)
                common += mesh->triangle[3 * star[i] + k / 3] ==
                          mesh->triangle[3 * star[j] + k % 3];
            if (common < 2 || fan[i] == fan[j])
                continue;
            for (int k = 0, old = fan[j]; k < count; k++)
                fan[k] = fan[k] == old ? fan[i] : fan[k];
            fans--;
        }
    return fans;
}

static const char *fan_fault(const damaged_run *all)
{
    tf_mesh before = adaptive_scene_mesh(&all->run.scene);
    tf_mesh now = *tf_adaptive_mesh(all->run.surface);
    for (int v = 0; v < now.vertices; v++) {
        int fans = fans_at(&now, v);
        if (tf_is_frozen(all->run.surface, v) ? fans != fans_at(&before, v)
                                              : fans > 1)
            return "the triangles at a vertex are no single fan";
    }
    return NULL;
}

static const char *fault_of(const damaged_run *all)
{
    const char *found = tangle_fault(all);
    return found ? found : frozen_fault(all);
}

START_TEST(no_more_elements_meet)
{
    enum {
        OPERATIONS_EACH = 500
    };
    static damaged_run all;
    long done = 0, tangled = 0, defects[TF_BAD_AXES + 1] = {0};
    for (long run = 0; run < cases_at_least(10, 60); run++) {
        const char *fault = NULL;
        begin_damaged(&all, (uint64_t)run + 100);
        tangled += all.tangles > 0;
        for (size_t i = 0; i < all.defects->count; i++)
            defects[all.defects->defect[i].status]++;
        for (int i = 0; i < OPERATIONS_EACH && !fault; i++) {
            surgery_choice request = surgery_run_choose(&all.run);
            if (operate(&all.run, &request) != TF_COMMITTED)
                continue;
            fault = fault_of(&all);
            done++;
        }
        if (!fault)
            fault = edge_fault(&all);
        if (!fault)
            fault = fan_fault(&all);
        ck_assert_msg(!fault, "run %ld, after %ld: %s", run, done, fault);
        surgery_run_end(&all.run);
    }
    printf("%ld operations; %ld runs with tangles; defects %ld %ld %ld %ld\n",
           done, tangled, defects[TF_EDGE_NOT_MANIFOLD],
           defects[TF_VERTEX_NOT_MANIFOLD], defects[TF_COLLINEAR],
           defects[TF_NOT_EMBEDDED]);
    ck_assert_int_gt(done, cases(10000));
    for (int status = TF_EDGE_NOT_MANIFOLD; status <= TF_NOT_EMBEDDED; status++)
        ck_assert_int_gt(defects[status], 0);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("surgery/frozen");
    TCase *tcase = tcase_create("defects");
    int count = (int)(sizeof meshes / sizeof *meshes);
    tcase_add_loop_test(tcase, all_defects_are_listed, 0, count);
    tcase_add_loop_test(tcase, the_first_is_what_is_refused, 0, count);
    tcase_add_test(tcase, what_is_no_mesh_is_refused);
    tcase_add_test(tcase, a_perfect_surface_is_the_same_either_way);
    tcase_add_test(tcase, operations_leave_vertices_and_edges_alone);
    tcase_add_loop_test(tcase, operations_go_up_to_them, 0, 7);
    tcase_add_test(tcase, a_frozen_vertex_keeps_its_fans);
    tcase_add_test(tcase, marks_are_handed_on);
    tcase_add_test(tcase, no_more_elements_meet);
    suite_add_tcase(suite, tcase);
    return suite;
}
