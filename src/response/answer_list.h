//: Declare a list of answers
#pragma once

#include "response/contact_constraint.h"
#include "response/options.h"
#include "surface/contacts.h"
#include "surface/sort.h"

/// The contacts that the levels have answered in a step, and the constraints of
/// those levels that keep none themselves.  All zero: none.
typedef struct tf_answer_list {
    size_t answers, constraints; ///< how many
    size_t settled; ///< answers of parts of the step that have ended
    size_t settled_constraints;
    bool is_lent; ///< the rows are those of the answers
    tf_buffer answer, constraint, gap;
    tf_buffer row, push, sorting; ///< the rows and pushes that are lent
} tf_answer_list;

void tf_answers_clear(tf_answer_list *list);

/// Makes room for the constraints of some more contacts, and for their gaps, to
/// be filled in before these are added; NULL if there is no memory.
tf_constraint *tf_answers_extend(tf_answer_list *list, size_t contacts,
                                 tf_contact_gap **gap);

/// Adds the contacts that a round has answered.  `zone_constraint` is the number
/// of the first one's constraint among those of the zones, if that is the level.
/// False if there is no memory, or if the caller has cancelled.
bool tf_answers_add(tf_answer_list *list, const tf_contacts *contacts,
                    tf_response_level level, int round, size_t zone_constraint,
                    tf_watch *watch);

/// Ends a part of a step that is taken in several: takes over the constraints of
/// its zones, so that those of the next part may replace them, and turns times
/// into those of the whole step.  False if there is no memory.
bool tf_answers_settle(tf_answer_list *list,
                       const tf_constraint zone_constraint[],
                       const tf_contact_gap zone_gap[], int part, int parts);

/// Drops the answers of the part that has not ended.
void tf_answers_drop(tf_answer_list *list);

/// Lists all answers, sorted, in `row`, and the push of each in `push`.  False if
/// there is no memory.
bool tf_answers_lend(tf_answer_list *list,
                     const tf_constraint zone_constraint[],
                     const tf_contact_gap zone_gap[]);

size_t tf_answers_memory(const tf_answer_list *list);
void tf_answers_free(tf_answer_list *list);
