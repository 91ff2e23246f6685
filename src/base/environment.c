//: Include what the environment check needs
#include "base/environment.h"

#include <math.h>
#include <stdint.h>
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

//: Check the control register of x86
#if defined __SSE2__

static bool is_set_to_ieee(void)
{
    enum {
        DENORMALS_ARE_ZERO = 1 << 6,
        ROUNDING_CONTROL = 3 << 13, // 0: to nearest
        FLUSH_TO_ZERO = 1 << 15
    };
    return (_mm_getcsr() &
            (DENORMALS_ARE_ZERO | ROUNDING_CONTROL | FLUSH_TO_ZERO)) == 0;
}

//: Check the control register of ARM
#elif defined __aarch64__

static bool is_set_to_ieee(void)
{
    enum {
        FLUSH_INPUTS_TO_ZERO = 1 << 0,
        ROUNDING_MODE = 3 << 22, // 0: to nearest
        FLUSH_TO_ZERO = 1 << 24
    };
    uint64_t control;
    __asm__ volatile("mrs %0, fpcr" : "=r"(control));
    return (control & (FLUSH_INPUTS_TO_ZERO | ROUNDING_MODE | FLUSH_TO_ZERO)) ==
           0;
}

//: Check other processors by an experiment
#else

static bool is_set_to_ieee(void)
{
    // Volatile, so that the processor computes this, not the compiler.
    volatile double tiny = 0x1p-60, smallest_normal = DBL_MIN;
    volatile double next = DBL_MIN + DBL_TRUE_MIN;

    // Every rounding but to nearest distinguishes 1 + tiny from 1 - tiny.
    bool to_nearest = 1 + tiny == 1 - tiny;
    bool keeps_subnormals = next - smallest_normal != 0;
    return to_nearest && keeps_subnormals;
}

#endif

//: Check what the compiler has made of the code
/// Whether operations are executed as they are written, each with its rounding,
/// given that the processor rounds to nearest.
static bool is_compiled_as_written(void)
{
    // Volatile, so that the processor computes this, not the compiler.
    static const volatile double given[] = {0x1p-60, 1 + 0x1p-30, -0.0, NAN};
    double tiny = given[0], near_one = given[1], zero = given[2];
    bool sums = (near_one + tiny) - near_one == 0;
    bool products = near_one * near_one - (1 + 0x1p-29) == 0;
    bool quotients = near_one / 3 != near_one * (1.0 / 3);
    bool zeros = copysign(1, zero + 0.0) > 0;
    bool numbers = isnan(given[3]);
    return sums && products && quotients && zeros && numbers;
}

//: Check the floating-point environment
bool tf_environment_is_ieee(void)
{
    return is_set_to_ieee() && is_compiled_as_written();
}
