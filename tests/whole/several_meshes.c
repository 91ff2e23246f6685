// A body and a cloth in files of their own, for 60 frames, are as the same
// meshes joined by hand: their contacts, their intersections, and what becomes
// of them when the steps are resolved.
#define _GNU_SOURCE // strsep, M_PI

#include "support/program.h"
#include "support/support.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    FRAMES = 60,
    AROUND = 10, ///< vertices of the body around its axis
    ALONG = 6,   ///< and rings of them
    SIDE = 11,   ///< vertices of the cloth along a side
    BODY = AROUND * ALONG,
    CLOTH = SIDE * SIDE
};

// The meshes ------------------------------------------------------------------

/// A body with a waist, closed by nothing, that turns and walks.
static void place_body(int frame, double x[BODY][3])
{
    for (int i = 0; i < BODY; i++) {
        double along = (double)(i / AROUND) / (ALONG - 1);
        double angle = 2 * M_PI * (i % AROUND) / AROUND + 0.03 * frame;
        double radius = 0.5 - 0.2 * sin(M_PI * along);
        x[i][0] = 2 * along - 1 + 0.2 * sin(0.1 * frame);
        x[i][1] = radius * cos(angle);
        x[i][2] = radius * sin(angle);
    }
}

/// A cloth that falls through the body and folds, as if nothing were there.
static void place_cloth(int frame, double x[CLOTH][3])
{
    for (int i = 0; i < CLOTH; i++) {
        double u = (double)(i / SIDE) / (SIDE - 1) - 0.5;
        double v = (double)(i % SIDE) / (SIDE - 1) - 0.5;
        double fold = 1 - 0.9 * frame / (FRAMES - 1);
        x[i][0] = 1.6 * u;
        x[i][1] = 1.6 * v * fold + 0.3 * (1 - fold) * sin(30 * v + u);
        x[i][2] = 0.6 - 0.02 * frame + 0.1 * (1 - fold) * cos(40 * v);
    }
}

static void write_vertices(FILE *file, int count, double x[][3])
{
    for (int i = 0; i < count; i++)
        fprintf(file, "v %.17g %.17g %.17g\n", x[i][0], x[i][1], x[i][2]);
}

/// The squares of a grid, whose columns meet if it is closed, from the vertex
/// `first` on.
static void write_grid(FILE *file, int rows, int columns, bool closed,
                       int first)
{
    for (int i = 0; i + 1 < rows; i++)
        for (int j = 0; j + !closed < columns; j++) {
            int a = first + i * columns + j;
            int b = first + i * columns + (j + 1) % columns;
            fprintf(file, "f %d %d %d\nf %d %d %d\n", a, b, a + columns, b,
                    b + columns, a + columns);
        }
}

/// Writes the body, the cloth or both of a frame.
static void write_meshes(const char *name, int frame, bool body, bool cloth)
{
    static double on_body[BODY][3], on_cloth[CLOTH][3];
    char path[50];
    snprintf(path, sizeof path, name, frame);
    FILE *file = fopen(path, "w");
    ck_assert_ptr_nonnull(file);
    place_body(frame, on_body);
    place_cloth(frame, on_cloth);
    if (body)
        write_vertices(file, BODY, on_body);
    if (cloth)
        write_vertices(file, CLOTH, on_cloth);
    if (body)
        write_grid(file, ALONG, AROUND, true, 1);
    if (cloth)
        write_grid(file, SIDE, SIDE, false, body ? 1 + BODY : 1);
    fclose(file);
}

#define SCENE                                                                  \
    "meshes:\n"                                                                \
    "- frames: body*.obj\n  role: scripted\n  friction: 0.1\n"                 \
    "- frames: cloth*.obj\n  mass: 0.25\n  friction: 0.4\n"

static void enter_folder_of_meshes(void)
{
    enter_folder();
    for (int i = 0; i < FRAMES; i++) {
        write_meshes("body%d.obj", i, true, false);
        write_meshes("cloth%d.obj", i, false, true);
        write_meshes("joined%d.obj", i, true, true);
    }
    make_file("scene.yaml", SCENE);
}

