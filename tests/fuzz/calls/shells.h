// Calls about adaptive surfaces and flows.
#ifndef FUZZ_CALLS_SHELLS_H
#define FUZZ_CALLS_SHELLS_H

#include "arguments.h"

typedef struct shell {
    tf_adaptive_surface *surface; ///< NULL: there is no shell
    tf_flow *flow;                ///< of the surface, or NULL
    double unit;                  ///< about the length of its first edges
} shell;

/// Tries to make a surface of a mesh that may be bad; if it succeeds, the shell
/// is replaced by it, and otherwise left.
void call_adaptive_create(generator *random, shell *of);

/// Each makes a call about a shell and judges it: what has failed or is refused
/// has changed nothing, and what is done has left an embedded surface.  It is
/// an operation,
void call_operation(generator *random, shell *of);

/// a compaction,
void call_compact(generator *random, shell *of);

/// remeshing,
void call_remesh(generator *random, shell *of);

/// reconnecting,
void call_reconnect(generator *random, shell *of);

/// the beginning of a flow, or its end,
void call_flow(generator *random, shell *of);

/// or a step of it.
void call_flow_step(generator *random, shell *of);

void shell_free(shell *of);

#endif
