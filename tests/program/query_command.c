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
#include <sys/resource.h>
#include <unistd.h>

// A hit at t = 1/2 and a miss, of a point that falls on an edge.
#define HIT "0,1\n-1,0\n2,0\n0,-1\n-1,0\n2,0\n"
#define MISS "0,1\n-1,0\n1,0\n0,1\n-1,0\n1,0\n"
#define HEADER "query,hit,toi_lo,toi_hi,nx,ny,nz,normal_velocity,case\n"
#define MISS_ANSWER ",0,,,,,,,\n"

/// Expect two misses answered, then this message about the file "bad".
static void expect_fault(const char *text, const char *message)
{
    char rows[10000];
    snprintf(rows, sizeof rows, "%s%s%s", MISS, MISS, text);
    make_file("bad", rows);
    outcome found = run("$tf query --kind point-edge bad");
    ck_assert_str_eq(found.out, HEADER "0" MISS_ANSWER "1" MISS_ANSWER);
    ck_assert_int_eq(found.status, 2);
    char right[1000];
    snprintf(right, sizeof right, "tanglefree: bad:%s\n", message);
    ck_assert_str_eq(found.err, right);
}

// Answers ---------------------------------------------------------------------

START_TEST(a_hit_and_a_miss_are_told_apart)
{
    make_file("in", HIT MISS);
    outcome found = run("$tf query --kind point-edge in");
    double lo, hi, nx, ny, speed;
    char decision[20];
    ck_assert_int_eq(sscanf(found.out,
                            HEADER "0,1,%lf,%lf,%lf,%lf,,%lf,%19[a-z]", &lo,
                            &hi, &nx, &ny, &speed, decision),
                     6);
    ck_assert_msg(lo <= 0.5 && 0.5 <= hi && hi - lo <= 0x1p-50, "[%a, %a]", lo,
                  hi);
    ck_assert(nx == 0 && ny == 1 && speed == -2);
    ck_assert_str_eq(decision, "generic");
    expect_words(found.out, "\n1" MISS_ANSWER);
    ck_assert_str_eq(found.err, "");
    ck_assert_int_eq(found.status, 0);
}
END_TEST

START_TEST(every_kind_arithmetic_and_output_works)
{
    static const char *const kinds[] = {"point-edge", "point-triangle",
                                        "edge-edge"};
    static const char *const arithmetics[] = {"exact", "clamped", "report"};
    static const char *const formats[] = {"csv", "json", "summary"};
    for (int i = 0; i < 27; i++) {
        outcome found = run("$tf query --kind=%s --arithmetic=%s --format=%s "
                            "$QUERIES/%s.csv",
                            kinds[i / 9], arithmetics[i / 3 % 3],
                            formats[i % 3], kinds[i / 9]);
        ck_assert_str_eq(found.err, "");
        ck_assert_int_eq(found.status, 0);
        ck_assert_int_eq(occurrences(found.out, "nan"), 0);
        if (i % 3 < 2)
            ck_assert_int_ge(occurrences(found.out, "\n"), 7);
    }
}
END_TEST

START_TEST(exact_answers_agree_with_the_kept_truth)
{
    expect(
        run("$tf query -k point-edge --format summary $QUERIES/point-edge.csv"),
        0, "queries: 7\nhits: 5\ngeneric: 3\ntouching: 1\ndegenerate: 1\n", "");
    expect(run("$tf query -k point-triangle --format summary "
               "$QUERIES/point-triangle.csv"),
           0, "queries: 6\nhits: 5\ngeneric: 3\ntouching: 1\ndegenerate: 1\n",
           "");
    expect(
        run("$tf query -k edge-edge --format summary $QUERIES/edge-edge.csv"),
        0, "queries: 6\nhits: 5\ngeneric: 3\ntouching: 0\ndegenerate: 2\n", "");
}
END_TEST

START_TEST(vertex_face_is_point_triangle)
{
    char triangle[10000];
    strcpy(triangle, run("$tf query -k point-triangle "
                         "$QUERIES/point-triangle.csv")
                         .out);
    expect(run("$tf query -k vertex-face $QUERIES/point-triangle.csv"), 0,
           triangle, "");
}
END_TEST

START_TEST(exact_is_the_arithmetic_unless_told)
{
    char exact[10000];
    strcpy(exact, run("$tf query -k edge-edge -a exact "
                      "$QUERIES/edge-edge.csv")
                      .out);
    expect(run("$tf query -k edge-edge $QUERIES/edge-edge.csv"), 0, exact, "");
}
END_TEST

START_TEST(three_exact_arithmetics_agree_on_integers)
{
    char exact[1000];
    make_file("in", HIT MISS);
    strcpy(exact, run("$tf query -k point-edge in").out);
    expect(run("$tf query -k point-edge -a integer64 in"), 0, exact, "");
    expect(run("$tf query -k point-edge -a integer128 in"), 0, exact, "");
}
END_TEST

