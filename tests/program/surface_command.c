// The commands detect and check, as a user runs them.

#include "program/command.h"

#include "base/status.h"
#include "support/environments.h"
#include "support/json.h"
#include "support/program.h"
#include "support/support.h"
#include "support/terminal.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Two points above a triangle.  The first falls through it at t = 1/2, the
// second at t = 1/4.
#define TRIANGLE "v -1 -1 0\nv 3 -1 0\nv -1 3 0\nf 1 2 3\n"
#define ABOVE TRIANGLE "v 0 0 1\nv 0.5 0.5 1\n"
#define BELOW TRIANGLE "v 0 0 -1\nv 0.5 0.5 -3\n"

// A point in the plane falls through an edge.
#define FLAT_ABOVE "v -1 0\nv 1 0\nv 0 1\nl 1 2\n"
#define FLAT_BELOW "v -1 0\nv 1 0\nv 0 -1\nl 1 2\n"

// Two triangles, 0 1 2 and 3 4 5, each of which has an edge that passes through
// the other; a vertex on the first, and an edge that ends on an edge of it.
#define CLEAR TRIANGLE "v 9 9 9\n"
#define CROSSED                                                                \
    TRIANGLE "v 0 0 -1\nv 0 0 1\nv -9 0 0\nf 4 5 6\nv 0.5 0.5 0\n"             \
             "v 1 -2 0\nv 1 -1 0\nl 8 9\n"

#define HEADER "step,kind,a,b,c,d,toi_lo,toi_hi,nx,ny,nz,normal_velocity,case\n"
#define CHECK_HEADER "file,kind,a,b,c,d,e,f\n"

static void enter_folder_with_files(void)
{
    enter_folder();
    make_file("above", ABOVE);
    make_file("below", BELOW);
    make_file("flat-above", FLAT_ABOVE);
    make_file("flat-below", FLAT_BELOW);
    make_file("clear", CLEAR);
    make_file("crossed", CROSSED);
}

// Contacts --------------------------------------------------------------------

/// Expects a row to begin so, and to have this time; returns what follows it.
static const char *expect_row_within(double within, const char *text,
                                     const char *beginning, double time)
{
    ck_assert_msg(strncmp(text, beginning, strlen(beginning)) == 0,
                  "'%s' does not begin with '%s'", text, beginning);
    double lo, hi;
    ck_assert_int_eq(sscanf(text + strlen(beginning), ",%lf,%lf,", &lo, &hi),
                     2);
    ck_assert_msg(lo <= time && time <= hi && hi - lo <= within, "[%a, %a]", lo,
                  hi);
    const char *end = strchr(text, '\n');
    ck_assert_ptr_nonnull(end);
    return end + 1;
}

static const char *expect_row(const char *text, const char *beginning,
                              double time)
{
    return expect_row_within(0x1p-50, text, beginning, time);
}

START_TEST(contacts_of_a_step_are_printed)
{
    outcome found = run("$tf detect above below");
    const char *at = found.out;
    ck_assert_int_eq(strncmp(at, HEADER, strlen(HEADER)), 0);
    at = expect_row(at + strlen(HEADER), "0,point-triangle,3,0,1,2", 0.5);
    at = expect_row(at, "0,point-triangle,4,0,1,2", 0.25);
    ck_assert_str_eq(at, "");
    ck_assert_str_eq(found.err, "");
    ck_assert_int_eq(found.status, 1);
    // The normal is that of the triangle, up to its sign.
    ck_assert(strstr(found.out, ",0,0,1,-2,touching\n") ||
              strstr(found.out, ",0,0,-1,2,touching\n"));
}
END_TEST

START_TEST(contacts_of_the_plane_are_printed)
{
    outcome found = run("$tf detect flat-above flat-below");
    const char *at = found.out;
    ck_assert_int_eq(strncmp(at, HEADER, strlen(HEADER)), 0);
    at = expect_row(at + strlen(HEADER), "0,point-edge,2,0,1,", 0.5);
    ck_assert_str_eq(at, "");
    ck_assert(strstr(found.out, ",0,1,,-2,touching\n") ||
              strstr(found.out, ",0,-1,,2,touching\n"));
    ck_assert_str_eq(found.err, "");
    ck_assert_int_eq(found.status, 1);
}
END_TEST

START_TEST(a_clear_step_has_no_rows)
{
    expect(run("$tf detect above above"), 0, HEADER, "");
    expect(run("$tf detect above above above"), 0, HEADER, "");
    expect(run("$tf detect flat-below flat-below"), 0, HEADER, "");
    expect(run("$tf detect above above --format summary | head -n 3"), 0,
           "steps: 1\nsteps with contacts: 0\ncontacts: 0\n", "");
}
END_TEST

START_TEST(steps_are_counted_through)
{
    outcome found = run("$tf detect above above below below above");
    const char *at = found.out + strlen(HEADER);
    at = expect_row(at, "1,point-triangle,3,0,1,2", 0.5);
    at = expect_row(at, "1,point-triangle,4,0,1,2", 0.25);
    at = expect_row(at, "3,point-triangle,3,0,1,2", 0.5);
    at = expect_row(at, "3,point-triangle,4,0,1,2", 0.75);
    ck_assert_str_eq(at, "");
    ck_assert_int_eq(found.status, 1);
    expect(run("$tf detect above above below below above --format summary | "
               "head -n 3"),
           0, "steps: 4\nsteps with contacts: 2\ncontacts: 4\n", "");
}
END_TEST

START_TEST(first_prints_the_first_contact_of_each_step)
{
    static const char *const options[] = {"--first", "--firs", "--first -t 1"};
    for (int i = 0; i < 3; i++) {
        outcome found = run("$tf detect %s above below above", options[i]);
        const char *at = found.out + strlen(HEADER);
        at = expect_row(at, "0,point-triangle,4,0,1,2", 0.25);
        at = expect_row(at, "1,point-triangle,3,0,1,2", 0.5);
        ck_assert_str_eq(at, "");
        ck_assert_int_eq(found.status, 1);
    }
}
END_TEST

