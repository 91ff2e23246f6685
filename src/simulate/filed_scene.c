//: Include what scenes from files need
#define _GNU_SOURCE // basename
#include "simulate/filed_scene.h"

#include "scenes/flaws.h"
#include "scenes/scene_file.h"
#include "simulate/cloth.h"
#include "simulate/cloth_scenes.h"
#include "simulate/cloth_simulation.h"
#include "simulate/flow_scenes.h"
#include "simulate/frame_notes.h"
#include "simulate/strand.h"
#include "surface/check.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

enum {
    USUAL_STEPS = 100, // of a scene in which nothing has frames
    MOST_STEPS = 99999
};

/// What is usual where a scene file says nothing.
static const tf_scene usual = {
    &tf_cloth_kind,       .step = 0.01,    .gravity = 9.81,
    .air = {.drag = 0.3}, .friction = 0.3, .material = {0.15, 300, 1.5e-4}};

//: Add up a checksum
/// None at all would begin a new sum.
static void sum_bytes(tf_scene *scene, const void *item, size_t size)
{
    if (size > 0)
        scene->checksum = (unsigned)crc32_z(scene->checksum, item, size);
}

static void sum_text(tf_scene *scene, const char *text)
{
    sum_bytes(scene, text ? text : "", text ? strlen(text) + 1 : 1);
}

/// All that decides how a scene goes on from its start.
static void sum_scene(tf_scene *scene, double rate)
{
    const tf_air *air = &scene->air;
    const tf_material *material = &scene->material;
    const double number[] = {
        scene->step,  scene->gravity,    scene->friction,   air->drag,
        air->wind[0], air->wind[1],      air->wind[2],      air->veer,
        air->gust,    material->density, material->stretch, material->bend,
        rate,
    };
    sum_bytes(scene, number, sizeof number);
}

//: Take what a scene file says of a simulation
static double given(double number, double otherwise)
{
    return number >= 0 ? number : otherwise;
}

static tf_air air_of(const tf_scene_air *air)
{
    return (tf_air){.drag = air->drag,
                    .wind = {air->wind[0], air->wind[1], air->wind[2]},
                    .veer = air->veer,
                    .gust = air->gust};
}

static tf_material material_of(const tf_scene_material *material,
                               const tf_material *otherwise)
{
    return (tf_material){given(material->density, otherwise->density),
                         given(material->stretch, otherwise->stretch),
                         given(material->bend, otherwise->bend)};
}

/// In place of what the scene has.
static void take_physics(tf_scene *scene, const tf_scene_physics *physics)
{
    scene->step = given(physics->step, scene->step);
    scene->gravity = given(physics->gravity, scene->gravity);
    scene->friction = given(physics->friction, scene->friction);
    scene->material = material_of(&physics->material, &scene->material);
    if (physics->steps >= 0)
        scene->steps = physics->steps;
    if (physics->air.given)
        scene->air = air_of(&physics->air);
}

//: Check what a scene file says of a shape
__attribute__((format(printf, 3, 4))) static bool
fault_at_line(tf_filed_scene *filed, long line, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    tf_fault_set_list(&filed->fault, filed->path, line, format, arguments);
    va_end(arguments);
    return false;
}

static bool check_shape(tf_filed_scene *filed)
{
    const tf_scene_physics *p = &filed->meshes.physics;
    bool flows = filed->scene.field;
    if (p->rate >= 0 || p->up >= 0)
        return fault_at_line(filed, p->shape_line,
                             "rate and up are for meshes; with a shape, leave "
                             "them out");
    if (flows && (p->gravity >= 0 || p->friction >= 0 || p->air.given ||
                  p->material.density >= 0 || p->material.stretch >= 0 ||
                  p->material.bend >= 0))
        return fault_at_line(filed, p->shape_line,
                             "the shape '%s' flows, without gravity, friction, "
                             "air and material; leave them out",
                             p->shape);
    return true;
}

static bool take_resolution(tf_filed_scene *filed)
{
    const tf_scene_physics *p = &filed->meshes.physics;
    const tf_resolution *range = &filed->scene.resolution;
    const char *option = filed->scene.kind->option;
    double of_option = strcmp(option, "size") == 0 ? p->size : p->edge;
    filed->resolution = given(of_option, range->usual);
    bool given_other = p->resolution_line > 0 && of_option < 0;
    if (given_other || filed->resolution < range->least ||
        filed->resolution > range->most)
        return fault_at_line(filed, p->resolution_line,
                             "the shape '%s' takes '%s:' from %g to %g",
                             p->shape, option, range->least, range->most);
    return true;
}

