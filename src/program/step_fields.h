//: Declare what is told of steps
#pragma once

#include "files/record.h"
#include "simulate/simulation.h"

enum {
    TF_TOTALS = 15,
    TF_STEP_WORDS = 100
};

/// The columns of the table of steps, in which a simulation is a record.
const tf_field *tf_step_columns(const tf_simulation_kind *kind);

/// Says in a few words of how many steps the last one is, and what it had.
void tf_step_describe(const tf_simulation *simulation, int steps,
                      char words[TF_STEP_WORDS]);

//: Declare totals of steps
/// What is told of several steps together.
typedef struct tf_step_totals {
    int steps;
    double total[TF_TOTALS]; ///< of a number
} tf_step_totals;

/// Counts the last step of a simulation in.
void tf_step_totals_add(tf_step_totals *sums, const tf_simulation *simulation);

/// Writes the report of all totals.  False, with errno, if a write failed.
bool tf_step_totals_write(FILE *stream, tf_format format,
                          const tf_step_totals *sums,
                          const tf_simulation *simulation);
