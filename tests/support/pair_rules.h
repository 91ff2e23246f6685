// Random filters of pairs, and which pairs they keep, without a surface.
#ifndef SUPPORT_PAIR_RULES_H
#define SUPPORT_PAIR_RULES_H

#include "support/generator.h"
#include "support/tangle.h"
#include "surface/check.h"
#include "surface/contacts.h"
#include "surface/pair_filter.h"

enum {
    RULE_VERTICES = 400
};

/// A filter, and what it is made of.  Where it is, its filter points to.
typedef struct pair_rule {
    tf_pair_filter filter;
    int axes;
    int group[RULE_VERTICES];
    uint64_t salt;
    int part; ///< how many of 16 pairs the callback leaves out
    bool weighs;
    double inverse_mass[RULE_VERTICES]; ///< if it weighs: pairs are left out
                                        ///< whose vertices all have 0
} pair_rule;

/// Makes a filter by groups, by a callback, or by both.  The callback aborts if
/// it is not asked as it should be.
/// @param position of the vertices: some groups are on one side of a plane
void pair_rule_make(generator *random, int axes, int vertices,
                    const double position[], pair_rule *made);

/// Gives the vertices masses, some or most inverse ones 0; returns these.
const double *pair_rule_weigh(generator *random, int vertices, pair_rule *made);

/// Whether a step has the pair, whose vertices are those of a contact.
bool pair_rule_keeps(const pair_rule *rule, tf_kind kind, const int vertex[]);

/// Whether a check has the pair.
bool pair_rule_keeps_crossing(const pair_rule *rule,
                              const tf_crossing *crossing);

/// How many tangles are of pairs that the rule keeps.
int pair_rule_count_tangles(const pair_rule *rule, int count,
                            const tangle found[]);

#endif
