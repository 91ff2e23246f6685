//: Include what the reports of changes need
#include "program/reports.h"

#include <string.h>

//: List the fields of a response
const tf_field tf_resolved_fields[] = {
    TF_FIELD("status", tf_resolved, status),
    TF_FIELD("first contacts", tf_resolved, report.first_contacts),
    TF_FIELD("contacts", tf_resolved, report.contacts),
    TF_FIELD("impulse rounds", tf_resolved, report.rounds[TF_IMPULSES]),
    TF_FIELD("zone rounds", tf_resolved, report.rounds[TF_ZONES]),
    TF_FIELD("rigid rounds", tf_resolved, report.rounds[TF_RIGID]),
    TF_FIELD("failsafe rounds", tf_resolved, report.rounds[TF_FAILSAFE]),
    TF_FIELD("rows", tf_resolved, report.constraints),
    TF_FIELD("zones", tf_resolved, report.zones),
    TF_FIELD("largest zone", tf_resolved, report.largest_zone),
    TF_FIELD("iterations", tf_resolved, report.iterations),
    TF_FIELD("violation", tf_resolved, report.violation),
    TF_FIELD("smallest gap", tf_resolved, report.smallest_gap),
    TF_FIELD("groups", tf_resolved, report.groups),
    TF_FIELD("grouped", tf_resolved, report.grouped),
    TF_FIELD("resting", tf_resolved, report.resting),
    TF_FIELD("held", tf_resolved, report.held),
    TF_FIELD("moved", tf_resolved, report.moved),
    TF_FIELD("followed", tf_resolved, report.followed),
    TF_FIELD("candidates", tf_resolved, report.statistics.candidates),
    TF_FIELD("decided by axis", tf_resolved, report.statistics.by_axis),
    TF_FIELD("decided by filter", tf_resolved, report.statistics.by_filter),
    TF_FIELD("decided by signs", tf_resolved, report.statistics.by_signs),
    TF_FIELD("energy before", tf_resolved, report.energy_before),
    TF_FIELD("energy after", tf_resolved, report.energy_after),
    TF_FIELD("seconds", tf_resolved, seconds),
    TF_FIELD("first near", tf_resolved, report.first_near),
    TF_FIELD("near", tf_resolved, report.near),
    TF_FIELD("near at start", tf_resolved, report.near_at_start),
    TF_FIELD("exempt zones", tf_resolved, exempt_zones),
    TF_FIELD("exempt crossings", tf_resolved, exempt_crossings),
    {0},
};

//: Tell what was wrong with a surface
static int count_of(const tf_defects *defects, tf_status status)
{
    int count = 0;
    for (size_t i = 0; i < defects->count; i++)
        count += defects->defect[i].status == status;
    return count;
}

void tf_remeshed_set_defects(tf_remeshed *remeshed, const tf_defects *defects)
{
    remeshed->turned = defects->turned;
    remeshed->left_alone = defects->triangles;
    remeshed->edges = count_of(defects, TF_EDGE_NOT_MANIFOLD);
    remeshed->vertices = count_of(defects, TF_VERTEX_NOT_MANIFOLD);
    remeshed->collinear = count_of(defects, TF_COLLINEAR);
    remeshed->crossings = count_of(defects, TF_NOT_EMBEDDED);
}

//: List the fields about remeshing
#define TRIED(name, operation, outcome)                                        \
    TF_FIELD(name, tf_remeshed, report.tried[operation][outcome])

#define OUTCOMES(names, operation)                                             \
    TRIED(names, operation, TF_COMMITTED),                                     \
        TRIED("impossible " names, operation, TF_IMPOSSIBLE),                  \
        TRIED("collinear " names, operation, TF_FLATTENED),                    \
        TRIED("overlapping " names, operation, TF_OVERLAPPED),                 \
        TRIED(names " past vertices", operation, TF_PASSED_VERTEX),            \
        TRIED(names " past edges", operation, TF_PASSED_EDGE),                 \
        TRIED(names " past triangles", operation, TF_PASSED_TRIANGLE)

