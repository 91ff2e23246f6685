//: Include what writing a source needs
#define _DEFAULT_SOURCE // fwrite_unlocked
#include "writers/source_writer.h"

#include "files/number.h"
#include "formats/binary.h"
#include "writers/encoder.h"

#include <string.h>

//: Copy a source
typedef struct copier {
    const tf_source *source;
    const double *position;
    tf_encoder to;
    size_t done;            ///< how many bytes of the source are dealt with
    tf_number_type type[3]; ///< in which x, y and z are written
    bool adds_z;
} copier;

static void copy_up_to(copier *c, size_t at)
{
    fwrite_unlocked(c->source->text + c->done, 1, at - c->done, c->to.stream);
    c->done = at;
}

/// Sorts three places in the source.  What is not there comes before what
/// begins at the same place.
static void sort_axes(const size_t at[3], int axis[3])
{
    for (int k = 0; k < 3; k++) {
        int i = k;
        for (; i > 0 && at[axis[i - 1]] >= at[k]; i--)
            axis[i] = axis[i - 1];
        axis[i] = k;
    }
}

//: Compare a coordinate with its source
static bool is_same(double a, double b)
{
    return tf_bits_of(a) == tf_bits_of(b);
}

/// Whether it is the same double; where vertices were welded, 0 has any sign.
static bool is_kept(const tf_source *source, double written, double x)
{
    return is_same(written, x) || (source->welds && written == x);
}

/// Whether the number that is spelled there, or 0 if none is, is kept; `*end`:
/// the byte where it ends.
static bool is_spelled(const tf_source *source, size_t at, double x,
                       size_t *end)
{
    const char *text = source->text + at;
    double spelled = 0;
    tf_number_read(&text, &spelled);
    *end = (size_t)(text - source->text);
    return is_kept(source, spelled, x);
}

static double coordinate(const copier *c, const tf_source_point *point, int k)
{
    return c->position[3 * (size_t)point->vertex + (size_t)k];
}

static bool lacks(const copier *c, int k)
{
    return k == 2 && c->source->lacks_z;
}

//: Choose the types of coordinates
/// In text, numbers may have been read that their type does not hold: these
/// stay.
static bool fits(const copier *c, const tf_source_point *point, int k)
{
    double x = coordinate(c, point, k);
    size_t end;
    if (lacks(c, k))
        return is_same(x, 0);
    return tf_number_fits(c->source->type[k], x) ||
           (c->to.is_text && is_spelled(c->source, point->at[k], x, &end));
}

static bool all_fit(const copier *c, int k)
{
    const tf_source *source = c->source;
    for (size_t i = 0; i < source->points; i++)
        if (!fits(c, &source->point[i], k))
            return false;
    return true;
}

/// Only PLY declares types; all three become double, as readers expect.
static void choose_types(copier *c)
{
    bool declares = c->source->word_length[0] > 0;
    bool fit[3] = {true, true, true};
    for (int k = 0; k < 3 && declares; k++)
        fit[k] = all_fit(c, k);
    for (int k = 0; k < 3; k++)
        c->type[k] =
            fit[0] && fit[1] && fit[2] ? c->source->type[k] : TF_DOUBLE;
    c->adds_z = !fit[2] && c->source->lacks_z;
}

//: Write the header of the source
static void change_word(copier *c, int k)
{
    const tf_source *source = c->source;
    if (source->word_length[k] == 0 || c->type[k] == source->type[k])
        return;
    copy_up_to(c, source->word[k]);
    fputs("double", c->to.stream);
    c->done += source->word_length[k];
}

/// With a line that ends as that of y.
static void declare_z(copier *c)
{
    copy_up_to(c, c->source->y_end);
    const char *end = c->source->text + c->done;
    end += strspn(end, " \t");
    fwrite(end, 1, strspn(end, "\r") + (end[strspn(end, "\r")] == '\n'),
           c->to.stream);
    fputs("property double z", c->to.stream);
}

static void write_header(copier *c)
{
    int axis[3] = {0};
    sort_axes(c->source->word, axis);
    for (int i = 0; i < 3; i++) {
        change_word(c, axis[i]);
        if (axis[i] == 1 && c->adds_z)
            declare_z(c);
    }
}

//: Write a coordinate of the source
/// Only binary STL welds, which has floats.
static double float_at(const copier *c, size_t at)
{
    return (double)tf_gather_float(c->source->text + at, c->to.is_big_endian);
}

/// Whether what is there stays; `*end`: where it ends.
static bool stays(const copier *c, size_t at, int k, double x, size_t *end)
{
    if (lacks(c, k))
        return !c->adds_z;
    if (c->to.is_text)
        return is_spelled(c->source, at, x, end);
    *end = at + (size_t)tf_number_bytes(c->source->type[k]);
    return c->source->welds && is_kept(c->source, float_at(c, at), x);
}

static void write_coordinate(copier *c, const tf_source_point *point, int k)
{
    double x = coordinate(c, point, k);
    size_t at = point->at[k], end = at;
    if (stays(c, at, k, x, &end))
        return;
    copy_up_to(c, at);
    if (end == at)
        tf_encode_blank(&c->to);
    tf_encode(&c->to, c->to.is_text ? TF_DOUBLE : c->type[k], x);
    c->done = end;
}

//: Write a source
void tf_source_write(FILE *stream, const tf_mesh_file *file,
                     const double position[])
{
    const tf_source *source = file->source;
    copier c = {.source = source,
                .position = position,
                .to = {.stream = stream,
                       .is_text = !file->counts_bytes,
                       .is_big_endian = source->is_big_endian}};
    choose_types(&c);
    write_header(&c);
    for (size_t i = 0; i < source->points; i++) {
        int axis[3] = {0};
        sort_axes(source->point[i].at, axis);
        for (int k = 0; k < 3; k++)
            write_coordinate(&c, &source->point[i], axis[k]);
    }
    copy_up_to(&c, source->size);
}
