// The accumulator's words: which of them two determinants use.
#include "kit/figures.h"

#include "arithmetic/superaccumulator.h"
#include "renderer/plot.h"

#include <float.h>
#include <math.h>

enum {
    TERMS = 6,
    WORD_BITS = 64,
    UNIT_EXPONENT = -3222
};

static const double left = 14, width = 356, row = 12;

static const double mixed[TF_AXES][TF_AXES] = {{DBL_MAX, 1, DBL_TRUE_MIN},
                                               {DBL_TRUE_MIN, DBL_MAX, 1},
                                               {1, DBL_TRUE_MIN, DBL_MAX}};
static const double ordinary[TF_AXES][TF_AXES] = {
    {0x1.39adc5cd900e1p-2, -0x1.5fd7e4fab497p-4, -0x1.382988f3c19d2p-2},
    {-0x1.72b9bad814c5fp-2, 0x1.08b61d7e26e86p-4, 0x1.5c960fdb4427ap-2},
    {-0x1.7426e4871b6b3p-2, 0x1.a16e455e5683p-4, 0x1.725a4884d51d7p-2}};

static void accumulate(const double e[TF_AXES][TF_AXES],
                       tf_superaccumulator *sum)
{
    static const int column[TERMS][TF_AXES] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                               {0, 2, 1}, {1, 0, 2}, {2, 1, 0}};
    tf_superaccumulator_clear(sum);
    for (int p = 0; p < TERMS; p++)
        tf_superaccumulator_add(
            sum, p < 3 ? e[0][column[p][0]] : -e[0][column[p][0]],
            e[1][column[p][1]], e[2][column[p][2]]);
}

/// Where a bit of that exponent stands: high ones at the left.
static double place(double exponent)
{
    double bits = TF_SUPERACCUMULATOR_WORDS * WORD_BITS;
    return left + width * (1 - (exponent - UNIT_EXPONENT) / bits);
}

static fig_box word_box(int i, double y)
{
    double from = place(UNIT_EXPONENT + (i + 1) * WORD_BITS);
    return (fig_box){from, y, width / TF_SUPERACCUMULATOR_WORDS - 0.6, row};
}

/// A word that is not zero, one that is, and one that is not even set.
static fig_paint word_paint(const tf_superaccumulator *a, bool positive, int i)
{
    fig_paint paint = {.role =
                           positive ? FIG_ROLE_POSITIVE : FIG_ROLE_NEGATIVE};
    if (i < a->first || i >= a->end)
        return (fig_paint){.role = FIG_ROLE_NEUTRAL, .opacity = 0.18};
    if (a->sum[positive][i] == 0)
        paint.opacity = 0.3;
    return paint;
}

static void draw_sum(fig_page *page, const tf_superaccumulator *a,
                     bool positive, double y)
{
    for (int i = 0; i < TF_SUPERACCUMULATOR_WORDS; i++)
        fig_page_fill_box(page, word_box(i, y), word_paint(a, positive, i));
}

static int full_words(const tf_superaccumulator *a, bool positive)
{
    int count = 0;
    for (int i = a->first; i < a->end; i++)
        count += a->sum[positive][i] != 0;
    return count;
}

static void draw_accumulator(fig_page *page, double y, const char *title,
                             const tf_superaccumulator *a)
{
    fig_page_text(page, left, y, FIG_ALIGN_LEFT, title, FIG_LETTERS_SMALL,
                  FIG_ROLE_INK);
    draw_sum(page, a, true, y + 6);
    draw_sum(page, a, false, y + 6 + row + 2);
}

static void draw_scale(fig_page *page, double y)
{
    static const int at[] = {3072, 2000, 1000, 0, -1000, -2000, -3222};
    for (int i = 0; i < 7; i++) {
        double x = place(at[i]);
        char text[24];
        snprintf(text, sizeof text, "$2^{%d}$", at[i]);
        fig_plot_tick(page, (fig_point){x, y}, text);
    }
}

static void print_sum(FILE *numbers, const char *name,
                      const tf_superaccumulator *a)
{
    char key[32];
    snprintf(key, sizeof key, "%s_used", name);
    fig_number(numbers, key, a->end - a->first);
    snprintf(key, sizeof key, "%s_positive", name);
    fig_number(numbers, key, full_words(a, true));
    snprintf(key, sizeof key, "%s_negative", name);
    fig_number(numbers, key, full_words(a, false));
}

static void draw(fig_page *page, FILE *numbers)
{
    tf_superaccumulator all, few;
    accumulate(mixed, &all);
    accumulate(ordinary, &few);
    draw_accumulator(page, 14,
                     "*from $4.9\u00b710^{-324}$ to "
                     "$1.8\u00b710^{308}$*",
                     &all);
    draw_accumulator(page, 66, "*an ordinary determinant*", &few);
    draw_scale(page, 102);
    print_sum(numbers, "mixed", &all);
    print_sum(numbers, "ordinary", &few);
    fig_number(numbers, "words", TF_SUPERACCUMULATOR_WORDS);
}

const fig_figure fig_accumulator_words = {
    .name = "accumulator-words",
    .title = "The words of the accumulator, and those that are used",
    .width = FIG_PAGE_WIDTH,
    .height = 126,
    .draw = draw,
};
