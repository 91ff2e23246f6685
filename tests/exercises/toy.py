"""Two toy exercises, and a student's folder, for the tests of the exercises."""
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ONE = """\
/* Exercise 1.1.  One.
 *
 * Return one.
 *
 * Section: Numbers.
 *
 * Hint 1: Not zero.
 * Hint 2: Not
 *     two.
 */
int answer(void)
{
#if defined TF_SOLUTION
    return 1;
#elif defined TF_WRONG_1 // one too many
    return 2;
#elif defined TF_WRONG_2
    return -1;
#else
    // Your turn.
    return 0;
#endif
}
"""
CHECK = """\
#include "check.h"
int answer(void);
TEST(is_one)
{
    static const tf_worldline rest[3];
    check_input("nothing\\nat all");
    check_picture(2, 1, rest, 2, rest + 1);
    int got;
    check_value(got, answer());
    check_that(got == 1, "1", "%d", got);
}
void run_tests(void)
{
    check_run(1, is_one);
}
"""


class Toy(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.root = Path(temporary.name)
        self.exercises = self.root / "exercises"
        self.exercises.mkdir()
        self.add_exercise("01-1-one")
        self.add_exercise("01-2-two")
        self.mine = self.root / "work/01-1-one.c"

    def add_exercise(self, slug):
        (self.exercises / f"{slug}.c").write_text(
            ONE.replace("1.1", "1." + slug[3]))
        (self.exercises / f"{slug}.check.c").write_text(CHECK)

    def environment(self):
        return dict(
            os.environ, EXERCISES=str(self.exercises),
            WORK=str(self.root / "work"), BUILD=str(self.root / "build"),
            COMPILE=os.environ["COMPILE"] + " -iquote exercises")

    def learn_command(self, *arguments):
        return [sys.executable, "exercises/learn.py", *arguments]

    def run_learn(self, *arguments, status=0):
        run = subprocess.run(self.learn_command(*arguments), text=True,
                             capture_output=True, env=self.environment())
        self.assertEqual(run.returncode, status, run.stdout + run.stderr)
        return run.stdout + run.stderr
