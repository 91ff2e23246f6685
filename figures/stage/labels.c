#include "stage/list.h"
#include "stage/page_parts.h"
#include "stage/placement.h"

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

static void add_tag(tf_page *page, const tf_panel *panel, const double at[3],
                    tf_label label)
{
    tf_tag tag = {.panel = panel, .at = {at[0], at[1], at[2]}, .label = label};
    tf_stage_status status =
        tf_letters_set(page->family, label.text,
                       label.size > 0 ? label.size : TF_LETTERS, &tag.letters);
    if (status == TF_STAGE_OK &&
        !tf_list_room(&page->tags, page->tag_count, 1, &page->tag_room,
                      sizeof *page->tags))
        status = TF_STAGE_NO_MEMORY;
    if (status != TF_STAGE_OK) {
        tf_page_note(page, status);
        tf_letters_free(tag.letters);
        return;
    }
    tag.label.text = NULL;
    page->tags[page->tag_count++] = tag;
}

void tf_page_label(tf_page *page, double x, double y, tf_label label)
{
    add_tag(page, NULL, (double[]){x, y, 0}, label);
}

void tf_panel_label(tf_panel *panel, const double at[3], tf_label label)
{
    add_tag(panel->page, panel, at, label);
}

// Placing ----------------------------------------------------------------

/// What labels are placed among.
typedef struct crowd {
    tf_obstacle *obstacles;
    tf_box *taken;
    int obstacle_count, taken_count;
    int obstacle_room, taken_room;
    bool out_of_memory;
} crowd;

static void add_obstacle(crowd *c, const double from[2], const double to[2],
                         double width, double weight)
{
    if (!tf_list_room(&c->obstacles, c->obstacle_count, 1, &c->obstacle_room,
                      sizeof *c->obstacles)) {
        c->out_of_memory = true;
        return;
    }
    c->obstacles[c->obstacle_count++] =
        (tf_obstacle){{from[0], from[1]}, {to[0], to[1]}, width / 2, weight};
}

static void add_scene(crowd *c, const tf_panel *panel)
{
    tf_view view = tf_panel_view(panel);
    for (int i = 0; i < panel->scene.ball_count; i++) {
        const tf_ball *ball = &panel->scene.balls[i];
        double at[2];
        tf_view_project(&view, ball->at, at);
        add_obstacle(c, at, at, ball->diameter, ball_weight);
    }
    for (int i = 0; i < panel->scene.tube_count; i++) {
        const tf_tube *tube = &panel->scene.tubes[i];
        double from[2], to[2];
        tf_view_project(&view, tube->from, from);
        tf_view_project(&view, tube->to, to);
        add_obstacle(c, from, to, tube->width,
                     tube->width > TF_WIDTH_THIN   ? tube_weight
                     : tube->width > TF_WIDTH_HAIR ? crease_weight
                                                   : hair_weight);
    }
}

static void add_line(crowd *c, const tf_mark *mark)
{
    double width = mark->stroke.width;
    for (int i = 0; i + 1 < mark->count; i++) {
        double from[2], to[2];
        tf_page_point(mark->panel, mark->at[i], from);
        tf_page_point(mark->panel, mark->at[i + 1], to);
        add_obstacle(c, from, to, width, line_weight);
    }
}

static void add_taken(crowd *c, const tf_mark *mark)
{
    if (!tf_list_room(&c->taken, c->taken_count, 1, &c->taken_room,
                      sizeof *c->taken)) {
        c->out_of_memory = true;
        return;
    }
    c->taken[c->taken_count++] = tf_mark_text_box(mark);
}

static void add_mark(crowd *c, const tf_mark *mark)
{
    if (mark->kind == TF_MARK_PANEL)
        add_scene(c, mark->panel);
    else if (mark->kind == TF_MARK_LINE && !mark->stroke.under_labels)
        add_line(c, mark);
    else if (mark->kind == TF_MARK_DOT)
        add_obstacle(c, mark->at[0], mark->at[0], mark->stroke.width,
                     ball_weight);
    else if (mark->kind == TF_MARK_TEXT)
        add_taken(c, mark);
}

