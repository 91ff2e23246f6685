//: Declare the output about surfaces
#pragma once

#include "distance/near_pairs.h"
#include "files/record.h"
#include "surface/check.h"
#include "surface/contacts.h"

/// What an output has counted.
typedef struct tf_surface_tally {
    size_t parts;                    ///< files checked, or steps
    size_t tangled;                  ///< of these, with rows
    size_t rows;                     ///< but for those of near pairs
    size_t near;                     ///< pairs
    tf_detect_statistics statistics; ///< of detection
} tf_surface_tally;

typedef struct tf_surface_output {
    tf_records records;
    bool checks;   ///< whether rows are intersections, not contacts
    bool measures; ///< whether near pairs are among them
    tf_surface_tally tally;
} tf_surface_output;

//: Declare how to write about surfaces
/// Write what comes before all rows, the rows of one step or file, and what
/// comes after them; the last also flushes.  False after a write that failed.
bool tf_surface_output_begin(tf_surface_output *output, FILE *stream,
                             tf_format format, bool checks, bool measures);
bool tf_surface_output_contacts(tf_surface_output *output, int axes,
                                const tf_contacts *contacts);
bool tf_surface_output_crossings(tf_surface_output *output, const char *file,
                                 const tf_crossings *crossings);

/// Comes after the intersections of the same file, which may be `tangled`.
bool tf_surface_output_near(tf_surface_output *output, const char *file,
                            bool tangled, const tf_near_pairs *pairs);
bool tf_surface_output_end(tf_surface_output *output);
