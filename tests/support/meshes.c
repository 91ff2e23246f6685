#define _POSIX_C_SOURCE 200809L // open_memstream

#include "support/meshes.h"

#include "formats/mesh_reader.h"
#include "support/support.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static tf_fault fault;
static tf_columns *columns;

void read_columns(tf_columns *into)
{
    columns = into;
    if (into)
        *into = (tf_columns){0};
}

bool parse_mesh(tf_mesh_file *file, const void *text, size_t size)
{
    char *copy = malloc(size + 1);
    ck_assert_ptr_nonnull(copy);
    memcpy(copy, text, size);
    copy[size] = '\0';
    fault = (tf_fault){0};
    bool good = tf_mesh_file_parse(file, "mesh", copy, size, columns, &fault);
    free(copy);
    return good;
}

tf_mesh_file good_bytes(const void *text, size_t size)
{
    tf_mesh_file file;
    bool good = parse_mesh(&file, text, size);
    ck_assert_msg(good, "%ld: %s", fault.place, fault.text);
    ck_assert_str_eq(fault.text, "");
    return file;
}

tf_mesh_file good_mesh(const char *text)
{
    return good_bytes(text, strlen(text));
}

tf_mesh_content content_of(const tf_mesh_file *file)
{
    return (tf_mesh_content){.mesh = tf_mesh_file_elements(file, 3),
                             .position = file->position.item};
}

char *bytes_of_mesh(const tf_mesh_content *content, tf_mesh_format format,
                    size_t *size)
{
    char *text = NULL;
    FILE *stream = open_memstream(&text, size);
    ck_assert_ptr_nonnull(stream);
    tf_mesh_write(stream, content, format);
    ck_assert_int_eq(fclose(stream), 0);
    return text;
}

void expect_mesh_text(const tf_mesh_content *content, tf_mesh_format format,
                      const char *text)
{
    size_t size;
    char *found = bytes_of_mesh(content, format, &size);
    ck_assert_str_eq(found, text);
    free(found);
}

tf_mesh_file empty_mesh(const char *name)
{
    fault = (tf_fault){0};
    return (tf_mesh_file){.name = name, .fault = &fault};
}

void expect_bad_bytes(const void *text, size_t size, long place,
                      const char *words)
{
    tf_mesh_file file;
    ck_assert_msg(!parse_mesh(&file, text, size), "no fault, but %s", words);
    ck_assert_msg(strstr(fault.text, words), "'%s' and not '%s'", fault.text,
                  words);
    ck_assert_msg(strstr(fault.text, "; "), "'%s': how to mend it?",
                  fault.text);
    ck_assert_msg(fault.place == place, "place %ld, not %ld: %s", fault.place,
                  place, fault.text);
    tf_mesh_file_free(&file);
}

void expect_bad_mesh(const char *text, long place, const char *words)
{
    expect_bad_bytes(text, strlen(text), place, words);
}

void expect_vertices(const tf_mesh_file *file, int count, const double x[])
{
    ck_assert_int_eq(tf_mesh_file_vertices(file), count);
    for (int i = 0; i < 3 * count; i++) {
        double read = file->position.item[i];
        ck_assert_msg(read == x[i] && signbit(read) == signbit(x[i]),
                      "coordinate %d of vertex %d is %a, not %a", i % 3, i / 3,
                      read, x[i]);
    }
}

static void expect_ints(int count, const int read[], const int right[])
{
    for (int i = 0; i < count; i++)
        ck_assert_msg(read[i] == right[i], "index %d is %d, not %d", i, read[i],
                      right[i]);
}

void expect_triangles(const tf_mesh_file *file, int count, const int vertex[])
{
    ck_assert_int_eq(tf_mesh_file_triangles(file), count);
    expect_ints(3 * count, file->triangle.item, vertex);
}

void expect_edges(const tf_mesh_file *file, int count, const int vertex[])
{
    ck_assert_int_eq(tf_mesh_file_edges(file), count);
    expect_ints(2 * count, file->edge.item, vertex);
}

void expect_triangles_of(const char *text, int count, const int vertex[])
{
    tf_mesh_file file = good_mesh(text);
    expect_triangles(&file, count, vertex);
    tf_mesh_file_free(&file);
}

void expect_edges_of(const char *text, int count, const int vertex[])
{
    tf_mesh_file file = good_mesh(text);
    expect_edges(&file, count, vertex);
    tf_mesh_file_free(&file);
}
