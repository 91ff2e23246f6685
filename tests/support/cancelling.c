#include "support/cancelling.h"

#include "support/adaptive_surfaces.h"
#include "support/support.h"

bool tell_cancellation(void *context, const tf_stage *stage)
{
    cancellation *cancelling = context;
    ck_assert_ptr_nonnull(stage->name);
    ck_assert_int_gt(stage->name[0], 0);
    ck_assert(cancelling->last == 0 || cancelling->told < cancelling->last);
    return ++cancelling->told != cancelling->last;
}

/// The hash of a surface after the call; `*told` becomes how often it told.
static uint64_t finish(tf_adaptive_surface *surface, long_call *call,
                       long *told)
{
    cancellation none = {0};
    tf_error error;
    ck_assert_int_eq(call(surface, &none, &error), TF_OK);
    ck_assert_int_eq(error.status, TF_OK);
    *told = none.told;
    return adaptive_hash(surface);
}

static void cancel(tf_adaptive_surface *surface, long_call *call, long last)
{
    cancellation cancelling = {.last = last};
    tf_error error;
    ck_assert_int_eq(call(surface, &cancelling, &error), TF_CANCELLED);
    ck_assert_int_eq(error.status, TF_CANCELLED);
    ck_assert_int_eq(error.subject, TF_NO_SUBJECT);
    ck_assert_int_eq(cancelling.told, last);
}

void expect_cancelling(tf_adaptive_surface *make(void), long_call *call,
                       long times)
{
    generator random = generator_new(77);
    tf_adaptive_surface *surface = make();
    uint64_t before = adaptive_hash(surface);
    long told, again;
    uint64_t after = finish(surface, call, &told);
    ck_assert_int_gt(told, 10);
    tf_adaptive_free(surface);
    for (long i = 0; i < times; i++) {
        surface = make();
        const double *position = tf_adaptive_positions(surface);
        const int *triangle = tf_adaptive_mesh(surface)->triangle;
        cancel(surface, call,
               i < 8
                   ? i + 1
                   : (i < 16 ? told - (i - 8) : 1 + below(&random, (int)told)));
        ck_assert_uint_eq(adaptive_hash(surface), before);
        ck_assert_ptr_eq(tf_adaptive_positions(surface), position);
        ck_assert_ptr_eq(tf_adaptive_mesh(surface)->triangle, triangle);
        ck_assert_uint_eq(finish(surface, call, &again), after);
        ck_assert_int_eq(again, told);
        tf_adaptive_free(surface);
    }
}
