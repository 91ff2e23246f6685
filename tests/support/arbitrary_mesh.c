#define _POSIX_C_SOURCE 200809L // open_memstream

#include "support/arbitrary_mesh.h"

#include "formats/mesh_reader.h"
#include "scenes/weld.h"
#include "surface/check.h"
#include "surface/detect.h"
#include "writers/joined_writer.h"
#include "writers/losses.h"
#include "writers/mesh_writer.h"
#include "writers/source_writer.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void require(bool condition)
{
    if (!condition)
        abort();
}

// The file --------------------------------------------------------------------

static void check_fault(const tf_mesh_file *file, const char *text, size_t size)
{
    long most = 1;
    for (size_t i = 0; i < size; i++)
        most += text[i] == '\n' || text[i] == '\r';
    if (file->counts_bytes)
        most = (long)size;
    require(file->fault->place >= -1 && file->fault->place <= most);
    require(file->counts_bytes || file->fault->place != 0);
    require(strstr(file->fault->text, "; ") != NULL);
    for (const char *c = file->fault->text; *c; c++)
        require(*c >= ' ' && *c <= '~');
}

/// Places that do not decrease; indices from 0, though perhaps of no vertex.
static void check_list(const tf_ints *list, const tf_ints *places,
                       size_t corners)
{
    require(list->count == corners * places->count);
    for (size_t i = 0; i < list->count; i++)
        require(list->item[i] >= 0);
    for (size_t i = 1; i < places->count; i++)
        require(places->item[i - 1] <= places->item[i]);
}

/// The faces are all triangles, and those of a polygon have its corners.
static void check_faces(const tf_mesh_file *file)
{
    tf_face face = {0};
    int triangles = 0, polygons = 0;
    while (tf_mesh_file_next_face(file, &face)) {
        require(face.triangle == triangles && face.polygon == polygons);
        const int *vertex = file->triangle.item + (size_t)3 * (size_t)triangles;
        for (int i = 0; i < 3 * (face.corners - 2) && face.corners < 50; i++) {
            int k = 0;
            while (k < face.corners && face.corner[k] != vertex[i])
                k++;
            require(k < face.corners);
        }
        triangles += face.corners - 2;
        polygons += face.corners > 3;
    }
    require(triangles == tf_mesh_file_triangles(file));
    require(polygons == tf_mesh_file_polygons(file));
}

static void check_file(const tf_mesh_file *file)
{
    require(file->fault->text[0] == '\0');
    require(file->position.count == 3 * file->vertex_place.count);
    for (size_t i = 0; i < file->position.count; i++)
        require(isfinite(file->position.item[i]));
    check_list(&file->triangle, &file->triangle_place, 3);
    check_list(&file->edge, &file->edge_place, 2);
    check_faces(file);
}

// The surface -----------------------------------------------------------------

enum {
    MOST_VERTICES = 200,
    MOST_ELEMENTS = 24
};

static bool is_small(const tf_mesh_file *file)
{
    return tf_mesh_file_vertices(file) <= MOST_VERTICES &&
           tf_mesh_file_triangles(file) <= MOST_ELEMENTS &&
           tf_mesh_file_edges(file) <= MOST_ELEMENTS;
}

static bool is_good_list(const tf_ints *list, int corners, int vertices)
{
    bool good = true;
    for (size_t i = 0; i < list->count; i++) {
        good &= list->item[i] < vertices;
        for (size_t j = i - i % (size_t)corners; j < i; j++)
            good &= list->item[i] != list->item[j];
    }
    return good;
}

/// At rest two elements in space touch if they intersect, and the reverse.
static void check_surface(tf_surface *surface, int axes, int vertices,
                          const double *x)
{
    tf_motion rest = {.axes = axes, .vertices = vertices, .start = x, .end = x};
    tf_contacts contacts;
    tf_crossings crossings;
    require(tf_detect(surface, &rest, NULL, &contacts, NULL) == TF_OK);
    size_t met = contacts.count;
    require(contacts.any == (met > 0));
    require(tf_surface_check(surface, vertices, x, NULL, &crossings, NULL) ==
            TF_OK);
    size_t crossed = 0;
    for (size_t i = 0; i < crossings.count; i++)
        crossed += crossings.crossing[i].kind != TF_EDGE_THROUGH_TRIANGLE;
    require(axes == 2 || met == crossed);
}

