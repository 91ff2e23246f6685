//: Include what remarks need
#include "scenes/remarks.h"

#include <stdarg.h>
#include <stdio.h>

//: Print a remark
/// Unless that was done before: what is printed of all later files is the same.
__attribute__((format(printf, 3, 4))) static void
print_once(bool *printed, const tf_mesh_file *file, const char *format, ...)
{
    if (*printed)
        return;
    *printed = true;
    va_list arguments;
    va_start(arguments, format);
    fprintf(stderr, "tanglefree: %s: ", tf_make_visible(file->name).text);
    vfprintf(stderr, format, arguments);
    fputs("; so in further files, of which nothing is said\n", stderr);
    va_end(arguments);
}

//: Print remarks on a file
static void print_polygons(const tf_mesh_file *file)
{
    static bool printed = false;
    int polygons = tf_mesh_file_polygons(file);
    if (polygons > 0)
        print_once(&printed, file,
                   "%d face%s with more than three corners %s triangulated",
                   polygons, polygons == 1 ? "" : "s",
                   polygons == 1 ? "is" : "are");
}

/// Points are no elements of a surface anyway.
static void print_left_out(const tf_mesh_file *file)
{
    static bool printed = false, flat_printed = false;
    int lines = file->left_out[1], volumes = file->left_out[3];
    int flat = file->left_out[2];
    if (lines + volumes > 0)
        print_once(&printed, file,
                   "what is no surface is left out: %d line%s and %d volume%s",
                   lines, lines == 1 ? "" : "s", volumes,
                   volumes == 1 ? "" : "s");
    if (flat > 0)
        print_once(&flat_printed, file,
                   "%d triangle%s with two corners at one position %s left out",
                   flat, flat == 1 ? "" : "s", flat == 1 ? "is" : "are");
}

void tf_remarks_print(const tf_mesh_file *file)
{
    print_polygons(file);
    print_left_out(file);
}
