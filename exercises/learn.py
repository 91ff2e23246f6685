"""Take a student through the exercises; rules.mk has the targets that run this.

The exercises are in catalog.py, trial.py tries a file, course.py grades those of
a course, review.py checks the exercises themselves.
"""
import argparse
import json
import signal
import subprocess
import sys
import textwrap
import time

import course
import review
from catalog import BUILD, WORK, all_exercises, chosen_exercises
from trial import compile_checks, field, try_file


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


def choose(exercises, progress, numbers):
    """The exercises of those numbers, else the first unsolved one."""
    if numbers:
        return chosen_exercises(exercises, numbers)
    unsolved = [e for e in exercises if not progress.get(e)["solved"]]
    if not unsolved:
        print("All exercises are solved.  `make list` lists them; "
              "`make learn N=1.1` returns to one.")
        sys.exit()
    return unsolved[:1]


def name(exercises, numbers, command):
    """The exercises of those numbers, which must be given."""
    if not numbers:
        sys.exit(f"Which exercise?  For instance: make {command} N=1.2")
    return chosen_exercises(exercises, numbers)


def paint(text, colour):
    return f"\033[{colour}m{text}\033[0m" if sys.stdout.isatty() else text


RED, GREEN, BOLD = 31, 32, 1


def heading(exercise):
    return paint(f"Exercise {exercise.number}.  {exercise.title}", BOLD)


# Learning ---------------------------------------------------------------------

def learn(exercises, progress, options):
    """Exits with status 1 unless all that were chosen are solved."""
    chosen = choose(exercises, progress, options.number)
    paths = [exercise.mine for exercise in chosen]
    before = times(paths)
    solved = learn_each(chosen, progress)
    while options.watch and not all(solved):
        before = wait_for_change(paths, before)
        print("\n" + "-" * 78)
        solved = learn_each(chosen, progress)
    if all(solved):
        announce_next(exercises, chosen[-1], progress)
    else:
        failed = chosen[solved.index(False)].number
        print("\nEdit your file " + ("and save it." if options.watch else
                                     "and run `make learn` again.")
              + "  `make hint" + (f" N={failed}" if options.number else "")
              + "` gives a hint.")
    sys.exit(not all(solved))


def learn_each(chosen, progress):
    solved = []
    for exercise in chosen:
        if solved:
            print()
        solved.append(learn_one(exercise, progress))
    return solved


def wait_for_change(paths, before):
    """Wait until a file is written that was tried as it was `before`; the times
    of what is tried next.  What was edited during a trial counts, but not the
    files that it has made."""
    tried = [then or now for then, now in zip(before, times(paths))]
    print("\nWaiting for you to edit " + ", ".join(map(str, paths))
          + ".  `make hint` in another\nterminal gives a hint; Ctrl-C ends "
          "this.", flush=True)
    while (now := times(paths)) == tried or 0 in now:
        time.sleep(0.2)
    return now


def times(paths):
    """When the files were last written; 0 while an editor replaces them."""
    return [path.stat().st_mtime_ns if path.exists() else 0 for path in paths]


def learn_one(exercise, progress):
    print(heading(exercise))
    if not exercise.mine.exists():
        WORK.mkdir(exist_ok=True)
        exercise.mine.write_text(exercise.stub())
        print(f"\n{exercise.task}\n")
        state = ", newly made.  So far it fails:"
    else:
        state = ""
    print(f"The section: {exercise.section}"
          + (f" ({place})" if (place := exercise.place()) else ""))
    print(f"Your file: {exercise.mine}{state}\n", flush=True)
    folder = BUILD / "learn"
    outcome = try_file(exercise, exercise.mine,
                       compile_checks(exercise, folder), folder)
    show(outcome)
    if outcome.picture:
        print(draw(outcome.picture, folder / exercise.slug), end="")
    if outcome.passed:
        print(paint("Solved.  Well done!", GREEN))
        progress.get(exercise)["solved"] = True
        progress.save()
    return outcome.passed


def show(outcome):
    if outcome.warnings:
        print("The compiler warns:\n\n" + outcome.warnings)
    if outcome.printed:
        print("Your program printed:\n"
              + textwrap.indent(outcome.printed[-2000:], "  "))
    if not outcome.passed:
        print(paint(outcome.report.rstrip("\n"), RED))


