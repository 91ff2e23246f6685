//: Declare query files
#pragma once

#include "files/choice.h"
#include "files/text_lines.h"

#include <stdbool.h>
#include <stdio.h>

//: Declare the kinds of query
/// Which two elements a query is about.
typedef struct tf_query_kind {
    const char *name;
    int axes;
    int vertices[2]; ///< of the first and the second element
} tf_query_kind;

/// The kinds by their names; vertex-face is point-triangle, too.
extern const tf_choice tf_query_kinds[];

//: Declare a query as the file gives it
enum {
    TF_QUERY_COORDINATES = 12, ///< the most at one time: four vertices of space
    TF_QUERY_ROWS = 8          ///< the most: four vertices, two times
};

/// One query of a file.  Its rows are the vertices at t = 0, then at t = 1; the
/// order of the rows is that of the vertices' indices, from 0.
typedef struct tf_query_rows {
    double x[2][TF_QUERY_COORDINATES]; ///< by time; axes to a vertex
    long line[TF_QUERY_ROWS];          ///< of each row, counted from 1
    int ground_truth;                  ///< 1 hit, 0 apart, -1 not given
    int rounded; ///< coordinates that were no doubles and had to be rounded
} tf_query_rows;

//: Declare the reader of query files
/// Reads one query after another in memory of the size of the longest line.
typedef struct tf_query_file {
    tf_text_lines lines;
    const tf_query_kind *kind;
    size_t queries; ///< the number of the next query
    int columns;    ///< of the first row; 0 before it was read
} tf_query_file;

//: Declare how to read a query file
/// Starts to read a stream, or the file at `path` ("-": standard input).  The
/// first query has the number `queries`.  Both borrow the name and the fault.
/// Close the file in any case, also if it cannot be opened; this closes the
/// stream, too, unless it is standard input.
void tf_query_file_start(tf_query_file *file, FILE *stream, const char *name,
                         const tf_query_kind *kind, size_t queries,
                         tf_fault *fault);
bool tf_query_file_open(tf_query_file *file, const char *path,
                        const tf_query_kind *kind, size_t queries,
                        tf_fault *fault);
void tf_query_file_close(tf_query_file *file);

/// Reads the next query, without lines that are blank or begin with #.
/// Whatever it holds, coordinates are finite.
tf_reading tf_query_file_next(tf_query_file *file, tf_query_rows *query);
