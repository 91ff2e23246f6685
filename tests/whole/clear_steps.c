// What the theorem of no contact gives for surfaces: a step that starts free of
// intersections and has no contact ends free of them.
#include "fast/detect.h"
#include "surface/check.h"

#include "support/crossings.h"
#include "support/support.h"
#include "support/surface_of.h"
#include "support/surfaces.h"

#include <stdlib.h>

enum {
    STEPS = 20000,
    MOST_TRIES = 400
};

static surface_case given;

static bool is_clear(tf_surface *surface, const double position[])
{
    tf_crossings found;
    ck_assert_int_eq(tf_surface_check(surface, given.mesh.vertices, position,
                                      NULL, &found, NULL),
                     TF_OK);
    return found.count == 0;
}

static tf_contacts detect(tf_surface *surface)
{
    tf_detect_options any = {.selection = TF_ANY_CONTACT};
    tf_contacts found;
    ck_assert_int_eq(
        tf_surface_detect(surface, &given.motion, &any, &found, NULL), TF_OK);
    return found;
}

static void check_end(const tf_surface *surface)
{
    static oracle_crossings all;
    oracle_crossings_find(&all, surface, given.mesh.axes, given.mesh.vertices,
                          given.end);
    ck_assert_msg(all.count == 0, "%d intersections at the end, seed %llu",
                  all.count, (unsigned long long)seed());
}

/// One step without a contact from a clear start; returns how many candidates
/// it had.
static size_t try_step(generator *random, int axes, placement placed)
{
    for (int i = 0; i < MOST_TRIES; i++) {
        random_surface(random, axes, 5, placed, &given);
        tf_surface *surface = surface_of(&given.mesh);
        tf_contacts found = {.any = true};
        if (is_clear(surface, given.start))
            found = detect(surface);
        if (!found.any)
            check_end(surface);
        tf_surface_free(surface);
        if (!found.any)
            return found.statistics.candidates;
    }
    ck_abort_msg("no clear step in %d tries", MOST_TRIES);
}

START_TEST(clear_steps_end_clear)
{
    static const placement placed[] = {ANYWHERE, ON_LATTICE};
    generator random = generator_new((uint64_t)_i);
    int steps = (int)cases(STEPS / 4), near = 0;
    for (int i = 0; i < steps; i++)
        near += try_step(&random, 2 + _i % 2, placed[_i / 2]) > 0;
    // Many of them have elements whose boxes overlap.
    ck_assert_int_gt(10 * near, steps);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("whole/clear_steps");
    TCase *tcase = tcase_create("clear steps");
    tcase_add_loop_test(tcase, clear_steps_end_clear, 0, 4);
    suite_add_tcase(suite, tcase);
    return suite;
}
