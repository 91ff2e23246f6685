// What callers get wrong, by the header that they see: each mistake has its
// status, and a null pointer breaks the contract unless the header allows it.
#include "support/misuse.h"

#include <limits.h>
#include <math.h>
#include <string.h>
#include <tanglefree.h>

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))

/// A triangle, and a point that falls through it.
enum {
    VERTICES = 4
};
static const double start[] = {0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, 1};
static const double end[] = {0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, -1};
static const int triangle[] = {0, 1, 2};

/// The same in the plane: an edge, and a point beside it.
static const double plane_start[] = {0, 0, 4, 0, 1, 1, 1, 2};
static const double plane_end[] = {0, 0, 4, 0, 1, -1, 1, 3};
static const int edge[] = {0, 1};

static tf_motion motion_of(int axes)
{
    if (axes == 2)
        return (tf_motion){2, VERTICES, plane_start, plane_end};
    return (tf_motion){3, VERTICES, start, end};
}

static const tf_mesh mesh = {
    .axes = 3, .vertices = VERTICES, .triangles = 1, .triangle = triangle};
static const tf_mesh curve = {
    .axes = 2, .vertices = VERTICES, .edges = 1, .edge = edge};

static tf_surface *surface, *plane;
static tf_resolver *resolver;

static void begin(void)
{
    ck_assert_int_eq(tf_surface_create(&mesh, &surface, NULL), TF_OK);
    ck_assert_int_eq(tf_surface_create(&curve, &plane, NULL), TF_OK);
    ck_assert_int_eq(tf_resolver_create(surface, &resolver), TF_OK);
}

static void finish(void)
{
    tf_resolver_free(resolver);
    tf_surface_free(surface);
    tf_surface_free(plane);
    ck_assert_uint_eq(tf_memory_in_use(), 0);
}

// Motions ---------------------------------------------------------------------

/// Functions that take a motion; those without an error set its status.
typedef tf_status motion_call(const tf_motion *motion, tf_error *error);

static tf_status ask_point_edge(const tf_motion *motion, tf_error *error)
{
    tf_contact contact;
    return error->status = tf_point_edge(&tf_exact, motion, 2, edge, &contact);
}

static tf_status ask_point_triangle(const tf_motion *motion, tf_error *error)
{
    tf_contact contact;
    return error->status =
               tf_point_triangle(&tf_exact, motion, 3, triangle, &contact);
}

static tf_status ask_edge_edge(const tf_motion *motion, tf_error *error)
{
    static const int other[] = {2, 3};
    tf_contact contact;
    return error->status =
               tf_edge_edge(&tf_exact, motion, edge, other, &contact);
}

static tf_status ask_quadratic(const tf_motion *motion, tf_error *error)
{
    tf_contact contact;
    return error->status = tf_quadratic_point_edge(&(tf_tolerances){0}, motion,
                                                   2, edge, &contact);
}

static tf_status ask_cubic(const tf_motion *motion, tf_error *error)
{
    tf_contact contact;
    return error->status = tf_cubic_point_triangle(&(tf_tolerances){0}, motion,
                                                   3, triangle, &contact);
}

static tf_status ask_additive_edge(const tf_motion *motion, tf_error *error)
{
    tf_contact contact;
    return error->status = tf_additive_point_edge(
               &(tf_advance_limits){0}, motion, 2, edge, &contact, NULL);
}

static tf_status ask_additive_triangle(const tf_motion *motion, tf_error *error)
{
    tf_contact contact;
    return error->status = tf_additive_point_triangle(
               &(tf_advance_limits){0}, motion, 3, triangle, &contact, NULL);
}

static tf_status decide(const tf_narrow_phase *narrow_phase, tf_kind kind,
                        const tf_motion *motion)
{
    static const int vertices[] = {2, 0, 1, 3};
    tf_queries queries = {kind, motion, 1, vertices};
    tf_verdict verdict;
    size_t separated = 0;
    return narrow_phase->decide(narrow_phase->context, &tf_exact, &queries,
                                &verdict, &separated);
}

static tf_status decide_one(const tf_motion *motion, tf_error *error)
{
    return error->status = decide(&tf_reference, TF_POINT_TRIANGLE, motion);
}

static tf_status decide_by_vectors(const tf_motion *motion, tf_error *error)
{
    return error->status = decide(&tf_vectorized, TF_EDGE_EDGE, motion);
}

static tf_status decide_in_plane(const tf_motion *motion, tf_error *error)
{
    return error->status = decide(&tf_vectorized, TF_POINT_EDGE, motion);
}

/// By vectors, as there is a NULL for the arithmetic, or by the reference.
static tf_status answer(tf_kind kind, const tf_motion *motion, tf_error *error)
{
    static const int vertices[] = {2, 0, 1, 3};
    tf_queries queries = {kind, motion, 1, vertices};
    tf_contact contact;
    return tf_query_batch(NULL, &queries, NULL, &contact, error);
}

static tf_status answer_many(const tf_motion *motion, tf_error *error)
{
    return answer(TF_EDGE_EDGE, motion, error);
}

static tf_status answer_in_plane(const tf_motion *motion, tf_error *error)
{
    return answer(TF_POINT_EDGE, motion, error);
}

static tf_status detect(const tf_motion *motion, tf_error *error)
{
    tf_contacts found;
    return tf_surface_detect(surface, motion, NULL, &found, error);
}

static tf_status detect_in_plane(const tf_motion *motion, tf_error *error)
{
    tf_contacts found;
    return tf_surface_detect(plane, motion, NULL, &found, error);
}

