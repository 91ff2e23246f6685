// Coordinates of a column on one grid, bit by bit, and one that is not on it.
#include "kit/figures.h"

#include "arithmetic/fixed.h"
#include "kit/bit_rows.h"

#include <math.h>

enum {
    COORDINATES = 5
};

static const fig_bit_rows rows = {
    .left = 52, .cell = 4.8, .height = 9, .highest = 0, .lowest = -65};

/// The square roots of 3/8, 1/200, 1/5000, 2^-17 and 1/8000000.
static const double coordinate[COORDINATES] = {
    0x1.3988e1409212ep-1, 0x1.21a1851ff630ap-4, 0x1.cf68d4fff04ddp-7,
    0x1.6a09e667f3bcdp-9, 0x1.72ba43fff3717p-12};

/// The exponent of the last one bit.
static int last_place(double x)
{
    int last = ilogb(x) - 52;
    while (fmod(ldexp(x, -last), 2) == 0)
        last++;
    return last;
}

/// Whether the library evaluates a determinant of the largest and this one.
static bool is_on_grid(double x)
{
    tf_event largest = {.x = {coordinate[0]}}, other = {.x = {x}};
    tf_differences d = {
        .n = 1, .to = {&largest}, .from = {&other}, .axis = {0}};
    tf_sign sign;
    return tf_fixed_sign(&d, &sign);
}

static void draw(fig_page *page, FILE *numbers)
{
    static const char *const names[COORDINATES] = {"$a$", "$b$", "$c$", "$d$",
                                                   "$e$"};
    const double top = 10, step = 15;
    double end = top + COORDINATES * step;
    int on_grid = 0, unit = ilogb(coordinate[0]) + 1 - TF_GRID_BITS;
    for (int i = 0; i < COORDINATES; i++) {
        bool good = is_on_grid(coordinate[i]);
        fig_role role = good ? FIG_ROLE_TRIANGLE : FIG_ROLE_CONTACT;
        double y = top + i * step;
        fig_bits_name(page, &rows, y, names[i], FIG_ROLE_INK);
        fig_bits(page, &rows, y, coordinate[i], role);
        on_grid += good;
    }
    fig_bits_cut(page, &rows, unit, top - 5, end);
    fig_bits_scale(page, &rows, end + 3);
    fig_number(numbers, "unit", unit);
    fig_number(numbers, "on_grid", on_grid);
    fig_number(numbers, "last_of_d", last_place(coordinate[3]));
    fig_number(numbers, "last_of_e", last_place(coordinate[4]));
}

const fig_figure fig_coordinates_on_grid = {
    .name = "coordinates-on-grid",
    .title = "Coordinates on one grid, bit by bit, and one beside it",
    .width = FIG_PAGE_WIDTH,
    .height = 112,
    .draw = draw,
};
