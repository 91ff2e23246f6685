"""Check the exercises themselves: make check-exercises."""
import os
import re
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from catalog import (BUILD, CHAPTERS, EXERCISES, chosen_exercises)
from trial import compile_checks, try_file


def check(exercises, options):
    chosen = chosen_exercises(exercises, options.number)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        results = list(pool.map(check_one, chosen))
    faults = check_order(exercises)
    for exercise, (found, tried) in zip(chosen, results):
        faults += [f"{exercise.slug}: {fault}" for fault in found]
    for fault in faults:
        print(fault)
    print(f"{len(chosen)} exercises, {sum(n for _, n in results)} "
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
    try:
        checks = compile_checks(exercise, folder)
    except SystemExit as error:
        return [*faults, f"the checks do not compile: {error}"], 0
    variants = exercise.variants()
    for name in [None, *variants]:
        source = folder / ((name or "stub").lower() + ".c")
        source.write_text(exercise.variant(name) if name else exercise.stub())
        outcome = try_file(exercise, source, checks, folder)
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
    if re.search(r"^#.*\\$", text, re.M):
        yield "has a condition of two lines, which unifdef cannot read"
    if f"Exercise {exercise.number}.  {exercise.title}\n" not in text:
        yield "the title is not: /* Exercise N.k.  Its title."
    numbers = re.findall(r"Hint (\d+): ", text)
    if len(numbers) < 2 or numbers != [str(i + 1) for i in
                                       range(len(numbers))]:
        yield "needs at least two hints, counted from 1"
    if not exercise.section:
        yield "names no section (Section: Its title.)"
    if exercise.chapter.exists() and not exercise.place():
        yield f"{exercise.chapter} has no section “{exercise.section}”"


def include_faults(exercise):
    """Headers of later chapters."""
    taught = {module + ".h" for _, *modules in CHAPTERS[:exercise.order[0]]
              for module in modules}
    for path in (exercise.path, exercise.checks):
        text = path.read_text() if path.exists() else ""
        for header in re.findall(r'#\s*include "(.*)"', text):
            if Path("src", header).exists() and header not in taught:
                yield f"{path.name}: {header} is of a later chapter"