static tf_status list(const tf_motion *motion, tf_error *error)
{
    tf_candidates found;
    return tf_surface_candidates(surface, motion, NULL, &found, error);
}

static const struct {
    const char *name;
    int axes;
    motion_call *ask;
    bool counts; ///< whether it must have as many vertices as the surface
} motion_calls[] = {
    {"tf_point_edge", 2, ask_point_edge, false},
    {"tf_point_triangle", 3, ask_point_triangle, false},
    {"tf_edge_edge", 3, ask_edge_edge, false},
    {"tf_quadratic_point_edge", 2, ask_quadratic, false},
    {"tf_cubic_point_triangle", 3, ask_cubic, false},
    {"tf_additive_point_edge", 2, ask_additive_edge, false},
    {"tf_additive_point_triangle", 3, ask_additive_triangle, false},
    {"tf_reference", 3, decide_one, false},
    {"tf_vectorized", 3, decide_by_vectors, false},
    {"tf_vectorized in the plane", 2, decide_in_plane, false},
    {"tf_query_batch", 3, answer_many, false},
    {"tf_query_batch in the plane", 2, answer_in_plane, false},
    {"tf_surface_detect", 3, detect, true},
    {"tf_surface_detect in the plane", 2, detect_in_plane, true},
    {"tf_surface_candidates", 3, list, true},
};

static void expect_motion(int which, const tf_motion *motion,
                          tf_status expected)
{
    tf_error error = {.status = TF_OK, .time = -1};
    tf_status status = motion_calls[which].ask(motion, &error);
    expect_error(motion_calls[which].name, status, expected, &error);
}

START_TEST(motions_are_as_they_say)
{
    static const int bad[] = {0, 1, 4, -1, -2, INT_MAX, INT_MIN};
    int axes = motion_calls[_i].axes;
    tf_motion good = motion_of(axes), other = motion_of(5 - axes);
    expect_motion(_i, &good, TF_OK);
    expect_motion(_i, &other, TF_BAD_AXES);
    expect_motion(_i, &(tf_motion){0}, TF_BAD_AXES);
    for (int k = 0; k < COUNT(bad); k++) {
        tf_motion motion = good;
        motion.axes = bad[k];
        expect_motion(_i, &motion, TF_BAD_AXES);
    }
}
END_TEST

START_TEST(motions_have_what_they_count)
{
    static const int bad[] = {-1, INT_MIN, 0, 3, 5, INT_MAX};
    const tf_motion good = motion_of(motion_calls[_i].axes);
    tf_motion no_start = good, no_end = good;
    no_start.start = NULL;
    no_end.end = NULL;
    expect_motion(_i, &no_start, TF_BAD_COUNT);
    expect_motion(_i, &no_end, TF_BAD_COUNT);
    for (int k = 0; k < (motion_calls[_i].counts ? COUNT(bad) : 2); k++) {
        tf_motion motion = good;
        motion.vertices = bad[k];
        expect_motion(_i, &motion, TF_BAD_COUNT);
    }
}
END_TEST

// Indices ---------------------------------------------------------------------

START_TEST(queries_are_of_vertices)
{
    static const int bad[] = {-1, INT_MIN, VERTICES, INT_MAX, 1};
    tf_motion space = motion_of(3), flat = motion_of(2);
    tf_contact contact;
    for (int k = 0; k < COUNT(bad); k++) {
        const int one[] = {1, bad[k]}, corners[] = {1, 2, bad[k]};
        ck_assert_int_eq(tf_point_edge(&tf_exact, &flat, 0, one, &contact),
                         TF_BAD_INDEX);
        ck_assert_int_eq(
            tf_point_edge(&tf_exact, &flat, bad[k], edge, &contact),
            TF_BAD_INDEX);
        ck_assert_int_eq(
            tf_point_triangle(&tf_exact, &space, 0, corners, &contact),
            TF_BAD_INDEX);
        ck_assert_int_eq(
            tf_edge_edge(&tf_exact, &space, one, corners + 1, &contact),
            TF_BAD_INDEX);
    }
}
END_TEST

START_TEST(kinds_are_those_that_there_are)
{
    static const int bad[] = {TF_NO_KIND, TF_EDGE_EDGE + 1, -1, INT_MAX,
                              INT_MIN};
    tf_motion motion = motion_of(3);
    for (int k = 0; k < COUNT(bad); k++) {
        ck_assert_int_eq(decide(&tf_reference, (tf_kind)bad[k], &motion),
                         TF_BAD_OPTION);
        ck_assert_int_eq(decide(&tf_vectorized, (tf_kind)bad[k], &motion),
                         TF_BAD_OPTION);
        tf_error error;
        tf_status status = answer((tf_kind)bad[k], &motion, &error);
        expect_error("a kind", status, TF_BAD_OPTION, &error);
        ck_assert_str_eq(error.option, "kind");
    }
}
END_TEST

START_TEST(batches_are_of_vertices)
{
    static const int bad[] = {-1, INT_MIN, VERTICES, INT_MAX, 1};
    tf_motion motion = motion_of(3);
    for (int k = 0; k < COUNT(bad); k++) {
        const int vertices[] = {0, 1, 2, 3, 0, 1, 2, bad[k]};
        tf_queries queries = {TF_POINT_TRIANGLE, &motion, 2, vertices};
        tf_contact contact[2];
        tf_error error;
        tf_status status =
            tf_query_batch(NULL, &queries, NULL, contact, &error);
        expect_error("a batch", status, TF_BAD_INDEX, &error);
        ck_assert_uint_eq(error.index, 1);
        ck_assert_int_eq(error.vertex[0], bad[k]);
    }
}
END_TEST

