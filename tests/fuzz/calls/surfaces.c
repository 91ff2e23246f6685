#include "surfaces.h"

#include "allocator.h"

#include <limits.h>
#include <string.h>

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))

// Creating --------------------------------------------------------------------

/// Spoils a number of the mesh, or an index.
static void spoil_mesh(generator *random, call *made, body *of)
{
    static const int bad[] = {-1, INT_MIN, INT_MAX};
    tf_mesh *mesh = &of->mesh;
    int *counts[] = {&mesh->vertices, &mesh->triangles, &mesh->edges};
    int fault = below(random, 6);
    bool plane = mesh->axes == 2;
    if (fault < 3) {
        *counts[fault] = bad[below(random, COUNT(bad))];
        expect_fault(made, true, TF_BAD_COUNT);
        // Any number of triangles in the plane is a matter of axes, too.
        expect_fault(made, plane && fault == 1, TF_BAD_AXES);
    } else if (fault == 3) {
        mesh->axes = wrong_number(random, mesh->axes);
        bool good = mesh->axes == 3 || (mesh->axes == 2 && !mesh->triangles);
        expect_fault(made, !good, TF_BAD_AXES);
    } else if (fault == 4) {
        int *list = plane ? of->edge : of->triangle;
        int count = plane ? 2 * mesh->edges : 3 * mesh->triangles;
        int place = below(random, count);
        list[place] = one_in(random, 2)
                          ? list[place ^ (place % 2 == 0 && place + 1 < count)]
                          : wrong_number(random, list[place]);
        bool inside = list[place] >= 0 && list[place] < mesh->vertices;
        excuse(made, TF_BAD_INDEX);
        expect_fault(made, !inside, TF_BAD_INDEX);
    } else {
        mesh->triangles = mesh->edges = 0;
        expect_fault(made, true, TF_NO_ELEMENTS);
    }
}

/// Leaves out a list that is empty, or is not.
static void drop_lists(generator *random, call *made, body *of)
{
    tf_mesh *mesh = &of->mesh;
    if (mesh->triangles == 0 || one_in(random, 32))
        mesh->triangle = NULL;
    if (mesh->edges == 0 || one_in(random, 32))
        mesh->edge = NULL;
    expect_fault(made,
                 (!mesh->triangle && mesh->triangles > 0) ||
                     (!mesh->edge && mesh->edges > 0),
                 TF_BAD_COUNT);
}

void call_create(generator *random, body *of)
{
    body drawn;
    tf_surface *surface;
    results set;
    call made = call_begin("tf_surface_create");
    body_draw(random, &drawn);
    if (one_in(random, 4))
        spoil_mesh(random, &made, &drawn);
    drop_lists(random, &made, &drawn);
    results_begin(random, &set, &surface, sizeof surface);
    tf_status status = tf_surface_create(&drawn.mesh, &surface, &set.error);
    if (!results_judge(random, &made, &set, NULL, status))
        return;
    body_free(of);
    *of = drawn;
    of->mesh.triangle = of->triangle;
    of->mesh.edge = of->edge;
    of->surface = surface;
}

// Resolvers -------------------------------------------------------------------

void call_resolver(generator *random, body *of)
{
    call made = call_begin("tf_resolver_create");
    bool before = of->resolver;
    tf_resolver_free(of->resolver);
    of->resolver = NULL;
    if (before && one_in(random, 2))
        return;
    tf_resolver *resolver;
    mark(&resolver, sizeof resolver);
    allocator_fail(random);
    tf_status status = tf_resolver_create(of->surface, &resolver);
    end_trouble(&made);
    if (!judge_status(&made, status)) {
        judge_unset(&made, &resolver, sizeof resolver);
        return;
    }
    of->resolver = resolver;
    require(&made, tf_resolver_memory(resolver) > 0, "it holds nothing");
}

/// Makes a resolver if there is none.
static void need_resolver(body *of)
{
    call made = call_begin("tf_resolver_create");
    if (!of->resolver)
        judge_status(&made, tf_resolver_create(of->surface, &of->resolver));
}

// Filters ---------------------------------------------------------------------

typedef struct pair_filter {
    tf_pair_filter own;
    unsigned char later[LATER];
} pair_filter;

/// What the contexts of filters point to.
static int divisor = 3;

/// Leaves out a third of the pairs.
static bool is_wanted(void *context, const tf_element_pair *pair)
{
    call made = {.name = "a filter of pairs"};
    int sum = 0, count = pair->kind == TF_POINT_EDGE ? 3 : 4;
    require(&made, context == &divisor, "it has another context");
    require(&made, pair->kind >= TF_POINT_EDGE && pair->kind <= TF_EDGE_EDGE,
            "the pair is of no kind");
    for (int i = 0; i < count; i++) {
        require(&made, pair->vertex[i] >= 0, "the pair has no vertices");
        for (int j = 0; j < i; j++)
            require(&made, pair->vertex[i] != pair->vertex[j],
                    "the pair shares a vertex");
        sum += pair->vertex[i];
    }
    return sum % divisor != 0;
}

