#include "program/frame_file.h"

#include "formats/mesh_reader.h"
#include "simulate/cloth_scenes.h"
#include "simulate/cloth_simulation.h"
#include "simulate/flow_scenes.h"
#include "support/program.h"
#include "support/support.h"

#include <errno.h>
#include <string.h>

static void write_frame(const char *path, const tf_simulation *s)
{
    FILE *stream = fopen(path, "wb");
    ck_assert_ptr_nonnull(stream);
    tf_frame_write(stream, s);
    ck_assert_int_eq(fclose(stream), 0);
}

/// A scene after some steps.
static tf_simulation *moved(const char *name, double resolution, int steps)
{
    const tf_scene *scene = tf_scene_named(tf_cloth_scenes, name);
    if (!scene)
        scene = tf_scene_named(tf_flow_scenes, name);
    tf_simulation *s = NULL;
    ck_assert_int_eq(tf_simulation_create(scene, resolution, &s), TF_OK);
    for (int i = 0; i < steps; i++)
        ck_assert_int_eq(scene->kind->step(s, &(tf_step_options){0}), TF_OK);
    return s;
}

static const struct {
    const char *name;
    double resolution;
    int steps;
} scenes[] = {{"sphere", 5, 30}, {"plane-chain", 41, 30}, {"star", 0.1, 3}};

enum {
    SCENES = sizeof scenes / sizeof *scenes
};

static tf_simulation *moved_scene(int i, int steps)
{
    return moved(scenes[i].name, scenes[i].resolution, steps);
}

static size_t bytes_of(const tf_mesh *mesh)
{
    return sizeof(double) * (size_t)(mesh->axes * mesh->vertices);
}

START_TEST(a_frame_holds_the_state)
{
    tf_simulation *s = moved_scene(_i, scenes[_i].steps);
    tf_simulation *read = moved_scene(_i, 0);
    if (s->scene->kind == &tf_cloth_kind) {
        tf_cloth_simulation *cloth = (tf_cloth_simulation *)s;
        cloth->script_steps = 17;
        cloth->velocity[1] = -0.0;
    }
    write_frame("frame", s);
    ck_assert_int_eq(tf_frame_read(read, "frame"), TF_FRAME_GOOD);
    tf_snapshot a = s->scene->kind->snapshot(s);
    tf_snapshot b = s->scene->kind->snapshot(read);
    ck_assert_int_eq(b.step, scenes[_i].steps);
    ck_assert_int_eq(b.script_steps, a.script_steps);
    ck_assert_int_eq(b.mesh.vertices, a.mesh.vertices);
    ck_assert_mem_eq(b.position, a.position, bytes_of(&a.mesh));
    if (a.velocity)
        ck_assert_mem_eq(b.velocity, a.velocity, bytes_of(&a.mesh));
    tf_simulation_free(s);
    tf_simulation_free(read);
}
END_TEST

START_TEST(going_on_from_a_frame_changes_no_bit)
{
    tf_simulation *whole = moved_scene(_i, scenes[_i].steps);
    tf_simulation *parts = moved_scene(_i, 0);
    write_frame("frame", whole);
    ck_assert_int_eq(tf_frame_read(parts, "frame"), TF_FRAME_GOOD);
    for (int i = 0; i < 2; i++) {
        tf_simulation *s = i == 0 ? whole : parts;
        ck_assert_int_eq(s->scene->kind->step(s, &(tf_step_options){0}), TF_OK);
        write_frame(i == 0 ? "one" : "other", s);
        tf_simulation_free(s);
    }
    expect(run("cmp one other"), 0, "", "");
}
END_TEST

START_TEST(a_frame_is_a_mesh)
{
    tf_simulation *s = moved_scene(_i, scenes[_i].steps);
    tf_snapshot now = s->scene->kind->snapshot(s);
    int axes = now.mesh.axes;
    tf_mesh_file mesh;
    tf_fault fault;
    write_frame("frame", s);
    ck_assert_msg(tf_mesh_file_read(&mesh, "frame", NULL, &fault), "%s",
                  fault.text);
    ck_assert_int_eq(tf_mesh_file_vertices(&mesh), now.mesh.vertices);
    ck_assert_int_eq(tf_mesh_file_triangles(&mesh), now.mesh.triangles);
    ck_assert_int_eq(tf_mesh_file_edges(&mesh), now.mesh.edges);
    ck_assert_int_eq(tf_mesh_file_is_flat(&mesh), axes == 2);
    for (int v = 0; v < now.mesh.vertices; v++)
        ck_assert_mem_eq(mesh.position.item + 3 * v, now.position + axes * v,
                         sizeof(double) * (size_t)axes);
    tf_mesh_file_free(&mesh);
    tf_simulation_free(s);
}
END_TEST

