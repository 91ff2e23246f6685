// Groups, against a list of which number is in which.
#include "response/groups.h"

#include "support/support.h"

enum {
    NUMBERS = 60
};

static int least_of[NUMBERS];

static void unite_in_list(int a, int b)
{
    int from = least_of[a] < least_of[b] ? least_of[b] : least_of[a];
    int to = least_of[a] < least_of[b] ? least_of[a] : least_of[b];
    for (int i = 0; i < NUMBERS; i++)
        if (least_of[i] == from)
            least_of[i] = to;
}

START_TEST(roots_are_the_least_members)
{
    generator random = generator_new(100);
    tf_groups groups = {0};
    for (int times = 0; times < (int)cases(200); times++) {
        ck_assert(tf_groups_begin(&groups, NUMBERS));
        for (int i = 0; i < NUMBERS; i++)
            least_of[i] = i;
        for (int unions = below(&random, 2 * NUMBERS); unions > 0; unions--) {
            int a = below(&random, NUMBERS), b = below(&random, NUMBERS);
            int root = tf_groups_unite(&groups, a, b);
            unite_in_list(a, b);
            ck_assert_int_eq(root, least_of[a]);
        }
        for (int i = 0; i < NUMBERS; i++)
            ck_assert_int_eq(tf_groups_find(&groups, i), least_of[i]);
    }
    tf_buffer_free(&groups.storage);
}
END_TEST

START_TEST(finding_shortens_chains)
{
    tf_groups groups = {0};
    ck_assert(tf_groups_begin(&groups, NUMBERS));
    for (int i = 1; i < NUMBERS; i++)
        groups.parent[i] = i - 1;
    ck_assert_int_eq(tf_groups_find(&groups, NUMBERS - 1), 0);
    int steps = 0;
    for (int i = NUMBERS - 1; groups.parent[i] != i; i = groups.parent[i])
        steps++;
    ck_assert_int_le(steps, NUMBERS / 2 + 1);
    tf_buffer_free(&groups.storage);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("response/groups");
    TCase *tcase = tcase_create("groups");
    tcase_add_test(tcase, roots_are_the_least_members);
    tcase_add_test(tcase, finding_shortens_chains);
    suite_add_tcase(suite, tcase);
    return suite;
}
