#include "renderer/shaders.h"

#define VERSION "#version 330 core\n"

// A corner of a triangle on its way to the picture.
#define CORNER                                                                 \
    "layout(location = 0) in vec3 at;\n"                                       \
    "layout(location = 1) in vec3 normal;\n"                                   \
    "layout(location = 2) in vec4 color;\n"                                    \
    "uniform mat4 projection;\n"                                               \
    "uniform vec2 jitter;\n" /* in half pictures */                            \
    "void project()\n"                                                         \
    "{\n"                                                                      \
    "    gl_Position = projection * vec4(at, 1);\n"                            \
    "    gl_Position.xy += jitter * gl_Position.w;\n"                          \
    "}\n"

// Shading and the sum of pictures count in linear light.  Translucent colours
// are blended as the square roots of it, near to how sRGB encodes them and the
// eye counts: then a tint on white paper is as strong as one on black.
//
// Light from a sky, from a lamp behind the reader's left shoulder, and a
// highlight.  What is far off fades a little towards the paper.
#define LIGHT                                                                  \
    "uniform vec3 eye;\n" /* its place, or its direction */                    \
    "uniform float perspective;\n"                                             \
    "uniform vec3 lamp;\n"                                                     \
    "uniform vec3 paper;\n"                                                    \
    "uniform float fog;\n" /* over all the depth of the scene */               \
    "vec3 to_eye(vec3 place)\n"                                                \
    "{\n"                                                                      \
    "    return normalize(eye - perspective * place);\n"                       \
    "}\n"                                                                      \
    "float key(vec3 n)\n"                                                      \
    "{\n"                                                                      \
    "    float wrapped = 0.5 + 0.5 * dot(n, lamp);\n"                          \
    "    return wrapped * sqrt(wrapped);\n"                                    \
    "}\n"                                                                      \
    "float sky(vec3 n)\n"                                                      \
    "{\n"                                                                      \
    "    return 0.5 + 0.5 * n.z;\n"                                            \
    "}\n"                                                                      \
    "vec3 faded(vec3 color, float depth)\n"                                    \
    "{\n"                                                                      \
    "    float fade = fog * smoothstep(0.3, 1.0, depth);\n"                    \
    "    return mix(sqrt(min(color, 1.0)), sqrt(paper), fade);\n"              \
    "}\n"

const char *const fig_shader_solid_corner =
    VERSION CORNER "out vec3 place, upright;\n"
                   "out vec4 tone;\n"
                   "void main()\n"
                   "{\n"
                   "    project();\n"
                   "    place = at;\n"
                   "    upright = normal;\n"
                   "    tone = color;\n"
                   "}\n";

const char *const fig_shader_solid = VERSION LIGHT
    "in vec3 place, upright;\n"
    "in vec4 tone;\n"
    "out vec4 result;\n"
    "void main()\n"
    "{\n"
    "    bool painted = dot(upright, upright) < 0.0625;\n"
    "    vec3 v = to_eye(place), n = painted ? v : normalize(upright);\n"
    "    n *= dot(n, v) < 0.0 ? -1.0 : 1.0;\n"
    "    float shine = max(dot(n, normalize(lamp + v)), 0.0);\n"
    "    shine *= shine; shine *= shine; shine *= shine; shine *= shine;\n"
    "    vec3 lit = tone.rgb * (0.30 + 0.30 * sky(n) + 0.60 * key(n));\n"
    "    lit += 0.16 * shine * shine;\n"
    "    vec3 seen = faded(lit, gl_FragCoord.z);\n"
    "    seen = painted ? sqrt(min(tone.rgb, 1.0)) : seen;\n"
    "    result = vec4(seen, tone.a);\n"
    "}\n";

// A sheet is thicker along a slanting line of sight, hence more opaque.  All
// of this varies so little over a triangle that its corners do.  Its plane
// gives the depth z = x plane.x + y plane.y + plane.z of each place (x, y) of
// the picture, to the same bit for all sheets of that plane; if it has none, or
// one that is seen edge-on, plane.w is 0.
const char *const fig_shader_sheet_corner = VERSION CORNER LIGHT
    "layout(location = 3) in float level;\n"
    "out vec4 light;\n"
    "flat out vec4 plane;\n"
    "void main()\n"
    "{\n"
    "    project();\n"
    "    vec4 seen = transpose(inverse(projection)) * vec4(normal, -level);\n"
    "    bool fit = level < 1e20 &&\n"
    "        dot(abs(seen), vec4(1)) < 1000.0 * abs(seen.z);\n"
    "    plane = fit ? vec4(-seen.xyw / seen.z, 1) : vec4(0);\n"
    "    plane.z -= dot(plane.xy, jitter);\n"
    "    vec3 v = to_eye(at), n = normal;\n"
    "    float slant = dot(n, v);\n"
    "    n *= slant < 0.0 ? -1.0 : 1.0;\n"
    "    slant = max(abs(slant), 0.45);\n"
    "    vec3 lit = color.rgb * (0.68 + 0.16 * sky(n) + 0.28 * key(n));\n"
    "    float depth = 0.5 + 0.5 * gl_Position.z / gl_Position.w;\n"
    "    float through = pow(1.0 - color.a, 1.0 / slant);\n"
    "    light = vec4(faded(lit, depth), 1) * (1.0 - through);\n"
    "}\n";