START_TEST(batches_have_what_they_count)
{
    static const int vertices[] = {0, 1, 2, 3};
    static const size_t bad[] = {(size_t)-1, (size_t)-1 / 16, (size_t)-1 / 128};
    tf_motion motion = motion_of(3);
    tf_queries queries = {TF_EDGE_EDGE, &motion, 1, NULL};
    tf_contact contact;
    tf_error error;
    tf_status status = tf_query_batch(NULL, &queries, NULL, &contact, &error);
    expect_error("no list", status, TF_BAD_COUNT, &error);
    queries.vertices = vertices;
    for (int k = 0; k < COUNT(bad); k++) {
        queries.count = bad[k];
        status = tf_query_batch(NULL, &queries, NULL, &contact, &error);
        expect_error("many queries", status, TF_BAD_COUNT, &error);
    }
}
END_TEST

START_TEST(arithmetics_have_bits_for_two_axes_and_three)
{
    static const int bad[] = {0, 1, 4, -1, INT_MAX, INT_MIN};
    for (int k = 0; k < COUNT(bad); k++)
        ck_assert_int_eq(tf_arithmetic_bits(&tf_integer64, bad[k]), -1);
    ck_assert_int_eq(tf_arithmetic_bits(&tf_integer64, 3), 19);
    ck_assert_ptr_null(tf_arithmetic_named("no such arithmetic"));
}
END_TEST

START_TEST(rigid_positions_are_of_vertices)
{
    static const int bad[] = {0, 1, 4, -1, INT_MAX, INT_MIN};
    tf_rigid_body body = {.vertices = start};
    double x[3];
    for (int k = 0; k < COUNT(bad); k++)
        ck_assert_int_eq(tf_rigid_position(bad[k], &body, 0, 0.5, x),
                         TF_BAD_AXES);
    ck_assert_int_eq(tf_rigid_position(3, &body, -1, 0.5, x), TF_BAD_INDEX);
    ck_assert_int_eq(tf_rigid_position(3, &body, 0, NAN, x), TF_NOT_FINITE);
}
END_TEST

// Meshes ----------------------------------------------------------------------

static const int no_vertex[] = {0, 1, VERTICES}, repeated[] = {0, 1, 1};

static const struct {
    const char *what;
    tf_mesh mesh;
    tf_status expected;
} meshes[] = {
    {"all zero", {0}, TF_BAD_AXES},
    {"no axes", {0, 4, 1, triangle, 0, NULL}, TF_BAD_AXES},
    {"one axis", {1, 4, 1, triangle, 0, NULL}, TF_BAD_AXES},
    {"four axes", {4, 4, 1, triangle, 0, NULL}, TF_BAD_AXES},
    {"axes below 0", {-3, 4, 1, triangle, 0, NULL}, TF_BAD_AXES},
    {"as many axes as there are ints",
     {INT_MAX, 4, 1, triangle, 0, NULL},
     TF_BAD_AXES},
    {"vertices below 0", {3, -1, 1, triangle, 0, NULL}, TF_BAD_COUNT},
    {"the least int of vertices",
     {3, INT_MIN, 1, triangle, 0, NULL},
     TF_BAD_COUNT},
    {"2^31 - 1 vertices", {3, INT_MAX, 1, triangle, 0, NULL}, TF_BAD_COUNT},
    {"triangles below 0", {3, 4, -1, triangle, 0, NULL}, TF_BAD_COUNT},
    {"the least int of triangles",
     {3, 4, INT_MIN, triangle, 0, NULL},
     TF_BAD_COUNT},
    {"2^31 - 1 triangles", {3, 4, INT_MAX, triangle, 0, NULL}, TF_BAD_COUNT},
    {"no list of triangles", {3, 4, 1, NULL, 0, NULL}, TF_BAD_COUNT},
    {"no elements", {3, 4, 0, NULL, 0, NULL}, TF_NO_ELEMENTS},
    {"nothing", {3, 0, 0, NULL, 0, NULL}, TF_NO_ELEMENTS},
    {"an index of no vertex", {3, 4, 1, no_vertex, 0, NULL}, TF_BAD_INDEX},
    {"triangles without vertices", {3, 0, 1, triangle, 0, NULL}, TF_BAD_INDEX},
    {"an index that repeats", {3, 4, 1, repeated, 0, NULL}, TF_BAD_INDEX},
};

static const struct {
    const char *what;
    tf_mesh mesh;
    tf_status expected;
} curves[] = {
    {"triangles in the plane", {2, 4, 1, triangle, 0, NULL}, TF_BAD_AXES},
    {"edges below 0", {2, 4, 0, NULL, -1, edge}, TF_BAD_COUNT},
    {"the least int of edges", {2, 4, 0, NULL, INT_MIN, edge}, TF_BAD_COUNT},
    {"2^31 - 1 edges", {2, 4, 0, NULL, INT_MAX, edge}, TF_BAD_COUNT},
    {"no list of edges", {2, 4, 0, NULL, 1, NULL}, TF_BAD_COUNT},
    {"no edges", {2, 4, 0, NULL, 0, NULL}, TF_NO_ELEMENTS},
    {"an edge of no vertex", {2, 1, 0, NULL, 1, edge}, TF_BAD_INDEX},
    {"an edge of one vertex", {2, 4, 0, NULL, 1, repeated + 1}, TF_BAD_INDEX},
};

static void expect_mesh(const char *what, const tf_mesh *bad,
                        tf_status expected)
{
    tf_surface *made = surface;
    tf_error error;
    tf_status status = tf_surface_create(bad, &made, &error);
    expect_error(what, status, expected, &error);
    ck_assert_msg(made == surface, "%s: a surface without success", what);
}

