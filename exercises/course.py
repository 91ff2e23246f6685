"""For a course: grade answers, and make what students and Gradescope get."""
import csv
import hashlib
import json
import os
import shutil
import stat
import sys
import zipfile
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from catalog import BUILD, EXERCISES, WORK, chosen_exercises
from trial import Outcome, compile_checks, try_file

LARGEST = 1 << 20  # bytes of an answer
MISSING = Outcome(False, "There is no such file.", word="missing")


# What is handed in ------------------------------------------------------------

@dataclass
class Submission:
    """The files of a student, by name; and what is odd about them."""
    student: str
    files: dict
    notes: list


def read_folder(folder, wanted):
    """Paths and contents of files with these names; links are not followed."""
    for path in sorted(folder.rglob("*.c")):
        if path.name in wanted and stat.S_ISREG(path.lstat().st_mode):
            with path.open("rb") as file:
                yield path.relative_to(folder), file.read(LARGEST + 1)


def read_zip(path, wanted):
    """The same of a zip file, without unpacking it."""
    with zipfile.ZipFile(path) as archive:
        for entry in archive.infolist():
            name = Path(entry.filename)
            if name.name in wanted and name.parts[0] != "__MACOSX":
                with archive.open(entry) as file:
                    yield name, file.read(LARGEST + 1)


def read_submission(path, exercises):
    """Answers may be in any folder; of two the one less deep counts."""
    wanted = {e.path.name for e in exercises}
    found = Submission(path.stem, {}, [])
    try:
        read = read_folder if path.is_dir() else read_zip
        all_files = sorted(read(path, wanted), key=lambda f: len(f[0].parts))
    except (zipfile.BadZipFile, NotImplementedError, RuntimeError, OSError,
            EOFError, ValueError) as fault:
        found.notes.append(f"cannot be read: {fault}")
        return found
    for name, text in all_files:
        if name.name in found.files:
            found.notes.append(f"{name} is a second one, and ignored")
        elif len(text) > LARGEST:
            found.notes.append(f"{name} is larger than a megabyte")
        else:
            found.files[name.name] = text
    return found


def read_weights(path, exercises):
    """What each exercise counts: 1, or as a line "1.2 3" or "1 3" says."""
    said = {}
    for number, line in enumerate(open(path), 1) if path else []:
        words = line.partition("#")[0].replace(",", " ").split()
        try:
            if words:
                name, points = words
                said[name] = float(points)
                if not 0 <= said[name] < 1e6:
                    raise ValueError
                chosen_exercises(exercises, name)
        except ValueError:
            sys.exit(f"{path}:{number}: should be the number of an exercise or "
                     "chapter\nand what it counts, like 1.2 3")
    return {e.number: said.get(e.number, said.get(str(e.order[0]), 1))
            for e in exercises}


# Grading ----------------------------------------------------------------------

def try_all(jobs, folder):
    """Outcomes by job, an exercise and the bytes of a file; each is tried once,
    so a report must not tell whose it is."""
    def try_one(job):
        exercise, text = job
        place = folder / hashlib.sha256(text).hexdigest()[:16]
        place.mkdir(parents=True, exist_ok=True)
        source = place / exercise.path.name
        source.write_bytes(text)
        return try_file(exercise, source, checks[exercise], place,
                        source.name)

    jobs = list(dict.fromkeys(jobs))
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        used = list(dict.fromkeys(exercise for exercise, _ in jobs))
        checks = dict(zip(used, pool.map(
            lambda e: compile_checks(e, BUILD / "grade"), used)))
        return dict(zip(jobs, pool.map(try_one, jobs)))


def outcomes_of(submission, exercises, tried):
    for exercise in exercises:
        text = submission.files.get(exercise.path.name)
        yield exercise, MISSING if text is None else tried[exercise, text]


def grade_submissions(paths, exercises, folder):
    """Pairs of a submission and its outcomes, by exercise."""
    submissions = [read_submission(path, exercises) for path in paths]
    jobs = [(e, s.files[e.path.name]) for s in submissions for e in exercises
            if e.path.name in s.files]
    tried = try_all(jobs, folder)
    return [(s, list(outcomes_of(s, exercises, tried))) for s in submissions]


def plain(points):
    return int(points) if points == int(points) else points


def grade(exercises, options):
    """Grade a folder of files; write Gradescope's results.json."""
    folder, results = Path(options.dir or WORK), BUILD / "grade"
    wanted = chosen_exercises(exercises, options.number)
    weights = read_weights(options.weights, exercises)
    if not folder.is_dir():
        sys.exit(f"There is no folder {folder} to grade.")
    (submission, outcomes), = grade_submissions([folder], wanted, results)
    tests = [{"number": e.number, "name": e.title,
              "score": plain(o.passed * weights[e.number]),
              "max_score": plain(weights[e.number]),
              "status": "passed" if o.passed else "failed",
              "output": o.report, "output_format": "text",
              "visibility": "visible"} for e, o in outcomes]
    score = sum(test["score"] for test in tests)
    solved = sum(o.passed for _, o in outcomes)
    summary = f"{solved} of {len(tests)} exercises are solved."
    output = "\n".join([summary, *submission.notes])
    results.mkdir(parents=True, exist_ok=True)
    (results / "results.json").write_text(json.dumps(
        {"score": score, "output": output, "output_format": "text",
         "visibility": "visible", "stdout_visibility": "hidden",
         "tests": tests}, indent=1) + "\n")
    for test in tests:
        print(f"{test['number']:<5} {test['score']} of {test['max_score']}  "
              f"{test['name']}")
    print(f"{output}  See {results}/results.json.")


