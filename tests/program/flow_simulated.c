// A flow as it is simulated for the user.
#include "program/flow_simulated.h"

#include "support/program.h"
#include "support/support.h"

#include <errno.h>
#include <string.h>

static tf_flow_simulated *flow(const char *scene, double edge)
{
    tf_simulated *made = NULL;
    ck_assert_int_eq(tf_flow_simulate(tf_flow_scene_named(scene), edge, &made),
                     TF_OK);
    return (tf_flow_simulated *)made;
}

static void advance(tf_flow_simulated *f)
{
    static const tf_step_way way;
    char words[TF_SIMULATED_NAME];
    ck_assert_int_eq(f->base.kind->advance(&f->base, &way, words), TF_OK);
}

static void write_frame(const tf_flow_simulated *f, const char *path)
{
    FILE *stream = fopen(path, "wb");
    ck_assert(f->base.kind->write_frame(stream, &f->base));
    fclose(stream);
}

static void free_flow(tf_flow_simulated *f)
{
    f->base.kind->free(&f->base);
}

START_TEST(a_name_has_the_digits_that_it_needs)
{
    static const double edges[] = {0.05, 0.0625, 0.1, 1.0 / 30};
    static const char *const names[] = {
        "enright --edge 0.05", "enright --edge 0.0625", "enright --edge 0.1",
        "enright --edge 0.03333333333333333"};
    for (int i = 0; i < 4; i++) {
        tf_flow_simulated *f = flow("enright", edges[i]);
        ck_assert_str_eq(f->base.name, names[i]);
        free_flow(f);
    }
}
END_TEST

START_TEST(a_line_has_a_number_for_each_column)
{
    tf_flow_simulated *f = flow("enright", 0.08);
    advance(f);
    FILE *table = fopen("line", "w");
    f->base.kind->write_line(table, &f->base);
    fclose(table);
    const char *line = file_text("line");
    expect_words(line, ",42,80,1,0,0,");
    ck_assert_int_eq(occurrences(line, ","),
                     occurrences(f->base.kind->columns, ",") + 1);
    free_flow(f);
}
END_TEST

START_TEST(a_frame_is_gone_on_from)
{
    tf_flow_simulated *whole = flow("dumbbell", 0.08);
    tf_flow_simulated *parts = flow("dumbbell", 0.08);
    for (int i = 0; i < 3; i++)
        advance(whole);
    write_frame(whole, "frame");
    ck_assert_int_eq(parts->base.kind->read_frame(&parts->base, "frame"),
                     TF_FRAME_GOOD);
    ck_assert_int_eq(parts->base.step, 3);
    advance(whole);
    advance(parts);
    write_frame(whole, "one");
    write_frame(parts, "other");
    expect(run("cmp one other"), 0, "", "");
    free_flow(whole);
    free_flow(parts);
}
END_TEST

START_TEST(what_is_no_frame)
{
    tf_flow_simulated *f = flow("enright", 0.08);
    tf_flow_simulated *finer = flow("enright", 0.07);
    write_frame(f, "frame");
    ck_assert_int_eq(finer->base.kind->read_frame(&finer->base, "frame"),
                     TF_FRAME_FOREIGN);
    ck_assert_int_eq(f->base.kind->read_frame(&f->base, "missing"),
                     TF_FRAME_UNREADABLE);
    ck_assert_int_eq(errno, ENOENT);
    run("head -c 1000 frame >cut");
    ck_assert_int_eq(f->base.kind->read_frame(&f->base, "cut"),
                     TF_FRAME_FOREIGN);
    // Two vertices in one place: it is no surface.
    run("sed 's/, step 0/, step 1/' frame >later; "
        "head -c -4 frame >end; printf '\\000\\000\\000\\000' >>end");
    ck_assert_int_eq(f->base.kind->read_frame(&f->base, "later"),
                     TF_FRAME_GOOD);
    ck_assert_int_eq(f->base.step, 1);
    ck_assert_int_eq(f->base.kind->read_frame(&f->base, "end"),
                     TF_FRAME_FOREIGN);
    free_flow(f);
    free_flow(finer);
}
END_TEST

START_TEST(what_is_printed_in_the_end)
{
    tf_entry entry[TF_SIMULATED_ENTRIES];
    tf_flow_simulated *f = flow("enright", 0.08);
    advance(f);
    int count = f->base.kind->summarize(&f->base, entry);
    ck_assert_int_le(count, TF_SIMULATED_ENTRIES);
    ck_assert_str_eq(entry[0].name, "steps");
    ck_assert_uint_eq(entry[0].count, 1);
    ck_assert_str_eq(entry[count - 1].name, "advance seconds");
    free_flow(f);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/flow_simulated");
    TCase *tcase = tcase_create("flows");
    tcase_add_checked_fixture(tcase, enter_folder, leave_folder);
    tcase_add_test(tcase, a_name_has_the_digits_that_it_needs);
    tcase_add_test(tcase, a_line_has_a_number_for_each_column);
    tcase_add_test(tcase, a_frame_is_gone_on_from);
    tcase_add_test(tcase, what_is_no_frame);
    tcase_add_test(tcase, what_is_printed_in_the_end);
    suite_add_tcase(suite, tcase);
    return suite;
}
