//: Declare the output about surfaces
#pragma once

#include "surface/check.h"
#include "surface/detect.h"

#include <stdbool.h>
#include <stdio.h>

//: Declare the formats
typedef struct tf_surface_format tf_surface_format;

/// The names that tf_surface_format_named accepts, for help and messages.
#define TF_SURFACE_FORMAT_NAMES "csv, json or summary"

/// The format of that name; NULL if there is none.
const tf_surface_format *tf_surface_format_named(const char *name);

//: Declare the output
/// What an output has counted.
typedef struct tf_surface_tally {
    long parts;   ///< files checked, or steps
    long tangled; ///< of these, with rows
    long rows;
    tf_detect_statistics statistics; ///< of detection
} tf_surface_tally;

typedef struct tf_surface_output {
    FILE *stream;
    const tf_surface_format *format;
    bool checks; ///< whether rows are intersections, not contacts
    int error;   ///< the errno of the first write that failed, or 0
    tf_surface_tally tally;
} tf_surface_output;

/// Writes what comes before all rows, the rows of one step or file, and what
/// comes after them; the last also flushes.  False after a write that failed.
bool tf_surface_output_begin(tf_surface_output *output, FILE *stream,
                             const tf_surface_format *format, bool checks);
bool tf_surface_output_contacts(tf_surface_output *output, int axes,
                                const tf_contacts *contacts);
bool tf_surface_output_crossings(tf_surface_output *output, const char *file,
                                 const tf_crossings *crossings);
bool tf_surface_output_end(tf_surface_output *output);
