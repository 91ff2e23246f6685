//: Include what summaries need
#include "program/summary.h"

#include <math.h>

//: Make an entry
tf_entry tf_entry_count(const char *name, size_t count)
{
    return (tf_entry){.name = name, .kind = TF_ENTRY_COUNT, .count = count};
}

tf_entry tf_entry_number(const char *name, double number)
{
    return (tf_entry){.name = name, .kind = TF_ENTRY_NUMBER, .number = number};
}

tf_entry tf_entry_word(const char *name, const char *word)
{
    return (tf_entry){.name = name, .kind = TF_ENTRY_WORD, .word = word};
}

//: Write a summary for people
static void write_entry(FILE *stream, const tf_entry *entry)
{
    fprintf(stream, "%s: ", entry->name);
    if (entry->kind == TF_ENTRY_WORD)
        fprintf(stream, "%s\n", entry->word);
    else if (entry->kind == TF_ENTRY_NUMBER)
        fprintf(stream, "%g\n", entry->number);
    else
        fprintf(stream, "%zu\n", entry->count);
}

void tf_summary_write(FILE *stream, int entries, const tf_entry entry[])
{
    for (int i = 0; i < entries; i++)
        write_entry(stream, &entry[i]);
}

//: Write a summary as JSON
static void write_key(FILE *stream, const char *name)
{
    fputc('"', stream);
    for (; *name; name++)
        fputc(*name == ' ' ? '_' : *name, stream);
    fputs("\":", stream);
}

static void write_json_value(FILE *stream, const tf_entry *entry)
{
    if (entry->kind == TF_ENTRY_WORD)
        fprintf(stream, "\"%s\"", entry->word);
    else if (entry->kind == TF_ENTRY_COUNT)
        fprintf(stream, "%zu", entry->count);
    else if (isfinite(entry->number))
        fprintf(stream, "%.17g", entry->number);
    else
        fputs("null", stream);
}

void tf_summary_write_json(FILE *stream, int entries, const tf_entry entry[])
{
    for (int i = 0; i < entries; i++) {
        fputs(i > 0 ? "," : "{", stream);
        write_key(stream, entry[i].name);
        write_json_value(stream, &entry[i]);
    }
    fputc('}', stream);
}
