#include "bodies.h"

#include "support/hash.h"

#include <stdlib.h>
#include <string.h>

// Meshes ----------------------------------------------------------------------

static void draw_elements(generator *random, int vertices, int count,
                          int corners, int corner[])
{
    for (int i = 0; i < count; i++, corner += corners) {
        int v = below(random, vertices);
        for (int k = 0; k < corners; k++) {
            int step = 1 + below(random, (vertices - corners) / corners + 1);
            corner[k] = v % vertices;
            v += k + 1 < corners ? step : 0;
        }
    }
}

/// Any triangles and edges of vertices on a lattice.
static void draw_soup(generator *random, body *drawn)
{
    tf_mesh *mesh = &drawn->mesh;
    *mesh = (tf_mesh){.axes = 3, .vertices = 4 + below(random, 8)};
    mesh->triangles = 1 + below(random, MOST_TRIANGLES);
    mesh->edges = below(random, 3);
    draw_elements(random, mesh->vertices, mesh->triangles, 3, drawn->triangle);
    draw_elements(random, mesh->vertices, mesh->edges, 2, drawn->edge);
    draw_coordinates(random, NUMBERS, drawn->start);
}

/// Segments of the plane, and particles: clear.
static void draw_curve(generator *random, body *drawn)
{
    tf_mesh *mesh = &drawn->mesh;
    *mesh = (tf_mesh){.axes = 2, .vertices = 6 + below(random, 6)};
    mesh->edges = 1 + below(random, 3);
    for (int i = 0; i < 2 * mesh->edges; i++)
        drawn->edge[i] = i;
    for (int v = 0; v < MOST_VERTICES; v++) {
        drawn->start[2 * v] = v % 2 * 2 + 0.25 * (v / 2 % 2);
        drawn->start[2 * v + 1] = v / 2;
    }
}

/// Triangles upon each other, and particles between them: clear.
static void draw_stack(generator *random, body *drawn)
{
    tf_mesh *mesh = &drawn->mesh;
    *mesh = (tf_mesh){.axes = 3, .vertices = 6 + below(random, 7)};
    mesh->triangles = 2 + (mesh->vertices >= 9 && one_in(random, 2));
    for (int i = 0; i < 3 * mesh->triangles; i++)
        drawn->triangle[i] = i;
    for (int v = 0; v < MOST_VERTICES; v++) {
        double *x = drawn->start + (size_t)3 * (size_t)v;
        x[0] = v % 3 == 1 ? 3 : 0.25 * (v / 3);
        x[1] = v % 3 == 2 ? 3 : 0;
        x[2] = v < 3 * mesh->triangles ? v / 3 : v / 3 + 0.5 + 0.1 * (v % 3);
    }
}

void body_draw(generator *random, body *drawn)
{
    *drawn = (body){.surface = NULL};
    int kind = below(random, 4);
    (kind == 0   ? draw_soup
     : kind == 1 ? draw_curve
                 : draw_stack)(random, drawn);
    drawn->mesh.triangle = drawn->triangle;
    drawn->mesh.edge = drawn->edge;
    double by[NUMBERS];
    draw_coordinates(random, NUMBERS, by);
    for (int i = 0; i < NUMBERS; i++)
        drawn->end[i] = drawn->start[i] + by[i];
}

int body_numbers(const body *of)
{
    return of->mesh.axes * of->mesh.vertices;
}

tf_surface *body_copy(const body *of)
{
    tf_surface *made;
    if (tf_surface_create(&of->mesh, &made, NULL) != TF_OK ||
        tf_surface_set_filter(made, &of->filter, NULL) != TF_OK)
        abort();
    return made;
}

// Answers in numbers ----------------------------------------------------------

static uint64_t hash_number(uint64_t hash, uint64_t number)
{
    return hash_bytes(hash, &number, sizeof number);
}

