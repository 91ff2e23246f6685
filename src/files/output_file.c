//: Include what output files need
#define _GNU_SOURCE // asprintf, flock
#include "files/output_file.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

//: Remove scratch files when a signal ends the program
enum {
    SCRATCHES = 4, // more than are ever there at a time
    NAMES = 16     // of scratch files of a file, which are looked for
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
// A file has the same names of scratch files each time that this user writes
// it, so that those that a killed program has left are found again.  Programs
// that write it at the same time take one each.

/// FNV-1a.
static uint32_t hash(uint32_t from, const void *bytes, size_t count)
{
    const unsigned char *byte = bytes;
    for (size_t i = 0; i < count; i++)
        from = (from ^ byte[i]) * UINT32_C(16777619);
    return from;
}

/// "folder/.tanglefree-89abcdef.png" for "folder/name.png"; NULL without memory.
static char *scratch_name(const char *path, int number)
{
    const char *slash = strrchr(path, '/');
    const char *file = slash ? slash + 1 : path;
    const char *dot = strrchr(file, '.');
    const uid_t user = geteuid();
    uint32_t digits = hash(UINT32_C(2166136261), file, strlen(file));
    digits = hash(digits, &user, sizeof user);
    digits = hash(digits, &number, sizeof number);
    char *name;
    return asprintf(&name, "%.*s.tanglefree-%08x%s", (int)(file - path), path,
                    (unsigned)digits, dot ? dot : "") < 0
               ? NULL
               : name;
}

//: Remove an abandoned scratch file
// A program that lives holds a lock of its scratch file, which the system ends
// with the program, however that ends.

/// Whether a name is that of an open file, which is one as scratch files are.
static bool is_scratch(int descriptor, const char *name)
{
    struct stat opened, named;
    return fstat(descriptor, &opened) == 0 && lstat(name, &named) == 0 &&
           opened.st_dev == named.st_dev && opened.st_ino == named.st_ino &&
           S_ISREG(opened.st_mode) && opened.st_nlink == 1 &&
           opened.st_uid == geteuid();
}

/// Looks at the name once more under the lock, as its owner may just have
/// renamed the file, and another have begun one.
static void remove_abandoned(const char *name)
{
    int flags = O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;
    int descriptor = open(name, flags);
    if (descriptor < 0)
        return;
    if (flock(descriptor, LOCK_EX | LOCK_NB) == 0 &&
        is_scratch(descriptor, name))
        unlink(name);
    close(descriptor);
}

void tf_output_file_clear(const char *path)
{
    char *real = realpath(path, NULL);
    for (int i = 0; i < NAMES; i++) {
        char *name = scratch_name(real ? real : path, i);
        if (name)
            remove_abandoned(name);
        free(name);
    }
    free(real);
}

//: Set the permissions of a scratch file
/// The permissions of the file that it will replace, or of any new one; until
/// then nobody else can read it.
static void set_permissions(int descriptor, const struct stat *before)
{
    mode_t mask = umask(0);
    umask(mask);
    fchmod(descriptor, before ? before->st_mode & 0777 : 0666 & ~mask);
}

//: Lock a scratch file
/// Opens a file that is not there yet, with a descriptor that is none of the
/// standard ones: if one of those is closed, what is printed must not get into
/// the file.
static int open_new(const char *name)
{
    int any = open(name, O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (any < 0)
        return -1;
    int descriptor = fcntl(any, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    int cause = errno;
    close(any);
    errno = cause;
    return descriptor;
}

/// Makes a file that is not there yet, and locks it; where there are no locks,
/// nothing is ever taken for abandoned.  Another program may remove it before
/// it is locked; then errno is EEXIST, too.
static int make_locked(const char *name)
{
    int descriptor = open_new(name);
    struct stat made;
    if (descriptor < 0)
        return -1;
    flock(descriptor, LOCK_EX);
    if (fstat(descriptor, &made) == 0 && made.st_nlink > 0)
        return descriptor;
    close(descriptor);
    errno = EEXIST;
    return -1;
}

//: Make a scratch file
/// The first that no other program has.
static bool make_scratch(tf_output_file *file, const struct stat *before)
{
    tf_output_file_clear(file->path);
    errno = EEXIST;
    for (int i = 0; file->lock < 0 && errno == EEXIST; i++) {
        free(file->scratch);
        file->scratch = scratch_name(file->path, i);
        if (!file->scratch)
            return false;
        file->lock = make_locked(file->scratch);
    }
    if (file->lock < 0)
        return false;
    set_permissions(file->lock, before);
    remember(NULL, file->scratch);
    watch_signals();
    return true;
}

//: Begin an output file
static void forget(tf_output_file *file)
{
    int cause = errno;
    if (file->lock >= 0)
        close(file->lock);
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
    *file = (tf_output_file){.lock = -1};
    bool made = make(file, path);
    if (!made)
        forget(file);
    return made;
}

//: Keep or drop an output file
// Once the file has lost the name, another program may take that, and neither
// this one nor a signal may remove it.

bool tf_output_file_keep(tf_output_file *file)
{
    remember(file->scratch, NULL);
    bool kept =
        file->scratch == file->path || rename(file->scratch, file->path) == 0;
    int cause = errno;
    if (!kept)
        unlink(file->scratch);
    errno = cause;
    forget(file);
    return kept;
}

void tf_output_file_drop(tf_output_file *file)
{
    if (!file->scratch)
        return;
    remember(file->scratch, NULL);
    if (file->scratch != file->path)
        unlink(file->scratch);
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
