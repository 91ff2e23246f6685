// What callers get wrong about adaptive surfaces and flows, by the header that
// they see.
#include "support/misuse.h"

#include <limits.h>
#include <math.h>
#include <string.h>
#include <tanglefree.h>

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))

/// A tetrahedron.
enum {
    VERTICES = 4
};
static const double position[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
static const int triangles[] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
static const tf_mesh mesh = {
    .axes = 3, .vertices = VERTICES, .triangles = 4, .triangle = triangles};

static tf_adaptive_surface *surface;
static tf_flow *flow;

static void begin(void)
{
    ck_assert_int_eq(tf_adaptive_create(&mesh, position, &surface, NULL),
                     TF_OK);
    ck_assert_int_eq(tf_flow_create(surface, &flow), TF_OK);
}

static void finish(void)
{
    tf_flow_free(flow);
    tf_adaptive_free(surface);
    ck_assert_uint_eq(tf_memory_in_use(), 0);
}

// Meshes ----------------------------------------------------------------------

static const int one_edge[] = {0, 1}, no_vertex[] = {0, 1, 2, 1, 2, VERTICES};
static const int repeated[] = {0, 1, 1}, two_ways[] = {0, 1, 2, 0, 1, 3};

static const struct {
    const char *what;
    tf_mesh mesh;
    tf_status expected;
} meshes[] = {
    {"all zero", {0}, TF_BAD_AXES},
    {"a mesh of the plane", {2, 4, 0, NULL, 1, one_edge}, TF_BAD_AXES},
    {"four axes", {4, 4, 4, triangles, 0, NULL}, TF_BAD_AXES},
    {"axes below 0", {-3, 4, 4, triangles, 0, NULL}, TF_BAD_AXES},
    {"vertices below 0", {3, -1, 4, triangles, 0, NULL}, TF_BAD_COUNT},
    {"2^31 - 1 vertices", {3, INT_MAX, 4, triangles, 0, NULL}, TF_BAD_COUNT},
    {"triangles below 0", {3, 4, -1, triangles, 0, NULL}, TF_BAD_COUNT},
    {"2^31 - 1 triangles", {3, 4, INT_MAX, triangles, 0, NULL}, TF_BAD_COUNT},
    {"no list of triangles", {3, 4, 4, NULL, 0, NULL}, TF_BAD_COUNT},
    {"no triangles", {3, 4, 0, NULL, 0, NULL}, TF_NO_ELEMENTS},
    {"an index of no vertex", {3, 4, 2, no_vertex, 0, NULL}, TF_BAD_INDEX},
    {"an index that repeats", {3, 4, 1, repeated, 0, NULL}, TF_BAD_INDEX},
    {"an edge of no triangle",
     {3, 4, 4, triangles, 1, one_edge},
     TF_EDGE_NOT_MANIFOLD},
    {"an edge passed twice in one direction",
     {3, 4, 2, two_ways, 0, NULL},
     TF_EDGE_NOT_MANIFOLD},
};

START_TEST(meshes_are_surfaces)
{
    for (int i = 0; i < COUNT(meshes); i++) {
        tf_adaptive_surface *made = surface;
        tf_error error;
        tf_status status =
            tf_adaptive_create(&meshes[i].mesh, position, &made, &error);
        expect_error(meshes[i].what, status, meshes[i].expected, &error);
        ck_assert_msg(made == surface, "%s: a surface", meshes[i].what);
    }
}
END_TEST

// Around what is wrong with a surface there is one, but not without triangles.
START_TEST(meshes_with_defects_are_surfaces)
{
    for (int i = 0; i < COUNT(meshes); i++) {
        bool defective = meshes[i].mesh.edges == 0 &&
                         meshes[i].expected == TF_EDGE_NOT_MANIFOLD;
        tf_adaptive_surface *made = NULL;
        tf_error error;
        tf_status status = tf_adaptive_create_around(&meshes[i].mesh, position,
                                                     &made, NULL, &error);
        expect_error(meshes[i].what, status,
                     defective ? TF_OK : meshes[i].expected, &error);
        ck_assert_int_eq(made != NULL, defective);
        tf_adaptive_free(made);
    }
}
END_TEST

START_TEST(positions_are_finite)
{
    static const double bad[] = {NAN, INFINITY, -INFINITY};
    for (int k = 0; k < COUNT(bad); k++) {
        tf_adaptive_surface *made;
        tf_error error;
        double x[3 * VERTICES];
        memcpy(x, position, sizeof x);
        x[7] = bad[k];
        tf_status status = tf_adaptive_create(&mesh, x, &made, &error);
        expect_error("positions", status, TF_NOT_FINITE, &error);
        ck_assert_int_eq(error.vertex[0], 2);
    }
}
END_TEST

// Operations ------------------------------------------------------------------

/// Operations on vertices, and a position, which some of them ignore.
typedef tf_status operation_call(const int v[3], const double x[9],
                                 tf_outcome *outcome);

static tf_status split(const int v[3], const double x[9], tf_outcome *outcome)
{
    int vertex;
    return tf_adaptive_split(surface, v[0], v[1], x, &vertex, outcome);
}

static tf_status move(const int v[3], const double x[9], tf_outcome *outcome)
{
    return tf_adaptive_move(surface, v[0], x, outcome);
}

static tf_status collapse(const int v[3], const double x[9],
                          tf_outcome *outcome)
{
    (void)x;
    return tf_adaptive_collapse(surface, v[0], v[1], outcome);
}

static tf_status collapse_to(const int v[3], const double x[9],
                             tf_outcome *outcome)
{
    return tf_adaptive_collapse_to(surface, v[0], v[1], x, outcome);
}

static tf_status flip(const int v[3], const double x[9], tf_outcome *outcome)
{
    (void)x;
    return tf_adaptive_flip(surface, v[0], v[1], outcome);
}

static tf_status merge(const int v[3], const double x[9], tf_outcome *outcome)
{
    static const int other[] = {2, 3};
    (void)x;
    return tf_adaptive_merge(surface, v, other, outcome);
}

static tf_status pinch(const int v[3], const double x[9], tf_outcome *outcome)
{
    int vertex[3];
    return tf_adaptive_pinch(surface, v, x, vertex, outcome);
}

static tf_status drop(const int v[3], const double x[9], tf_outcome *outcome)
{
    (void)x;
    return tf_adaptive_drop(surface, v[0], outcome);
}

static const struct {
    const char *name;
    operation_call *call;
    int vertices;   ///< of which each may be bad
    bool positions; ///< whether it takes any
} operations[] = {
    {"tf_adaptive_split", split, 2, true},
    {"tf_adaptive_move", move, 1, true},
    {"tf_adaptive_collapse", collapse, 2, false},
    {"tf_adaptive_collapse_to", collapse_to, 2, true},
    {"tf_adaptive_flip", flip, 2, false},
    {"tf_adaptive_merge", merge, 2, false},
    {"tf_adaptive_pinch", pinch, 3, true},
    {"tf_adaptive_drop", drop, 1, false},
};

static void expect_refused(int which, const int v[3], const double x[9],
                           tf_status expected)
{
    tf_outcome outcome = TF_COMMITTED;
    tf_status status = operations[which].call(v, x, &outcome);
    ck_assert_msg(status == expected, "%s: \"%s\"", operations[which].name,
                  tf_status_message(status));
    ck_assert_msg(outcome == TF_NO_OUTCOME, "%s: an outcome",
                  operations[which].name);
    ck_assert_mem_eq(tf_adaptive_positions(surface), position, sizeof position);
}

START_TEST(operations_are_about_vertices)
{
    static const int bad[] = {-1, INT_MIN, VERTICES, INT_MAX};
    static const double x[9] = {0};
    for (int i = 0; i < operations[_i].vertices; i++)
        for (int k = 0; k < COUNT(bad); k++) {
            int v[] = {0, 1, 2};
            v[i] = bad[k];
            expect_refused(_i, v, x, TF_BAD_INDEX);
        }
}
END_TEST

START_TEST(operations_lead_to_finite_positions)
{
    static const double bad[] = {NAN, INFINITY, -INFINITY};
    static const int v[] = {0, 1, 2};
    for (int k = 0; k < COUNT(bad) && operations[_i].positions; k++) {
        const double x[9] = {0, 0, bad[k]};
        expect_refused(_i, v, x, TF_NOT_FINITE);
    }
}
END_TEST

// Long calls ------------------------------------------------------------------

/// What the long calls can get wrong.
typedef struct choices {
    size_t size;
    double edge;
    tf_progress *progress;
    const tf_parallel *parallel;
} choices;

typedef tf_status long_call(const choices *with, tf_error *error);

static tf_status remesh(const choices *with, tf_error *error)
{
    tf_remesh_options options = {
        .size = with->size, .edge = with->edge, .progress = with->progress};
    return tf_adaptive_remesh(surface, &options, NULL, error);
}

static tf_status reconnect(const choices *with, tf_error *error)
{
    tf_reconnect_options options = {
        .size = with->size, .edge = with->edge, .progress = with->progress};
    return tf_adaptive_reconnect(surface, &options, NULL, error);
}

static void stand_still(void *context, double time, int points,
                        const double point[], const double normal[],
                        double velocity[])
{
    (void)context;
    (void)time;
    (void)point;
    (void)normal;
    memset(velocity, 0, 3 * sizeof *velocity * (size_t)points);
}

static tf_status flow_on(const choices *with, tf_error *error)
{
    tf_flow_options options = {.size = with->size,
                               .edge = with->edge,
                               .velocity = stand_still,
                               .parallel = with->parallel,
                               .progress = with->progress};
    return tf_flow_step(flow, 0, 1, &options, NULL, error);
}

static const struct {
    const char *name;
    long_call *call;
    bool counts; ///< whether it counts triangles of that length before
} long_calls[] = {
    {"tf_adaptive_remesh", remesh, true},
    {"tf_adaptive_reconnect", reconnect, false},
    {"tf_flow_step", flow_on, true},
};

static void expect_bad_option(int which, const choices *with,
                              const char *option)
{
    tf_error error;
    tf_status status = long_calls[which].call(with, &error);
    expect_error(long_calls[which].name, status, TF_BAD_OPTION, &error);
    ck_assert_str_eq(error.option, option);
    ck_assert_mem_eq(tf_adaptive_positions(surface), position, sizeof position);
}

START_TEST(lengths_of_edges_are_above_0)
{
    static const double bad[] = {0, -0.0, -1, NAN, INFINITY, -INFINITY};
    for (int k = 0; k < COUNT(bad); k++)
        expect_bad_option(_i, &(choices){.edge = bad[k]}, "edge");
    if (long_calls[_i].counts) {
        expect_bad_option(_i, &(choices){.edge = 1e-5}, "edge");
        expect_bad_option(_i, &(choices){.edge = 0x1p-1074}, "edge");
    }
}
END_TEST

START_TEST(sizes_are_those_of_options)
{
    static const size_t bad[] = {1, 8, (size_t)-1, (size_t)1 << 40};
    for (int k = 0; k < COUNT(bad); k++)
        expect_bad_option(_i, &(choices){.size = bad[k], .edge = 1}, "size");
}
END_TEST

static bool cancel(void *context, const tf_stage *stage)
{
    (void)context;
    (void)stage;
    return false;
}

START_TEST(long_calls_can_be_cancelled)
{
    tf_error error;
    choices with = {.edge = 0.1, .progress = cancel};
    tf_status status = long_calls[_i].call(&with, &error);
    expect_error(long_calls[_i].name, status, TF_CANCELLED, &error);
    ck_assert_mem_eq(tf_adaptive_positions(surface), position, sizeof position);
}
END_TEST

START_TEST(coordinates_can_be_measured)
{
    static const double far[] = {0, 0, -0x1p1001};
    tf_outcome outcome;
    tf_error error;
    choices with = {.edge = 1};
    ck_assert_int_eq(tf_adaptive_move(surface, 0, far, &outcome), TF_OK);
    ck_assert_int_eq(outcome, TF_COMMITTED);
    tf_status status = long_calls[_i].call(&with, &error);
    expect_error(long_calls[_i].name, status, TF_OUT_OF_RANGE, &error);
    ck_assert_int_eq(error.vertex[0], 0);
}
END_TEST

static void run_all(void *context, int count, tf_task *run, void *argument)
{
    (void)context;
    for (int task = 0; task < count; task++)
        run(argument, task, 0);
}

START_TEST(workers_of_flows_are_from_1_to_4096)
{
    static const int bad[] = {0, -1, 4097, INT_MAX, INT_MIN};
    for (int k = 0; k < COUNT(bad); k++) {
        tf_parallel parallel = {bad[k], run_all, NULL};
        choices with = {.edge = 1, .parallel = &parallel};
        expect_bad_option(2, &with, "parallel.workers");
    }
}
END_TEST

START_TEST(steps_lead_to_finite_positions)
{
    static const double bad[] = {NAN, INFINITY, -INFINITY};
    tf_flow_options options = {
        .edge = 1, .velocity = stand_still, .keep_topology = true};
    for (int k = 0; k < COUNT(bad); k++) {
        tf_error error;
        tf_status status =
            tf_flow_step(flow, 0, bad[k], &options, NULL, &error);
        expect_error("a step", status, TF_NOT_FINITE, &error);
    }
}
END_TEST

START_TEST(shares_of_an_edge_are_finite)
{
    const struct {
        const char *option;
        tf_reconnect_options options;
    } bad[] = {
        {"merge", {.edge = 1, .merge = NAN}},
        {"patch", {.edge = 1, .patch = INFINITY}},
        {"pinch", {.edge = 1, .pinch = -INFINITY}},
        {"drop", {.edge = 1, .drop = NAN}},
    };
    for (int i = 0; i < COUNT(bad); i++) {
        tf_error error;
        tf_status status =
            tf_adaptive_reconnect(surface, &bad[i].options, NULL, &error);
        expect_error(bad[i].option, status, TF_BAD_OPTION, &error);
        ck_assert_str_eq(error.option, bad[i].option);
    }
}
END_TEST

// Null pointers ---------------------------------------------------------------

START_TEST(null_is_allowed_where_the_header_says_so)
{
    const tf_remesh_options remeshing = {.edge = 1};
    const tf_reconnect_options reconnecting = {.edge = 1};
    tf_adaptive_free(NULL);
    tf_flow_free(NULL);
    ck_assert_ptr_null(tf_adaptive_origins(surface));
    ck_assert_ptr_null(tf_adaptive_corner_origins(surface));
    ck_assert_int_eq(tf_adaptive_compact(surface, NULL), TF_OK);
    ck_assert_int_eq(tf_adaptive_remesh(surface, &remeshing, NULL, NULL),
                     TF_OK);
    ck_assert_int_eq(tf_adaptive_reconnect(surface, &reconnecting, NULL, NULL),
                     TF_OK);
    ck_assert_int_eq(flow_on(&(choices){.edge = 1}, NULL), TF_OK);
}
END_TEST

static void create_without(int null)
{
    tf_adaptive_surface *made;
    tf_adaptive_create(GIVEN(0, &mesh), GIVEN(1, position), GIVEN(2, &made),
                       NULL);
}

static void tell_without(int null)
{
    tf_adaptive_mesh(GIVEN(0, surface));
    tf_adaptive_positions(GIVEN(1, surface));
    tf_adaptive_memory(GIVEN(2, surface));
    tf_adaptive_origins(GIVEN(3, surface));
    tf_adaptive_compact(GIVEN(4, surface), NULL);
    tf_flow_memory(GIVEN(5, flow));
    tf_adaptive_corner_origins(GIVEN(6, surface));
}

static void split_without(int null)
{
    int vertex;
    tf_outcome outcome;
    tf_adaptive_split(GIVEN(0, surface), 0, 1, GIVEN(1, position),
                      GIVEN(2, &vertex), GIVEN(3, &outcome));
}

static void move_without(int null)
{
    tf_outcome outcome;
    tf_adaptive_move(GIVEN(0, surface), 0, GIVEN(1, position),
                     GIVEN(2, &outcome));
}

static void collapse_without(int null)
{
    tf_outcome outcome;
    tf_adaptive_collapse(GIVEN(0, surface), 0, 1, GIVEN(1, &outcome));
}

static void collapse_to_without(int null)
{
    tf_outcome outcome;
    tf_adaptive_collapse_to(GIVEN(0, surface), 0, 1, GIVEN(1, position),
                            GIVEN(2, &outcome));
}

static void flip_without(int null)
{
    tf_outcome outcome;
    tf_adaptive_flip(GIVEN(0, surface), 0, 1, GIVEN(1, &outcome));
}

static void merge_without(int null)
{
    tf_outcome outcome;
    tf_adaptive_merge(GIVEN(0, surface), GIVEN(1, triangles),
                      GIVEN(2, triangles + 3), GIVEN(3, &outcome));
}

static void pinch_without(int null)
{
    int vertex[3];
    tf_outcome outcome;
    tf_adaptive_pinch(GIVEN(0, surface), GIVEN(1, triangles),
                      GIVEN(2, position), GIVEN(3, vertex), GIVEN(4, &outcome));
}

static void drop_without(int null)
{
    tf_outcome outcome;
    tf_adaptive_drop(GIVEN(0, surface), 0, GIVEN(1, &outcome));
}

static void long_call_without(int null)
{
    const tf_remesh_options remeshing = {.edge = 1};
    const tf_reconnect_options reconnecting = {.edge = 1};
    tf_adaptive_remesh(GIVEN(0, surface), GIVEN(1, &remeshing), NULL, NULL);
    tf_adaptive_reconnect(GIVEN(2, surface), GIVEN(3, &reconnecting), NULL,
                          NULL);
}

static void flow_without(int null)
{
    tf_flow *made;
    tf_flow_options options = {.edge = 1,
                               .velocity = null == 4 ? NULL : stand_still};
    tf_flow_step(GIVEN(0, flow), 0, 1, GIVEN(1, &options), NULL, NULL);
    tf_flow_create(GIVEN(2, surface), GIVEN(3, &made));
}

static const null_call null_calls[] = {
    {create_without, 3}, {tell_without, 7},      {split_without, 4},
    {move_without, 3},   {collapse_without, 2},  {collapse_to_without, 3},
    {flip_without, 2},   {merge_without, 4},     {pinch_without, 5},
    {drop_without, 2},   {long_call_without, 4}, {flow_without, 5},
    {NULL, 0},
};

Suite *suite(void)
{
    Suite *misuse = suite_create("whole/adaptive_misuse");
    TCase *c = tcase_create("statuses");
    tcase_add_checked_fixture(c, begin, finish);
    tcase_add_test(c, meshes_are_surfaces);
    tcase_add_test(c, meshes_with_defects_are_surfaces);
    tcase_add_test(c, positions_are_finite);
    tcase_add_loop_test(c, operations_are_about_vertices, 0, COUNT(operations));
    tcase_add_loop_test(c, operations_lead_to_finite_positions, 0,
                        COUNT(operations));
    tcase_add_loop_test(c, lengths_of_edges_are_above_0, 0, COUNT(long_calls));
    tcase_add_loop_test(c, sizes_are_those_of_options, 0, COUNT(long_calls));
    tcase_add_loop_test(c, long_calls_can_be_cancelled, 0, COUNT(long_calls));
    tcase_add_loop_test(c, coordinates_can_be_measured, 0, COUNT(long_calls));
    tcase_add_test(c, workers_of_flows_are_from_1_to_4096);
    tcase_add_test(c, steps_lead_to_finite_positions);
    tcase_add_test(c, shares_of_an_edge_are_finite);
    tcase_add_test(c, null_is_allowed_where_the_header_says_so);
    suite_add_tcase(misuse, c);

    TCase *contracts = tcase_create("contracts");
    tcase_add_checked_fixture(contracts, begin, finish);
    add_null_calls(contracts, null_calls);
    suite_add_tcase(misuse, contracts);
    return misuse;
}
