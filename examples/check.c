// Where a mesh is bad, and where it intersects itself.
#include <stdio.h>
#include <tanglefree.h>

// Two triangles: the second one stands in the first.
static const double position[] = {0, 0, 0,  4, 0, 0, 0, 4, 0,
                                  1, 1, -1, 1, 1, 1, 2, 1, 1};
static int triangles[] = {0, 1, 2, 3, 4, 6}; // of which the last is wrong

// An error says what is wrong and where; here for people.  A program reads its
// members.
static void print_error(const tf_error *error)
{
    char sentence[200];
    tf_describe(error, sentence, sizeof sentence);
    printf("error: %s\n", sentence);
}

static void print_crossing(const tf_crossing *found)
{
    const int *v = found->vertex;
    if (found->kind == TF_EDGE_THROUGH_TRIANGLE)
        printf("edge %d-%d passes through triangle %d-%d-%d\n", v[0], v[1],
               v[2], v[3], v[4]);
    else if (found->kind == TF_POINT_ON_TRIANGLE)
        printf("vertex %d lies on triangle %d-%d-%d\n", v[0], v[1], v[2], v[3]);
    else
        printf("edge %d-%d touches edge %d-%d\n", v[0], v[1], v[2], v[3]);
}

int main(void)
{
    const tf_mesh mesh = {3, 6, 2, triangles, 0, NULL};
    tf_surface *surface = NULL;
    tf_error error;

    // The library looks at all that it is given, so that files need no check of
    // their own before.
    if (tf_surface_create(&mesh, &surface, &error) != TF_OK)
        print_error(&error);
    triangles[5] = 5;
    if (tf_surface_create(&mesh, &surface, &error) != TF_OK) {
        print_error(&error);
        return 1;
    }

    tf_crossings found;
    if (tf_surface_check(surface, 6, position, NULL, &found, &error) != TF_OK)
        print_error(&error);
    else
        for (size_t i = 0; i < found.count; i++)
            print_crossing(&found.crossing[i]);

    tf_surface_free(surface); // and with it what `found` lists
    return 0;
}
