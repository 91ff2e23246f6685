#include "check.h"

#include "support/moved_simplices.h"
#include "support/support.h"

bool is_inside(const tf_event *p, const tf_event *far, int triangles,
               const tf_event triangle[][3]);

enum {
    BOXES = 2,
    FACETS = 12, // of a box
    SIDE = 8     // of the cube that contains all but the far end
};

/// Boxes and their triangles.
typedef struct surface {
    int low[BOXES][3], high[BOXES][3];
    int triangles;
    tf_event triangle[BOXES * FACETS][3];
} surface;

/// Corner i of a box, at the high end on the axes of the bits of i.
static tf_event corner_of(const surface *s, int box, int i, const int index[])
{
    tf_event corner = {.vertex = index[8 * box + i]};
    for (int k = 0; k < 3; k++)
        corner.x[k] = i >> k & 1 ? s->high[box][k] : s->low[box][k];
    return corner;
}

/// Two triangles a face, with the diagonal from its first corner to its last.
static void add_box(surface *s, int box, const int index[])
{
    for (int axis = 0; axis < 3; axis++)
        for (int side = 0; side < 2; side++) {
            int first = side << axis;
            int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
            for (int half = 0; half < 2; half++) {
                const int corner[3] = {first, first | u | v,
                                       first | (half ? v : u)};
                tf_event *t = s->triangle[s->triangles++];
                for (int j = 0; j < 3; j++)
                    t[j] = corner_of(s, box, corner[j], index);
            }
        }
}

/// A box, or two that may touch, cross or contain each other.
static surface make_surface(generator *random, int boxes, const int index[])
{
    surface s = {.triangles = 0};
    for (int box = 0; box < boxes; box++) {
        for (int k = 0; k < 3; k++) {
            s.low[box][k] = below(random, SIDE / 2);
            s.high[box][k] =
                s.low[box][k] + 1 + below(random, SIDE - s.low[box][k]);
        }
        add_box(&s, box, index);
    }
    return s;
}

/// By hand: how many of the boxes contain the point, moved or not; -1 if it is
/// on the surface of one.
static int count_around(const surface *s, int boxes, const tf_event *p)
{
    int count = 0;
    for (int box = 0; box < boxes; box++) {
        bool inside = true, outside = false;
        for (int k = 0; k < 3; k++) {
            inside &= s->low[box][k] < p->x[k] && p->x[k] < s->high[box][k];
            outside |= p->x[k] < s->low[box][k] || s->high[box][k] < p->x[k];
        }
        if (!inside && !outside)
            return -1;
        count += inside;
    }
    return count;
}

/// How many triangles the segment intersects if everything is moved by explicit
/// numbers.
static int count_moved(const surface *s, const tf_event *p, const tf_event *far)
{
    int count = 0;
    for (int i = 0; i < s->triangles; i++) {
        const tf_event *t = s->triangle[i];
        moved_pair pair = {
            .axes = 3, .s = {2, {p, far}}, .r = {3, {&t[0], &t[1], &t[2]}}};
        count += moved_pair_meets(&pair, NULL);
    }
    return count;
}

static void show_input(const surface *s, int boxes, const tf_event *p,
                       const tf_event *far)
{
    const char *box[BOXES] = {"", ""};
    for (int i = 0; i < boxes; i++) {
        double low[3], high[3];
        for (int k = 0; k < 3; k++) {
            low[k] = s->low[i][k];
            high[k] = s->high[i][k];
        }
        tf_worldline diagonal = tf_worldline_between(3, low, high);
        box[i] = text_line(3, &diagonal);
    }
    check_input("point (vertex %d) at %s, far end (vertex %d) at %s\n"
                "%d triangles of %s %s%s%s",
                p->vertex, text_point(3, p->x), far->vertex,
                text_point(3, far->x), s->triangles,
                boxes == 1 ? "the box" : "the boxes", box[0],
                boxes == 1 ? "" : " and ", box[1]);
}

/// Numbers the corners and the two ends at random.
static void number(generator *random, int count, int index[])
{
    for (int i = 0; i < count; i++) {
        int place = below(random, i + 1);
        index[i] = index[place];
        index[place] = i;
    }
}

static void try_surfaces(int boxes)
{
    generator random = generator_new((uint64_t)boxes);
    for (int i = 0; i < 1000; i++) {
        int index[8 * BOXES + 2];
        number(&random, 8 * boxes + 2, index);
        surface s = make_surface(&random, boxes, index);
        tf_event p = {.vertex = index[8 * boxes]};
        tf_event far = {.vertex = index[8 * boxes + 1]};
        for (int k = 0; k < 3; k++) {
            p.x[k] = below(&random, SIDE + 1);
            far.x[k] = below(&random, SIDE + 1);
        }
        far.x[i % 3] = 2 * SIDE;
        show_input(&s, boxes, &p, &far);
        int around = count_around(&s, boxes, &p);
        if (around < 0)
            around = count_moved(&s, &p, &far);
        bool inside, right = around % 2 == 1;
        check_value(inside, is_inside(&p, &far, s.triangles,
                                      (const tf_event(*)[3])s.triangle));
        int count = inside == right ? 0 : count_moved(&s, &p, &far);
        check_that(inside == right, right ? "true" : "false",
                   "%s, and the moved segment intersects %d of the triangles",
                   inside ? "true" : "false", count);
    }
}

TEST(one_box)
{
    try_surfaces(1);
}

TEST(two_boxes)
{
    try_surfaces(2);
}

void run_tests(void)
{
    check_run(1, one_box);
    check_run(1, two_boxes);
}
