#include "support/simulations.h"

#include "support/support.h"
#include "support/surface_of.h"
#include "surface/check.h"

tf_cloth_simulation *cloth_of(const char *scene, int size)
{
    tf_simulation *made = NULL;
    const tf_scene *found = tf_scene_named(tf_cloth_scenes, scene);
    ck_assert_ptr_nonnull(found);
    ck_assert_int_eq(tf_simulation_create(found, size, &made), TF_OK);
    return (tf_cloth_simulation *)made;
}

void cloth_simulation_free(tf_cloth_simulation *cloth)
{
    tf_simulation_free(&cloth->base);
}

tf_scene_setup setup_of(const tf_scene *scene, double resolution)
{
    tf_scene_setup setup = {.scene = scene, .body.axes = scene->plane ? 2 : 3};
    scene->build(&setup, resolution);
    ck_assert(!setup.body.failed);
    return setup;
}

int scene_count(const tf_scene list[])
{
    int count = 0;
    while (list[count].name)
        count++;
    return count;
}

tf_cloth_report simulate_step(tf_cloth_simulation *c,
                              const tf_parallel *parallel)
{
    tf_step_options options = {.parallel = parallel,
                               .check = c->base.step == 0};
    ck_assert_msg(tf_cloth_kind.step(&c->base, &options) == TF_OK,
                  "%s, step %d", c->base.scene->name, c->base.step + 1);
    return c->report;
}

void simulate_blindly(tf_cloth_simulation *c)
{
    ck_assert_int_eq(tf_cloth_propose(c), TF_OK);
    tf_cloth_accept(c, c->end, 0);
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
    ck_assert_int_eq(tf_surface_check(surface, body->vertices, body->position,
                                      NULL, &found, NULL),
                     TF_OK);
    ck_assert_uint_eq(found.count, 0);
    tf_surface_free(surface);
    tangle_judge *judge = judge_of(body);
    int tangled = tangle_count(judge, body->position);
    ck_assert_msg(tangled == 0, "%s", tangle_text(tangles(judge)));
    tangle_judge_free(judge);
}