START_TEST(json_of_contacts_has_a_summary)
{
    outcome found = run("$tf detect --format json above below above");
    ck_assert_msg(!json_fault(found.out), "%s", json_fault(found.out));
    ck_assert_int_eq(occurrences(found.out, "\n{\"step\":"), 4);
    expect_words(found.out, "{\"contacts\":[\n{\"step\":0,\"kind\":\"point-"
                            "triangle\",\"a\":3,\"b\":0,\"c\":1,\"d\":2,");
    expect_words(found.out, "\n],\n\"summary\":{\"steps\":2,\"steps_with_"
                            "contacts\":2,\"contacts\":4,\"candidates\":4,");
    ck_assert_int_eq(found.status, 1);
    found = run("$tf detect --format json above above");
    ck_assert_msg(!json_fault(found.out), "%s", json_fault(found.out));
    expect_words(found.out, "{\"contacts\":[\n],\n\"summary\":{\"steps\":1,");
    ck_assert_int_eq(found.status, 0);
    found = run("$tf detect --format json flat-above flat-below");
    ck_assert_msg(!json_fault(found.out), "%s", json_fault(found.out));
    expect_words(found.out, "\"c\":1,\"d\":null,");
}
END_TEST

START_TEST(every_arithmetic_finds_the_contact)
{
    static const char *const names[] = {"exact",     "clamped",   "report",
                                        "perturbed", "integer64", "integer128"};
    make_file("a", TRIANGLE "v 0 0 1\n");
    make_file("b", TRIANGLE "v 0 0 -1\n");
    for (int i = 0; i < 6; i++) {
        outcome found = run("$tf detect -a %s a b", names[i]);
        const char *at = found.out + strlen(HEADER);
        // What is rounded has wider bounds.
        at = expect_row_within(1e-14, at, "0,point-triangle,3,0,1,2", 0.5);
        ck_assert_str_eq(at, "");
        ck_assert_str_eq(found.err, "");
        ck_assert_int_eq(found.status, 1);
    }
}
END_TEST

// Many contacts ---------------------------------------------------------------

/// A soup of triangles that tumble, in files.
static void make_soup(const char *const names[], int files)
{
    enum {
        TRIANGLES = 120
    };
    generator random = generator_new(1);
    double center[TRIANGLES][3], corner[TRIANGLES][9];
    for (int t = 0; t < TRIANGLES; t++)
        for (int k = 0; k < 9; k++) {
            center[t][k % 3] = uniform(&random, 0, 4);
            corner[t][k] = uniform(&random, -1, 1);
        }
    for (int f = 0; f < files; f++) {
        FILE *file = fopen(names[f], "w");
        for (int t = 0; t < TRIANGLES; t++) {
            for (int c = 0; c < 9; c += 3)
                fprintf(file, "v %a %a %a\n", center[t][0] + corner[t][c],
                        center[t][1] + corner[t][c + 1],
                        center[t][2] + corner[t][c + 2]);
            for (int k = 0; k < 9; k++)
                corner[t][k] += uniform(&random, -1, 1);
        }
        for (int t = 0; t < TRIANGLES; t++)
            fprintf(file, "f %d %d %d\n", 3 * t + 3, 3 * t + 1, 3 * t + 2);
        fclose(file);
    }
}

static const char *const soup[] = {"soup-0", "soup-1", "soup-2", "soup-3"};

START_TEST(threads_change_nothing)
{
    make_soup(soup, 4);
    static const char *const commands[] = {
        "detect soup-?",
        "detect --format json soup-?",
        "detect --first soup-?",
        "detect --format summary soup-?",
        "check soup-? clear",
        "check --format json soup-? clear",
        "check --format summary soup-? clear",
        "check --each soup-?"};
    for (int i = 0; i < 8; i++) {
        outcome found = run(
            "$tf %s -t 1 >one; status=$?; for t in 2 3 8 256; do $tf %s -t $t "
            "| cmp - one || exit 9; done; $tf %s | cmp - one && exit $status",
            commands[i], commands[i], commands[i]);
        expect(found, 1, "", "");
    }
}
END_TEST

/// A row of either command, as numbers; -1 where there is none.
typedef struct row {
    int step, kind, vertex[6];
} row;

static const char *read_row(const char *line, int vertices,
                            const char *const kinds[], row *read)
{
    char kind[20];
    *read = (row){.step = 0, .kind = -1};
    ck_assert_int_eq(sscanf(line, "%d,%19[a-z-]", &read->step, kind), 2);
    for (int i = 0; i < 3; i++)
        if (strcmp(kind, kinds[i]) == 0)
            read->kind = i;
    ck_assert_int_ge(read->kind, 0);
    const char *at = strchr(strchr(line, ',') + 1, ',') + 1;
    for (int i = 0; i < vertices; i++) {
        read->vertex[i] = *at == ',' || *at == '\n' ? -1 : atoi(at);
        at += strcspn(at, ",\n") + 1;
    }
    return strchr(line, '\n') + 1;
}

static int compare_rows(const row *a, const row *b)
{
    if (a->step != b->step)
        return a->step < b->step ? -1 : 1;
    if (a->kind != b->kind)
        return a->kind < b->kind ? -1 : 1;
    for (int i = 0; i < 6; i++)
        if (a->vertex[i] != b->vertex[i])
            return a->vertex[i] < b->vertex[i] ? -1 : 1;
    return 0;
}

static void expect_sorted(const char *text, int vertices,
                          const char *const kinds[], row *last,
                          bool (*good)(const row *))
{
    int count = 0;
    row own, before = {-1, -1, {0}};
    for (const char *at = strchr(text, '\n') + 1; *at; count++) {
        at = read_row(at, vertices, kinds, &own);
        ck_assert_msg(compare_rows(&before, &own) < 0, "row %d", count);
        ck_assert_msg(good(&own), "row %d", count);
        before = own;
    }
    ck_assert_int_gt(count, 100);
    *last = before;
}

static bool is_contact(const row *own)
{
    const int *v = own->vertex;
    return own->kind == 1 ? v[1] < v[2] && v[2] < v[3]
                          : v[0] < v[1] && v[2] < v[3] && v[0] < v[2];
}