START_TEST(undecided_is_a_hit)
{
    // A point on an edge that is no multiple of anything, but for a rounding.
    make_file("in", "0.1,0.3\n-0.7,-2.1\n1.1,3.3000000000000003\n"
                    "0.1,0.3\n-0.7,-2.1\n1.1,3.3000000000000003\n");
    outcome found =
        run("$tf query -k point-edge -a clamped --format summary in");
    expect_words(found.out, "hits: 1\n");
    ck_assert_int_eq(found.status, 0);
}
END_TEST

START_TEST(json_is_an_array_of_objects)
{
    make_file("in", MISS MISS);
    static const char nulls[] =
        ",\"hit\":0,\"toi_lo\":null,\"toi_hi\":null,\"nx\":null,\"ny\":null,"
        "\"nz\":null,\"normal_velocity\":null,\"case\":null}";
    char right[1000];
    snprintf(right, sizeof right, "[\n{\"query\":0%s,\n{\"query\":1%s\n]\n",
             nulls, nulls);
    expect(run("$tf query -k point-edge --format json in"), 0, right, "");
}
END_TEST

START_TEST(json_of_a_hit_has_numbers)
{
    make_file("in", HIT);
    outcome found = run("$tf query -k point-edge --format json in");
    double lo, hi;
    ck_assert_int_eq(sscanf(found.out,
                            "[\n{\"query\":0,\"hit\":1,\"toi_lo\":%lf,"
                            "\"toi_hi\":%lf,",
                            &lo, &hi),
                     2);
    expect_words(found.out,
                 ",\"nz\":null,\"normal_velocity\":-2,\"case\":\"generic\"}"
                 "\n]\n");
}
END_TEST

static void expect_json(const char *kind, const char *rows)
{
    static const char *const arithmetics[] = {"exact", "clamped", "report",
                                              "perturbed"};
    make_file("in", rows);
    for (int i = 0; i < 4; i++) {
        outcome found =
            run("$tf query -k %s -a %s --format json in", kind, arithmetics[i]);
        const char *fault = json_fault(found.out);
        ck_assert_msg(!fault, "%s: no JSON here: %s", arithmetics[i], fault);
        ck_assert_str_eq(found.err, "");
        ck_assert_int_eq(found.status, 0);
    }
}

START_TEST(json_has_finite_numbers_only)
{
    ck_assert_ptr_null(json_fault("[\n{\"a\":-0.5e-7,\"b\":null},[]]\n"));
    static const char *const bad[] = {"nan", "-nan", "inf", "-inf", "01",
                                      "1.",  "+1",   "[1,", "{1:2}"};
    for (int i = 0; i < 9; i++)
        ck_assert_ptr_nonnull(json_fault(bad[i]));

    // Squares near the largest double, and coordinates as large.
    static const char crossing[] = "0,0,0\n1.2e154,1.1e154,0\n"
                                   "0,0,0\n1.1e154,1.2e154,1e-160\n",
                      largest[] = "0,1.7e308\n-1.7e308,0\n1.7e308,0\n"
                                  "0,-1.7e308\n-1.7e308,0\n1.7e308,0\n";
    char rows[1000];
    snprintf(rows, sizeof rows, "%s%s", crossing, crossing);
    expect_json("edge-edge", rows);
    expect_json("point-triangle", rows);
    expect_json("point-edge", largest);
}
END_TEST

START_TEST(json_is_closed_before_bad_input)
{
    make_file("in", MISS "0,1\nx,0\n");
    outcome found = run("$tf query -k point-edge --format json in");
    ck_assert_int_eq(found.status, 2);
    ck_assert_int_eq(occurrences(found.out, "{"), 1);
    expect_words(found.out, ",\"case\":null}\n]\n");
    make_file("in", "x,0\n");
    found = run("$tf query -k point-edge --format json in");
    ck_assert_str_eq(found.out, "[\n]\n");
    ck_assert_int_eq(found.status, 2);
}
END_TEST

START_TEST(summary_tells_agreement_with_the_truth)
{
    // The same hit, called right and wrong; the same miss.
    static const char *const rows[2] = {
        "0,1,1,1,%d\n-1,1,0,1,%d\n2,1,0,1,%d\n"
        "0,1,-1,1,%d\n-1,1,0,1,%d\n2,1,0,1,%d\n",
        "0,1,1,1,%d\n-1,1,0,1,%d\n1,1,0,1,%d\n"
        "0,1,1,1,%d\n-1,1,0,1,%d\n1,1,0,1,%d\n"};
    char text[2000] = "";
    static const int hits_and_truths[][2] = {{1, 1}, {1, 0}, {1, 0},
                                             {0, 0}, {0, 1}, {0, 0}};
    for (int i = 0; i < 6; i++)
        for (const char *c = rows[!hits_and_truths[i][0]]; *c; c++) {
            char written[2] = {*c, '\0'};
            if (*c == '%')
                written[0] = (char)('0' + hits_and_truths[i][1]);
            c += *c == '%';
            strcat(text, written);
        }
    make_file("in", text);
    expect(run("$tf query -k point-edge --format summary in"), 0,
           "queries: 6\nhits: 3\ngeneric: 3\ntouching: 0\ndegenerate: 0\n"
           "agree: 3\nextra: 2\nmissed: 1\n",
           "");
}
END_TEST

