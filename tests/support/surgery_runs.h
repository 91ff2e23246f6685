// Random operations on adaptive surfaces, and the judge of what they leave: the
// surface must not intersect itself, every closed part must be where it was,
// inside or outside of every other, and the right side out.
#ifndef SUPPORT_SURGERY_RUNS_H
#define SUPPORT_SURGERY_RUNS_H

#include "support/adaptive_scenes.h"
#include "surgery/outcome.h"

enum {
    LABELLED = 20000 ///< the most vertices in a run
};

typedef enum operation {
    SPLIT_EDGE,
    MOVE_VERTEX,
    COLLAPSE_HALF,
    COLLAPSE_TO_PLACE,
    FLIP_EDGE,
} operation;

enum {
    OPERATIONS = FLIP_EDGE + 1
};

/// What to do: to the edge from a to b, or to the vertex a.
typedef struct surgery_choice {
    operation what;
    int a, b;
    double position[3];
} surgery_choice;

/// How often which operation ended how.
typedef struct surgery_counts {
    long count[OPERATIONS][TF_OUTCOMES];
    long judged;
} surgery_counts;

/// A surface that is operated on.
typedef struct surgery_run {
    generator random;
    adaptive_scene scene;
    tf_adaptive_surface *surface;
    int part[LABELLED]; ///< of each vertex
    int nesting[SCENE_PARTS]
               [SCENE_PARTS]; ///< how often one goes around another
    int sign[SCENE_PARTS];    ///< of the volume; 0: open
    int changed; ///< the part that the last operation was meant for
    surgery_counts *counts;
} surgery_run;

/// Begins a run on a scene; `counts` may be shared by runs.
void surgery_run_begin(surgery_run *run, generator random,
                       adaptive_scene_kind kind, surgery_counts *counts);
void surgery_run_end(surgery_run *run);

/// Notes how the parts are nested now, and the signs of their volumes.
void surgery_run_note(surgery_run *run);

/// A corner of some triangle that exists.
int surgery_run_corner(surgery_run *run);

/// Chooses an operation.
surgery_choice surgery_run_choose(surgery_run *run);

/// Tries it on any surface; `vertex` becomes the number of a new vertex, or -1.
tf_outcome surgery_choice_try(tf_adaptive_surface *surface,
                              const surgery_choice *request, int *vertex);

/// Tries it on the surface of a run.
tf_outcome operate(surgery_run *run, const surgery_choice *request);

/// Closes the gaps in the numbers of vertices.
void surgery_run_compact(surgery_run *run);

/// What is wrong with the surface: tangles, or what the last operation can have
/// changed of the nesting and the volumes.  NULL: nothing.  Static storage.
const char *surgery_run_fault(const surgery_run *run);

/// Gives each vertex of a surface the number of its part; returns how many
/// parts there are.  -1: it has no triangles.
int label_parts(const tf_adaptive_surface *surface, int part[]);

/// A number that depends on all that the surface is.
uint64_t surgery_run_hash(const surgery_run *run);

/// Runs `operations` of them on a scene, leaving out tests of the library (bits
/// 1 << outcome); judges after each that is done, and compares the surface after
/// each that is not.  Returns the first fault, or NULL.  Static storage.
const char *run_surgery(generator random, adaptive_scene_kind kind,
                        int operations, unsigned left_out,
                        surgery_counts *counts);

/// Prints a table.
void surgery_counts_print(const surgery_counts *counts);

#endif
