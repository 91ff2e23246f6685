// Calls about surfaces and resolvers.
#ifndef FUZZ_CALLS_SURFACES_H
#define FUZZ_CALLS_SURFACES_H

#include "bodies.h"

/// Tries to make a surface of a mesh that may be bad; if it succeeds, the body
/// is replaced by it, and otherwise left.
void call_create(generator *random, body *of);

/// Each makes a call about a body and judges it, and after some failures the
/// body as well: makes a resolver, or frees it,
void call_resolver(generator *random, body *of);

/// filters its pairs,
void call_filter_pairs(generator *random, body *of);

/// detects the contacts of a step,
void call_detect(generator *random, body *of);

/// lists the candidates,
void call_candidates(generator *random, body *of);

/// checks a position,
void call_check(generator *random, body *of);

/// asks for what the surface lends,
void call_lend(generator *random, body *of);

/// resolves a step,
void call_resolve(generator *random, body *of);

/// limits it,
void call_limit(generator *random, body *of);

/// untangles a position,
void call_untangle(generator *random, body *of);

/// or finds its zones.
void call_zones(generator *random, body *of);

#endif
