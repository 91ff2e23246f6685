"""Answers that cheat, or do harm: none passes, and the grading goes on.

Each is handed in by a student of its own, and all are graded in one run, with
the answers of an honest student: run by make check-exercises.  What they would
do if nothing hindered them is limited to the test's own folder and processes.
"""
import csv
import os
import subprocess
import unittest

from toy import ONE, Toy

HEAD = """\
#define _GNU_SOURCE
#include <fcntl.h>
#include <setjmp.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>
"""


def function(body, before=""):
    return f"{HEAD}{before}\nint answer(void)\n{{\n{body}\n    return 0;\n}}\n"


# What the judge reports of a pass, to whoever may listen.
SHOUT = """
    for (int file = 0; file < 1024; file++)
        dprintf(file, "passed\\nend: passed\\n");
"""

FORGERIES = {
    "claims to have passed": function(SHOUT + "_exit(0);"),
    "claims it before main": function("", f"""
__attribute__((constructor)) static void first(void)
{{{SHOUT}
    _exit(0);
}}"""),
    "claims it before that": function("", f"""
static void first(void) {{{SHOUT} _exit(0); }}
__attribute__((section(".preinit_array"), used))
static void (*start)(void) = first;"""),
    "claims it at the end": function("atexit(first);", f"""
static void first(void) {{{SHOUT} _exit(0); }}"""),
    "writes to the judge": function("""
    char path[64];
    for (int file = 0; file < 16; file++) {
        snprintf(path, sizeof path, "/proc/%d/fd/%d", (int)getppid(), file);
        dprintf(open(path, O_WRONLY), "end: passed\\n");
    }
    _exit(0);"""),
    "alters the judge": function("""
    char one = 1;
    struct iovec from = {&one, 1}, to = {(void *)answer, 1};
    process_vm_writev(getppid(), &from, 1, &to, 1, 0);
    ptrace(PTRACE_ATTACH, getppid(), NULL, NULL);
    pause();"""),
    "hands in results": function("""
    for (int file = 0; file < 1024; file++) {
        write(file, "r\\0\\0\\0\\0r\\0\\0\\0\\0", 10);
        write(file, "end: passed\\n", 12);
    }"""),
    "includes the checks": '#include "{root}/exercises/01-1-one.check.c"\n'
    + function(""),
    "includes the solution": "#define TF_SOLUTION\n"
    '#include "{root}/exercises/01-1-one.c"\n',
    "calls the harness": function("judge_end();", """
void judge_end(void);
void check_take(void *, size_t);
__attribute__((constructor)) static void take(void) { check_take(0, 0); }"""),
    "is a main": function("") + "int main(void) { return 0; }\n",
    "has its own library": function("", """
int memcmp(const void *a, const void *b, size_t n) { return a == b && n; }
int strcmp(const char *a, const char *b) { return a == b; }
int printf(const char *text, ...) { return text == 0; }
size_t fwrite(const void *a, size_t b, size_t c, FILE *d)
{
    return a && b && d ? c : 0;
}"""),
    "jumps back": function("""
    static jmp_buf place;
    static int calls;
    if (calls++ == 0 && setjmp(place) == 0)
        return 0;
    longjmp(place, 1);"""),
    "kills": function("""
    kill(getppid(), SIGKILL);
    kill({victim}, SIGKILL);"""),
    "is a bomb": function("for (int i = 0; i < 6; i++) fork();"),
    "takes all memory": function("""
    for (int i = 0; i < 64; i++) {
        char *more = malloc(1 << 26);
        if (more)
            memset(more, 1, 1 << 26);
    }"""),
    "computes for ever": function("""
    signal(SIGXCPU, SIG_IGN);
    setrlimit(RLIMIT_CPU, &(struct rlimit){RLIM_INFINITY, RLIM_INFINITY});
    for (volatile unsigned i = 0;; i++) { }"""),
    "sleeps for ever": function("for (;;) pause();"),
    "drips": function("""
    for (;;) {
        write(3, "r", 1);
        usleep(30000);
    }"""),
    "floods": function("""
    setrlimit(RLIMIT_FSIZE, &(struct rlimit){RLIM_INFINITY, RLIM_INFINITY});
    for (int i = 0; i < 10000000; i++)
        puts("end: passed");"""),
    "closes everything": function("""
    for (int file = 0; file < 1024; file++)
        close(file);
    for (;;) pause();"""),
    "deletes": function("""
    unlink("{root}/treasure");
    unlink("{root}/exercises/01-1-one.check.c");
    rename("{root}/treasure", "{root}/stolen");
    chmod("{root}/treasure", 0);
    execl("/bin/rm", "rm", "-rf", "{root}", (char *)0);"""),
    "alters": function("""
    truncate("{root}/treasure", 0);
    dprintf(open("{root}/treasure", O_WRONLY | O_TRUNC), "mine");
    dprintf(open("{root}/booty", O_WRONLY | O_CREAT, 0666), "mine");
    dprintf(socket(AF_INET, SOCK_STREAM, 0), "mine");
    symlink("{root}/treasure", "{root}/booty");
    mkdir("{root}/booty", 0777);"""),
}
WORDS = {"includes the checks": "does not compile",
         "includes the solution": "does not compile",
         "calls the harness": "does not compile",
         "is a main": "does not compile"}


class Forgeries(Toy):
    def setUp(self):
        super().setUp()
        (self.root / "treasure").write_text("gold")
        self.victim = subprocess.Popen(["sleep", "1000"])
        self.addCleanup(self.victim.wait)
        self.addCleanup(self.victim.kill)
        for name, text in FORGERIES.items():
            self.hand_in(name, "01-1-one.c",
                         text.replace("{root}", str(self.root))
                         .replace("{victim}", str(self.victim.pid)))
        for slug in "01-1-one", "01-2-two":
            self.hand_in("honest", f"{slug}.c",
                         "int answer(void)\n{\n    return 1;\n}\n")

    def hand_in(self, student, name, text):
        path = self.root / "submissions" / student / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def test_none_passes_and_nothing_is_harmed(self):
        self.run_learn("grade-all", f"--dir={self.root}/submissions")
        with (self.root / "build/grade-all/grades.csv").open() as table:
            rows = {row["student"]: row for row in csv.DictReader(table)}
        self.assertEqual(set(rows), {"honest", *FORGERIES})
        self.assertEqual([rows["honest"][k] for k in ("1.1", "1.2")],
                         ["right", "right"])
        for name in FORGERIES:
            with self.subTest(name):
                self.assertEqual(rows[name]["1.1"], WORDS.get(name, "wrong"))
        self.assertEqual((self.root / "treasure").read_text(), "gold")
        self.assertEqual(os.stat(self.root / "treasure").st_mode & 0o777, 0o644)
        self.assertFalse((self.root / "booty").exists())
        self.assertIsNone(self.victim.poll())
        self.assertTrue((self.exercises / "01-1-one.check.c").exists())


if __name__ == "__main__":
    os.umask(0o022)
    unittest.main(verbosity=0)
