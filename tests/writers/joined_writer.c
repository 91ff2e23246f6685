// Sources of which vertices were joined: what is kept of them, and that what is
// written is the mesh that was made.

#define _GNU_SOURCE // open_memstream

#include "writers/joined_writer.h"

#include "formats/mesh_reader.h"
#include "scenes/weld.h"
#include "support/support.h"
#include "writers/encoder.h"
#include "writers/mesh_writer.h"

#include <stdlib.h>
#include <string.h>

enum {
    MOST = 67 ///< vertices
};

static tf_fault fault;
static tf_mesh_file file, welded, again;
static tf_columns columns, carried;
static tf_source source;
static int number[MOST];
static tf_mesh_content content;

static void parse(tf_mesh_file *read, tf_columns *into, tf_source *keep,
                  const char *bytes, size_t size)
{
    char *text = malloc(size + 1);
    memcpy(text, bytes, size);
    text[size] = '\0';
    fault = (tf_fault){0};
    ck_assert_msg(
        tf_mesh_file_parse_all(read, "mesh", text, size, into, keep, &fault),
        "%ld: %s in\n%s", fault.place, fault.text, bytes);
}

/// Welds bytes.
static void weld(const char *bytes, size_t size)
{
    tf_weld_report report;
    source = (tf_source){.keeps_parts = true};
    columns = carried = (tf_columns){0};
    parse(&file, &columns, &source, bytes, size);
    ck_assert(tf_weld(&file, 0, &columns, number, &welded, &carried, &report));
    content = (tf_mesh_content){.mesh = tf_mesh_file_elements(&welded, 3),
                                .position = welded.position.item,
                                .from = &welded,
                                .joined = &file,
                                .number = number};
}

static void free_all(void)
{
    tf_mesh_file_free(&file);
    tf_mesh_file_free(&welded);
    tf_columns_free(&columns);
    tf_columns_free(&carried);
    tf_source_free(&source);
}

/// To be freed.
static char *written(size_t *size)
{
    char *text = NULL;
    FILE *stream = open_memstream(&text, size);
    ck_assert(tf_mesh_is_source(&content, file.format));
    tf_mesh_write(stream, &content, file.format);
    ck_assert_int_eq(fclose(stream), 0);
    return text;
}

static void expect_ints(const tf_ints *found, const tf_ints *right)
{
    ck_assert_uint_eq(found->count, right->count);
    if (right->count > 0)
        ck_assert_mem_eq(found->item, right->item,
                         right->count * sizeof *right->item);
}

/// Expects that what is written is read as the welded mesh.
static void expect_welded(const char *bytes, size_t size)
{
    tf_columns rows = {0};
    parse(&again, &rows, NULL, bytes, size);
    ck_assert_uint_eq(again.position.count, welded.position.count);
    ck_assert_mem_eq(again.position.item, welded.position.item,
                     again.position.count * sizeof *again.position.item);
    expect_ints(&again.triangle, &welded.triangle);
    expect_ints(&again.edge, &welded.edge);
    expect_ints(&again.corner, &welded.corner);
    ck_assert_int_eq(rows.count, carried.count);
    for (int v = 0; v < tf_mesh_file_vertices(&again) && rows.count > 0; v++)
        ck_assert_mem_eq(tf_columns_row(&rows, v), tf_columns_row(&carried, v),
                         (size_t)rows.count * sizeof(double));
    tf_columns_free(&rows);
    tf_mesh_file_free(&again);
}

static void expect_text(const char *before, const char *after)
{
    size_t size;
    weld(before, strlen(before));
    ck_assert(tf_joined_is_writable(&content));
    char *text = written(&size);
    ck_assert_str_eq(text, after);
    expect_welded(text, size);
    free(text);
    free_all();
}

// OBJ -------------------------------------------------------------------------

