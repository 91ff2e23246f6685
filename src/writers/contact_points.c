//: Include what the points of contacts need
#include "writers/contact_points.h"

#include <string.h>

//: Lay out the rows of contacts
enum {
    POSITION = 0, // the first column of each
    NORMAL = 3,
    TIME = 6,
    KIND,
    VERTICES,
    NORMAL_VELOCITY = 12,
    IMPULSE = 12,
    PUSH = 15,
    LEVEL,
    ROUND,
    WIDTH
};

/// An array of the points.
typedef struct part {
    const char *name;
    tf_number_type type;
    int components, column;
} part;

static const part found_parts[] = {
    {"normal", TF_DOUBLE, 3, NORMAL},
    {"time", TF_DOUBLE, 1, TIME},
    {"kind", TF_UCHAR, 1, KIND},
    {"vertices", TF_INT, 4, VERTICES},
    {"normal_velocity", TF_DOUBLE, 1, NORMAL_VELOCITY},
    {0},
};

static const part answered_parts[] = {
    {"normal", TF_DOUBLE, 3, NORMAL},
    {"time", TF_DOUBLE, 1, TIME},
    {"kind", TF_UCHAR, 1, KIND},
    {"vertices", TF_INT, 4, VERTICES},
    {"impulse", TF_DOUBLE, 3, IMPULSE},
    {"push", TF_DOUBLE, 1, PUSH},
    {"level", TF_UCHAR, 1, LEVEL},
    {"round", TF_INT, 1, ROUND},
    {0},
};

//: Find the point of a contact
static int first_vertices(tf_kind kind)
{
    return kind == TF_EDGE_EDGE ? 2 : 1;
}

/// Adds a point of the first element at a time, by its weights.
static void place(double row[], const tf_motion *motion, tf_kind kind,
                  const int vertex[], const double weight[], double time)
{
    for (int i = 0; i < first_vertices(kind); i++) {
        size_t at = (size_t)motion->axes * (size_t)vertex[i];
        for (int k = 0; k < motion->axes; k++) {
            double start = motion->start[at + (size_t)k];
            double end = motion->end[at + (size_t)k];
            row[POSITION + k] +=
                weight[i] * (time < 1 ? start + time * (end - start) : end);
        }
    }
}

static void set_common(double row[], const double normal[3], double time,
                       tf_kind kind, const int vertex[4])
{
    memcpy(row + NORMAL, normal, 3 * sizeof *row);
    row[TIME] = time;
    row[KIND] = kind;
    for (int i = 0; i < 4; i++)
        row[VERTICES + i] = vertex[i];
}

//: Set the points of contacts
static void begin(tf_contact_points *points, bool answered)
{
    tf_columns_free(&points->row);
    points->row.count = WIDTH;
    points->answered = answered;
}

bool tf_contact_points_found(tf_contact_points *points, const tf_motion *motion,
                             const tf_contacts *contacts)
{
    begin(points, false);
    bool good = true;
    for (size_t i = 0; i < contacts->count && good; i++) {
        const tf_surface_contact *found = &contacts->contact[i];
        const tf_contact *contact = &found->contact;
        double row[WIDTH] = {0}, time = contact->toi_lo;
        place(row, motion, found->kind, found->vertex, contact->barycentric[0],
              time);
        set_common(row, contact->normal, time, found->kind, found->vertex);
        row[NORMAL_VELOCITY] = contact->normal_velocity;
        good = tf_columns_add(&points->row, row);
    }
    return good;
}

//: Set the points of answered contacts
bool tf_contact_points_answered(tf_contact_points *points,
                                const tf_motion *motion, size_t count,
                                const tf_answered_contact contact[],
                                const double push[])
{
    begin(points, true);
    bool good = true;
    for (size_t i = 0; i < count && good; i++) {
        const tf_answered_contact *c = &contact[i];
        double row[WIDTH] = {0};
        place(row, motion, c->kind, c->vertex, c->coefficient, 1);
        set_common(row, c->normal, c->toi, c->kind, c->vertex);
        for (int k = 0; k < 3; k++)
            row[IMPULSE + k] = c->impulse * c->normal[k] + c->friction[k];
        row[PUSH] = push[i];
        row[LEVEL] = c->level;
        row[ROUND] = c->round;
        good = tf_columns_add(&points->row, row);
    }
    return good;
}

void tf_contact_points_free(tf_contact_points *points)
{
    tf_columns_free(&points->row);
}

//: Make PolyData of contacts
tf_polydata tf_contact_points_data(const tf_contact_points *points)
{
    const tf_columns *rows = &points->row;
    tf_polydata data = tf_polydata_of(rows->rows, rows->value, WIDTH);
    data.verts = tf_polydata_cells_of(rows->rows, 1, NULL);
    const part *own = points->answered ? answered_parts : found_parts;
    for (; own->name; own++)
        tf_polydata_add(
            &data, &(tf_polydata_array){
                       .name = own->name,
                       .type = own->type,
                       .components = own->components,
                       .rows = rows->rows,
                       .number = rows->value ? rows->value + own->column : NULL,
                       .stride = WIDTH});
    return data;
}
