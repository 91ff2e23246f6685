#include "simulate/coupling.h"

#include "support/simulations.h"
#include "support/support.h"
#include "support/surface_of.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/// Two steps of a scene from the same state: one by the coupling, the other by
/// the response alone.
typedef struct comparison {
    tf_cloth_simulation *c;
    size_t bytes;
    double *proposed, *alone, *draft;
    tf_response_report coupled;
    tf_response_report simple;
    tf_response_report drafted; ///< of the coupling's first answer
} comparison;

static void draft(comparison *both)
{
    tf_cloth_simulation *c = both->c;
    tf_response_options options = {.size = sizeof options,
                                   .friction = c->base.scene->friction,
                                   .zone_rounds = 3,
                                   .draft = true};
    const tf_response_report *lent;
    memcpy(both->draft, both->proposed, both->bytes);
    ck_assert_int_eq(tf_step_resolve(c->resolver, c->base.setup.body.vertices,
                                     c->position, both->draft, c->inverse_mass,
                                     &options, &lent, NULL),
                     TF_OK);
    both->drafted = *lent;
}

static void compare(comparison *both)
{
    tf_cloth_simulation *c = both->c;
    int vertices = c->base.setup.body.vertices;
    tf_response_options options = {.friction = c->base.scene->friction};
    const tf_response_report *lent;
    ck_assert_int_eq(tf_cloth_propose(c), TF_OK);
    memcpy(both->proposed, c->end, both->bytes);
    memcpy(both->alone, c->end, both->bytes);
    ck_assert_int_eq(tf_step_resolve(c->resolver, vertices, c->position,
                                     both->alone, c->inverse_mass, &options,
                                     &lent, NULL),
                     TF_OK);
    both->simple = *lent;
    draft(both);
    ck_assert_int_eq(tf_coupling_resolve(c->coupling, c->position, c->end,
                                         c->inverse_mass, &options, NULL,
                                         &both->coupled),
                     TF_OK);
}

static comparison comparison_of(const char *scene, int size)
{
    comparison both = {.c = cloth_of(scene, size)};
    const tf_body *body = &both.c->base.setup.body;
    both.bytes = sizeof(double) * (size_t)(body->axes * body->vertices);
    both.proposed = malloc(both.bytes);
    both.alone = malloc(both.bytes);
    both.draft = malloc(both.bytes);
    return both;
}

static void comparison_free(comparison *both)
{
    cloth_simulation_free(both->c);
    free(both->proposed);
    free(both->alone);
    free(both->draft);
}

static void accept(comparison *both)
{
    tf_cloth_accept(both->c, tf_resolver_unpushed(both->c->resolver),
                    both->coupled.held);
}

// The first contact comes after some steps, in which nothing is stretched.
START_TEST(a_clear_step_is_that_of_the_dynamics)
{
    comparison both = comparison_of("sphere", 8);
    int clear = 0;
    for (compare(&both); both.simple.first_contacts == 0; compare(&both)) {
        ck_assert_mem_eq(both.c->end, both.proposed, both.bytes);
        ck_assert_uint_eq(both.coupled.contacts, 0);
        accept(&both);
        clear++;
    }
    ck_assert_int_gt(clear, 1);
    ck_assert_mem_ne(both.c->end, both.proposed, both.bytes);
    comparison_free(&both);
}
END_TEST

/// How many vertices do not end where the last answer was to lead them.
static int moved_vertices(const comparison *both)
{
    const unsigned char *flags = tf_resolver_vertices(both->c->resolver);
    int moved = 0;
    for (int v = 0; v < both->c->base.setup.body.vertices; v++)
        moved += (flags[v] & TF_VERTEX_MOVED) != 0;
    return moved;
}

