//: Include what Gmsh's files need
#define _GNU_SOURCE // memmem
#include "formats/msh_file.h"

#include "formats/binary.h"
#include "formats/msh_nodes.h"
#include "formats/words.h"

#include <limits.h>
#include <math.h>
#include <string.h>

//: Declare the reader of Gmsh's format
typedef struct msh {
    tf_words words;
    tf_mesh_file *file;
    const char *start;
    bool is_four; ///< version 4.1; or else 2
    bool is_binary, is_big;
    bool has_nodes;
    tf_msh_nodes nodes;
} msh;

static long place(const msh *m)
{
    return m->is_binary ? (long)(m->words.text.at - m->start)
                        : m->words.text.line;
}

//: Take bytes
/// Steps over so many bytes of binary; NULL: they are not there.
static const char *take_bytes(msh *m, size_t count)
{
    const char *at = m->words.text.at;
    if ((size_t)(m->words.end - at) < count) {
        tf_text_fault(&m->words.text,
                      "the file ends too early; it may be cut short");
        return NULL;
    }
    m->words.text.at += count;
    return at;
}

//: Read an integer of Gmsh
/// An int, which is not below `least`.
static bool read_int(msh *m, int least, int *number)
{
    if (!m->is_binary)
        return tf_words_read_integer(&m->words, least, number);
    const char *at = take_bytes(m, 4);
    *number = at ? tf_gather_int(at, m->is_big) : least;
    return at && (*number >= least ||
                  tf_text_fault(&m->words.text,
                                "%d is not an integer from %d; correct it",
                                *number, least));
}

/// A count or a tag, which have more bytes in version 4.
static bool read_size(msh *m, int *number)
{
    if (!m->is_binary || !m->is_four)
        return read_int(m, 0, number);
    const char *at = take_bytes(m, 8);
    uint64_t size = at ? tf_gather_bytes(at, 8, m->is_big) : 0;
    *number = (int)size;
    return at && (size <= INT_MAX ||
                  tf_text_fault(&m->words.text,
                                "a number or tag is above %d; correct it, or "
                                "number the nodes and elements anew",
                                INT_MAX));
}

//: Read the position of a node
static bool read_coordinate(msh *m, double *x, const char **begins)
{
    if (!m->is_binary && !tf_words_need(&m->words))
        return false;
    *begins = m->words.text.at;
    if (!m->is_binary)
        return tf_words_read_number(&m->words, x);
    const char *at = take_bytes(m, 8);
    if (at)
        *x = tf_gather_double(at, m->is_big);
    return at && (isfinite(*x) ||
                  tf_text_fault(&m->words.text, "a coordinate is infinite or "
                                                "NaN; write finite numbers"));
}

static bool skip_coordinate(msh *m)
{
    return m->is_binary ? take_bytes(m, 8) != NULL : tf_words_skip(&m->words);
}

/// Those after the first three are skipped.
static bool read_node(msh *m, int coordinates)
{
    double x[3];
    const char *begin[3];
    if (!m->is_binary && !tf_words_need(&m->words))
        return false;
    long at = place(m);
    for (int k = 0; k < coordinates; k++)
        if (k < 3 ? !read_coordinate(m, &x[k], &begin[k]) : !skip_coordinate(m))
            return false;
    return tf_mesh_file_add_point(m->file, tf_mesh_file_vertices(m->file),
                                  m->start, begin) &&
           tf_mesh_file_add_vertex(m->file, x, at);
}

static bool read_tag(msh *m)
{
    int tag;
    return read_size(m, &tag) && (tf_ints_add(&m->nodes.tag, 1, &tag) ||
                                  tf_mesh_file_fault_in_memory(m->file));
}

//: Read the nodes of a block
/// A block of version 4 has an entity of so many dimensions, in parameters of
/// which positions may be given besides.  All tags come before all positions.
static bool read_node_block(msh *m)
{
    int dimensions, entity, is_parametric, count;
    if (!read_int(m, 0, &dimensions) || !read_int(m, INT_MIN, &entity) ||
        !read_int(m, 0, &is_parametric) || !read_size(m, &count))
        return false;
    int coordinates = 3 + (is_parametric && dimensions < 4 ? dimensions : 0);
    for (int i = 0; i < count; i++)
        if (!read_tag(m))
            return false;
    for (int i = 0; i < count; i++)
        if (!read_node(m, coordinates))
            return false;
    return true;
}

