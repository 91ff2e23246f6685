#include "queries.h"

#include "arguments.h"

#include <limits.h>
#include <math.h>
#include <string.h>

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))

enum {
    VERTICES = 8
};

// A scene of a few vertices, and elements of it -------------------------------

typedef struct scene {
    tf_motion motion;
    double start[3 * VERTICES], end[3 * VERTICES];
    tf_kind kind;
    int vertex[4];
} scene;

static int kind_axes(tf_kind kind)
{
    return kind == TF_POINT_EDGE ? 2 : 3;
}

static int kind_vertices(tf_kind kind)
{
    return kind == TF_POINT_EDGE ? 3 : 4;
}

/// A few times one that no vertex has, or that another one has.
static void draw_indices(generator *random, int vertices, int count,
                         int index[])
{
    for (int i = 0; i < count; i++)
        index[i] = (i + below(random, vertices)) % vertices;
    for (int i = 0; i < count; i++)
        for (int j = 0; j < i; j++)
            if (index[i] == index[j] && !one_in(random, 16))
                index[i] = (index[i] + 1) % vertices, j = -1;
    if (one_in(random, 16))
        index[below(random, count)] =
            one_in(random, 2) ? vertices : wrong_number(random, 0);
}

static bool are_good(int vertices, int count, const int index[])
{
    for (int i = 0; i < count; i++) {
        if (index[i] < 0 || index[i] >= vertices)
            return false;
        for (int j = 0; j < i; j++)
            if (index[i] == index[j])
                return false;
    }
    return true;
}

/// The motion of these positions, one time of eight with something that must be
/// seen before they are read.
static void draw_motion(generator *random, call *made, int axes,
                        const double start[], const double end[],
                        tf_motion *motion)
{
    *motion = (tf_motion){axes, VERTICES, start, end};
    if (!one_in(random, 8))
        return;
    int fault = below(random, 4);
    if (fault == 0)
        motion->axes = wrong_number(random, axes);
    if (fault == 1)
        motion->vertices = one_in(random, 2) ? -1 : INT_MIN;
    if (fault == 2)
        motion->start = NULL;
    if (fault == 3)
        motion->end = NULL;
    expect_fault(made, fault == 0, TF_BAD_AXES);
    expect_fault(made, fault != 0, TF_BAD_COUNT);
}

/// The coordinates of the vertices of a query, if it names vertices.
static int gather(const scene *s, double x[])
{
    int axes = kind_axes(s->kind), count = 0;
    for (int i = 0; i < kind_vertices(s->kind); i++)
        for (int k = 0; k < axes; k++) {
            x[count++] = s->start[axes * s->vertex[i] + k];
            x[count++] = s->end[axes * s->vertex[i] + k];
        }
    return count;
}

/// Draws what a query is about; without an arithmetic, all doubles are good.
static void draw_scene(generator *random, call *made,
                       const tf_arithmetic *arithmetic, scene *s)
{
    double x[24];
    s->kind = (tf_kind)(1 + below(random, 3));
    int axes = kind_axes(s->kind);
    draw_coordinates(random, axes * VERTICES, s->start);
    draw_coordinates(random, axes * VERTICES, s->end);
    draw_motion(random, made, axes, s->start, s->end, &s->motion);
    draw_indices(random, VERTICES, kind_vertices(s->kind), s->vertex);
    if (!are_good(VERTICES, kind_vertices(s->kind), s->vertex)) {
        expect_fault(made, true, TF_BAD_INDEX);
        return;
    }
    int count = gather(s, x);
    expect_fault(made, !all_finite(count, x), TF_NOT_FINITE);
    expect_fault(made, arithmetic && !all_held(arithmetic, axes, count, x),
                 TF_OUT_OF_RANGE);
}

// What a contact must be ------------------------------------------------------

static bool are_weights(const double weight[3])
{
    double sum = weight[0] + weight[1] + weight[2];
    return weight[0] >= 0 && weight[1] >= 0 && weight[2] >= 0 &&
           fabs(sum - 1) < 1e-9;
}

static bool is_unit_or_zero(const double x[3])
{
    double square = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
    return square == 0 || fabs(square - 1) < 1e-9;
}