// Both begin with the same contacts.  The coupling drafts an answer, and then does
// more.
START_TEST(a_report_adds_up_what_answers_took)
{
    comparison both = comparison_of("plane-chain", 60);
    int more = 0;
    for (int i = 0; i < 120; i++) {
        compare(&both);
        ck_assert_uint_eq(both.coupled.first_contacts,
                          both.simple.first_contacts);
        ck_assert_uint_ge(both.coupled.contacts, both.drafted.contacts);
        ck_assert_uint_ge(both.coupled.constraints, both.drafted.constraints);
        ck_assert_int_ge(both.coupled.rounds[TF_ZONES],
                         both.drafted.rounds[TF_ZONES]);
        ck_assert_int_eq((int)both.coupled.moved, moved_vertices(&both));
        more += both.coupled.contacts > both.drafted.contacts;
        accept(&both);
    }
    ck_assert_int_gt(more, 20);
    comparison_free(&both);
}
END_TEST

// The chain hangs on what is in the way, and the response alone stretches it.
START_TEST(what_hangs_on_a_contact_is_not_stretched)
{
    comparison both = comparison_of("plane-chain", 120);
    double most = 1, alone = 1;
    for (int i = 0; i < 200; i++) {
        compare(&both);
        const tf_body *body = &both.c->base.setup.body;
        alone = fmax(alone, tf_body_stretch(body, both.alone));
        most = fmax(most, tf_body_stretch(body, both.c->end));
        accept(&both);
    }
    printf("stretched to %g, and to %g in a step without coupling\n", most,
           alone);
    ck_assert_double_le(most, 1.15);
    comparison_free(&both);
}
END_TEST

// What was answered before leaves no traces.
START_TEST(a_step_depends_on_itself_alone)
{
    comparison both = comparison_of("plane-chain", 60);
    for (int i = 0; i < 100; i++) {
        compare(&both);
        accept(&both);
    }
    compare(&both);
    memcpy(both.alone, both.c->end, both.bytes);
    memcpy(both.c->end, both.proposed, both.bytes);
    tf_response_options options = {.friction = both.c->base.scene->friction};
    ck_assert_int_eq(tf_coupling_resolve(both.c->coupling, both.c->position,
                                         both.c->end, both.c->inverse_mass,
                                         &options, NULL, &both.coupled),
                     TF_OK);
    ck_assert_uint_gt(both.coupled.first_contacts, 0);
    ck_assert_mem_eq(both.c->end, both.alone, both.bytes);
    comparison_free(&both);
}
END_TEST

// Rounds ------------------------------------------------------------------------

static double ticks;

static double tick(void)
{
    return ticks++;
}

// Each part takes a tick.
START_TEST(parts_are_timed)
{
    comparison both = comparison_of("sphere", 8);
    int clear = 0;
    tf_coupling_watch(both.c->coupling, tick);
    for (compare(&both); both.simple.first_contacts == 0; compare(&both)) {
        accept(&both);
        tf_coupling_times took = tf_coupling_took(both.c->coupling);
        ck_assert_double_eq(took.draft, ++clear);
        ck_assert_double_eq(took.relaxation, 0);
        ck_assert_double_eq(took.answers, 0);
    }
    tf_coupling_times took = tf_coupling_took(both.c->coupling);
    ck_assert_double_eq(took.draft, clear + 1);
    ck_assert_double_ge(took.relaxation, 1);
    ck_assert_double_eq(took.answers, took.relaxation);
    comparison_free(&both);
}
END_TEST

// A script stretches a spring, and nothing helps.
START_TEST(rounds_come_to_an_end)
{
    static const double place[][2] = {{0, 0}, {1, 0}, {0, 1}};
    double end[] = {0, 0, 2, 0, 0, 1}, inverse_mass[] = {0, 0, 1};
    tf_body body = {.axes = 2};
    for (int v = 0; v < 3; v++)
        tf_body_add_vertex(&body, place[v]);
    body.mass[2] = 1;
    tf_body_add_edge(&body, 0, 1);
    tf_body_add_spring(&body, 0, 1, 100);
    tf_mesh mesh = tf_body_mesh(&body);
    tf_surface *surface = surface_of(&mesh);
    tf_resolver *resolver;
    tf_coupling *coupling;
    tf_response_report report;
    tf_response_options options = {0};
    ck_assert_int_eq(tf_resolver_create(surface, &resolver), TF_OK);
    ck_assert_int_eq(tf_coupling_create(&body, 0.01, resolver, &coupling),
                     TF_OK);
    tf_coupling_watch(coupling, tick);
    ck_assert_int_eq(tf_coupling_resolve(coupling, body.position, end,
                                         inverse_mass, &options, NULL, &report),
                     TF_OK);
    ck_assert_double_eq(tf_coupling_took(coupling).relaxation, 8);
    ck_assert_double_eq(end[2], 2);
    tf_coupling_free(coupling);
    tf_coupling_free(NULL);
    tf_resolver_free(resolver);
    tf_surface_free(surface);
    tf_body_free(&body);
}
END_TEST

