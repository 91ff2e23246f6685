//: Include what reading scene files needs
#define _GNU_SOURCE // strcasecmp
#include "scenes/scene_file.h"

#include "scenes/natural_order.h"
#include "scenes/scene_reader.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

//: Know a scene by its name
bool tf_is_scene(const char *path)
{
    static const char *const endings[] = {".yaml", ".yml", ".json"};
    const char *dot = strrchr(path, '.');
    bool found = false;
    for (int i = 0; i < 3 && dot; i++)
        found = found || strcasecmp(dot, endings[i]) == 0;
    return found;
}

//: Read what a mesh of a scene is
/// Files are called by it.
static bool read_name(tf_scene_reader *r, const tf_scene_key *key,
                      const yaml_node_t *node, void *target)
{
    tf_scene_mesh *mesh = target;
    return tf_scene_take_text(r, key, node, mesh) &&
           (!strchr(mesh->name, '/') ||
            tf_scene_fault_at(r, node,
                              "the name '%s' has a slash, but files are named "
                              "after it; remove the slash",
                              tf_make_visible(mesh->name).text));
}

static bool read_role(tf_scene_reader *r, const tf_scene_key *key,
                      const yaml_node_t *node, void *target)
{
    const char *text = tf_scene_text(r, node, key->name);
    const tf_role *role = text ? tf_choice_named(tf_roles, text) : NULL;
    if (role)
        ((tf_scene_mesh *)target)->role = *role;
    return role ||
           (text && tf_scene_fault_at(r, node, "role must be %s, got '%s'",
                                      tf_list_choices(tf_roles).text,
                                      tf_make_visible(text).text));
}

//: Find files that a scene names
static bool find_files(tf_scene_reader *r, const yaml_node_t *node,
                       const char *what, tf_frame_names *names)
{
    const char *text = tf_scene_text(r, node, what);
    tf_names_found found =
        text ? tf_frame_names_find(names, r->path, text) : TF_NAMES_ADDED;
    if (found == TF_NAMES_NO_MEMORY)
        return tf_scene_fault_in_memory(r);
    return text &&
           (found == TF_NAMES_ADDED ||
            tf_scene_fault_at(r, node,
                              "there is no file '%s'; names are relative to "
                              "the scene file",
                              tf_make_visible(text).text));
}

//: Read the frames of a mesh of a scene
/// Such as frame-7.obj and frame-07.obj, which a pattern takes for two.
static bool are_different(tf_scene_reader *r, const yaml_node_t *node,
                          char *const name[], int count)
{
    for (int i = 1; i < count; i++)
        if (tf_are_of_one_frame(name[i - 1], name[i]))
            return tf_scene_fault_at(
                r, node,
                "%s and %s have the same number; delete one, or list the "
                "frames",
                tf_make_visible(name[i - 1]).text,
                tf_make_visible(name[i]).text);
    return true;
}

static bool read_frames(tf_scene_reader *r, const tf_scene_key *key,
                        const yaml_node_t *node, void *target)
{
    (void)key;
    tf_frame_names *names = &((tf_scene_mesh *)target)->frames;
    if (node->type == YAML_SCALAR_NODE)
        return find_files(r, node, "a file of frames", names) &&
               are_different(r, node, names->path, names->count);
    if (!tf_scene_is_list(node))
        return tf_scene_fault_at(
            r, node, "frames must be a file, a pattern or a list of some");
    bool good = true;
    for (yaml_node_item_t *item = node->data.sequence.items.start;
         item < node->data.sequence.items.top && good; item++)
        good =
            find_files(r, tf_scene_node(r, *item), "a file of frames", names);
    return good;
}

//: Read the pinned vertices of a mesh
static bool add_pin(tf_scene_reader *r, const yaml_node_t *node,
                    tf_scene_mesh *mesh)
{
    static const tf_scene_key pin = {"a pinned vertex", NULL, .most = INFINITY};
    int vertex;
    if (!tf_scene_take_whole(r, &pin, node, &vertex))
        return false;
    mesh->pinned[mesh->pins++] = vertex;
    return true;
}

