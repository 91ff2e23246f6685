#include "renderer/letters.h"

#include "renderer/markup.h"

#include <fontconfig/fontconfig.h>
#include <pango/pangocairo.h>
#include <stdlib.h>

/// A bar over letters leans to the right with them: it begins and ends this
/// part of the letters' size farther right.  Its height over the ink and its
/// width too.
static const double bar_lean = 0.06, bar_rise = 0.10, bar_width = 0.055;

enum {
    BARS_MOST = 8
};

typedef struct bar {
    double from, to, height; ///< from the left end of the first baseline
} bar;

struct fig_letters {
    PangoLayout *layout;
    double size;
    double baseline; ///< below the layout's top
    bar bars[BARS_MOST];
    int bar_count;
};

bool fig_letters_known(const char *family)
{
    FcPattern *pattern =
        FcPatternBuild(NULL, FC_FAMILY, FcTypeString, family, (char *)NULL);
    FcObjectSet *wanted = FcObjectSetBuild(FC_FAMILY, (char *)NULL);
    FcFontSet *found = FcFontList(NULL, pattern, wanted);
    bool known = found != NULL && found->nfont > 0;
    if (found != NULL)
        FcFontSetDestroy(found);
    FcObjectSetDestroy(wanted);
    FcPatternDestroy(pattern);
    return known;
}

/// A layout that looks the same at every scale.
static PangoLayout *new_layout(const char *family, double size)
{
    PangoFontMap *map = pango_cairo_font_map_get_default();
    PangoContext *context = pango_font_map_create_context(map);
    cairo_font_options_t *options = cairo_font_options_create();
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    pango_cairo_context_set_font_options(context, options);
    pango_context_set_round_glyph_positions(context, FALSE);
    cairo_font_options_destroy(options);

    PangoFontDescription *font = pango_font_description_new();
    pango_font_description_set_family(font, family);
    pango_font_description_set_absolute_size(font, size * PANGO_SCALE);
    PangoLayout *layout = pango_layout_new(context);
    pango_layout_set_font_description(layout, font);
    pango_font_description_free(font);
    g_object_unref(context);
    return layout;
}

/// The top of the ink of a part of the text, above its baseline.
static double ink_height(PangoLayout *whole, const fig_markup *markup,
                         fig_bar part)
{
    PangoLayout *layout = pango_layout_copy(whole);
    PangoAttrList *looks = pango_attr_list_copy(markup->looks);
    pango_attr_list_update(looks, 0, (int)part.from, 0);
    pango_layout_set_text(layout, markup->text->str + part.from,
                          (int)(part.to - part.from));
    pango_layout_set_attributes(layout, looks);
    PangoRectangle ink;
    pango_layout_get_extents(layout, &ink, NULL);
    double height = pango_layout_get_baseline(layout) - ink.y;
    pango_attr_list_unref(looks);
    g_object_unref(layout);
    return height / PANGO_SCALE;
}

static void find_bars(fig_letters *letters, const fig_markup *markup)
{
    guint count = markup->bars->len < BARS_MOST ? markup->bars->len : BARS_MOST;
    for (guint i = 0; i < count; i++) {
        fig_bar part = g_array_index(markup->bars, fig_bar, i);
        PangoRectangle from, to;
        pango_layout_index_to_pos(letters->layout, (int)part.from, &from);
        pango_layout_index_to_pos(letters->layout, (int)part.to, &to);
        double lean = bar_lean * letters->size;
        letters->bars[letters->bar_count++] =
            (bar){.from = (double)from.x / PANGO_SCALE + 2 * lean,
                  .to = (double)to.x / PANGO_SCALE + lean,
                  .height = ink_height(letters->layout, markup, part) +
                            bar_rise * letters->size};
    }
}

/// Let what follows the glyphs of a byte of the text begin where they do.
static void narrow_glyphs(const PangoGlyphItem *run, guint byte)
{
    PangoGlyphString *glyphs = run->glyphs;
    for (int i = 0; i < glyphs->num_glyphs; i++)
        if ((guint)(run->item->offset + glyphs->log_clusters[i]) == byte)
            glyphs->glyphs[i].geometry.width = 0;
}

