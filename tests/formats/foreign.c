// Files that are no meshes which are read.
#include "formats/foreign.h"

#include "support/bytes.h"
#include "support/support.h"

#include <stdio.h>
#include <string.h>

static void expect_name(const char *text, size_t size, const char *name)
{
    char copy[8001];
    memcpy(copy, text, size);
    copy[size] = '\0';
    const tf_foreign *found = tf_foreign_find(copy, size);
    ck_assert_msg(found != NULL, "%s", name);
    ck_assert_str_eq(found->name, name);
    ck_assert_uint_gt(strlen(found->mend), 0);
}

#define BYTES(text) text, sizeof(text) - 1

static const struct {
    const char *text;
    size_t size;
    const char *name;
} files[] = {
    {BYTES("glTF\2\0\0\0"), "a binary glTF file"},
    {BYTES("{\n  \"asset\": {\"version\": \"2.0\"}"), "a glTF file"},
    {BYTES(" {\"scenes\": [], \"meshes\": ["), "a glTF file"},
    {BYTES("{\"a\": 1}"), "a JSON file"},
    {BYTES("Kaydara FBX Binary  \0"), "an FBX file"},
    {BYTES("; FBX 7.4.0 project file\n"), "an FBX file"},
    {BYTES("MM\x10\0\0\0\2\0\x0a\0\0\0\3\0\0\0"), "a 3DS file"},
    {BYTES("#usda 1.0\n"), "a USD file"},
    {BYTES("PXR-USDC\0"), "a USD file"},
    {BYTES("Ogawa\xff"), "an Alembic file"},
    {BYTES("\x89HDF\r\n\x1a\n"), "an HDF5 file, such as Alembic or netCDF"},
    {BYTES("CDF\x01"), "a netCDF file"},
    {BYTES("CDF\x02"), "a netCDF file"},
    {BYTES("BLENDER-v300"), "a Blender file"},
    {BYTES("<?xml version=\"1.0\"?>\n<COLLADA xmlns="), "a COLLADA file"},
    {BYTES("<?xml?><X3D profile"), "an X3D file"},
    {BYTES("#X3D V3.0 utf8\n"), "an X3D file"},
    {BYTES("#VRML V2.0 utf8\n"), "a VRML file"},
    {BYTES("#Inventor V2.1 ascii\n"), "an Open Inventor file"},
    {BYTES("# vtk DataFile Version 3.0\n"), "a VTK file"},
    {BYTES("<VTKFile type=\"PolyData\">"), "a VTK file"},
    {BYTES("<?xml version='1.0'?>\n<amf unit"), "an AMF file"},
    {BYTES("<?xml?><model unit"), "a 3MF file"},
    {BYTES("ISO-10303-21;\nHEADER;"), "a STEP file"},
    {BYTES("  0\nSECTION\n  2\nHEADER\n"), "a DXF file"},
    {BYTES("0\r\nSECTION\r\n"), "a DXF file"},
    {BYTES("AutoCAD Binary DXF\r\n"), "a DXF file"},
    {BYTES("AC1027"), "a DWG file"},
    {BYTES("3D Geometry File Format "), "a Rhino file"},
    {BYTES(" MeshVersionFormatted 2\n"), "a Medit file"},
    {BYTES("DRACO\2"), "a Draco file"},
    {BYTES("FORM\0\1\2\3LWO2"), "a LightWave file"},
    {BYTES("xof 0302txt 0064\n"), "a DirectX file"},
    {BYTES("AC3Db\n"), "an AC3D file"},
    {BYTES("*3DSMAX_ASCIIEXPORT 200\n"), "a 3ds Max file"},
    {BYTES("\xd0\xcf\x11\xe0\xa1\xb1"), "a 3ds Max or Office file"},
    {BYTES("OCTM"), "an OpenCTM file"},
    {BYTES("//Maya ASCII 2020"), "a Maya file"},
    {BYTES("\x7fNSJb"), "a Houdini file"},
    {BYTES("PGEOMETRY V5"), "a Houdini file"},
    {BYTES("*HEADING\n"), "an Abaqus file"},
    {BYTES("*Node\n"), "an Abaqus file"},
    {BYTES("$NOD\n4\n"), "version 1 of Gmsh's format"},
    {BYTES("# .PCD v.7\n"), "a cloud of points"},
    {BYTES("\x93NUMPY\1\0"), "an array of NumPy"},
    {BYTES("version https://git-lfs.github.com/spec/v1\n"),
     "a pointer of Git LFS"},
    {BYTES("%PDF-1.7"), "a PDF file"},
    {BYTES("\x89PNG\r\n"), "a PNG picture"},
    {BYTES("\xff\xd8\xff\xe0"), "a JPEG picture"},
    {BYTES("GIF89a"), "a GIF picture"},
    {BYTES("<svg xmlns"), "an SVG picture"},
    {BYTES("<!DOCTYPE HTML>"), "an HTML page"},
    {BYTES("\n<HTML>"), "an HTML page"},
    {BYTES("<a>"), "an XML file"},
    {BYTES("\x1f\x8b\x08"), "gzip of gzip"},
    {BYTES("BZh91AY"), "a bzip2 file"},
    {BYTES("\xfd"
           "7zXZ\0"),
     "an xz file"},
    {BYTES("\x28\xb5\x2f\xfd\x04"), "a zstd file"},
    {BYTES("7z\xbc\xaf\x27\x1c"), "a 7z archive"},
    {BYTES("Rar!\x1a\x07"), "a RAR archive"},
    {BYTES("\xff\xfev\0"), "UTF-16 text"},
    {BYTES("\xfe\xff\0v"), "UTF-16 text"},
    {BYTES("v\0 \0001\0"), "UTF-16 text"},
    {BYTES("\0v\0 \0001"), "UTF-16 text"},
};

