"""Tests of exercises/learn.py, on toy exercises: run by make check-exercises."""
import json
import subprocess
import threading
import unittest

from toy import ONE, Toy


class Learn(Toy):
    def answer(self, body, status=1):
        self.mine.parent.mkdir(exist_ok=True)
        self.mine.write_text("#include <stdio.h>\n#include <stdlib.h>\n"
                             "#include <unistd.h>\n"
                             "int answer(void)\n{\n" + body + "\n}\n")
        return self.run_learn("learn", status=status)

    def test_starts_with_the_stub_without_hints(self):
        self.assertIn("  got       0\n", self.run_learn("learn", status=1))
        text = self.mine.read_text()
        self.assertIn(" * Section: Numbers.\n */\n", text)
        self.assertNotIn("Hint", text)
        self.assertNotIn("#", text)

    def test_shows_the_failure(self):
        self.assertIn("  input     nothing\n            at all\n"
                      "  expected  1\n  got       3\n  where     ",
                      self.answer("return 3;"))

    def test_names_a_wrong_signature(self):
        self.mine.parent.mkdir()
        self.mine.write_text("float answer(void)\n{\n    return 1;\n}\n")
        told = self.run_learn("learn", status=1)
        self.assertIn("01-1-one.check.c:2:5: error: conflicting types for", told)

    def test_takes_several_exercises(self):
        told = self.run_learn("learn", "--number=1.1 1.2", status=1)
        self.assertIn("Exercise 1.1", told)
        self.assertIn("Exercise 1.2", told)
        self.assertIn("`make hint N=1.1` gives", told)
        self.answer("return 1;", status=0)
        self.run_learn("learn", "--number=1.2 1.1", status=1)

    def test_draws_the_failing_input(self):
        self.assertNotIn("picture", self.run_learn("learn", status=1))
        program = self.root / "build/tanglefree-draw"
        program.write_text("#!/bin/sh\n[ \"$4\" = point-edge ] && "
                           "cp \"${2%:0}\" \"$6\"\n")
        program.chmod(0o755)
        drawn = self.root / "build/learn/01-1-one.png"
        self.assertIn(f"  picture   {drawn}\n",
                      self.run_learn("learn", status=1))
        self.assertEqual(drawn.read_text().strip(),
                         "\n".join(6 * ["0x0p+0,0x0p+0"]))

    def test_watches_the_file(self):
        run = subprocess.Popen(
            self.learn_command("learn", "--watch=1"), text=True,
            env=self.environment(), stdout=subprocess.PIPE)
        watchdog = threading.Timer(300, run.kill)
        watchdog.start()
        self.addCleanup(watchdog.cancel)
        lines = iter(run.stdout.readline, "")
        self.assertTrue(any("Waiting for you" in line for line in lines))
        self.mine.write_text("int answer(void)\n{\n    return 2;\n}\n")
        self.assertTrue(any("got       2" in line for line in lines))
        self.assertTrue(any("Waiting for you" in line for line in lines))
        self.mine.write_text("int answer(void)\n{\n    return 1;\n}\n")
        self.assertIn("Solved", run.communicate()[0])
        self.assertEqual(run.returncode, 0)

    def test_goes_on_after_success_when_asked(self):
        told = self.answer("return 1;", status=0)
        self.assertIn("Solved", told)
        self.assertIn("Next is exercise 1.2", told)
        self.assertFalse((self.root / "work/01-2-two.c").exists())
        self.assertIn("Exercise 1.2", self.run_learn("learn", status=1))
        self.assertIn("solved", self.run_learn("list"))

    def test_goes_on_from_what_was_chosen(self):
        self.add_exercise("01-3-three")
        self.mine.parent.mkdir()
        for slug in "01-2-two", "01-3-three":
            (self.root / "work" / f"{slug}.c").write_text(
                "int answer(void)\n{\n    return 1;\n}\n")
        told = self.run_learn("learn", "--number=1.2")
        self.assertIn("Next is exercise 1.3", told)
        self.assertIn("`make learn N=1.3` starts it", told)
        told = self.run_learn("learn", "--number=1.3")
        self.assertIn("Next is exercise 1.1", told)
        self.assertIn("`make learn` starts it", told)

    def test_explains_what_went_wrong(self):
        for body, explanation in (
                ("return 1", "error: expected"),
                ("for (;;) {}", "an endless loop"),
                ("int *p = 0; return *p;", "null pointer"),
                ("int two(void); return two();", "there is no function two"),
                ("return 1 / answer();", "an endless recursion"),
                ("int a[2] = {0}; int volatile i = 2; return a[i];",
                 "index 2 out of bounds"),
                ("__builtin_trap();", "a crash"),
                ("_Exit(0);", "does your code call exit"),
                ("sleep(100); return 1;", "in which it did not compute"),
                ("for (;;) puts(\"again\");", "a megabyte printed")):
            with self.subTest(body):
                self.assertIn(explanation, self.answer(body))

    def test_shows_what_is_printed_and_warnings(self):
        told = self.answer("int unused = 1; puts(\"hello\"); return 0;")
        self.assertIn("  hello\n", told)
        self.assertIn("unused variable", told)

    def test_never_overwrites(self):
        self.answer("return 3;")
        before = self.mine.read_text()
        self.run_learn("learn", status=1)
        self.assertEqual(self.mine.read_text(), before)
        for i in (1, 2):
            self.run_learn("reset", "--number=1.1")
            kept = self.mine.with_suffix(f".{i}.c").read_text()
            self.assertEqual(kept, before)
            self.assertFalse(self.mine.exists())
            self.mine.write_text(before)

    def test_gives_one_more_hint_each_time(self):
        self.assertNotIn("Hint 2", self.run_learn("hint"))
        self.assertIn("Hint 2: Not two.", self.run_learn("hint"))
        self.assertIn("the last hint", self.run_learn("hint"))

    def test_asks_before_it_shows_the_solution(self):
        self.assertNotIn("return 1", self.run_learn("solution",
                                                    "--number=1.1"))
        sure = self.run_learn("solution", "--number=1.1", "--sure=1")
        self.assertIn("return 1;", sure)
        self.assertNotIn("#", sure)
        self.answer("return 1;", status=0)
        self.assertIn("return 1;", self.run_learn("solution",
                                                  "--number=1.1"))

    def test_names_what_there_is_not(self):
        self.assertIn("There is no exercise or chapter 7.7",
                      self.run_learn("learn", "--number=7.7", status=1))
        self.assertIn("Which exercise", self.run_learn("reset", status=1))

    def test_grades_as_gradescope_documents(self):
        self.answer("return 1;", status=0)
        self.run_learn("grade", f"--dir={self.mine.parent}")
        results = json.loads((self.root / "build/grade/results.json")
                             .read_text())
        self.assertLessEqual(set(results), {
            "score", "execution_time", "output", "output_format",
            "test_output_format", "test_name_format", "visibility",
            "stdout_visibility", "extra_data", "tests", "leaderboard"})
        self.assertEqual(results["score"], 1)
        for test in results["tests"]:
            self.assertLessEqual(set(test), {
                "score", "max_score", "status", "name", "name_format",
                "number", "output", "output_format", "tags", "visibility",
                "extra_data"})
            self.assertIsInstance(test["output"], str)
            self.assertIn(test["output_format"],
                          ("text", "html", "simple_format", "md", "ansi"))
            self.assertIn(test["visibility"], (
                "hidden", "after_due_date", "after_published", "visible"))
        self.assertEqual([(test["number"], test["score"], test["max_score"],
                           test["status"]) for test in results["tests"]],
                         [("1.1", 1, 1, "passed"), ("1.2", 0, 1, "failed")])

    def test_check_finds_bad_exercises(self):
        path = self.exercises / "01-1-one.c"
        for old, new, fault in (
                ("Hint 2", "Tip 2", "at least two hints"),
                ("Section", "Chapter", "names no section"),
                ("return -1", "return 1", "TF_WRONG_2: passes"),
                ("return 1", "return 5", "TF_SOLUTION: fails"),
                ("return 0", "return 1", "the stub: passes"),
                ("return 0", "return !", "the stub: It does not compile"),
                ("TF_WRONG_2", "TF_WRONG_3", "needs TF_SOLUTION"),
                ("int answer", '#include "query/edge_edge.h"\nint answer',
                 "query/edge_edge.h is of a later chapter")):
            with self.subTest(fault):
                path.write_text(ONE.replace(old, new))
                self.assertIn(fault, self.run_learn("check", status=1))
        path.write_text(ONE)
        path.rename(self.exercises / "01-3-one.c")
        told = self.run_learn("check", status=1)
        self.assertIn("does not follow", told)
        self.assertIn("checks no exercise", told)


if __name__ == "__main__":
    unittest.main(verbosity=0)
