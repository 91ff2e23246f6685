#include "stage/theme.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

/// A colour from its usual notation, 0xRRGGBB.
#define RGB(hex)                                                               \
    {                                                                          \
        ((hex) >> 16 & 255) / 255.0, ((hex) >> 8 & 255) / 255.0,               \
            ((hex)&255) / 255.0                                                \
    }

// The colours of Okabe and Ito, darkened where paper is white and lightened
// where it is black until lines of them stand off it.
const tf_theme tf_theme_light = {
    .name = "light",
    .opacity_power = 1,
    .color =
        {
            [TF_ROLE_INK] = RGB(0x20242a),
            [TF_ROLE_PAPER] = RGB(0xffffff),
            [TF_ROLE_NEUTRAL] = RGB(0x6f757e),
            [TF_ROLE_POINT] = RGB(0xa8379f),
            [TF_ROLE_EDGE] = RGB(0x0068c0),
            [TF_ROLE_OTHER_EDGE] = RGB(0xdb8000),
            [TF_ROLE_TRIANGLE] = RGB(0x00a07c),
            [TF_ROLE_CONTACT] = RGB(0xc81e00),
            [TF_ROLE_START] = RGB(0x5796e0),
            [TF_ROLE_END] = RGB(0x8e7f00),
            [TF_ROLE_POSITIVE] = RGB(0x8cc4e8),
            [TF_ROLE_NEGATIVE] = RGB(0xf2b97c),
            [TF_ROLE_UNCERTAIN] = RGB(0x5c6068),
        },
};

const tf_theme tf_theme_dark = {
    .name = "dark",
    .dark = true,
    .opacity_power = 1.15,
    .color =
        {
            [TF_ROLE_INK] = RGB(0xe8eaed),
            [TF_ROLE_PAPER] = RGB(0x16181c),
            [TF_ROLE_NEUTRAL] = RGB(0x8a8f98),
            [TF_ROLE_POINT] = RGB(0xd391e6),
            [TF_ROLE_EDGE] = RGB(0x3590d8),
            [TF_ROLE_OTHER_EDGE] = RGB(0xff9c1a),
            [TF_ROLE_TRIANGLE] = RGB(0x18c79c),
            [TF_ROLE_CONTACT] = RGB(0xf0442c),
            [TF_ROLE_START] = RGB(0x9fdcfb),
            [TF_ROLE_END] = RGB(0xf7e83a),
            [TF_ROLE_POSITIVE] = RGB(0x2a6d9c),
            [TF_ROLE_NEGATIVE] = RGB(0xa5662a),
            [TF_ROLE_UNCERTAIN] = RGB(0xb4b8be),
        },
};

const tf_theme *tf_theme_named(const char *name)
{
    const tf_theme *const themes[] = {&tf_theme_light, &tf_theme_dark};
    for (int i = 0; i < 2; i++)
        if (strcmp(themes[i]->name, name) == 0)
            return themes[i];
    return NULL;
}

double tf_rgb_to_linear(double encoded)
{
    return encoded <= 0.04045 ? encoded / 12.92
                              : pow((encoded + 0.055) / 1.055, 2.4);
}

double tf_rgb_from_linear(double linear)
{
    return linear <= 0.0031308 ? linear * 12.92
                               : 1.055 * pow(linear, 1 / 2.4) - 0.055;
}

tf_rgb tf_rgb_mix(tf_rgb a, tf_rgb b, double weight)
{
    return (tf_rgb){a.r + weight * (b.r - a.r), a.g + weight * (b.g - a.g),
                    a.b + weight * (b.b - a.b)};
}

tf_rgb tf_paint_color(const tf_theme *theme, tf_paint paint)
{
    tf_rgb color = theme->color[paint.role];
    if (paint.shade == 0)
        return color;
    tf_role towards = paint.shade > 0 ? TF_ROLE_INK : TF_ROLE_PAPER;
    return tf_rgb_mix(color, theme->color[towards], fabs(paint.shade));
}

double tf_paint_opacity(tf_paint paint)
{
    return paint.opacity == 0 ? 1 : paint.opacity;
}
