//: Include what columns of steps need
#include "program/step_columns.h"

#include "simulate/cloth_simulation.h"
#include "simulate/flow_simulation.h"

#include <stddef.h>
#include <string.h>

//: Refer to a number of a simulation
#define MEMBER(simulation, member)                                             \
    _Generic(((simulation *)0)->member, int                                    \
             : 'i', size_t                                                     \
             : 's', double                                                     \
             : 'd'),                                                           \
        offsetof(simulation, member)

#define CLOTH(member) MEMBER(tf_cloth_simulation, member)
#define RESPONSE(member) CLOTH(report.response.member)
#define FLOW(member) MEMBER(tf_flow_simulation, member)

#define COUNT "%.0f"

double tf_step_number(const tf_step_column *column,
                      const tf_simulation *simulation)
{
    const void *at = (const char *)simulation + column->offset;
    return column->type == 'i'   ? *(const int *)at
           : column->type == 's' ? (double)*(const size_t *)at
                                 : *(const double *)at;
}

//: List the columns of cloth
static const tf_step_column cloth_columns[] = {
    {NULL, NULL, CLOTH(base.stage.body.vertices), TF_LAST, "vertices"},
    {NULL, NULL, CLOTH(base.stage.body.triangles), TF_LAST, "triangles"},
    {"first_contacts", COUNT, RESPONSE(first_contacts), 0, NULL},
    {"contacts", COUNT, RESPONSE(contacts), TF_SUM, "contacts"},
    {"impulse_rounds", COUNT, RESPONSE(rounds[TF_IMPULSES]), 0, NULL},
    {"zone_rounds", COUNT, RESPONSE(rounds[TF_ZONES]), 0, NULL},
    {"rigid_rounds", COUNT, RESPONSE(rounds[TF_RIGID]), 0, NULL},
    {"failsafe_rounds", COUNT, RESPONSE(rounds[TF_FAILSAFE]), TF_STEPS,
     "failsafe steps"},
    {"rows", COUNT, RESPONSE(rows), 0, NULL},
    {"held", COUNT, RESPONSE(held), TF_SUM, "held"},
    {"grouped", COUNT, RESPONSE(grouped), 0, NULL},
    {"resting", COUNT, RESPONSE(resting), 0, NULL},
    {"stretch", "%.6f", CLOTH(report.stretch), 0, NULL},
    {"kinetic_energy", "%.6g", CLOTH(report.kinetic), 0, NULL},
    {"elastic_energy", "%.6g", CLOTH(report.elastic), 0, NULL},
    {"dynamics_seconds", "%.6f", CLOTH(report.dynamics_seconds), TF_SUM,
     "dynamics seconds"},
    {"response_seconds", "%.6f", CLOTH(report.response_seconds), TF_SUM,
     "response seconds"},
    {0},
};

//: List the columns of flows
/// How often an operation was done, and refused by each of the tests.
#define OUTCOMES(name, outcomes, how, total)                                   \
    {name "_done", COUNT, FLOW(outcomes[TF_COMMITTED]), how, total},           \
        {name "_impossible", COUNT, FLOW(outcomes[TF_IMPOSSIBLE]), 0, NULL},   \
        {name "_flattened", COUNT, FLOW(outcomes[TF_FLATTENED]), 0, NULL},     \
        {name "_overlapped", COUNT, FLOW(outcomes[TF_OVERLAPPED]), 0, NULL},   \
        {name "_passed_vertex", COUNT, FLOW(outcomes[TF_PASSED_VERTEX]), 0,    \
         NULL},                                                                \
        {name "_passed_edge", COUNT, FLOW(outcomes[TF_PASSED_EDGE]), 0, NULL}, \
    {                                                                          \
        name "_passed_triangle", COUNT, FLOW(outcomes[TF_PASSED_TRIANGLE]), 0, \
            NULL                                                               \
    }

