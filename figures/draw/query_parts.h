// What is drawn of a query: its parts, as the commands and tests need them.
#ifndef FIG_DRAW_QUERY_PARTS_H
#define FIG_DRAW_QUERY_PARTS_H

#include "draw/query_picture.h"
#include "files/query_file.h"
#include "kit/fit.h"
#include "query/query.h"
#include "renderer/page.h"

/// A query that was answered, and its vertices in the box of a drawing.
typedef struct fig_shown {
    const fig_answered *answered; ///< borrowed
    const tf_query_kind *kind;
    const tf_worldline *given; ///< the vertices as they were given; borrowed
    tf_contact contact;
    fig_fit fit;
    tf_worldline vertex[FIG_QUERY_VERTICES]; ///< in the box
    double toi;                              ///< where there is a hit
    tf_vector meeting;                       ///< the place of the contact
} fig_shown;

/// Fit an answered query into the box.
fig_shown fig_shown_of(const fig_answered *answered);

bool fig_shown_hits(const fig_shown *shown);

/// The role of the first (0) or the second (1) element, and the name of one of
/// its vertices at t = 0 or 1, as mathematics.
fig_role fig_shown_role(const fig_shown *shown, int element);
void fig_shown_name(const fig_shown *shown, int element, int vertex, int t,
                    char text[FIG_NAME_TEXT]);

/// Where the contact is in the coordinates that were given.
tf_vector fig_shown_meeting(const fig_shown *shown);

/// The vertices of an element.
const tf_worldline *fig_shown_element(const fig_shown *shown, int element);

/// Add a convex polygon of 1 to 4 corners in order: a ball, a line or a face
/// with lines of `width` points around it.
void fig_add_polygon(fig_scene *scene, int count, const tf_vector corner[],
                     double width, fig_paint paint);

/// Show both elements in space at the time t; `marked`: and their contact.
void fig_show_slice(fig_panel *panel, const fig_shown *shown, double t,
                    bool marked);

/// Show a point-edge query in space-time; t < 0: with no present.
void fig_show_spacetime(fig_panel *panel, const fig_shown *shown, double t);

/// Show the difference of the elements, second minus first, around the origin,
/// and where it is at the time t; t < 0: at no time.  Returns whether its axes
/// are scaled alike.
bool fig_show_difference(fig_page *page, fig_panel *panel,
                         const fig_shown *shown, double t);

/// Add the normal at the contact as an arrow, with its name if coordinates are
/// shown; nothing if there is no normal, or if the axes are not scaled alike.
void fig_add_normal(fig_panel *panel, const fig_shown *shown, tf_vector from);

/// Write down the coordinates of the vertices, of the contact and of its normal
/// as a table from y = `top` on.
void fig_show_coordinates(fig_page *page, const fig_shown *shown, double top);
double fig_coordinates_height(const fig_answered *answered);

/// Look at space as all panels do.
extern const fig_camera fig_shown_camera;

#endif
