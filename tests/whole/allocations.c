// Steps of cloth ask for no memory once they have had what they need: the calls
// themselves are counted.  The linker puts the functions below in the place of
// those of the C library in all that is linked statically: see tests/rules.mk.
#include "response/resolve.h"
#include "support/cloth.h"
#include "support/support.h"
#include "support/surface_of.h"

#include <stdlib.h>

// Counting ----------------------------------------------------------------------

static long calls;

// The names are the linker's.
void *__real_malloc(size_t size);
void *__real_calloc(size_t count, size_t size);
void *__real_realloc(void *old, size_t size);
void *__real_aligned_alloc(size_t alignment, size_t size);
void *__wrap_malloc(size_t size);
void *__wrap_calloc(size_t count, size_t size);
void *__wrap_realloc(void *old, size_t size);
void *__wrap_aligned_alloc(size_t alignment, size_t size);

void *__wrap_malloc(size_t size)
{
    calls++;
    return __real_malloc(size);
}

void *__wrap_calloc(size_t count, size_t size)
{
    calls++;
    return __real_calloc(count, size);
}

void *__wrap_realloc(void *old, size_t size)
{
    calls++;
    return __real_realloc(old, size);
}

void *__wrap_aligned_alloc(size_t alignment, size_t size)
{
    calls++;
    return __real_aligned_alloc(alignment, size);
}

// Scenes ------------------------------------------------------------------------

/// Plays a scene from its start; returns how many calls its steps made from
/// `begin` on.
static long play(cloth_scene which, int edges, int begin, int steps,
                 tf_surface **surface, tf_resolver **resolver)
{
    cloth_model *cloth = cloth_new(which, edges);
    if (!*surface) {
        *surface = surface_of(&cloth->mesh);
        ck_assert_int_eq(tf_resolver_create(*surface, resolver), TF_OK);
    }
    size_t numbers = (size_t)(cloth->mesh.axes * cloth->mesh.vertices);
    double *end = malloc(sizeof *end * numbers);
    ck_assert_ptr_nonnull(end);
    long all = 0;
    for (int i = 0; i < steps; i++) {
        cloth_propose(cloth, end);
        long before = calls;
        tf_status status =
            tf_step_resolve(*resolver, cloth->mesh.vertices, cloth->position,
                            end, cloth->inverse_mass, NULL, NULL, NULL);
        // Assertions make calls, too.
        all += i >= begin ? calls - before : 0;
        ck_assert_int_eq(status, TF_OK);
        cloth_accept(cloth, end);
    }
    free(end);
    cloth_free(cloth);
    return all;
}

static const int edges[CLOTH_SCENES] = {60, 20, 8, 8, 6, 2};
static const int steps[CLOTH_SCENES] = {100, 100, 60, 60, 120, 240};

START_TEST(a_scene_played_again_allocates_nothing)
{
    tf_surface *surface = NULL;
    tf_resolver *resolver = NULL;
    int count = (int)cases(steps[_i]);
    long first =
        play((cloth_scene)_i, edges[_i], 0, count, &surface, &resolver);
    ck_assert_int_gt(first, 0);
    long again =
        play((cloth_scene)_i, edges[_i], 0, count, &surface, &resolver);
    ck_assert_int_eq(again, 0);
    tf_resolver_free(resolver);
    tf_surface_free(surface);
}
END_TEST

START_TEST(the_second_half_of_a_fall_allocates_nothing)
{
    tf_surface *surface = NULL;
    tf_resolver *resolver = NULL;
    int half = steps[SPHERE] / 2;
    ck_assert_int_eq(
        play(SPHERE, edges[SPHERE], half, 2 * half, &surface, &resolver), 0);
    tf_resolver_free(resolver);
    tf_surface_free(surface);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("whole/allocations");
    TCase *tcase = tcase_create("steady state");
    tcase_add_loop_test(tcase, a_scene_played_again_allocates_nothing, 0,
                        CLOTH_SCENES);
    tcase_add_test(tcase, the_second_half_of_a_fall_allocates_nothing);
    suite_add_tcase(suite, tcase);
    return suite;
}
