#include "support/pair_rules.h"

#include "support/hash.h"

#include <stdlib.h>
#include <string.h>

// What a rule keeps -----------------------------------------------------------

static bool is_one_group(const pair_rule *rule, int count, const int vertex[])
{
    for (int i = 0; i < count; i++)
        if (!rule->filter.group || rule->group[vertex[i]] == 0 ||
            rule->group[vertex[i]] != rule->group[vertex[0]])
            return false;
    return true;
}

static bool is_left_out_by_callback(const pair_rule *rule, tf_kind kind,
                                    const int vertex[])
{
    int numbers[5] = {(int)kind, -1, -1, -1, -1};
    memcpy(numbers + 1, vertex,
           sizeof *vertex * (kind == TF_POINT_EDGE ? 3 : 4));
    uint64_t hash = hash_bytes(rule->salt, numbers, sizeof numbers);
    return rule->filter.wanted && (int)(hash >> 40 & 15) < rule->part;
}

static bool has_free_vertex(const pair_rule *rule, int count,
                            const int vertex[])
{
    for (int i = 0; i < count; i++)
        if (rule->inverse_mass[vertex[i]] > 0)
            return true;
    return false;
}

const double *pair_rule_weigh(generator *random, int vertices, pair_rule *made)
{
    double scripted = uniform(random, 0.3, 1);
    made->weighs = true;
    for (int v = 0; v < vertices; v++)
        made->inverse_mass[v] = uniform(random, 0, 1) < scripted ? 0 : 1;
    return made->inverse_mass;
}

bool pair_rule_keeps(const pair_rule *rule, tf_kind kind, const int vertex[])
{
    int count = kind == TF_POINT_EDGE ? 3 : 4;
    if (rule->weighs && !has_free_vertex(rule, count, vertex))
        return false;
    return !is_one_group(rule, kind == TF_POINT_EDGE ? 3 : 4, vertex) &&
           !is_left_out_by_callback(rule, kind, vertex);
}

/// The same for two edges in any order.
static bool keeps_edges(const pair_rule *rule, int a, int b, int c, int d)
{
    int low[] = {a < b ? a : b, c < d ? c : d};
    int high[] = {a < b ? b : a, c < d ? d : c};
    int first = low[1] < low[0];
    return pair_rule_keeps(
        rule, TF_EDGE_EDGE,
        (const int[]){low[first], high[first], low[!first], high[!first]});
}

static bool keeps_edge_triangle(const pair_rule *rule, const int v[5])
{
    return pair_rule_keeps(rule, TF_POINT_TRIANGLE,
                           (const int[]){v[0], v[2], v[3], v[4]}) &&
           pair_rule_keeps(rule, TF_POINT_TRIANGLE,
                           (const int[]){v[1], v[2], v[3], v[4]}) &&
           keeps_edges(rule, v[0], v[1], v[2], v[3]) &&
           keeps_edges(rule, v[0], v[1], v[2], v[4]) &&
           keeps_edges(rule, v[0], v[1], v[3], v[4]);
}

static bool keeps_edges_in_plane(const pair_rule *rule, const int v[4])
{
    return pair_rule_keeps(rule, TF_POINT_EDGE,
                           (const int[]){v[0], v[2], v[3]}) &&
           pair_rule_keeps(rule, TF_POINT_EDGE,
                           (const int[]){v[1], v[2], v[3]}) &&
           pair_rule_keeps(rule, TF_POINT_EDGE,
                           (const int[]){v[2], v[0], v[1]}) &&
           pair_rule_keeps(rule, TF_POINT_EDGE,
                           (const int[]){v[3], v[0], v[1]});
}

bool pair_rule_keeps_crossing(const pair_rule *rule,
                              const tf_crossing *crossing)
{
    if (crossing->kind == TF_EDGE_THROUGH_TRIANGLE)
        return keeps_edge_triangle(rule, crossing->vertex);
    if (crossing->kind == TF_POINT_ON_TRIANGLE)
        return pair_rule_keeps(rule, TF_POINT_TRIANGLE, crossing->vertex);
    return rule->axes == 2
               ? keeps_edges_in_plane(rule, crossing->vertex)
               : pair_rule_keeps(rule, TF_EDGE_EDGE, crossing->vertex);
}

static bool keeps_tangle(const pair_rule *rule, const tangle *found)
{
    static const tf_crossing_kind kinds[] = {
        [EDGE_PIERCES_TRIANGLE] = TF_EDGE_THROUGH_TRIANGLE,
        [POINT_IN_TRIANGLE] = TF_POINT_ON_TRIANGLE,
        [EDGES_MEET] = TF_EDGE_ON_EDGE};
    if (found->kind == POINT_IN_EDGE)
        return pair_rule_keeps(rule, TF_POINT_EDGE, found->vertex);
    tf_crossing crossing = {.kind = kinds[found->kind]};
    memcpy(crossing.vertex, found->vertex, sizeof crossing.vertex);
    return pair_rule_keeps_crossing(rule, &crossing);
}

int pair_rule_count_tangles(const pair_rule *rule, int count,
                            const tangle found[])
{
    int kept = 0;
    for (int i = 0; i < count; i++)
        kept += keeps_tangle(rule, &found[i]);
    return kept;
}

// The callback ----------------------------------------------------------------

static void expect(bool condition)
{
    if (!condition)
        abort();
}

/// The group of an element, which must be the one that the callback was told.
static void expect_group(const pair_rule *rule, int corners, const int vertex[],
                         int told)
{
    bool one = is_one_group(rule, corners, vertex);
    expect(told == (one ? rule->group[vertex[0]] : 0));
    for (int i = 1; i < corners; i++)
        expect(vertex[i - 1] < vertex[i]);
}

static bool is_wanted(void *context, const tf_element_pair *pair)
{
    const pair_rule *rule = context;
    const int *v = pair->vertex;
    int first = pair->kind == TF_EDGE_EDGE ? 2 : 1;
    int count = rule->axes + 1;
    expect((pair->kind == TF_POINT_EDGE) == (rule->axes == 2));
    expect(pair->kind != TF_NO_KIND && (count == 4 || v[3] == -1));
    expect(first == 1 || v[0] < v[2]);
    expect_group(rule, first, v, pair->group[0]);
    expect_group(rule, count - first, v + first, pair->group[1]);
    expect(!is_one_group(rule, count, v));
    return !is_left_out_by_callback(rule, pair->kind, v);
}

// Rules -----------------------------------------------------------------------

static int group_for(generator *random, int way, const double *x)
{
    switch (way) {
    case 0:
        return 7;
    case 1:
        return below(random, 8) ? 0 : -1;
    case 2:
        return x[1] < 0 ? 1 : 2;
    case 3:
        return below(random, 16) ? x[0] < 0.25 : 0;
    default:
        return below(random, 3) - 1;
    }
}

void pair_rule_make(generator *random, int axes, int vertices,
                    const double position[], pair_rule *made)
{
    expect(vertices <= RULE_VERTICES);
    *made = (pair_rule){.axes = axes, .salt = next_bits(random)};
    int uses = 1 + below(random, 3), way = below(random, 6);
    for (int v = 0; v < vertices; v++)
        made->group[v] = group_for(random, way, position + axes * v);
    if (uses & 1) {
        made->filter.group = made->group;
        made->filter.vertices = vertices;
    }
    if (uses & 2) {
        made->filter.wanted = is_wanted;
        made->filter.context = made;
        made->part = below(random, 17);
    }
}
