// What can go wrong between a figure and its file.
#ifndef TF_STAGE_STATUS_H
#define TF_STAGE_STATUS_H

/// Zero is success.
typedef enum tf_stage_status {
    TF_STAGE_OK = 0,
    TF_STAGE_NO_MEMORY,
    TF_STAGE_BAD_SIZE,     ///< pixels outside TF_PIXELS_LEAST..TF_PIXELS_MOST
    TF_STAGE_NO_FONT,      ///< fontconfig does not know the family of letters
    TF_STAGE_NO_CONTEXT,   ///< OpenGL 3.3 cannot be had
    TF_STAGE_NO_SHADER,    ///< this OpenGL refuses the stage's shaders
    TF_STAGE_BAD_TEXT,     ///< a label's text is no UTF-8 or its $...$ is open
    TF_STAGE_UNWRITABLE,   ///< a file cannot be opened or written; see errno
    TF_STAGE_UNKNOWN_KIND, ///< a file's name ends in none of .png .pdf .svg
} tf_stage_status;

/// A sentence for a status: what is wrong and how to mend it.  Static storage.
/// After TF_STAGE_UNWRITABLE, strerror(errno) tells the cause.
const char *tf_stage_message(tf_stage_status status);

#endif
