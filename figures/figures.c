#include "figures.h"

#include <string.h>

const tf_figure *const tf_figures[] = {
    &tf_figure_between_frames,
    &tf_figure_staircase,
    &tf_figure_bent_slices,
    &tf_figure_two_orders,
    &tf_figure_sign_maps,
    &tf_figure_toy_doubles,
    &tf_figure_error_band,
    &tf_figure_edge_sweep,
    &tf_figure_seven_regions,
    &tf_figure_time_margins,
    &tf_figure_plane_degenerate,
    &tf_figure_legs,
    &tf_figure_on_a_line,
    &tf_figure_seesaw,
    &tf_figure_staircase_patch,
    &tf_figure_models_apart,
    &tf_figure_prism,
    &tf_figure_sheared_frame,
    &tf_figure_signs_spent,
    &tf_figure_contact,
    &tf_figure_edge_edge_sheets,
    &tf_figure_propeller,
    &tf_figure_coplanar_times,
    &tf_figure_crease_crossing,
    &tf_figure_winding,
    &tf_figure_even_sums,
    &tf_figure_integer_stripes,
    &tf_figure_bits_spent,
    &tf_figure_grid_rounding,
    &tf_figure_rounded_sheets,
    &tf_figure_two_sum,
    &tf_figure_expansion_terms,
    &tf_figure_accumulator_words,
    &tf_figure_exact_stages,
    &tf_figure_needle_counts,
    &tf_figure_moved_row,
    &tf_figure_leading_terms,
    &tf_figure_sign_stages,
    &tf_figure_sign_costs,
    NULL,
};

const tf_figure *tf_figure_named(const char *name)
{
    for (int i = 0; tf_figures[i]; i++)
        if (strcmp(name, tf_figures[i]->name) == 0)
            return tf_figures[i];
    return NULL;
}
