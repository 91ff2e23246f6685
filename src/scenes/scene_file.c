//: Include what reading scene files needs
#define _GNU_SOURCE // strdup, strcasecmp
#include "scenes/scene_file.h"

#include "files/number.h"
#include "scenes/natural_order.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <yaml.h>

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

//: Hold a scene file that is being read
typedef struct scene_reader {
    const char *path;
    yaml_document_t document;
    tf_scene_meshes *meshes;
    tf_fault *fault;
} scene_reader;

static yaml_node_t *node_at(scene_reader *r, int index)
{
    return yaml_document_get_node(&r->document, index);
}

/// Sets a fault at the line of a node, as printf; false.
__attribute__((format(printf, 3, 4))) static bool
fault_at(scene_reader *r, const yaml_node_t *node, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    tf_fault_set_list(r->fault, r->path, (long)node->start_mark.line + 1,
                      format, arguments);
    va_end(arguments);
    return false;
}

static bool fault_in_scene_memory(scene_reader *r)
{
    return tf_fault_set(r->fault, r->path, -1,
                        "not enough memory; name fewer files, or use a machine "
                        "with more");
}

//: Read a text of YAML
/// The text of a node, lent; NULL: there is a fault.
static const char *text_of(scene_reader *r, const yaml_node_t *node,
                           const char *what)
{
    if (node->type != YAML_SCALAR_NODE) {
        fault_at(r, node, "%s must be a text, not a list or a mapping", what);
        return NULL;
    }
    const char *text = (const char *)node->data.scalar.value;
    if (!*text || strlen(text) != node->data.scalar.length) {
        fault_at(r, node, "%s must be a text that is not empty", what);
        return NULL;
    }
    return text;
}

/// Takes a copy of it.
static bool copy_text(scene_reader *r, const yaml_node_t *node,
                      const char *what, char **copy)
{
    const char *text = text_of(r, node, what);
    if (!text)
        return false;
    *copy = strdup(text);
    return *copy || fault_in_scene_memory(r);
}

//: Read a number of YAML
static bool read_scene_number(scene_reader *r, const yaml_node_t *node,
                              const char *what, double least, double *number)
{
    const char *text = text_of(r, node, what);
    if (!text)
        return false;
    const char *rest = text;
    bool good = tf_number_read(&rest, number) && *rest == '\0' &&
                *number >= least && isfinite(*number);
    return good || fault_at(r, node, "%s must be a number %s, got '%s'", what,
                            least > 0 ? "above 0" : "from 0 on",
                            tf_make_visible(text).text);
}

//: Read what a mesh of a scene is
typedef bool key_reader(scene_reader *r, const yaml_node_t *node,
                        tf_scene_mesh *mesh);

/// Files are called by it.
static bool read_name(scene_reader *r, const yaml_node_t *node,
                      tf_scene_mesh *mesh)
{
    return copy_text(r, node, "name", &mesh->name) &&
           (!strchr(mesh->name, '/') ||
            fault_at(r, node,
                     "the name '%s' has a slash, but files are named after it; "
                     "remove the slash",
                     tf_make_visible(mesh->name).text));
}

static bool read_role(scene_reader *r, const yaml_node_t *node,
                      tf_scene_mesh *mesh)
{
    const char *text = text_of(r, node, "role");
    const tf_role *role = text ? tf_choice_named(tf_roles, text) : NULL;
    if (role)
        mesh->role = *role;
    return role || (text && fault_at(r, node, "role must be %s, got '%s'",
                                     tf_list_choices(tf_roles).text,
                                     tf_make_visible(text).text));
}

static bool read_mass(scene_reader *r, const yaml_node_t *node,
                      tf_scene_mesh *mesh)
{
    return read_scene_number(r, node, "mass", 0x1p-1022, &mesh->mass);
}

static bool read_friction(scene_reader *r, const yaml_node_t *node,
                          tf_scene_mesh *mesh)
{
    return read_scene_number(r, node, "friction", 0, &mesh->friction);
}

static bool read_group(scene_reader *r, const yaml_node_t *node,
                       tf_scene_mesh *mesh)
{
    return copy_text(r, node, "group", &mesh->group);
}

//: Read the frames of a mesh of a scene
static bool find_frames(scene_reader *r, const yaml_node_t *node,
                        tf_scene_mesh *mesh)
{
    const char *text = text_of(r, node, "a file of frames");
    tf_names_found found =
        text ? tf_frame_names_find(&mesh->frames, r->path, text)
             : TF_NAMES_ADDED;
    if (found == TF_NAMES_NO_MEMORY)
        return fault_in_scene_memory(r);
    return text &&
           (found == TF_NAMES_ADDED ||
            fault_at(r, node,
                     "there is no file '%s'; names are relative to the scene "
                     "file",
                     tf_make_visible(text).text));
}

static bool read_frames(scene_reader *r, const yaml_node_t *node,
                        tf_scene_mesh *mesh)
{
    if (node->type == YAML_SCALAR_NODE)
        return find_frames(r, node, mesh);
    if (node->type != YAML_SEQUENCE_NODE ||
        node->data.sequence.items.start == node->data.sequence.items.top)
        return fault_at(r, node,
                        "frames must be a file, a pattern or a list of some");
    bool good = true;
    for (yaml_node_item_t *item = node->data.sequence.items.start;
         item < node->data.sequence.items.top && good; item++)
        good = find_frames(r, node_at(r, *item), mesh);
    return good;
}