static bool is_crossing(const row *own)
{
    const int *v = own->vertex;
    return own->kind == 0 && v[0] < v[1] && v[2] < v[3] && v[3] < v[4] &&
           v[5] == -1;
}

START_TEST(rows_are_sorted)
{
    static const char *const contacts[] = {"point-edge", "point-triangle",
                                           "edge-edge"};
    static const char *const crossings[] = {"edge-triangle", "point-triangle",
                                            "edge-edge"};
    make_soup(soup, 4);
    row last;
    expect_sorted(run("$tf detect soup-?").out, 4, contacts, &last, is_contact);
    ck_assert(last.step == 2 && last.kind == 2);
    expect_sorted(run("$tf check --each soup-? | sed s/soup-//").out, 6,
                  crossings, &last, is_crossing);
    ck_assert(last.step == 3);
}
END_TEST

// Intersections ---------------------------------------------------------------

START_TEST(intersections_are_printed)
{
    expect(run("$tf check crossed"), 1,
           CHECK_HEADER "crossed,edge-triangle,0,2,3,4,5,\n"
                        "crossed,edge-triangle,3,4,0,1,2,\n"
                        "crossed,point-triangle,6,0,1,2,,\n"
                        "crossed,point-triangle,8,0,1,2,,\n"
                        "crossed,edge-edge,0,1,7,8,,\n",
           "");
}
END_TEST

START_TEST(surfaces_free_of_intersections_have_no_rows)
{
    expect(run("$tf check clear"), 0, CHECK_HEADER, "");
    expect(run("$tf check --each clear above flat-above"), 0, CHECK_HEADER, "");
    expect(run("$tf check --each --format summary clear above"), 0,
           "files: 2\nfiles with intersections: 0\nintersections: 0\n", "");
}
END_TEST

START_TEST(intersections_of_curves_are_printed)
{
    make_file("curve", "v 0 0\nv 2 2\nv 0 2\nv 2 0\nl 1 2 3 4\n");
    expect(run("$tf check --each curve clear"), 1,
           CHECK_HEADER "curve,edge-edge,0,1,2,3,,\n", "");
}
END_TEST

START_TEST(near_pairs_are_printed)
{
    make_file("near", TRIANGLE "v 0 0 0.5\nv 1 0 1\nl 4 5\n");
    expect(run("$tf check --thickness 0.5 near"), 0, CHECK_HEADER, "");
    expect(run("$tf check --thickness 0.6 near"), 1,
           CHECK_HEADER "near,near-point-triangle,3,0,1,2,,\n", "");
    make_file("flat-near", "v -1 0\nv 1 0\nv 0 1\nv 5 1\nl 1 2\nl 3 4\n");
    expect(run("$tf check --thickness 1.3 flat-near"), 1,
           CHECK_HEADER "flat-near,near-point-edge,1,2,3,,,\n"
                        "flat-near,near-point-edge,2,0,1,,,\n",
           "");
    expect(run("$tf check --thickness 0.1 --format summary --each crossed "
               "near"),
           1,
           "files: 2\nfiles with rows: 1\nintersections: 5\n"
           "near pairs: 3\n",
           "");
    expect_usage("check --thickness 0 near",
                 "tanglefree check: --thickness must be above 0, got '0'");
}
END_TEST

START_TEST(several_files_are_checked_each_alone)
{
    expect(run("$tf check --each clear crossed clear crossed --format "
               "summary"),
           1, "files: 4\nfiles with intersections: 2\nintersections: 10\n", "");
    outcome found = run("cp crossed 'a,\"b'; $tf check --each clear 'a,\"b'");
    ck_assert_int_eq(occurrences(found.out, "\n\"a,\"\"b\",edge-triangle,3,4,"),
                     1);
    ck_assert_int_eq(found.status, 1);
}
END_TEST

#define JOINED_HEADER "file,kind,a,b,c,d,e,f,other_file\n"

// A point rests upon the triangle of `clear`, and an edge passes through it; in
// `below-it` nothing does.
#define UPON "v 9 9 8\nv 0 0 0\nv 0.5 0.2 1\nv 0.5 0.2 -1\nl 4 3\nl 2 1\n"

START_TEST(several_files_are_checked_against_each_other)
{
    make_file("upon", UPON);
    make_file("below-it", "v 0 0 -1\nv 1 1 -1\nl 1 2\n");
    expect(run("$tf check clear upon"), 1,
           JOINED_HEADER "upon,edge-triangle,2,3,0,1,2,,clear\n"
                         "upon,point-triangle,1,0,1,2,,,clear\n",
           "");
    expect(run("$tf check upon clear"), 1,
           JOINED_HEADER "upon,edge-triangle,2,3,0,1,2,,clear\n"
                         "upon,point-triangle,1,0,1,2,,,clear\n",
           "");
    expect(run("$tf check clear below-it"), 0, JOINED_HEADER, "");
    expect(run("$tf check --format summary clear below-it upon"), 1,
           "files: 3\nfiles with intersections: 2\nintersections: 2\n", "");
    outcome found = run("$tf check --format json clear upon");
    ck_assert_msg(!json_fault(found.out), "%s", json_fault(found.out));
    expect_words(found.out,
                 "{\"intersections\":[\n{\"file\":\"upon\",\"kind\":\"edge-"
                 "triangle\",\"a\":2,\"b\":3,\"c\":0,\"d\":1,\"e\":2,"
                 "\"other_file\":\"clear\"},\n");
    expect_words(found.out, "\"summary\":{\"files\":2,\"files_with_"
                            "intersections\":2,\"intersections\":2}}\n");
    expect_words(run("$tf check crossed crossed").out,
                 "\ncrossed,edge-triangle,0,2,3,4,5,,crossed\n");
}
END_TEST

START_TEST(near_pairs_of_several_files_are_printed)
{
    make_file("near", "v 0 0 0.5\nv 0 0 9\nl 1 2\n");
    expect(run("$tf check --thickness 0.5 clear near"), 0, JOINED_HEADER, "");
    expect(run("$tf check --thickness 0.6 clear near"), 1,
           JOINED_HEADER "near,near-point-triangle,0,0,1,2,,,clear\n", "");
    expect(run("$tf check --thickness 0.6 --each clear near"), 0, CHECK_HEADER,
           "");
    expect(run("$tf check --thickness 0.6 --format summary clear near"), 1,
           "files: 2\nfiles with rows: 2\nintersections: 0\nnear pairs: 1\n",
           "");
}
END_TEST