START_TEST(meshes_are_as_they_say)
{
    for (int i = 0; i < COUNT(meshes); i++)
        expect_mesh(meshes[i].what, &meshes[i].mesh, meshes[i].expected);
    for (int i = 0; i < COUNT(curves); i++)
        expect_mesh(curves[i].what, &curves[i].mesh, curves[i].expected);
}
END_TEST

// Counts and positions --------------------------------------------------------

/// Functions that take as many positions as the surface has vertices.
typedef tf_status position_call(int vertices, const double position[],
                                tf_error *error);

static tf_status check(int vertices, const double position[], tf_error *error)
{
    tf_crossings found;
    return tf_surface_check(surface, vertices, position, NULL, &found, error);
}

static tf_status measure(int vertices, const double position[], tf_error *error)
{
    tf_near_pairs found;
    return tf_surface_near(surface, vertices, position, 1, NULL, &found, error);
}

static tf_status find_nearest(int vertices, const double position[],
                              tf_error *error)
{
    static const double point[] = {1, 2, 3};
    tf_surface_point found;
    return tf_surface_nearest(surface, vertices, position, point, &found,
                              error);
}

static tf_status resolve(int vertices, const double position[], tf_error *error)
{
    double to[3 * VERTICES];
    memcpy(to, end, sizeof to);
    return tf_step_resolve(resolver, vertices, position, to, NULL, NULL, NULL,
                           error);
}

static tf_status limit(int vertices, const double position[], tf_error *error)
{
    double to[3 * VERTICES];
    int halvings;
    memcpy(to, end, sizeof to);
    return tf_step_limit(resolver, vertices, position, to, NULL, &halvings,
                         error);
}

static tf_status untangle(int vertices, const double position[],
                          tf_error *error)
{
    double to[3 * VERTICES];
    return tf_untangle(resolver, vertices, position, to, NULL, NULL, NULL,
                       error);
}

static tf_status find_zones(int vertices, const double position[],
                            tf_error *error)
{
    int zone[3 * VERTICES];
    return tf_surface_zones(surface, vertices, position, 0, NULL, zone, NULL,
                            NULL, error);
}

static const struct {
    const char *name;
    position_call *call;
} position_calls[] = {
    {"tf_surface_check", check},
    {"tf_surface_near", measure},
    {"tf_surface_nearest", find_nearest},
    {"tf_step_resolve", resolve},
    {"tf_step_limit", limit},
    {"tf_untangle", untangle},
    {"tf_surface_zones", find_zones},
};

START_TEST(positions_are_of_all_vertices)
{
    static const int bad[] = {-1, 0, 1, 3, 5, INT_MAX, INT_MIN};
    const char *name = position_calls[_i].name;
    tf_error error;
    tf_status status = position_calls[_i].call(VERTICES, start, &error);
    expect_error(name, status, TF_OK, &error);
    for (int k = 0; k < COUNT(bad); k++) {
        status = position_calls[_i].call(bad[k], start, &error);
        expect_error(name, status, TF_BAD_COUNT, &error);
    }
}
END_TEST

START_TEST(positions_are_finite)
{
    static const double bad[] = {NAN, INFINITY, -INFINITY};
    for (int k = 0; k < COUNT(bad); k++) {
        double position[3 * VERTICES];
        tf_error error;
        memcpy(position, start, sizeof position);
        position[7] = bad[k];
        tf_status status = position_calls[_i].call(VERTICES, position, &error);
        expect_error(position_calls[_i].name, status, TF_NOT_FINITE, &error);
        ck_assert_int_eq(error.subject, TF_VERTEX);
        ck_assert_int_eq(error.vertex[0], 2);
    }
}
END_TEST

// Options ---------------------------------------------------------------------

/// Functions that take options, here a size, workers and a callback.
typedef tf_status option_call(size_t size, const tf_parallel *parallel,
                              tf_progress *progress, tf_error *error);

static tf_status detect_with(size_t size, const tf_parallel *parallel,
                             tf_progress *progress, tf_error *error)
{
    tf_motion motion = motion_of(3);
    tf_contacts found;
    tf_detect_options options = {
        .size = size, .parallel = parallel, .progress = progress};
    return tf_surface_detect(surface, &motion, &options, &found, error);
}

static tf_status list_with(size_t size, const tf_parallel *parallel,
                           tf_progress *progress, tf_error *error)
{
    tf_motion motion = motion_of(3);
    tf_candidates found;
    tf_detect_options options = {
        .size = size, .parallel = parallel, .progress = progress};
    return tf_surface_candidates(surface, &motion, &options, &found, error);
}

static tf_status check_with(size_t size, const tf_parallel *parallel,
                            tf_progress *progress, tf_error *error)
{
    tf_crossings found;
    tf_check_options options = {
        .size = size, .parallel = parallel, .progress = progress};
    return tf_surface_check(surface, VERTICES, start, &options, &found, error);
}

static tf_status measure_with(size_t size, const tf_parallel *parallel,
                              tf_progress *progress, tf_error *error)
{
    tf_near_pairs found;
    tf_check_options options = {
        .size = size, .parallel = parallel, .progress = progress};
    return tf_surface_near(surface, VERTICES, start, 1, &options, &found,
                           error);
}

static tf_status resolve_with(size_t size, const tf_parallel *parallel,
                              tf_progress *progress, tf_error *error)
{
    double to[3 * VERTICES];
    memcpy(to, end, sizeof to);
    tf_response_options options = {
        .size = size, .parallel = parallel, .progress = progress};
    return tf_step_resolve(resolver, VERTICES, start, to, NULL, &options, NULL,
                           error);
}

