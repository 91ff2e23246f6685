#include "program/obstacles.h"

#include "support/support.h"

#include <limits.h>
#include <stdio.h>

static const struct {
    tf_obstacle obstacle;
    const char *words;
} pairs[] = {
    {{.touching = TF_POINT_EDGE, .vertex = {2, 0, 1, -1, -1}},
     "vertex 2 lies on edge 0 1"},
    {{.touching = TF_POINT_TRIANGLE, .vertex = {9, 0, 1, 2, -1}},
     "vertex 9 lies on triangle 0 1 2"},
    {{.touching = TF_EDGE_EDGE, .vertex = {0, 3, 1, 2, -1}},
     "edge 0 3 meets edge 1 2"},
    {{.crossing = TF_EDGE_THROUGH_TRIANGLE, .vertex = {8, 9, 0, 1, 2}},
     "edge 8 9 passes through triangle 0 1 2"},
    {{.crossing = TF_POINT_ON_TRIANGLE, .vertex = {7, 0, 1, INT_MAX, -1}},
     "vertex 7 lies on triangle 0 1 2147483647"},
    {{.crossing = TF_EDGE_ON_EDGE, .vertex = {0, 3, 1, 2, -1}},
     "edge 0 3 meets edge 1 2"},
};

START_TEST(the_pair_is_named)
{
    char right[1000];
    tf_mesh_file file = {.name = "start"};
    snprintf(right, sizeof right,
             "%s (numbered from 0) before the step begins; move them apart, "
             "see 'tanglefree check' for all such pairs",
             pairs[_i].words);
    ck_assert(!tf_obstacle_fault(&file, &pairs[_i].obstacle));
    ck_assert_str_eq(file.fault, right);
    ck_assert_int_lt(file.fault_place, 0);
}
END_TEST

START_TEST(a_crossing_is_named)
{
    static const tf_crossing crossing = {TF_POINT_ON_TRIANGLE,
                                         {7, 0, 1, 2, -1}};
    tf_mesh_file file = {.name = "mesh"};
    ck_assert(!tf_crossing_fault(&file, &crossing));
    ck_assert_str_eq(file.fault,
                     "vertex 7 lies on triangle 0 1 2 (numbered from 0); move "
                     "them apart, see 'tanglefree check' for all such pairs");
    ck_assert_int_lt(file.fault_place, 0);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/obstacles");
    TCase *named = tcase_create("pairs");
    tcase_add_loop_test(named, the_pair_is_named, 0,
                        sizeof pairs / sizeof *pairs);
    tcase_add_test(named, a_crossing_is_named);
    suite_add_tcase(suite, named);
    return suite;
}
