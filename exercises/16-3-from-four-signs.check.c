#include "check.h"

#include "intersect/verdict.h"
#include "support/support.h"

#include <math.h>

tf_verdict pair_verdict(const double number[4], double bound);

static const char *word(tf_verdict verdict)
{
    return verdict == TF_HIT         ? "hit"
           : verdict == TF_APART     ? "apart"
           : verdict == TF_UNDECIDED ? "undecided"
                                     : "no verdict";
}

/// The verdict that six true signs have: they leave it open if all are zero.
static tf_verdict verdict_of(const int sign[6])
{
    bool positive = false, negative = false;
    for (int i = 0; i < 6; i++) {
        positive |= sign[i] > 0;
        negative |= sign[i] < 0;
    }
    return positive && negative   ? TF_APART
           : positive || negative ? TF_HIT
                                  : TF_UNDECIDED;
}

/// By all signs that the four may have: -1, 0 or 1 where that is open.  Those
/// of the sums follow unless the terms are of opposite signs, which decides.
static tf_verdict expected(const double number[4], double bound)
{
    bool may[4] = {false};
    for (int code = 0; code < 81; code++) {
        int sign[6] = {code % 3 - 1, code / 3 % 3 - 1, code / 9 % 3 - 1,
                       code / 27 - 1};
        bool possible = true;
        for (int i = 0; i < 4; i++)
            possible &=
                fabs(number[i]) <= bound || sign[i] == (number[i] > 0 ? 1 : -1);
        sign[4] = sign[0] != 0 ? sign[0] : sign[1];
        sign[5] = sign[2] != 0 ? sign[2] : sign[3];
        if (!possible)
            continue;
        bool zero = false;
        for (int i = 0; i < 4; i++)
            zero |= sign[i] == 0;
        tf_verdict verdict = verdict_of(sign);
        may[verdict == TF_HIT && zero ? TF_UNDECIDED : verdict] = true;
    }
    return may[TF_UNDECIDED] || (may[TF_HIT] && may[TF_APART]) ? TF_UNDECIDED
           : may[TF_HIT]                                       ? TF_HIT
                                                               : TF_APART;
}

static void expect(const double number[4], double bound)
{
    tf_verdict right = expected(number, bound);
    check_input("numbers %s, %s, %s, %s, bound %s", text_real(number[0]),
                text_real(number[1]), text_real(number[2]),
                text_real(number[3]), text_real(bound));
    tf_verdict got;
    check_value(got, pair_verdict(number, bound));
    check_that(got == right, word(right), "%s", word(got));
}

TEST(certain_ones)
{
    expect((double[]){1, 2, 3, 4}, 0.5);
    expect((double[]){-1, -2, -3, -4}, 0.5);
    expect((double[]){1, 2, -3, 4}, 0.5);
    expect((double[]){1, -2, 3, 4}, 0.5);
}

TEST(all_combinations)
{
    static const double some[] = {-2, -1, -0.0, 0.5, 1, 3};
    enum {
        SOME = sizeof some / sizeof *some
    };
    for (int code = 0; code < SOME * SOME * SOME * SOME; code++) {
        double number[4] = {some[code % SOME], some[code / SOME % SOME],
                            some[code / SOME / SOME % SOME],
                            some[code / SOME / SOME / SOME]};
        expect(number, 0.25);
        expect(number, 1);
    }
}

void run_tests(void)
{
    check_run(1, certain_ones);
    check_run(1, all_combinations);
}
