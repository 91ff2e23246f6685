#include "renderer/render.h"

#include "renderer/gl.h"
#include "renderer/list.h"
#include "renderer/shaders.h"

#include <float.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum {
    SHIFTS = 8,       ///< pictures that are summed
    FEW_SHIFTS = 4,   ///< the same, where speed counts
    LAYERS_MOST = 64, ///< translucent things behind each other
    RUN = 384         ///< vertices of a call: Mesa takes the square of the time
                      ///< for long ones where a triangle is cut
};

/// How far off a solid thing breaks off where it passes behind another, and
/// how far behind it must be; in points.
static const double halo_width = 0.9, halo_gap = 6;

/// How much of the paper's color the farthest things take on, in a scene half
/// as deep as its panel is high or deeper.
static const double fog_most = 0.25;

/// Within a pixel, from its middle: eight rooks that do not attack each other,
/// so that edges of any slant, steep and flat ones too, get eight steps.
static const double shift[SHIFTS][2] = {{-0.4375, 0.0625}, {-0.3125, -0.3125},
                                        {-0.1875, 0.3125}, {-0.0625, -0.0625},
                                        {0.0625, 0.4375},  {0.1875, -0.4375},
                                        {0.3125, 0.1875},  {0.4375, -0.1875}};

/// The same with four rooks.
static const double few_shift[FEW_SHIFTS][2] = {
    {-0.375, -0.125}, {-0.125, 0.375}, {0.125, -0.375}, {0.375, 0.125}};

typedef enum program {
    SOLID,
    LAYER,
    UNDER,
    FINISH,
    PROGRAMS
} program;

/// What is drawn to: pictures and depths of the same size.
typedef enum target {
    SOLID_COLOR,
    SOLID_DEPTH,
    LAYER_COLOR,
    LAYER_DEPTH_EVEN,
    LAYER_DEPTH_ODD,
    FRONT,
    SUM,
    TARGETS
} target;

typedef enum frame {
    SOLID_FRAME,
    EVEN_FRAME,
    ODD_FRAME,
    FRONT_FRAME,
    SUM_FRAME,
    FRAMES
} frame;

struct fig_renderer {
    fig_context *context;
    fig_gl gl;
    GLuint programs[PROGRAMS];
    GLuint textures[TARGETS], frames[FRAMES];
    GLuint vertices, corners, nothing, query;
    int width, height; ///< of the textures
    fig_mesh seen;     ///< the triangles of a mesh that a window shows
};

// Making -----------------------------------------------------------------

static GLuint compile(const fig_gl *gl, GLenum kind, const char *source)
{
    GLuint shader = gl->CreateShader(kind);
    gl->ShaderSource(shader, 1, &source, NULL);
    gl->CompileShader(shader);
    return shader;
}

/// A program; 0 if it does not compile and link.
static GLuint link_program(const fig_gl *gl, const char *corner,
                           const char *pixel)
{
    GLuint made = gl->CreateProgram();
    GLuint part[2] = {compile(gl, GL_VERTEX_SHADER, corner),
                      compile(gl, GL_FRAGMENT_SHADER, pixel)};
    for (int i = 0; i < 2; i++) {
        gl->AttachShader(made, part[i]);
        gl->DeleteShader(part[i]);
    }
    gl->LinkProgram(made);
    GLint linked = GL_FALSE;
    gl->GetProgramiv(made, GL_LINK_STATUS, &linked);
    if (linked == GL_TRUE)
        return made;
    gl->DeleteProgram(made);
    return 0;
}

static bool make_programs(fig_renderer *r)
{
    const char *const source[PROGRAMS][2] = {
        [SOLID] = {fig_shader_solid_corner, fig_shader_solid},
        [LAYER] = {fig_shader_sheet_corner, fig_shader_layer},
        [UNDER] = {fig_shader_whole, fig_shader_under},
        [FINISH] = {fig_shader_whole, fig_shader_finish},
    };
    for (int i = 0; i < PROGRAMS; i++) {
        r->programs[i] = link_program(&r->gl, source[i][0], source[i][1]);
        if (r->programs[i] == 0)
            return false;
    }
    return true;
}

