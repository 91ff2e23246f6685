// Proposals as steps that are being resolved.
#ifndef SUPPORT_STEPPED_H
#define SUPPORT_STEPPED_H

#include "response/contact_constraint.h"
#include "support/proposals.h"
#include "surface/surface.h"

/// The step of a proposal, with its surface.
typedef struct stepped {
    tf_surface *surface;
    tf_step step;
    tf_contact_rule rule; ///< without separation, from the proposed ends
    double end[3 * PROPOSAL_VERTICES];
    double looked[3 * PROPOSAL_VERTICES];
} stepped;

/// Refers to the proposal, and to `of` itself; to be freed.
void stepped_begin(stepped *of, const proposal *made);
void stepped_free(stepped *of);

/// All contacts from the start to the ends so far, lent by the surface.
tf_contacts stepped_contacts(stepped *of);

/// Whether a vertex has moved since contacts were last looked for, and how many
/// have.
bool stepped_has_moved(const stepped *of, int vertex);
int stepped_changes(const stepped *of);

#endif
