// What is drawn of a surface: in space, and in the plane.
#ifndef FIG_DRAW_SURFACE_PARTS_H
#define FIG_DRAW_SURFACE_PARTS_H

#include "draw/surface_picture.h"
#include "renderer/page.h"

/// The margin of the camera, in points.
#define FIG_SURFACE_MARGIN 14.0

/// The paint of a part of a surface, from 0.
fig_paint fig_part_paint(const fig_shown_surface *shown, int part);

/// Whether something that is in contact from the time `toi` on is marked in the
/// picture of the time t: in films as time passes, otherwise always.
bool fig_is_marked(const fig_page *page, double toi, double t);

/// The paint of an element that is in contact from the time `toi` on: paler
/// before.
fig_paint fig_touching_paint(double toi, double t);

/// Whether a facet, a triangle or in the plane an edge, is shown in a zone.
bool fig_is_in_zone(const fig_shown_surface *shown, int facet);

/// The paint of a facet that has this vertex: that of its part, paler in a zone.
fig_paint fig_facet_paint(const fig_shown_surface *shown, int facet,
                          int vertex);

/// The paint of spots: darker than that of the elements.
extern const fig_paint fig_spot_paint;

/// How wide, in points, the i-th spot is drawn: the first contact always is,
/// others where there are few enough to tell them apart.  0: not at all.
double fig_spot_width(const fig_page *page, const fig_shown_surface *shown,
                      int i, double t);

/// Whether elements are large enough for lines along all edges to be read.
bool fig_shows_edges(const fig_shown_surface *shown);

/// Draw the surface as it is at the time t in a box of the page: one of space,
/// and one of the plane.
void fig_show_surface(fig_page *page, fig_box box,
                      const fig_shown_surface *shown, double t);
void fig_show_curve(fig_page *page, fig_box box, const fig_shown_surface *shown,
                    double t);

#endif
