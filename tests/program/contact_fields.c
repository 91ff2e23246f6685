// The fields of a contact, to the letter.
#define _GNU_SOURCE // open_memstream

#include "program/contact_fields.h"

#include "support/support.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

static const tf_contact hit = {
    .verdict = TF_HIT,
    .classification = TF_GENERIC,
    .toi_lo = 0.1,
    .toi_hi = 0.25,
    .normal = {1, -0.5, 4.9e-324},
    .normal_velocity = -DBL_MAX,
};
// What a query leaves unset must not be read.
static const tf_contact apart = {
    .verdict = TF_APART, .classification = (tf_classification)99, .toi_lo = 7};

typedef struct row {
    tf_contact_values contact;
} row;

static const tf_field fields[] = {TF_CONTACT_FIELDS(row, contact), {0}};

static void expect(int axes, const tf_contact *contact, const char *right)
{
    char *text = NULL;
    size_t length;
    FILE *stream = open_memstream(&text, &length);
    row r = {tf_contact_values_of(contact, axes)};
    tf_record_write_csv(stream, fields, &r);
    fclose(stream);
    ck_assert_str_eq(text, right);
    free(text);
}

START_TEST(a_contact_has_all_values_but_nz_in_the_plane)
{
    expect(3, &hit,
           "0.10000000000000001,0.25,1,-0.5,4.9406564584124654e-324,"
           "-1.7976931348623157e+308,generic\n");
    expect(2, &hit,
           "0.10000000000000001,0.25,1,-0.5,,-1.7976931348623157e+308,"
           "generic\n");
    expect(3, &apart, ",,,,,,\n");
}
END_TEST

START_TEST(the_fields_have_the_names_of_the_values)
{
    char *text = NULL;
    size_t length;
    FILE *stream = open_memstream(&text, &length);
    tf_record_write_head(stream, fields);
    fclose(stream);
    ck_assert_str_eq(text, "toi_lo,toi_hi,nx,ny,nz,normal_velocity,case\n");
    free(text);
}
END_TEST

START_TEST(every_case_has_a_name)
{
    static const char *const names[] = {[TF_GENERIC] = "generic",
                                        [TF_TOUCHING] = "touching",
                                        [TF_DEGENERATE] = "degenerate"};
    for (int i = TF_GENERIC; i <= TF_DEGENERATE; i++) {
        tf_contact contact = {.verdict = TF_UNDECIDED,
                              .classification = (tf_classification)i};
        ck_assert_str_eq(tf_contact_values_of(&contact, 3).name, names[i]);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/contact_fields");
    TCase *tcase = tcase_create("fields");
    tcase_add_test(tcase, a_contact_has_all_values_but_nz_in_the_plane);
    tcase_add_test(tcase, the_fields_have_the_names_of_the_values);
    tcase_add_test(tcase, every_case_has_a_name);
    suite_add_tcase(suite, tcase);
    return suite;
}
