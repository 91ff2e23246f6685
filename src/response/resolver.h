//: Declare resolvers
#pragma once

#include "base/api.h"
#include "base/status.h"
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

/// @}
