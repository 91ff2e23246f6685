#include "support/counting.h"

static const tf_arithmetic *counted_one;
static evaluations so_far;

static tf_sign count_sign(const tf_differences *differences)
{
    so_far.signs++;
    return counted_one->sign(differences);
}

static tf_value count_value(const tf_differences *differences)
{
    so_far.values++;
    return counted_one->value(differences);
}

tf_arithmetic counting(const tf_arithmetic *arithmetic)
{
    counted_one = arithmetic;
    so_far = (evaluations){0, 0};
    tf_arithmetic counts = *arithmetic;
    counts.sign = count_sign;
    counts.value = count_value;
    return counts;
}

evaluations counted(void)
{
    return so_far;
}
