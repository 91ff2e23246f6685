"""Try a file: compile it, link it with its checks, run both, explain the end.

Two programs are linked from the same checks: the answer's process, which has
the student's code and is confined, and the judge, which has not and decides (see
check.h and confine.h).  An answer is linked to what the checks are made of only
where it is called; it cannot call them.
"""
import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

COMPILE = shlex.split(os.environ.get("COMPILE", "cc"))
HARNESS = shlex.split(os.environ.get("HARNESS", ""))
LINK = shlex.split(os.environ.get("LINK", ""))
LIBRARIES = [word for word in LINK if not word.startswith("-")]
PATIENCE = 600  # seconds for the judge, which waits for no answer that long

# What compiling a file may take: seconds of the processor, bytes.
LIMITS = ["--cpu=60", "--as=4000000000", "--fsize=100000000", "--core=0"]
LIMITED = ["prlimit", *LIMITS] if shutil.which("prlimit") else []
ROOT = Path().resolve()
HEADERS = [ROOT / "src", ROOT / "figures"]

SANITIZERS = dict(os.environ, ASAN_OPTIONS="detect_leaks=0:handle_abort=1:"
                  "color=never:max_allocation_size_mb=1000")


@dataclass
class Outcome:
    passed: bool
    report: str  # why not
    warnings: str = ""
    printed: str = ""
    word: str = "wrong"  # for tables
    picture: tuple = ()  # of the failing input: a kind of query, its rows

    def __post_init__(self):
        if self.passed:
            self.word = "right"


# Compiling --------------------------------------------------------------------

def run_compiler(arguments, text="", limits=()):
    """In a session of its own, so that no file of a student's reads a terminal."""
    run = subprocess.run([*limits, *COMPILE, *arguments], input=text, text=True,
                         errors="replace", capture_output=True,
                         start_new_session=True)
    # Leave out that the compiler stops at the first error.
    messages = re.sub(r"^compilation terminated due to.*\n", "", run.stderr,
                      flags=re.M)
    return run, messages


def must(run_and_messages):
    run, messages = run_and_messages
    if run.returncode != 0:
        sys.exit(messages)
    return run


def is_newer(made, sources):
    return made.exists() and all(
        os.path.getmtime(source) < made.stat().st_mtime for source in sources)


def compile_checks(exercise, folder):
    """The checks as one object without names but what is needed, and a judge."""
    folder.mkdir(parents=True, exist_ok=True)
    made = folder / (exercise.slug + ".checks.o")
    judge = folder / (exercise.slug + ".judge")
    if is_newer(judge, [exercise.checks, *HARNESS, *LIBRARIES]):
        return made, judge
    compiled = folder / (exercise.slug + ".check.o")
    # Before C23, -Wpedantic minds arrays that become arrays of constants.
    must(run_compiler(["-Werror", "-Wno-pedantic", "-Itests", "-c",
                       str(exercise.checks), "-o", str(compiled)]))
    must(run_compiler(["-r", "-nostdlib", str(compiled), *HARNESS, "-o",
                       str(made)]))
    subprocess.run(["objcopy", *(f"--keep-global-symbol={name}" for name in
                                 ["main", *exercise.provided()]), made],
                   check=True)
    absent = folder / (exercise.slug + ".absent.o")
    must(run_compiler(
        ["-x", "c", "-", "-c", "-o", str(absent), "-w"],
        "".join(f"void {name}(void) {{ __builtin_trap(); }}\n"
                for name in exercise.wanted())))
    must(run_compiler([str(absent), str(made), *LINK, "-o", str(judge)]))
    return made, judge


def source_text(exercise, source, shown):
    """The student's file, then the declarations that it must agree with."""
    parts = [(1, source.read_text(errors="replace"), shown)]
    parts += [(line, text, exercise.checks)
              for line, text, _ in exercise.prototypes()]
    return "".join(f'#line {line} "{path}"\n{text}\n'
                   for line, text, path in parts)


def is_allowed(header):
    """Headers of the library, of a figure, and those that are not ours."""
    path = Path(header).resolve()
    return path.suffix == ".h" and (ROOT not in path.parents or any(
        folder in path.parents for folder in HEADERS))


def foreign_headers(text):
    """What a file includes that no answer may include."""
    run, _ = run_compiler(["-M", "-x", "c", "-"], text, LIMITED)
    if run.returncode != 0:
        return []
    rule = run.stdout.replace("\\\n", " ").partition(":")[2]
    return [header for header in shlex.split(rule)
            if header != "-" and not is_allowed(header)]


def compile_answer(exercise, source, shown, compiled):
    """Its warnings and None, or None and the outcome."""
    text = source_text(exercise, source, shown)
    for header in foreign_headers(text):
        return None, Outcome(False, f"{shown} includes {header}.\nAn answer "
                             "may include headers of src/ and of C only.",
                             word="does not compile")
    colour = ["-fdiagnostics-color=always"] if sys.stdout.isatty() else []
    run, messages = run_compiler([*colour, "-x", "c", "-", "-c", "-o",
                                  str(compiled)], text, LIMITED)
    if run.returncode != 0:
        return None, Outcome(False, "It does not compile:\n\n" + messages,
                             word="does not compile")
    return messages, None