// Methods ---------------------------------------------------------------------

// A plank turns below a fly: a hit if it bends, a miss if it stays straight.
#define FLY "0,1\n-2,2\n2,-2\n0,1\n-2,-2\n2,2\n"

START_TEST(every_kind_method_and_output_works)
{
    static const char *const kinds[] = {"point-edge", "point-triangle",
                                        "edge-edge"};
    static const char *const methods[] = {"spacetime", "cubic", "advancement"};
    static const char *const formats[] = {"csv", "json", "summary"};
    for (int i = 0; i < 27; i++) {
        outcome found =
            run("$tf query --kind=%s --method=%s --format=%s "
                "$QUERIES/%s.csv",
                kinds[i / 9], methods[i / 3 % 3], formats[i % 3], kinds[i / 9]);
        ck_assert_str_eq(found.err, "");
        ck_assert_int_eq(found.status, 0);
        ck_assert_int_eq(occurrences(found.out, "nan"), 0);
        ck_assert_int_eq(occurrences(found.out, "inf"), 0);
        if (i % 3 < 2)
            ck_assert_int_ge(occurrences(found.out, "\n"), 7);
    }
}
END_TEST

START_TEST(spacetime_is_the_method_unless_told)
{
    char told[10000];
    make_file("in", HIT FLY);
    strcpy(told, run("$tf query -k point-edge -m spacetime in").out);
    expect(run("$tf query -k point-edge in"), 0, told, "");
}
END_TEST

START_TEST(the_cubic_answers)
{
    make_file("in", HIT FLY);
    expect(run("$tf query -k point-edge -m cubic in"), 0,
           HEADER "0,1,0.5,0.5,0,1,,-2,generic\n1" MISS_ANSWER, "");
}
END_TEST

START_TEST(tolerances_and_thresholds_count)
{
    // A point falls beside the end of an edge, at a distance of 1/16.
    make_file("in", "2.0625,1\n-1,0\n2,0\n2.0625,-1\n-1,0\n2,0\n");
    static const char *const options[] = {"-m cubic --tolerance=0",
                                          "-m cubic",
                                          "-m cubic --tolerance 0x1p-3",
                                          "-m advancement --threshold=0.01",
                                          "-m advancement",
                                          "-m advancement --threshold=1e-1"};
    for (int i = 0; i < 6; i++) {
        outcome found =
            run("$tf query -k point-edge --format summary %s in", options[i]);
        ck_assert_str_eq(found.err, "");
        expect_words(found.out, i % 3 == 2 ? "hits: 1" : "hits: 0");
    }
}
END_TEST

START_TEST(methods_are_compared)
{
    make_file("in", HIT FLY MISS);
    expect(run("$tf query -k point-edge --format summary --against cubic in"),
           0,
           "queries: 3\nhits: 2\ngeneric: 2\ntouching: 0\ndegenerate: 0\n"
           "differ: 1\nonly_method: 1\nonly_against: 0\n",
           "");
    expect(run("$tf query -k point-edge --format summary -m cubic -a exact "
               "--against=spacetime in"),
           0,
           "queries: 3\nhits: 1\ngeneric: 1\ntouching: 0\ndegenerate: 0\n"
           "differ: 1\nonly_method: 0\nonly_against: 1\n",
           "");
}
END_TEST

// Input -----------------------------------------------------------------------

START_TEST(several_files_are_counted_through)
{
    make_file("one", MISS MISS);
    make_file("two", MISS);
    // Columns are chosen anew for each file.
    make_file("three", "0,1,1,1\n-1,1,0,1\n1,1,0,1\n"
                       "0,1,1,1\n-1,1,0,1\n1,1,0,1\n");
    expect(run("$tf query one -k point-edge two three"), 0,
           HEADER "0" MISS_ANSWER "1" MISS_ANSWER "2" MISS_ANSWER
                  "3" MISS_ANSWER,
           "");
}
END_TEST

