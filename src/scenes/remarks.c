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
    fputs("; so are those of further files, without a message\n", stderr);
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
    static bool lines_printed, volumes_printed, flat_printed;
    int lines = file->left_out[1], volumes = file->left_out[3];
    int flat = file->left_out[2];
    if (lines > 0)
        print_once(&lines_printed, file, "%d line%s left out, as %s no surface",
                   lines, lines == 1 ? " is" : "s are",
                   lines == 1 ? "it is" : "they are");
    if (volumes > 0)
        print_once(&volumes_printed, file,
                   "%d volume%s left out, as %s no surface", volumes,
                   volumes == 1 ? " is" : "s are",
                   volumes == 1 ? "it is" : "they are");
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