static void try_surface(const tf_mesh_file *file)
{
    int vertices = tf_mesh_file_vertices(file);
    int axes = tf_mesh_file_is_flat(file) ? 2 : 3;
    tf_mesh mesh = {.axes = axes,
                    .vertices = vertices,
                    .triangles = tf_mesh_file_triangles(file),
                    .triangle = file->triangle.item,
                    .edges = tf_mesh_file_edges(file),
                    .edge = file->edge.item};
    tf_surface *surface = NULL;
    tf_status status = tf_surface_create(&mesh, &surface, NULL);
    require(status == (is_good_list(&file->triangle, 3, vertices) &&
                               is_good_list(&file->edge, 2, vertices)
                           ? TF_OK
                           : TF_BAD_INDEX));
    if (status == TF_OK) {
        double x[3 * MOST_VERTICES];
        for (int i = 0; i < axes * vertices; i++)
            x[i] = file->position.item[i / axes * 3 + i % axes];
        check_surface(surface, axes, vertices, x);
    }
    tf_surface_free(surface);
}

/// A row for each vertex, if there are columns, which are written as they are
/// read.
static void check_columns(const tf_mesh_file *file)
{
    const tf_columns *columns = file->columns;
    require(columns->count == 0 ||
            columns->rows == (size_t)tf_mesh_file_vertices(file));
    if (!is_small(file))
        return;
    FILE *nowhere = fopen("/dev/null", "w");
    require(nowhere != NULL);
    tf_mesh_content content = {.mesh = tf_mesh_file_elements(file, 3),
                               .position = file->position.item,
                               .columns = columns->count > 0 ? columns : NULL};
    static const tf_mesh_format formats[] = {TF_OBJ,
                                             TF_PLY_TEXT,
                                             TF_PLY_LITTLE_ENDIAN,
                                             TF_PLY_BIG_ENDIAN,
                                             TF_OFF,
                                             TF_STL_BINARY,
                                             TF_VTP};
    bool good = is_good_list(&file->triangle, 3, tf_mesh_file_vertices(file));
    for (int i = 0; i < 7; i++) {
        if (good) // as what is written has passed for a surface
            tf_mesh_write(nowhere, &content, formats[i]);
        tf_losses losses = tf_find_losses(file, formats[i], false);
        require(memchr(losses.text, '\0', sizeof losses.text) != NULL);
    }
    fclose(nowhere);
}

/// What is written of a file with its positions; to be freed.
static char *rewrite(const tf_mesh_file *file, size_t *size)
{
    char *text = NULL;
    FILE *stream = open_memstream(&text, size);
    require(stream != NULL);
    tf_source_write(stream, file, file->position.item);
    require(fclose(stream) == 0);
    return text;
}

/// Whether a face has a corner twice.  It may be read, if its places let slits
/// lead to holes in it.
static bool has_slit(const tf_mesh_file *file)
{
    tf_face face = {0};
    bool found = false;
    while (tf_mesh_file_next_face(file, &face))
        for (int i = 0; i < face.corners; i++)
            for (int j = 0; j < i; j++)
                found |= face.corner[i] == face.corner[j];
    return found;
}

static bool have_same(const tf_ints *a, const tf_ints *b)
{
    return a->count == b->count &&
           (a->count == 0 ||
            memcmp(a->item, b->item, a->count * sizeof *a->item) == 0);
}

