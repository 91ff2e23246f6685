// What is told of steps: a line of the table, and the totals.
#include "program/step_fields.h"

#include "simulate/cloth_scenes.h"
#include "simulate/cloth_simulation.h"
#include "simulate/flow_scenes.h"
#include "simulate/flow_simulation.h"
#include "support/program.h"
#include "support/support.h"

#include <string.h>

/// The file "text", which was written to the stream.
static const char *text_of(FILE *stream)
{
    fclose(stream);
    return file_text("text");
}

static const char *line_of(const tf_simulation *s)
{
    FILE *stream = fopen("text", "w");
    tf_record_write_csv(stream, tf_step_columns(s->scene->kind), s);
    return text_of(stream);
}

static const char *totals_as(tf_format format, const tf_step_totals *totals,
                             const tf_simulation *s)
{
    FILE *stream = fopen("text", "w");
    ck_assert(tf_step_totals_write(stream, format, totals, s));
    return text_of(stream);
}

static const char *totals_of(const tf_step_totals *totals,
                             const tf_simulation *s)
{
    return totals_as(TF_SUMMARY, totals, s);
}

static const char *heading_of(const tf_simulation_kind *kind)
{
    FILE *stream = fopen("text", "w");
    tf_record_write_head(stream, tf_step_columns(kind));
    return text_of(stream);
}

// Cloth -----------------------------------------------------------------------

static const tf_cloth_simulation cloth = {
    .base = {.scene = tf_cloth_scenes,
             .setup.body = {.vertices = 5, .triangles = 4},
             .step = 12,
             .time = 0.12},
    .report = {.response = {.first_contacts = 2,
                            .contacts = 3,
                            .rounds = {4, 5, 6, 7},
                            .constraints = 8,
                            .held = 9,
                            .grouped = 10,
                            .resting = 11},
               .stretch = 1.5,
               .kinetic = 0.25,
               .elastic = 1e-7,
               .dynamics_seconds = 0.5,
               .response_seconds = 0.25},
};

START_TEST(a_line_of_cloth_has_its_report)
{
    ck_assert_str_eq(line_of(&cloth.base),
                     "12,0.12,2,3,4,5,6,7,8,9,10,11,1.500000,0.25,1e-07,"
                     "0.500000,0.250000\n");
    ck_assert_str_eq(
        heading_of(&tf_cloth_kind),
        "step,time,first_contacts,contacts,impulse_rounds,zone_rounds,"
        "rigid_rounds,failsafe_rounds,rows,held,grouped,resting,stretch,"
        "kinetic_energy,elastic_energy,dynamics_seconds,response_seconds\n");
}
END_TEST

START_TEST(totals_of_cloth_are_sums)
{
    tf_cloth_simulation calm = cloth;
    calm.report.response.rounds[TF_FAILSAFE] = 0;
    tf_step_totals totals = {0};
    char words[TF_STEP_WORDS];
    tf_step_totals_add(&totals, &cloth.base);
    tf_step_totals_add(&totals, &calm.base);
    tf_step_totals_add(&totals, &cloth.base);
    ck_assert_str_eq(totals_of(&totals, &cloth.base),
                     "steps: 3\nvertices: 5\ntriangles: 4\ncontacts: 9\n"
                     "failsafe steps: 2\nheld: 27\ndynamics seconds: 1.5\n"
                     "response seconds: 0.75\n");
    ck_assert_str_eq(totals_as(TF_JSON, &totals, &cloth.base),
                     "{\"steps\":3,\"vertices\":5,\"triangles\":4,"
                     "\"contacts\":9,\"failsafe_steps\":2,\"held\":27,"
                     "\"dynamics_seconds\":1.5,\"response_seconds\":0.75}\n");
    ck_assert_str_eq(totals_as(TF_CSV, &totals, &cloth.base),
                     "steps,vertices,triangles,contacts,failsafe_steps,held,"
                     "dynamics_seconds,response_seconds\n"
                     "3,5,4,9,2,27,1.5,0.75\n");
    tf_step_describe(&cloth.base, 7, words);
    ck_assert_str_eq(words, "of 7 steps, 3 contacts");
}
END_TEST

// Flows -----------------------------------------------------------------------

