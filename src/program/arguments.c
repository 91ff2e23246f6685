//: Include what arguments need
#include "program/arguments.h"

#include "files/number.h"
#include "files/visible.h"
#include "program/threads.h"

#include <stdlib.h>
#include <string.h>

//: Refuse a name
void tf_refuse_name(struct argp_state *state, const char *what,
                    const char *name, const char *names)
{
    argp_error(state, "unknown %s '%s'; choose %s", what,
               tf_make_visible(name).text, names);
}

//: Parse a number
double tf_parse_number(struct argp_state *state, const char *option,
                       const char *text, double most, const char *wanted)
{
    const char *rest = text;
    double number = -1;
    if (!tf_number_read(&rest, &number) || *rest != '\0' ||
        !(number >= 0 && number <= most))
        argp_error(state, "--%s needs a number, %s, and not '%s'", option,
                   wanted, tf_make_visible(text).text);
    return number;
}

//: Parse a number of threads
int tf_parse_threads(struct argp_state *state, const char *text)
{
    char *end;
    long threads = strtol(text, &end, 10);
    if (end == text || *end || threads < 1 || threads > TF_MOST_THREADS)
        argp_error(state, "'%s' is not a number of threads; choose 1 to %d",
                   tf_make_visible(text).text, TF_MOST_THREADS);
    return (int)threads;
}

//: Parse a format
tf_format tf_parse_format(struct argp_state *state, const char *text, bool rows)
{
    if (strcmp(text, "json") == 0)
        return TF_JSON;
    if (rows && strcmp(text, "csv") == 0)
        return TF_CSV;
    if (strcmp(text, "summary") != 0)
        tf_refuse_name(state, "output format", text,
                       rows ? TF_ROWS_FORMAT_NAMES : TF_REPORT_FORMAT_NAMES);
    return TF_SUMMARY;
}