static void draw_filter(generator *random, call *made, const body *of,
                        pair_filter *filter, int group[])
{
    tf_pair_filter *own = &filter->own;
    *own = (tf_pair_filter){.context = &divisor};
    own->size = any_size(random, made, sizeof *own, filter->later);
    for (int i = 0; i < MOST_VERTICES; i++)
        group[i] = one_in(random, 2) ? below(random, 3) : INT_MIN;
    if (one_in(random, 2)) {
        own->vertices = of->mesh.vertices;
        own->group = group;
    }
    if (one_in(random, 8)) {
        own->vertices = wrong_number(random, own->vertices);
        expect_fault(made, true, TF_BAD_COUNT);
    }
    own->wanted = one_in(random, 2) ? is_wanted : NULL;
}

/// Takes over a filter that a surface has copied.
static void keep_filter(body *of, const tf_pair_filter *filter)
{
    of->filter = *filter;
    of->filter.size = 0; // without what is later
    if (!filter->group)
        return;
    memcpy(of->group, filter->group, sizeof of->group);
    of->filter.group = of->group;
}

void call_filter_pairs(generator *random, body *of)
{
    static pair_filter filter;
    int group[MOST_VERTICES];
    results set;
    call made = call_begin("tf_surface_set_filter");
    bool none = one_in(random, 4);
    filter = (pair_filter){0};
    if (!none)
        draw_filter(random, &made, of, &filter, group);
    results_begin(random, &set, NULL, 0);
    tf_status status = tf_surface_set_filter(
        of->surface, none ? NULL : &filter.own, &set.error);
    if (results_judge(random, &made, &set, NULL, status)) {
        keep_filter(of, &filter.own);
        mark(group, sizeof group);
        of->known = false;
    }
    judge_body(&made, of);
}

// Steps -----------------------------------------------------------------------

/// The positions of a step.
typedef struct step {
    int vertices; ///< that the caller claims to have
    double start[NUMBERS], end[NUMBERS];
} step;

/// Draws a step: the one that is known, one from its start, or any.
static void draw_step(generator *random, call *made, const body *of, step *s)
{
    int kind = below(random, 4), numbers = body_numbers(of);
    s->vertices = of->mesh.vertices;
    memcpy(s->start, of->start, sizeof s->start);
    memcpy(s->end, of->end, sizeof s->end);
    if (kind == 0)
        draw_coordinates(random, NUMBERS, s->start);
    if (kind < 3)
        draw_coordinates(random, NUMBERS, s->end);
    for (int i = 0; i < NUMBERS && kind == 1; i++)
        s->end[i] += s->start[i];
    if (one_in(random, 16)) {
        s->vertices = wrong_number(random, s->vertices);
        expect_fault(made, true, TF_BAD_COUNT);
    }
    expect_fault(made,
                 !all_finite(numbers, s->start) || !all_finite(numbers, s->end),
                 TF_NOT_FINITE);
}

/// The motion of a step, which may be spoiled.
static tf_motion draw_motion(generator *random, call *made, const body *of,
                             const step *s)
{
    tf_motion motion = {of->mesh.axes, s->vertices, s->start, s->end};
    if (!one_in(random, 16))
        return motion;
    int fault = below(random, 4);
    if (fault == 0)
        motion.axes = wrong_number(random, motion.axes);
    if (fault == 1)
        motion.start = NULL;
    if (fault == 2)
        motion.end = NULL;
    if (fault == 3)
        motion = (tf_motion){0};
    expect_fault(made, fault == 0 || fault == 3, TF_BAD_AXES);
    expect_fault(made, fault != 0, TF_BAD_COUNT);
    return motion;
}

// Detecting -------------------------------------------------------------------

enum {
    MOST_FACETS = MOST_TRIANGLES + MOST_EDGES
};

/// How many triangles there are, or in the plane edges.
static int body_facets(const body *of)
{
    int count;
    if (of->mesh.axes == 2)
        tf_surface_edges(of->surface, &count);
    else
        tf_surface_triangles(of->surface, &count);
    return count;
}

/// Draws any zones, or none.
static const int *draw_zones(generator *random, int zone[])
{
    if (one_in(random, 2))
        return NULL;
    for (int i = 0; i < MOST_FACETS; i++)
        zone[i] = below(random, 4) - 1;
    return zone;
}

/// Options with room for those of a later version.
typedef struct detect_options {
    tf_detect_options own;
    unsigned char later[LATER];
    int zone[MOST_FACETS];
} detect_options;

/// Decides as tf_reference does, one query after another; fails when its
/// context, the number of queries that are left, is zero.
static tf_status decide_few(void *context, const tf_arithmetic *arithmetic,
                            const tf_queries *queries, tf_verdict verdict[],
                            size_t *separated)
{
    int *left = context;
    for (size_t i = 0; i < queries->count; i++)
        if ((*left)-- == 0)
            return TF_OUT_OF_RANGE;
    return tf_reference.decide(NULL, arithmetic, queries, verdict, separated);
}

