#include "support/surgery_runs.h"

#include "experiments/leave_out.h"
#include "support/adaptive_surfaces.h"
#include "support/dyadic.h"
#include "support/tangle.h"
#include "support/winding.h"
#include "surgery/adaptive_surface.h"
#include "surgery/collapse.h"
#include "surgery/flip.h"
#include "surgery/move.h"
#include "surgery/split.h"

#include <gmp.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// The surface without gaps -----------------------------------------------------

/// The triangles that exist, and their vertices, numbered anew.
typedef struct snapshot {
    int vertices, triangles;
    int number[LABELLED]; ///< of a vertex of the surface; -1: it has none
    int part[LABELLED];
    double position[3 * LABELLED];
    int triangle[3 * LABELLED];
} snapshot;

static int number_of(snapshot *taken, const surgery_run *run, int vertex)
{
    int *number = &taken->number[vertex];
    if (*number < 0) {
        *number = taken->vertices++;
        taken->part[*number] = run->part[vertex];
        memcpy(taken->position + 3 * *number,
               tf_adaptive_positions(run->surface) + 3 * vertex,
               3 * sizeof(double));
    }
    return *number;
}

static void take_snapshot(const surgery_run *run, snapshot *taken)
{
    tf_mesh mesh = *tf_adaptive_mesh(run->surface);
    taken->vertices = taken->triangles = 0;
    for (int v = 0; v < mesh.vertices; v++)
        taken->number[v] = -1;
    for (int t = 0; t < mesh.triangles; t++) {
        if (mesh.triangle[3 * t] < 0)
            continue;
        for (int i = 0; i < 3; i++)
            taken->triangle[3 * taken->triangles + i] =
                number_of(taken, run, mesh.triangle[3 * t + i]);
        taken->triangles++;
    }
}

// Judging ---------------------------------------------------------------------

static char fault[200];

static const char *tangle_fault(const snapshot *taken)
{
    tf_mesh mesh = {.axes = 3,
                    .vertices = taken->vertices,
                    .triangles = taken->triangles,
                    .triangle = taken->triangle};
    tangle_judge *judge = tangle_judge_new(&mesh);
    int count = tangle_count(judge, taken->position);
    if (count > 0)
        snprintf(fault, sizeof fault, "%d tangles: %s", count,
                 tangle_text(tangles(judge)));
    tangle_judge_free(judge);
    return count > 0 ? fault : NULL;
}

/// The triangles of a part; `list` has room for all.
static cycle cycle_of(const snapshot *taken, int part, int list[])
{
    int count = 0;
    for (int t = 0; t < taken->triangles; t++)
        if (taken->part[taken->triangle[3 * t]] == part)
            memcpy(list + 3 * count++, taken->triangle + 3 * t,
                   3 * sizeof *list);
    return (cycle){count, 3, list};
}

static int vertex_of(const snapshot *taken, int part)
{
    for (int v = 0; v < taken->vertices; v++)
        if (taken->part[v] == part)
            return v;
    return -1;
}

/// The corners of a triangle, times a power of two.
static void take_corners(const snapshot *taken, const int triangle[],
                         int exponent, mpz_t x[3][3])
{
    for (int i = 0; i < 9; i++)
        dyadic_scale(x[i / 3][i % 3],
                     taken->position[3 * triangle[i / 3] + i % 3], exponent);
}

/// sum += one times the minor of the two others without axis k.
static void add_minor(mpz_t sum, int k, mpz_t x[3][3])
{
    int l = (k + 1) % 3, m = (k + 2) % 3;
    mpz_t minor;
    mpz_init(minor);
    mpz_mul(minor, x[1][l], x[2][m]);
    mpz_submul(minor, x[1][m], x[2][l]);
    mpz_addmul(sum, x[0][k], minor);
    mpz_clear(minor);
}

