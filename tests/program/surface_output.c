// The rows and the summary, to the letter.
#define _GNU_SOURCE // open_memstream, fopencookie

#include "program/surface_output.h"

#include "support/json.h"
#include "support/support.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#define HIT                                                                    \
    {                                                                          \
        .verdict = TF_HIT, .classification = TF_GENERIC, .toi_lo = 0.5,        \
        .toi_hi = 0.75, .normal = {1, 0, 0}, .normal_velocity = -2             \
    }

static const tf_surface_contact in_space[] = {
    {TF_POINT_TRIANGLE, {9, 1, 2, 3}, HIT},
    {TF_EDGE_EDGE, {0, 5, 1, 2147483647}, HIT},
};
static const tf_surface_contact in_plane[] = {
    {TF_POINT_EDGE, {2, 0, 1, -1}, HIT},
};

// Two steps in space, one without contacts; then one of the plane.
static const tf_contacts steps[] = {
    {true, 2, in_space, {10, 5, 3, 2}},
    {false, 0, NULL, {100, 50, 30, 20}},
    {true, 1, in_plane, {1000, 500, 300, 200}},
};
static const int axes[] = {3, 3, 2};

static const tf_crossing crossed[] = {
    {TF_EDGE_THROUGH_TRIANGLE, {0, 1, 2, 3, 4}},
    {TF_POINT_ON_TRIANGLE, {9, 1, 2, 3, -1}},
    {TF_EDGE_ON_EDGE, {0, 5, 1, 2147483647, -1}},
};

static FILE *stream;
static char *text;
static size_t length;

static void begin(tf_surface_output *output, const char *format, bool checks)
{
    stream = open_memstream(&text, &length);
    ck_assert(tf_surface_output_begin(output, stream,
                                      tf_surface_format_named(format), checks));
}

/// Ends the output, which must be this.
static void expect(tf_surface_output *output, const char *right)
{
    ck_assert(tf_surface_output_end(output));
    ck_assert_int_eq(output->error, 0);
    fclose(stream);
    ck_assert_str_eq(text, right);
    free(text);
}

static void expect_steps(const char *format, int count, const char *right)
{
    tf_surface_output output;
    begin(&output, format, false);
    for (int i = 0; i < count; i++)
        ck_assert(tf_surface_output_contacts(&output, axes[i], &steps[i]));
    ck_assert_int_eq(output.tally.parts, count);
    expect(&output, right);
}

/// Checks of two files, the first of which is free of intersections.
static void expect_files(const char *format, const char *name,
                         const char *right)
{
    tf_surface_output output;
    begin(&output, format, true);
    tf_crossings none = {0, NULL}, all = {3, crossed};
    ck_assert(tf_surface_output_crossings(&output, "clear", &none));
    ck_assert_int_eq(output.tally.tangled, 0);
    ck_assert(tf_surface_output_crossings(&output, name, &all));
    ck_assert_int_eq(output.tally.tangled, 1);
    expect(&output, right);
}

// Contacts --------------------------------------------------------------------

#define HEADER "step,kind,a,b,c,d,toi_lo,toi_hi,nx,ny,nz,normal_velocity,case\n"

START_TEST(contacts_as_csv)
{
    expect_steps("csv", 0, HEADER);
    expect_steps("csv", 3,
                 HEADER
                 "0,point-triangle,9,1,2,3,0.5,0.75,1,0,0,-2,generic\n"
                 "0,edge-edge,0,5,1,2147483647,0.5,0.75,1,0,0,-2,generic\n"
                 "2,point-edge,2,0,1,,0.5,0.75,1,0,,-2,generic\n");
}
END_TEST

#define SUMMARY_OF_NONE                                                        \
    "\"summary\":{\"steps\":0,\"steps_with_contacts\":0,\"contacts\":0,"       \
    "\"candidates\":0,\"decided_by_axis\":0,\"decided_by_filter\":0,"          \
    "\"decided_by_signs\":0}}\n"

