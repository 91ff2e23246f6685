#include "figures/numbers.h"

#include "kit/meshes.h"
#include "program/threads.h"
#include "surface/detect.h"

START_TEST(all_workers_together_find_the_contacts)
{
    char *text = printed(&fig_contact_order);
    ck_assert_double_eq(number_of(text, "same"), 1);
    double contacts = number_of(text, "contacts");
    double sum = number_of(text, "worker_0") + number_of(text, "worker_1");
    ck_assert_double_eq(sum, contacts);
    ck_assert_double_gt(number_of(text, "worker_0"), 0);
    ck_assert_double_gt(number_of(text, "worker_1"), 0);

    fig_some_mesh at[2] = {fig_folded_sheet(60, 120, 150),
                           fig_folded_sheet(60, 120, 183.35)};
    const tf_mesh mesh = fig_mesh_in_space(&at[0]);
    const tf_motion motion = {at[0].vertices, at[0].x, at[1].x};
    int threads = 3;
    tf_parallel parallel = tf_threads(&threads);
    tf_detect_options detection = {.parallel = &parallel};
    tf_surface *surface;
    tf_contacts found;
    ck_assert_int_eq(tf_surface_create(&mesh, &surface, NULL), TF_OK);
    ck_assert_int_eq(
        tf_surface_detect(surface, &motion, &detection, &found, NULL), TF_OK);
    ck_assert_double_eq(contacts, (double)found.count);
    int points = 0;
    for (size_t i = 0; i < found.count; i++)
        points += found.contact[i].kind == TF_POINT_TRIANGLE;
    ck_assert_double_eq(number_of(text, "point_triangle"), points);
    tf_surface_free(surface);
    for (int t = 0; t < 2; t++)
        fig_some_mesh_free(&at[t]);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/contact_order",
                    all_workers_together_find_the_contacts);
}
