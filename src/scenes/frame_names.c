//: Include what the names of frames need
#define _GNU_SOURCE // strdup, asprintf
#include "scenes/frame_names.h"

#include "scenes/natural_order.h"

#include <glob.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

//: Add and free the names of frames
/// Takes over the path, which is NULL without memory.
static bool add_own(tf_frame_names *names, char *path)
{
    size_t count = (size_t)names->count + 1;
    char **moved = path ? realloc(names->path, count * sizeof *moved) : NULL;
    if (!moved) {
        free(path);
        return false;
    }
    names->path = moved;
    names->path[names->count++] = path;
    return true;
}

bool tf_frame_names_add(tf_frame_names *names, const char *path)
{
    return add_own(names, strdup(path));
}

void tf_frame_names_free(tf_frame_names *names)
{
    for (int i = 0; i < names->count; i++)
        free(names->path[i]);
    free(names->path);
    *names = (tf_frame_names){0};
}

//: Name files relative to a scene
/// How much of a path is that of a folder, with the slash at its end.
static size_t folder_of(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? (size_t)(slash + 1 - path) : 0;
}

/// To be freed; NULL: there is no memory.
static char *path_of(const char *scene, const char *name)
{
    char *path;
    int folder = name[0] == '/' ? 0 : (int)folder_of(scene);
    return asprintf(&path, "%.*s%s", folder, scene, name) < 0 ? NULL : path;
}

/// The same as a pattern, in which nothing of the folder is special.
static char *pattern_of(const char *scene, const char *name)
{
    size_t folder = name[0] == '/' ? 0 : folder_of(scene);
    char *pattern = malloc(2 * folder + strlen(name) + 1), *end = pattern;
    for (size_t i = 0; i < folder && pattern; i++) {
        if (strchr("*?[]\\", scene[i]))
            *end++ = '\\';
        *end++ = scene[i];
    }
    return pattern ? strcpy(end, name) - (end - pattern) : NULL;
}

//: Find the files of a pattern
static tf_names_found add_sorted(tf_frame_names *names, char *path[], int count)
{
    tf_natural_sort(path, count);
    for (int i = 0; i < count; i++)
        if (!tf_frame_names_add(names, path[i]))
            return TF_NAMES_NO_MEMORY;
    return TF_NAMES_ADDED;
}

static tf_names_found find_pattern(tf_frame_names *names, const char *pattern)
{
    glob_t found = {0};
    int status = glob(pattern, GLOB_NOSORT, NULL, &found);
    tf_names_found result =
        status == GLOB_NOSPACE ? TF_NAMES_NO_MEMORY
        : status != 0          ? TF_NAMES_NONE
                      : add_sorted(names, found.gl_pathv, (int)found.gl_pathc);
    globfree(&found);
    return result;
}

tf_names_found tf_frame_names_find(tf_frame_names *names, const char *scene,
                                   const char *name)
{
    char *path = path_of(scene, name), *pattern = pattern_of(scene, name);
    tf_names_found found = TF_NAMES_NO_MEMORY;
    if (path && pattern && access(path, F_OK) == 0)
        found = tf_frame_names_add(names, path) ? TF_NAMES_ADDED
                                                : TF_NAMES_NO_MEMORY;
    else if (path && pattern)
        found =
            strpbrk(name, "*?[") ? find_pattern(names, pattern) : TF_NAMES_NONE;
    free(path);
    free(pattern);
    return found;
}
