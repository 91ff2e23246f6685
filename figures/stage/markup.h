// The notation of text in letters.h, read into plain text and its looks.
#ifndef TF_STAGE_MARKUP_H
#define TF_STAGE_MARKUP_H

#include <glib.h>
#include <pango/pango.h>
#include <stdbool.h>

/// A part of the text, in bytes, with a bar over it.
typedef struct tf_bar {
    guint from, to;
} tf_bar;

typedef struct tf_markup {
    GString *text;
    PangoAttrList *looks;
    GArray *bars;   ///< of tf_bar
    GArray *primes; ///< of guint: bytes of the primes to stand over a subscript
} tf_markup;

/// Read text whose letters are `size` points high.  False if it is no UTF-8 or
/// something is not closed; what was read is to be freed in any case.
bool tf_markup_read(tf_markup *markup, const char *text, double size);
void tf_markup_free(tf_markup *markup);

#endif