static void judge_contact(const call *made, const tf_contact *contact)
{
    require(made, contact->verdict >= 0 && contact->verdict <= TF_HIT,
            "it has no verdict");
    if (contact->verdict == TF_APART)
        return;
    require(made,
            contact->toi_lo >= 0 && contact->toi_lo <= contact->toi_hi &&
                contact->toi_hi <= 1,
            "the bounds of the time are not in the step");
    require(made,
            are_weights(contact->barycentric[0]) &&
                are_weights(contact->barycentric[1]),
            "barycentric coordinates don't add up to 1");
    require(made, is_unit_or_zero(contact->normal),
            "the normal has another length than 1");
    require(made, isfinite(contact->normal_velocity),
            "a normal velocity is not finite");
}

static void judge_exact_contact(const call *made,
                                const tf_arithmetic *arithmetic,
                                const tf_contact *contact)
{
    judge_contact(made, contact);
    if (arithmetic == &tf_clamped || arithmetic == &tf_published)
        return;
    require(made, contact->verdict != TF_UNDECIDED,
            "an exact verdict is undecided");
    require(made, contact->toi_hi - contact->toi_lo <= 0x1p-50,
            "the bounds of an exact time are far apart");
}

// Queries ---------------------------------------------------------------------

static tf_status ask(const tf_arithmetic *arithmetic, const scene *s,
                     tf_contact *contact)
{
    const int *v = s->vertex;
    if (s->kind == TF_POINT_EDGE)
        return tf_point_edge(arithmetic, &s->motion, v[0], v + 1, contact);
    if (s->kind == TF_POINT_TRIANGLE)
        return tf_point_triangle(arithmetic, &s->motion, v[0], v + 1, contact);
    return tf_edge_edge(arithmetic, &s->motion, v, v + 2, contact);
}

void call_query(generator *random)
{
    scene s;
    tf_contact contact;
    call made = call_begin("a query");
    const tf_arithmetic *arithmetic = any_arithmetic(random);
    draw_scene(random, &made, arithmetic, &s);
    mark(&contact, sizeof contact);
    break_environment(random, &made);
    tf_status status = ask(arithmetic, &s, &contact);
    end_trouble(&made);
    if (judge_status(&made, status))
        judge_exact_contact(&made, arithmetic, &contact);
    else
        judge_unset(&made, &contact, sizeof contact);
}

static bool is_from_zero(double x)
{
    return x >= 0 && isfinite(x);
}

/// Limits of an advancement that ends soon.
static tf_advance_limits any_limits(generator *random, call *made)
{
    tf_advance_limits limits = {any_option(random, 1), any_option(random, 0.5),
                                1 + below(random, 50)};
    if (one_in(random, 16))
        limits.steps = one_in(random, 2) ? -1 : INT_MIN;
    expect_fault(made,
                 !is_from_zero(limits.threshold) || !(limits.fraction >= 0) ||
                     !(limits.fraction < 1) || limits.steps < 0,
                 TF_BAD_OPTION);
    return limits;
}

static void judge_advancement(const call *made, tf_verdict verdict,
                              const tf_advancement *advancement)
{
    require(made, advancement->verdict == verdict, "there are two verdicts");
    require(made, advancement->time >= 0 && advancement->time <= 1,
            "the time is not in the step");
    require(made, advancement->steps >= 0, "the steps are negative");
    require(made,
            are_weights(advancement->barycentric[0]) &&
                are_weights(advancement->barycentric[1]),
            "barycentric coordinates don't add up to 1");
}

static tf_status ask_rounded(const tf_tolerances *tolerances, const scene *s,
                             tf_contact *contact)
{
    const int *v = s->vertex;
    if (s->kind == TF_POINT_EDGE)
        return tf_quadratic_point_edge(tolerances, &s->motion, v[0], v + 1,
                                       contact);
    if (s->kind == TF_POINT_TRIANGLE)
        return tf_cubic_point_triangle(tolerances, &s->motion, v[0], v + 1,
                                       contact);
    return tf_cubic_edge_edge(tolerances, &s->motion, v, v + 2, contact);
}

static tf_status ask_advancing(const tf_advance_limits *limits, const scene *s,
                               tf_contact *contact, tf_advancement *advancement)
{
    const int *v = s->vertex;
    if (s->kind == TF_POINT_EDGE)
        return tf_additive_point_edge(limits, &s->motion, v[0], v + 1, contact,
                                      advancement);
    if (s->kind == TF_POINT_TRIANGLE)
        return tf_additive_point_triangle(limits, &s->motion, v[0], v + 1,
                                          contact, advancement);
    return tf_additive_edge_edge(limits, &s->motion, v, v + 2, contact,
                                 advancement);
}

