#include "check.h"

#include "intersect/complementary.h"

#include <stdio.h>
#include <string.h>

tf_verdict read_signs(int count, const tf_sign sign[]);

enum {
    SIGNS = 5
};

/// The verdict of signs that are all known.
static tf_verdict read_known(const tf_sign sign[SIGNS])
{
    int least = 1, most = -1;
    for (int i = 0; i < SIGNS; i++) {
        least = (int)sign[i] < least ? (int)sign[i] : least;
        most = (int)sign[i] > most ? (int)sign[i] : most;
    }
    if (least == 0 && most == 0)
        return TF_UNDECIDED;
    return least * most < 0 ? TF_APART : TF_HIT;
}

/// The verdict for all signs that the unknown ones may be, taken together.
static tf_verdict read_all(tf_sign sign[SIGNS])
{
    int i = 0;
    while (i < SIGNS && sign[i] != TF_UNKNOWN)
        i++;
    if (i == SIGNS)
        return read_known(sign);
    tf_verdict all = TF_UNDECIDED;
    for (int s = -1; s <= 1; s++) {
        sign[i] = (tf_sign)s;
        tf_verdict one = read_all(sign);
        all = s == -1 || one == all ? one : TF_UNDECIDED;
    }
    sign[i] = TF_UNKNOWN;
    return all;
}

static const char *const verdicts[] = {[TF_UNDECIDED] = "TF_UNDECIDED",
                                       [TF_APART] = "TF_APART",
                                       [TF_HIT] = "TF_HIT"};

TEST(all_patterns)
{
    for (int pattern = 0; pattern < 1 << (2 * SIGNS); pattern++) {
        tf_sign sign[SIGNS];
        char text[100] = "";
        for (int i = 0; i < SIGNS; i++) {
            sign[i] = (tf_sign)((pattern >> (2 * i)) % 4 - 1);
            snprintf(text + strlen(text), sizeof text - strlen(text), " %s",
                     text_sign(sign[i]));
        }
        tf_verdict expected = read_all(sign);
        check_input("the signs%s", text);
        tf_verdict got;
        check_value(got, read_signs(SIGNS, sign));
        check_that(got == expected, verdicts[expected], "%s",
                   (unsigned)got <= TF_HIT ? verdicts[got] : "no verdict");
    }
}

void run_tests(void)
{
    check_run(1, all_patterns);
}
