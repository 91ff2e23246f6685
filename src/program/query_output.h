//: Declare the output of queries
#pragma once

#include "files/query_file.h"
#include "query/contact.h"

#include <stdbool.h>
#include <stdio.h>

//: Declare the tally
/// What was counted; the last four over queries whose file has a truth column.
typedef struct tf_tally {
    long queries, hits;
    long classified[TF_DEGENERATE + 1]; ///< hits by tf_classification
    long known, agree;
    long extra, missed; ///< hits that are misses in truth; the reverse
    long compared;      ///< answers with those of another method
    long only_method, only_against; ///< hits of one alone, or of the other
} tf_tally;

//: Declare the output and its formats
typedef struct tf_query_format tf_query_format;

typedef struct tf_query_output {
    FILE *stream;
    const tf_query_format *format;
    int axes;
    int error; ///< the errno of the first write that failed, or 0
    tf_tally tally;
} tf_query_output;

/// The names that tf_query_format_named accepts, for help and messages.
#define TF_QUERY_FORMAT_NAMES "csv, json or summary"

/// The format of that name; NULL if there is none.
const tf_query_format *tf_query_format_named(const char *name);

//: Declare how to write the answers
/// Writes what comes before all answers, an answer, and what comes after them;
/// the last also flushes.  False after a write that failed.
bool tf_query_output_begin(tf_query_output *output, FILE *stream,
                           const tf_query_format *format, int axes);
bool tf_query_output_answer(tf_query_output *output, const tf_query_rows *query,
                            const tf_contact *contact);
bool tf_query_output_end(tf_query_output *output);

/// Counts in which way an answer differs from that of another method.
void tf_query_output_compare(tf_query_output *output, const tf_contact *contact,
                             const tf_contact *against);
