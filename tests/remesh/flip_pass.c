// Edges flip to better triangles.
#include "remesh/remesher.h"

#include "support/adaptive_surfaces.h"
#include "support/remeshers.h"
#include "support/support.h"

static tf_remesher *kite(double height)
{
    static double place[4][3];
    static const double flat[4][3] = {
        {-3, 0, 0}, {0, -1, 0}, {3, 0, 0}, {0, 1, 0}};
    static const int triangle[] = {0, 1, 2, 0, 2, 3};
    for (int i = 0; i < 12; i++)
        place[i / 3][i % 3] =
            flat[i / 3][i % 3] + (i % 3 == 2 && i % 2 ? height : 0);
    return remesher_begin(adaptive_of(4, place, 2, triangle), 1);
}

START_TEST(the_short_diagonal_is_better)
{
    tf_remesher *remesher = kite(0);
    ck_assert_int_eq(tf_flip_pass(remesher), TF_OK);
    ck_assert_int_eq(done(remesher, TF_FLIP), 1);
    ck_assert(has_triangle(remesher->surface, 0, 1, 3));
    ck_assert_int_eq(tf_flip_pass(remesher), TF_OK); // and stays
    ck_assert_int_eq(done(remesher, TF_FLIP), 1);
    remesher_end(remesher);
}
END_TEST

START_TEST(a_bent_kite_stays)
{
    for (int i = 1; i < 3; i++) { // a little, and at a crease
        tf_remesher *remesher = kite(i);
        ck_assert_int_eq(tf_flip_pass(remesher), TF_OK);
        ck_assert_int_eq(done(remesher, TF_FLIP) + refused(remesher, TF_FLIP),
                         0);
        remesher_end(remesher);
    }
}
END_TEST

// All diagonals of squares are alike.
START_TEST(nothing_flips_for_nothing)
{
    tf_remesher *remesher = remesher_begin(adaptive_sheet(3, 3), 1);
    ck_assert_int_eq(tf_flip_pass(remesher), TF_OK);
    ck_assert_int_eq(done(remesher, TF_FLIP), 0);
    remesher_end(remesher);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("remesh/flip_pass");
    TCase *tcase = tcase_create("flips");
    tcase_add_test(tcase, the_short_diagonal_is_better);
    tcase_add_test(tcase, a_bent_kite_stays);
    tcase_add_test(tcase, nothing_flips_for_nothing);
    suite_add_tcase(suite, tcase);
    return suite;
}
