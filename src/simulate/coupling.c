//: Include what coupling needs
#include "simulate/coupling.h"

#include "simulate/relaxation.h"

#include <math.h>
#include <stdlib.h>

enum {
    DRAFT_ROUNDS = 3, // of zones, until the springs have a say
    ROUNDS = 8, // of relaxation, after each of which a step is answered again
    ENERGY_ROUNDS = 3, // after so many of them a step may have gained energy
    RELAXATIONS = 5    // in a round, if energy is gained
};

/// Edges that are longer than at rest by this factor ask for another round.
static const double stretched = 1.11;

/// A step may gain this part of the kinetic energy that was proposed.
static const double slack = 0.01;

//: Hold the coupling
struct tf_coupling {
    const tf_body *body;
    double step;
    tf_resolver *resolver;
    tf_relaxation *relaxation;
    double (*clock)(void); ///< NULL: nothing is timed
    tf_coupling_times took;
};

//: Make and free a coupling
tf_status tf_coupling_create(const tf_body *body, double step,
                             tf_resolver *resolver, tf_coupling **coupling)
{
    tf_coupling *c = calloc(1, sizeof *c);
    if (!c)
        return TF_OUT_OF_MEMORY;
    c->body = body;
    c->step = step;
    c->resolver = resolver;
    tf_status status = tf_relaxation_create(body, step, &c->relaxation);
    if (status == TF_OK)
        *coupling = c;
    else
        tf_coupling_free(c);
    return status;
}

void tf_coupling_free(tf_coupling *coupling)
{
    if (!coupling)
        return;
    tf_relaxation_free(coupling->relaxation);
    free(coupling);
}

//: Time the parts of a step
void tf_coupling_watch(tf_coupling *coupling, double (*clock)(void))
{
    coupling->clock = clock;
    coupling->took = (tf_coupling_times){0};
}

tf_coupling_times tf_coupling_took(const tf_coupling *coupling)
{
    return coupling->took;
}

static double time_of(const tf_coupling *c)
{
    return c->clock ? c->clock() : 0;
}

//: Answer a step once
/// Adds up what answers took; how they ended is what the last one says.
static void add_report(tf_response_report *sum, const tf_response_report *last)
{
    tf_response_report before = *sum;
    *sum = *last;
    sum->first_contacts = before.first_contacts;
    sum->contacts += before.contacts;
    sum->constraints += before.constraints;
    for (int i = 0; i < TF_LEVELS; i++)
        sum->rounds[i] += before.rounds[i];
}

static tf_status answer(tf_coupling *c, const double start[], double end[],
                        const double inverse_mass[],
                        const tf_response_options *options,
                        tf_response_report *report, bool first)
{
    const tf_response_report *lent;
    double begin = time_of(c),
           *took = first ? &c->took.draft : &c->took.answers;
    tf_status status = tf_step_resolve(c->resolver, c->body->vertices, start,
                                       end, inverse_mass, options, &lent, NULL);
    *took += time_of(c) - begin;
    if (status == TF_OK && first)
        *report = *lent;
    else if (status == TF_OK)
        add_report(report, lent);
    return status;
}

//: Limit the energy of a step
/// What a step may end with, in joules.
typedef struct energy_limit {
    double gravity, most;
} energy_limit;

static double kinetic_energy(const tf_coupling *c, const double start[],
                             const double end[])
{
    double energy = 0;
    for (int i = 0; i < c->body->axes * c->body->vertices; i++) {
        double velocity = (end[i] - start[i]) / c->step;
        energy += c->body->mass[i / c->body->axes] / 2 * velocity * velocity;
    }
    return energy;
}

static bool is_script_at_rest(const tf_body *body, const double start[],
                              const double end[])
{
    for (int i = 0; i < body->axes * body->vertices; i++)
        if (body->mass[i / body->axes] == 0 && start[i] != end[i])
            return false;
    return true;
}

//: Find the limit from what was proposed
static energy_limit energy_limit_of(const tf_coupling *c,
                                    const tf_coupling_energy *energy,
                                    const double start[], const double end[])
{
    if (!energy || !is_script_at_rest(c->body, start, end))
        return (energy_limit){.most = INFINITY};
    double kinetic = kinetic_energy(c, start, end);
    double proposed =
        kinetic + tf_body_potential_energy(c->body, energy->gravity, end);
    return (energy_limit){energy->gravity,
                          fmax(energy->start, proposed) + slack * kinetic};
}

/// @param motion where the step ends as far as velocities are concerned
static bool gains_energy(const tf_coupling *c, energy_limit limit,
                         const double start[], const double motion[],
                         const double end[])
{
    return isfinite(limit.most) &&
           kinetic_energy(c, start, motion) +
                   tf_body_potential_energy(c->body, limit.gravity, end) >
               limit.most;
}

//: Propose what the elastic elements and the contacts allow
static tf_status propose_again(tf_coupling *c, energy_limit limit,
                               const tf_response_options *options,
                               const double start[], double end[])
{
    double begin = time_of(c);
    size_t count;
    const tf_answered_contact *contact;
    tf_status status = tf_resolver_contacts(c->resolver, &count, &contact);
    if (status == TF_OK)
        status = tf_relaxation_add(c->relaxation, options, count, contact);
    bool gains = status == TF_OK;
    for (int i = 0; i < RELAXATIONS && gains; i++) {
        tf_relaxation_run(c->relaxation, end);
        gains = gains_energy(c, limit, start, end, end);
    }
    c->took.relaxation += time_of(c) - begin;
    return status;
}

//: Find out whether to go on
static bool is_to_go_on(const tf_coupling *c, int rounds, energy_limit limit,
                        const double start[], const double end[],
                        const tf_response_report *report)
{
    return (rounds == 0 && report->first_contacts > 0) ||
           tf_body_stretch(c->body, end) >= stretched ||
           (rounds < ENERGY_ROUNDS &&
            gains_energy(c, limit, start, tf_resolver_unpushed(c->resolver),
                         end));
}

//: Answer a step until all is well
tf_status tf_coupling_resolve(tf_coupling *coupling, const double start[],
                              double end[], const double inverse_mass[],
                              const tf_response_options *options,
                              const tf_coupling_energy *energy,
                              tf_response_report *report)
{
    tf_coupling *c = coupling;
    energy_limit limit = energy_limit_of(c, energy, start, end);
    tf_response_options draft = *options, again = *options;
    draft.size = again.size = sizeof *options;
    draft.draft = again.again = true;
    draft.zone_rounds = DRAFT_ROUNDS;
    again.check_start = false;
    tf_relaxation_begin(c->relaxation, start, end);
    tf_status status =
        answer(c, start, end, inverse_mass, &draft, report, true);
    for (int i = 0; i < ROUNDS && status == TF_OK; i++) {
        if (!is_to_go_on(c, i, limit, start, end, report))
            break;
        status = propose_again(c, limit, options, start, end);
        if (status == TF_OK)
            status = answer(c, start, end, inverse_mass, &again, report, false);
    }
    return status;
}