def try_file(exercise, source, checks, folder, shown=None):
    """Compile `source`, link it with its compiled checks, and run them.

    Messages call it `shown`, or as it is called.
    """
    made, judge = checks
    shown = shown or source
    compiled, program = folder / (source.stem + ".o"), folder / source.stem
    try:
        warnings, failure = compile_answer(exercise, source, shown,
                                           compiled)
        if failure:
            return failure
        run, errors = run_compiler([str(compiled), str(made), *LINK,
                                    "-o", str(program)], limits=LIMITED)
        if run.returncode != 0:
            return Outcome(False, explain_link(shown, errors), warnings,
                           word="does not compile")
        return run_program(shown, program, judge, warnings)
    finally:
        compiled.unlink(missing_ok=True)
        program.unlink(missing_ok=True)


def explain_link(source, errors):
    missing = sorted(set(re.findall(r"undefined reference to [`'](\w+)'",
                                    errors)))
    if not missing:
        return "It does not link:\n\n" + errors
    return ("It does not link, because there is no function "
            + ", ".join(missing) + f".\nIs it defined in {source}, or is a "
            "call misspelled?")


# Running ----------------------------------------------------------------------

def run_program(source, program, judge, warnings):
    printed, errors = (program.with_suffix(ending)
                       for ending in (".printed", ".errors"))
    try:
        run = subprocess.run([judge, program, printed, errors], text=True,
                             stdin=subprocess.DEVNULL, capture_output=True,
                             errors="replace", timeout=PATIENCE,
                             env=SANITIZERS)
    except subprocess.TimeoutExpired:
        return Outcome(False, field("got", ENDS["slow"]), warnings)
    report, _, end = run.stdout.rpartition("end: ")
    report, _, picture = report.partition("picture: ")
    kind, _, rows = picture.partition("\n")
    words = printed.read_text(errors="replace")
    complaints = errors.read_text(errors="replace")
    if end == "free\n":
        sys.exit("Answers cannot be run: this kernel does not let a program "
                 "confine itself\n(seccomp; see exercises/confine.h).")
    if end == "passed\n" and run.returncode == 0:
        return Outcome(True, "", warnings, words)
    if end == "failed\n":
        return Outcome(False, report, warnings, words + complaints,
                       picture=(kind, rows) if rows else ())
    report += explain_end(source, end.split() or ["judge"], complaints
                          if end else run.stderr)
    return Outcome(False, report, warnings, words)


def field(name, text):
    return f"  {name:<9} " + text.replace("\n", "\n" + " " * 12) + "\n"


ENDS = {
    "sleeps": "no answer for some seconds, in which it did not compute: does it "
    "sleep,\nor wait for input?",
    "memory": "more than 2 GiB of memory taken: an endless loop that allocates?",
    "closed": "no more answers: does your code close files that it did not open?",
    "slow": "no end after ten minutes",
    "judge": "a result that the checks cannot read",
}
SIGNALS = {
    signal.SIGXCPU: "no answer after 5 seconds of processor time: an endless "
    "loop?",
    signal.SIGKILL: "no answer after 5 seconds of processor time: an endless "
    "loop?",
    signal.SIGXFSZ: "more than a megabyte printed: an endless loop that prints?",
}
CRASHES = [
    ("SEGV", "a crash: an access through an invalid pointer (NULL, or "
     "uninitialized?)"),
    ("stack-overflow", "a crash: an endless recursion?"),
    ("buffer-overflow", "a crash: an access outside an array"),
    ("stack-use-after", "a crash: the use of a variable after its function "
     "or block has ended"),
]


def explain_end(source, end, errors):
    """What ended an answer that neither passed nor failed a check."""
    undefined = re.search(r"^(\S+:\d+):\d+: runtime error: (.*)", errors, re.M)
    contract = re.search(r"^\S+: broken contract: (.*)", errors, re.M)
    address = re.search(r"AddressSanitizer:? ([\w-]+)", errors)
    number = int(end[1]) if end[0] == "signal" else 0
    if end[0] in ENDS:
        what = ENDS[end[0]]
    elif number in SIGNALS:
        what = SIGNALS[number]
    elif undefined:
        what = "undefined behaviour: " + undefined[2]
    elif contract:
        what = "a call that breaks a contract of the library: " + contract[1]
    elif address:
        what = next((sentence for kind, sentence in CRASHES
                     if kind in address[1]), "a crash: " + address[1])
    elif number:
        what = f"a crash by signal {number}"
    else:
        what = "the program ended early: does your code call exit?"
    frame = re.search(rf" in (\w+) \S*?({re.escape(str(source))}:\d+)", errors)
    where = str(source)
    if undefined:
        where = undefined[1]
    elif frame:
        where = f"{frame[2]}, in {frame[1]}"
    return field("got", what) + field("where", where)
