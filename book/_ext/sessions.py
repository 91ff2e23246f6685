"""Commands and what they print, run as at the repository's root.

    ```{session}
    $ build/tanglefree --version
    tanglefree ...
    ```
shows the text and compares it with the real output, a line `...` standing for
any lines; `{run}` takes the commands alone and puts the real output in.  A
line that begins with "> " continues a command.  `:status: 1` is the expected
exit status of the last command; all others must exit with 0.  `build/` has what
is in the folder of this build, whatever its name; what commands write there is
gone after the build.
"""
import re
import subprocess
import tempfile
from pathlib import Path

from docutils import nodes
from docutils.parsers.rst import directives
from sphinx.util import logging
from sphinx.util.docutils import SphinxDirective

log = logging.getLogger(__name__)


def commands(lines):
    """Pairs of the lines of a command and the lines of its output."""
    found = []
    for line in lines:
        if line.startswith("$ "):
            found.append(([line[2:]], []))
        elif line.startswith("> ") and found and not found[-1][1]:
            found[-1][0].append(line[2:])
        elif found:
            found[-1][1].append(line)
        elif line.strip():
            raise ValueError("a session begins with a line '$ command'")
    return found


def run(command, root):
    """The lines that a command prints, and its exit status."""
    done = subprocess.run(["sh", "-c", "\n".join(command)], cwd=root,
                          stdin=subprocess.DEVNULL, capture_output=True,
                          text=True)
    return (done.stdout + done.stderr).splitlines(), done.returncode


def agrees(expected, real):
    pattern = "".join(r"(?:.*\n)*?" if line == "..." else
                      re.escape(line) + r"\n" for line in expected)
    return re.fullmatch(pattern, "".join(line + "\n" for line in real))


class RunDirective(SphinxDirective):
    has_content = True
    option_spec = {"status": directives.nonnegative_int}

    def run(self):
        self.env.note_dependency(str(self.env.app.program))
        shown = []
        try:
            found = commands(self.content)
        except ValueError as error:
            raise self.error(str(error))
        for command, expected in found:
            last = command is found[-1][0]
            wanted = self.options.get("status", 0) if last else 0
            real, status = run(command, self.env.app.desk.name)
            if status != wanted:
                self.complain(f"'{command[0]}' exits with {status}, not "
                              f"{wanted}", real)
            shown += ["$ " + command[0], *("> " + c for c in command[1:])]
            shown += self.output(command, expected, real)
        text = "\n".join(shown)
        return [nodes.literal_block(text, text, language="console",
                                    classes=["session"])]

    def output(self, command, expected, real):
        return real

    def complain(self, what, real):
        log.warning("%s; it prints\n%s", what, "\n".join(real),
                    location=self.get_location())


class SessionDirective(RunDirective):
    def output(self, command, expected, real):
        while expected and not expected[-1].strip():
            expected.pop()
        if not agrees(expected, real):
            self.complain(f"'{command[0]}' prints something else", real)
        return expected


PRINTED = re.compile(r'<span class="go">[^<]*</span>')


def open_at_commas(body):
    """A page on which what is printed may go on in a new line after a comma."""
    return PRINTED.sub(
        lambda found: re.sub(r",(?=\S)(?!<)", ",<wbr>", found[0]), body)


def open_lines(app, page, template, context, doctree):
    if "body" in context:
        context["body"] = open_at_commas(context["body"])


def link(paths, folder):
    for path in paths:
        (folder / path.name).symlink_to(path)


def lay_out_desk(root, built):
    """A folder of links to what is in the root, and in its folder build to what
    is built; what commands write there stays there."""
    desk = tempfile.TemporaryDirectory()
    build = Path(desk.name, "build")
    link((p for p in root.iterdir() if p.name != build.name), build.parent)
    build.mkdir()
    link(built.iterdir(), build)
    return desk


def begin(app):
    app.program = app.built / "tanglefree"
    app.desk = lay_out_desk(app.root, app.built)


def setup(app):
    app.add_directive("run", RunDirective)
    app.add_directive("session", SessionDirective)
    app.connect("builder-inited", begin)
    app.connect("html-page-context", open_lines)
    return {"version": "1", "parallel_read_safe": False}
