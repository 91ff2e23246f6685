// Whether a text is JSON, strictly: no NaN, no infinity.
#ifndef SUPPORT_JSON_H
#define SUPPORT_JSON_H

#include <stddef.h>

/// Where a text breaks the rules of JSON; NULL if it is one value and white
/// space around it.
const char *json_fault(const char *text);

#endif
