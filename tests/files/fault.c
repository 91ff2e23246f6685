#define _GNU_SOURCE // dup

#include "files/fault.h"

#include "support/program.h"
#include "support/support.h"

#include <errno.h>
#include <stdio.h>
#include <unistd.h>

/// Expects what is printed on standard error of a fault.
static void expect_print(const tf_fault *fault, const char *right)
{
    fflush(stderr);
    int kept = dup(STDERR_FILENO);
    ck_assert_ptr_nonnull(freopen("printed", "w", stderr));
    tf_fault_print(fault, "program");
    fflush(stderr);
    dup2(kept, STDERR_FILENO);
    close(kept);
    ck_assert_str_eq(file_text("printed"), right);
}

START_TEST(faults_are_printed_with_their_place)
{
    tf_fault fault = {0};
    expect_print(&fault, "");
    ck_assert(!tf_fault_set(&fault, "a\x1b", 12, "%s; %d", "bad", 7));
    expect_print(&fault, "program: a\\x1b:12: bad; 7\n");
    fault.counts_bytes = true;
    fault.place = 3000000000;
    expect_print(&fault, "program: a\\x1b: byte 3000000000: bad; 7\n");
    fault.place = 0;
    expect_print(&fault, "program: a\\x1b: byte 0: bad; 7\n");
    fault.place = -1;
    expect_print(&fault, "program: a\\x1b: bad; 7\n");
    ck_assert(!tf_fault_set(&fault, "b", 3, "worse"));
    expect_print(&fault, "program: b:3: worse\n");
}
END_TEST

START_TEST(faults_of_the_system_name_their_reason)
{
    tf_fault fault;
    ck_assert(!tf_fault_set_unopened(&fault, "a", ENOENT));
    expect_print(&fault, "program: a: cannot open: No such file or directory; "
                         "check the name\n");
    ck_assert(!tf_fault_set_unread(&fault, "a", 2, EISDIR));
    expect_print(&fault, "program: a:2: cannot read: Is a directory; check "
                         "that this is a file\n");
    ck_assert(!tf_fault_set_unwritten(&fault, "a", ENOSPC));
    expect_print(&fault, "program: a: cannot write: No space left on device; "
                         "mend that, and run again\n");
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("files/fault");
    TCase *faults = tcase_create("faults");
    tcase_add_checked_fixture(faults, enter_folder, leave_folder);
    tcase_add_test(faults, faults_are_printed_with_their_place);
    tcase_add_test(faults, faults_of_the_system_name_their_reason);
    suite_add_tcase(suite, faults);
    return suite;
}