// Energy ------------------------------------------------------------------------

/// Couples a proposed step, and finds the energy that it ends with.
static double couple(comparison *both, const tf_coupling_energy *energy)
{
    tf_cloth_simulation *c = both->c;
    const tf_body *body = &c->base.setup.body;
    tf_response_options options = {.friction = c->base.scene->friction};
    memcpy(c->end, both->proposed, both->bytes);
    ck_assert_int_eq(tf_coupling_resolve(c->coupling, c->position, c->end,
                                         c->inverse_mass, &options, energy,
                                         &both->coupled),
                     TF_OK);
    const double *motion = tf_resolver_unpushed(c->resolver);
    double sum = tf_body_potential_energy(body, c->base.scene->gravity, c->end);
    for (int i = 0; i < body->axes * body->vertices; i++)
        sum += body->mass[i / body->axes] / 2 *
               pow((motion[i] - c->position[i]) / c->base.scene->step, 2);
    return sum;
}

static void propose(comparison *both)
{
    ck_assert_int_eq(tf_cloth_propose(both->c), TF_OK);
    memcpy(both->proposed, both->c->end, both->bytes);
}

// While a sheet meets a ball, which rests.
START_TEST(what_gains_energy_is_relaxed_again)
{
    comparison both = comparison_of("sphere", 16);
    double careless = 0, careful = 0;
    for (int i = 0; i < 60; i++) {
        tf_coupling_energy energy = tf_cloth_energy(both.c);
        propose(&both);
        double alone = couple(&both, NULL) - energy.start;
        memcpy(both.alone, both.c->end, both.bytes);
        double limited = couple(&both, &energy) - energy.start;
        if (alone <= 0)
            ck_assert_mem_eq(both.c->end, both.alone, both.bytes);
        careless += fmax(0, alone);
        careful += fmax(0, limited);
        accept(&both);
    }
    printf("gained: %g J, and %g in rounds that look at it\n", careless,
           careful);
    ck_assert_double_gt(careless, 0);
    ck_assert_double_lt(careful, careless / 4);
    comparison_free(&both);
}
END_TEST

// The ends of the strip turn, and what they do is work.
START_TEST(a_script_that_moves_may_do_work)
{
    comparison both = comparison_of("twist", 4);
    size_t contacts = 0;
    int gains = 0;
    for (int i = 0; i < 300; i++) {
        tf_coupling_energy energy = tf_cloth_energy(both.c);
        propose(&both);
        double alone = couple(&both, NULL);
        memcpy(both.alone, both.c->end, both.bytes);
        couple(&both, &energy);
        ck_assert_mem_eq(both.c->end, both.alone, both.bytes);
        gains += both.coupled.first_contacts > 0 && alone > energy.start;
        contacts += both.coupled.first_contacts;
        accept(&both);
    }
    ck_assert_uint_gt(contacts, 0);
    ck_assert_int_gt(gains, 0);
    comparison_free(&both);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("simulate/coupling");
    TCase *tcase = tcase_create("coupling");
    tcase_add_test(tcase, a_clear_step_is_that_of_the_dynamics);
    tcase_add_test(tcase, a_report_adds_up_what_answers_took);
    tcase_add_test(tcase, what_hangs_on_a_contact_is_not_stretched);
    tcase_add_test(tcase, a_step_depends_on_itself_alone);
    tcase_add_test(tcase, parts_are_timed);
    tcase_add_test(tcase, rounds_come_to_an_end);
    tcase_add_test(tcase, what_gains_energy_is_relaxed_again);
    tcase_add_test(tcase, a_script_that_moves_may_do_work);
    suite_add_tcase(suite, tcase);
    return suite;
}
