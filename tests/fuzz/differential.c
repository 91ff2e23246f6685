// Any bytes as a query: the first byte gives the kind and how the others make
// coordinates, which are finite whatever the bytes.  The oracle is slow, so that
// it judges few; the answers to all have to agree with each other.
#include "arithmetic/clamped.h"
#include "arithmetic/exact.h"
#include "arithmetic/integer.h"
#include "support/fuzz_input.h"
#include "support/hash.h"
#include "support/invariants.h"
#include "support/judge.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/// An integer from -4 to 3, up to three units in the last place off.
static double near_lattice(fuzz_input *bytes)
{
    int byte = next_byte(bytes);
    return nudged_by_byte((byte & 7) - 4, byte);
}

static double any_double(fuzz_input *bytes)
{
    uint64_t bits = 0;
    for (int i = 0; i < 8; i++)
        bits = bits << 8 | (uint64_t)next_byte(bytes);
    double x;
    memcpy(&x, &bits, sizeof x);
    return isfinite(x) ? x : 0;
}

/// Multiply each axis by a power of two, from 2^-1024 to 2^1016.
static void scale_axes(fuzz_input *bytes, query *q)
{
    for (int axis = 0; axis < q->axes; axis++)
        query_scale(q, axis, 8 * next_byte(bytes) - 1024);
}

/// Integers of all sizes that are exact in 128 bits.
static void shear(fuzz_input *bytes, query *q)
{
    for (int i = 0; i < query_size(q); i++)
        *query_coordinate(q, i) = round(*query_coordinate(q, i));
    generator random = {(uint64_t)next_byte(bytes)};
    query_shear(&random, q, tf_arithmetic_bits(&tf_integer128, q->axes));
}

static query decode(fuzz_input *bytes)
{
    int first = next_byte(bytes), mode = first / KINDS % 4;
    query q = query_new((query_kind)(first % KINDS));
    for (int i = 0; i < query_size(&q); i++)
        *query_coordinate(&q, i) =
            mode == 1 ? any_double(bytes) : near_lattice(bytes);
    if (mode == 2)
        scale_axes(bytes, &q);
    if (mode == 3)
        shear(bytes, &q);
    query_number(&q);
    return q;
}

static void stop_at(const char *fault, const query *q)
{
    if (!fault)
        return;
    fprintf(stderr, "%s\n%s\n%s", fault, query_name(q), query_text(q));
    abort();
}

/// The oracle, and what it does not judge.
static void judge(const query *q)
{
    truth known;
    tf_contact contact;
    truth_init(&known);
    truth_find(q, &known);
    stop_at(exact_fault(q, &tf_exact, &known, &contact), q);
    stop_at(sound_fault(q, &tf_clamped, &known, &contact), q);
    truth_clear(&known);
}

enum {
    JUDGED = 1000 // one query in so many
};

/// perturbed_fault() as an invariant.
static const char *moved_fault(generator *random, const query *q,
                               const tf_contact *exact)
{
    (void)random;
    (void)exact;
    return perturbed_fault(q);
}

/// A query has to meet one of these, picked by the hash: others like it will
/// meet the others.
static invariant *const invariants[] = {
    change_fault, change_fault,   reversal_fault, reversal_fault,
    batch_fault,  integers_fault, clamped_fault,  moved_fault,
};

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz_input bytes = {data, size, {0}};
    query q = decode(&bytes);
    generator random = {hash_bytes(HASH_OF_NOTHING, data, size)};
    if (below(&random, JUDGED) == 0)
        judge(&q);
    tf_contact exact = ask(&tf_exact, &q);
    stop_at(contact_fault(&random, &q, &exact), &q);
    int count = (int)(sizeof invariants / sizeof *invariants);
    stop_at(invariants[below(&random, count)](&random, &q, &exact), &q);
    return 0;
}