//: Read the numbers that begin a section
/// In binary of version 2 the number is text in a line.
static bool read_plain_count(msh *m, int *count)
{
    bool good = tf_words_read_integer(&m->words, 0, count);
    tf_words_skip_line(&m->words);
    return good && (!m->is_binary || take_bytes(m, 1));
}

/// In version 4 how many blocks there are, and three numbers that they tell, too.
static bool read_block_count(msh *m, int *blocks)
{
    int unused;
    if (m->is_binary) {
        tf_words_skip_line(&m->words);
        if (!take_bytes(m, 1))
            return false;
    }
    return read_size(m, blocks) && read_size(m, &unused) &&
           read_size(m, &unused) && read_size(m, &unused);
}

static bool read_count(msh *m, int *count)
{
    return m->is_four ? read_block_count(m, count) : read_plain_count(m, count);
}

//: Read the nodes
static bool order_nodes(msh *m)
{
    int twice;
    return tf_msh_nodes_order(&m->nodes, &twice) ||
           (twice >= 0 ? tf_text_fault(&m->words.text,
                                       "two nodes have the tag %d; number them "
                                       "differently",
                                       twice)
                       : tf_mesh_file_fault_in_memory(m->file));
}

static bool read_nodes(msh *m)
{
    int count;
    if (m->has_nodes)
        return tf_text_fault(&m->words.text,
                             "a second section $Nodes; join the two");
    m->has_nodes = true;
    if (!read_count(m, &count))
        return false;
    for (int i = 0; i < count; i++)
        if (m->is_four ? !read_node_block(m) : !read_tag(m) || !read_node(m, 3))
            return false;
    return order_nodes(m);
}

//: Tabulate the types of elements
typedef struct msh_type {
    unsigned char dimensions, nodes;
} msh_type;

/// By their numbers.  Those of order 1 are 1 to 7 and 15.
static const msh_type msh_types[] = {
    [1] = {1, 2},   [2] = {2, 3},   [3] = {2, 4},   [4] = {3, 4},
    [5] = {3, 8},   [6] = {3, 6},   [7] = {3, 5},   [8] = {1, 3},
    [9] = {2, 6},   [10] = {2, 9},  [11] = {3, 10}, [12] = {3, 27},
    [13] = {3, 18}, [14] = {3, 14}, [15] = {0, 1},  [16] = {2, 8},
    [17] = {3, 20}, [18] = {3, 15}, [19] = {3, 13}, [20] = {2, 9},
    [21] = {2, 10}, [22] = {2, 12}, [23] = {2, 15}, [24] = {2, 15},
    [25] = {2, 21}, [26] = {1, 4},  [27] = {1, 5},  [28] = {1, 6},
    [29] = {3, 20}, [30] = {3, 35}, [31] = {3, 56}, [36] = {2, 16},
    [37] = {2, 25}, [38] = {2, 36}, [39] = {2, 12}, [40] = {2, 16},
    [41] = {2, 20}, [92] = {3, 64}, [93] = {3, 125}};

enum {
    MSH_TYPES = sizeof msh_types / sizeof *msh_types,
    MSH_NODES = 125 // of an element, at most
};

/// The row of a type, unless it is unknown or a curved surface.
static const msh_type *find_type(const msh *m, int number)
{
    const msh_type *type = number < MSH_TYPES ? &msh_types[number] : NULL;
    if (!type || type->nodes == 0)
        tf_text_fault(&m->words.text,
                      "unknown type %d of elements; save the mesh with "
                      "elements of order 1",
                      number);
    else if (type->dimensions == 2 && number > 3)
        tf_text_fault(&m->words.text,
                      "a curved element with %d nodes; save the mesh with "
                      "elements of order 1, for instance by gmsh -order 1",
                      type->nodes);
    else
        return type;
    return NULL;
}