static tf_status limit_with(size_t size, const tf_parallel *parallel,
                            tf_progress *progress, tf_error *error)
{
    double to[3 * VERTICES];
    int halvings;
    memcpy(to, end, sizeof to);
    tf_response_options options = {
        .size = size, .parallel = parallel, .progress = progress};
    return tf_step_limit(resolver, VERTICES, start, to, &options, &halvings,
                         error);
}

static tf_status untangle_with(size_t size, const tf_parallel *parallel,
                               tf_progress *progress, tf_error *error)
{
    double to[3 * VERTICES];
    tf_untangle_options options = {
        .size = size, .parallel = parallel, .progress = progress};
    return tf_untangle(resolver, VERTICES, start, to, &options, NULL, NULL,
                       error);
}

static tf_status find_zones_with(size_t size, const tf_parallel *parallel,
                                 tf_progress *progress, tf_error *error)
{
    int zone[3 * VERTICES];
    tf_check_options options = {
        .size = size, .parallel = parallel, .progress = progress};
    return tf_surface_zones(surface, VERTICES, start, 0, &options, zone, NULL,
                            NULL, error);
}

static const struct {
    const char *name;
    option_call *call;
} option_calls[] = {
    {"tf_surface_detect", detect_with}, {"tf_surface_candidates", list_with},
    {"tf_surface_check", check_with},   {"tf_surface_near", measure_with},
    {"tf_step_resolve", resolve_with},  {"tf_step_limit", limit_with},
    {"tf_untangle", untangle_with},     {"tf_surface_zones", find_zones_with},
};

static void expect_bad_option(int which, size_t size,
                              const tf_parallel *parallel, const char *option)
{
    tf_error error;
    tf_status status = option_calls[which].call(size, parallel, NULL, &error);
    expect_error(option_calls[which].name, status, TF_BAD_OPTION, &error);
    ck_assert_int_eq(error.subject, TF_OPTION);
    ck_assert_str_eq(error.option, option);
    ck_assert_ptr_nonnull(error.range);
}

static void run_all(void *context, int count, tf_task *run, void *argument)
{
    (void)context;
    for (int task = 0; task < count; task++)
        run(argument, task, 0);
}

START_TEST(workers_are_from_1_to_4096)
{
    static const int bad[] = {0, -1, 4097, INT_MAX, INT_MIN};
    tf_parallel parallel = {1, run_all, NULL}, none = {1, NULL, NULL};
    tf_error error;
    tf_status status = option_calls[_i].call(0, &parallel, NULL, &error);
    expect_error(option_calls[_i].name, status, TF_OK, &error);
    expect_bad_option(_i, 0, &none, "parallel.for_each");
    for (int k = 0; k < COUNT(bad); k++) {
        parallel.workers = bad[k];
        expect_bad_option(_i, 0, &parallel, "parallel.workers");
    }
}
END_TEST

START_TEST(sizes_are_those_of_options)
{
    static const size_t bad[] = {1, 8, (size_t)-1, (size_t)1 << 40};
    for (int k = 0; k < COUNT(bad); k++)
        expect_bad_option(_i, bad[k], NULL, "size");
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
    tf_status status = option_calls[_i].call(0, NULL, cancel, &error);
    expect_error(option_calls[_i].name, status, TF_CANCELLED, &error);
}
END_TEST

START_TEST(selections_are_those_that_there_are)
{
    static const int bad[] = {-1, TF_ANY_CONTACT + 1, INT_MAX, INT_MIN};
    tf_motion motion = motion_of(3);
    tf_contacts found;
    tf_error error;
    for (int k = 0; k < COUNT(bad); k++) {
        tf_detect_options options = {.selection = (tf_contact_selection)bad[k]};
        tf_status status =
            tf_surface_detect(surface, &motion, &options, &found, &error);
        expect_error("a selection", status, TF_BAD_OPTION, &error);
        ck_assert_str_eq(error.option, "selection");
    }
}
END_TEST

START_TEST(filters_have_a_group_for_each_vertex_or_none)
{
    static const int groups[VERTICES] = {1, 1, 1, 2};
    static const int bad[] = {-1, 0, 3, 5, INT_MAX, INT_MIN};
    tf_pair_filter filter = {.vertices = VERTICES, .group = groups};
    tf_error error;
    tf_status status = tf_surface_set_filter(surface, &filter, &error);
    expect_error("a filter", status, TF_OK, &error);
    for (int k = 0; k < COUNT(bad); k++) {
        filter.vertices = bad[k];
        status = tf_surface_set_filter(surface, &filter, &error);
        expect_error("groups", status, TF_BAD_COUNT, &error);
    }
    filter = (tf_pair_filter){.vertices = VERTICES};
    status = tf_surface_set_filter(surface, &filter, &error);
    expect_error("no groups", status, TF_BAD_COUNT, &error);
    filter = (tf_pair_filter){.size = 1};
    status = tf_surface_set_filter(surface, &filter, &error);
    expect_error("a size", status, TF_BAD_OPTION, &error);
}
END_TEST

START_TEST(allocators_stay_while_memory_is_in_use)
{
    ck_assert_int_eq(tf_set_allocator(NULL, NULL, NULL), TF_IN_USE);
}
END_TEST

