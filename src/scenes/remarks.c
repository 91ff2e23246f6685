//: Include what remarks need
#include "scenes/remarks.h"

#include <stdio.h>

//: Print remarks on a file
static void print_polygons(const tf_mesh_file *file)
{
    static bool printed = false;
    int polygons = tf_mesh_file_polygons(file);
    if (polygons == 0 || printed)
        return;
    printed = true;
    fprintf(stderr,
            "tanglefree: %s: %d face%s with more than three corners %s "
            "triangulated (here and in all further files)\n",
            tf_make_visible(file->name).text, polygons,
            polygons == 1 ? "" : "s", polygons == 1 ? "was" : "were");
}

void tf_remarks_print(const tf_mesh_file *file)
{
    print_polygons(file);
}