//: Read an element
/// Replaces tags by vertices.
static bool find_vertices(const msh *m, int count, int node[], long at)
{
    for (int i = 0; i < count; i++) {
        int vertex = tf_msh_nodes_find(&m->nodes, node[i]);
        if (vertex < 0)
            return tf_mesh_file_fault(
                m->file, at,
                "there is no node %d; the section $Nodes must have it",
                node[i]);
        node[i] = vertex;
    }
    return true;
}

static bool add_element(const msh *m, const msh_type *type, int node[], long at)
{
    bool is_edge = type->dimensions == 1 && type->nodes == 2;
    if (type->dimensions != 2)
        m->file->left_out[type->dimensions]++;
    if (type->dimensions != 2 && !is_edge)
        return true;
    return find_vertices(m, type->nodes, node, at) &&
           (is_edge ? tf_mesh_file_add_edge(m->file, node, at)
                    : tf_mesh_file_add_face(m->file, node, type->nodes, at));
}

/// The nodes of an element.
static bool read_element(msh *m, const msh_type *type, long at)
{
    int node[MSH_NODES];
    for (int i = 0; i < type->nodes; i++)
        if (!read_size(m, &node[i]))
            return false;
    return add_element(m, type, node, at);
}

//: Read the elements of a block
/// Each has a number, so many tags, and then its nodes.
static bool read_elements_of(msh *m, const msh_type *type, int count, int tags)
{
    for (int i = 0; i < count; i++) {
        int unused;
        if (!m->is_binary && !tf_words_need(&m->words))
            return false;
        long at = place(m);
        if (!read_size(m, &unused))
            return false;
        for (int k = 0; k < tags; k++)
            if (!read_int(m, INT_MIN, &unused))
                return false;
        if (!read_element(m, type, at))
            return false;
    }
    return true;
}

static bool read_element_block(msh *m, int *count)
{
    int dimensions, entity, number;
    if (!read_int(m, 0, &dimensions) || !read_int(m, INT_MIN, &entity) ||
        !read_int(m, 0, &number) || !read_size(m, count))
        return false;
    const msh_type *type = find_type(m, number);
    return type && read_elements_of(m, type, *count, 0);
}

/// A block of version 2 in binary.
static bool read_old_block(msh *m, int *count)
{
    int number, tags;
    if (!read_int(m, 0, &number) || !read_int(m, 1, count) ||
        !read_int(m, 0, &tags))
        return false;
    const msh_type *type = find_type(m, number);
    return type && read_elements_of(m, type, *count, tags);
}

//: Read an element of a line
/// In text of version 2 each is a block of its own, which its number precedes.
static bool read_element_line(msh *m, int *count)
{
    int unused, number, tags;
    if (!tf_words_need(&m->words))
        return false;
    long at = place(m);
    *count = 1;
    if (!read_int(m, 0, &unused) || !read_int(m, 0, &number) ||
        !read_int(m, 0, &tags))
        return false;
    for (int k = 0; k < tags; k++)
        if (!read_int(m, INT_MIN, &unused))
            return false;
    const msh_type *type = find_type(m, number);
    return type && read_element(m, type, at);
}

//: Read the elements
static bool read_elements(msh *m)
{
    int count, read;
    if (!m->has_nodes)
        return tf_text_fault(&m->words.text, "the section $Elements comes "
                                             "before $Nodes; swap them");
    if (!read_count(m, &count))
        return false;
    for (int i = 0; i < count; i += m->is_four ? 1 : read)
        if (m->is_four     ? !read_element_block(m, &read)
            : m->is_binary ? !read_old_block(m, &read)
                           : !read_element_line(m, &read))
            return false;
    return true;
}

//: Read the format of Gmsh
static bool read_version(msh *m)
{
    double version;
    if (!tf_words_read_number(&m->words, &version))
        return false;
    m->is_four = version == 4.1;
    return m->is_four || (version >= 2 && version < 3) ||
           tf_text_fault(
               &m->words.text,
               "this is version %g of Gmsh's format; save the mesh in "
               "version 4.1 or 2.2, for instance by gmsh -save "
               "-format msh41",
               version);
}

