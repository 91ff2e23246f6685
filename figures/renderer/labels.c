#include "renderer/list.h"
#include "renderer/page_parts.h"
#include "renderer/placement.h"

#include <math.h>
#include <stdlib.h>

/// How bad it is to cover things, for each point of their length.
static const double ball_weight = 8, tube_weight = 3, crease_weight = 1.2,
                    hair_weight = 0.3, line_weight = 2.5;

/// How far from its anchor a label may be moved, without and with a leader, and
/// what each point of that costs.
static const double reach = 14, leader_reach = 70;
static const double plain_cost = 1.2, leader_cost = 0.3;

/// From how far on a leader is drawn, and how far it stays off either end.
static const double leader_least = 5, leader_gap = 1.5;

/// The border around letters, and how strong it is.
static const double halo = 0.8, halo_opacity = 0.5;

/// Labels keep this far from the border of the page.
static const double border = 2;

static void add_tag(fig_page *page, const fig_panel *panel, tf_vector at,
                    fig_label label)
{
    if (page->options.bare)
        return;
    fig_tag tag = {.panel = panel, .at = at, .label = label};
    tag.letters = fig_page_letters(page, label.text, label.size);
    if (tag.letters == NULL)
        return;
    if (!fig_list_room(&page->tags, page->tag_count, 1, &page->tag_room,
                       sizeof *page->tags)) {
        fig_page_note(page, FIG_NO_MEMORY);
        fig_letters_free(tag.letters);
        return;
    }
    tag.label.text = NULL;
    page->tags[page->tag_count++] = tag;
}

void fig_page_label(fig_page *page, double x, double y, fig_label label)
{
    add_tag(page, NULL, (tf_vector){{x, y, 0}}, label);
}

void fig_panel_label(fig_panel *panel, tf_vector at, fig_label label)
{
    add_tag(panel->page, panel, at, label);
}

// Placing ----------------------------------------------------------------

/// What labels are placed among.
typedef struct crowd {
    fig_obstacle *obstacles;
    fig_box *taken;
    int obstacle_count, taken_count;
    int obstacle_room, taken_room;
    bool out_of_memory;
} crowd;

static void add_obstacle(crowd *c, fig_point from, fig_point to, double width,
                         double weight)
{
    if (!fig_list_room(&c->obstacles, c->obstacle_count, 1, &c->obstacle_room,
                       sizeof *c->obstacles)) {
        c->out_of_memory = true;
        return;
    }
    c->obstacles[c->obstacle_count++] =
        (fig_obstacle){from, to, width / 2, weight};
}

static void add_scene(crowd *c, const fig_panel *panel)
{
    fig_view view = fig_panel_view(panel);
    for (int i = 0; i < panel->scene.ball_count; i++) {
        const fig_ball *ball = &panel->scene.balls[i];
        fig_point at = fig_view_project(&view, ball->at);
        add_obstacle(c, at, at, ball->diameter, ball_weight);
    }
    for (int i = 0; i < panel->scene.tube_count; i++) {
        const fig_tube *tube = &panel->scene.tubes[i];
        add_obstacle(c, fig_view_project(&view, tube->from),
                     fig_view_project(&view, tube->to), tube->width,
                     tube->width > FIG_WIDTH_THIN   ? tube_weight
                     : tube->width > FIG_WIDTH_HAIR ? crease_weight
                                                    : hair_weight);
    }
}

static void add_line(crowd *c, const fig_mark *mark)
{
    double width = mark->stroke.width;
    for (int i = 0; i + 1 < mark->count; i++)
        add_obstacle(c, fig_page_point(mark->panel, mark->at[i]),
                     fig_page_point(mark->panel, mark->at[i + 1]), width,
                     line_weight);
}

static void add_taken(crowd *c, const fig_mark *mark)
{
    if (!fig_list_room(&c->taken, c->taken_count, 1, &c->taken_room,
                       sizeof *c->taken)) {
        c->out_of_memory = true;
        return;
    }
    c->taken[c->taken_count++] = fig_mark_text_box(mark);
}

static void add_dot(crowd *c, const fig_mark *mark)
{
    fig_point at = fig_page_point(mark->panel, mark->at[0]);
    add_obstacle(c, at, at, mark->stroke.width, ball_weight);
}

