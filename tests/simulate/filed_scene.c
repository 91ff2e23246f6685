// Scenes from files: what they are made of, how frames move them, and mistakes.
#include "simulate/filed_scene.h"

#include "simulate/cloth_scenes.h"
#include "simulate/cloth_simulation.h"
#include "simulate/flow_scenes.h"
#include "support/program.h"
#include "support/simulations.h"
#include "support/support.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

// A flat square above a triangle that moves, and a triangle that is fixed.
#define SQUARE "v 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
#define BODY(z) "v -1 -1 " z "\nv 3 -1 " z "\nv -1 3 " z "\nf 1 2 3\n"

static void enter_folder_of_meshes(void)
{
    enter_folder();
    make_file("cloth.obj", SQUARE "f 1 2 3\nf 1 3 4\n");
    make_file("body0.obj", BODY("0"));
    make_file("body1.obj", BODY("0.25"));
    make_file("body2.obj", BODY("-1"));
    make_file("wall.obj", "v 9 0 0\nv 9 1 0\nv 9 0 1\nf 1 2 3\n");
}

static const char *const scene_text = "rate: 10\n"
                                      "meshes:\n"
                                      "- frames: cloth.obj\n"
                                      "- frames: body*.obj\n"
                                      "  role: scripted\n"
                                      "- frames: wall.obj\n"
                                      "  role: fixed\n";

static tf_filed_scene *filed_scene(const char *text)
{
    static tf_filed_scene filed;
    make_file("scene.yaml", text);
    ck_assert_msg(tf_filed_scene_read(&filed, "scene.yaml"), "%s:%ld: %s",
                  filed.fault.file, filed.fault.place, filed.fault.text);
    return &filed;
}

static tf_simulation *simulation_of(const tf_filed_scene *filed)
{
    tf_simulation *simulation;
    ck_assert_int_eq(
        tf_simulation_create(&filed->scene, filed->resolution, &simulation),
        TF_OK);
    return simulation;
}

// What meshes are made of ------------------------------------------------------

START_TEST(a_scene_has_notes_for_its_frames)
{
    tf_filed_scene *filed = filed_scene(scene_text);
    ck_assert_str_eq(filed->scene.notes,
                     "up z\nmesh of 4 vertices, moving: cloth\n"
                     "mesh of 3 vertices, scripted: body\n"
                     "mesh of 3 vertices, fixed: wall");
    tf_filed_scene_free(filed);
    filed = filed_scene("shape: sphere");
    ck_assert_ptr_null(filed->scene.notes);
    tf_filed_scene_free(filed);
}
END_TEST

START_TEST(a_scene_has_usual_values)
{
    tf_filed_scene *filed = filed_scene("meshes: [{frames: cloth.obj}]");
    const tf_scene *scene = &filed->scene;
    ck_assert_ptr_eq(scene->kind, &tf_cloth_kind);
    ck_assert_str_eq(scene->name, "scene.yaml");
    ck_assert(scene->step == 0.01 && scene->steps == 100 &&
              scene->gravity == 9.81 && scene->friction == 0.3 &&
              scene->air.drag == 0.3 && filed->body.up == 0 && !scene->plane);
    double sum = 0;
    for (int v = 0; v < 4; v++)
        sum += filed->body.mass[v];
    ck_assert_double_eq_tol(sum, 0.15, 1e-15);
    tf_filed_scene_free(filed);
}
END_TEST

