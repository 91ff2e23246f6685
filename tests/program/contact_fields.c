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

typedef void writer(FILE *stream, int axes, const tf_contact *contact);

static void expect(writer *write, int axes, const tf_contact *contact,
                   const char *right)
{
    char *text = NULL;
    size_t length;
    FILE *stream = open_memstream(&text, &length);
    write(stream, axes, contact);
    fclose(stream);
    ck_assert_str_eq(text, right);
    free(text);
}

static void write_head(FILE *stream, int axes, const tf_contact *contact)
{
    (void)axes;
    (void)contact;
    tf_contact_head_csv(stream);
}

START_TEST(as_csv)
{
    expect(write_head, 3, NULL,
           ",toi_lo,toi_hi,nx,ny,nz,normal_velocity,case\n");
    expect(tf_contact_write_csv, 3, &hit,
           ",0.10000000000000001,0.25,1,-0.5,4.9406564584124654e-324,"
           "-1.7976931348623157e+308,generic\n");
    expect(tf_contact_write_csv, 2, &hit,
           ",0.10000000000000001,0.25,1,-0.5,,-1.7976931348623157e+308,"
           "generic\n");
    expect(tf_contact_write_csv, 3, &apart, ",,,,,,,\n");
}
END_TEST

START_TEST(as_json)
{
    expect(tf_contact_write_json, 3, &hit,
           ",\"toi_lo\":0.10000000000000001,\"toi_hi\":0.25,\"nx\":1,"
           "\"ny\":-0.5,\"nz\":4.9406564584124654e-324,"
           "\"normal_velocity\":-1.7976931348623157e+308,"
           "\"case\":\"generic\"}");
    expect(tf_contact_write_json, 2, &hit,
           ",\"toi_lo\":0.10000000000000001,\"toi_hi\":0.25,\"nx\":1,"
           "\"ny\":-0.5,\"nz\":null,"
           "\"normal_velocity\":-1.7976931348623157e+308,"
           "\"case\":\"generic\"}");
    expect(tf_contact_write_json, 3, &apart,
           ",\"toi_lo\":null,\"toi_hi\":null,\"nx\":null,\"ny\":null,"
           "\"nz\":null,\"normal_velocity\":null,\"case\":null}");
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
        char right[100];
        ck_assert_str_eq(tf_classification_names[i], names[i]);
        snprintf(right, sizeof right, ",0,0,0,0,0,0,%s\n", names[i]);
        expect(tf_contact_write_csv, 3, &contact, right);
    }
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/contact_fields");
    TCase *fields = tcase_create("fields");
    tcase_add_test(fields, as_csv);
    tcase_add_test(fields, as_json);
    tcase_add_test(fields, every_case_has_a_name);
    suite_add_tcase(suite, fields);
    return suite;
}