static void make_vertex_arrays(fig_renderer *r)
{
    const fig_gl *gl = &r->gl;
    gl->GenVertexArrays(1, &r->nothing);
    gl->GenVertexArrays(1, &r->corners);
    gl->GenBuffers(1, &r->vertices);
    gl->BindVertexArray(r->corners);
    gl->BindBuffer(GL_ARRAY_BUFFER, r->vertices);
    const struct {
        GLint size;
        uintptr_t offset;
    } attribute[] = {{3, offsetof(fig_vertex, at)},
                     {3, offsetof(fig_vertex, normal)},
                     {4, offsetof(fig_vertex, color)},
                     {1, offsetof(fig_vertex, level)}};
    for (GLuint i = 0; i < 4; i++) {
        // OpenGL takes an offset for a pointer.
        const void *offset =
            (const void *)attribute[i].offset; // NOLINT(*-no-int-to-ptr)
        gl->VertexAttribPointer(i, attribute[i].size, GL_FLOAT, GL_FALSE,
                                sizeof(fig_vertex), offset);
        gl->EnableVertexAttribArray(i);
    }
}

fig_status fig_renderer_new(fig_renderer **renderer)
{
    fig_renderer *r = *renderer = calloc(1, sizeof *r);
    if (r == NULL)
        return FIG_NO_MEMORY;
    r->context = fig_context_open();
    fig_status status = FIG_OK;
    if (r->context == NULL || !fig_gl_load(&r->gl))
        status = FIG_NO_CONTEXT;
    else if (!make_programs(r))
        status = FIG_NO_SHADER;
    if (status != FIG_OK) {
        fig_context_close(r->context);
        free(r);
        *renderer = NULL;
        return status;
    }
    make_vertex_arrays(r);
    r->gl.GenTextures(TARGETS, r->textures);
    r->gl.GenFramebuffers(FRAMES, r->frames);
    r->gl.GenQueries(1, &r->query);
    return FIG_OK;
}

void fig_renderer_free(fig_renderer *r)
{
    if (r == NULL)
        return;
    const fig_gl *gl = &r->gl;
    for (int i = 0; i < PROGRAMS; i++)
        gl->DeleteProgram(r->programs[i]);
    gl->DeleteTextures(TARGETS, r->textures);
    gl->DeleteFramebuffers(FRAMES, r->frames);
    gl->DeleteQueries(1, &r->query);
    gl->DeleteBuffers(1, &r->vertices);
    gl->DeleteVertexArrays(1, &r->corners);
    gl->DeleteVertexArrays(1, &r->nothing);
    fig_context_close(r->context);
    free(r->seen.vertices);
    free(r);
}

// Targets ----------------------------------------------------------------