static int volume_sign(const snapshot *taken, const cycle *part)
{
    mpz_t sum, x[3][3];
    int exponent = 0;
    mpz_init(sum);
    for (int i = 0; i < 9; i++)
        mpz_init(x[i / 3][i % 3]);
    for (int i = 0; i < 3 * taken->vertices; i++)
        exponent = dyadic_least(exponent, taken->position[i]);
    for (int t = 0; t < part->count; t++) {
        take_corners(taken, part->vertices + 3 * t, exponent, x);
        for (int k = 0; k < 3; k++)
            add_minor(sum, k, x);
    }
    int sign = mpz_sgn(sum);
    mpz_clear(sum);
    for (int i = 0; i < 9; i++)
        mpz_clear(x[i / 3][i % 3]);
    return sign;
}

static bool is_flat(const snapshot *taken, const int triangle[])
{
    mpq_t u[2][3], term, sum;
    bool flat = true;
    mpq_inits(term, sum, NULL);
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 3; k++) {
            mpq_init(u[i][k]);
            mpq_set_d(u[i][k], taken->position[3 * triangle[i + 1] + k]);
            mpq_set_d(term, taken->position[3 * triangle[0] + k]);
            mpq_sub(u[i][k], u[i][k], term);
        }
    for (int k = 0; k < 3; k++) {
        int l = (k + 1) % 3;
        mpq_mul(sum, u[0][k], u[1][l]);
        mpq_mul(term, u[0][l], u[1][k]);
        flat &= mpq_equal(sum, term) != 0;
    }
    for (int i = 0; i < 6; i++)
        mpq_clear(u[i / 3][i % 3]);
    mpq_clears(term, sum, NULL);
    return flat;
}

static const char *flat_fault(const snapshot *taken, int part)
{
    for (int t = 0; t < taken->triangles; t++)
        if (taken->part[taken->triangle[3 * t]] == part &&
            is_flat(taken, taken->triangle + 3 * t))
            return "a triangle is collinear";
    return NULL;
}

// Nesting ---------------------------------------------------------------------

static int nesting_of(const snapshot *taken, const cycle *outer, int inner)
{
    return winding_number(3, taken->position, outer, vertex_of(taken, inner));
}

/// Compares, or at first notes, what concerns a part.
static const char *nesting_fault(const surgery_run *run, const snapshot *taken,
                                 int part)
{
    static int list[3 * LABELLED], others[3 * LABELLED];
    cycle own = cycle_of(taken, part, list);
    if (volume_sign(taken, &own) != run->sign[part])
        return "a part is inside out";
    for (int other = 0; other < run->scene.parts; other++) {
        if (other == part)
            continue;
        cycle its = cycle_of(taken, other, others);
        if (nesting_of(taken, &own, other) != run->nesting[part][other] ||
            nesting_of(taken, &its, part) != run->nesting[other][part])
            return "a part has changed sides";
    }
    return NULL;
}

void surgery_run_note(surgery_run *run)
{
    static snapshot taken;
    static int list[3 * LABELLED];
    take_snapshot(run, &taken);
    for (int part = 0; part < run->scene.parts; part++) {
        cycle own = cycle_of(&taken, part, list);
        run->sign[part] = volume_sign(&taken, &own);
        for (int other = 0; other < run->scene.parts; other++)
            run->nesting[part][other] =
                other == part ? 0 : nesting_of(&taken, &own, other);
    }
}

const char *surgery_run_fault(const surgery_run *run)
{
    static snapshot taken;
    take_snapshot(run, &taken);
    const char *found = tangle_fault(&taken);
    if (!found)
        found = flat_fault(&taken, run->changed);
    if (!found && run->scene.kind != SHEETS)
        found = nesting_fault(run, &taken, run->changed);
    return found;
}

// Running ---------------------------------------------------------------------

void surgery_run_begin(surgery_run *run, generator random,
                       adaptive_scene_kind kind, surgery_counts *counts)
{
    run->random = random;
    run->counts = counts;
    run->changed = 0;
    adaptive_scene_make(&run->random, kind, &run->scene);
    tf_mesh mesh = adaptive_scene_mesh(&run->scene);
    if (tf_adaptive_create(&mesh, run->scene.position, &run->surface, NULL) !=
        TF_OK)
        abort();
    memcpy(run->part, run->scene.part, sizeof run->scene.part);
    if (kind != SHEETS)
        surgery_run_note(run);
}

