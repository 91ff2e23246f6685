//: Include what the levels need
#include "response/levels.h"

#include "response/impulses.h"

#include <limits.h>
#include <stdint.h>
#include <string.h>

//: Begin a level
/// Makes the ends so far, without pushes, the ones from which impulses or zones
/// start.
static bool set_base(tf_resolution *r)
{
    size_t bytes =
        sizeof(double) * (size_t)r->step.axes * (size_t)r->step.vertices;
    if (!tf_buffer_reserve(&r->resolver->base, bytes, 1))
        return false;
    memcpy(r->resolver->base.data, r->step.unpushed, bytes);
    r->rule.base = r->resolver->base.data;
    return true;
}

static bool begin_level(tf_resolution *r, tf_response_level level)
{
    switch (level) {
    case TF_IMPULSES:
        return set_base(r) && tf_buffer_reserve(&r->resolver->displacement,
                                                2 * (size_t)r->step.axes *
                                                    (size_t)r->step.vertices,
                                                sizeof(double));
    case TF_ZONES:
        return set_base(r) && tf_zones_begin(&r->resolver->zones, &r->step);
    case TF_RIGID:
        return tf_rigid_begin(&r->resolver->rigid, &r->step);
    default:
        return tf_failsafe_begin(&r->resolver->failsafe, &r->step);
    }
}

//: Answer contacts by impulses
static tf_friction friction_of(const tf_resolution *r)
{
    return (tf_friction){r->options.friction, r->options.vertex_friction};
}

static bool answer_by_impulses(tf_resolution *r)
{
    tf_contact_gap *gap;
    tf_constraint *constraint =
        tf_answers_extend(&r->resolver->answers, r->contacts.count, &gap);
    if (constraint)
        tf_impulses_round(&r->step, &r->contacts, &r->rule, friction_of(r),
                          r->resolver->displacement.data, constraint, gap);
    return constraint != NULL;
}

//: Answer contacts by zones
static bool answer_by_zones(tf_resolution *r)
{
    tf_zone_options options = {.solver = r->options.solver,
                               .friction = friction_of(r),
                               .sweeps = r->options.sweeps};
    tf_zones *zones = &r->resolver->zones;
    return tf_zones_add(zones, &r->step, &r->contacts, &r->rule, &r->zones) &&
           tf_zones_solve(zones, &r->step, &r->rule, &options, &r->zones);
}

//: Answer contacts by groups of vertices
static bool answer_by_groups(tf_resolution *r, tf_response_level level)
{
    tf_contact_gap *gap;
    tf_constraint *constraint =
        tf_answers_extend(&r->resolver->answers, r->contacts.count, &gap);
    if (!constraint)
        return false;
    for (size_t i = 0; i < r->contacts.count && tf_watch_work(r->step.watch, 1);
         i++) {
        constraint[i] = tf_contact_points(&r->contacts.contact[i]);
        gap[i] = (tf_contact_gap){0};
    }
    if (level == TF_RIGID)
        tf_rigid_round(&r->resolver->rigid, &r->step, &r->contacts);
    else
        tf_failsafe_round(&r->resolver->failsafe, &r->step, &r->contacts);
    return true;
}

//: Answer contacts by one level
static bool answer_by(tf_resolution *r, tf_response_level level)
{
    size_t first = (size_t)r->resolver->zones.constraints;
    bool good = level == TF_IMPULSES ? answer_by_impulses(r)
                : level == TF_ZONES  ? answer_by_zones(r)
                                     : answer_by_groups(r, level);
    return good &&
           tf_answers_add(&r->resolver->answers, &r->contacts, level,
                          r->report.rounds[level]++, first, r->step.watch);
}

//: Find near pairs
/// If the motion has no contacts, lists in their place the pairs that it brings
/// nearer than the thickness, if there is one, and counts them.
static tf_status find_near(tf_resolution *r, tf_error *error)
{
    tf_thickness *thickness = &r->resolver->thickness;
    if (!(thickness->length > 0) || r->contacts.any)
        return TF_OK;
    tf_status status =
        tf_near_contacts_find(thickness, r->resolver->surface, &r->motion,
                              r->options.parallel, &r->contacts, error);
    if (status == TF_OK)
        r->report.near += r->contacts.count;
    return status;
}

