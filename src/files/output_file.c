//: Include what output files need
#define _GNU_SOURCE // asprintf, mkstemps
#include "files/output_file.h"

#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

//: Remove scratch files when a signal ends the program
enum {
    SCRATCHES = 4 // more than are ever there at a time
};

static char *volatile scratches[SCRATCHES];
static volatile pid_t writer;

void tf_output_file_writer(pid_t process)
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

/// A file that gets larger than it may is an error of the write, and no end of
/// the program.
static void watch_signals(void)
{
    static const int endings[] = {SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM};
    for (size_t i = 0; i < sizeof endings / sizeof *endings; i++)
        if (signal(endings[i], remove_scratches) == SIG_IGN)
            signal(endings[i], SIG_IGN);
    signal(SIGXFSZ, SIG_IGN);
}

//: Name a scratch file
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

//: Make a scratch file
/// The permissions of the file that it will replace, or of any new one;
/// mkstemps lets nobody else read it.
static void set_permissions(int descriptor, const struct stat *before)
{
    mode_t mask = umask(0);
    umask(mask);
    fchmod(descriptor, before ? before->st_mode & 0777 : 0666 & ~mask);
}

static bool make_scratch(tf_output_file *file, const struct stat *before)
{
    int ending_length;
    file->scratch = scratch_name(file->path, &ending_length);
    int descriptor =
        file->scratch ? mkstemps(file->scratch, ending_length) : -1;
    if (descriptor < 0)
        return false;
    set_permissions(descriptor, before);
    close(descriptor);
    remember(NULL, file->scratch);
    watch_signals();
    return true;
}

//: Begin an output file
static void forget(tf_output_file *file)
{
    int cause = errno;
    if (file->scratch != file->path)
        free(file->scratch);
    free(file->path);
    *file = (tf_output_file){0};
    errno = cause;
}

static bool make(tf_output_file *file, const char *path)
{
    struct stat there;
    bool exists = stat(path, &there) == 0;
    bool ordinary = !exists || S_ISREG(there.st_mode);
    file->path = exists && ordinary ? realpath(path, NULL) : strdup(path);
    if (!file->path)
        return false;
    if (ordinary)
        return make_scratch(file, exists ? &there : NULL);
    file->scratch = file->path;
    errno = EISDIR;
    return !S_ISDIR(there.st_mode);
}

bool tf_output_file_begin(tf_output_file *file, const char *path)
{
    *file = (tf_output_file){0};
    bool made = make(file, path);
    if (!made)
        forget(file);
    return made;
}

//: Keep or drop an output file
bool tf_output_file_keep(tf_output_file *file)
{
    bool kept =
        file->scratch == file->path || rename(file->scratch, file->path) == 0;
    int cause = errno;
    tf_output_file_drop(file);
    errno = cause;
    return kept;
}

void tf_output_file_drop(tf_output_file *file)
{
    if (!file->scratch)
        return;
    if (file->scratch != file->path)
        unlink(file->scratch);
    remember(file->scratch, NULL);
    forget(file);
}

//: Write to an output file
FILE *tf_output_file_open(const tf_output_file *file)
{
    return fopen(file->scratch, "wb");
}

/// Only ordinary files can be synchronized with a disk.
static bool synchronize(const tf_output_file *file, FILE *stream)
{
    return file->scratch == file->path || fsync(fileno(stream)) == 0;
}

bool tf_output_file_close(const tf_output_file *file, FILE *stream)
{
    bool written =
        !ferror(stream) && fflush(stream) == 0 && synchronize(file, stream);
    int cause = errno;
    if (fclose(stream) != 0 && written)
        return false;
    errno = cause;
    return written;
}