// A sheet of the simulator's own has the same elements.
START_TEST(any_mesh_is_made_as_sheets_are)
{
    const tf_material material = {0.25, 400, 0.002};
    const tf_sheet sheet = {5, 4, .corner = {0.1, -0.3, 2},
                            .across_step = {0.11, 0.01, 0},
                            .along_step = {0, 0.13, 0.02}};
    tf_body own = {.axes = 3};
    tf_sheet_add(&own, &sheet, &material);
    FILE *file = fopen("sheet.obj", "w");
    for (int v = 0; v < own.vertices; v++)
        fprintf(file, "v %.17g %.17g %.17g\n", own.position[3 * v],
                own.position[3 * v + 1], own.position[3 * v + 2]);
    for (int t = 0; t < own.triangles; t++)
        fprintf(file, "f %d %d %d\n", own.triangle[3 * t] + 1,
                own.triangle[3 * t + 1] + 1, own.triangle[3 * t + 2] + 1);
    fclose(file);
    tf_filed_scene *filed =
        filed_scene("material: {density: 0.25, bend: 0.002}\n"
                    "meshes: [{frames: sheet.obj, material: {stretch: 400}}]");
    const tf_body *found = &filed->body;
    ck_assert_int_eq(found->vertices, own.vertices);
    ck_assert_int_eq(found->elastics, own.elastics);
    for (int v = 0; v < own.vertices; v++)
        ck_assert_double_eq(found->mass[v], own.mass[v]);
    for (int i = 0; i < own.elastics; i++) {
        const tf_elastic *a = &found->elastic[i], *b = &own.elastic[i];
        ck_assert(a->count == b->count && a->rest == b->rest &&
                  a->stiffness == b->stiffness);
        for (int k = 0; k < a->count; k++)
            ck_assert(a->vertex[k] == b->vertex[k] &&
                      a->weight[k] == b->weight[k]);
    }
    tf_body_free(&own);
    tf_filed_scene_free(filed);
}
END_TEST

// Of which each triangle has half, and each of its corners a third of that.
START_TEST(a_mesh_may_have_a_mass)
{
    const double masses[] = {1, 0.5, 1, 0.5};
    make_file("wide.obj", "v 0 0 0\nv 4 0 0\nv 4 1 0\nv 0 1 0\nf 1 2 3 4\n");
    tf_filed_scene *filed = filed_scene(
        "material: {density: 7}\nmeshes: [{frames: wide.obj, mass: 3}]");
    bool low = filed->body.mass[0] < 0.75; // which diagonal it has
    for (int v = 0; v < 4; v++)
        ck_assert_double_eq_tol(filed->body.mass[v],
                                low ? masses[(v + 1) % 4] : masses[v], 1e-14);
    tf_filed_scene_free(filed);
}
END_TEST

START_TEST(meshes_may_have_one_friction)
{
    tf_filed_scene *filed = filed_scene(
        "friction: 0.1\nmeshes: [{frames: cloth.obj, friction: 0.7}, "
        "{frames: wall.obj, friction: 0.7, role: fixed}]");
    ck_assert_double_eq(filed->scene.friction, 0.7);
    tf_filed_scene_free(filed);
}
END_TEST

// That of the scene is for a mesh without its own.
START_TEST(meshes_may_have_frictions_of_their_own)
{
    static const double expected[] = {0.7, 0.7, 0.7, 0.7, 0, 0, 0, 0.1};
    unsigned sum[3];
    for (int i = 0; i < 3; i++) {
        char text[200];
        snprintf(text, sizeof text,
                 "friction: 0.1\nmeshes:\n"
                 "- {frames: cloth.obj, friction: 0.%d}\n"
                 "- {frames: body0.obj, friction: 0, role: scripted}\n"
                 "- {frames: wall.obj, role: fixed}\n",
                 i == 2 ? 6 : 7);
        tf_filed_scene *filed = filed_scene(text);
        for (int v = 0; v < 8 && i < 2; v++)
            ck_assert_double_eq(filed->friction[v], expected[v]);
        sum[i] = filed->scene.checksum;
        tf_filed_scene_free(filed);
    }
    ck_assert(sum[0] == sum[1] && sum[1] != sum[2]);
}
END_TEST

