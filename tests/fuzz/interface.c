// Any bytes as calls of the interface: each eight of them are one, which object
// it is about and what arguments it has, right and wrong ones.  Whatever they
// are, each status is one that the header lists and that fits what is wrong,
// a call that fails has set nothing and done nothing, and the object then
// answers as a new one does.  TF_JOURNAL (environment) lists the calls.
#include "calls/allocator.h"
#include "calls/queries.h"
#include "calls/surfaces.h"

#include "support/hash.h"

enum {
    BYTES = 8,  ///< of a call
    CALLS = 32, ///< at most
    BODIES = 3
};

typedef void stateless_call(generator *random);
typedef void body_call(generator *random, body *of);

static stateless_call *const stateless[] = {
    call_query,        call_linear_query, call_rigid_advance,
    call_narrow_phase, call_batch,        call_filter,
    call_solver,       call_describe,     call_allocator,
};

static body_call *const about_bodies[] = {
    call_create,  call_create,  call_resolver, call_filter_pairs, call_detect,
    call_detect,  call_detect,  call_detect,   call_candidates,   call_check,
    call_check,   call_lend,    call_resolve,  call_resolve,      call_resolve,
    call_resolve, call_resolve, call_limit,    call_limit,
};

enum {
    STATELESS = sizeof stateless / sizeof *stateless,
    ABOUT_BODIES = sizeof about_bodies / sizeof *about_bodies
};

/// A body must exist before it can be used.
static void call_about_body(int which, generator *random, body *of)
{
    about_bodies[of->surface ? which : 0](random, of);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static body bodies[BODIES];
    allocator_begin();
    for (int i = 0; i < CALLS && size >= BYTES; i++) {
        generator random = {hash_bytes(HASH_OF_NOTHING, data + 2, BYTES - 2)};
        int which = data[0] % (STATELESS + ABOUT_BODIES);
        if (which < STATELESS)
            stateless[which](&random);
        else
            call_about_body(which - STATELESS, &random,
                            &bodies[data[1] % BODIES]);
        data += BYTES;
        size -= BYTES;
    }
    for (int i = 0; i < BODIES; i++)
        body_free(&bodies[i]);
    allocator_end();
    return 0;
}
