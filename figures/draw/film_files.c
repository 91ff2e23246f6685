#include "draw/film_files.h"

#include "files/visible.h"

#include <dirent.h>
#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum {
    NAME = 32,
    FRAMES_MOST = 1000000
};

static void write_name(int i, char name[NAME])
{
    snprintf(name, NAME, "frame-%05d.ply", i);
}

/// The number in the name of a frame; -1: it is the name of none.
static int number_of(const char *name)
{
    char same[NAME];
    long number = -1;
    if (sscanf(name, "frame-%7ld.ply", &number) < 1 || number < 0 ||
        number >= FRAMES_MOST)
        return -1;
    write_name((int)number, same);
    return strcmp(name, same) == 0 ? (int)number : -1;
}

void fig_film_files_path(const char *folder, int i, char path[FIG_FILM_PATH])
{
    char name[NAME];
    write_name(i, name);
    snprintf(path, FIG_FILM_PATH, "%.4096s/%s", folder, name);
}

/// Print an error about a file of the folder or, if `file` is empty, about the
/// folder; -1.
static int report(const char *folder, const char *file, const char *what)
{
    fprintf(stderr, "tanglefree-draw: %s%s%s: %s\n",
            tf_make_visible(folder).text, *file ? "/" : "", file, what);
    return -1;
}

static bool is_there(const char *folder, int i)
{
    char path[FIG_FILM_PATH];
    fig_film_files_path(folder, i, path);
    return access(path, F_OK) == 0;
}

/// Print an error about the first missing frame before the last one; -1.
static int report_gap(const char *folder, int last)
{
    char name[NAME], what[4 * NAME];
    int missing = 0;
    while (missing < last && is_there(folder, missing))
        missing++;
    write_name(last, name);
    snprintf(what, sizeof what,
             "there is no such frame, but there is %s; simulate again, or "
             "number the frames from 0 on",
             name);
    write_name(missing, name);
    return report(folder, name, what);
}

int fig_film_files_count(const char *folder)
{
    char what[256];
    DIR *all = opendir(folder);
    if (!all) {
        snprintf(what, sizeof what,
                 "cannot open: %s; give the folder that 'tanglefree simulate' "
                 "wrote",
                 strerror(errno));
        return report(folder, "", what);
    }
    int count = 0, last = -1;
    for (const struct dirent *entry; (entry = readdir(all));) {
        int number = number_of(entry->d_name);
        count += number >= 0;
        last = number > last ? number : last;
    }
    closedir(all);
    if (count == 0)
        return report(folder, "",
                      "no frames frame-00000.ply, frame-00001.ply, ...; give "
                      "the folder that 'tanglefree simulate' wrote");
    return count <= last ? report_gap(folder, last) : count;
}