void surgery_run_end(surgery_run *run)
{
    tf_adaptive_free(run->surface);
}

// Choosing --------------------------------------------------------------------

int surgery_run_corner(surgery_run *run)
{
    tf_mesh mesh = *tf_adaptive_mesh(run->surface);
    int corner = 3 * below(&run->random, mesh.triangles);
    while (mesh.triangle[corner] < 0)
        corner = 3 * below(&run->random, mesh.triangles);
    return corner + below(&run->random, 3);
}

static double length_between(const double a[], const double b[])
{
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                (a[2] - b[2]) * (a[2] - b[2]));
}

/// Onto another vertex, the middle of an edge or the plane of a triangle, or
/// nearly so.
static void choose_special(surgery_run *run, double position[3])
{
    tf_mesh mesh = *tf_adaptive_mesh(run->surface);
    const double *x = tf_adaptive_positions(run->surface);
    int corner = surgery_run_corner(run), first = corner / 3 * 3,
        corners = 1 + below(&run->random, 3);
    for (int k = 0; k < 3; k++) {
        double sum = 0;
        for (int i = 0; i < corners; i++)
            sum += x[3 * mesh.triangle[first + (corner + i) % 3] + k];
        position[k] = sum / corners;
    }
}

/// Near the point between two vertices, or far, or on the lattice, or special.
static void choose_position(surgery_run *run, int a, int b, double position[3])
{
    generator *random = &run->random;
    const double *x = tf_adaptive_positions(run->surface);
    double length = length_between(x + 3 * a, x + 3 * b);
    double far = (length > 0 ? length : run->scene.unit) *
                 pow(10, uniform(random, -4, 0.7));
    for (int k = 0; k < 3; k++)
        position[k] = (x[3 * a + k] + x[3 * b + k]) / 2;
    int way = below(random, 10);
    if (way == 0) {
        choose_special(run, position);
        return;
    }
    bool lattice = run->scene.kind == SLABS || run->scene.kind == SHEETS;
    for (int k = 0; k < 3 && way > 1; k++) {
        position[k] += uniform(random, -far, far);
        if (lattice && way > 4)
            position[k] = rint(position[k] * 2) / 2;
    }
}

static operation choose_operation(surgery_run *run)
{
    static const operation list[] = {SPLIT_EDGE,        MOVE_VERTEX,
                                     MOVE_VERTEX,       COLLAPSE_HALF,
                                     COLLAPSE_TO_PLACE, FLIP_EDGE};
    tf_mesh mesh = *tf_adaptive_mesh(run->surface);
    int many = mesh.triangles > 2 * run->scene.triangles ? 1 : 0;
    return list[many + below(&run->random, 6 - many)];
}

surgery_choice surgery_run_choose(surgery_run *run)
{
    tf_mesh mesh = *tf_adaptive_mesh(run->surface);
    surgery_choice made = {.what = choose_operation(run)};
    int corner = surgery_run_corner(run);
    made.a = mesh.triangle[corner];
    made.b = mesh.triangle[corner % 3 == 2 ? corner - 2 : corner + 1];
    choose_position(run, made.a, made.what == MOVE_VERTEX ? made.a : made.b,
                    made.position);
    return made;
}

// Operating -------------------------------------------------------------------

static tf_status do_operation(tf_adaptive_surface *surface,
                              const surgery_choice *request, int *vertex,
                              tf_outcome *outcome)
{
    const surgery_choice *r = request;
    switch (r->what) {
    case SPLIT_EDGE:
        return tf_adaptive_split(surface, r->a, r->b, r->position, vertex,
                                 outcome);
    case MOVE_VERTEX:
        return tf_adaptive_move(surface, r->a, r->position, outcome);
    case COLLAPSE_HALF:
        return tf_adaptive_collapse(surface, r->a, r->b, outcome);
    case COLLAPSE_TO_PLACE:
        return tf_adaptive_collapse_to(surface, r->a, r->b, r->position,
                                       outcome);
    default:
        return tf_adaptive_flip(surface, r->a, r->b, outcome);
    }
}

