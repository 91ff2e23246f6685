"""The exercises, as they are written.

An exercise is two files: NN-k-slug.c holds the task, the hints and, as variants
distinguished by #if, a stub, the solution and typical mistakes; NN-k-slug.check.c
checks any of them.  A student's file is the stub, cut out once into WORK; only
the student writes to it from then on.
"""
import os
import re
import subprocess
import sys
from pathlib import Path

EXERCISES = Path(os.environ.get("EXERCISES", "exercises"))
WORK = Path(os.environ.get("WORK", "work"))
BUILD = Path(os.environ.get("BUILD", "build"))
CHAPTERS = [line.split() for line in Path("book/chapters").open()
            if line[0].islower()]

# A declaration of a function, from the start of a line.
PROTOTYPE = re.compile(r"^(?!static|typedef)\w[\w* ]*?\b(\w+)\([^;{]*\);", re.M)


class Exercise:
    def __init__(self, path):
        self.path = path
        self.slug = path.stem
        chapter, count = re.match(r"(\d\d)-(\d+)-", path.stem).groups()
        self.order = int(chapter), int(count)
        self.number = f"{self.order[0]}.{self.order[1]}"
        self.checks = path.with_suffix(".check.c")
        self.mine = WORK / path.name

        # The opening comment: a title, the task, the section, the hints.
        lines = path.read_text().partition(" */\n")[0].splitlines()
        text = "\n".join(re.sub(r"^(/\*| \*) ?", "", line) for line in lines)
        self.title = (re.match(r"Exercise [\d.]+\.  (.*[.?])\n", text)
                      or ["", ""])[1]
        self.section = (re.search(r"^Section: (.*)\.$", text, re.M)
                        or ["", ""])[1]
        task, *hints = re.split(r"^Hint \d+: ", text, flags=re.M)
        self.task = re.sub(r"^Section: .*", "", task.partition("\n\n")[2],
                           flags=re.M).strip()
        self.hints = [" ".join(hint.split()) for hint in hints]

    @property
    def chapter(self):
        """The file of the chapter's text."""
        return Path("book", CHAPTERS[self.order[0] - 1][0] + ".md")

    def place(self):
        """The section's file and line, where the text is at hand."""
        if self.chapter.exists():
            for number, line in enumerate(self.chapter.open(), 1):
                if re.fullmatch(rf"#+ {re.escape(self.section)}\s*", line):
                    return f"{self.chapter}:{number}"
        return None

    def variants(self):
        """The names of the variants, but for the stub."""
        return sorted(set(re.findall(r"\bdefined (TF_\w+)",
                                     self.path.read_text())))

    def variant(self, chosen):
        """The source of one variant; None: of the stub."""
        choices = ["-D" + name if name == chosen else "-U" + name
                   for name in self.variants()]
        if not choices:  # of a handout
            return self.path.read_text()
        run = subprocess.run(["unifdef", *choices, self.path], text=True,
                             capture_output=True)
        if run.returncode > 1:
            sys.exit(f"unifdef {self.path}: {run.stderr}")
        return run.stdout

    def stub(self):
        """The file that a student starts from: without the hints."""
        return re.sub(r"( \*\n)? \* Hint 1: .*?(?= \*/\n)", "",
                      self.variant(None), count=1, flags=re.S)

    def prototypes(self):
        """What the checks call: a number of a line, a declaration, a name."""
        text = self.checks.read_text()
        head = text[:text.index("\nTEST(")]
        for found in PROTOTYPE.finditer(head):
            yield text.count("\n", 0, found.start()) + 1, found[0], found[1]

    def wanted(self):
        """The names of the functions that the student writes."""
        text = self.checks.read_text()
        return [name for _, _, name in self.prototypes()
                if not re.search(rf"^[\w* ]*\b{name}\([^;{{]*\)\n{{", text,
                                 re.M)]

    def provided(self):
        """The names of the functions of the checks that students call."""
        return sorted({name for _, _, name in self.prototypes()}
                      - set(self.wanted()))


def all_exercises():
    paths = EXERCISES.glob("[0-9][0-9]-*-*.c")
    return sorted((Exercise(path) for path in paths
                   if not path.name.endswith(".check.c")),
                  key=lambda exercise: exercise.order)


def chosen_exercises(exercises, numbers):
    """Those of the numbers "1.2 3", of exercises or whole chapters; or all."""
    if not numbers:
        return exercises
    chosen = []
    for number in numbers.split():
        of = [e for e in exercises if number in (e.number, str(e.order[0]))]
        if not of:
            sys.exit(f"There is no exercise or chapter {number}; `make list` "
                     "lists them.")
        chosen += of
    return list(dict.fromkeys(chosen))
