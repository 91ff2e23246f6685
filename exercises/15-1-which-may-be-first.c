/* Exercise 15.1.  Which contacts may be the first?
 *
 * A row gives the time of a contact as an interval, from toi_lo to toi_hi; the
 * exact time is somewhere in it.  List the places of all rows that may be the
 * first contact of the step, in their order, and return how many there are.
 * If there are no rows, there is no such contact.
 *
 * Section: All, the first, or any.
 *
 * Hint 1: The row with the least toi_lo is always one of them.  But it need not
 *     be the only one, nor need it be the first contact.
 * Hint 2: A row is certainly not the first if some other row is certainly
 *     earlier.  When is it certain that one time is less than another?
 * Hint 3: Find the least toi_hi of all rows.  By then there was a contact.
 */
#include "surface/detect.h"

size_t may_be_first(size_t count, const tf_surface_contact row[],
                    size_t place[])
{
    size_t found = 0;
#if defined TF_SOLUTION
    double latest = 1;
    for (size_t i = 0; i < count; i++)
        if (row[i].contact.toi_hi < latest)
            latest = row[i].contact.toi_hi;
    for (size_t i = 0; i < count; i++)
        if (row[i].contact.toi_lo <= latest)
            place[found++] = i;
#elif defined TF_WRONG_1 // believes in the least lower bound
    double least = 1;
    for (size_t i = 0; i < count; i++)
        if (row[i].contact.toi_lo < least)
            least = row[i].contact.toi_lo;
    for (size_t i = 0; i < count; i++)
        if (row[i].contact.toi_lo == least)
            place[found++] = i;
#elif defined TF_WRONG_2 // compares with one row only
    size_t first = 0;
    for (size_t i = 0; i < count; i++)
        if (row[i].contact.toi_lo < row[first].contact.toi_lo)
            first = i;
    for (size_t i = 0; i < count; i++)
        if (row[i].contact.toi_lo <= row[first].contact.toi_hi)
            place[found++] = i;
#elif defined TF_WRONG_3 // two intervals with a common end are not apart
    double latest = 1;
    for (size_t i = 0; i < count; i++)
        if (row[i].contact.toi_hi < latest)
            latest = row[i].contact.toi_hi;
    for (size_t i = 0; i < count; i++)
        if (row[i].contact.toi_lo < latest)
            place[found++] = i;
#else
    // Your turn: not every row may be the first.
    for (size_t i = 0; i < count; i++)
        if (row[i].contact.toi_lo <= 1)
            place[found++] = i;
#endif
    return found;
}
