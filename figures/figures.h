// The figures of the book.
#ifndef TF_FIGURES_FIGURES_H
#define TF_FIGURES_FIGURES_H

#include "stage/figure.h"

// A figure is a file; tf_figure_edge_sweep is the figure "edge-sweep".
extern const tf_figure tf_figure_between_frames;
extern const tf_figure tf_figure_staircase;
extern const tf_figure tf_figure_bent_slices;
extern const tf_figure tf_figure_two_orders;
extern const tf_figure tf_figure_sign_maps;
extern const tf_figure tf_figure_toy_doubles;
extern const tf_figure tf_figure_error_band;
extern const tf_figure tf_figure_edge_sweep;
extern const tf_figure tf_figure_seven_regions;
extern const tf_figure tf_figure_time_margins;
extern const tf_figure tf_figure_plane_degenerate;
extern const tf_figure tf_figure_legs;
extern const tf_figure tf_figure_on_a_line;
extern const tf_figure tf_figure_seesaw;
extern const tf_figure tf_figure_staircase_patch;
extern const tf_figure tf_figure_models_apart;
extern const tf_figure tf_figure_prism;
extern const tf_figure tf_figure_sheared_frame;
extern const tf_figure tf_figure_signs_spent;
extern const tf_figure tf_figure_contact;
extern const tf_figure tf_figure_edge_edge_sheets;
extern const tf_figure tf_figure_propeller;
extern const tf_figure tf_figure_coplanar_times;
extern const tf_figure tf_figure_crease_crossing;
extern const tf_figure tf_figure_winding;
extern const tf_figure tf_figure_even_sums;
extern const tf_figure tf_figure_integer_stripes;
extern const tf_figure tf_figure_bits_spent;
extern const tf_figure tf_figure_grid_rounding;
extern const tf_figure tf_figure_rounded_sheets;
extern const tf_figure tf_figure_two_sum;
extern const tf_figure tf_figure_expansion_terms;
extern const tf_figure tf_figure_accumulator_words;
extern const tf_figure tf_figure_exact_stages;
extern const tf_figure tf_figure_needle_counts;
extern const tf_figure tf_figure_moved_row;
extern const tf_figure tf_figure_leading_terms;
extern const tf_figure tf_figure_sign_stages;
extern const tf_figure tf_figure_sign_costs;

/// All figures in the order of the book; NULL ends the table.
extern const tf_figure *const tf_figures[];

/// The figure of that name; NULL if there is none.
const tf_figure *tf_figure_named(const char *name);

#endif
