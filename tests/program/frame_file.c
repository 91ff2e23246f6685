#include "program/frame_file.h"

#include "files/mesh_file.h"
#include "support/program.h"
#include "support/simulating.h"
#include "support/support.h"

#include <errno.h>
#include <string.h>

static void write_frame(const char *path, const tf_simulation *s)
{
    FILE *stream = fopen(path, "wb");
    ck_assert_ptr_nonnull(stream);
    ck_assert(tf_frame_write(stream, s));
    ck_assert_int_eq(fclose(stream), 0);
}

/// A scene after some steps.
static tf_simulation *moved(const char *name, int size, int steps)
{
    tf_simulation *s = simulation_of(tf_scene_named(name), size);
    for (int i = 0; i < steps; i++)
        simulate_step(s, NULL);
    return s;
}

static const char *const scenes[] = {"sphere", "plane-chain"};
static const int sizes[] = {5, 41};

START_TEST(a_frame_holds_the_state)
{
    tf_simulation *s = moved(scenes[_i], sizes[_i], 30);
    tf_simulation *read = moved(scenes[_i], sizes[_i], 0);
    size_t size =
        sizeof(double) * (size_t)(s->scene->axes * s->stage.body.vertices);
    s->scripted = 17;
    s->velocity[1] = -0.0;
    write_frame("frame", s);
    ck_assert_int_eq(tf_frame_read(read, "frame"), TF_FRAME_GOOD);
    ck_assert_int_eq(read->step, 30);
    ck_assert_int_eq(read->scripted, 17);
    ck_assert_mem_eq(read->position, s->position, size);
    ck_assert_mem_eq(read->velocity, s->velocity, size);
    tf_simulation_free(s);
    tf_simulation_free(read);
}
END_TEST

START_TEST(a_frame_is_a_mesh)
{
    tf_simulation *s = moved(scenes[_i], sizes[_i], 30);
    const tf_body *body = &s->stage.body;
    tf_mesh_file mesh;
    write_frame("frame", s);
    ck_assert_msg(tf_mesh_file_read(&mesh, "frame"), "%s", mesh.fault);
    ck_assert_int_eq(tf_mesh_file_vertices(&mesh), body->vertices);
    ck_assert_int_eq(tf_mesh_file_triangles(&mesh), body->triangles);
    ck_assert_int_eq(tf_mesh_file_edges(&mesh), body->edges);
    ck_assert_int_eq(tf_mesh_file_is_flat(&mesh), body->axes == 2);
    for (int v = 0; v < body->vertices; v++)
        ck_assert_mem_eq(mesh.position.item + 3 * v,
                         s->position + body->axes * v,
                         sizeof(double) * (size_t)body->axes);
    tf_mesh_file_free(&mesh);
    tf_simulation_free(s);
}
END_TEST

START_TEST(its_header_names_it)
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
    write_frame("frame", s);
    ck_assert_int_eq(tf_frame_read(finer, "frame"), TF_FRAME_FOREIGN);
    ck_assert_int_eq(tf_frame_read(stack, "frame"), TF_FRAME_FOREIGN);
    tf_simulation_free(s);
    tf_simulation_free(finer);
    tf_simulation_free(stack);
}
END_TEST

START_TEST(bytes_that_are_missing_or_changed_are_seen)
{
    tf_simulation *s = moved("plane-chain", 41, 0);
    write_frame("frame", s);
    char text[10000];
    FILE *stream = fopen("frame", "rb");
    size_t size = fread(text, 1, sizeof text - 1, stream);
    fclose(stream);
    for (size_t shorter = 0; shorter < size; shorter += 7) {
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

START_TEST(what_cannot_be_read)
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
    tcase_add_loop_test(tcase, a_frame_holds_the_state, 0, 2);
    tcase_add_loop_test(tcase, a_frame_is_a_mesh, 0, 2);
    tcase_add_test(tcase, its_header_names_it);
    tcase_add_test(tcase, another_scene_or_size_is_foreign);
    tcase_add_test(tcase, bytes_that_are_missing_or_changed_are_seen);
    tcase_add_test(tcase, what_cannot_be_read);
    suite_add_tcase(suite, tcase);
    return suite;
}
