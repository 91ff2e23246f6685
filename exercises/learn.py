"""Take a student through the exercises; rules.mk has the targets that run this.

An exercise is two files: NN-k-slug.c holds the task, the hints and, as variants
distinguished by #if, a stub, the solution and typical mistakes; NN-k-slug.check.c
checks any of them.  A student's file is the stub, cut out once into WORK; only
the student writes to it from then on.
"""
import argparse
import json
import os
import re
import shlex
import signal
import subprocess
import sys
import textwrap
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

EXERCISES = Path(os.environ.get("EXERCISES", "exercises"))
WORK = Path(os.environ.get("WORK", "work"))
BUILD = Path(os.environ.get("BUILD", "build"))
COMPILE = shlex.split(os.environ.get("COMPILE", "cc"))
LINK = shlex.split(os.environ.get("LINK", ""))
PATIENCE = 60  # seconds for a program that waits instead of computing
CHAPTERS = [line.split() for line in Path("book/chapters").open()
            if line[0].islower()]


# Exercises --------------------------------------------------------------------

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
        self.task = task.partition("\n\n")[2].strip()
        self.hints = [" ".join(hint.split()) for hint in hints]

    def variants(self):
        """The names of the variants, but for the stub."""
        return sorted(set(re.findall(r"\bdefined (TF_\w+)",
                                     self.path.read_text())))

    def variant(self, chosen):
        """The source of one variant; None: of the stub."""
        choices = ["-D" + name if name == chosen else "-U" + name
                   for name in self.variants()]
        run = subprocess.run(["unifdef", *choices, self.path], text=True,
                             capture_output=True)
        if run.returncode > 1:
            sys.exit(f"unifdef {self.path}: {run.stderr}")
        return run.stdout

    def stub(self):
        """The file that a student starts from: without the hints."""
        return re.sub(r"( \*\n)? \* Hint 1: .*?(?= \*/\n)", "",
                      self.variant(None), count=1, flags=re.S)


def all_exercises():
    paths = EXERCISES.glob("[0-9][0-9]-*-*.c")
    return sorted((Exercise(path) for path in paths
                   if not path.name.endswith(".check.c")),
                  key=lambda exercise: exercise.order)


# Trying a file ----------------------------------------------------------------

@dataclass
class Outcome:
    passed: bool
    report: str  # why not
    warnings: str = ""
    printed: str = ""


def run_compiler(arguments):
    run = subprocess.run(COMPILE + arguments, text=True, capture_output=True)
    # Leave out that the compiler stops at the first error.
    messages = re.sub(r"^compilation terminated due to.*\n", "", run.stderr,
                  flags=re.M)
    return run.returncode == 0, messages


def compile_checks(exercise, folder):
    folder.mkdir(parents=True, exist_ok=True)
    compiled = folder / (exercise.slug + ".check.o")
    # Before C23, -Wpedantic minds arrays that become arrays of constants.
    good, errors = run_compiler(["-Werror", "-Wno-pedantic",
                                 "-c", str(exercise.checks),
                                 "-o", str(compiled)])
    if not good:
        sys.exit(errors)
    return compiled


def try_file(source, checks, folder):
    """Compile `source`, link it with its compiled checks, and run them."""
    compiled, program = folder / (source.stem + ".o"), folder / source.stem
    colour = ["-fdiagnostics-color=always"] if sys.stdout.isatty() else []
    good, messages = run_compiler([*colour, "-c", str(source),
                                   "-o", str(compiled)])
    if not good:
        return Outcome(False, "It does not compile:\n\n" + messages)
    good, errors = run_compiler([str(compiled), str(checks), *LINK,
                                 "-o", str(program)])
    if not good:
        return Outcome(False, explain_link(source, errors), messages)
    return run_program(source, program, messages)


def explain_link(source, errors):
    missing = sorted(set(re.findall(r"undefined reference to [`'](\w+)'",
                                    errors)))
    if not missing:
        return "It does not link:\n\n" + errors
    return ("It does not link, because there is no function "
            + ", ".join(missing) + f".\nIs it defined in {source}, or is a "
            "call misspelled?")


