#include "support/environments.h"

#include <fenv.h>
#include <stdint.h>
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

#if defined __SSE2__

static unsigned register_value(void)
{
    return _mm_getcsr();
}

static void set_register(unsigned value)
{
    _mm_setcsr(value);
}

enum {
    FLUSH_TO_ZERO = 1 << 15,
    DENORMALS_ARE_ZERO = 1 << 6
};

#elif defined __aarch64__

static unsigned register_value(void)
{
    uint64_t value;
    __asm__ volatile("mrs %0, fpcr" : "=r"(value));
    return (unsigned)value;
}

static void set_register(unsigned value)
{
    __asm__ volatile("msr fpcr, %0" : : "r"((uint64_t)value));
}

enum {
    FLUSH_TO_ZERO = 1 << 24, // operands and results
    DENORMALS_ARE_ZERO = 0
};

#else

static unsigned register_value(void)
{
    return 0;
}

static void set_register(unsigned value)
{
    (void)value;
}

enum {
    FLUSH_TO_ZERO = 0, // there is no such switch
    DENORMALS_ARE_ZERO = 0
};

#endif

/// A rounding, and the bits that are set in the control register besides.
typedef struct environment {
    const char *name;
    int rounding;
    unsigned bits;
} environment;

static const environment all[] = {
    {"upward", FE_UPWARD, 0},
    {"downward", FE_DOWNWARD, 0},
    {"toward zero", FE_TOWARDZERO, 0},
#if defined __SSE2__ || defined __aarch64__
    {"flush to zero", FE_TONEAREST, FLUSH_TO_ZERO},
#endif
#ifdef __SSE2__
    {"denormals are zero", FE_TONEAREST, DENORMALS_ARE_ZERO},
    {"as -ffast-math", FE_TONEAREST, FLUSH_TO_ZERO | DENORMALS_ARE_ZERO},
#endif
};

/// The bits of the control register that an environment may set.
static unsigned control(void)
{
    return register_value() & (FLUSH_TO_ZERO | DENORMALS_ARE_ZERO);
}

static void set_control(unsigned bits)
{
    set_register((register_value() ^ control()) | bits);
}

int environments(void)
{
    return (int)(sizeof all / sizeof *all);
}

const char *environment_name(int i)
{
    return all[i].name;
}

void environment_break(int i)
{
    fesetround(all[i].rounding);
    set_control(all[i].bits);
}

bool environment_is_broken(int i)
{
    return fegetround() == all[i].rounding && control() == all[i].bits;
}

void environment_restore(void)
{
    fesetround(FE_TONEAREST);
    set_control(0);
}