/// A file that is written with its own positions is the same bytes, and with
/// others is read again as these, unless slits are torn open.
static void check_source(tf_mesh_file *file, const void *bytes, size_t size)
{
    size_t again;
    char *text = rewrite(file, &again);
    require(again == size && memcmp(text, bytes, size) == 0);
    free(text);
    bool welds = file->format == TF_STL_TEXT || file->format == TF_STL_BINARY;
    size_t count = file->position.count;
    for (size_t i = 0; i < count; i++)
        if (fabs(file->position.item[i]) < 1e9)
            file->position.item[i] += (double)(i % 7) / 3;
    text = rewrite(file, &again);
    tf_mesh_file read;
    tf_fault fault;
    bool good = tf_mesh_file_parse(&read, "again", text, again, NULL, &fault);
    require(welds || has_slit(file) ||
            (good && read.position.count == count &&
             memcmp(read.position.item, file->position.item,
                    count * sizeof(double)) == 0));
    free(text);
    tf_mesh_file_free(&read);
}

/// What is written of a file of which vertices were joined is read as the mesh
/// that was made, unless slits are closed.
static void check_joined(const tf_mesh_file *file, const tf_mesh_file *made,
                         const int number[])
{
    size_t size;
    const tf_mesh_content content = {.mesh = tf_mesh_file_elements(made, 3),
                                     .position = made->position.item,
                                     .from = made,
                                     .joined = file,
                                     .number = number};
    if (!tf_joined_is_writable(&content))
        return;
    char *text = NULL;
    FILE *stream = open_memstream(&text, &size);
    require(stream != NULL);
    tf_joined_write(stream, &content);
    require(fclose(stream) == 0);
    tf_mesh_file read;
    tf_fault fault;
    bool good = tf_mesh_file_parse(&read, "joined", text, size, NULL, &fault);
    require(has_slit(file) || made->triangle.count + made->edge.count == 0 ||
            (good && have_same(&read.triangle, &made->triangle) &&
             have_same(&read.edge, &made->edge) &&
             read.position.count == made->position.count &&
             memcmp(read.position.item, made->position.item,
                    made->position.count * sizeof(double)) == 0));
    free(text);
    tf_mesh_file_free(&read);
}

static void try_weld(const tf_mesh_file *file)
{
    int vertices = tf_mesh_file_vertices(file);
    tf_mesh_file made;
    tf_weld_report report;
    int *number = malloc(((size_t)vertices + 1) * sizeof *number);
    require(number != NULL);
    if (is_good_list(&file->triangle, 3, vertices) &&
        is_good_list(&file->edge, 2, vertices)) {
        if (tf_weld(file, 0, NULL, number, &made, NULL, &report))
            check_joined(file, &made, number);
        tf_mesh_file_free(&made);
    }
    free(number);
}

void try_arbitrary_mesh(const void *bytes, size_t size)
{
    char *text = malloc(size + 1), *kept = malloc(size + 1);
    require(text && kept);
    memcpy(text, bytes, size);
    memcpy(kept, bytes, size);
    text[size] = kept[size] = '\0';
    tf_mesh_file file;
    tf_fault fault = {0};
    tf_columns columns = {0};
    tf_source source = {.keeps_parts = true};
    if (!tf_mesh_file_parse_all(&file, "fuzz", text, size, &columns, &source,
                                &fault)) {
        check_fault(&file, kept, size);
    } else {
        check_file(&file);
        check_columns(&file);
        if (is_small(&file))
            try_surface(&file);
        try_weld(&file);
        check_source(&file, kept, size);
    }
    free(kept);
    tf_columns_free(&columns);
    tf_source_free(&source);
    tf_mesh_file_free(&file);
}

void try_begun_mesh(int count, const beginning beginnings[], const void *bytes,
                    size_t size)
{
    const unsigned char *byte = bytes;
    if (size == 0)
        return;
    const beginning *chosen = &beginnings[byte[0] % count];
    char *text = malloc(chosen->size + size);
    require(text != NULL);
    memcpy(text, chosen->bytes, chosen->size);
    memcpy(text + chosen->size, byte + 1, size - 1);
    try_arbitrary_mesh(text, chosen->size + size - 1);
    free(text);
}
