// Files of any format, and what is wrong with the whole of one.
#define _GNU_SOURCE // fileno

#include "formats/mesh_reader.h"

#include "support/bytes.h"
#include "support/meshes.h"
#include "support/program.h"
#include "support/support.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

#define OBJ "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
#define PLY                                                                    \
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"              \
    "property float y\nproperty float z\nelement face 1\n"                     \
    "property list uchar int vertex_index\nend_header\n"                       \
    "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"

static void expect_mesh(const tf_mesh_file *file)
{
    expect_vertices(file, 3, (double[]){0, 0, 0, 1, 0, 0, 0, 1, 0});
    expect_triangles(file, 1, (int[]){0, 1, 2});
}

// Texts -----------------------------------------------------------------------

START_TEST(formats_are_told_apart_by_content)
{
    tf_mesh_file file = good_mesh(OBJ);
    expect_mesh(&file);
    ck_assert_str_eq(file.name, "mesh");
    ck_assert_int_eq(file.first_index, 1);
    tf_mesh_file_free(&file);
    file = good_mesh(PLY);
    expect_mesh(&file);
    ck_assert_int_eq(file.first_index, 0);
    tf_mesh_file_free(&file);
    // These do not begin as PLY does.
    file = good_mesh("plywood\n" OBJ);
    expect_mesh(&file);
    tf_mesh_file_free(&file);
    expect_bad_mesh(" " PLY, -1, "no vertices; the file must be");
    expect_bad_mesh("ply", -1, "no vertices");
}
END_TEST

#define STL                                                                    \
    "solid a\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"   \
    "endloop\nendfacet\nendsolid\n"
#define OFF "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"
#define MSH                                                                    \
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n"      \
    "3 0 1 0\n$EndNodes\n$Elements\n1\n1 2 0 1 2 3\n$EndElements\n"

/// The triangle as binary STL.
static bytes binary_stl(const char *beginning)
{
    bytes made = {0};
    put_text(&made, beginning);
    made.count = 80;
    put_int(&made, 4, 1);
    for (int i = 0; i < 12; i++)
        put_float(&made, i == 6 || i == 10);
    put_int(&made, 2, 0);
    return made;
}

/// A text with other ends of its lines.
static void end_lines(const char *text, const char *end, char made[])
{
    for (; *text; text++)
        made += sprintf(made, *text == '\n' ? "%s" : "%.1s",
                        *text == '\n' ? end : text);
}

START_TEST(all_formats_are_read_with_all_ends_of_lines)
{
    static const char *const texts[] = {OBJ, PLY, STL, OFF, MSH};
    static const int lines[] = {4, 13, 2, 6, 12};
    static const char *const ends[] = {"\n", "\r", "\r\n", "\r\r\n"};
    for (int i = 0; i < 5; i++)
        for (int k = 0; k < 8; k++) {
            char text[1000] = "\xEF\xBB\xBF";
            end_lines(texts[i], ends[k % 4], text + (k < 4 ? 0 : 3));
            tf_mesh_file file = good_mesh(text);
            expect_mesh(&file);
            ck_assert_int_eq(file.triangle_place.item[0],
                             k % 4 < 3 ? lines[i] : 2 * lines[i] - 1);
            tf_mesh_file_free(&file);
        }
}
END_TEST

START_TEST(comments_of_old_macs_end)
{
    tf_mesh_file file = good_mesh("# a\rv 0 0 0\rv 1 0 0\n# b\rv 0 1 0\r\n"
                                  "f 1 \\\r2 3");
    expect_mesh(&file);
    ck_assert_int_eq(file.triangle_place.item[0], 6);
    tf_mesh_file_free(&file);
}
END_TEST

