#define _GNU_SOURCE
#include "draw/settings.h"

#include "program/number.h"
#include "stage/page.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    SIZE = 's',
    TRANSPARENT = 'x',
    DPI = 256, // from here on: no letter
    ANIMATE,
    FRAMES,
    FPS,
    TURNTABLE
};

enum {
    FRAMES_MOST = 10000,
    FPS_MOST = 120,
    DPI_MOST = 4800
};

static const struct argp_option options[] = {
    {"output", 'o', "FILE", 0,
     "Draw to this file: .png, .pdf (letters and lines stay vectors) or .svg",
     0},
    {"size", SIZE, "WxH", 0, "Pixels of the picture; 1600 wide unless told", 0},
    {"dpi", DPI, "N", 0,
     "Pixels per inch in print; without --size, also how many pixels", 0},
    {"theme", 't', "THEME", 0, "light or dark; light unless told", 0},
    {"transparent", TRANSPARENT, NULL, 0, "No paper behind the drawing", 0},
    {"view", 'v', "AZ,EL", 0,
     "Look from this azimuth and elevation, in degrees", 0},
    {NULL, 0, NULL, 0, "Films:", 0},
    {"animate", ANIMATE, "FILE", 0, "Make a film: .mp4, .gif or .webp", 0},
    {"turntable", TURNTABLE, NULL, 0,
     "Turn the camera once in the film; otherwise time passes", 0},
    {"frames", FRAMES, "N", 0, "Pictures of the film; 90 unless told", 0},
    {"fps", FPS, "N", 0, "Pictures per second; 30 unless told", 0},
    {0},
};

bool tf_path_ends(const char *path, const char *ending)
{
    size_t length = strlen(path), wanted = strlen(ending);
    return length > wanted && strcmp(path + length - wanted, ending) == 0 &&
           path[length - wanted - 1] != '/';
}

/// A name of a file with one of three endings.
static const char *read_path(struct argp_state *state, const char *what,
                             const char *text, const char *const ending[3])
{
    for (int i = 0; i < 3; i++)
        if (tf_path_ends(text, ending[i]))
            return text;
    argp_error(state, "%s '%s' must end in %s, %s or %s", what, text, ending[0],
               ending[1], ending[2]);
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

static int read_count(struct argp_state *state, const char *option,
                      const char *text, int most)
{
    const char *at = text;
    long count = read_digits(&at);
    if (*at != '\0' || count < 1 || count > most)
        argp_error(state, "%s is '%s'; give a number from 1 to %d", option,
                   text, most);
    return (int)count;
}

static bool good_size(long pixels)
{
    return pixels >= TF_PIXELS_LEAST && pixels <= TF_PIXELS_MOST;
}

static void read_size(struct argp_state *state, const char *text)
{
    tf_settings *settings = state->input;
    const char *at = text;
    long x = read_digits(&at), y = -1;
    if (*at == 'x') {
        at++;
        y = read_digits(&at);
    }
    if (*at != '\0' || !good_size(x) || !good_size(y))
        argp_error(state,
                   "the size is '%s'; give width and height as 1600x1200, "
                   "both from %d to %d pixels",
                   text, TF_PIXELS_LEAST, TF_PIXELS_MOST);
    settings->pixels_x = (int)x;
    settings->pixels_y = (int)y;
}

static void read_view(struct argp_state *state, const char *text)
{
    tf_settings *settings = state->input;
    const char *at = text;
    double azimuth = 0, elevation = 0;
    bool good = tf_number_read(&at, &azimuth) && *at++ == ',' &&
                tf_number_read(&at, &elevation) && *at == '\0';
    if (!good || !(fabs(azimuth) <= 360) || !(fabs(elevation) <= 90))
        argp_error(state,
                   "the view is '%s'; give two angles in degrees as 30,20, "
                   "the first from -360 to 360, the second from -90 to 90",
                   text);
    settings->turned = true;
    settings->azimuth = azimuth;
    settings->elevation = elevation;
}

static void read_theme(struct argp_state *state, const char *text)
{
    tf_settings *settings = state->input;
    settings->theme = tf_theme_named(text);
    if (!settings->theme)
        argp_error(state, "no theme is named '%s'; choose light or dark", text);
}

/// See that the options go together.
static void check(struct argp_state *state)
{
    const tf_settings *settings = state->input;
    if (!settings->picture && !settings->film)
        argp_error(state, "nothing to write; name a file by -o FILE.png or "
                          "--animate FILE.mp4");
    if (settings->film && settings->transparent &&
        tf_path_ends(settings->film, ".mp4"))
        argp_error(state, "no .mp4 is transparent; drop --transparent or "
                          "choose .webp or .gif");
    if (!settings->film && settings->turntable)
        argp_error(state, "--turntable is for films; name one by --animate "
                          "FILE.mp4");
}

static void set_usual(tf_settings *settings)
{
    *settings = (tf_settings){
        .theme = &tf_theme_light,
        .frames = 90,
        .fps = 30,
    };
}

static error_t understand(int key, char *text, struct argp_state *state)
{
    static const char *const pictures[] = {".png", ".pdf", ".svg"};
    static const char *const films[] = {".mp4", ".gif", ".webp"};
    tf_settings *settings = state->input;
    switch (key) {
    case ARGP_KEY_INIT:
        set_usual(settings);
        return 0;
    case 'o':
        settings->picture = read_path(state, "the picture", text, pictures);
        return 0;
    case ANIMATE:
        settings->film = read_path(state, "the film", text, films);
        return 0;
    case SIZE:
        read_size(state, text);
        return 0;
    case DPI:
        settings->dpi = read_count(state, "--dpi", text, DPI_MOST);
        return 0;
    case 't':
        read_theme(state, text);
        return 0;
    case TRANSPARENT:
        settings->transparent = true;
        return 0;
    case 'v':
        read_view(state, text);
        return 0;
    case FRAMES:
        settings->frames = read_count(state, "--frames", text, FRAMES_MOST);
        return 0;
    case FPS:
        settings->fps = read_count(state, "--fps", text, FPS_MOST);
        return 0;
    case TURNTABLE:
        settings->turntable = true;
        return 0;
    case ARGP_KEY_END:
        check(state);
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp parser = {.options = options, .parser = understand};

const struct argp_child tf_settings_options[] = {
    {&parser, 0, "Pictures:", 0},
    {0},
};