const tf_field tf_remeshed_fields[] = {
    TF_FIELD("triangles before", tf_remeshed, triangles_before),
    TF_FIELD("triangles", tf_remeshed, triangles_after),
    TF_FIELD("edge", tf_remeshed, edge),
    TF_FIELD("least quality before", tf_remeshed, report.least_before),
    TF_FIELD("least quality", tf_remeshed, report.least_after),
    TF_FIELD("mean quality before", tf_remeshed, report.mean_before),
    TF_FIELD("mean quality", tf_remeshed, report.mean_after),
    TF_FIELD("distance", tf_remeshed, report.distance),
    TF_FIELD("distance at most", tf_remeshed, report.most_distance),
    TF_FIELD("rounds", tf_remeshed, report.rounds),
    TF_FIELD("seconds", tf_remeshed, seconds),
    TF_FIELD("turned", tf_remeshed, turned),
    TF_FIELD("left alone", tf_remeshed, left_alone),
    TF_FIELD("nonmanifold edges", tf_remeshed, edges),
    TF_FIELD("nonmanifold vertices", tf_remeshed, vertices),
    TF_FIELD("collinear triangles", tf_remeshed, collinear),
    TF_FIELD("intersections", tf_remeshed, crossings),
    OUTCOMES("splits", TF_SPLIT),
    OUTCOMES("collapses", TF_COLLAPSE),
    OUTCOMES("flips", TF_FLIP),
    OUTCOMES("moves", TF_SMOOTH),
    {0},
};

//: List the fields about welding
const tf_field tf_weld_fields[] = {
    TF_FIELD("vertices before", tf_weld_report, vertices_before),
    TF_FIELD("vertices", tf_weld_report, vertices),
    TF_FIELD("joined", tf_weld_report, joined),
    TF_FIELD("farthest", tf_weld_report, farthest),
    TF_FIELD("triangles before", tf_weld_report, triangles_before),
    TF_FIELD("triangles", tf_weld_report, triangles),
    TF_FIELD("collapsed triangles", tf_weld_report, collapsed),
    TF_FIELD("edges before", tf_weld_report, edges_before),
    TF_FIELD("edges", tf_weld_report, edges),
    TF_FIELD("collapsed edges", tf_weld_report, collapsed_edges),
    {0},
};

//: Tell what untangling did
static void name_rungs(tf_untangled *untangled)
{
    static const char *const names[] = {"push",  "smooth", "again",
                                        "apart", "relax",  "return"};
    for (int i = 0; i < 6; i++)
        if (untangled->report.rungs >> i & 1) {
            strcat(untangled->rungs, untangled->rungs[0] ? " " : "");
            strcat(untangled->rungs, names[i]);
        }
    untangled->rung_names = untangled->rungs[0] ? untangled->rungs : "none";
}

void tf_untangled_set(tf_untangled *untangled, const tf_untangled_frame *done,
                      double seconds)
{
    *untangled = (tf_untangled){.status = done->left.count > 0 ? "tangled"
                                          : done->before > 0   ? "untangled"
                                                               : "clear",
                                .before = done->before,
                                .left = done->left.count,
                                .report = done->report,
                                .seconds = seconds};
    name_rungs(untangled);
}

//: List the fields about untangling
const tf_field tf_untangled_fields[] = {
    TF_FIELD("status", tf_untangled, status),
    TF_FIELD("intersections before", tf_untangled, before),
    TF_FIELD("intersections", tf_untangled, left),
    TF_FIELD("between fixed", tf_untangled, report.beyond),
    TF_FIELD("parts", tf_untangled, report.parts),
    TF_FIELD("rounds", tf_untangled, report.rounds),
    TF_FIELD("rungs", tf_untangled, rung_names),
    TF_FIELD("moved", tf_untangled, report.moved),
    TF_FIELD("farthest", tf_untangled, report.farthest),
    TF_FIELD("mean", tf_untangled, report.mean),
    TF_FIELD("deviation", tf_untangled, report.deviation),
    TF_FIELD("edge", tf_untangled, report.edge),
    TF_FIELD("stretched", tf_untangled, report.stretched),
    TF_FIELD("stretch", tf_untangled, report.stretch),
    TF_FIELD("volume before", tf_untangled, report.volume_before),
    TF_FIELD("volume", tf_untangled, report.volume_after),
    TF_FIELD("turned", tf_untangled, report.turned),
    TF_FIELD("seconds", tf_untangled, seconds),
    {0},
};
