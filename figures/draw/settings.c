#define _GNU_SOURCE
#include "draw/settings.h"

#include "files/number.h"
#include "files/visible.h"
#include "renderer/markup.h"
#include "renderer/page.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    SIZE = 's',
    TRANSPARENT = 'x',
    OLD_THEME = 't',
    DPI = 256, // from here on: no letter
    THEME,
    ANIMATE,
    FRAMES,
    FPS,
    TURNTABLE,
    TITLE,
    PANEL,
    LABELS
};

enum {
    FRAMES_MOST = 10000,
    FPS_MOST = 120,
    DPI_MOST = 4800,
    RATIO_MOST = 100
};

// Options that all commands share.
#define SIZE_OPTION                                                            \
    {                                                                          \
        "size", SIZE, "WxH", 0,                                                \
            "Size in pixels, or W:H, the shape, such as 16:9; the default "    \
            "width is 1600, of films 960",                                     \
            0                                                                  \
    }
#define TITLE_OPTION                                                           \
    {                                                                          \
        "title", TITLE, "TEXT", 0,                                             \
            "Write a title above the picture; $...$ is mathematics", 0         \
    }
#define THEME_OPTION                                                           \
    {                                                                          \
        "theme", THEME, "THEME", 0, "light or dark; the default is light", 0   \
    }
#define VIEW_OPTION                                                            \
    {                                                                          \
        "view", 'v', "AZ,EL", 0,                                               \
            "Look from this azimuth and elevation, in degrees", 0              \
    }
#define FPS_OPTION                                                             \
    {                                                                          \
        "fps", FPS, "N", 0, "Frames per second; the default is 30", 0          \
    }

static const struct argp_option options[] = {
    {"output", 'o', "FILE", 0,
     "Write a picture to this file: .png, or .pdf or .svg (in which text and "
     "lines are vectors)",
     0},
    SIZE_OPTION,
    {"dpi", DPI, "N", 0,
     "Resolution in pixels per inch; without --size it also determines the "
     "size in pixels",
     0},
    THEME_OPTION,
    {"transparent", TRANSPARENT, NULL, 0, "Leave out the background", 0},
    VIEW_OPTION,
    TITLE_OPTION,
    {"panel", PANEL, "N", 0,
     "Draw only panel N, counted from 1 row by row, from left to right", 0},
    {"labels", LABELS, "none|NAMES", 0,
     "Leave out the labels; or name the vertices of a query, in the order of "
     "its rows, such as q,u,v,w",
     0},
    {NULL, 0, NULL, 0, "Films:", 0},
    {"animate", ANIMATE, "FILE", 0,
     "Write a film to this file: .mp4, .gif, .webp or .png, a sheet of tiles",
     0},
    {"turntable", TURNTABLE, NULL, 0,
     "Turn the camera around once in the film, instead of letting time pass",
     0},
    {"frames", FRAMES, "N", 0, "Number of frames; the default is 90", 0},
    FPS_OPTION,
    FIG_OLD_LETTER(OLD_THEME),
    {0},
};

static const struct argp_option film_options[] = {
    {"output", 'o', "FILE", 0,
     "Write a film to this file, .webp, .gif or .mp4, or to a folder, FOLDER/, "
     "as a picture of each frame; or write a picture of one frame, .png, .pdf "
     "or .svg",
     0},
    SIZE_OPTION,
    THEME_OPTION,
    VIEW_OPTION,
    TITLE_OPTION,
    FPS_OPTION,
    FIG_OLD_LETTER(OLD_THEME),
    {0},
};

bool fig_path_ends(const char *path, const char *ending)
{
    size_t length = strlen(path), wanted = strlen(ending);
    return length > wanted && strcmp(path + length - wanted, ending) == 0 &&
           path[length - wanted - 1] != '/';
}

bool fig_path_is_folder(const char *path)
{
    size_t length = strlen(path);
    return length > 0 && path[length - 1] == '/';
}

/// A name of a file with one of the endings, after which comes NULL; `endings`
/// lists them in words.
static const char *read_path(struct argp_state *state, const char *option,
                             const char *text, const char *const ending[],
                             const char *endings)
{
    for (int i = 0; ending[i]; i++)
        if (fig_path_ends(text, ending[i]))
            return text;
    argp_error(state, "%s must end in %s, got '%s'", option, endings,
               tf_make_visible(text).text);
    return text;
}

/// The integer at the start of *text, which is stepped behind it; -1 if none
/// is there.
static long read_digits(const char **text)
{
    if (**text < '0' || **text > '9')
        return -1;
    char *end;
    long number = strtol(*text, &end, 10);
    *text = end;
    return number;
}

