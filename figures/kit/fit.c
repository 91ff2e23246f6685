#include "kit/fit.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/// Spans are scaled alike up to this ratio of longest to shortest, as a power
/// of two.
static const double ratio_most = 4;

/// One axis: coordinates are first scaled by 2^-exponent to at most 1.
typedef struct axis {
    int exponent;
    double middle; ///< of the scaled coordinates
    fig_span span;
} axis;

static fig_span span_of(double length, int exponent)
{
    fig_span span = {.fraction = frexp(length, &span.exponent)};
    span.exponent += exponent;
    return span;
}

static axis measure(int count, tf_vector point[], int k)
{
    double greatest = 0, lo = DBL_MAX, hi = -DBL_MAX;
    for (int i = 0; i < count; i++)
        greatest = fmax(greatest, fabs(point[i].x[k]));
    axis a = {0};
    frexp(greatest, &a.exponent);
    for (int i = 0; i < count; i++) {
        double scaled = ldexp(point[i].x[k], -a.exponent);
        lo = fmin(lo, scaled);
        hi = fmax(hi, scaled);
    }
    a.middle = (lo + hi) / 2;
    a.span = span_of(hi - lo, a.exponent);
    return a;
}

static double logarithm(fig_span span)
{
    return log2(span.fraction) + span.exponent;
}

/// Whether the spans of the axes are near enough; *longest is the longest one.
static bool are_alike(int axes, const axis measured[3], fig_span *longest)
{
    double least = DBL_MAX, most = -DBL_MAX;
    for (int k = 0; k < axes; k++) {
        fig_span span = measured[k].span;
        if (span.fraction == 0)
            continue;
        least = fmin(least, logarithm(span));
        if (logarithm(span) > most) {
            most = logarithm(span);
            *longest = span;
        }
    }
    return most - least <= ratio_most;
}

static double place(const axis *a, fig_span side, double x)
{
    double off = ldexp(x, -a->exponent) - a->middle;
    return ldexp(off / side.fraction, a->exponent - side.exponent);
}

/// Fit points; the axes are scaled alike if `forced` or if they may be.
static fig_fit fit_points(int axes, int count, tf_vector point[], bool forced)
{
    fig_fit fit = {0};
    axis measured[3] = {0};
    for (int k = 0; k < axes; k++)
        measured[k] = measure(count, point, k);
    fig_span longest = {0};
    fit.alike = are_alike(axes, measured, &longest) || forced;
    for (int k = 0; k < 3; k++) {
        fit.span[k] = measured[k].span;
        fig_span side = fit.alike ? longest : fit.span[k];
        for (int i = 0; i < count; i++)
            point[i].x[k] = fit.span[k].fraction > 0
                                ? place(&measured[k], side, point[i].x[k])
                                : 0;
    }
    return fit;
}

fig_fit fig_fit_points(int axes, int count, tf_vector point[])
{
    return fit_points(axes, count, point, false);
}

fig_fit fig_fit_points_alike(int axes, int count, tf_vector point[])
{
    return fit_points(axes, count, point, true);
}

// Text -------------------------------------------------------------------

/// The greatest power of ten, and the least, that is written with zeros.
static const double most_zeros = 4, least_zeros = -3;

bool fig_span_text(fig_span span, char text[FIG_NUMBER_TEXT])
{
    double size = log10(fabs(span.fraction)) + span.exponent * log10(2);
    if (span.fraction == 0 || (size >= least_zeros && size < most_zeros)) {
        double number = ldexp(span.fraction, span.exponent);
        snprintf(text, FIG_NUMBER_TEXT, "%.4g", number);
        return strtod(text, NULL) == number;
    }
    double power = floor(size), digits = pow(10, size - power);
    if (digits >= 9.95) {
        digits = 1;
        power++;
    }
    snprintf(text, FIG_NUMBER_TEXT, "%.1f×10^{%.0f}",
             copysign(digits, span.fraction), power);
    return false;
}

bool fig_number_text(double number, char text[FIG_NUMBER_TEXT])
{
    return fig_span_text(span_of(number, 0), text);
}

void fig_time_text(double t, char text[FIG_TIME_TEXT])
{
    char digits[FIG_NUMBER_TEXT];
    bool whole = fig_number_text(t, digits);
    snprintf(text, FIG_TIME_TEXT, "$t %s %s$", whole ? "=" : "≈", digits);
}
