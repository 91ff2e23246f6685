// Scene files: what is read of them, and each mistake.
#include "scenes/scene_file.h"

#include "support/program.h"
#include "support/support.h"

#include <string.h>

static void enter_folder_of_files(void)
{
    enter_folder();
    run("mkdir walk; touch walk/body-1.ply walk/body-2.ply walk/body-10.ply "
        "a.obj b.obj");
}

/// Reads a text as the file "scene.yaml".
static bool read_text(tf_scene_meshes *meshes, const char *text,
                      tf_fault *fault)
{
    make_file("scene.yaml", text);
    fault->text[0] = '\0';
    return tf_scene_file_read(meshes, "scene.yaml", fault);
}

static tf_scene_meshes good_scene(const char *text)
{
    tf_scene_meshes meshes;
    tf_fault fault;
    ck_assert_msg(read_text(&meshes, text, &fault), "%ld: %s", fault.place,
                  fault.text);
    return meshes;
}

// Good scenes -----------------------------------------------------------------

static const char *const same[] = {
    "meshes:\n"
    "  - name: body\n"
    "    frames: walk/body-*.ply # in natural order\n"
    "    role: scripted\n"
    "  - name: shirt\n"
    "    frames: [a.obj, b.obj, a.obj]\n"
    "    mass: 0.25\n"
    "    friction: 0.4\n"
    "    group: outfit\n"
    "    role: moving\n",
    "{\"meshes\": [{\"name\": \"body\", \"frames\": \"walk/body-*.ply\", "
    "\"role\": \"scripted\"}, {\"name\": \"shirt\", \"frames\": [\"a.obj\", "
    "\"b.obj\", \"a.obj\"], \"mass\": 2.5e-1, \"friction\": 0.4, \"group\": "
    "\"outfit\"}]}\n",
    "%YAML 1.1\n---\nmeshes:\n"
    "- {frames: [walk/body-1.ply, walk/body-2.ply, walk/body-10.ply], "
    "role: scripted}\n"
    "- frames: [&a a.obj, b.obj, *a]\n"
    "  name: 'shirt'\n"
    "  mass: \"0.25\"\n"
    "  friction: 4e-1\n"
    "  group: outfit\n...\n",
    "\xef\xbb\xbfmeshes:\r\n- name: body\r\n  role: scripted\r\n"
    "  frames: walk/body-*.ply\r\n"
    "- frames:\r\n  - a.obj\r\n  - b.obj\r\n  - a.obj\r\n"
    "  group: outfit\r\n  name: shirt\r\n  mass: 0x1p-2\r\n  friction: 0.4",
};

START_TEST(a_scene_has_meshes)
{
    tf_scene_meshes meshes = good_scene(same[_i]);
    ck_assert_int_eq(meshes.count, 2);
    ck_assert_int_eq(meshes.frames, 3);
    const tf_scene_mesh *body = &meshes.mesh[0], *shirt = &meshes.mesh[1];
    ck_assert_str_eq(body->name, "body");
    ck_assert_str_eq(body->frames.path[0], "walk/body-1.ply");
    ck_assert_str_eq(body->frames.path[1], "walk/body-2.ply");
    ck_assert_str_eq(body->frames.path[2], "walk/body-10.ply");
    ck_assert(body->role == TF_SCRIPTED && body->mass == 0 &&
              body->friction < 0 && !body->group);
    ck_assert_str_eq(shirt->name, "shirt");
    ck_assert_int_eq(shirt->frames.count, 3);
    ck_assert_str_eq(shirt->frames.path[2], "a.obj");
    ck_assert(shirt->role == TF_MOVING && shirt->mass == 0.25 &&
              shirt->friction == 0.4);
    ck_assert_str_eq(shirt->group, "outfit");
    tf_scene_meshes_free(&meshes);
}
END_TEST

START_TEST(utf_16_is_read)
{
    static const char text[] = "meshes: [{frames: a.obj}]";
    char wide[2 * sizeof text] = "\xff\xfe";
    for (size_t i = 0; text[i]; i++)
        wide[2 + 2 * i] = text[i];
    make_binary_file("scene.yaml", wide, 2 * strlen(text) + 2);
    tf_scene_meshes meshes;
    tf_fault fault;
    ck_assert(tf_scene_file_read(&meshes, "scene.yaml", &fault));
    ck_assert_str_eq(meshes.mesh[0].name, "a");
    tf_scene_meshes_free(&meshes);
}
END_TEST