void fig_refuse_letter(struct argp_state *state, char letter, const char *now)
{
    argp_error(state, "-%c is an old spelling; write %s", letter, now);
}

int fig_read_count(struct argp_state *state, const char *option,
                   const char *text, int least, int most)
{
    const char *at = text;
    long count = read_digits(&at);
    if (*at != '\0' || count < least || count > most)
        argp_error(state, "%s must be an integer from %d to %d, got '%s'",
                   option, least, most, tf_make_visible(text).text);
    return (int)count;
}

fig_up fig_read_up(struct argp_state *state, const char *text)
{
    const char *axis = strlen(text) == 1 ? strchr("xyz", *text) : NULL;
    if (!axis)
        argp_error(state, "--up must be x, y or z, got '%s'",
                   tf_make_visible(text).text);
    return !axis || *axis == 'z' ? FIG_UP_Z
           : *axis == 'y'        ? FIG_UP_Y
                                 : FIG_UP_X;
}

double fig_read_time(struct argp_state *state, const char *option,
                     const char *text)
{
    const char *at = text;
    double time = 0;
    if (!tf_number_read(&at, &time) || *at != '\0' || !(time >= 0 && time <= 1))
        argp_error(state, "%s must be from 0 to 1, got '%s'", option,
                   tf_make_visible(text).text);
    return time;
}

static bool good_size(long pixels)
{
    return pixels >= FIG_PIXELS_LEAST && pixels <= FIG_PIXELS_MOST;
}

static bool good_ratio(long part)
{
    return part >= 1 && part <= RATIO_MOST;
}

/// Width and height in pixels, or their ratio.
static void read_size(struct argp_state *state, const char *text)
{
    fig_settings *settings = state->input;
    const char *at = text;
    long x = read_digits(&at), y = -1;
    bool ratio = *at == ':';
    if (*at == 'x' || ratio) {
        at++;
        y = read_digits(&at);
    }
    bool good =
        ratio ? good_ratio(x) && good_ratio(y) : good_size(x) && good_size(y);
    if (*at != '\0' || !good)
        argp_error(state,
                   "--size must be width and height, such as 1600x1200, both "
                   "from %d to %d pixels, or their ratio, such as 16:9, both "
                   "from 1 to %d, got '%s'",
                   FIG_PIXELS_LEAST, FIG_PIXELS_MOST, RATIO_MOST,
                   tf_make_visible(text).text);
    settings->pixels_x = ratio ? 0 : (int)x;
    settings->pixels_y = ratio ? 0 : (int)y;
    settings->shape = (double)y / (double)x;
}

void fig_check_text(struct argp_state *state, const char *option,
                    const char *text)
{
    fig_markup markup;
    bool good = fig_markup_read(&markup, text, FIG_LETTERS);
    fig_markup_free(&markup);
    if (!good)
        argp_error(state,
                   "%s must be UTF-8 that closes each $, * and { and has \\$, "
                   "\\* and \\\\ for the signs themselves, got '%s'",
                   option, tf_make_visible(text).text);
}

static void read_labels(fig_settings *settings, const char *text)
{
    settings->bare = strcmp(text, "none") == 0;
    settings->names = settings->bare ? NULL : text;
}

void fig_refuse_names(struct argp_state *state, const fig_settings *settings)
{
    if (settings->names)
        argp_error(state,
                   "--labels must be none, since only the vertices of a query "
                   "can be named, got '%s'",
                   tf_make_visible(settings->names).text);
}

static void read_view(struct argp_state *state, const char *text)
{
    fig_settings *settings = state->input;
    const char *at = text;
    double azimuth = 0, elevation = 0;
    bool good = tf_number_read(&at, &azimuth) && *at++ == ',' &&
                tf_number_read(&at, &elevation) && *at == '\0';
    if (!good || !(fabs(azimuth) <= 360) || !(fabs(elevation) <= 90))
        argp_error(state,
                   "--view must be two angles in degrees, such as 30,20, the "
                   "first from -360 to 360, the second from -90 to 90, got "
                   "'%s'",
                   tf_make_visible(text).text);
    settings->turned = true;
    settings->azimuth = azimuth;
    settings->elevation = elevation;
}

static void read_theme(struct argp_state *state, const char *text)
{
    fig_settings *settings = state->input;
    settings->theme = fig_theme_named(text);
    if (!settings->theme)
        argp_error(state, "--theme must be light or dark, got '%s'",
                   tf_make_visible(text).text);
}

