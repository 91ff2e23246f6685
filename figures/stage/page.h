// A figure's page: panels with solid geometry, vector drawing, labels.
//
// All places and widths are in points of the printed page, (0, 0) its upper
// left, y down.  Things are drawn in the order of their calls; labels come
// last.  Text is plain UTF-8 in which $...$ is mathematics, see letters.h:
// "point $x_0'$ at $t = 1$".  The page copies all it is given and owns what it
// returns.  What fails while a page is drawn on (memory, text that is no
// UTF-8) is told by the call that writes it.
#ifndef TF_STAGE_PAGE_H
#define TF_STAGE_PAGE_H

#include "stage/camera.h"
#include "stage/scene.h"
#include "stage/status.h"
#include "stage/theme.h"

#include <stdbool.h>

enum {
    TF_PIXELS_LEAST = 16,
    TF_PIXELS_MOST = 16384
}; ///< limits to a picture's width and height in pixels

typedef struct tf_page tf_page;
typedef struct tf_panel tf_panel;

// The page ---------------------------------------------------------------

/// How a page is to be made; zero stands for a default where one is told.
typedef struct tf_page_options {
    double width, height;   ///< points, > 0
    int pixels_x, pixels_y; ///< of the picture; also of pictures in vector
                            ///< files.  The page is scaled to fit and centred
    const tf_theme *theme;  ///< NULL: light
    const char *family;     ///< of letters; NULL: STIXGeneral
    double dpi;             ///< of a PNG, for print; 0: as the width tells
    bool transparent;       ///< no paper behind the page
    bool moves;             ///< one of a film in which time passes
    double time;            ///< 0..1, of such a film
    bool turned;            ///< look at turnable panels from:
    double azimuth;         ///< degrees
    double elevation;       ///< degrees
} tf_page_options;

/// Make an empty page.  Refuses sizes in pixels out of range and a family that
/// is not installed; then *page is NULL.
tf_stage_status tf_page_new(const tf_page_options *options, tf_page **page);

/// Free a page and all its panels; NULL is no page.
void tf_page_free(tf_page *page);

double tf_page_width(const tf_page *page);
double tf_page_height(const tf_page *page);
const tf_theme *tf_page_theme(const tf_page *page);

/// Whether the page is one of a film in which time passes, and its time, 0..1.
bool tf_page_moves(const tf_page *page);
double tf_page_time(const tf_page *page);

/// Draw the page to a file of the kind that its name ends in: .png, .pdf or
/// .svg.  PNG records the resolution.  May be called again.
tf_stage_status tf_page_write(tf_page *page, const char *path);

// Panels -----------------------------------------------------------------

/// A rectangle of the page that shows a scene.
tf_panel *tf_page_panel(tf_page *page, tf_box box);

/// The panel's scene, to add to.
tf_scene *tf_panel_scene(tf_panel *panel);

/// Place the eye.  A height of 0 fits the camera to the scene, TF_FIT_MARGIN
/// points from the border, room for labels.  A page that is turned looks from
/// its own azimuth and elevation unless the panel is fixed.
void tf_panel_look(tf_panel *panel, tf_camera camera);

/// The margin of a fitted camera, in points, in place of TF_FIT_MARGIN.
void tf_panel_margin(tf_panel *panel, double margin);
#define TF_FIT_MARGIN 22.0

/// Keep the eye where it is on pages that are turned: for diagrams.
void tf_panel_fix(tf_panel *panel);

/// Project a world point to the page, in points, with the panel's camera as it
/// fits the scene that is there now.
void tf_panel_project(const tf_panel *panel, const double world[3],
                      double page[2]);

/// Three arrows from `origin` with the names at their tips: "$x$", "$y$",
/// "$t$".  A length of 0 or a NULL name leaves that axis out.
void tf_panel_axes(tf_panel *panel, const double origin[3],
                   const double length[3], const char *const name[3]);

// Labels -----------------------------------------------------------------

