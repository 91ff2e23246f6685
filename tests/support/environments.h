// Floating-point environments that break the proofs.
#ifndef SUPPORT_ENVIRONMENTS_H
#define SUPPORT_ENVIRONMENTS_H

#include <stdbool.h>

/// How many there are: the directed roundings, and where the processor has a
/// switch for them, subnormal results and subnormal operands taken for zero.
int environments(void);

/// What the i-th is called.
const char *environment_name(int i);

/// Switches the calling thread to the i-th, until environment_restore().
void environment_break(int i);

/// Whether the calling thread still is in the i-th.
bool environment_is_broken(int i);

void environment_restore(void);

#endif
