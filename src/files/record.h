//: Declare the fields of records
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/// The type of a member of a structure, and which of its values is none.
typedef enum tf_field_type {
    TF_COUNT,   ///< size_t
    TF_INTEGER, ///< int; below 0: none
    TF_NUMBER,  ///< double; not a number: none
    TF_WORD,    ///< const char *; NULL: none
    TF_EMPTY    ///< no member: a column of CSV alone, without values
} tf_field_type;

/// A field of a record, which is a structure that is written as a row of CSV, as
/// an object of JSON or as the lines of a summary.  A list of fields ends with
/// one that has no name.
typedef struct tf_field {
    const char *name; ///< in CSV and JSON with a _ for each blank
    tf_field_type type;
    size_t offset;      ///< of the member
    const char *format; ///< of a number in CSV, as printf; NULL: "%.17g"
} tf_field;

/// A field whose type is that of the member; numbers in CSV as `format` says.
#define TF_FIELD(name, record, member) TF_FIELD_AS(name, record, member, NULL)
#define TF_FIELD_AS(name, record, member, format)                              \
    {                                                                          \
        name, TF_FIELD_TYPE(((record *)0)->member), offsetof(record, member),  \
            format                                                             \
    }
#define TF_FIELD_TYPE(value)                                                   \
    _Generic((value), size_t                                                   \
             : TF_COUNT, int                                                   \
             : TF_INTEGER, double                                              \
             : TF_NUMBER, const char *                                         \
             : TF_WORD)

/// Lists a field and those of another list.
void tf_fields_join(tf_field all[], const tf_field *first,
                    const tf_field rest[]);

//: Declare how to write a record
/// Write the names of the fields as the first line of CSV, or the values as a
/// line, with nothing where there is none, and words in quotes where they need
/// them.
void tf_record_write_head(FILE *stream, const tf_field field[]);
void tf_record_write_csv(FILE *stream, const tf_field field[],
                         const void *record);

/// Writes an object: all digits of numbers, null where there is no value or no
/// finite number.
void tf_record_write_json(FILE *stream, const tf_field field[],
                          const void *record);

/// Writes a line "name: value" for each field that has a value.
void tf_record_write_lines(FILE *stream, const tf_field field[],
                           const void *record);

//: Declare formats
typedef enum tf_format {
    TF_CSV,
    TF_JSON,
    TF_SUMMARY
} tf_format;

/// Writes a record as a heading and a row of CSV, as a line of JSON or as a
/// summary, and flushes.  False, with errno, if a write failed.
bool tf_report_write(FILE *stream, tf_format format, const tf_field field[],
                     const void *record);

//: Declare how to write many records
/// Records that are written one by one: as CSV with a heading; as an array of
/// JSON; or not at all where only a summary is wanted.
typedef struct tf_records {
    FILE *stream;
    tf_format format;
    const char *name; ///< of the array, in an object with a summary; or NULL
    const tf_field *field;
    size_t count;
    int error; ///< the errno of the first write that failed, or 0
} tf_records;

/// Each writes its part, and returns false after a write that failed.  The end
/// has the summary, unless that is for CSV or `field` is NULL, and flushes.  What
/// comes before the records is written with the first one, or at the end: after
/// an error before both there is nothing.
void tf_records_begin(tf_records *records, FILE *stream, tf_format format,
                      const char *name, const tf_field field[]);
bool tf_records_add(tf_records *records, const void *record);
bool tf_records_end(tf_records *records, const tf_field field[],
                    const void *summary);
