// What an answer's process may do: compute, print a little, and read files.
#ifndef EXERCISES_CONFINE_H
#define EXERCISES_CONFINE_H

#include <stdbool.h>

/// Confine this process and whatever it executes from now on, for good: it can
/// read files but neither write, rename nor delete any, start no process or
/// thread, send no signal but to itself, open no connection, and regain no
/// right of root's.  Calls that would are refused with EPERM.  Its processor
/// time and what it prints to a file are limited; beyond that it is killed by
/// SIGXCPU or SIGXFSZ.  Not limited: memory and waiting.  False if the kernel
/// cannot do it.
bool confine(void);

#endif
