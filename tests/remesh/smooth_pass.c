// Vertices move to the middles of their stars.
#include "remesh/remesher.h"

#include "support/adaptive_surfaces.h"
#include "support/remeshers.h"
#include "support/support.h"
#include "surgery/star.h"

#include <math.h>

START_TEST(a_vertex_goes_back_to_the_middle)
{
    static const double off[] = {1.3, 0.8, 0};
    tf_remesher *remesher = remesher_begin(adaptive_sheet(2, 2), 1);
    tf_vertex_put(remesher->surface, 4, off);
    for (int i = 0; i < 20; i++)
        ck_assert_int_eq(tf_smooth_pass(remesher), TF_OK);
    const double *place = place_of(remesher->surface, 4);
    ck_assert_double_lt(hypot(place[0] - 1, place[1] - 1), 0.2);
    ck_assert_double_eq(place[2], 0);
    ck_assert_int_gt(done(remesher, TF_SMOOTH), 0);
    ck_assert_int_lt(done(remesher, TF_SMOOTH),
                     10); // small moves are not worth it
    for (int v = 0; v < 9; v++)
        if (v != 4)
            ck_assert_double_eq(place_of(remesher->surface, v)[0], v % 3);
    remesher_end(remesher);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("remesh/smooth_pass");
    TCase *tcase = tcase_create("moves");
    tcase_add_test(tcase, a_vertex_goes_back_to_the_middle);
    suite_add_tcase(suite, tcase);
    return suite;
}