// Rows ------------------------------------------------------------------------

/// Gives a vertex of the joined mesh its own number, and appends it to a row
/// behind a comma.
static void append_vertex(char *row, const char *vertex, const char **mesh)
{
    int v = atoi(vertex);
    if (*vertex == '\0')
        strcat(row, ",");
    else
        sprintf(row + strlen(row), ",%d", v < BODY ? v : v - BODY);
    if (*vertex)
        *mesh = v < BODY ? "body" : "cloth";
}

/// Rewrites a row of the joined mesh as one of the scene: with own numbers, and
/// with the names of the meshes of both elements at its end.
/// @param vertices how many fields follow step and kind that are vertices
static void localize(char *row, int vertices, char right[500])
{
    const char *mesh[2] = {"", ""};
    char *field[20] = {row, row};
    int count = 0;
    for (char *at = row; at; count++)
        field[count] = strsep(&at, ",");
    bool point = strstr(field[1], "point-");
    sprintf(right, "%s,%s", field[0], field[1]);
    for (int i = 0; i < vertices; i++)
        append_vertex(right, field[2 + i], &mesh[i >= (point ? 1 : 2)]);
    for (int i = 2 + vertices; i < count; i++)
        sprintf(right + strlen(right), ",%s", field[i]);
    sprintf(right + strlen(right), ",%s,%s", mesh[0], mesh[1]);
}

/// Compares rows of the files "joined" and "scene".  Returns how many there are,
/// and how many of them are about both meshes.
static int compare(int vertices, int *between)
{
    FILE *joined = fopen("joined", "r"), *scene = fopen("scene", "r");
    char row[500], own[500], right[500];
    int rows = 0;
    *between = 0;
    while (fgets(row, sizeof row, joined)) {
        row[strcspn(row, "\n")] = '\0';
        ck_assert_ptr_nonnull(fgets(own, sizeof own, scene));
        own[strcspn(own, "\n")] = '\0';
        if (rows++ == 0)
            continue; // the names of the columns
        localize(row, vertices, right);
        ck_assert_str_eq(own, right);
        *between += strstr(own, ",body,cloth") || strstr(own, ",cloth,body");
    }
    ck_assert_ptr_null(fgets(own, sizeof own, scene));
    fclose(joined);
    fclose(scene);
    return rows - 1;
}

// Contacts and intersections --------------------------------------------------

START_TEST(contacts_are_those_of_the_joined_mesh)
{
    int between;
    outcome found = run("$tf detect joined*.obj >joined; a=$?; "
                        "$tf detect scene.yaml >scene; test $a = $?");
    expect(found, 0, "",
           "tanglefree: the frames from joined0.obj to joined59.obj are taken "
           "in the order of their numbers\n");
    int rows = compare(4, &between);
    ck_assert_msg(rows > 300 && between > 200 && rows - between > 50,
                  "%d rows, %d of both", rows, between);
}
END_TEST

START_TEST(intersections_are_those_of_the_joined_mesh)
{
    int between;
    expect(
        run("$tf check --each $(ls -v joined*.obj) | sed -E 's/^joined([0-9]+)"
            "\\.obj/\\1/' >joined; $tf check scene.yaml >scene"),
        1, "", "");
    int rows = compare(6, &between);
    ck_assert_msg(rows > 100 && between > 80, "%d rows, %d of both", rows,
                  between);
    expect(
        run("$tf check --each --thickness 0.05 $(ls -v joined*.obj) | sed -E "
            "'s/^joined([0-9]+)\\.obj/\\1/' >joined; "
            "$tf check --thickness 0.05 scene.yaml >scene"),
        1, "", "");
    ck_assert_int_gt(compare(6, &between), rows);
}
END_TEST

