//: Declare interruptions
#pragma once

/// Holds back the signals that ask the program to end, such as that of Ctrl-C,
/// so that it can finish what it is doing.  It must ask for them often.
void tf_interruption_hold(void);

/// The signal that asks the program to end; 0: none does.  A signal that is
/// ignored, as in the background, asks for nothing.
int tf_interruption(void);
