// Any bytes as a query, judged by the oracle: the first byte tells the kind and
// how the others make coordinates, which are finite whatever the bytes.
#include "arithmetic/clamped.h"
#include "arithmetic/exact.h"
#include "support/judge.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/// What is left of the bytes; zeros after their end.
typedef struct input {
    const uint8_t *byte;
    size_t left;
} input;

static int next_byte(input *bytes)
{
    if (bytes->left == 0)
        return 0;
    bytes->left--;
    return *bytes->byte++;
}

/// An integer from -4 to 3, up to three units in the last place off.
static double near_lattice(input *bytes)
{
    int byte = next_byte(bytes);
    double x = (byte & 7) - 4;
    for (int steps = byte >> 4 & 3; steps > 0; steps--)
        x = nextafter(x, byte & 64 ? INFINITY : -INFINITY);
    return x;
}

static double any_double(input *bytes)
{
    uint64_t bits = 0;
    for (int i = 0; i < 8; i++)
        bits = bits << 8 | (uint64_t)next_byte(bytes);
    double x;
    memcpy(&x, &bits, sizeof x);
    return isfinite(x) ? x : 0;
}

/// Multiply each axis by a power of two, from 2^-1024 to 2^1016.
static void scale_axes(input *bytes, query *q)
{
    for (int axis = 0; axis < q->axes; axis++)
        query_scale(q, axis, 8 * next_byte(bytes) - 1024);
}

static query decode(input *bytes)
{
    int first = next_byte(bytes), mode = first / KINDS % 3;
    query q = query_new((query_kind)(first % KINDS));
    for (int i = 0; i < query_size(&q); i++)
        *query_coordinate(&q, i) =
            mode == 1 ? any_double(bytes) : near_lattice(bytes);
    if (mode == 2)
        scale_axes(bytes, &q);
    return q;
}

static void stop_at(const char *fault, const query *q)
{
    if (!fault)
        return;
    fprintf(stderr, "%s\n%s\n%s", fault, query_name(q), query_text(q));
    abort();
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    input bytes = {data, size};
    query q = decode(&bytes);
    truth known;
    tf_contact contact;
    truth_init(&known);
    truth_find(&q, &known);
    stop_at(exact_fault(&q, &tf_exact, &known, &contact), &q);
    stop_at(sound_fault(&q, &tf_clamped, &known, &contact), &q);
    query_number(&q);
    stop_at(perturbed_fault(&q), &q);
    truth_clear(&known);
    return 0;
}
