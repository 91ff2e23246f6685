//: Include what forecasts need
#define _POSIX_C_SOURCE 200809L
#include "scenes/forecast.h"

#include "files/visible.h"
#include "geometry/vector.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <sys/stat.h>

//: Measure the triangles of a file
typedef struct extent {
    double area;  ///< of all triangles, in equilateral ones
    double sides; ///< of all triangles, added up
} extent;

/// In edges of a length.
static void add_triangle(extent *sum, const tf_mesh_file *file, int triangle,
                         double edge)
{
    tf_vector side[3];
    const int *v = file->triangle.item + (ptrdiff_t)3 * triangle;
    for (int i = 0; i < 3; i++)
        side[i] = tf_vector_difference(
            tf_vector_scaled(1 / edge,
                             tf_vector_at(file->position.item, v[(i + 1) % 3])),
            tf_vector_scaled(1 / edge,
                             tf_vector_at(file->position.item, v[i])));
    for (int i = 0; i < 3; i++)
        sum->sides += tf_vector_length(side[i]);
    sum->area +=
        2 / sqrt(3) * tf_vector_length(tf_vector_cross(side[0], side[1]));
}

//: Forecast the triangles of a remesh
/// Two digits are as many as a forecast has.
static double rounded(double number)
{
    double unit = pow(10, floor(log10(number)) - 1);
    return floor(number / unit + 0.5) * unit;
}

void tf_forecast_triangles(const tf_mesh_file *file, double edge)
{
    int triangles = tf_mesh_file_triangles(file);
    extent sum = {0};
    for (int t = 0; t < triangles; t++)
        add_triangle(&sum, file, t, edge);
    if (sum.area > 50000 && sum.area <= INT_MAX / 3.0)
        fprintf(stderr,
                "tanglefree: %s: about %.0f triangles will be made of %d; if "
                "those are too many, give an --edge nearer to the mean edge "
                "length, %.3g\n",
                tf_make_visible(file->name).text, rounded(sum.area), triangles,
                edge * (sum.sides / (3.0 * triangles)));
}

//: Forecast the bytes of frames
double tf_bytes_of(const char *path)
{
    struct stat file;
    return stat(path, &file) == 0 ? (double)file.st_size : 0;
}

void tf_forecast_frames(const char *path, int frames, double bytes)
{
    double total = frames * bytes;
    if (total > 1e8)
        fprintf(stderr,
                "tanglefree: %s: %d frames will be written, about %.1f GB\n",
                tf_make_visible(path).text, frames, total / 1e9);
}
