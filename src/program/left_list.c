//: Include what the list of what is left needs
#define _POSIX_C_SOURCE 200809L // open_memstream
#include "program/left_list.h"

#include <errno.h>
#include <stdlib.h>

//: Begin the list of what is left
/// It is in memory, so that nothing else fails.
static bool fault_in_list(const tf_scene_frames *frames)
{
    return tf_mesh_file_fault_in_memory(tf_scene_frames_file(frames, 0, 1));
}

bool tf_left_list_begin(tf_left_list *list, tf_scene_frames *frames,
                        tf_format format, tf_row_names names,
                        const char *name[])
{
    size_t meshes = (size_t)frames->meshes->count;
    list->stream = open_memstream(&list->text, &list->size);
    list->listed = calloc(meshes, sizeof *list->listed);
    if (!list->stream || !list->listed)
        return fault_in_list(frames);
    list->part = (tf_surface_part){
        .joined = &frames->joined, .name = name, .listed = list->listed};
    tf_surface_output_options how = {.format =
                                         format == TF_JSON ? TF_JSON : TF_CSV,
                                     .checks = true,
                                     .names = names};
    tf_surface_output_begin(&list->output, list->stream, &how);
    return true;
}

//: Add to the list of what is left
bool tf_left_list_add(tf_left_list *list, tf_scene_frames *frames,
                      const tf_crossings *left)
{
    bool good = tf_surface_output_crossings(&list->output, &list->part, left);
    tf_surface_output_count(&list->output, &list->part);
    return good || fault_in_list(frames);
}

//: Write the list of what is left
bool tf_left_list_write(tf_left_list *list, tf_scene_frames *frames,
                        FILE *stream)
{
    bool json = list->output.options.format == TF_JSON;
    if (list->output.tally.rows == 0)
        return true;
    if (!tf_surface_output_end(&list->output, true))
        return fault_in_list(frames);
    bool good = json || fputc('\n', stream) != EOF;
    good = good && fwrite(list->text, 1, list->size, stream) == list->size &&
           fflush(stream) == 0;
    return good || tf_fault_set_unwritten(&frames->fault, "the list", errno);
}

void tf_left_list_free(tf_left_list *list)
{
    if (list->stream)
        fclose(list->stream);
    free(list->text);
    free(list->listed);
    *list = (tf_left_list){0};
}