static void size_texture(const fig_renderer *r, target t)
{
    const fig_gl *gl = &r->gl;
    bool depth =
        t == SOLID_DEPTH || t == LAYER_DEPTH_EVEN || t == LAYER_DEPTH_ODD;
    GLint kept = depth      ? GL_DEPTH_COMPONENT32F
                 : t == SUM ? GL_RGBA32F
                            : GL_RGBA16F;
    gl->BindTexture(GL_TEXTURE_2D, r->textures[t]);
    gl->TexImage2D(GL_TEXTURE_2D, 0, kept, r->width, r->height, 0,
                   depth ? GL_DEPTH_COMPONENT : GL_RGBA, GL_FLOAT, NULL);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

static bool size_targets(fig_renderer *r, int width, int height)
{
    static const struct {
        frame frame;
        GLenum place;
        target target;
    } parts[] = {{SOLID_FRAME, GL_COLOR_ATTACHMENT0, SOLID_COLOR},
                 {SOLID_FRAME, GL_DEPTH_ATTACHMENT, SOLID_DEPTH},
                 {EVEN_FRAME, GL_COLOR_ATTACHMENT0, LAYER_COLOR},
                 {EVEN_FRAME, GL_DEPTH_ATTACHMENT, LAYER_DEPTH_EVEN},
                 {ODD_FRAME, GL_COLOR_ATTACHMENT0, LAYER_COLOR},
                 {ODD_FRAME, GL_DEPTH_ATTACHMENT, LAYER_DEPTH_ODD},
                 {FRONT_FRAME, GL_COLOR_ATTACHMENT0, FRONT},
                 {SUM_FRAME, GL_COLOR_ATTACHMENT0, SUM}};
    const fig_gl *gl = &r->gl;
    if (width == r->width && height == r->height)
        return true;
    r->width = width;
    r->height = height;
    for (int t = 0; t < TARGETS; t++)
        size_texture(r, (target)t);
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
        gl->BindFramebuffer(GL_FRAMEBUFFER, r->frames[parts[i].frame]);
        gl->FramebufferTexture2D(GL_FRAMEBUFFER, parts[i].place, GL_TEXTURE_2D,
                                 r->textures[parts[i].target], 0);
    }
    bool complete = true;
    for (int f = 0; f < FRAMES; f++) {
        gl->BindFramebuffer(GL_FRAMEBUFFER, r->frames[f]);
        complete = complete && gl->CheckFramebufferStatus(GL_FRAMEBUFFER) ==
                                   GL_FRAMEBUFFER_COMPLETE;
    }
    if (!complete)
        r->width = 0;
    return complete;
}

// Uniforms ---------------------------------------------------------------

static GLint uniform(const fig_renderer *r, program p, const char *name)
{
    return r->gl.GetUniformLocation(r->programs[p], name);
}

static void set_vector(const fig_renderer *r, program p, const char *name,
                       tf_vector v)
{
    r->gl.Uniform3f(uniform(r, p, name), (float)v.x[0], (float)v.x[1],
                    (float)v.x[2]);
}

/// Let a sampler of a program read a target.
static void set_sampler(const fig_renderer *r, program p, const char *name,
                        int unit, target t)
{
    r->gl.ActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    r->gl.BindTexture(GL_TEXTURE_2D, r->textures[t]);
    r->gl.Uniform1i(uniform(r, p, name), unit);
}

/// How near to the eye a mesh begins and how far it goes, along view->back.
static void find_range(const fig_mesh *mesh, const fig_view *view, double *lo,
                       double *hi)
{
    *lo = DBL_MAX;
    *hi = -DBL_MAX;
    for (int i = 0; i < mesh->count; i++) {
        const float *at = mesh->vertices[i].at;
        double d =
            tf_vector_dot((tf_vector){{at[0], at[1], at[2]}}, view->back);
        *lo = fmin(*lo, d);
        *hi = fmax(*hi, d);
    }
    double room = (*hi - *lo) / 64 + 1e-6 / view->points_per_unit;
    *lo -= room;
    *hi += room;
    if (view->distance > 0)
        *hi = fmin(*hi, view->distance * (1023.0 / 1024));
    if (view->distance > 0)
        *lo = fmin(*lo, *hi - view->distance / 1024);
}

