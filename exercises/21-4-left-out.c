/* Exercise 21.4.  Which pairs may be left out?
 *
 * Each triangle of a surface has the number of its zone, from 0, or -1 if it is
 * in none.  An element of the surface is a vertex, an edge or a triangle, given
 * by its one, two or three vertices.  The triangles at a vertex or an edge are
 * all that have it; at a triangle there is only the triangle itself.
 * A step leaves out a pair of elements only if all triangles at both of them are
 * in one zone.  Return whether it does.  At each of the elements is a triangle.
 *
 * Section: Zones.
 *
 * Hint 1: If a pair is left out, any triangle at the one element and any
 *     triangle at the other share a zone.  That is what the promise needs.
 * Hint 2: -1 is not the number of a zone.
 * Hint 3: Two elements may each have triangles of one zone only, and yet these
 *     may be different zones.
 */
#include <stdbool.h>

/// Whether a triangle is at an element of `count` vertices.
static bool is_at(const int triangle[3], int count, const int element[])
{
    for (int i = 0; i < count; i++)
        if (element[i] != triangle[0] && element[i] != triangle[1] &&
            element[i] != triangle[2])
            return false;
    return true;
}

/// The zone that the triangles at an element share; -1: they share none.
static int zone_of(int triangles, const int triangle[][3], const int zone[],
                   int count, const int element[])
{
#if defined TF_SOLUTION || defined TF_WRONG_3 || defined TF_WRONG_4
    int shared = -2;
    for (int t = 0; t < triangles; t++)
        if (is_at(triangle[t], count, element))
            shared = shared == -2 || shared == zone[t] ? zone[t] : -1;
    return shared;
#elif defined TF_WRONG_1 // is content with some triangle in a zone
    int shared = -1;
    for (int t = 0; t < triangles; t++)
        if (is_at(triangle[t], count, element) && zone[t] >= 0)
            shared = zone[t];
    return shared;
#elif defined TF_WRONG_2 // passes over triangles that are in no zone
    int shared = -2;
    for (int t = 0; t < triangles; t++)
        if (is_at(triangle[t], count, element) && zone[t] >= 0)
            shared = shared == -2 || shared == zone[t] ? zone[t] : -1;
    return shared;
#else
    // Your turn, part one: for now the first triangle speaks for all.
    for (int t = 0; t < triangles; t++)
        if (is_at(triangle[t], count, element))
            return zone[t];
    return -1;
#endif
}

bool is_left_out(int triangles, const int triangle[][3], const int zone[],
                 int first, const int a[], int second, const int b[])
{
    int of_a = zone_of(triangles, triangle, zone, first, a);
    int of_b = zone_of(triangles, triangle, zone, second, b);
#if defined TF_WRONG_3 // takes -1 for a zone
    return of_a == of_b;
#elif defined TF_WRONG_4 // does not ask whether it is the same zone
    return of_a >= 0 && of_b >= 0;
#elif defined TF_SOLUTION || defined TF_WRONG_1 || defined TF_WRONG_2
    return of_a >= 0 && of_a == of_b;
#else
    // Your turn, part two.
    return of_a == of_b;
#endif
}
