//: Declare natural order
#pragma once

#include <stdbool.h>

/// Compares two names as people order them: a run of digits by the number that
/// it is, however long, and all else byte by byte.  Names that differ only in
/// leading zeros are in the order of their bytes.  Less than, equal to or greater
/// than 0, as strcmp.
int tf_natural_compare(const char *a, const char *b);

/// Sorts names in natural order.
void tf_natural_sort(char *name[], int count);

/// Whether two names are those of one frame: they differ only in leading zeros,
/// or in .gz at the end of one.
bool tf_are_of_one_frame(const char *a, const char *b);

//: Declare the order of frames
/// Whether names may be those of a sequence: three or more, each of which differs
/// from the one before in one number alone.
bool tf_are_numbered(char *const name[], int count);

/// Says on standard error what is strange about the order of the frames of a
/// sequence, if their names differ in numbers only: one number follows another
/// that is not lower, or some are missing.  Three names or more in the order of
/// bytes, as a shell lists files, are put in natural order first, which is said,
/// too.
void tf_order_frames(char *name[], int count);
