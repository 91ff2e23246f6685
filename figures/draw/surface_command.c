#include "draw/commands.h"
#include "draw/surface_picture.h"
#include "fast/detect.h"

#include "files/visible.h"
#include "scenes/frames.h"
#include "threads/threads.h"

#include <stdlib.h>
#include <string.h>

// Arguments --------------------------------------------------------------

typedef struct request {
    const char *path[2];
    int path_count;
    bool contacts, crossings, told_motion;
    fig_motion motion;
    fig_up up;
    double time; ///< -1: not told
    fig_settings settings;
} request;

enum {
    TIME = 'T',
    OLD_MOTION = 'm',
    MOTION = 256, // no letter
    CROSSINGS     // nor this one
};

static const struct argp_option options[] = {
    {"contacts", 'c', NULL, 0,
     "Mark the contacts of the step; at rest, the intersections", 0},
    {"crossings", CROSSINGS, NULL, 0,
     "Draw the curves along which the surface intersects itself at rest, and "
     "the zones around them",
     0},
    {"motion", MOTION, "MOTION", 0,
     "How elements follow their vertices in mid-step: bent or straight; the "
     "default is bent",
     0},
    {"at", TIME, "T", 0,
     "The time of the step to draw, from 0 to 1; the default is that of the "
     "first contact if contacts are marked and there is one, otherwise 1",
     0},
    {"time", 0, NULL, OPTION_ALIAS, NULL, 0},
    {"up", 'u', "AXIS", 0,
     "The axis that points up: x, y or z; the default is z", 0},
    FIG_OLD_LETTER(OLD_MOTION),
    {0},
};

static void read_motion(struct argp_state *state, const char *text)
{
    request *asked = state->input;
    asked->told_motion = true;
    if (strcmp(text, "bent") == 0)
        asked->motion = FIG_BENT;
    else if (strcmp(text, "straight") == 0)
        asked->motion = FIG_STRAIGHT;
    else
        argp_error(state, "--motion must be bent or straight, got '%s'",
                   tf_make_visible(text).text);
}

static void read_path(struct argp_state *state, const char *text)
{
    request *asked = state->input;
    if (asked->path_count == 2)
        argp_error(state, "unexpected '%s'; give one START and one END",
                   tf_make_visible(text).text);
    else
        asked->path[asked->path_count++] = text;
}

/// See that the arguments go together.
static void check(struct argp_state *state)
{
    const request *asked = state->input;
    const char *option = asked->time >= 0     ? "--at"
                         : asked->told_motion ? "--motion"
                                              : NULL;
    if (asked->path_count == 1 && option)
        argp_error(state, "%s is for steps; add END", option);
    if (asked->path_count == 1 && asked->settings.film &&
        !asked->settings.turntable)
        argp_error(state, "nothing moves without END; add it, or "
                          "--turntable");
    if (asked->crossings && asked->path_count == 2)
        argp_error(state, "--crossings is for a surface at rest; drop END, or "
                          "write --contacts");
    if (asked->crossings && asked->contacts)
        argp_error(state, "--contacts and --crossings exclude each other; drop "
                          "one");
}

