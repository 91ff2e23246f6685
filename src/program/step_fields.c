//: Include what fields of steps need
#include "program/step_fields.h"

#include "simulate/cloth_simulation.h"
#include "simulate/flow_simulation.h"

#include <string.h>

//: Refer to a number of a simulation
/// Its type, and where it is.
#define MEMBER(simulation, member)                                             \
    _Generic(((simulation *)0)->member, int                                    \
             : TF_INTEGER, size_t                                              \
             : TF_COUNT, double                                                \
             : TF_NUMBER),                                                     \
        offsetof(simulation, member)

#define CLOTH(member) MEMBER(tf_cloth_simulation, member)
#define RESPONSE(member) CLOTH(report.response.member)
#define FLOW(member) MEMBER(tf_flow_simulation, member)

static double number_of(const tf_field *field, const tf_simulation *simulation)
{
    const void *at = (const char *)simulation + field->offset;
    return field->type == TF_INTEGER ? *(const int *)at
           : field->type == TF_COUNT ? (double)*(const size_t *)at
                                     : *(const double *)at;
}

//: List the columns of cloth
static const tf_field cloth_columns[] = {
    {"step", CLOTH(base.step), NULL},
    {"time", CLOTH(base.time), "%.6g"},
    {"first_contacts", RESPONSE(first_contacts), NULL},
    {"contacts", RESPONSE(contacts), NULL},
    {"impulse_rounds", RESPONSE(rounds[TF_IMPULSES]), NULL},
    {"zone_rounds", RESPONSE(rounds[TF_ZONES]), NULL},
    {"rigid_rounds", RESPONSE(rounds[TF_RIGID]), NULL},
    {"failsafe_rounds", RESPONSE(rounds[TF_FAILSAFE]), NULL},
    {"rows", RESPONSE(constraints), NULL},
    {"held", RESPONSE(held), NULL},
    {"grouped", RESPONSE(grouped), NULL},
    {"resting", RESPONSE(resting), NULL},
    {"stretch", CLOTH(report.stretch), "%.6f"},
    {"kinetic_energy", CLOTH(report.kinetic), "%.6g"},
    {"elastic_energy", CLOTH(report.elastic), "%.6g"},
    {"dynamics_seconds", CLOTH(report.dynamics_seconds), "%.6f"},
    {"response_seconds", CLOTH(report.response_seconds), "%.6f"},
    {0},
};

//: List the columns of flows
/// How often an operation was done, and refused by each of the tests.
#define OUTCOMES(name, outcomes)                                               \
    {name "_done", FLOW(outcomes[TF_COMMITTED]), NULL},                        \
        {name "_impossible", FLOW(outcomes[TF_IMPOSSIBLE]), NULL},             \
        {name "_flattened", FLOW(outcomes[TF_FLATTENED]), NULL},               \
        {name "_overlapped", FLOW(outcomes[TF_OVERLAPPED]), NULL},             \
        {name "_passed_vertex", FLOW(outcomes[TF_PASSED_VERTEX]), NULL},       \
        {name "_passed_edge", FLOW(outcomes[TF_PASSED_EDGE]), NULL},           \
    {                                                                          \
        name "_passed_triangle", FLOW(outcomes[TF_PASSED_TRIANGLE]), NULL      \
    }

static const tf_field flow_columns[] = {
    {"step", FLOW(base.step), NULL},
    {"time", FLOW(base.time), "%.6g"},
    {"vertices", FLOW(measures.vertices), NULL},
    {"triangles", FLOW(measures.triangles), NULL},
    {"components", FLOW(measures.components), NULL},
    {"genus", FLOW(measures.genus), NULL},
    {"rims", FLOW(measures.boundaries), NULL},
    {"area", FLOW(measures.area), "%.9g"},
    {"volume", FLOW(measures.volume), "%.12g"},
    OUTCOMES("split", report.tried[TF_SPLIT]),
    OUTCOMES("collapse", report.tried[TF_COLLAPSE]),
    OUTCOMES("flip", report.tried[TF_FLIP]),
    OUTCOMES("smooth", report.tried[TF_SMOOTH]),
    OUTCOMES("shift", report.shifted),
    OUTCOMES("merge", reconnected.tried[TF_MERGE]),
    OUTCOMES("pinch", reconnected.tried[TF_PINCH]),
    OUTCOMES("drop", reconnected.tried[TF_DROP]),
    {"merge_gain", FLOW(reconnected.gained[TF_MERGE]), "%.6g"},
    {"pinch_gain", FLOW(reconnected.gained[TF_PINCH]), "%.6g"},
    {"drop_gain", FLOW(reconnected.gained[TF_DROP]), "%.6g"},
    {"contacts", FLOW(response.contacts), NULL},
    {"zone_rounds", FLOW(response.rounds[TF_ZONES]), NULL},
    {"failsafe_rounds", FLOW(response.rounds[TF_FAILSAFE]), NULL},
    {"moved", FLOW(response.moved), NULL},
    {"improve_seconds", FLOW(report.seconds[TF_IMPROVE]), "%.6f"},
    {"reconnect_seconds", FLOW(report.seconds[TF_RECONNECT]), "%.6f"},
    {"advance_seconds", FLOW(report.seconds[TF_ADVANCE]), "%.6f"},
    {0},
};

