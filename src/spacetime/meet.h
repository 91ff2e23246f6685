//: Declare the cascade
#ifndef TF_SPACETIME_MEET_H
#define TF_SPACETIME_MEET_H

#include "spacetime/complementary.h"

//: Declare the earlier of two meetings
/// The earliest point of two pairs together, from what is known of each.
/// Weights are those of the one that may come first; `a` in a tie.
tf_meeting tf_meeting_earlier(const tf_meeting *a, const tf_meeting *b);

//: Declare the meeting of two swept simplices
/// The verdict and the earliest point of two closed simplices that both span
/// t = 0 to t = 1, with axes + 3 events, degenerate in any way.  Exact when the
/// signs are; with unknown signs TF_UNDECIDED, never TF_APART, where a contact
/// is possible.
tf_meeting tf_meet(const tf_arithmetic *arithmetic, const tf_pair *pair);

//: Close the cascade
#endif
