// The response that a command line requests.
#include "program/response_request.h"

#include "response/minres.h"
#include "support/support.h"

#include <string.h>

/// The request of resolve with what is usual, as if `option` had been given.
static tf_request request_with(const char *option)
{
    tf_request request = {0};
    tf_request_begin(&request, TF_RESOLVE);
    for (int i = 0; tf_options[i].name && option; i++)
        if (tf_options[i].commands & TF_RESOLVE &&
            strcmp(tf_options[i].name, option) == 0)
            request.given |= UINT64_C(1) << i;
    return request;
}

START_TEST(options_are_those_of_the_request)
{
    tf_request request = request_with(NULL);
    tf_progress_line progress = {0};
    request.solver = &tf_minres;
    request.separation = 1;
    request.friction = 2;
    request.restitution = 0.5;
    request.restitution_threshold = 4;
    request.substeps = 5;
    request.thickness = 6;
    tf_response_options how = tf_response_requested(&request, &progress);
    ck_assert_uint_eq(how.size, sizeof how);
    ck_assert_ptr_eq(how.solver, &tf_minres);
    ck_assert(how.separation == 1 && how.friction == 2);
    ck_assert(how.restitution == 0.5 && how.restitution_threshold == 4);
    ck_assert(how.substeps == 5 && how.thickness == 6);
    ck_assert(!how.check_start && !how.parallel && !how.vertex_friction);
    ck_assert_ptr_eq(how.context, &progress);
    ck_assert(how.progress(how.context, &(tf_stage){.name = "pairs"}));
    ck_assert(!progress.shown);
}
END_TEST

START_TEST(a_separation_of_0_that_was_given_is_none)
{
    tf_progress_line progress = {0};
    tf_request usual = request_with(NULL), given = request_with("separation");
    ck_assert(tf_response_requested(&usual, &progress).separation == 0);
    ck_assert(tf_response_requested(&given, &progress).separation < 0);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("program/response_request");
    TCase *options = tcase_create("options");
    tcase_add_test(options, options_are_those_of_the_request);
    tcase_add_test(options, a_separation_of_0_that_was_given_is_none);
    suite_add_tcase(suite, options);
    return suite;
}