START_TEST(json_of_intersections_has_a_summary)
{
    outcome found = run("$tf check --format json crossed");
    ck_assert_msg(!json_fault(found.out), "%s", json_fault(found.out));
    expect_words(found.out,
                 "{\"intersections\":[\n{\"file\":\"crossed\",\"kind\":\"edge-"
                 "triangle\",\"a\":0,\"b\":2,\"c\":3,\"d\":4,\"e\":5},\n");
    expect_words(found.out, "\"summary\":{\"files\":1,\"files_with_"
                            "intersections\":1,\"intersections\":5}}\n");
    ck_assert_int_eq(found.status, 1);
}
END_TEST

// Input -----------------------------------------------------------------------

START_TEST(standard_input_is_read)
{
    char right[10000];
    strcpy(right, run("$tf detect above below").out);
    expect(run("$tf detect - below <above"), 1, right, "");
    expect(run("cat below | $tf detect above -"), 1, right, "");
    expect(run("$tf check - <clear"), 0, CHECK_HEADER, "");
    outcome found = run("$tf check - <crossed");
    ck_assert_int_eq(found.status, 1);
    expect_words(found.out, "\nstandard input,edge-triangle,0,2,3,4,5,\n");
    expect(run("$tf detect - - <above"), 2, HEADER,
           "tanglefree: standard input: no vertices; the file must be a mesh "
           "in OBJ, PLY, STL, OFF or .msh\n");
    expect(run("$tf check - <&-"), 2, CHECK_HEADER,
           "tanglefree: standard input: cannot read: Bad file descriptor; "
           "check that this is a file\n");
}
END_TEST

START_TEST(ply_is_as_good)
{
    make_file("below.ply",
              "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\n"
              "property float y\nproperty float z\nelement face 1\n"
              "property list uchar int vertex_indices\nend_header\n"
              "-1 -1 0\n3 -1 0\n-1 3 0\n0 0 -1\n0.5 0.5 -3\n3 0 1 2\n");
    char right[10000];
    strcpy(right, run("$tf detect above below").out);
    expect(run("$tf detect above below.ply"), 1, right, "");
}
END_TEST

// The writer waits until the program, which has begun to count time, opens the
// pipe.
START_TEST(progress_is_shown_on_a_terminal)
{
    terminal screen = terminal_open();
    expect(run("mkfifo late; { exec 3>late; sleep 1.1; cat above >&3; } & "
               "$tf detect above above late above 2>%s",
               screen.name),
           0, HEADER, "");
    expect_progress(terminal_close(&screen), "\r2 steps");
}
END_TEST

// Bad input -------------------------------------------------------------------

/// Files that are bad, and what is told of them.
static const struct {
    const char *text, *message;
} faults[] = {
    {"", " no vertices; the file must be a mesh in OBJ, PLY, STL, OFF or .msh"},
    {"v 1 2 3\n", " no triangles and no edges; a mesh must have some"},
    {TRIANGLE "f 1 2 4\n",
     "5: there is no vertex 4; they are numbered from 1 to 3"},
    {TRIANGLE "f 1 2 1\n", "5: vertex 1 is a corner twice; delete the triangle "
                           "or edge, here and in all files"},
    {TRIANGLE "f 1 2 0\n", "5: '0' is not a corner; write the number of a "
                           "vertex, from 1, or vertex/texture/normal"},
    {TRIANGLE "v nan 0 0\n", "5: 'nan' is not a finite number; write a "
                             "decimal or a hexadecimal float"},
    {TRIANGLE "v 1 0\n", "5: a vertex without z; the vertices of triangles "
                         "must have three coordinates"},
    {"ply\nformat ascii 1.0\nelement vertex 9\nproperty float x\n"
     "property float y\nend_header\n0 0\n",
     "8: the file ends too early; it may be cut short, or the header declares "
     "too many elements"},
    {"ply\nformat binary_big_endian 1.0\nelement vertex 9\nproperty char x\n"
     "property char y\nend_header\n0",
     " byte 94: the file ends too early; it may be cut short, or the header "
     "declares too many elements"},
    {"ply\nformat binary_big_endian 1.0\nelement edge 1\nproperty int "
     "vertex1\nend_header\n....",
     "3: the edges have no ends; declare the properties int vertex1 and int "
     "vertex2"},
};

START_TEST(bad_files_are_refused)
{
    char right[1000], rows[10000];
    make_file("bad", faults[_i].text);
    snprintf(right, sizeof right, "tanglefree: bad:%s\n", faults[_i].message);
    expect(run("$tf check bad"), 2, CHECK_HEADER, right);
    expect(run("$tf detect bad above"), 2, HEADER, right);
    expect(run("$tf check --format summary bad"), 2, "", right);
    expect(run("$tf detect --format summary bad above"), 2, "", right);
    // The rows of what was good are out by then.
    strcpy(rows, run("$tf check crossed").out);
    expect(run("$tf check --each crossed bad crossed"), 2, rows, right);
    outcome found = run("$tf check --each --format json crossed bad");
    ck_assert_msg(!json_fault(found.out), "%s", json_fault(found.out));
    ck_assert_int_eq(found.status, 2);
}
END_TEST

START_TEST(good_steps_before_bad_files_are_printed)
{
    char rows[10000];
    strcpy(rows, run("$tf detect above below").out);
    make_file("bad", "v 1 2 x\n");
    expect(run("$tf detect above below bad above"), 2, rows,
           "tanglefree: bad:1: 'x' is not a finite number; write a decimal "
           "or a hexadecimal float\n");
    expect(run("$tf detect above below clear"), 2, rows,
           "tanglefree: clear: 4 vertices, but below has 5; "
           "all files must have the same elements\n");
    expect(run("$tf detect above below absent"), 2, rows,
           "tanglefree: absent: cannot open: No such file or directory; check "
           "the name\n");
    expect(run("$tf detect above below ."), 2, rows,
           "tanglefree: .: cannot read: Is a directory; check that this is a "
           "file\n");
    outcome found = run("$tf detect --format json above below bad");
    ck_assert_msg(!json_fault(found.out), "%s", json_fault(found.out));
    ck_assert_int_eq(occurrences(found.out, "\"step\":0"), 2);
    expect_words(found.out, "\"summary\":{\"steps\":1,");
    ck_assert_int_eq(found.status, 2);
}
END_TEST

