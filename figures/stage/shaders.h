// The programs that run for each corner and each pixel, in GLSL 3.30.
#ifndef TF_STAGE_SHADERS_H
#define TF_STAGE_SHADERS_H

/// Corners of triangles: see tf_vertex.
extern const char *const tf_shader_corner;

/// Solid things: colour and coverage.
extern const char *const tf_shader_solid;

/// The next layer of translucent things behind the one before.
extern const char *const tf_shader_layer;

/// A triangle over the whole picture, and what is done there: put a layer
/// behind those before it; add a finished picture to the sum of pictures.
extern const char *const tf_shader_whole;
extern const char *const tf_shader_under;
extern const char *const tf_shader_finish;

#endif
