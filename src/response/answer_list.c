//: Include what the list of answers needs
#include "response/answer_list.h"

#include <string.h>

//: Hold an answer
/// A contact that was answered.
typedef struct noted_answer {
    tf_kind kind;
    int vertex[4];
    tf_response_level level;
    int round;
    double toi;
    bool by_zones;     ///< its constraint is in the list of the zones
    size_t constraint; ///< its number there, or in that of the other levels
} noted_answer;

void tf_answers_clear(tf_answer_list *list)
{
    list->answers = list->constraints = 0;
    list->settled = list->settled_constraints = 0;
    list->is_lent = false;
}

//: Add the answers of a round
tf_constraint *tf_answers_extend(tf_answer_list *list, size_t contacts,
                                 tf_contact_gap **gap)
{
    size_t constraints = list->constraints + contacts;
    if (!tf_buffer_extend(&list->constraint, constraints,
                          sizeof(tf_constraint)) ||
        !tf_buffer_extend(&list->gap, constraints, sizeof **gap))
        return NULL;
    *gap = (tf_contact_gap *)list->gap.data + list->constraints;
    return (tf_constraint *)list->constraint.data + list->constraints;
}

bool tf_answers_add(tf_answer_list *list, const tf_contacts *contacts,
                    tf_response_level level, int round, size_t zone_constraint,
                    tf_watch *watch)
{
    size_t constraint = level == TF_ZONES ? zone_constraint : list->constraints;
    if (!tf_buffer_extend(&list->answer, list->answers + contacts->count,
                          sizeof(noted_answer)))
        return false;
    noted_answer *to = (noted_answer *)list->answer.data + list->answers;
    for (size_t i = 0; i < contacts->count && tf_watch_work(watch, 1); i++) {
        const tf_surface_contact *from = &contacts->contact[i];
        to[i] = (noted_answer){.kind = from->kind,
                               .level = level,
                               .round = round,
                               .toi = from->contact.toi_lo,
                               .by_zones = level == TF_ZONES,
                               .constraint = constraint + i};
        memcpy(to[i].vertex, from->vertex, sizeof from->vertex);
    }
    list->answers += contacts->count;
    if (level != TF_ZONES)
        list->constraints += contacts->count;
    return !tf_watch_cancelled(watch);
}

//: Settle the answers of a part
void tf_answers_drop(tf_answer_list *list)
{
    list->answers = list->settled;
    list->constraints = list->settled_constraints;
}

static void take_over(tf_answer_list *list, noted_answer *own,
                      const tf_constraint *constraint,
                      const tf_contact_gap *gap, int part, int parts)
{
    tf_constraint *to = (tf_constraint *)list->constraint.data;
    tf_contact_gap *to_gap = (tf_contact_gap *)list->gap.data;
    size_t place = own->by_zones ? list->constraints++ : own->constraint;
    to[place] = *constraint;
    to_gap[place] = *gap;
    own->constraint = place;
    own->by_zones = false;
    own->toi = (own->toi + part) / parts;
}

bool tf_answers_settle(tf_answer_list *list,
                       const tf_constraint zone_constraint[],
                       const tf_contact_gap zone_gap[], int part, int parts)
{
    size_t answers = list->answers - list->settled;
    tf_contact_gap *gap;
    if (answers > 0 && !tf_answers_extend(list, answers, &gap))
        return false;
    noted_answer *all = list->answer.data;
    const tf_constraint *constraint = list->constraint.data;
    gap = list->gap.data;
    for (; list->settled < list->answers; list->settled++) {
        noted_answer *own = &all[list->settled];
        bool zones = own->by_zones;
        take_over(list, own,
                  (zones ? zone_constraint : constraint) + own->constraint,
                  (zones ? zone_gap : gap) + own->constraint, part, parts);
    }
    list->settled_constraints = list->constraints;
    return true;
}

//: Compare answers
/// Answers of the same elements stay in their order, that of levels and rounds.
static bool answered_first(const void *first, const void *second)
{
    const noted_answer *a = first, *b = second;
    if (a->kind != b->kind)
        return a->kind < b->kind;
    for (int i = 0; i < 4; i++)
        if (a->vertex[i] != b->vertex[i])
            return a->vertex[i] < b->vertex[i];
    return false;
}

//: Write the entry of an answer
/// A constraint has only the vertices that it pushes.
static void copy_coefficients(const tf_constraint *constraint,
                              tf_answered_contact *row)
{
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4 && constraint->vertex[j] >= 0; j++)
            if (constraint->vertex[j] == row->vertex[i])
                row->coefficient[i] = constraint->coefficient[j];
}

static tf_answered_contact row_of(const noted_answer *from,
                                  const tf_constraint *constraint)
{
    tf_answered_contact row = {.kind = from->kind,
                               .level = from->level,
                               .round = from->round,
                               .toi = from->toi,
                               .impulse = constraint->impulse};
    memcpy(row.vertex, from->vertex, sizeof row.vertex);
    memcpy(row.normal, constraint->normal, sizeof row.normal);
    memcpy(row.friction, constraint->friction, sizeof row.friction);
    copy_coefficients(constraint, &row);
    return row;
}

//: Lend the answers
static const void **sort_answers(tf_answer_list *list)
{
    const noted_answer *all = list->answer.data;
    const void **sorted = list->sorting.data;
    for (size_t i = 0; i < list->answers; i++)
        sorted[i] = &all[i];
    return tf_sort(list->answers, sorted, sorted + list->answers,
                   answered_first, NULL);
}

bool tf_answers_lend(tf_answer_list *list,
                     const tf_constraint zone_constraint[],
                     const tf_contact_gap zone_gap[])
{
    size_t count = list->answers;
    if (list->is_lent || count == 0)
        return true;
    if (!tf_buffer_reserve(&list->row, count, sizeof(tf_answered_contact)) ||
        !tf_buffer_reserve(&list->push, count, sizeof(double)) ||
        !tf_buffer_reserve(&list->sorting, 2 * count, sizeof(void *)))
        return false;
    const void **sorted = sort_answers(list);
    tf_answered_contact *row = list->row.data;
    double *push = list->push.data;
    for (size_t i = 0; i < count; i++) {
        const noted_answer *own = sorted[i];
        bool zones = own->by_zones;
        const tf_constraint *constraint =
            zones ? zone_constraint : list->constraint.data;
        const tf_contact_gap *gap = zones ? zone_gap : list->gap.data;
        row[i] = row_of(own, &constraint[own->constraint]);
        push[i] = gap[own->constraint].push;
    }
    list->is_lent = true;
    return true;
}

//: Account for the memory of answers
size_t tf_answers_memory(const tf_answer_list *list)
{
    return list->answer.bytes + list->constraint.bytes + list->gap.bytes +
           list->row.bytes + list->push.bytes + list->sorting.bytes;
}

void tf_answers_free(tf_answer_list *list)
{
    tf_buffer_free(&list->answer);
    tf_buffer_free(&list->constraint);
    tf_buffer_free(&list->gap);
    tf_buffer_free(&list->row);
    tf_buffer_free(&list->push);
    tf_buffer_free(&list->sorting);
}