static void stack_primes(PangoLayout *layout, const GArray *primes)
{
    PangoLayoutIter *at = pango_layout_get_iter(layout);
    do {
        const PangoGlyphItem *run = pango_layout_iter_get_run(at);
        for (guint i = 0; run && i < primes->len; i++)
            narrow_glyphs(run, g_array_index(primes, guint, i));
    } while (pango_layout_iter_next_run(at));
    pango_layout_iter_free(at);
}

fig_status fig_letters_set(const char *family, const char *text, double size,
                           fig_letters **letters)
{
    *letters = NULL;
    fig_markup markup;
    if (!fig_markup_read(&markup, text, size)) {
        fig_markup_free(&markup);
        return FIG_BAD_TEXT;
    }
    fig_letters *set = calloc(1, sizeof *set);
    if (set != NULL) {
        set->size = size;
        set->layout = new_layout(family, size);
        pango_layout_set_text(set->layout, markup.text->str, -1);
        pango_layout_set_attributes(set->layout, markup.looks);
        set->baseline =
            (double)pango_layout_get_baseline(set->layout) / PANGO_SCALE;
        stack_primes(set->layout, markup.primes);
        find_bars(set, &markup);
    }
    fig_markup_free(&markup);
    *letters = set;
    return set == NULL ? FIG_NO_MEMORY : FIG_OK;
}

void fig_letters_free(fig_letters *letters)
{
    if (letters == NULL)
        return;
    g_object_unref(letters->layout);
    free(letters);
}

void fig_letters_ink(const fig_letters *letters, double *x, double *y,
                     double *width, double *height)
{
    PangoRectangle ink;
    pango_layout_get_extents(letters->layout, &ink, NULL);
    double top = (double)ink.y / PANGO_SCALE - letters->baseline;
    double bottom = top + (double)ink.height / PANGO_SCALE;
    double left = (double)ink.x / PANGO_SCALE;
    double right = left + (double)ink.width / PANGO_SCALE;
    for (int i = 0; i < letters->bar_count; i++) {
        const bar *over = &letters->bars[i];
        double edge = -over->height - bar_width * letters->size;
        top = edge < top ? edge : top;
        right = over->to > right ? over->to : right;
    }
    *x = left;
    *y = top;
    *width = right - left;
    *height = bottom - top;
}

double fig_letters_advance(const fig_letters *letters)
{
    PangoRectangle logical;
    pango_layout_get_extents(letters->layout, NULL, &logical);
    return (double)logical.width / PANGO_SCALE;
}

void fig_letters_clear(const fig_letters *letters, cairo_t *cairo, double x,
                       double y, double width, fig_rgb color, double opacity)
{
    cairo_set_source_rgba(cairo, color.r, color.g, color.b, opacity);
    cairo_move_to(cairo, x, y - letters->baseline);
    pango_cairo_layout_path(cairo, letters->layout);
    cairo_set_line_width(cairo, 2 * width);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    cairo_set_dash(cairo, NULL, 0, 0);
    cairo_stroke(cairo);
}

void fig_letters_draw(const fig_letters *letters, cairo_t *cairo, double x,
                      double y, fig_rgb color)
{
    cairo_set_source_rgb(cairo, color.r, color.g, color.b);
    cairo_move_to(cairo, x, y - letters->baseline);
    pango_cairo_show_layout(cairo, letters->layout);

    // The place of the letters is no point of the next path.
    cairo_new_path(cairo);
    cairo_set_line_width(cairo, bar_width * letters->size);
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_BUTT);
    for (int i = 0; i < letters->bar_count; i++) {
        const bar *over = &letters->bars[i];
        cairo_move_to(cairo, x + over->from, y - over->height);
        cairo_line_to(cairo, x + over->to, y - over->height);
        cairo_stroke(cairo);
    }
}
