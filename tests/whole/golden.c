// What the library answered when the answers were filed: every field of every
// contact, to the last bit, with every arithmetic, of the queries in
// tests/queries.  The answers are beside them, in files that end in .golden.
// Where they are meant to change, make them anew and read the difference:
//
//     TF_GOLDEN=write build/tests/whole/golden && git diff tests/queries
#define _POSIX_C_SOURCE 200809L // strtok_r

#include "files/query_file.h"
#include "program/arithmetics.h"
#include "query/edge_edge.h"
#include "query/point_edge.h"
#include "query/point_triangle.h"
#include "support/support.h"

#include <stdlib.h>
#include <string.h>

typedef struct golden_file {
    const char *name, *kind;
} golden_file;

static const golden_file files[] = {
    {"point-edge", "point-edge"},
    {"point-triangle", "point-triangle"},
    {"edge-edge", "edge-edge"},
    {"witness", "point-triangle"},
    {"rare-point-edge", "point-edge"},
    {"rare-point-triangle", "point-triangle"},
    {"rare-edge-edge", "edge-edge"},
};

enum {
    FILES = sizeof files / sizeof *files,
    LINE = 1024
};

// Ask -------------------------------------------------------------------------

/// The second element lists its vertices as the file does, or backwards.
static tf_status ask(const tf_arithmetic *arithmetic, const tf_query_kind *kind,
                     const tf_query_rows *rows, bool backwards,
                     tf_contact *contact)
{
    int first = kind->vertices[0], others = kind->vertices[1];
    int vertex[4] = {0, 1, 2, 3};
    for (int i = 0; i < others && backwards; i++)
        vertex[first + i] = first + others - 1 - i;
    tf_motion motion = {kind->axes, first + others, rows->x[0], rows->x[1]};
    if (kind->axes == 2)
        return tf_point_edge(arithmetic, &motion, 0, vertex + 1, contact);
    return first == 1
               ? tf_point_triangle(arithmetic, &motion, 0, vertex + 1, contact)
               : tf_edge_edge(arithmetic, &motion, vertex, vertex + 2, contact);
}

// Tell ------------------------------------------------------------------------

static void put_numbers(FILE *text, const char *field, int count,
                        const double number[])
{
    for (int i = 0; i < count; i++)
        fprintf(text, "%s%s%a", i == 0 ? " " : ",", i == 0 ? field : "",
                number[i]);
}

static void put_contact(FILE *text, const tf_contact *c)
{
    static const char *const verdicts[] = {"undecided", "apart", "hit"};
    static const char *const classifications[] = {"unclassified", "generic",
                                                  "touching", "degenerate"};
    fprintf(text, " verdict=%s classification=%s", verdicts[c->verdict],
            classifications[c->classification]);
    put_numbers(text, "toi_lo=", 1, &c->toi_lo);
    put_numbers(text, "toi_hi=", 1, &c->toi_hi);
    put_numbers(text, "barycentric[0]=", 3, c->barycentric[0]);
    put_numbers(text, "barycentric[1]=", 3, c->barycentric[1]);
    put_numbers(text, "normal=", 3, c->normal);
    put_numbers(text, "velocity=", 3, c->velocity);
    put_numbers(text, "normal_velocity=", 1, &c->normal_velocity);
}

static void put_answer(FILE *text, const char *name, const tf_query_kind *kind,
                       const tf_query_rows *rows, long query, bool backwards)
{
    fprintf(text, "%ld %s%s:", query, name, backwards ? " backwards" : "");
    tf_contact contact;
    tf_status status = ask(tf_choice_named(tf_arithmetics, name), kind, rows,
                           backwards, &contact);
    if (status == TF_OK)
        put_contact(text, &contact);
    else
        fprintf(text, " status=%s",
                status == TF_OUT_OF_RANGE ? "out-of-range" : "other");
    fputc('\n', text);
}

static void put_query(FILE *text, const tf_query_kind *kind,
                      const tf_query_rows *rows, long query)
{
    static const char *const names[] = {"exact",     "clamped",   "report",
                                        "perturbed", "integer64", "integer128"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        put_answer(text, names[i], kind, rows, query, false);
    put_answer(text, "exact", kind, rows, query, true);
}

static void put_file(FILE *text, const golden_file *file)
{
    char path[LINE];
    snprintf(path, sizeof path, "tests/queries/%s.csv", file->name);
    const tf_query_kind *kind = tf_choice_named(tf_query_kinds, file->kind);
    tf_query_file queries;
    tf_fault fault;
    ck_assert_msg(tf_query_file_open(&queries, path, kind, 0, &fault), "%s",
                  path);
    tf_query_rows rows;
    tf_reading reading;
    long query = 0;
    while ((reading = tf_query_file_next(&queries, &rows)) == TF_READ_GOOD)
        put_query(text, kind, &rows, query++);
    ck_assert_msg(reading == TF_READ_END, "%s: %s", path, fault.text);
    ck_assert_int_gt(query, 0);
    tf_query_file_close(&queries);
}

// Compare ---------------------------------------------------------------------

/// Fail at the first word that differs: a field and its value.
static void expect_words(const char *path, char *expected, char *got)
{
    char answer[LINE], *rest, *others;
    snprintf(answer, sizeof answer, "%.*s", (int)strcspn(got, ":"), got);
    char *want = strtok_r(expected, " \n", &rest);
    char *have = strtok_r(got, " \n", &others);
    while (want && have && strcmp(want, have) == 0) {
        want = strtok_r(NULL, " \n", &rest);
        have = strtok_r(NULL, " \n", &others);
    }
    ck_assert_msg(!want && !have, "%s: query %s: expected %s, got %s", path,
                  answer, want ? want : "nothing", have ? have : "nothing");
}

static void compare(const char *path, FILE *golden, FILE *text)
{
    char expected[LINE], got[LINE];
    rewind(text);
    while (fgets(got, sizeof got, text)) {
        ck_assert_msg(fgets(expected, sizeof expected, golden), "%s lacks: %s",
                      path, got);
        expect_words(path, expected, got);
    }
    ck_assert_msg(!fgets(expected, sizeof expected, golden),
                  "%s has too much: %s", path, expected);
}

static bool writes(void)
{
    const char *told = getenv("TF_GOLDEN");
    return told && strcmp(told, "write") == 0;
}

START_TEST(answers_match_the_golden_file)
{
    char path[LINE];
    snprintf(path, sizeof path, "tests/queries/%s.golden", files[_i].name);
    FILE *golden = fopen(path, writes() ? "w" : "r");
    ck_assert_msg(golden, "cannot open %s", path);
    if (writes()) {
        put_file(golden, &files[_i]);
    } else {
        FILE *text = tmpfile();
        ck_assert_ptr_nonnull(text);
        put_file(text, &files[_i]);
        compare(path, golden, text);
        fclose(text);
    }
    ck_assert_int_eq(fclose(golden), 0);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("golden answers");
    TCase *tcase = tcase_create("files");
    tcase_add_loop_test(tcase, answers_match_the_golden_file, 0, FILES);
    suite_add_tcase(suite, tcase);
    return suite;
}