START_TEST(files_are_found_from_the_scene)
{
    make_file("walk/scene.yaml", "meshes: [{frames: ../a.obj}, "
                                 "{frames: body-1.ply, role: fixed}]");
    tf_scene_meshes meshes;
    tf_fault fault;
    ck_assert(tf_scene_file_read(&meshes, "walk/scene.yaml", &fault));
    ck_assert_str_eq(meshes.mesh[0].frames.path[0], "walk/../a.obj");
    ck_assert_str_eq(meshes.mesh[1].frames.path[0], "walk/body-1.ply");
    ck_assert(meshes.mesh[1].role == TF_FIXED);
    ck_assert_str_eq(meshes.mesh[1].name, "body-1");
    tf_scene_meshes_free(&meshes);
}
END_TEST

START_TEST(a_scene_is_known_by_its_ending)
{
    static const char *const scenes[] = {"a.yaml", "b/a.yml", "a.json",
                                         "A.YAML", ".json"};
    static const char *const meshes[] = {
        "a.obj", "-", "yaml", "a.yaml.gz", "a.ply", "a.yam", "a.yaml/b", ""};
    for (int i = 0; i < 5; i++)
        ck_assert_msg(tf_is_scene(scenes[i]), "%s", scenes[i]);
    for (int i = 0; i < 8; i++)
        ck_assert_msg(!tf_is_scene(meshes[i]), "%s", meshes[i]);
}
END_TEST

// What is simulated -----------------------------------------------------------

START_TEST(a_scene_says_how_it_is_simulated)
{
    make_file("waist.txt", "0 1\n");
    tf_scene_meshes meshes = good_scene(
        "shows: a shirt\nrate: 25\nsteps: 300\nstep: 0.005\ngravity: 1.6\n"
        "up: y\nfriction: 0.5\n"
        "air: {drag: 0.1, wind: [1, -2, 3e0], veer: -1, gust: 2}\n"
        "material: {density: 0.2, bend: 0}\n"
        "meshes:\n"
        "- frames: a.obj\n  pinned: waist.txt\n  mass: 0.1\n"
        "- frames: b.obj\n  pinned: [3, 1]\n  mass: 0.1\n"
        "  material: {stretch: 5, bend: 7}\n  friction: 0.1\n");
    const tf_scene_physics *p = &meshes.physics;
    ck_assert_str_eq(p->shows, "a shirt");
    ck_assert(p->rate == 25 && p->steps == 300 && p->step == 0.005);
    ck_assert(p->gravity == 1.6 && p->up == 1 && p->friction == 0.5);
    ck_assert(p->air.given && p->air.drag == 0.1 && p->air.veer == -1 &&
              p->air.gust == 2);
    ck_assert(p->air.wind[0] == 1 && p->air.wind[1] == -2 &&
              p->air.wind[2] == 3);
    const tf_scene_mesh *a = &meshes.mesh[0], *b = &meshes.mesh[1];
    ck_assert_str_eq(a->pinned_in.path[0], "waist.txt");
    ck_assert_int_eq(a->pinned_line, 12);
    ck_assert(b->pins == 2 && b->pinned[0] == 3 && b->pinned[1] == 1);
    ck_assert(a->friction == 0.5 && b->friction == 0.1);
    ck_assert(a->material.density < 0 && a->material.stretch < 0 &&
              a->material.bend == 0);
    ck_assert(b->material.density < 0 && b->material.stretch == 5 &&
              b->material.bend == 7);
    tf_scene_meshes_free(&meshes);
}
END_TEST