uint64_t hash_contacts(const tf_contacts *found)
{
    uint64_t hash = hash_number(HASH_OF_NOTHING, found->any);
    for (size_t i = 0; i < found->count; i++) {
        const tf_surface_contact *row = &found->contact[i];
        hash = hash_number(hash, row->kind);
        hash = hash_bytes(hash, row->vertex, sizeof row->vertex);
        hash = hash_bytes(hash, &row->contact, sizeof row->contact);
    }
    return hash;
}

uint64_t hash_crossings(const tf_crossings *found)
{
    return hash_bytes(HASH_OF_NOTHING, found->crossing,
                      sizeof *found->crossing * found->count);
}

uint64_t hash_candidates(const tf_candidates *found)
{
    uint64_t hash = hash_number(HASH_OF_NOTHING, found->point_count);
    hash = hash_bytes(hash, found->points,
                      sizeof *found->points * found->point_count);
    return hash_bytes(hash, found->edges,
                      sizeof *found->edges * found->edge_count);
}

/// Without the statistics of detections: they tell what was left to detect.
uint64_t hash_report(const tf_response_report *report)
{
    uint64_t hash = hash_bytes(HASH_OF_NOTHING, report,
                               offsetof(tf_response_report, groups));
    const int counts[] = {report->groups, report->grouped, report->resting,
                          report->held, report->moved};
    const double energies[] = {report->energy_before, report->energy_after};
    hash = hash_bytes(hash, counts, sizeof counts);
    return hash_bytes(hash, energies, sizeof energies);
}

uint64_t hash_answers(size_t count, const tf_answered_contact contact[],
                      const double push[])
{
    uint64_t hash = hash_number(HASH_OF_NOTHING, count);
    hash = hash_bytes(hash, contact, sizeof *contact * count);
    return hash_bytes(hash, push, sizeof *push * count);
}

// What is known ---------------------------------------------------------------

static uint64_t known_contacts(const body *of, tf_surface *surface)
{
    tf_motion motion = {of->mesh.axes, of->mesh.vertices, of->start, of->end};
    tf_contacts found;
    tf_status status = tf_surface_detect(surface, &motion, NULL, &found, NULL);
    return status == TF_OK ? hash_contacts(&found) : (uint64_t)status;
}

static uint64_t known_crossings(const body *of, tf_surface *surface)
{
    tf_crossings found;
    tf_status status = tf_surface_check(surface, of->mesh.vertices, of->start,
                                        NULL, &found, NULL);
    return status == TF_OK ? hash_crossings(&found) : (uint64_t)status;
}

static uint64_t known_step(const body *of, tf_resolver *resolver)
{
    double end[NUMBERS];
    const tf_response_report *report;
    memcpy(end, of->end, sizeof end);
    tf_status status = tf_step_resolve(resolver, of->mesh.vertices, of->start,
                                       end, NULL, NULL, &report, NULL);
    if (status != TF_OK)
        return (uint64_t)status;
    return hash_bytes(hash_report(report), end, sizeof end);
}

static void learn(body *of)
{
    tf_surface *made = body_copy(of);
    tf_resolver *resolver;
    of->detected = known_contacts(of, made);
    of->checked = known_crossings(of, made);
    if (tf_resolver_create(made, &resolver) != TF_OK)
        abort();
    of->resolved = known_step(of, resolver);
    of->known = true;
    tf_resolver_free(resolver);
    tf_surface_free(made);
}

void judge_body(const call *made, body *of)
{
    if (!of->known)
        learn(of);
    require(made, known_contacts(of, of->surface) == of->detected,
            "the surface finds other contacts than a new one");
    require(made, known_crossings(of, of->surface) == of->checked,
            "the surface finds other crossings than a new one");
    require(made, !of->resolver || known_step(of, of->resolver) == of->resolved,
            "the resolver answers otherwise than a new one");
}

void body_free(body *of)
{
    tf_resolver_free(of->resolver);
    tf_surface_free(of->surface);
    of->resolver = NULL;
    of->surface = NULL;
}
