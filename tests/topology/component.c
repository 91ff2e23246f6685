// The parts of a surface.
#include "topology/component.h"

#include "support/blobs.h"
#include "support/support.h"

static tf_adaptive_surface *three_balls(void)
{
    static blobs made;
    made.vertices = made.triangles = 0;
    for (int i = 0; i < 3; i++) {
        const double middle[] = {3 * i, 0, 0};
        add_ball(&made, middle, 1, 2);
    }
    return blobs_surface(&made);
}

START_TEST(each_component_is_listed_once)
{
    tf_adaptive_surface *surface = three_balls();
    tf_components parts = {0};
    ck_assert(tf_components_begin(&parts, surface));
    ck_assert_int_eq(tf_components_add(&parts, surface, 40), 32);
    ck_assert_int_eq(tf_components_add(&parts, surface, 35), 0);
    ck_assert_int_eq(tf_components_add(&parts, surface, 0), 32);
    for (int i = 0; i < 64; i++) {
        int t = tf_components_list(&parts)[i];
        ck_assert_int_eq(t / 32, i < 32 ? 1 : 0);
        for (int j = 0; j < i; j++)
            ck_assert_int_ne(tf_components_list(&parts)[j], t);
    }
    ck_assert(tf_is_listed(&parts, 31));
    ck_assert(!tf_is_listed(&parts, 64));
    ck_assert(tf_components_begin(&parts, surface)); // again, empty
    ck_assert(!tf_is_listed(&parts, 31));
    tf_components_free(&parts);
    tf_adaptive_free(surface);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("topology/component");
    TCase *tcase = tcase_create("parts");
    tcase_add_test(tcase, each_component_is_listed_once);
    suite_add_tcase(suite, tcase);
    return suite;
}
