//: Include what foreign formats need
#define _GNU_SOURCE // memmem
#include "formats/foreign.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

//: Tabulate what begins with certain bytes
#define EXPORT "export OBJ, PLY or STL"
#define UNPACK "unpack it, or compress the mesh by gzip"
#define NO_MESH "give the file of a mesh"

/// Bytes at an offset, and what they tell; the first row that fits counts.
typedef struct signature {
    size_t offset, length;
    const char *bytes;
    tf_foreign is;
} signature;

#define AT(offset, bytes) (offset), sizeof(bytes) - 1, (bytes)

static const signature signatures[] = {
    {AT(0, "\xff\xfe"), {"UTF-16 text", "save it as UTF-8"}},
    {AT(0, "\xfe\xff"), {"UTF-16 text", "save it as UTF-8"}},
    {AT(0, "glTF"), {"a binary glTF file", EXPORT}},
    {AT(0, "Kaydara FBX"), {"an FBX file", EXPORT}},
    {AT(0, "; FBX"), {"an FBX file", EXPORT}},
    {AT(0, "#usda"), {"a USD file", EXPORT}},
    {AT(0, "PXR-USDC"), {"a USD file", EXPORT}},
    {AT(0, "Ogawa"), {"an Alembic file", EXPORT}},
    {AT(0, "\x89HDF\r\n"), {"an HDF5 file, such as Alembic or netCDF", EXPORT}},
    {AT(0, "CDF\x01"), {"a netCDF file", EXPORT}},
    {AT(0, "CDF\x02"), {"a netCDF file", EXPORT}},
    {AT(0, "BLENDER"), {"a Blender file", EXPORT}},
    {AT(0, "#VRML"), {"a VRML file", EXPORT}},
    {AT(0, "#Inventor"), {"an Open Inventor file", EXPORT}},
    {AT(0, "#X3D"), {"an X3D file", EXPORT}},
    {AT(0, "# vtk DataFile"), {"a VTK file", EXPORT}},
    {AT(0, "ISO-10303"), {"a STEP file", "mesh it, and " EXPORT}},
    {AT(0, "AutoCAD Binary DXF"), {"a DXF file", EXPORT}},
    {AT(0, "AC10"), {"a DWG file", EXPORT}},
    {AT(0, "3D Geometry File"), {"a Rhino file", EXPORT}},
    {AT(0, "MeshVersionFormatted"), {"a Medit file", EXPORT}},
    {AT(0, "DRACO"), {"a Draco file", EXPORT}},
    {AT(8, "LWO"), {"a LightWave file", EXPORT}},
    {AT(0, "xof "), {"a DirectX file", EXPORT}},
    {AT(0, "AC3D"), {"an AC3D file", EXPORT}},
    {AT(0, "*3DSMAX"), {"a 3ds Max file", EXPORT}},
    {AT(0, "\xd0\xcf\x11\xe0"), {"a 3ds Max or Office file", EXPORT}},
    {AT(0, "OCTM"), {"an OpenCTM file", EXPORT}},
    {AT(0, "//Maya ASCII"), {"a Maya file", EXPORT}},
    {AT(0, "\x7fNSJb"), {"a Houdini file", EXPORT}},
    {AT(0, "PGEOMETRY"), {"a Houdini file", EXPORT}},
    {AT(0, "*HEADING"), {"an Abaqus file", EXPORT}},
    {AT(0, "*Heading"), {"an Abaqus file", EXPORT}},
    {AT(0, "*NODE"), {"an Abaqus file", EXPORT}},
    {AT(0, "*Node"), {"an Abaqus file", EXPORT}},
    {AT(0, "$NOD\n"), {"version 1 of Gmsh's format", "save version 4.1"}},
    {AT(0, "# .PCD"), {"a cloud of points", "make a surface of it"}},
    {AT(0, "\x93NUMPY"), {"an array of NumPy", EXPORT}},
    {AT(0, "version https://git-lfs"),
     {"a pointer of Git LFS", "fetch the file by git lfs pull"}},
    {AT(0, "%PDF"), {"a PDF file", NO_MESH}},
    {AT(0, "\x89PNG"), {"a PNG picture", NO_MESH}},
    {AT(0, "\xff\xd8\xff"), {"a JPEG picture", NO_MESH}},
    {AT(0, "GIF8"), {"a GIF picture", NO_MESH}},
    {AT(0, "\x1f\x8b"), {"gzip of gzip", UNPACK}},
    {AT(0, "BZh"), {"a bzip2 file", UNPACK}},
    {AT(0, "\xfd"
           "7zXZ"),
     {"an xz file", UNPACK}},
    {AT(0, "\x28\xb5\x2f\xfd"), {"a zstd file", UNPACK}},
    {AT(0, "7z\xbc\xaf"), {"a 7z archive", UNPACK}},
    {AT(0, "Rar!"), {"a RAR archive", UNPACK}},
    {AT(257, "ustar"), {"a tar archive", UNPACK}},
};

static const tf_foreign *find_signature(const char *text, size_t size)
{
    for (size_t i = 0; i < sizeof signatures / sizeof *signatures; i++) {
        const signature *row = &signatures[i];
        if (size >= row->offset + row->length &&
            memcmp(text + row->offset, row->bytes, row->length) == 0)
            return &row->is;
    }
    return NULL;
}

