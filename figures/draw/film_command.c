#include "draw/commands.h"
#include "draw/drawing.h"
#include "draw/film_files.h"
#include "kit/cloth.h"

#include "files/visible.h"
#include "renderer/figure.h"
#include "renderer/list.h"
#include "scenes/frames.h"
#include "simulate/frame_notes.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>

/// The page without a size in pixels, in points.
static const double page_height = 240;

// Arguments --------------------------------------------------------------

typedef struct request {
    const char *folder;
    int every; ///< of so many frames one is drawn
    int still; ///< the frame of a picture; -1: the last one
    int up;    ///< an axis; -1: the one that the frames name
    fig_settings settings;
} request;

enum {
    OLD_EVERY = 'e',
    OLD_FRAME = 'f',
    EVERY = 256, // from here on: no letter
    FRAME
};

static const struct argp_option options[] = {
    {"every", EVERY, "K", 0, "Draw only every K-th frame, from the first on",
     0},
    {"frame", FRAME, "N", 0,
     "The frame of a picture, from 0; the default is the last one", 0},
    {"up", 'u', "AXIS", 0,
     "The axis that points up: x, y or z; the default is that of the scene", 0},
    FIG_OLD_LETTER(OLD_EVERY),
    FIG_OLD_LETTER(OLD_FRAME),
    {0},
};

/// See that the arguments go together.
static void check(struct argp_state *state)
{
    const request *asked = state->input;
    if (asked->settings.film && asked->still >= 0)
        argp_error(state, "--frame is for pictures; drop it, or write to a "
                          ".png file");
    if (asked->settings.picture && asked->every > 1)
        argp_error(state, "--every is for films; drop it, or write to a .webp "
                          "file");
}