/// What the options of a detection point to.
typedef struct pointed_to {
    crew workers;
    listener hearing;
    int left; ///< of a narrow phase that fails
    tf_narrow_phase narrow_phase;
} pointed_to;

static const tf_narrow_phase *any_narrow_phase(generator *random, call *made,
                                               pointed_to *to)
{
    static const tf_narrow_phase *const all[] = {NULL, &tf_reference,
                                                 &tf_vectorized};
    if (!one_in(random, 8))
        return all[below(random, COUNT(all))];
    to->left = one_in(random, 2) ? -1 : below(random, 40);
    to->narrow_phase = (tf_narrow_phase){"few", decide_few, NULL, &to->left};
    if (to->left >= 0)
        excuse(made, TF_OUT_OF_RANGE);
    return &to->narrow_phase;
}

/// Those that tf_surface_candidates uses, too.
static void draw_usual_options(generator *random, call *made,
                               detect_options *options, pointed_to *to)
{
    tf_detect_options *own = &options->own;
    *own = (tf_detect_options){.context = &to->hearing};
    own->size = any_size(random, made, sizeof *own, options->later);
    own->parallel = any_parallel(random, made, &to->workers);
    own->progress = any_progress(random, made, &to->hearing);
    own->zone = draw_zones(random, options->zone);
}

static void draw_detect_options(generator *random, call *made,
                                detect_options *options, pointed_to *to)
{
    static const int bad[] = {-1, 3, INT_MAX, INT_MIN};
    tf_detect_options *own = &options->own;
    draw_usual_options(random, made, options, to);
    own->selection = (tf_contact_selection)below(random, 3);
    if (one_in(random, 16)) {
        own->selection = (tf_contact_selection)bad[below(random, COUNT(bad))];
        expect_fault(made, true, TF_BAD_OPTION);
    }
    own->arithmetic = one_in(random, 2) ? NULL : any_arithmetic(random);
    own->narrow_phase = any_narrow_phase(random, made, to);
}

/// Whether an arithmetic holds all positions of a step.
static bool step_is_held(const tf_arithmetic *arithmetic, const body *of,
                         const step *s)
{
    int axes = of->mesh.axes, numbers = body_numbers(of);
    return !arithmetic || (all_held(arithmetic, axes, numbers, s->start) &&
                           all_held(arithmetic, axes, numbers, s->end));
}

/// The group that some vertices have in common, or 0.
static int group_of(const body *of, int count, const int vertex[])
{
    int group = of->filter.group ? of->group[vertex[0]] : 0;
    for (int i = 1; i < count; i++)
        group = group == of->group[vertex[i]] ? group : 0;
    return group;
}

/// Whether the filter of a body lets a contact be.
static bool is_let_through(const body *of, const tf_surface_contact *contact)
{
    int first = contact->kind == TF_EDGE_EDGE ? 2 : 1;
    int second = contact->kind == TF_POINT_TRIANGLE ? 3 : 2;
    int group = group_of(of, first, contact->vertex);
    int other = group_of(of, second, contact->vertex + first);
    tf_element_pair pair = {.kind = contact->kind, .group = {group, other}};
    memcpy(pair.vertex, contact->vertex, sizeof pair.vertex);
    return (group == 0 || group != other) &&
           (!of->filter.wanted || of->filter.wanted(of->filter.context, &pair));
}

/// Requires that the contacts are those without a filter that it lets through.
static void judge_filter(const call *made, const body *of,
                         const tf_motion *motion, const tf_contacts *found)
{
    body whole = *of;
    whole.filter = (tf_pair_filter){0};
    tf_surface *other = body_copy(&whole);
    tf_contacts all;
    tf_status status = tf_surface_detect(other, motion, NULL, &all, NULL);
    require(made, status == TF_OK, "a new surface fails");
    size_t kept = 0;
    for (size_t i = 0; i < all.count; i++)
        if (is_let_through(of, &all.contact[i])) {
            require(made,
                    kept < found->count &&
                        memcmp(found->contact[kept].vertex,
                               all.contact[i].vertex,
                               sizeof all.contact[i].vertex) == 0,
                    "the filter lets other contacts through");
            kept++;
        }
    require(made, kept == found->count, "the filter keeps contacts back");
    tf_surface_free(other);
}

/// Detects again, by a new surface, in the plainest way.
static void judge_contacts(const call *made, const body *of,
                           const tf_motion *motion,
                           const tf_detect_options *options,
                           const tf_contacts *found)
{
    tf_detect_options plain = {.size = options->size ? sizeof plain : 0,
                               .narrow_phase = &tf_reference,
                               .selection = options->selection,
                               .arithmetic = options->arithmetic,
                               .zone = options->zone};
    tf_surface *other = body_copy(of);
    tf_contacts again;
    tf_status status = tf_surface_detect(other, motion, &plain, &again, NULL);
    require(made, status == TF_OK, "a new surface fails");
    require(made, hash_contacts(found) == hash_contacts(&again),
            "it finds other contacts than a new surface");
    tf_surface_free(other);
}

