#include "support/bytes.h"

#include "support/support.h"

#include <string.h>

static void put(bytes *to, const void *from, size_t size)
{
    // The machine's own order is the little one, or the reverse is put.
    const char *byte = from;
    static const short one = 1;
    bool reverse = to->big == *(const char *)&one;
    ck_assert_uint_le(to->count + size, sizeof to->at);
    for (size_t i = 0; i < size; i++)
        to->at[to->count++] = byte[reverse ? size - 1 - i : i];
}

void put_text(bytes *to, const char *text)
{
    ck_assert_uint_le(to->count + strlen(text), sizeof to->at);
    memcpy(to->at + to->count, text, strlen(text));
    to->count += strlen(text);
}

void put_double(bytes *to, double x)
{
    put(to, &x, sizeof x);
}

void put_float(bytes *to, float x)
{
    put(to, &x, sizeof x);
}

void put_int(bytes *to, int size, int64_t number)
{
    uint64_t bits = (uint64_t)number;
    for (int i = 0; i < size; i++) {
        int shift = to->big ? size - 1 - i : i;
        to->at[to->count++] = (char)(bits >> 8 * shift);
    }
}
