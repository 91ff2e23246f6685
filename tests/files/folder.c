// Folders that are made, or taken if they are empty.
#include "files/folder.h"

#include "support/program.h"
#include "support/support.h"

/// Expects a fault of the folder "a" or of another, which ends so.
static void expect_fault(const char *path, const char *otherwise,
                         const char *right)
{
    tf_fault fault;
    ck_assert(!tf_folder_begin(path, otherwise, &fault));
    ck_assert_str_eq(fault.text, right);
    ck_assert_str_eq(fault.file, path);
    ck_assert_int_eq(fault.place, -1);
}

START_TEST(a_folder_is_made_or_taken)
{
    tf_fault fault;
    ck_assert(tf_folder_begin("a", "", &fault));
    ck_assert(tf_folder_begin("a", "", &fault));
    ck_assert_int_eq(run("test -d a").status, 0);
}
END_TEST

START_TEST(a_folder_with_files_is_refused)
{
    run("mkdir a b; touch a/.hidden; mkdir b/c; touch file");
    expect_fault("a", "", "exists, and is not an empty folder; choose another");
    expect_fault("b", ", or leave it",
                 "exists, and is not an empty folder; choose another, or leave "
                 "it");
    expect_fault("file", "",
                 "exists, and is not an empty folder; choose another");
}
END_TEST

START_TEST(a_folder_nowhere_is_refused)
{
    expect_fault("none/a", "",
                 "there is no folder 'none'; make it, or choose another");
    make_file("file", "");
    expect_fault("file/a", "",
                 "cannot make this folder: Not a directory; choose another "
                 "with -o");
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("files/folder");
    TCase *folders = tcase_create("folders");
    tcase_add_checked_fixture(folders, enter_folder, leave_folder);
    tcase_add_test(folders, a_folder_is_made_or_taken);
    tcase_add_test(folders, a_folder_with_files_is_refused);
    tcase_add_test(folders, a_folder_nowhere_is_refused);
    suite_add_tcase(suite, folders);
    return suite;
}