START_TEST(binary_is_left_as_it_is)
{
    // Its coordinates are what would end lines in text.
    static const char *const ends[] = {"\n", "\r", "\r\n"};
    static const char header[] =
        "ply\nformat binary_big_endian 1.0\nelement vertex 3\n"
        "property char x\nproperty char y\nproperty char z\nelement face 1\n"
        "property list char char vertex_indices\nend_header\n";
    for (int i = 0; i < 3; i++) {
        char text[500];
        bytes made = {0};
        end_lines(header, ends[i], text);
        put_text(&made, text);
        put_text(&made, "\r\r\n\r\n\r\n\r\r\3");
        put_int(&made, 3, 0x020100);
        tf_mesh_file file = good_bytes(made.at, made.count);
        expect_vertices(&file, 3,
                        (double[]){13, 13, 10, 13, 10, 13, 10, 13, 13});
        expect_triangles(&file, 1, (int[]){0, 1, 2});
        tf_mesh_file_free(&file);
    }
    bytes made = binary_stl("solid\r");
    tf_mesh_file file = good_bytes(made.at, made.count);
    expect_mesh(&file);
    tf_mesh_file_free(&file);
}
END_TEST

START_TEST(other_files_are_named)
{
    expect_bad_mesh("<html>\n", -1,
                    "this is an HTML page; give the file of a mesh");
    expect_bad_bytes("glTF\2\0\0\0", 8, -1,
                     "this is a binary glTF file; export OBJ, PLY or STL");
}
END_TEST

START_TEST(flat_meshes_have_edges_alone_and_z_0)
{
    static const struct {
        const char *text;
        bool flat;
    } files[] = {
        {"v 1 2\nv 3 4\nl 1 2\n", true},
        {"v 1 2 0\nv 3 4 -0\nl 1 2\n", true},
        {"v 1 2 0\nv 3 4 5e-324\nl 1 2\n", false},
        {"v 1 2 1\nv 3 4 1\nl 1 2\n", false},
        {OBJ, false},
        {OBJ "l 1 2\n", false},
    };
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        tf_mesh_file file = good_mesh(files[i].text);
        ck_assert_msg(tf_mesh_file_is_flat(&file) == files[i].flat, "%s",
                      files[i].text);
        tf_mesh_file_free(&file);
    }
}
END_TEST

