//: Include what simulated cloth needs
#include "program/cloth_simulated.h"

#include <stdlib.h>

static tf_cloth_simulated *cloth_of(tf_simulated *of)
{
    return (tf_cloth_simulated *)of;
}

static const tf_cloth_simulated *cloth_in(const tf_simulated *of)
{
    return (const tf_cloth_simulated *)of;
}

//: Make a step of cloth
static void count_cost(tf_cloth_simulated *c)
{
    tf_step_cost *total = &c->total;
    total->report.contacts += c->last.report.contacts;
    total->report.held += c->last.report.held;
    total->dynamics += c->last.dynamics;
    total->response += c->last.response;
    c->failsafes += c->last.report.rounds[TF_FAILSAFE] > 0;
    c->steps++;
}

static tf_status advance_cloth(tf_simulated *of, const tf_step_way *way,
                               char words[TF_SIMULATED_NAME])
{
    tf_cloth_simulated *c = cloth_of(of);
    tf_status status = tf_simulation_step(c->simulation, way, &c->last);
    if (status != TF_OK)
        return status;
    of->step = c->simulation->step;
    count_cost(c);
    snprintf(words, TF_SIMULATED_NAME, "%zu contacts", c->last.report.contacts);
    return TF_OK;
}

//: Write what a step of cloth took
static void write_report(FILE *table, const tf_response_report *report)
{
    fprintf(table, ",%zu,%zu", report->first_contacts, report->contacts);
    for (int i = 0; i < TF_LEVELS; i++)
        fprintf(table, ",%d", report->rounds[i]);
    fprintf(table, ",%zu,%d,%d,%d", report->constraints, report->held,
            report->grouped, report->resting);
}

static void write_cloth_line(FILE *table, const tf_simulated *of)
{
    const tf_simulation *s = cloth_in(of)->simulation;
    const tf_step_cost *cost = &cloth_in(of)->last;
    const tf_body *body = &s->stage.body;
    write_report(table, &cost->report);
    fprintf(table, ",%.6f,%.6g,%.6g,%.6f,%.6f",
            tf_body_stretch(body, s->position),
            tf_body_kinetic_energy(body, s->velocity),
            tf_body_elastic_energy(body, s->position), cost->dynamics,
            cost->response);
}

//: Sum cloth up
static int summarize_cloth(const tf_simulated *of,
                           tf_entry entry[TF_SIMULATED_ENTRIES])
{
    const tf_cloth_simulated *c = cloth_in(of);
    const tf_body *body = &c->simulation->stage.body;
    int count = 0;
    entry[count++] = tf_entry_count("steps", (size_t)c->steps);
    entry[count++] = tf_entry_count("vertices", (size_t)body->vertices);
    entry[count++] = tf_entry_count("triangles", (size_t)body->triangles);
    entry[count++] = tf_entry_count("contacts", c->total.report.contacts);
    entry[count++] = tf_entry_count("failsafe steps", (size_t)c->failsafes);
    entry[count++] = tf_entry_count("held", (size_t)c->total.report.held);
    entry[count++] = tf_entry_number("dynamics seconds", c->total.dynamics);
    entry[count++] = tf_entry_number("response seconds", c->total.response);
    return count;
}

//: Write and read frames of cloth
static bool write_cloth_frame(FILE *stream, const tf_simulated *of)
{
    return tf_frame_write(stream, cloth_in(of)->simulation);
}

static tf_frame_fault read_cloth_frame(tf_simulated *of, const char *path)
{
    tf_simulation *simulation = cloth_of(of)->simulation;
    tf_frame_fault fault = tf_frame_read(simulation, path);
    of->step = simulation->step;
    return fault;
}

//: Simulate cloth
static void free_cloth(tf_simulated *of)
{
    tf_simulation_free(cloth_of(of)->simulation);
    free(of);
}

static const tf_simulated_kind cloth_kind = {
    .columns =
        "first_contacts,contacts,impulse_rounds,zone_rounds,rigid_rounds,"
        "failsafe_rounds,rows,held,grouped,resting,stretch,kinetic_energy,"
        "elastic_energy,dynamics_seconds,response_seconds",
    .advance = advance_cloth,
    .write_line = write_cloth_line,
    .write_frame = write_cloth_frame,
    .read_frame = read_cloth_frame,
    .summarize = summarize_cloth,
    .free = free_cloth,
};

tf_status tf_cloth_simulate(const tf_scene *scene, int size,
                            tf_simulated **simulated)
{
    tf_cloth_simulated *c = calloc(1, sizeof *c);
    if (!c)
        return TF_OUT_OF_MEMORY;
    c->base = (tf_simulated){.kind = &cloth_kind, .length = scene->step};
    snprintf(c->base.name, sizeof c->base.name, "%s --size %d", scene->name,
             size);
    tf_status status = tf_simulation_create(scene, size, &c->simulation);
    if (status == TF_OK)
        *simulated = &c->base;
    else
        free_cloth(&c->base);
    return status;
}
