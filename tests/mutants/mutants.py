"""Break the library on purpose, one small change at a time, and see that some
test fails.

    make mutants                              the layers up to query, and PLANTED
    make mutants FILE=src/intersect/time.c    one file, or several

A mutant is a source file with one change: an operator swapped, a constant off
by one or doubled, a condition negated, a statement dropped.  Mistakes that take
more than that, and that someone might make, are listed in tests/mutants/planted,
one line each of four parts between bars:

    file | the line, without its indentation | what replaces it | what is wrong

A mutant is compiled in a scratch folder and linked with the other, unchanged
objects; then the tests run, first those of its own module, then those of the
whole, until one fails or crashes or runs out of time.  A mutant that no test
notices is a survivor: write the test that kills it, or remove code that does
nothing.  Some change nothing that could be observed.  They are listed in
tests/mutants/equivalent, with the reason why, one line each of four parts:

    file | the line, without its indentation | the change | why

The exit status is 0 if those in the list survive and no others.  A mutant that
does not compile, or to the same machine code, does not count.
"""

import collections
import concurrent.futures
import os
import pathlib
import queue
import re
import resource
import shlex
import shutil
import subprocess
import sys
import time

WORKERS = 2
LAYERS = ['base', 'geometry', 'arithmetic', 'intersect', 'query']
EQUIVALENT = 'tests/mutants/equivalent'
PLANTED = 'tests/mutants/planted'

# Where the compiler sees the mistake, or `make check-sanitize` would, or where a
# variable is not set, it need not be left to chance whether a test fails.
CAREFUL = ['-Werror=return-type', '-Werror=uninitialized',
           '-Werror=array-bounds', '-fsanitize=undefined,bounds-strict',
           '-fsanitize-undefined-trap-on-error',
           '-ftrivial-auto-var-init=pattern']

# Make mutants ----------------------------------------------------------------

# What clang-format leaves with a space on both sides is a binary operator.
SWAPS = {
    '<': ['<=', '>'], '<=': ['<', '>='], '>': ['>=', '<'], '>=': ['>', '<='],
    '==': ['!='], '!=': ['=='], '&&': ['||'], '||': ['&&'],
    '+': ['-'], '-': ['+'], '*': ['/'], '/': ['*'], '%': ['*'],
    '<<': ['>>'], '>>': ['<<'], '&': ['|'], '|': ['&'], '^': ['|'],
    '+=': ['-='], '-=': ['+='], '*=': ['/='], '|=': ['='],
}
OPERATOR = re.compile(r'(?<=\s)(%s)(?=\s)' % '|'.join(
    re.escape(o) for o in sorted(SWAPS, key=len, reverse=True)))
UNARY = re.compile(r'(?<=[\s(\[{])(?:-(?=[\w(.])|!(?=[\w(*]))')
STEP = re.compile(r'\+\+|--')
NUMBER = re.compile(r'(?<![\w.])(0[xX][\da-fA-F.]+(?:[pP][+-]?\d+)?'
                    r'|\d+(?:\.\d*)?(?:[eE][+-]?\d+)?)(?![\w.])')
DIMENSION = re.compile(r'(?:\b(?!return\b|case\b)\w+ \**|^ +\w+ \w+\[.*, )'
                       r'\w+(?:\[[^\]]*\])*\[$')
ADDED_ZERO = re.compile(r' \+ 0\.0\b')
CONDITION = re.compile(r'\b(?:if|while) \(')
STATEMENT = re.compile(
    r'^ +(?!(?:for|if|while|else|do|switch|case|default|static|enum)\b)'
    r'(?!(?:const |unsigned )*\w+ [*(]*\w+\)?(?:\[[^\]]*\])*(?: = |;|,))'
    r'(?!.*[,{]$)[\w(*+-][^;{}]*;|^ +return\b[^;]*;', re.M)

Mutant = collections.namedtuple('Mutant', 'file line text change source')


def blank(match):
    return re.sub(r'[^\n]', ' ', match.group())