const tf_field *tf_step_columns(const tf_simulation_kind *kind)
{
    return kind == &tf_flow_kind ? flow_columns : cloth_columns;
}

//: List what is told of all steps
/// Each kind of simulation has those of which it has the column.
static const struct {
    const char *name, *column;
    enum {
        LAST, ///< the number after the last step
        SUM,  ///< over all steps
        STEPS ///< how many steps have a number above 0
    } kind;
} totals[TF_TOTALS] = {
    {"components", "components", LAST},
    {"genus", "genus", LAST},
    {"area", "area", LAST},
    {"volume", "volume", LAST},
    {"merges", "merge_done", SUM},
    {"pinches", "pinch_done", SUM},
    {"drops", "drop_done", SUM},
    {"contacts", "contacts", SUM},
    {"failsafe steps", "failsafe_rounds", STEPS},
    {"held", "held", SUM},
    {"improve seconds", "improve_seconds", SUM},
    {"reconnect seconds", "reconnect_seconds", SUM},
    {"advance seconds", "advance_seconds", SUM},
    {"dynamics seconds", "dynamics_seconds", SUM},
    {"response seconds", "response_seconds", SUM},
};

/// NULL: the kind has no such column.
static const tf_field *column_of(const tf_simulation *simulation,
                                 const char *name)
{
    const tf_field *column = tf_step_columns(simulation->scene->kind);
    while (column->name && strcmp(column->name, name) != 0)
        column++;
    return column->name ? column : NULL;
}

//: Count a step in
void tf_step_totals_add(tf_step_totals *sums, const tf_simulation *simulation)
{
    sums->steps++;
    for (int i = 0; i < TF_TOTALS; i++) {
        const tf_field *column = column_of(simulation, totals[i].column);
        double number = column ? number_of(column, simulation) : 0;
        sums->total[i] += totals[i].kind == STEPS ? number > 0 : number;
    }
}

//: Gather what is told of all steps
/// A record, and its fields: three and the totals that the kind has.
typedef struct totals_record {
    tf_field field[3 + TF_TOTALS + 1];
    int steps, vertices, triangles;
    size_t count[TF_TOTALS];
    double number[TF_TOTALS];
} totals_record;

/// Sets the value of the i-th total, and returns its field.
static tf_field gather_total(totals_record *record, int i, double value,
                             tf_field_type type)
{
    bool counts = type != TF_NUMBER;
    record->count[i] = counts ? (size_t)value : 0;
    record->number[i] = value;
    return (tf_field){
        .name = totals[i].name,
        .type = counts ? TF_COUNT : TF_NUMBER,
        .offset = counts ? offsetof(totals_record, count[i])
                         : offsetof(totals_record, number[i]),
    };
}

static void gather_totals(totals_record *record, const tf_step_totals *sums,
                          const tf_simulation *simulation)
{
    tf_field *field = record->field + 3;
    for (int i = 0; i < TF_TOTALS; i++) {
        const tf_field *column = column_of(simulation, totals[i].column);
        if (column)
            *field++ = gather_total(record, i,
                                    totals[i].kind == LAST
                                        ? number_of(column, simulation)
                                        : sums->total[i],
                                    column->type);
    }
}

//: Write what is told of all steps
static const tf_field sizes[] = {
    TF_FIELD("steps", totals_record, steps),
    TF_FIELD("vertices", totals_record, vertices),
    TF_FIELD("triangles", totals_record, triangles),
};

bool tf_step_totals_write(FILE *stream, tf_format format,
                          const tf_step_totals *sums,
                          const tf_simulation *simulation)
{
    tf_mesh mesh = simulation->scene->kind->snapshot(simulation).mesh;
    totals_record record = {
        .field = {sizes[0], sizes[1], sizes[2]},
        .steps = sums->steps,
        .vertices = mesh.vertices,
        .triangles = mesh.triangles,
    };
    gather_totals(&record, sums, simulation);
    return tf_report_write(stream, format, record.field, &record);
}

//: Describe a step in a few words
void tf_step_describe(const tf_simulation *simulation, int steps,
                      char words[TF_STEP_WORDS])
{
    bool flows = simulation->scene->kind == &tf_flow_kind;
    const char *name = flows ? "triangles" : "contacts";
    snprintf(words, TF_STEP_WORDS, "of %d steps, %.0f %s", steps,
             number_of(column_of(simulation, name), simulation), name);
}
