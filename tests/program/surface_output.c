// The rows and the summary, to the letter.
#define _GNU_SOURCE // open_memstream

#include "program/surface_output.h"

#include "support/support.h"

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
    {true, 2, in_space, {10, 5, 3, 2, {0}}},
    {false, 0, NULL, {100, 50, 30, 20, {0}}},
    {true, 1, in_plane, {1000, 500, 300, 200, {0}}},
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

static void begin(tf_surface_output *output,
                  const tf_surface_output_options *options)
{
    stream = open_memstream(&text, &length);
    ck_assert(tf_surface_output_begin(output, stream, options));
}

/// A surface of one mesh of that name.
static tf_surface_part part_of(const char *name)
{
    static int first[] = {0, 2147483647};
    static const tf_joined joined = {1, first, first, first};
    static const char *names[1];
    static bool listed[1];
    names[0] = name;
    return (tf_surface_part){&joined, names, listed};
}

/// Ends the output, which must be this.
static void expect(tf_surface_output *output, const char *right)
{
    ck_assert(tf_surface_output_end(output, true));
    ck_assert_int_eq(output->records.error, 0);
    fclose(stream);
    ck_assert_str_eq(text, right);
    free(text);
}

static void expect_steps(tf_format format, int count, const char *right)
{
    tf_surface_output output;
    tf_surface_part part = part_of("a");
    begin(&output, &(tf_surface_output_options){.format = format});
    for (int i = 0; i < count; i++)
        ck_assert(
            tf_surface_output_contacts(&output, &part, axes[i], &steps[i]));
    ck_assert_uint_eq(output.tally.parts, (size_t)count);
    expect(&output, right);
}

/// Checks of two files, the first of which is free of intersections.
static void expect_files(tf_format format, const char *name, const char *right)
{
    tf_surface_output output;
    begin(&output,
          &(tf_surface_output_options){.format = format, .checks = true});
    tf_crossings none = {0, NULL}, all = {3, crossed};
    tf_surface_part clear = part_of("clear");
    ck_assert(tf_surface_output_crossings(&output, &clear, &none));
    tf_surface_output_count(&output, &clear);
    ck_assert_uint_eq(output.tally.tangled, 0);
    tf_surface_part tangled = part_of(name);
    ck_assert(tf_surface_output_crossings(&output, &tangled, &all));
    tf_surface_output_count(&output, &tangled);
    ck_assert_uint_eq(output.tally.tangled, 1);
    expect(&output, right);
}

// Contacts --------------------------------------------------------------------

#define HEADER "step,kind,a,b,c,d,toi_lo,toi_hi,nx,ny,nz,normal_velocity,case\n"

