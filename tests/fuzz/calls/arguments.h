// Arguments of calls: good ones, slightly wrong ones, and absurd ones.
#ifndef FUZZ_CALLS_ARGUMENTS_H
#define FUZZ_CALLS_ARGUMENTS_H

#include "judge.h"

/// Whether the one case of n is drawn.
bool one_in(generator *random, int n);

/// Any int but the right one: next to it, negative, or as large as possible.
int wrong_number(generator *random, int right);

/// A finite double of any size, or NaN or an infinity.
double any_double(generator *random);

/// A number from a few that are good, 0 among them; or, one time of eight, any.
double any_option(generator *random, double most);

// Coordinates -----------------------------------------------------------------

/// Draws coordinates, all on a lattice, near one, or anywhere, of one size; a
/// few times one of them is any double.
void draw_coordinates(generator *random, int count, double x[]);
bool all_finite(int count, const double x[]);

/// One of the library's arithmetics, tf_exact most of the time.
const tf_arithmetic *any_arithmetic(generator *random);

/// Whether it holds all coordinates, as far as they are finite.
bool all_held(const tf_arithmetic *arithmetic, int axes, int count,
              const double x[]);

// Options ---------------------------------------------------------------------

enum {
    LATER = 64 ///< bytes of the members of a later version
};

/// Draws the size of options of `known` bytes that are followed by LATER bytes,
/// which it sets.  Notes TF_BAD_OPTION where the library must refuse it.
size_t any_size(generator *random, call *made, size_t known, void *later);

/// How to run tasks, in some order by some workers, or NULL.  Notes
/// TF_BAD_OPTION for a number of workers that is out of range.
typedef struct crew {
    tf_parallel parallel;
    generator random;
} crew;
const tf_parallel *any_parallel(generator *random, call *made, crew *workers);

/// A callback of progress that may cancel.
typedef struct listener {
    const call *made;
    int left; ///< how often it goes on
    bool cancelled;
} listener;

/// NULL, or a callback whose context must be the listener; notes TF_CANCELLED.
tf_progress *any_progress(generator *random, call *made, listener *hearing);

// Trouble ---------------------------------------------------------------------

/// Lets rounding go upward, one time of 64, and notes TF_BAD_ENVIRONMENT.
void break_environment(generator *random, call *made);

/// Restores it after the call, and lets no allocation fail any more; notes
/// TF_OUT_OF_MEMORY if one has failed.
void end_trouble(call *made);

// Results ---------------------------------------------------------------------

/// What a call sets: a result, and an error.
typedef struct results {
    void *result;
    size_t size;
    tf_error error;
} results;

/// Marks the results before a call, and lets allocations fail, one time of 16.
void results_begin(generator *random, results *of, void *result, size_t size);

/// Ends all trouble after it, and judges its status and the error.  Requires
/// that a call that was cancelled has not succeeded, and the result of one that
/// failed is not set.  Returns whether it has succeeded.
/// @param hearing what may have cancelled; NULL: nothing
bool results_judge(generator *random, call *made, const results *of,
                   const listener *hearing, tf_status status);

#endif