void call_linear_query(generator *random)
{
    scene s;
    tf_contact contact;
    tf_advancement advancement;
    bool advances = one_in(random, 2), wanted = one_in(random, 2);
    call made = call_begin("a query of linear motion");
    draw_scene(random, &made, NULL, &s);
    tf_tolerances tolerances = {any_option(random, 1), any_option(random, 1)};
    tf_advance_limits limits = {0};
    if (advances)
        limits = any_limits(random, &made);
    else
        expect_fault(&made,
                     !is_from_zero(tolerances.distance) ||
                         !is_from_zero(tolerances.barycentric),
                     TF_BAD_OPTION);
    mark(&contact, sizeof contact);
    mark(&advancement, sizeof advancement);
    break_environment(random, &made);
    tf_status status = advances ? ask_advancing(&limits, &s, &contact,
                                                wanted ? &advancement : NULL)
                                : ask_rounded(&tolerances, &s, &contact);
    end_trouble(&made);
    if (judge_status(&made, status))
        judge_contact(&made, &contact);
    else
        judge_unset(&made, &contact, sizeof contact);
    if (status == TF_OK && advances && wanted)
        judge_advancement(&made, contact.verdict, &advancement);
    else
        judge_unset(&made, &advancement, sizeof advancement);
}

// Rigid elements --------------------------------------------------------------

typedef struct rigid_element {
    tf_rigid_body body;
    double vertices[9];
} rigid_element;

static void draw_rigid(generator *random, call *made, int axes, int vertices,
                       rigid_element *element)
{
    tf_rigid_body *body = &element->body;
    draw_coordinates(random, 9, element->vertices);
    draw_coordinates(random, 3, body->center);
    draw_coordinates(random, 3, body->velocity);
    draw_coordinates(random, 3, body->rotation);
    body->vertices = element->vertices;
    expect_fault(made,
                 !all_finite(axes * vertices, element->vertices) ||
                     !all_finite(axes, body->center) ||
                     !all_finite(axes, body->velocity) ||
                     !all_finite(axes == 2 ? 1 : 3,
                                 body->rotation + (axes == 2 ? 2 : 0)),
                 TF_NOT_FINITE);
}

void call_rigid_advance(generator *random)
{
    rigid_element first, second;
    tf_advancement advancement;
    bool space = one_in(random, 2);
    call made = call_begin("the advancement of rigid elements");
    draw_rigid(random, &made, space ? 3 : 2, space ? 3 : 1, &first);
    draw_rigid(random, &made, space ? 3 : 2, space ? 3 : 2, &second);
    tf_advance_limits limits = any_limits(random, &made);
    mark(&advancement, sizeof advancement);
    break_environment(random, &made);
    tf_status status = (space ? tf_advance_triangles : tf_advance_point_edge)(
        &limits, &first.body, &second.body, &advancement);
    end_trouble(&made);
    if (judge_status(&made, status))
        judge_advancement(&made, advancement.verdict, &advancement);
    else
        judge_unset(&made, &advancement, sizeof advancement);
}

// Many queries ----------------------------------------------------------------

enum {
    QUERIES = 140 ///< more than two masks
};

typedef struct verdicts {
    tf_status status;
    tf_verdict verdict[QUERIES];
    size_t separated;
} verdicts;

static void decide(const tf_narrow_phase *narrow_phase,
                   const tf_arithmetic *arithmetic, const tf_queries *queries,
                   verdicts *decided)
{
    mark(decided->verdict, sizeof decided->verdict);
    decided->separated = 0;
    decided->status =
        narrow_phase->decide(narrow_phase->context, arithmetic, queries,
                             decided->verdict, &decided->separated);
}

static void draw_queries(generator *random, const scene *s, tf_queries *queries,
                         int vertex[])
{
    queries->kind = s->kind;
    queries->motion = &s->motion;
    queries->count = (size_t)below(random, one_in(random, 2) ? 4 : QUERIES);
    queries->vertices = vertex;
    int count = kind_vertices(s->kind);
    for (size_t i = 0; i < queries->count; i++, vertex += count) {
        draw_indices(random, VERTICES, count, vertex);
        if (!are_good(VERTICES, count, vertex) && !one_in(random, 16))
            memcpy(vertex, s->vertex, sizeof *vertex * (size_t)count);
    }
    if (one_in(random, 16))
        queries->kind = (tf_kind)wrong_number(random, TF_EDGE_EDGE);
}