static error_t understand(int key, char *text, struct argp_state *state)
{
    request *asked = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        state->child_inputs[0] = &asked->settings;
        return 0;
    case 'c':
        asked->contacts = true;
        return 0;
    case CROSSINGS:
        asked->crossings = true;
        return 0;
    case OLD_MOTION:
        fig_refuse_letter(state, OLD_MOTION, "--motion");
        return 0;
    case MOTION:
        read_motion(state, text);
        return 0;
    case TIME:
        asked->time = fig_read_time(state, "--at", text);
        return 0;
    case 'u':
        asked->up = fig_read_up(state, text);
        return 0;
    case ARGP_KEY_ARG:
        read_path(state, text);
        return 0;
    case ARGP_KEY_NO_ARGS:
        argp_error(state, "a surface is required: its file");
        return 0;
    case ARGP_KEY_SUCCESS:
        fig_refuse_names(state, &asked->settings);
        check(state);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

// The surface ------------------------------------------------------------

static bool lack_memory(tf_frames *frames)
{
    return tf_mesh_file_fault(&frames->file[frames->current], -1, "%s",
                              tf_status_message(TF_OUT_OF_MEMORY));
}

static bool mark_contacts(tf_frames *frames, const tf_parallel *parallel,
                          fig_shown_surface *shown)
{
    tf_detect_options detection = {.parallel = parallel};
    tf_motion motion = tf_frames_motion(frames);
    tf_contacts found;
    tf_error error;
    tf_status status =
        tf_surface_detect(frames->surface, &motion, &detection, &found, &error);
    if (status != TF_OK)
        return tf_frames_fault(frames, &error);
    return fig_marks_of_contacts(&shown->marks, &shown->shape, &found) ||
           lack_memory(frames);
}

static bool mark_crossings(tf_frames *frames, const tf_parallel *parallel,
                           fig_shown_surface *shown)
{
    tf_check_options check = {.parallel = parallel};
    tf_motion rest = tf_frames_motion(frames);
    tf_crossings found;
    tf_error error;
    tf_status status =
        shown->crosses
            ? fig_tangled_find(&shown->tangled, frames->surface, &shown->shape,
                               rest.start, &check, &found, &error)
            : tf_surface_check(frames->surface, rest.vertices, rest.start,
                               &check, &found, &error);
    if (status != TF_OK)
        return tf_frames_fault(frames, &error);
    return fig_marks_of_crossings(&shown->marks, &shown->shape, &found) ||
           lack_memory(frames);
}

static bool mark(tf_frames *frames, fig_shown_surface *shown)
{
    tf_threads *threads;
    tf_threads_create(0, &threads);
    const tf_parallel *parallel = tf_threads_parallel(threads);
    bool marked = shown->steps ? mark_contacts(frames, parallel, shown)
                               : mark_crossings(frames, parallel, shown);
    tf_threads_free(threads);
    return marked;
}

static bool read_frames(const request *asked, tf_frames *frames)
{
    for (int i = 0; i < asked->path_count; i++)
        if (!tf_frames_next(frames, asked->path[i]))
            return false;
    if (frames->axes == 2 && asked->settings.turntable)
        return tf_mesh_file_fault(&frames->file[frames->current], -1,
                                  "a curve in the plane cannot be turned; drop "
                                  "--turntable");
    return true;
}

static bool take_surface(const request *asked, tf_frames *frames,
                         fig_shown_surface *shown)
{
    if (!read_frames(asked, frames))
        return false;
    tf_motion motion = tf_frames_motion(frames);
    shown->steps = asked->path_count == 2;
    shown->motion = asked->motion;
    shown->crosses = asked->crossings;
    shown->marked = asked->contacts || asked->crossings;
    if (!fig_shape_make(&shown->shape, frames->surface, frames->axes, &motion,
                        asked->up))
        return lack_memory(frames);
    bool marked = !shown->marked || mark(frames, shown);
    if (marked)
        fig_shown_surface_look(shown, asked->time);
    return marked;
}

static int draw(const request *asked, fig_shown_surface *shown)
{
    tf_frames frames = {0};
    int status = 2;
    if (take_surface(asked, &frames, shown)) {
        fig_drawing drawing = fig_surface_drawing(shown);
        status = fig_drawing_make(&drawing, &asked->settings);
    } else {
        tf_fault_print(&frames.fault, "tanglefree-draw");
    }
    fig_tangled_free(&shown->tangled);
    fig_marks_free(&shown->marks);
    fig_shape_free(&shown->shape);
    tf_frames_free(&frames);
    return status;
}

int fig_draw_surface(int argc, char *argv[])
{
    static const struct argp parser = {
        .options = options,
        .parser = understand,
        .args_doc = "START [END]",
        .doc =
            "Draw a surface, or a step of it from one position to another.\v"
            "The files are as for 'tanglefree detect'.  Each connected part "
            "has its own color.  Borders and sharp bends are drawn as lines, "
            "and so are all edges if they are long enough on the page.  A "
            "curve in the plane is drawn as lines and dots.\n\n"
            "In a step the vertices move in straight lines.  With --motion "
            "bent an element moves one vertex after another, in the order of "
            "their indices, as in 'tanglefree detect': in mid-step edges and "
            "triangles are bent, and this is the motion whose contacts are "
            "found.  With --motion straight elements stay straight and flat.  "
            "This looks smoother, but elements may pass through each other at "
            "other times than those of the contacts.\n\n"
            "--contacts draws in red the elements that touch during the step, "
            "paler those that have not touched yet (in a film these are not "
            "marked), and as balls the first places of contact, or all if "
            "they are few.  Without END it marks what intersects at rest, as "
            "in 'tanglefree check'.\n\n"
            "--crossings draws a surface at rest: in red, the curves along "
            "which it passes through itself, and balls where it only touches "
            "itself; and fainter than the rest its zones, which are the "
            "triangles that intersect and those that share a vertex with "
            "them.  Triangles of a zone that share a vertex, or intersect each "
            "other, are in the same zone.  In the plane it draws dots, and "
            "broad bands along the edges of zones.\n\n"
            "The numbers are printed, one key and its value per line.\n\n"
            "Exit status: 0 on success, 2 if the arguments or the input are "
            "invalid or the output cannot be written.",
        .children = fig_settings_options,
    };
    request asked = {.time = -1, .up = FIG_UP_Z};
    argp_parse(&parser, argc, argv, 0, NULL, &asked);
    fig_shown_surface *shown = calloc(1, sizeof *shown);
    if (!shown) {
        fprintf(stderr, "tanglefree-draw: %s\n",
                tf_status_message(TF_OUT_OF_MEMORY));
        return 2;
    }
    int status = draw(&asked, shown);
    free(shown);
    return status;
}