def grade_all(exercises, options):
    """Grade the folders and zip files in a folder; write a table."""
    folder, results = Path(options.dir or ""), BUILD / "grade-all"
    if not options.dir or not folder.is_dir():
        sys.exit("Which folder?  For instance: make grade-all DIR=submissions")
    wanted = chosen_exercises(exercises, options.number)
    weights = read_weights(options.weights, exercises)
    paths = sorted(path for path in folder.iterdir()
                   if not path.is_symlink() and path.name[0] != "." and
                   (path.is_dir() or path.suffix == ".zip"))
    shutil.rmtree(results, ignore_errors=True)
    graded = grade_submissions(paths, wanted, results / "tried")
    shutil.rmtree(results / "tried", ignore_errors=True)
    results.mkdir(parents=True, exist_ok=True)
    write_table(results / "grades.csv", graded, wanted, weights)
    for submission, outcomes in graded:
        write_report(results / f"{submission.student}.txt", submission,
                     outcomes)
    print(f"{len(graded)} submissions are graded: see {results}/grades.csv, "
          "and a report each\nbeside it.")


def write_table(path, graded, exercises, weights):
    most = plain(sum(weights[e.number] for e in exercises))
    with path.open("w", newline="") as file:
        table = csv.writer(file)
        table.writerow(["student", "points", "of",
                        *(e.number for e in exercises), "notes"])
        for submission, outcomes in graded:
            points = sum(o.passed * weights[e.number] for e, o in outcomes)
            table.writerow([submission.student, plain(points), most,
                            *(o.word for _, o in outcomes),
                            "; ".join(submission.notes)])


def write_report(path, submission, outcomes):
    """What a student may see."""
    text = [f"{note}\n" for note in submission.notes]
    text += [f"{e.number} {e.title}  {o.word}\n" +
             (o.report.rstrip("\n") + "\n" if o.report else "")
             for e, o in outcomes]
    path.write_text("\n".join(text))


# What others get --------------------------------------------------------------

# What `make learn` and `make grade` are made of, besides the exercises.
PARTS = ["Makefile", "LICENSE", "README.md", "book/chapters", "src/**/*",
         "*/rules.mk", "*/*/rules.mk", "tests/checks.mk", "tests/help.awk",
         "tests/packages", "tests/install-packages.sh", "tests/support/*",
         "tests/bench/*.[ch]", "tests/proofs/*", "figures/kit/expansion.[ch]",
         "exercises/README.md", "exercises/*.py", "exercises/*.h",
         "exercises/check.c", "exercises/judge.c", "exercises/confine.c"]

SETUP = """\
#!/bin/sh
# Gradescope runs this once: install the packages, build the library.
set -e
apt-get update
apt-get install -y --no-install-recommends make
make -C /autograder/source ready
"""
RUN = """\
#!/bin/sh
# Gradescope runs this for each submission.
cd /autograder/source
make -s grade DIR=/autograder/submission N='{numbers}' WEIGHTS=weights
cp build/grade/results.json /autograder/results/results.json
"""


def parts():
    return sorted({path for part in PARTS for path in Path().glob(part)
                   if path.is_file()})


def write_zip(path, files):
    """`files`: pairs of a name and a text; programs are executable."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in files:
            entry = zipfile.ZipInfo(str(name), (1980, 1, 1, 0, 0, 0))
            script = text.startswith(b"#!")
            entry.external_attr = (0o755 if script else 0o644) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, text)


def without(word, text):
    """The text without the lines that have a word."""
    return b"".join(line for line in text.splitlines(keepends=True)
                    if word not in line)


def handed_out(path):
    """What a handout has instead of a file; its exercises are cut already, and
    its README is what ours tells students."""
    text = path.read_bytes()
    if path == Path("tests/packages"):
        return without(b"unifdef", text)
    if path == Path("README.md"):
        text = Path("exercises/README.md").read_bytes()
        return without(b"make solution", text.partition(b"## For courses")[0])
    return text


def write_handout(exercises, options):
    """The exercises without solutions, and all that `make learn` needs."""
    wanted = chosen_exercises(exercises, options.number)
    path = BUILD / "handout.zip"
    top = Path("tanglefree-exercises")
    files = [(top / part, handed_out(part)) for part in parts()
             if part != Path("exercises/README.md")]
    for e in wanted:
        files += [(top / "exercises" / e.path.name, e.variant(None).encode()),
                  (top / "exercises" / e.checks.name, e.checks.read_bytes())]
    write_zip(path, files)
    print(f"{path} has {len(wanted)} exercises without solutions, for "
          "students: `make learn`\nin its folder needs a compiler, Check and "
          "Python.")


def write_autograder(exercises, options):
    """What to upload to Gradescope as the autograder of an assignment."""
    wanted = chosen_exercises(exercises, options.number)
    weights = read_weights(options.weights, exercises)
    path = BUILD / "gradescope.zip"
    files = [(part, part.read_bytes()) for part in parts()]
    files += [(EXERCISES / file.name, file.read_bytes())
              for e in wanted for file in (e.path, e.checks)]
    files += [("setup.sh", SETUP.encode()),
              ("run_autograder", RUN.format(numbers=" ".join(
                  e.number for e in wanted)).encode()),
              ("weights", "".join(f"{e.number} {weights[e.number]}\n"
                                  for e in wanted).encode())]
    write_zip(path, files)
    print(f"{path} grades {len(wanted)} exercises: upload it as the "
          "autograder of a\nprogramming assignment on Gradescope.")
