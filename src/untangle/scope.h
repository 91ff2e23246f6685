//: Declare the scope of a round
#pragma once

#include "surface/contacts.h"
#include "untangle/regions.h"

/// The zones of one round: sets of connected facets around what crosses.
/// Within one anything may pass through anything, outside and between them
/// nothing may.
typedef struct tf_scope {
    int *zone;             ///< of each vertex: its zone, if it is `within`
    unsigned char *within; ///< of each vertex, then of each edge, then of each
                           ///< triangle: 1 if all facets at it are in its zone
    tf_buffer storage, marks;
} tf_scope;

/// Finds the zones of what crosses, of the wrong regions unless they are NULL,
/// and of some rings of neighbors.  False if there is no memory.
bool tf_scope_find(tf_scope *scope, const tf_tangle *tangle,
                   const tf_regions *regions, int rings);

void tf_scope_free(tf_scope *scope);

/// Marks the vertices of crossings, those of wrong regions unless they are
/// NULL, and some rings of neighbors: 1 more than the number of the ring, 0: in
/// none. NULL if there is no memory.
int *tf_mark_rings(tf_buffer *marks, const tf_tangle *tangle,
                   const tf_regions *regions, int rings);

/// Whether both elements of a contact are within one zone.
bool tf_scope_has(const tf_scope *scope, const tf_neighbors *all,
                  const tf_surface_contact *contact);
