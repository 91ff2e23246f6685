// Pictures of surfaces that intersect themselves.
#ifndef FIG_TANGLE_PICTURE_H
#define FIG_TANGLE_PICTURE_H

#include "kit/crossing_curves.h"
#include "kit/tangles.h"
#include "renderer/page.h"

/// The color of the part of a vertex.
fig_role fig_part_role(const fig_crossing_curves *curves, int vertex);

/// Draw a tangle whose vertices are at x in a panel, each part in a color of its
/// own, with its curves.  The camera is fitted to where the tangle was, too.
/// Returns how many crossings there are.
size_t fig_tangle_draw_in(fig_panel *panel, const fig_tangle *tangle,
                          const double x[]);

/// The same in a new panel.
size_t fig_tangle_draw(fig_page *page, fig_box box, const fig_tangle *tangle,
                       const double x[]);

#endif