START_TEST(everything_else_in_obj_stays)
{
    expect_text("\xEF\xBB\xBF# by hand\r\nmtllib a.mtl\no body\nv 0.0 00 0\r\n"
                "v 1 0 0 0.5 0 1\nv 0 1 0\nv  1 0 0 1 1 1\nv 1 1 0#last\n"
                "v 0 1 0\nvt 0 1\nvn 0 0 1\n g a\ns 1\nusemtl red\n"
                "f 1/1/1 2/1 3//1 # one\nunknown 7\n"
                "f -3//1 \\\n\t5 6/1\r\nl 1 4 6\nend",
                "\xEF\xBB\xBF# by hand\r\nmtllib a.mtl\no body\nv 0.0 00 0\r\n"
                "v 1 0 0 0.5 0 1\nv 0 1 0\nv 1 1 0#last\n"
                "vt 0 1\nvn 0 0 1\n g a\ns 1\nusemtl red\n"
                "f 1/1/1 2/1 3//1 # one\nunknown 7\n"
                "f 2//1 \\\n\t4 3/1\r\nl 1 2 3\nend");
}
END_TEST

START_TEST(lines_of_old_macs_stay)
{
    expect_text("v 0 0 0\rv 1 0 0\rv 1 0 0\rv 0 1 0\r# a\rf 1 3/1 4\rl 2 1\r",
                "v 0 0 0\rv 1 0 0\rv 0 1 0\r# a\rf 1 2/1 3\rl 2 1\r");
}
END_TEST

#define PAIRS "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 1 1 0\nv 0 1 0\nv 9 9 9\nv 9 9 9\n"

START_TEST(what_loses_corners_is_written_anew)
{
    // Triangles and edges that collapse, and a vertex that only they have.
    expect_text(PAIRS "f 1 2 3\nf 3 4 5\nf 6 7 1\nl 3 4\nl 6 7\nl 1 2 3\n",
                "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\nl 1 2 3\n");
    expect_text(PAIRS "f 1/1 2/2 3/3 4/4 5/5 #x\nf 1 3 4 7/7/7\n",
                "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 9 9 9\n"
                "f 1/1 2/2 3/3 4/5\nf 1 3 5/7/7\n");
    expect_text(PAIRS "f 1 2 3\nl 1 3/8 4/9 5\n",
                "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 9 9 9\nf 1 2 3\n"
                "l 1 3/8\nl 3/8 4\n");
    // Corners across are joined.
    expect_text("v 0 0 0\nv 2 0 0\nv 1 1 0\nv 2 2 0\nv 0 2 0\nv 1 1 0\n"
                "f 1/1 2/2 3/3 4/4 5/5 6/6\n",
                "v 0 0 0\nv 2 0 0\nv 1 1 0\nv 2 2 0\nv 0 2 0\n"
                "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\nf 1/1 4/4 5/5\n"
                "f 1/1 5/5 3/3\n");
}
END_TEST

START_TEST(points_are_numbered_anew)
{
    expect_text(PAIRS "p 4 5\nf 1 2 3\nf 6 7 1\np 6 \\\n -1 5/1\np 7 99\n",
                "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\np 3 4\nf 1 2 3\np 4/1\n");
}
END_TEST

START_TEST(what_has_other_vertices_is_not_kept)
{
    static const char *const lines[] = {"curv 0 1 1 2 3\n", " curv2 1 2\n",
                                        "surf 0 1 0 1 1 2 3 4\n", "p 1 x\n",
                                        "p 0\n"};
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        char text[300];
        int size = sprintf(text, PAIRS "f 1 2 3\n%s", lines[i]);
        weld(text, (size_t)size);
        ck_assert_msg(!tf_joined_is_writable(&content), "%s", lines[i]);
        free_all();
    }
    static const char known[] = PAIRS "f 1 2 3\nsurface\ncurved 1\npp\n";
    weld(known, sizeof known - 1);
    ck_assert(tf_joined_is_writable(&content));
    free_all();
}
END_TEST

// PLY -------------------------------------------------------------------------

#define HEADER(vertices, faces, edges)                                         \
    "ply\nformat ascii 1.0\ncomment kept\nelement vertex " vertices            \
    "\nproperty float x\nproperty float y\nproperty float z\n"                 \
    "property uchar red\nelement face " faces "\nproperty float heat\n"        \
    "property list uchar int vertex_indices\nproperty list uchar float "       \
    "texcoord\nelement edge " edges " \nproperty int vertex1\n"                \
    "property int vertex2\nobj_info kept\nend_header\n"