static bool read_pinned(tf_scene_reader *r, const tf_scene_key *key,
                        const yaml_node_t *node, void *target)
{
    tf_scene_mesh *mesh = target;
    mesh->pinned_line = tf_scene_line(node);
    if (node->type == YAML_SCALAR_NODE)
        return find_files(r, node, "a file of pinned vertices",
                          &mesh->pinned_in);
    if (!tf_scene_is_list(node))
        return tf_scene_fault_at(
            r, node, "%s must be a list of vertices or a file", key->name);
    yaml_node_item_t *item = node->data.sequence.items.start;
    yaml_node_item_t *end = node->data.sequence.items.top;
    mesh->pinned = malloc((size_t)(end - item) * sizeof *mesh->pinned);
    if (!mesh->pinned)
        return tf_scene_fault_in_memory(r);
    bool good = true;
    for (; item < end && good; item++)
        good = add_pin(r, tf_scene_node(r, *item), mesh);
    return good;
}

//: Read a material
/// The least number above 0 of a normal number, so that its inverse is finite.
#define ABOVE_0 0x1p-1022, INFINITY
#define FROM_0 0, INFINITY

#define MATERIAL(member) offsetof(tf_scene_material, member)

static bool read_material(tf_scene_reader *r, const tf_scene_key *key,
                          const yaml_node_t *node, void *target)
{
    static const tf_scene_key keys[] = {
        {"density", tf_scene_take_number, MATERIAL(density), ABOVE_0},
        {"stretch", tf_scene_take_number, MATERIAL(stretch), ABOVE_0},
        {"bend", tf_scene_take_number, MATERIAL(bend), FROM_0},
        {0}};
    return tf_scene_read_mapping(
        r, node, keys, "a material may have density, stretch and bend",
        tf_scene_member(key, target));
}

//: Read a mesh of a scene
/// Vertices of a mesh that doesn't give way need no pins.
static bool check_pins(tf_scene_reader *r, const yaml_node_t *node,
                       const tf_scene_mesh *mesh)
{
    return mesh->role == TF_MOVING ||
           (mesh->pins == 0 && mesh->pinned_in.count == 0) ||
           tf_scene_fault_at(r, node,
                             "all vertices of a %s mesh are pinned anyway; "
                             "delete 'pinned:'",
                             mesh->role == TF_FIXED ? "fixed" : "scripted");
}

#define MESH(member) offsetof(tf_scene_mesh, member)

static bool read_mesh(tf_scene_reader *r, const yaml_node_t *node)
{
    static const tf_scene_key keys[] = {
        {"name", read_name, .member = MESH(name)},
        {"frames", .read = read_frames},
        {"role", .read = read_role},
        {"mass", tf_scene_take_number, MESH(mass), ABOVE_0},
        {"group", tf_scene_take_text, .member = MESH(group)},
        {"friction", tf_scene_take_number, MESH(friction), FROM_0},
        {"material", read_material, .member = MESH(material)},
        {"pinned", .read = read_pinned},
        {0}};
    tf_scene_mesh *mesh = tf_scene_meshes_add(r->meshes);
    if (!mesh)
        return tf_scene_fault_in_memory(r);
    mesh->line = tf_scene_line(node);
    if (!tf_scene_read_mapping(r, node, keys,
                               "a mesh has frames, and may have name, role, "
                               "mass, friction, group, material and pinned",
                               mesh))
        return false;
    if (mesh->frames.count == 0)
        return tf_scene_fault_at(r, node,
                                 "a mesh without frames; write 'frames:' and a "
                                 "file, a pattern or a list of some");
    tf_order_frames(mesh->frames.path, mesh->frames.count);
    return check_pins(r, node, mesh);
}

static bool read_meshes(tf_scene_reader *r, const tf_scene_key *key,
                        const yaml_node_t *node, void *target)
{
    (void)key, (void)target;
    if (!tf_scene_is_list(node))
        return tf_scene_fault_at(
            r, node, "meshes must be a list; write '- frames: FILE' for each");
    bool good = true;
    for (yaml_node_item_t *item = node->data.sequence.items.start;
         item < node->data.sequence.items.top && good; item++)
        good = read_mesh(r, tf_scene_node(r, *item));
    return good;
}

