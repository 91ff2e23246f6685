#include "support/six.h"

#include <math.h>
#include <stdio.h>

static double coordinate_of(generator *random, int kind)
{
    static const double largest = 0x1.fffffffffffffp61;
    double small = below(random, 4), any = uniform(random, -1, 1);
    return kind == 0   ? small
           : kind == 1 ? any
           : kind == 2 ? (2 * below(random, 2) - 1) * largest
           : kind == 3 ? ldexp(any, -below(random, 18))
                       : ldexp(any, -below(random, 50));
}

six_events six_any(generator *random)
{
    six_events six = {.start_count = 2 + below(random, 3)};
    for (int k = 0; k < TF_AXES; k++) {
        int kind = below(random, 5), scale = below(random, 600) - 300;
        for (int i = 0; i < TF_SIX; i++)
            six.event[i].x[k] =
                ldexp(coordinate_of(random, kind), kind == 2 ? 0 : scale);
    }
    return six;
}

six_events six_flat(generator *random)
{
    six_events six = {.start_count = 2 + below(random, 3)};
    double a = uniform(random, -2, 2), b = uniform(random, -2, 2);
    int ulps = below(random, 10) == 0 ? 1000 : 2, up = below(random, TF_AXES);
    for (int i = 0; i < TF_SIX; i++) {
        double *x = six.event[i].x;
        double u = uniform(random, -1, 1), v = uniform(random, -1, 1);
        double off = (below(random, 2 * ulps + 1) - ulps) * 0x1p-53;
        x[up] = a * u + b * v + off;
        x[(up + 1) % TF_AXES] = u;
        x[(up + 2) % TF_AXES] = v;
    }
    return six;
}

void six_list(const six_events *six, const tf_event *list[TF_SIX])
{
    for (int i = 0; i < TF_SIX; i++)
        list[i] = &six->event[i];
}

tf_differences six_without(const six_events *six, int i)
{
    tf_differences d = {.axis = {0, 1, 2}};
    for (int t = 0; t < 2; t++) {
        int begin = t == 0 ? 0 : six->start_count;
        int first = begin == i ? begin + 1 : begin;
        for (int j = first + 1; j < (t == 0 ? six->start_count : TF_SIX); j++)
            if (j != i) {
                d.to[d.n] = &six->event[j];
                d.from[d.n++] = &six->event[first];
            }
    }
    return d;
}

const char *six_text(const six_events *six)
{
    static char text[TF_SIX * 100];
    int length = 0;
    for (int i = 0; i < TF_SIX; i++) {
        const double *x = six->event[i].x;
        length += snprintf(text + length, sizeof text - (size_t)length,
                           "t = %d: %a, %a, %a\n", i >= six->start_count, x[0],
                           x[1], x[2]);
    }
    return text;
}
