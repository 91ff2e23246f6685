//: Require what callers promise
#pragma once

/// Calls the contract handler, then aborts.
_Noreturn void tf_contract_broken(const char *file, int line,
                                  const char *condition);

/// A condition that callers promise; checked in every build.
#define TF_REQUIRE(condition)                                                  \
    ((condition) ? (void)0 : tf_contract_broken(__FILE__, __LINE__, #condition))