// The chain that is built in, of which each link is as long as any other.
START_TEST(curves_are_made_as_chains_are)
{
    enum {
        LINKS = 40
    };
    const tf_scene *chain = tf_scene_named(tf_cloth_scenes, "plane-chain");
    tf_scene_setup setup = setup_of(chain, LINKS);
    const tf_body *own = &setup.body;
    FILE *file = fopen("chain.obj", "w");
    for (int v = 0; v <= LINKS; v++)
        fprintf(file, "v %.17g %.17g\n", own->position[2 * v],
                own->position[2 * v + 1]);
    for (int v = 1; v <= LINKS; v++)
        fprintf(file, "l %d %d\n", v, v + 1);
    fclose(file);
    tf_filed_scene *filed =
        filed_scene("meshes:\n- frames: chain.obj\n  material: {density: 0.1, "
                    "stretch: 50, bend: 2e-3}");
    const tf_body *found = &filed->body;
    ck_assert_int_eq(found->axes, 2);
    ck_assert_int_eq(found->elastics, own->elastics);
    for (int i = 0; i < LINKS; i++) {
        const tf_elastic *a = &found->elastic[i], *b = &own->elastic[i];
        ck_assert_double_eq(a->rest, b->rest);
        // Its own links are not as long as they are made for.
        ck_assert_double_eq_tol(a->stiffness * a->rest, 50, 1e-12);
        ck_assert(a->vertex[0] == b->vertex[0] && a->vertex[1] == b->vertex[1]);
    }
    tf_body_free(&setup.body);
    tf_filed_scene_free(filed);
}
END_TEST

START_TEST(a_curve_may_have_a_mass)
{
    make_file("curve.obj", "v 0 0 1\nv 3 4 1\nv 3 4 2\nl 1 2\nl 2 3\n");
    tf_filed_scene *filed =
        filed_scene("meshes: [{frames: curve.obj, mass: 12}]");
    ck_assert_double_eq_tol(filed->body.mass[0], 5, 1e-14);
    ck_assert_double_eq_tol(filed->body.mass[1], 6, 1e-14);
    ck_assert_double_eq_tol(filed->body.mass[2], 1, 1e-14);
    ck_assert_int_eq(filed->body.elastics, 3);
    tf_filed_scene_free(filed);
}
END_TEST

START_TEST(what_is_scripted_or_pinned_has_no_mass)
{
    tf_filed_scene *filed =
        filed_scene("rate: 10\nmeshes:\n- {frames: wall.obj, role: fixed}\n"
                    "- {frames: cloth.obj, pinned: [2]}\n"
                    "- {frames: body*.obj, role: scripted}\n");
    for (int v = 0; v < 10; v++)
        ck_assert_msg((filed->body.mass[v] > 0) == (v >= 3 && v < 7 && v != 5),
                      "vertex %d", v);
    ck_assert_int_eq(filed->body.elastics, 5 + 1);
    tf_filed_scene_free(filed);
}
END_TEST

START_TEST(a_scene_says_what_is_simulated)
{
    tf_filed_scene *filed = filed_scene(
        "step: 0.002\nsteps: 7\ngravity: 3\nup: x\nfriction: 0.7\n"
        "air: {wind: [1, 2, 3], veer: 4}\n"
        "meshes: [{frames: cloth.obj}, {frames: wall.obj, role: fixed}]");
    const tf_scene *scene = &filed->scene;
    ck_assert(scene->step == 0.002 && scene->steps == 7 &&
              scene->gravity == 3 && scene->friction == 0.7 &&
              filed->body.up == 1 && scene->air.drag == 0 &&
              scene->air.wind[2] == 3 && scene->air.veer == 4);
    tf_filed_scene_free(filed);
}
END_TEST

// One axis after another points up.
START_TEST(what_falls_falls_down)
{
    for (int up = 0; up < 3; up++) {
        char text[200];
        snprintf(text, sizeof text,
                 "gravity: 2\nup: %c\nair: {drag: 0}\n"
                 "meshes: [{frames: cloth.obj}]",
                 'x' + up);
        tf_filed_scene *filed = filed_scene(text);
        tf_simulation *s = simulation_of(filed);
        for (int i = 0; i < 3; i++)
            ck_assert_int_eq(s->scene->kind->step(s, &(tf_step_options){0}),
                             TF_OK);
        tf_snapshot now = s->scene->kind->snapshot(s);
        for (int i = 0; i < 12; i++)
            ck_assert_double_eq_tol(now.velocity[i],
                                    i % 3 == up ? -2 * 0.03 : 0, 1e-12);
        tf_simulation_free(s);
        tf_filed_scene_free(filed);
    }
}
END_TEST