def run_program(source, program, warnings):
    told = program.with_suffix(".told")
    told.write_text("")
    options = "detect_leaks=0:handle_abort=1:color=never"
    environment = dict(os.environ, ASAN_OPTIONS=options)
    try:
        run = subprocess.run(
            [program, told], stdin=subprocess.DEVNULL, capture_output=True,
            text=True, errors="replace", timeout=PATIENCE, env=environment)
    except subprocess.TimeoutExpired as late:
        printed = (late.stdout or b"").decode(errors="replace")
        return Outcome(False, told.read_text() + NO_END
                       + field("where", str(source)), warnings, printed)
    report = told.read_text()
    if run.returncode == 0 and report == "passed\n":
        return Outcome(True, "", warnings, run.stdout)
    if "  got " not in report:
        report += explain_crash(source, run)
        return Outcome(False, report, warnings, run.stdout)
    return Outcome(False, report, warnings, run.stdout + run.stderr)


def field(name, text):
    return f"  {name:<9} " + text.replace("\n", "\n" + " " * 12) + "\n"


NO_END = field("got", "no answer for some seconds: an endless loop?")
CRASHES = [
    ("SEGV", "a crash: an access through an invalid pointer (NULL, or "
     "uninitialized?)"),
    ("stack-overflow", "a crash: an endless recursion?"),
    ("buffer-overflow", "a crash: an access outside an array"),
    ("stack-use-after", "a crash: the use of a variable after its function "
     "or block has ended"),
]


def explain_crash(source, run):
    """What ended a program that reported neither success nor failure."""
    errors = run.stderr
    undefined = re.search(r"^(\S+:\d+):\d+: runtime error: (.*)", errors, re.M)
    contract = re.search(r"^\S+: broken contract: (.*)", errors, re.M)
    address = re.search(r"AddressSanitizer:? ([\w-]+)", errors)
    if undefined:
        what = "undefined behaviour: " + undefined[2]
    elif contract:
        what = "a call that breaks a contract of the library: " + contract[1]
    elif address:
        what = next((sentence for kind, sentence in CRASHES
                     if kind in address[1]), "a crash: " + address[1])
    elif run.returncode == -signal.SIGXCPU:
        return NO_END + field("where", str(source))
    elif run.returncode < 0:
        what = f"a crash by signal {-run.returncode}"
    else:
        what = "the program ended early: does your code call exit?"
    frame = re.search(rf" in (\w+) \S*?({re.escape(str(source))}:\d+)", errors)
    where = str(source)
    if undefined:
        where = undefined[1]
    elif frame:
        where = f"{frame[2]}, in {frame[1]}"
    return field("got", what) + field("where", where)


# The student's progress -------------------------------------------------------

class Progress:
    """What a student has solved, and which hints: WORK/progress.json."""

    def __init__(self):
        self.path = WORK / "progress.json"
        self.of = json.loads(self.path.read_text()) \
            if self.path.exists() else {}

    def get(self, exercise):
        return self.of.setdefault(exercise.number,
                                  {"solved": False, "hints": 0})

    def save(self):
        WORK.mkdir(exist_ok=True)
        self.path.write_text(json.dumps(self.of, indent=1) + "\n")


def choose(exercises, progress, number):
    """The exercise of that number, else the first unsolved one."""
    if number:
        chosen = [e for e in exercises if e.number == number]
        if not chosen:
            sys.exit(f"There is no exercise {number}; `make list` lists them.")
        return chosen[0]
    unsolved = [e for e in exercises if not progress.get(e)["solved"]]
    if not unsolved:
        print("All exercises are solved.  `make list` lists them; "
              "`make learn N=1.1` returns to one.")
        sys.exit()
    return unsolved[0]


def paint(text, colour):
    return f"\033[{colour}m{text}\033[0m" if sys.stdout.isatty() else text


RED, GREEN, BOLD = 31, 32, 1


def heading(exercise):
    return paint(f"Exercise {exercise.number}.  {exercise.title}", BOLD)


# The commands -----------------------------------------------------------------

def learn(exercises, progress, options):
    exercise = choose(exercises, progress, options.number)
    print(heading(exercise))
    if not exercise.mine.exists():
        WORK.mkdir(exist_ok=True)
        exercise.mine.write_text(exercise.stub())
        print(f"\n{exercise.task}\n\nYour file: {exercise.mine}, newly made.  "
              "So far it fails:\n")
    else:
        print(f"Your file: {exercise.mine}\n")
    folder = BUILD / "learn"
    outcome = try_file(exercise.mine, compile_checks(exercise, folder), folder)
    show(outcome)
    if outcome.passed:
        progress.get(exercise)["solved"] = True
        progress.save()
        announce_next(exercises, progress)
    else:
        print("\nEdit your file and run `make learn` again.  `make hint` gives "
              "a hint.")


