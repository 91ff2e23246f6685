// Query files: the public ones and the adversarial ones, whose exact answers
// are on file beside them, and those in tests/queries.
#define _POSIX_C_SOURCE 200809L // glob, strtok_r

#include "arithmetic/clamped.h"
#include "arithmetic/exact.h"
#include "arithmetic/integer.h"
#include "support/judge.h"

#include <glob.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Read ------------------------------------------------------------------------

enum {
    LINE = 8192,
    FIELDS = 8
};

static int split(char *line, char *field[FIELDS])
{
    int count = 0;
    char *rest;
    for (char *next = strtok_r(line, ",\n", &rest); next && count < FIELDS;
         next = strtok_r(NULL, ",\n", &rest))
        field[count++] = next;
    return count;
}

/// The fraction that two texts stand for.
static void read_fraction(mpq_t fraction, const char *numerator,
                          const char *denominator)
{
    ck_assert(mpz_set_str(mpq_numref(fraction), numerator, 10) == 0);
    ck_assert(mpz_set_str(mpq_denref(fraction), denominator, 10) == 0);
    mpq_canonicalize(fraction);
}

static double read_rational(const char *numerator, const char *denominator)
{
    mpq_t given, kept;
    mpq_inits(given, kept, NULL);
    read_fraction(given, numerator, denominator);
    double x = mpq_get_d(given);
    mpq_set_d(kept, x);
    if (!mpq_equal(given, kept))
        ck_abort_msg("%s/%s is no double", numerator, denominator);
    mpq_clears(given, kept, NULL);
    return x;
}

/// Read a row: a rational or a number an axis, and perhaps a truth.
static void read_row(char *line, int axes, double x[])
{
    char *field[FIELDS];
    int count = split(line, field);
    bool rational = count >= 2 * axes;
    ck_assert_int_ge(count, axes);
    for (int k = 0; k < axes; k++)
        x[k] = rational ? read_rational(field[2 * k], field[2 * k + 1])
                        : strtod(field[k], NULL);
}

/// Read the next query; false at the end of the file.
static bool read_query(FILE *file, query_kind kind, query *q)
{
    char line[LINE];
    *q = query_new(kind);
    for (int i = 0; i < query_size(q); i += q->axes) {
        if (!fgets(line, sizeof line, file)) {
            ck_assert_int_eq(i, 0);
            return false;
        }
        double x[TF_AXES];
        read_row(line, q->axes, x);
        for (int k = 0; k < q->axes; k++)
            *query_coordinate(q, i + k) = x[k];
    }
    return true;
}

/// Read a row "query,hit,toi", where toi is a fraction.
static void read_truth(FILE *file, truth *known)
{
    char line[LINE], *field[FIELDS];
    ck_assert_ptr_nonnull(fgets(line, sizeof line, file));
    int count = split(line, field);
    ck_assert_int_ge(count, 2);
    known->hit = field[1][0] == '1';
    if (!known->hit)
        return;
    ck_assert_int_eq(count, 3);
    char *slash = strchr(field[2], '/');
    if (slash)
        *slash = '\0';
    read_fraction(known->toi, field[2], slash ? slash + 1 : "1");
}

// Judge -----------------------------------------------------------------------

/// Whether the truth on file, which was not found by this program, is what the
/// oracle says.
static void compare_oracle(const query *q, const truth *filed)
{
    truth known;
    truth_init(&known);
    truth_find(q, &known);
    if (known.hit != filed->hit ||
        (known.hit && !mpq_equal(known.toi, filed->toi)))
        expect_no_fault("the oracle contradicts the file", q);
    truth_clear(&known);
}

static void judge(const query *q, const truth *known, bool integers)
{
    expect_truth(q, known);
    query numbered = *q;
    query_number(&numbered);
    expect_no_fault(perturbed_fault(&numbered), q);
    if (!integers)
        return;
    tf_contact contact;
    expect_no_fault(exact_fault(q, &tf_integer64, known, &contact), q);
    expect_no_fault(exact_fault(q, &tf_integer128, known, &contact), q);
}

static FILE *open_file(const char *path)
{
    FILE *file = fopen(path, "r");
    if (!file)
        ck_abort_msg("cannot read %s", path);
    return file;
}

