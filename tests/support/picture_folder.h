// A folder for one picture at a time.
#ifndef SUPPORT_PICTURE_FOLDER_H
#define SUPPORT_PICTURE_FOLDER_H

/// A fixture of tests: makes a new folder, then removes it with the picture.
void make_picture_folder(void);
void remove_picture_folder(void);

/// The path of the picture.
const char *picture_path(void);

#endif
