#define _GNU_SOURCE // environ, pipe2
#include "draw/encoder.h"

#include "draw/settings.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

// Arguments --------------------------------------------------------------

enum {
    ARGUMENTS = 40,
    WORDS = 8
};

/// How each kind of film is encoded.  .mp4 wants even sides, and a .gif its own
/// colours for each picture.  In a .webp, blocks that change slowly stay as
/// they were for many pictures, the more of them the less the quality.
static const struct {
    const char *ending;
    const char *words[WORDS];
} kinds[] = {
    {".mp4",
     {"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2,format=yuv420p", "-c:v", "libx264",
      "-crf", "18", "-movflags", "+faststart"}},
    {".gif",
     {"-vf",
      "split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1",
      "-loop", "0"}},
    {".webp", {"-c:v", "libwebp_anim", "-quality", "95", "-loop", "0"}},
};

/// The arguments, NULL at the end; `rate` and `path` are borrowed.
static void list_arguments(const char *arguments[ARGUMENTS], const char *rate,
                           const char *path)
{
    const char *const before[] = {
        "ffmpeg",  "-hide_banner", "-nostdin", "-loglevel",  "error",
        "-y",      "-xerror",      "-f",       "image2pipe", "-c:v",
        "png",     "-framerate",   rate,       "-i",         "pipe:0",
        "-fflags", "+bitexact",    "-flags:v", "+bitexact",  "-map_metadata",
        "-1"};
    int count = 0;
    for (size_t i = 0; i < sizeof before / sizeof *before; i++)
        arguments[count++] = before[i];
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        for (int j = 0; fig_path_ends(path, kinds[i].ending) && j < WORDS; j++)
            if (kinds[i].words[j])
                arguments[count++] = kinds[i].words[j];
    arguments[count++] = path;
    arguments[count] = NULL;
}

// The process ------------------------------------------------------------

/// Start ffmpeg with `input` as its standard input.  An errno, or 0.
static int start(pid_t *process, int input, const char *rate, const char *path)
{
    const char *arguments[ARGUMENTS];
    list_arguments(arguments, rate, path);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
    int error = posix_spawnp(process, "ffmpeg", &actions, NULL,
                             (char *const *)arguments, environ);
    posix_spawn_file_actions_destroy(&actions);
    return error;
}

bool fig_encoder_begin(fig_encoder *encoder, const char *path, int fps)
{
    char rate[16];
    snprintf(rate, sizeof rate, "%d", fps);
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
        return false;
    int error = start(&encoder->process, ends[0], rate, path);
    close(ends[0]);
    encoder->pipe = error == 0 ? fdopen(ends[1], "wb") : NULL;
    if (!encoder->pipe) {
        close(ends[1]);
        errno = error;
        return false;
    }
    signal(SIGPIPE, SIG_IGN);
    return true;
}

bool fig_encoder_add(fig_encoder *encoder, const char *png)
{
    FILE *file = fopen(png, "rb");
    if (!file)
        return false;
    char bytes[65536];
    size_t count;
    while ((count = fread(bytes, 1, sizeof bytes, file)) > 0)
        if (fwrite(bytes, 1, count, encoder->pipe) < count)
            break;
    int cause = errno;
    bool read = count == 0 && !ferror(file);
    fclose(file);
    errno = cause;
    return read && fflush(encoder->pipe) == 0;
}

bool fig_encoder_end(fig_encoder *encoder)
{
    bool piped = fclose(encoder->pipe) == 0;
    int status = 0;
    while (waitpid(encoder->process, &status, 0) < 0)
        if (errno != EINTR)
            return false;
    return piped && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}
