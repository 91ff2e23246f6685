//: Declare what is simulated
#pragma once

#include "program/frame_file.h"
#include "program/summary.h"
#include "simulate/simulation.h"

#include <stdbool.h>
#include <stdio.h>

enum {
    TF_SIMULATED_NAME = 100,
    TF_SIMULATED_ENTRIES = 16 ///< the most of a summary
};

typedef struct tf_simulated tf_simulated;

/// What simulations of one kind have in common, cloth or a flow.
typedef struct tf_simulated_kind {
    const char *columns; ///< of the table, behind "step,time,"

    /// Makes a step, and describes it in a few words.
    tf_status (*advance)(tf_simulated *of, const tf_step_way *way,
                         char words[TF_SIMULATED_NAME]);

    /// Writes what the table has of the last step behind its number and time, a
    /// comma first.
    void (*write_line)(FILE *table, const tf_simulated *of);

    /// Writes the state; errors are those of the stream; false without memory.
    bool (*write_frame)(FILE *stream, const tf_simulated *of);

    /// Reads the state, and the step, that the same scene in the same size has
    /// written, bit for bit.  After a fault the simulation is of no use.
    tf_frame_fault (*read_frame)(tf_simulated *of, const char *path);

    /// Sets what is printed in the end; returns how many entries.
    int (*summarize)(const tf_simulated *of,
                     tf_entry entry[TF_SIMULATED_ENTRIES]);

    void (*free)(tf_simulated *of);
} tf_simulated_kind;

//: Declare a scene that is simulated
/// The first member of what a kind has.
struct tf_simulated {
    const tf_simulated_kind *kind;
    char name[TF_SIMULATED_NAME]; ///< the arguments that make it: of the scene
                                  ///< and its size
    double length;                ///< of a step, in seconds
    int step;                     ///< how many were made
};