START_TEST(standard_input_is_read)
{
    make_file("in", MISS);
    expect(run("$tf query -k point-edge <in"), 0, HEADER "0" MISS_ANSWER, "");
    expect(run("$tf query -k point-edge in - in <in"), 0,
           HEADER "0" MISS_ANSWER "1" MISS_ANSWER "2" MISS_ANSWER, "");
    make_file("in", MISS "1,x\n");
    expect(run("$tf query -k point-edge <in"), 2, HEADER "0" MISS_ANSWER,
           "tanglefree: standard input:7: column 2 is 'x', not a finite "
           "number; write a decimal or a hexadecimal float\n");
}
END_TEST

START_TEST(a_pipe_that_ends_within_a_query_is_refused)
{
    make_file("in", MISS "1,2\n");
    expect(run("cat in | $tf query -k point-edge"), 2, HEADER "0" MISS_ANSWER,
           "tanglefree: standard input:7: query 1 has only 1 of its 6 rows; "
           "add the rest\n");
}
END_TEST

START_TEST(messages_count_through_the_files_too)
{
    make_file("one", MISS MISS);
    make_file("two", MISS "1,2\n");
    outcome found = run("$tf query -k point-edge one two");
    ck_assert_str_eq(found.err,
                     "tanglefree: two:7: query 3 has only 1 of its 6 "
                     "rows; add the rest\n");
}
END_TEST

START_TEST(names_send_no_commands_to_the_terminal)
{
    // Clear the screen, in a file that is not there, in one that is bad, and in
    // words.
    expect(
        run("$tf query -k point-edge $(printf 'a\\033[2J\\233')"), 2, HEADER,
        "tanglefree: a\\x1b[2J\\x9b: cannot open: No such file or directory; "
        "check the name\n");
    make_file("a\x1b[2J", "1,2\n");
    expect(run("$tf query -k point-edge a*"), 2, HEADER,
           "tanglefree: a\\x1b[2J:1: query 0 has only 1 of its 6 rows; "
           "add the rest\n");
    expect_words(run("$tf \"$(printf '\\033c')\"").err,
                 "unknown command '\\x1bc';");
    expect_words(run("$tf query -k \"$(printf '\\033c')\"").err,
                 "--kind must be point-edge, point-triangle, edge-edge or "
                 "vertex-face, got '\\x1bc'");
}
END_TEST

// The writer waits until the program, which has begun to count time, opens the
// pipe.
START_TEST(progress_is_shown_on_a_terminal)
{
    make_file("in", MISS MISS);
    terminal screen = terminal_open();
    expect(run("mkfifo late; "
               "{ exec 3>late; cat in >&3; sleep 1.1; cat in >&3; } & "
               "$tf query -k point-edge late 2>%s",
               screen.name),
           0,
           HEADER "0" MISS_ANSWER "1" MISS_ANSWER "2" MISS_ANSWER
                  "3" MISS_ANSWER,
           "");
    expect_progress(terminal_close(&screen), "\r2 queries");
}
END_TEST

START_TEST(closed_standard_input_is_refused)
{
    expect(run("$tf query -k point-edge <&-"), 2, HEADER,
           "tanglefree: standard input:1: cannot read: Bad file descriptor; "
           "check that this is a file\n");
}
END_TEST

START_TEST(windows_text_is_read)
{
    make_file("in", "\xEF\xBB\xBF" MISS MISS);
    expect(run("sed 's/$/\\r/' in >windows && "
               "$tf query -k point-edge windows"),
           0, HEADER "0" MISS_ANSWER "1" MISS_ANSWER, "");
}
END_TEST

START_TEST(rounded_coordinates_are_counted)
{
    make_file("one", "1,3,2,1\n0,1,1,1\n1,1,1,1\n1,3,2,1\n0,1,1,1\n1,1,1,1\n");
    make_file("two", "1,7,2,1\n0,1,1,1\n1,1,1,1\n0,3,2,1\n0,1,1,1\n1,1,1,1\n");
    expect(run("$tf query -k point-edge two"), 0, HEADER "0" MISS_ANSWER,
           "tanglefree: rounded 1 rational coordinate to the nearest double\n");
    expect(
        run("$tf query -k point-edge one two"), 0,
        HEADER "0" MISS_ANSWER "1" MISS_ANSWER,
        "tanglefree: rounded 3 rational coordinates to the nearest double\n");
}
END_TEST

/// The most memory that any process of this test has used so far, in KiB.
static long most_memory(void)
{
    struct rusage used;
    ck_assert_int_eq(getrusage(RUSAGE_CHILDREN, &used), 0);
    return used.ru_maxrss;
}

START_TEST(memory_does_not_grow_with_the_file)
{
    make_file("in", MISS);
    run("$tf query -k point-edge --format summary in");
    long before = most_memory();
    outcome found = run("for i in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17; "
                        "do cat in in >more; mv more in; done; "
                        "$tf query -k point-edge --format summary in");
    expect_words(found.out, "queries: 131072\n");
    long grown = most_memory() - before;
    ck_assert_msg(grown < 2048, "%ld KiB more for 4700", grown);
}
END_TEST

