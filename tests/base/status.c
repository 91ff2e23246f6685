#include "base/status.h"

#include "support/support.h"

#include <string.h>

/// What each message must hold: the matter, and how to mend it.
static const struct {
    tf_status status;
    const char *matter, *mend;
} messages[] = {
    {TF_NOT_FINITE, "infinite or NaN", "; give finite positions"},
    {TF_OUT_OF_RANGE, "out of range", "; use exact"},
    {TF_BAD_INDEX, "index",
     "; the vertices of an element or a query must be distinct"},
    {TF_BAD_ENVIRONMENT, "floating-point environment",
     "; round to nearest and keep subnormal numbers, and compile without "
     "-ffast-math"},
    {TF_NO_ELEMENTS, "no elements", "; give it a triangle or an edge"},
    {TF_BAD_COUNT, "not those of this surface", "; give as many vertices"},
    {TF_OUT_OF_MEMORY, "not enough memory", "; divide the surface"},
    {TF_BAD_OPTION, "an option, tolerance or limit", " is not in its range"},
    {TF_BAD_MASS, "inverse mass", "; use 0 for a vertex that is scripted"},
    {TF_START_NOT_CLEAR, "when the step starts",
     "; start from a surface that does not intersect itself"},
    {TF_EDGE_NOT_MANIFOLD, "an edge", "; give each edge one triangle or two"},
    {TF_VERTEX_NOT_MANIFOLD, "at a vertex", "; give each its own vertex"},
    {TF_COLLINEAR, "on one line", "; remove it, or move a corner off"},
    {TF_NOT_EMBEDDED, "intersects or touches itself", "; move its parts away"},
    {TF_BAD_AXES, "axes must be 2", " and be that of the surface or the query"},
    {TF_CANCELLED, "cancelled", "; nothing is changed"},
    {TF_IN_USE, "memory is in use", "; set the allocator before"},
};

enum {
    MESSAGES = sizeof messages / sizeof *messages
};

START_TEST(messages_tell_how_to_fix_it)
{
    const char *message = tf_status_message(messages[_i].status);
    const char *matter = strstr(message, messages[_i].matter);
    ck_assert_msg(matter, "no '%s' in '%s'", messages[_i].matter, message);
    ck_assert_msg(strstr(matter, messages[_i].mend),
                  "'%s' does not follow in '%s'", messages[_i].mend, message);
}
END_TEST

START_TEST(every_status_has_a_message_of_its_own)
{
    for (int a = TF_OK; a <= TF_IN_USE; a++) {
        const char *message = tf_status_message((tf_status)a);
        ck_assert_uint_gt(strlen(message), 5);
        for (int b = TF_OK; b < a; b++)
            ck_assert_str_ne(message, tf_status_message((tf_status)b));
    }
    ck_assert_int_eq(MESSAGES, TF_IN_USE - TF_OK);
}
END_TEST

START_TEST(unknown_status_is_one_of_a_later_version)
{
    static const int unknown[] = {99, -1, TF_IN_USE + 1};
    ck_assert_str_eq(tf_status_message((tf_status)unknown[_i]),
                     "a status of a later version");
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("base/status");
    TCase *tcase = tcase_create("messages");
    tcase_add_loop_test(tcase, messages_tell_how_to_fix_it, 0, MESSAGES);
    tcase_add_test(tcase, every_status_has_a_message_of_its_own);
    tcase_add_loop_test(tcase, unknown_status_is_one_of_a_later_version, 0, 3);
    suite_add_tcase(suite, tcase);
    return suite;
}