static tf_wish wish_of(tf_tag *tag)
{
    double x, y;
    tf_wish wish = {.any_side = tag->label.side == TF_SIDE_ANY};
    tf_letters_ink(tag->letters, &x, &y, &wish.width, &wish.height);
    tf_page_point(tag->panel, tag->at, wish.anchor);
    int eighth = wish.any_side ? 1 : (int)tag->label.side - (int)TF_SIDE_E;
    wish.direction = eighth * 0.7853981633974483;
    wish.gap = tag->label.gap > 0 ? tag->label.gap : TF_WIDTH_BALL / 2 + 2;
    wish.reach = tag->label.leader ? leader_reach : reach;
    wish.distance_cost = tag->label.leader ? leader_cost : plain_cost;
    return wish;
}

static bool place_among(tf_page *page, const crowd *c, tf_wish *wishes,
                        tf_box *placed)
{
    tf_box inside = {border, border, page->options.width - 2 * border,
                     page->options.height - 2 * border};
    for (int i = 0; i < page->tag_count; i++)
        wishes[i] = wish_of(&page->tags[i]);
    if (!tf_place(inside, page->tag_count, wishes, c->taken_count, c->taken,
                  c->obstacle_count, c->obstacles, placed))
        return false;
    for (int i = 0; i < page->tag_count; i++)
        page->tags[i].placed =
            (tf_placed){{wishes[i].anchor[0], wishes[i].anchor[1]}, placed[i]};
    return true;
}

bool tf_page_place_tags(tf_page *page)
{
    crowd c = {.obstacles = NULL};
    for (int i = 0; i < page->mark_count; i++)
        add_mark(&c, &page->marks[i]);
    size_t count = (size_t)page->tag_count + 1;
    tf_wish *wishes = calloc(count, sizeof *wishes);
    tf_box *placed = calloc(count, sizeof *placed);
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
static void draw_leader(const tf_page *page, const tf_tag *tag, cairo_t *cairo)
{
    const tf_box *box = &tag->placed.box;
    const double *from = tag->placed.anchor;
    double to[2] = {fmax(box->x, fmin(from[0], box->x + box->width)),
                    fmax(box->y, fmin(from[1], box->y + box->height))};
    double dx = to[0] - from[0], dy = to[1] - from[1];
    double length = hypot(dx, dy);
    double begin = tag->label.gap > 0 ? 0 : TF_WIDTH_BALL / 2;
    if (length < begin + leader_least + leader_gap)
        return;
    tf_rgb color = page->options.theme->color[TF_ROLE_NEUTRAL];
    cairo_set_source_rgb(cairo, color.r, color.g, color.b);
    cairo_set_line_width(cairo, TF_WIDTH_HAIR);
    cairo_set_dash(cairo, NULL, 0, 0);
    cairo_move_to(cairo, from[0] + dx * begin / length,
                  from[1] + dy * begin / length);
    cairo_line_to(cairo, to[0] - dx * leader_gap / length,
                  to[1] - dy * leader_gap / length);
    cairo_stroke(cairo);
}

void tf_page_draw_tags(const tf_page *page, cairo_t *cairo)
{
    const tf_theme *theme = page->options.theme;
    for (int i = 0; i < page->tag_count; i++) {
        const tf_tag *tag = &page->tags[i];
        double x, y, width, height;
        tf_letters_ink(tag->letters, &x, &y, &width, &height);
        if (tag->label.leader)
            draw_leader(page, tag, cairo);
        x = tag->placed.box.x - x;
        y = tag->placed.box.y - y;
        tf_letters_clear(tag->letters, cairo, x, y, halo,
                         theme->color[TF_ROLE_PAPER], halo_opacity);
        tf_letters_draw(tag->letters, cairo, x, y,
                        theme->color[tag->label.role]);
    }
}