// Bad input -------------------------------------------------------------------

/// Rows that are bad, and what is told of them.
static const struct {
    const char *rows, *message;
} faults[] = {
    {"0,nan\n", "13: column 2 is 'nan', not a finite number; write a "
                "decimal or a hexadecimal float"},
    {"0,0\n-inf,0\n", "14: column 1 is '-inf', not a finite number; write a "
                      "decimal or a hexadecimal float"},
    {"0,0\n1.5x,0\n", "14: column 1 is '1.5x', not a finite number; write a "
                      "decimal or a hexadecimal float"},
    {"0,1e999\n", "13: column 2 is '1e999', beyond the largest double; "
                  "scale the scene down"},
    {"0,0\n1\n",
     "14: too few columns: 1, but the first row has 2; all rows must "
     "have as many"},
    {"0,0\n1,1\n0,0\n1,1\n0,0\n",
     "17: query 2 has only 5 of its 6 rows; add the rest"},
    {"\n# comment\nx,0\n", "15: column 1 is 'x', not a finite number; write a "
                           "decimal or a hexadecimal float"},
};

START_TEST(bad_rows_are_refused)
{
    expect_fault(faults[_i].rows, faults[_i].message);
}
END_TEST

START_TEST(a_zero_denominator_is_refused)
{
    make_file("bad", "0,1,1,1\n-1,1,0,0\n");
    expect(run("$tf query -k point-edge bad"), 2, HEADER,
           "tanglefree: bad:2: column 4 is 0; a denominator must not be "
           "0\n");
}
END_TEST

START_TEST(a_nul_byte_is_refused)
{
    make_file("in", MISS);
    expect(run("head -c 5 /dev/zero | cat in - >bad; "
               "$tf query -k point-edge bad"),
           2, HEADER "0" MISS_ANSWER,
           "tanglefree: bad:7: a NUL byte; the file must be plain text (ASCII "
           "or UTF-8, not UTF-16)\n");
}
END_TEST

START_TEST(an_empty_file_is_refused)
{
    make_file("in", MISS);
    make_file("bad", "");
    expect(run("$tf query -k point-edge in bad in"), 2, HEADER "0" MISS_ANSWER,
           "tanglefree: bad:1: no rows; a query has 6\n");
}
END_TEST

START_TEST(a_directory_is_refused)
{
    make_file("in", MISS);
    expect(run("mkdir bad; $tf query -k point-edge in bad"), 2,
           HEADER "0" MISS_ANSWER,
           "tanglefree: bad:1: cannot read: Is a directory; check that this "
           "is a file\n");
}
END_TEST

START_TEST(an_absent_file_is_refused)
{
    make_file("in", MISS);
    expect(run("$tf query -k point-edge in bad in"), 2, HEADER "0" MISS_ANSWER,
           "tanglefree: bad: cannot open: No such file or directory; check "
           "the name\n");
}
END_TEST

/// The second of two files goes away while the first, a pipe, is read; and a
/// file that is open goes on being read when its name has gone.
START_TEST(a_file_that_vanishes_is_refused)
{
    make_file("bad", MISS);
    make_file("in", MISS);
    expect(run("mkfifo pipe; $tf query -k point-edge pipe bad & "
               "{ head -n 3 in; rm bad; tail -n 3 in; } >pipe; wait $!"),
           2, HEADER "0" MISS_ANSWER,
           "tanglefree: bad: cannot open: No such file or directory; check "
           "the name\n");
    expect(run("$tf query -k point-edge pipe & exec 3>pipe; "
               "rm pipe; cat in >&3; exec 3>&-; wait $!"),
           0, HEADER "0" MISS_ANSWER, "");
}
END_TEST

START_TEST(a_coordinate_out_of_range_is_refused)
{
    make_file("in", MISS "0,1\n-1,0\n1,0\n0,1\n1,1073741824\n1,0\n");
    expect(run("$tf query -k point-edge -a integer64 in"), 2,
           HEADER "0" MISS_ANSWER,
           "tanglefree: in:11: the coordinate 1073741824 is out of range: "
           "integer64 holds integers below 2^30 in absolute value; use "
           "--arithmetic exact\n");
    make_file("in", "0,0,0\n0,0,0.5\n0,0,0\n0,0,0\n"
                    "0,0,0\n0,0,0\n0,0,0\n0,0,0\n");
    expect(run("$tf query -k edge-edge -a integer128 in"), 2, HEADER,
           "tanglefree: in:2: the coordinate 0.5 is out of range: integer128 "
           "holds integers below 2^40 in absolute value; use --arithmetic "
           "exact\n");
}
END_TEST

