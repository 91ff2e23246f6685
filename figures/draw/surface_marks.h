// What of a surface is in contact, or intersects, as it is marked.
#ifndef FIG_DRAW_SURFACE_MARKS_H
#define FIG_DRAW_SURFACE_MARKS_H

#include "kit/surface_shape.h"
#include "surface/check.h"
#include "surface/contacts.h"

/// A place of contact: a point of an element, by the weights of its vertices.
typedef struct fig_spot {
    int vertices;
    int vertex[3];
    double weight[3];
    double toi; ///< from when on it is marked
} fig_spot;

/// All marks of a step, or of a surface at rest.
typedef struct fig_marks {
    bool at_rest;
    int count; ///< of pairs of elements
    fig_spot *spot;
    float *edge, *triangle; ///< of each: from when on it is in contact; NEVER
    double toi_lo, toi_hi;  ///< of the first contact
} fig_marks;

/// The time of elements that are in no contact.
#define FIG_NEVER 2.0F

/// Mark contacts of a step; mark intersections at rest.  False if there is no
/// memory; the marks are to be freed in any case.
bool fig_marks_of_contacts(fig_marks *marks, const fig_shape *shape,
                           const tf_contacts *contacts);
bool fig_marks_of_crossings(fig_marks *marks, const fig_shape *shape,
                            const tf_crossings *crossings);
void fig_marks_free(fig_marks *marks);

#endif
