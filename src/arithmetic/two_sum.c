//: Include what two-sum needs
#include "arithmetic/two_sum.h"

//: Add two doubles without losing anything
tf_two tf_two_sum(double a, double b)
{
    double hi = a + b;
    double b_virtual = hi - a;
    double a_virtual = hi - b_virtual;
    return (tf_two){.hi = hi, .lo = (a - a_virtual) + (b - b_virtual)};
}

tf_two tf_two_difference(double a, double b)
{
    return tf_two_sum(a, -b);
}
