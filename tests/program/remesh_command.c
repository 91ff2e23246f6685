// The command remesh, as a user runs it.

#include "program/command.h"

#include "support/environments.h"
#include "support/program.h"
#include "support/support.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SQUARE "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n"

static void enter_folder_with_files(void)
{
    enter_folder();
    make_file("square.obj", SQUARE);
    make_file("crossed", "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 1 1 -1\nv 1 1 1\n"
                         "v 9 9 9\nf 1 2 3\nf 4 5 6\n");
}

START_TEST(a_mesh_is_remeshed)
{
    outcome found = run("$tf remesh square.obj -o out.obj --edge 0.25");
    ck_assert_str_eq(found.err, "");
    ck_assert_int_eq(found.status, 0);
    expect_words(found.out, "triangles before: 2\n");
    expect_words(found.out, "rounds: 5\n");
    expect_words(found.out, "\ndistance: ");
    ck_assert_int_gt(occurrences(file_text("out.obj"), "f "), 20);
    expect(run("$tf check --format summary out.obj"), 0,
           "files: 1\nfiles with intersections: 0\nintersections: 0\n", "");
}
END_TEST

START_TEST(a_mesh_goes_from_and_to_a_pipe)
{
    outcome found =
        run("cat square.obj | $tf remesh - -o - -e 9 --rounds 1 --format json");
    ck_assert_int_eq(found.status, 0);
    ck_assert_str_eq(found.out, SQUARE);
    expect_words(found.err, "\"triangles\":2,");
    expect_words(found.err, "\"rounds\":1,");
}
END_TEST

START_TEST(the_ending_chooses_the_format)
{
    outcome found = run("$tf remesh square.obj -o out.ply -e 9");
    ck_assert_int_eq(found.status, 0);
    expect_words(file_text("out.ply"), "ply\n");
}
END_TEST

START_TEST(what_new_triangles_lose_is_said)
{
    make_file("named.obj", "o square\nvt 0 0\ns 1\nvn 0 0 1\n" SQUARE);
    outcome found = run("$tf remesh named.obj -o out.obj -e 9");
    ck_assert_int_eq(found.status, 0);
    ck_assert_str_eq(found.err,
                     "tanglefree: out.obj: without the smoothing groups and "
                     "normals of named.obj\n");
    expect_words(run("$tf remesh named.obj -o - -e 9").err,
                 "tanglefree: standard output: without the smoothing groups "
                 "and normals of named.obj\n");
    expect_words(run("$tf remesh named.obj -o out.ply -e 9").err,
                 "tanglefree: out.ply: without the object names, smoothing "
                 "groups, texture coordinates and normals of named.obj\n");
}
END_TEST

START_TEST(floats_of_stl_are_told)
{
    make_file("third.obj", "v 0 0 0\nv 1 0 0\nv 1 0.1 0\nf 1 2 3\n");
    expect(run("$tf resolve third.obj third.obj -o one.stl 2>&1 >report | "
               "cut -d, -f 1"),
           0, "tanglefree: one.stl: 1 of 9 coordinates are rounded to floats\n",
           "");
    make_file("text.stl",
              "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
              "vertex 1 0 0\nvertex 1 .1 0\nendloop\nendfacet\n"
              "endsolid\n");
    expect(run("$tf remesh text.stl -o two.stl -e 9 2>&1 >report | cut -d, -f "
               "1; cmp one.stl two.stl"),
           0, "tanglefree: two.stl: 1 of 9 coordinates are rounded to floats\n",
           "");
    expect(run("$tf remesh text.stl -o a.pvd -e 9"), 2, "",
           "tanglefree: a.pvd: .pvd is not written; end the name in .obj, "
           ".ply, .stl, .off or .vtp\n");
}
END_TEST

START_TEST(edges_are_kept)
{
    make_file("kept", "# the diagonal, and a corner of it\n0 2\n0\n");
    ck_assert_int_eq(
        run("$tf remesh square.obj -o out.obj -e 0.3 --keep kept").status, 0);
    make_file("none", "1 3\n");
    expect(run("$tf remesh square.obj -o out.obj -e 0.3 --keep none"), 2, "",
           "tanglefree: none: no edge joins the vertices 1 and 3; keep edges "
           "that the mesh has\n");
    expect(run("$tf remesh square.obj -o out.obj -e 0.3 --keep nowhere"), 2, "",
           "tanglefree: nowhere: cannot open: No such file or directory; check "
           "the name\n");
}
END_TEST

