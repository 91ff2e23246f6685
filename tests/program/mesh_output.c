#define _GNU_SOURCE

#include "program/mesh_output.h"

#include "support/meshes.h"
#include "support/program.h"
#include "support/support.h"

#include <errno.h>
#include <stdlib.h>

static bool say_so(FILE *stream, const void *context)
{
    return fprintf(stream, "%s\n", (const char *)context) > 0 &&
           fflush(stream) == 0;
}

static bool fail_to_say(FILE *stream, const void *context)
{
    (void)stream;
    (void)context;
    errno = ENOSPC;
    return false;
}

static const char text[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

static bool write_to(const char *path,
                     bool (*report)(FILE *stream, const void *context))
{
    tf_mesh_output output = {0};
    tf_mesh_file mesh = good_mesh(text);
    bool good = tf_mesh_output_begin(&output, path) &&
                tf_mesh_output_write(&output, &mesh, report, "done");
    ck_assert(good == (output.target == NULL));
    tf_mesh_output_end(&output);
    tf_mesh_file_free(&mesh);
    return good;
}

START_TEST(a_mesh_is_written_to_a_file)
{
    ck_assert(write_to("made", say_so));
    ck_assert_str_eq(file_text("made"), text);
    ck_assert(write_to("made.ply", say_so));
    expect_words(file_text("made.ply"), "ply\n");
}
END_TEST

// Not in part, and not at all if the report cannot be.
START_TEST(what_fails_leaves_the_file_as_it_was)
{
    make_file("made", "before\n");
    ck_assert(!write_to("made", fail_to_say));
    ck_assert_str_eq(file_text("made"), "before\n");
    ck_assert(!write_to("no/folder/made", say_so));
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/mesh_output");
    TCase *tcase = tcase_create("files");
    tcase_add_checked_fixture(tcase, enter_folder, leave_folder);
    tcase_add_test(tcase, a_mesh_is_written_to_a_file);
    tcase_add_test(tcase, what_fails_leaves_the_file_as_it_was);
    suite_add_tcase(suite, tcase);
    return suite;
}
