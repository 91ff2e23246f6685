//: Declare the output of queries
#pragma once

#include "files/query_file.h"
#include "files/record.h"
#include "query/contact.h"

//: Declare the tally
/// What was counted.
typedef struct tf_tally {
    size_t queries, hits;
    size_t classified[TF_DEGENERATE + 1]; ///< hits by tf_classification
    size_t known, agree;                  ///< queries with ground truth
    size_t extra, missed; ///< hits that are misses in truth; the reverse
    size_t compared;      ///< answers with those of another method
    size_t differ, only_method, only_against; ///< hits of one alone
} tf_tally;

typedef struct tf_query_output {
    tf_records records;
    int axes;
    tf_tally tally;
} tf_query_output;

//: Declare how to write the answers
/// Write what comes before all answers, an answer, and what comes after them;
/// the last also flushes.  False after a write that failed.
void tf_query_output_begin(tf_query_output *output, FILE *stream,
                           tf_format format, int axes);
bool tf_query_output_answer(tf_query_output *output, const tf_query_rows *query,
                            const tf_contact *contact);
bool tf_query_output_end(tf_query_output *output);

/// Counts in which way an answer differs from that of another method.
void tf_query_output_compare(tf_query_output *output, const tf_contact *contact,
                             const tf_contact *against);