static bool is_kind(tf_kind kind)
{
    return kind >= TF_POINT_EDGE && kind <= TF_EDGE_EDGE;
}

/// With a wrong kind, nothing else is looked at.
static bool judge_kind(const call *made, const tf_queries *queries,
                       const verdicts *decided)
{
    require(made, (decided->status == TF_BAD_OPTION) == !is_kind(queries->kind),
            "a kind that there is not");
    return is_kind(queries->kind);
}

/// What one query after another says.
static void judge_one_by_one(const call *made, const tf_arithmetic *arithmetic,
                             const scene *all, const tf_queries *queries,
                             const verdicts *decided)
{
    scene s = *all;
    s.kind = queries->kind;
    int count = kind_vertices(s.kind);
    size_t i = 0;
    for (; i < queries->count; i++) {
        tf_contact contact;
        memcpy(s.vertex, queries->vertices + (size_t)count * i,
               sizeof *s.vertex * (size_t)count);
        tf_status status = ask(arithmetic, &s, &contact);
        if (status != TF_OK) {
            require(made, decided->status == status, "another status");
            break;
        }
        require(made, decided->verdict[i] == contact.verdict,
                "another verdict");
    }
    require(made, i < queries->count || decided->status == TF_OK,
            "a status of no query");
    judge_unset(made, decided->verdict + i,
                sizeof *decided->verdict * (QUERIES - i));
}

void call_narrow_phase(generator *random)
{
    static verdicts by_one, by_lanes;
    static int vertex[4 * QUERIES];
    scene s;
    tf_queries queries;
    call made = call_begin("a narrow phase");
    const tf_arithmetic *arithmetic = any_arithmetic(random);
    draw_scene(random, &made, arithmetic, &s);
    draw_queries(random, &s, &queries, vertex);
    decide(&tf_reference, arithmetic, &queries, &by_one);
    decide(&tf_vectorized, arithmetic, &queries, &by_lanes);
    require(&made, by_one.status == by_lanes.status,
            "two narrow phases have two statuses");
    require(&made,
            memcmp(by_one.verdict, by_lanes.verdict, sizeof by_one.verdict) ==
                0,
            "two narrow phases have two verdicts");
    require(&made,
            by_one.status != TF_OK || by_one.separated == by_lanes.separated,
            "two narrow phases separate by axes in two ways");
    if (judge_kind(&made, &queries, &by_one))
        judge_one_by_one(&made, arithmetic, &s, &queries, &by_one);
}

/// Requires the answers of one query after another, or the first one's status.
static void judge_answers(const call *made, const tf_arithmetic *arithmetic,
                          const scene *all, const tf_queries *queries,
                          const tf_contact contact[], const tf_error *error)
{
    scene s = *all;
    int count = kind_vertices(s.kind = queries->kind);
    for (size_t i = 0; i < queries->count; i++) {
        tf_contact alone = {0};
        memcpy(s.vertex, queries->vertices + (size_t)count * i,
               sizeof *s.vertex * (size_t)count);
        tf_status status = ask(arithmetic, &s, &alone);
        if (status != TF_OK) {
            require(made, error->status == status, "another status");
            require(made, error->subject != TF_BATCH_QUERY || error->index == i,
                    "another query");
            return;
        }
        require(made,
                error->status != TF_OK ||
                    memcmp(&alone, &contact[i], sizeof alone) == 0,
                "another answer");
    }
    require(made, error->status == TF_OK, "a status of no query");
}

void call_batch(generator *random)
{
    static tf_contact contact[QUERIES];
    static int vertex[4 * QUERIES];
    scene s;
    tf_queries queries;
    crew workers;
    tf_error error;
    call scene_made = call_begin("a batch"), made = scene_made;
    const tf_arithmetic *arithmetic = any_arithmetic(random);
    draw_scene(random, &scene_made, arithmetic, &s);
    draw_queries(random, &s, &queries, vertex);
    const tf_parallel *parallel = any_parallel(random, &made, &workers);
    expect_fault(&made, !is_kind(queries.kind), TF_BAD_OPTION);
    bool asks = !made.faults;
    mark(&error, sizeof error);
    tf_status status = tf_query_batch(
        arithmetic == &tf_exact && one_in(random, 2) ? NULL : arithmetic,
        &queries, parallel, contact, &error);
    judge_error(&made, status, &error, random);
    if (asks)
        judge_answers(&made, arithmetic, &s, &queries, contact, &error);
    else
        judge_status(&made, status);
}

