// Any bytes as calls of the interface: each eight of them are one, which object
// it is about and what arguments it has, right and wrong ones.  Whatever they
// are, each status is one that the header lists and that fits what is wrong,
// a call that fails has set nothing and done nothing, and the object then
// answers as a new one does.  TF_JOURNAL (environment) lists the calls.
#include "calls/allocator.h"
#include "calls/queries.h"
#include "calls/shells.h"
#include "calls/surfaces.h"

#include "support/hash.h"

enum {
    BYTES = 8,  ///< of a call
    CALLS = 32, ///< at most
    BODIES = 3,
    SHELLS = 2
};

typedef void stateless_call(generator *random);
typedef void body_call(generator *random, body *of);
typedef void shell_call(generator *random, shell *of);

static stateless_call *const stateless[] = {
    call_query,        call_linear_query, call_rigid_advance,
    call_narrow_phase, call_batch,        call_filter,
    call_solver,       call_describe,     call_allocator,
};

static body_call *const about_bodies[] = {
    call_create,     call_create,  call_resolver, call_filter_pairs,
    call_detect,     call_detect,  call_detect,   call_detect,
    call_candidates, call_check,   call_check,    call_lend,
    call_resolve,    call_resolve, call_resolve,  call_resolve,
    call_resolve,    call_limit,   call_limit,    call_untangle,
    call_untangle,   call_zones,
};

static shell_call *const about_shells[] = {
    call_adaptive_create, call_operation, call_operation, call_operation,
    call_operation,       call_operation, call_operation, call_operation,
    call_compact,         call_remesh,    call_reconnect, call_flow,
    call_flow_step,       call_flow_step,
};

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))

/// An object must exist before it can be used.
static void make_call(int which, int object, generator *random, body bodies[],
                      shell shells[])
{
    body *b = &bodies[object % BODIES];
    shell *s = &shells[object % SHELLS];
    int about_body = which - COUNT(stateless);
    int about_shell = about_body - COUNT(about_bodies);
    if (about_shell >= 0)
        about_shells[s->surface ? about_shell : 0](random, s);
    else if (about_body >= 0)
        about_bodies[b->surface ? about_body : 0](random, b);
    else
        stateless[which](random);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static body bodies[BODIES];
    static shell shells[SHELLS];
    allocator_begin();
    for (int i = 0; i < CALLS && size >= BYTES; i++) {
        generator random = {hash_bytes(HASH_OF_NOTHING, data + 2, BYTES - 2)};
        int calls =
            COUNT(stateless) + COUNT(about_bodies) + COUNT(about_shells);
        make_call(data[0] % calls, data[1], &random, bodies, shells);
        data += BYTES;
        size -= BYTES;
    }
    for (int i = 0; i < BODIES; i++)
        body_free(&bodies[i]);
    for (int i = 0; i < SHELLS; i++)
        shell_free(&shells[i]);
    allocator_end();
    return 0;
}