/// The rows x, y, z, w of clip space, for a window; y down as the rows of a
/// picture go.  Columns are world axes, from the view's center, and 1.
static void find_projection(const fig_view *view, const fig_box *window,
                            double lo, double hi, float matrix[16])
{
    double row[4][4] = {{0}};
    double ppu = view->points_per_unit;
    double per = view->distance > 0 ? 1 / view->distance : 0;
    double dx = view->box.x + view->box.width / 2 - window->x;
    double dy = view->box.y + view->box.height / 2 - window->y;
    double w_lo = 1 - per * lo, w_hi = 1 - per * hi;
    double z_slope = -(w_hi + w_lo) / (hi - lo);
    for (int k = 0; k < 3; k++) {
        double right = ppu * view->right.x[k], up = ppu * view->up.x[k];
        row[3][k] = -per * view->back.x[k];
        row[0][k] = 2 * (right + dx * row[3][k]) / window->width;
        row[1][k] = 2 * (dy * row[3][k] - up) / window->height;
        row[0][k] -= row[3][k];
        row[1][k] -= row[3][k];
        row[2][k] = z_slope * view->back.x[k];
    }
    row[0][3] = 2 * dx / window->width - 1;
    row[1][3] = 2 * dy / window->height - 1;
    row[2][3] = w_lo - z_slope * lo;
    row[3][3] = 1;
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 4; k++)
            matrix[4 * k + i] = (float)row[i][k];
}

/// Tell a program the color of the paper, in linear light.
static void set_paper(const fig_renderer *r, program p, const fig_theme *theme)
{
    const fig_rgb *paper = &theme->color[FIG_ROLE_PAPER];
    set_vector(
        r, p, "paper",
        (tf_vector){{fig_rgb_to_linear(paper->r), fig_rgb_to_linear(paper->g),
                     fig_rgb_to_linear(paper->b)}});
}

static void set_view(const fig_renderer *r, program p, const fig_view *view,
                     const float matrix[16], const fig_theme *theme)
{
    bool perspective = view->distance > 0;
    tf_vector eye =
        tf_vector_scaled(perspective ? view->distance : 1, view->back);
    tf_vector lamp = tf_vector_scaled(-0.45, view->right);
    lamp = fig_combination(lamp, 0.70, view->up);
    lamp = fig_combination(lamp, 0.75, view->back);
    r->gl.UseProgram(r->programs[p]);
    r->gl.UniformMatrix4fv(uniform(r, p, "projection"), 1, GL_FALSE, matrix);
    r->gl.Uniform1f(uniform(r, p, "perspective"), perspective ? 1 : 0);
    set_vector(r, p, "eye", eye);
    set_vector(r, p, "lamp", fig_normalized(lamp));
    set_paper(r, p, theme);
}

// What a window shows ------------------------------------------------------

/// Whether a triangle, from its first vertex on, may be seen in a box.  One
/// that reaches the eye or beyond may be anywhere.
static bool may_be_seen(const fig_vertex vertex[3], const fig_view *view,
                        const fig_box *box)
{
    fig_point lo = {DBL_MAX, DBL_MAX}, hi = {-DBL_MAX, -DBL_MAX};
    for (int i = 0; i < 3; i++) {
        const float *at = vertex[i].at;
        tf_vector world =
            fig_sum(view->center, (tf_vector){{at[0], at[1], at[2]}});
        double off = view->distance + fig_view_depth(view, world);
        if (view->distance > 0 && off <= view->distance / 512)
            return true;
        fig_point seen = fig_view_project(view, world);
        lo = (fig_point){fmin(lo.x, seen.x), fmin(lo.y, seen.y)};
        hi = (fig_point){fmax(hi.x, seen.x), fmax(hi.y, seen.y)};
    }
    return lo.x <= box->x + box->width && hi.x >= box->x &&
           lo.y <= box->y + box->height && hi.y >= box->y;
}

/// Gather the triangles that a window may show, in their order.  False if there
/// is no memory.
static bool gather_seen(fig_renderer *r, const fig_mesh *mesh,
                        const fig_view *view, fig_window window)
{
    fig_mesh *seen = &r->seen;
    double pixel = window.box.width / window.width;
    fig_box box = {window.box.x - pixel, window.box.y - pixel,
                   window.box.width + 2 * pixel, window.box.height + 2 * pixel};
    seen->count = seen->opaque = 0;
    for (int i = 0; i < mesh->count; i += 3) {
        if (i == mesh->opaque)
            seen->opaque = seen->count;
        if (!may_be_seen(&mesh->vertices[i], view, &box))
            continue;
        if (!fig_list_room(&seen->vertices, seen->count, 3, &seen->room,
                           sizeof *seen->vertices))
            return false;
        memcpy(&seen->vertices[seen->count], &mesh->vertices[i],
               3 * sizeof *seen->vertices);
        seen->count += 3;
    }
    if (mesh->opaque == mesh->count)
        seen->opaque = seen->count;
    return true;
}