START_TEST(rounding_is_told_before_bad_input)
{
    make_file("in", "1,3,2,1\n0,1,1,1\n1,1,1,1\n1,3,2,1\n0,1,1,1\n1,1,1,1\n"
                    "1,3,2,1\n\n");
    expect(
        run("$tf query -k point-edge in"), 2, HEADER "0" MISS_ANSWER,
        "tanglefree: rounded 2 rational coordinates to the nearest double\n"
        "tanglefree: in:7: query 1 has only 1 of its 6 rows; add the rest\n");
}
END_TEST

// Output files ----------------------------------------------------------------

START_TEST(what_is_written_to_a_file_is_what_is_printed)
{
    static const char *const formats[] = {"csv", "json", "summary"};
    make_file("in", MISS);
    for (int i = 0; i < 3; i++)
        expect(run("$tf query -k point-edge --format %s in >printed && "
                   "$tf query -k point-edge --format %s in --output=written && "
                   "$tf query -k point-edge --format %s in -o - | "
                   "cmp - printed && cmp printed written && test -s written",
                   formats[i], formats[i], formats[i]),
               0, "", "");
}
END_TEST

START_TEST(a_file_appears_whole_or_not_at_all)
{
    make_file("in", MISS "0,nan\n");
    make_file("old", "before\n");
    static const char *const names[] = {"old", "new"};
    for (int i = 0; i < 2; i++) {
        outcome found = run("$tf query -k point-edge in -o %s", names[i]);
        ck_assert_int_eq(found.status, 2);
        ck_assert_str_eq(found.out, "");
        expect_words(found.err, "column 2 is 'nan', not a finite number");
    }
    ck_assert_str_eq(file_text("old"), "before\n");
    expect(run("ls -A | grep -e new -e tanglefree"), 1, "", "");
}
END_TEST

START_TEST(a_file_that_cannot_be_written_is_named)
{
    make_file("in", MISS);
    expect(run("$tf query -k point-edge in -o /dev/full"), 2, "",
           "tanglefree: /dev/full: cannot write: No space left on device; mend "
           "that, and run again\n");
}
END_TEST

START_TEST(old_spellings_are_refused)
{
    expect_usage("query -k point-edge -o json in",
                 "tanglefree query: --output json is an old spelling; write "
                 "--format json, or ./json for a file of that name\n");
}
END_TEST

// Output that cannot be written -----------------------------------------------

#define NO_SPACE                                                               \
    "tanglefree: standard output: cannot write: No space left on device"

START_TEST(a_full_disk_is_reported)
{
    static const char *const formats[] = {"csv", "json", "summary"};
    make_file("in", MISS);
    for (int i = 0; i < 3; i++)
        expect(run("$tf query -k point-edge --format %s in >/dev/full",
                   formats[i]),
               2, "", NO_SPACE "; mend that, and run again\n");
}
END_TEST

START_TEST(a_full_disk_on_the_way_is_reported)
{
    make_file("in", MISS);
    // The input has no end, and must not be read to it.
    expect(run("while cat in; do :; done 2>/dev/null | "
               "$tf query -k point-edge >/dev/full"),
           2, "", NO_SPACE "; mend that, and run again\n");
}
END_TEST

START_TEST(a_full_disk_for_help_is_reported)
{
    expect(run("$tf --help >/dev/full"), 2, "",
           NO_SPACE "; mend that, and run again\n");
    expect(run("$tf query --help >/dev/full"), 2, "",
           NO_SPACE "; mend that, and run again\n");
    expect(run("$tf --version >/dev/full"), 2, "",
           NO_SPACE "; mend that, and run again\n");
}
END_TEST

START_TEST(closed_standard_output_is_reported)
{
    make_file("in", MISS);
    expect(run("$tf query -k point-edge in >&-"), 2, "",
           "tanglefree: standard output: cannot write: Bad file descriptor; "
           "mend that, and run again\n");
    ck_assert_str_eq(file_text("in"), MISS);
}
END_TEST

START_TEST(a_reader_that_leaves_ends_the_program)
{
    make_file("in", MISS);
    outcome found = run("while cat in; do :; done 2>/dev/null | "
                        "$tf query -k point-edge | head -n 2");
    expect(found, 0, HEADER "0" MISS_ANSWER, "");
}
END_TEST

// Usage -----------------------------------------------------------------------

START_TEST(help_lists_the_commands)
{
    outcome found = run("$tf --help");
    ck_assert_int_eq(found.status, 0);
    ck_assert_str_eq(found.err, "");
    expect_words(found.out, "Usage: tanglefree [OPTION...] COMMAND");
    expect_words(found.out, "\nCommands:\n  query ");
    expect_words(found.out, "\n  detect ");
    expect_words(found.out, "\n  check ");
}
END_TEST