START_TEST(files_of_a_frame_are_as_their_scene)
{
    expect(run("for i in 0 9 30 59; do $tf check body$i.obj cloth$i.obj | "
               "tail -n +2 | cut -d , -f 2-8; done >files; "
               "$tf check scene.yaml | grep -E '^(0|9|30|59),' | "
               "cut -d , -f 2-8 >frames; cmp files frames && "
               "test $(wc -l <files) -gt 10"),
           0, "", "");
}
END_TEST

START_TEST(groups_and_each_leave_out_what_is_between)
{
    make_file("group.yaml", "meshes:\n- {frames: body*.obj, group: g}\n"
                            "- {frames: cloth*.obj, group: g}\n");
    expect(run("$tf detect scene.yaml | grep -v -e body,cloth -e cloth,body "
               ">right; $tf detect group.yaml | cmp - right; "
               "$tf check scene.yaml | grep -v -e body,cloth -e cloth,body "
               ">right; $tf check group.yaml | cmp - right && "
               "$tf check --each scene.yaml | cmp - right"),
           0, "", "");
}
END_TEST

// Responses -------------------------------------------------------------------

/// Writes what the scene says about vertices, for the joined mesh.
static void write_lists(void)
{
    FILE *fixed = fopen("fixed", "w"), *masses = fopen("masses", "w"),
         *friction = fopen("friction", "w");
    for (int v = 0; v < BODY + CLOTH; v++) {
        if (v < BODY)
            fprintf(fixed, "%d\n", v);
        fprintf(masses, "%.17g\n", v < BODY ? 1 : 0.25 / CLOTH);
        fprintf(friction, "%g\n", v < BODY ? 0.1 : 0.4);
    }
    fclose(fixed);
    fclose(masses);
    fclose(friction);
}

/// Expects that the cloth of frames that were resolved one by one is that of
/// the folder.
static void expect_same_cloth(const char *folder)
{
    expect(run("for i in $(seq 0 %d); do "
               "grep '^v' hand$i.obj | tail -n %d >right; "
               "grep '^v' %s/cloth-$(printf %%05d $i).obj | cmp - right || "
               "exit 7; done",
               FRAMES - 1, CLOTH, folder),
           0, "", "");
}

START_TEST(steps_are_resolved_one_after_another)
{
    write_lists();
    run("$tf resolve scene.yaml -o made >report; cp joined0.obj hand0.obj; "
        "for i in $(seq 1 %d); do $tf resolve hand$((i-1)).obj joined$i.obj -o "
        "hand$i.obj --fixed fixed --masses masses --vertex-friction friction "
        ">one || exit; done",
        FRAMES - 1);
    expect_same_cloth("made");
    expect_words(file_text("report"), "steps: 59\nresolved steps: ");
    expect(run("ls made | grep -v cloth"), 1, "", "");
    make_file("made.yaml", "meshes:\n- {frames: body*.obj, role: scripted}\n"
                           "- {frames: made/cloth*.obj}\n");
    expect(run("$tf detect made.yaml --format summary | head -n 3"), 0,
           "steps: 59\nsteps with contacts: 0\ncontacts: 0\n", "");
    expect(run("$tf detect scene.yaml --format summary | head -n 2 | grep -c "
               "' 0$'"),
           1, "0\n", "");
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("whole/several_meshes");
    TCase *rows = tcase_create("contacts and intersections");
    tcase_add_checked_fixture(rows, enter_folder_of_meshes, leave_folder);
    tcase_add_test(rows, contacts_are_those_of_the_joined_mesh);
    tcase_add_test(rows, intersections_are_those_of_the_joined_mesh);
    tcase_add_test(rows, files_of_a_frame_are_as_their_scene);
    tcase_add_test(rows, groups_and_each_leave_out_what_is_between);
    suite_add_tcase(suite, rows);

    TCase *responses = tcase_create("responses");
    tcase_add_checked_fixture(responses, enter_folder_of_meshes, leave_folder);
    tcase_add_test(responses, steps_are_resolved_one_after_another);
    suite_add_tcase(suite, responses);
    return suite;
}
