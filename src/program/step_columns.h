//: Declare what is told of steps
#pragma once

#include "program/summary.h"
#include "simulate/simulation.h"

/// A number of a simulation that is told to the user.
typedef struct tf_step_column {
    const char *name;   ///< in the table of steps; NULL: it is not there
    const char *format; ///< there, of printf for a double
    char type;          ///< 'i', an int; 's', a size_t; or 'd', a double
    size_t offset;      ///< in the simulation
    enum {
        TF_NO_TOTAL,
        TF_LAST,       ///< the number after the last step
        TF_SUM,        ///< over all steps
        TF_STEPS       ///< how many steps have a number above 0
    } how;             ///< it is told of all steps together
    const char *total; ///< by that name
} tf_step_column;

/// The numbers of a kind of simulation, up to one of type 0.
const tf_step_column *tf_step_columns(const tf_simulation_kind *kind);

/// A number as it is after the last step.
double tf_step_number(const tf_step_column *column,
                      const tf_simulation *simulation);

//: Declare totals of steps
enum {
    TF_MOST_COLUMNS = 100,
    TF_STEP_WORDS = 100
};

typedef struct tf_step_totals {
    int steps;
    double number[TF_MOST_COLUMNS]; ///< by column
} tf_step_totals;

/// Counts the last step of a simulation in.
void tf_step_totals_add(tf_step_totals *totals,
                        const tf_simulation *simulation);

/// Writes a line for each total.
void tf_step_totals_write(FILE *stream, const tf_step_totals *totals,
                          const tf_simulation *simulation);

/// Describes the last step in a few words.
void tf_step_describe(const tf_simulation *simulation,
                      char words[TF_STEP_WORDS]);