START_TEST(contacts_as_json)
{
    expect_steps("json", 0, "{\"contacts\":[\n],\n" SUMMARY_OF_NONE);
    expect_steps(
        "json", 3,
        "{\"contacts\":[\n"
        "{\"step\":0,\"kind\":\"point-triangle\",\"a\":9,\"b\":1,\"c\":2,"
        "\"d\":3,\"toi_lo\":0.5,\"toi_hi\":0.75,\"nx\":1,\"ny\":0,\"nz\":0,"
        "\"normal_velocity\":-2,\"case\":\"generic\"},\n"
        "{\"step\":0,\"kind\":\"edge-edge\",\"a\":0,\"b\":5,\"c\":1,"
        "\"d\":2147483647,\"toi_lo\":0.5,\"toi_hi\":0.75,\"nx\":1,\"ny\":0,"
        "\"nz\":0,\"normal_velocity\":-2,\"case\":\"generic\"},\n"
        "{\"step\":2,\"kind\":\"point-edge\",\"a\":2,\"b\":0,\"c\":1,"
        "\"d\":null,\"toi_lo\":0.5,\"toi_hi\":0.75,\"nx\":1,\"ny\":0,"
        "\"nz\":null,\"normal_velocity\":-2,\"case\":\"generic\"}\n"
        "],\n"
        "\"summary\":{\"steps\":3,\"steps_with_contacts\":2,\"contacts\":3,"
        "\"candidates\":1110,\"decided_by_axis\":555,"
        "\"decided_by_filter\":333,\"decided_by_signs\":222}}\n");
}
END_TEST

START_TEST(contacts_counted)
{
    expect_steps("summary", 3,
                 "steps: 3\nsteps with contacts: 2\ncontacts: 3\n"
                 "candidates: 1110\ndecided by axis: 555\n"
                 "decided by filter: 333\ndecided by signs: 222\n");
}
END_TEST

// Intersections ---------------------------------------------------------------

START_TEST(crossings_as_csv)
{
    expect_files("csv", "a",
                 "file,kind,a,b,c,d,e,f\n"
                 "a,edge-triangle,0,1,2,3,4,\n"
                 "a,point-triangle,9,1,2,3,,\n"
                 "a,edge-edge,0,5,1,2147483647,,\n");
}
END_TEST

START_TEST(crossings_as_json)
{
    expect_files("json", "a",
                 "{\"intersections\":[\n"
                 "{\"file\":\"a\",\"kind\":\"edge-triangle\",\"a\":0,\"b\":1,"
                 "\"c\":2,\"d\":3,\"e\":4},\n"
                 "{\"file\":\"a\",\"kind\":\"point-triangle\",\"a\":9,\"b\":1,"
                 "\"c\":2,\"d\":3,\"e\":null},\n"
                 "{\"file\":\"a\",\"kind\":\"edge-edge\",\"a\":0,\"b\":5,"
                 "\"c\":1,\"d\":2147483647,\"e\":null}\n"
                 "],\n\"summary\":{\"files\":2,\"files_with_intersections\":1,"
                 "\"intersections\":3}}\n");
}
END_TEST

START_TEST(crossings_counted)
{
    expect_files("summary", "a",
                 "files: 2\nfiles with intersections: 1\nintersections: 3\n");
}
END_TEST

/// Names, as fields of CSV and as strings of JSON.
static const struct {
    const char *name, *csv, *json;
} names[] = {
    {"a b.obj", "a b.obj", "\"a b.obj\""},
    {"a,b", "\"a,b\"", "\"a,b\""},
    {"a\"b", "\"a\"\"b\"", "\"a\\\"b\""},
    {"\"", "\"\"\"\"", "\"\\\"\""},
    {"a\nb", "\"a\nb\"", "\"a\\\\x0ab\""},
    {"a\rb", "\"a\rb\"", "\"a\\\\x0db\""},
    {"a\\b", "a\\b", "\"a\\\\b\""},
    {"\x1b\x01", "\x1b\x01", "\"\\\\x1b\\\\x01\""},
    {"\xc3\xa9", "\xc3\xa9", "\"\xc3\xa9\""},
    {"\xff\xc3", "\xff\xc3", "\"\\\\xff\\\\xc3\""},
    {"%s%n", "%s%n", "\"%s%n\""},
    {"", "", "\"\""},
};

START_TEST(names_of_files)
{
    tf_surface_output output;
    tf_crossings one = {1, crossed};
    char right[1000];
    begin(&output, "csv", true);
    tf_surface_output_crossings(&output, names[_i].name, &one);
    snprintf(right, sizeof right,
             "file,kind,a,b,c,d,e,f\n%s,edge-triangle,0,1,2,3,4,\n",
             names[_i].csv);
    expect(&output, right);
    begin(&output, "json", true);
    tf_surface_output_crossings(&output, names[_i].name, &one);
    ck_assert(tf_surface_output_end(&output));
    fclose(stream);
    ck_assert_msg(!json_fault(text), "%s", json_fault(text));
    snprintf(right, sizeof right, "{\"file\":%s,", names[_i].json);
    ck_assert_msg(strstr(text, right), "'%s' is not in '%s'", right, text);
    free(text);
}
END_TEST

