#include "support/exact_distance.h"

#include <stdbool.h>

enum {
    MOST = 4,        ///< differences of vertices
    ROWS = MOST + 1, ///< of the equations
};

/// Vectors from a vertex of one element to one of the other.
typedef struct differences {
    int count;
    mpq_t x[MOST][3];
} differences;

static void list_differences(tf_kind kind, const double *const x[],
                             differences *list)
{
    int axes = kind == TF_POINT_EDGE ? 2 : 3,
        first = kind == TF_EDGE_EDGE ? 2 : 1;
    mpq_t other;
    mpq_init(other);
    list->count = 0;
    for (int i = 0; i < first; i++)
        for (int j = first; j <= axes; j++, list->count++)
            for (int k = 0; k < 3; k++) {
                mpq_set_d(list->x[list->count][k], k < axes ? x[j][k] : 0);
                mpq_set_d(other, k < axes ? x[i][k] : 0);
                mpq_sub(list->x[list->count][k], list->x[list->count][k],
                        other);
            }
    mpq_clear(other);
}

static void dot(mpq_t a[3], mpq_t b[3], mpq_t sum)
{
    mpq_t product;
    mpq_init(product);
    mpq_set_ui(sum, 0, 1);
    for (int k = 0; k < 3; k++) {
        mpq_mul(product, a[k], b[k]);
        mpq_add(sum, sum, product);
    }
    mpq_clear(product);
}

/// Solves n equations by elimination; the answers are in the last column.  False
/// if they are dependent.
static bool eliminate(int n, mpq_t row[ROWS][ROWS + 1])
{
    mpq_t factor, product;
    bool good = true;
    mpq_inits(factor, product, NULL);
    for (int i = 0; i < n && good; i++) {
        int pivot = i;
        while (pivot < n && mpq_sgn(row[pivot][i]) == 0)
            pivot++;
        good = pivot < n;
        for (int k = 0; k <= n && good; k++)
            mpq_swap(row[i][k], row[pivot][k]);
        for (int j = 0; j < n && good; j++) {
            if (j == i || mpq_sgn(row[j][i]) == 0)
                continue;
            mpq_div(factor, row[j][i], row[i][i]);
            for (int k = i; k <= n; k++) {
                mpq_mul(product, factor, row[i][k]);
                mpq_sub(row[j][k], row[j][k], product);
            }
        }
    }
    for (int i = 0; i < n && good; i++)
        mpq_div(row[i][n], row[i][n], row[i][i]);
    mpq_clears(factor, product, NULL);
    return good;
}

/// Finds the point nearest to the origin in the plane of some vectors: the one
/// whose product with all of them is the same, the square of its length.  False
/// if the vectors are dependent or the point is not between them.
static bool nearest_of(differences *list, unsigned subset,
                       mpq_t row[ROWS][ROWS + 1], mpq_t square)
{
    int member[MOST], n = 0;
    for (int i = 0; i < list->count; i++)
        if (subset >> i & 1)
            member[n++] = i;
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++)
            dot(list->x[member[i]], list->x[member[j]], row[i][j]);
        mpq_set_si(row[i][n], -1, 1);
        mpq_set_ui(row[i][n + 1], 0, 1);
        mpq_set_ui(row[n][i], 1, 1);
    }
    mpq_set_ui(row[n][n], 0, 1);
    mpq_set_ui(row[n][n + 1], 1, 1);
    if (!eliminate(n + 1, row))
        return false;
    for (int i = 0; i < n; i++)
        if (mpq_sgn(row[i][n + 1]) < 0)
            return false;
    mpq_set(square, row[n][n + 1]);
    return true;
}

void exact_distance_square(tf_kind kind, const double *const x[], mpq_t square)
{
    differences list;
    mpq_t row[ROWS][ROWS + 1], own;
    for (int i = 0; i < MOST; i++)
        for (int k = 0; k < 3; k++)
            mpq_init(list.x[i][k]);
    for (int i = 0; i < ROWS; i++)
        for (int k = 0; k <= ROWS; k++)
            mpq_init(row[i][k]);
    mpq_init(own);
    list_differences(kind, x, &list);
    bool any = false;
    for (unsigned subset = 1; subset < 1u << list.count; subset++)
        if (nearest_of(&list, subset, row, own) &&
            (!any || mpq_cmp(own, square) < 0)) {
            mpq_set(square, own);
            any = true;
        }
    mpq_clear(own);
    for (int i = 0; i < ROWS; i++)
        for (int k = 0; k <= ROWS; k++)
            mpq_clear(row[i][k]);
    for (int i = 0; i < MOST; i++)
        for (int k = 0; k < 3; k++)
            mpq_clear(list.x[i][k]);
}

int exact_distance_compare(tf_kind kind, const double *const x[], double length)
{
    mpq_t square, other;
    mpq_inits(square, other, NULL);
    exact_distance_square(kind, x, square);
    mpq_set_d(other, length);
    mpq_mul(other, other, other);
    int sign = mpq_cmp(square, other);
    mpq_clears(square, other, NULL);
    return sign;
}
