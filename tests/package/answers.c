// Answer the queries of a file by all arithmetics, and print all bits of the
// answers: what every build of the library must print alike.  A user's program,
// which has only tanglefree.h.
//
//     answers point-edge|point-triangle|edge-edge <FILE
#include <inttypes.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <tanglefree.h>

enum {
    VERTICES = 4, // the most of a query
    AXES = 3,
    LINE = 1024
};

// Kinds -----------------------------------------------------------------------

typedef tf_status ask(const tf_arithmetic *arithmetic, const tf_motion *motion,
                      tf_contact *contact);

static tf_status point_edge(const tf_arithmetic *arithmetic,
                            const tf_motion *motion, tf_contact *contact)
{
    return tf_point_edge(arithmetic, motion, 0, (int[]){1, 2}, contact);
}

static tf_status point_triangle(const tf_arithmetic *arithmetic,
                                const tf_motion *motion, tf_contact *contact)
{
    return tf_point_triangle(arithmetic, motion, 0, (int[]){1, 2, 3}, contact);
}

static tf_status edge_edge(const tf_arithmetic *arithmetic,
                           const tf_motion *motion, tf_contact *contact)
{
    return tf_edge_edge(arithmetic, motion, (int[]){0, 1}, (int[]){2, 3},
                        contact);
}

typedef struct kind {
    const char *name;
    int vertices, axes;
    ask *ask;
} kind;

static const kind kinds[] = {
    {"point-edge", 3, 2, point_edge},
    {"point-triangle", 4, 3, point_triangle},
    {"edge-edge", 4, 3, edge_edge},
};

static const kind *kind_named(const char *name)
{
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (strcmp(kinds[i].name, name) == 0)
            return &kinds[i];
    return NULL;
}

// Queries ---------------------------------------------------------------------

static bool read_vertex(int axes, double vertex[])
{
    char line[LINE];
    if (!fgets(line, sizeof line, stdin))
        return false;
    char *at = line;
    for (int k = 0; k < axes; k++) {
        char *end;
        vertex[k] = strtod(at, &end);
        if (end == at || *end != (k < axes - 1 ? ',' : '\n')) {
            fprintf(stderr, "answers: bad line: %s", line);
            exit(2);
        }
        at = end + 1;
    }
    return true;
}

static bool read_vertices(const kind *asked, double vertices[])
{
    for (int i = 0; i < asked->vertices; i++)
        if (!read_vertex(asked->axes, vertices + i * asked->axes))
            return false;
    return true;
}

// Answers ---------------------------------------------------------------------

static void print_bits(int count, const double numbers[])
{
    for (int i = 0; i < count; i++) {
        uint64_t bits;
        memcpy(&bits, &numbers[i], sizeof bits);
        printf(" %016" PRIx64, bits);
    }
}

static void print_contact(const tf_contact *contact)
{
    printf(" %d %d", (int)contact->verdict, (int)contact->classification);
    print_bits(1, &contact->toi_lo);
    print_bits(1, &contact->toi_hi);
    print_bits(3, contact->barycentric[0]);
    print_bits(3, contact->barycentric[1]);
    print_bits(3, contact->normal);
    print_bits(3, contact->velocity);
    print_bits(1, &contact->normal_velocity);
}

static void answer(const kind *asked, const tf_motion *motion)
{
    const tf_arithmetic *const arithmetics[] = {
        &tf_exact,     &tf_clamped,   &tf_published,
        &tf_perturbed, &tf_integer64, &tf_integer128,
    };
    for (size_t i = 0; i < sizeof arithmetics / sizeof *arithmetics; i++) {
        tf_contact contact;
        tf_status status = asked->ask(arithmetics[i], motion, &contact);
        printf("%s:", tf_arithmetic_name(arithmetics[i]));
        if (status == TF_OK)
            print_contact(&contact);
        else
            printf(" %s", tf_status_message(status));
        putchar('\n');
    }
}

int main(int argc, char *argv[])
{
    const kind *asked = argc == 2 ? kind_named(argv[1]) : NULL;
    if (!asked)
        return 2;
    double start[VERTICES * AXES], end[VERTICES * AXES];
    tf_motion motion = {asked->axes, asked->vertices, start, end};
    while (read_vertices(asked, start) && read_vertices(asked, end))
        answer(asked, &motion);
    return 0;
}
