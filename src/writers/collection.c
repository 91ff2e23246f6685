//: Include what collections need
#define _POSIX_C_SOURCE 200809L
#include "writers/collection.h"

#include "files/output_file.h"

#include <errno.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

//: Name the files of a collection
static const char ending[] = ".pvd";
static const char *const parts[] = {"mesh", "contacts"};

bool tf_is_collection(const char *path)
{
    size_t length = strlen(path), own = strlen(ending);
    return length > own && path[length - own - 1] != '/' &&
           strcasecmp(path + length - own, ending) == 0;
}

/// How many bytes of the path of the list are the folder.
static int folder_length(const tf_collection *c)
{
    return (int)(strlen(c->path) - strlen(ending));
}

/// Sets to work on the folder.
static const char *choose_folder(tf_collection *c)
{
    snprintf(c->file, sizeof c->file, "%.*s", folder_length(c), c->path);
    return c->file;
}

static void choose_part(tf_collection *c, int part)
{
    snprintf(c->file, sizeof c->file, "%.*s/%s-%05d.vtp", folder_length(c),
             c->path, parts[part], c->frames);
}

static void choose_list(tf_collection *c)
{
    snprintf(c->file, sizeof c->file, "%s", c->path);
}

//: Begin a collection
bool tf_collection_begin(tf_collection *collection, const char *path,
                         tf_fault *fault)
{
    *collection = (tf_collection){.path = path, .fault = fault};
    struct stat there;
    const char *folder = choose_folder(collection);
    if (mkdir(folder, 0777) == 0)
        return true;
    int cause = errno;
    bool taken = stat(folder, &there) == 0 && S_ISDIR(there.st_mode);
    return taken ||
           tf_fault_set(fault, folder, -1,
                        "cannot make this folder: %s; choose another with -o",
                        strerror(cause));
}

//: Write a file of a collection
/// Writes what is to be written of a context.
typedef void write_function(FILE *stream, const void *context);

static bool write_whole(tf_collection *c, tf_output_file *out,
                        write_function *write, const void *context)
{
    FILE *stream =
        tf_output_file_begin(out, c->file) ? tf_output_file_open(out) : NULL;
    if (!stream)
        return false;
    write(stream, context);
    c->bytes += (double)ftello(stream);
    return tf_output_file_close(out, stream) && tf_output_file_keep(out);
}

/// The one that is at work.
static bool write_file(tf_collection *c, write_function *write,
                       const void *context)
{
    tf_output_file out = {0};
    bool good = write_whole(c, &out, write, context) ||
                tf_fault_set_unwritten(c->fault, c->file, errno);
    tf_output_file_drop(&out);
    return good;
}

//: Add a frame to a collection
static void write_polydata(FILE *stream, const void *data)
{
    tf_polydata_write(stream, data);
}

bool tf_collection_add(tf_collection *collection, const tf_polydata *mesh,
                       const tf_polydata *contacts)
{
    const tf_polydata *data[] = {mesh, contacts};
    bool good = true;
    for (int part = 0; part < 2 && good; part++) {
        choose_part(collection, part);
        good = write_file(collection, write_polydata, data[part]);
    }
    collection->frames += good;
    return good;
}

//: Write the list of a collection
/// As the value of an attribute.
static void write_attribute(FILE *stream, const char *text, int length)
{
    for (int i = 0; i < length; i++)
        if (strchr("&<>\"\n\t", text[i]))
            fprintf(stream, "&#%d;", text[i]);
        else
            fputc(text[i], stream);
}

static void write_entry(FILE *stream, const tf_collection *c, int frame,
                        int part)
{
    const char *slash = strrchr(c->path, '/');
    const char *name = slash ? slash + 1 : c->path;
    fprintf(stream, "<DataSet timestep=\"%d\" group=\"\" part=\"%d\" file=\"",
            frame, part);
    write_attribute(stream, name, folder_length(c) - (int)(name - c->path));
    fprintf(stream, "/%s-%05d.vtp\"/>\n", parts[part], frame);
}

static void write_list(FILE *stream, const void *context)
{
    const tf_collection *c = context;
    fputs("<?xml version=\"1.0\"?>\n"
          "<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n",
          stream);
    for (int frame = 0; frame < c->frames; frame++)
        for (int part = 0; part < 2; part++)
            write_entry(stream, c, frame, part);
    fputs("</Collection>\n</VTKFile>\n", stream);
}

bool tf_collection_end(tf_collection *collection)
{
    choose_list(collection);
    return write_file(collection, write_list, collection);
}
