// Proposals as steps that are being resolved.
#ifndef SUPPORT_PROPOSAL_STEPS_H
#define SUPPORT_PROPOSAL_STEPS_H

#include "response/contact_constraint.h"
#include "support/proposals.h"
#include "surface/surface.h"

/// The step of a proposal, with its surface.
typedef struct proposal_step {
    tf_surface *surface;
    tf_step step;
    tf_contact_rule rule; ///< without separation, from the proposed ends
    double end[3 * PROPOSAL_VERTICES];
    double unpushed[3 * PROPOSAL_VERTICES];
    unsigned char flags[PROPOSAL_VERTICES];
} proposal_step;

/// Refers to the proposal, and to `s` itself; to be freed.
void proposal_step_begin(proposal_step *s, const proposal *made);
void proposal_step_free(proposal_step *s);

/// All contacts from the start to the ends so far, lent by the surface.
tf_contacts proposal_step_contacts(proposal_step *s);

/// Whether a vertex no longer ends where it was proposed to, and how many do
/// not.
bool proposal_step_has_moved(const proposal_step *s, int vertex);
int proposal_step_changes(const proposal_step *s);

#endif