/// Judges the body, after some failures.
static void judge_after(generator *random, const call *made, body *of)
{
    if (one_in(random, 4))
        judge_body(made, of);
}

void call_detect(generator *random, body *of)
{
    static detect_options options;
    pointed_to to;
    step s;
    tf_contacts found;
    results set;
    call made = call_begin("tf_surface_detect");
    draw_step(random, &made, of, &s);
    tf_motion motion = draw_motion(random, &made, of, &s);
    draw_detect_options(random, &made, &options, &to);
    expect_fault(&made, !step_is_held(options.own.arithmetic, of, &s),
                 TF_OUT_OF_RANGE);
    bool usual = !made.faults && !options.own.arithmetic && one_in(random, 8);
    if (usual)
        options.own = (tf_detect_options){0};
    break_environment(random, &made);
    results_begin(random, &set, &found, sizeof found);
    tf_status status = tf_surface_detect(
        of->surface, &motion, usual ? NULL : &options.own, &found, &set.error);
    if (!results_judge(random, &made, &set, &to.hearing, status)) {
        judge_after(random, &made, of);
        return;
    }
    judge_contacts(&made, of, &motion, &options.own, &found);
    bool zoned = options.own.size != 0 && options.own.zone;
    if (options.own.selection == TF_ALL_CONTACTS && !options.own.arithmetic &&
        !zoned)
        judge_filter(&made, of, &motion, &found);
}

/// Lists again, by a new surface.
static void judge_candidates(const call *made, const body *of,
                             const tf_motion *motion,
                             const tf_detect_options *options,
                             const tf_candidates *found)
{
    tf_detect_options plain = {.size = options->size ? sizeof plain : 0,
                               .zone = options->zone};
    tf_surface *other = body_copy(of);
    tf_candidates again;
    tf_status status =
        tf_surface_candidates(other, motion, &plain, &again, NULL);
    require(made, status == TF_OK, "a new surface fails");
    require(made, hash_candidates(found) == hash_candidates(&again),
            "it finds other candidates than a new surface");
    tf_surface_free(other);
}

void call_candidates(generator *random, body *of)
{
    static detect_options options;
    pointed_to to;
    step s;
    tf_candidates found;
    results set;
    call made = call_begin("tf_surface_candidates");
    draw_step(random, &made, of, &s);
    tf_motion motion = draw_motion(random, &made, of, &s);
    draw_usual_options(random, &made, &options, &to);
    break_environment(random, &made);
    results_begin(random, &set, &found, sizeof found);
    tf_status status = tf_surface_candidates(of->surface, &motion, &options.own,
                                             &found, &set.error);
    if (results_judge(random, &made, &set, &to.hearing, status))
        judge_candidates(&made, of, &motion, &options.own, &found);
    else
        judge_after(random, &made, of);
}

// Checking --------------------------------------------------------------------

typedef struct check_options {
    tf_check_options own;
    unsigned char later[LATER];
} check_options;

static void draw_check_options(generator *random, call *made,
                               check_options *options, pointed_to *to)
{
    tf_check_options *own = &options->own;
    *own = (tf_check_options){.context = &to->hearing};
    own->size = any_size(random, made, sizeof *own, options->later);
    own->parallel = any_parallel(random, made, &to->workers);
    own->progress = any_progress(random, made, &to->hearing);
}

/// Checks again, by a new surface.
static void judge_crossings(const call *made, const body *of, const step *s,
                            const tf_crossings *found)
{
    tf_surface *other = body_copy(of);
    tf_crossings again;
    tf_status status =
        tf_surface_check(other, s->vertices, s->start, NULL, &again, NULL);
    require(made, status == TF_OK, "a new surface fails");
    require(made, hash_crossings(found) == hash_crossings(&again),
            "it finds other crossings than a new surface");
    tf_surface_free(other);
}

void call_check(generator *random, body *of)
{
    static check_options options;
    pointed_to to;
    step s;
    tf_crossings found;
    results set;
    call made = call_begin("tf_surface_check");
    draw_step(random, &made, of, &s);
    made.faults &= ~((status_set)1 << TF_NOT_FINITE); // as the end alone may be
    expect_fault(&made, !all_finite(body_numbers(of), s.start), TF_NOT_FINITE);
    draw_check_options(random, &made, &options, &to);
    break_environment(random, &made);
    results_begin(random, &set, &found, sizeof found);
    tf_status status = tf_surface_check(of->surface, s.vertices, s.start,
                                        &options.own, &found, &set.error);
    if (results_judge(random, &made, &set, &to.hearing, status))
        judge_crossings(&made, of, &s, &found);
    else
        judge_after(random, &made, of);
}

