//: Include what coupling needs
#include "simulate/coupling.h"

#include "simulate/relaxation.h"

#include <stdlib.h>

enum {
    DRAFT_ROUNDS = 3, // of zones, until the springs have a say
    ROUNDS = 8 // of relaxation, after each of which a step is answered again
};

/// Edges that are longer than at rest by this factor ask for another round.
static const double stretched = 1.13;

//: Hold the coupling
struct tf_coupling {
    const tf_body *body;
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

//: Propose what the elastic elements and the contacts allow
static tf_status propose_again(tf_coupling *c,
                               const tf_response_options *options, double end[])
{
    double begin = time_of(c);
    size_t count;
    const tf_answered_contact *contact;
    tf_status status = tf_resolver_contacts(c->resolver, &count, &contact);
    if (status == TF_OK)
        status = tf_relaxation_add(c->relaxation, count, contact);
    if (status == TF_OK)
        tf_relaxation_run(c->relaxation, options->friction, end);
    c->took.relaxation += time_of(c) - begin;
    return status;
}

//: Answer a step until nothing is stretched
tf_status tf_coupling_resolve(tf_coupling *coupling, const double start[],
                              double end[], const double inverse_mass[],
                              const tf_response_options *options,
                              tf_response_report *report)
{
    tf_coupling *c = coupling;
    tf_response_options draft = *options, again = *options;
    draft.size = again.size = sizeof *options;
    draft.draft = again.again = true;
    draft.zone_rounds = DRAFT_ROUNDS;
    again.check_start = false;
    tf_relaxation_begin(c->relaxation, start, end);
    tf_status status =
        answer(c, start, end, inverse_mass, &draft, report, true);
    for (int i = 0; i < ROUNDS && status == TF_OK; i++) {
        bool met = i == 0 && report->first_contacts > 0;
        if (!met && tf_body_stretch(c->body, end) < stretched)
            break;
        status = propose_again(c, options, end);
        if (status == TF_OK)
            status = answer(c, start, end, inverse_mass, &again, report, false);
    }
    return status;
}
