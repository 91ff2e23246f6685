//: Declare the contract handler
#pragma once

#include "base/api.h"

/// @addtogroup trouble Statuses and contracts
/// @{

/// Called when a caller breaks the contract of a function in a way that no
/// data can excuse.  No pointer that a function takes may be null unless its
/// documentation allows it.  When the handler returns, the program is aborted.
/// It may be called from any thread.
/// @param file the file of the library that holds the condition
/// @param line the line in that file
/// @param condition the condition that does not hold, as C
typedef void tf_contract_handler(const char *file, int line,
                                 const char *condition);

/// Replaces the handler for the whole program.  Thread-safe.
/// @param handler the new handler, or NULL to restore the default, which prints
///     to standard error
/// @return the handler before
TF_API tf_contract_handler *
tf_contract_set_handler(tf_contract_handler *handler);

/// @}
