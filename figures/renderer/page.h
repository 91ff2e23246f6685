// A figure's page: panels with solid geometry, vector drawing, labels.
//
// All places and widths are in points of the printed page, (0, 0) its upper
// left, y down.  Things are drawn in the order of their calls; labels come
// last.  Text is plain UTF-8 in which $...$ is mathematics, see letters.h:
// "point $x_0'$ at $t = 1$".  The page copies all it is given and owns what it
// returns.  What fails while a page is drawn on (memory, text that is no
// UTF-8) is told by the call that writes it.
#ifndef FIG_RENDERER_PAGE_H
#define FIG_RENDERER_PAGE_H

#include "renderer/camera.h"
#include "renderer/scene.h"
#include "renderer/status.h"
#include "renderer/theme.h"

#include <stdbool.h>
#include <stdint.h>

enum {
    FIG_PIXELS_LEAST = 16,
    FIG_PIXELS_MOST = 16384
}; ///< limits to a picture's width and height in pixels

typedef struct fig_page fig_page;
typedef struct fig_panel fig_panel;

// The page ---------------------------------------------------------------

/// How a page is to be made; zero stands for a default where one is told.
typedef struct fig_page_options {
    double width, height;    ///< points, > 0
    int pixels_x, pixels_y;  ///< of the picture; also of pictures in vector
                             ///< files.  The page is scaled to fit and centred
    const fig_theme *theme;  ///< NULL: light
    const char *family;      ///< of letters; NULL: STIXGeneral
    double dpi;              ///< of a PNG, for print; 0: as the width tells
    double paper_x, paper_y; ///< of a vector file, points: the page is scaled
                             ///< to fit and centred; 0: as large as the page
    bool transparent;        ///< no paper behind the page
    bool bare;               ///< no labels; exact texts stay
    bool moves;              ///< one of a film in which time passes
    double time;             ///< 0..1, of such a film
    bool turned;             ///< look at turnable panels from:
    double azimuth;          ///< degrees
    double elevation;        ///< degrees
    struct fig_renderer **renderer; ///< for all pages of a film: NULL before
                                    ///< the first, freed by the caller after
                                    ///< the last; without, a page has its own
} fig_page_options;

/// Make an empty page.  Refuses sizes in pixels out of range and a family that
/// is not installed; then *page is NULL.
fig_status fig_page_new(const fig_page_options *options, fig_page **page);

/// Free a page and all its panels; NULL is no page.
void fig_page_free(fig_page *page);

double fig_page_width(const fig_page *page);
double fig_page_height(const fig_page *page);
const fig_theme *fig_page_theme(const fig_page *page);

/// Whether the page is one of a film in which time passes, and its time, 0..1.
bool fig_page_moves(const fig_page *page);
double fig_page_time(const fig_page *page);

/// Whether the page is one without labels.
bool fig_page_is_bare(const fig_page *page);

/// Draw the page to a file of the kind that its name ends in: .png, .pdf or
/// .svg.  PNG records the resolution.  May be called again.
fig_status fig_page_write(fig_page *page, const char *path);

/// Draw the page, not a transparent one, into pixels_x times pixels_y pixels,
/// 0xRRGGBB below a byte to ignore, row by row from the top.
fig_status fig_page_paint(fig_page *page, uint32_t pixels[]);

// Panels -----------------------------------------------------------------

/// A rectangle of the page that shows a scene.
fig_panel *fig_page_panel(fig_page *page, fig_box box);

/// The panel's scene, to add to.
fig_scene *fig_panel_scene(fig_panel *panel);

/// Place the eye.  A height of 0 fits the camera to the scene, FIG_FIT_MARGIN
/// points from the border, room for labels.  A page that is turned looks from
/// its own azimuth and elevation unless the panel is fixed.
void fig_panel_look(fig_panel *panel, fig_camera camera);

/// The margin of a fitted camera, in points, in place of FIG_FIT_MARGIN.
void fig_panel_margin(fig_panel *panel, double margin);
#define FIG_FIT_MARGIN 22.0

/// Keep the eye where it is on pages that are turned: for diagrams.
void fig_panel_fix(fig_panel *panel);

/// Project a world point to the page, in points, with the panel's camera as it
/// fits the scene that is there now.
fig_point fig_panel_project(const fig_panel *panel, tf_vector world);

/// Three arrows from `origin` with the names at their tips: "$x$", "$y$",
/// "$t$".  A length of 0 or a NULL name leaves that axis out.
void fig_panel_axes(fig_panel *panel, tf_vector origin, tf_vector length,
                    const char *const name[3]);

// Parts ------------------------------------------------------------------

enum {
    FIG_PARTS_MOST = 64
}; ///< what a page has beyond is no part

/// How many parts the page has: panels, and frames of plots.  Those that
/// overlap are one part, and those that hold no more than an axis are none.
int fig_page_parts(const fig_page *page);

