// The files of a film: the frames that 'tanglefree simulate' writes.
#ifndef FIG_DRAW_FILM_FILES_H
#define FIG_DRAW_FILM_FILES_H

/// How many frames a folder has: frame-00000.ply, frame-00001.ply and so on.
/// -1: it has none, or one is missing in between, and standard error has been
/// told so.
int fig_film_files_count(const char *folder);

enum {
    FIG_FILM_PATH = 4352
}; ///< room for any path that a file can have

/// Write the path of the i-th frame.
void fig_film_files_path(const char *folder, int i, char path[FIG_FILM_PATH]);

#endif
