//: Include what records need
#include "files/record.h"

#include "files/visible.h"

#include <errno.h>
#include <math.h>
#include <string.h>

//: Join fields
void tf_fields_join(tf_field all[], const tf_field *first,
                    const tf_field rest[])
{
    int count = 0;
    all[count++] = *first;
    for (; rest->name; rest++)
        all[count++] = *rest;
    all[count] = (tf_field){0};
}

//: Find the value of a field
static const void *member(const tf_field *field, const void *record)
{
    return (const char *)record + field->offset;
}

static bool has_value(const tf_field *field, const void *record)
{
    const void *value = member(field, record);
    switch (field->type) {
    case TF_INTEGER:
        return *(const int *)value >= 0;
    case TF_NUMBER:
        return !isnan(*(const double *)value);
    case TF_WORD:
        return *(const char *const *)value;
    default:
        return field->type == TF_COUNT;
    }
}

//: Write a value
typedef void word_writer(FILE *stream, const char *word);

/// Numbers as `format` says.
static void write_value(FILE *stream, const tf_field *field, const void *record,
                        const char *format, word_writer *write_word)
{
    const void *value = member(field, record);
    if (field->type == TF_COUNT)
        fprintf(stream, "%zu", *(const size_t *)value);
    else if (field->type == TF_INTEGER)
        fprintf(stream, "%d", *(const int *)value);
    else if (field->type == TF_NUMBER)
        fprintf(stream, format, *(const double *)value);
    else
        write_word(stream, *(const char *const *)value);
}

//: Write the name of a field
/// With a _ for each blank.
static void write_name(FILE *stream, const char *name)
{
    for (; *name; name++)
        fputc(*name == ' ' ? '_' : *name, stream);
}

//: Write a record as CSV
/// In quotes where it needs them.
static void write_csv_word(FILE *stream, const char *word)
{
    bool quoted = strpbrk(word, ",\"\r\n");
    fputs(quoted ? "\"" : "", stream);
    for (; *word; word++) {
        fputs(*word == '"' ? "\"" : "", stream);
        fputc(*word, stream);
    }
    fputs(quoted ? "\"" : "", stream);
}

void tf_record_write_head(FILE *stream, const tf_field field[])
{
    for (int i = 0; field[i].name; i++) {
        fputs(i > 0 ? "," : "", stream);
        write_name(stream, field[i].name);
    }
    fputc('\n', stream);
}

void tf_record_write_csv(FILE *stream, const tf_field field[],
                         const void *record)
{
    for (int i = 0; field[i].name; i++) {
        const char *format = field[i].format ? field[i].format : "%.17g";
        fputs(i > 0 ? "," : "", stream);
        if (has_value(&field[i], record))
            write_value(stream, &field[i], record, format, write_csv_word);
    }
    fputc('\n', stream);
}

//: Write a record as JSON
/// A string of JSON must be UTF-8.
static void write_json_word(FILE *stream, const char *word)
{
    tf_visible shown = tf_make_visible(word);
    fputc('"', stream);
    for (const char *c = shown.text; *c; c++) {
        fputs(*c == '"' || *c == '\\' ? "\\" : "", stream);
        fputc(*c, stream);
    }
    fputc('"', stream);
}

static bool is_infinite(const tf_field *field, const void *record)
{
    return field->type == TF_NUMBER &&
           isinf(*(const double *)member(field, record));
}

void tf_record_write_json(FILE *stream, const tf_field field[],
                          const void *record)
{
    for (int i = 0; field[i].name; i++) {
        if (field[i].type == TF_EMPTY)
            continue;
        fputs(i > 0 ? "," : "{", stream);
        fputc('"', stream);
        write_name(stream, field[i].name);
        fputs("\":", stream);
        if (has_value(&field[i], record) && !is_infinite(&field[i], record))
            write_value(stream, &field[i], record, "%.17g", write_json_word);
        else
            fputs("null", stream);
    }
    fputc('}', stream);
}

//: Write a record as lines
static void write_plain_word(FILE *stream, const char *word)
{
    fputs(word, stream);
}

void tf_record_write_lines(FILE *stream, const tf_field field[],
                           const void *record)
{
    for (int i = 0; field[i].name; i++)
        if (has_value(&field[i], record)) {
            fprintf(stream, "%s: ", field[i].name);
            write_value(stream, &field[i], record, "%g", write_plain_word);
            fputc('\n', stream);
        }
}

//: Write a report
bool tf_report_write(FILE *stream, tf_format format, const tf_field field[],
                     const void *record)
{
    if (format == TF_CSV) {
        tf_record_write_head(stream, field);
        tf_record_write_csv(stream, field, record);
    } else if (format == TF_JSON) {
        tf_record_write_json(stream, field, record);
        fputc('\n', stream);
    } else
        tf_record_write_lines(stream, field, record);
    return fflush(stream) == 0 && !ferror(stream);
}

//: Notice a write that failed
// Called after every record, before errno can change.
static bool written(tf_records *records)
{
    if (ferror(records->stream) && records->error == 0)
        records->error = errno;
    return records->error == 0;
}

//: Write many records
void tf_records_begin(tf_records *records, FILE *stream, tf_format format,
                      const char *name, const tf_field field[])
{
    *records = (tf_records){
        .stream = stream, .format = format, .name = name, .field = field};
}

/// Writes what comes before the first record.
static bool begin_rows(tf_records *records)
{
    if (records->count > 0)
        return true;
    if (records->format == TF_CSV)
        tf_record_write_head(records->stream, records->field);
    else if (records->format == TF_JSON && records->name)
        fprintf(records->stream, "{\"%s\":[", records->name);
    else if (records->format == TF_JSON)
        fputc('[', records->stream);
    return written(records);
}

bool tf_records_add(tf_records *records, const void *record)
{
    if (!begin_rows(records))
        return false;
    if (records->format == TF_CSV)
        tf_record_write_csv(records->stream, records->field, record);
    if (records->format == TF_JSON) {
        fputs(records->count > 0 ? ",\n" : "\n", records->stream);
        tf_record_write_json(records->stream, records->field, record);
    }
    records->count++;
    return written(records);
}

//: End many records
static void end_json(const tf_records *records, const tf_field field[],
                     const void *summary)
{
    fputs("\n]", records->stream);
    if (records->name) {
        fputs(",\n\"summary\":", records->stream);
        tf_record_write_json(records->stream, field, summary);
        fputc('}', records->stream);
    }
    fputc('\n', records->stream);
}

bool tf_records_end(tf_records *records, const tf_field field[],
                    const void *summary)
{
    if (!begin_rows(records))
        return false;
    if (records->format == TF_JSON)
        end_json(records, field, summary);
    else if (records->format == TF_SUMMARY && field)
        tf_record_write_lines(records->stream, field, summary);
    fflush(records->stream);
    return written(records);
}
