#include "check.h"

#include "support/support.h"

#include <inttypes.h>
#include <stdio.h>

uint32_t shuffle(uint32_t x, uint32_t y);

/// Cards from one half and the other, the lowest first.
static uint32_t shuffled(uint32_t x, uint32_t y)
{
    uint32_t result = 0;
    for (int i = 0; i < 16; i++) {
        result += (x % 2) * (UINT32_C(1) << 2 * i);
        result += (y % 2) * (UINT32_C(2) << 2 * i);
        x /= 2;
        y /= 2;
    }
    return result;
}

static void expect(uint32_t x, uint32_t y)
{
    check_input("x = 0x%04" PRIx32 ", y = 0x%04" PRIx32, x, y);
    uint32_t expected = shuffled(x, y), got;
    check_value(got, shuffle(x, y));
    char text[16];
    snprintf(text, sizeof text, "0x%08" PRIx32, expected);
    check_that(got == expected, text, "0x%08" PRIx32, got);
}

TEST(single_bits)
{
    for (int i = 0; i < 16; i++) {
        expect(UINT32_C(1) << i, 0);
        expect(0, UINT32_C(1) << i);
    }
}

TEST(any_cell)
{
    generator random = generator_new(0);
    expect(5, 3);
    expect(0xffff, 0);
    for (int i = 0; i < 2000; i++)
        expect((uint32_t)below(&random, 65536),
               (uint32_t)below(&random, 65536));
}

void run_tests(void)
{
    check_run(1, single_bits);
    check_run(1, any_cell);
}
