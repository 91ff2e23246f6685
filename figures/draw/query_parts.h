// What is drawn of a query: its parts, as the commands and tests need them.
#ifndef TF_DRAW_QUERY_PARTS_H
#define TF_DRAW_QUERY_PARTS_H

#include "draw/fit.h"
#include "program/query_file.h"
#include "query/contact.h"
#include "stage/page.h"

/// A query that was answered, and its vertices in the box of a drawing.
typedef struct tf_shown {
    const tf_query_kind *kind;
    const tf_worldline *asked; ///< the vertices as they were asked; borrowed
    tf_contact contact;
    tf_fit fit;
    tf_worldline vertex[TF_QUESTION_VERTICES]; ///< in the box
    double toi;                                ///< where there is a hit
    double meeting[3];                         ///< the place of the contact
} tf_shown;

/// Fit an answered question into the box.
tf_shown tf_shown_of(const tf_query_kind *kind, const tf_worldline asked[],
                     const tf_contact *contact);

bool tf_shown_hits(const tf_shown *shown);

/// The role of the first (0) or the second (1) element, and the name of one of
/// its vertices at t = 0 or 1, as mathematics without $.
tf_role tf_shown_role(const tf_shown *shown, int element);
const char *tf_shown_name(const tf_shown *shown, int element, int vertex,
                          int t);

/// The vertices of an element.
const tf_worldline *tf_shown_element(const tf_shown *shown, int element);

/// Add a convex polygon of 1 to 4 corners in order: a ball, a line or a face
/// with lines of `width` points around it.
void tf_add_polygon(tf_scene *scene, int count, const double corner[][3],
                    double width, tf_paint paint);

/// Show both elements in space at the time t; `marked`: and their contact.
void tf_show_slice(tf_panel *panel, const tf_shown *shown, double t,
                   bool marked);

/// Show a point-edge query in space-time; t < 0: with no present.
void tf_show_spacetime(tf_panel *panel, const tf_shown *shown, double t);

/// Show the difference of the elements, second minus first, around the origin,
/// and where it is at the time t; t < 0: at no time.  Returns whether its axes
/// are scaled alike.
bool tf_show_difference(tf_page *page, tf_panel *panel, const tf_shown *shown,
                        double t);

/// Look at space as all panels do.
extern const tf_camera tf_shown_camera;

#endif
