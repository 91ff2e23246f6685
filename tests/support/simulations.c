#include "support/simulations.h"

#include "support/support.h"
#include "support/surface_of.h"
#include "surface/check.h"

const tf_scene *scene_number(int i)
{
    int count;
    return &tf_scenes(&count)[i];
}

int scene_count(void)
{
    int count;
    tf_scenes(&count);
    return count;
}

tf_simulation *simulation_of(const tf_scene *scene, int size)
{
    tf_simulation *made = NULL;
    ck_assert_ptr_nonnull(scene);
    ck_assert_int_eq(tf_simulation_create(scene, size, &made), TF_OK);
    return made;
}

tf_step_cost simulate_step(tf_simulation *s, const tf_parallel *parallel)
{
    tf_step_cost cost;
    tf_step_way way = {.parallel = parallel, .check = s->step == 0};
    ck_assert_msg(tf_simulation_step(s, &way, &cost) == TF_OK, "%s, step %d",
                  s->scene->name, s->step + 1);
    return cost;
}

void simulate_blindly(tf_simulation *s)
{
    ck_assert_int_eq(tf_simulation_propose(s), TF_OK);
    tf_simulation_accept(s, 0);
}

tangle_judge *judge_of(const tf_body *body)
{
    tf_mesh mesh = tf_body_mesh(body);
    return tangle_judge_new(&mesh);
}

void expect_clear(const tf_body *body)
{
    tf_mesh mesh = tf_body_mesh(body);
    tf_surface *surface = surface_of(&mesh);
    tf_crossings found;
    ck_assert_int_eq(tf_surface_check(surface, body->position, body->vertices,
                                      NULL, &found, NULL),
                     TF_OK);
    ck_assert_uint_eq(found.count, 0);
    tf_surface_free(surface);
    tangle_judge *judge = judge_of(body);
    int tangled = tangle_count(judge, body->position);
    ck_assert_msg(tangled == 0, "%s", tangle_text(tangles(judge)));
    tangle_judge_free(judge);
}
