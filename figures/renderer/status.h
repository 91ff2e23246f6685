// What can go wrong between a figure and its file.
#ifndef FIG_RENDERER_STATUS_H
#define FIG_RENDERER_STATUS_H

/// Zero is success.
typedef enum fig_status {
    FIG_OK = 0,
    FIG_NO_MEMORY,
    FIG_BAD_SIZE,     ///< pixels outside FIG_PIXELS_LEAST..FIG_PIXELS_MOST
    FIG_NO_FONT,      ///< fontconfig does not know the family of letters
    FIG_NO_CONTEXT,   ///< OpenGL 3.3 cannot be had
    FIG_NO_SHADER,    ///< this OpenGL refuses the renderer's shaders
    FIG_BAD_TEXT,     ///< a label's text is no UTF-8 or its $...$ is open
    FIG_UNWRITABLE,   ///< a file cannot be opened or written; see errno
    FIG_UNKNOWN_KIND, ///< a file's name ends in none of .png .pdf .svg
} fig_status;

/// A sentence for a status: what is wrong and how to mend it.  Static storage.
/// After FIG_UNWRITABLE, strerror(errno) tells the cause.
const char *fig_status_message(fig_status status);

#endif