START_TEST(a_scene_may_say_nothing_of_that)
{
    tf_scene_meshes meshes = good_scene("meshes: [{frames: a.obj}]");
    const tf_scene_physics *p = &meshes.physics;
    ck_assert(!p->shows && !p->shape && p->size < 0 && p->edge < 0 &&
              p->steps < 0 && p->step < 0 && p->rate < 0 && p->gravity < 0 &&
              p->up < 0 && p->friction < 0 && !p->air.given);
    ck_assert(meshes.mesh[0].material.density < 0 &&
              meshes.mesh[0].material.stretch < 0 &&
              meshes.mesh[0].material.bend < 0 && meshes.mesh[0].pins == 0);
    tf_scene_meshes_free(&meshes);
}
END_TEST

START_TEST(a_simulated_scene_may_have_a_shape)
{
    tf_scene_meshes meshes;
    tf_fault fault;
    make_file("scene.yaml", "shape: sphere\nsize: 7\n");
    ck_assert(tf_simulated_file_read(&meshes, "scene.yaml", &fault));
    ck_assert_str_eq(meshes.physics.shape, "sphere");
    ck_assert_int_eq(meshes.physics.size, 7);
    ck_assert_int_eq(meshes.physics.shape_line, 1);
    ck_assert_int_eq(meshes.physics.resolution_line, 2);
    ck_assert_int_eq(meshes.count, 0);
    tf_scene_meshes_free(&meshes);
}
END_TEST

// Mistakes --------------------------------------------------------------------

#define A_MESH "meshes:\n- frames: a.obj\n"
#define MESH_KEYS                                                              \
    "a mesh has frames, and may have name, role, mass, friction, group, "      \
    "material and pinned"
#define SCENE_KEYS                                                             \
    "a scene has 'meshes:', a list, and to be simulated may have rate, "       \
    "steps, "                                                                  \
    "step, gravity, up, friction, air, material and shows"

