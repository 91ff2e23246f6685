//: Include what natural order needs
#include "scenes/natural_order.h"

#include "files/visible.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

//: Compare runs of digits
static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static size_t digits_of(const char *run)
{
    size_t count = 0;
    while (is_digit(run[count]))
        count++;
    return count;
}

/// Steps over the zeros that don't count, and returns how many digits follow.
static size_t significant(const char **run)
{
    while (**run == '0' && is_digit((*run)[1]))
        ++*run;
    return digits_of(*run);
}

/// Compares the numbers at the beginning of two texts, and steps over them.
static int compare_numbers(const char **a, const char **b)
{
    size_t own = significant(a), other = significant(b);
    int order = own != other ? (own < other ? -1 : 1) : memcmp(*a, *b, own);
    *a += own;
    *b += other;
    return order;
}

//: Compare names in natural order
/// Steps over what two names have in common, leading zeros aside, and compares
/// what comes next.
static int compare_common(const char **x, const char **y)
{
    while (**x && **y) {
        if (is_digit(**x) && is_digit(**y)) {
            int order = compare_numbers(x, y);
            if (order != 0)
                return order;
        } else if (*(*x)++ != *(*y)++)
            return (unsigned char)(*x)[-1] < (unsigned char)(*y)[-1] ? -1 : 1;
    }
    return 0;
}

int tf_natural_compare(const char *a, const char *b)
{
    const char *x = a, *y = b;
    int order = compare_common(&x, &y);
    return order != 0 ? order : *x ? 1 : *y ? -1 : strcmp(a, b);
}

bool tf_are_of_one_frame(const char *a, const char *b)
{
    return compare_common(&a, &b) == 0 && (!*a || strcasecmp(a, ".gz") == 0) &&
           (!*b || strcasecmp(b, ".gz") == 0);
}

static int compare_names(const void *a, const void *b)
{
    return tf_natural_compare(*(char *const *)a, *(char *const *)b);
}

void tf_natural_sort(char *name[], int count)
{
    qsort(name, (size_t)count, sizeof *name, compare_names);
}

//: Compare the numbers of two frames
/// The numbers of two names that differ in them alone; false: they differ in
/// more, or in nothing.
static bool numbers_of(const char *a, const char *b, int64_t number[2])
{
    int differences = 0;
    while (*a && *b) {
        char *a_end = (char *)a + 1, *b_end = (char *)b + 1;
        if (is_digit(*a) && is_digit(*b)) {
            int64_t own = strtoll(a, &a_end, 10);
            int64_t other = strtoll(b, &b_end, 10);
            differences += own != other;
            if (own != other)
                number[0] = own, number[1] = other;
        } else if (*a != *b)
            return false;
        a = a_end;
        b = b_end;
    }
    return !*a && !*b && differences == 1;
}

/// How far the numbers of each two neighbors differ.  False: something else
/// does.
static bool find_distances(char *const name[], int count, int64_t distance[])
{
    int64_t number[2] = {0, 0};
    for (int i = 0; i + 1 < count; i++) {
        if (!numbers_of(name[i], name[i + 1], number))
            return false;
        distance[i] = number[1] - number[0];
    }
    return true;
}

bool tf_are_numbered(char *const name[], int count)
{
    int64_t number[2];
    bool numbered = count > 2;
    for (int i = 1; i < count && numbered; i++)
        numbered = numbers_of(name[i - 1], name[i], number);
    return numbered;
}

//: Tell what is strange about the numbers of frames
static void say_next(const char *name, const char *next, const char *what)
{
    fprintf(stderr, "tanglefree: %s follows %s; %s\n",
            tf_make_visible(next).text, tf_make_visible(name).text, what);
}

/// The first step that does not go the way of the first; 0: there is none.
static int find_turn(int steps, const int64_t distance[])
{
    int i = 0;
    while (i < steps && (distance[i] < 0) == (distance[0] < 0))
        i++;
    return i < steps ? i : 0;
}

/// The first step that is longer than another; -1: there is none.
static int find_gap(int steps, const int64_t distance[])
{
    int64_t least = INT64_MAX;
    for (int i = 0; i < steps; i++)
        least = llabs(distance[i]) < least ? llabs(distance[i]) : least;
    int i = 0;
    while (i < steps && llabs(distance[i]) == least)
        i++;
    return i < steps ? i : -1;
}

/// Frames may go backward, but two may have been listed by their bytes.
static void say_strange(char *const name[], int count, const int64_t distance[])
{
    int turn = find_turn(count - 1, distance);
    int gap = find_gap(count - 1, distance);
    if (turn > 0)
        say_next(name[turn], name[turn + 1],
                 "the frames are taken in this order, although their numbers "
                 "are not in order");
    else if (gap >= 0)
        say_next(
            name[gap], name[gap + 1],
            "frames may be missing in between, but this is taken as one step");
    else if (count == 2 && distance[0] < 0 && strcmp(name[0], name[1]) < 0)
        say_next(name[0], name[1],
                 "the step goes from the higher number to the lower one");
}

//: Put frames in order
static bool is_sorted(char *const name[], int count,
                      int compare(const char *a, const char *b))
{
    int i = 1;
    while (i < count && compare(name[i - 1], name[i]) < 0)
        i++;
    return i >= count;
}

/// With two names the order is the user's word: the step goes from the first to
/// the second.
static void restore_order(char *name[], int count)
{
    if (count < 3 || is_sorted(name, count, tf_natural_compare) ||
        !is_sorted(name, count, strcmp))
        return;
    tf_natural_sort(name, count);
    fprintf(stderr,
            "tanglefree: the frames from %s to %s are taken in the order of "
            "their numbers\n",
            tf_make_visible(name[0]).text,
            tf_make_visible(name[count - 1]).text);
}

void tf_order_frames(char *name[], int count)
{
    int64_t *distance = calloc((size_t)count + 1, sizeof *distance);
    if (distance && count > 1 && find_distances(name, count, distance)) {
        restore_order(name, count);
        if (find_distances(name, count, distance))
            say_strange(name, count, distance);
    }
    free(distance);
}