START_TEST(other_elements_are_refused)
{
    make_file("other", "v -1 -1 0\nv 3 -1 0\nv -1 3 0\nv 0 0 1\nv 1 1 1\n"
                       "# the triangle\nf 2 3 1\n");
    expect(run("$tf detect above other"), 2, HEADER,
           "tanglefree: other:7: this triangle is not as in above; all files "
           "must have the same elements in the same order\n");
}
END_TEST

START_TEST(names_send_no_commands_to_the_terminal)
{
    make_file("a\x1b[2J", TRIANGLE);
    make_file("b\x1b[2J", TRIANGLE "v 1 2 3\n");
    expect(run("$tf detect a*J b*J"), 2, HEADER,
           "tanglefree: b\\x1b[2J: 4 vertices, but a\\x1b[2J has 3; all files "
           "must have the same elements\n");
    expect_words(run("$tf check --format \"$(printf '\\033c')\" clear").err,
                 "--format must be csv, json or summary, got '\\x1bc'");
    expect_words(run("$tf check -t \"$(printf '\\033c')\" clear").err,
                 "got '\\x1bc'");
}
END_TEST

START_TEST(coordinates_out_of_range_are_refused)
{
    static const char message[] =
        " is out of range: integer64 holds integers below 2^19 in absolute "
        "value; use --arithmetic exact\n";
    char right[1000];
    make_file("half", TRIANGLE "v 0 0 1\nv 0.5 0 2\n");
    make_file("large", TRIANGLE "v 0 0 1\nv 0 0 -524288\n");
    make_file("good", TRIANGLE "v 0 0 1\nv 0 0 -524287\n");
    snprintf(right, sizeof right, "tanglefree: half:6: the coordinate 0.5%s",
             message);
    expect(run("$tf detect -a integer64 half good"), 2, HEADER, right);
    expect(run("$tf detect -a integer64 half large"), 2, HEADER, right);
    snprintf(right, sizeof right,
             "tanglefree: large:6: the coordinate -524288%s", message);
    outcome found = run("$tf detect -a integer64 good good large");
    ck_assert_str_eq(found.err, right);
    ck_assert_int_eq(found.status, 2);
    ck_assert_int_eq(run("$tf detect -a integer64 good good").status, 0);
}
END_TEST

// Scenes ----------------------------------------------------------------------

#define SCENE_HEADER                                                           \
    "step,kind,a,b,c,d,toi_lo,toi_hi,nx,ny,nz,normal_velocity,case,mesh,"      \
    "other_mesh\n"
#define SCENE_CHECK_HEADER "frame,kind,a,b,c,d,e,f,mesh,other_mesh\n"

// A rod that falls through the triangle, whose other end stays above it.
static void enter_folder_with_scene(void)
{
    enter_folder_with_files();
    make_file("rod-1", "v 0 0 9\nv 0 0 1\nl 1 2\n");
    make_file("rod-2", "v 0 0 9\nv 0 0 -1\nl 1 2\n");
    make_file("rod-3", "v 0 0 9\nv 0 0 -2\nl 1 2\n");
    make_file("scene.yaml", "meshes:\n- {frames: clear, name: floor}\n"
                            "- {frames: rod-*}\n");
}

START_TEST(contacts_of_scenes_have_names)
{
    outcome found = run("$tf detect scene.yaml");
    ck_assert_int_eq(found.status, 1);

    expect_row_within(0x1p-50, found.out + strlen(SCENE_HEADER),
                      "0,point-triangle,1,0,1,2", 0.5);
    ck_assert_int_eq(strncmp(found.out, SCENE_HEADER, strlen(SCENE_HEADER)), 0);
    expect_words(found.out, ",touching,rod,floor\n");
    ck_assert_int_eq(occurrences(found.out, "\n"), 2);
    found = run("$tf detect scene.yaml --format json");
    ck_assert_msg(!json_fault(found.out), "%s", json_fault(found.out));
    expect_words(found.out, "\"mesh\":\"rod\",\"other_mesh\":\"floor\"}\n");
    expect_words(found.out, "\"summary\":{\"steps\":2,");
}
END_TEST

START_TEST(each_frame_of_a_scene_is_checked)
{
    expect(run("$tf check scene.yaml"), 1,
           SCENE_CHECK_HEADER "1,edge-triangle,0,1,0,1,2,,rod,floor\n"
                              "2,edge-triangle,0,1,0,1,2,,rod,floor\n",
           "");
    expect(run("$tf check --each scene.yaml"), 0, SCENE_CHECK_HEADER, "");
    expect(run("$tf check --format summary scene.yaml"), 1,
           "frames: 3\nframes with intersections: 2\nintersections: 2\n", "");
    expect(run("$tf check --thickness 1.5 scene.yaml | head -n 2"), 0,
           SCENE_CHECK_HEADER "0,near-point-triangle,1,0,1,2,,,rod,floor\n",
           "");
    outcome found = run("$tf check scene.yaml --format json");
    ck_assert_msg(!json_fault(found.out), "%s", json_fault(found.out));
    expect_words(found.out,
                 "{\"intersections\":[\n{\"frame\":1,\"kind\":\"edge-triangle"
                 "\",\"a\":0,\"b\":1,\"c\":0,\"d\":1,\"e\":2,\"mesh\":\"rod"
                 "\",\"other_mesh\":\"floor\"},\n");
    expect_words(found.out, "\"summary\":{\"frames\":3,\"frames_with_"
                            "intersections\":2,\"intersections\":2}}\n");
}
END_TEST

