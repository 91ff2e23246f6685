// The meshes of a scene: how they are called, and what goes together.
#define _GNU_SOURCE // strdup

#include "scenes/scene_meshes.h"

#include "support/program.h"
#include "support/support.h"

#include <stdlib.h>
#include <string.h>

/// Adds a mesh of so many frames; the first is called so, and the others are "f".
static tf_scene_mesh *add_mesh(tf_scene_meshes *meshes, const char *path,
                               int frames)
{
    tf_scene_mesh *mesh = tf_scene_meshes_add(meshes);
    ck_assert_ptr_nonnull(mesh);
    mesh->line = 10 * meshes->count;
    for (int i = 0; i < frames; i++)
        ck_assert(tf_frame_names_add(&mesh->frames, i == 0 ? path : "f"));
    return mesh;
}

// Names -----------------------------------------------------------------------

static const struct {
    const char *path;
    int frames;
    const char *name;
} names[] = {
    {"shirt.obj", 1, "shirt"},
    {"a/b.c/shirt.obj", 1, "shirt"},
    {"a.b/shirt", 1, "shirt"},
    {"shirt.obj.gz", 1, "shirt"},
    {"shirt.GZ", 1, "shirt"},
    {"my.shirt.ply", 1, "my.shirt"},
    {"shirt10.obj", 1, "shirt10"},
    {"shirt10.obj", 2, "shirt"},
    {"walk/body-0001.ply", 60, "body"},
    {"walk/body_1.ply.gz", 60, "body"},
    {"body 0.ply", 2, "body"},
    {"body.0001.ply", 2, "body"},
    {"body-.ply", 2, "body-"},
    {"0001.ply", 2, "0001"},
    {"-1.ply", 2, "-1"},
    {".obj", 1, ".obj"},
    {"a/.gz", 1, ".gz"},
};

START_TEST(meshes_are_called_as_their_files)
{
    tf_scene_meshes meshes = {0};
    add_mesh(&meshes, names[_i].path, names[_i].frames);
    ck_assert(tf_scene_meshes_name(&meshes));
    ck_assert_str_eq(meshes.mesh[0].name, names[_i].name);
    tf_scene_meshes_free(&meshes);
    ck_assert(!meshes.mesh && meshes.count == 0);
}
END_TEST

START_TEST(given_names_stay)
{
    tf_scene_meshes meshes = {0};
    add_mesh(&meshes, "a.obj", 1)->name = strdup("b");
    add_mesh(&meshes, "c.obj", 1);
    ck_assert(tf_scene_meshes_name(&meshes));
    ck_assert_str_eq(meshes.mesh[0].name, "b");
    ck_assert_str_eq(meshes.mesh[1].name, "c");
    tf_scene_meshes_free(&meshes);
}
END_TEST

START_TEST(a_mesh_that_is_added_moves)
{
    tf_scene_meshes meshes = {0};
    const tf_scene_mesh *mesh = tf_scene_meshes_add(&meshes);
    ck_assert(mesh->role == TF_MOVING && mesh->mass == 0 && !mesh->name &&
              mesh->friction < 0 && !mesh->group && mesh->line == -1);
    tf_scene_meshes_free(&meshes);
}
END_TEST

// What goes together ----------------------------------------------------------

/// Checks meshes of these numbers of frames, roles and masses, called a, b, ...
static bool check(int count, const int frames[], const tf_role roles[],
                  const double masses[], tf_scene_meshes *meshes,
                  tf_fault *fault)
{
    *meshes = (tf_scene_meshes){0};
    fault->text[0] = '\0';
    for (int i = 0; i < count; i++) {
        tf_scene_mesh *mesh =
            add_mesh(meshes, (const char[]){(char)('a' + i), 0}, frames[i]);
        mesh->role = roles[i];
        mesh->mass = masses[i];
    }
    ck_assert(tf_scene_meshes_name(meshes));
    return tf_scene_meshes_check(meshes, "scene.yaml", fault);
}

static void expect_frames(int count, const int frames[], const tf_role roles[],
                          const double masses[], int right)
{
    tf_scene_meshes meshes;
    tf_fault fault;
    ck_assert_msg(check(count, frames, roles, masses, &meshes, &fault), "%s",
                  fault.text);
    ck_assert_int_eq(meshes.frames, right);
    tf_scene_meshes_free(&meshes);
}

static void expect_fault(int count, const int frames[], const tf_role roles[],
                         const double masses[], long line, const char *right)
{
    tf_scene_meshes meshes;
    tf_fault fault;
    ck_assert(!check(count, frames, roles, masses, &meshes, &fault));
    ck_assert_str_eq(fault.text, right);
    ck_assert_str_eq(fault.file, "scene.yaml");
    ck_assert_int_eq(fault.place, line);
    tf_scene_meshes_free(&meshes);
}

static const tf_role roles[] = {TF_MOVING, TF_SCRIPTED, TF_FIXED};
static const double none[3] = {0, 0, 0};

START_TEST(meshes_have_one_frame_or_as_many_as_others)
{
    expect_frames(1, (int[]){1}, roles, none, 1);
    expect_frames(1, (int[]){7}, roles, none, 7);
    expect_frames(3, (int[]){7, 7, 1}, roles, none, 7);
    expect_frames(3, (int[]){1, 7, 1}, roles, none, 7);
    expect_frames(3, (int[]){7, 1, 3}, roles, none, 7);
    expect_frames(3, (int[]){1, 1, 9}, roles, none, 1);
    expect_fault(3, (int[]){6, 7, 1}, roles, none, 10,
                 "'a' has 6 frames, but 'b' has 7; give each mesh one frame, "
                 "or all the same number");
    expect_fault(3, (int[]){7, 2, 1}, roles, none, 20,
                 "'b' has 2 frames, but 'a' has 7; give each mesh one frame, "
                 "or all the same number");
}
END_TEST

