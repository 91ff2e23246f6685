// Changes of a query after which the answer is known from that before.
#ifndef SUPPORT_QUERY_CHANGES_H
#define SUPPORT_QUERY_CHANGES_H

#include "support/queries.h"

#include <stdbool.h>

/// Name the axes anew: the k-th becomes the one before called `first` + k, or
/// `first` - k, modulo their number.
void query_turn_axes(query *q, int first, bool backward);

/// Negate one axis.
void query_mirror(query *q, int axis);

/// Swap the elements, where both have the same number of vertices.
void query_swap_elements(query *q);

/// Run time backward.  The vertices change places as well as the ends of the
/// step, each element's last for its first: the simplices of its staircase at
/// the time t are then those that were at 1 - t.
///
/// Index and place of each vertex stay, so that index order is the order of the
/// list after the change if it was before.
query query_reversed(const query *q);

/// Multiply all coordinates by 2^exponent if none loses a bit; false, with the
/// query unchanged, if one would.
bool query_change_unit(query *q, int exponent);

#endif