// Formats and full disks ------------------------------------------------------

START_TEST(formats_by_their_names)
{
    ck_assert_ptr_null(tf_surface_format_named(""));
    ck_assert_ptr_null(tf_surface_format_named("xml"));
    char list[] = TF_SURFACE_FORMAT_NAMES;
    int found = 0;
    char *rest = list;
    for (char *name; (name = strtok_r(rest, ", ", &rest));)
        found += tf_surface_format_named(name) != NULL;
    ck_assert_int_eq(found, 3);
}
END_TEST

START_TEST(full_disk_at_the_end)
{
    FILE *full = fopen("/dev/full", "w");
    tf_surface_output output;
    ck_assert(tf_surface_output_begin(&output, full,
                                      tf_surface_format_named("csv"), false));
    ck_assert(!tf_surface_output_end(&output));
    ck_assert_int_eq(output.error, ENOSPC);
    fclose(full);
}
END_TEST

START_TEST(full_disk_on_the_way)
{
    for (int checks = 0; checks < 2; checks++) {
        FILE *full = fopen("/dev/full", "w");
        tf_surface_output output;
        tf_surface_output_begin(&output, full, tf_surface_format_named("json"),
                                checks);
        tf_crossings all = {3, crossed};
        bool good = true;
        for (int i = 0; i < 10000 && good; i++)
            good = checks ? tf_surface_output_crossings(&output, "a", &all)
                          : tf_surface_output_contacts(&output, 3, &steps[0]);
        ck_assert(!good);
        ck_assert_int_eq(output.error, ENOSPC);
        errno = 0;
        ck_assert(!tf_surface_output_end(&output));
        ck_assert_int_eq(output.error, ENOSPC);
        fclose(full);
    }
}
END_TEST

START_TEST(full_disk_within_a_step)
{
    // No more rows are written than fit.
    enum {
        MANY = 100000
    };
    tf_surface_contact *row = calloc(MANY, sizeof *row);
    for (int i = 0; i < MANY; i++)
        row[i] = in_space[0];
    tf_contacts many = {true, MANY, row, {0}};
    FILE *full = fopen("/dev/full", "w");
    tf_surface_output output;
    tf_surface_output_begin(&output, full, tf_surface_format_named("csv"),
                            false);
    ck_assert(!tf_surface_output_contacts(&output, 3, &many));
    ck_assert_int_lt(output.tally.rows, 10000);
    fclose(full);
    free(row);
}
END_TEST

/// Fails for another reason each time.
static ssize_t fail_to_write(void *reason, const char *bytes, size_t size)
{
    (void)bytes;
    (void)size;
    errno = ++*(int *)reason;
    return 0;
}

START_TEST(the_first_reason_counts)
{
    int reason = ENOENT;
    cookie_io_functions_t functions = {.write = fail_to_write};
    FILE *full = fopencookie(&reason, "w", functions);
    setvbuf(full, NULL, _IONBF, 0);
    tf_surface_output output;
    ck_assert(!tf_surface_output_begin(&output, full,
                                       tf_surface_format_named("csv"), true));
    int first = output.error;
    ck_assert_int_gt(first, ENOENT);
    ck_assert(!tf_surface_output_end(&output));
    ck_assert_int_eq(output.error, first);
    fclose(full);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/surface_output");
    TCase *contacts = tcase_create("contacts");
    tcase_add_test(contacts, contacts_as_csv);
    tcase_add_test(contacts, contacts_as_json);
    tcase_add_test(contacts, contacts_counted);
    suite_add_tcase(suite, contacts);

    TCase *crossings = tcase_create("intersections");
    tcase_add_test(crossings, crossings_as_csv);
    tcase_add_test(crossings, crossings_as_json);
    tcase_add_test(crossings, crossings_counted);
    tcase_add_loop_test(crossings, names_of_files, 0,
                        sizeof names / sizeof *names);
    suite_add_tcase(suite, crossings);

    TCase *formats = tcase_create("formats");
    tcase_add_test(formats, formats_by_their_names);
    tcase_add_test(formats, full_disk_at_the_end);
    tcase_add_test(formats, full_disk_on_the_way);
    tcase_add_test(formats, full_disk_within_a_step);
    tcase_add_test(formats, the_first_reason_counts);
    suite_add_tcase(suite, formats);
    return suite;
}