void call_lend(generator *random, body *of)
{
    int edges, triangles;
    call made = call_begin("tf_surface_edges");
    (void)random;
    const int *edge = tf_surface_edges(of->surface, &edges);
    const int *triangle = tf_surface_triangles(of->surface, &triangles);
    require(&made, tf_surface_axes(of->surface) == of->mesh.axes, "axes");
    require(&made, tf_surface_vertices(of->surface) == of->mesh.vertices,
            "vertices");
    for (int i = 0; i < 2 * edges; i++)
        require(&made, edge[i] >= 0 && edge[i] < of->mesh.vertices,
                "an edge of no vertex");
    for (int i = 0; i < 3 * triangles; i++)
        require(&made, triangle[i] >= 0 && triangle[i] < of->mesh.vertices,
                "a triangle of no vertex");
    require(&made, tf_surface_memory(of->surface) > 0, "it holds nothing");
}

// Responding ------------------------------------------------------------------

typedef struct response_options {
    tf_response_options own;
    unsigned char later[LATER];
    double friction[MOST_VERTICES]; ///< of each vertex
    int zone[MOST_FACETS];
} response_options;

static bool is_within(double x, double least, double most)
{
    return x >= least && x <= most;
}

static size_t no_numbers(int axes, int vertices, int constraints)
{
    (void)axes;
    (void)vertices;
    (void)constraints;
    return 0;
}

/// As bad as a solver can be: impulses of any size that depend on the zone, and
/// one time of four displacements that overflow.
static int solve_wildly(tf_zone *zone)
{
    double impulse[4 * MOST_VERTICES * MOST_VERTICES];
    generator random = {(uint64_t)zone->constraints};
    int most = COUNT(impulse);
    for (int i = 0; i < zone->constraints && i < most; i++)
        zone->constraint[i].impulse = impulse[i] = uniform(&random, 0, 1e3);
    if (!tf_zone_goes_on(zone, 1))
        return 0;
    if (zone->constraints <= most)
        tf_zone_push(zone, impulse, zone->displacement);
    if (zone->constraints % 4 == 0)
        zone->displacement[0] = any_double(&random);
    return 1;
}

static const tf_zone_solver wild_solver = {"wild", no_numbers, solve_wildly};

static int any_rounds(generator *random)
{
    static const int rounds[] = {0, 0, 0, 1, 2, 5, -1, INT_MIN};
    return rounds[below(random, COUNT(rounds))];
}

/// Those of the numbers, of which tf_step_limit uses none.
static void draw_response(generator *random, call *made,
                          tf_response_options *own)
{
    const tf_zone_solver *const solver[] = {
        NULL,       &tf_gauss_seidel,     &tf_conjugate_residuals,
        &tf_minres, &tf_normal_residuals, &wild_solver};
    const double most = 1.7976931348623157e308;
    own->solver = solver[below(random, COUNT(solver))];
    own->impulse_rounds = any_rounds(random);
    own->zone_rounds = any_rounds(random);
    own->sweeps = any_rounds(random);
    own->rigid = one_in(random, 2);
    own->separation = any_option(random, 1);
    own->restitution = any_option(random, 1);
    own->friction = any_option(random, 2);
    bool reads = own->size != 0;
    // Younger than 1.0:
    own->restitution_threshold = any_option(random, 1);
    own->substeps = any_rounds(random);
    own->thickness = any_option(random, 1);
    own->draft = one_in(random, 4);
    own->again = one_in(random, 2);
    int most_parts = own->draft ? 1 : INT_MAX;
    expect_fault(
        made,
        own->sweeps < 0 || !is_within(own->separation, -most, most) ||
            !is_within(own->restitution, 0, 1) ||
            !is_within(own->friction, 0, most) ||
            (reads && (!is_within(own->restitution_threshold, 0, most) ||
                       !is_within(own->thickness, 0, most) ||
                       own->substeps < 0 || own->substeps > most_parts)),
        TF_BAD_OPTION);
}

/// Draws the friction of each vertex, or none.
static void draw_friction(generator *random, call *made, const body *of,
                          response_options *options)
{
    if (one_in(random, 2))
        return;
    bool good = true;
    for (int v = 0; v < MOST_VERTICES; v++) {
        double *own = &options->friction[v];
        *own = one_in(random, 4) ? 0 : uniform(random, 0, 2);
        if (one_in(random, 100))
            *own = any_double(random);
        good &= v >= of->mesh.vertices || (*own >= 0 && all_finite(1, own));
    }
    options->own.vertex_friction = options->friction;
    expect_fault(made, options->own.size != 0 && !good, TF_BAD_OPTION);
}

static void draw_response_options(generator *random, call *made,
                                  response_options *options, pointed_to *to)
{
    tf_response_options *own = &options->own;
    *own = (tf_response_options){.context = &to->hearing};
    own->size = any_size(random, made, sizeof *own, options->later);
    own->check_start = one_in(random, 2);
    own->narrow_phase = any_narrow_phase(random, made, to);
    own->parallel = any_parallel(random, made, &to->workers);
    own->progress = any_progress(random, made, &to->hearing);
    own->zone = draw_zones(random, options->zone);
    excuse(made, TF_START_NOT_CLEAR);
}