START_TEST(scenes_that_are_wrong_are_refused)
{
    make_file("rod-3", "v 0 0 9\nv 0 0 -2\nl 2 1\n");
    outcome found = run("$tf detect scene.yaml");
    ck_assert_str_eq(found.err,
                     "tanglefree: rod-3:3: this edge is not as in rod-2; all "
                     "files must have the same elements in the same order\n");
    ck_assert_int_eq(found.status, 2);
    ck_assert_int_eq(occurrences(found.out, "\n"), 2);
    expect(run("$tf detect scene.yaml -o rows; test -e rows"), 1, "",
           "tanglefree: rod-3:3: this edge is not as in rod-2; all files must "
           "have the same elements in the same order\n");
    make_file("wrong.yaml", "meshes:\n- frames: clear\n  rôle: fixed\n");
    expect(run("$tf check wrong.yaml"), 2, SCENE_CHECK_HEADER,
           "tanglefree: wrong.yaml:3: unknown key 'rôle'; a mesh has frames, "
           "and may have name, role, mass, friction, group, material and "
           "pinned\n");
    make_file("one.yml", "meshes: [{frames: clear}]");
    expect(run("$tf detect one.yml"), 2, SCENE_HEADER,
           "tanglefree: one.yml: has only one frame, so there is no step; give "
           "a mesh two frames or more\n");
    expect(run("$tf detect none.json"), 2, SCENE_HEADER,
           "tanglefree: none.json: cannot open: No such file or directory; "
           "check the name\n");
    expect_usage("detect scene.yaml clear",
                 "tanglefree detect: scene.yaml is a scene, which must be the "
                 "only operand; name the other files in it\n");
    expect_usage("check clear scene.yaml",
                 "tanglefree check: scene.yaml is a scene, which must be the "
                 "only operand; name the other files in it\n");
}
END_TEST

// A coordinate of the second mesh is no integer, in the second frame.
START_TEST(coordinates_of_scenes_have_a_file)
{
    make_file("rod-2", "v 0 0 9\nv 0 0 -1.5\nl 1 2\n");
    outcome found = run("$tf detect -a integer64 scene.yaml");
    ck_assert_int_eq(found.status, 2);
    expect_words(found.err,
                 "tanglefree: rod-2:2: the coordinate -1.5 is out of "
                 "range: integer64");
}
END_TEST

START_TEST(frames_are_taken_in_natural_order)
{
    outcome found =
        run("cp rod-3 rod-10; $tf detect rod-* --format summary | head -n 1");
    expect(found, 0, "steps: 3\n",
           "tanglefree: the frames from rod-1 to rod-10 are taken in the order "
           "of their numbers\ntanglefree: rod-10 follows rod-3; frames may be "
           "missing in between, but this is taken as one step\n");
    expect(run("$tf detect rod-1 rod-2 rod-3 rod-10 2>said >right; "
               "$tf detect rod-1 rod-10 rod-2 rod-3 2>more | cmp - right"),
           0, "", "");
    expect_words(run("$tf check rod-1 rod-2 rod-3").err,
                 "tanglefree: rod-1 and the other files are tested against "
                 "each other; --each tests each alone\n");
    expect(run("$tf check rod-1 rod-2 rod-3 --each && $tf check rod-1 clear"),
           0, CHECK_HEADER JOINED_HEADER, "");
    // The same rows in the order that is given, which is none.
    expect_words(run("$tf detect rod-3 rod-1 rod-2").err,
                 "tanglefree: rod-2 follows rod-1; the frames are taken in "
                 "this order, although their numbers are not in order\n");
}
END_TEST

// Output files ----------------------------------------------------------------

static const char *const writing[] = {"detect above below",
                                      "detect above above",
                                      "check clear crossed", "check clear"};

START_TEST(what_is_written_to_a_file_is_what_is_printed)
{
    static const char *const formats[] = {"csv", "json", "summary"};
    for (int i = 0; i < 12; i++) {
        char line[100];
        snprintf(line, sizeof line, "%s --format %s", writing[i / 3],
                 formats[i % 3]);
        expect(run("$tf %s >printed; a=$?; $tf %s -o written; b=$?; "
                   "$tf %s -o - | cmp - printed && cmp printed written && "
                   "test -s written -a $a = $b",
                   line, line, line),
               0, "", "");
    }
}
END_TEST

START_TEST(collections_are_written_besides_the_rows)
{
    outcome found = run("$tf detect above below above");
    char rows[2000];
    snprintf(rows, sizeof rows, "%s", found.out);
    expect(run("$tf detect above below above -o seen.pvd"), 1, rows, "");
    expect(run("ls seen.pvd seen | tr '\\n' ' '"), 0,
           "seen.pvd  seen: contacts-00000.vtp contacts-00001.vtp "
           "contacts-00002.vtp mesh-00000.vtp mesh-00001.vtp mesh-00002.vtp ",
           "");
    expect(run("grep -ahoE 'NumberOf(Points|Polys)=.[0-9]+' seen/*1.vtp"), 0,
           "NumberOfPoints=\"2\nNumberOfPolys=\"0\n"
           "NumberOfPoints=\"5\nNumberOfPolys=\"1\n",
           "");
    expect(run("$tf detect above above -o seen.pvd --format summary | head -n "
               "1; grep -c mesh seen.pvd"),
           0, "steps: 1\n2\n", "");
}
END_TEST

START_TEST(collections_that_cannot_be_written_are_named)
{
    make_file("taken", "before\n");
    expect(run("$tf detect above below -o taken.pvd"), 2, "",
           "tanglefree: taken: cannot make this folder: File exists; choose "
           "another with -o\n");
    expect(run("mkdir seen seen/contacts-00001.vtp; $tf detect above below -o "
               "seen.pvd >rows; echo $?; ls seen.pvd 2>/dev/null"),
           2, "2\n",
           "tanglefree: seen/contacts-00001.vtp: cannot write: Is a directory; "
           "mend that, and run again\n");
    expect_usage("check above -o seen.pvd",
                 "tanglefree check: --output must be a file for rows, got "
                 "'seen.pvd'; only detect and resolve write collections for "
                 "ParaView\n");
}
END_TEST