/// Judge a file of queries by a file of truths or, if that is NULL, by the
/// oracle, and tell how many there are.
static void judge_file(const char *path, const char *truth_path,
                       query_kind kind, bool integers)
{
    FILE *queries = open_file(path);
    FILE *truths = truth_path ? open_file(truth_path) : NULL;
    char header[LINE];
    if (truths)
        ck_assert_ptr_nonnull(fgets(header, sizeof header, truths));

    truth known;
    truth_init(&known);
    long count = 0, hits = 0;
    for (query q; read_query(queries, kind, &q); count++) {
        if (truths) {
            read_truth(truths, &known);
            compare_oracle(&q, &known);
        } else {
            truth_find(&q, &known);
        }
        judge(&q, &known, integers);
        hits += known.hit;
    }
    truth_clear(&known);

    printf("%6ld queries, %5ld hits: %s\n", count, hits, path);
    ck_assert_int_gt(count, 0);
    fclose(queries);
    if (truths) {
        ck_assert_msg(!fgets(header, sizeof header, truths),
                      "%s has too many rows", truth_path);
        fclose(truths);
    }
}

// Find the files --------------------------------------------------------------

static query_kind kind_of(const char *path)
{
    return strstr(path, "point-edge")  ? POINT_EDGE
           : strstr(path, "edge-edge") ? EDGE_EDGE
                                       : POINT_TRIANGLE;
}

/// Put the path of the truths that belong to the queries in `path`.
static void truth_path_of(const char *path, const char *folder,
                          const char *truth_folder, char truth_path[LINE])
{
    const char *at = strstr(path, folder);
    snprintf(truth_path, LINE, "%.*s%s%s", (int)(at - path), path, truth_folder,
             at + strlen(folder));
}

/// Judge what matches `pattern` in the shared folder, by the truths in files
/// whose paths have `replacement` for `replaced`.
static void judge_shared(const char *pattern, const char *replaced,
                         const char *replacement)
{
    const char *root = getenv("TF_SHARED_DATA");
    char path[LINE], truth_path[LINE];
    snprintf(path, sizeof path, "%s/%s", root ? root : "../shared/data",
             pattern);

    glob_t found;
    if (glob(path, 0, NULL, &found) != 0) {
        printf("not checked, for want of files: %s (set TF_SHARED_DATA)\n",
               path);
        return;
    }
    for (size_t i = 0; i < found.gl_pathc; i++) {
        const char *queries = found.gl_pathv[i];
        truth_path_of(queries, replaced, replacement, truth_path);
        judge_file(queries, truth_path, kind_of(queries),
                   strstr(queries, "/lattice/") != NULL);
    }
    globfree(&found);
}

START_TEST(public_queries_have_the_known_verdicts)
{
    judge_shared("sample-queries/*/*/*.csv", "sample-queries",
                 "sample-queries-truth");
}
END_TEST

START_TEST(adversarial_queries_have_the_known_verdicts)
{
    judge_shared("adversarial/*/*/data.csv", "data.csv", "truth.csv");
}
END_TEST

START_TEST(kept_queries_have_the_known_verdicts)
{
    judge_file("tests/queries/point-edge.csv", NULL, POINT_EDGE, false);
    judge_file("tests/queries/point-triangle.csv", NULL, POINT_TRIANGLE, false);
    judge_file("tests/queries/edge-edge.csv", NULL, EDGE_EDGE, false);
}
END_TEST

START_TEST(rare_queries_have_the_known_verdicts)
{
    judge_file("tests/queries/rare-point-edge.csv", NULL, POINT_EDGE, false);
    judge_file("tests/queries/rare-point-triangle.csv", NULL, POINT_TRIANGLE,
               false);
    judge_file("tests/queries/rare-edge-edge.csv", NULL, EDGE_EDGE, false);
}
END_TEST

Suite *suite(void)
{
    Suite *data = suite_create("query files");
    TCase *files = tcase_create("files");
    tcase_add_test(files, public_queries_have_the_known_verdicts);
    tcase_add_test(files, adversarial_queries_have_the_known_verdicts);
    tcase_add_test(files, kept_queries_have_the_known_verdicts);
    tcase_add_test(files, rare_queries_have_the_known_verdicts);
    suite_add_tcase(data, files);
    return data;
}
