// The programs that run for each corner and each pixel, in GLSL 3.30.
#ifndef FIG_RENDERER_SHADERS_H
#define FIG_RENDERER_SHADERS_H

/// Solid things: their corners (see fig_vertex), their colour and opacity.
extern const char *const fig_shader_solid_corner;
extern const char *const fig_shader_solid;

/// Translucent things: their corners, and the next layer of them behind the
/// one before.
extern const char *const fig_shader_sheet_corner;
extern const char *const fig_shader_layer;

/// A triangle over the whole picture, and what is done there: put a layer
/// behind those before it; add a finished picture to the sum of pictures.
extern const char *const fig_shader_whole;
extern const char *const fig_shader_under;
extern const char *const fig_shader_finish;

#endif