START_TEST(files_are_named)
{
    expect_name(files[_i].text, files[_i].size, files[_i].name);
}
END_TEST

static bytes archive(const char *first)
{
    bytes made = {0};
    put_text(&made, "PK\x03\x04");
    made.count = 26;
    put_int(&made, 2, (int64_t)strlen(first));
    put_int(&made, 2, 0);
    put_text(&made, first);
    put_text(&made, ".usd 3D/");
    return made;
}

START_TEST(archives_are_told_apart_by_their_first_file)
{
    static const char *const first[][2] = {
        {"a.usdc", "a USD file"},
        {"b/a.usda", "a USD file"},
        {"[Content_Types].xml", "a 3MF file"},
        {"3D/a.model", "a 3MF file"},
        {"a.obj", "a zip archive"},
        {"", "a zip archive"}};
    for (int i = 0; i < 6; i++) {
        bytes made = archive(first[i][0]);
        expect_name(made.at, made.count, first[i][1]);
    }
    bytes made = archive("long enough to end before .usd");
    expect_name(made.at, 40, "a zip archive");
    expect_name(made.at, 29, "a zip archive");
    expect_name(made.at, 4, "a zip archive");
    bytes tar = {.count = 257};
    memset(tar.at, 'a', 257);
    put_text(&tar, "ustar");
    expect_name(tar.at, tar.count, "a tar archive");
}
END_TEST

START_TEST(iges_is_known_by_its_columns)
{
    char text[200];
    snprintf(text, sizeof text, "%-72sS      1\n%-72sS0000002\n", "a name", "");
    expect_name(text, strlen(text), "an IGES file");
    snprintf(text, sizeof text, "%-72sS0000001\r\n%-72sS0000002\n", "", "");
    expect_name(text, strlen(text), "an IGES file");
    text[72] = 'G';
    ck_assert_ptr_null(tf_foreign_find(text, strlen(text)));
}
END_TEST

START_TEST(meshes_and_other_texts_have_no_name)
{
    static const struct {
        const char *text;
        size_t size;
    } texts[] = {{BYTES("")},
                 {BYTES("v 0 0 0\n")},
                 {BYTES("# <html>\n{ }\n")},
                 {BYTES("solid a\n")},
                 {BYTES("OFF\n")},
                 {BYTES("ply\n")},
                 {BYTES("$MeshFormat\n")},
                 {BYTES("0 SECTION")},
                 {BYTES("0\nSECTIO")},
                 {BYTES("MM\x11\0\0\0\2\0\x0a\0\0\0\3\0\0\0")},
                 {BYTES("MM\x0f\0\0\0\2\0\x0a\0\0\0\3\0\0\0")},
                 {BYTES("PK\x03")},
                 {BYTES("\0\0\0\0\0")},
                 {BYTES("\x80\0\0\0\0")},
                 {BYTES("v\0\1\0v\0v\0")},
                 {BYTES("v\0v")}};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        ck_assert_msg(!tf_foreign_find(texts[i].text, texts[i].size), "%zu", i);
}
END_TEST

START_TEST(tags_are_found_at_the_beginning_alone)
{
    static char text[6000];
    memset(text, ' ', sizeof text - 1);
    text[0] = '<';
    memcpy(text + 4096 - 8, "<COLLADA", 8);
    expect_name(text, sizeof text - 1, "a COLLADA file");
    memcpy(text + 4096 - 8, " <COLLADA", 9);
    expect_name(text, sizeof text - 1, "an XML file");
}
END_TEST

Suite *suite(void)
{
    Suite *suite = suite_create("formats/foreign");
    TCase *names = tcase_create("names");
    tcase_add_loop_test(names, files_are_named, 0,
                        sizeof files / sizeof *files);
    tcase_add_test(names, archives_are_told_apart_by_their_first_file);
    tcase_add_test(names, iges_is_known_by_its_columns);
    tcase_add_test(names, meshes_and_other_texts_have_no_name);
    tcase_add_test(names, tags_are_found_at_the_beginning_alone);
    suite_add_tcase(suite, names);
    return suite;
}
