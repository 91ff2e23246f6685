//: Include what attempts need
#include "untangle/attempts.h"

#include "untangle/apart.h"
#include "untangle/smooth.h"

#include <limits.h>
#include <string.h>

//: Tell which rungs there are
enum {
    IDLE_ROUNDS = 12,    ///< after which another rung has its turn
    SMOOTHINGS = 2,      ///< of an attempt
    SMOOTH_ROUNDS = 7,   ///< of a smoothing
    MOST_RINGS = 12,     ///< that are smoothed
    SCOPE_RINGS = 2,     ///< around what crosses that may pass through anything
    USUAL_ROUNDS = 300,  ///< of an attempt since its crossings were halved
    RELAX_ROUNDS = 4000, ///< of the last one
    CHECK_EVERY = 4,     ///< of its rounds there is a check, at first,
    CHECK_PARTS = 32     ///< and later when they have grown by such a part
};

static bool may(const tf_attempts *all, int rung)
{
    return (all->options->without & rung) == 0;
}

static bool is_done(const tf_attempts *all)
{
    return all->fewest <= all->beyond;
}

//: Keep the best state
static size_t coordinates(const tf_attempts *all)
{
    return (size_t)all->tangle.near.axes * (size_t)all->tangle.near.vertices;
}

static void copy(const tf_attempts *all, double to[], const double from[])
{
    memcpy(to, from, coordinates(all) * sizeof *to);
}

/// Judges x, of which the tangle was checked last.
static void judge_round(tf_attempts *all)
{
    size_t count = all->tangle.crossings.count;
    if (count < all->fewest) {
        all->fewest = count;
        copy(all, all->best, all->x);
    }
    all->idle = count < all->few ? 0 : all->idle + 1;
    all->few = count < all->few ? count : all->few;
}

static tf_status judge_state(tf_attempts *all)
{
    tf_status status = tf_tangle_check(&all->tangle, all->x);
    if (status == TF_OK)
        judge_round(all);
    return status;
}

//: Take a step
/// Moves the vertices by the change, limited, and judges where they are.  Where
/// nothing moves, nothing will in the next round either.
static tf_status step(tf_attempts *all, tf_untangle_rung rung, int rings)
{
    bool knows = may(all, TF_RUNG_PUSH) && all->push.regions.count > 0;
    if (!tf_scope_find(&all->scope, &all->tangle,
                       knows ? &all->push.regions : NULL, rings))
        return TF_OUT_OF_MEMORY;
    tf_status status = tf_limit_moves(&all->tangle, &all->scope, all->x,
                                      all->change.move, all->next);
    if (status != TF_OK)
        return status;
    bool moved =
        memcmp(all->x, all->next, coordinates(all) * sizeof *all->x) != 0;
    double *swap = all->x;
    all->x = all->next;
    all->next = swap;
    all->rounds++;
    all->rungs |= moved ? (int)rung : 0;
    status = tf_tangle_follow(&all->tangle, all->next, all->x);
    if (status != TF_OK)
        return status;
    judge_round(all);
    if (!moved)
        all->idle = IDLE_ROUNDS + 1;
    return TF_OK;
}

//: Push for a round
static tf_status push_once(tf_attempts *all)
{
    if (!tf_change_begin(&all->change, &all->tangle))
        return TF_OUT_OF_MEMORY;
    if (!tf_push_propose(&all->push, &all->tangle, all->x, &all->change) ||
        !tf_change_finish(&all->change, &all->tangle))
        return tf_watch_failure(all->tangle.watch);
    return step(all, TF_RUNG_PUSH, SCOPE_RINGS);
}

//: Smooth for some rounds
static tf_status smooth(tf_attempts *all)
{
    tf_status status = TF_OK;
    for (int i = 0; i < SMOOTH_ROUNDS && status == TF_OK && !is_done(all);
         i++) {
        if (!tf_change_begin(&all->change, &all->tangle))
            return TF_OUT_OF_MEMORY;
        if (!tf_smooth(&all->change, &all->tangle, all->x, all->rings))
            return tf_watch_failure(all->tangle.watch);
        status = step(all, TF_RUNG_SMOOTH, SCOPE_RINGS + all->rings);
    }
    all->rings += all->rings < MOST_RINGS;
    all->idle = 0;
    return status;
}

//: Begin an attempt
static tf_status start(tf_attempts *all, const double from[])
{
    if (from != all->x)
        copy(all, all->x, from);
    all->few = (size_t)-1;
    all->idle = 0;
    all->rings = 1;
    return judge_state(all);
}