// Drawing ----------------------------------------------------------------

static void use(const fig_renderer *r, program p, const double shifted[2])
{
    r->gl.UseProgram(r->programs[p]);
    r->gl.Uniform2f(uniform(r, p, "jitter"), (float)(2 * shifted[0] / r->width),
                    (float)(2 * shifted[1] / r->height));
}

static void clear(const fig_renderer *r, frame f, double depth)
{
    const fig_gl *gl = &r->gl;
    gl->BindFramebuffer(GL_FRAMEBUFFER, r->frames[f]);
    gl->ClearColor(0, 0, 0, 0);
    gl->ClearDepth(depth);
    gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

static void draw_triangles(const fig_renderer *r, int begin, int end)
{
    for (; begin < end; begin += RUN)
        r->gl.DrawArrays(GL_TRIANGLES, begin,
                         end - begin < RUN ? end - begin : RUN);
}

static void draw_solid(const fig_renderer *r, const fig_mesh *mesh,
                       const double shifted[2])
{
    clear(r, SOLID_FRAME, 1);
    use(r, SOLID, shifted);
    r->gl.BindVertexArray(r->corners);
    r->gl.Enable(GL_DEPTH_TEST);
    draw_triangles(r, 0, mesh->opaque);
    r->gl.Disable(GL_DEPTH_TEST);
}

/// Draw what is nearest of all that is behind the layer before.  False if
/// there is nothing.
static bool draw_layer(const fig_renderer *r, const fig_mesh *mesh, int layer,
                       const double shifted[2])
{
    const fig_gl *gl = &r->gl;
    bool odd = layer % 2 == 1;
    clear(r, odd ? ODD_FRAME : EVEN_FRAME, 1);
    use(r, LAYER, shifted);
    set_sampler(r, LAYER, "before", 0,
                odd ? LAYER_DEPTH_EVEN : LAYER_DEPTH_ODD);
    set_sampler(r, LAYER, "solid", 1, SOLID_DEPTH);
    gl->BindVertexArray(r->corners);
    gl->Enable(GL_DEPTH_TEST);
    gl->BeginQuery(GL_ANY_SAMPLES_PASSED, r->query);
    draw_triangles(r, mesh->opaque, mesh->count);
    gl->EndQuery(GL_ANY_SAMPLES_PASSED);
    gl->Disable(GL_DEPTH_TEST);
    GLuint any = 0;
    gl->GetQueryObjectuiv(r->query, GL_QUERY_RESULT, &any);
    return any != 0;
}

static void draw_whole(const fig_renderer *r, frame f, GLenum blend)
{
    const fig_gl *gl = &r->gl;
    gl->BindFramebuffer(GL_FRAMEBUFFER, r->frames[f]);
    gl->BindVertexArray(r->nothing);
    gl->Enable(GL_BLEND);
    gl->BlendFunc(blend, GL_ONE);
    gl->DrawArrays(GL_TRIANGLES, 0, 3);
    gl->Disable(GL_BLEND);
}

/// Collect the translucent layers, front to back.
static void draw_front(const fig_renderer *r, const fig_mesh *mesh,
                       const double shifted[2])
{
    clear(r, FRONT_FRAME, 1);
    clear(r, ODD_FRAME, 0);
    if (mesh->count == mesh->opaque)
        return;
    for (int layer = 0; layer < LAYERS_MOST; layer++) {
        if (!draw_layer(r, mesh, layer, shifted))
            return;
        r->gl.UseProgram(r->programs[UNDER]);
        set_sampler(r, UNDER, "layer", 0, LAYER_COLOR);
        draw_whole(r, FRONT_FRAME, GL_ONE_MINUS_DST_ALPHA);
    }
}

static void add_to_sum(const fig_renderer *r)
{
    r->gl.UseProgram(r->programs[FINISH]);
    set_sampler(r, FINISH, "front", 0, FRONT);
    set_sampler(r, FINISH, "color", 1, SOLID_COLOR);
    set_sampler(r, FINISH, "solid", 2, SOLID_DEPTH);
    draw_whole(r, SUM_FRAME, GL_ONE);
}

/// Whether something stands off what is behind it.
static bool stands_off(const fig_mesh *mesh)
{
    for (int i = 0; i < mesh->opaque; i++)
        if (mesh->vertices[i].color[3] > 0.75F)
            return true;
    return false;
}

/// Tell the programs what is the same for all shifted pictures.
static void set_scene(const fig_renderer *r, const fig_mesh *mesh,
                      const fig_view *view, fig_window window,
                      const fig_theme *theme)
{
    double lo, hi;
    float matrix[16];
    find_range(mesh, view, &lo, &hi);
    find_projection(view, &window.box, lo, hi, matrix);
    set_view(r, SOLID, view, matrix, theme);
    set_view(r, LAYER, view, matrix, theme);
    double pixels_per_point = window.width / window.box.width;
    double depth_per_point = 1 / view->points_per_unit / (hi - lo);
    double depth = (hi - lo) * view->points_per_unit / view->box.height;
    double fog = window.steady ? 0 : fog_most * fmin(1, 2 * depth);
    for (int p = SOLID; p <= LAYER; p++) {
        r->gl.UseProgram(r->programs[p]);
        r->gl.Uniform1f(uniform(r, (program)p, "fog"), (float)fog);
    }
    r->gl.UseProgram(r->programs[FINISH]);
    set_paper(r, FINISH, theme);
    r->gl.Uniform1f(uniform(r, FINISH, "weight"),
                    1.0F / (float)(window.coarse ? FEW_SHIFTS : SHIFTS));
    r->gl.Uniform1f(uniform(r, FINISH, "halo"),
                    (float)(halo_width * pixels_per_point));
    r->gl.Uniform1f(uniform(r, FINISH, "gap"),
                    stands_off(mesh) ? (float)(halo_gap * depth_per_point) : 1);
}

fig_status fig_renderer_draw(fig_renderer *r, const fig_mesh *mesh,
                             const fig_view *view, fig_window window,
                             const fig_theme *theme, float *pixels)
{
    const fig_gl *gl = &r->gl;
    if (!size_targets(r, window.width, window.height) ||
        !gather_seen(r, mesh, view, window))
        return FIG_NO_MEMORY;
    const fig_mesh *seen = &r->seen;
    gl->Viewport(0, 0, window.width, window.height);
    gl->BindBuffer(GL_ARRAY_BUFFER, r->vertices);
    gl->BufferData(GL_ARRAY_BUFFER,
                   (GLsizeiptr)((size_t)seen->count * sizeof(fig_vertex)),
                   seen->vertices, GL_STATIC_DRAW);
    set_scene(r, mesh, view, window, theme);
    clear(r, SUM_FRAME, 1);
    const double(*shifts)[2] = window.coarse ? few_shift : shift;
    int count = window.coarse ? FEW_SHIFTS : SHIFTS;
    for (int i = 0; i < count && mesh->count > 0; i++) {
        draw_solid(r, seen, shifts[i]);
        draw_front(r, seen, shifts[i]);
        add_to_sum(r);
    }
    gl->BindFramebuffer(GL_FRAMEBUFFER, r->frames[SUM_FRAME]);
    gl->ReadPixels(0, 0, window.width, window.height, GL_RGBA, GL_FLOAT,
                   pixels);
    return gl->GetError() == GL_NO_ERROR ? FIG_OK : FIG_NO_MEMORY;
}
