//: Declare contracts and statuses
#ifndef TF_CONTRACT_H
#define TF_CONTRACT_H

#include <float.h>
#include <stdbool.h>

//: Refuse a compiler that rewrites floating-point arithmetic
#ifdef __FAST_MATH__
#error "tanglefree: exact signs need IEEE arithmetic; drop -ffast-math"
#endif
#if FLT_EVAL_METHOD != 0
#error "tanglefree: doubles must be evaluated as doubles (-msse2 -mfpmath=sse)"
#endif

//: Declare the statuses
/// What a call that can fail on its input returns; zero is success.
typedef enum tf_status {
    TF_OK = 0,
    TF_NOT_FINITE,   ///< a coordinate is a NaN or an infinity
    TF_OUT_OF_RANGE, ///< a coordinate is beyond what the arithmetic holds
} tf_status;

/// A sentence for a status: what is wrong and how to mend it.  Static storage.
const char *tf_status_message(tf_status status);

//: Declare the broken contract
/// Called with the place and the text of a contract that its caller broke.
/// The program is aborted if the handler returns.
typedef void tf_contract_handler(const char *file, int line,
                                 const char *condition);

/// Replace the handler (NULL: the default, which prints to standard error).
/// Returns the one before.  Not for concurrent use.
tf_contract_handler *tf_contract_set_handler(tf_contract_handler *handler);

/// Call the handler, then abort.  Used by TF_REQUIRE.
_Noreturn void tf_contract_broken(const char *file, int line,
                                  const char *condition);

/// A condition that callers promise; checked in every build.
#define TF_REQUIRE(condition)                                                  \
    ((condition) ? (void)0 : tf_contract_broken(__FILE__, __LINE__, #condition))

//: Declare the test of the floating-point environment
/// Whether the processor rounds to nearest and keeps subnormal numbers.  A
/// library built with -ffast-math, once linked, can switch subnormals off for
/// the whole program.
bool tf_environment_is_ieee(void);

//: Close the contracts
#endif