//: Extend an attempt
/// Until when an attempt goes on, unless it may extend it.
typedef struct span {
    int end;
    size_t half;
} span;

static span begin_span(const tf_attempts *all)
{
    int most = all->options->rounds > 0 ? all->options->rounds : USUAL_ROUNDS;
    return (span){all->rounds + most, all->few / 2};
}

static bool goes_on(const tf_attempts *all, span *own)
{
    if (all->extends && all->few <= own->half)
        *own = begin_span(all);
    return !is_done(all) && all->rounds < own->end;
}

//: Make an attempt
/// Pushes until that gets no further, smooths, and so on.
static tf_status attempt(tf_attempts *all, bool toggles)
{
    span own = begin_span(all);
    int smoothings = 0;
    tf_status status = TF_OK;
    while (status == TF_OK && goes_on(all, &own)) {
        if (may(all, TF_RUNG_PUSH) && all->idle <= IDLE_ROUNDS) {
            status = push_once(all);
            continue;
        }
        if (!may(all, TF_RUNG_SMOOTH) ||
            (may(all, TF_RUNG_PUSH) && smoothings++ == SMOOTHINGS))
            break;
        if (toggles)
            all->push.acute = !all->push.acute;
        status = smooth(all);
    }
    return status;
}

//: Relax the surface
/// Everything may pass through anything meanwhile, so that nothing limits it.
static tf_status relax(tf_attempts *all)
{
    const tf_neighbors *near = &all->tangle.near;
    int next = 0; // round with a check
    for (int round = 0; round < RELAX_ROUNDS && !is_done(all); round++) {
        if (!tf_change_begin(&all->change, &all->tangle))
            return TF_OUT_OF_MEMORY;
        if (!tf_smooth(&all->change, &all->tangle, all->x, INT_MAX))
            return tf_watch_failure(all->tangle.watch);
        for (int v = 0; v < near->vertices; v++)
            tf_put(near, all->x, v,
                   tf_vector_sum(tf_place(near, all->x, v), 1,
                                 all->change.move[v]));
        all->rounds++;
        all->rungs |= TF_RUNG_RELAX;
        if (round < next)
            continue;
        next = round + CHECK_EVERY + round / CHECK_PARTS;
        tf_status status = judge_state(all);
        if (status != TF_OK)
            return status;
    }
    return TF_OK;
}

//: Attempt it with the parts apart
static tf_status attempt_apart(tf_attempts *all)
{
    bool moved = false;
    tf_status status = start(all, all->tangle.in);
    if (status != TF_OK)
        return status;
    if (!tf_move_apart(&all->tangle, all->x, &moved))
        return tf_watch_failure(all->tangle.watch);
    if (!moved)
        return TF_OK;
    all->rungs |= TF_RUNG_APART;
    all->push.acute = false;
    status = start(all, all->x);
    return status == TF_OK ? attempt(all, true) : status;
}

//: Attempt it again from the input
static tf_status attempt_again(tf_attempts *all)
{
    all->push.acute = true;
    all->rungs |= TF_RUNG_AGAIN;
    tf_status status = start(all, all->tangle.in);
    return status == TF_OK ? attempt(all, false) : status;
}

/// From the input or, of several parts, from where they are.
static tf_status attempt_to_relax(tf_attempts *all)
{
    bool alone = all->tangle.near.parts == 1;
    tf_status status = start(all, alone ? all->tangle.in : all->best);
    return status == TF_OK ? relax(all) : status;
}

//: Try rung after rung
/// Whether a rung has its turn.
static bool is_next(const tf_attempts *all, tf_status status, int rung)
{
    return status == TF_OK && !is_done(all) && may(all, rung);
}

tf_status tf_attempt(tf_attempts *all)
{
    all->fewest = (size_t)-1;
    if (!tf_push_begin(&all->push, &all->tangle))
        return TF_OUT_OF_MEMORY;
    tf_status status = start(all, all->tangle.in);
    all->beyond = tf_tangle_beyond(&all->tangle);
    if (status == TF_OK)
        status = attempt(all, true);
    if (all->tangle.near.parts > 1 && is_next(all, status, TF_RUNG_APART))
        status = attempt_apart(all);
    if (is_next(all, status, TF_RUNG_AGAIN))
        status = attempt_again(all);
    if (is_next(all, status, TF_RUNG_RELAX))
        status = attempt_to_relax(all);
    return status;
}

void tf_attempts_free(tf_attempts *all)
{
    tf_push_free(&all->push);
    tf_change_free(&all->change);
    tf_scope_free(&all->scope);
}