tf_outcome surgery_choice_try(tf_adaptive_surface *surface,
                              const surgery_choice *request, int *vertex)
{
    tf_outcome outcome;
    *vertex = -1;
    if (do_operation(surface, request, vertex, &outcome) != TF_OK ||
        *vertex >= LABELLED)
        abort();
    return outcome;
}

tf_outcome operate(surgery_run *run, const surgery_choice *request)
{
    int vertex;
    run->changed = run->part[request->a];
    tf_outcome outcome = surgery_choice_try(run->surface, request, &vertex);
    if (vertex >= 0)
        run->part[vertex] = run->changed;
    run->counts->count[request->what][outcome]++;
    return outcome;
}

void surgery_run_compact(surgery_run *run)
{
    static int map[LABELLED];
    int before = tf_adaptive_mesh(run->surface)->vertices;
    if (tf_adaptive_compact(run->surface, map) != TF_OK)
        abort();
    for (int v = 0; v < before; v++)
        if (map[v] >= 0)
            run->part[map[v]] = run->part[v];
}

// Parts -----------------------------------------------------------------------

static int root_of(int parent[], int v)
{
    while (parent[v] != v)
        v = parent[v] = parent[parent[v]];
    return v;
}

int label_parts(const tf_adaptive_surface *surface, int part[])
{
    static int parent[LABELLED], label[LABELLED];
    tf_mesh mesh = *tf_adaptive_mesh(surface);
    int parts = 0;
    for (int v = 0; v < mesh.vertices; v++) {
        parent[v] = v;
        label[v] = part[v] = -1;
    }
    for (int c = 0; c < 3 * mesh.triangles; c++)
        if (mesh.triangle[c / 3 * 3] >= 0)
            parent[root_of(parent, mesh.triangle[c])] =
                root_of(parent, mesh.triangle[c / 3 * 3]);
    for (int c = 0; c < 3 * mesh.triangles; c++) {
        if (mesh.triangle[c / 3 * 3] < 0)
            continue;
        int *own = &label[root_of(parent, mesh.triangle[c])];
        if (*own < 0)
            *own = parts++;
        part[mesh.triangle[c]] = *own;
    }
    return parts;
}

// The whole state -------------------------------------------------------------

uint64_t surgery_run_hash(const surgery_run *run)
{
    return adaptive_hash(run->surface);
}

const char *run_surgery(generator random, adaptive_scene_kind kind,
                        int operations, unsigned left_out,
                        surgery_counts *counts)
{
    static surgery_run run;
    const char *found = NULL;
    surgery_run_begin(&run, random, kind, counts);
    leave_out(left_out);
    for (int i = 0; i < operations && !found; i++) {
        surgery_choice request = surgery_run_choose(&run);
        uint64_t hash = surgery_run_hash(&run);
        if (operate(&run, &request) == TF_COMMITTED) {
            found = surgery_run_fault(&run);
            counts->judged++;
        } else if (surgery_run_hash(&run) != hash)
            found = "a refusal has changed the surface";
        if (i % 128 == 127)
            surgery_run_compact(&run);
    }
    leave_out(0);
    surgery_run_end(&run);
    return found;
}

void surgery_counts_print(const surgery_counts *counts)
{
    static const char *const operations[] = {"split", "move", "collapse",
                                             "collapse to", "flip"};
    printf("%-12s%10s%11s%10s%10s%10s%10s%10s\n", "", "done", "impossible", "D",
           "S", "V", "E", "X");
    for (int i = 0; i < OPERATIONS; i++) {
        printf("%-12s", operations[i]);
        for (int j = TF_COMMITTED; j <= TF_PASSED_TRIANGLE; j++)
            printf("%*ld", j == TF_IMPOSSIBLE ? 11 : 10, counts->count[i][j]);
        printf("\n");
    }
    printf("judged: %ld\n", counts->judged);
}
