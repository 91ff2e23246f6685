#include "arithmetic/accumulated.h"

#include "arithmetic/functions.h"
#include "support/exactness.h"

static const tf_arithmetic accumulated = {.name = "accumulated",
                                          .sign = tf_accumulated_sign,
                                          .value = tf_accumulated_value};

static void use(void)
{
    exactness_use(&accumulated);
}

START_TEST(all_48_products_are_added)
{
    // Every entry has a head and a tail.
    matrix m = matrix_of(3, (double[9]){0});
    for (int i = 0; i < matrix_size(&m); i++)
        *matrix_coordinate(&m, i) = i % 2 == 0 ? 1 + i * i : 0x1.8p-60 * i;
    expect_exact(&accumulated, &m);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("accumulated");
    exactness_add(suite, use);
    TCase *products = tcase_create("products");
    tcase_add_test(products, all_48_products_are_added);
    suite_add_tcase(suite, products);
    return suite;
}
