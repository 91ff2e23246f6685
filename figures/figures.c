#include "figures.h"

#include <string.h>

const tf_figure *const tf_figures[] = {
    &tf_figure_edge_sweep,
    &tf_figure_prism,
    &tf_figure_staircase_patch,
    &tf_figure_bent_slices,
    &tf_figure_sign_maps,
    &tf_figure_plane_degenerate,
    &tf_figure_sheared_frame,
    &tf_figure_edge_edge_sheets,
    &tf_figure_contact,
    &tf_figure_crease_crossing,
    NULL,
};

const tf_figure *tf_figure_named(const char *name)
{
    for (int i = 0; tf_figures[i]; i++)
        if (strcmp(name, tf_figures[i]->name) == 0)
            return tf_figures[i];
    return NULL;
}