START_TEST(help_describes_the_command)
{
    outcome found = run("$tf query --help");
    ck_assert_int_eq(found.status, 0);
    ck_assert_str_eq(found.err, "");
    static const char *const words[] = {
        "Usage: tanglefree query [OPTION...] [FILE...]",
        "--kind=KIND",
        "--arithmetic=NAME",
        "--format=FORMAT",
        "-o, --output=FILE",
        "point-edge",
        "vertex-face",
        "exact, clamped, report",
        "csv, json or summary",
        "hexadecimal",
        "xnum,xden",
        "lines that begin with # are skipped",
        "moved vertices",
        "toi_lo",
        "degenerate",
        "Exit status"};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        expect_words(found.out, words[i]);
}
END_TEST

START_TEST(version_is_printed)
{
    outcome found = run("$tf --version");
    ck_assert_int_eq(strncmp(found.out, "tanglefree ", 11), 0);
    ck_assert_int_eq(found.status, 0);
    char same[100];
    snprintf(same, sizeof same, "%s", found.out);
    expect(run("$tf query --version"), 0, same, "");
}
END_TEST

START_TEST(unknown_commands_are_refused)
{
    expect_usage(
        "", "tanglefree: a command is required; --help lists the commands\n");
    expect_usage("contact", "tanglefree: unknown command 'contact'; --help "
                            "lists the commands\n");
    expect_usage("''", "tanglefree: unknown command ''");
    expect_usage("--kind query", "tanglefree: ");
}
END_TEST

START_TEST(wrong_options_are_refused)
{
    make_file("in", MISS);
    expect_usage("query in", "tanglefree query: --kind KIND is required: "
                             "point-edge, point-triangle, edge-edge or "
                             "vertex-face\n");
    expect_usage("query -k edge in",
                 "tanglefree query: --kind must be point-edge, point-triangle, "
                 "edge-edge or vertex-face, got 'edge'\n");
    expect_usage("query -k point-edge -a rounded in",
                 "tanglefree query: --arithmetic must be exact, clamped, "
                 "report, perturbed, integer64 or integer128, got 'rounded'\n");
    expect_usage("query -k point-edge --format=xml in",
                 "tanglefree query: --format must be csv, json or summary, got "
                 "'xml'\n");
    expect_usage("query -m cubic in",
                 "tanglefree query: --kind KIND is required");
    expect_usage("query -k point-edge -m quartic in",
                 "tanglefree query: --method must be spacetime, cubic or "
                 "advancement, got 'quartic'\n");
    expect_usage("query -k point-edge --against quartic in",
                 "tanglefree query: --against must be spacetime, cubic or "
                 "advancement, got 'quartic'\n");
    expect_usage(
        "query -k point-edge --against cubic in",
        "tanglefree query: --against is for --format summary, which has "
        "what it counts; add that\n");
    expect_usage("query -k point-edge -m cubic -a exact in",
                 "tanglefree query: --arithmetic is for --method spacetime; "
                 "add that, or drop it\n");
    expect_usage("query -k point-edge --tolerance 1 in",
                 "tanglefree query: --tolerance is for --method cubic; add "
                 "that, or drop it\n");
    expect_usage("query -k point-edge -m cubic --threshold 1 in",
                 "tanglefree query: --threshold is for --method "
                 "advancement; add that, or drop it\n");
    expect_usage("query --kind", "tanglefree query: option '--kind' requires");
    expect_usage("query --speed in",
                 "tanglefree query: unrecognized option '--speed'");
    expect_usage("query -z in", "tanglefree query: invalid option -- 'z'");
}
END_TEST

START_TEST(invalid_distances_are_refused)
{
    static const char *const bad[] = {"-1",    "nan", "-nan", "inf", "-inf",
                                      "1e999", "'' ", "1x",   "one", "-1e-300"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        char arguments[100];
        snprintf(arguments, sizeof arguments,
                 "query -k point-edge -m cubic --tolerance %s in", bad[i]);
        expect_usage(arguments,
                     "tanglefree query: --tolerance must be a number "
                     "from 0 on, got '");
        snprintf(arguments, sizeof arguments,
                 "query -k point-edge -m advancement --threshold=%s in",
                 bad[i]);
        expect_usage(arguments,
                     "tanglefree query: --threshold must be a number "
                     "from 0 on, got '");
    }
}
END_TEST

// A broken floating-point environment ----------------------------------------

static int run_query(int argc, char *argv[])
{
    return tf_command_run(&tf_query_command, argc, argv);
}