//: Read how a scene is simulated
static bool read_shape(tf_scene_reader *r, const tf_scene_key *key,
                       const yaml_node_t *node, void *target)
{
    r->meshes->physics.shape_line = tf_scene_line(node);
    return tf_scene_take_text(r, key, node, target);
}

static bool read_resolution(tf_scene_reader *r, const tf_scene_key *key,
                            const yaml_node_t *node, void *target)
{
    r->meshes->physics.resolution_line = tf_scene_line(node);
    return key->most < INFINITY ? tf_scene_take_whole(r, key, node, target)
                                : tf_scene_take_number(r, key, node, target);
}

static bool read_up(tf_scene_reader *r, const tf_scene_key *key,
                    const yaml_node_t *node, void *target)
{
    const char *text = tf_scene_text(r, node, key->name);
    if (!text)
        return false;
    if (strlen(text) != 1 || text[0] < 'x' || text[0] > 'z')
        return tf_scene_fault_at(r, node, "up must be x, y or z, got '%s'",
                                 tf_make_visible(text).text);
    ((tf_scene_physics *)target)->up = text[0] - 'x';
    return true;
}

#define AIR(member) offsetof(tf_scene_air, member)

static bool read_air(tf_scene_reader *r, const tf_scene_key *key,
                     const yaml_node_t *node, void *target)
{
    static const tf_scene_key keys[] = {
        {"drag", tf_scene_take_number, AIR(drag), FROM_0},
        {"wind", tf_scene_take_vector, .member = AIR(wind)},
        {"veer", tf_scene_take_number, .member = AIR(veer)},
        {"gust", tf_scene_take_number, AIR(gust), FROM_0},
        {0}};
    (void)key;
    tf_scene_air *air = &((tf_scene_physics *)target)->air;
    air->given = true;
    return tf_scene_read_mapping(r, node, keys,
                                 "air may have drag, wind, veer and gust", air);
}

//: Read the keys of a scene
/// What a scene has, for messages.
static const char wanted[] =
    "a scene has 'meshes:', a list, and to be simulated may have rate, steps, "
    "step, gravity, up, friction, air, material and shows";

#define PHYSICS(member) offsetof(tf_scene_physics, member)

static bool read_keys(tf_scene_reader *r, const yaml_node_t *root)
{
    enum {
        MOST_STEPS = 99999,
        MOST_SIZE = 2000
    };
    static const tf_scene_key keys[] = {
        {"meshes", .read = read_meshes},
        {"shows", tf_scene_take_text, .member = PHYSICS(shows)},
        {"shape", read_shape, .member = PHYSICS(shape)},
        {"size", read_resolution, PHYSICS(size), 1, MOST_SIZE},
        {"edge", read_resolution, PHYSICS(edge), ABOVE_0},
        {"steps", tf_scene_take_whole, PHYSICS(steps), 0, MOST_STEPS},
        {"step", tf_scene_take_number, PHYSICS(step), ABOVE_0},
        {"rate", tf_scene_take_number, PHYSICS(rate), ABOVE_0},
        {"gravity", tf_scene_take_number, PHYSICS(gravity), FROM_0},
        {"up", .read = read_up},
        {"friction", tf_scene_take_number, PHYSICS(friction), FROM_0},
        {"air", .read = read_air},
        {"material", read_material, .member = PHYSICS(material)},
        {0}};
    r->meshes->physics = (tf_scene_physics){.size = -1,
                                            .edge = -1,
                                            .steps = -1,
                                            .step = -1,
                                            .rate = -1,
                                            .gravity = -1,
                                            .up = -1,
                                            .friction = -1,
                                            .material = {-1, -1, -1}};
    return tf_scene_read_mapping(r, root, keys, wanted, &r->meshes->physics);
}

/// What the scene says of all meshes, where they say nothing themselves.
static void share(tf_scene_meshes *meshes)
{
    for (int i = 0; i < meshes->count; i++) {
        tf_scene_mesh *mesh = &meshes->mesh[i];
        const tf_scene_physics *all = &meshes->physics;
        tf_scene_material *own = &mesh->material;
        if (mesh->friction < 0)
            mesh->friction = all->friction;
        if (own->density < 0 && mesh->mass == 0)
            own->density = all->material.density;
        if (own->stretch < 0)
            own->stretch = all->material.stretch;
        if (own->bend < 0)
            own->bend = all->material.bend;
    }
}