//: Detect from the beginning
static void account(tf_resolution *r)
{
    r->report.contacts += r->contacts.count;
    tf_detect_statistics_add(&r->report.statistics, &r->contacts.statistics);
}

/// Pairs that are only too near come last.
tf_status tf_resolution_detect(tf_resolution *r, tf_error *error)
{
    tf_status status = tf_pair_cache_build(&r->resolver->pairs, &r->search,
                                           &r->contacts, error);
    if (status != TF_OK)
        return status;
    account(r);
    return find_near(r, error);
}

//: Find the contacts that are left
/// Updates the cache of pairs, and if no contacts are left among these, builds it
/// anew.  So if none are left at all, a detection from the beginning has found
/// none.  A draft does without.
tf_status tf_resolution_detect_again(tf_resolution *r)
{
    tf_pair_cache *pairs = &r->resolver->pairs;
    tf_status status = tf_pair_cache_update(pairs, &r->search, &r->contacts);
    if (status != TF_OK)
        return status;
    account(r);
    return r->contacts.any || r->options.draft ? TF_OK
                                               : tf_resolution_detect(r, NULL);
}

//: Notice that rounds lead nowhere
enum {
    PATIENCE = 5,     ///< rounds that leave no fewer contacts than one before
    FEW_CONTACTS = 16 ///< that are worth all rounds
};

/// What the rounds of a level have led to.
typedef struct round_progress {
    size_t fewest; ///< contacts that were left after one of them
    int since;     ///< rounds since then
} round_progress;

/// Whether many contacts are left, and more rounds are not likely to help.
static bool is_futile(round_progress *so_far, size_t contacts)
{
    bool fewer = contacts < so_far->fewest;
    so_far->since = fewer ? 0 : so_far->since + 1;
    so_far->fewest = fewer ? contacts : so_far->fewest;
    return so_far->since >= PATIENCE && so_far->fewest > FEW_CONTACTS;
}

//: Go through the rounds of a level
static const char *const stage_names[TF_LEVELS] = {
    [TF_IMPULSES] = "impulses",
    [TF_ZONES] = "zones",
    [TF_RIGID] = "rigid zones",
    [TF_FAILSAFE] = "failsafe",
};

/// Ends after `most` rounds, or earlier if no contacts are left or, except for
/// the failsafe, if a round moves nothing: its contacts stay as they are.  Those
/// of zones also end if they lead nowhere.
static tf_status go_through(tf_resolution *r, tf_response_level level, int most)
{
    if (most <= 0 || !r->contacts.any)
        return TF_OK;
    if (!begin_level(r, level))
        return TF_OUT_OF_MEMORY;
    tf_watch *watch = r->resolver->surface->workers.watch;
    round_progress so_far = {.fewest = SIZE_MAX};
    bool futile = false;
    for (int round = 0; round < most && r->contacts.any && !futile; round++) {
        tf_watch_stage(watch, stage_names[level], 0);
        if (!tf_watch_done(watch, 0))
            return TF_CANCELLED;
        if (!answer_by(r, level))
            return tf_watch_failure(watch);
        // If all vertices were proposed to move by the same displacement, the
        // failsafe may unite groups without moving any vertex.
        bool moved = !tf_pair_cache_is_current(&r->resolver->pairs, &r->search);
        if (!moved && level != TF_FAILSAFE)
            return TF_OK;
        tf_status status = tf_resolution_detect_again(r);
        if (status != TF_OK)
            return status;
        futile = level == TF_ZONES && is_futile(&so_far, r->contacts.count);
    }
    return TF_OK;
}

//: Respond level by level
enum {
    RIGID_ROUNDS = 4
};

tf_status tf_respond(tf_resolution *r)
{
    const int most[TF_LEVELS] = {
        [TF_IMPULSES] = r->options.impulse_rounds,
        [TF_ZONES] = r->options.zone_rounds,
        [TF_RIGID] = r->options.rigid ? RIGID_ROUNDS : 0,
        [TF_FAILSAFE] = INT_MAX,
    };
    int levels = r->options.draft ? TF_RIGID : TF_LEVELS;
    for (int level = 0; level < levels; level++) {
        tf_status status = go_through(r, (tf_response_level)level, most[level]);
        if (status != TF_OK)
            return status;
    }
    return TF_OK;
}
