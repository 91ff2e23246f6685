// Colours, line widths and letter sizes: one set for all figures.
#ifndef FIG_RENDERER_THEME_H
#define FIG_RENDERER_THEME_H

#include <stdbool.h>

/// What a colour stands for, in every figure.  Ink is zero, the default.
typedef enum fig_role {
    FIG_ROLE_INK = 0,    ///< letters and outlines
    FIG_ROLE_PAPER,      ///< the background
    FIG_ROLE_NEUTRAL,    ///< axes, grids, leader lines
    FIG_ROLE_POINT,      ///< the moving point, its worldline
    FIG_ROLE_EDGE,       ///< the moving edge, its sweep
    FIG_ROLE_OTHER_EDGE, ///< the second edge of an edge-edge query
    FIG_ROLE_TRIANGLE,   ///< the moving triangle, its sweep
    FIG_ROLE_CONTACT,    ///< where they meet
    FIG_ROLE_START,      ///< t = 0
    FIG_ROLE_END,        ///< t = 1
    FIG_ROLE_POSITIVE,   ///< a sign
    FIG_ROLE_NEGATIVE,   ///< a sign
    FIG_ROLE_UNCERTAIN,  ///< a sign that is not known
    FIG_ROLES
} fig_role;

/// Red, green, blue in 0..1, as sRGB encodes them.
typedef struct fig_rgb {
    double r, g, b;
} fig_rgb;

typedef struct fig_theme {
    const char *name;
    bool dark;
    double opacity_power; ///< of translucent things; they glow on dark paper,
                          ///< so that one has an exponent > 1
    fig_rgb color[FIG_ROLES];
} fig_theme;

extern const fig_theme fig_theme_light;
extern const fig_theme fig_theme_dark;

/// "light" or "dark"; NULL if there is no such theme.
const fig_theme *fig_theme_named(const char *name);

/// How a thing is coloured.  {FIG_ROLE_EDGE} is an opaque blue;
/// {FIG_ROLE_EDGE, .opacity = 0.4} a translucent one.
typedef struct fig_paint {
    fig_role role;
    double opacity; ///< 0..1; 0 stands for 1, opaque
    double shade;   ///< -1..1: > 0 mixes towards ink, < 0 towards paper
} fig_paint;

/// The colour of a paint in a theme, opacity aside.
fig_rgb fig_paint_color(const fig_theme *theme, fig_paint paint);

/// The opacity of a paint, 0 read as 1.
double fig_paint_opacity(fig_paint paint);

/// The colour (1 - weight) a + weight b, mixed as sRGB encodes them.
fig_rgb fig_rgb_mix(fig_rgb a, fig_rgb b, double weight);

/// A component as sRGB encodes it (0..1) in linear light, and the reverse.
double fig_rgb_to_linear(double encoded);
double fig_rgb_from_linear(double linear);

/// Sizes in points of the printed figure.
#define FIG_WIDTH_HAIR 0.4  ///< grids, leader lines
#define FIG_WIDTH_THIN 0.7  ///< creases, plot axes
#define FIG_WIDTH_LINE 1.1  ///< curves, arrows, axes in space
#define FIG_WIDTH_TUBE 2.4  ///< worldlines and edges in space
#define FIG_WIDTH_BALL 6.5  ///< the diameter of an event
#define FIG_WIDTH_MARK 9.0  ///< the diameter of a contact
#define FIG_LETTERS 11.0    ///< labels
#define FIG_LETTERS_SMALL 9 ///< ticks, captions below panels
#define FIG_LETTERS_TITLE 12.0

#endif