static tf_flow_simulation *flow(void)
{
    tf_simulation *made = NULL;
    const tf_scene *scene = tf_scene_named(tf_flow_scenes, "enright");
    ck_assert_int_eq(tf_simulation_create(scene, 0.08, &made), TF_OK);
    return (tf_flow_simulation *)made;
}

/// Numbers that are different for each outcome of each operation.
static void set_report(tf_flow_simulation *f)
{
    f->reconnected = (tf_reconnect_report){.gained = {0.5, -0.25, 1e-9}};
    f->response = (tf_response_report){
        .contacts = 91, .rounds = {0, 92, 0, 93}, .moved = 94};
    f->report = (tf_flow_report){.seconds = {1, 2, 3}};
    for (size_t o = TF_COMMITTED; o < TF_OUTCOMES; o++) {
        for (size_t i = 0; i < TF_OPERATIONS; i++)
            f->report.tried[i][o] = 100 + 10 * i + o;
        f->report.shifted[o] = 200 + o;
        for (size_t i = 0; i < TF_RECONNECTIONS; i++)
            f->reconnected.tried[i][o] = 300 + 10 * i + o;
    }
}

START_TEST(a_line_of_a_flow_has_its_measures_and_its_report)
{
    tf_flow_simulation *f = flow();
    tf_simulation_go_to(&f->base, 4);
    f->measures = (tf_flow_measures){42, 80, 1, 2, 3, 0.25, 0.125};
    set_report(f);
    ck_assert_str_eq(
        line_of(&f->base),
        "4,0.04,42,80,1,2,3,0.25,0.125,"
        "101,102,103,104,105,106,107,111,112,113,114,115,116,117,"
        "121,122,123,124,125,126,127,131,132,133,134,135,136,137,"
        "201,202,203,204,205,206,207,301,302,303,304,305,306,307,"
        "311,312,313,314,315,316,317,321,322,323,324,325,326,327,"
        "0.5,-0.25,1e-09,91,92,93,94,1.000000,2.000000,3.000000\n");
    const char *heading = heading_of(&tf_flow_kind);
    expect_words(heading, "step,time,vertices,triangles,components,genus,rims,"
                          "area,volume,split_done,split_impossible,");
    expect_words(heading, ",shift_done,shift_impossible,shift_flattened,"
                          "shift_overlapped,shift_passed_vertex,"
                          "shift_passed_edge,shift_passed_triangle,");
    expect_words(heading,
                 ",merge_gain,pinch_gain,drop_gain,contacts,zone_rounds,"
                 "failsafe_rounds,moved,improve_seconds,reconnect_seconds,"
                 "advance_seconds\n");
    tf_simulation_free(&f->base);
}
END_TEST

START_TEST(totals_of_a_flow_are_sums_and_last_measures)
{
    tf_flow_simulation *f = flow();
    char words[TF_STEP_WORDS];
    tf_step_totals totals = {0};
    set_report(f);
    tf_step_totals_add(&totals, &f->base);
    f->measures.area = 0.5;
    f->measures.volume = 0.25;
    tf_step_totals_add(&totals, &f->base);
    ck_assert_str_eq(totals_of(&totals, &f->base),
                     "steps: 2\nvertices: 42\ntriangles: 80\n"
                     "components: 1\ngenus: 0\narea: 0.5\nvolume: 0.25\n"
                     "merges: 602\npinches: 622\ndrops: 642\n"
                     "contacts: 182\nfailsafe steps: 2\n"
                     "improve seconds: 2\nreconnect seconds: 4\n"
                     "advance seconds: 6\n");
    tf_step_describe(&f->base, 7, words);
    ck_assert_str_eq(words, "of 7 steps, 80 triangles");
    tf_simulation_free(&f->base);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/step_fields");
    TCase *tcase = tcase_create("fields");
    tcase_add_checked_fixture(tcase, enter_folder, leave_folder);
    tcase_add_test(tcase, a_line_of_cloth_has_its_report);
    tcase_add_test(tcase, totals_of_cloth_are_sums);
    tcase_add_test(tcase, a_line_of_a_flow_has_its_measures_and_its_report);
    tcase_add_test(tcase, totals_of_a_flow_are_sums_and_last_measures);
    suite_add_tcase(suite, tcase);
    return suite;
}
