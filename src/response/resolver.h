//: Declare resolvers
#pragma once

#include "base/api.h"
#include "base/status.h"
#include "response/options.h"
#include "surface/surface.h"

#include <stddef.h>

/// @addtogroup response
/// @{

/// The memory for responding to the contacts of a surface, kept from one step to
/// the next.  Only one thread at a time may use a resolver.
typedef struct tf_resolver tf_resolver;

/// Makes a resolver.
///
/// @param surface the surface, borrowed: it must live until the resolver is
///     freed, and each step overwrites what the surface has lent
/// @param[out] resolver the resolver, to be freed by tf_resolver_free; set only
///     with TF_OK
/// @return TF_OK or TF_OUT_OF_MEMORY
TF_API tf_status tf_resolver_create(tf_surface *surface,
                                    tf_resolver **resolver);

/// Frees a resolver, but not its surface.
/// @param resolver the resolver; may be NULL
TF_API void tf_resolver_free(tf_resolver *resolver);

/// Returns how much memory a resolver holds by now, without its surface.
/// @param resolver the resolver
/// @return bytes
TF_API size_t tf_resolver_memory(const tf_resolver *resolver);

//: Declare what a resolver tells of its last step
/// Lists the contacts that the last step had on its way to being resolved:
/// those of the proposal, those that were made by answering them, and so on.
/// A contact that came back is there once for each time that it was answered;
/// in zones the impulses of all these times act together.  If scripted
/// vertices were held back, the contacts are those of the step as it was
/// shortened.
///
/// @param resolver the resolver
/// @param[out] count how many; 0 if the step was clear, or if the resolver's last
///     call did not resolve a step; set only with TF_OK
/// @param[out] contact they, sorted by kind, then by vertices, then by substep,
///     level and round, lent until the next call for this resolver; the same bits
///     for any number of threads; set only with TF_OK
/// @return TF_OK or TF_OUT_OF_MEMORY
TF_API tf_status tf_resolver_contacts(tf_resolver *resolver, size_t *count,
                                      const tf_answered_contact **contact);

/// Returns what the last step's response did with each vertex: a sum of
/// tf_vertex_flag, 0 where nothing was done.
///
/// @param resolver the resolver
/// @return a number for each vertex of the surface, lent until the next call for
///     this resolver; NULL if its last call did not resolve a step
TF_API const unsigned char *tf_resolver_vertices(const tf_resolver *resolver);

//: Declare what a resolver tells of scripts
/// Returns how far the scripted vertices of the last step followed their scripts:
/// of each vertex the fraction, from 0 to 1, of the way from its start to its
/// proposed end, on which it ends.  It is 1 for those that were not held back,
/// and for all that are not scripted.
///
/// @param resolver the resolver
/// @return a fraction for each vertex of the surface, lent until the next call
///     for this resolver; NULL if its last call did not resolve a step
TF_API const double *tf_resolver_followed(const tf_resolver *resolver);

//: Declare what a resolver tells of pushes
/// Returns where the vertices would end in the last step if no pair were pushed
/// apart: the step's motion, from which velocities follow, as those of the
/// vertices after the step are
///
///     (unpushed - start) / dt,
///
/// where dt is the time that the step takes.  Go on from `end`, as elements may
/// meet on the way to these positions.  They are those of `end` where no pair was
/// pushed apart: up to rounding, or bit for bit in a step without contacts.  In
/// substeps they are the motion of the last one, if it went on for all the step.
///
/// @param resolver the resolver
/// @return `axes` coordinates for each vertex of the surface, lent until the next
///     call for this resolver; NULL if its last call did not resolve a step
TF_API const double *tf_resolver_unpushed(const tf_resolver *resolver);

/// Lists how hard the pairs of tf_resolver_contacts were pushed apart.  A push
/// adds
///
///     inverse_mass_i coefficient[i] push normal
///
/// to where vertex[i] of the contact ends, and nothing to its velocity.
///
/// @param resolver the resolver
/// @param[out] count how many: as many as there are contacts; set only with TF_OK
/// @param[out] push that of each contact, in the same order, in units of mass
///     times length; at least 0; lent until the next call for this resolver; set
///     only with TF_OK
/// @return TF_OK or TF_OUT_OF_MEMORY
TF_API tf_status tf_resolver_pushes(tf_resolver *resolver, size_t *count,
                                    const double **push);

/// @}
