// What of a page is shown: all of it, or a part; and a heading.
#include "base/require.h"
#include "renderer/page_parts.h"

#include <math.h>
#include <stddef.h>

/// Of the smaller of two boxes, how much the other covers if they are one part.
static const double together = 0.3;

/// What is narrower or lower holds no more than an axis; in points.
static const double least_side = 40;

/// How long the longer side of a part is at least when only that is shown.
static const double least_shown = 256;

/// How far from a part its texts are, and how far they reach beyond it to its
/// left, where the numbers of a plot are, and to its right; in points.
static const double near = 20, beyond_left = 44, beyond_right = 14;

/// The room around a part and its texts, in points.
static const double around = 5;

/// The letters of a heading by the width of what it stands above, and at least
/// in points; its height by its letters, and how much of the width it may take.
static const double heading_letters = 0.042, least_letters = 15,
                    heading_height = 2.1, heading_width = 0.96;

// Boxes ------------------------------------------------------------------

static double area(const fig_box *box)
{
    return box->width * box->height;
}

static fig_box hull(fig_box a, fig_box b)
{
    double x = fmin(a.x, b.x), y = fmin(a.y, b.y);
    return (fig_box){x, y, fmax(a.x + a.width, b.x + b.width) - x,
                     fmax(a.y + a.height, b.y + b.height) - y};
}

static bool is_within(const fig_box *box, const fig_box *whole)
{
    return box->x >= whole->x &&
           box->x + box->width <= whole->x + whole->width &&
           box->y >= whole->y &&
           box->y + box->height <= whole->y + whole->height;
}

/// How far off a box is from another; 0 if they meet.
static double distance(const fig_box *a, const fig_box *b)
{
    double x = fmax(a->x - b->x - b->width, b->x - a->x - a->width);
    double y = fmax(a->y - b->y - b->height, b->y - a->y - a->height);
    return hypot(fmax(x, 0), fmax(y, 0));
}

// Parts ------------------------------------------------------------------

typedef struct layout {
    int count;
    fig_box part[FIG_PARTS_MOST];
} layout;

/// Whether one reads `a` before `b`.
static bool comes_first(const fig_box *a, const fig_box *b)
{
    if (a->y + a->height / 2 < b->y)
        return true;
    return b->y + b->height / 2 >= a->y && a->x < b->x;
}

/// Add a box as a part, one with all those that it overlaps.
static void add_part(layout *l, fig_box box)
{
    for (int i = l->count - 1; i >= 0; i--) {
        fig_box *other = &l->part[i];
        if (fig_box_overlap(&box, other) <
            together * fmin(area(&box), area(other)))
            continue;
        box = hull(box, *other);
        for (int j = i + 1; j < l->count; j++)
            l->part[j - 1] = l->part[j];
        l->count--;
    }
    if (l->count == FIG_PARTS_MOST)
        return;
    int at = l->count++;
    for (; at > 0 && comes_first(&box, &l->part[at - 1]); at--)
        l->part[at] = l->part[at - 1];
    l->part[at] = box;
}

static bool is_large(const fig_box *box)
{
    return fmin(box->width, box->height) >= least_side;
}

static layout layout_of(const fig_page *page)
{
    layout l = {0};
    for (int i = 0; i < page->panel_count; i++)
        if (is_large(&page->panels[i]->box))
            add_part(&l, page->panels[i]->box);
    for (int i = 0; i < page->plot_count; i++)
        if (is_large(&page->plots[i]))
            add_part(&l, page->plots[i]);
    return l;
}

int fig_page_parts(const fig_page *page)
{
    return layout_of(page).count;
}

/// The part that a text belongs to; -1 if it belongs to none.
static int owner_of(const layout *l, const fig_box *text)
{
    double least = near;
    int owner = -1;
    for (int i = 0; i < l->count; i++) {
        const fig_box *part = &l->part[i];
        double left = part->x - text->x;
        double right = text->x + text->width - part->x - part->width;
        double off = distance(text, part);
        if (left > beyond_left || right > beyond_right || off > least)
            continue;
        least = off;
        owner = i;
    }
    return owner;
}

fig_box fig_page_part(const fig_page *page, int i)
{
    layout l = layout_of(page);
    TF_REQUIRE(i >= 0 && i < l.count);
    fig_box box = l.part[i];
    for (int k = 0; k < page->mark_count; k++) {
        if (page->marks[k].kind != FIG_MARK_TEXT)
            continue;
        fig_box text = fig_mark_text_box(&page->marks[k]);
        if (owner_of(&l, &text) == i)
            box = hull(box, text);
    }
    return (fig_box){box.x - around, box.y - around, box.width + 2 * around,
                     box.height + 2 * around};
}

// Cropping ---------------------------------------------------------------

static bool shows_panel(const fig_box *box, const fig_panel *panel)
{
    return fig_box_overlap(&panel->box, box) >= area(&panel->box) / 2;
}