def draw(picture, path):
    """Draw the failing input, if the drawing program has been built."""
    kind, rows = picture
    program, drawn = BUILD / "tanglefree-draw", path.with_suffix(".png")
    if not program.exists():
        return ""
    table = path.with_suffix(".csv")
    table.write_text(rows)
    run = subprocess.run([program, "query", f"{table}:0", "--kind", kind, "-o",
                          drawn], capture_output=True)
    return field("picture", str(drawn)) if run.returncode == 0 else ""


def announce_next(exercises, last, progress):
    """Announce the next unsolved exercise after `last`, if there is one."""
    unsolved = [e for e in exercises if not progress.get(e)["solved"]]
    if not unsolved:
        print("That was the last one: you have solved all exercises.")
        return
    after = [e for e in unsolved if e.order > last.order]
    following = (after or unsolved)[0]
    chosen = "" if following is unsolved[0] else f" N={following.number}"
    print(f"Next is exercise {following.number}, {following.title}  "
          f"`make learn{chosen}` starts it.")


# Help -------------------------------------------------------------------------

def hint(exercises, progress, options):
    for exercise in choose(exercises, progress, options.number):
        hint_one(exercise, progress)


def hint_one(exercise, progress):
    print(heading(exercise))
    state = progress.get(exercise)
    state["hints"] = min(state["hints"] + 1, len(exercise.hints))
    progress.save()
    for i, text in enumerate(exercise.hints[:state["hints"]], 1):
        print(textwrap.fill(text, 78, initial_indent=f"Hint {i}: ",
                            subsequent_indent=" " * 8))
    left = len(exercise.hints) - state["hints"]
    if left:
        print(f"{left} more: run `make hint` again.")
        return
    place = exercise.place()
    print("That was the last hint.  Reread the section "
          f"“{exercise.section}” of chapter {exercise.order[0]}"
          + (f" ({place})" if place else "")
          + (f", or run `make solution N={exercise.number}`."
             if exercise.variants() else "."))


def list_all(exercises, progress, options):
    width = max(len(exercise.title) for exercise in exercises)
    for exercise in chosen_exercises(exercises, options.number):
        state = progress.get(exercise)
        word = "solved" if state["solved"] else \
            "started" if exercise.mine.exists() else "-"
        hints = f"hints: {state['hints']}" if state["hints"] else ""
        print(f"{exercise.number:<5} {exercise.title:<{width}}  "
              f"{paint(word, GREEN if word == 'solved' else 0)} {hints}"
              .rstrip())


def reset(exercises, progress, options):
    for exercise in name(exercises, options.number, "reset"):
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
    for exercise in name(exercises, options.number, "solution"):
        if not exercise.variants():
            sys.exit("This edition of the exercises has no solutions.")
        if not progress.get(exercise)["solved"] and not options.sure:
            print(f"You have not solved exercise {exercise.number}; there are "
                  f"{len(exercise.hints)} hints (`make hint "
                  f"N={exercise.number}`).\nTo see the solution anyway: "
                  f"make solution N={exercise.number} SURE=1")
            continue
        print(exercise.variant("TF_SOLUTION").partition(" */\n")[2].strip())
        if (proof := exercise.path.with_suffix(".gappa")).exists():
            print("\n" + proof.read_text().strip())


COMMANDS = {"learn": learn, "hint": hint, "list": list_all, "reset": reset,
            "solution": solution}
OF_COURSES = {"grade": course.grade, "grade-all": course.grade_all,
              "gradescope": course.write_autograder,
              "handout": course.write_handout, "check": review.check}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("command", choices=[*COMMANDS, *OF_COURSES])
    parser.add_argument("--number", help="exercises or chapters: '1.2 3'")
    parser.add_argument("--dir", help="the folder to grade")
    parser.add_argument("--weights", help="a file of what exercises count")
    parser.add_argument("--watch", help="try the file whenever it changes")
    parser.add_argument("--sure", help="show an unsolved exercise's solution")
    options = parser.parse_args()
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)  # for `make list | head`
    try:
        if options.command in COMMANDS:
            COMMANDS[options.command](all_exercises(), Progress(), options)
        else:
            OF_COURSES[options.command](all_exercises(), options)
    except KeyboardInterrupt:
        sys.exit(1)


if __name__ == "__main__":
    main()
