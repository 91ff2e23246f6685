//: Include what hints at seams need
#include "scenes/seams.h"

#include "scenes/coincident.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

//: Find intersections at seams
/// How many intersections a mesh has with itself, and how many of these are of
/// elements that have corners at one position.
typedef struct seam_count {
    size_t all, at_seams;
} seam_count;

static bool is_at_seam(const double x[], const int vertex[5], int first)
{
    bool found = false;
    for (int i = 0; i < first; i++)
        for (int j = first; j < 5 && vertex[j] >= 0; j++) {
            const double *a = x + 3 * (size_t)vertex[i];
            const double *b = x + 3 * (size_t)vertex[j];
            found = found || (a[0] == b[0] && a[1] == b[1] && a[2] == b[2]);
        }
    return found;
}

static void count_crossing(const tf_scene_frames *frames,
                           const tf_crossing *crossing, seam_count count[])
{
    int vertex[5], mesh[2];
    int first = crossing->kind == TF_POINT_ON_TRIANGLE ? 1 : 2;
    memcpy(vertex, crossing->vertex, sizeof vertex);
    tf_joined_localize(&frames->joined, 5, vertex, first, mesh);
    if (mesh[0] != mesh[1])
        return;
    count[mesh[0]].all++;
    count[mesh[0]].at_seams +=
        is_at_seam(tf_scene_frames_positions(frames, mesh[0]), vertex, first);
}

//: Hint at seams
/// How many vertices of a mesh coincide with others; -1: there is no memory.
static int count_coincident(const tf_scene_frames *frames, int mesh)
{
    const int *own = frames->joined.first_vertex + mesh;
    int vertices = own[1] - own[0], count = -1;
    int *first = malloc(((size_t)vertices + 1) * sizeof *first);
    if (first &&
        tf_find_coincident(vertices, tf_scene_frames_positions(frames, mesh), 0,
                           first))
        count = 0;
    for (int v = 0; v < vertices && count >= 0; v++)
        count += first[v] != v;
    free(first);
    return count;
}

static void hint(const tf_scene_frames *frames, int mesh,
                 const seam_count *count, const char *name)
{
    int coincident = count_coincident(frames, mesh);
    if (coincident > 0)
        fprintf(stderr,
                "tanglefree: %s: %zu of %zu intersections are between elements "
                "with corners at the same position, as at an unwelded seam; %d "
                "vert%s with others, which 'tanglefree weld' joins\n",
                tf_make_visible(name).text, count->at_seams, count->all,
                coincident, coincident == 1 ? "ex coincides" : "ices coincide");
}

void tf_hint_at_seams(const tf_scene_frames *frames, const tf_crossings *found,
                      const char *const name[], bool hinted[])
{
    seam_count *count =
        calloc((size_t)frames->joined.meshes + 1, sizeof *count);
    for (size_t i = 0; i < found->count && count; i++)
        count_crossing(frames, &found->crossing[i], count);
    for (int m = 0; m < frames->joined.meshes && count; m++)
        if (count[m].at_seams > 0 && !hinted[m]) {
            hint(frames, m, &count[m], name[m]);
            hinted[m] = true;
        }
    free(count);
}