//: Read the document of a scene
static bool check_document(tf_scene_reader *r)
{
    share(r->meshes);
    return tf_scene_meshes_name(r->meshes)
               ? tf_scene_meshes_check(r->meshes, r->path, r->fault)
               : tf_scene_fault_in_memory(r);
}

static bool read_document(tf_scene_reader *r)
{
    const yaml_node_t *root = yaml_document_get_root_node(&r->document);
    if (!root)
        return tf_fault_set(r->fault, r->path, -1, "is empty; %s", wanted);
    if (!read_keys(r, root))
        return false;
    const tf_scene_physics *physics = &r->meshes->physics;
    if (r->meshes->count == 0 && !physics->shape)
        return tf_scene_fault_at(r, root, "no meshes; %s", wanted);
    if (r->meshes->count > 0 && physics->shape)
        return tf_fault_set(r->fault, r->path, physics->shape_line,
                            "the scene has meshes and a shape; delete one of "
                            "them");
    if (physics->resolution_line > 0 && !physics->shape)
        return tf_fault_set(r->fault, r->path, physics->resolution_line,
                            "size and edge are for a shape; meshes are as fine "
                            "as their files, so delete this");
    return check_document(r);
}

//: Load YAML
static bool fault_in_yaml(tf_scene_reader *r, const yaml_parser_t *parser,
                          FILE *stream)
{
    bool bytes = parser->error == YAML_READER_ERROR;
    if (ferror(stream))
        return tf_fault_set_unread(r->fault, r->path, -1, errno);
    if (parser->error == YAML_MEMORY_ERROR)
        return tf_scene_fault_in_memory(r);
    tf_fault_set(r->fault, r->path,
                 bytes ? (long)parser->problem_offset
                       : (long)parser->problem_mark.line + 1,
                 bytes
                     ? "is not YAML: %s; write it in UTF-8"
                     : "is not YAML: %s; mend it there, or in the line before",
                 parser->problem);
    r->fault->counts_bytes = bytes;
    return false;
}

/// Loads one document, and makes sure that there is no other.
static bool load(tf_scene_reader *r, yaml_parser_t *parser, FILE *stream)
{
    yaml_document_t other;
    if (!yaml_parser_load(parser, &r->document))
        return fault_in_yaml(r, parser, stream);
    if (!yaml_document_get_root_node(&r->document))
        return true;
    if (!yaml_parser_load(parser, &other))
        return fault_in_yaml(r, parser, stream);
    yaml_node_t *root = yaml_document_get_root_node(&other);
    bool good =
        !root ||
        tf_scene_fault_at(r, root, "a second document; a scene file has one");
    yaml_document_delete(&other);
    return good;
}

static bool read_scene_stream(tf_scene_reader *r, FILE *stream)
{
    yaml_parser_t parser;
    if (!yaml_parser_initialize(&parser))
        return tf_scene_fault_in_memory(r);
    yaml_parser_set_input_file(&parser, stream);
    errno = 0;
    bool good = load(r, &parser, stream) && read_document(r);
    yaml_document_delete(&r->document);
    yaml_parser_delete(&parser);
    return good;
}

//: Read a scene file
bool tf_scene_file_read(tf_scene_meshes *meshes, const char *path,
                        tf_fault *fault)
{
    return tf_simulated_file_read(meshes, path, fault) &&
           (!meshes->physics.shape ||
            tf_fault_set(fault, path, meshes->physics.shape_line,
                         "a shape is for 'tanglefree simulate'; give other "
                         "commands the frames that this writes"));
}

bool tf_simulated_file_read(tf_scene_meshes *meshes, const char *path,
                            tf_fault *fault)
{
    tf_scene_reader r = {.path = path, .meshes = meshes, .fault = fault};
    FILE *stream = fopen(path, "rb");
    *meshes = (tf_scene_meshes){0};
    if (!stream)
        return tf_fault_set_unopened(fault, path, errno);
    bool good = read_scene_stream(&r, stream);
    fclose(stream);
    return good;
}