//: Read a mapping of YAML
/// A key, and what reads its value.  A list of them ends with one without name.
typedef struct scene_key {
    const char *name;
    key_reader *read;
} scene_key;

/// Sets *known to the key, unless there is a fault: no key of the list, or one
/// that has been seen.
static bool find_key(scene_reader *r, const yaml_node_t *node,
                     const scene_key keys[], const char *wanted, unsigned *seen,
                     const scene_key **known)
{
    const char *text = text_of(r, node, "a key");
    if (!text)
        return false;
    int i = 0;
    while (keys[i].name && strcmp(keys[i].name, text) != 0)
        i++;
    *known = &keys[i];
    if (!keys[i].name)
        return fault_at(r, node, "unknown key '%s'; %s",
                        tf_make_visible(text).text, wanted);
    if (*seen & 1u << i)
        return fault_at(r, node, "the key '%s' is there twice; delete one",
                        text);
    *seen |= 1u << i;
    return true;
}

/// @param wanted what the mapping has, for a message
static bool read_mapping(scene_reader *r, const yaml_node_t *node,
                         const scene_key keys[], const char *wanted,
                         tf_scene_mesh *mesh)
{
    if (node->type != YAML_MAPPING_NODE)
        return fault_at(r, node, "not a mapping; %s", wanted);
    unsigned seen = 0;
    for (yaml_node_pair_t *pair = node->data.mapping.pairs.start;
         pair < node->data.mapping.pairs.top; pair++) {
        const scene_key *key;
        if (!find_key(r, node_at(r, pair->key), keys, wanted, &seen, &key) ||
            !key->read(r, node_at(r, pair->value), mesh))
            return false;
    }
    return true;
}

//: Read a mesh of a scene
static bool read_mesh(scene_reader *r, const yaml_node_t *node)
{
    static const scene_key keys[] = {{"name", read_name},
                                     {"frames", read_frames},
                                     {"role", read_role},
                                     {"mass", read_mass},
                                     {"group", read_group},
                                     {"friction", read_friction},
                                     {0}};
    tf_scene_mesh *mesh = tf_scene_meshes_add(r->meshes);
    if (!mesh)
        return fault_in_scene_memory(r);
    mesh->line = (long)node->start_mark.line + 1;
    if (!read_mapping(r, node, keys,
                      "a mesh has frames, and may have name, role, mass, "
                      "friction and group",
                      mesh))
        return false;
    if (mesh->frames.count == 0)
        return fault_at(r, node,
                        "a mesh without frames; write 'frames:' and a file, a "
                        "pattern or a list of some");
    tf_order_frames(mesh->frames.path, mesh->frames.count);
    return true;
}

static bool read_meshes(scene_reader *r, const yaml_node_t *node,
                        tf_scene_mesh *unused)
{
    (void)unused;
    if (node->type != YAML_SEQUENCE_NODE ||
        node->data.sequence.items.start == node->data.sequence.items.top)
        return fault_at(r, node,
                        "meshes must be a list; write '- frames: FILE' for "
                        "each");
    bool good = true;
    for (yaml_node_item_t *item = node->data.sequence.items.start;
         item < node->data.sequence.items.top && good; item++)
        good = read_mesh(r, node_at(r, *item));
    return good;
}

//: Read the document of a scene
static bool read_document(scene_reader *r)
{
    static const scene_key keys[] = {{"meshes", read_meshes}, {0}};
    const yaml_node_t *root = yaml_document_get_root_node(&r->document);
    if (!root)
        return tf_fault_set(r->fault, r->path, -1,
                            "is empty; a scene has 'meshes:', a list");
    if (!read_mapping(r, root, keys, "a scene has 'meshes:', a list", NULL))
        return false;
    if (r->meshes->count == 0)
        return fault_at(r, root, "no meshes; a scene has 'meshes:', a list");
    return tf_scene_meshes_name(r->meshes)
               ? tf_scene_meshes_check(r->meshes, r->path, r->fault)
               : fault_in_scene_memory(r);
}

//: Load YAML
static bool fault_in_yaml(scene_reader *r, const yaml_parser_t *parser,
                          FILE *stream)
{
    bool bytes = parser->error == YAML_READER_ERROR;
    if (ferror(stream))
        return tf_fault_set_unread(r->fault, r->path, -1, errno);
    if (parser->error == YAML_MEMORY_ERROR)
        return fault_in_scene_memory(r);
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
static bool load(scene_reader *r, yaml_parser_t *parser, FILE *stream)
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
        !root || fault_at(r, root, "a second document; a scene file has one");
    yaml_document_delete(&other);
    return good;
}

static bool read_scene_stream(scene_reader *r, FILE *stream)
{
    yaml_parser_t parser;
    if (!yaml_parser_initialize(&parser))
        return fault_in_scene_memory(r);
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
    scene_reader r = {.path = path, .meshes = meshes, .fault = fault};
    FILE *stream = fopen(path, "rb");
    *meshes = (tf_scene_meshes){0};
    if (!stream)
        return tf_fault_set_unopened(fault, path, errno);
    bool good = read_scene_stream(&r, stream);
    fclose(stream);
    return good;
}