/// Draws inverse masses, or none.
static const double *draw_masses(generator *random, call *made, int vertices,
                                 double inverse_mass[])
{
    if (one_in(random, 4))
        return NULL;
    bool good = true;
    for (int v = 0; v < MOST_VERTICES; v++) {
        inverse_mass[v] = one_in(random, 4) ? 0 : uniform(random, 0, 2);
        if (one_in(random, 100))
            inverse_mass[v] = any_double(random);
        double m = inverse_mass[v];
        good &= v >= vertices || (m >= 0 && all_finite(1, &m));
    }
    expect_fault(made, !good, TF_BAD_MASS);
    return inverse_mass;
}

static bool has_free_vertex(const int vertex[4], const double inverse_mass[])
{
    bool any = !inverse_mass;
    for (int i = 0; i < 4 && vertex[i] >= 0 && !any; i++)
        any = inverse_mass[vertex[i]] > 0;
    return any;
}

/// Whether a step is clear, as a new surface sees it, but for what is scripted
/// and what is in zones.
static void judge_clear(const call *made, const body *of, const double start[],
                        const double end[], const double inverse_mass[],
                        const tf_response_options *options)
{
    tf_motion motion = {of->mesh.axes, of->mesh.vertices, start, end};
    tf_detect_options plain = {.size = options->size ? sizeof plain : 0,
                               .zone = options->zone};
    tf_contacts found;
    tf_surface *other = body_copy(of);
    tf_status status = tf_surface_detect(other, &motion, &plain, &found, NULL);
    require(made, status == TF_OK, "the end cannot be detected");
    for (size_t i = 0; i < found.count; i++)
        require(made, !has_free_vertex(found.contact[i].vertex, inverse_mass),
                "the step is not clear");
    tf_surface_free(other);
}

/// Requires that scripted vertices end where they should, but for those that
/// the report counts.
static void judge_scripted(const call *made, const body *of, const step *s,
                           const double inverse_mass[], const double end[],
                           const tf_response_report *report)
{
    int axes = of->mesh.axes, other = 0;
    for (int v = 0; v < of->mesh.vertices && inverse_mass; v++)
        other +=
            inverse_mass[v] == 0 && memcmp(end + axes * v, s->end + axes * v,
                                           sizeof *end * (size_t)axes) != 0;
    require(made, report->held == other, "other vertices were held back");
}

/// Requires that the flags of the vertices tell which have moved.
static void judge_flags(const call *made, const body *of, const step *s,
                        const double inverse_mass[], const double end[])
{
    const unsigned char *flags = tf_resolver_vertices(of->resolver);
    int axes = of->mesh.axes;
    for (int v = 0; v < of->mesh.vertices; v++) {
        bool moved = memcmp(end + axes * v, s->end + axes * v,
                            sizeof *end * (size_t)axes) != 0;
        bool held = moved && inverse_mass && inverse_mass[v] == 0;
        require(made, ((flags[v] & TF_VERTEX_MOVED) != 0) == moved,
                "a flag does not tell whether a vertex has moved");
        require(made, ((flags[v] & TF_VERTEX_HELD) != 0) == held,
                "a flag does not tell whether a vertex was held");
    }
}

static bool are_vertices(const body *of, int count, const int vertex[])
{
    for (int i = 0; i < count; i++)
        if (vertex[i] < 0 || vertex[i] >= of->mesh.vertices)
            return false;
    return true;
}

static void judge_answer(const call *made, const body *of,
                         const tf_answered_contact *answer)
{
    int vertices = answer->kind == TF_POINT_EDGE ? 3 : 4;
    require(made, answer->kind >= TF_POINT_EDGE && answer->kind <= TF_EDGE_EDGE,
            "an answer is about no kind of pair");
    require(made, are_vertices(of, vertices, answer->vertex),
            "an answer is about no vertices");
    require(made,
            answer->level >= 0 && answer->level <= TF_FAILSAFE &&
                answer->round >= 0 && answer->reserved == 0,
            "an answer is of no round");
    require(made, answer->toi >= 0 && answer->toi <= 1,
            "an answer is not in the step");
}

/// Asks for the pushes of the contacts that were answered, and for the motion.
static const double *ask_pushes(tf_resolver *resolver, size_t contacts)
{
    size_t count;
    const double *push, *unpushed = tf_resolver_unpushed(resolver);
    call made = call_begin("tf_resolver_pushes");
    require(&made, tf_resolver_pushes(resolver, &count, &push) == TF_OK,
            "it fails where the contacts are listed");
    require(&made, count == contacts, "other pushes than contacts");
    require(&made, !unpushed == !tf_resolver_vertices(resolver),
            "there is a motion without flags, or flags without a motion");
    require(&made, !unpushed == !tf_resolver_followed(resolver),
            "there is a motion without fractions, or vice versa");
    return push;
}

