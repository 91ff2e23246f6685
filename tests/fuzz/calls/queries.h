// Calls about a few vertices, which need no object.
#ifndef FUZZ_CALLS_QUERIES_H
#define FUZZ_CALLS_QUERIES_H

#include "support/generator.h"

/// Each makes one call, with arguments of its own, and judges it: a query,
void call_query(generator *random);

/// one by another method,
void call_linear_query(generator *random);

/// the advancement of rigid elements,
void call_rigid_advance(generator *random);

/// many queries by both narrow phases,
void call_narrow_phase(generator *random);

/// many queries at once,
void call_batch(generator *random);

/// a filter,
void call_filter(generator *random);

/// a solver of a zone,
void call_solver(generator *random);

/// or what describes statuses, errors and arithmetics.
void call_describe(generator *random);

#endif
