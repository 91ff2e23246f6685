// Texts of mesh files: what is read of them, or what is wrong with them.
#ifndef SUPPORT_MESHES_H
#define SUPPORT_MESHES_H

#include "writers/mesh_writer.h"

/// Reads a text from memory that ends with it, and calls it "mesh".  Its fault
/// is kept until the next one is read.
bool parse_mesh(tf_mesh_file *file, const void *text, size_t size);

/// The mesh of a good text; free it.
tf_mesh_file good_bytes(const void *text, size_t size);
tf_mesh_file good_mesh(const char *text);

/// Reads into empty columns, too, until this is called with NULL.
void read_columns(tf_columns *columns);

/// What is written of a file.
tf_mesh_content content_of(const tf_mesh_file *file);

/// The bytes of a mesh in a format, with a zero behind them; to be freed.
char *bytes_of_mesh(const tf_mesh_content *content, tf_mesh_format format,
                    size_t *size);

/// Expects that a mesh with polygons, colors and so on is this text.
void expect_mesh_text(const tf_mesh_content *content, tf_mesh_format format,
                      const char *text);

/// An empty file of that name, whose fault is kept until a text is parsed.
tf_mesh_file empty_mesh(const char *name);

/// Expects a fault at a line or byte (below 0: at none), told in these words.
void expect_bad_bytes(const void *text, size_t size, long place,
                      const char *words);
void expect_bad_mesh(const char *text, long place, const char *words);

/// Expects these vertices, triangles or edges, and no others.
void expect_vertices(const tf_mesh_file *file, int count, const double x[]);
void expect_triangles(const tf_mesh_file *file, int count, const int vertex[]);
void expect_edges(const tf_mesh_file *file, int count, const int vertex[]);

/// Expects the elements of a text, without its vertices.
void expect_triangles_of(const char *text, int count, const int vertex[]);
void expect_edges_of(const char *text, int count, const int vertex[]);

#endif
