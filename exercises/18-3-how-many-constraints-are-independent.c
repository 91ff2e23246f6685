/* Exercise 18.3.  The rank of a zone's matrix: independent constraints.
 *
 * The n x n numbers a[n * i + j] are the matrix of a zone.  It is symmetric and
 * positive semidefinite.  Return its rank: how many of the zone's constraints
 * do not depend on those before them.  Masses may be in any unit, so the matrix
 * may be multiplied by any positive number.  If elimination leaves a pivot that
 * is smaller than the largest entry of the original diagonal by a factor of
 * 10^9 or more, count it as zero.  You may overwrite the matrix.
 *
 * Section: Why it is singular.
 *
 * Hint 1: Choose the largest entry that is left on the diagonal for a pivot,
 *     and eliminate its row from all others that are left.
 * Hint 2: A positive semidefinite matrix whose diagonal is zero has no other
 *     entries than zeros.
 * Hint 3: If row p is the pivot's, a[i][j] becomes
 *     a[i][j] - a[i][p] a[p][j] / a[p][p].
 */
#include <stdbool.h>

enum {
    MOST_ROWS = 64
};

int rank_of(int n, double a[])
{
#if defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_2
    bool used[MOST_ROWS] = {false};
    double largest = 0;
    for (int i = 0; i < n; i++)
        largest = a[n * i + i] > largest ? a[n * i + i] : largest;
#if defined TF_WRONG_1 // has an opinion about the unit of mass
    double enough = 1e-9;
#elif defined TF_WRONG_2 // believes in zeros
    double enough = 0;
#else
    double enough = 1e-9 * largest;
#endif
    for (int rank = 0;; rank++) {
        int p = -1;
        for (int i = 0; i < n; i++)
            if (!used[i] && (p < 0 || a[n * i + i] > a[n * p + p]))
                p = i;
        if (p < 0 || !(a[n * p + p] > enough))
            return rank;
        used[p] = true;
        for (int i = 0; i < n; i++)
            for (int j = 0; j < n && !used[i]; j++)
                if (!used[j])
                    a[n * i + j] -= a[n * i + p] * a[n * p + j] / a[n * p + p];
    }
#elif defined TF_WRONG_3 // takes the rows as they come, and stops at a zero
    double enough = 1e-9 * a[0];
    for (int p = 0; p < n; p++) {
        if (!(a[n * p + p] > enough))
            return p;
        for (int i = p + 1; i < n; i++)
            for (int j = n - 1; j >= p; j--)
                a[n * i + j] -= a[n * i + p] * a[n * p + j] / a[n * p + p];
    }
    return n;
#elif defined TF_WRONG_4 // counts rows that are not zero
    int count = 0;
    for (int i = 0; i < n; i++)
        count += a[n * i + i] > 0;
    return count;
#else
    // Your turn: takes all rows for new.
    return n;
#endif
}
