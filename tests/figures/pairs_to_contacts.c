#include "figures/rows.h"

#include "bench/layers.h"
#include "surface/detect.h"

/// How many pairs of elements share no vertex, counted around each vertex.
static double count_pairs(const tf_mesh *mesh, const tf_surface *surface)
{
    int edges;
    const int *edge = tf_surface_edges(surface, &edges);
    int *degree = calloc((size_t)mesh->vertices, sizeof *degree);
    ck_assert_ptr_nonnull(degree);
    double pairs = (double)mesh->vertices * mesh->triangles -
                   3.0 * mesh->triangles + 0.5 * edges * (edges - 1.0);
    // An edge shares its vertex with the edges there that come before it.
    for (int i = 0; i < 2 * edges; i++)
        pairs -= degree[edge[i]]++;
    free(degree);
    return pairs;
}

START_TEST(crowded_layers_are_detected_again)
{
    char *text = printed(&fig_pairs_to_contacts);
    layers cloth = layers_new(71, 1, 1);
    tf_surface *surface;
    tf_contacts found;
    ck_assert_int_eq(tf_surface_create(&cloth.mesh, &surface, NULL), TF_OK);
    ck_assert_int_eq(
        tf_surface_detect(surface, &cloth.motion, NULL, &found, NULL), TF_OK);
    expect_number(text, "crowded_triangles", cloth.mesh.triangles);
    expect_number(text, "crowded_pairs", count_pairs(&cloth.mesh, surface));
    expect_number(text, "crowded_candidates",
                  (double)found.statistics.candidates);
    expect_number(
        text, "crowded_open",
        (double)(found.statistics.by_filter + found.statistics.by_signs));
    expect_number(text, "crowded_contacts", (double)found.count);
    tf_surface_free(surface);
    layers_free(&cloth);
    free(text);
}
END_TEST

START_TEST(dense_layers_are_those_measured)
{
    char *text = printed(&fig_pairs_to_contacts);
    expect_number(text, "dense_triangles", 994580);
    expect_number(text, "dense_pairs", row_value("dense 994580 pairs"));
    expect_number(text, "dense_contacts", row_value("dense 994580 contacts"));
    // Candidates were measured a triangle, in three decimals.
    ck_assert_double_eq_tol(number_of(text, "dense_candidates") / 994580,
                            row_value("dense 994580 candidates"), 5.1e-4);
    double open = number_of(text, "dense_open");
    ck_assert_double_lt(open, number_of(text, "dense_candidates"));
    ck_assert_double_gt(open, number_of(text, "dense_contacts"));
    free(text);
}
END_TEST

Suite *suite(void)
{
    Suite *s = suite_of("figures/pairs_to_contacts",
                        crowded_layers_are_detected_again);
    TCase *measured = tcase_create("measured");
    tcase_add_test(measured, dense_layers_are_those_measured);
    suite_add_tcase(s, measured);
    return s;
}
