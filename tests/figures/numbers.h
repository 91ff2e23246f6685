// What tests of the figures' numbers start from: see numbers.c.
#ifndef FIGURES_NUMBERS_H
#define FIGURES_NUMBERS_H

#include "kit/figures.h"
#include "support/oracle.h"
#include "support/support.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PI 3.14159265358979323846

/// What is expected of a figure's numbers beyond the lines of numbers.txt.
typedef struct figure_test {
    const fig_figure *figure;
    void (*expect)(void);
} figure_test;

/// Those of the figures of a part; one without a figure ends them.
extern const figure_test plane_tests[], space_tests[], arithmetic_tests[],
    surfaces_tests[], response_tests[], untangle_tests[], adaptive_tests[];

/// The lines "key value" that the figure under test prints.
extern const char *printed;

// Keys are made as printf does.

/// The number of a key.
double number(const char *key, ...);

/// Whether there is one.
bool has_number(const char *key, ...);

/// Expect a number of a key, up to rounding or up to a tolerance.
void expect(double expected, const char *key, ...);
void expect_within(double tolerance, double expected, const char *key, ...);

/// The value of a row of a file in figures/measured, without ending.
double measured(const char *file, const char *row, ...);

/// Moving vertices by their coordinates, of each first those at t = 0.
void make_vertices(int axes, int count, const double coordinate[],
                   tf_worldline vertex[]);

/// When two moving elements or two simplices first meet, as the oracle has it,
/// rounded; -1 if they do not.
double oracle_time(int axes, int vertices, const tf_worldline first[],
                   int others, const tf_worldline second[]);
double oracle_simplices_time(int axes, const oracle_simplex *s,
                             const oracle_simplex *r);

/// Whether two elements, straight and flat at t = 0 and t = 1, meet then.
bool meet_at(int t, int axes, int vertices, const tf_worldline first[],
             int others, const tf_worldline second[]);

/// Whether there is an axis on which all vertices of one element, at either
/// time, are beyond all of the other.
bool boxes_apart(int axes, int vertices, const tf_worldline first[], int others,
                 const tf_worldline second[]);

#endif
