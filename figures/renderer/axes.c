#include "renderer/page_parts.h"

#include <stddef.h>

void fig_panel_axes(fig_panel *panel, tf_vector origin, tf_vector length,
                    const char *const name[3])
{
    const fig_paint paint = {.role = FIG_ROLE_NEUTRAL};
    for (int k = 0; k < 3; k++) {
        if (length.x[k] == 0)
            continue;
        tf_vector tip = origin;
        tip.x[k] += length.x[k];
        fig_scene_arrow(&panel->scene, origin, tip, FIG_WIDTH_LINE, paint);
        if (name[k] != NULL)
            fig_panel_label(
                panel, tip,
                (fig_label){.text = name[k],
                            .role = FIG_ROLE_INK,
                            .side = k == 2 ? FIG_SIDE_N : FIG_SIDE_ANY,
                            .gap = 3});
    }
}
