// The figures of the book.
#ifndef FIG_FIGURES_H
#define FIG_FIGURES_H

#include "renderer/figure.h"

// A figure is a file: the one named "edge-sweep" is fig_edge_sweep, in
// plane/edge_sweep.c.  The build lists them in names.h, a line FIG_NAME(edge_sweep)
// each, for whoever defines FIG_NAME.
#define FIG_NAME(name) extern const fig_figure fig_##name;
#include "names.h"
#undef FIG_NAME

/// All figures, in the order of their names; NULL ends the table.
extern const fig_figure *const fig_figures[];

/// The figure of that name; NULL if there is none.
const fig_figure *fig_figure_named(const char *name);

#endif
