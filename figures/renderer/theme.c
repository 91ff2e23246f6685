#include "renderer/theme.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

/// A color from its usual notation, 0xRRGGBB.
#define RGB(hex)                                                               \
    {                                                                          \
        ((hex) >> 16 & 255) / 255.0, ((hex) >> 8 & 255) / 255.0,               \
            ((hex)&255) / 255.0                                                \
    }

// The colours of Okabe and Ito, darkened where paper is white and lightened
// where it is black until lines of them stand off it.
const fig_theme fig_theme_light = {
    .name = "light",
    .opacity_power = 1,
    .color =
        {
            [FIG_ROLE_INK] = RGB(0x20242a),
            [FIG_ROLE_PAPER] = RGB(0xffffff),
            [FIG_ROLE_NEUTRAL] = RGB(0x6f757e),
            [FIG_ROLE_POINT] = RGB(0xa8379f),
            [FIG_ROLE_EDGE] = RGB(0x0068c0),
            [FIG_ROLE_OTHER_EDGE] = RGB(0xdb8000),
            [FIG_ROLE_TRIANGLE] = RGB(0x00a07c),
            [FIG_ROLE_CONTACT] = RGB(0xc81e00),
            [FIG_ROLE_START] = RGB(0x5796e0),
            [FIG_ROLE_END] = RGB(0x8e7f00),
            [FIG_ROLE_POSITIVE] = RGB(0x8cc4e8),
            [FIG_ROLE_NEGATIVE] = RGB(0xf2b97c),
            [FIG_ROLE_UNCERTAIN] = RGB(0x5c6068),
        },
};

const fig_theme fig_theme_dark = {
    .name = "dark",
    .dark = true,
    .opacity_power = 1.15,
    .color =
        {
            [FIG_ROLE_INK] = RGB(0xe8eaed),
            [FIG_ROLE_PAPER] = RGB(0x16181c),
            [FIG_ROLE_NEUTRAL] = RGB(0x8a8f98),
            [FIG_ROLE_POINT] = RGB(0xd391e6),
            [FIG_ROLE_EDGE] = RGB(0x3590d8),
            [FIG_ROLE_OTHER_EDGE] = RGB(0xff9c1a),
            [FIG_ROLE_TRIANGLE] = RGB(0x18c79c),
            [FIG_ROLE_CONTACT] = RGB(0xf0442c),
            [FIG_ROLE_START] = RGB(0x9fdcfb),
            [FIG_ROLE_END] = RGB(0xf7e83a),
            [FIG_ROLE_POSITIVE] = RGB(0x2a6d9c),
            [FIG_ROLE_NEGATIVE] = RGB(0xa5662a),
            [FIG_ROLE_UNCERTAIN] = RGB(0xb4b8be),
        },
};

const fig_theme *fig_theme_named(const char *name)
{
    const fig_theme *const themes[] = {&fig_theme_light, &fig_theme_dark};
    for (int i = 0; i < 2; i++)
        if (strcmp(themes[i]->name, name) == 0)
            return themes[i];
    return NULL;
}

double fig_rgb_to_linear(double encoded)
{
    return encoded <= 0.04045 ? encoded / 12.92
                              : pow((encoded + 0.055) / 1.055, 2.4);
}

double fig_rgb_from_linear(double linear)
{
    return linear <= 0.0031308 ? linear * 12.92
                               : 1.055 * pow(linear, 1 / 2.4) - 0.055;
}

fig_rgb fig_rgb_mix(fig_rgb a, fig_rgb b, double weight)
{
    return (fig_rgb){a.r + weight * (b.r - a.r), a.g + weight * (b.g - a.g),
                     a.b + weight * (b.b - a.b)};
}

fig_rgb fig_paint_color(const fig_theme *theme, fig_paint paint)
{
    fig_rgb color = theme->color[paint.role];
    if (paint.shade == 0)
        return color;
    fig_role towards = paint.shade > 0 ? FIG_ROLE_INK : FIG_ROLE_PAPER;
    return fig_rgb_mix(color, theme->color[towards], fabs(paint.shade));
}

double fig_paint_opacity(fig_paint paint)
{
    return paint.opacity == 0 ? 1 : paint.opacity;
}
