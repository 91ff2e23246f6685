// The PolyData of a text, as a reader of VTK's files sees it.
#ifndef SUPPORT_POLYDATA_H
#define SUPPORT_POLYDATA_H

#include <stddef.h>

/// How many there are, of a kind that is an attribute such as NumberOfPolys.
int polydata_count(const char *text, const char *kind);

/// An array in the first element of a kind, such as Polys: a number of it.
/// Fails the test if the array has not that type and so many components and
/// numbers.
double polydata_number(const char *text, size_t size, const char *element,
                       const char *name, const char *type, int components,
                       size_t count, size_t i);

#endif