/// Check that the options fit together.
static void check(struct argp_state *state)
{
    const fig_settings *settings = state->input;
    if (!settings->picture && !settings->film)
        argp_error(state, "--output FILE or --animate FILE is required: the "
                          "picture or the film");
    if (settings->film && settings->transparent &&
        (fig_path_ends(settings->film, ".mp4") ||
         fig_path_ends(settings->film, ".png")))
        argp_error(state, "an .mp4 file or a sheet cannot be transparent; drop "
                          "--transparent, or choose .webp or .gif");
    if (!settings->film && settings->turntable)
        argp_error(state, "--turntable is for films; add --animate "
                          "FILE.mp4");
}

static void set_usual(fig_settings *settings)
{
    *settings = (fig_settings){
        .theme = &fig_theme_light,
        .frames = 90,
        .fps = 30,
    };
}

/// What one option sets; ARGP_ERR_UNKNOWN if it is none of these.
static error_t understand_picture(int key, char *text, struct argp_state *state)
{
    static const char *const pictures[] = {".png", ".pdf", ".svg", NULL};
    fig_settings *settings = state->input;
    switch (key) {
    case 'o':
        settings->picture =
            read_path(state, "--output", text, pictures, ".png, .pdf or .svg");
        return 0;
    case SIZE:
        read_size(state, text);
        return 0;
    case DPI:
        settings->dpi = fig_read_count(state, "--dpi", text, 1, DPI_MOST);
        return 0;
    case OLD_THEME:
        fig_refuse_letter(state, OLD_THEME, "--theme");
        return 0;
    case THEME:
        read_theme(state, text);
        return 0;
    case TRANSPARENT:
        settings->transparent = true;
        return 0;
    case 'v':
        read_view(state, text);
        return 0;
    case TITLE:
        fig_check_text(state, "--title", text);
        settings->title = text;
        return 0;
    case PANEL:
        settings->panel =
            fig_read_count(state, "--panel", text, 1, FIG_PARTS_MOST);
        return 0;
    case LABELS:
        read_labels(settings, text);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static error_t understand_film(int key, char *text, struct argp_state *state)
{
    static const char *const films[] = {".mp4", ".gif", ".webp", ".png", NULL};
    fig_settings *settings = state->input;
    switch (key) {
    case ANIMATE:
        settings->film = read_path(state, "--animate", text, films,
                                   ".mp4, .gif, .webp or .png");
        return 0;
    case FRAMES:
        settings->frames =
            fig_read_count(state, "--frames", text, 1, FRAMES_MOST);
        return 0;
    case FPS:
        settings->fps = fig_read_count(state, "--fps", text, 1, FPS_MOST);
        return 0;
    case TURNTABLE:
        settings->turntable = true;
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static error_t understand(int key, char *text, struct argp_state *state)
{
    switch (key) {
    case ARGP_KEY_INIT:
        set_usual(state->input);
        return 0;
    case ARGP_KEY_END:
        check(state);
        return 0;
    default:
        return understand_picture(key, text, state) == 0
                   ? 0
                   : understand_film(key, text, state);
    }
}

// Films of given frames ------------------------------------------------------

/// A file of a film or of a picture, or a folder.
static void read_output(struct argp_state *state, const char *text)
{
    static const char *const pictures[] = {".png", ".pdf", ".svg"};
    static const char *const endings[] = {".webp", ".gif", ".mp4", ".png",
                                          ".pdf",  ".svg", NULL};
    fig_settings *settings = state->input;
    settings->picture = settings->film = NULL;
    for (int i = 0; i < 3; i++)
        if (fig_path_ends(text, pictures[i]))
            settings->picture = text;
    if (!settings->picture)
        settings->film =
            fig_path_is_folder(text)
                ? text
                : read_path(state, "--output", text, endings,
                            ".webp, .gif or .mp4, in .png, .pdf or .svg, or "
                            "in / for a folder");
}

static error_t understand_given(int key, char *text, struct argp_state *state)
{
    const fig_settings *settings = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        set_usual(state->input);
        return 0;
    case 'o':
        read_output(state, text);
        return 0;
    case ARGP_KEY_END:
        if (!settings->picture && !settings->film)
            argp_error(state, "--output FILE is required: the film or the "
                              "picture");
        return 0;
    default:
        return understand_picture(key, text, state) == 0
                   ? 0
                   : understand_film(key, text, state);
    }
}

// The parsers ----------------------------------------------------------------

static const struct argp parser = {.options = options, .parser = understand};

const struct argp_child fig_settings_options[] = {
    {&parser, 0, "Pictures:", 0},
    {0},
};

static const struct argp film_parser = {.options = film_options,
                                        .parser = understand_given};

const struct argp_child fig_settings_film_options[] = {
    {&film_parser, 0, "Films and pictures:", 0},
    {0},
};