/// Asks for the contacts that were answered; returns a number that depends on
/// them all.
static uint64_t judge_answers(generator *random, const call *resolved,
                              const body *of, tf_resolver *resolver)
{
    size_t count;
    const tf_answered_contact *contact;
    call made = call_begin("tf_resolver_contacts");
    mark(&count, sizeof count);
    mark(&contact, sizeof contact);
    allocator_fail(random);
    tf_status status = tf_resolver_contacts(resolver, &count, &contact);
    end_trouble(&made);
    if (!judge_status(&made, status)) {
        judge_unset(&made, &count, sizeof count);
        judge_unset(&made, &contact, sizeof contact);
        status = tf_resolver_contacts(resolver, &count, &contact);
        require(&made, status == TF_OK, "it fails twice");
    }
    for (size_t i = 0; i < count; i++)
        judge_answer(resolved, of, &contact[i]);
    return hash_answers(count, contact, ask_pushes(resolver, count));
}

/// Resolves again by new objects, on one thread.
static void judge_again(generator *random, const call *made, const body *of,
                        const step *s, const double inverse_mass[],
                        const tf_response_options *options, const double end[],
                        const tf_response_report *report)
{
    tf_response_options plain = *options;
    plain.parallel = NULL;
    plain.progress = NULL;
    plain.size = options->size ? sizeof plain : 0;
    plain.narrow_phase = &tf_reference;
    double other_end[NUMBERS];
    memcpy(other_end, s->end, sizeof other_end);
    tf_surface *other = body_copy(of);
    tf_resolver *resolver;
    const tf_response_report *other_report;
    require(made, tf_resolver_create(other, &resolver) == TF_OK, "no memory");
    tf_status status =
        tf_step_resolve(resolver, s->vertices, s->start, other_end,
                        inverse_mass, &plain, &other_report, NULL);
    require(made, status == TF_OK, "a new resolver fails");
    require(made,
            memcmp(end, other_end, sizeof *end * (size_t)body_numbers(of)) == 0,
            "it ends otherwise than by a new resolver");
    require(made, hash_report(report) == hash_report(other_report),
            "it reports otherwise than a new resolver");
    require(made,
            judge_answers(random, made, of, of->resolver) ==
                judge_answers(random, made, of, resolver),
            "a new resolver has answered other contacts");
    tf_resolver_free(resolver);
    tf_surface_free(other);
}

void call_resolve(generator *random, body *of)
{
    static response_options options;
    pointed_to to;
    step s;
    double masses[MOST_VERTICES], end[NUMBERS];
    const tf_response_report *report;
    results set;
    need_resolver(of);
    call made = call_begin("tf_step_resolve");
    draw_step(random, &made, of, &s);
    draw_response_options(random, &made, &options, &to);
    draw_response(random, &made, &options.own);
    draw_friction(random, &made, of, &options);
    const double *inverse_mass =
        draw_masses(random, &made, of->mesh.vertices, masses);
    memcpy(end, s.end, sizeof end);
    break_environment(random, &made);
    results_begin(random, &set, &report, sizeof report);
    tf_status status =
        tf_step_resolve(of->resolver, s.vertices, s.start, end, inverse_mass,
                        &options.own, &report, &set.error);
    if (!results_judge(random, &made, &set, &to.hearing, status)) {
        require(&made, memcmp(end, s.end, sizeof end) == 0, "the end is set");
        judge_after(random, &made, of);
        return;
    }
    bool reads = options.own.size != 0;
    bool in_parts = reads && options.own.substeps > 1;
    if (!(reads && options.own.draft))
        judge_clear(&made, of, in_parts ? end : s.start, end, inverse_mass,
                    &options.own);
    judge_scripted(&made, of, &s, inverse_mass, end, report);
    judge_flags(&made, of, &s, inverse_mass, end);
    if (!(reads && options.own.again))
        judge_again(random, &made, of, &s, inverse_mass, &options.own, end,
                    report);
}

void call_limit(generator *random, body *of)
{
    static response_options options;
    pointed_to to;
    step s;
    double end[NUMBERS];
    int halvings;
    results set;
    need_resolver(of);
    call made = call_begin("tf_step_limit");
    draw_step(random, &made, of, &s);
    draw_response_options(random, &made, &options, &to);
    memcpy(end, s.end, sizeof end);
    break_environment(random, &made);
    results_begin(random, &set, &halvings, sizeof halvings);
    tf_status status = tf_step_limit(of->resolver, s.vertices, s.start, end,
                                     &options.own, &halvings, &set.error);
    bool whole = memcmp(end, s.end, sizeof end) == 0;
    if (!results_judge(random, &made, &set, &to.hearing, status)) {
        require(&made, whole, "the end is set");
        judge_after(random, &made, of);
        return;
    }
    require(&made, halvings >= -1, "the halvings");
    require(&made,
            !tf_resolver_vertices(of->resolver) &&
                judge_answers(random, &made, of, of->resolver) ==
                    hash_answers(0, NULL, NULL),
            "it has resolved nothing, and tells what it did");
    require(&made, halvings != 0 || whole, "a step that is clear is changed");
    judge_clear(&made, of, s.start, end, NULL, &options.own);
}

// Untangling ------------------------------------------------------------------