static error_t understand(int key, char *text, struct argp_state *state)
{
    request *asked = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &asked->settings;
        return 0;
    case EVERY:
        asked->every = fig_read_count(state, "--every", text, 1, INT_MAX);
        return 0;
    case FRAME:
        asked->still = fig_read_count(state, "--frame", text, 0, INT_MAX);
        return 0;
    case 'u':
        asked->up = (int)fig_read_up(state, text);
        return 0;
    case OLD_EVERY:
        fig_refuse_letter(state, OLD_EVERY, "--every");
        return 0;
    case OLD_FRAME:
        fig_refuse_letter(state, OLD_FRAME, "--frame");
        return 0;
    case ARGP_KEY_ARG:
        if (asked->folder)
            argp_error(state, "unexpected '%s'; draw one film at a time",
                       tf_make_visible(text).text);
        asked->folder = text;
        return 0;
    case ARGP_KEY_NO_ARGS:
        argp_error(state, "a folder is required: one that 'tanglefree "
                          "simulate' wrote");
        return 0;
    case ARGP_KEY_SUCCESS:
        check(state);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

// Frames -----------------------------------------------------------------

/// Frames with the same elements.
typedef struct take {
    tf_surface *surface;
    fig_cloth *cloth;
} take;

/// A film on its way from its files to a page.
typedef struct film {
    take *take;
    int takes, room;
    tf_frames frames;            ///< the last two that were read
    char path[2][FIG_FILM_PATH]; ///< theirs, which their messages name
    fig_cloth_look look;
    tf_frame_notes notes; ///< those of the first frame
    int up;               ///< an axis; -1: the one of the notes
    int count;            ///< frames of all takes
    int still;
} film;

static bool lack_memory(film *f)
{
    return tf_mesh_file_fault(&f->frames.file[f->frames.current], -1,
                              "not enough memory for all frames up to this "
                              "one; draw fewer by --every");
}

/// Tell the cloth of a take, which has its first frame, what the frames say of
/// its obstacles, if they say it.
static bool set_obstacles(const film *f, fig_cloth *cloth)
{
    int vertices = fig_cloth_shape(cloth)->vertices;
    const tf_frame_notes *notes = &f->notes;
    if (notes->meshes == 0 || notes->mesh[notes->meshes - 1].end != vertices)
        return true;
    bool *of_obstacle = malloc(((size_t)vertices + 1) * sizeof *of_obstacle);
    for (int v = 0; v < vertices && of_obstacle; v++)
        of_obstacle[v] = tf_frame_notes_role(notes, v) != TF_MOVING;
    bool good = of_obstacle && fig_cloth_set_obstacles(cloth, of_obstacle);
    free(of_obstacle);
    return good;
}

/// Make the surface of a take from its first frame.  It is one of space, also
/// where all frames are in the plane.
static bool begin(film *f)
{
    const tf_mesh_file *file = tf_frames_file(&f->frames);
    const tf_mesh mesh = {.axes = 3,
                          .vertices = tf_mesh_file_vertices(file),
                          .triangles = tf_mesh_file_triangles(file),
                          .triangle = file->triangle.item,
                          .edges = tf_mesh_file_edges(file),
                          .edge = file->edge.item};
    if (!fig_list_room(&f->take, f->takes, 1, &f->room, sizeof *f->take))
        return lack_memory(f);
    take *made = &f->take[f->takes++];
    *made = (take){0};
    tf_error error;
    tf_status status = tf_surface_create(&mesh, &made->surface, &error);
    if (status != TF_OK)
        return tf_frames_fault(&f->frames, &error);
    made->cloth = fig_cloth_new(made->surface, 3);
    if (!made->cloth)
        return lack_memory(f);
    fig_cloth_set_up(made->cloth, (fig_up)f->up);
    return true;
}

static bool add(film *f, const char *path)
{
    if (!tf_frames_next(&f->frames, path) || (f->frames.is_new && !begin(f)))
        return false;
    const tf_mesh_file *file = tf_frames_file(&f->frames);
    fig_cloth *cloth = f->take[f->takes - 1].cloth;
    f->count++;
    return (fig_cloth_add(cloth, tf_mesh_file_vertices(file),
                          file->position.item) &&
            (fig_cloth_frames(cloth) > 1 || set_obstacles(f, cloth))) ||
           lack_memory(f);
}

/// Read what the first frame says of all.
static bool read_notes(film *f, const char *path)
{
    if (!tf_frame_notes_read(&f->notes, path))
        return tf_fault_set(&f->frames.fault, path, -1, "%s",
                            tf_status_message(TF_OUT_OF_MEMORY));
    if (f->up < 0)
        f->up = f->notes.up < 0 ? (int)FIG_UP_Z : f->notes.up;
    return true;
}

/// Read the i-th frame of a folder.
static bool read_frame(film *f, const char *folder, int i)
{
    char *path = f->path[f->frames.count % 2];
    fig_film_files_path(folder, i, path);
    return (i > 0 || read_notes(f, path)) && add(f, path);
}

static bool end(film *f)
{
    if (f->takes == 1)
        return fig_cloth_end(f->take[0].cloth);
    fig_cloth **all = malloc(((size_t)f->takes + 1) * sizeof *all);
    for (int i = 0; i < f->takes && all; i++)
        all[i] = f->take[i].cloth;
    bool good = all && fig_cloth_end_all(f->takes, all);
    free(all);
    return good;
}

/// Read every so many of `count` frames.  False: standard error has been told
/// why.
static bool read_frames(film *f, const request *asked, int count)
{
    bool good = true;
    tf_progress_line progress = fig_progress_begin();
    for (long i = 0; i < count && good; i += asked->every) {
        fig_progress_show(&progress, (int)i, count, "frames read");
        good = read_frame(f, asked->folder, (int)i);
    }
    tf_progress_line_end(&progress);
    if (good && !end(f))
        good = lack_memory(f);
    if (!good)
        tf_fault_print(&f->frames.fault, "tanglefree-draw");
    return good;
}

static void free_film(film *f)
{
    for (int i = 0; i < f->takes; i++) {
        fig_cloth_free(f->take[i].cloth);
        tf_surface_free(f->take[i].surface);
    }
    free(f->take);
    tf_frame_notes_free(&f->notes);
    tf_frames_free(&f->frames);
}

// Drawing ----------------------------------------------------------------

/// Those of a take, but for the number of frames.
static void print_numbers(const film *f, const fig_cloth *cloth, FILE *numbers)
{
    const fig_shape *shape = fig_cloth_shape(cloth);
    int stiff = 0;
    for (int p = 0; p < shape->parts; p++)
        stiff += fig_cloth_is_stiff(cloth, p);
    fig_number(numbers, "frames", f->count);
    fig_number(numbers, "vertices", shape->vertices);
    fig_number(numbers, "triangles", shape->triangles);
    fig_number(numbers, "edges", shape->edges);
    fig_number(numbers, "parts", shape->parts);
    fig_number(numbers, "stiff_parts", stiff);
}

static void draw_frame(const void *subject, fig_page *page, FILE *numbers)
{
    const film *f = subject;
    const take *t = f->take;
    int frame = fig_page_moves(page)
                    ? (int)lround(fig_page_time(page) * (f->count - 1))
                    : f->still;
    for (; frame >= fig_cloth_frames(t->cloth); t++)
        frame -= fig_cloth_frames(t->cloth);
    fig_box box = {0, 0, fig_page_width(page), fig_page_height(page)};
    fig_cloth_draw(t->cloth, page, box, frame, &f->look);
    print_numbers(f, t->cloth, numbers);
}

/// The height of a page that has that shape together with its title.
static double height_of(const fig_settings *settings)
{
    double height = FIG_PAGE_WIDTH * settings->shape;
    double title =
        settings->title
            ? fig_page_heading_height((fig_box){.width = FIG_PAGE_WIDTH})
            : 0;
    return fmax(height - title, height / 2);
}

/// Draw what was read: the page is as wide for its height as the picture.
static int draw(film *f, fig_settings *settings)
{
    fig_drawing drawing = {FIG_PAGE_WIDTH, page_height, f, draw_frame};
    if (settings->shape > 0)
        drawing.height = height_of(settings);
    f->look = (fig_cloth_look){.turned = settings->turned,
                               .azimuth = settings->azimuth,
                               .elevation = settings->elevation};
    settings->frames = f->count;
    return fig_drawing_make(&drawing, settings);
}

/// Which frame a picture shows; -1: there is no such frame.
static int choose_still(const request *asked, int count)
{
    if (asked->still < count)
        return asked->still < 0 ? count - 1 : asked->still;
    fprintf(stderr,
            "tanglefree-draw: %s: there is no frame %d; they are "
            "numbered from 0 to %d\n",
            tf_make_visible(asked->folder).text, asked->still, count - 1);
    return -1;
}

static int draw_film(request *asked)
{
    int count = fig_film_files_count(asked->folder);
    if (count < 0)
        return 2;
    film f = {.frames.may_differ = true,
              .still = choose_still(asked, count),
              .up = asked->up};
    int status = 2;
    if (f.still >= 0 && read_frames(&f, asked, count))
        status = draw(&f, &asked->settings);
    free_film(&f);
    return status;
}

int fig_draw_film(int argc, char *argv[])
{
    static const struct argp parser = {
        .options = options,
        .parser = understand,
        .args_doc = "FOLDER",
        .doc = "Draw a film of the frames of a simulation.\v"
               "FOLDER has the frames that 'tanglefree simulate' writes: "
               "frame-00000.ply, frame-00001.ply and so on.  Each connected "
               "part has its own color, paler on "
               "its back, and pale stripes along its border.  Meshes of a "
               "scene that are scripted or fixed are gray, and if the frames "
               "name no such roles, what keeps its shape in all of them; but "
               "where the elements change from frame to frame, as those of a "
               "surface that flows do, all has one color.  Cloth lies in the "
               "light of a lamp and of the sky, and throws soft shadows, also "
               "on the ground that is drawn below all frames.  Curves of the "
               "plane are drawn as lines.  The camera stands still, and all "
               "frames fit into the picture.\n\n"
               "A film shows 30 frames a second unless --fps says otherwise, "
               "and a step of a simulation takes 0.01 seconds unless its scene "
               "says otherwise.  So a film is 3.3 times as slow as what it "
               "shows; with --every 3 it takes about as long.\n\n"
               "The numbers are printed, one key and its value per line.\n\n"
               "Exit status: 0 on success, 2 if the arguments or the input are "
               "invalid or the output cannot be written.",
        .children = fig_settings_film_options,
    };
    request asked = {.every = 1, .still = -1, .up = -1};
    argp_parse(&parser, argc, argv, 0, NULL, &asked);
    return draw_film(&asked);
}