//: Tell archives apart
/// By the name of the first file in it.
static const tf_foreign *find_archive(const char *text, size_t size)
{
    static const tf_foreign usd = {"a USD file", EXPORT};
    static const tf_foreign parts = {"a 3MF file", EXPORT};
    static const tf_foreign zip = {"a zip archive", UNPACK};
    if (size < 4 || memcmp(text, "PK\x03\x04", 4) != 0)
        return NULL;
    if (size < 30)
        return &zip;
    size_t length = (unsigned char)text[26] + 256u * (unsigned char)text[27];
    size_t here = length < size - 30 ? length : size - 30;
    const char *name = text + 30;
    if (memmem(name, here, ".usd", 4))
        return &usd;
    return memmem(name, here, "[Content_Types]", 15) ||
                   memmem(name, here, "3D/", 3)
               ? &parts
               : &zip;
}

//: Tell markup apart
/// Tags in the first bytes of a file that begins with < or {.
static const struct {
    const char *tag;
    tf_foreign is;
} tags[] = {
    {"<COLLADA", {"a COLLADA file", EXPORT}},
    {"<X3D", {"an X3D file", EXPORT}},
    {"<VTKFile", {"a VTK file", "such files are written only; " EXPORT}},
    {"<amf", {"an AMF file", EXPORT}},
    {"<model", {"a 3MF file", EXPORT}},
    {"<svg", {"an SVG picture", NO_MESH}},
    {"<html", {"an HTML page", NO_MESH ", which may be behind a link of it"}},
    {"<!doctype html",
     {"an HTML page", NO_MESH ", which may be behind a link of it"}},
    {"\"asset\"", {"a glTF file", EXPORT}},
    {"\"meshes\"", {"a glTF file", EXPORT}},
    {"<", {"an XML file", EXPORT}},
    {"{", {"a JSON file", EXPORT}},
};

static bool has_tag(const char *text, size_t size, const char *tag)
{
    size_t length = strlen(tag), most = 4096;
    size = size < most ? size : most;
    for (size_t i = 0; i + length <= size; i++) {
        size_t k = 0;
        while (k < length &&
               tolower((unsigned char)text[i + k]) == tolower(tag[k]))
            k++;
        if (k == length)
            return true;
    }
    return false;
}

static const tf_foreign *find_markup(const char *text, size_t size)
{
    size_t blanks = strspn(text, " \t\r\n");
    if (text[blanks] != '<' && text[blanks] != '{')
        return NULL;
    for (size_t i = 0; i < sizeof tags / sizeof *tags; i++)
        if (has_tag(text, size, tags[i].tag))
            return &tags[i].is;
    return NULL;
}

//: Tell formats apart by their first lines
/// IGES has the letter S and a number at the end of lines of 80 columns, DXF a
/// section first, and 3DS a chunk that is as long as the file, with another one
/// in it.
static bool is_iges(const char *text, size_t size)
{
    return size > 80 && text[72] == 'S' &&
           strspn(text + 73, " 0") + strspn(text + 73, " 01") > 6 &&
           (text[80] == '\r' || text[80] == '\n');
}

static bool is_dxf(const char *text)
{
    const char *at = text + strspn(text, " \t");
    if (*at != '0')
        return false;
    at += 1 + strspn(at + 1, " \t\r");
    return *at == '\n' &&
           strncmp(at + strspn(at, " \t\r\n"), "SECTION", 7) == 0;
}

static bool is_3ds(const char *text, size_t size)
{
    uint64_t length = 0;
    for (int i = 0; i < 4 && size > 6; i++)
        length |= (uint64_t)(unsigned char)text[2 + i] << 8 * i;
    return size > 6 && memcmp(text, "MM", 2) == 0 && length == size;
}

/// ASCII has a zero in each second byte of UTF-16.
static bool is_utf_16(const char *text, size_t size)
{
    size_t first = size > 0 && text[0] == '\0';
    bool fits = size >= 4;
    for (size_t i = 0; i + 1 < size && i < 16; i += 2)
        fits &= text[i + 1 - first] == '\0' && text[i + first] >= '\t' &&
                text[i + first] <= '~';
    return fits;
}

//: Find what a file is
const tf_foreign *tf_foreign_find(const char *text, size_t size)
{
    static const tf_foreign iges = {"an IGES file", "mesh it, and " EXPORT};
    static const tf_foreign dxf = {"a DXF file", EXPORT};
    static const tf_foreign studio = {"a 3DS file", EXPORT};
    static const tf_foreign utf_16 = {"UTF-16 text", "save it as UTF-8"};
    size_t blanks = strspn(text, " \t\r\n");
    const tf_foreign *found = find_signature(text + blanks, size - blanks);
    found = found ? found : find_archive(text, size);
    found = found ? found : find_markup(text, size);
    return found                   ? found
           : is_iges(text, size)   ? &iges
           : is_utf_16(text, size) ? &utf_16
           : is_dxf(text)          ? &dxf
           : is_3ds(text, size)    ? &studio
                                   : NULL;
}
