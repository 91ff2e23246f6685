// The reader of scene files: values of each type, by a document of YAML.
#include "scenes/scene_reader.h"

#include "support/support.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/// What the mappings of these tests describe.
typedef struct described {
    char *text;
    double number, vector[3];
    int whole;
} described;

#define MEMBER(member) offsetof(described, member)

static const tf_scene_key keys[] = {
    {"text", tf_scene_take_text, .member = MEMBER(text)},
    {"any", tf_scene_take_number, .member = MEMBER(number)},
    {"some", tf_scene_take_number, MEMBER(number), -1, 2},
    {"above", tf_scene_take_number, MEMBER(number), 0x1p-1022, INFINITY},
    {"from", tf_scene_take_number, MEMBER(number), 0, INFINITY},
    {"whole", tf_scene_take_whole, MEMBER(whole), -5, 5},
    {"vector", tf_scene_take_vector, MEMBER(vector), 0, INFINITY},
    {0}};

/// Reads a document that is a mapping of those keys.
static bool read(const char *text, described *found, tf_fault *fault)
{
    tf_scene_reader reader = {.path = "scene.yaml", .fault = fault};
    yaml_parser_t parser;
    ck_assert(yaml_parser_initialize(&parser));
    yaml_parser_set_input_string(&parser, (const unsigned char *)text,
                                 strlen(text));
    ck_assert(yaml_parser_load(&parser, &reader.document));
    *found = (described){0};
    bool good = tf_scene_read_mapping(
        &reader, yaml_document_get_root_node(&reader.document), keys,
        "there is a list", found);
    yaml_document_delete(&reader.document);
    yaml_parser_delete(&parser);
    return good;
}

START_TEST(values_of_all_types)
{
    described found;
    tf_fault fault;
    ck_assert(
        read("{text: a b, any: -1.5e3, whole: -5, vector: [1, 0x1p-3, 0]}",
             &found, &fault));
    ck_assert_str_eq(found.text, "a b");
    ck_assert(found.number == -1500 && found.whole == -5);
    ck_assert(found.vector[0] == 1 && found.vector[1] == 0.125 &&
              found.vector[2] == 0);
    free(found.text);
}
END_TEST

START_TEST(numbers_at_the_ends_of_their_ranges)
{
    static const char *const good[] = {"some: -1", "some: 2",
                                       "whole: 5", "above: 0x1p-1022",
                                       "from: 0",  "any: -1e308"};
    described found;
    tf_fault fault;
    for (int i = 0; i < 6; i++)
        ck_assert_msg(read(good[i], &found, &fault), "%s", good[i]);
}
END_TEST

static const struct {
    const char *text;
    long line;
    const char *fault;
} mistakes[] = {
    {"some: -1.0000000000000002", 1,
     "some must be a number from -1 to 2, got '-1.0000000000000002'"},
    {"some: 2.0000000000000004", 1,
     "some must be a number from -1 to 2, got '2.0000000000000004'"},
    {"some: -.inf", 1, "some must be a number from -1 to 2, got '-.inf'"},
    {"above: 0x1p-1023", 1, "above must be a number above 0, got '0x1p-1023'"},
    {"from: -0x1p-1074", 1,
     "from must be a number from 0 on, got '-0x1p-1074'"},
    {"above: 1/90", 1,
     "above must be a number above 0, got '1/90'; write 0.0111"},
    {"above: -1/90", 1, "above must be a number above 0, got '-1/90'"},
    {"above: 1/0", 1, "above must be a number above 0, got '1/0'"},
    {"above: 1/9x", 1, "above must be a number above 0, got '1/9x'"},
    {"any: nan", 1, "any must be a number, got 'nan'"},
    {"any: 1e309", 1, "any must be a number, got '1e309'"},
    {"any: \"\\e\"", 1, "any must be a number, got '\\x1b'"},
    {"any: {}", 1, "any must be a text, not a list or a mapping"},
    {"any: ''", 1, "any is an empty text; fill it in"},
    {"any: 1\nwhole: 0.5", 2,
     "whole must be a whole number from -5 to 5, got '0.5'"},
    {"any: 1\n\nwhole: 6", 3,
     "whole must be a whole number from -5 to 5, got '6'"},
    {"vector: [1, 2, 3, 4]", 1,
     "vector must be three numbers; write [1, 0, 0]"},
    {"vector: []", 1, "vector must be three numbers; write [1, 0, 0]"},
    {"vector: {}", 1, "vector must be three numbers; write [1, 0, 0]"},
    {"vector: [1,\n2,\n-3]", 3, "vector must be a number from 0 on, got '-3'"},
    {"other: 1", 1, "unknown key 'other'; there is a list"},
    {"any: 1\nsome: 1\nany: 1", 3, "the key 'any' is there twice; delete one"},
    {"[any]", 1, "not a mapping; there is a list"},
};

START_TEST(each_mistake_has_its_line)
{
    described found;
    tf_fault fault;
    ck_assert(!read(mistakes[_i].text, &found, &fault));
    ck_assert_str_eq(fault.text, mistakes[_i].fault);
    ck_assert_int_eq(fault.place, mistakes[_i].line);
    ck_assert_str_eq(fault.file, "scene.yaml");
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("scenes/scene_reader");
    TCase *tcase = tcase_create("values");
    tcase_add_test(tcase, values_of_all_types);
    tcase_add_test(tcase, numbers_at_the_ends_of_their_ranges);
    tcase_add_loop_test(tcase, each_mistake_has_its_line, 0,
                        sizeof mistakes / sizeof *mistakes);
    suite_add_tcase(suite, tcase);
    return suite;
}