/// In binary a 1 follows, from which the order of bytes is known.
static bool read_byte_order(msh *m)
{
    tf_words_skip_line(&m->words);
    const char *at = take_bytes(m, 5);
    if (!at)
        return false;
    m->is_big = tf_gather_int(at + 1, false) != 1;
    return tf_gather_int(at + 1, m->is_big) == 1 ||
           tf_text_fault(&m->words.text,
                         "the byte order is not told by a 1; the file may be "
                         "damaged");
}

static void describe_source(const msh *m)
{
    if (!m->file->source)
        return;
    m->file->source->is_big_endian = m->is_big;
    for (int k = 0; k < 3; k++)
        m->file->source->type[k] = TF_DOUBLE;
}

static bool read_format(msh *m)
{
    int is_binary, size;
    if (!read_version(m) || !tf_words_read_integer(&m->words, 0, &is_binary) ||
        !tf_words_read_integer(&m->words, 0, &size))
        return false;
    if (is_binary && size != 8)
        return tf_text_fault(&m->words.text,
                             "numbers of %d bytes; save the mesh with 8", size);
    m->is_binary = m->file->counts_bytes = is_binary;
    if (is_binary && !read_byte_order(m))
        return false;
    describe_source(m);
    return true;
}

//: Skip a section
/// Up to its end, which may have any bytes before it.
static bool skip_section(msh *m, const char *end)
{
    tf_text *text = &m->words.text;
    const char *found =
        memmem(text->at, (size_t)(m->words.end - text->at), end, strlen(end));
    if (!found)
        return tf_text_fault(
            text, "'%s' does not follow; the file may be cut short", end);
    for (; text->at < found; text->at++)
        text->line += *text->at == '\n';
    return true;
}

//: Read a section
/// The names of sections are short: longer ones are cut, and so not found again.
static bool read_section(msh *m)
{
    if (*m->words.text.at != '$')
        return tf_words_fault(&m->words, "not the name of a section; one such "
                                         "as $Nodes must follow");
    tf_quoted name = tf_quote(m->words.text.at + 1,
                              strcspn(m->words.text.at + 1, " \t\r\n"));
    char end[TF_QUOTED_ROOM + 4] = "$End";
    strcat(end, name.text);
    m->words.text.at += 1 + strlen(name.text);
    bool good = strcmp(name.text, "MeshFormat") == 0 ? read_format(m)
                : strcmp(name.text, "Nodes") == 0    ? read_nodes(m)
                : strcmp(name.text, "Elements") == 0 ? read_elements(m)
                                                     : skip_section(m, end);
    return good && (tf_words_take(&m->words, end) ||
                    tf_text_fault(&m->words.text,
                                  "'%s' does not follow; correct the numbers "
                                  "in the section",
                                  end));
}

static bool read_sections(msh *m)
{
    while (tf_words_find(&m->words))
        if (!read_section(m))
            return false;
    return true;
}

//: Read Gmsh's format
bool tf_is_msh(const char *text, size_t size)
{
    tf_words words = tf_words_of(&(tf_mesh_file){0}, text, size);
    return tf_words_take(&words, "$MeshFormat");
}

/// Lines are edges where there is no surface.
static bool choose_elements(tf_mesh_file *file)
{
    if (tf_mesh_file_triangles(file) > 0) {
        file->edge.count = file->edge_place.count = 0;
        return true;
    }
    file->left_out[1] -= tf_mesh_file_edges(file);
    return tf_mesh_file_edges(file) > 0 || file->left_out[3] == 0 ||
           tf_mesh_file_fault(file, -1,
                              "no triangles, but %d volume elements; save "
                              "their surface, too",
                              file->left_out[3]);
}

bool tf_msh_parse(tf_mesh_file *file, const char *text, size_t size)
{
    msh m = {
        .words = tf_words_of(file, text, size), .file = file, .start = text};
    file->format = TF_MSH;
    bool good = read_sections(&m);
    tf_msh_nodes_free(&m.nodes);
    if (!good && m.is_binary && !file->fault->counts_bytes) {
        file->fault->counts_bytes = true;
        file->fault->place = place(&m);
    }
    return good && choose_elements(file);
}