START_TEST(everything_else_in_ply_stays)
{
    expect_text(HEADER("5", "3", "2") "0 0 0.0 1\n1 0 0 2\n\n1e0 0 0 3\n"
                                      "0 1 0 4\n1 1 0 5\n"
                                      "0.5 3 0 1 3 6 0 0 1 0 0 1\n"
                                      "7 3  2 4 3 0\n8 3 1 2 3 0\n"
                                      "2 4\n1 2\n",
                HEADER("4", "2", "1") "0 0 0.0 1\n1 0 0 2\n\n"
                                      "0 1 0 4\n1 1 0 5\n"
                                      "0.5 3 0 1 2 6 0 0 1 0 0 1\n"
                                      "7 3  1 3 2 0\n"
                                      "1 3\n");
}
END_TEST

START_TEST(lists_of_corners_that_are_gone_are_not_kept)
{
    static const char quad[] =
        HEADER("4", "1", "0") "0 0 0 1\n1 0 0 2\n1 0 0 3\n0 1 0 4\n"
                              "0 4 0 1 2 3 0\n";
    weld(quad, sizeof quad - 1);
    ck_assert(!tf_joined_is_writable(&content));
    free_all();
    static const char strips[] =
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"
        "property float y\nproperty float z\nelement tristrips 1\n"
        "property list int int vertex_indices\nend_header\n"
        "0 0 0\n1 0 0\n1 0 0\n0 1 0\n3 0 1 3\n";
    weld(strips, sizeof strips - 1);
    ck_assert(!tf_joined_is_writable(&content));
    free_all();
}
END_TEST

// Any mesh --------------------------------------------------------------------

/// So many of MOST vertices, no two of them the same.
static void choose(generator *random, int vertices, int count, int chosen[])
{
    for (int i = 0; i < count; i++) {
        bool again_;
        do {
            chosen[i] = below(random, vertices);
            again_ = false;
            for (int k = 0; k < i; k++)
                again_ = again_ || chosen[k] == chosen[i];
        } while (again_);
    }
}

/// A line of elements with all forms of indices.
static int add_line(generator *random, char *text, char word, int vertices,
                    int count)
{
    static const char *const rest[] = {"", "/1", "/1/2", "//3"};
    int chosen[8];
    choose(random, vertices, count, chosen);
    int at = sprintf(text, "%c", word);
    for (int i = 0; i < count; i++)
        at += sprintf(text + at, " %d%s",
                      below(random, 3) ? chosen[i] + 1 : chosen[i] - vertices,
                      rest[below(random, 4)]);
    return at + sprintf(text + at, "\n");
}

static size_t make_obj(generator *random, char text[20000])
{
    static const char *const others[] = {
        "# a comment\n", "g a b\n", "\n", "usemtl x\n", "vt 0 1\n", "s off\n"};
    static const char *const spelled[] = {"0", "1", "1.0", "0.5", "5e-1"};
    int at = 0, vertices = 0;
    while (vertices < 8 || (vertices < MOST - 3 && below(random, 8))) {
        at += sprintf(text + at, "v %s %s %s\n", spelled[below(random, 5)],
                      spelled[below(random, 5)], spelled[below(random, 5)]);
        vertices++;
        if (below(random, 4) == 0)
            at += sprintf(text + at, "%s", others[below(random, 6)]);
        int count = 3 + below(random, 3);
        if (vertices >= 8 && below(random, 2))
            at += add_line(random, text + at, 'f', vertices, count);
        if (vertices >= 8 && below(random, 4) == 0)
            at += add_line(random, text + at, 'l', vertices, count - 1);
        if (vertices >= 8 && below(random, 8) == 0)
            at += add_line(random, text + at, 'p', vertices, count);
    }
    return (size_t)at + (size_t)sprintf(text + at, "v 9 9 9\nv 9 8 9\nv 8 9 9\n"
                                                   "f -1 -2 -3\n");
}

/// The lines that are no elements and no vertices.
static void filter(const char *text, char kept[20000])
{
    *kept = '\0';
    for (const char *line = text; *line;) {
        size_t length = strcspn(line, "\n") + 1;
        if (!strchr("vflp", *line) || strchr("tn", line[1]))
            strncat(kept, line, length);
        line += length;
    }
}

