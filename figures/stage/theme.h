// Colours, line widths and letter sizes: one set for all figures.
#ifndef TF_STAGE_THEME_H
#define TF_STAGE_THEME_H

#include <stdbool.h>

/// What a colour stands for, in every figure.  Ink is zero, the default.
typedef enum tf_role {
    TF_ROLE_INK = 0,    ///< letters and outlines
    TF_ROLE_PAPER,      ///< the background
    TF_ROLE_NEUTRAL,    ///< axes, grids, leader lines
    TF_ROLE_POINT,      ///< the moving point, its worldline
    TF_ROLE_EDGE,       ///< the moving edge, its sweep
    TF_ROLE_OTHER_EDGE, ///< the second edge of an edge-edge query
    TF_ROLE_TRIANGLE,   ///< the moving triangle, its sweep
    TF_ROLE_CONTACT,    ///< where they meet
    TF_ROLE_START,      ///< t = 0
    TF_ROLE_END,        ///< t = 1
    TF_ROLE_POSITIVE,   ///< a sign
    TF_ROLE_NEGATIVE,   ///< a sign
    TF_ROLE_UNCERTAIN,  ///< a sign that is not known
    TF_ROLES
} tf_role;

/// Red, green, blue in 0..1, as sRGB encodes them.
typedef struct tf_rgb {
    double r, g, b;
} tf_rgb;

typedef struct tf_theme {
    const char *name;
    bool dark;
    double opacity_power; ///< of translucent things; they glow on dark paper,
                          ///< so that one has an exponent > 1
    tf_rgb color[TF_ROLES];
} tf_theme;

extern const tf_theme tf_theme_light;
extern const tf_theme tf_theme_dark;

/// "light" or "dark"; NULL if there is no such theme.
const tf_theme *tf_theme_named(const char *name);

/// How a thing is coloured.  {TF_ROLE_EDGE} is an opaque blue;
/// {TF_ROLE_EDGE, .opacity = 0.4} a translucent one.
typedef struct tf_paint {
    tf_role role;
    double opacity; ///< 0..1; 0 stands for 1, opaque
    double shade;   ///< -1..1: > 0 mixes towards ink, < 0 towards paper
} tf_paint;

/// The colour of a paint in a theme, opacity aside.
tf_rgb tf_paint_color(const tf_theme *theme, tf_paint paint);

/// The opacity of a paint, 0 read as 1.
double tf_paint_opacity(tf_paint paint);

/// The colour (1 - weight) a + weight b, mixed as sRGB encodes them.
tf_rgb tf_rgb_mix(tf_rgb a, tf_rgb b, double weight);

/// A component as sRGB encodes it (0..1) in linear light, and the reverse.
double tf_rgb_to_linear(double encoded);
double tf_rgb_from_linear(double linear);

/// Sizes in points of the printed figure.
#define TF_WIDTH_HAIR 0.4  ///< grids, leader lines
#define TF_WIDTH_THIN 0.7  ///< creases, plot axes
#define TF_WIDTH_LINE 1.1  ///< curves, arrows, axes in space
#define TF_WIDTH_TUBE 2.4  ///< worldlines and edges in space
#define TF_WIDTH_BALL 6.5  ///< the diameter of an event
#define TF_WIDTH_MARK 9.0  ///< the diameter of a contact
#define TF_LETTERS 11.0    ///< labels
#define TF_LETTERS_SMALL 9 ///< ticks, captions below panels
#define TF_LETTERS_TITLE 12.0

#endif
