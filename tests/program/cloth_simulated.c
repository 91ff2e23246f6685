// Cloth as it is simulated for the user.
#include "program/cloth_simulated.h"

#include "support/program.h"
#include "support/support.h"

#include <string.h>

static tf_cloth_simulated *chain(void)
{
    tf_simulated *made = NULL;
    ck_assert_int_eq(
        tf_cloth_simulate(tf_scene_named("plane-chain"), 40, &made), TF_OK);
    return (tf_cloth_simulated *)made;
}

static const tf_step_cost cost = {
    .report = {.first_contacts = 2,
               .contacts = 3,
               .rounds = {4, 5, 6, 7},
               .constraints = 8,
               .held = 9,
               .grouped = 10,
               .resting = 11},
    .dynamics = 0.5,
    .response = 0.25,
};

START_TEST(a_line_of_the_table)
{
    tf_cloth_simulated *c = chain();
    c->simulation->stage.body.elastics = 0; // nothing is stretched
    c->last = cost;
    FILE *table = fopen("line", "w");
    c->base.kind->write_line(table, &c->base);
    fclose(table);
    ck_assert_str_eq(file_text("line"),
                     ",2,3,4,5,6,7,8,9,10,11,1.000000,0,0,0.500000,0.250000");
    ck_assert_str_eq(
        c->base.kind->columns,
        "first_contacts,contacts,impulse_rounds,zone_rounds,rigid_rounds,"
        "failsafe_rounds,rows,held,grouped,resting,stretch,kinetic_energy,"
        "elastic_energy,dynamics_seconds,response_seconds");
    c->base.kind->free(&c->base);
}
END_TEST

START_TEST(steps_are_counted)
{
    static const tf_step_way way;
    char words[TF_SIMULATED_NAME];
    tf_entry entry[TF_SIMULATED_ENTRIES];
    tf_cloth_simulated *c = chain();
    ck_assert_str_eq(c->base.name, "plane-chain --size 40");
    for (int i = 1; i <= 3; i++) {
        ck_assert_int_eq(c->base.kind->advance(&c->base, &way, words), TF_OK);
        ck_assert_int_eq(c->base.step, i);
        ck_assert_str_eq(words, "0 contacts");
    }
    ck_assert_int_eq(c->base.kind->summarize(&c->base, entry), 8);
    ck_assert_str_eq(entry[0].name, "steps");
    ck_assert_uint_eq(entry[0].count, 3);
    c->base.kind->free(&c->base);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/cloth_simulated");
    TCase *tcase = tcase_create("cloth");
    tcase_add_checked_fixture(tcase, enter_folder, leave_folder);
    tcase_add_test(tcase, a_line_of_the_table);
    tcase_add_test(tcase, steps_are_counted);
    suite_add_tcase(suite, tcase);
    return suite;
}
