// From a clear state back to the input.
#include "untangle/way_home.h"

#include "support/support.h"
#include "support/tangles.h"

#include <string.h>

static made_tangle own;
static double x[3 * TANGLE_VERTICES];
static tf_way_home way;

static tf_status go_home(void)
{
    tf_resolver *resolver = NULL;
    ck_assert_int_eq(tf_resolver_create(own.surface, &resolver), TF_OK);
    way = (tf_way_home){.steps = 0};
    tf_status status = tf_way_home_take(&way, resolver, &own.tangle, x);
    tf_resolver_free(resolver);
    return status;
}

static void release(void)
{
    tf_way_home_free(&way);
    tangle_free(&own);
}

static double squares(void)
{
    double sum = 0;
    for (int i = 0; i < 3 * own.mesh.vertices; i++)
        sum += (x[i] - own.x[i]) * (x[i] - own.x[i]);
    return sum;
}

/// A bump that is lifted out of the sheet.
static void lift(double height)
{
    tangle_make_bump(&own, 3);
    tangle_finish(&own);
    memcpy(x, own.x, sizeof x);
    for (int v = 169; v < 338; v++)
        x[3 * v + 2] += height;
}

START_TEST(what_meets_nothing_comes_home)
{
    lift(5);
    double before = squares();
    ck_assert_int_eq(go_home(), TF_OK);
    ck_assert_double_lt(squares(), before / 10);
    ck_assert_int_gt(way.steps, 0);
    ck_assert_int_eq(tf_tangle_check(&own.tangle, x), TF_OK);
    ck_assert_uint_eq(own.tangle.crossings.count, 0);
    // Both sheets' corners are far from the bump.
    ck_assert_mem_eq(x, own.x, 3 * sizeof *x);
    ck_assert_mem_eq(x + 507, own.x + 507, 3 * sizeof *x);
    release();
}
END_TEST

START_TEST(fixed_vertices_stay)
{
    lift(5);
    memset(own.fixed, 1, 169);
    ck_assert_int_eq(go_home(), TF_OK);
    ck_assert_mem_eq(x, own.x, 507 * sizeof *x);
    ck_assert_int_eq(tf_tangle_check(&own.tangle, x), TF_OK);
    ck_assert_uint_eq(own.tangle.crossings.count, 0);
    release();
}
END_TEST

START_TEST(a_free_way_ends_bit_for_bit)
{
    tangle_make_bump(&own, 0.1);
    own.x[3 * 300] = 1.0 / 3;
    tangle_finish(&own);
    memcpy(x, own.x, sizeof x);
    for (int v = 169; v < 338; v++)
        x[3 * v + 2] += 1 / 7.0;
    ck_assert_int_eq(go_home(), TF_OK);
    ck_assert_mem_eq(x, own.x, sizeof x);
    release();
}
END_TEST

START_TEST(at_home_nothing_is_to_be_done)
{
    tangle_make_bump(&own, 0.1);
    tangle_finish(&own);
    memcpy(x, own.x, sizeof x);
    ck_assert_int_eq(go_home(), TF_OK);
    ck_assert_mem_eq(x, own.x, sizeof x);
    ck_assert_int_eq(way.steps, 0);
    release();
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("untangle/way_home");
    TCase *tcase = tcase_create("way_home");
    tcase_add_test(tcase, what_meets_nothing_comes_home);
    tcase_add_test(tcase, fixed_vertices_stay);
    tcase_add_test(tcase, a_free_way_ends_bit_for_bit);
    tcase_add_test(tcase, at_home_nothing_is_to_be_done);
    suite_add_tcase(suite, tcase);
    return suite;
}
