//: Declare the verdicts
#pragma once

#include "base/api.h"

/// @addtogroup contacts Contacts
/// @{

/// Whether two closed moving elements have a point in common at some time of
/// the step, its ends included.
typedef enum tf_verdict {
    TF_UNDECIDED = 0, ///< a contact cannot be excluded (tf_clamped only)
    TF_APART,         ///< they do not
    TF_HIT,           ///< they do
} tf_verdict;

/// How a contact was found.
typedef enum tf_classification {
    TF_UNCLASSIFIED = 0, ///< there is no contact
    TF_GENERIC,          ///< by barycentric signs, none of them zero
    TF_TOUCHING,         ///< by barycentric signs, some zero or unknown
    TF_DEGENERATE,       ///< all signs are zero: by lower dimensions
} tf_classification;

/// @}
