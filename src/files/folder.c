//: Include what folders need
#define _POSIX_C_SOURCE 200809L
#include "files/folder.h"

#include <dirent.h>
#include <errno.h>
#include <string.h>
#include <sys/stat.h>

//: Begin a folder
/// Not if this is no folder.
static bool is_empty_folder(const char *path)
{
    DIR *entries = opendir(path);
    int count = 0;
    while (entries && readdir(entries))
        count++;
    if (entries)
        closedir(entries);
    return count == 2; // "." and ".."
}

bool tf_folder_begin(const char *path, const char *otherwise, tf_fault *fault)
{
    if (mkdir(path, 0777) == 0)
        return true;
    if (errno == ENOENT && strchr(path, '/'))
        return tf_fault_set_unwritten(fault, path, errno);
    if (errno != EEXIST)
        return tf_fault_set(
            fault, path, -1,
            "cannot make this folder: %s; choose another with -o",
            strerror(errno));
    return is_empty_folder(path) ||
           tf_fault_set(fault, path, -1,
                        "exists, and is not an empty folder; choose another%s",
                        otherwise);
}
