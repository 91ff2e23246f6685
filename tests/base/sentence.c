#include "base/sentence.h"

#include "support/support.h"

#include <string.h>

static const struct {
    tf_error error;
    int first;
    const char *sentence;
} expected[] = {
    {{.status = TF_BAD_INDEX,
      .subject = TF_TRIANGLE,
      .index = 7,
      .vertex = {12, -1, -1, -1, -1},
      .vertices = 12,
      .time = -1},
     0,
     "triangle 7: there is no vertex 12; they are numbered from 0 to 11"},
    {{.status = TF_BAD_INDEX,
      .vertex = {12},
      .vertices = 12,
      .subject = TF_EDGE},
     1,
     "edge 0 at the start of the step: there is no vertex 13; they are "
     "numbered "
     "from 1 to 12"},
    {{.status = TF_BAD_INDEX,
      .subject = TF_BATCH_QUERY,
      .index = 1,
      .vertex = {3},
      .vertices = 12,
      .time = -1},
     0,
     "query 1: vertex 3 is there twice; give different ones"},
    {{.status = TF_BAD_INDEX,
      .subject = TF_TRIANGLE,
      .index = 1,
      .vertex = {3},
      .vertices = 12,
      .time = -1},
     0,
     "triangle 1: vertex 3 is a corner twice; delete the triangle or edge"},
    {{.status = TF_NOT_FINITE, .subject = TF_VERTEX, .index = 3, .time = 1},
     1,
     "vertex 4 at the end of the step: a coordinate is infinite or NaN; give "
     "finite positions"},
    {{.status = TF_NOT_FINITE,
      .subject = TF_BATCH_QUERY,
      .index = 3,
      .vertex = {8},
      .time = 0},
     1,
     "query 3, vertex 9 at the start of the step: a coordinate is infinite or "
     "NaN; give finite positions"},
    {{.status = TF_BAD_OPTION,
      .subject = TF_OPTION,
      .option = "restitution",
      .range = "from 0 to 1",
      .value = 1.5},
     0,
     "restitution must be from 0 to 1, got 1.5"},
    {{.status = TF_BAD_OPTION,
      .subject = TF_VERTEX,
      .index = 3,
      .vertex = {3, -1, -1, -1, -1},
      .time = -1,
      .option = "vertex_friction",
      .range = "finite, 0 or more",
      .value = -1},
     1,
     "vertex 4: vertex_friction must be finite, 0 or more, got -1"},
    {{.status = TF_START_NOT_CLEAR,
      .subject = TF_POINT_TRIANGLE_PAIR,
      .vertex = {5, 1, 2, 3, -1}},
     0,
     "vertex 5 lies on triangle 1 2 3 (numbered from 0) before the step "
     "begins; move them apart"},
    {{.status = TF_NOT_EMBEDDED,
      .subject = TF_EDGE_TRIANGLE_PAIR,
      .vertex = {0, 1, 2, 3, 4}},
     1,
     "edge 1 2 passes through triangle 3 4 5 (numbered from 1); move them "
     "apart"},
    {{.status = TF_NOT_EMBEDDED,
      .subject = TF_EDGE_EDGE_PAIR,
      .vertex = {0, 1, 2, 3, -1}},
     0,
     "edge 0 1 meets edge 2 3 (numbered from 0); move them apart"},
    {{.status = TF_START_NOT_CLEAR,
      .subject = TF_POINT_EDGE_PAIR,
      .vertex = {0, 1, 2, -1, -1}},
     0,
     "vertex 0 lies on edge 1 2 (numbered from 0) before the step begins; move "
     "them apart"},
    {{.status = TF_COLLINEAR,
      .subject = TF_TRIANGLE,
      .index = 2,
      .vertex = {-1, -1, -1, -1, -1},
      .time = -1},
     1,
     "triangle 2: the corners of this triangle are on one line; remove it, or "
     "move a corner off"},
    {{.status = TF_EDGE_NOT_MANIFOLD, .subject = TF_EDGE, .vertex = {0, 1}},
     0,
     "edge 0 at the start of the step: the edge from vertex 0 to 1 belongs to "
     "no triangle; remove it"},
    {{.status = TF_EDGE_NOT_MANIFOLD,
      .subject = TF_TRIANGLE,
      .index = 2,
      .time = -1,
      .vertex = {0, 1}},
     0,
     "triangle 2: another triangle passes the edge from vertex 0 to 1 in the "
     "same direction; orient them consistently, or divide the surface there"},
    {{.status = TF_VERTEX_NOT_MANIFOLD,
      .subject = TF_VERTEX,
      .index = 2,
      .time = -1,
      .vertex = {2}},
     0,
     "vertex 2: the triangles at vertex 2 form more than one ring or fan; give "
     "each a vertex of its own"},
    {{.status = TF_START_NOT_CLEAR, .subject = TF_VERTEX, .time = -1},
     0,
     "vertex 0: two elements touch or intersect before the step begins; move "
     "them apart"},
    {{.status = TF_OUT_OF_MEMORY},
     0,
     "not enough memory; divide the surface, or use a machine with more"},
};

START_TEST(error_has_its_sentence)
{
    char sentence[512];
    tf_sentence_write(&expected[_i].error, expected[_i].first, false, sentence,
                      sizeof sentence);
    ck_assert_str_eq(sentence, expected[_i].sentence);
}
END_TEST

START_TEST(place_can_be_left_out)
{
    const tf_error error = {
        .status = TF_BAD_MASS, .subject = TF_VERTEX, .index = 3, .time = -1};
    char with[256], without[256];
    tf_sentence_write(&error, 0, false, with, sizeof with);
    tf_sentence_write(&error, 0, true, without, sizeof without);
    ck_assert_str_eq(without, tf_status_message(TF_BAD_MASS));
    ck_assert_str_eq(with + strlen("vertex 3: "), without);
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("base/sentence");
    TCase *tcase = tcase_create("sentences");
    tcase_add_loop_test(tcase, error_has_its_sentence, 0,
                        sizeof expected / sizeof *expected);
    tcase_add_test(tcase, place_can_be_left_out);
    suite_add_tcase(suite, tcase);
    return suite;
}