static const tf_step_column flow_columns[] = {
    {"vertices", COUNT, FLOW(measures.vertices), TF_LAST, "vertices"},
    {"triangles", COUNT, FLOW(measures.triangles), TF_LAST, "triangles"},
    {"components", COUNT, FLOW(measures.components), TF_LAST, "components"},
    {"genus", COUNT, FLOW(measures.genus), TF_LAST, "genus"},
    {"rims", COUNT, FLOW(measures.boundaries), 0, NULL},
    {"area", "%.9g", FLOW(measures.area), TF_LAST, "area"},
    {"volume", "%.12g", FLOW(measures.volume), TF_LAST, "volume"},
    OUTCOMES("split", report.tried[TF_SPLIT], 0, NULL),
    OUTCOMES("collapse", report.tried[TF_COLLAPSE], 0, NULL),
    OUTCOMES("flip", report.tried[TF_FLIP], 0, NULL),
    OUTCOMES("smooth", report.tried[TF_SMOOTH], 0, NULL),
    OUTCOMES("shift", report.shifted, 0, NULL),
    OUTCOMES("merge", report.reconnected.tried[TF_MERGE], TF_SUM, "merges"),
    OUTCOMES("pinch", report.reconnected.tried[TF_PINCH], TF_SUM, "pinches"),
    OUTCOMES("drop", report.reconnected.tried[TF_DROP], TF_SUM, "drops"),
    {"merge_gain", "%.6g", FLOW(report.reconnected.gained[TF_MERGE]), 0, NULL},
    {"pinch_gain", "%.6g", FLOW(report.reconnected.gained[TF_PINCH]), 0, NULL},
    {"drop_gain", "%.6g", FLOW(report.reconnected.gained[TF_DROP]), 0, NULL},
    {"contacts", COUNT, FLOW(report.response.contacts), TF_SUM, "contacts"},
    {"zone_rounds", COUNT, FLOW(report.response.rounds[TF_ZONES]), 0, NULL},
    {"failsafe_rounds", COUNT, FLOW(report.response.rounds[TF_FAILSAFE]),
     TF_STEPS, "failsafe steps"},
    {"moved", COUNT, FLOW(report.response.moved), 0, NULL},
    {"improve_seconds", "%.6f", FLOW(report.seconds[TF_IMPROVE]), TF_SUM,
     "improve seconds"},
    {"reconnect_seconds", "%.6f", FLOW(report.seconds[TF_RECONNECT]), TF_SUM,
     "reconnect seconds"},
    {"advance_seconds", "%.6f", FLOW(report.seconds[TF_ADVANCE]), TF_SUM,
     "advance seconds"},
    {0},
};

const tf_step_column *tf_step_columns(const tf_simulation_kind *kind)
{
    return kind == &tf_flow_kind ? flow_columns : cloth_columns;
}

//: Add up what is told of steps
void tf_step_totals_add(tf_step_totals *totals, const tf_simulation *simulation)
{
    const tf_step_column *column = tf_step_columns(simulation->scene->kind);
    totals->steps++;
    for (int i = 0; column[i].type; i++) {
        double number = tf_step_number(&column[i], simulation);
        totals->number[i] += column[i].how == TF_STEPS ? number > 0 : number;
    }
}

//: Write what is told of all steps
void tf_step_totals_write(FILE *stream, const tf_step_totals *totals,
                          const tf_simulation *simulation)
{
    tf_entry entry[TF_MOST_COLUMNS] = {
        tf_entry_count("steps", (size_t)totals->steps)};
    int entries = 1;
    const tf_step_column *column = tf_step_columns(simulation->scene->kind);
    for (int i = 0; column[i].type; i++) {
        double number = column[i].how == TF_LAST
                            ? tf_step_number(&column[i], simulation)
                            : totals->number[i];
        if (column[i].how != TF_NO_TOTAL)
            entry[entries++] =
                column[i].type == 'd'
                    ? tf_entry_number(column[i].total, number)
                    : tf_entry_count(column[i].total, (size_t)number);
    }
    tf_summary_write(stream, entries, entry);
}

//: Describe a step in a few words
void tf_step_describe(const tf_simulation *simulation,
                      char words[TF_STEP_WORDS])
{
    const tf_simulation_kind *kind = simulation->scene->kind;
    const tf_step_column *column = tf_step_columns(kind);
    const char *name = kind == &tf_flow_kind ? "triangles" : "contacts";
    while (!column->name || strcmp(column->name, name) != 0)
        column++;
    snprintf(words, TF_STEP_WORDS, "%.0f %s",
             tf_step_number(column, simulation), name);
}