static const struct {
    const char *text;
    long line;
    const char *fault;
} mistakes[] = {
    // No meshes.
    {"", -1, "is empty; " SCENE_KEYS},
    {"# nothing\n---\n", 3, "not a mapping; " SCENE_KEYS},
    {"{}\n", 1, "no meshes; " SCENE_KEYS},
    {"- frames: a.obj\n", 1, "not a mapping; " SCENE_KEYS},
    {"a.obj\n", 1, "not a mapping; " SCENE_KEYS},
    {"meshes:\n", 1, "meshes must be a list; write '- frames: FILE' for each"},
    {"\nmeshes: []\n", 2,
     "meshes must be a list; write '- frames: FILE' for each"},
    {"meshes:\n  frames: a.obj\n", 2,
     "meshes must be a list; write '- frames: FILE' for each"},
    {"meshes:\n- a.obj\n", 2, "not a mapping; " MESH_KEYS},
    // Keys.
    {"mesh:\n- frames: a.obj\n", 1, "unknown key 'mesh'; " SCENE_KEYS},
    {A_MESH "mass: 1\n", 3, "unknown key 'mass'; " SCENE_KEYS},
    {A_MESH "meshes: []\n", 3, "the key 'meshes' is there twice; delete one"},
    {A_MESH "  weight: 1\n", 3, "unknown key 'weight'; " MESH_KEYS},
    {A_MESH "  Name: a\n", 3, "unknown key 'Name'; " MESH_KEYS},
    {A_MESH "  \"a\\eb\": 1\n", 3, "unknown key 'a\\x1bb'; " MESH_KEYS},
    {A_MESH "  <<: {mass: 1}\n", 3, "unknown key '<<'; " MESH_KEYS},
    {A_MESH "  frames: b.obj\n", 3,
     "the key 'frames' is there twice; delete one"},
    {A_MESH "  group: a\n  mass: 1\n  group: b\n", 5,
     "the key 'group' is there twice; delete one"},
    {A_MESH "  [a]: 1\n", 3, "a key must be a text, not a list or a mapping"},
    {A_MESH "  '': 1\n", 3, "a key is an empty text; fill it in"},
    // Frames.
    {"meshes:\n- name: a\n", 2,
     "a mesh without frames; write 'frames:' and a file, a pattern or a list "
     "of some"},
    {"meshes:\n- {}\n", 2,
     "a mesh without frames; write 'frames:' and a file, a pattern or a list "
     "of some"},
    {"meshes:\n- frames: c.obj\n", 2,
     "there is no file 'c.obj'; names are relative to the scene file"},
    {"meshes:\n- frames:\n  - a.obj\n  - c-*.obj\n", 4,
     "there is no file 'c-*.obj'; names are relative to the scene file"},
    {"meshes:\n- frames:\n", 2,
     "a file of frames is an empty text; fill it in"},
    {"meshes:\n- frames: []\n", 2,
     "frames must be a file, a pattern or a list of some"},
    {"meshes:\n- frames: {a.obj: b.obj}\n", 2,
     "frames must be a file, a pattern or a list of some"},
    {"meshes:\n- frames: [a.obj,\n    [b.obj]]\n", 3,
     "a file of frames must be a text, not a list or a mapping"},
    {"meshes:\n- frames: \"a\\0b\"\n", 2,
     "a file of frames has a NUL character; remove it"},
    {"meshes:\n- frames: e*.obj\n", 2,
     "e07.obj and e7.obj have the same number; delete one, or list the "
     "frames"},
    {"meshes:\n- frames: z*.obj*\n", 2,
     "z7.obj and z7.obj.gz have the same number; delete one, or list the "
     "frames"},
    {"meshes:\n- &m\n  frames: *m\n", 2,
     "frames must be a file, a pattern or a list of some"},
    // Pins.
    {A_MESH "  role: scripted\n  pinned: [0]\n", 2,
     "all vertices of a scripted mesh are pinned anyway; delete 'pinned:'"},
    {A_MESH "  pinned: a.obj\n  role: fixed\n", 2,
     "all vertices of a fixed mesh are pinned anyway; delete 'pinned:'"},
    // Values.
    {A_MESH "  role: scriptd\n", 3,
     "role must be moving, scripted or fixed, got 'scriptd'"},
    {A_MESH "  role: Fixed\n", 3,
     "role must be moving, scripted or fixed, got 'Fixed'"},
    {A_MESH "  role:\n", 3, "role is an empty text; fill it in"},
    {A_MESH "  role: [fixed]\n", 3,
     "role must be a text, not a list or a mapping"},
    {A_MESH "  mass: heavy\n", 3, "mass must be a number above 0, got 'heavy'"},
    {A_MESH "  mass: 0\n", 3, "mass must be a number above 0, got '0'"},
    {A_MESH "  mass: -1\n", 3, "mass must be a number above 0, got '-1'"},
    {A_MESH "  mass: 1e999\n", 3, "mass must be a number above 0, got '1e999'"},
    {A_MESH "  mass: .nan\n", 3, "mass must be a number above 0, got '.nan'"},
    {A_MESH "  mass: 1 kg\n", 3, "mass must be a number above 0, got '1 kg'"},
    {A_MESH "  mass: [1]\n", 3, "mass must be a text, not a list or a mapping"},
    {A_MESH "  friction: -0.1\n", 3,
     "friction must be a number from 0 on, got '-0.1'"},
    {A_MESH "  friction: 0,4\n", 3,
     "friction must be a number from 0 on, got '0,4'"},
    {A_MESH "  name: a/b\n", 3,
     "the name 'a/b' has a slash, but files are named after it; remove the "
     "slash"},
    {A_MESH "  name: ''\n", 3, "name is an empty text; fill it in"},
    {A_MESH "  group: {a: b}\n", 3,
     "group must be a text, not a list or a mapping"},
    {A_MESH "  material: cotton\n", 3,
     "not a mapping; a material may have density, stretch and bend"},
    {A_MESH "  material: {weight: 1}\n", 3,
     "unknown key 'weight'; a material may have density, stretch and bend"},
    {A_MESH "  material:\n    density: 0\n", 4,
     "density must be a number above 0, got '0'"},
    {A_MESH "  material: {stretch: -1}\n", 3,
     "stretch must be a number above 0, got '-1'"},
    {A_MESH "  material: {bend: stiff}\n", 3,
     "bend must be a number from 0 on, got 'stiff'"},
    {A_MESH "  pinned: []\n", 3, "pinned must be a list of vertices or a file"},
    {A_MESH "  pinned: {}\n", 3, "pinned must be a list of vertices or a file"},
    {A_MESH "  pinned:\n  - 0\n  - -1\n", 5,
     "a pinned vertex must be a number from 0 on, got '-1'"},
    {A_MESH "  pinned: [0, 1.5]\n", 3,
     "a pinned vertex must be a whole number, got '1.5'"},
    {A_MESH "  pinned: [3000000000]\n", 3,
     "a pinned vertex must be a whole number, got '3000000000'"},
    {A_MESH "  pinned: [[0]]\n", 3,
     "a pinned vertex must be a text, not a list or a mapping"},
    {A_MESH "  pinned: c.txt\n", 3,
     "there is no file 'c.txt'; names are relative to the scene file"},
    // How it is simulated.
    {A_MESH "steps: 100000\n", 3,
     "steps must be a number from 0 to 99999, got '100000'"},
    {A_MESH "steps: 1.5\n", 3, "steps must be a whole number, got '1.5'"},
    {A_MESH "step: 0\n", 3, "step must be a number above 0, got '0'"},
    {A_MESH "rate: 25 Hz\n", 3, "rate must be a number above 0, got '25 Hz'"},
    {A_MESH "gravity: -9.81\n", 3,
     "gravity must be a number from 0 on, got '-9.81'"},
    {A_MESH "gravity: [0, 0, 1]\n", 3,
     "gravity must be a text, not a list or a mapping"},
    {A_MESH "up: yes\n", 3, "up must be x, y or z, got 'yes'"},
    {A_MESH "up: w\n", 3, "up must be x, y or z, got 'w'"},
    {A_MESH "up: [y]\n", 3, "up must be a text, not a list or a mapping"},
    {A_MESH "friction: -1\n", 3,
     "friction must be a number from 0 on, got '-1'"},
    {A_MESH "air: still\n", 3,
     "not a mapping; air may have drag, wind, veer and gust"},
    {A_MESH "air:\n  storm: 1\n", 4,
     "unknown key 'storm'; air may have drag, wind, veer and gust"},
    {A_MESH "air: {drag: -1}\n", 3,
     "drag must be a number from 0 on, got '-1'"},
    {A_MESH "air: {wind: 5}\n", 3,
     "wind must be three numbers; write [1, 0, 0]"},
    {A_MESH "air: {wind: [1, 2]}\n", 3,
     "wind must be three numbers; write [1, 0, 0]"},
    {A_MESH "air:\n  wind: [1,\n    2, x]\n", 5,
     "wind must be a number, got 'x'"},
    {A_MESH "air: {veer: .inf}\n", 3, "veer must be a number, got '.inf'"},
    {A_MESH "material: {bend: -1}\n", 3,
     "bend must be a number from 0 on, got '-1'"},
    {A_MESH "shows: []\n", 3, "shows must be a text, not a list or a mapping"},
    {"shape: [sphere]\n", 1, "shape must be a text, not a list or a mapping"},
    {A_MESH "shape: sphere\n", 3,
     "the scene has meshes and a shape; delete one of them"},
    {A_MESH "size: 10\n", 3,
     "size and edge are for a shape; meshes are as fine as their files, so "
     "delete this"},
    {A_MESH "edge: 0.1\n", 3,
     "size and edge are for a shape; meshes are as fine as their files, so "
     "delete this"},
    {"shape: sphere\nsize: 2001\n", 2,
     "size must be a number from 1 to 2000, got '2001'"},
    {"shape: star\nedge: 0\n", 2, "edge must be a number above 0, got '0'"},
    {"steps: 1\nshape: sphere\n", 2,
     "a shape is for 'tanglefree simulate'; give other commands the frames "
     "that this writes"},
    // Meshes that do not go together.
    {A_MESH "- frames: b.obj\n  name: a\n", 3,
     "there is already a mesh named 'a'; name one of them differently, by "
     "'name:'"},
    {"meshes:\n- frames: [a.obj, b.obj]\n  role: scripted\n"
     "- frames: walk/body-*.ply\n",
     2,
     "'a' has 2 frames, but 'body' has 3; give each mesh one frame, or all the "
     "same number"},
    {A_MESH "- frames: b.obj\n  mass: 1\n", 2,
     "'a' has no mass, but another moving mesh has one; give a mass to all "
     "moving meshes or to none"},
    // What is not YAML.
    {"meshes:\n- frames: [a.obj\n", 3,
     "is not YAML: did not find expected ',' or ']'; mend it there, or in the "
     "line before"},
    {"meshes:\n- frames: a.obj\n   role: fixed\n", 3,
     "is not YAML: mapping values are not allowed in this context; mend it "
     "there, or in the line before"},
    {"meshes:\n\t- frames: a.obj\n", 2,
     "is not YAML: found character that cannot start any token; mend it there, "
     "or in the line before"},
    {"meshes:\n- frames: *b\n", 2,
     "is not YAML: found undefined alias; mend it there, or in the line "
     "before"},
    {"meshes: \xff\n", 8,
     "is not YAML: invalid leading UTF-8 octet; write it in UTF-8"},
    {A_MESH "---\n" A_MESH, 4, "a second document; a scene file has one"},
    {A_MESH "---\n[\n", 5,
     "is not YAML: did not find expected node content; mend it there, or in "
     "the line before"},
};