/// The box around the i-th part and the texts beside it that are nearest to it.
/// From 0 on, in the order one reads: row by row, from left to right.
fig_box fig_page_part(const fig_page *page, int i);

/// Show only what the page has now in a box: the panels, texts and labels of a
/// part.  A small box is magnified, but neither letters nor widths of lines.
/// Returns the box of what is shown.
fig_box fig_page_crop(fig_page *page, fig_box box);

/// The height of a heading over a box, in points.
double fig_page_heading_height(fig_box box);

/// Put a line above all that the page shows, in letters small enough for its
/// width.
void fig_page_heading(fig_page *page, const char *text);

// Labels -----------------------------------------------------------------

/// Where a label would best stand, seen from its anchor.
typedef enum fig_side {
    FIG_SIDE_ANY = 0,
    FIG_SIDE_E,
    FIG_SIDE_NE,
    FIG_SIDE_N,
    FIG_SIDE_NW,
    FIG_SIDE_W,
    FIG_SIDE_SW,
    FIG_SIDE_S,
    FIG_SIDE_SE,
} fig_side;

typedef struct fig_label {
    const char *text; ///< one line or, with \n, some
    fig_role role;    ///< of the letters
    double size;      ///< of the letters, points; 0: FIG_LETTERS
    fig_side side;    ///< preferred; others are taken where that one is full
    double gap;       ///< from the anchor, points; 0: as a ball needs
    bool leader;      ///< may stand farther off, joined by a thin line
} fig_label;

/// A label at a point of the page or of a panel's world.  It is placed when
/// the page is written: inside the page, clear of other labels and, as far as
/// possible, of balls, tubes and strokes.
void fig_page_label(fig_page *page, double x, double y, fig_label label);
void fig_panel_label(fig_panel *panel, tf_vector at, fig_label label);

/// How text stands at its place: the place is the left end, the middle or the
/// right end of the first line's baseline.
typedef enum fig_align {
    FIG_ALIGN_LEFT = 0,
    FIG_ALIGN_CENTER,
    FIG_ALIGN_RIGHT,
} fig_align;

/// Text exactly there: titles, ticks, captions.  Labels keep clear of it.
void fig_page_text(fig_page *page, double x, double y, fig_align align,
                   const char *text, double size, fig_role role);

/// The same, turned a quarter to read upwards: the name of a vertical axis.
void fig_page_text_upwards(fig_page *page, double x, double y, fig_align align,
                           const char *text, double size, fig_role role);

/// Width and height of text in points; what a figure needs to lay out by.
void fig_page_measure(fig_page *page, const char *text, double size,
                      double *width, double *height);

/// A small legible line in the middle below a box, and one above it.
void fig_page_caption(fig_page *page, fig_box box, const char *text);
void fig_page_title(fig_page *page, fig_box box, const char *text);

// Vector drawing ---------------------------------------------------------

/// How a line is drawn.  Zero stands for an ink line of FIG_WIDTH_LINE.
typedef struct fig_stroke {
    fig_paint paint;
    double width;      ///< points; 0: FIG_WIDTH_LINE
    double dash;       ///< length of dashes and gaps, points; 0: solid
    bool arrow;        ///< a head at the last point
    bool both;         ///< a head at the first point too
    bool closed;       ///< joined to the first point
    bool under_labels; ///< labels need not keep clear of it
} fig_stroke;

/// A polyline through `count` >= 2 points of the page; the same through points
/// of a panel's world, drawn over its picture.
void fig_page_line(fig_page *page, int count, const fig_point at[],
                   fig_stroke stroke);
void fig_panel_line(fig_panel *panel, int count, const tf_vector at[],
                    fig_stroke stroke);

/// A filled polygon without outline; labels may stand on it.
void fig_page_fill(fig_page *page, int count, const fig_point at[],
                   fig_paint paint);
void fig_panel_fill(fig_panel *panel, int count, const tf_vector at[],
                    fig_paint paint);
void fig_page_fill_box(fig_page *page, fig_box box, fig_paint paint);

/// A filled disc.
void fig_page_dot(fig_page *page, double x, double y, double diameter,
                  fig_paint paint);

/// A part of a circle around (x, y), angles in degrees, counterclockwise from
/// the right as seen.
void fig_page_arc(fig_page *page, double x, double y, double radius,
                  double from, double to, fig_stroke stroke);

/// A map: a picture of columns x rows cells, row after row from the top, with
/// hard borders between the cells at any size.
void fig_page_map(fig_page *page, fig_box box, int columns, int rows,
                  const fig_rgb *cells);

// What tests ask ---------------------------------------------------------

/// A label as it was placed by the last write.
typedef struct fig_placed {
    fig_point anchor;
    fig_box box;
} fig_placed;

/// How many labels there are (texts at fixed places not counted), and the
/// i-th, in the order of the calls.
int fig_page_labels(const fig_page *page);
fig_placed fig_page_placed(const fig_page *page, int i);

#endif
