// Moves are shortened until nothing outside of the zones meets.
#include "untangle/limit.h"

#include "fast/detect.h"
#include "support/generator.h"
#include "support/support.h"
#include "support/tangles.h"

#include <stdint.h>

static made_tangle own;
static tf_scope scope;
static tf_vector move[TANGLE_VERTICES];
static double to[3 * TANGLE_VERTICES];

static void limit(void)
{
    ck_assert(tf_scope_find(&scope, &own.tangle, NULL, 0));
    ck_assert_int_eq(tf_limit_moves(&own.tangle, &scope, own.x, move, to),
                     TF_OK);
}

static void release(void)
{
    tf_scope_free(&scope);
    tangle_free(&own);
    scope = (tf_scope){.zone = NULL};
}

/// How many contacts outside of the zones the moves have.
static int contacts_outside(void)
{
    tf_motion motion = {3, own.mesh.vertices, own.x, to};
    tf_contacts found;
    ck_assert_int_eq(
        tf_surface_detect(own.surface, &motion, NULL, &found, NULL), TF_OK);
    int count = 0;
    for (size_t i = 0; i < found.count; i++)
        count += !tf_scope_has(&scope, &own.tangle.near, &found.contact[i]);
    return count;
}

static void move_randomly(uint64_t stream, double length)
{
    generator random = generator_new(stream);
    for (int v = 0; v < own.mesh.vertices; v++)
        for (int k = 0; k < 3; k++)
            move[v].x[k] = uniform(&random, -length, length);
}

START_TEST(free_moves_stay)
{
    tangle_begin(&own, 3);
    tangle_add_sheet(&own, 9, (double[]){1, 0, 0}, (double[]){0, 1, 0},
                     (double[]){0, 0, 0});
    tangle_finish(&own);
    for (int v = 0; v < own.mesh.vertices; v++)
        move[v] = (tf_vector){{0.25, 0.5, v}};
    limit();
    for (int v = 0; v < own.mesh.vertices; v++) {
        ck_assert_double_eq(to[3 * v], own.x[3 * v] + 0.25);
        ck_assert_double_eq(to[3 * v + 2], v);
    }
    release();
}
END_TEST

START_TEST(nothing_meets_outside_of_the_zones)
{
    for (int trial = 0; trial < 10; trial++) {
        tangle_make_bump(&own, 3);
        tangle_finish(&own);
        move_randomly((uint64_t)trial, 0.3 + 0.2 * trial);
        limit();
        ck_assert_int_eq(contacts_outside(), 0);
        release();
    }
}
END_TEST

START_TEST(within_a_zone_all_may_meet)
{
    tangle_make_bump(&own, 3);
    tangle_finish(&own);
    for (int v = 0; v < own.mesh.vertices; v++) {
        const double *x = own.x + 3 * (ptrdiff_t)v;
        bool tip = v >= 169 && x[2] < -1;
        move[v] = (tf_vector){{0, 0, tip ? 3.5 : 0}};
    }
    limit();
    int tips = 0;
    for (int v = 169; v < own.mesh.vertices; v++)
        tips += own.x[3 * v + 2] < -1 && to[3 * v + 2] > 0;
    ck_assert_int_gt(tips, 0);
    release();
}
END_TEST

START_TEST(fixed_vertices_stay)
{
    tangle_make_bump(&own, 3);
    for (int v = 0; v < 169; v++)
        own.fixed[v] = true;
    tangle_finish(&own);
    move_randomly(99, 2);
    limit();
    ck_assert_mem_eq(to, own.x, 3 * 169 * sizeof *to);
    ck_assert_int_eq(contacts_outside(), 0);
    release();
}
END_TEST

// A sheet that is to fall upon a fixed one slides along it.
START_TEST(what_meets_gives_way_along_the_normal)
{
    tangle_begin(&own, 3);
    tangle_add_sheet(&own, 9, (double[]){1, 0, 0}, (double[]){0, 1, 0},
                     (double[]){-4, -4, 0});
    tangle_add_sheet(&own, 3, (double[]){1, 0, 0}, (double[]){0, 1, 0},
                     (double[]){-1.3, -1.2, 0.25});
    for (int v = 0; v < 81; v++)
        own.fixed[v] = true;
    tangle_finish(&own);
    for (int v = 81; v < own.mesh.vertices; v++)
        move[v] = (tf_vector){{0.5, 0, -1}};
    limit();
    ck_assert_int_eq(contacts_outside(), 0);
    for (int v = 81; v < own.mesh.vertices; v++) {
        ck_assert_double_gt(to[3 * v], own.x[3 * v]);
        ck_assert_double_gt(to[3 * v + 2], 0);
    }
    release();
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("untangle/limit");
    TCase *tcase = tcase_create("limit");
    tcase_add_test(tcase, free_moves_stay);
    tcase_add_test(tcase, nothing_meets_outside_of_the_zones);
    tcase_add_test(tcase, within_a_zone_all_may_meet);
    tcase_add_test(tcase, fixed_vertices_stay);
    tcase_add_test(tcase, what_meets_gives_way_along_the_normal);
    suite_add_tcase(suite, tcase);
    return suite;
}
