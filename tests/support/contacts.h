// Comparing the answers to two queries.
#ifndef SUPPORT_CONTACTS_H
#define SUPPORT_CONTACTS_H

#include "query/contact.h"

#include <stdbool.h>

/// Whether all numbers are the same; where rounded arithmetic gives up, both
/// NaN.
bool contacts_are_same(const tf_contact *a, const tf_contact *b);

/// Whether the intervals of the two times may enclose one and the same time.
bool contacts_share_time(const tf_contact *a, const tf_contact *b);

#endif
