#include "writers/endings.h"

#include "support/support.h"

START_TEST(the_ending_chooses_the_format)
{
    static const struct {
        const char *path;
        tf_mesh_format usual, format;
    } cases[] = {
        {"a.obj", TF_OBJ, TF_OBJ},
        {"a.OBJ", TF_PLY_TEXT, TF_OBJ},
        {"a.ply", TF_OBJ, TF_PLY_LITTLE_ENDIAN},
        {"a.ply", TF_PLY_TEXT, TF_PLY_TEXT},
        {"a.Ply", TF_PLY_BIG_ENDIAN, TF_PLY_BIG_ENDIAN},
        {"a.stl", TF_OBJ, TF_STL_BINARY},
        {"a.STL", TF_STL_TEXT, TF_STL_TEXT},
        {"a.stl", TF_STL_BINARY, TF_STL_BINARY},
        {"a.off", TF_OBJ, TF_OFF},
        {"a.vtp", TF_OBJ, TF_VTP},
        {"a.msh", TF_OBJ, TF_MSH},
        {"a.ply.gz", TF_OBJ, TF_PLY_LITTLE_ENDIAN},
        {"a.PLY.GZ", TF_PLY_TEXT, TF_PLY_TEXT},
        {"a.gz", TF_OFF, TF_OFF},
        {"a", TF_PLY_BIG_ENDIAN, TF_PLY_BIG_ENDIAN},
        {"-", TF_OBJ, TF_OBJ},
        {"", TF_OBJ, TF_OBJ},
        {".gz", TF_OBJ, TF_OBJ},
        {"obj", TF_PLY_TEXT, TF_PLY_TEXT},
        {"a.obj/b", TF_PLY_TEXT, TF_PLY_TEXT},
        {"a.obj.old", TF_PLY_TEXT, TF_PLY_TEXT},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        ck_assert_msg(tf_mesh_format_of(cases[i].path, cases[i].usual) ==
                          cases[i].format,
                      "%s, usual %d", cases[i].path, (int)cases[i].usual);
}
END_TEST

START_TEST(endings_of_other_formats_are_known)
{
    ck_assert_str_eq(tf_unwritten_ending("a/b.glb"), ".glb");
    ck_assert_str_eq(tf_unwritten_ending("B.FBX.gz"), ".fbx");
    ck_assert_str_eq(tf_unwritten_ending("a.inp"), ".inp");
    ck_assert_ptr_null(tf_unwritten_ending("a.obj"));
    ck_assert_ptr_null(tf_unwritten_ending("a.vtp"));
    ck_assert_ptr_null(tf_unwritten_ending("glb"));
    ck_assert_ptr_null(tf_unwritten_ending("a.tmp"));
    ck_assert_ptr_null(tf_unwritten_ending("-"));
}
END_TEST

START_TEST(formats_have_names)
{
    ck_assert_str_eq(tf_mesh_format_name(TF_OBJ), "OBJ");
    ck_assert_str_eq(tf_mesh_format_name(TF_PLY_BIG_ENDIAN), "PLY");
    ck_assert_str_eq(tf_mesh_format_name(TF_VTP), "VTK's .vtp");
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("writers/endings");
    TCase *tcase = tcase_create("endings");
    tcase_add_test(tcase, the_ending_chooses_the_format);
    tcase_add_test(tcase, endings_of_other_formats_are_known);
    tcase_add_test(tcase, formats_have_names);
    suite_add_tcase(suite, tcase);
    return suite;
}