/// Where a label would best stand, seen from its anchor.
typedef enum tf_side {
    TF_SIDE_ANY = 0,
    TF_SIDE_E,
    TF_SIDE_NE,
    TF_SIDE_N,
    TF_SIDE_NW,
    TF_SIDE_W,
    TF_SIDE_SW,
    TF_SIDE_S,
    TF_SIDE_SE,
} tf_side;

typedef struct tf_label {
    const char *text; ///< one line or, with \n, some
    tf_role role;     ///< of the letters
    double size;      ///< of the letters, points; 0: TF_LETTERS
    tf_side side;     ///< preferred; others are taken where that one is full
    double gap;       ///< from the anchor, points; 0: as a ball needs
    bool leader;      ///< may stand farther off, joined by a thin line
} tf_label;

/// A label at a point of the page or of a panel's world.  It is placed when
/// the page is written: inside the page, clear of other labels and, as far as
/// possible, of balls, tubes and strokes.
void tf_page_label(tf_page *page, double x, double y, tf_label label);
void tf_panel_label(tf_panel *panel, const double at[3], tf_label label);

/// How text stands at its place: the place is the left end, the middle or the
/// right end of the first line's baseline.
typedef enum tf_align {
    TF_ALIGN_LEFT = 0,
    TF_ALIGN_CENTER,
    TF_ALIGN_RIGHT,
} tf_align;

/// Text exactly there: titles, ticks, captions.  Labels keep clear of it.
void tf_page_text(tf_page *page, double x, double y, tf_align align,
                  const char *text, double size, tf_role role);

/// The same, turned a quarter to read upwards: the name of a vertical axis.
void tf_page_text_upwards(tf_page *page, double x, double y, tf_align align,
                          const char *text, double size, tf_role role);

/// Width and height of text in points; what a figure needs to lay out by.
void tf_page_measure(tf_page *page, const char *text, double size,
                     double *width, double *height);

/// A small legible line in the middle below a box, and one above it.
void tf_page_caption(tf_page *page, tf_box box, const char *text);
void tf_page_title(tf_page *page, tf_box box, const char *text);

// Vector drawing ---------------------------------------------------------

/// How a line is drawn.  Zero stands for an ink line of TF_WIDTH_LINE.
typedef struct tf_stroke {
    tf_paint paint;
    double width;      ///< points; 0: TF_WIDTH_LINE
    double dash;       ///< length of dashes and gaps, points; 0: solid
    bool arrow;        ///< a head at the last point
    bool both;         ///< a head at the first point too
    bool closed;       ///< joined to the first point
    bool under_labels; ///< labels need not keep clear of it
} tf_stroke;

/// A polyline through `count` >= 2 points of the page; the same through points
/// of a panel's world, drawn over its picture.
void tf_page_line(tf_page *page, int count, const double at[][2],
                  tf_stroke stroke);
void tf_panel_line(tf_panel *panel, int count, const double at[][3],
                   tf_stroke stroke);

/// A filled polygon without outline; labels may stand on it.
void tf_page_fill(tf_page *page, int count, const double at[][2],
                  tf_paint paint);
void tf_panel_fill(tf_panel *panel, int count, const double at[][3],
                   tf_paint paint);
void tf_page_fill_box(tf_page *page, tf_box box, tf_paint paint);

/// A filled disc.
void tf_page_dot(tf_page *page, double x, double y, double diameter,
                 tf_paint paint);

/// A part of a circle around (x, y), angles in degrees, counterclockwise from
/// the right as seen.
void tf_page_arc(tf_page *page, double x, double y, double radius, double from,
                 double to, tf_stroke stroke);

/// A map: a picture of columns x rows cells, row after row from the top, with
/// hard borders between the cells at any size.
void tf_page_map(tf_page *page, tf_box box, int columns, int rows,
                 const tf_rgb *cells);

// What tests ask ---------------------------------------------------------

/// A label as it was placed by the last write.
typedef struct tf_placed {
    double anchor[2];
    tf_box box;
} tf_placed;

/// How many labels there are (texts at fixed places not counted), and the
/// i-th, in the order of the calls.
int tf_page_labels(const tf_page *page);
tf_placed tf_page_placed(const tf_page *page, int i);

#endif