//: Make a scene of a shape
static bool make_shape(tf_filed_scene *filed)
{
    const tf_scene_physics *physics = &filed->meshes.physics;
    const tf_scene *shape = tf_scene_named(tf_cloth_scenes, physics->shape);
    if (!shape)
        shape = tf_scene_named(tf_flow_scenes, physics->shape);
    if (!shape)
        return fault_at_line(filed, physics->shape_line,
                             "there is no shape '%s'; 'tanglefree simulate "
                             "list' lists all shapes",
                             tf_make_visible(physics->shape).text);
    filed->scene = *shape;
    if (!check_shape(filed) || !take_resolution(filed))
        return false;
    take_physics(&filed->scene, physics);
    sum_text(&filed->scene, physics->shape);
    sum_scene(&filed->scene, 0);
    return true;
}

//: Check what meshes are made of
/// The name is that of other files that are written.
static bool check_names(tf_filed_scene *filed)
{
    for (int m = 0; m < filed->meshes.count; m++)
        if (strcmp(filed->meshes.mesh[m].name, "frame") == 0)
            return fault_at_line(filed, filed->meshes.mesh[m].line,
                                 "no mesh may be named 'frame', as the frames "
                                 "of all meshes together are; name it "
                                 "differently, by 'name:'");
    return true;
}

static bool check_roles(tf_filed_scene *filed)
{
    for (int m = 0; m < filed->meshes.count; m++)
        if (filed->meshes.mesh[m].role == TF_MOVING)
            return true;
    return fault_at_line(filed, -1,
                         "no mesh is moving, so there is nothing to simulate; "
                         "let one be, by its role");
}

static bool check_rate(tf_filed_scene *filed)
{
    const tf_scene_meshes *meshes = &filed->meshes;
    for (int m = 0; m < meshes->count && meshes->physics.rate < 0; m++) {
        const tf_scene_mesh *mesh = &meshes->mesh[m];
        if (mesh->role != TF_FIXED && mesh->frames.count > 1)
            return fault_at_line(
                filed, mesh->line,
                "'%s' has %d frames, but there is no rate; for "
                "25 frames a second, write 'rate: 25' beside "
                "'meshes:'",
                tf_make_visible(mesh->name).text, mesh->frames.count);
    }
    return true;
}

static bool check_masses_of_meshes(tf_filed_scene *filed)
{
    for (int m = 0; m < filed->meshes.count; m++) {
        const tf_scene_mesh *mesh = &filed->meshes.mesh[m];
        if (mesh->mass > 0 && mesh->material.density >= 0)
            return fault_at_line(filed, mesh->line,
                                 "'%s' has a mass and a density; delete one of "
                                 "them",
                                 tf_make_visible(mesh->name).text);
    }
    return true;
}

//: Add a mesh to the body
static void add_mesh_to_body(tf_filed_scene *filed, int m,
                             const double position[])
{
    tf_body *body = &filed->body;
    const tf_mesh_file *file = tf_scene_frames_file(&filed->frames, m, 1);
    int first = body->vertices;
    for (int v = 0; v < tf_mesh_file_vertices(file); v++)
        tf_body_add_vertex(body,
                           position + (ptrdiff_t)body->axes * (first + v));
    for (size_t i = 0; i < file->triangle.count; i += 3) {
        const int *corner = file->triangle.item + i;
        tf_body_add_triangle(body, first + corner[0], first + corner[1],
                             first + corner[2]);
    }
    for (size_t i = 0; i < file->edge.count; i += 2)
        tf_body_add_edge(body, first + file->edge.item[i],
                         first + file->edge.item[i + 1]);
}

//: Measure the triangles of a mesh
/// Twice the area of one.
static double twice_area_of(const tf_body *body, int triangle)
{
    const int *corner = body->triangle + (ptrdiff_t)3 * triangle;
    tf_vector a = tf_vector_at(body->position, corner[0]);
    tf_vector b = tf_vector_at(body->position, corner[1]);
    tf_vector c = tf_vector_at(body->position, corner[2]);
    return tf_vector_length(tf_vector_cross(tf_vector_difference(b, a),
                                            tf_vector_difference(c, a)));
}

