#include "support/matrices.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/// The matrix with the given order of axes: axis[j] = first + j * step, mod 3.
static matrix with_axes(int n, int first, int step)
{
    matrix m = {.n = n};
    for (int i = 0; i < TF_AXES; i++) {
        m.axis[i] = (first + i * step) % TF_AXES;
        for (int k = 0; k < TF_AXES; k++)
            m.to[i].x[k] = m.from[i].x[k] = NAN;
    }
    for (int i = 0; i < matrix_size(&m); i++)
        *matrix_coordinate(&m, i) = 0;
    return m;
}

matrix matrix_new(generator *random, int n)
{
    return with_axes(n, below(random, TF_AXES), 1 + below(random, 2));
}

matrix matrix_of(int n, const double entry[])
{
    matrix m = with_axes(n, 0, 1);
    for (int k = 0; k < n * n; k++)
        *matrix_coordinate(&m, 2 * k) = entry[k];
    return m;
}

tf_differences matrix_differences(const matrix *m)
{
    tf_differences differences = {.n = m->n};
    for (int i = 0; i < m->n; i++) {
        differences.to[i] = &m->to[i];
        differences.from[i] = &m->from[i];
        differences.axis[i] = m->axis[i];
    }
    return differences;
}

int matrix_size(const matrix *m)
{
    return 2 * m->n * m->n;
}

double *matrix_coordinate(matrix *m, int i)
{
    tf_event *event = i % 2 == 0 ? m->to : m->from;
    int row = i / 2 / m->n, column = i / 2 % m->n;
    return &event[row].x[m->axis[column]];
}

void expect_of_matrix(bool good, const char *what, const matrix *m)
{
    if (good)
        return;
    char text[1024];
    matrix copy = *m;
    int length = 0;
    for (int i = 0; i < matrix_size(m); i++)
        length += snprintf(text + length, sizeof text - (size_t)length, "%a%s",
                           *matrix_coordinate(&copy, i),
                           i % 2 == 0                       ? " - "
                           : i % (2 * m->n) == 2 * m->n - 1 ? "\n"
                                                            : ", ");
    ck_abort_msg("%s\nseed %llu\n%s", what, (unsigned long long)seed(), text);
}

// Kinds -----------------------------------------------------------------------

matrix matrix_lattice(generator *random, int n, int values)
{
    matrix m = matrix_new(random, n);
    for (int i = 0; i < matrix_size(&m); i++)
        *matrix_coordinate(&m, i) = below(random, values);
    return m;
}

matrix matrix_flat(generator *random, int n)
{
    matrix m = matrix_new(random, n);
    for (int i = 0; i < matrix_size(&m); i++)
        *matrix_coordinate(&m, i) = uniform(random, -1, 1);
    tf_event *last = &m.to[n - 1];
    *last = m.from[n - 1];
    for (int i = 0; i < n - 1; i++) {
        double weight = uniform(random, -1, 1);
        for (int k = 0; k < TF_AXES; k++)
            last->x[k] += weight * (m.to[i].x[k] - m.from[i].x[k]);
    }
    return m;
}

/// Make the last row a sum of small multiples of the others.
static void make_dependent(generator *random, matrix *m)
{
    int last = 2 * m->n * (m->n - 1);
    for (int row = 0; row < last; row += 2 * m->n) {
        int weight = below(random, 17) - 8;
        for (int i = 0; i < 2 * m->n; i++)
            *matrix_coordinate(m, last + i) +=
                weight * *matrix_coordinate(m, row + i);
    }
}

matrix matrix_singular(generator *random, int n)
{
    matrix m = matrix_new(random, n);
    for (int i = 0; i < matrix_size(&m) - 2 * n; i++)
        *matrix_coordinate(&m, i) = trunc(uniform(random, -0x1p47, 0x1p47));
    make_dependent(random, &m);

    // The subtrahends in another unit need more places than a double has.
    int exponent = below(random, 2) ? below(random, 100) - 50 : 0;
    for (int i = 1; i < matrix_size(&m); i += 2)
        *matrix_coordinate(&m, i) = ldexp(*matrix_coordinate(&m, i), exponent);
    return m;
}

double any_double(generator *random)
{
    double x;
    do {
        uint64_t bits = next_bits(random);
        memcpy(&x, &bits, sizeof x);
    } while (!isfinite(x));
    return x;
}

matrix matrix_extreme(generator *random, int n)
{
    double pool[6] = {0, DBL_TRUE_MIN, DBL_MIN, 1};
    pool[4] = any_double(random);
    pool[5] = below(random, 2) ? DBL_MAX : any_double(random);
    matrix m = matrix_new(random, n);
    for (int i = 0; i < matrix_size(&m); i++) {
        double x = pool[below(random, 6)];
        *matrix_coordinate(&m, i) = below(random, 2) ? -x : x;
    }
    return m;
}

matrix matrix_bits(generator *random, int n)
{
    matrix m = matrix_new(random, n);
    for (int i = 0; i < matrix_size(&m); i++)
        *matrix_coordinate(&m, i) = any_double(random);
    return m;
}

matrix matrix_any(generator *random, int n)
{
    switch (below(random, 5)) {
    case 0:
        return matrix_lattice(random, n, 3);
    case 1:
        return matrix_flat(random, n);
    case 2:
        return matrix_singular(random, n);
    case 3:
        return matrix_extreme(random, n);
    default:
        return matrix_bits(random, n);
    }
}

// Changes ---------------------------------------------------------------------

void matrix_nudge(generator *random, matrix *m, int ulps)
{
    for (int i = 0; i < matrix_size(m); i++) {
        int steps = below(random, 2 * ulps + 1) - ulps;
        double *x = matrix_coordinate(m, i);
        for (; steps > 0; steps--)
            *x = nextafter(*x, DBL_MAX);
        for (; steps < 0; steps++)
            *x = nextafter(*x, -DBL_MAX);
    }
}

void matrix_scale(matrix *m, int j, int exponent)
{
    for (int i = 0; i < m->n; i++) {
        double *to = &m->to[i].x[m->axis[j]];
        double *from = &m->from[i].x[m->axis[j]];
        *to = ldexp(*to, exponent);
        *from = ldexp(*from, exponent);
    }
}

bool next_signs(int count, double sign[])
{
    for (int i = 0; i < count; i++) {
        if (++sign[i] <= 1)
            return true;
        sign[i] = -1;
    }
    return false;
}