START_TEST(lengths_come_from_a_file)
{
    make_file("lengths", "0.1 0.1\n1\n1\n");
    outcome found = run("$tf remesh square.obj -o out.obj --lengths lengths");
    ck_assert_str_eq(found.err, "");
    ck_assert_int_eq(found.status, 0);
    ck_assert_int_gt(occurrences(file_text("out.obj"), "f "), 40);
    make_file("few", "0.1 0.1\n1\n");
    expect(run("$tf remesh square.obj -o out.obj --lengths few"), 2, "",
           "tanglefree: few: the number of lengths is 3, but there are 4 "
           "vertices; write one for each, in their order\n");
}
END_TEST

START_TEST(a_distance_is_kept)
{
    outcome found = run("$tf remesh square.obj -o out.obj --error 0.01");
    ck_assert_str_eq(found.err, "");
    ck_assert_int_eq(found.status, 0);
    const char *most = strstr(found.out, "distance at most: ");
    ck_assert_ptr_nonnull(most);
    ck_assert_double_lt(strtod(strchr(most, ':') + 1, NULL), 1e-12);
    ck_assert_int_eq(occurrences(file_text("out.obj"), "f "), 2);
    expect(run("$tf remesh square.obj -o out.obj --error 1e-20"), 2, "",
           "tanglefree: square.obj: --error 1e-20 can't be kept; give a larger "
           "one\n");
}
END_TEST

/// A square with colors, a label and a linear function of x and y.
#define PROPERTIES                                                             \
    "property uchar red\nproperty double x\nproperty double y\n"               \
    "property double z\nproperty short label\nproperty double f\n"
#define COLORED                                                                \
    "ply\nformat ascii 1.0\nelement vertex 4\n" PROPERTIES                     \
    "element face 2\nproperty list uchar int vertex_indices\n"                 \
    "property uchar flags\nend_header\n255 0 0 0 -5 1\n0 1 0 0 -5 3\n"         \
    "0 1 1 0 -5 -4\n255 0 1 0 -5 -6\n3 0 1 2 9\n3 0 2 3 9\n"

START_TEST(what_vertices_have_is_carried_over)
{
    make_file("colored.ply", COLORED);
    ck_assert_int_eq(run("$tf remesh colored.ply -o out.ply -e 0.3").status, 0);
    const char *text = file_text("out.ply");
    expect_words(text, PROPERTIES "element face");
    const char *row = strstr(text, "end_header\n") + 11;
    int vertices = 0, label, read;
    double red, x, y, z, f;
    sscanf(strstr(text, "element vertex"), "element vertex %d", &vertices);
    ck_assert_int_gt(vertices, 15);
    for (int v = 0; v < vertices; v++, row += read) {
        ck_assert_int_eq(sscanf(row, "%lf %lf %lf %lf %d %lf\n%n", &red, &x, &y,
                                &z, &label, &f, &read),
                         6);
        ck_assert_double_eq_tol(red, 255 * (1 - x), 0.5 + 1e-12);
        ck_assert_double_eq(red, floor(red));
        ck_assert_int_eq(label, -5);
        ck_assert_double_eq_tol(f, 1 + 2 * x - 7 * y, 1e-14);
    }
}
END_TEST

START_TEST(colors_of_obj_are_carried_over)
{
    make_file("colored.obj", "v 0 0 0 1 0 0\nv 1 0 0 0 0 1\nv 1 1 0 0 0 1\n"
                             "v 0 1 0 1 0 0\nf 1 2 3\nf 1 3 4\n");
    ck_assert_int_eq(run("$tf remesh colored.obj -o out.obj -e 0.3").status, 0);
    const char *row = file_text("out.obj");
    int vertices = 0, read;
    double x[6];
    for (; *row == 'v'; row += read, vertices++) {
        ck_assert_int_eq(sscanf(row, "v %lf %lf %lf %lf %lf %lf\n%n", &x[0],
                                &x[1], &x[2], &x[3], &x[4], &x[5], &read),
                         6);
        ck_assert_double_eq_tol(x[3], 1 - x[0], 1e-14);
        ck_assert_double_eq(x[4], 0);
        ck_assert_double_eq_tol(x[5], x[0], 1e-14);
    }
    ck_assert_int_gt(vertices, 15);
}
END_TEST

// What faces have -------------------------------------------------------------