START_TEST(a_file_without_elements_is_refused)
{
    static const char *const texts[] = {
        "\n",
        "# nothing\n",
        "\xEF\xBB\xBF",
        "f 1 2 3\n",
        "ply\nformat ascii 1.0\nend_header\n",
        "ply\nformat ascii 1.0\nelement a 7\nend_header\n"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        expect_bad_mesh(texts[i], -1,
                        "no vertices; the file must be a mesh in OBJ, PLY, "
                        "STL, OFF or .msh");
    expect_bad_mesh("", -1, "the file is empty; export it again");
    expect_bad_mesh("v 1 2 3\nv 1 2\n", -1,
                    "no triangles and no edges; a mesh must have some");
}
END_TEST

START_TEST(many_elements_keep_their_order)
{
    enum {
        MANY = 100000
    };
    char *text = malloc(64 * MANY), *to = text;
    for (int i = 0; i < MANY; i++)
        to += sprintf(to, "v %d 0 0\n", i);
    for (int i = 0; i < MANY - 2; i++)
        to += sprintf(to, "f %d %d %d\nl %d -1\n", i + 1, i + 2, i + 3, i + 1);
    tf_mesh_file file = good_mesh(text);
    free(text);
    ck_assert_int_eq(tf_mesh_file_vertices(&file), MANY);
    ck_assert_int_eq(tf_mesh_file_triangles(&file), MANY - 2);
    ck_assert_int_eq(tf_mesh_file_edges(&file), MANY - 2);
    for (int i = 0; i < MANY; i++)
        ck_assert(file.position.item[3 * i] == i);
    for (int i = 0; i < MANY - 2; i++) {
        ck_assert_int_eq(file.triangle.item[3 * i + 2], i + 2);
        ck_assert_int_eq(file.edge.item[2 * i], i);
        ck_assert_int_eq(file.triangle_place.item[i], MANY + 2 * i + 1);
        ck_assert_int_eq(file.edge_place.item[i], MANY + 2 * i + 2);
    }
    tf_mesh_file_free(&file);
}
END_TEST

static tf_fault fault;

// Files -----------------------------------------------------------------------

START_TEST(files_are_read_by_their_names)
{
    make_file("mesh.obj", OBJ);
    make_file("mesh", PLY);
    static const char *const names[] = {"mesh.obj", "mesh"};
    for (int i = 0; i < 2; i++) {
        tf_mesh_file file;
        ck_assert(tf_mesh_file_read(&file, names[i], NULL, &fault));
        ck_assert_ptr_eq(file.name, names[i]);
        expect_mesh(&file);
        tf_mesh_file_free(&file);
    }
}
END_TEST

START_TEST(compressed_files_are_read)
{
    static const char *const texts[] = {OBJ, PLY, STL, OFF, MSH};
    for (int i = 0; i < 5; i++) {
        make_file("mesh", texts[i]);
        ck_assert_int_eq(system("gzip -f mesh"), 0);
        for (int k = 0; k < 2; k++) {
            tf_mesh_file file;
            ck_assert_ptr_nonnull(freopen("mesh.gz", "r", stdin));
            ck_assert_msg(
                tf_mesh_file_read(&file, k ? "-" : "mesh.gz", NULL, &fault),
                "%s", fault.text);
            expect_mesh(&file);
            tf_mesh_file_free(&file);
        }
    }
}
END_TEST

static void expect_words_on(const char *name, const bytes *text,
                            const char *words)
{
    make_binary_file(name, text->at, text->count);
    tf_mesh_file file;
    ck_assert(!tf_mesh_file_read(&file, name, NULL, &fault));
    expect_words(fault.text, words);
    tf_mesh_file_free(&file);
}

/// More than what is read at once, behind the words of another format.
START_TEST(binary_stl_of_any_size_may_begin_with_anything)
{
    enum {
        COUNT = 4000
    };
    static char stl[84 + 50 * COUNT] = "AC3D, by an exporter to STL";
    bytes count = {0};
    put_int(&count, 4, COUNT);
    memcpy(stl + 80, count.at, 4);
    for (int i = 0; i < COUNT; i++) {
        bytes facet = {0};
        for (int k = 0; k < 12; k++)
            put_float(&facet, k % 3 == 2 ? (float)i : k == 6 || k == 10);
        put_int(&facet, 2, 0);
        memcpy(stl + 84 + 50 * i, facet.at, 50);
    }
    tf_mesh_file file;
    make_binary_file("mesh", stl, sizeof stl);
    ck_assert_msg(tf_mesh_file_read(&file, "mesh", NULL, &fault), "%s",
                  fault.text);
    ck_assert_int_eq(tf_mesh_file_triangles(&file), COUNT);
    tf_mesh_file_free(&file);
}
END_TEST

START_TEST(names_tell_what_contents_do_not)
{
    bytes stl = binary_stl("a"), solid = binary_stl("solid a");
    stl.count--;
    solid.count--;
    expect_words_on("mesh.stl", &stl,
                    "has 133 bytes, but its header declares 1 triangle, for "
                    "which it needs 134;");
    expect_words_on("mesh.STL.gz", &stl, "has 133 bytes, but its");
    expect_words_on("mesh.obj", &solid, "has 133 bytes, but its");
    expect_words_on("mesh.obj", &stl, "a NUL byte; ");
    expect_words_on("stl", &stl, "a NUL byte; ");
    expect_words_on(".stl", &stl, "a NUL byte; ");
    bytes off = {0};
    put_text(&off, "# a\n 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    expect_words_on("mesh", &off, "no vertices; ");
    make_file("mesh.off", "# a\n 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    tf_mesh_file named;
    ck_assert(tf_mesh_file_read(&named, "mesh.off", NULL, &fault));
    expect_mesh(&named);
    tf_mesh_file_free(&named);
    // The content does here.
    make_file("mesh.stl", OBJ);
    tf_mesh_file file;
    ck_assert(tf_mesh_file_read(&file, "mesh.stl", NULL, &fault));
    expect_mesh(&file);
    tf_mesh_file_free(&file);
}
END_TEST

START_TEST(files_are_closed)
{
    make_file("mesh", OBJ);
    ck_assert_int_eq(setrlimit(RLIMIT_NOFILE, &(struct rlimit){64, 64}), 0);
    for (int i = 0; i < 100; i++) {
        tf_mesh_file file;
        ck_assert_msg(tf_mesh_file_read(&file, "mesh", NULL, &fault), "%s",
                      fault.text);
        tf_mesh_file_free(&file);
    }
}
END_TEST

START_TEST(files_of_any_size_are_read_whole)
{
    // Around the sizes at which there is more room to be had.
    for (int size = 131072 - 200; size < 131072 + 200; size++) {
        FILE *stream = fopen("mesh", "w");
        fprintf(stream, OBJ "#%*s\nf 1 2 3", size, "");
        fclose(stream);
        tf_mesh_file file;
        ck_assert(tf_mesh_file_read(&file, "mesh", NULL, &fault));
        expect_triangles(&file, 2, (int[]){0, 1, 2, 0, 1, 2});
        tf_mesh_file_free(&file);
    }
}
END_TEST

START_TEST(standard_input_is_read_once)
{
    make_file("mesh", OBJ);
    ck_assert_ptr_nonnull(freopen("mesh", "r", stdin));
    tf_mesh_file file;
    ck_assert(tf_mesh_file_read(&file, "-", NULL, &fault));
    ck_assert_str_eq(file.name, "standard input");
    expect_mesh(&file);
    tf_mesh_file_free(&file);
    // Nothing is left for the second time.
    ck_assert(!tf_mesh_file_read(&file, "-", NULL, &fault));
    expect_words(fault.text, "the file is empty; ");
    tf_mesh_file_free(&file);
}
END_TEST

static void expect_unread(const char *path, const char *words)
{
    tf_mesh_file file;
    ck_assert(!tf_mesh_file_read(&file, path, NULL, &fault));
    ck_assert_str_eq(fault.text, words);
    ck_assert_str_eq(file.name, path);
    ck_assert_int_lt(fault.place, 0);
    tf_mesh_file_free(&file);
}

START_TEST(unreadable_files_are_refused)
{
    expect_unread("absent",
                  "cannot open: No such file or directory; check the name");
    expect_unread("", "cannot open: No such file or directory; check the name");
    expect_unread("/",
                  "cannot read: Is a directory; check that this is a file");
    // Nothing is at address 0.
    expect_unread("/proc/self/mem",
                  "cannot read: Input/output error; check that this is a file");
    make_file("secret", OBJ);
    if (geteuid() == 0)
        return; // who may read it all the same
    ck_assert_int_eq(system("chmod 0 secret"), 0);
    expect_unread("secret", "cannot open: Permission denied; check the name");
}
END_TEST

START_TEST(binary_files_are_given_up_early)
{
    tf_mesh_file file;
    ck_assert(!tf_mesh_file_read(&file, "/dev/zero", NULL, &fault));
    expect_words(fault.text, "a NUL byte; the file must be plain text");
    ck_assert_int_eq(fault.place, 1);
    tf_mesh_file_free(&file);
    FILE *program = fopen("program", "wb");
    ck_assert_ptr_nonnull(program);
    fwrite("\177ELF\0\1", 1, 6, program);
    fclose(program);
    ck_assert(!tf_mesh_file_read(&file, "program", NULL, &fault));
    expect_words(fault.text, "a NUL byte; ");
    tf_mesh_file_free(&file);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("formats/mesh_reader");
    TCase *texts = tcase_create("texts");
    tcase_add_test(texts, formats_are_told_apart_by_content);
    tcase_add_test(texts, all_formats_are_read_with_all_ends_of_lines);
    tcase_add_test(texts, comments_of_old_macs_end);
    tcase_add_test(texts, binary_is_left_as_it_is);
    tcase_add_test(texts, other_files_are_named);
    tcase_add_test(texts, flat_meshes_have_edges_alone_and_z_0);
    tcase_add_test(texts, a_file_without_elements_is_refused);
    tcase_add_test(texts, many_elements_keep_their_order);
    suite_add_tcase(suite, texts);

    TCase *files = tcase_create("files");
    tcase_add_checked_fixture(files, enter_folder, leave_folder);
    tcase_add_test(files, files_are_read_by_their_names);
    tcase_add_test(files, compressed_files_are_read);
    tcase_add_test(files, names_tell_what_contents_do_not);
    tcase_add_test(files, binary_stl_of_any_size_may_begin_with_anything);
    tcase_add_test(files, files_are_closed);
    tcase_add_test(files, files_of_any_size_are_read_whole);
    tcase_add_test(files, standard_input_is_read_once);
    tcase_add_test(files, unreadable_files_are_refused);
    tcase_add_test(files, binary_files_are_given_up_early);
    suite_add_tcase(suite, files);
    return suite;
}