/// The box of a mark on the page that is no text.
static fig_box mark_box(const fig_mark *mark)
{
    if (mark->kind == FIG_MARK_MAP)
        return mark->box;
    fig_box box = {mark->at[0].x[0], mark->at[0].x[1], 0, 0};
    for (int i = 1; i < mark->count; i++)
        box = hull(box, (fig_box){mark->at[i].x[0], mark->at[i].x[1], 0, 0});
    return box;
}

/// What has its middle in the box is cut at its border, but texts are not.
static bool shows_mark(const fig_box *box, const fig_mark *mark)
{
    if (mark->panel != NULL)
        return shows_panel(box, mark->panel);
    if (mark->kind == FIG_MARK_TEXT) {
        fig_box text = fig_mark_text_box(mark);
        return is_within(&text, box);
    }
    fig_box own = mark_box(mark);
    fig_box middle = {own.x + own.width / 2, own.y + own.height / 2, 0, 0};
    return is_within(&middle, box);
}

static bool shows_tag(const fig_box *box, const fig_tag *tag)
{
    fig_box anchor = {tag->at.x[0], tag->at.x[1], 0, 0};
    return tag->panel != NULL ? shows_panel(box, tag->panel)
                              : is_within(&anchor, box);
}

static void crop_marks(fig_page *page, const fig_box *box)
{
    int kept = 0;
    for (int i = 0; i < page->mark_count; i++)
        if (shows_mark(box, &page->marks[i]))
            page->marks[kept++] = page->marks[i];
        else
            fig_mark_clear(&page->marks[i]);
    page->mark_count = kept;
}

static void crop_tags(fig_page *page, const fig_box *box)
{
    int kept = 0;
    for (int i = 0; i < page->tag_count; i++)
        if (shows_tag(box, &page->tags[i]))
            page->tags[kept++] = page->tags[i];
        else
            fig_letters_free(page->tags[i].letters);
    page->tag_count = kept;
}

/// Where a place of a box is when the box is magnified and moved to the origin.
static tf_vector moved(const fig_box *box, double scale, tf_vector at)
{
    return (tf_vector){
        {(at.x[0] - box->x) * scale, (at.x[1] - box->y) * scale, at.x[2]}};
}

static fig_box moved_box(const fig_box *box, double scale, fig_box part)
{
    return (fig_box){(part.x - box->x) * scale, (part.y - box->y) * scale,
                     part.width * scale, part.height * scale};
}

/// The middle of a text is moved, as its size stays.
static void move_text(const fig_box *box, double scale, fig_mark *mark)
{
    fig_box text = fig_mark_text_box(mark);
    double x = text.x + text.width / 2, y = text.y + text.height / 2;
    mark->at[0].x[0] += (x - box->x) * scale - x;
    mark->at[0].x[1] += (y - box->y) * scale - y;
}

static void move_mark(const fig_box *box, double scale, fig_mark *mark)
{
    mark->box = moved_box(box, scale, mark->box);
    if (mark->kind == FIG_MARK_TEXT)
        move_text(box, scale, mark);
    else if (mark->panel == NULL)
        for (int i = 0; i < mark->count; i++)
            mark->at[i] = moved(box, scale, mark->at[i]);
}

static void magnify(fig_page *page, const fig_box *box, double scale)
{
    for (int i = 0; i < page->panel_count; i++) {
        page->panels[i]->box = moved_box(box, scale, page->panels[i]->box);
        page->panels[i]->margin *= scale;
    }
    for (int i = 0; i < page->mark_count; i++)
        move_mark(box, scale, &page->marks[i]);
    for (int i = 0; i < page->tag_count; i++)
        if (page->tags[i].panel == NULL)
            page->tags[i].at = moved(box, scale, page->tags[i].at);
}

fig_box fig_page_crop(fig_page *page, fig_box box)
{
    double scale = fmax(least_shown / fmax(box.width, box.height), 1);
    crop_marks(page, &box);
    crop_tags(page, &box);
    magnify(page, &box, scale);
    page->shown = page->content = moved_box(&box, scale, box);
    page->cropped = true;
    return page->content;
}

// The heading ------------------------------------------------------------

static double letters_above(const fig_box *box)
{
    return fmax(heading_letters * box->width, least_letters);
}

double fig_page_heading_height(fig_box box)
{
    return heading_height * letters_above(&box);
}

void fig_page_heading(fig_page *page, const char *text)
{
    const fig_box *content = &page->content;
    double size = letters_above(content), width, height;
    double most = heading_width * content->width;
    fig_page_measure(page, text, size, &width, &height);
    fig_letters_free(page->heading);
    page->heading =
        fig_page_letters(page, text, width > most ? size * most / width : size);
    double room = fig_page_heading_height(*content);
    page->shown = *content;
    page->shown.y -= room;
    page->shown.height += room;
}

void fig_page_draw_heading(const fig_page *page, cairo_t *cairo)
{
    if (page->heading == NULL)
        return;
    const fig_box *content = &page->content;
    double middle = content->x + content->width / 2;
    double room = fig_page_heading_height(*content);
    fig_letters_draw(
        page->heading, cairo, middle - fig_letters_advance(page->heading) / 2,
        content->y - 0.38 * room, page->options.theme->color[FIG_ROLE_INK]);
}
