// Make steps with all options and print all that is reported: a user's program,
// compiled with one version of the library and run with another.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <tanglefree.h>

static void expect(tf_status status, const char *what)
{
    printf("%s: %s\n", what, tf_status_message(status));
    if (status != TF_OK)
        exit(1);
}

static void print_numbers(const char *name, size_t count, const double x[])
{
    printf("%s:", name);
    for (size_t i = 0; i < count; i++)
        printf(" %a", x[i]);
    puts("");
}

// What the library fills is between memory of the caller that it must not write.
enum {
    MARGIN = 64
};

#define WITH_MARGINS(type, name)                                               \
    struct {                                                                   \
        unsigned char before[MARGIN];                                          \
        type it;                                                               \
        unsigned char after[MARGIN];                                           \
    } name;                                                                    \
    memset(&(name), 0xa5, sizeof(name))

static void expect_margins(const unsigned char before[MARGIN],
                           const unsigned char after[MARGIN])
{
    for (int i = 0; i < MARGIN; i++)
        if (before[i] != 0xa5 || after[i] != 0xa5)
            puts("the library writes beside what it fills");
}

static bool go_on(void *context, const tf_stage *stage)
{
    int *calls = context;
    (*calls)++;
    return stage->done <= stage->total || stage->total == 0;
}

// A surface -------------------------------------------------------------------

// A triangle falls on another one, which is at rest.
enum {
    VERTICES = 6
};
static const int triangle[] = {0, 1, 2, 3, 4, 5};
static const double start[3 * VERTICES] = {0, 0, 0, 1, 0, 0, 0, 1, 0,
                                           0, 0, 1, 1, 0, 1, 0, 1, 1};
static const double end[3 * VERTICES] = {0, 0, 0,  1, 0, 0,  0, 1, 0,
                                         0, 0, -1, 1, 0, -1, 0, 1, -1};

static void detect(tf_surface *surface, size_t size)
{
    const tf_motion motion = {
        .axes = 3, .vertices = VERTICES, .start = start, .end = end};
    int calls = 0;
    const tf_detect_options options = {.size = size,
                                       .arithmetic = &tf_perturbed,
                                       .narrow_phase = &tf_reference,
                                       .progress = go_on,
                                       .context = &calls};
    WITH_MARGINS(tf_contacts, found);
    expect(tf_surface_detect(surface, &motion, &options, &found.it, NULL),
           "detect");
    expect_margins(found.before, found.after);
    for (size_t i = 0; i < found.it.count; i++) {
        const tf_surface_contact *row = &found.it.contact[i];
        printf("%d: %d %d %d %d\n", row->kind, row->vertex[0], row->vertex[1],
               row->vertex[2], row->vertex[3]);
        print_numbers("normal", 3, row->contact.normal);
        print_numbers("times", 2,
                      (double[]){row->contact.toi_lo, row->contact.toi_hi});
    }
    printf("%zu candidates, told: %d\n", found.it.statistics.candidates,
           calls > 0);
}

static void check(tf_surface *surface, size_t size)
{
    WITH_MARGINS(tf_crossings, found);
    const tf_check_options options = {.size = size};
    expect(
        tf_surface_check(surface, VERTICES, start, &options, &found.it, NULL),
        "check");
    expect_margins(found.before, found.after);
    printf("%zu crossings\n", found.it.count);
}

static void resolve(tf_surface *surface, size_t size)
{
    tf_resolver *resolver;
    expect(tf_resolver_create(surface, &resolver), "a resolver");
    int calls = 0;
    const tf_response_options options = {.size = size,
                                         .impulse_rounds = 1,
                                         .zone_rounds = 3,
                                         .friction = 0.5,
                                         .restitution = 0.25,
                                         .check_start = true,
                                         .progress = go_on,
                                         .context = &calls};
    double resolved[3 * VERTICES];
    memcpy(resolved, end, sizeof resolved);
    const double mass[VERTICES] = {0, 0, 0, 1, 1, 1};
    const tf_response_report *report;
    expect(tf_step_resolve(resolver, VERTICES, start, resolved, mass, &options,
                           &report, NULL),
           "resolve");
    print_numbers("ends", 3 * VERTICES, resolved);
    printf("%zu contacts, %d moved, told: %d\n", report->contacts,
           report->moved, calls > 0);
    print_numbers("energies", 2,
                  (double[]){report->energy_before, report->energy_after});
    tf_resolver_free(resolver);
}

static void make_steps(void)
{
    const tf_mesh mesh = {
        .axes = 3, .vertices = VERTICES, .triangles = 2, .triangle = triangle};
    WITH_MARGINS(tf_error, error);
    tf_surface *surface;
    expect(tf_surface_create(&mesh, &surface, &error.it), "a surface");
    expect_margins(error.before, error.after);
    for (int sized = 0; sized < 2; sized++) {
        detect(surface, sized ? sizeof(tf_detect_options) : 0);
        check(surface, sized ? sizeof(tf_check_options) : 0);
        resolve(surface, sized ? sizeof(tf_response_options) : 0);
    }
    tf_surface_free(surface);
}

// An adaptive surface ---------------------------------------------------------

static void blow_up(void *context, double time, int points,
                    const double point[], const double normal[],
                    double velocity[])
{
    (void)context, (void)time, (void)point;
    for (int i = 0; i < 3 * points; i++)
        velocity[i] = normal[i];
}

static void flow(tf_adaptive_surface *surface, size_t size)
{
    tf_flow *flow;
    expect(tf_flow_create(surface, &flow), "a flow");
    const tf_flow_options options = {
        .size = size, .edge = 0.5, .velocity = blow_up};
    const tf_flow_report *report;
    expect(tf_flow_step(flow, 0, 0.1, &options, &report, NULL), "flow");
    printf("%zu splits, %zu merges, %d moved\n",
           report->tried[TF_SPLIT][TF_COMMITTED],
           report->reconnected->tried[TF_MERGE][TF_COMMITTED],
           report->response->moved);
    tf_flow_free(flow);
}

static void remesh(tf_adaptive_surface *surface, size_t size)
{
    const tf_remesh_options options = {.size = size, .edge = 0.6, .rounds = 2};
    const tf_remesh_report *report;
    expect(tf_adaptive_remesh(surface, &options, &report, NULL), "remesh");
    printf("%d rounds, %zu splits\n", report->rounds,
           report->tried[TF_SPLIT][TF_COMMITTED]);
    print_numbers("qualities", 2,
                  (double[]){report->least_before, report->least_after});
}

// An octahedron.
static void change_surfaces(void)
{
    static const int octahedron[] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4,
                                     2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
    static const double position[] = {1, 0,  0, -1, 0, 0, 0, 1, 0,
                                      0, -1, 0, 0,  0, 1, 0, 0, -1};
    const tf_mesh mesh = {
        .axes = 3, .vertices = 6, .triangles = 8, .triangle = octahedron};
    for (int sized = 0; sized < 2; sized++) {
        tf_adaptive_surface *surface;
        expect(tf_adaptive_create(&mesh, position, &surface, NULL),
               "an adaptive surface");
        remesh(surface, sized ? sizeof(tf_remesh_options) : 0);
        flow(surface, sized ? sizeof(tf_flow_options) : 0);
        const tf_mesh *now = tf_adaptive_mesh(surface);
        print_numbers("positions", 3 * (size_t)now->vertices,
                      tf_adaptive_positions(surface));
        tf_adaptive_free(surface);
    }
}

int main(void)
{
    make_steps();
    change_surfaces();
    return 0;
}
