#include "renderer/markup.h"

#include <string.h>

/// Small letters' size and how far they are raised or lowered, by the size of
/// the others.
static const double script_size = 0.72, script_raise = 0.34,
                    script_lower = 0.17;

/// How far a prime over a subscript is raised, by the letters' size.
static const double prime_raise = 0.08;

/// Where reading is, and the looks that hold there.
typedef struct reader {
    fig_markup *markup;
    const char *at;
    double size;   ///< of plain letters, points
    bool math;     ///< within $...$
    bool upright;  ///< within \up
    bool slanted;  ///< within *...*
    bool heavy;    ///< within \b
    double script; ///< 1 raised, -1 lowered, 0 neither
} reader;

static void add_look(const reader *r, PangoAttribute *look, guint from)
{
    look->start_index = from;
    look->end_index = (guint)r->markup->text->len;
    pango_attr_list_insert(r->markup->looks, look);
}

static bool leans(const reader *r, gunichar letter)
{
    bool latin = g_unichar_isalpha(letter) && letter < 0x250;
    bool greek = letter >= 0x3b1 && letter <= 0x3c9;
    return r->slanted || (r->math && !r->upright && (latin || greek));
}

/// What a sign of mathematics is written for.
static gunichar sign_for(const reader *r, gunichar letter)
{
    if (!r->math || r->upright)
        return letter;
    return letter == '-' ? 0x2212 : letter == '\'' ? 0x2032 : letter;
}

static void put_letter(const reader *r, gunichar letter)
{
    guint from = (guint)r->markup->text->len;
    g_string_append_unichar(r->markup->text, sign_for(r, letter));
    if (leans(r, letter))
        add_look(r, pango_attr_style_new(PANGO_STYLE_ITALIC), from);
    if (r->heavy)
        add_look(r, pango_attr_weight_new(PANGO_WEIGHT_BOLD), from);
    if (r->script == 0)
        return;
    double rise = r->size * (r->script > 0 ? script_raise : -script_lower);
    add_look(r,
             pango_attr_size_new_absolute(
                 (int)(script_size * r->size * PANGO_SCALE)),
             from);
    add_look(r, pango_attr_rise_new((int)(rise * PANGO_SCALE)), from);
}

static bool read_item(reader *r);

/// What stands in braces, or one item.
static bool read_group(reader *r)
{
    if (*r->at != '{')
        return *r->at != '\0' && read_item(r);
    for (r->at++; *r->at != '}';)
        if (*r->at == '\0' || !read_item(r))
            return false;
    r->at++;
    return true;
}

static bool read_script(reader *r, double script)
{
    double before = r->script;
    r->script = script;
    r->at++;
    bool fine = read_group(r);
    r->script = before;
    return fine;
}

/// Put a prime before the subscript that begins at `from`, clear of it.
static void put_prime(const reader *r, guint from)
{
    GString *text = r->markup->text;
    gsize before = text->len;
    g_string_insert_unichar(text, from, sign_for(r, '\''));
    guint length = (guint)(text->len - before);
    pango_attr_list_update(r->markup->looks, (int)from, 0, (int)length);
    PangoAttribute *rise =
        pango_attr_rise_new((int)(prime_raise * r->size * PANGO_SCALE));
    rise->start_index = from;
    rise->end_index = from + length;
    pango_attr_list_insert(r->markup->looks, rise);
    g_array_append_val(r->markup->primes, from);
}

/// A subscript; a prime that follows goes before it, to stand over it.
static bool read_subscript(reader *r)
{
    guint from = (guint)r->markup->text->len;
    if (!read_script(r, -1))
        return false;
    if (*r->at != '\'' || r->script != 0)
        return true;
    r->at++;
    put_prime(r, from);
    return true;
}

static bool read_flagged(reader *r, bool *flag)
{
    bool before = *flag;
    *flag = true;
    bool fine = read_group(r);
    *flag = before;
    return fine;
}

static bool read_bar(reader *r)
{
    fig_bar bar = {.from = (guint)r->markup->text->len};
    bool fine = read_group(r);
    bar.to = (guint)r->markup->text->len;
    g_array_append_val(r->markup->bars, bar);
    return fine;
}

/// Move over `name` if it is next.
static bool skip(reader *r, const char *name)
{
    size_t length = strlen(name);
    if (strncmp(r->at, name, length) != 0)
        return false;
    r->at += length;
    return true;
}

static bool read_letter(reader *r)
{
    put_letter(r, g_utf8_get_char(r->at));
    r->at = g_utf8_next_char(r->at);
    return true;
}

static bool read_command(reader *r)
{
    if (skip(r, "\\bar"))
        return read_bar(r);
    if (skip(r, "\\up"))
        return read_flagged(r, &r->upright);
    if (skip(r, "\\b"))
        return read_flagged(r, &r->heavy);
    r->at++;
    return g_ascii_ispunct(*r->at) && read_letter(r);
}

static bool read_math(reader *r)
{
    r->math = true;
    for (r->at++; *r->at != '$';)
        if (*r->at == '\0' || !read_item(r))
            return false;
    r->math = false;
    r->at++;
    return true;
}

static bool read_item(reader *r)
{
    switch (*r->at) {
    case '\\':
        return read_command(r);
    case '$':
        return !r->math && read_math(r);
    case '_':
        return r->math ? read_subscript(r) : read_letter(r);
    case '^':
        return r->math ? read_script(r, 1) : read_letter(r);
    case '*':
        if (r->math)
            return read_letter(r);
        r->slanted = !r->slanted;
        r->at++;
        return true;
    default:
        return read_letter(r);
    }
}

bool fig_markup_read(fig_markup *markup, const char *text, double size)
{
    markup->text = g_string_new("");
    markup->looks = pango_attr_list_new();
    markup->bars = g_array_new(FALSE, FALSE, sizeof(fig_bar));
    markup->primes = g_array_new(FALSE, FALSE, sizeof(guint));
    reader r = {.markup = markup, .at = text, .size = size};
    bool fine = g_utf8_validate(text, -1, NULL);
    while (fine && *r.at != '\0')
        fine = read_item(&r);
    return fine && !r.slanted;
}

void fig_markup_free(fig_markup *markup)
{
    g_string_free(markup->text, TRUE);
    pango_attr_list_unref(markup->looks);
    g_array_free(markup->bars, TRUE);
    g_array_free(markup->primes, TRUE);
}