START_TEST(each_mistake_has_a_line_and_a_mend)
{
    tf_scene_meshes meshes;
    tf_fault fault;
    static const char *const names[] = {"e7.obj", "e07.obj", "z6.obj", "z7.obj",
                                        "z7.obj.gz"};
    for (int i = 0; i < 5; i++)
        make_file(names[i], "");
    ck_assert(!read_text(&meshes, mistakes[_i].text, &fault));
    ck_assert_str_eq(fault.text, mistakes[_i].fault);
    ck_assert_int_eq(fault.place, mistakes[_i].line);
    ck_assert_str_eq(fault.file, "scene.yaml");
    ck_assert_int_eq(fault.counts_bytes,
                     strstr(fault.text, "write it in UTF-8") != NULL);
    tf_scene_meshes_free(&meshes);
}
END_TEST

START_TEST(files_that_cannot_be_read_are_told)
{
    tf_scene_meshes meshes;
    tf_fault fault;
    ck_assert(!tf_scene_file_read(&meshes, "absent.yaml", &fault));
    ck_assert_str_eq(fault.text,
                     "cannot open: No such file or directory; check the name");
    ck_assert(!tf_scene_file_read(&meshes, "walk", &fault));
    ck_assert_str_eq(fault.text, "cannot read: Is a directory; check that this "
                                 "is a file");
}
END_TEST

