// The notation of text in letters.h, read into plain text and its looks.
#ifndef FIG_RENDERER_MARKUP_H
#define FIG_RENDERER_MARKUP_H

#include <glib.h>
#include <pango/pango.h>
#include <stdbool.h>

/// A part of the text, in bytes, with a bar over it.
typedef struct fig_bar {
    guint from, to;
} fig_bar;

typedef struct fig_markup {
    GString *text;
    PangoAttrList *looks;
    GArray *bars;   ///< of fig_bar
    GArray *primes; ///< of guint: bytes of the primes to stand over a subscript
} fig_markup;

/// Read text whose letters are `size` points high.  False if it is no UTF-8 or
/// something is not closed; what was read is to be freed in any case.
bool fig_markup_read(fig_markup *markup, const char *text, double size);
void fig_markup_free(fig_markup *markup);

#endif