def code_of(source):
    """The source with blanks for what is no code."""
    code = re.sub(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\])\'',
                  blank, source, flags=re.S)
    code = re.sub(r'^#define \w+(\([^)]*\))?', blank, code, flags=re.M)
    return re.sub(r'^#[^\n]*', blank, code, flags=re.M)


def close_of(code, start):
    """Where the parenthesis that opens at `start` closes."""
    depth = 0
    for i in range(start, len(code)):
        depth += {'(': 1, ')': -1}.get(code[i], 0)
        if depth == 0:
            return i
    raise ValueError('unbalanced parenthesis')


def number_changes(text):
    if re.fullmatch(r'\d+', text):
        n = int(text)
        return [str(n + 1)] + ([str(n - 1)] if n > 0 else [])
    if not re.fullmatch(r'0[xX][0-9a-fA-F]+', text):
        return ['(2 * %s)' % text] if float_value(text) else []
    return [hex(int(text, 16) + 1)]


def float_value(text):
    return float.fromhex(text) if 'x' in text else float(text)


def changes(source, code):
    """Yields (start, end, replacement, what it is called)."""
    for m in OPERATOR.finditer(code):
        for other in SWAPS[m.group()]:
            yield m.start(), m.end(), other, '%s -> %s' % (m.group(), other)
    for m in UNARY.finditer(code):
        yield m.start(), m.end(), '', '%s dropped' % m.group()
    for m in STEP.finditer(code):
        other = '--' if m.group() == '++' else '++'
        yield m.start(), m.end(), other, '%s -> %s' % (m.group(), other)
    for m in NUMBER.finditer(code):
        line = code[code.rfind('\n', 0, m.start()) + 1:m.start()]
        if not DIMENSION.search(line):
            for other in number_changes(m.group()):
                yield (m.start(), m.end(), other,
                       '%s -> %s' % (m.group(), other))
    for m in ADDED_ZERO.finditer(code):
        yield m.start(), m.end(), '', '+ 0.0 dropped'
    for m in CONDITION.finditer(code):
        end = close_of(code, m.end() - 1)
        inner = source[m.end():end]
        yield m.end() - 1, end, '(!(' + inner + ')', 'negated'
    for m in STATEMENT.finditer(code):
        lines = '\n' * m.group().count('\n')
        yield m.start(), m.end(), ';' + lines, 'dropped'


def small_changes(path):
    source = pathlib.Path(path).read_text()
    counts = collections.Counter()
    for start, end, text, change in sorted(changes(source, code_of(source))):
        line = source.count('\n', 0, start) + 1
        shown = source.split('\n')[line - 1].strip()
        counts[line, change] += 1
        if counts[line, change] > 1:
            change += ' (%d)' % counts[line, change]
        yield Mutant(path, line, shown, change,
                     source[:start] + text + source[end:])


def planted(path):
    source = pathlib.Path(path).read_text()
    for file, text, change, _ in read_list(PLANTED):
        if file != path:
            continue
        text, change = with_bars(text), with_bars(change)
        found = list(re.finditer('^ *%s$' % re.escape(text), source, re.M))
        if len(found) != 1:
            sys.exit('%s: not one line of %s, but %d: %s' % (
                PLANTED, path, len(found), text))
        before, after = source[:found[0].start()], source[found[0].end():]
        yield Mutant(path, before.count('\n') + 1, text, change,
                     before + change + after)


def mutants_of(path, all_of_it):
    if all_of_it:
        yield from small_changes(path)
    yield from planted(path)


# Lists -----------------------------------------------------------------------


def read_list(path):
    for line in pathlib.Path(path).read_text().splitlines():
        if line and not line.startswith('#'):
            parts = [part.strip() for part in re.split(r' \| ', line)]
            if len(parts) != 4:
                sys.exit('%s: four parts, please: %s' % (path, line))
            yield parts


# Where a bar between blanks would end a part, a broken one stands for it.
def without_bars(text):
    return re.sub(r' \|(?= |$)', ' ¦', text)


def with_bars(text):
    return re.sub(r' ¦(?= |$)', ' |', text)


# Build and run ---------------------------------------------------------------


def run(command):
    return subprocess.run(command, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True)