START_TEST(all_that_move_have_a_mass_or_none)
{
    static const tf_role moving[] = {TF_MOVING, TF_SCRIPTED, TF_MOVING};
    static const int frames[] = {1, 1, 1};
    expect_frames(3, frames, moving, (double[]){1, 0, 2}, 1);
    expect_frames(3, frames, moving, (double[]){0, 5, 0}, 1);
    expect_fault(3, frames, moving, (double[]){0, 5, 1}, 10,
                 "'a' has no mass, but another moving mesh has one; give a "
                 "mass to all moving meshes or to none");
    expect_fault(3, frames, moving, (double[]){1, 5, 0}, 30,
                 "'c' has no mass, but another moving mesh has one; give a "
                 "mass to all moving meshes or to none");
}
END_TEST

START_TEST(names_differ)
{
    tf_scene_meshes meshes = {0};
    tf_fault fault;
    add_mesh(&meshes, "body/1.obj", 1);
    add_mesh(&meshes, "shirt/1.obj", 1);
    ck_assert(tf_scene_meshes_name(&meshes));
    ck_assert(!tf_scene_meshes_check(&meshes, "scene.yaml", &fault));
    ck_assert_str_eq(fault.text, "there is already a mesh named '1'; name one "
                                 "of them differently, by 'name:'");
    ck_assert_int_eq(fault.place, 20);
    tf_scene_meshes_free(&meshes);
}
END_TEST

START_TEST(what_is_fixed_stays_at_its_first_frame)
{
    tf_scene_meshes meshes = {0};
    tf_scene_mesh *mesh = add_mesh(&meshes, "first", 3);
    ck_assert_str_eq(tf_scene_mesh_path(mesh, 0), "first");
    ck_assert_str_eq(tf_scene_mesh_path(mesh, 2), "f");
    mesh->role = TF_FIXED;
    ck_assert_str_eq(tf_scene_mesh_path(mesh, 2), "first");
    mesh = add_mesh(&meshes, "alone", 1);
    ck_assert_str_eq(tf_scene_mesh_path(mesh, 2), "alone");
    tf_scene_meshes_free(&meshes);
}
END_TEST

// Pins --------------------------------------------------------------------------

START_TEST(pinned_vertices_have_no_mass)
{
    tf_scene_meshes meshes = {0};
    tf_scene_mesh *mesh = add_mesh(&meshes, "a.obj", 1);
    tf_fault fault;
    double inverse_mass[] = {1, 2, 3, 4};
    ck_assert(tf_scene_meshes_name(&meshes));
    ck_assert(tf_scene_mesh_pin(mesh, "scene.yaml", 4, inverse_mass, &fault));
    ck_assert(inverse_mass[0] == 1 && inverse_mass[3] == 4);
    mesh->pinned = malloc(2 * sizeof(int));
    mesh->pinned[0] = 3;
    mesh->pinned[1] = 1;
    mesh->pins = 2;
    mesh->pinned_line = 7;
    ck_assert(tf_scene_mesh_pin(mesh, "scene.yaml", 4, inverse_mass, &fault));
    ck_assert(inverse_mass[0] == 1 && inverse_mass[1] == 0 &&
              inverse_mass[2] == 3 && inverse_mass[3] == 0);
    ck_assert(!tf_scene_mesh_pin(mesh, "scene.yaml", 3, inverse_mass, &fault));
    ck_assert_str_eq(fault.text, "'a' has no vertex 3; its vertices are "
                                 "numbered from 0 to 2");
    ck_assert_str_eq(fault.file, "scene.yaml");
    ck_assert_int_eq(fault.place, 7);
    tf_scene_meshes_free(&meshes);
}
END_TEST

START_TEST(a_file_may_list_pinned_vertices)
{
    tf_scene_meshes meshes = {0};
    tf_scene_mesh *mesh = add_mesh(&meshes, "a.obj", 1);
    tf_fault fault;
    double inverse_mass[] = {1, 2, 3};
    make_file("pins.txt", "# some\n2 0\n");
    ck_assert(tf_frame_names_add(&mesh->pinned_in, "pins.txt"));
    ck_assert(tf_scene_mesh_pin(mesh, "scene.yaml", 3, inverse_mass, &fault));
    ck_assert(inverse_mass[0] == 0 && inverse_mass[1] == 2 &&
              inverse_mass[2] == 0);
    ck_assert(!tf_scene_mesh_pin(mesh, "scene.yaml", 2, inverse_mass, &fault));
    ck_assert_str_eq(fault.file, "pins.txt");
    ck_assert_int_eq(fault.place, 2);
    tf_scene_meshes_free(&meshes);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("scenes/scene_meshes");
    TCase *called = tcase_create("names");
    tcase_add_loop_test(called, meshes_are_called_as_their_files, 0,
                        sizeof names / sizeof *names);
    tcase_add_test(called, given_names_stay);
    tcase_add_test(called, a_mesh_that_is_added_moves);
    suite_add_tcase(suite, called);

    TCase *together = tcase_create("what goes together");
    tcase_add_test(together, meshes_have_one_frame_or_as_many_as_others);
    tcase_add_test(together, all_that_move_have_a_mass_or_none);
    tcase_add_test(together, names_differ);
    tcase_add_test(together, what_is_fixed_stays_at_its_first_frame);
    suite_add_tcase(suite, together);

    TCase *pins = tcase_create("pins");
    tcase_add_checked_fixture(pins, enter_folder, leave_folder);
    tcase_add_test(pins, pinned_vertices_have_no_mass);
    tcase_add_test(pins, a_file_may_list_pinned_vertices);
    suite_add_tcase(suite, pins);
    return suite;
}