START_TEST(numbers_of_responses_are_in_their_ranges)
{
    const struct {
        const char *option;
        tf_response_options options;
    } bad[] = {
        {"restitution", {.restitution = -0.1}},
        {"restitution", {.restitution = 1.1}},
        {"restitution", {.restitution = NAN}},
        {"friction", {.friction = -0.1}},
        {"friction", {.friction = INFINITY}},
        {"friction", {.friction = NAN}},
        {"separation", {.separation = INFINITY}},
        {"separation", {.separation = NAN}},
    };
    for (int i = 0; i < COUNT(bad); i++) {
        double to[3 * VERTICES];
        tf_error error;
        memcpy(to, end, sizeof to);
        tf_status status = tf_step_resolve(resolver, VERTICES, start, to, NULL,
                                           &bad[i].options, NULL, &error);
        expect_error(bad[i].option, status, TF_BAD_OPTION, &error);
        ck_assert_str_eq(error.option, bad[i].option);
        ck_assert_mem_eq(to, end, sizeof to);
    }
}
END_TEST

START_TEST(masses_are_zero_or_more)
{
    static const double bad[] = {-1, -0x1p-1074, NAN, INFINITY, -INFINITY};
    for (int k = 0; k < COUNT(bad); k++) {
        const double masses[] = {1, 0, bad[k], 1};
        double to[3 * VERTICES];
        tf_error error;
        memcpy(to, end, sizeof to);
        tf_status status = tf_step_resolve(resolver, VERTICES, start, to,
                                           masses, NULL, NULL, &error);
        expect_error("a mass", status, TF_BAD_MASS, &error);
        ck_assert_int_eq(error.vertex[0], 2);
    }
}
END_TEST

START_TEST(friction_of_vertices_is_zero_or_more)
{
    static const double bad[] = {-1, -0x1p-1074, NAN, INFINITY, -INFINITY};
    for (int k = 0; k < COUNT(bad); k++) {
        const double own[] = {1, 0, bad[k], 1};
        const tf_response_options options = {.size = sizeof options,
                                             .vertex_friction = own};
        double to[3 * VERTICES];
        tf_error error;
        memcpy(to, end, sizeof to);
        tf_status status = tf_step_resolve(resolver, VERTICES, start, to, NULL,
                                           &options, NULL, &error);
        expect_error("friction", status, TF_BAD_OPTION, &error);
        ck_assert_str_eq(error.option, "vertex_friction");
        ck_assert_int_eq(error.vertex[0], 2);
        ck_assert_mem_eq(to, end, sizeof to);
    }
}
END_TEST

// Null pointers ---------------------------------------------------------------

START_TEST(null_is_allowed_where_the_header_says_so)
{
    tf_motion flat = motion_of(2);
    tf_contact contact;
    tf_verdict verdict;
    size_t separated = 0;
    tf_queries none = {.kind = TF_EDGE_EDGE};
    tf_surface_free(NULL);
    tf_resolver_free(NULL);
    tf_adaptive_free(NULL);
    tf_flow_free(NULL);
    ck_assert_uint_gt(tf_describe(&(tf_error){.time = -1}, NULL, 0), 0);
    ck_assert_int_eq(tf_filter_edge_edge(0, NULL, NULL), TF_OK);
    ck_assert_int_eq(tf_filter_point_triangle(0, NULL, NULL), TF_OK);
    ck_assert_int_eq(
        tf_reference.decide(NULL, &tf_exact, &none, &verdict, &separated),
        TF_OK);
    ck_assert_int_eq(
        tf_vectorized.decide(NULL, &tf_exact, &none, &verdict, &separated),
        TF_OK);
    ck_assert_int_eq(tf_query_batch(NULL, &none, NULL, NULL, NULL), TF_OK);
    ck_assert_int_eq(tf_surface_set_filter(surface, NULL, NULL), TF_OK);
    ck_assert_int_eq(tf_additive_point_edge(&(tf_advance_limits){0}, &flat, 2,
                                            edge, &contact, NULL),
                     TF_OK);
    ck_assert_int_eq(check(VERTICES, start, NULL), TF_OK);
    ck_assert_int_eq(resolve(VERTICES, start, NULL), TF_OK);
    ck_assert_int_eq(limit(VERTICES, start, NULL), TF_OK);
    ck_assert_int_eq(check(-1, start, NULL), TF_BAD_COUNT);
    tf_contract_set_handler(NULL);
}
END_TEST

static void query_without(int null)
{
    tf_motion motion = motion_of(3);
    tf_contact contact;
    tf_point_triangle(GIVEN(0, &tf_exact), GIVEN(1, &motion), 3,
                      GIVEN(2, triangle), GIVEN(3, &contact));
}

static void plane_query_without(int null)
{
    tf_motion motion = motion_of(2);
    tf_contact contact;
    tf_point_edge(GIVEN(0, &tf_exact), GIVEN(1, &motion), 3, GIVEN(2, edge),
                  GIVEN(3, &contact));
}

static void edge_query_without(int null)
{
    static const int other[] = {2, 3};
    tf_motion motion = motion_of(3);
    tf_contact contact;
    tf_edge_edge(GIVEN(0, &tf_exact), GIVEN(1, &motion), GIVEN(2, edge),
                 GIVEN(3, other), GIVEN(4, &contact));
}

static void cubic_without(int null)
{
    tf_motion motion = motion_of(3);
    tf_contact contact;
    tf_cubic_point_triangle(GIVEN(0, &(tf_tolerances){0}), GIVEN(1, &motion), 3,
                            GIVEN(2, triangle), GIVEN(3, &contact));
}

static void quadratic_without(int null)
{
    tf_motion motion = motion_of(2);
    tf_contact contact;
    tf_quadratic_point_edge(GIVEN(0, &(tf_tolerances){0}), GIVEN(1, &motion), 3,
                            GIVEN(2, edge), GIVEN(3, &contact));
}

