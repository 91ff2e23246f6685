#include "kit/expansion.h"

#include <math.h>

/// Split 53 bits into 26, and 26 and a sign.
static tf_two split(double a)
{
    double c = (0x1p27 + 1) * a;
    double hi = c - (c - a);
    return (tf_two){.hi = hi, .lo = a - hi};
}

tf_two two_product(double a, double b)
{
    tf_two x = split(a), y = split(b);
    double hi = a * b;
    double rest = ((x.hi * y.hi - hi) + x.hi * y.lo) + x.lo * y.hi;
    return (tf_two){.hi = hi, .lo = rest + x.lo * y.lo};
}

static void append(expansion *e, double term)
{
    if (term != 0)
        e->term[e->count++] = term;
}

/// Shewchuk's linear expansion sum: merge the terms by size, smallest first, and
/// carry the sum of those so far as two doubles, keeping what falls off.
void expansion_add(const expansion *a, const expansion *b, expansion *sum)
{
    tf_two carry = {0, 0};
    sum->count = 0;
    for (int i = 0, j = 0; i < a->count || j < b->count;) {
        bool from_a = j == b->count ||
                      (i < a->count && fabs(a->term[i]) < fabs(b->term[j]));
        double term = from_a ? a->term[i++] : b->term[j++];
        tf_two low = tf_two_sum(term, carry.lo);
        append(sum, low.lo);
        carry = tf_two_sum(carry.hi, low.hi);
    }
    append(sum, carry.lo);
    append(sum, carry.hi);
}

/// Shewchuk's scaled expansion: each product adds its low half, then its high
/// half, to what is carried.
void expansion_scale(const expansion *a, double b, expansion *product)
{
    double carry = 0;
    product->count = 0;
    for (int i = 0; i < a->count; i++) {
        tf_two term = two_product(a->term[i], b);
        tf_two low = tf_two_sum(carry, term.lo);
        tf_two high = tf_two_sum(term.hi, low.hi);
        append(product, low.lo);
        append(product, high.lo);
        carry = high.hi;
    }
    append(product, carry);
}

/// The determinant of (a b; c d).
static void determinant_2x2(double a, double b, double c, double d,
                            expansion *determinant)
{
    expansion down = {.count = 1, .term = {a}}, down_product;
    expansion up = {.count = 1, .term = {-b}}, up_product;
    expansion_scale(&down, d, &down_product);
    expansion_scale(&up, c, &up_product);
    expansion_add(&down_product, &up_product, determinant);
}

static void determinant_3x3(double e[TF_AXES][TF_AXES], expansion *determinant)
{
    expansion part[TF_AXES], two_parts;
    for (int j = 0; j < 3; j++) {
        int k = (j + 1) % 3, l = (j + 2) % 3;
        expansion minor;
        determinant_2x2(e[1][k], e[1][l], e[2][k], e[2][l], &minor);
        expansion_scale(&minor, e[0][j], &part[j]);
    }
    expansion_add(&part[0], &part[1], &two_parts);
    expansion_add(&two_parts, &part[2], determinant);
}

void expansion_determinant(int n, double entry[TF_AXES][TF_AXES],
                           expansion *determinant)
{
    determinant->count = 0;
    if (n == 1)
        append(determinant, entry[0][0]);
    else if (n == 2)
        determinant_2x2(entry[0][0], entry[0][1], entry[1][0], entry[1][1],
                        determinant);
    else
        determinant_3x3(entry, determinant);
}

tf_sign expansion_sign(const expansion *e)
{
    double last = e->count > 0 ? e->term[e->count - 1] : 0;
    return (tf_sign)((last > 0) - (last < 0));
}