START_TEST(exit_codes_are_the_same_with_a_file)
{
    static const int status[] = {1, 0, 1, 0};
    for (int i = 0; i < 4; i++)
        expect(run("$tf %s --output=written", writing[i]), status[i], "", "");
}
END_TEST

START_TEST(a_file_appears_whole_or_not_at_all)
{
    make_file("bad", TRIANGLE "v x 0 0\n");
    for (int i = 0; i < 2; i++) {
        const char *command =
            i == 0 ? "detect above below bad" : "check crossed bad";
        ck_assert_int_eq(run("$tf %s -o new", command).status, 2);
        make_file("old", "before\n");
        outcome found = run("$tf %s -o old", command);
        ck_assert_int_eq(found.status, 2);
        ck_assert_str_eq(found.out, "");
        expect_words(found.err, "tanglefree: bad:5: 'x' is not a finite");
        ck_assert_str_eq(file_text("old"), "before\n");
        expect(run("ls -A | grep -e new -e tanglefree"), 1, "", "");
    }
}
END_TEST

START_TEST(a_file_that_is_read_may_be_written)
{
    make_file("both", CLEAR);
    expect(run("$tf check both -o both"), 0, "", "");
    ck_assert_str_eq(file_text("both"), CHECK_HEADER);
}
END_TEST

START_TEST(a_file_that_cannot_be_written_is_named)
{
    expect(run("$tf check clear -o no/rows"), 2, "",
           "tanglefree: no/rows: cannot write: No such file or directory; mend "
           "that, and run again\n");
    expect(run("$tf detect above below -o /dev/full"), 2, "",
           "tanglefree: /dev/full: cannot write: No space left on device; mend "
           "that, and run again\n");
}
END_TEST

// Output that cannot be written -----------------------------------------------

#define CANNOT_WRITE "tanglefree: standard output: cannot write: "

START_TEST(a_full_disk_is_reported)
{
    static const char *const formats[] = {"csv", "json", "summary"};
    for (int i = 0; i < 3; i++) {
        expect(run("$tf detect --format %s above below >/dev/full", formats[i]),
               2, "",
               CANNOT_WRITE
               "No space left on device; mend that, and run again\n");
        expect(run("$tf check --format %s clear >/dev/full", formats[i]), 2, "",
               CANNOT_WRITE
               "No space left on device; mend that, and run again\n");
    }
    expect(run("$tf detect --help >/dev/full"), 2, "",
           CANNOT_WRITE "No space left on device; mend that, and run again\n");
}
END_TEST

START_TEST(closed_standard_output_is_reported)
{
    expect(run("$tf detect above below >&-"), 2, "",
           CANNOT_WRITE "Bad file descriptor; mend that, and run again\n");
    expect(run("$tf check clear >&-"), 2, "",
           CANNOT_WRITE "Bad file descriptor; mend that, and run again\n");
    ck_assert_str_eq(file_text("clear"), CLEAR);
}
END_TEST

START_TEST(a_reader_that_leaves_ends_the_program)
{
    make_soup(soup, 4);
    expect(run("$tf detect soup-? | head -n 1"), 0, HEADER, "");
}
END_TEST

// Usage -----------------------------------------------------------------------

START_TEST(help_describes_the_commands)
{
    outcome found = run("$tf detect --help");
    ck_assert_int_eq(found.status, 0);
    ck_assert_str_eq(found.err, "");
    static const char *const words[] = {
        "Usage: tanglefree detect [OPTION...] START END [END...]",
        "--first",
        "--arithmetic=NAME",
        "--narrow-phase=NAME",
        "--format=FORMAT",
        "-o, --output=FILE",
        "Where to write; the default is -, which is",
        "--threads=NUMBER",
        "exact, clamped, report",
        "reference or vector",
        "csv, json or summary",
        "toi_lo",
        "Exit status"};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        expect_words(found.out, words[i]);
    found = run("$tf check --help");
    ck_assert_int_eq(found.status, 0);
    expect_words(found.out, "Usage: tanglefree check [OPTION...] FILE...");
    expect_words(found.out, "--threads=NUMBER");
    ck_assert_int_eq(occurrences(found.out, "--first"), 0);
    ck_assert_int_eq(occurrences(found.out, "--arithmetic"), 0);
}
END_TEST

START_TEST(old_spellings_are_refused)
{
    static const char *const words[] = {"csv", "json", "summary"};
    for (int i = 0; i < 3; i++) {
        char old[100], message[200];
        snprintf(message, sizeof message,
                 ": --output %s is an old spelling; write --format %s, or ./%s "
                 "for a file of that name\n",
                 words[i], words[i], words[i]);
        snprintf(old, sizeof old, "detect above below -o %s", words[i]);
        expect_words(run("$tf %s", old).err, message);
        snprintf(old, sizeof old, "check --output=%s clear", words[i]);
        expect_words(run("$tf %s", old).err, message);
        expect_usage(old, "tanglefree check: --output ");
    }
    expect_usage("detect -f above below",
                 "tanglefree detect: -f is an old spelling; write --first\n");
    expect_usage("detect -tf above below", "tanglefree detect: --threads must");
    expect_usage("detect -ft 1 above below", "tanglefree detect: -f is an old");
    ck_assert_int_eq(occurrences(run("$tf detect --usage").out, "[-f"), 0);
    ck_assert_int_eq(run("$tf check clear -o ./csv").status, 0);
    ck_assert_str_eq(file_text("csv"), CHECK_HEADER);
}
END_TEST