START_TEST(a_broken_environment_is_reported)
{
    static const char *const arguments[] = {"tanglefree query",
                                            "--kind=point-edge", "in", NULL};
    make_file("in", HIT);
    char message[1000];
    snprintf(message, sizeof message, "tanglefree: in:1: %s\n",
             tf_status_message(TF_BAD_ENVIRONMENT));
    expect(run_broken(_i, run_query, arguments), 2, HEADER, message);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/query_command");
    TCase *answers = tcase_create("answers");
    tcase_add_checked_fixture(answers, enter_folder, leave_folder);
    tcase_add_test(answers, a_hit_and_a_miss_are_told_apart);
    tcase_add_test(answers, every_kind_arithmetic_and_output_works);
    tcase_add_test(answers, exact_answers_agree_with_the_kept_truth);
    tcase_add_test(answers, vertex_face_is_point_triangle);
    tcase_add_test(answers, exact_is_the_arithmetic_unless_told);
    tcase_add_test(answers, three_exact_arithmetics_agree_on_integers);
    tcase_add_test(answers, undecided_is_a_hit);
    tcase_add_test(answers, json_is_an_array_of_objects);
    tcase_add_test(answers, json_of_a_hit_has_numbers);
    tcase_add_test(answers, json_has_finite_numbers_only);
    tcase_add_test(answers, json_is_closed_before_bad_input);
    tcase_add_test(answers, summary_tells_agreement_with_the_truth);
    suite_add_tcase(suite, answers);

    TCase *methods = tcase_create("methods");
    tcase_add_checked_fixture(methods, enter_folder, leave_folder);
    tcase_add_test(methods, every_kind_method_and_output_works);
    tcase_add_test(methods, spacetime_is_the_method_unless_told);
    tcase_add_test(methods, the_cubic_answers);
    tcase_add_test(methods, tolerances_and_thresholds_count);
    tcase_add_test(methods, methods_are_compared);
    suite_add_tcase(suite, methods);

    TCase *input = tcase_create("input");
    tcase_add_checked_fixture(input, enter_folder, leave_folder);
    tcase_add_test(input, several_files_are_counted_through);
    tcase_add_test(input, standard_input_is_read);
    tcase_add_test(input, a_pipe_that_ends_within_a_query_is_refused);
    tcase_add_test(input, messages_count_through_the_files_too);
    tcase_add_test(input, names_send_no_commands_to_the_terminal);
    tcase_add_test(input, progress_is_shown_on_a_terminal);
    tcase_add_test(input, closed_standard_input_is_refused);
    tcase_add_test(input, windows_text_is_read);
    tcase_add_test(input, rounded_coordinates_are_counted);
    tcase_add_test(input, memory_does_not_grow_with_the_file);
    suite_add_tcase(suite, input);

    TCase *bad = tcase_create("bad input");
    tcase_add_checked_fixture(bad, enter_folder, leave_folder);
    tcase_add_loop_test(bad, bad_rows_are_refused, 0,
                        sizeof faults / sizeof *faults);
    tcase_add_test(bad, a_zero_denominator_is_refused);
    tcase_add_test(bad, a_nul_byte_is_refused);
    tcase_add_test(bad, an_empty_file_is_refused);
    tcase_add_test(bad, a_directory_is_refused);
    tcase_add_test(bad, an_absent_file_is_refused);
    tcase_add_test(bad, a_file_that_vanishes_is_refused);
    tcase_add_test(bad, a_coordinate_out_of_range_is_refused);
    tcase_add_test(bad, rounding_is_told_before_bad_input);
    suite_add_tcase(suite, bad);

    TCase *unwritten = tcase_create("output that cannot be written");
    tcase_add_checked_fixture(unwritten, enter_folder, leave_folder);
    tcase_add_test(unwritten, what_is_written_to_a_file_is_what_is_printed);
    tcase_add_test(unwritten, a_file_appears_whole_or_not_at_all);
    tcase_add_test(unwritten, a_file_that_cannot_be_written_is_named);
    tcase_add_test(unwritten, old_spellings_are_refused);
    tcase_add_test(unwritten, a_full_disk_is_reported);
    tcase_add_test(unwritten, a_full_disk_on_the_way_is_reported);
    tcase_add_test(unwritten, a_full_disk_for_help_is_reported);
    tcase_add_test(unwritten, closed_standard_output_is_reported);
    tcase_add_test(unwritten, a_reader_that_leaves_ends_the_program);
    suite_add_tcase(suite, unwritten);

    TCase *usage = tcase_create("usage");
    tcase_add_checked_fixture(usage, enter_folder, leave_folder);
    tcase_add_test(usage, help_lists_the_commands);
    tcase_add_test(usage, help_describes_the_command);
    tcase_add_test(usage, version_is_printed);
    tcase_add_test(usage, unknown_commands_are_refused);
    tcase_add_test(usage, wrong_options_are_refused);
    tcase_add_test(usage, invalid_distances_are_refused);
    suite_add_tcase(suite, usage);

    TCase *environment = tcase_create("a broken environment");
    tcase_add_checked_fixture(environment, enter_folder, leave_folder);
    tcase_add_loop_test(environment, a_broken_environment_is_reported, 0,
                        environments());
    suite_add_tcase(suite, environment);
    return suite;
}
