//: Include what the reader of a scene file needs
#define _GNU_SOURCE // strdup
#include "scenes/scene_reader.h"

#include "files/number.h"

#include <limits.h>
#include <math.h>
#include <string.h>

//: Look at a node of YAML
yaml_node_t *tf_scene_node(tf_scene_reader *reader, int index)
{
    return yaml_document_get_node(&reader->document, index);
}

long tf_scene_line(const yaml_node_t *node)
{
    return (long)node->start_mark.line + 1;
}

void *tf_scene_member(const tf_scene_key *key, void *target)
{
    return (char *)target + key->member;
}

bool tf_scene_is_list(const yaml_node_t *node)
{
    return node->type == YAML_SEQUENCE_NODE &&
           node->data.sequence.items.start < node->data.sequence.items.top;
}

//: Describe what is wrong with a node
bool tf_scene_fault_at(tf_scene_reader *reader, const yaml_node_t *node,
                       const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    tf_fault_set_list(reader->fault, reader->path, tf_scene_line(node), format,
                      arguments);
    va_end(arguments);
    return false;
}

bool tf_scene_fault_in_memory(tf_scene_reader *reader)
{
    return tf_fault_set(reader->fault, reader->path, -1,
                        "not enough memory; name fewer files, or use a machine "
                        "with more");
}

//: Read a text of YAML
const char *tf_scene_text(tf_scene_reader *reader, const yaml_node_t *node,
                          const char *what)
{
    if (node->type != YAML_SCALAR_NODE) {
        tf_scene_fault_at(reader, node,
                          "%s must be a text, not a list or a mapping", what);
        return NULL;
    }
    const char *text = (const char *)node->data.scalar.value;
    if (*text && strlen(text) == node->data.scalar.length)
        return text;
    tf_scene_fault_at(reader, node,
                      *text ? "%s has a NUL character; remove it"
                            : "%s is an empty text; fill it in",
                      what);
    return NULL;
}

bool tf_scene_take_text(tf_scene_reader *reader, const tf_scene_key *key,
                        const yaml_node_t *node, void *target)
{
    const char *text = tf_scene_text(reader, node, key->name);
    if (!text)
        return false;
    char **copy = tf_scene_member(key, target);
    *copy = strdup(text);
    return *copy || tf_scene_fault_in_memory(reader);
}

//: Describe a range of numbers of YAML
typedef struct range_words {
    char text[64];
} range_words;

static range_words words_of_range(const tf_scene_key *key)
{
    range_words words = {""};
    if (key->most < INFINITY && key->most > key->least)
        snprintf(words.text, sizeof words.text, " from %g to %g", key->least,
                 key->most);
    else if (key->most > key->least)
        snprintf(words.text, sizeof words.text,
                 key->least > 0 ? " above 0" : " from 0 on");
    return words;
}

//: Read a number of YAML
static bool fits_key(double number, const tf_scene_key *key, bool whole)
{
    return isfinite(number) &&
           (key->most <= key->least ||
            (number >= key->least && number <= key->most)) &&
           (!whole || (number == floor(number) && fabs(number) <= INT_MAX));
}

/// How to write a fraction, which YAML does not have: "; write 0.0111".
static range_words words_of_fraction(const tf_scene_key *key, const char *text)
{
    range_words words = {""};
    double above, below;
    if (tf_number_read(&text, &above) && *text++ == '/' &&
        tf_number_read(&text, &below) && *text == '\0' &&
        fits_key(above / below, key, false))
        snprintf(words.text, sizeof words.text, "; write %.3g", above / below);
    return words;
}

static bool read_number(tf_scene_reader *reader, const yaml_node_t *node,
                        const tf_scene_key *key, bool whole, double *number)
{
    const char *text = tf_scene_text(reader, node, key->name);
    if (!text)
        return false;
    const char *rest = text;
    bool good = tf_number_read(&rest, number) && *rest == '\0' &&
                fits_key(*number, key, whole);
    return good || tf_scene_fault_at(
                       reader, node, "%s must be a %s%s, got '%s'%s", key->name,
                       whole ? "whole number" : "number",
                       words_of_range(key).text, tf_make_visible(text).text,
                       whole ? "" : words_of_fraction(key, text).text);
}

bool tf_scene_read_number(tf_scene_reader *reader, const yaml_node_t *node,
                          const tf_scene_key *key, double *number)
{
    return read_number(reader, node, key, false, number);
}

bool tf_scene_take_number(tf_scene_reader *reader, const tf_scene_key *key,
                          const yaml_node_t *node, void *target)
{
    double *number = tf_scene_member(key, target);
    return tf_scene_read_number(reader, node, key, number);
}

//: Read a whole number of YAML
bool tf_scene_take_whole(tf_scene_reader *reader, const tf_scene_key *key,
                         const yaml_node_t *node, void *target)
{
    double number;
    if (!read_number(reader, node, key, true, &number))
        return false;
    *(int *)tf_scene_member(key, target) = (int)number;
    return true;
}

//: Read a vector of YAML
bool tf_scene_take_vector(tf_scene_reader *reader, const tf_scene_key *key,
                          const yaml_node_t *node, void *target)
{
    double *vector = tf_scene_member(key, target);
    const yaml_node_item_t *item = node->data.sequence.items.start;
    if (!tf_scene_is_list(node) || node->data.sequence.items.top - item != 3)
        return tf_scene_fault_at(reader, node,
                                 "%s must be three numbers; write [1, 0, 0]",
                                 key->name);
    bool good = true;
    for (int i = 0; i < 3 && good; i++)
        good = tf_scene_read_number(reader, tf_scene_node(reader, item[i]), key,
                                    &vector[i]);
    return good;
}

//: Find a key of a mapping
/// Sets *known to the key, unless there is a fault: no key of the list, or one
/// that has been seen.
static bool find_key(tf_scene_reader *r, const yaml_node_t *node,
                     const tf_scene_key keys[], const char *wanted,
                     unsigned *seen, const tf_scene_key **known)
{
    const char *text = tf_scene_text(r, node, "a key");
    if (!text)
        return false;
    int i = 0;
    while (keys[i].name && strcmp(keys[i].name, text) != 0)
        i++;
    *known = &keys[i];
    if (!keys[i].name)
        return tf_scene_fault_at(r, node, "unknown key '%s'; %s",
                                 tf_make_visible(text).text, wanted);
    if (*seen & 1u << i)
        return tf_scene_fault_at(
            r, node, "the key '%s' is there twice; delete one", text);
    *seen |= 1u << i;
    return true;
}

//: Read a mapping of YAML
bool tf_scene_read_mapping(tf_scene_reader *reader, const yaml_node_t *node,
                           const tf_scene_key keys[], const char *wanted,
                           void *target)
{
    if (node->type != YAML_MAPPING_NODE)
        return tf_scene_fault_at(reader, node, "not a mapping; %s", wanted);
    unsigned seen = 0;
    for (yaml_node_pair_t *pair = node->data.mapping.pairs.start;
         pair < node->data.mapping.pairs.top; pair++) {
        const tf_scene_key *key;
        if (!find_key(reader, tf_scene_node(reader, pair->key), keys, wanted,
                      &seen, &key) ||
            !key->read(reader, key, tf_scene_node(reader, pair->value), target))
            return false;
    }
    return true;
}