START_TEST(any_obj_is_the_welded_mesh)
{
    generator random = generator_new(33);
    for (long n = cases(3000); n > 0; n--) {
        static char text[20000], before[20000], after[20000];
        size_t size = make_obj(&random, text);
        weld(text, size);
        ck_assert(tf_joined_is_writable(&content));
        char *made = written(&size);
        expect_welded(made, size);
        filter(text, before);
        filter(made, after);
        ck_assert_str_eq(before, after);
        free(made);
        free_all();
    }
}
END_TEST

static void write_ply(generator *random, FILE *stream, int encoding)
{
    static const char *const names[] = {"ascii", "binary_little_endian",
                                        "binary_big_endian"};
    const tf_encoder to = {stream, encoding == 0, encoding == 2};
    int vertices = 8 + below(random, MOST - 8), faces = 1 + below(random, 40);
    fprintf(stream,
            "ply\nformat %s 1.0\ncomment a\nelement face %d\n"
            "property ushort heat\nproperty list uchar ushort vertex_index\n"
            "element vertex %d\nproperty float x\nproperty float y\n"
            "property uchar red\nproperty double z\nelement edge %d\n"
            "property uchar vertex2\nproperty int vertex1\nend_header\n",
            names[encoding], faces, vertices, faces);
    for (int f = 0; f < faces; f++) {
        int chosen[4], count = 3 + (below(random, 30) == 0);
        choose(random, vertices, count, chosen);
        tf_encode_integer(&to, below(random, 65536), 2);
        tf_encode_blank(&to);
        tf_encode_integer(&to, count, 1);
        for (int i = 0; i < count; i++) {
            tf_encode_blank(&to);
            tf_encode_integer(&to, chosen[i], 2);
        }
        tf_encode_line_end(&to);
    }
    for (int v = 0; v < vertices; v++) {
        for (int k = 0; k < 4; k++) {
            static const tf_number_type types[] = {TF_FLOAT, TF_FLOAT, TF_UCHAR,
                                                   TF_DOUBLE};
            tf_encode(&to, types[k], below(random, 3));
            tf_encode_blank(&to);
        }
        tf_encode_line_end(&to);
    }
    for (int e = 0; e < faces; e++) {
        int chosen[2];
        choose(random, vertices, 2, chosen);
        tf_encode_integer(&to, chosen[0], 1);
        tf_encode_blank(&to);
        tf_encode_integer(&to, chosen[1], 4);
        tf_encode_line_end(&to);
    }
}

START_TEST(any_ply_is_the_welded_mesh)
{
    generator random = generator_new(34);
    long kept = 0, all = cases(1500);
    for (long n = 0; n < all; n++) {
        char *text = NULL;
        size_t size;
        FILE *stream = open_memstream(&text, &size);
        write_ply(&random, stream, (int)(n % 3));
        ck_assert_int_eq(fclose(stream), 0);
        weld(text, size);
        free(text);
        if (tf_joined_is_writable(&content)) {
            kept++;
            text = written(&size);
            ck_assert_ptr_nonnull(memmem(text, size, "\ncomment a\n", 11));
            ck_assert_ptr_nonnull(memmem(text, size, "ushort heat\n", 12));
            expect_welded(text, size);
            free(text);
        }
        free_all();
    }
    ck_assert_int_gt(kept, all / 4);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("writers/joined_writer");
    TCase *obj = tcase_create("OBJ");
    tcase_add_test(obj, everything_else_in_obj_stays);
    tcase_add_test(obj, lines_of_old_macs_stay);
    tcase_add_test(obj, what_loses_corners_is_written_anew);
    tcase_add_test(obj, points_are_numbered_anew);
    tcase_add_test(obj, what_has_other_vertices_is_not_kept);
    suite_add_tcase(suite, obj);

    TCase *ply = tcase_create("PLY");
    tcase_add_test(ply, everything_else_in_ply_stays);
    tcase_add_test(ply, lists_of_corners_that_are_gone_are_not_kept);
    suite_add_tcase(suite, ply);

    TCase *any = tcase_create("any mesh");
    tcase_add_test(any, any_obj_is_the_welded_mesh);
    tcase_add_test(any, any_ply_is_the_welded_mesh);
    suite_add_tcase(suite, any);
    return suite;
}
