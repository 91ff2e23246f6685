// Surfaces that calls are made about, each with its resolver, and what new ones
// answer to calls that are always the same.
#ifndef FUZZ_CALLS_BODIES_H
#define FUZZ_CALLS_BODIES_H

#include "arguments.h"

enum {
    MOST_VERTICES = 12,
    MOST_TRIANGLES = 8,
    MOST_EDGES = 8,
    NUMBERS = 3 * MOST_VERTICES ///< coordinates of a position
};

typedef struct body {
    tf_mesh mesh;
    int triangle[3 * MOST_TRIANGLES], edge[2 * MOST_EDGES];
    tf_surface *surface;   ///< of the mesh; NULL: there is no body
    tf_resolver *resolver; ///< of the surface, or NULL
    tf_pair_filter filter; ///< of the surface; all zero: none
    int group[MOST_VERTICES];
    double start[NUMBERS], end[NUMBERS]; ///< a step that is known
    bool known; ///< whether it is known what new objects answer to it:
    uint64_t detected, checked, resolved;
} body;

/// Draws a mesh and a step of it, whose start is clear most of the time.
void body_draw(generator *random, body *drawn);

/// Makes another surface of the same mesh, with the same filter.
tf_surface *body_copy(const body *of);

/// How many coordinates a position has.
int body_numbers(const body *of);

/// Requires that the objects of the body answer as new ones do.
void judge_body(const call *made, body *of);

void body_free(body *of);

// Answers in numbers ----------------------------------------------------------

/// Numbers that depend on all that was found.
uint64_t hash_contacts(const tf_contacts *found);
uint64_t hash_crossings(const tf_crossings *found);
uint64_t hash_candidates(const tf_candidates *found);
uint64_t hash_report(const tf_response_report *report);
uint64_t hash_answers(size_t count, const tf_answered_contact contact[],
                      const double push[]);

#endif