/// Adds the area from the first triangle on; that of one without is an error.
static bool add_area(tf_filed_scene *filed, const tf_mesh_file *file, int first,
                     double *measure)
{
    for (int t = first; t < filed->body.triangles; t++) {
        double twice = twice_area_of(&filed->body, t);
        if (!isfinite(1 / twice))
            return tf_error_fault(file,
                                  &(tf_error){.status = TF_COLLINEAR,
                                              .subject = TF_TRIANGLE,
                                              .index = (size_t)(t - first),
                                              .vertex = {-1, -1, -1, -1, -1},
                                              .time = -1});
        *measure += twice / 2;
    }
    return true;
}

//: Measure the edges of a mesh
/// Adds the length from the first edge on; that of one without is an error.
static bool add_length(tf_filed_scene *filed, const tf_mesh_file *file,
                       int first, double *measure)
{
    for (int e = first; e < filed->body.edges; e++) {
        double length = tf_strand_length(&filed->body, e);
        if (!isfinite(1 / length))
            return tf_mesh_file_fault(file, file->edge_place.item[e - first],
                                      "this edge has no length; remove it, or "
                                      "move an end of it");
        *measure += length;
    }
    return true;
}

//: Make a mesh of its material
static bool pin(tf_filed_scene *filed, int m)
{
    const int *first = filed->frames.joined.first_vertex + m;
    return tf_scene_mesh_pin(&filed->meshes.mesh[m], filed->path,
                             first[1] - first[0], filed->body.mass + first[0],
                             &filed->fault);
}

/// @param triangle,edge the first of the mesh
static bool stiffen(tf_filed_scene *filed, int m, int triangle, int edge)
{
    const tf_scene_mesh *mesh = &filed->meshes.mesh[m];
    const tf_mesh_file *file = tf_scene_frames_file(&filed->frames, m, 1);
    double measure = 0;
    if (!add_area(filed, file, triangle, &measure) ||
        !add_length(filed, file, edge, &measure))
        return false;
    tf_material material = material_of(&mesh->material, &usual.material);
    if (mesh->mass > 0)
        material.density = mesh->mass / measure;
    tf_cloth_stiffen(&filed->body, triangle, &material);
    tf_strand_stiffen(&filed->body, edge, &material);
    sum_bytes(&filed->scene, &material, sizeof material);
    return filed->body.failed || pin(filed, m);
}

//: Report that a scene needs more memory
static bool fault_in_body(tf_filed_scene *filed)
{
    return fault_at_line(filed, -1,
                         "not enough memory for these meshes; make them "
                         "coarser, or use a machine with more");
}

//: Take the friction of meshes
/// The one coefficient of all meshes, or -1 if they have several.
static double one_friction_of(const tf_filed_scene *filed)
{
    const tf_scene_mesh *mesh = filed->meshes.mesh;
    double usually = filed->scene.friction;
    for (int m = 1; m < filed->meshes.count; m++)
        if (given(mesh[m].friction, usually) != given(mesh->friction, usually))
            return -1;
    return given(mesh->friction, usually);
}

/// Each vertex has that of its mesh, unless all are the same.
static bool take_friction(tf_filed_scene *filed)
{
    double one = one_friction_of(filed), usually = filed->scene.friction;
    if (one >= 0) {
        filed->scene.friction = one;
        return true;
    }
    size_t size = (size_t)filed->body.vertices * sizeof *filed->friction;
    filed->friction = malloc(size);
    if (!filed->friction)
        return fault_in_body(filed);
    const int *first = filed->frames.joined.first_vertex;
    for (int m = 0; m < filed->meshes.count; m++)
        for (int v = first[m]; v < first[m + 1]; v++)
            filed->friction[v] = given(filed->meshes.mesh[m].friction, usually);
    sum_bytes(&filed->scene, filed->friction, size);
    return true;
}

//: Make the body of a scene
static bool make_body(tf_filed_scene *filed)
{
    tf_motion motion = tf_scene_frames_motion(&filed->frames);
    tf_body *body = &filed->body;
    int up = filed->meshes.physics.up;
    body->axes = motion.axes;
    body->up = up >= 0 && body->axes == 3 ? (up + 1) % 3 : 0;
    bool good = true;
    for (int m = 0; m < filed->meshes.count && good && !body->failed; m++) {
        int triangle = body->triangles, edge = body->edges;
        add_mesh_to_body(filed, m, motion.end);
        if (filed->meshes.mesh[m].role == TF_MOVING && !body->failed)
            good = stiffen(filed, m, triangle, edge);
    }
    return good && (body->failed ? fault_in_body(filed) : take_friction(filed));
}

