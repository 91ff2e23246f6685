#define _GNU_SOURCE // CAP_*, and all names of system calls
#include "confine.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <stddef.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

enum {
    SECONDS = 5, // of the processor, whatever else the machine does
    PRINTED = 1 << 20
};

#if defined __x86_64__
#define MACHINE AUDIT_ARCH_X86_64
#elif defined __aarch64__
#define MACHINE AUDIT_ARCH_AARCH64
#else
#define MACHINE 0 // unknown: everything would be refused
#endif

// Older machines have some calls that newer ones do without.
#if defined __x86_64__
#define OLDER_CALLS                                                            \
    __NR_open, __NR_stat, __NR_lstat, __NR_access, __NR_readlink, __NR_poll,   \
        __NR_time, __NR_arch_prctl, __NR_pipe, __NR_getrlimit, __NR_pause,
#else
#define OLDER_CALLS
#endif

/// Calls that change nothing outside the process, if the conditions below hold.
static const int allowed[] = {
    OLDER_CALLS __NR_read,
    __NR_write,
    __NR_readv,
    __NR_writev,
    __NR_pread64,
    __NR_close,
    __NR_lseek,
    __NR_openat,
    __NR_fstat,
    __NR_newfstatat,
    __NR_statx,
    __NR_faccessat,
    __NR_readlinkat,
    __NR_getcwd,
    __NR_ioctl,
    __NR_fcntl,
    __NR_pipe2,
    __NR_ppoll,
    __NR_mmap,
    __NR_mprotect,
    __NR_munmap,
    __NR_mremap,
    __NR_madvise,
    __NR_brk,
    __NR_execve,
    __NR_exit,
    __NR_exit_group,
    __NR_kill,
    __NR_tkill,
    __NR_tgkill,
    __NR_rt_sigaction,
    __NR_rt_sigprocmask,
    __NR_rt_sigreturn,
    __NR_sigaltstack,
    __NR_getpid,
    __NR_getppid,
    __NR_gettid,
    __NR_getuid,
    __NR_geteuid,
    __NR_getgid,
    __NR_getegid,
    __NR_uname,
    __NR_personality,
    __NR_prlimit64,
    __NR_sched_yield,
    __NR_sched_getaffinity,
    __NR_getrandom,
    __NR_futex,
    __NR_set_tid_address,
    __NR_set_robust_list,
    __NR_rseq,
    __NR_clock_gettime,
    __NR_clock_getres,
    __NR_clock_nanosleep,
    __NR_nanosleep,
    __NR_gettimeofday,
    __NR_getrusage,
    __NR_restart_syscall,
};

enum {
    ALLOWED = sizeof allowed / sizeof *allowed,
    CONDITIONS = 8
};

/// A call is allowed only if an argument, of which only the bits of a mask
/// count, has a value.
typedef struct condition {
    unsigned call, argument, mask, value;
} condition;

static struct sock_filter load(size_t offset)
{
    return (struct sock_filter)BPF_STMT(BPF_LD | BPF_W | BPF_ABS,
                                        (unsigned)offset);
}

static struct sock_filter result(unsigned action)
{
    return (struct sock_filter)BPF_STMT(BPF_RET | BPF_K, action);
}

/// Go on with the next instruction if the loaded number is `value`; else skip
/// some.
static struct sock_filter unless(unsigned value, unsigned char skipped)
{
    return (struct sock_filter)BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, value, 0,
                                        skipped);
}

static const unsigned refuse = SECCOMP_RET_ERRNO | EPERM;

/// Refuse the loaded call where it is that of the condition, which does not
/// hold; the call stays loaded.
static size_t add_condition(struct sock_filter *to, condition given)
{
    const struct sock_filter all[] = {
        unless(given.call, 5),
        load(offsetof(struct seccomp_data, args[given.argument])),
        BPF_STMT(BPF_ALU | BPF_AND | BPF_K, given.mask),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, given.value, 1, 0),
        result(refuse),
        load(offsetof(struct seccomp_data, nr)),
    };
    const size_t count = sizeof all / sizeof *all;
    for (size_t i = 0; i < count; i++)
        to[i] = all[i];
    return count;
}

/// The low halves of arguments are enough: flags, numbers of processes.
static size_t add_conditions(struct sock_filter *to)
{
    const unsigned self = (unsigned)getpid(), all = ~0U;
    const unsigned writing = O_ACCMODE | O_CREAT | O_TRUNC;
    const condition conditions[CONDITIONS] = {
        {__NR_openat, 2, writing, O_RDONLY},
        {__NR_ioctl, 1, all, TCGETS},
        {__NR_fcntl, 1, all, F_GETFL},
        {__NR_kill, 0, all, self},
        {__NR_tgkill, 0, all, self},
        {__NR_tkill, 0, all, self},
        {__NR_prlimit64, 0, all, 0},
#if defined __x86_64__
        {__NR_open, 1, writing, O_RDONLY},
#endif
    };
    size_t count = 0;
    for (int i = 0; i < CONDITIONS && conditions[i].mask; i++)
        count += add_condition(to + count, conditions[i]);
    return count;
}

/// Install the list as a program that the kernel runs before each call.
static bool filter_calls(void)
{
    struct sock_filter program[8 + 6 * CONDITIONS + 2 * ALLOWED];
    size_t count = 0;
    program[count++] = load(offsetof(struct seccomp_data, arch));
    program[count++] = unless(MACHINE, 1);
    program[count++] = (struct sock_filter)BPF_JUMP(BPF_JMP | BPF_JA, 1, 0, 0);
    program[count++] = result(refuse);
    program[count++] = load(offsetof(struct seccomp_data, nr));
    count += add_conditions(program + count);
    for (int i = 0; i < ALLOWED; i++) {
        program[count++] = unless((unsigned)allowed[i], 1);
        program[count++] = result(SECCOMP_RET_ALLOW);
    }
    program[count++] = result(refuse);
    struct sock_fprog all = {(unsigned short)count, program};
    return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
           prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &all) == 0;
}

bool confine(void)
{
    // Without a bounding set root is a user like others after it executes.
    for (int right = 0; prctl(PR_CAPBSET_DROP, right, 0, 0, 0) == 0;)
        right++;
    setrlimit(RLIMIT_CPU, &(struct rlimit){SECONDS, SECONDS + 1});
    setrlimit(RLIMIT_FSIZE, &(struct rlimit){PRINTED, PRINTED});
    setrlimit(RLIMIT_CORE, &(struct rlimit){0, 0});
    return MACHINE != 0 && filter_calls();
}
