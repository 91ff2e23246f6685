//: Declare the clock
#pragma once

/// Seconds since some time in the past, which never jump.
double tf_clock_seconds(void);
