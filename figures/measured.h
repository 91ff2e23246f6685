// What `make measure` found out on the machine that draws the figures.
#ifndef TF_FIGURES_MEASURED_H
#define TF_FIGURES_MEASURED_H

#include "stage/page.h"

enum {
    TF_STAGE_SHARES = 3
};

typedef struct tf_query_time {
    const char *work, *kind, *arithmetic;
    long queries, hits;
    double time;  ///< nanoseconds a query
    double ratio; ///< to clamped
} tf_query_time;

/// Of a workload, the percentage of queries whose signs were all found without
/// one, by estimates, and with the help of the accumulator.
typedef struct tf_stage_share {
    const char *work, *kind;
    double percent[TF_STAGE_SHARES];
    double tails; ///< percent of the accumulator's signs: a difference rounded
    double heads; ///< and the exact determinant of the rounded ones decides
} tf_stage_share;

/// A way to a sign, by a stage of the library or by an expansion.
typedef struct tf_stage_time {
    const char *stage;
    double time; ///< nanoseconds a sign
} tf_stage_time;

/// The tables, as long as the number that `count` is set to.
const tf_query_time *tf_measured_queries(int *count);
const tf_stage_share *tf_measured_shares(int *count);
const tf_stage_time *tf_measured_stages(int *count);

/// "pt" or "ee", for a kind's name.
const char *tf_kind_letters(const char *kind);

/// Write a workload's name left of a row of a chart: "soup", and of what kind.
void tf_name_workload(tf_page *page, double x, double y, const char *work,
                      const char *kind);

#endif
