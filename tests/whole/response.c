// Responses, judged by what shares no code with detection.
#include "response/conjugate_residuals.h"
#include "support/cloth.h"
#include "support/resolutions.h"
#include "support/scrambled_workers.h"
#include "support/support.h"
#include "support/surface_of.h"
#include "support/tangle.h"
#include "threads/threads.h"

#include <stdio.h>
#include <stdlib.h>

// Random proposals ------------------------------------------------------------

START_TEST(random_proposals_are_resolved)
{
    resolution_counts counts = {0};
    long tries = cases(120);
    for (long number = 0; number < tries; number++) {
        const char *fault = numbered_fault(number, &counts);
        ck_assert_msg(!fault, "%s", fault);
    }
    resolution_counts_print(&counts);
    ck_assert_int_ge(10 * counts.tries, 9 * tries);
    ck_assert_int_ge(2 * counts.met, tries);
}
END_TEST

// Cloth -----------------------------------------------------------------------

/// A scene, and what resolves and judges its steps.
typedef struct scene {
    cloth_model *cloth;
    tf_surface *surface;
    tf_resolver *resolver;
    tangle_judge *judge;
    double *end;
} scene;

static scene scene_new(cloth_scene which, int edges)
{
    scene s = {.cloth = cloth_new(which, edges)};
    s.surface = surface_of(&s.cloth->mesh);
    ck_assert_int_eq(tf_resolver_create(s.surface, &s.resolver), TF_OK);
    s.judge = tangle_judge_new(&s.cloth->mesh);
    s.end = malloc(sizeof *s.end *
                   (size_t)(s.cloth->mesh.axes * s.cloth->mesh.vertices));
    ck_assert_ptr_nonnull(s.end);
    return s;
}

static void scene_free(scene *s)
{
    free(s->end);
    tangle_judge_free(s->judge);
    tf_resolver_free(s->resolver);
    tf_surface_free(s->surface);
    cloth_free(s->cloth);
}

static tf_response_report step(scene *s, const tf_response_options *options)
{
    const tf_response_report *lent;
    cloth_propose(s->cloth, s->end);
    ck_assert_int_eq(tf_step_resolve(s->resolver, s->cloth->mesh.vertices,
                                     s->cloth->position, s->end,
                                     s->cloth->inverse_mass, options, &lent,
                                     NULL),
                     TF_OK);
    int count = tangle_count(s->judge, s->end);
    ck_assert_msg(count == 0, "%d tangles, such as %s", count,
                  count ? tangle_text(tangles(s->judge)) : "");
    cloth_accept(s->cloth, tf_resolver_unpushed(s->resolver), s->end);
    return *lent;
}

/// What the steps of a scene took.
typedef struct course {
    int steps, met, rescued, rounds, most_rounds;
    long held;
} course;

static void account(const tf_response_report *report, course *sum)
{
    int rounds = report->rounds[TF_ZONES];
    sum->steps++;
    sum->met += report->first_contacts > 0;
    sum->rescued += report->rounds[TF_FAILSAFE] > 0;
    sum->rounds += rounds;
    sum->most_rounds = rounds > sum->most_rounds ? rounds : sum->most_rounds;
    sum->held += report->held;
}

static const int scene_edges[CLOTH_SCENES] = {40, 10, 5, 5, 4, 2};
static const int scene_steps[CLOTH_SCENES] = {60, 40, 30, 30, 100, 160};

/// At more than 100 percent, as in `make soak-response`, cloth is also finer.
static int edges_of(cloth_scene which)
{
    return scene_edges[which] * (cases(100) > 100 ? 2 : 1);
}

static course run(cloth_scene which, int steps,
                  const tf_response_options *options)
{
    scene s = scene_new(which, edges_of(which));
    course sum = {0};
    for (int i = 0; i < steps; i++) {
        tf_response_report report = step(&s, options);
        account(&report, &sum);
    }
    printf("%-14s %5d vertices, %3d steps, %3d with contacts, %3d by the "
           "failsafe; rounds %.1f, most %d; %ld held\n",
           cloth_names[which], s.cloth->mesh.vertices, sum.steps, sum.met,
           sum.rescued, (double)sum.rounds / sum.steps, sum.most_rounds,
           sum.held);
    scene_free(&s);
    return sum;
}

START_TEST(cloth_stays_free_of_tangles)
{
    course sum = run((cloth_scene)_i, (int)cases(scene_steps[_i]), NULL);
    ck_assert(sum.steps < scene_steps[_i] || 4 * sum.met > sum.steps);
    // The zones are what resolves; the failsafe is for the rest.
    ck_assert(_i == NARROW_TWIST || 4 * sum.rescued <= sum.steps);
}
END_TEST

START_TEST(cloth_stays_free_of_tangles_by_other_means)
{
    static const tf_response_options means[] = {
        {.zone_rounds = -1},
        {.solver = &tf_conjugate_residuals, .friction = 0.3},
        {.impulse_rounds = 4, .zone_rounds = 4, .rigid = true},
        {.friction = 0.5, .restitution = 0.5, .separation = -1}};
    cloth_scene which = (cloth_scene)(_i % CLOTH_SCENES);
    const tf_response_options *options = &means[_i / CLOTH_SCENES];
    course sum = run(which, 3 * (int)cases(scene_steps[which]) / 4, options);
    ck_assert(!options->solver || which == NARROW_TWIST ||
              4 * sum.rescued <= sum.steps);
}
END_TEST

// Threads ---------------------------------------------------------------------

static void expect_same(const scene *one, const scene *other)
{
    int numbers = one->cloth->mesh.axes * one->cloth->mesh.vertices;
    ck_assert_mem_eq(one->end, other->end, sizeof *one->end * (size_t)numbers);
}

START_TEST(any_number_of_threads_ends_with_the_same_bits)
{
    scene alone = scene_new(STACK_TURNED, 6), shared[2];
    int workers = 3;
    tf_threads *two;
    ck_assert_int_eq(tf_threads_create(2, &two), TF_OK);
    const tf_parallel scrambled = scrambled_workers(&workers);
    const tf_parallel *parallel[] = {tf_threads_parallel(two), &scrambled};
    for (int i = 0; i < 2; i++)
        shared[i] = scene_new(STACK_TURNED, 6);
    for (int i = 0; i < (int)cases(15); i++) {
        step(&alone, NULL);
        for (int j = 0; j < 2; j++) {
            step(&shared[j], &(tf_response_options){.parallel = parallel[j]});
            expect_same(&alone, &shared[j]);
        }
    }
    scene_free(&alone);
    for (int i = 0; i < 2; i++)
        scene_free(&shared[i]);
    tf_threads_free(two);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("whole/response");
    TCase *random = tcase_create("random proposals");
    tcase_add_test(random, random_proposals_are_resolved);
    suite_add_tcase(suite, random);

    TCase *scenes = tcase_create("cloth");
    tcase_add_loop_test(scenes, cloth_stays_free_of_tangles, 0, CLOTH_SCENES);
    tcase_add_loop_test(scenes, cloth_stays_free_of_tangles_by_other_means, 0,
                        4 * CLOTH_SCENES);
    suite_add_tcase(suite, scenes);

    TCase *threads = tcase_create("threads");
    tcase_add_test(threads, any_number_of_threads_ends_with_the_same_bits);
    suite_add_tcase(suite, threads);
    return suite;
}
