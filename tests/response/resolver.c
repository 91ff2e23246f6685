// What a resolver keeps.
#include "response/resolver.h"

#include "response/resolve.h"
#include "support/proposals.h"
#include "support/support.h"
#include "support/surface_of.h"

#include <signal.h>
#include <string.h>

static proposal made;

static void resolve(tf_resolver *resolver, const tf_response_options *options)
{
    static double end[3 * PROPOSAL_VERTICES];
    memcpy(end, made.end, sizeof end);
    ck_assert_int_eq(tf_step_resolve(resolver, made.mesh.vertices, made.start,
                                     end, NULL, options, NULL, NULL),
                     TF_OK);
}

// The same steps again take no memory; each level has had its turn.
START_TEST(a_steady_state_takes_no_memory)
{
    static const tf_response_options options[] = {
        {0},
        {.impulse_rounds = 2, .friction = 0.3},
        {.zone_rounds = -1, .rigid = true},
        {.zone_rounds = -1}};
    enum {
        WAYS = sizeof options / sizeof *options
    };
    generator random = generator_new(100);
    proposal_make(&random, BALLS, 3, SCATTERED, &made);
    tf_surface *surface = surface_of(&made.mesh);
    tf_resolver *resolver;
    ck_assert_int_eq(tf_resolver_create(surface, &resolver), TF_OK);
    size_t empty = tf_resolver_memory(resolver);
    for (int i = 0; i < WAYS; i++)
        resolve(resolver, &options[i]);
    size_t bytes = tf_resolver_memory(resolver);
    size_t surface_bytes = tf_surface_memory(surface);
    ck_assert_uint_gt(bytes, empty);
    for (int i = 0; i < 2 * WAYS; i++)
        resolve(resolver, &options[i % WAYS]);
    ck_assert_uint_eq(tf_resolver_memory(resolver), bytes);
    ck_assert_uint_eq(tf_surface_memory(surface), surface_bytes);
    tf_resolver_free(resolver);
    tf_surface_free(surface);
}
END_TEST

START_TEST(null_may_be_freed)
{
    tf_resolver_free(NULL);
}
END_TEST

START_TEST(a_resolver_needs_a_surface)
{
    tf_resolver *resolver;
    tf_resolver_create(NULL, &resolver);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("response/resolver");
    TCase *tcase = tcase_create("memory");
    tcase_add_test(tcase, a_steady_state_takes_no_memory);
    tcase_add_test(tcase, null_may_be_freed);
    tcase_add_test_raise_signal(tcase, a_resolver_needs_a_surface, SIGABRT);
    suite_add_tcase(suite, tcase);
    return suite;
}