START_TEST(wrong_arguments_are_refused)
{
    static const char two[] = "tanglefree detect: two files or more are "
                              "required, START and END, or a scene, whose "
                              "name ends in .yaml, .yml or .json\n";
    expect_usage("detect", two);
    expect_usage("detect above", two);
    expect_usage("detect --first above", two);
    expect_usage("check", "tanglefree check: a file is required: its name, or "
                          "- for standard input\n");
    expect_usage("detect -a rounded above below",
                 "tanglefree detect: --arithmetic must be exact, clamped, "
                 "report, perturbed, integer64 or integer128, got 'rounded'\n");
    expect_usage("detect --narrow-phase=scalar above below",
                 "tanglefree detect: --narrow-phase must be reference or "
                 "vector, got 'scalar'\n");
    expect_usage(
        "detect --format xml above below",
        "tanglefree detect: --format must be csv, json or summary, got "
        "'xml'\n");
    expect_usage("check -a exact clear",
                 "tanglefree check: invalid option -- 'a'");
    expect_usage("check -n vector clear",
                 "tanglefree check: invalid option -- 'n'");
    expect_usage("check -f clear", "tanglefree check: invalid option -- 'f'");
    static const char *const threads[] = {
        "0", "-1", "257", "two", "1.5", "''", "9999999999999999999"};
    for (int i = 0; i < 7; i++) {
        char arguments[100], words[200];
        bool empty = *threads[i] == '\'';
        snprintf(arguments, sizeof arguments, "check -t %s clear", threads[i]);
        snprintf(words, sizeof words,
                 "tanglefree check: --threads must be an integer from 1 to "
                 "256, got '%s'\n",
                 empty ? "" : threads[i]);
        expect_usage(arguments, words);
    }
}
END_TEST

// A broken floating-point environment -----------------------------------------

static int run_detect(int argc, char *argv[])
{
    return tf_command_run(&tf_detect_command, argc, argv);
}

static int run_check(int argc, char *argv[])
{
    return tf_command_run(&tf_check_command, argc, argv);
}

START_TEST(a_broken_environment_is_reported)
{
    bool checks = _i % 2;
    static const char *const check[] = {"tanglefree", "above", NULL};
    static const char *const detect[] = {"tanglefree", "above", "below", NULL};
    char message[1000];
    snprintf(message, sizeof message, "tanglefree: %s: %s\n",
             checks ? "above" : "below", tf_status_message(TF_BAD_ENVIRONMENT));
    expect(run_broken(_i / 2, checks ? run_check : run_detect,
                      checks ? check : detect),
           2, checks ? CHECK_HEADER : HEADER, message);
}
END_TEST

static TCase *add_case(Suite *suite, const char *name)
{
    TCase *made = tcase_create(name);
    tcase_add_checked_fixture(made, enter_folder_with_files, leave_folder);
    suite_add_tcase(suite, made);
    return made;
}

Suite *suite(void)
{
    Suite *suite = suite_create("program/surface_command");
    TCase *contacts = add_case(suite, "contacts");
    tcase_add_test(contacts, contacts_of_a_step_are_printed);
    tcase_add_test(contacts, contacts_of_the_plane_are_printed);
    tcase_add_test(contacts, a_clear_step_has_no_rows);
    tcase_add_test(contacts, steps_are_counted_through);
    tcase_add_test(contacts, first_prints_the_first_contact_of_each_step);
    tcase_add_test(contacts, json_of_contacts_has_a_summary);
    tcase_add_test(contacts, every_arithmetic_finds_the_contact);

    TCase *many = add_case(suite, "many contacts");
    tcase_add_test(many, threads_change_nothing);
    tcase_add_test(many, rows_are_sorted);

    TCase *crossings = add_case(suite, "intersections");
    tcase_add_test(crossings, intersections_are_printed);
    tcase_add_test(crossings, surfaces_free_of_intersections_have_no_rows);
    tcase_add_test(crossings, intersections_of_curves_are_printed);
    tcase_add_test(crossings, near_pairs_are_printed);
    tcase_add_test(crossings, several_files_are_checked_each_alone);
    tcase_add_test(crossings, several_files_are_checked_against_each_other);
    tcase_add_test(crossings, near_pairs_of_several_files_are_printed);
    tcase_add_test(crossings, json_of_intersections_has_a_summary);

    TCase *input = add_case(suite, "input");
    tcase_add_test(input, standard_input_is_read);
    tcase_add_test(input, ply_is_as_good);
    tcase_add_test(input, progress_is_shown_on_a_terminal);

    TCase *bad = add_case(suite, "bad input");
    tcase_add_loop_test(bad, bad_files_are_refused, 0,
                        sizeof faults / sizeof *faults);
    tcase_add_test(bad, good_steps_before_bad_files_are_printed);
    tcase_add_test(bad, other_elements_are_refused);
    tcase_add_test(bad, names_send_no_commands_to_the_terminal);
    tcase_add_test(bad, coordinates_out_of_range_are_refused);

    TCase *scenes = tcase_create("scenes");
    tcase_add_checked_fixture(scenes, enter_folder_with_scene, leave_folder);
    tcase_add_test(scenes, contacts_of_scenes_have_names);
    tcase_add_test(scenes, each_frame_of_a_scene_is_checked);
    tcase_add_test(scenes, scenes_that_are_wrong_are_refused);
    tcase_add_test(scenes, coordinates_of_scenes_have_a_file);
    tcase_add_test(scenes, frames_are_taken_in_natural_order);
    suite_add_tcase(suite, scenes);

    TCase *unwritten = add_case(suite, "output that cannot be written");
    tcase_add_test(unwritten, what_is_written_to_a_file_is_what_is_printed);
    tcase_add_test(unwritten, collections_are_written_besides_the_rows);
    tcase_add_test(unwritten, collections_that_cannot_be_written_are_named);
    tcase_add_test(unwritten, exit_codes_are_the_same_with_a_file);
    tcase_add_test(unwritten, a_file_appears_whole_or_not_at_all);
    tcase_add_test(unwritten, a_file_that_is_read_may_be_written);
    tcase_add_test(unwritten, a_file_that_cannot_be_written_is_named);
    tcase_add_test(unwritten, a_full_disk_is_reported);
    tcase_add_test(unwritten, closed_standard_output_is_reported);
    tcase_add_test(unwritten, a_reader_that_leaves_ends_the_program);

    TCase *usage = add_case(suite, "usage");
    tcase_add_test(usage, help_describes_the_commands);
    tcase_add_test(usage, old_spellings_are_refused);
    tcase_add_test(usage, wrong_arguments_are_refused);

    TCase *environment = add_case(suite, "a broken environment");
    tcase_add_loop_test(environment, a_broken_environment_is_reported, 0,
                        2 * environments());
    return suite;
}
