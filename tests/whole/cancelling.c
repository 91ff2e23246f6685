// How soon a cancelled call ends, by what it does instead of a clock: between two
// looks at the watch, and after it has cancelled, it does little, however large
// the surface is.  The linker counts calls of the functions below: see
// tests/rules.mk.
#include "support/cancelling.h"
#include "flow/flow.h"
#include "linear/distance.h"
#include "remesh/remesh.h"
#include "support/flows.h"
#include "support/support.h"
#include "surgery/adaptive_surface.h"
#include "surgery/side.h"
#include "topology/reconnect.h"

/// What was done since the last look at the watch, and the most so far.
static long work, most;

// The names are the linker's.
tf_sign __real_tf_side(const double *a, const double *b, const double *c,
                       const double *d);
tf_sign __wrap_tf_side(const double *a, const double *b, const double *c,
                       const double *d);
tf_point_pair __real_tf_nearest_points(int vertices, int others,
                                       const tf_vector x[]);
tf_point_pair __wrap_tf_nearest_points(int vertices, int others,
                                       const tf_vector x[]);
double __real_tf_squared_distance(const tf_vector x[4]);
double __wrap_tf_squared_distance(const tf_vector x[4]);
int __real_tf_dynamic_tree_find(tf_dynamic_tree *tree, const tf_aabb *box,
                                int found[]);
int __wrap_tf_dynamic_tree_find(tf_dynamic_tree *tree, const tf_aabb *box,
                                int found[]);
int __real_tf_find_edge(const tf_adaptive_surface *surface, int from, int to);
int __wrap_tf_find_edge(const tf_adaptive_surface *surface, int from, int to);
bool __real_tf_watch_done(tf_watch *watch, size_t more);
bool __wrap_tf_watch_done(tf_watch *watch, size_t more);

static void note(void)
{
    work++;
    most = work > most ? work : most;
}

tf_sign __wrap_tf_side(const double *a, const double *b, const double *c,
                       const double *d)
{
    note();
    return __real_tf_side(a, b, c, d);
}

tf_point_pair __wrap_tf_nearest_points(int vertices, int others,
                                       const tf_vector x[])
{
    note();
    return __real_tf_nearest_points(vertices, others, x);
}

double __wrap_tf_squared_distance(const tf_vector x[4])
{
    note();
    return __real_tf_squared_distance(x);
}

int __wrap_tf_dynamic_tree_find(tf_dynamic_tree *tree, const tf_aabb *box,
                                int found[])
{
    note();
    return __real_tf_dynamic_tree_find(tree, box, found);
}

int __wrap_tf_find_edge(const tf_adaptive_surface *surface, int from, int to)
{
    note();
    return __real_tf_find_edge(surface, from, to);
}

bool __wrap_tf_watch_done(tf_watch *watch, size_t more)
{
    if (!tf_watch_cancelled(watch))
        work = 0;
    return __real_tf_watch_done(watch, more);
}

// Calls -----------------------------------------------------------------------

enum {
    SMALL = 14, ///< 8 times its square is the number of triangles
    LARGE = 44,
    MOST = 8000 ///< what may be done between two looks: milliseconds
};

static tf_adaptive_surface *sphere(int n)
{
    return adaptive_bumpy_sphere(n, 0.2 / n, 1);
}

static tf_status refine(tf_adaptive_surface *surface, cancellation *cancelling,
                        tf_error *error)
{
    const tf_remesh_options how = {.edge = 0.06,
                                   .rounds = 1,
                                   .progress = tell_cancellation,
                                   .context = cancelling};
    return tf_adaptive_remesh(surface, &how, NULL, error);
}

static tf_status coarsen(tf_adaptive_surface *surface, cancellation *cancelling,
                         tf_error *error)
{
    const tf_remesh_options how = {
        .edge = 0.6, .progress = tell_cancellation, .context = cancelling};
    return tf_adaptive_remesh(surface, &how, NULL, error);
}

static tf_status reconnect(tf_adaptive_surface *surface,
                           cancellation *cancelling, tf_error *error)
{
    const tf_reconnect_options how = {.edge = 1.5,
                                      .drop = 10,
                                      .progress = tell_cancellation,
                                      .context = cancelling};
    return tf_adaptive_reconnect(surface, &how, NULL, error);
}

static void shrink(void *context, double time, int points, const double point[],
                   const double normal[], double velocity[])
{
    (void)context, (void)time, (void)point;
    for (int i = 0; i < 3 * points; i++)
        velocity[i] = -0.05 * normal[i];
}

static tf_status flow(tf_adaptive_surface *surface, cancellation *cancelling,
                      tf_error *error)
{
    tf_flow *made;
    const tf_flow_options how = {.edge = 0.1,
                                 .velocity = shrink,
                                 .progress = tell_cancellation,
                                 .context = cancelling};
    ck_assert_int_eq(tf_flow_create(surface, &made), TF_OK);
    tf_status status = tf_flow_step(made, 0, 1, &how, NULL, error);
    tf_flow_free(made);
    return status;
}

static long_call *const calls[] = {refine, coarsen, reconnect, flow};

START_TEST(little_is_done_between_two_looks)
{
    tf_adaptive_surface *surface = sphere(LARGE);
    cancellation none = {0};
    tf_error error;
    work = most = 0;
    ck_assert_int_eq(calls[_i](surface, &none, &error), TF_OK);
    ck_assert_msg(most < MOST, "%ld", most);
    tf_adaptive_free(surface);
}
END_TEST

START_TEST(little_is_done_after_a_cancel)
{
    generator random = generator_new((uint64_t)_i);
    tf_adaptive_surface *surface = sphere(SMALL), *same = sphere(SMALL);
    cancellation none = {0};
    tf_error error;
    ck_assert_int_eq(calls[_i](same, &none, &error), TF_OK);
    for (long i = 0; i < cases(30); i++) {
        cancellation some = {.last = 1 + below(&random, (int)none.told)};
        work = 0;
        ck_assert_int_eq(calls[_i](surface, &some, &error), TF_CANCELLED);
        ck_assert_msg(work < MOST, "%ld", work);
    }
    tf_adaptive_free(same);
    tf_adaptive_free(surface);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("whole/cancelling");
    TCase *tcase = tcase_create("work");
    tcase_add_loop_test(tcase, little_is_done_between_two_looks, 0, 4);
    tcase_add_loop_test(tcase, little_is_done_after_a_cancel, 0, 4);
    suite_add_tcase(suite, tcase);
    return suite;
}