/// A reading of OBJ by lines of few kinds: triangles with what they belong to.
typedef struct obj {
    int vertices, textures, triangles;
    double x[4096][3], uv[4096][2];
    int vertex[4096][3], texture[4096][3]; // from 0; -1: none
    char heading[4096][64];                // the last usemtl or g
} obj;

static const obj *read_obj(const char *name)
{
    static obj read;
    static char now[64];
    memset(&read, 0, sizeof read);
    now[0] = '\0';
    for (const char *at = file_text(name); *at; at += strcspn(at, "\n") + 1) {
        int(*v)[3] = read.vertex, (*t)[3] = read.texture, i = read.triangles;
        if (at[0] == 'v' && at[1] == ' ') {
            double *x = read.x[read.vertices++];
            sscanf(at, "v %lf %lf %lf", &x[0], &x[1], &x[2]);
        } else if (at[0] == 'v') {
            double *uv = read.uv[read.textures++];
            ck_assert_int_eq(sscanf(at, "vt %lf %lf", &uv[0], &uv[1]), 2);
        } else if (at[0] == 'f') {
            bool has = sscanf(at, "f %d/%d %d/%d %d/%d", &v[i][0], &t[i][0],
                              &v[i][1], &t[i][1], &v[i][2], &t[i][2]) == 6;
            if (!has)
                ck_assert_int_eq(
                    sscanf(at, "f %d %d %d", &v[i][0], &v[i][1], &v[i][2]), 3);
            for (int k = 0; k < 3; k++) {
                v[i][k]--;
                t[i][k] = has ? t[i][k] - 1 : -1;
            }
            strcpy(read.heading[read.triangles++], now);
        } else if (at[0] == 'u' || at[0] == 'g') {
            sscanf(at, "%*s %63s", now);
        }
    }
    return &read;
}

