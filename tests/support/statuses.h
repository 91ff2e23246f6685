// The statuses that every query of a scene may return, tried one by one.
#ifndef SUPPORT_STATUSES_H
#define SUPPORT_STATUSES_H

#include "arithmetic/arithmetic.h"
#include "base/status.h"
#include "query/contact.h"
#include "query/motion.h"
#include "support/queries.h"

/// Queries the vertices of the indices vertex[], those of the first element
/// first.
typedef tf_status status_query(const tf_arithmetic *arithmetic,
                               const tf_motion *motion, const int vertex[],
                               tf_contact *contact);

/// What to try; called by the function that is given to statuses_case().
void statuses_use(query_kind kind, status_query *ask);

/// The tests of a query; `use` calls statuses_use().
TCase *statuses_case(const char *name, void (*use)(void));

/// The same for one that takes all doubles, whatever the arithmetic.  It does
/// not take NULL for it.
TCase *statuses_case_of_doubles(const char *name, void (*use)(void));

/// Makes a broken contract end the program with the status BROKEN_CONTRACT
/// instead of a signal, if the place and the condition are known.
void exit_on_broken_contract(void);

enum {
    BROKEN_CONTRACT = 7
};

#endif
