"""Prove the error bounds of the library by Gappa: all scripts, or those named,
by the name of a script here or by a path.

A script says in its comments what it proves, and takes its constants from the
C code:

    # claim: TEXT       what is proved
    # source: FILE      the file that the next lines are about
    # code: TEXT        must be in that file, however it is broken into lines;
                        {NAME} stands for whatever the file has there, and
                        defines NAME in the script
    # least: NAME = X, not Y
                        the proof must also succeed with NAME = X, and must
                        fail with NAME = Y, which is smaller

So a proof fails when a quoted line changes or a constant becomes too small, and
what is too small is known.
"""

import pathlib
import re
import subprocess
import sys

FOLDER = pathlib.Path(__file__).parent
ROOT = FOLDER.parent.parent

# The second order of 2^-53 times 2^-1075 has digits far behind the point.  No
# proof needs to cut ranges into pieces, and without that failure comes soon.
GAPPA = ["gappa", "-Eprecision=300", "-Eno-auto-dichotomy",
         "-Wno-unbound-variable", "-Wno-null-denominator"]


class Trouble(Exception):
    """A script that cannot be judged."""


def told(script, what):
    return re.findall(rf"^# {what}: (.*)$", script, re.MULTILINE)


def find_quoted(quoted, source):
    """The constants at the place that is quoted, {name: text}."""
    pattern = r"\s+".join(map(re.escape, quoted.split()))
    pattern = re.sub(r"\\{(\w+)\\}$", r"(?P<\1>[^\\n;]+)", pattern)
    pattern = re.sub(r"\\{(\w+)\\}", r"(?P<\1>[^\\n;]+?)", pattern)
    found = re.search(pattern, source)
    if not found:
        raise Trouble(f"the code has no `{quoted}`")
    return found.groupdict()


def read_constants(script):
    """The constants that the script takes from its sources, {name: text}."""
    constants, source = {}, ""
    for what, text in re.findall("^# (source|code): (.*)$", script,
                                 re.MULTILINE):
        if what == "source":
            source = (ROOT / text).read_text()
        else:
            constants |= find_quoted(text, source)
    return constants


def unproved(script, constants):
    """What Gappa cannot prove of a script with these constants; "" if all."""
    definitions = "".join(f"{name} = {text};\n"
                          for name, text in constants.items())
    run = subprocess.run(GAPPA, input=definitions + script, text=True,
                         capture_output=True)
    if "not trivially equal" in run.stderr:
        raise Trouble(f"a rule is no identity:\n{run.stderr}")
    if run.returncode and not re.search(
            "properties were not satisfied|no contradiction", run.stderr):
        raise Trouble(run.stderr)
    return run.stderr if run.returncode else ""


def check(script):
    """Tell what a script proves; return whether that is all it should."""
    constants = {"DBL_EPSILON": "0x1p-52"} | read_constants(script)
    missing = unproved(script, constants)
    print("NOT PROVED:" if missing else "proved:", told(script, "claim")[0])
    print(missing, end="")
    good = not missing
    for least in told(script, "least"):
        name, enough, less = re.fullmatch("(.*) = (.*), not (.*)",
                                          least).groups()
        sharp = (not unproved(script, constants | {name: enough}) and
                 unproved(script, constants | {name: less}))
        print(f"    {name} = {constants[name]}; "
              f"{'it could be' if sharp else 'NOT SO:'} {enough}, not {less}")
        good = good and sharp
    return good


def main(names):
    good = True
    for name in names or sorted(path.stem for path in FOLDER.glob("*.gappa")):
        try:
            path = pathlib.Path(name) if "/" in name else \
                FOLDER / f"{name}.gappa"
            good = check(path.read_text()) and good
        except Trouble as trouble:
            good = False
            print(f"{path.name}: {trouble}")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
