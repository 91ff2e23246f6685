#define _GNU_SOURCE

#include "writers/collection.h"

#include "support/polydata.h"
#include "support/program.h"
#include "support/support.h"

#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static tf_fault fault;
static tf_collection collection;

START_TEST(names_end_in_pvd)
{
    ck_assert(tf_is_collection("a.pvd"));
    ck_assert(tf_is_collection("x/a.b.PVD"));
    ck_assert(!tf_is_collection("a.vtp"));
    ck_assert(!tf_is_collection(".pvd"));
    ck_assert(!tf_is_collection("folder/.pvd"));
    ck_assert(!tf_is_collection("pvd"));
    ck_assert(!tf_is_collection("-"));
}
END_TEST

static bool add_frame(int number)
{
    const double x[] = {number, 2, 3, 4, 5, 6};
    tf_polydata mesh = tf_polydata_of(2, x, 3);
    tf_polydata contacts = tf_polydata_of(1, x + 3, 3);
    return tf_collection_add(&collection, &mesh, &contacts);
}

START_TEST(frames_are_listed)
{
    ck_assert_int_eq(mkdir("folder", 0777), 0);
    ck_assert(tf_collection_begin(&collection, "folder/a&b.pvd", &fault));
    for (int i = 0; i < 2; i++)
        ck_assert(add_frame(i));
    ck_assert_int_ne(access("folder/a&b.pvd", F_OK), 0);
    ck_assert(tf_collection_end(&collection));
    ck_assert_str_eq(
        file_text("folder/a&b.pvd"),
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n"
        "<DataSet timestep=\"0\" group=\"\" part=\"0\" "
        "file=\"a&#38;b/mesh-00000.vtp\"/>\n"
        "<DataSet timestep=\"0\" group=\"\" part=\"1\" "
        "file=\"a&#38;b/contacts-00000.vtp\"/>\n"
        "<DataSet timestep=\"1\" group=\"\" part=\"0\" "
        "file=\"a&#38;b/mesh-00001.vtp\"/>\n"
        "<DataSet timestep=\"1\" group=\"\" part=\"1\" "
        "file=\"a&#38;b/contacts-00001.vtp\"/>\n"
        "</Collection>\n</VTKFile>\n");
    ck_assert_int_eq(polydata_count(file_text("folder/a&b/mesh-00001.vtp"),
                                    "NumberOfPoints"),
                     2);
    ck_assert_int_eq(polydata_count(file_text("folder/a&b/contacts-00001.vtp"),
                                    "NumberOfPoints"),
                     1);
    expect(run("ls -A 'folder/a&b' | wc -l"), 0, "4\n", "");
}
END_TEST

START_TEST(a_folder_that_is_there_is_taken)
{
    ck_assert_int_eq(mkdir("a", 0777), 0);
    make_file("a/mine", "before\n");
    make_file("a/mesh-00000.vtp", "before\n");
    ck_assert(tf_collection_begin(&collection, "a.pvd", &fault));
    ck_assert(add_frame(0));
    ck_assert(tf_collection_end(&collection));
    ck_assert_str_eq(file_text("a/mine"), "before\n");
    ck_assert_int_eq(
        polydata_count(file_text("a/mesh-00000.vtp"), "NumberOfPoints"), 2);
}
END_TEST

START_TEST(what_cannot_be_written_is_named)
{
    make_file("a", "before\n");
    ck_assert(!tf_collection_begin(&collection, "a.pvd", &fault));
    ck_assert_str_eq(fault.file, "a");
    ck_assert_str_eq(fault.text, "cannot make this folder: File exists; choose "
                                 "another with -o");
    ck_assert(!tf_collection_begin(&collection, "no/a.pvd", &fault));
    ck_assert_str_eq(fault.file, "no/a");
    expect_words(fault.text, "No such file or directory");

    ck_assert(tf_collection_begin(&collection, "b.pvd", &fault));
    ck_assert_int_eq(mkdir("b/mesh-00000.vtp", 0777), 0);
    ck_assert(!add_frame(0));
    ck_assert_str_eq(fault.file, "b/mesh-00000.vtp");
    expect_words(fault.text, "cannot write: Is a directory; ");
    ck_assert_int_eq(mkdir("b.pvd", 0777), 0);
    ck_assert(!tf_collection_end(&collection));
    ck_assert_str_eq(fault.file, "b.pvd");
    expect_words(fault.text, "cannot write: Is a directory; ");
    expect(run("ls -A b"), 0, "mesh-00000.vtp\n", "");
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("writers/collection");
    TCase *tcase = tcase_create("collections");
    tcase_add_checked_fixture(tcase, enter_folder, leave_folder);
    tcase_add_test(tcase, names_end_in_pvd);
    tcase_add_test(tcase, frames_are_listed);
    tcase_add_test(tcase, a_folder_that_is_there_is_taken);
    tcase_add_test(tcase, what_cannot_be_written_is_named);
    suite_add_tcase(suite, tcase);
    return suite;
}
