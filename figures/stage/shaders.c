#include "stage/shaders.h"

#define VERSION "#version 330 core\n"

const char *const tf_shader_corner =
    VERSION "layout(location = 0) in vec3 at;\n"
            "layout(location = 1) in vec3 normal;\n"
            "layout(location = 2) in vec4 color;\n"
            "layout(location = 3) in float facing;\n"
            "uniform mat4 projection;\n"
            "uniform vec2 jitter;\n" // in half pictures
            "out vec3 place, upright;\n"
            "out vec4 tone;\n"
            "out float sheet;\n"
            "void main()\n"
            "{\n"
            "    place = at;\n"
            "    upright = normal;\n"
            "    tone = color;\n"
            "    sheet = facing;\n"
            "    gl_Position = projection * vec4(at, 1);\n"
            "    gl_Position.xy += jitter * gl_Position.w;\n"
            "}\n";

// Light from a sky, from a lamp behind the reader's left shoulder, and a small
// highlight.  A sheet is thicker along a slanting line of sight, hence more
// opaque.  What is far off fades a little towards the paper.
#define SHADE                                                                  \
    "in vec3 place, upright;\n"                                                \
    "in vec4 tone;\n"                                                          \
    "in float sheet;\n"                                                        \
    "uniform vec3 eye;\n" /* its place, or its direction */                    \
    "uniform float perspective;\n"                                             \
    "uniform vec3 lamp;\n"                                                     \
    "uniform vec3 paper;\n"                                                    \
    "vec4 shade()\n"                                                           \
    "{\n"                                                                      \
    "    vec3 v = normalize(eye - perspective * place);\n"                     \
    "    vec3 n = normalize(upright);\n"                                       \
    "    float slant = dot(n, v);\n"                                           \
    "    n *= slant < 0.0 ? -1.0 : 1.0;\n"                                     \
    "    slant = max(abs(slant), 0.15);\n"                                     \
    "    float key = pow(0.5 + 0.5 * dot(n, lamp), 1.5);\n"                    \
    "    float sky = 0.5 + 0.5 * n.z;\n"                                       \
    "    float lit = mix(0.30 + 0.30 * sky + 0.60 * key,\n"                    \
    "                    0.70 + 0.15 * sky + 0.25 * key, sheet);\n"            \
    "    float shine = pow(max(dot(n, normalize(lamp + v)), 0.0), 40.0);\n"    \
    "    vec3 color = tone.rgb * lit\n"                                        \
    "               + (0.18 - 0.14 * sheet) * shine;\n"                        \
    "    float fade = 0.22 * smoothstep(0.3, 1.0, gl_FragCoord.z);\n"          \
    "    color = mix(min(color, 1.0), paper, fade);\n"                         \
    "    float through = pow(1.0 - tone.a, mix(1.0, 1.0 / slant, sheet));\n"   \
    "    return vec4(color, 1.0) * (1.0 - through);\n"                         \
    "}\n"

const char *const tf_shader_solid = VERSION SHADE "out vec4 result;\n"
                                                  "void main()\n"
                                                  "{\n"
                                                  "    result = shade();\n"
                                                  "}\n";

const char *const tf_shader_layer = VERSION SHADE
    "uniform sampler2D before, solid;\n"
    "out vec4 result;\n"
    "void main()\n"
    "{\n"
    "    ivec2 pixel = ivec2(gl_FragCoord.xy);\n"
    "    if (gl_FragCoord.z <= texelFetch(before, pixel, 0).r ||\n"
    "        gl_FragCoord.z >= texelFetch(solid, pixel, 0).r)\n"
    "        discard;\n"
    "    result = shade();\n"
    "}\n";

const char *const tf_shader_whole =
    VERSION "void main()\n"
            "{\n"
            "    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);\n"
            "    gl_Position = vec4(4.0 * corner - 1.0, 0, 1);\n"
            "}\n";

const char *const tf_shader_under =
    VERSION "uniform sampler2D layer;\n"
            "out vec4 result;\n"
            "void main()\n"
            "{\n"
            "    result = texelFetch(layer, ivec2(gl_FragCoord.xy), 0);\n"
            "}\n";

// A solid thing that passes behind another one breaks off a little beside it:
// then it is plain which of the two is in front.
const char *const tf_shader_finish = VERSION
    "uniform sampler2D front, color, solid;\n"
    "uniform float weight;\n"
    "uniform float halo;\n" // in pixels
    "uniform float gap;\n"  // in depth, from which on there is a halo
    "out vec4 result;\n"
    "float hidden(ivec2 pixel)\n"
    "{\n"
    "    float depth = texelFetch(solid, pixel, 0).r, most = 0.0;\n"
    "    ivec2 last = textureSize(solid, 0) - 1;\n"
    "    for (int i = 0; i < 12; i++) {\n"
    "        float turn = 0.5235988 * float(i);\n"
    "        vec2 off = halo * vec2(cos(turn), sin(turn));\n"
    "        ivec2 there = clamp(pixel + ivec2(round(off)), ivec2(0), last);\n"
    "        float nearer = depth - texelFetch(solid, there, 0).r;\n"
    "        most = max(most, nearer);\n"
    "    }\n"
    "    return smoothstep(gap, 2.0 * gap, most);\n"
    "}\n"
    "void main()\n"
    "{\n"
    "    ivec2 pixel = ivec2(gl_FragCoord.xy);\n"
    "    vec4 over = texelFetch(front, pixel, 0);\n"
    "    vec4 under = texelFetch(color, pixel, 0);\n"
    "    if (under.a > 0.0)\n"
    "        under *= 1.0 - 0.9 * hidden(pixel);\n"
    "    result = weight * (over + (1.0 - over.a) * under);\n"
    "}\n";
