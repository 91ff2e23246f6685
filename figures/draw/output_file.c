#define _GNU_SOURCE // mkstemps
#include "draw/output_file.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

// Signals ----------------------------------------------------------------

enum {
    SCRATCHES = 4
}; ///< more than are ever there at a time

static char *volatile scratches[SCRATCHES];
static volatile pid_t writer;

void fig_output_file_writer(pid_t process)
{
    writer = process;
}

static void remove_scratches(int signal_number)
{
    if (writer > 0) {
        kill(writer, SIGKILL);
        waitpid(writer, NULL, 0);
    }
    for (int i = 0; i < SCRATCHES; i++)
        if (scratches[i])
            unlink(scratches[i]);
    signal(signal_number, SIG_DFL);
    raise(signal_number);
}

static void remember(char *from, char *to)
{
    for (int i = 0; i < SCRATCHES; i++)
        if (scratches[i] == from) {
            scratches[i] = to;
            return;
        }
}

static void watch_signals(void)
{
    const int endings[] = {SIGHUP, SIGINT, SIGTERM};
    for (int i = 0; i < 3; i++)
        if (signal(endings[i], remove_scratches) == SIG_IGN)
            signal(endings[i], SIG_IGN);
}

// Files ------------------------------------------------------------------

/// "folder/.tanglefree-XXXXXX.png" for "folder/name.png"; NULL without memory.
static char *scratch_name(const char *path, int *ending_length)
{
    const char *slash = strrchr(path, '/');
    int folder = slash ? (int)(slash - path) + 1 : 0;
    const char *dot = strrchr(path + folder, '.');
    const char *ending = dot ? dot : "";
    *ending_length = (int)strlen(ending);
    char *name;
    return asprintf(&name, "%.*s.tanglefree-XXXXXX%s", folder, path, ending) < 0
               ? NULL
               : name;
}

/// Let others read the file as they read any new one; mkstemps does not.
static void open_to_others(int descriptor)
{
    mode_t mask = umask(0);
    umask(mask);
    fchmod(descriptor, 0666 & ~mask);
}

bool fig_output_file_begin(fig_output_file *file, const char *path)
{
    int ending_length;
    *file = (fig_output_file){path, scratch_name(path, &ending_length)};
    int descriptor =
        file->scratch ? mkstemps(file->scratch, ending_length) : -1;
    if (descriptor < 0) {
        int cause = errno;
        free(file->scratch);
        file->scratch = NULL;
        errno = cause;
        return false;
    }
    open_to_others(descriptor);
    close(descriptor);
    remember(NULL, file->scratch);
    watch_signals();
    return true;
}

bool fig_output_file_keep(fig_output_file *file)
{
    bool kept = rename(file->scratch, file->path) == 0;
    int cause = errno;
    fig_output_file_drop(file);
    errno = cause;
    return kept;
}

void fig_output_file_drop(fig_output_file *file)
{
    if (!file->scratch)
        return;
    unlink(file->scratch);
    remember(file->scratch, NULL);
    free(file->scratch);
    file->scratch = NULL;
}