// Filters ---------------------------------------------------------------------

enum {
    BLOCKS = 17 ///< more than two masks
};

/// Requires the verdict of tf_exact about one query, where it is certain.
static void judge_lane(const call *made, bool triangle,
                       const tf_query_block *block, int lane,
                       const tf_query_masks *masks, uint64_t bit)
{
    scene s = {.kind = triangle ? TF_POINT_TRIANGLE : TF_EDGE_EDGE,
               .motion = {3, 4, s.start, s.end},
               .vertex = {0, 1, 2, 3}};
    for (int v = 0; v < 4; v++)
        for (int k = 0; k < 3; k++) {
            s.start[3 * v + k] = block->at[0][v][k][lane];
            s.end[3 * v + k] = block->at[1][v][k][lane];
        }
    tf_contact contact;
    tf_status status = ask(&tf_exact, &s, &contact);
    tf_verdict verdict = masks->hit & bit     ? TF_HIT
                         : masks->apart & bit ? TF_APART
                                              : TF_UNDECIDED;
    require(made,
            verdict == TF_UNDECIDED ||
                (status == TF_OK && contact.verdict == verdict),
            "the filter is certain of what is wrong");
}

static void judge_masks(const call *made, size_t count,
                        const tf_query_masks masks[])
{
    for (size_t i = 0; i * TF_MASK_QUERIES < count; i++) {
        size_t left = count - i * TF_MASK_QUERIES;
        uint64_t all = left < 64 ? (UINT64_C(1) << left) - 1 : ~UINT64_C(0);
        const tf_query_masks *m = &masks[i];
        require(made, (m->apart | m->hit | m->undecided) == all,
                "the masks are not about each query");
        require(made,
                !(m->apart & m->hit) && !(m->apart & m->undecided) &&
                    !(m->hit & m->undecided) && !(m->separated & ~m->apart),
                "two masks are about one query");
    }
}

void call_filter(generator *random)
{
    static tf_query_block block[BLOCKS];
    tf_query_masks masks[3];
    bool triangle = one_in(random, 2);
    call made = call_begin("a filter");
    size_t count =
        (size_t)below(random, one_in(random, 2) ? 10 : 8 * BLOCKS + 1);
    for (size_t i = 0; i < (count + 7) / 8; i++)
        draw_coordinates(random, COUNT(block->at) * 96,
                         &block[i].at[0][0][0][0]);
    mark(masks, sizeof masks);
    break_environment(random, &made);
    tf_status status =
        (triangle ? tf_filter_point_triangle : tf_filter_edge_edge)(
            count, count ? block : NULL, count ? masks : NULL);
    end_trouble(&made);
    if (!judge_status(&made, status) || count == 0) {
        judge_unset(&made, masks, sizeof masks);
        return;
    }
    judge_masks(&made, count, masks);
    int one = below(random, (int)count);
    judge_lane(&made, triangle, &block[one / 8], one % 8, &masks[one / 64],
               UINT64_C(1) << one % 64);
}

// Zones -----------------------------------------------------------------------

enum {
    CONSTRAINTS = 5
};

typedef struct zone_arrays {
    tf_constraint constraint[CONSTRAINTS];
    double inverse_mass[2 * VERTICES], displacement[3 * VERTICES];
} zone_arrays;

/// Two edges of unequal weights, or in the plane a point and an edge.
static tf_constraint any_constraint(generator *random, int axes)
{
    tf_constraint drawn = {.vertex = {0, 1, 2, 3}};
    double a = uniform(random, 0.1, 0.9), b = uniform(random, 0.1, 0.9);
    draw_indices(random, VERTICES, 4, drawn.vertex);
    if (!are_good(VERTICES, 4, drawn.vertex))
        memcpy(drawn.vertex, (int[]){3, 1, 0, 2}, sizeof drawn.vertex);
    const double weights[] = {a, 1 - a, -b, b - 1};
    memcpy(drawn.coefficient, weights, sizeof weights);
    double angle = uniform(random, 0, 6);
    drawn.normal[0] = cos(angle);
    drawn.normal[one_in(random, 2) ? 1 : axes - 1] = sin(angle);
    drawn.bound = one_in(random, 2) ? 0 : uniform(random, 0, 1);
    return drawn;
}

