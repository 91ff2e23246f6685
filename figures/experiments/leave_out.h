// Surgery without some of its tests, to see what each of them is needed for.
//
// The library always does all tests.  In the programs of the figures and the
// tests the linker puts the functions __wrap_NAME of this folder in the place of
// the library's functions NAME, which are __real_NAME there (ld's option --wrap).
#ifndef FIG_LEAVE_OUT_H
#define FIG_LEAVE_OUT_H

#include "surgery/outcome.h"

#include <stdbool.h>

/// From now on surgery leaves out the tests that refuse with some outcomes, a
/// bit 1 << outcome for each; with 0 it leaves out none, as at the start.
void leave_out(unsigned outcomes);

/// Whether the test that refuses with an outcome is left out.
bool is_left_out(tf_outcome outcome);

#endif
