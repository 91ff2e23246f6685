// Remeshing with sharp edges, kept edges and lengths, judged after each operation
// that is done:
//
//     remeshing COUNT FROM
//
// goes on until COUNT operations are done, in scenes of the streams of random
// numbers FROM on of TF_SEED's.  The surface must not intersect itself, its
// corners must be where they were, bit for bit, and each sharp edge must be an
// edge, and at least 0.999 as long as what it stands for.  Prints each fault,
// with the stream that repeats it.
#include "remesh/keep_shape.h"
#include "remesh/passes.h"
#include "remesh/sizes.h"
#include "support/adaptive_surfaces.h"
#include "support/surgery_runs.h"
#include "surgery/draft.h"
#include "surgery/star.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    ROUNDS = 2,
    MOST_KEPT = 4
};

/// A remeshing that is watched.
typedef struct soak_run {
    surgery_run run; ///< the surface that changes
    tf_adaptive_surface original;
    tf_remesher remesher;
    tf_sizes sizes;
    size_t done; ///< when it was judged last
    const char *fault;
} soak_run;

static soak_run soaked;
static long judged[TF_OPERATIONS];

// Judging ---------------------------------------------------------------------

/// All sharp edges of a vertex must be edges, long enough; a corner must be where
/// a vertex of the original was.
static const char *sharp_fault(const tf_remesher *remesher, int vertex)
{
    const tf_adaptive_surface *surface = remesher->surface;
    const tf_sharp_link *links = remesher->sharp.link.data;
    int i = ((const int *)remesher->sharp.first.data)[vertex];
    for (; i != TF_NONE; i = links[i].next) {
        int to = links[i].to;
        if (tf_find_edge(surface, vertex, to) == TF_NONE &&
            tf_find_edge(surface, to, vertex) == TF_NONE)
            return "a sharp edge is no edge";
        if (tf_length_of(surface, vertex, to) <
            0.999 * links[i].length * (1 - 1e-12))
            return "a sharp edge is too short";
    }
    return NULL;
}

static const char *corner_fault(const tf_remesher *remesher, int vertex)
{
    if (tf_freedom_of(&remesher->sharp_before, vertex) == TF_HELD &&
        (tf_first_corner(remesher->surface, vertex) == TF_NONE ||
         memcmp(tf_vertex_coordinates(remesher->surface, vertex),
                tf_vertex_coordinates(remesher->original.surface, vertex),
                3 * sizeof(double)) != 0))
        return "a corner has moved";
    return NULL;
}

static const char *all_faults(const soak_run *all)
{
    const tf_remesher *remesher = &all->remesher;
    const char *fault = surgery_run_fault(&all->run);
    for (int v = 0; v < remesher->surface->vertices && !fault; v++)
        fault = sharp_fault(remesher, v);
    // The gaps are not closed, so that vertices keep their numbers.
    for (int v = 0; v < all->original.vertices && !fault; v++)
        fault = corner_fault(remesher, v);
    return fault;
}

static size_t count_done(const tf_remesher *remesher)
{
    size_t sum = 0;
    for (int i = 0; i < TF_OPERATIONS; i++)
        sum += remesher->report.tried[i][TF_COMMITTED];
    return sum;
}

/// Before the next operation is chosen; false if there is a fault.
static bool judge(void)
{
    size_t done = count_done(&soaked.remesher);
    if (done != soaked.done && !soaked.fault)
        soaked.fault = all_faults(&soaked);
    soaked.done = done;
    return !soaked.fault;
}

// Choosing --------------------------------------------------------------------

static bool choose_split(tf_remesher *remesher, int corner, int refused,
                         tf_vector *position, tf_volume_error *error)
{
    return judge() && tf_keep_shape.choose_split(remesher, corner, refused,
                                                 position, error);
}

static bool choose_collapse(tf_remesher *remesher, int corner,
                            tf_edge_collapse *collapse)
{
    return judge() && tf_keep_shape.choose_collapse(remesher, corner, collapse);
}

static bool choose_flip(tf_remesher *remesher, const tf_diagonals *diagonals,
                        tf_volume_error *error)
{
    return judge() && tf_keep_shape.choose_flip(remesher, diagonals, error);
}

static bool choose_move(tf_remesher *remesher, int vertex, tf_vector *position)
{
    return judge() && tf_keep_shape.choose_move(remesher, vertex, position);
}

// Running ---------------------------------------------------------------------

/// A crease angle, and some edges that are kept, or corners.
static tf_sharpness choose_sharpness(generator *random,
                                     const tf_adaptive_surface *surface,
                                     int keep[2 * MOST_KEPT])
{
    tf_sharpness made = {.cosine = uniform(random, -1, 1),
                         .depth = INFINITY,
                         .keeps = below(random, MOST_KEPT + 1),
                         .keep = keep};
    for (int i = 0; i < made.keeps; i++) {
        int corner = below(random, 3 * surface->triangles);
        int other = below(random, 4) ? tf_corner_after(corner) : corner;
        keep[2 * i] = tf_vertex_at(surface, corner);
        keep[2 * i + 1] = tf_vertex_at(surface, other);
    }
    return made;
}

