// Nodes, found by their tags.
#include "formats/msh_nodes.h"

#include "support/support.h"

/// Whether these tags are ordered, and which is there twice.
static bool order(tf_msh_nodes *nodes, int count, const int tag[], int *twice)
{
    *nodes = (tf_msh_nodes){0};
    ck_assert(tf_ints_add(&nodes->tag, (size_t)count, tag));
    return tf_msh_nodes_order(nodes, twice);
}

START_TEST(consecutive_tags_need_no_order)
{
    for (int first = 0; first < 3; first++) {
        tf_msh_nodes nodes;
        int twice;
        ck_assert(
            order(&nodes, 3, (int[]){first, first + 1, first + 2}, &twice));
        ck_assert_ptr_null(nodes.node);
        for (int i = 0; i < 3; i++)
            ck_assert_int_eq(tf_msh_nodes_find(&nodes, first + i), i);
        ck_assert_int_eq(tf_msh_nodes_find(&nodes, first - 1), -1);
        ck_assert_int_eq(tf_msh_nodes_find(&nodes, first + 3), -1);
        ck_assert_int_eq(tf_msh_nodes_find(&nodes, 2147483647), -1);
        tf_msh_nodes_free(&nodes);
    }
}
END_TEST

START_TEST(other_tags_mean_vertices_in_the_order_of_the_file)
{
    static const int tag[] = {70, 5, 2147483647, 0, 6};
    tf_msh_nodes nodes;
    int twice;
    ck_assert(order(&nodes, 5, tag, &twice));
    for (int i = 0; i < 5; i++)
        ck_assert_int_eq(tf_msh_nodes_find(&nodes, tag[i]), i);
    static const int others[] = {1, 4, 7, 69, 71, 2147483646};
    for (int i = 0; i < 6; i++)
        ck_assert_int_eq(tf_msh_nodes_find(&nodes, others[i]), -1);
    tf_msh_nodes_free(&nodes);
}
END_TEST

START_TEST(no_nodes_are_found_among_none)
{
    tf_msh_nodes nodes = {0};
    int twice;
    ck_assert_int_eq(tf_msh_nodes_find(&nodes, 0), -1);
    ck_assert(tf_msh_nodes_order(&nodes, &twice));
    ck_assert_int_eq(tf_msh_nodes_find(&nodes, 0), -1);
    tf_msh_nodes_free(&nodes);
}
END_TEST

START_TEST(tags_that_are_there_twice_are_told)
{
    tf_msh_nodes nodes;
    int twice;
    ck_assert(!order(&nodes, 5, (int[]){3, 9, 1, 9, 4}, &twice));
    ck_assert_int_eq(twice, 9);
    tf_msh_nodes_free(&nodes);
    ck_assert(!order(&nodes, 2, (int[]){0, 0}, &twice));
    tf_msh_nodes_free(&nodes);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("formats/msh_nodes");
    TCase *nodes = tcase_create("nodes");
    tcase_add_test(nodes, consecutive_tags_need_no_order);
    tcase_add_test(nodes, other_tags_mean_vertices_in_the_order_of_the_file);
    tcase_add_test(nodes, no_nodes_are_found_among_none);
    tcase_add_test(nodes, tags_that_are_there_twice_are_told);
    suite_add_tcase(suite, nodes);
    return suite;
}