// Deep nesting and aliases that refer to themselves end.
START_TEST(hostile_texts_end)
{
    static char deep[10000];
    memset(deep, '[', sizeof deep - 1);
    tf_scene_meshes meshes;
    tf_fault fault;
    ck_assert(!read_text(&meshes, deep, &fault));
    ck_assert(!read_text(&meshes, "&a [*a, *a]", &fault));
    tf_scene_meshes_free(&meshes);
    ck_assert(!read_text(&meshes,
                         "a: &a [x,x]\nb: &b [*a,*a]\nc: &c [*b,*b]\n"
                         "meshes: [{frames: *c}]\n",
                         &fault));
    tf_scene_meshes_free(&meshes);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("scenes/scene_file");
    TCase *good = tcase_create("good scenes");
    tcase_add_checked_fixture(good, enter_folder_of_files, leave_folder);
    tcase_add_loop_test(good, a_scene_has_meshes, 0,
                        sizeof same / sizeof *same);
    tcase_add_test(good, utf_16_is_read);
    tcase_add_test(good, files_are_found_from_the_scene);
    tcase_add_test(good, a_scene_is_known_by_its_ending);
    tcase_add_test(good, a_scene_says_how_it_is_simulated);
    tcase_add_test(good, a_scene_may_say_nothing_of_that);
    tcase_add_test(good, a_simulated_scene_may_have_a_shape);
    suite_add_tcase(suite, good);

    TCase *bad = tcase_create("mistakes");
    tcase_add_checked_fixture(bad, enter_folder_of_files, leave_folder);
    tcase_add_loop_test(bad, each_mistake_has_a_line_and_a_mend, 0,
                        sizeof mistakes / sizeof *mistakes);
    tcase_add_test(bad, files_that_cannot_be_read_are_told);
    tcase_add_test(bad, hostile_texts_end);
    suite_add_tcase(suite, bad);
    return suite;
}