// How frames move meshes -------------------------------------------------------

/// Where the body is at a time: its frames are 0, 0.25 and -1, ten a second.
static double height_at(double time)
{
    double at = time * 10;
    return at <= 1 ? 0.25 * at : at <= 2 ? 0.25 - 1.25 * (at - 1) : -1;
}

// At 25 frames a second a frame takes 4 steps, though 7 of them aren't 0.28 s in
// doubles.
START_TEST(rounding_makes_no_step)
{
    char name[20];
    for (int i = 0; i < 8; i++) {
        snprintf(name, sizeof name, "fall%d.obj", i);
        make_file(name, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    }
    tf_filed_scene *filed = filed_scene("rate: 25\nmeshes:\n"
                                        "- frames: cloth.obj\n"
                                        "- frames: fall*.obj\n"
                                        "  role: scripted\n");
    ck_assert_int_eq(filed->scene.steps, 28);
    tf_filed_scene_free(filed);
}
END_TEST

/// Another program may write frames while they are read.
START_TEST(frames_that_change_meanwhile_are_refused)
{
    tf_filed_scene *filed = filed_scene(scene_text);
    tf_simulation *s = simulation_of(filed);
    static const char more[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 9\nf 1 2 3\n";
    make_file("body1.obj", more);
    make_file("body2.obj", more);
    tf_status status = TF_OK;
    for (int i = 0; i < 20 && status == TF_OK; i++)
        status = s->scene->kind->step(s, &(tf_step_options){0});
    ck_assert_int_eq(status, TF_CANCELLED);
    ck_assert_str_ne(filed->frames.fault.text, "");
    tf_simulation_free(s);
    tf_filed_scene_free(filed);
}
END_TEST

START_TEST(frames_are_followed_along_straight_lines)
{
    tf_filed_scene *filed = filed_scene(scene_text);
    ck_assert_int_eq(filed->scene.steps, 20);
    tf_simulation *s = simulation_of(filed);
    for (int i = 1; i <= 25; i++) {
        ck_assert_int_eq(s->scene->kind->step(s, &(tf_step_options){0}), TF_OK);
        tf_snapshot now = s->scene->kind->snapshot(s);
        for (int v = 4; v < 7; v++)
            ck_assert_double_eq_tol(now.position[3 * v + 2],
                                    height_at(i * 0.01), 1e-14);
        ck_assert_double_eq(now.position[3 * 4], -1);
        for (int v = 7; v < 10; v++)
            ck_assert_double_eq(now.position[3 * v], 9);
        if (i == 20)
            ck_assert_double_eq(now.position[3 * 4 + 2], -1);
    }
    tf_simulation_free(s);
    tf_filed_scene_free(filed);
}
END_TEST

// Times in order, each of them far or near the next, and the same twice.
START_TEST(random_times_find_their_frames)
{
    generator random = generator_new(33);
    for (int i = 0; i < cases(50); i++) {
        tf_filed_scene *filed = filed_scene(scene_text);
        tf_simulation *s = simulation_of(filed);
        const tf_path *path = &s->setup.path;
        double time = 0, x[30] = {0};
        while (time < 0.3) {
            ck_assert(path->place(path->context, time, x));
            for (int v = 4; v < 7; v++)
                ck_assert_double_eq_tol(x[3 * v + 2], height_at(time), 1e-14);
            for (int v = 0; v < 12; v++)
                ck_assert_double_eq(x[v], 0);
            time += below(&random, 3) * ldexp(0.125, -below(&random, 12));
        }
        tf_simulation_free(s);
        tf_filed_scene_free(filed);
    }
}
END_TEST

/// How far a floor that moves 1 along x carries a sheet, which has a friction of
/// 2, while a wall nearby has another one.
static double way_of_sheet(const char *friction_of_floor)
{
    char text[400];
    snprintf(text, sizeof text,
             "rate: 2\nair: {drag: 0}\nmeshes:\n"
             "- {frames: sheet.obj, friction: 2}\n"
             "- {frames: floor*.obj, role: scripted, friction: %s}\n"
             "- {frames: wall.obj, role: fixed, friction: 3}\n",
             friction_of_floor);
    tf_filed_scene *filed = filed_scene(text);
    tf_simulation *s = simulation_of(filed);
    for (int i = 0; i < 50; i++)
        ck_assert_int_eq(s->scene->kind->step(s, &(tf_step_options){0}), TF_OK);
    double way = s->scene->kind->snapshot(s).position[0];
    tf_simulation_free(s);
    tf_filed_scene_free(filed);
    return way;
}

START_TEST(meshes_have_frictions_of_their_own)
{
    make_file("sheet.obj", "v 0 0 1e-3\nv 1 0 1e-3\nv 1 1 1e-3\nv 0 1 1e-3\n"
                           "f 1 2 3\nf 1 3 4\n");
    make_file("floor0.obj", "v -3 -3 0\nv 9 -3 0\nv -3 9 0\nf 1 2 3\n");
    make_file("floor1.obj", "v -2 -3 0\nv 10 -3 0\nv -2 9 0\nf 1 2 3\n");
    make_file("wall.obj", "v 19 0 0\nv 19 1 0\nv 19 0 1\nf 1 2 3\n");
    ck_assert_double_eq_tol(way_of_sheet("0"), 0, 1e-9);
    ck_assert_double_gt(way_of_sheet("2"), 0.9);
    double little = way_of_sheet("0.0008"); // with 2: 0.04
    ck_assert_double_eq_tol(little, 0.04 * 9.81 * 0.125, 0.005);
}
END_TEST

START_TEST(pinned_vertices_follow_their_frames)
{
    make_file("cloth1.obj", "v 0 0 2\nv 1 0 2\nv 1 1 2\nv 0 1 2\n"
                            "f 1 2 3\nf 1 3 4\n");
    tf_filed_scene *filed =
        filed_scene("rate: 10\ngravity: 0\nmeshes:\n"
                    "- {frames: [cloth.obj, cloth1.obj], pinned: [0, 3]}\n");
    ck_assert_int_eq(filed->scene.steps, 10);
    tf_simulation *s = simulation_of(filed);
    for (int i = 1; i <= 5; i++)
        ck_assert_int_eq(s->scene->kind->step(s, &(tf_step_options){0}), TF_OK);
    tf_snapshot now = s->scene->kind->snapshot(s);
    ck_assert_double_eq_tol(now.position[2], 1.5, 1e-14);
    ck_assert_double_eq_tol(now.position[11], 1.5, 1e-14);
    ck_assert_double_lt(now.position[5], 1.5);
    tf_simulation_free(s);
    tf_filed_scene_free(filed);
}
END_TEST

START_TEST(curves_of_the_plane_are_scripted)
{
    make_file("curve.obj", "v 0 0\nv 1 1\nv 2 0\nl 1 2\nl 2 3\n");
    make_file("chain.obj", "v 0 2\nv 1 2\nl 1 2\n");
    tf_filed_scene *filed =
        filed_scene("meshes: [{frames: curve.obj, role: fixed}, "
                    "{frames: chain.obj}]");
    ck_assert(filed->scene.plane);
    ck_assert_int_eq(filed->body.axes, 2);
    ck_assert_int_eq(filed->body.edges, 3);
    ck_assert(filed->body.mass[0] == 0 && filed->body.mass[3] > 0);
    ck_assert_double_eq(filed->body.position[3], 1);
    tf_filed_scene_free(filed);
}
END_TEST

// Elements of one group may meet, and so may those that are scripted.
START_TEST(some_elements_may_meet)
{
    make_file("other.obj", "v 0.5 0.5 0.5\nv 0.6 0.5 2\nv 0.5 0.6 2\nf 1 2 3");
    tf_filed_scene *filed =
        filed_scene("meshes: [{frames: cloth.obj, group: a}, "
                    "{frames: other.obj, group: a, role: fixed}]");
    tf_simulation *s = simulation_of(filed);
    tf_step_options options = {.check = true};
    ck_assert_int_eq(s->scene->kind->step(s, &options), TF_OK);
    tf_simulation_free(s);
    tf_filed_scene_free(filed);
    make_file("apart.obj", "v 5 5 5\nv 6 5 5\nv 5 6 5\nf 1 2 3");
    tf_filed_scene_free(
        filed_scene("meshes: [{frames: cloth.obj, role: fixed}, "
                    "{frames: other.obj, role: scripted}, "
                    "{frames: apart.obj}]"));
}
END_TEST

// Checksums --------------------------------------------------------------------

static unsigned checksum_of(const char *text)
{
    tf_filed_scene *filed = filed_scene(text);
    unsigned checksum = filed->scene.checksum;
    tf_filed_scene_free(filed);
    return checksum;
}

/// The scene with other words in place of some.
static const char *replaced(const char *words, const char *by)
{
    static char text[500];
    const char *at = strstr(scene_text, words);
    snprintf(text, sizeof text, "%.*s%s%s", (int)(at - scene_text), scene_text,
             by, at + strlen(words));
    return text;
}

START_TEST(what_changes_nothing_keeps_the_checksum)
{
    unsigned checksum = checksum_of(scene_text);
    ck_assert_uint_eq(checksum_of(scene_text), checksum);
    ck_assert_uint_eq(checksum_of(replaced("rate", "steps: 9\nrate")),
                      checksum);
    ck_assert_uint_eq(checksum_of(replaced("rate", "gravity: 9.81\nrate")),
                      checksum);
    ck_assert_uint_eq(checksum_of(replaced("rate", "shows: it\nrate")),
                      checksum);
    ck_assert_uint_eq(
        checksum_of(replaced("  role: f", "  name: a\n  role: f")), checksum);
}
END_TEST

START_TEST(what_changes_the_simulation_changes_the_checksum)
{
    static const char *const others[] = {"gravity: 9.8\nrate",
                                         "step: 0.011\nrate",
                                         "up: y\nrate",
                                         "friction: 0.2\nrate",
                                         "air: {drag: 1}\nrate",
                                         "air: {wind: [0, 0, 1]}\nrate",
                                         "air: {veer: 1}\nrate",
                                         "air: {gust: 1}\nrate",
                                         "material: {density: 1}\nrate",
                                         "material: {stretch: 1}\nrate",
                                         "material: {bend: 1}\nrate"};
    unsigned checksum = checksum_of(scene_text);
    for (int i = 0; i < 11; i++)
        ck_assert_msg(checksum_of(replaced("rate", others[i])) != checksum,
                      "%s", others[i]);
    ck_assert_uint_ne(checksum_of(replaced("10", "11")), checksum);
    ck_assert_uint_ne(checksum_of(replaced("cloth.obj", "cloth.obj\n"
                                                        "  pinned: [1]")),
                      checksum);
    ck_assert_uint_ne(
        checksum_of(replaced("  role: f", "  group: a\n  role: f")), checksum);
    make_file("body2.obj", BODY("-1.0000000000000002"));
    ck_assert_uint_ne(checksum_of(scene_text), checksum);
}
END_TEST

// Mistakes ---------------------------------------------------------------------

#define CLOTH "meshes:\n- frames: cloth.obj\n"

static const struct {
    const char *text, *file;
    long line;
    const char *fault;
} mistakes[] = {
    {CLOTH "- frames: body*.obj\n  role: scripted\n", "scene.yaml", 3,
     "'body' has 3 frames, but there is no rate; for 25 frames a second, "
     "write 'rate: 25' beside 'meshes:'"},
    {"meshes:\n- {frames: wall.obj, role: fixed}\n"
     "- {frames: body0.obj, role: scripted}\n",
     "scene.yaml", -1,
     "no mesh is moving, so there is nothing to simulate; let one be, by its "
     "role"},
    {CLOTH "  mass: 1\n  material: {density: 1}\n", "scene.yaml", 2,
     "'cloth' has a mass and a density; delete one of them"},
    {CLOTH "  name: frame\n", "scene.yaml", 2,
     "no mesh may be named 'frame', as the frames of all meshes together are; "
     "name it differently, by 'name:'"},
    {CLOTH "  pinned:\n  - 4\n", "scene.yaml", 4,
     "'cloth' has no vertex 4; its vertices are numbered from 0 to 3"},
    {CLOTH "  pinned: pins.txt\n", "pins.txt", 2,
     "there is no vertex 9; they are numbered from 0 to 3"},
    {"meshes:\n- frames: edges.obj\n", "edges.obj", 6,
     "this edge has no length; remove it, or move an end of it"},
    {"meshes:\n- frames: flat.obj\n", "flat.obj", 5,
     "the corners of this triangle are on one line; remove it"},
    {CLOTH "- {frames: through.obj, role: fixed}\n", "cloth.obj", -1,
     "edge 0 2 passes through triangle 0 1 2 of through.obj (numbered from 0) "
     "before the step begins; move them apart, see 'tanglefree check' for all "
     "such pairs"},
    {"rate: 1\n" CLOTH "- frames: [body0.obj, cloth.obj]\n  role: scripted\n",
     "cloth.obj", -1,
     "4 vertices, but body0.obj has 3; all files must have "
     "the same elements"},
    {"rate: 1\nmeshes:\n- {frames: [curve.obj, raised.obj], role: scripted}\n"
     "- {frames: chain.obj}\n",
     "scene.yaml", -1,
     "the curves leave the plane in frame 1; keep z = 0, or give them another "
     "z from the start"},
    {"shape: cube\n", "scene.yaml", 1,
     "there is no shape 'cube'; 'tanglefree simulate list' lists all shapes"},
    {"rate: 1\nshape: sphere\n", "scene.yaml", 2,
     "rate and up are for meshes; with a shape, leave them out"},
    {"up: y\nshape: sphere\n", "scene.yaml", 2,
     "rate and up are for meshes; with a shape, leave them out"},
    {"gravity: 1\nshape: star\n", "scene.yaml", 2,
     "the shape 'star' flows, without gravity, friction, air and material; "
     "leave them out"},
    {"shape: star\nair: {}\n", "scene.yaml", 1,
     "the shape 'star' flows, without gravity, friction, air and material; "
     "leave them out"},
    {"shape: star\nmaterial: {bend: 0}\n", "scene.yaml", 1,
     "the shape 'star' flows, without gravity, friction, air and material; "
     "leave them out"},
    {"shape: star\nsize: 9\n", "scene.yaml", 2,
     "the shape 'star' takes 'edge:' from 0.001 to 0.1"},
    {"shape: sphere\nedge: 9\n", "scene.yaml", 2,
     "the shape 'sphere' takes 'size:' from 4 to 2000"},
    {"shape: sphere\nsize: 3\n", "scene.yaml", 2,
     "the shape 'sphere' takes 'size:' from 4 to 2000"},
};

START_TEST(each_mistake_is_told)
{
    tf_filed_scene filed;
    make_file("pins.txt", "0\n9\n");
    make_file("edges.obj", SQUARE "v 0 1 1\nl 4 5\nf 1 2 3\nl 1 4\n");
    make_file("flat.obj", "v 0 0 1\nv 1 0 1\nv 2 0 1\nv 0 1 1\nf 1 2 3\n"
                          "f 1 2 4\n");
    make_file("curve.obj", "v 0 0\nv 1 1\nl 1 2\n");
    make_file("chain.obj", "v 0 2\nv 1 2\nl 1 2\n");
    make_file("raised.obj", "v 0 0 1\nv 1 1 0\nl 1 2\n");
    make_file("through.obj",
              "v 0.4 0.5 0.5\nv 0.6 0.45 0.5\nv 0.5 0.5 2\nf 1 2 3\n");
    make_file("scene.yaml", mistakes[_i].text);
    ck_assert(!tf_filed_scene_read(&filed, "scene.yaml"));
    ck_assert_str_eq(filed.fault.file, mistakes[_i].file);
    ck_assert_msg(strncmp(filed.fault.text, mistakes[_i].fault,
                          strlen(mistakes[_i].fault)) == 0,
                  "'%s', not '%s'", filed.fault.text, mistakes[_i].fault);
    ck_assert_int_eq(filed.fault.place, mistakes[_i].line);
    tf_filed_scene_free(&filed);
}
END_TEST

// A file that is changed while the simulation runs.
START_TEST(frames_that_vanish_end_the_simulation)
{
    tf_filed_scene *filed = filed_scene(scene_text);
    tf_simulation *s = simulation_of(filed);
    ck_assert_int_eq(remove("body1.obj"), 0);
    ck_assert_int_eq(s->scene->kind->step(s, &(tf_step_options){0}),
                     TF_CANCELLED);
    ck_assert_str_eq(filed->frames.fault.file, "body1.obj");
    ck_assert_int_eq(s->step, 0);
    tf_simulation_free(s);
    tf_filed_scene_free(filed);
}
END_TEST

START_TEST(names_of_any_kind_name_a_scene)
{
    static const char *const names[][2] = {
        {"a b.yaml", "a b.yaml"},
        {"a,b.yaml", "a?b.yaml"},
        {"\xc3\xa4.yaml", "??.yaml"},
    };
    run("mkdir folder");
    for (int i = 0; i < 3; i++) {
        char path[100];
        tf_filed_scene filed;
        snprintf(path, sizeof path, "folder/%s", names[i][0]);
        make_file(path, "meshes: [{frames: ../cloth.obj}]");
        ck_assert(tf_filed_scene_read(&filed, path));
        ck_assert_str_eq(filed.scene.name, names[i][1]);
        tf_filed_scene_free(&filed);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("simulate/filed_scene");
    TCase *made = tcase_create("what meshes are made of");
    tcase_add_checked_fixture(made, enter_folder_of_meshes, leave_folder);
    tcase_add_test(made, a_scene_has_notes_for_its_frames);
    tcase_add_test(made, a_scene_has_usual_values);
    tcase_add_test(made, any_mesh_is_made_as_sheets_are);
    tcase_add_test(made, a_mesh_may_have_a_mass);
    tcase_add_test(made, meshes_may_have_one_friction);
    tcase_add_test(made, meshes_may_have_frictions_of_their_own);
    tcase_add_test(made, curves_are_made_as_chains_are);
    tcase_add_test(made, a_curve_may_have_a_mass);
    tcase_add_test(made, what_is_scripted_or_pinned_has_no_mass);
    tcase_add_test(made, a_scene_says_what_is_simulated);
    tcase_add_test(made, what_falls_falls_down);
    suite_add_tcase(suite, made);

    TCase *moved = tcase_create("how frames move meshes");
    tcase_add_checked_fixture(moved, enter_folder_of_meshes, leave_folder);
    tcase_add_test(moved, frames_are_followed_along_straight_lines);
    tcase_add_test(moved, rounding_makes_no_step);
    tcase_add_test(moved, frames_that_change_meanwhile_are_refused);
    tcase_add_test(moved, random_times_find_their_frames);
    tcase_add_test(moved, meshes_have_frictions_of_their_own);
    tcase_add_test(moved, pinned_vertices_follow_their_frames);
    tcase_add_test(moved, curves_of_the_plane_are_scripted);
    tcase_add_test(moved, some_elements_may_meet);
    suite_add_tcase(suite, moved);

    TCase *sums = tcase_create("checksums");
    tcase_add_checked_fixture(sums, enter_folder_of_meshes, leave_folder);
    tcase_add_test(sums, what_changes_nothing_keeps_the_checksum);
    tcase_add_test(sums, what_changes_the_simulation_changes_the_checksum);
    suite_add_tcase(suite, sums);

    TCase *bad = tcase_create("mistakes");
    tcase_add_checked_fixture(bad, enter_folder_of_meshes, leave_folder);
    tcase_add_loop_test(bad, each_mistake_is_told, 0,
                        sizeof mistakes / sizeof *mistakes);
    tcase_add_test(bad, frames_that_vanish_end_the_simulation);
    tcase_add_test(bad, names_of_any_kind_name_a_scene);
    suite_add_tcase(suite, bad);
    return suite;
}