static void additive_without(int null)
{
    tf_motion motion = motion_of(2);
    tf_contact contact;
    tf_additive_point_edge(GIVEN(0, &(tf_advance_limits){0}), GIVEN(1, &motion),
                           3, GIVEN(2, edge), GIVEN(3, &contact), NULL);
}

static void rigid_without(int null)
{
    tf_rigid_body body = {.vertices = start}, none = {.vertices = NULL};
    tf_advancement advancement;
    tf_advance_triangles(GIVEN(0, &(tf_advance_limits){0}), GIVEN(1, &body),
                         null == 2 ? &none : &body, GIVEN(3, &advancement));
}

static void position_without(int null)
{
    tf_rigid_body body = {.vertices = GIVEN(2, start)};
    double x[3];
    tf_rigid_position(3, GIVEN(0, &body), 0, 0, GIVEN(1, x));
}

static void decide_without(const tf_narrow_phase *narrow_phase, int null)
{
    static const int vertices[] = {0, 1, 2, 3};
    tf_motion motion = motion_of(3);
    tf_queries queries = {TF_EDGE_EDGE, GIVEN(2, &motion), 1,
                          GIVEN(3, vertices)};
    tf_verdict verdict;
    size_t separated = 0;
    narrow_phase->decide(NULL, GIVEN(0, &tf_exact), GIVEN(1, &queries),
                         GIVEN(4, &verdict), GIVEN(5, &separated));
}

static void narrow_phase_without(int null)
{
    decide_without(&tf_reference, null);
}

static void vectors_without(int null)
{
    decide_without(&tf_vectorized, null);
}

static void batch_without(int null)
{
    static const int vertices[] = {0, 1, 2, 3};
    tf_motion motion = motion_of(3);
    tf_queries queries = {TF_EDGE_EDGE, GIVEN(0, &motion), 1, vertices};
    tf_contact contact;
    tf_query_batch(NULL, GIVEN(1, &queries), NULL, GIVEN(2, &contact), NULL);
}

static void filter_without(int null)
{
    static const tf_query_block block;
    tf_query_masks masks;
    tf_filter_edge_edge(1, GIVEN(0, &block), GIVEN(1, &masks));
}

static void create_without(int null)
{
    tf_surface *made;
    tf_surface_create(GIVEN(0, &mesh), GIVEN(1, &made), NULL);
}

static void lend_without(int null)
{
    int count;
    tf_surface_edges(GIVEN(0, surface), GIVEN(1, &count));
}

static void lend_triangles_without(int null)
{
    int count;
    tf_surface_triangles(GIVEN(0, surface), GIVEN(1, &count));
}

static void tell_without(int null)
{
    tf_surface_axes(GIVEN(0, surface));
    tf_surface_vertices(GIVEN(1, surface));
    tf_surface_memory(GIVEN(2, surface));
    tf_resolver_memory(GIVEN(3, resolver));
    tf_arithmetic_name(GIVEN(4, &tf_exact));
    tf_arithmetic_bits(GIVEN(5, &tf_exact), 3);
    tf_arithmetic_named(GIVEN(6, "exact"));
    tf_describe(GIVEN(7, &(tf_error){0}), NULL, 0);
    tf_describe(&(tf_error){0}, NULL, null == 8);
    tf_surface_set_filter(GIVEN(9, surface), NULL, NULL);
}

static void *no_memory(void *context, size_t size)
{
    (void)context;
    (void)size;
    return NULL;
}

static void keep_memory(void *context, void *memory, size_t size)
{
    (void)context;
    (void)memory;
    (void)size;
}

static void allocator_without(int null)
{
    tf_set_allocator(GIVEN(0, no_memory), GIVEN(1, keep_memory), NULL);
}

static void detect_without(int null)
{
    tf_motion motion = motion_of(3);
    tf_contacts found;
    tf_surface_detect(GIVEN(0, surface), GIVEN(1, &motion), NULL,
                      GIVEN(2, &found), NULL);
}

static void list_without(int null)
{
    tf_motion motion = motion_of(3);
    tf_candidates found;
    tf_surface_candidates(GIVEN(0, surface), GIVEN(1, &motion), NULL,
                          GIVEN(2, &found), NULL);
}

static void check_without(int null)
{
    tf_crossings found;
    tf_surface_check(GIVEN(0, surface), VERTICES, GIVEN(1, start), NULL,
                     GIVEN(2, &found), NULL);
}

static void measure_without(int null)
{
    tf_near_pairs found;
    tf_surface_near(GIVEN(0, surface), VERTICES, GIVEN(1, start), 1, NULL,
                    GIVEN(2, &found), NULL);
}

static void find_nearest_without(int null)
{
    tf_surface_point found;
    tf_surface_nearest(GIVEN(0, surface), VERTICES, GIVEN(1, start),
                       GIVEN(2, start), GIVEN(3, &found), NULL);
}

static void distance_without(int null)
{
    static const int vertex[] = {0, 1, 2, 3};
    tf_nearest nearest;
    tf_distance(TF_EDGE_EDGE, VERTICES, GIVEN(0, start), GIVEN(1, vertex),
                GIVEN(2, &nearest));
}

static void nearer_without(int null)
{
    static const int vertex[] = {0, 1, 2, 3};
    bool nearer;
    tf_is_nearer(TF_EDGE_EDGE, VERTICES, GIVEN(0, start), GIVEN(1, vertex), 1,
                 GIVEN(2, &nearer));
}