const char *const fig_shader_layer =
    VERSION "in vec4 light;\n"
            "flat in vec4 plane;\n"
            "uniform sampler2D before, solid;\n"
            "out vec4 result;\n"
            "float depth()\n"
            "{\n"
            "    vec2 size = vec2(textureSize(solid, 0));\n"
            "    vec2 at = 2.0 * gl_FragCoord.xy / size - 1.0;\n"
            "    float z = dot(plane.xyz, vec3(at, 1));\n"
            "    return plane.w > 0.0 ? 0.5 + 0.5 * z : gl_FragCoord.z;\n"
            "}\n"
            "void main()\n"
            "{\n"
            "    ivec2 pixel = ivec2(gl_FragCoord.xy);\n"
            "    float z = depth();\n"
            "    if (z <= texelFetch(before, pixel, 0).r ||\n"
            "        z >= texelFetch(solid, pixel, 0).r)\n"
            "        discard;\n"
            "    gl_FragDepth = z;\n"
            "    result = light;\n"
            "}\n";

const char *const fig_shader_whole =
    VERSION "void main()\n"
            "{\n"
            "    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);\n"
            "    gl_Position = vec4(4.0 * corner - 1.0, 0, 1);\n"
            "}\n";

const char *const fig_shader_under =
    VERSION "uniform sampler2D layer;\n"
            "out vec4 result;\n"
            "void main()\n"
            "{\n"
            "    result = texelFetch(layer, ivec2(gl_FragCoord.xy), 0);\n"
            "}\n";

// A solid thing that passes behind another one breaks off a little beside it:
// then it is plain which of the two is in front.  Only things whose opacity is
// written as 1 have such a border; thin lines are written as a half.  Most
// pixels have none, hence a loop of no rounds: Mesa takes the time of both
// sides of an if.
const char *const fig_shader_finish = VERSION
    "uniform sampler2D front, color, solid;\n"
    "uniform vec3 paper;\n"
    "uniform float weight;\n"
    "uniform float halo;\n" // in pixels
    "uniform float gap;\n"  // in depth, from which on there is a halo
    "out vec4 result;\n"
    "float hidden(ivec2 pixel, int count)\n"
    "{\n"
    "    float depth = texelFetch(solid, pixel, 0).r, most = 0.0;\n"
    "    ivec2 last = textureSize(solid, 0) - 1;\n"
    "    for (int i = 0; i < count; i++) {\n"
    "        float turn = 0.5235988 * float(i);\n"
    "        vec2 off = halo * vec2(cos(turn), sin(turn));\n"
    "        ivec2 there = clamp(pixel + ivec2(round(off)), ivec2(0), last);\n"
    "        float nearer = depth - texelFetch(solid, there, 0).r;\n"
    "        bool casts = texelFetch(color, there, 0).a > 0.75;\n"
    "        most = max(most, casts ? nearer : 0.0);\n"
    "    }\n"
    "    return smoothstep(gap, 2.0 * gap, most);\n"
    "}\n"
    "void main()\n"
    "{\n"
    "    ivec2 pixel = ivec2(gl_FragCoord.xy);\n"
    "    vec4 over = texelFetch(front, pixel, 0);\n"
    "    vec4 under = texelFetch(color, pixel, 0);\n"
    "    int around = under.a > 0.0 && gap < 1.0 ? 12 : 0;\n"
    "    if (under.a > 0.0)\n"
    "        under.a = 1.0;\n"
    "    under *= 1.0 - 0.9 * hidden(pixel, around);\n"
    "    over += (1.0 - over.a) * under;\n"
    "    over.rgb += (1.0 - over.a) * sqrt(paper);\n"
    "    result = weight * vec4(over.rgb * over.rgb, over.a);\n"
    "}\n";
