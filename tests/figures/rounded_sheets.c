#include "figures/numbers.h"

#include "support/oracle.h"

enum {
    SIDE = 7,
    VERTICES = SIDE * SIDE
};

/// The rotation that the quaternion 4 - 4 i - 5 j - 10 k makes, times 157.
static const int rotated[3][3] = {
    {-93, 120, 40}, {-40, -75, 132}, {120, 68, 75}};
static const int upright[3][3] = {{157, 0, 0}, {0, 157, 0}, {0, 0, 157}};

/// The quotient by 314 rounded to nearest, halves away from zero, or as it is.
static double quotient(int numerator, bool rounded)
{
    if (!rounded)
        return numerator / 314.0;
    int size = (abs(numerator) + 157) / 314;
    return numerator < 0 ? -size : size;
}

static void make_sheet(int sheet, const int matrix[3][3], bool rounded,
                       tf_event vertex[VERTICES])
{
    for (int i = 0; i < SIDE; i++)
        for (int j = 0; j < SIDE; j++) {
            // Twice the place.
            int place[3] = {8 * i - 24 + 4 * sheet, 8 * j - 24 + 2 * sheet,
                            2 * sheet - 1};
            tf_event *event = &vertex[i * SIDE + j];
            *event = (tf_event){.t = 0};
            for (int k = 0; k < 3; k++)
                event->x[k] =
                    quotient(matrix[k][0] * place[0] + matrix[k][1] * place[1] +
                                 matrix[k][2] * place[2],
                             rounded);
        }
}

/// Whether an axis separates the two.
static bool boxes_apart(const oracle_simplex *s, const oracle_simplex *r)
{
    for (int k = 0; k < 3; k++) {
        double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
        for (int side = 0; side < 2; side++) {
            const oracle_simplex *own = side == 0 ? s : r;
            for (int i = 0; i < own->count; i++) {
                low[side] = fmin(low[side], own->event[i]->x[k]);
                high[side] = fmax(high[side], own->event[i]->x[k]);
            }
        }
        if (high[0] < low[1] || high[1] < low[0])
            return true;
    }
    return false;
}

/// How many triangles of a sheet an edge meets.
static int count_triangles(const oracle_simplex *edge,
                           const tf_event vertex[VERTICES])
{
    int count = 0;
    for (int i = 0; i + 1 < SIDE; i++)
        for (int j = 0; j + 1 < SIDE; j++)
            for (int half = 0; half < 2; half++) {
                const tf_event *a = &vertex[i * SIDE + j];
                oracle_simplex triangle = {
                    3, {a, a + SIDE + 1, half == 0 ? a + 1 : a + SIDE}};
                count += !boxes_apart(edge, &triangle) &&
                         oracle_slices_meet(3, edge, &triangle);
            }
    return count;
}

/// The same for all edges of another sheet.
static int count_edges(const tf_event vertex[VERTICES],
                       const tf_event other[VERTICES])
{
    int count = 0;
    for (int i = 0; i < SIDE; i++)
        for (int j = 0; j < SIDE; j++) {
            const tf_event *a = &vertex[i * SIDE + j];
            bool right = j + 1 < SIDE, up = i + 1 < SIDE;
            if (right)
                count +=
                    count_triangles(&(oracle_simplex){2, {a, a + 1}}, other);
            if (up)
                count +=
                    count_triangles(&(oracle_simplex){2, {a, a + SIDE}}, other);
            if (right && up)
                count += count_triangles(
                    &(oracle_simplex){2, {a, a + SIDE + 1}}, other);
        }
    return count;
}

static int count_crossings(const int matrix[3][3], bool rounded)
{
    tf_event sheet[2][VERTICES];
    for (int i = 0; i < 2; i++)
        make_sheet(i, matrix, rounded, sheet[i]);
    return count_edges(sheet[0], sheet[1]) + count_edges(sheet[1], sheet[0]);
}

START_TEST(only_what_is_rotated_and_rounded_crosses)
{
    char *text = printed(&fig_rounded_sheets);
    expect_number(text, "triangles", 2 * 6 * 6 * 2);
    expect_number(text, "upright_rounded", count_crossings(upright, true));
    expect_number(text, "rotated", count_crossings(rotated, false));
    expect_number(text, "rotated_rounded", count_crossings(rotated, true));
    ck_assert(number_of(text, "upright_rounded") == 0);
    ck_assert(number_of(text, "rotated") == 0);
    ck_assert(number_of(text, "rotated_rounded") > 0);
    free(text);
}
END_TEST

Suite *suite(void)
{
    return suite_of("figures/rounded_sheets",
                    only_what_is_rotated_and_rounded_crosses);
}