static void add_mark(crowd *c, const fig_mark *mark)
{
    if (mark->kind == FIG_MARK_PANEL)
        add_scene(c, mark->panel);
    else if (mark->kind == FIG_MARK_LINE && !mark->stroke.under_labels)
        add_line(c, mark);
    else if (mark->kind == FIG_MARK_DOT)
        add_dot(c, mark);
    else if (mark->kind == FIG_MARK_TEXT)
        add_taken(c, mark);
}

static fig_wish wish_of(fig_tag *tag)
{
    double x, y;
    fig_wish wish = {.any_side = tag->label.side == FIG_SIDE_ANY};
    fig_letters_ink(tag->letters, &x, &y, &wish.width, &wish.height);
    wish.anchor = fig_page_point(tag->panel, tag->at);
    int eighth = wish.any_side ? 1 : (int)tag->label.side - (int)FIG_SIDE_E;
    wish.direction = eighth * 0.7853981633974483;
    wish.gap = tag->label.gap > 0 ? tag->label.gap : FIG_WIDTH_BALL / 2 + 2;
    wish.reach = tag->label.leader ? leader_reach : reach;
    wish.distance_cost = tag->label.leader ? leader_cost : plain_cost;
    return wish;
}

static bool place_among(fig_page *page, const crowd *c, fig_wish *wishes,
                        fig_box *placed)
{
    const fig_box *content = &page->content;
    fig_box inside = {content->x + border, content->y + border,
                      content->width - 2 * border,
                      content->height - 2 * border};
    for (int i = 0; i < page->tag_count; i++)
        wishes[i] = wish_of(&page->tags[i]);
    if (!fig_place(inside, page->tag_count, wishes, c->taken_count, c->taken,
                   c->obstacle_count, c->obstacles, placed))
        return false;
    for (int i = 0; i < page->tag_count; i++)
        page->tags[i].placed = (fig_placed){wishes[i].anchor, placed[i]};
    return true;
}

bool fig_page_place_tags(fig_page *page)
{
    crowd c = {.obstacles = NULL};
    for (int i = 0; i < page->mark_count; i++)
        add_mark(&c, &page->marks[i]);
    size_t count = (size_t)page->tag_count + 1;
    fig_wish *wishes = calloc(count, sizeof *wishes);
    fig_box *placed = calloc(count, sizeof *placed);
    bool fine = !c.out_of_memory && wishes != NULL && placed != NULL &&
                place_among(page, &c, wishes, placed);
    free(wishes);
    free(placed);
    free(c.obstacles);
    free(c.taken);
    return fine;
}

// Drawing ----------------------------------------------------------------

/// A thin line from the anchor to the nearest place of the box.
static void draw_leader(const fig_page *page, const fig_tag *tag,
                        cairo_t *cairo)
{
    const fig_box *box = &tag->placed.box;
    fig_point from = tag->placed.anchor;
    fig_point to = {fmax(box->x, fmin(from.x, box->x + box->width)),
                    fmax(box->y, fmin(from.y, box->y + box->height))};
    double dx = to.x - from.x, dy = to.y - from.y;
    double length = hypot(dx, dy);
    double begin = tag->label.gap > 0 ? 0 : FIG_WIDTH_BALL / 2;
    if (length < begin + leader_least + leader_gap)
        return;
    fig_rgb color = page->options.theme->color[FIG_ROLE_NEUTRAL];
    cairo_set_source_rgb(cairo, color.r, color.g, color.b);
    cairo_set_line_width(cairo, FIG_WIDTH_HAIR);
    cairo_set_dash(cairo, NULL, 0, 0);
    cairo_move_to(cairo, from.x + dx * begin / length,
                  from.y + dy * begin / length);
    cairo_line_to(cairo, to.x - dx * leader_gap / length,
                  to.y - dy * leader_gap / length);
    cairo_stroke(cairo);
}

void fig_page_draw_tags(const fig_page *page, cairo_t *cairo)
{
    const fig_theme *theme = page->options.theme;
    for (int i = 0; i < page->tag_count; i++) {
        const fig_tag *tag = &page->tags[i];
        double x, y, width, height;
        fig_letters_ink(tag->letters, &x, &y, &width, &height);
        if (tag->label.leader)
            draw_leader(page, tag, cairo);
        x = tag->placed.box.x - x;
        y = tag->placed.box.y - y;
        fig_letters_clear(tag->letters, cairo, x, y, halo,
                          theme->color[FIG_ROLE_PAPER], halo_opacity);
        fig_letters_draw(tag->letters, cairo, x, y,
                         theme->color[tag->label.role]);
    }
}