def show(outcome):
    if outcome.warnings:
        print("The compiler warns:\n\n" + outcome.warnings)
    if outcome.printed:
        print("Your program printed:\n"
              + textwrap.indent(outcome.printed[-2000:], "  "))
    if not outcome.passed:
        print(paint(outcome.report.rstrip("\n"), RED))


def announce_next(exercises, progress):
    print(paint("Solved.  Well done!", GREEN))
    unsolved = [e for e in exercises if not progress.get(e)["solved"]]
    if unsolved:
        print(f"Next is exercise {unsolved[0].number}, {unsolved[0].title}  "
              "`make learn` starts it.")
    else:
        print("That was the last one: you have solved all exercises.")


def hint(exercises, progress, options):
    exercise = choose(exercises, progress, options.number)
    print(heading(exercise))
    state = progress.get(exercise)
    state["hints"] = min(state["hints"] + 1, len(exercise.hints))
    progress.save()
    for i, text in enumerate(exercise.hints[:state["hints"]], 1):
        print(textwrap.fill(text, 78, initial_indent=f"Hint {i}: ",
                            subsequent_indent=" " * 8))
    left = len(exercise.hints) - state["hints"]
    print(f"{left} more: run `make hint` again." if left else
          "That was the last hint.  Reread the section "
          f"“{exercise.section}” of chapter {exercise.order[0]}, or run "
          f"`make solution N={exercise.number}`.")


def list_all(exercises, progress, options):
    width = max(len(exercise.title) for exercise in exercises)
    for exercise in exercises:
        state = progress.get(exercise)
        word = "solved" if state["solved"] else \
            "started" if exercise.mine.exists() else "-"
        hints = f"hints: {state['hints']}" if state["hints"] else ""
        print(f"{exercise.number:<5} {exercise.title:<{width}}  "
              f"{paint(word, GREEN if word == 'solved' else 0)} {hints}"
              .rstrip())


def reset(exercises, progress, options):
    if not options.number:
        sys.exit("Which exercise?  For instance: make reset N=1.2")
    exercise = choose(exercises, progress, options.number)
    if exercise.mine.exists():
        n = 1
        while (backup := exercise.mine.with_suffix(f".{n}.c")).exists():
            n += 1
        exercise.mine.rename(backup)
        print(f"Your file is kept as {backup}.")
    progress.of.pop(exercise.number, None)
    progress.save()
    print(f"`make learn N={exercise.number}` starts the exercise over.")


def solution(exercises, progress, options):
    if not options.number:
        sys.exit("Which exercise?  For instance: make solution N=1.2")
    exercise = choose(exercises, progress, options.number)
    if not progress.get(exercise)["solved"] and not options.sure:
        print(f"You have not solved exercise {exercise.number}; there are "
              f"{len(exercise.hints)} hints (`make hint "
              f"N={exercise.number}`).\nTo see the solution anyway: "
              f"make solution N={exercise.number} SURE=1")
        return
    print(exercise.variant("TF_SOLUTION").partition(" */\n")[2].strip())


# Grading ----------------------------------------------------------------------

def grade(exercises, progress, options):
    """Grade a folder of files, or one exercise or chapter of it."""
    folder, results = Path(options.dir or WORK), BUILD / "grade"
    wanted = [e for e in exercises if options.number in
              (None, e.number, str(e.order[0]))]
    if not wanted or not folder.is_dir():
        sys.exit(f"There is no folder {folder} to grade." if wanted else
                 f"There is no exercise or chapter {options.number}.")
    results.mkdir(parents=True, exist_ok=True)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        outcomes = list(pool.map(
            lambda e: grade_one(e, folder / e.path.name, results), wanted))
    tests = [{"number": e.number, "name": e.title, "score": int(o.passed),
              "max_score": 1, "status": "passed" if o.passed else "failed",
              "output": o.report, "output_format": "text",
              "visibility": "visible"} for e, o in zip(wanted, outcomes)]
    score = sum(test["score"] for test in tests)
    summary = f"{score} of {len(tests)} exercises are solved."
    (results / "results.json").write_text(json.dumps(
        {"score": score, "output": summary, "output_format": "text",
         "visibility": "visible", "stdout_visibility": "hidden",
         "tests": tests}, indent=1) + "\n")
    for test in tests:
        print(f"{test['number']:<5} {test['score']} of {test['max_score']}  "
              f"{test['name']}")
    print(f"{summary}  See {results}/results.json.")