//: Sum the body of a scene
static void sum_body(tf_filed_scene *filed)
{
    const tf_body *body = &filed->body;
    tf_scene *scene = &filed->scene;
    size_t vertices = (size_t)body->vertices;
    sum_bytes(scene, &body->up, sizeof body->up);
    sum_bytes(scene, body->mass, vertices * sizeof *body->mass);
    sum_bytes(scene, body->triangle,
              3 * (size_t)body->triangles * sizeof *body->triangle);
    sum_bytes(scene, body->edge, 2 * (size_t)body->edges * sizeof *body->edge);
    for (int m = 0; m < filed->meshes.count; m++) {
        sum_bytes(scene, &filed->frames.joined.first_vertex[m], sizeof(int));
        sum_text(scene, filed->meshes.mesh[m].group);
    }
}

//: Check that the start is clear
static bool are_scripted(const tf_body *body, const int vertex[5])
{
    bool scripted = true;
    for (int i = 0; i < 5; i++)
        scripted = scripted && (vertex[i] < 0 || body->mass[vertex[i]] == 0);
    return scripted;
}

static bool fault_in_crossing(const tf_filed_scene *filed,
                              const tf_crossing *crossing)
{
    static const tf_subject subjects[] = {
        [TF_EDGE_THROUGH_TRIANGLE] = TF_EDGE_TRIANGLE_PAIR,
        [TF_POINT_ON_TRIANGLE] = TF_POINT_TRIANGLE_PAIR,
        [TF_EDGE_ON_EDGE] = TF_EDGE_EDGE_PAIR};
    tf_error error = {.status = TF_START_NOT_CLEAR,
                      .subject = subjects[crossing->kind]};
    memcpy(error.vertex, crossing->vertex, sizeof error.vertex);
    return tf_scene_frames_fault(&filed->frames, &error);
}

/// Elements that are scripted may meet.
static bool check_start(tf_filed_scene *filed)
{
    tf_motion motion = tf_scene_frames_motion(&filed->frames);
    tf_crossings found;
    tf_error error;
    if (tf_surface_check(filed->frames.surface, motion.vertices, motion.end,
                         NULL, &found, &error) != TF_OK)
        return tf_scene_frames_fault(&filed->frames, &error);
    for (size_t i = 0; i < found.count; i++)
        if (!are_scripted(&filed->body, found.crossing[i].vertex))
            return fault_in_crossing(filed, &found.crossing[i]);
    return true;
}

//: Read all frames of a scene
static void sum_frame(tf_filed_scene *filed)
{
    tf_motion motion = tf_scene_frames_motion(&filed->frames);
    sum_bytes(&filed->scene, motion.end,
              (size_t)(motion.axes * motion.vertices) * sizeof *motion.end);
}

static bool read_later(tf_filed_scene *filed)
{
    tf_scene_frames *frames = &filed->frames;
    for (int i = 1; i < filed->meshes.frames; i++) {
        if (!tf_scene_frames_next(frames))
            return false;
        if (frames->axes != filed->body.axes)
            return fault_at_line(filed, -1,
                                 "the curves leave the plane in frame %d; keep "
                                 "z = 0, or give them another z from the start",
                                 i);
        sum_frame(filed);
    }
    return true;
}

/// Goes back to the first frame.
static bool read_again(tf_filed_scene *filed)
{
    if (filed->frames.count == 1)
        return true;
    tf_scene_frames_free(&filed->frames);
    return tf_scene_frames_next(&filed->frames);
}

static bool read_frames_of_scene(tf_filed_scene *filed)
{
    if (!tf_scene_frames_next(&filed->frames) || !make_body(filed) ||
        !check_start(filed))
        return false;
    sum_body(filed);
    sum_frame(filed);
    return read_later(filed) && read_again(filed);
}

//: Place what frames move
/// Reads on until the frames are those before and after a time.
static bool go_to(tf_scene_frames *frames, double at)
{
    bool good = true;
    while (good && frames->count < frames->meshes->frames &&
           frames->count - 1 < at)
        good = tf_scene_frames_next(frames);
    return good;
}

