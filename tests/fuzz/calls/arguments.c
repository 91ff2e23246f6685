#include "arguments.h"

#include "allocator.h"

#include <fenv.h>
#include <float.h>
#include <limits.h>
#include <math.h>
#include <string.h>

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))

bool one_in(generator *random, int n)
{
    return below(random, n) == 0;
}

int wrong_number(generator *random, int right)
{
    const int wrong[] = {right - 1, right + 1, -1,      0,       1,
                         2,         3,         INT_MAX, INT_MIN, 4};
    int number = wrong[below(random, COUNT(wrong))];
    return number == right ? -1 : number;
}

double any_double(generator *random)
{
    static const double special[] = {NAN,      INFINITY,  -INFINITY, DBL_MAX,
                                     -DBL_MAX, 0x1p-1074, DBL_MIN,   -0.0,
                                     1e300,    0x1p53,    0x1p19,    0.1};
    if (one_in(random, 2))
        return special[below(random, COUNT(special))];
    return ldexp(uniform(random, -1, 1), below(random, 2100) - 1075);
}

double any_option(generator *random, double most)
{
    if (one_in(random, 8))
        return any_double(random);
    return one_in(random, 2) ? 0 : uniform(random, 0, most);
}

// Coordinates -----------------------------------------------------------------

/// From -3 to 3, most of the time an integer, or a few units in the last place
/// off.
static double near_lattice(generator *random, int flavor)
{
    double x = below(random, 7) - 3;
    if (flavor == 2)
        return uniform(random, -3, 3);
    for (int i = flavor == 1 ? below(random, 3) : 0; i > 0; i--)
        x = nextafter(x, one_in(random, 2) ? INFINITY : -INFINITY);
    return x;
}

void draw_coordinates(generator *random, int count, double x[])
{
    int flavor = below(random, 3);
    int scale = one_in(random, 4) ? below(random, 2090) - 1073 : 0;
    for (int i = 0; i < count; i++)
        x[i] = ldexp(near_lattice(random, flavor), scale);
    if (count > 0 && one_in(random, 8))
        x[below(random, count)] = any_double(random);
}

bool all_finite(int count, const double x[])
{
    for (int i = 0; i < count; i++)
        if (!isfinite(x[i]))
            return false;
    return true;
}

const tf_arithmetic *any_arithmetic(generator *random)
{
    const tf_arithmetic *const all[] = {&tf_clamped, &tf_published,
                                        &tf_perturbed, &tf_integer64,
                                        &tf_integer128};
    return one_in(random, 2) ? &tf_exact : all[below(random, COUNT(all))];
}

bool all_held(const tf_arithmetic *arithmetic, int axes, int count,
              const double x[])
{
    int bits = tf_arithmetic_bits(arithmetic, axes);
    for (int i = 0; i < count && bits > 0; i++)
        if (isfinite(x[i]) &&
            (fabs(x[i]) >= ldexp(1, bits) || trunc(x[i]) != x[i]))
            return false;
    return true;
}

// Options ---------------------------------------------------------------------

size_t any_size(generator *random, call *made, size_t known, void *later)
{
    memset(later, 0, LATER);
    if (!one_in(random, 8))
        return one_in(random, 2) ? 0 : known;
    size_t more = 1 + (size_t)below(random, LATER);
    if (one_in(random, 2)) {
        expect_fault(made, true, TF_BAD_OPTION);
        // No version has less than half of all members,
        size_t least = more < known / 2 ? more : 1;
        return one_in(random, 2) ? least : SIZE_MAX / least; // or so many
    }
    bool set = one_in(random, 2);
    ((unsigned char *)later)[more - 1] = set;
    expect_fault(made, set, TF_BAD_OPTION);
    return known + more;
}

/// All tasks, from the first, from the last, or in any rotation, each by any
/// worker.
static void run_tasks(void *context, int count, tf_task *run, void *argument)
{
    crew *workers = context;
    int order = below(&workers->random, 3), first = 0;
    if (order == 2 && count > 0)
        first = below(&workers->random, count);
    for (int i = 0; i < count; i++) {
        int task = order == 1 ? count - 1 - i : (first + i) % count;
        run(argument, task, below(&workers->random, workers->parallel.workers));
    }
}

const tf_parallel *any_parallel(generator *random, call *made, crew *workers)
{
    static const int good[] = {1, 2, 3, 4, 7, 16},
                     bad[] = {0, -1, INT_MIN, 4097, INT_MAX};
    if (one_in(random, 2))
        return NULL;
    bool wrong = one_in(random, 8);
    workers->random = (generator){next_bits(random)};
    workers->parallel = (tf_parallel){wrong ? bad[below(random, COUNT(bad))]
                                            : good[below(random, COUNT(good))],
                                      run_tasks, workers};
    if (one_in(random, 64))
        workers->parallel.for_each = NULL;
    expect_fault(made, wrong || !workers->parallel.for_each, TF_BAD_OPTION);
    return &workers->parallel;
}

static bool hear(void *context, const tf_stage *stage)
{
    listener *hearing = context;
    require(hearing->made, stage->name && stage->name[0],
            "a stage has no name");
    require(hearing->made, stage->total == 0 || stage->done <= stage->total,
            "more of a stage is done than there is");
    require(hearing->made, !hearing->cancelled, "it goes on after cancelling");
    hearing->cancelled = hearing->left-- == 0;
    return !hearing->cancelled;
}

tf_progress *any_progress(generator *random, call *made, listener *hearing)
{
    *hearing = (listener){made, -1, false};
    if (one_in(random, 2))
        return NULL;
    if (one_in(random, 2))
        hearing->left = below(random, one_in(random, 2) ? 3 : 40);
    excuse(made, TF_CANCELLED);
    return hear;
}

// Trouble ---------------------------------------------------------------------

void break_environment(generator *random, call *made)
{
    if (!one_in(random, 64))
        return;
    fesetround(FE_UPWARD);
    expect_fault(made, true, TF_BAD_ENVIRONMENT);
}

void end_trouble(call *made)
{
    fesetround(FE_TONEAREST);
    if (allocator_succeed())
        excuse(made, TF_OUT_OF_MEMORY);
}

// Results ---------------------------------------------------------------------

void results_begin(generator *random, results *of, void *result, size_t size)
{
    of->result = result;
    of->size = size;
    mark(result, size);
    mark(&of->error, sizeof of->error);
    allocator_fail(random);
}

bool results_judge(generator *random, call *made, const results *of,
                   const listener *hearing, tf_status status)
{
    bool cancelled = hearing && hearing->cancelled;
    end_trouble(made);
    judge_error(made, status, &of->error, random);
    require(made, cancelled || status != TF_CANCELLED, "nobody has cancelled");
    require(made, !cancelled || status != TF_OK,
            "it succeeded although it was cancelled");
    if (judge_status(made, status))
        return true;
    judge_unset(made, of->result, of->size);
    return false;
}