def must(command):
    done = run(command)
    if done.returncode != 0:
        sys.exit('%s\n%s' % (shlex.join(command), done.stdout))


def limit_process():
    os.nice(10)
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))


def layer_of(path):
    folder = path.split('/')[1]
    return LAYERS.index(folder) if folder in LAYERS else len(LAYERS)


class Tests:
    """The test programs, linked with the library as a shared object."""

    def __init__(self, build, names, libraries):
        self.build, self.took = build, {}
        for name in names:
            program = '%s/linked/%s' % (build, name.replace('/', '-'))
            must(['cc', '%s/%s.o' % (build, name), build + '/support.a',
                  '-L' + build + '/linked', '-ltanglefree', *libraries,
                  '-o', program])
            start = time.monotonic()
            if not self.passes(name, build + '/linked', 600):
                sys.exit('%s fails without a change' % name)
            self.took[name] = time.monotonic() - start

    def passes(self, name, folder, seconds):
        def limit():
            limit_process()
            cpu = int(seconds / 5) + 1
            resource.setrlimit(resource.RLIMIT_CPU, (cpu, cpu))
        environment = dict(os.environ, LD_LIBRARY_PATH=folder)
        program = '%s/linked/%s' % (self.build, name.replace('/', '-'))
        process = subprocess.Popen([program], env=environment,
                                   stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL, preexec_fn=limit,
                                   start_new_session=True)
        try:
            return process.wait(seconds) == 0
        except subprocess.TimeoutExpired:
            # Check ends the test that it has forked, too, and all of the
            # session.
            process.terminate()
            process.wait()
            return False

    def order(self, file):
        """Its own first, then the quick ones; none of lower layers."""
        own = 'tests' + file[3:-2]
        lowest = layer_of(file)
        return sorted(
            (name for name in self.took if layer_of(name) >= lowest),
            key=lambda name: (
                name != own, name != 'tests/whole/golden', self.took[name]))

    def killer(self, file, folder):
        for name in self.order(file):
            if not self.passes(name, folder, 5 + 10 * self.took[name]):
                return name
        return None


class Builder:
    """The library, and the program but for main(), as a shared object."""

    def __init__(self, build, compiler, experiments, sources):
        self.build, self.compiler = build, compiler
        self.experiments = experiments
        self.sources = sources
        for folder in ['linked', *map(self.worker, range(WORKERS))]:
            os.makedirs('%s/%s' % (build, folder), exist_ok=True)
        with concurrent.futures.ThreadPoolExecutor(WORKERS) as pool:
            list(pool.map(self.compile_original, sources))
        self.link(build + '/linked', None, None)

    def worker(self, i):
        return 'worker%d' % i

    def original(self, file):
        return '%s/original/%so' % (self.build, file[:-1])

    def compile_original(self, file):
        folder = os.path.dirname(self.original(file))
        os.makedirs(folder, exist_ok=True)
        if not self.compile(folder, file, pathlib.Path(file).read_text()):
            sys.exit('%s does not compile' % file)

    def compile(self, folder, file, source, options=CAREFUL):
        """The object, or None if the source does not compile."""
        path = '%s/%s' % (folder, os.path.basename(file))
        pathlib.Path(path).write_text('#line 1 "%s"\n%s' % (file, source))
        done = run(self.compiler + options +
                   ['-Isrc', '-c', path, '-o', path[:-1] + 'o'])
        return path[:-1] + 'o' if done.returncode == 0 else None

    def link(self, folder, replaced, by):
        objects = [by if file == replaced else self.original(file)
                   for file in self.sources]
        must(['cc', '-shared', *objects, *self.experiments, '-lm', '-o',
              folder + '/libtanglefree.so'])


def same_bytes(path, other):
    return pathlib.Path(path).read_bytes() == pathlib.Path(other).read_bytes()


def same_machine_code(builder, folder, mutant):
    """Whether the mutant is the original to a compiler without precautions."""
    codes = []
    for source in mutant.source, pathlib.Path(mutant.file).read_text():
        path = builder.compile(folder, mutant.file, source, [])
        codes.append(pathlib.Path(path).read_bytes())
    return codes[0] == codes[1]