static tf_zone any_zone(generator *random, zone_arrays *arrays)
{
    tf_zone zone = {.axes = 2 + below(random, 2),
                    .vertices = VERTICES,
                    .constraints = 1 + below(random, CONSTRAINTS),
                    .constraint = arrays->constraint,
                    .inverse_mass = arrays->inverse_mass,
                    .displacement = arrays->displacement,
                    .friction = below(random, 3) / 2. - 0.5,
                    .sweeps = 1 + below(random, 40)};
    zone.solved = below(random, zone.constraints + 1);
    for (int i = 0; i < zone.constraints; i++)
        arrays->constraint[i] = any_constraint(random, zone.axes);
    for (int v = 0; v < VERTICES; v++)
        arrays->inverse_mass[v] = v < 3 && one_in(random, 4) ? 0 : 1;
    for (int v = VERTICES; v < 2 * VERTICES;
         v++) // friction, if it is asked for
        arrays->inverse_mass[v] = one_in(random, 4) ? 0 : uniform(random, 0, 2);
    for (int i = 0; i < 3 * VERTICES; i++)
        arrays->displacement[i] = uniform(random, -2, 2);
    return zone;
}

void call_solver(generator *random)
{
    const tf_zone_solver *const all[] = {&tf_gauss_seidel,
                                         &tf_conjugate_residuals, &tf_minres,
                                         &tf_normal_residuals};
    static double workspace[4096];
    zone_arrays arrays = {0};
    double impulse[CONSTRAINTS], gap_change[CONSTRAINTS];
    tf_zone zone = any_zone(random, &arrays);
    const tf_zone_solver *solver = all[below(random, COUNT(all))];
    call made = call_begin(solver->name);
    size_t numbers =
        solver->workspace(zone.axes, zone.vertices, zone.constraints);
    require(&made, numbers <= COUNT(workspace), "it needs much memory");
    zone.workspace = workspace;
    int iterations = solver->solve(&zone);
    require(&made, iterations >= 0 && iterations <= zone.sweeps,
            "it makes more iterations than it may");
    require(&made, all_finite(zone.axes * VERTICES, arrays.displacement),
            "displacements overflow");
    for (int i = 0; i < zone.constraints; i++) {
        impulse[i] = zone.constraint[i].impulse;
        double friction = tf_zone_friction(&zone, &zone.constraint[i]);
        require(&made, friction >= 0 && friction <= 2, "a coefficient");
    }
    tf_zone_multiply(&zone, impulse, gap_change, workspace);
    require(&made, all_finite(zone.constraints, gap_change), "gaps overflow");
}

// Descriptions ----------------------------------------------------------------

/// An error that no function has set, but for its strings.
static tf_error any_error(generator *random)
{
    tf_error error = {.status = (tf_status)wrong_number(random, 7),
                      .subject = (tf_subject)(below(random, 14) - 2),
                      .index = (size_t)next_bits(random),
                      .vertices = wrong_number(random, 9),
                      .time = below(random, 5) - 2,
                      .value = any_double(random)};
    if (one_in(random, 2))
        error.status = (tf_status)below(random, 20);
    for (int i = 0; i < COUNT(error.vertex); i++)
        error.vertex[i] = wrong_number(random, -7);
    error.option = one_in(random, 2) ? NULL : "friction";
    error.range = one_in(random, 2) ? NULL : "0 or more";
    return error;
}

void call_describe(generator *random)
{
    call made = call_begin("tf_describe");
    tf_error error = any_error(random);
    char buffer[400];
    mark(buffer, sizeof buffer);
    size_t size = (size_t)below(random, COUNT(buffer));
    size_t length = tf_describe(&error, size ? buffer : NULL, size);
    require(&made, length > 0 && length < 1000, "there is no sentence");
    require(&made, size == 0 || memchr(buffer, '\0', size), "it has no end");
    judge_unset(&made, buffer + size, sizeof buffer - size);
    require(&made, tf_status_message(error.status)[0] != '\0',
            "a status has no message");
    require(&made, tf_arithmetic_name(any_arithmetic(random))[0] != '\0',
            "an arithmetic has no name");
    require(&made, tf_version()[0] != '\0', "there is no version");
}