START_TEST(csv_has_a_row_for_each_contact)
{
    expect_steps(TF_CSV, 0, HEADER);
    expect_steps(TF_CSV, 3,
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

START_TEST(json_has_all_contacts_and_their_summary)
{
    expect_steps(TF_JSON, 0, "{\"contacts\":[\n],\n" SUMMARY_OF_NONE);
    expect_steps(
        TF_JSON, 3,
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

START_TEST(a_summary_counts_steps_and_contacts)
{
    expect_steps(TF_SUMMARY, 3,
                 "steps: 3\nsteps with contacts: 2\ncontacts: 3\n"
                 "candidates: 1110\ndecided by axis: 555\n"
                 "decided by filter: 333\ndecided by signs: 222\n");
}
END_TEST

// Intersections ---------------------------------------------------------------

START_TEST(csv_has_a_row_for_each_intersection)
{
    expect_files(TF_CSV, "a",
                 "file,kind,a,b,c,d,e,f\n"
                 "a,edge-triangle,0,1,2,3,4,\n"
                 "a,point-triangle,9,1,2,3,,\n"
                 "a,edge-edge,0,5,1,2147483647,,\n");
}
END_TEST

START_TEST(json_has_all_intersections_and_their_summary)
{
    expect_files(TF_JSON, "a",
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

START_TEST(a_summary_counts_files_and_intersections)
{
    expect_files(TF_SUMMARY, "a",
                 "files: 2\nfiles with intersections: 1\nintersections: 3\n");
}
END_TEST

// Several meshes --------------------------------------------------------------

// Meshes of 4, 1, 0 and 6 vertices.
static int first_vertex[] = {0, 4, 5, 5, 11};
static const tf_joined joined = {4, first_vertex, first_vertex, first_vertex};
static const char *mesh_names[] = {"a", "b", "none", "d"};

static const tf_surface_contact between[] = {
    {TF_POINT_TRIANGLE, {4, 5, 6, 10}, HIT},
    {TF_POINT_TRIANGLE, {5, 1, 2, 3}, HIT},
    {TF_EDGE_EDGE, {0, 3, 9, 10}, HIT},
    {TF_EDGE_EDGE, {5, 6, 7, 8}, HIT},
};

START_TEST(contacts_have_the_numbers_and_names_of_meshes)
{
    bool listed[4] = {false};
    tf_surface_part part = {&joined, mesh_names, listed};
    tf_surface_output output;
    begin(&output, &(tf_surface_output_options){.format = TF_CSV,
                                                .names = TF_NAMES_OF_MESHES});
    tf_contacts found = {true, 4, between, {0}};
    ck_assert(tf_surface_output_contacts(&output, &part, 3, &found));
    expect(&output,
           "step,kind,a,b,c,d,toi_lo,toi_hi,nx,ny,nz,normal_velocity,case,"
           "mesh,other_mesh\n"
           "0,point-triangle,0,0,1,5,0.5,0.75,1,0,0,-2,generic,b,d\n"
           "0,point-triangle,0,1,2,3,0.5,0.75,1,0,0,-2,generic,d,a\n"
           "0,edge-edge,0,3,4,5,0.5,0.75,1,0,0,-2,generic,a,d\n"
           "0,edge-edge,0,1,2,3,0.5,0.75,1,0,0,-2,generic,d,d\n");
}
END_TEST

START_TEST(contacts_of_curves_have_the_names_of_meshes)
{
    bool listed[4] = {false};
    tf_surface_part part = {&joined, mesh_names, listed};
    static const tf_surface_contact flat[] = {
        {TF_POINT_EDGE, {4, 0, 3, -1}, HIT}};
    tf_surface_output output;
    begin(&output, &(tf_surface_output_options){.format = TF_JSON,
                                                .names = TF_NAMES_OF_MESHES});
    tf_contacts found = {true, 1, flat, {0}};
    ck_assert(tf_surface_output_contacts(&output, &part, 2, &found));
    ck_assert(tf_surface_output_end(&output, true));
    fclose(stream);
    ck_assert_ptr_nonnull(strstr(text, "\"a\":0,\"b\":0,\"c\":3,\"d\":null,"));
    ck_assert_ptr_nonnull(
        strstr(text, ",\"mesh\":\"b\",\"other_mesh\":\"a\"}\n"));
    free(text);
}
END_TEST

static const tf_crossing crossed_meshes[] = {
    {TF_EDGE_THROUGH_TRIANGLE, {5, 10, 1, 2, 3}},
    {TF_POINT_ON_TRIANGLE, {4, 1, 2, 3, -1}},
    {TF_EDGE_ON_EDGE, {5, 6, 7, 8, -1}},
};
static const tf_near_pair near_meshes[] = {
    {.kind = TF_POINT_TRIANGLE, .vertex = {5, 1, 2, 3}},
    {.kind = TF_EDGE_EDGE, .vertex = {0, 1, 2, 3}},
};

/// Checks two frames of the meshes, of which the first is clear, and a third in
/// which pairs are near.
static void expect_frames(tf_format format, tf_row_names names, bool measures,
                          const char *right)
{
    bool listed[4] = {false};
    tf_surface_part part = {&joined, mesh_names, listed};
    tf_surface_output output;
    tf_crossings all = {3, crossed_meshes};
    tf_near_pairs near = {.count = 2, .pair = near_meshes};
    begin(&output, &(tf_surface_output_options){.format = format,
                                                .checks = true,
                                                .measures = measures,
                                                .names = names});
    if (names == TF_NAMES_OF_MESHES)
        tf_surface_output_count(&output, &part);
    ck_assert(tf_surface_output_crossings(&output, &part, &all));
    if (names == TF_NAMES_OF_MESHES)
        tf_surface_output_count(&output, &part);
    if (measures)
        ck_assert(tf_surface_output_near(&output, &part, &near));
    tf_surface_output_count(&output, &part);
    expect(&output, right);
}

START_TEST(intersections_have_the_names_of_files)
{
    expect_frames(TF_CSV, TF_NAMES_OF_FILES, true,
                  "file,kind,a,b,c,d,e,f,other_file\n"
                  "d,edge-triangle,0,5,1,2,3,,a\n"
                  "b,point-triangle,0,1,2,3,,,a\n"
                  "d,edge-edge,0,1,2,3,,,d\n"
                  "d,near-point-triangle,0,1,2,3,,,a\n"
                  "a,near-edge-edge,0,1,2,3,,,a\n");
    expect_frames(TF_SUMMARY, TF_NAMES_OF_FILES, false,
                  "files: 4\nfiles with intersections: 3\nintersections: 3\n");
    expect_frames(TF_SUMMARY, TF_NAMES_OF_FILES, true,
                  "files: 4\nfiles with rows: 3\nintersections: 3\n"
                  "near pairs: 2\n");
}
END_TEST

START_TEST(intersections_have_a_frame_and_the_names_of_meshes)
{
    expect_frames(TF_CSV, TF_NAMES_OF_MESHES, true,
                  "frame,kind,a,b,c,d,e,f,mesh,other_mesh\n"
                  "1,edge-triangle,0,5,1,2,3,,d,a\n"
                  "1,point-triangle,0,1,2,3,,,b,a\n"
                  "1,edge-edge,0,1,2,3,,,d,d\n"
                  "2,near-point-triangle,0,1,2,3,,,d,a\n"
                  "2,near-edge-edge,0,1,2,3,,,a,a\n");
    expect_frames(
        TF_SUMMARY, TF_NAMES_OF_MESHES, false,
        "frames: 3\nframes with intersections: 1\nintersections: 3\n");
    expect_frames(TF_SUMMARY, TF_NAMES_OF_MESHES, true,
                  "frames: 3\nframes with rows: 2\nintersections: 3\n"
                  "near pairs: 2\n");
}
END_TEST

// Full disks ------------------------------------------------------------------

START_TEST(no_more_rows_are_written_than_fit)
{
    enum {
        MANY = 100000
    };
    tf_surface_contact *row = calloc(MANY, sizeof *row);
    for (int i = 0; i < MANY; i++)
        row[i] = in_space[0];
    tf_contacts many = {true, MANY, row, {0}};
    FILE *full = fopen("/dev/full", "w");
    tf_surface_output output;
    tf_surface_part part = part_of("a");
    tf_surface_output_begin(&output, full,
                            &(tf_surface_output_options){.format = TF_CSV});
    ck_assert(!tf_surface_output_contacts(&output, &part, 3, &many));
    ck_assert_uint_lt(output.tally.rows, 10000);
    fclose(full);
    free(row);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/surface_output");
    TCase *contacts = tcase_create("contacts");
    tcase_add_test(contacts, csv_has_a_row_for_each_contact);
    tcase_add_test(contacts, json_has_all_contacts_and_their_summary);
    tcase_add_test(contacts, a_summary_counts_steps_and_contacts);
    suite_add_tcase(suite, contacts);

    TCase *crossings = tcase_create("intersections");
    tcase_add_test(crossings, csv_has_a_row_for_each_intersection);
    tcase_add_test(crossings, json_has_all_intersections_and_their_summary);
    tcase_add_test(crossings, a_summary_counts_files_and_intersections);
    suite_add_tcase(suite, crossings);

    TCase *several = tcase_create("several meshes");
    tcase_add_test(several, contacts_have_the_numbers_and_names_of_meshes);
    tcase_add_test(several, contacts_of_curves_have_the_names_of_meshes);
    tcase_add_test(several, intersections_have_the_names_of_files);
    tcase_add_test(several, intersections_have_a_frame_and_the_names_of_meshes);
    suite_add_tcase(suite, several);

    TCase *disks = tcase_create("full disks");
    tcase_add_test(disks, no_more_rows_are_written_than_fit);
    suite_add_tcase(suite, disks);
    return suite;
}
