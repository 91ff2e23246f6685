//: Declare the output about responses
#pragma once

#include "response/options.h"

#include <stdbool.h>
#include <stdio.h>

typedef struct tf_response_format tf_response_format;

/// The names that tf_response_format_named accepts, for help and messages.
#define TF_RESPONSE_FORMAT_NAMES "summary or json"

/// The format of that name; NULL if there is none.
const tf_response_format *tf_response_format_named(const char *name);

/// Writes what it took to resolve a step, and how many seconds, and flushes.
/// False, with errno, if a write failed.
bool tf_response_output_write(FILE *stream, const tf_response_format *format,
                              const tf_response_report *report, double seconds);