static tf_status begin_sharp(soak_run *all)
{
    tf_remesher *remesher = &all->remesher;
    int keep[2 * MOST_KEPT];
    tf_sharpness sharpness =
        choose_sharpness(&all->run.random, &all->original, keep);
    tf_status status = tf_sharp_edges_find(&remesher->sharp_before,
                                           &all->original, &sharpness, NULL);
    bool good =
        status == TF_OK &&
        tf_sharp_edges_copy(&remesher->sharp, &remesher->sharp_before) &&
        tf_trace_begin(&remesher->trace, &remesher->original,
                       &remesher->sharp_before);
    return good ? TF_OK : TF_OUT_OF_MEMORY;
}

/// Lengths between a half and four times the scene's unit.
static bool begin_lengths(soak_run *all)
{
    static double length[PLACED_VERTICES];
    all->remesher.edge = 0;
    for (int v = 0; v < all->original.vertices; v++) {
        length[v] = all->run.scene.unit * uniform(&all->run.random, 0.5, 4);
        all->remesher.edge =
            fmax(all->remesher.edge, length[v] * all->original.scale);
    }
    return tf_sizes_begin(&all->sizes, &all->remesher, length);
}

/// The scene of a stream; one in six is a prism of many sides instead, whose
/// sharp edges are round.
static void begin_scene(soak_run *all, long stream)
{
    static surgery_counts counts;
    surgery_run *run = &all->run;
    surgery_run_begin(run, generator_new((uint64_t)stream),
                      (adaptive_scene_kind)(stream % ADAPTIVE_SCENES), &counts);
    if (stream % 6 == 5) {
        int sides = 12 + below(&run->random, 53);
        tf_adaptive_free(run->surface);
        run->surface = adaptive_prism(sides);
        run->scene.unit = 0.5;
    }
    memset(run->part, 0, sizeof run->part);
    run->scene.kind = SHEETS; // nothing but tangles is judged
    tf_choose_scale(run->surface);
}

static void begin(soak_run *all, long stream)
{
    static tf_remesh_policy policy;
    *all = (soak_run){0};
    policy = tf_keep_shape;
    policy.choose_split = choose_split;
    policy.choose_collapse = choose_collapse;
    policy.choose_flip = choose_flip;
    policy.choose_move = choose_move;
    begin_scene(all, stream);
    all->remesher.surface = all->run.surface;
    all->remesher.policy = &policy;
    if (tf_draft_begin(&all->original, all->run.surface, NULL) != TF_OK ||
        tf_original_begin(&all->remesher.original, &all->original, NULL) !=
            TF_OK ||
        begin_sharp(all) != TF_OK || !begin_lengths(all))
        abort();
}

static void end(soak_run *all)
{
    for (int i = 0; i < TF_OPERATIONS; i++)
        judged[i] += (long)all->remesher.report.tried[i][TF_COMMITTED];
    tf_sizes_free(&all->sizes);
    tf_remesher_free(&all->remesher);
    tf_draft_free(&all->original);
    surgery_run_end(&all->run);
}

static const char *soak(long stream)
{
    begin(&soaked, stream);
    for (int i = 0; i < ROUNDS && judge(); i++)
        if (tf_remesh_round(&soaked.remesher) != TF_OK)
            abort();
    judge();
    const char *fault = soaked.fault;
    end(&soaked);
    return fault;
}

int main(int argc, char *argv[])
{
    long count = argc > 1 ? atol(argv[1]) : 10000;
    long stream = argc > 2 ? atol(argv[2]) : 0, from = stream, faults = 0;
    if (count < 1 || from < 0) {
        fprintf(stderr, "remeshing: COUNT from 1, FROM from 0\n");
        return EXIT_FAILURE;
    }
    for (long sum = 0; sum < count; stream++) {
        const char *fault = soak(stream);
        if (fault) {
            faults++;
            printf("stream %ld: %s\n", stream, fault);
            fflush(stdout);
        }
        sum = judged[TF_SPLIT] + judged[TF_COLLAPSE] + judged[TF_FLIP] +
              judged[TF_SMOOTH];
    }
    printf("%ld splits, %ld collapses, %ld flips, %ld moves\n",
           judged[TF_SPLIT], judged[TF_COLLAPSE], judged[TF_FLIP],
           judged[TF_SMOOTH]);
    printf("seed %llu, streams %ld to %ld, %ld faults\n",
           (unsigned long long)seed(), from, stream - 1, faults);
    return faults == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