/// Straight from the frame before to the one after.
static bool place_by_frames(void *context, double time, double position[])
{
    tf_filed_scene *filed = context;
    double at = time * filed->meshes.physics.rate;
    if (!go_to(&filed->frames, at))
        return false;
    tf_motion motion = tf_scene_frames_motion(&filed->frames);
    if (motion.axes != filed->axes || motion.vertices != filed->vertices)
        return tf_fault_set(&filed->frames.fault, filed->path, -1,
                            "the files of frames have changed since they were "
                            "read first; try again when nothing writes them");
    double part = fmin(at - (filed->frames.count - 2), 1);
    for (int i = 0; i < motion.axes * motion.vertices; i++)
        if (filed->mass[i / motion.axes] == 0)
            position[i] =
                part < 1
                    ? motion.start[i] + part * (motion.end[i] - motion.start[i])
                    : motion.end[i];
    return true;
}

//: Build what meshes are simulated as
static void build_meshes(tf_scene_setup *setup, double resolution)
{
    (void)resolution;
    tf_filed_scene *filed = setup->scene->own;
    setup->body = filed->body;
    filed->axes = filed->body.axes;
    filed->vertices = filed->body.vertices;
    filed->mass = filed->body.mass;
    setup->filter = tf_scene_frames_filter(&filed->frames);
    setup->friction = filed->friction;
    filed->body = (tf_body){0};
    if (filed->meshes.frames > 1)
        setup->path = (tf_path){place_by_frames, filed};
}

//: Make a scene of meshes
static int steps_of(const tf_filed_scene *filed)
{
    int frames = filed->meshes.frames;
    double seconds = (frames - 1) / filed->meshes.physics.rate;
    // What is left of a step by rounding alone is none.
    double steps = ceil(seconds / filed->scene.step * (1 - 1e-12));
    return frames > 1 ? (int)fmin(steps, MOST_STEPS) : USUAL_STEPS;
}

static bool make_notes(tf_filed_scene *filed)
{
    filed->notes = tf_frame_notes_write(&filed->meshes, &filed->frames.joined);
    filed->scene.notes = filed->notes;
    return filed->notes || fault_in_body(filed);
}

static bool make_meshes(tf_filed_scene *filed)
{
    filed->frames.meshes = &filed->meshes;
    filed->frames.keeps_sources = true;
    filed->scene = usual;
    take_physics(&filed->scene, &filed->meshes.physics);
    if (!check_names(filed) || !check_roles(filed) ||
        !check_masses_of_meshes(filed) || !check_rate(filed) ||
        !read_frames_of_scene(filed) || !make_notes(filed))
        return false;
    if (filed->meshes.physics.steps < 0)
        filed->scene.steps = steps_of(filed);
    filed->scene.plane = filed->body.axes == 2;
    filed->scene.build = build_meshes;
    filed->scene.own = filed;
    sum_scene(&filed->scene, filed->meshes.physics.rate);
    return true;
}

//: Name a scene by its file
/// A comma would end the name in the comment of a frame.
static void name_by_file(tf_filed_scene *filed)
{
    const char *file = basename(filed->path);
    tf_quoted quoted = tf_quote(file, strlen(file));
    snprintf(filed->name, sizeof filed->name, "%s", quoted.text);
    for (char *c = filed->name; *c; c++)
        if (*c == ',')
            *c = '?';
    filed->scene.name = filed->name;
}

//: Read a scene to be simulated
bool tf_filed_scene_read(tf_filed_scene *filed, const char *path)
{
    *filed = (tf_filed_scene){.path = path};
    if (!tf_simulated_file_read(&filed->meshes, path, &filed->fault))
        return false;
    bool good =
        filed->meshes.physics.shape ? make_shape(filed) : make_meshes(filed);
    if (!good && filed->frames.fault.text[0])
        filed->fault = filed->frames.fault;
    name_by_file(filed);
    filed->scene.filed = true;
    return good;
}

void tf_filed_scene_free(tf_filed_scene *filed)
{
    if (filed->frames.meshes)
        tf_scene_frames_free(&filed->frames);
    tf_body_free(&filed->body);
    free(filed->friction);
    free(filed->notes);
    tf_scene_meshes_free(&filed->meshes);
}