static void resolver_without(int null)
{
    tf_resolver *made;
    tf_resolver_create(GIVEN(0, surface), GIVEN(1, &made));
}

static void resolve_without(int null)
{
    double to[3 * VERTICES] = {0};
    tf_step_resolve(GIVEN(0, resolver), VERTICES, GIVEN(1, start), GIVEN(2, to),
                    NULL, NULL, NULL, NULL);
}

static void contacts_without(int null)
{
    size_t count;
    const tf_answered_contact *contact;
    tf_resolver_contacts(GIVEN(0, resolver), GIVEN(1, &count),
                         GIVEN(2, &contact));
    tf_resolver_vertices(GIVEN(3, resolver));
    const double *push;
    tf_resolver_pushes(GIVEN(4, resolver), GIVEN(5, &count), GIVEN(6, &push));
    tf_resolver_unpushed(GIVEN(7, resolver));
    tf_resolver_followed(GIVEN(8, resolver));
}

static void zone_without(int null)
{
    double numbers[8] = {0};
    tf_zone zone = {.axes = 2};
    tf_zone_goes_on(GIVEN(0, &zone), 1);
    tf_zone_push(GIVEN(1, &zone), GIVEN(2, numbers), GIVEN(3, numbers));
    tf_zone_gap_changes(GIVEN(4, &zone), GIVEN(5, numbers), GIVEN(6, numbers));
    tf_zone_multiply(GIVEN(7, &zone), GIVEN(8, numbers), GIVEN(9, numbers),
                     GIVEN(10, numbers));
    const tf_constraint constraint = {.vertex = {-1, -1, -1, -1}};
    tf_zone_friction(GIVEN(11, &zone), GIVEN(12, &constraint));
}

static void limit_without(int null)
{
    double to[3 * VERTICES] = {0};
    int halvings;
    tf_step_limit(GIVEN(0, resolver), VERTICES, GIVEN(1, start), GIVEN(2, to),
                  NULL, GIVEN(3, &halvings), NULL);
}

static void untangle_without(int null)
{
    double to[3 * VERTICES] = {0};
    tf_untangle(GIVEN(0, resolver), VERTICES, GIVEN(1, start), GIVEN(2, to),
                NULL, NULL, NULL, NULL);
}

static void find_zones_without(int null)
{
    int zone[3 * VERTICES];
    tf_surface_zones(GIVEN(0, surface), VERTICES, GIVEN(1, start), 0, NULL,
                     GIVEN(2, zone), NULL, NULL, NULL);
}

static const null_call null_calls[] = {
    {query_without, 4},          {plane_query_without, 4},
    {edge_query_without, 5},     {cubic_without, 4},
    {quadratic_without, 4},      {additive_without, 4},
    {rigid_without, 4},          {position_without, 3},
    {narrow_phase_without, 6},   {vectors_without, 6},
    {batch_without, 3},          {filter_without, 2},
    {create_without, 2},         {lend_without, 2},
    {lend_triangles_without, 2}, {tell_without, 10},
    {allocator_without, 2},      {detect_without, 3},
    {list_without, 3},           {check_without, 3},
    {measure_without, 3},        {find_nearest_without, 4},
    {distance_without, 3},       {nearer_without, 3},
    {resolver_without, 2},       {resolve_without, 3},
    {limit_without, 4},          {contacts_without, 9},
    {zone_without, 13},          {untangle_without, 3},
    {find_zones_without, 3},     {NULL, 0},
};

Suite *suite(void)
{
    Suite *misuse = suite_create("whole/misuse");
    TCase *c = tcase_create("statuses");
    tcase_add_checked_fixture(c, begin, finish);
    tcase_add_loop_test(c, motions_are_as_they_say, 0, COUNT(motion_calls));
    tcase_add_loop_test(c, motions_have_what_they_count, 0,
                        COUNT(motion_calls));
    tcase_add_test(c, queries_are_of_vertices);
    tcase_add_test(c, kinds_are_those_that_there_are);
    tcase_add_test(c, batches_are_of_vertices);
    tcase_add_test(c, batches_have_what_they_count);
    tcase_add_test(c, arithmetics_have_bits_for_two_axes_and_three);
    tcase_add_test(c, rigid_positions_are_of_vertices);
    tcase_add_test(c, meshes_are_as_they_say);
    tcase_add_loop_test(c, positions_are_of_all_vertices, 0,
                        COUNT(position_calls));
    tcase_add_loop_test(c, positions_are_finite, 0, COUNT(position_calls));
    tcase_add_loop_test(c, workers_are_from_1_to_4096, 0, COUNT(option_calls));
    tcase_add_loop_test(c, sizes_are_those_of_options, 0, COUNT(option_calls));
    tcase_add_loop_test(c, long_calls_can_be_cancelled, 0, COUNT(option_calls));
    tcase_add_test(c, selections_are_those_that_there_are);
    tcase_add_test(c, filters_have_a_group_for_each_vertex_or_none);
    tcase_add_test(c, allocators_stay_while_memory_is_in_use);
    tcase_add_test(c, numbers_of_responses_are_in_their_ranges);
    tcase_add_test(c, masses_are_zero_or_more);
    tcase_add_test(c, friction_of_vertices_is_zero_or_more);
    tcase_add_test(c, null_is_allowed_where_the_header_says_so);
    suite_add_tcase(misuse, c);

    TCase *contracts = tcase_create("contracts");
    tcase_add_checked_fixture(contracts, begin, finish);
    add_null_calls(contracts, null_calls);
    suite_add_tcase(misuse, contracts);
    return misuse;
}