typedef struct untangle_options {
    tf_untangle_options own;
    unsigned char later[LATER];
    bool fixed[MOST_VERTICES];
} untangle_options;

static void draw_untangle_options(generator *random, call *made,
                                  untangle_options *options, pointed_to *to)
{
    static const int bad[] = {-1, 64, INT_MAX, INT_MIN};
    tf_untangle_options *own = &options->own;
    *own = (tf_untangle_options){.context = &to->hearing};
    own->size = any_size(random, made, sizeof *own, options->later);
    own->parallel = any_parallel(random, made, &to->workers);
    own->progress = any_progress(random, made, &to->hearing);
    own->rounds = 1 + below(random, 9);
    own->without = below(random, 64) | TF_RUNG_RELAX;
    for (int v = 0; v < MOST_VERTICES; v++)
        options->fixed[v] = one_in(random, 3);
    own->fixed = one_in(random, 2) ? options->fixed : NULL;
    if (one_in(random, 16)) {
        own->without = bad[below(random, COUNT(bad))];
        expect_fault(made, true, TF_BAD_OPTION);
    }
}

/// Checks the output by a new surface.
static void judge_untangled(const call *made, const body *of,
                            const untangle_options *options, const step *s,
                            const double out[],
                            const tf_untangle_report *report)
{
    tf_surface *other = body_copy(of);
    tf_crossings found;
    size_t axes = (size_t)of->mesh.axes;
    tf_status status =
        tf_surface_check(other, s->vertices, out, NULL, &found, NULL);
    require(made, status == TF_OK, "the output is bad");
    require(made, found.count == report->left, "other crossings are left");
    require(made, report->left <= report->before, "more than before are left");
    for (int v = 0; v < s->vertices && options->own.fixed; v++)
        require(made,
                !options->own.fixed[v] ||
                    memcmp(out + axes * (size_t)v, s->start + axes * (size_t)v,
                           axes * sizeof *out) == 0,
                "a fixed vertex has moved");
    tf_surface_free(other);
}

void call_untangle(generator *random, body *of)
{
    static untangle_options options;
    pointed_to to;
    step s;
    double out[NUMBERS];
    tf_untangle_report report;
    results set;
    need_resolver(of);
    call made = call_begin("tf_untangle");
    draw_step(random, &made, of, &s);
    made.faults &= ~((status_set)1 << TF_NOT_FINITE); // as the end alone may be
    expect_fault(&made, !all_finite(body_numbers(of), s.start), TF_NOT_FINITE);
    draw_untangle_options(random, &made, &options, &to);
    memcpy(out, s.end, sizeof out);
    break_environment(random, &made);
    results_begin(random, &set, &report, sizeof report);
    tf_status status = tf_untangle(of->resolver, s.vertices, s.start, out,
                                   &options.own, &report, NULL, &set.error);
    if (results_judge(random, &made, &set, &to.hearing, status)) {
        judge_untangled(&made, of, &options, &s, out, &report);
        return;
    }
    require(&made, memcmp(out, s.end, sizeof out) == 0, "the output is set");
    judge_after(random, &made, of);
}

// Zones -----------------------------------------------------------------------

/// Finds them again by a new surface, and checks the start that they allow.
static void judge_zones(const call *made, const body *of, const step *s,
                        int rings, const int zone[], int zones)
{
    int again[MOST_FACETS], count, facets = body_facets(of);
    tf_surface *other = body_copy(of);
    tf_status status = tf_surface_zones(other, s->vertices, s->start, rings,
                                        NULL, again, &count, NULL, NULL);
    require(made, status == TF_OK, "a new surface fails");
    require(made,
            count == zones &&
                memcmp(zone, again, sizeof *zone * (size_t)facets) == 0,
            "it finds other zones than a new surface");
    for (int i = 0, seen = 0; i < facets; i++) {
        require(made, zone[i] >= -1 && zone[i] <= seen && zone[i] < zones,
                "zones are not numbered in order");
        seen += zone[i] == seen;
    }
    tf_surface_free(other);
}

void call_zones(generator *random, body *of)
{
    static check_options options;
    pointed_to to;
    step s;
    tf_crossings found;
    results set;
    int zone[MOST_FACETS], zones, rings = below(random, 4) - one_in(random, 8);
    call made = call_begin("tf_surface_zones");
    draw_step(random, &made, of, &s);
    made.faults &= ~((status_set)1 << TF_NOT_FINITE); // as the end alone may be
    expect_fault(&made, !all_finite(body_numbers(of), s.start), TF_NOT_FINITE);
    draw_check_options(random, &made, &options, &to);
    expect_fault(&made, rings < 0, TF_BAD_OPTION);
    break_environment(random, &made);
    results_begin(random, &set, &found, sizeof found);
    tf_status status =
        tf_surface_zones(of->surface, s.vertices, s.start, rings, &options.own,
                         zone, &zones, &found, &set.error);
    if (results_judge(random, &made, &set, &to.hearing, status))
        judge_zones(&made, of, &s, rings, zone, zones);
    else
        judge_after(random, &made, of);
}