START_TEST(a_name_has_the_digits_that_it_needs)
{
    static const struct {
        const char *name, *expected;
        double resolution;
    } names[] = {
        {"plane-chain", "plane-chain --size 40", 40},
        {"sphere", "sphere --size 10", 10},
        {"enright", "enright --edge 0.05", 0.05},
        {"enright", "enright --edge 0.0625", 0.0625},
        {"enright", "enright --edge 0.1", 0.1},
        {"enright", "enright --edge 0.03333333333333333", 1.0 / 30},
        {"enright", "enright --edge 0.0123456789", 0.0123456789},
    };
    char name[TF_SIMULATION_NAME];
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        tf_simulation *s = moved(names[i].name, names[i].resolution, 0);
        tf_simulation_name(s, name);
        ck_assert_str_eq(name, names[i].expected);
        tf_simulation_free(s);
    }
}
END_TEST

START_TEST(a_header_names_scene_size_and_step)
{
    tf_simulation *s = moved("plane-chain", 41, 3);
    write_frame("frame", s);
    const char *expected =
        "ply\nformat binary_little_endian 1.0\ncomment tanglefree simulate "
        "plane-chain --size 41, step 3, of the script 3\nelement vertex 46\n"
        "property double x\nproperty double y\nproperty double z\n"
        "property double vx\nproperty double vy\nproperty double vz\n"
        "element edge 44\nproperty int vertex1\nproperty int vertex2\n"
        "end_header\n";
    ck_assert_int_eq(strncmp(file_text("frame"), expected, strlen(expected)),
                     0);
    tf_simulation_free(s);
}
END_TEST

// What is no frame of the scene -------------------------------------------------

START_TEST(another_scene_or_size_is_foreign)
{
    tf_simulation *s = moved("sphere", 5, 0);
    tf_simulation *finer = moved("sphere", 6, 0);
    tf_simulation *stack = moved("stack", 5, 0);
    tf_simulation *star = moved("star", 0.1, 0);
    tf_simulation *coarser = moved("star", 0.09, 0);
    write_frame("frame", s);
    ck_assert_int_eq(tf_frame_read(finer, "frame"), TF_FRAME_FOREIGN);
    ck_assert_int_eq(tf_frame_read(stack, "frame"), TF_FRAME_FOREIGN);
    tf_simulation_free(s);
    tf_simulation_free(finer);
    tf_simulation_free(stack);
    ck_assert_int_eq(tf_frame_read(star, "frame"), TF_FRAME_FOREIGN);
    write_frame("frame", star);
    ck_assert_int_eq(tf_frame_read(coarser, "frame"), TF_FRAME_FOREIGN);
    tf_simulation_free(star);
    tf_simulation_free(coarser);
}
END_TEST

START_TEST(bytes_that_are_missing_or_changed_are_seen)
{
    tf_simulation *s = moved_scene(_i, 0);
    write_frame("frame", s);
    static char text[20000];
    FILE *stream = fopen("frame", "rb");
    size_t size = fread(text, 1, sizeof text - 1, stream);
    fclose(stream);
    for (size_t shorter = 0; shorter < size; shorter += 37) {
        make_binary_file("cut", text, shorter);
        ck_assert_int_eq(tf_frame_read(s, "cut"), TF_FRAME_FOREIGN);
    }
    text[size] = 0;
    make_binary_file("long", text, size + 1);
    ck_assert_int_eq(tf_frame_read(s, "long"), TF_FRAME_FOREIGN);
    text[size - 1] = 1; // of the last index
    make_binary_file("changed", text, size);
    ck_assert_int_eq(tf_frame_read(s, "changed"), TF_FRAME_FOREIGN);
    text[size - 1] = 0;
    make_binary_file("mended", text, size);
    ck_assert_int_eq(tf_frame_read(s, "mended"), TF_FRAME_GOOD);
    tf_simulation_free(s);
}
END_TEST

START_TEST(a_missing_file_and_a_folder_are_unreadable)
{
    tf_simulation *s = moved("sphere", 5, 0);
    ck_assert_int_eq(tf_frame_read(s, "missing"), TF_FRAME_UNREADABLE);
    ck_assert_int_eq(errno, ENOENT);
    ck_assert_int_eq(tf_frame_read(s, "."), TF_FRAME_UNREADABLE);
    tf_simulation_free(s);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/frame_file");
    TCase *tcase = tcase_create("frames");
    tcase_add_checked_fixture(tcase, enter_folder, leave_folder);
    tcase_add_loop_test(tcase, a_frame_holds_the_state, 0, SCENES);
    tcase_add_loop_test(tcase, going_on_from_a_frame_changes_no_bit, 0, SCENES);
    tcase_add_loop_test(tcase, a_frame_is_a_mesh, 0, SCENES);
    tcase_add_test(tcase, a_name_has_the_digits_that_it_needs);
    tcase_add_test(tcase, a_header_names_scene_size_and_step);
    tcase_add_test(tcase, another_scene_or_size_is_foreign);
    tcase_add_loop_test(tcase, bytes_that_are_missing_or_changed_are_seen, 1,
                        SCENES);
    tcase_add_test(tcase, a_missing_file_and_a_folder_are_unreadable);
    suite_add_tcase(suite, tcase);
    return suite;
}