def grade_one(exercise, source, folder):
    if not source.exists():
        return Outcome(False, f"There is no file {source.name}.")
    return try_file(source, compile_checks(exercise, folder), folder)


# Checking the exercises themselves --------------------------------------------

def check(exercises, progress, options):
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        results = list(pool.map(check_one, exercises))
    faults = check_order(exercises)
    for exercise, (found, tried) in zip(exercises, results):
        faults += [f"{exercise.slug}: {fault}" for fault in found]
    for fault in faults:
        print(fault)
    print(f"{len(exercises)} exercises, {sum(n for _, n in results)} "
          f"variants: {len(faults)} faults.")
    sys.exit(bool(faults) or not exercises)


def check_order(exercises):
    """Chapters count from 1 without gaps, and so do the exercises of each."""
    faults, last = [], (0, 0)
    for exercise in exercises:
        if exercise.order not in ((last[0], last[1] + 1), (last[0] + 1, 1)):
            faults.append(f"{exercise.slug}: does not follow "
                          f"{last[0]}.{last[1]}")
        last = exercise.order
    checks = {exercise.checks for exercise in exercises}
    return faults + [f"{path.name}: checks no exercise" for path in
                     sorted(set(EXERCISES.glob("*.check.c")) - checks)]


def check_one(exercise):
    """What is wrong with an exercise, and how many variants were tried."""
    faults = [*text_faults(exercise), *include_faults(exercise)]
    if not exercise.checks.exists():
        return [*faults, "has no checks"], 0
    folder = BUILD / "exercises" / exercise.slug
    checks = compile_checks(exercise, folder)
    variants = exercise.variants()
    for name in [None, *variants]:
        source = folder / ((name or "stub").lower() + ".c")
        source.write_text(exercise.variant(name) if name else exercise.stub())
        outcome = try_file(source, checks, folder)
        faults += variant_faults(name or "the stub", outcome)
    return faults, 1 + len(variants)


def variant_faults(name, outcome):
    if outcome.warnings or "\n  got" not in outcome.report \
            and not outcome.passed:
        yield f"{name}: {outcome.warnings or outcome.report}"
    elif outcome.passed != (name == "TF_SOLUTION"):
        yield f"{name}: " + ("passes" if outcome.passed else
                             "fails\n" + outcome.report)
    elif not outcome.passed and "  where     exercises/" not in outcome.report:
        yield f"{name}: breaks down instead of failing\n" + outcome.report


def text_faults(exercise):
    wrong = [f"TF_WRONG_{i}" for i in range(1, len(exercise.variants()))]
    if exercise.variants() != ["TF_SOLUTION", *wrong] or len(wrong) < 2:
        yield "needs TF_SOLUTION, TF_WRONG_1, TF_WRONG_2 and so on"
    text = exercise.path.read_text()
    if f"Exercise {exercise.number}.  {exercise.title}\n" not in text:
        yield "the title is not: /* Exercise N.k.  Its title."
    numbers = re.findall(r"Hint (\d+): ", text)
    if len(numbers) < 2 or numbers != [str(i + 1) for i in
                                       range(len(numbers))]:
        yield "needs at least two hints, counted from 1"
    if not exercise.section:
        yield "names no section (Section: Its title.)"
    chapter = Path("book", CHAPTERS[exercise.order[0] - 1][0] + ".md")
    if chapter.exists() and not re.search(
            rf"^#+ {re.escape(exercise.section)}\s*$", chapter.read_text(),
            re.M):
        yield f"{chapter} has no section “{exercise.section}”"


def include_faults(exercise):
    """Headers of later chapters."""
    taught = {module + ".h" for _, *modules in CHAPTERS[:exercise.order[0]]
              for module in modules}
    for path in (exercise.path, exercise.checks):
        text = path.read_text() if path.exists() else ""
        for header in re.findall(r'#\s*include "(.*)"', text):
            if Path("src", header).exists() and header not in taught:
                yield f"{path.name}: {header} is of a later chapter"


COMMANDS = {"learn": learn, "hint": hint, "list": list_all, "reset": reset,
            "solution": solution, "grade": grade, "check": check}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("command", choices=COMMANDS)
    parser.add_argument("--number", type=lambda text: text or None)
    parser.add_argument("--dir", help="the folder to grade")
    parser.add_argument("--sure", help="show an unsolved exercise's solution")
    options = parser.parse_args()
    COMMANDS[options.command](all_exercises(), Progress(), options)


if __name__ == "__main__":
    main()
