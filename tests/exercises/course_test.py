"""Tests of exercises/course.py: 40 submissions in one run, and what is handed
out.  Run by make check-exercises."""
import csv
import itertools
import os
import unittest
import zipfile
from pathlib import Path

from toy import Toy

ANSWERS = {"right": "return 1;", "wrong": "return 3;",
           "does not compile": "return 1", "missing": None}
NAMES = ["01-1-one.c", "01-2-two.c"]


def text_of(word):
    return f"int answer(void)\n{{\n    {ANSWERS[word]}\n}}\n"


class Course(Toy):
    def setUp(self):
        super().setUp()
        self.folder = self.root / "submissions"
        self.folder.mkdir()
        self.weights = self.root / "weights"
        self.weights.write_text("# what counts\n1 2\n1.2 3.5 # more\n")

    def hand_in(self, student, files):
        """As a zip file if the student's name ends in .zip, or as a folder."""
        if student.endswith(".zip"):
            with zipfile.ZipFile(self.folder / student, "w") as archive:
                for path, text in files.items():
                    archive.writestr(path, text)
        else:
            (self.folder / student).mkdir()
            for path, text in files.items():
                (self.folder / student / path).parent.mkdir(parents=True,
                                                            exist_ok=True)
                (self.folder / student / path).write_text(text)

    def hand_in_all_cases(self):
        """Expected words by student: each pair in two of four wrappings."""
        wraps = itertools.cycle(["", "work/"])
        for way, (i, words) in itertools.product(
                (0, 1), enumerate(itertools.product(ANSWERS, repeat=2))):
            student = f"s{way}{i:02}" + (".zip" if (i + way) % 2 else "")
            wrap = next(wraps) if i % 4 else "a/b/"
            self.hand_in(student, {wrap + name: text_of(word)
                                   for name, word in zip(NAMES, words)
                                   if ANSWERS[word]})
            yield student.removesuffix(".zip"), list(words)

    def hand_in_odd_ones(self):
        """Expected words and a part of the notes."""
        right, wrong = text_of("right"), text_of("wrong")
        one, two = NAMES
        self.hand_in("Zoë Ü", {one: right, "notes.txt": "hello"})
        yield "Zoë Ü", ["right", "missing"], ""
        self.hand_in("twice", {one: right, "old/" + one: wrong})
        yield "twice", ["right", "missing"], "is a second one"
        self.hand_in("mac.zip", {"__MACOSX/" + one: "x", "w/" + one: right})
        yield "mac", ["right", "missing"], ""
        self.hand_in("large.zip", {one: right + " " * 2000000, two: right})
        yield "large", ["missing", "right"], "larger than a megabyte"
        self.hand_in("climbs.zip", {"../../" + one: right, "/" + two: right})
        yield "climbs", ["right", "right"], ""
        self.hand_in("empty", {})
        yield "empty", ["missing", "missing"], ""
        (self.folder / "broken.zip").write_text("not a zip")
        yield "broken", ["missing", "missing"], "cannot be read"
        self.hand_in("links", {two: right})
        (self.folder / "links" / one).symlink_to(self.exercises / one)
        yield "links", ["missing", "right"], ""

    def test_grades_forty_submissions_in_one_run(self):
        expected = dict(self.hand_in_all_cases())
        notes = {student: "" for student in expected}
        for student, words, note in self.hand_in_odd_ones():
            expected[student], notes[student] = words, note
        self.assertEqual(len(expected), 40)
        self.run_learn("grade-all", f"--dir={self.folder}",
                       f"--weights={self.weights}")
        with (self.root / "build/grade-all/grades.csv").open() as table:
            rows = {row["student"]: row for row in csv.DictReader(table)}
        self.assertEqual({student: [row["1.1"], row["1.2"]]
                          for student, row in rows.items()}, expected)
        for student, row in rows.items():
            points = sum(weight for word, weight in
                         zip(expected[student], (2, 3.5)) if word == "right")
            self.assertEqual((float(row["points"]), float(row["of"])),
                             (points, 5.5))
            self.assertIn(notes[student], row["notes"])
        report = (self.root / "build/grade-all/s001.txt").read_text()
        self.assertIn("1.1 One.  right", report)
        self.assertIn("1.2 One.  wrong\n  input     nothing", report)
        self.assertNotIn(str(self.root / "build"), report)

    def test_grades_chosen_exercises_with_weights(self):
        self.hand_in("zip", {"deep/down/01-2-two.c": text_of("right")})
        told = self.run_learn("grade", f"--dir={self.folder}/zip",
                              "--number=1.2", f"--weights={self.weights}")
        self.assertIn("1.2   3.5 of 3.5", told)
        self.assertNotIn("1.1", told)

    def test_names_what_is_wrong(self):
        for text, fault in (("1.2", ":2: should be"), ("1 x", ":2: should be"),
                            ("1.2 -1", ":2: should be"),
                            ("9 1", "no exercise or chapter 9")):
            self.weights.write_text("\n" + text)
            self.assertIn(fault, self.run_learn(
                "grade-all", f"--dir={self.folder}",
                f"--weights={self.weights}", status=1))
        self.assertIn("Which folder?", self.run_learn("grade-all", status=1))

    def test_hands_out_no_solutions(self):
        self.run_learn("handout", "--number=1.2")
        with zipfile.ZipFile(self.root / "build/handout.zip") as archive:
            names = [Path(name) for name in archive.namelist()]
            texts = [archive.read(name) for name in archive.namelist()
                     if name.endswith("-two.c")]
            readme = archive.read("tanglefree-exercises/README.md")
        self.assertEqual([name.name for name in names if "01-" in name.name],
                         ["01-2-two.c", "01-2-two.check.c"])
        self.assertEqual({name.parts[0] for name in names},
                         {"tanglefree-exercises"})
        self.assertEqual(len(texts), 1)
        self.assertIn(b"Hint 2", texts[0])
        self.assertNotIn(b"TF_", texts[0])
        self.assertNotIn(b"return 1", texts[0])
        self.assertIn(b"make learn", readme)
        self.assertNotIn(b"make solution", readme)

    def test_makes_an_autograder(self):
        self.run_learn("gradescope", f"--weights={self.weights}")
        with zipfile.ZipFile(self.root / "build/gradescope.zip") as archive:
            for name in "setup.sh", "run_autograder":
                mode = archive.getinfo(name).external_attr >> 16
                self.assertEqual(mode & 0o777, 0o755)
                self.assertTrue(archive.read(name).startswith(b"#!/bin/sh\n"))
            self.assertIn(b"N='1.1 1.2'", archive.read("run_autograder"))
            self.assertEqual(archive.read("weights"), b"1.1 2.0\n1.2 3.5\n")


if __name__ == "__main__":
    os.umask(0o022)
    unittest.main(verbosity=0)