def judge(builder, tests, folder, mutant):
    """What becomes of a mutant: a word, and which test killed it."""
    path = builder.compile(folder, mutant.file, mutant.source)
    if not path:
        return 'invalid', None
    if same_bytes(path, builder.original(mutant.file)):
        return 'same', None
    builder.link(folder, mutant.file, path)
    killer = tests.killer(mutant.file, folder)
    if killer:
        return 'killed', killer
    same = same_machine_code(builder, folder, mutant)
    return ('same' if same else 'survived'), None


# Report ----------------------------------------------------------------------


def read_equivalent():
    return {tuple(parts[:3]): parts[3] for parts in read_list(EQUIVALENT)}


def key_of(mutant):
    """As in the list."""
    return mutant.file, without_bars(mutant.text), without_bars(mutant.change)


def show_progress(done, count, survivors):
    if sys.stderr.isatty():
        print('\r%d of %d, %d survivors ' % (done, count, survivors), end='',
              file=sys.stderr, flush=True)
    elif done % 100 == 0:
        print('%d of %d, %d survivors' % (done, count, survivors), flush=True)


def run_all(builder, tests, mutants):
    folders = queue.Queue()
    for i in range(WORKERS):
        folders.put('%s/%s' % (builder.build, builder.worker(i)))

    def work(mutant):
        mine = folders.get()
        try:
            return mutant, judge(builder, tests, mine, mutant)
        finally:
            folders.put(mine)

    results, survivors = [], 0
    with concurrent.futures.ThreadPoolExecutor(WORKERS) as pool, \
            open(builder.build + '/results', 'w') as log:
        for mutant, (fate, killer) in pool.map(work, mutants):
            results.append((mutant, fate))
            survivors += fate == 'survived'
            print('%s:%d | %s | %s | %s %s' % (
                mutant.file, mutant.line, mutant.text, mutant.change, fate,
                killer or ''), file=log, flush=True)
            show_progress(len(results), len(mutants), survivors)
    return results


def report(results, listed):
    """Prints a table by file and what is wrong; whether nothing is."""
    table = collections.defaultdict(collections.Counter)
    wrong, found = [], collections.defaultdict(set)
    for mutant, fate in results:
        key = key_of(mutant)
        found[key].add(fate)
        equivalent = key in listed
        if fate == 'survived' and not equivalent:
            wrong.append('survivor: %s:%d | %s | %s' % (
                mutant.file, mutant.line, key[1], key[2]))
        if fate == 'survived' and equivalent:
            fate = 'equivalent'
        table[mutant.file][fate] += 1
    files = {mutant.file for mutant, _ in results}
    for key in listed:
        if key[0] in files and not found[key] & {'survived', 'same'}:
            wrong.append('listed, but no survivor: %s | %s | %s' % key)

    columns = ['killed', 'equivalent', 'survived']
    print('%-34s %8s %8s %10s %8s' % ('', 'mutants', *columns))
    for file in sorted(table) + ['all']:
        row = table[file] if file != 'all' else sum(
            table.values(), collections.Counter())
        print('%-34s %8d %8d %10d %8d' % (
            file, sum(row[c] for c in columns), *(row[c] for c in columns)))
    print('\n'.join(wrong))
    return not wrong


def main():
    build, compiler, experiments, libraries, sources, names = sys.argv[1:7]
    files = sys.argv[7:] or sorted(
        str(path) for layer in LAYERS
        for path in pathlib.Path('src', layer).glob('*.c'))
    others = [] if sys.argv[7:] else sorted(
        {parts[0] for parts in read_list(PLANTED)} - set(files))
    builder = Builder(build, shlex.split(compiler), experiments.split(),
                      sources.split())
    tests = Tests(build, names.split(), libraries.split())
    mutants = [m for file in files + others
               for m in mutants_of(file, file in files)]
    results = run_all(builder, tests, mutants)
    shutil.rmtree(build + '/linked')
    sys.exit(0 if report(results, read_equivalent()) else 1)


main()
