// What `make measure-all` has measured, as it is in figures/measured.
#ifndef FIG_MEASURED_H
#define FIG_MEASURED_H

#include "renderer/page.h"

enum {
    FIG_WORKLOADS = 8
};

/// Queries that were timed.
typedef struct fig_workload {
    const char *work, *kind; ///< "soup", "point-triangle"
    const char *letters;     ///< for the kind, "pt"
} fig_workload;

/// In the order of the book, those of one work side by side.
extern const fig_workload fig_workloads[FIG_WORKLOADS];

/// The value of a row, by its name, which is made as printf does.  A name that
/// is in no row breaks the contract.
double fig_measured(const char *format, ...);

/// Write a workload's name left of a row of a chart: "soup", and of what kind.
void fig_name_workload(fig_page *page, double x, double y,
                       const fig_workload *workload);

#endif
