// What the scenes of cloth propose: without response, tangles.
#include "support/cloth.h"

#include "support/support.h"
#include "support/tangle.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const int edges[CLOTH_SCENES] = {60, 20, 8, 8, 6, 2};
static const int steps[CLOTH_SCENES] = {100, 100, 60, 60, 120, 240};

START_TEST(proposals_of_clear_cloth_tangle)
{
    cloth_model *cloth = cloth_new((cloth_scene)_i, edges[_i]);
    tangle_judge *judge = tangle_judge_new(&cloth->mesh);
    size_t numbers = (size_t)(cloth->mesh.axes * cloth->mesh.vertices);
    double *end = malloc(numbers * sizeof *end);
    int tangled = 0;
    ck_assert_int_eq(tangle_count(judge, cloth->position), 0);
    for (int step = 0; step < steps[_i]; step++) {
        cloth_propose(cloth, end);
        for (size_t i = 0; i < numbers; i++)
            ck_assert(isfinite(end[i]));
        cloth_accept(cloth, end, end);
        tangled += tangle_count(judge, end) > 0;
    }
    printf("%s: %d vertices, tangled after %d of %d steps\n", cloth_names[_i],
           cloth->mesh.vertices, tangled, steps[_i]);
    ck_assert_int_gt(tangled, 0);
    free(end);
    tangle_judge_free(judge);
    cloth_free(cloth);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("whole/cloth");
    TCase *tcase = tcase_create("scenes");
    tcase_add_loop_test(tcase, proposals_of_clear_cloth_tangle, 0,
                        (int)cases(CLOTH_SCENES));
    suite_add_tcase(suite, tcase);
    return suite;
}
