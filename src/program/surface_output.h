//: Declare the output about surfaces
#pragma once

#include "distance/near_pairs.h"
#include "files/record.h"
#include "scenes/joined.h"
#include "surface/check.h"
#include "surface/contacts.h"

/// What an output has counted.
typedef struct tf_surface_tally {
    size_t parts;                    ///< files or frames checked, or steps
    size_t tangled;                  ///< of these, with rows
    size_t rows;                     ///< but for those of near pairs
    size_t near;                     ///< pairs
    tf_detect_statistics statistics; ///< of detection
} tf_surface_tally;

/// What rows name besides the elements.
typedef enum tf_row_names {
    TF_NAMES_OF_FILE = 0, ///< the file; of contacts none
    TF_NAMES_OF_FILES,    ///< the file of each element
    TF_NAMES_OF_MESHES    ///< the mesh of each element, and the frame
} tf_row_names;

/// How to write about surfaces.
typedef struct tf_surface_output_options {
    tf_format format;
    bool checks;   ///< whether rows are intersections, not contacts
    bool measures; ///< whether near pairs are among them
    tf_row_names names;
} tf_surface_output_options;

typedef struct tf_surface_output {
    tf_records records;
    tf_surface_output_options options;
    tf_surface_tally tally;
    size_t part_rows; ///< those of the part that is being checked
} tf_surface_output;

/// The meshes that a surface is joined of.
typedef struct tf_surface_part {
    const tf_joined *joined;
    const char **name; ///< of each
    bool *listed;      ///< of each: whether it is in a row; to be set
} tf_surface_part;

//: Declare how to write about surfaces
/// Begin the output, and write the rows of one step.  Vertices get the numbers
/// that they have in their meshes.  False after a write that failed.
void tf_surface_output_begin(tf_surface_output *output, FILE *stream,
                             const tf_surface_output_options *options);
bool tf_surface_output_contacts(tf_surface_output *output,
                                const tf_surface_part *part, int axes,
                                const tf_contacts *contacts);

/// Writes what comes after the rows, and flushes.  Unless all was done, there is
/// no summary but in JSON, and without any row nothing at all.
bool tf_surface_output_end(tf_surface_output *output, bool done);

/// Write the intersections of a frame, of a file or of files that are joined, and
/// the near pairs; then count the frame or the files.
bool tf_surface_output_crossings(tf_surface_output *output,
                                 const tf_surface_part *part,
                                 const tf_crossings *crossings);
bool tf_surface_output_near(tf_surface_output *output,
                            const tf_surface_part *part,
                            const tf_near_pairs *pairs);
void tf_surface_output_count(tf_surface_output *output,
                             const tf_surface_part *part);

//: Declare how to list intersections after a report
/// Lists the intersections of a file, which rows call `name`, after a report in
/// that format: after an empty line, as CSV; or in JSON, as an object.  False:
/// a write failed, or there is no memory.
bool tf_surface_output_append(FILE *stream, tf_format report,
                              const tf_mesh_file *file, const char *name,
                              const tf_crossings *crossings);
