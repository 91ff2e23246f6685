// A film as one picture: a sheet of the distinct tiles of all its frames.
//
// Most of a frame is the same as in the one before, so a tile that has been
// seen is not kept again, and any frame can be put together from the sheet
// without those before it.  The sheet is a PNG file.  Where the tiles go is in
// its text chunk "film": a line of the numbers
//
//     width height tile columns frames
//
// (the pixels of a frame, the side of a tile, the tiles in a row of the sheet,
// and how many frames there are) and then a line for each frame: its runs of
// tiles that are not as in the frame before, "skip,count,first" each, in base
// 36.  After `skip` tiles of the frame, row by row, that stay come `count` that
// are the tiles `first`, `first` + 1 and so on of the sheet.
#ifndef FIG_DRAW_SHEET_H
#define FIG_DRAW_SHEET_H

#include <stdbool.h>
#include <stdint.h>

typedef struct fig_sheet fig_sheet;

/// An empty sheet for frames of width x height pixels.  NULL if there is no
/// memory.
fig_sheet *fig_sheet_new(int width, int height);

/// Free a sheet; NULL is no sheet.
void fig_sheet_free(fig_sheet *sheet);

/// Add a frame: its pixels, 0xRRGGBB below a byte to ignore, row by row.  False
/// if there is no memory.
bool fig_sheet_add(fig_sheet *sheet, const uint32_t pixels[]);

/// Write the sheet as a PNG file.  False, with errno, if that fails.
bool fig_sheet_write(const fig_sheet *sheet, const char *path);

#endif
