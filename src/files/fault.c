//: Include what faults need
#include "files/fault.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

//: Set a fault
bool tf_fault_set_list(tf_fault *fault, const char *file, long place,
                       const char *format, va_list arguments)
{
    fault->file = file;
    fault->place = place;
    fault->counts_bytes = false;
    vsnprintf(fault->text, sizeof fault->text, format, arguments);
    return false;
}

bool tf_fault_set(tf_fault *fault, const char *file, long place,
                  const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    tf_fault_set_list(fault, file, place, format, arguments);
    va_end(arguments);
    return false;
}

//: Set a fault of the system
/// How much of a path is that of the folder that it is in: of a/b and of a/b/, a.
static size_t length_of_folder(const char *path)
{
    size_t length = strlen(path);
    while (length > 0 && path[length - 1] == '/')
        length--;
    while (length > 0 && path[length - 1] != '/')
        length--;
    return length > 0 ? length - 1 : 0;
}

bool tf_fault_set_unwritten(tf_fault *fault, const char *file, int reason)
{
    char folder[TF_VISIBLE_ROOM];
    int length = (int)length_of_folder(file);
    snprintf(folder, sizeof folder, "%.*s", length, file);
    if (reason == ENOENT && length > 0)
        return tf_fault_set(
            fault, file, -1,
            "there is no folder '%s'; make it, or choose another",
            tf_make_visible(folder).text);
    return tf_fault_set(fault, file, -1,
                        "cannot write: %s; mend that, and run again",
                        strerror(reason));
}

bool tf_fault_set_unopened(tf_fault *fault, const char *file, int reason)
{
    return tf_fault_set(fault, file, -1, "cannot open: %s; check the name",
                        strerror(reason));
}

bool tf_fault_set_unread(tf_fault *fault, const char *file, long place,
                         int reason)
{
    return tf_fault_set(fault, file, place,
                        "cannot read: %s; check that this is a file",
                        strerror(reason));
}

//: Print a fault
void tf_fault_print(const tf_fault *fault, const char *program)
{
    if (fault->text[0] == '\0')
        return;
    fprintf(stderr, "%s: %s:", program, tf_make_visible(fault->file).text);
    if (fault->place >= 0)
        fprintf(stderr,
                fault->counts_bytes ? " byte %ld:" : "%ld:", fault->place);
    fprintf(stderr, " %s\n", fault->text);
}