static double area_of(const double *a, const double *b, const double *c)
{
    double n[3], sum = 0;
    for (int k = 0; k < 3; k++) {
        int i = (k + 1) % 3, j = (k + 2) % 3;
        n[k] = (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
        sum += n[k] * n[k];
    }
    return sqrt(sum) / 2;
}

/// The area of all triangles below a heading.
static double area_below(const obj *of, const char *heading)
{
    double sum = 0;
    for (int i = 0; i < of->triangles; i++)
        if (strcmp(of->heading[i], heading) == 0)
            sum += area_of(of->x[of->vertex[i][0]], of->x[of->vertex[i][1]],
                           of->x[of->vertex[i][2]]);
    return sum;
}

/// A cube with a material on each side, and a texture that the sides do not
/// share: side k has z = 0 or z = 1 for k < 2, and so on, with the texture
/// coordinates (k + x / 2, y / 3) of the two other axes.
static void make_cube(void)
{
    static const char *const sides[] = {"1 3 4 2", "5 6 8 7", "1 2 6 5",
                                        "3 7 8 4", "1 5 7 3", "2 4 8 6"};
    char text[2048] = "mtllib cube.mtl\no cube\ng all\n", word[64];
    int count = 0;
    for (int v = 0; v < 8; v++) {
        snprintf(word, sizeof word, "v %d %d %d\n", v & 1, v >> 1 & 1, v >> 2);
        strcat(text, word);
    }
    for (int k = 0; k < 6; k++) {
        int v[4], axis = 2 - k / 2, u = axis == 0, w = axis == 2 ? 1 : 2;
        sscanf(sides[k], "%d %d %d %d", &v[0], &v[1], &v[2], &v[3]);
        for (int i = 0; i < 4; i++) {
            snprintf(word, sizeof word, "vt %g %.17g\n",
                     k + ((v[i] - 1) >> u & 1) / 2.0,
                     ((v[i] - 1) >> w & 1) / 3.0);
            strcat(text, word);
        }
        snprintf(word, sizeof word, "usemtl m%d\nf %d/%d %d/%d %d/%d %d/%d\n",
                 k, v[0], count + 1, v[1], count + 2, v[2], count + 3, v[3],
                 count + 4);
        strcat(text, word);
        count += 4;
    }
    make_file("cube.obj", text);
}

START_TEST(materials_and_textures_keep_their_places)
{
    static const char *const edges[] = {"0.13", "0.4", "3"};
    make_cube();
    outcome found =
        run("$tf remesh cube.obj -o out.obj --crease 180 -e %s", edges[_i]);
    ck_assert_int_eq(found.status, 0);
    ck_assert_ptr_null(strstr(found.err, "out.obj: without"));
    expect_words(file_text("out.obj"), "mtllib cube.mtl\nv ");
    expect_words(file_text("out.obj"), "o cube\ng all\nusemtl m0\nf ");
    const obj *made = read_obj("out.obj");
    ck_assert_int_ge(made->triangles, 12);
    for (int k = 0; k < 6; k++) {
        char name[] = {'m', (char)('0' + k), '\0'};
        ck_assert_double_eq_tol(area_below(made, name), 1, 1e-12);
    }
    for (int i = 0; i < made->triangles; i++)
        for (int c = 0; c < 3; c++) {
            int k = made->heading[i][1] - '0', axis = 2 - k / 2;
            const double *x = made->x[made->vertex[i][c]];
            ck_assert_double_eq_tol(x[axis], k % 2, 1e-15);
            ck_assert_int_ge(made->texture[i][c], 0);
            const double *uv = made->uv[made->texture[i][c]];
            ck_assert_double_eq_tol(uv[0], k + x[axis == 0] / 2, 1e-12);
            ck_assert_double_eq_tol(uv[1], x[axis == 2 ? 1 : 2] / 3, 1e-12);
        }
    // A vertex has its texture coordinates once on each of its sides.
    int pairs = 0;
    for (int v = 0; v < made->vertices; v++)
        for (int k = 0; k < 3; k++)
            pairs += fabs(made->x[v][k] - 0.5) > 0.5 - 1e-12;
    ck_assert_int_eq(made->textures, pairs);
    expect(run("$tf check --format summary out.obj"), 0,
           "files: 1\nfiles with intersections: 0\nintersections: 0\n", "");
}
END_TEST

/// Three sheets on one edge, and a triangle through one of them.
#define PAGES                                                                  \
    "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 0 0 3\nv 4 0 3\nv 2 -3 1\n"         \
    "v 1 1 -1\nv 2 1 -1\nv 1.5 1 1\nusemtl a\nf 1 2 3\nf 1 3 4\nusemtl b\n"    \
    "f 1 2 6\nf 1 6 5\nusemtl c\nf 2 1 7\nusemtl d\nf 8 9 10\n"

START_TEST(materials_meet_where_three_sheets_do)
{
    make_file("pages.obj", PAGES);
    outcome found = run("$tf remesh pages.obj -o out.obj -e 0.5");
    ck_assert_int_eq(found.status, 0);
    const obj *made = read_obj("out.obj");
    ck_assert_double_eq_tol(area_below(made, "a"), 16, 1e-12);
    ck_assert_double_eq_tol(area_below(made, "b"), 12, 1e-12);
    ck_assert_double_eq_tol(area_below(made, "c"), 2 * sqrt(10), 1e-12);
    ck_assert_double_eq_tol(area_below(made, "d"), 1, 1e-12);
}
END_TEST

/// A flat sheet of 4 x 4 squares, whose groups a and b meet at a zigzag.
static void make_sheet(void)
{
    char text[4096] = "", word[64];
    for (int v = 0; v < 25; v++) {
        snprintf(word, sizeof word, "v %d %d 0\n", v % 5, v / 5);
        strcat(text, word);
    }
    for (int i = 0; i < 32; i++) {
        int x = i / 2 % 4, y = i / 8, v = 1 + x + 5 * y;
        bool lower = i % 2 == 0, is_b = x > 1 + y % 2 || (x == 1 && lower);
        snprintf(word, sizeof word, "g %c\nf %d %d %d\n", is_b ? 'b' : 'a', v,
                 lower ? v + 1 : v + 6, lower ? v + 6 : v + 5);
        strcat(text, word);
    }
    make_file("sheet.obj", text);
}

START_TEST(groups_keep_their_border)
{
    make_sheet();
    static obj before;
    before = *read_obj("sheet.obj");
    ck_assert_int_eq(run("$tf remesh sheet.obj -o out.obj -e 0.7").status, 0);
    const obj *made = read_obj("out.obj");
    ck_assert_double_eq_tol(area_below(made, "a"), area_below(&before, "a"),
                            1e-12);
    ck_assert_double_eq_tol(area_below(made, "b"), area_below(&before, "b"),
                            1e-12);
    ck_assert_double_eq_tol(area_below(made, "a") + area_below(made, "b"), 16,
                            1e-12);
    ck_assert_int_eq(occurrences(file_text("out.obj"), "g a\n"), 1);
    ck_assert_int_eq(occurrences(file_text("out.obj"), "g b\n"), 1);
    for (int i = 0; i < before.triangles; i++) // where it turns, it stays
        for (int k = 0; k < 3; k++) {
            const double *x = before.x[before.vertex[i][k]];
            if (x[0] < 1 || x[0] > 3 || x[1] == 0 || x[1] == 4)
                continue;
            int groups = 0, same = 0;
            for (int j = 0; j < before.triangles; j++)
                for (int c = 0; c < 3; c++)
                    if (before.vertex[j][c] == before.vertex[i][k])
                        groups |= 1 << (before.heading[j][0] - 'a');
            for (int v = 0; v < made->vertices; v++)
                same += memcmp(made->x[v], x, 24) == 0;
            if (groups == 3)
                ck_assert_int_eq(same, 1);
        }
}
END_TEST

#define LABELLED                                                               \
    "element vertex 6\nproperty float x\nproperty float y\n"                   \
    "property float z\nelement face 3\nproperty short label\n"                 \
    "property list uchar int vertex_indices\nproperty float heat\n"            \
    "property uchar red\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n"      \
    "2 1 0\n-7 4 0 1 2 3 0.5 9\n300 3 1 4 5 0.5 9\n300 3 1 5 2 0.5 9\n"

START_TEST(labels_of_faces_are_carried_over)
{
    make_file("labels.ply", "ply\nformat ascii 1.0\n" LABELLED);
    outcome found = run("$tf remesh labels.ply -o out.ply -e 0.3");
    ck_assert_int_eq(found.status, 0);
    expect_words(found.err, "tanglefree: out.ply: without the properties of "
                            "faces of labels.ply\n");
    const char *text = file_text("out.ply");
    expect_words(text, "property list uchar int vertex_indices\n"
                       "property short label\nproperty uchar red\nend_header");
    int vertices = 0, faces = 0, read;
    static double x[4096][3];
    double sum[2] = {0};
    sscanf(strstr(text, "element vertex"), "element vertex %d", &vertices);
    sscanf(strstr(text, "element face"), "element face %d", &faces);
    const char *row = strstr(text, "end_header\n") + 11;
    for (int v = 0; v < vertices; v++, row += read)
        sscanf(row, "%lf %lf %lf\n%n", &x[v][0], &x[v][1], &x[v][2], &read);
    for (int i = 0; i < faces; i++, row += read) {
        int v[3], label, red;
        ck_assert_int_eq(sscanf(row, "3 %d %d %d %d %d\n%n", &v[0], &v[1],
                                &v[2], &label, &red, &read),
                         5);
        ck_assert_int_eq(red, 9);
        ck_assert(label == -7 || label == 300);
        double middle = (x[v[0]][0] + x[v[1]][0] + x[v[2]][0]) / 3;
        ck_assert_int_eq(label, middle < 1 ? -7 : 300);
        sum[label == 300] += area_of(x[v[0]], x[v[1]], x[v[2]]);
    }
    ck_assert_int_gt(faces, 20);
    ck_assert_double_eq_tol(sum[0], 1, 1e-12);
    ck_assert_double_eq_tol(sum[1], 1, 1e-12);
    // What is written is read, in binary, too.
    expect_words(run("$tf remesh out.ply -o - -e 0.3").out,
                 "property short label\nproperty uchar red\nend_header");
}
END_TEST

START_TEST(texture_coordinates_that_are_missing_are_named)
{
    make_file("bad.obj", "vt 0 0\nv 0 0 0\nv 1 0 0\nv 1 1 0\n"
                         "f 1/1 2/1 3/2\n");
    expect(run("$tf remesh bad.obj -o out.obj -e 1"), 2, "",
           "tanglefree: bad.obj:5: there are no texture coordinates 2; the "
           "last vt of the file is 1\n");
    make_file("bad.obj", "vt 0 0\nv 0 0 0\nv 1 0 0\nv 1 1 0\n"
                         "f 1/1 2/-2 3/1\n");
    expect_words(run("$tf remesh bad.obj -o out.obj -e 1").err,
                 "bad.obj:5: '2/-2' is before the first texture coordinates");
    make_file("bad.obj", "vt\n" SQUARE);
    expect_words(run("$tf remesh bad.obj -o out.obj -e 1").err,
                 "bad.obj:1: the line ends too early; texture coordinates are "
                 "vt u v");
    // Nothing else reads them.
    ck_assert_int_eq(run("$tf check bad.obj").status, 0);
}
END_TEST

// What is not perfect ---------------------------------------------------------

#define CUBE                                                                   \
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\n"          \
    "v 0 1 1\nf 1 3 2\nf 1 4 3\nf 5 6 7\nf 5 7 8\nf 1 2 6\nf 1 6 5\n"          \
    "f 2 3 7\nf 2 7 6\nf 3 4 8\nf 3 8 7\nf 4 1 5\nf 4 5 8\n"

/// Another cube, of vertices 9 to 15, on the vertex 7 of that.
#define CUBE_BEYOND                                                            \
    "v 2 1 1\nv 2 2 1\nv 1 2 1\nv 1 1 2\nv 2 1 2\nv 2 2 2\nv 1 2 2\n"          \
    "f 7 10 9\nf 7 11 10\nf 12 13 14\nf 12 14 15\nf 7 9 13\n"                  \
    "f 7 13 12\nf 9 10 14\nf 9 14 13\nf 10 11 15\nf 10 15 14\n"                \
    "f 11 7 12\nf 11 12 15\n"

/// Three edges that pierce the cube are a triangle.
#define NEEDLE "v .2 .3 -1\nv .2 .4 2\nv .5 .3 -1\nf 9 10 11\n"

static const struct {
    const char *what, *text, *told, *reported;
} imperfect[] = {
    {"a vertex of two cubes", CUBE CUBE_BEYOND,
     "tanglefree: bad.obj:7: the triangles at vertex 7 form more than one ring "
     "or fan; give each a vertex of its own\n"
     "tanglefree: bad.obj: 1 of 15 vertices and 0 of 24 triangles are left "
     "alone because of that\n",
     "nonmanifold vertices: 1\n"},
    {"three sheets on an edge",
     "v 0 0 0\nv 0 0 1\nv 1 0 0\nv 1 0 1\nv 0 1 0\nv 0 1 1\nv -1 -1 0\n"
     "v -1 -1 1\nf 1 3 4\nf 1 4 2\nf 1 5 6\nf 1 6 2\nf 1 7 8\nf 1 8 2\n",
     "tanglefree: bad.obj:10: another triangle passes the edge from vertex 2 "
     "to "
     "1 in the same direction; orient them consistently, or divide the surface "
     "there\n"
     "tanglefree: bad.obj: 2 of 8 vertices and 0 of 6 triangles are left alone "
     "because of that\n",
     "nonmanifold edges: 1\n"},
    {"a collinear triangle", CUBE "v 5 5 5\nv 6 6 6\nv 7 7 7\nf 9 10 11\n",
     "tanglefree: bad.obj:24: the corners of this triangle are on one line; "
     "remove it, or move a corner off\n"
     "tanglefree: bad.obj: 3 of 11 vertices and 1 of 13 triangles are left "
     "alone because of that\n",
     "left alone: 1\nnonmanifold edges: 0\nnonmanifold vertices: 0\n"
     "collinear triangles: 1\nintersections: 0\n"},
    {"a triangle turned over",
     "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\n"
     "f 1 2 3\nf 1 4 3\nf 2 5 3\n",
     "tanglefree: bad.obj: 1 triangle is turned over, as its neighbors are\n",
     "turned: 1\nleft alone: 0\n"},
    {"a triangle twice", CUBE "f 1 3 2\n",
     "tanglefree: bad.obj:9: another triangle passes the edge from vertex 1 to "
     "3 in the same direction; orient them consistently, or divide the surface "
     "there\n",
     "left alone: 2\nnonmanifold edges: 3\n"},
    {"a band with one side",
     "v 0 0 0\nv 1 1 1\nv 2 4 8\nv 3 9 27\nv 4 16 64\n"
     "f 1 2 3\nf 3 2 4\nf 3 4 5\nf 5 4 1\nf 5 1 2\n",
     "tanglefree: bad.obj:6: another triangle passes the edge from vertex 1 to "
     "2 in the same direction; orient them consistently, or divide the surface "
     "there\n"
     "tanglefree: bad.obj: 2 of 5 vertices and 0 of 5 triangles are left alone "
     "because of that\n",
     "turned: 0\nleft alone: 0\nnonmanifold edges: 1\n"},
    {"edges of no triangle", CUBE "v 5 5 5\nv 6 5 5\nl 9 10\nl 10 7\n",
     "tanglefree: bad.obj:23: 2 edges of no triangle, from here on, are left "
     "out\n",
     "left alone: 0\n"},
    {"triangles that cross", CUBE NEEDLE,
     "tanglefree: bad.obj: edge 8 9 passes through triangle 0 2 3 (numbered "
     "from 0); move them apart\n",
     "collinear triangles: 0\nintersections: 5\n"},
};

// Nothing meets that did not, so the numbers of intersections are the same.
START_TEST(what_is_not_perfect_is_left_alone)
{
    make_file("bad.obj", imperfect[_i].text);
    outcome found = run("$tf remesh bad.obj -o out.obj -e 0.3");
    ck_assert_msg(found.status == 0, "%s: %s", imperfect[_i].what, found.err);
    expect_words(found.err, imperfect[_i].told);
    expect_words(found.out, imperfect[_i].reported);
    ck_assert_int_gt(occurrences(file_text("out.obj"), "f "), 20);
    ck_assert_int_eq(
        run("for i in bad out; do $tf check $i.obj 2>/dev/null | wc -l >$i; "
            "done; cmp bad out")
            .status,
        0);
    found = run("$tf remesh bad.obj -o strict.obj -e 0.3 --strict");
    ck_assert_int_eq(found.status, 2);
    ck_assert_int_eq(occurrences(found.err, "tanglefree:"), 1);
    ck_assert_int_eq(run("test -e strict.obj").status, 1);
}
END_TEST

START_TEST(defects_of_a_kind_are_named_up_to_twenty)
{
    char text[3000] = SQUARE;
    size_t length = strlen(text);
    for (int i = 10; i < 40; i++)
        length += (size_t)snprintf(text + length, sizeof text - length,
                                   "v %d 0 0\nv %d 1 0\nv %d 2 0\nf -1 -2 -3\n",
                                   i, i, i);
    make_file("bad.obj", text);
    outcome found = run("$tf remesh bad.obj -o out.obj -e 0.3");
    ck_assert_int_eq(found.status, 0);
    ck_assert_int_eq(occurrences(found.err, "are on one line"), 20);
    expect_words(found.err, "tanglefree: bad.obj: 10 more like these\n");
    expect_words(found.out, "collinear triangles: 30\n");
}
END_TEST

// Its origins are in the triangles as they are turned.
START_TEST(a_turned_triangle_carries_over_what_vertices_have)
{
    make_file("turned.obj",
              "v 0 0 0 0 0 0\nv 1 0 0 1 0 0\nv 1 1 0 1 1 0\nv 0 1 0 0 1 0\n"
              "v 2 0 0 2 0 0\nf 1 2 3\nf 1 4 3\nf 2 5 3\n");
    ck_assert_int_eq(run("$tf remesh turned.obj -o out.obj -e 0.3").status, 0);
    const char *row = file_text("out.obj");
    int vertices = 0, read;
    double x[6];
    for (; *row == 'v'; row += read, vertices++) {
        ck_assert_int_eq(sscanf(row, "v %lf %lf %lf %lf %lf %lf\n%n", &x[0],
                                &x[1], &x[2], &x[3], &x[4], &x[5], &read),
                         6);
        ck_assert_double_eq_tol(x[3], x[0], 1e-14);
        ck_assert_double_eq_tol(x[4], x[1], 1e-14);
    }
    ck_assert_int_gt(vertices, 15);
}
END_TEST

START_TEST(a_mesh_that_intersects_is_refused)
{
    expect(run("$tf remesh crossed -o made -e 1 --strict"), 2, "",
           "tanglefree: crossed: edge 3 4 passes through triangle 0 1 2 "
           "(numbered from 0); move them apart, see 'tanglefree check' for all "
           "such pairs\n");
    ck_assert_int_eq(run("test -e made").status, 1);
}
END_TEST

START_TEST(what_cannot_be_written_is_named)
{
    outcome found = run("$tf remesh square.obj -o no/out -e 1");
    ck_assert_int_eq(found.status, 2);
    expect_words(found.err, "tanglefree: no/out: there is no folder 'no'; ");
}
END_TEST

START_TEST(edges_of_the_wrong_scale_are_refused)
{
    outcome found = run("$tf remesh square.obj -o short -e 1e-9");
    ck_assert_int_eq(found.status, 2);
    expect_words(found.err, "tanglefree: square.obj: --edge 1e-09 would take "
                            "too many triangles; give a longer one");
    ck_assert_int_eq(run("test -e short").status, 1);
}
END_TEST

START_TEST(bad_arguments_are_refused)
{
    expect_usage("remesh -o out -e 1", "tanglefree remesh: one file is req");
    expect_usage("remesh a b -o out -e 1", "tanglefree remesh: one file is");
    expect_usage("remesh square.obj -e 1",
                 "tanglefree remesh: --output OUT is required: where to write "
                 "the new mesh\n");
    expect_usage("remesh square.obj -o out",
                 "tanglefree remesh: --edge L, --lengths FILE or --error D is "
                 "required: how long edges should be\n");
    expect_usage(
        "remesh square.obj -o out -e 0",
        "tanglefree remesh: --edge must be a number above 0, got '0'\n");
    expect_usage(
        "remesh square.obj -o out -e x",
        "tanglefree remesh: --edge must be a number above 0, got 'x'\n");
    expect_usage("remesh square.obj -o out -e 1 --rounds 0",
                 "tanglefree remesh: --rounds must be a whole number from 1 to "
                 "1000, got '0'\n");
    expect_usage("remesh square.obj -o out -e 1 --rounds 1.5",
                 "tanglefree remesh: --rounds must be a whole number from 1 to "
                 "1000, got '1.5'\n");
    expect_usage("remesh square.obj --write out -e 1",
                 "tanglefree remesh: --write is an old spelling; write "
                 "--output\n");
    expect_usage(
        "remesh square.obj -o out -e 1 --output summary",
        "tanglefree remesh: --output summary is an old spelling; write "
        "--format summary, or ./summary for a file of that name\n");
    expect_usage(
        "remesh square.obj -o out -e 1 --format xml",
        "tanglefree remesh: --format must be csv, json or summary, got "
        "'xml'\n");
}
END_TEST

static int run_remesh(int argc, char *argv[])
{
    return tf_command_run(&tf_remesh_command, argc, argv);
}

START_TEST(a_broken_environment_is_refused)
{
    const char *const arguments[] = {
        "tanglefree remesh", "square.obj", "-o", "out", "-e", "1", NULL};
    outcome found = run_broken(_i, run_remesh, arguments);
    ck_assert_int_eq(found.status, 2);
    expect_words(found.err, "floating-point environment");
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/remesh_command");
    TCase *tcase = tcase_create("command");
    tcase_add_checked_fixture(tcase, enter_folder_with_files, leave_folder);
    tcase_add_test(tcase, a_mesh_is_remeshed);
    tcase_add_test(tcase, a_mesh_goes_from_and_to_a_pipe);
    tcase_add_test(tcase, the_ending_chooses_the_format);
    tcase_add_test(tcase, what_new_triangles_lose_is_said);
    tcase_add_test(tcase, edges_are_kept);
    tcase_add_test(tcase, lengths_come_from_a_file);
    tcase_add_test(tcase, a_distance_is_kept);
    tcase_add_test(tcase, floats_of_stl_are_told);
    tcase_add_test(tcase, what_vertices_have_is_carried_over);
    tcase_add_test(tcase, colors_of_obj_are_carried_over);
    tcase_add_loop_test(tcase, materials_and_textures_keep_their_places, 0, 3);
    tcase_add_test(tcase, materials_meet_where_three_sheets_do);
    tcase_add_test(tcase, groups_keep_their_border);
    tcase_add_test(tcase, labels_of_faces_are_carried_over);
    tcase_add_test(tcase, texture_coordinates_that_are_missing_are_named);
    tcase_add_loop_test(tcase, what_is_not_perfect_is_left_alone, 0,
                        (int)(sizeof imperfect / sizeof *imperfect));
    tcase_add_test(tcase, defects_of_a_kind_are_named_up_to_twenty);
    tcase_add_test(tcase, a_turned_triangle_carries_over_what_vertices_have);
    tcase_add_test(tcase, a_mesh_that_intersects_is_refused);
    tcase_add_test(tcase, what_cannot_be_written_is_named);
    tcase_add_test(tcase, edges_of_the_wrong_scale_are_refused);
    tcase_add_test(tcase, bad_arguments_are_refused);
    tcase_add_loop_test(tcase, a_broken_environment_is_refused, 0,
                        environments());
    suite_add_tcase(suite, tcase);
    return suite;
}
