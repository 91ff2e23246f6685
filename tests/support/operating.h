// Random operations on adaptive surfaces, and the judge of what they leave: the
// surface must not intersect itself, every closed part must be where it was,
// inside or outside of every other, and the right side out.
#ifndef SUPPORT_OPERATING_H
#define SUPPORT_OPERATING_H

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
typedef struct chosen {
    operation what;
    int a, b;
    double place[3];
} chosen;

/// How often which operation ended how.
typedef struct operating_counts {
    long count[OPERATIONS][TF_OUTCOMES];
    long judged;
} operating_counts;

/// A surface that is operated on.
typedef struct operating {
    generator random;
    adaptive_scene scene;
    tf_adaptive_surface *surface;
    int part[LABELLED]; ///< of each vertex
    int nesting[SCENE_PARTS]
               [SCENE_PARTS]; ///< how often one goes around another
    int sign[SCENE_PARTS];    ///< of the volume; 0: open
    int changed; ///< the part that the last operation was meant for
    operating_counts *counts;
} operating;

/// Begins a run on a scene; `counts` may be shared by runs.
void operating_begin(operating *run, generator random, adaptive_scene_kind kind,
                     operating_counts *counts);
void operating_end(operating *run);

/// Notes how the parts are nested now, and the signs of their volumes.
void operating_note(operating *run);

/// A corner of some triangle that exists.
int operating_corner(operating *run);

/// Chooses an operation.
chosen operating_choose(operating *run);

/// Tries it on any surface; `vertex` becomes the number of a new vertex, or -1.
tf_outcome chosen_try(tf_adaptive_surface *surface, const chosen *request,
                      int *vertex);

/// Tries it on the surface of a run.
tf_outcome operate(operating *run, const chosen *request);

/// Closes the gaps in the numbers of vertices.
void operating_compact(operating *run);

/// What is wrong with the surface: tangles, or what the last operation can have
/// changed of the nesting and the volumes.  NULL: nothing.  Static storage.
const char *operating_fault(const operating *run);

/// A number that depends on all that the surface is.
uint64_t operating_hash(const operating *run);

/// Runs `operations` of them on a scene, leaving out tests of the library (bits
/// 1 << outcome); judges after each that is done, and compares the surface after
/// each that is not.  Returns the first fault, or NULL.  Static storage.
const char *operating_run(generator random, adaptive_scene_kind kind,
                          int operations, unsigned left_out,
                          operating_counts *counts);

/// Prints a table.
void operating_counts_print(const operating_counts *counts);

#endif
